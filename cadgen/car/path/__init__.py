"""From waypoints or control points to the drive wheel's track, by arc length.

| module       | what it does                                                             |
|--------------|--------------------------------------------------------------------------|
| `path_kinds` | kinds of path in a design file: keys and curve of each                   |
| `spline`     | waypoints or control points -> parametric spline, the planned path       |
| `wheel_track`| planned path -> drive wheel's track: arc length, signed curvature, kinks |
"""
