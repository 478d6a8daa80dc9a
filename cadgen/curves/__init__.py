"""Plane closed curves made of smooth pieces, and what a shop needs of them.

| module     | what it does                                                                |
|------------|-----------------------------------------------------------------------------|
| `closed`   | a closed curve of smooth pieces: sampling, polar radius, area, corners       |
| `moved`    | the same curve with its points moved a little                                |
| `turned`   | the same curve turned about the origin                                       |
| `contour`  | a closed chain of lines and arcs; bores                                      |
| `spacing`  | nodes at even errors, for the three approximations below                     |
| `offset`   | the parallel curve on which a cutter's centre runs                           |
| `inset`    | the parallel curve inside, and the chamfer between the two                   |
| `biarc`    | lines and arcs within a stated tolerance (DXF, G-code)                       |
| `spline`   | B-splines within a stated tolerance (STEP, DXF)                              |
| `zeros`    | zeros of a piecewise polynomial of many pieces                               |
| `polygon`  | chords within a stated tolerance (STL, 3MF)                                  |
| `hermite`  | values and derivatives at nodes -> piecewise quintic polynomial             |
"""
