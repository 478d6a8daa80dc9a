"""The kinds of follower: a new one is a file here and a line in the table, or is registered from outside.

| module     | what it holds                                                                       |
|------------|-------------------------------------------------------------------------------------|
| `kind`     | what a kind is: its code, its keys of the design file, and how it is built           |
| `rod`      | the leaning rod: envelope, rolling, checks, published profiles, first order          |
| `rod_kind` | its keys of the design file                                                          |
| `table`    | all kinds by their codes                                                             |
"""
