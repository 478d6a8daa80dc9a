"""Files that users write: measured data and trial runs, and points of a path.

| module   | what it does                                                                              |
|----------|-------------------------------------------------------------------------------------------|
| `load`   | CSV files -> records of the kind with these columns, and trial runs with their settings   |
| `points` | points of a path, from rows of numbers or a DXF's polyline                                |
"""
