"""From a design to the files of a cam.

| module      | what it holds                                                             |
|-------------|---------------------------------------------------------------------------|
| `plan`      | design -> lift, profile and checks                                        |
| `cures`     | changes of one key that cure lost lift, each proved                       |
| `comparison` | a profile against play beside the plain profile, and the gain             |
| `checking`  | the checks of profiles against play, each made once                       |
| `choosing`  | the choice among profiles by limits and checks                            |
| `play`      | design with play -> the profile that is best against it, with the reasons |
| `mechanics` | effect of friction and drag on a cam, in checks and words                 |
| `remedies`  | other remedies against play, on one sheet                                 |
| `as_built`  | deviations of the car as built, in words                                  |
| `wheel`     | the drive wheel that a cam is for, and the closing blend on the path      |
| `course`    | the planned run and those with play, held against the course              |
| `course_checks` | the checks of both                                                    |
| `car_facts` | play, friction and the car as built as plain values                       |
| `manifest`  | plan, cures and remedies as plain values                                  |
| `files`     | a checked cam -> every file, read back, rolled, published, on record      |
"""
