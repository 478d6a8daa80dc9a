"""From a measured cam to the motion that was meant, without its wear.

| module            | what it holds                                                                       |
|-------------------|-------------------------------------------------------------------------------------|
| `record_kinds`    | kinds of records of a cam: points and radii of its outline, lifts                   |
| `lift_samples`    | samples of the motion, of an outline by its normals; the flanks that they show      |
| `flank_fit`       | a flank by each law, with wear as a random process of one sign                      |
| `candidates`      | laws that a flank may have                                                          |
| `found_motion`    | all flanks together, with the centre of the disc; which laws are left               |
| `whole_degrees`   | ends of segments that a drawing had at whole degrees                                |
| `differences`     | a measured cam beside its design: what is off                                       |
| `disc_wear`       | wear of a disc's flanks beside deviations                                           |
| `off_bore`        | origin of an outline beside the bore                                                |
| `stated_motion`   | motion that was found as a design states it                                         |
"""
