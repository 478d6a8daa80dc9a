"""Settings of a single cam for every draw of spacings: what to set for each, as a card and a table.

| module  | what it does                                                          |
|---------|-----------------------------------------------------------------------|
| `maker` | the setting of a spacing, driven by the exact chain                   |
| `plan`  | design -> the cam with a setting for every spacing                    |
| `files` | the result as plain values, as a table and as a printed card          |
"""
