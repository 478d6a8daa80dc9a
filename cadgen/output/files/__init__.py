"""Files for a shop: one module per format, each with its own reader, so that every file can be proved.

| module         | what it does                                                                |
|----------------|-----------------------------------------------------------------------------|
| `mesh`         | STL and 3MF                                                                 |
| `dxf`          | the outline as arcs or as splines, for laser, wire EDM and CAD                |
| `gear_outline` | the teeth of a gear as splines in DXF                                        |
| `programs`     | every program for a mill that a disc needs                                  |
| `gcode`        | the program that mills the outline                                          |
| `gcode_tabs`   | tabs that hold the disc until it is clamped                                 |
| `drilling`     | the programs that drill the holes                                           |
| `program_time` | time that these programs take at their feeds                                |
| `gcode_words`  | words and comments of programs                                              |
| `gcode_machine`| an interpreter of programs                                                  |
| `gcode_reader` | the outline and the tabs that a program leaves                              |
| `drill_reader` | the holes that a program leaves                                             |
| `points`       | the cloud of points for CAD curve import, and the table by cam angle          |
| `edges`        | note on broken edges, for files of the outline alone                         |
| `tracks`       | the three wheels' tracks as a table                                         |
| `formats`      | choice among a job's files, by their endings                                |
| `folder`       | files appear all together and complete, or not at all                         |
| `lock`         | one run at a time moves files into a folder                                  |
| `verify`       | comparison of a folder with its manifest                                    |
| `manifest`     | `manifest.json`: hashes, versions, checks, measured errors                    |

STEP is written and read in `cadgen.geometry.solids`, since that needs the CAD kernel.
"""
