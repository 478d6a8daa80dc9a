"""Errors that a user can meet, each with its exit code on the command line.

Every message is one sentence that says what is wrong, where, and what to change.
"""

from cadgen.messages import Message


class CadgenError(Exception):
    """Base of every error that is meant for the user.

    Args:
        text: sentence, or its template with fields such as `{angle:.2f}`.
        arguments: values of the fields.
    """

    exit_code = 3

    def __init__(self, text: str, /, **arguments: object) -> None:
        super().__init__(Message(text, **arguments))

    @property
    def message(self) -> Message:
        """Sentence, which can be translated."""
        return Message(self.args[0])


class CheckError(CadgenError):
    """A design that was understood but fails one of its checks (exit code 1)."""

    exit_code = 1


class DesignError(CadgenError):
    """A design, or a command, that cannot be understood or built (exit code 2)."""

    exit_code = 2


class FileError(CadgenError):
    """A file that cannot be read, written or trusted, or a kernel that failed (exit code 3)."""

    exit_code = 3


MOST_REPEATED = 200  # characters of a user's text, in a message


def brief(text: str, most: int = MOST_REPEATED) -> str:
    """A user's text as a message may repeat it: on one line, control characters escaped, its middle left out."""
    if len(text) > 2 * most:  # escapes only make it longer
        text = f"{text[:most]}{text[-most:]}"
    line = escaped(text)
    if len(line) <= most:
        return line
    tail = most // 4
    return f"{line[: most - 3 - tail]}...{line[-tail:]}"


def escaped(text: str) -> str:
    """The text with every character that cannot be printed, such as a terminal's control codes, as a Python escape."""
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape").decode() for sign in text)
