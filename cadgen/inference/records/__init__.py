"""Files that users write: measured data and trial runs, and points of a path.

| module       | what it does                                                                         |
|--------------|--------------------------------------------------------------------------------------|
| `units`      | names and units of columns as people write them                                      |
| `text_table` | tables of any encoding, with any marks between columns, with decimal points or commas |
| `columns`    | columns of a file matched to those of a kind of measured data                        |
| `load`       | files -> records of the kind with these columns, and trial runs with their settings  |
| `points`     | points of a path, from rows of numbers or a DXF's polyline                           |
"""
