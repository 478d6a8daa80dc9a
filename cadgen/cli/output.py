"""Standard output, given up quietly when its reader has gone, and sentences on standard error."""

import logging
import os
import sys
from collections.abc import Sequence
from contextlib import suppress

import click

from cadgen.errors import MOST_REPEATED, brief, escaped
from cadgen.messages import Message, shown

_LONGEST_LINE = 1000  # of a message; our own are shorter


def hush() -> None:
    """Discard everything printed from now on, and all that is not yet flushed."""
    with suppress(OSError, ValueError):  # it is no file
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def tell(message: str) -> None:
    """Print one sentence on standard error."""
    with suppress(OSError):  # nobody listens
        click.echo(f"cadgen: {message}", err=True)


def sentence(message: str, arguments: Sequence[str]) -> str:
    """Shorten a message: at most one line of any argument is repeated, without control characters.

    Args:
        message: text of one or more lines.
        arguments: arguments of the command.
    """
    pieces = {piece for argument in arguments for piece in (argument, argument.partition("=")[2])}
    for piece in sorted(pieces, key=len, reverse=True):
        if len(piece) > MOST_REPEATED:
            for written in (piece, repr(piece)[1:-1]):
                message = message.replace(written, brief(piece))
    return "\n".join(brief(line, _LONGEST_LINE) for line in message.split("\n"))


class _Warnings(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        tell(escaped(shown(record.msg) if isinstance(record.msg, Message) else record.getMessage()))


def tell_warnings() -> None:
    """Print the program's warnings while it works, such as that it waits for another run."""
    logger = logging.getLogger("cadgen")
    if not logger.handlers:
        logger.addHandler(_Warnings(logging.WARNING))
        logger.propagate = False
