"""Worn cams: from a measured outline or lift to the motion that was meant, and to a new part.

| module          | what it holds                                                                      |
|-----------------|------------------------------------------------------------------------------------|
| `found_cam`     | measured cam of unknown motion -> its motion, the new design, the new cam          |
| `compared_cam`  | measured cam of known motion -> what differs from its design, and in sentences     |
| `found_report`  | the motion that was found in sentences and a table; the files of either            |
"""
