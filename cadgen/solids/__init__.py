"""Solids: the only room that loads the CAD kernel, and files that need it.

| module      | what it does                                                        |
|-------------|---------------------------------------------------------------------|
| `kernel`    | edges, wires, prisms, validity and volume on the kernel             |
| `cam`       | the disc with bore, holes and hub                                   |
| `gear`      | gears                                                               |
| `step`      | STEP: reproducible bytes, and what the kernel reads from them       |
| `step_text` | the rim read from a STEP file's text, without the kernel            |

Importing this package loads nothing; all modules but `step_text` load the kernel when they are imported.
"""
