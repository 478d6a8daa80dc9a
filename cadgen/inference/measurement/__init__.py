"""From measured data to the effect that the model lacks.

| module       | what it does                                                                                    |
|--------------|-------------------------------------------------------------------------------------------------|
| `record`     | a kind of data as an object: columns, readings, datum, model, method; a record of it with runs  |
| `models`     | exact forward models: effects -> what the instrument should have read                           |
| `nominal`    | the design that data are measured against                                                       |
| `kinds`      | the kinds, one file each, and their table                                                       |
| `remarks`    | what comment lines say of design, instrument and part                                           |
| `admission`  | records that no instrument reads are refused                                                    |
| `units`      | records in another unit than their header says, by what the design lets expect                  |
| `shapes`     | forms without a name that compete with the catalogue                                            |
| `recent`     | results that are asked for again and again                                                      |
| `noise`      | what does not repeat between runs                                                               |
| `joint`      | records of one car as one: shared effects, one evidence                                         |
| `merged`     | the catalogues of several records as one                                                        |
| `evidence`   | likelihood of a residual with noise, datum and form error accounted for                         |
| `hypothesis` | a subset of effects, fitted exactly and scored                                                  |
| `settle`     | least squares within bounds, ended when the values move by less than their errors               |
| `columns`    | linearised responses of effects                                                                 |
| `numerous`   | effects of which there are many, prepared to be tried one at a time                             |
| `search`     | all small subsets, linearised; the best are fitted                                              |
| `remains`    | residuals that a subset leaves, and whether the runs differ                                     |
| `verdict`    | what the rivals and what is left allow to be claimed                                            |
| `friction`   | play and friction of one car: whether they can be told apart, and what is known of the play     |
| `doubt`      | what speaks against a verdict: bounds, a rest that dwarfs every effect, too little data         |
| `findings`   | effects with their numbers; a diagnosis by evidence, and one by runs left out                   |
| `diagnose`   | the way through all of these for records of one car, and the test on runs left out              |
| `leave_out`  | subsets by their path error on runs left out, where errors accumulate                           |
| `steered`    | the diagnosis that follows from it                                                              |
| `zones`      | the return error implied by mean turns over smooth, jump and reverse zones                      |
| `together`   | what is claimed, each quantity at work once, where data that are judged apart show it too       |
| `calibrate`  | the entry: records of one car, judged together                                                  |
| `reference`  | the catalogues as a page of documentation                                                       |
"""
