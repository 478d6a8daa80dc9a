"""What may be done against play, how well it can work, and how much the tolerances leave of it.

| module         | what it does                                                                        |
|----------------|-------------------------------------------------------------------------------------|
| `nodes`        | a lift taken apart into nodes with jets and put together again                       |
| `smoothing`    | the paper's smoothed profile: peak and valley values brought down                    |
| `compensation` | the profile that takes play out: dilation of the wanted lift, made fit to cut        |
| `band`         | the play to cut it for within a band, and the bound that no profile can better       |
| `judge`        | the methods by name, judged on the profiles they cut: rolled and run with play       |
| `choice`       | the best of several profiles under limits, with the reasons                          |
| `fleet`        | many cars at once, each with its own dimensions                                      |
| `robust`       | Monte Carlo over the tolerances, yield within a gate, sensitivities                  |
"""
