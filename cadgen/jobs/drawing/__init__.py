"""Drawings of a cam and of a gear train: sheets from computed parts, then files that are read back.

| module  | what it does                                                              |
|---------|---------------------------------------------------------------------------|
| `title` | title blocks, and the files of the folder that a drawing refers to        |
| `cam`   | the sheet of a cam, and the form on which its lift is written down        |
| `train` | the sheets of the parts of a train and of the plate that holds the axes   |
| `files` | DXF, PDF and CSV with their entry in the manifest                         |
"""
