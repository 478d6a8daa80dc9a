"""Measured data from files. Only this room, `design` and `export` read files that users write.

| module | what it does                                                                      |
|--------|-----------------------------------------------------------------------------------|
| `load` | CSV files -> records, of the kind with these columns; impossible values are refused |
| `points` | points of a path, from rows of numbers or a DXF's polyline                        |
| `trials` | trial runs from such files, and the comment line that gives their settings        |
"""
