"""From a design to the files of a cam.

| module       | what it holds                                                                |
|--------------|------------------------------------------------------------------------------|
| `cam_plan`   | a cam that is computed and checked, how it is made, and what it is for       |
| `force_figures` | forces on a follower and its camshaft in checks                           |
| `motion_figures` | peaks, seams and table of a motion                                       |
| `motion_cam` | a cam by its motion: its use, plan and checks                                |
| `steered_car` | a car that a cam steers, as far as its parts and their energy go by it        |
| `steering_cam` | a car's cam: the car as its use, plan and checks                           |
| `cures`      | changes of one key that cure lost lift, each proved                          |
| `cam_facts`  | plan and cures as plain values                                               |
| `cam_files`  | a checked cam -> every file, read back, rolled, published                    |
| `comparison` | a car's profiles against play: compared, checked, chosen, with the reasons   |
| `mechanics`  | effect of friction and drag on a car's cam, in checks and words              |
| `remedies`   | other remedies against play, on one sheet                                    |
| `lever`      | a longer lever as a remedy, and the whole sheet                              |
| `built_car`  | deviations of the car as built, in words                                     |
| `path_check` | the car driven on its cam, held against the points of its path               |
| `readiness`  | cars that keep the course, and what holds a car's cam back                   |
| `wheel`      | the drive wheel that a cam is for, and the closing blend on the path         |
| `course`     | the planned run and those with play, held against the course                 |
| `car_facts`  | play, friction and the car as built as plain values                          |
"""
