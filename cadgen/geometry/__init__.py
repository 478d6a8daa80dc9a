"""Parts as meshes and as solids, each made and measured.

| room     | what it holds                                                              |
|----------|----------------------------------------------------------------------------|
| `meshes` | parts as closed meshes; the checks of a train put together                 |
| `solids` | the only room that imports the CAD kernel                                  |
"""
