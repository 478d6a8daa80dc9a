"""Designs: a TOML file, checked against a schema, as frozen values in the file's units.

| module      | what it does                                                             |
|-------------|--------------------------------------------------------------------------|
| `section`   | what all sections have in common                                         |
| `polygon`   | whether the sides of a polygon cross                                     |
| `course`    | sections of the course: field, posts, walls, zones, gates                |
| `outline`   | section of the car's outline and wheels                                  |
| `blank`     | sections of bore, keyway, hub, holes                                     |
| `path`      | section of the path, with the keys of its kind                           |
| `follower`  | section of the follower, with the keys of its kind                       |
| `machining` | section of milling and drilling                                          |
| `joint`     | what holds a wheel on its shaft                                          |
| `drawing`   | section of the texts in title blocks                                     |
| `play`      | sections of play, tolerances and what is asked of the profile            |
| `mechanics` | section of what turns the cam ahead of its gears, and what holds it      |
| `settings`  | section of what can be set on the car when a spacing is drawn             |
| `as_built`  | sections of the car as it was built                                      |
| `stage`     | sections of a stage of the train, with the keys of its kind              |
| `train`     | sections of the gear train                                               |
| `parse`     | TOML text as plain values                                                |
| `kinds`     | the registered kinds that a design names                                 |
| `schema`    | all other sections; ranges, defaults, how keys must fit each other       |
| `keys`      | the schema as a list of keys, their units and ranges in words            |
| `explain`   | what is wrong with a design, as sentences                                |
| `names`     | names that files can have on every system                                |
| `override`  | `--set key=value`                                                        |
| `load`      | name or file -> `Design`                                                 |
| `template`  | text of a design to begin with                                           |
| `begin`     | name, points of a path, changes of keys -> a commented design            |
| `planned`   | the design file with a planned path, comments kept                       |
| `reference` | the schema as a page of documentation                                    |
| `cam_model` | path, track, lift, follower, blank and car of a design                   |
| `course_model` | the course and the car's outline                                      |
| `draw_model` | what can be set on the car when a spacing is drawn                      |
| `gear_model` | gear train, blanks, joints and limits of the search of a design         |
| `variation` | what cars of a design differ by: return error, friction, tolerances      |
"""
