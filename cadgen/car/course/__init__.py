"""The course that a car drives and the car's own outline, in plan view.

| module   | what it does                                                                        |
|----------|-------------------------------------------------------------------------------------|
| `names`  | named points of the car, sides                                                      |
| `course` | field, posts, walls, zones, gates, start and finish                                 |
| `turning` | room to turn round in, of a car and of a field                                    |
| `scaled` | the course at another spacing                                                       |
| `body`   | outline and wheels of the car about its fork axis; places of its named points       |
| `poses`  | a run as poses, and how far any point of the car moves between them                 |
| `shapes` | distances between parts of the car and what is on the course                        |
| `sweep`  | nearest approach of the car, swept along its run                                    |
| `gates`  | whether a run passes the gates, where, and by what margin                           |
| `judge`  | a run held against a whole course                                                   |
| `laps`   | a run of several laps, each held against it                                         |
| `refuse` | courses that no car can drive                                                       |
"""
