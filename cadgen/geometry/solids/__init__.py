"""Solids: the only room that loads the CAD kernel, and files that need it.

| module        | what it does                                                               |
|---------------|----------------------------------------------------------------------------|
| `kernel`      | edges, wires, prisms, validity and volume on the kernel                    |
| `crossing`    | exact edges where a drilled hole meets a wall                              |
| `disc_solid`  | the disc of a cam with bore, holes and hub, its rim sharp or broken        |
| `helical_wall` | walls of helical teeth as Bézier patches and exact cylinders           |
| `gear_solids` | gears, the parts of a gear train, and their assembly                       |
| `car_solids`  | parts of a car as solids, and the car as one assembly                      |
| `step`        | STEP: reproducible bytes, and what the kernel reads from them              |
| `step_text`   | rim or tooth curves read from a STEP file's text, without the kernel       |

Importing this package loads nothing; all modules but `step_text` load the kernel when they are imported.
"""
