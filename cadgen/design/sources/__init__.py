"""Sources of the motion of a cam, each a file; a new one is a base of `MotionSection` more.

| module      | what it is a source of                                                                |
|-------------|---------------------------------------------------------------------------------------|
| `source`    | keys of all of them, heights in the motion's unit, rows whose angles grow             |
| `segments`  | rises and dwells                                                                      |
| `points`    | points of a periodic spline                                                           |
| `harmonics` | harmonics                                                                             |
| `lift_table`| a lift table                                                                          |
| `measured`  | a measured cam, from which the motion is to be found                                  |
"""
