"""The Python face: what commands, scripts and notebooks call. It never prints and never ends the program.

| module     | what it holds                                                             |
|------------|---------------------------------------------------------------------------|
| `values`   | numbers and words of a caller, refused in one sentence                     |
| `overrides`| values of Python as the overrides of the command line                      |
| `files`    | what a job has written; whether a folder still is that                     |
| `cam`      | a cam that has been computed: figures, picture, solid, files               |
| `runs`     | runs with play, the methods against it, many cars within the tolerances    |
| `measured` | measured data, as files or as arrays                                       |
| `gear`     | a gear by its numbers                                                      |
| `gears`    | pairs and trains of gears, by their numbers or of a design                 |
| `calibration` | a judgement of measured data, and the design built from it              |
| `adjustment` | settings after trial runs                                                |
| `design`   | a design and what can be done with it                                      |

Everything raises the errors of `cadgen.errors`: one sentence that says what is wrong, where, and what to change. The
public names are those of `cadgen` itself; numbers are mm and rad unless the name ends in another unit.
"""

import logging

# Without a handler Python itself would print what the program warns of.
logging.getLogger("cadgen").addHandler(logging.NullHandler())
