"""Steering cams and the gear trains that drive them: from a planned path to verified files.

The rooms, in walking order; each imports only those before it.

| room          | what happens there                                                        |
|---------------|---------------------------------------------------------------------------|
| `errors`      | what can go wrong, with the exit codes                                    |
| `arrays`      | an array of floats, a turn                                                |
| `check`       | one figure with its limit and verdict                                     |
| `reading`     | files that a user names, refused by kind and size                         |
| `curves`      | closed plane curves: arcs, splines, chords and offsets within a tolerance |
| `path`        | waypoints -> spline -> the drive wheel's track by arc length              |
| `steering`    | curvature of the track <-> steering angle                                 |
| `parts`       | features of a part: bore, keyway, hub, web, holes; a body of prisms       |
| `cam`         | lift, theoretical and actual profile, contact, checks                     |
| `gears`       | tolerances, backlash, return error, order of stages, tooth form, layout   |
| `motion`      | how the car runs when the gears have play                                 |
| `deviations`  | what a real car differs by, and what that does to it                      |
| `measurement` | measured data -> the effects that explain them; one object a kind of data |
| `optimize`    | methods against play and the choice among them                            |
| `monte_carlo` | many cars within the tolerances                                           |
| `records`     | measured data from files, each of the kind that its columns say           |
| `design`      | the design file: TOML -> frozen values                                    |
| `build`       | design -> the numeric rooms' own types, in mm and rad                     |
| `meshes`      | parts as closed meshes; the checks of a train put together                |
| `solids`      | the only room that imports the CAD kernel                                 |
| `export`      | one file per format, each with its read-back; manifest; publishing        |
| `report`      | pictures, as PNG and SVG                                                  |
| `workflow`    | one job from design to verified files                                     |
| `cli`         | the commands                                                              |

Inside, lengths are mm and angles rad; other units occur only at the rim and then stand in the name.
"""

__version__ = "0.1.0"
