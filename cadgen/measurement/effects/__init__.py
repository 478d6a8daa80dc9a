"""The catalogue of effects, a file for each kind of data.

| module         | what its effects act on                                              |
|----------------|----------------------------------------------------------------------|
| `base`         | what an effect and a parameter are                                   |
| `disc`         | the outline: seen in profiles, and some of it in the lift            |
| `lift`         | the follower, the divider and the dial                               |
| `transmission` | the gears between motor and camshaft, and the encoders               |
| `track`        | the car that the cam steers                                          |
| `tricycle`     | a car with a steered and driven front wheel whose steering is logged |
"""
