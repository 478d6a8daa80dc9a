"""`python -m cadgen` is the command `cadgen`."""

from cadgen.cli import main

if __name__ == "__main__":
    main()
