"""Files for a shop: one module per format, each with its own reader, so that what was written can be proved.

| module         | what it does                                                                |
|----------------|-----------------------------------------------------------------------------|
| `mesh`         | STL and 3MF                                                                 |
| `dxf`          | the outline as arcs or as splines, for laser, wire EDM and CAD                |
| `gcode`        | the milling program                                                          |
| `gcode_reader` | an interpreter of milling programs, and the outline that the cutter leaves  |
| `points`       | the cloud of points for CAD curve import, and the table by cam angle          |
| `tracks`       | the three wheels' tracks as a table                                         |
| `formats`      | which of a job's files are wanted, by their endings                         |
| `folder`       | files appear all together and complete, or not at all                         |
| `lock`         | one run at a time moves files into a folder                                  |
| `verify`       | whether a folder still is what its manifest says                             |
| `manifest`     | `manifest.json`: hashes, versions, checks, measured errors                    |

STEP is written and read in `cadgen.solids`, since only the CAD kernel knows it.
"""
