"""The kinds of stages: a new one is a file here and a line in the table, or is registered from outside.

| module        | what it holds                                                     |
|---------------|-------------------------------------------------------------------|
| `spur_checks` | a pair of spur gears in mesh: figures, limits and verdicts        |
| `spur_facts`  | the same as plain values for the manifest and the table of parts  |
| `spur`        | a pair of spur gears as a stage of a train                        |
"""
