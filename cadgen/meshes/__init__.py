"""Parts as closed meshes of triangles, and what only they show: whether bodies or teeth overlap.

| module         | what it does                                                                    |
|----------------|---------------------------------------------------------------------------------|
| `mesh`         | a mesh, the same as a solid of manifold3d, and a radial hole drilled through it |
| `disc`         | the disc of a cam -> mesh                                                       |
| `prisms`       | a body of prisms, such as a gear's -> mesh                                      |
| `content`      | what a mesh is, measured: closed, bodies, volume, the rim of a disc             |
| `teeth`        | play and clearances of two gears, measured on their sections, without formulas  |
| `train_checks` | the checks of a gear train: teeth in mesh, and parts at rest                    |

Only this room imports manifold3d. It knows neither the CAD kernel nor files.
"""
