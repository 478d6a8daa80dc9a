"""The report page: what it shows is computed once, put into words and shapes, and written as one file.

| module           | what it does                                                     |
|------------------|------------------------------------------------------------------|
| `plan`           | cam, gears, runs, tolerance and calibration, each computed once   |
| `train`          | the train beside its cam, and how its shafts turn                 |
| `bodies`         | parts and shafts in 3D                                            |
| `scene`          | everything that moves                                             |
| `charts`         | curves over the cam angle                                         |
| `sections`       | tables of checks, play and tolerance                              |
| `parts_sections` | tables of inspection, parts and calibration                       |
| `page`           | the whole page                                                    |
| `files`          | the file, with its figures in the manifest                        |
"""
