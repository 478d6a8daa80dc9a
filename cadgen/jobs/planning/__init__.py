"""From a course and a car to a planned path that the checks have passed, and its design file.

| module  | what it does                                                              |
|---------|---------------------------------------------------------------------------|
| `task`  | design -> what the planner is asked                                       |
| `plan`  | plan, the exact chain with all checks, and again with what they ask for    |
| `cars`  | cars within the tolerances on planned paths, and the path most of them keep |
| `path_planning` | the result, or why there is none: sentences, values, the design file |
"""
