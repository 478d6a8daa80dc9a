"""Public benchmark of measured mechanisms: records, tasks, truths, and a scorer that any program can use.

| module    | what it holds                                                                        |
|-----------|--------------------------------------------------------------------------------------|
| `score`   | scorer of a program's answers in JSON; standard library alone                        |
| `make`    | made records of steered vehicles, with their truths; no code of the package          |
| `plain`   | plain least squares on the same tasks; no code of the package                        |
| `ours`    | answers of this package                                                              |
| `convert` | raw logs of others -> columns of the benchmark                                       |
"""
