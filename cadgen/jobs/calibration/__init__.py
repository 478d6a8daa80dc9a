"""From measured files to the design as built.

| module               | what it holds                                                                     |
|----------------------|-----------------------------------------------------------------------------------|
| `sources`            | measured files, and arrays in memory that are read as files are                   |
| `cam_on_car`         | the car as designed with the measured cam on it, or with the next one             |
| `new_cam`            | places of claims in the as-built design, and what a new cam is expected to do     |
| `calibration`        | measured files -> one verdict for each kind of data, and what they say together   |
| `calibration_report` | a calibration in paragraphs and tables                                            |
| `advice`             | what to measure next; runs that were not used, predicted with what was found      |
| `workshop`           | file of what a workshop's cars differ by; times of measurements                   |
| `learned_workshop`   | calibrated cars -> what they differ by, claimed or not                            |
| `as_built_file`      | the design file with what was measured at its end                                 |
| `files`              | report, pictures, JSON and the as-built design, published together                |
"""
