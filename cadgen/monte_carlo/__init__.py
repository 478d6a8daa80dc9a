"""Many cars within the tolerances of a design: how their runs end, and which tolerance costs most.

| module        | what it holds                                                            |
|---------------|--------------------------------------------------------------------------|
| `fleet`       | many cars at once, each with its own dimensions                          |
| `derivatives` | change of the steering with all that may be a little off, to first order |
| `stretches`   | where many cars' cams jump, wait and go on, each with its own friction   |
| `robust`      | Monte Carlo over the tolerances, yield within a gate, sensitivities      |
| `budget`      | all that may be off, ranked by its cost before and after a trim          |
| `processes`   | what processes usually hold, and how materials grow with heat            |
"""
