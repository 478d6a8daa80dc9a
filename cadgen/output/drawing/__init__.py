"""Drawings for a workshop: sheets made from the numbers of a part, and their DXF and PDF.

| module    | what it does                                                    |
|-----------|-----------------------------------------------------------------|
| `sheet`   | curves, dimensions, tables and title of a sheet, as data        |
| `section` | section of a body through its axis                              |
| `room`    | places for texts where few lines cross them                     |
| `screw`   | hole of a set screw in the views                                |
| `cam`     | sheet of a cam                                                  |
| `gear`    | sheet of a part of a train                                      |
| `data`    | table of a gear's data                                          |
| `plate`   | sheet of the plate that holds the axes                          |
| `dxf`     | the sheet as DXF, and its dimensions read again                 |
| `fonts`   | fonts of the pages                                              |
| `pdf`     | the sheet as a page                                             |
"""
