"""Jobs from a design to verified files; the command line and other programs call these.

| module        | what it holds                                            |
|---------------|----------------------------------------------------------|
| `planning`    | course and car -> a path that passes every check         |
| `cam`         | design -> profile, checks -> files of a cam              |
| `card`        | settings for every spacing of a course that can be drawn |
| `settings_maker` | the setting of a spacing, driven by the exact chain   |
| `gears`       | design -> train, checks -> files of a gear train         |
| `simulation`  | the car's runs with play, one by one                     |
| `tolerance`   | many cars within the tolerances                          |
| `lift_tolerance` | errors of the lift of many cams by their motion       |
| `car_layout`  | the train in its car, and its checks                     |
| `car_frame`   | the frame of a car: checks, files and sheets             |
| `frame_writer` | files and sheets of a frame                              |
| `frame_parts` | parts of a frame among the parts of its car              |
| `car_assembly` | a car put together: all parts at their places            |
| `mounting_parts` | collars, spring, brake and what else mounting needs     |
| `car_gaps`    | gaps of each part of a car to the nearest others         |
| `assembly_checks` | whether a car put together stands, and has the energy  |
| `assembly_files` | a car put together -> STEP, list of parts, sheets        |
| `part_drawings` | sheets of wheels, shafts, rod and fork                  |
| `train_proposal` | wheel, path and sizes of a car -> a train that fits it |
| `nominal_car` | the car that these are varied from                       |
| `error_budget`| what costs most at the finish                            |
| `calibration` | measured files -> verdicts -> the design as built        |
| `worn_cam`    | a worn cam, measured -> its motion and a new design      |
| `measured_gears` | measured gears -> what they have, and what to change  |
| `drawings`    | cam and train -> drawings for a workshop                 |
| `adjustment`  | trial runs -> what a hand sets before the next           |
"""
