"""The kinds of path: a new one is a file here and a line in the table, or is registered from outside.

| module     | what it holds                                                          |
|------------|------------------------------------------------------------------------|
| `kind`     | what a kind is: its code, its keys of the design file, and its curve    |
| `quintic`  | the sixth-order natural spline through waypoints                        |
| `cubic`    | the cubic spline of the paper's appendix                                |
| `b_spline` | a curve by control points, such as `cadgen plan` writes                 |
| `table`    | all kinds by their codes                                                |
"""
