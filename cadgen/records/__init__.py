"""Measured data from files: the only room beside those of the design and of the exports that reads what users write.

| module | what it does                                                                      |
|--------|-----------------------------------------------------------------------------------|
| `load` | CSV files -> records of the kind that their columns say; what cannot be is refused |
| `trials` | trial runs from such files, and the comment line that gives their settings        |
"""
