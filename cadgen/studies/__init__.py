"""Studies of thousands of designs: what varies, what is aimed at, and every design computed once, wherever that is.

| module      | what it holds                                                                        |
|-------------|--------------------------------------------------------------------------------------|
| `figures`   | figures that a study may aim at or limit                                             |
| `variation` | one key that varies                                                                  |
| `plans`     | fixed plans: full factorial, Latin hypercube, Sobol                                  |
| `search`    | search for the front by whole generations                                            |
| `study`     | the study's file, checked                                                            |
| `faults`    | faults of that file, as sentences                                                    |
| `read`      | a study from its file                                                                |
| `guard`     | limits of time and memory for one design                                             |
| `evaluate`  | one design -> one row                                                                |
| `paths`     | planned paths, each distinct one once                                                |
| `engines`   | processes, executors, dask                                                           |
| `work`      | tasks in batches through an engine, whatever dies                                    |
| `journal`   | every result on disk as soon as it is there                                          |
| `run`       | a study computed                                                                     |
| `results`   | all rows in order, from one journal or several                                       |
| `merge`     | results of shards                                                                    |
| `front`     | the Pareto front                                                                     |
| `effects`   | share of each figure's variance that a key explains                                  |
| `table`     | CSV and Parquet                                                                      |
| `best`      | the best designs as design files                                                     |
| `files`     | all files of a study, published                                                      |
"""
