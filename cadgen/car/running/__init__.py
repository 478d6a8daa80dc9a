"""How the car runs when the gears have play: from a lift and a return error to tracks and errors.

| module      | what it does                                                                              |
|-------------|-------------------------------------------------------------------------------------------|
| `play`      | cam angle by motor position: the cam jumps at peaks and waits in valleys                  |
| `friction`  | bands of sliding friction, by pairs of materials                                          |
| `mechanics` | forces that turn the cam ahead of its gears or hold it: rod force, friction, drag         |
| `energy`    | what rolling, rod, brake and gears take of the drive's energy in a run                    |
| `tipping`   | speed at which a three-wheeled car tips over on its path                                  |
| `drive`     | cam angle -> steering -> heading and the tracks of the three wheels (eq. 20-24), by one   |
|             | integration for simulation, profiles and measured tracks alike; the run as poses          |
| `run_errors`| deflection errors of the events (eq. 28, 30); heading and position errors along the run   |
| `side_slip` | slip angles by which the wheels hold the yaw of one driven wheel                          |
| `sampled`   | steering known at sampled cam angles, such as a rolled outline's -> a motion              |
"""
