"""Drawings for a workshop: sheets made from the numbers of a part, and their DXF and PDF.

| module        | what it does                                                              |
|---------------|---------------------------------------------------------------------------|
| `sheet`       | curves, dimensions, tables and title of a sheet, as data                  |
| `section`     | section of a body through its axis; the hole of a set screw in the views  |
| `shaft_fit`   | fits of a part on its shaft: classes and limits                           |
| `placement`   | places for texts where few lines cross them                               |
| `hole_frames` | frames of the seats in a plate, and its view from the side                |
| `timing`      | timing diagram of a cam by its motion                                     |
| `cam_turns`   | points where the outline of a cam turns, for its table                    |
| `cam_sheet`   | sheet of a cam                                                            |
| `gear_sheets` | sheets of the parts of a train, and of the plate that holds the axes      |
| `assembly_sheet` | sheets of a car put together: views with balloons, steps of mounting     |
| `frame_sheets` | sheets of a frame's parts and of shafts                                  |
| `part_sheets` | sheets of plain turned parts, plates and blocks                           |
| `sheet_files` | a sheet as DXF and as a page, and the DXF's dimensions read again         |
"""
