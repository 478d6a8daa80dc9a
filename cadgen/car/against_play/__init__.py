"""Profiles and remedies against play, how well they can work, and the choice among them.

| module          | what it holds                                                                         |
|-----------------|---------------------------------------------------------------------------------------|
| `profile_kinds` | every kind of profile that a cam can have, by its code                                |
| `smoothing`     | the paper's smoothed profile: peak and valley values brought down                     |
| `compensation`  | the profile that takes play out: the lift dilated by the window of the play           |
| `turned_leads`  | the lift turned ahead on each lead by a window of its own, for cars whose rod rubs    |
| `trial_run`     | errors of a run, and the trim of the steering that brings its end nearest             |
| `lead_search`   | the windows of the leads, for one car or for all of a band                            |
| `band`          | the play to cut it for within a band, and the bound that no profile can better        |
| `play_task`     | the lift and run wanted, and on a train the best window for a lift                    |
| `evaluate`      | profiles evaluated as they are cut, rolled and run with play; the best under limits   |
| `laps`          | drift on a closed path, per lap and after the last one                                |
| `remedies`      | error that is left with a brake, a trim or a bearing, where the rod rubs              |
"""
