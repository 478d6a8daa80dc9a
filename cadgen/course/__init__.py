"""The course that a car drives and the car's own outline, in plan view.

| module   | what it does                                                                        |
|----------|-------------------------------------------------------------------------------------|
| `names`  | named points of the car, sides                                                      |
| `course` | field, posts, walls, zones, gates, start and finish                                 |
| `body`   | outline and wheels of the car about its fork axis; places of its named points       |
"""
