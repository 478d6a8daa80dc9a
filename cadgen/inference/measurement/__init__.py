"""From measured data to the effect that the model lacks.

| module         | what it does                                                                                   |
|----------------|------------------------------------------------------------------------------------------------|
| `model`        | interface of forward models: effects -> what the instrument should have read; the lift as rolled |
| `record`       | a kind of data as an object, a record of it with runs, and what no record may be               |
| `nominal`      | the design that data are measured against, and the forces on its cam                           |
| `shapes`       | forms without a name that compete with the catalogue                                           |
| `camera_frame` | frame of a track: axes turned by quarters of a turn, shifted, or in a mirror                   |
| `kinds`        | the kinds of data with their models, one file each, and their table                            |
| `evidence`     | likelihood of a residual with noise, datum and form error accounted for                        |
| `joint`        | records of one car as one: shared effects, one evidence                                        |
| `hypothesis`   | a subset of effects, fitted exactly and scored                                                 |
| `search`       | all small subsets, linearised; the best are fitted                                             |
| `verdict`      | what the rivals and what is left allow to be claimed                                           |
| `doubts`       | claimed names that are not of one size all the turn, or that a form without a name does better than |
| `reservations` | what speaks against a verdict, and what these data cannot tell apart                           |
| `findings`     | effects with their numbers; a diagnosis by evidence, and one by runs left out                  |
| `claims`       | what is claimed, each deviation at work once, where data that are judged apart show it too     |
| `runs_left_out` | diagnosis of logged runs by their path error on runs left out, where errors accumulate        |
| `odd_runs`     | runs of another car, state or unit, which are left out and named                               |
| `odd_logs`     | logged runs of another vehicle, state or unit, likewise                                        |
| `repeats`      | what repeats over logged runs of one path without a name                                       |
| `formulas`     | a formula for that over physical inputs, proposed by paths left out                            |
| `other_cam`    | whether the records fit another cam than the one that they were judged against                 |
| `diagnosis`    | the entry: records of one car, judged together, with the test on runs left out                 |
| `reference`    | the catalogues as a page of documentation                                                      |
"""
