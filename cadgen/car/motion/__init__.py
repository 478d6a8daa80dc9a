"""How the car runs when the gears have play: from a lift and a return error to tracks and errors.

| module    | what it does                                                                            |
|-----------|-----------------------------------------------------------------------------------------|
| `play`    | where the cam stands at each motor position: it jumps at peaks and waits in valleys      |
| `drive`   | cam angle -> steering -> heading and the tracks of the three wheels (eq. 20-24): the one |
|           | integration of a run, for simulation, profiles and measured tracks alike                 |
| `laps`    | where the car stands after each lap of a closed path                                     |
| `poses`   | a run as the poses that a course is held against                                         |
| `friction` | bands of sliding friction, by pairs of materials                                       |
| `mechanics` | forces that turn the cam ahead of its gears or hold it: rod force, friction, drag     |
| `errors`  | deflection errors of the events (eq. 28, 30); heading and position errors along the run  |
| `sampled` | steering known at sampled cam angles, such as a rolled outline's -> a lift curve         |
"""
