"""Worn cams: from a measured outline or lift to the motion that was meant, and to a new part.

| module          | what it holds                                                                      |
|-----------------|------------------------------------------------------------------------------------|
| `found_cam`     | measured cam of unknown motion -> its motion, the new design, the new cam          |
| `compared_cam`  | measured cam of known motion -> what differs from its design                       |
| `compared_report` | what differs in sentences and a table                                            |
| `files`         | report, JSON and the new design, published together                                |
| `found_report`  | the motion that was found in sentences and a table                                 |
"""
