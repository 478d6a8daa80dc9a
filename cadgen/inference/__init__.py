"""From measured data to what they show of the car, and what that promises.

| room          | what it holds                                                           |
|---------------|-------------------------------------------------------------------------|
| `measurement` | measured data -> the effects that explain them; one object a kind       |
| `gearing`     | measured gears and trains -> what differs from their design             |
| `motions`     | a worn cam, measured -> the motion that was meant                       |
| `expectation` | what a new cam, a measurement not made and a run not used will show     |
| `monte_carlo` | many cars within the tolerances                                         |
| `adjustment`  | trial runs -> settings of micrometer, key and start                     |
| `workshop`    | mean and spread of deviations over the cars of a workshop               |
| `records`     | measured data from files, each of the kind that its columns say         |
"""
