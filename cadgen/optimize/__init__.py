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
| `derivatives`  | how the steering changes with everything about disc and rod that may be a little off |
| `stretches`    | where many cars' cams jump, wait and go on, each with its own friction and drag      |
| `robust`       | Monte Carlo over the tolerances, yield within a gate, sensitivities                  |
| `budget`       | everything that may be off, ranked by what it costs before and after a trim          |
| `processes`    | what processes usually hold, and how materials grow with heat                        |
"""
