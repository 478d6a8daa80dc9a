"""From the values of a design file to what the numeric rooms work on; here degrees become radians and µm mm.

| module         | what it holds                                                       |
|----------------|---------------------------------------------------------------------|
| `cam_model`    | path, track, lift, follower, blank and car of a design              |
| `course_model` | the course and the car's outline                                    |
| `draw_model`   | what can be set on the car when a spacing is drawn                  |
| `gear_model`   | gear train, blanks, joints and limits of the search of a design     |
| `variation`    | what cars of a design differ by: return error, friction, tolerances |
"""
