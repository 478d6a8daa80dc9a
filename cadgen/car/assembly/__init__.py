"""The parts of a car at their places: what keeps clear of what, and where the train goes.

| module        | what it does                                                                     |
|---------------|----------------------------------------------------------------------------------|
| `bodies`      | cylinders of any direction, and how far two of them are apart                     |
| `site`        | what stands in a car besides its train: disc, rod, wheels, floor, plates          |
| `arrangement` | directions of the stages that bring the drive onto the rear axle, clear of all    |
| `turning_train` | the train beside its cam, and how its shafts turn                               |
| `car_parts`   | parts of a car: shape, place, material, mass, and what each moves with            |
| `standard_parts` | ball bearings, screws, nuts and their holes by standard sizes                 |
| `panels`      | sheets: exact outlines, and gaps to round bodies                                  |
| `fork_sizes`  | sizes of fork, hubs and shaft ends that no design states                          |
| `frame`       | plates, base, platform, block and brackets, by the layout                         |
| `carried`     | drop weight or motor on the base: place, rods, tubes and top plate                |

The frame is that of the cam's files: the camshaft is the z axis, which points to the car's left; x points ahead, to
the fork, and y down. The plane z = 0 is the disc's lower face.
"""
