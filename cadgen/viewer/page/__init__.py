"""The report page: one HTML file that works offline.

| module          | what it holds                                                     |
|-----------------|-------------------------------------------------------------------|
| `page_plan`     | cam and gears, each computed once, and what stands on their page  |
| `car_page`      | a car's page: runs, random cars and calibration besides           |
| `train_page`    | the page of a train alone: what stands on it                      |
| `document`      | content of a page: sheets, curves, meshes, motion                 |
| `charts`        | curves over the cam angle                                         |
| `scene`         | everything that moves: runs, course, parts and shafts in 3D       |
| `sections`      | sheets of checks, play, tolerance, inspection, parts, calibration |
| `mesh_block`    | normals and edges of meshes; arrays as one compressed block       |
| `data`          | the data of the page's script: JSON with a version, and the block |
| `plan_views`    | cam and course from the side and from above                       |
| `rim`           | deviations on the rim of the disc                                 |
| `html`          | the page around its pieces, and its policy                        |
| `report`        | the page of a plan, and the page as a file                        |

`templates` holds the page as HTML, `static` script and style as `page/build.mjs` bundles them, with the licences of the
libraries in them. Nothing here computes a figure of the car; the script only reads between the entries of the arrays.
"""
