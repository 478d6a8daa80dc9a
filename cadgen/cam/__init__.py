"""The cam: from the motion wanted to a profile that a follower can ride on, and the proof that it does.

| module           | what it does                                                                    |
|------------------|---------------------------------------------------------------------------------|
| `follower`       | the interface of every follower: branches of its envelope, contact, checks      |
| `followers`      | the kinds of follower; the leaning rod is one                                   |
| `round_follower` | followers with a circle: their envelope in closed form                          |
| `straight_follower` | followers with a straight face: their envelope in closed form                |
| `envelope`       | the actual profile: exact envelope of a follower over its planes, trimmed       |
| `lower_hull`     | which branch of the envelope is the lowest, with rounding kept out              |
| `derived_motions`| opposite of a motion, of a second follower; tangent of a steering angle         |
| `contact`        | a follower rolled on any outline: the lift it gives (shares no code with those) |
| `difference`     | how far two outlines lift the follower apart                                    |
| `formulas`       | formulas of a follower, held against the outline that it has rolled on          |
| `limits`         | what the checks allow; textbook limits of the pressure angle, by name           |
| `cutter`         | which cutter reaches every concave part                                         |
| `lost_lift`      | lift that is missing where the envelope is trimmed, and the change that cures it |
| `sizing`         | least base circles and the best offset for a pressure angle                     |
| `lift_errors`    | errors of the lift by what is off, to first order; a disc put on wrong          |
| `forces`         | force on the disc, torque of the camshaft, speed of lift-off, contact pressure  |
| `checks`         | every figure with its limit, place and verdict                                  |
"""
