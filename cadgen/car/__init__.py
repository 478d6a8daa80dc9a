"""The car that a steering cam drives: path, course, steering, and its run with play.

| room           | what it holds                                                                  |
|----------------|--------------------------------------------------------------------------------|
| `path`         | waypoints -> spline -> the drive wheel's track by arc length                   |
| `steering`     | curvature of the track <-> steering angle, also with slip                      |
| `path_motion`  | the law `path`: tan(beta) by cam angle, closed by a blend, and its checks      |
| `course`       | field, posts, gates; the car's outline swept along its run                     |
| `planner`      | course and car -> the path on which play moves the car least                   |
| `running`      | how the car runs when the gears have play                                      |
| `assembly`     | the train in the car, clear of disc, rod, wheels and floor                     |
| `draws`        | one cam for every draw: what to set on the car for each spacing                |
| `against_play` | profiles and remedies against play, and the choice among them                  |
"""
