"""Motions: what a follower has to do in one turn of the cam, and the laws of rises.

| module             | what it holds                                                                |
|--------------------|------------------------------------------------------------------------------|
| `motion`           | a motion q(theta) with its unit: periodic piecewise polynomial, kinks, level |
| `unit`             | units of motions: lift in mm, swing in rad, tangent of a steering angle      |
| `law`              | what a motion law is: the normalised rise over a segment                     |
| `polynomial_3_4_5` | the 3-4-5 polynomial                                                         |
| `cycloidal`        | the cycloidal law                                                            |
| `table`            | every law by its code                                                        |
| `segments`         | a motion of rises and dwells, checked at its seams                           |
"""
