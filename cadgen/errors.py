"""The errors a user can meet, each with the exit code of the command line.

Every message is one sentence that says what is wrong, where, and what to change.
"""


class CadgenError(Exception):
    """Base of every error that is meant for the user."""

    exit_code = 3


class CheckError(CadgenError):
    """A design that was understood but fails one of its checks (exit code 1)."""

    exit_code = 1


class DesignError(CadgenError):
    """A design, or a command, that cannot be understood or built (exit code 2)."""

    exit_code = 2


class FileError(CadgenError):
    """A file that cannot be read, written or trusted, or a kernel that failed (exit code 3)."""

    exit_code = 3
