"""Parts as closed meshes of triangles, and checks for overlap of bodies and teeth.

| module       | what it does                                                                    |
|--------------|---------------------------------------------------------------------------------|
| `mesh`       | a mesh; that of a cam's disc, and that of a body of prisms such as a gear's      |
| `car_meshes` | parts of a car as meshes                                                         |
| `content`    | a mesh measured: closed or not, its bodies, volume, and the rim of a disc        |
| `printing`   | what a printer does to a mesh, taken back; and the part from the mesh for it     |
| `teeth`      | play and clearances of two gears, measured on their sections, without formulas   |
| `made_train` | play -> thinned teeth, layout, inspection and measured mesh; the train's checks  |

Only this room imports manifold3d. It uses neither the CAD kernel nor files.
"""
