"""Designs: a TOML file, checked against a schema, as frozen values in the file's units.

Sections of the file, each with what belongs to it alone:

| module        | what it does                                                                          |
|---------------|---------------------------------------------------------------------------------------|
| `section`     | what all sections have in common                                                      |
| `path`        | path, with the keys of its kind                                                       |
| `course`      | field, posts, walls, zones, gates, spacing, the car's outline -> course and body       |
| `motion`      | the section [motion], of one of its sources                                           |
| `sources`     | rises and dwells, points, harmonics, a table -> the motion that they make             |
| `lift_tolerances` | what a cam with [motion] and its follower may be off by                           |
| `dynamics`    | mass, spring and load of a follower -> what its forces need                           |
| `lift_rows`   | rows of a lift table from a file                                                      |
| `follower`    | follower, with the keys of its kind                                                   |
| `disc`        | base circle of a cam by its motion, given or for a pressure angle                      |
| `blank`       | bore, keyway, hub and holes of the disc, and how a wheel is held on its shaft          |
| `machining`   | milling and drilling, texts in title blocks                                           |
| `play`        | play, forces on the cam, tolerances, what is asked of the profile                     |
| `settings`    | what can be set on the car when a spacing is drawn                                    |
| `as_built`    | the car as it was built                                                               |
| `train`       | gear train, its stages with the keys of their kinds                                   |
| `layout`      | how the train stands in the car                                                       |
| `frame`       | how plates, base and fork hold the parts                                              |
| `drive`       | drop weight or motor that the frame carries                                           |
| `schema`      | all other sections; ranges, defaults, how keys must fit each other                    |

The file:

| module        | what it does                                                                          |
|---------------|---------------------------------------------------------------------------------------|
| `parse`       | TOML text as plain values                                                             |
| `kinds`       | registered kinds that a design names                                                  |
| `keys`        | the schema as a list of keys, their units and ranges in words                         |
| `explain`     | what is wrong with a design, as sentences                                             |
| `file_names`  | names that files can have on every system                                             |
| `override`    | `--set key=value`                                                                     |
| `load`        | name or file -> `Design`                                                              |
| `begin`       | name, points of a path, changes of keys -> a commented design                         |
| `planned`     | the design file with a planned path, comments kept                                    |
| `reference`   | the schema as a page of documentation                                                 |

The design as the numeric rooms have it, in mm and rad:

| module        | what it does                                                                          |
|---------------|---------------------------------------------------------------------------------------|
| `cam_model`   | path, track, lift, follower, blank and car                                            |
| `draw_model`  | what can be set on the car when a spacing is drawn                                    |
| `gear_model`  | gear train, blanks, joints and limits of the search                                   |
| `variation`   | what cars differ by: return error, friction, tolerances                               |
"""
