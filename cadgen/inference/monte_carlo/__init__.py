"""Many cars within the tolerances of a design: how their runs end, and which tolerance costs most.

| module      | what it holds                                                            |
|-------------|--------------------------------------------------------------------------|
| `fleet`     | many cars at once, each with its own dimensions                          |
| `tracks`    | tracks of cars without play, as small changes of the nominal one         |
| `stretches` | jumps and waits of many cars' cams, each car with its own friction       |
| `watch`     | whether cars keep a course, from their poses at a few places             |
| `robust`    | Monte Carlo over the tolerances, yield within a gate, sensitivities      |
| `budget`    | all deviations and processes ranked by their cost, before and after a trim |
"""
