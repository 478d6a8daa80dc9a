"""Deviations by which a real disc, mount, lever, train or car differs from its design, and their effects.

| module         | what it holds                                                                        |
|----------------|--------------------------------------------------------------------------------------|
| `deviation`    | table of deviations: names, units, tolerance keys, settings by hand                  |
| `effect`       | an effect: an exact change at one step of a model, with numbers, bounds and rivals   |
| `disc`         | effects on the disc's outline about its bore                                         |
| `return_error` | numbers of return error and friction, which several kinds of data show               |
| `lift`         | effects of the mount, the follower and the instrument on a measured lift             |
| `instrument`   | effects of instruments, each like an effect of the part or the car                   |
| `camera`       | errors of the camera that a track is held against                                    |
| `transmission` | effects of the train between motor and camshaft, and of its encoders                 |
| `track`        | effects of the car that a cam steers                                                 |
| `catalogue`    | effects that are looked for in each kind of data, by their names in design files     |
| `first_order`  | change of the steering with deviations of disc, rod and frame, to first order        |
| `as_built`     | the car with its effects: what becomes of a disc, and what to cut for it             |
"""
