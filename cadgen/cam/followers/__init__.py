"""The kinds of follower: a new one is a file here and a line in the table, or is registered from outside.

| module         | what it holds                                                                  |
|----------------|--------------------------------------------------------------------------------|
| `kind`         | what a kind is: its code, its keys of the design file, and how it is built      |
| `rod_geometry` | the leaning rod and the two planes that carry it                                |
| `rod_envelope` | its exact envelope in a plane                                                   |
| `rod_profiles` | the rod axis's curve, and the formula of the paper's appendix                   |
| `rod_first_order` | change of the steering with disc, faces and rod, to first order              |
| `rod_checks`   | carrying face, rim, chamfers and hub                                            |
| `rod`          | the leaning rod as a follower                                                   |
| `rod_kind`     | its keys of the design file                                                     |
| `table`        | all kinds by their codes                                                        |
"""
