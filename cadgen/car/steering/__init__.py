"""Curvature of the drive wheel's track <-> steering angle.

| module | what it does                                                                    |
|--------|---------------------------------------------------------------------------------|
| `car`  | the three-wheeled car; tan(beta) from curvature (eq. 17-19 with signs) and back |
| `slip` | steering by the travel of the drive wheel's rim, where it slips in turns        |
"""
