"""Parts as closed meshes of triangles, and checks for overlap of bodies and teeth.

| module         | what it does                                                                    |
|----------------|---------------------------------------------------------------------------------|
| `mesh`         | a mesh, its solid of manifold3d, and a radial hole drilled through it           |
| `disc`         | the disc of a cam -> mesh                                                       |
| `prisms`       | a body of prisms, such as a gear's -> mesh                                      |
| `content`      | a mesh measured: closed or not, its bodies, volume, and the rim of a disc       |
| `teeth`        | play and clearances of two gears, measured on their sections, without formulas  |
| `train_checks` | the checks of a gear train: teeth in mesh, and parts at rest                    |
| `train_made`   | play -> thinned teeth, layout, inspection and measured mesh                      |

Only this room imports manifold3d. It uses neither the CAD kernel nor files.
"""
