"""Settings of a car with a single cam for each spacing of a course that is drawn on site.

A path scaled by a factor needs its steering divided by that and its distance multiplied. The disc moved along its shaft
changes the lever, and with it the steering; the drive wheel or the ratio changes the distance. Both together are exact
but for the offset of the drive wheel, the thickness of the disc and the lean of the rod; head and start take most of
what is left.

| module           | what it does                                                           |
|------------------|------------------------------------------------------------------------|
| `setting_ranges` | what can be set, within which range and to which division              |
| `target`         | how far the car leaves the scaled path with some setting               |
| `best_settings`  | the least greatest error to first order, then to the divisions         |
| `drawn_spacing`  | a spacing with its setting, its errors and its checks                  |
"""
