"""Solids: the only room that loads the CAD kernel, and files that need it.

| module      | what it does                                                        |
|-------------|---------------------------------------------------------------------|
| `kernel`    | edges, wires, prisms, validity and volume on the kernel             |
| `crossing`  | exact edges where a drilled hole meets a wall                       |
| `cam`       | the disc with bore, holes and hub                                   |
| `chamfered` | a disc with both edges of its rim broken                            |
| `gear`      | gears                                                               |
| `train`     | the parts of a gear train, and their assembly                       |
| `beside`    | a process that has loaded the kernel, beside this one               |
| `step`      | STEP: reproducible bytes, and what the kernel reads from them       |
| `step_text` | the rim read from a STEP file's text, without the kernel            |
| `gear_text` | a gear's tooth curves and solid read from a STEP file's text        |

Importing this package loads nothing; all modules but `beside` and the two of text load the kernel when they are
imported.
"""
