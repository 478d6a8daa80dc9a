"""Files that users write: measured data and trial runs, and points of a path.

| module         | what it does                                                                          |
|----------------|---------------------------------------------------------------------------------------|
| `units`        | names and units of columns as people write them, and words of their cells             |
| `text_table`   | text of any encoding, and the names of its columns with any marks between them        |
| `table_rows`   | rows under the names, apart from titles, summaries, lost points and rows written twice |
| `cell_numbers` | numbers with any decimal mark, thousands set apart, units behind, degrees and minutes |
| `side_by_side` | runs that stand side by side, brought under each other                                |
| `columns`      | columns of a file matched to those of a kind of measured data                         |
| `load`         | files -> records of the kind with these columns, and trial runs with their settings   |
| `points`       | points of a path, from rows of numbers or a DXF's polyline                            |
"""
