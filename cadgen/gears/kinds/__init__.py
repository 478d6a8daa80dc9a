"""The kinds of stages: a new one is a file here and a name in the table, or is registered from outside.

| module        | what it holds                                                     |
|---------------|-------------------------------------------------------------------|
| `kind`        | what a kind is: its code, its keys, and how a stage is built      |
| `spur_checks` | a pair of spur gears in mesh: figures, limits and verdicts        |
| `spur_facts`  | the same as plain values for the manifest and the table of parts  |
| `spur`        | a pair of spur gears as a stage of a train                        |
| `table`       | all kinds by their codes                                          |
"""
