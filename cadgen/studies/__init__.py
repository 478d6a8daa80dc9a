"""Studies of thousands of designs: what varies, what is aimed at, and every design computed once, wherever that is.

| module          | what it holds                                                                    |
|-----------------|----------------------------------------------------------------------------------|
| `study_figures` | figures that a study may aim at or limit                                         |
| `sampling`      | keys that vary, fixed plans, and the search by whole generations                 |
| `study`         | the study's file as a schema                                                     |
| `study_file`    | a study read from its file, and its faults as sentences                          |
| `design_row`    | one design -> one row, within limits of time and memory                          |
| `planned_paths` | planned paths, each distinct one once                                            |
| `engines`       | processes, executors and dask, and batches through them, whatever dies           |
| `journal`       | every result on disk as soon as it is there                                      |
| `results`       | all rows in order, from one journal or those of several shards                   |
| `study_run`     | a study computed                                                                 |
| `front`         | the Pareto front, and the share of each figure's variance that a key explains    |
| `study_files`   | table, front, pictures and best designs as files, published together             |
"""
