"""Motions: what a follower has to do in one turn of the cam, and the laws of rises.

| module          | what it holds                                                                  |
|-----------------|--------------------------------------------------------------------------------|
| `motion`        | a motion q(theta) with its unit: periodic piecewise polynomial, kinks, level   |
| `unit`          | units of motions: lift in mm, swing in rad, tangent of a steering angle        |
| `form`          | closed forms of laws: pieces of powers and sines, either side of every seam    |
| `law`           | what a motion law is: the normalised rise over a segment                       |
| `power_laws`    | polynomials from rest to rest, constant velocity, constant acceleration        |
| `sine_laws`     | cycloidal and harmonic laws, their halves, laws of few harmonics               |
| `scca`          | modified trapezoid, modified sine, with constant velocity or without           |
| `valve_lobe`    | the lobe of a valve, 2-p-q-r-s                                                 |
| `table`         | every law by its code                                                          |
| `conditions`    | polynomials by conditions at any number of places                              |
| `segments`      | a motion of rises and dwells, judged at its seams                              |
| `series`        | a motion of harmonics                                                          |
| `lift_table`    | a motion of points or of a lift table: closure, noise, splines                 |
"""
