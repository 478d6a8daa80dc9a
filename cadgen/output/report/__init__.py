"""Sheets, texts and pictures of results.

| module            | what it holds                                                                |
|-------------------|------------------------------------------------------------------------------|
| `terminal`        | sheets and sentences on a terminal or as text; no number is cut              |
| `settings_card`   | settings for the spacings of a course: sentences, sheet, CSV, page to print  |
| `style`           | colours, sizes, and files whose bytes depend on their content alone          |
| `cam_pictures`    | outline and lift of a cam, lift before and after, deflection errors by event |
| `tracks`          | the wheels on the field; heading and position error along the run            |
| `record_pictures` | a verdict on one record: residual before and after, candidates               |
| `cars`            | ends of the runs of many cars; sensitivities                                 |
| `study_pictures`  | studies of many designs                                                      |
| `gear_pictures`   | sections of gears in mesh                                                    |
| `shape_pictures`  | plane shapes: a section, the sheets of a frame, an assembly from two sides   |
| `notebook`        | results in a notebook: a line, figures, a picture; lines, bars               |

Pictures import matplotlib inside their functions, since that takes time.
"""
