"""The kinds of follower: a new one is a file here and a line in the table, or is registered from outside.

| module            | what it holds                                                                       |
|-------------------|-------------------------------------------------------------------------------------|
| `kind`            | what a kind is: its code, its keys of the design file, and how it is built           |
| `probe`           | whether a follower that a kind has built lacks a member                              |
| `rod`             | the leaning rod: envelope, rolling, checks, published profiles, first order          |
| `rod_kind`        | its keys of the design file                                                          |
| `roller`          | roller and knife edge on a slide                                                     |
| `roller_kind`     | their keys of the design file                                                        |
| `flat`            | flat face on a slide, square or tilted                                               |
| `flat_kind`       | its keys of the design file                                                          |
| `swinging_roller` | roller on an arm                                                                     |
| `swinging_flat`   | flat face on an arm                                                                  |
| `swinging_kind`   | keys of both in the design file                                                      |
| `groove`          | rollers of a groove: on its flanks, and with play                                     |
| `closure`         | what holds a roller on its cam, and keys of a second roller                          |
| `lifts`           | sense in which an arm lifts                                                         |
| `face_run`        | run of the contact on a straight face                                                |
| `pivot`           | points as seen from a pivot, and the room that the disc leaves it                    |
| `table`           | all kinds by their codes                                                             |
"""
