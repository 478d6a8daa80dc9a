"""Methods against play, how well they can work, and the choice among them.

| module         | what it holds                                                                  |
|----------------|--------------------------------------------------------------------------------|
| `nodes`        | a lift taken apart into nodes with jets and put together again                 |
| `smoothing`    | the paper's smoothed profile: peak and valley values brought down              |
| `dilation`     | the dilation of any lift by the window of the play                             |
| `compensation` | the profile that takes play out: the dilation, made fit to cut                 |
| `band`         | the play to cut it for within a band, and the bound that no profile can better |
| `task`         | the lift and run wanted, and on a train the best window for a lift             |
| `profiles`     | every profile that a cam can have, by its code                                 |
| `evaluate`     | a profile evaluated as it is cut: rolled and run with play                     |
| `laps`         | drift on a closed path, per lap and after the last one                         |
| `choice`       | the best of several profiles under limits, with the reasons                    |
| `remedies`     | error that is left with a brake, a trim or a bearing, where the rod rubs       |
"""
