"""Forward models of kinds whose file holds the kind alone.

| module     | what is measured                                |
|------------|-------------------------------------------------|
| `tricycle` | where a car with a logged front wheel goes      |
"""
