"""The course that a car drives and the car's own outline, in plan view.

| module     | what it does                                                                            |
|------------|-----------------------------------------------------------------------------------------|
| `layout`   | field, posts, walls, zones, gates, start and finish; the course at another spacing      |
| `body`     | outline and wheels of the car about its fork axis, its named points, a run as poses     |
| `approach` | nearest approach of the car, swept along its run                                        |
| `judge`    | a run held against a course, lap by lap on a closed path                                |
| `refuse`   | courses that no car can drive, and the room that it takes to turn round                 |
"""
