"""From waypoints to the drive wheel's track, by arc length.

| module    | what it does                                                             |
|-----------|--------------------------------------------------------------------------|
| `names`   | kinds of splines, by name                                                |
| `spline`  | waypoints -> parametric interpolating spline, the planned path            |
| `track`   | planned path -> drive wheel's track: arc length, signed curvature, kinks  |
| `hermite` | values and derivatives at nodes -> piecewise quintic polynomial           |
"""
