"""The cam: from the steering wanted to a profile that a rod can follow, and the proof that it does.

| module        | what it does                                                                   |
|---------------|--------------------------------------------------------------------------------|
| `follower`    | the leaning rod and the disc's two faces                                       |
| `lift`        | tan(beta) by cam angle, closed by a blend; lift, peaks and valleys              |
| `theoretical` | the rod axis's curve, and the formula of the paper's appendix                   |
| `envelope`    | the actual profile: exact envelope of the rod over both faces, trimmed          |
| `contact`     | a rod rolled on any outline: the lift it gives (shares no code with `envelope`) |
| `cutter`      | which cutter reaches every concave part                                         |
| `checks`      | every figure with its limit, verdict and cure                                   |
"""
