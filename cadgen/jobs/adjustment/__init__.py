"""Adjustment: trial runs of a car -> what a hand sets so that the next run ends where it is planned.

| module   | what it holds                                                          |
|----------|------------------------------------------------------------------------|
| `plan`   | cars that explain them, the best settings, what to expect; its files   |
"""
