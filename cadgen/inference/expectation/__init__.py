"""Expectations of a measured car: of a new cam, of measurements not made yet, and of runs that were not used.

| module             | what it does                                                                              |
|--------------------|-------------------------------------------------------------------------------------------|
| `outlook`          | where the car ends on the old cam, and on a new one made for what is claimed              |
| `linear`           | joint information of records on all effects, to first order; what may be true of the car  |
| `next_measurement` | which measurement brings the run nearest to its end on the next cam                       |
| `predict`          | runs that were not used, predicted with what was found                                    |
"""
