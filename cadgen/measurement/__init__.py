"""From measured data to the effect that the model lacks.

| module       | what it does                                                                                  |
|--------------|-----------------------------------------------------------------------------------------------|
| `record`     | measured data as read: rows, runs, remarks                                                      |
| `load`       | CSV files -> records; what cannot be is refused                                                 |
| `units`      | files in another unit than their header says, by what the design lets expect                    |
| `models`     | exact forward models: effects -> what the instrument should have read                           |
| `noise`      | what does not repeat between runs                                                               |
| `evidence`   | likelihood of a residual with noise, datum and form error accounted for                         |
| `hypothesis` | a subset of effects, fitted exactly and scored                                                  |
| `search`     | all small subsets, linearised; the best are fitted                                              |
| `verdict`    | what the rivals and what is left allow to be claimed                                            |
| `doubt`      | what speaks against a verdict: bounds, a rest that dwarfs every effect, too little data         |
| `diagnose`   | the way through all of these for one record, and the test on runs left out                      |
| `leave_out`  | subsets by their path error on runs left out, where errors accumulate                           |
| `steered`    | the verdict that follows from it                                                                |
| `zones`      | the return error implied by mean turns over smooth, jump and reverse zones                      |
| `together`   | one thing in several kinds of data: agreement, and rivals that other data decide                |
| `nominal`    | the design that data are measured against; the entry: `calibrate`                               |
"""
