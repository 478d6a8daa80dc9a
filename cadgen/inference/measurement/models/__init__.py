"""The exact forward models: from the nominal design and active effects to what the instrument should have read.

| module         | what it predicts                                                           |
|----------------|----------------------------------------------------------------------------|
| `base`         | what every model offers to the search                                      |
| `lift`         | the rod rolled on the changed disc, read by a dial                         |
| `profile`      | distance of measured points from the changed disc                          |
| `transmission` | the camshaft behind a train with play                                      |
| `track`        | the run of the car behind the rod, the play and the start set by hand      |
| `rolled`       | what effects on disc and follower make of the lift                         |
| `start`        | start poses, entered exactly, with what is known of them beforehand        |
| `floor`        | what a slope and an uneven floor do to a track                             |
| `forces`       | where the cam leads its gears, by friction, whichever way it is turned     |
| `tricycle`     | the run of a car whose steering was logged                                 |
"""
