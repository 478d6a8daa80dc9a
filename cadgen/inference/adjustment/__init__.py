"""Adjustment by hand after trial runs: measured points of a few tracks -> settings of the micrometer, key and start.

| module      | what it holds                                                                |
|-------------|------------------------------------------------------------------------------|
| `trial`     | settings that a hand makes; one trial run; which station a point belongs to   |
| `posterior` | cars that explain the trial runs, by their deviations within the tolerances   |
| `choice`    | settings with the least expected error, and the errors expected with them     |

A trial run is fitted with everything that the tolerances let vary: a Gaussian about each pair of play and friction on a
grid, for the car jumps elsewhere with another play or friction, and answers the rest almost linearly.
"""
