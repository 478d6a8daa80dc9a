"""From a design to the files of a cam.

| module      | what it holds                                                             |
|-------------|---------------------------------------------------------------------------|
| `plan`      | design -> lift, profile and checks                                        |
| `cures`     | changes of one key that cure lost lift, each proved                       |
| `against`   | a profile against play beside the plain one, and what it saves            |
| `checking`  | the checks of profiles against play, each made once                       |
| `choosing`  | the choice among profiles by limits and checks                            |
| `play`      | design with play -> the profile that is best against it, with the reasons |
| `mechanics` | what friction and drag do to a cam, in checks and words                   |
| `remedies`  | what else helps against play, on one sheet                                |
| `edges`     | what edges broken more than designed cost at the finish                   |
| `as_built`  | what a design says of the car as built, in words                          |
| `manifest`  | plan, cures and remedies as plain values                                  |
| `files`     | a checked cam -> every file, read back, rolled, published, on record      |
"""
