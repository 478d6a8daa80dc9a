"""The car's runs with play.

| module       | what it holds                                                            |
|--------------|--------------------------------------------------------------------------|
| `simulation` | one run on the actual profile and on another: runs, events, errors       |
| `fleet`      | many cars of a design, made ready                                        |
| `watched`    | a fleet that is held against the course                                  |
| `tolerance`  | many cars within the tolerances: ends, yield, sensitivities              |
| `budget`     | the error budget on one sheet: what costs most, and what to hold tighter |
| `manifest`   | runs and budgets as plain values                                         |
| `files`      | tracks and pictures, published with these values                         |
"""
