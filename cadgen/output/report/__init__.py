"""Pictures, tables and texts of results.

| module   | what it does                                                                   |
|----------|--------------------------------------------------------------------------------|
| `style`  | colours, sizes, and files whose bytes depend on their content alone             |
| `cam`    | a cam on one picture: outline and lift                                          |
| `card`   | a card of settings, to print                                                   |
| `settings` | settings for the spacings of a course, in words and as a table               |
| `reasons` | reasons why a course cannot be driven                                         |
| `lift`   | lift before and after, without and with play                                    |
| `tracks` | the wheels on the field; heading and position error along the run               |
| `terminal` | sheets and sentences on a terminal or as text; no number is cut               |
| `calibration` | a verdict on one record: residual before and after, candidates             |
| `errors` | deflection errors by event                                                      |
| `cars`   | ends of the runs of many cars; sensitivities                                    |
| `exploration`| studies of many designs                                                     |

Only this room imports matplotlib, inside its functions, since that takes time.
"""
