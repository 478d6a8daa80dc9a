"""The start of a design: a commented file that loads.

| module     | what it holds                                             |
|------------|-----------------------------------------------------------|
| `template` | text of the file                                          |
| `begin`    | points of a path, changes of keys -> the file             |
"""
