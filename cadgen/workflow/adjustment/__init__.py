"""Adjustment: trial runs of a car -> what a hand sets so that the next run ends where it is planned.

| module   | what it holds                                                          |
|----------|------------------------------------------------------------------------|
| `trials` | trial runs from files, and the comment line that gives their settings  |
| `plan`   | cars that explain them, the best settings, what to expect; sentences   |
| `files`  | the settings, trial runs and expectations as a verified JSON file      |
"""
