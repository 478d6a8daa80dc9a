"""The editor: the report page of a design, served to the user's own browser, where the design can be changed.

| module         | what it does                                                              |
|----------------|---------------------------------------------------------------------------|
| `course_items` | points on the floor that can be moved; items that can be added and removed |
| `timing`       | timing diagram of a motion: segments, and the handles that move them      |
| `controls`     | numbers of a design that can be changed, each with its range              |
| `text_changes` | a change of a design file's text, comments kept                           |
| `saving`       | the file: read once, written in one step, never over another's changes    |
| `session`      | one design being edited: changes, undo and redo, saving                   |
| `job`          | a version to compute, and the answer                                      |
| `compute`      | from a design's text to what the page shows                               |
| `worker`       | a process that computes; the newest request wins                          |
| `guard`        | refusal of requests that do not come from the page                        |
| `server`       | the page, its state and its results over HTTP, until Ctrl-C               |

The page's second script has its sources in `page/src/edit`. `guard` and `server` alone import the libraries of the
extra `edit`.
"""
