"""Files for a shop: a format is one module and one line in the table of `formats`, for cams and gears alike.

| module         | what it holds                                                                |
|----------------|------------------------------------------------------------------------------|
| `formats`      | the table of formats, and the choice among them                              |
| `exports`      | cams, gears and trains that are to be written, with the proof of their files |
| `step`         | STEP                                                                         |
| `stl`          | STL                                                                          |
| `threemf`      | 3MF                                                                          |
| `dxf`          | outlines as arcs or as splines, for laser, wire EDM and CAD                  |
| `nc`           | programs for a mill, and the time that they take                             |
| `plate`        | the plate for the axes of a train, as DXF and STEP                           |
| `frame_files`  | parts of a frame, as DXF, STEP and programs                                  |
| `sheet_nc`     | the program that mills a sheet part                                          |
| `groove`       | files of a cam with a groove                                                 |
| `groove_nc`    | the program that mills a groove                                              |
| `gcode`        | the program that mills an outline, over its tabs                             |
| `drilling`     | the programs that drill holes                                                |
| `hole_milling` | the program that mills holes wider than the cutter                           |
| `gcode_machine`| an interpreter of programs                                                   |
| `gcode_reader` | the outline, the tabs and the holes that programs leave                      |
| `xyz`          | clouds of points for a curve of a CAD system                                 |
| `tables`       | CSV: contacts of a cam, parts of a train, tracks of a car                    |
| `publisher`    | the files of a job published with their entry in the manifest                |
| `folder`       | files appear all together or not at all; a folder against its manifest       |
| `lock`         | one run at a time moves files into a folder                                  |
| `manifest`     | `manifest.json`: hashes, versions, checks, measured errors                   |

Each format has a reader of its own that shares no code with the writer, so that every file can be proved. The CAD
kernel, which writes and reads STEP, is in `cadgen.geometry.solids`.
"""
