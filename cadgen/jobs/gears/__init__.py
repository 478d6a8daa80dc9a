"""From a design, or from numbers, to the files of a gear train.

| module    | what it holds                                                        |
|-----------|----------------------------------------------------------------------|
| `plan`    | design -> play, order, and the train that is made                    |
| `facts`   | a planned train -> plain values for manifest, table and machines     |
| `files`   | a checked train -> files, read back, measured, on record             |
| `numbers` | gears and trains without a design file, to the same checks and files |
"""
