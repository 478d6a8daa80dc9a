"""Files for a shop: one module per format, each with its own reader, so that every file can be proved.

| module         | what it does                                                                |
|----------------|-----------------------------------------------------------------------------|
| `mesh`         | STL and 3MF                                                                 |
| `dxf`          | the outline as arcs or as splines, for laser, wire EDM and CAD                |
| `gear_outline` | the teeth of a gear as splines in DXF                                        |
| `gcode`        | the milling program                                                          |
| `gcode_reader` | an interpreter of milling programs, and the outline that the cutter leaves  |
| `points`       | the cloud of points for CAD curve import, and the table by cam angle          |
| `tracks`       | the three wheels' tracks as a table                                         |
| `formats`      | choice among a job's files, by their endings                                |
| `folder`       | files appear all together and complete, or not at all                         |
| `lock`         | one run at a time moves files into a folder                                  |
| `verify`       | comparison of a folder with its manifest                                    |
| `manifest`     | `manifest.json`: hashes, versions, checks, measured errors                    |

STEP is written and read in `cadgen.solids`, since that needs the CAD kernel.
"""
