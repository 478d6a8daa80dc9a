"""The planner: from a course and a car to the path on which the play of the gears moves the car least.

The path is a B-spline of degree 5 (`cadgen.car.path.spline.control_path`). Its control points are found by a row of
linear programmes: what the play costs and what the path must keep are linearised about the last path, and a trust
region bounds the step (Fletcher & Sainz de la Maza, Math. Program. 43 (1989) 235). See docs/theory/planner.md.

| module        | what it does                                                                        |
|---------------|-------------------------------------------------------------------------------------|
| `task`        | car, limits and course as the planner has them                                      |
| `basis`       | B-splines and their derivatives at parameters                                       |
| `motion`      | control points -> curvature of the drive wheel's track and poses, with derivatives   |
| `sensitivity` | what play costs at the end of the run, to first order                               |
| `rows`        | one limit's values and derivatives at many places of the path                       |
| `limits`      | limits of steering, pressure angle and outline                                      |
| `gates`       | gates, start and finish                                                             |
| `barriers`    | posts, walls, zones and the field's edge against the car's outline                  |
| `programme`   | one linear programme                                                                |
| `start`       | the path that the search begins with                                                |
| `order`       | the order of gates that may be passed at any time                                   |
| `route`       | a rough way from gate to gate, round what is in the way                             |
| `near`        | the drive wheel's track kept near to a given one                                    |
| `search`      | from that path to the best one                                                      |
| `plan`        | a task planned: the best of several searches                                        |
| `bounds`      | least and greatest of what may be asked of a plan                                   |
| `tightening`  | distances kept besides, where the exact chain has failed a check                    |
| `reasons`     | why a course cannot be driven, and the least change that would do                   |
"""
