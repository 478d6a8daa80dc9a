"""The Python face: the functions and classes for commands, scripts and notebooks. It never prints and never exits.

| module     | what it holds                                                             |
|------------|---------------------------------------------------------------------------|
| `values`   | checks of a caller's numbers and words, with one sentence a refusal        |
| `cam`      | a cam that has been computed: figures, picture, solid, files               |
| `motion_cam` | a motion, a follower, and the cam of both without a design file          |
| `comparison` | the methods against play, compared                                       |
| `runs`     | what a simulation, random cars and a budget of errors give                 |
| `assembly` | a car put together: masses, checks, files                                 |
| `drawing`  | drawings of cams and trains                                                |
| `measured` | measured data, as files or as arrays                                       |
| `gears`    | gears, pairs and trains by their numbers                                   |
| `rack`     | racks by their numbers, alone and under a pinion                           |
| `planetary` | planetary sets by their numbers                                          |
| `calibration` | a judgement of measured data, and the design built from it              |
| `found_cam` | a measured cam: its motion and the new cam, or what differs from its design |
| `measured_gears` | a measured train: its errors by wheel, and what to change             |
| `adjustment` | settings after trial runs                                                |
| `planning`   | a planned path, or why there is none                                    |
| `loaded`   | a design that has been read, and changed copies of it                      |
| `design`   | a design and what can be done with it                                      |
| `views`      | the report page of a design, and that page in the browser             |
| `exploration` | studies of many designs                                                 |

Everything raises the errors of `cadgen.errors`: one sentence that says what is wrong, where, and what to change. The
public names are those of `cadgen` itself; numbers are mm and rad unless the name ends in another unit.
"""

import logging

# Without a handler Python itself would print the program's warnings.
logging.getLogger("cadgen").addHandler(logging.NullHandler())
