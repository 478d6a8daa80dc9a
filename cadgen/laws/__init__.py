"""Motions: what a follower has to do in one turn of the cam.

| module   | what it holds                                                                        |
|----------|--------------------------------------------------------------------------------------|
| `motion` | a motion q(theta) with its unit: periodic piecewise polynomial, kinks, level parts   |
"""
