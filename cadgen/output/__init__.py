"""Results as files, drawings, pictures and text.

| room      | what it holds                                                               |
|-----------|-----------------------------------------------------------------------------|
| `files`   | one file per format, each with its read-back; manifest; publishing          |
| `drawing` | drawings for a workshop: sheets as data, as DXF and as PDF                  |
| `report`  | pictures as PNG and SVG; tables on a terminal                               |
"""
