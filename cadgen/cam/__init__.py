"""The cam: from the steering wanted to a profile that a rod can follow, and the proof that it does.

| module        | what it does                                                                   |
|---------------|--------------------------------------------------------------------------------|
| `follower`    | the leaning rod and the disc's two faces                                       |
| `lift`        | tan(beta) by cam angle, closed by a blend; lift, peaks and valleys              |
| `theoretical` | the rod axis's curve, and the formula of the paper's appendix                   |
| `envelope`    | the actual profile: exact envelope of the rod over both faces, trimmed          |
| `contact`     | a rod rolled on any outline: the lift it gives (shares no code with `envelope`) |
| `limits`      | what the checks allow; textbook limits of the pressure angle, by name           |
| `cutter`      | which cutter reaches every concave part                                         |
| `checks`      | every figure with its limit, place and verdict                                  |
| `clearance`   | of these the ones on room: rim, chamfers, hub, walls, concave parts              |
| `place`       | where on a cam something is, in words                                           |
| `lowest`      | which branch of the envelope is the lowest, with rounding kept out              |
| `loss`        | lift that is missing where the envelope is trimmed                              |
| `difference`  | how far two outlines lift the rod apart                                         |
| `cure`        | the smallest single change that brings lost lift within its limit               |
"""
