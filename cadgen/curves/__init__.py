"""Plane closed curves made of smooth pieces, and what a shop needs of them.

| module      | what it does                                                                 |
|-------------|------------------------------------------------------------------------------|
| `closed`    | a closed curve of smooth pieces: sampling, polar radius, area, corners       |
| `contour`   | a closed chain of lines and arcs; bores                                      |
| `spacing`   | nodes at even errors, for the three approximations below                     |
| `derived`   | a curve turned, displaced, or parallel outside: the path of a cutter         |
| `chamfer`   | the parallel curve inside, and the chamfer between the two                   |
| `biarc`     | lines and arcs within a stated tolerance (DXF, G-code)                       |
| `spline`    | B-splines within a stated tolerance (STEP, DXF)                              |
| `polygon`   | chords within a stated tolerance (STL, 3MF)                                  |
| `piecewise` | piecewise polynomials: quintics through given derivatives, and zeros         |
"""
