"""Effects of deviations, by which a real disc, mount, lever, train or car differs from its design.

| module         | what it holds                                                                   |
|----------------|---------------------------------------------------------------------------------|
| `names`        | places of an effect, light enough for every design file                         |
| `quantities`   | what effects are physically, whatever each kind of data calls them              |
| `rows`         | where measured numbers belong: run, place on the cam, place within the run      |
| `effect`       | what an effect is: a change at one stage of a model, with parameters and bounds |
| `disc`         | effects on the disc's outline about its bore                                    |
| `lift`         | effects of the mount, the follower and the instrument on a measured lift        |
| `instrument`   | effects of the instrument, beside those of the part that they look like          |
| `transmission` | effects of the train between motor and camshaft, and of its encoders            |
| `track`        | effects of the car that a cam steers                                            |
| `tricycle`     | effects of a car whose front wheel is logged                                    |
| `friction`     | what effects of sliding friction share                                          |
| `usual`        | how much cars differ in what nobody has measured                                |
| `catalogue`    | the effects of each kind of data, by the names that design files give them      |
| `edges`        | cost at the finish of edges broken more than designed                            |
| `lead`         | a camshaft ahead of its gears by the same at each turn, as a disc               |
| `as_built`     | the car with its effects: what becomes of a disc, and what to cut for it        |
"""
