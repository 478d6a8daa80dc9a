"""The report page, and the editor that serves it.

| room     | what it holds                                                                |
|----------|------------------------------------------------------------------------------|
| `page`   | the report page: one HTML file with model, curves and tables                 |
| `editor` | that page served to the user's browser, where the design can be changed      |
"""
