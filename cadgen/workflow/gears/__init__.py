"""From a design to the files of a gear train.

| module  | what it holds                                                    |
|---------|------------------------------------------------------------------|
| `plan`  | design -> play, order, layout and measured mesh                  |
| `facts` | a planned train -> plain values for manifest, table and machines |
| `files` | a checked train -> every file, read back, measured, on record    |
"""
