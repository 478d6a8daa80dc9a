"""The planner: from a course and a car to the path on which the play of the gears moves the car least.

The path is a B-spline of degree 5 (`cadgen.car.path.spline.control_path`). Its control points are found by a sequence
of linear programmes: what the play costs and what the path must keep are linearised about the last path, and a trust
region bounds the step (Fletcher & Sainz de la Maza, Math. Program. 43 (1989) 235). See docs/theory/planner.md.

| module        | what it does                                                                       |
|---------------|------------------------------------------------------------------------------------|
| `path_task`   | car, limits and course as the planner has them, and margins beside the limits      |
| `kinematics`  | control points -> curvature of the drive wheel's track and poses, with derivatives |
| `sensitivity` | cost of play at the end of the run, to first order                                 |
| `constraints` | limits of steering, cam and length, and a corridor along a track                   |
| `gates`       | gates, start and finish                                                            |
| `barriers`    | posts, walls, zones and the field's edge against the car's outline                 |
| `route`       | order of the gates, rough route, smooth path to begin with                         |
| `arcs`        | ways of arcs and straights to begin a search with                                  |
| `search`      | sequence of linear programmes from that path to the best one                       |
| `path_plan`   | best of several searches; reasons why a course cannot be driven                    |
"""

# Least and greatest of what may be asked of a plan.
WITHIN_MM = 0.1, 1000.0  # how far a given path may be left, mm
SEEDS = 1, 100  # searches
RESERVE = 0.0, 10.0  # room at gates and obstacles, times the scatter of the cars
