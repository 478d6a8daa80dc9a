"""Features of a part besides its outline or teeth: one definition of each, for disc and gear alike.

| module     | what it holds                                                                        |
|------------|--------------------------------------------------------------------------------------|
| `face`     | the faces of a part                                                                   |
| `features` | keyway, D-flat, set screw, hub, web, lightening holes, as a drawing dimensions them    |
| `run`      | how a section goes along the axis: straight, along a helix, or along one and back    |
| `loop`     | closed loops of exact lines, arcs, involutes and trochoids; chords, Bézier curves    |
| `body`     | a body as a stack of prisms between such loops, and the walls and caps that bound it |
| `print_compensation` | what a printer does to a part, taken back in its files                     |
| `blank`    | all features of one part; a disc's contours, its hub, and the walls left between them |

Lengths are mm, angles rad. Polar angles of features are those of the outline, or from the tooth on the x axis.
"""
