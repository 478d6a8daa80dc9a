"""From measured files to the design as built.

| module          | what it holds                                                                   |
|-----------------|---------------------------------------------------------------------------------|
| `plan`          | measured files -> one verdict for each kind of data, and what they say together |
| `places`        | places of claims in the as-built design                                         |
| `new_cam`       | what a new cam is expected to do                                                |
| `joint_effect`  | what is not sure by name, and taken out all the same                            |
| `advice`        | what to measure next, in words too                                              |
| `prediction`    | runs that were not used, predicted with what was found, in words too            |
| `zone_means`    | mean turns over zones, beside what the design's train lets expect               |
| `tables`        | arrays in memory, read as files are                                             |
| `words`         | a calibration in words and tables                                               |
| `as_built_file` | the design file with what was measured at its end                               |
| `files`         | report, pictures, JSON and the as-built design, published together              |
"""
