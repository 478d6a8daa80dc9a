"""The report page: one HTML file that works offline.

| module        | what it does                                                      |
|---------------|-------------------------------------------------------------------|
| `content`     | what is on it, from the plans of a design                         |
| `names`       | kinds of cells, figures, marks and parts                          |
| `document`    | content of a page: tables, curves, meshes, motion                 |
| `words`       | the page's texts in English and Chinese                           |
| `check_words` | names and places of checks in Chinese                             |
| `sentences`   | sentences that the program makes, in Chinese                      |
| `shading`     | normals and edges of a mesh                                       |
| `binary`      | arrays as one compressed block                                    |
| `data`        | the data of the page's script: JSON with a version, and the block |
| `markup`      | HTML elements, tables and sections                                |
| `views`       | plan views as SVG                                                 |
| `html`        | the file                                                          |

`static` holds script and style as `page/build.mjs` bundles them, with the licences of the libraries in them. Nothing
here computes a figure of the car; the script only reads between the entries of the arrays.
"""
