"""Many cars within the tolerances of a design: how their runs end, and which tolerance costs most.

| module           | what it holds                                                              |
|------------------|----------------------------------------------------------------------------|
| `tracks`         | tracks of cars without play, as small changes of the nominal one           |
| `course_margins` | margins of cars to the items of a course, from their poses at a few places |
| `cars`           | many cars at once, each with its own dimensions, friction and play         |
| `random_cars`    | random cars within the tolerances, yield within a gate, sensitivities      |
| `budget`         | deviations and processes ranked by their cost, before and after a trim     |
"""
