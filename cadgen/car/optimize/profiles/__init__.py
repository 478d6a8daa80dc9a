"""The profiles that a cam can have, each an object of its own with a code.

| module                 | what it holds                                                         |
|------------------------|-----------------------------------------------------------------------|
| `profile`              | a profile: its code, its purpose, its lift and its curve              |
| `actual`               | the exact envelope of the rod                                         |
| `optimized`            | the best against play of all that can be compared                     |
| `compensated`          | the lift dilated by the play, so that the play takes itself out       |
| `smoothed`             | the paper's: peaks and valleys brought nearer to each other           |
| `smoothed_compensated` | both                                                                  |
| `theoretical`          | the curve of the rod's axis                                           |
| `published`            | the formula of the paper's appendix                                   |
| `table`                | all of them; a new profile is a file here and a line there            |

What is computed is imported only when it is: the table itself is light, for commands that only name profiles.
"""
