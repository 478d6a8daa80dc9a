"""From a design, or from numbers, to the files of a gear train.

| module       | what it holds                                                       |
|--------------|---------------------------------------------------------------------|
| `assembly`   | what all pairs and trains have: figures, solids, files, on record   |
| `gear_train` | design -> play, order, and the train that is made                   |
| `train_making` | materials and fits of a train                                     |
"""
