"""Reading of files that a user names: regular files only, and none larger than a limit."""

import os
import stat
from pathlib import Path
from typing import BinaryIO

from cadgen.messages import Message

_KINDS = {
    stat.S_IFIFO: Message("a pipe"),
    stat.S_IFCHR: Message("a device"),
    stat.S_IFBLK: Message("a device"),
    stat.S_IFSOCK: Message("a socket"),
}


class TooLargeError(ValueError):
    """File that is larger than what is read of it."""


def read_regular(file: Path, most: int) -> bytes:
    """Bytes of a regular file. A pipe or device, which could keep the reader waiting, is refused at once.

    Args:
        file: path of the file; links are followed.
        most: greatest size of the file, bytes.

    Raises:
        OSError: the file cannot be opened; `IsADirectoryError` for a folder.
        TooLargeError: it is larger than `most`.
        ValueError: it is no regular file, or no file can have that name.
    """
    with open_regular(file) as stream:
        content = stream.read(most + 1)
    if len(content) > most:
        raise TooLargeError(Message("it is larger than {most:g} MB", most=most / 1e6))
    return content


def open_regular(file: Path) -> BinaryIO:
    """Open a regular file for reading; errors as `read_regular`, but for the size."""
    _refuse_kind(file.stat().st_mode, file)
    # Something else may have taken its place; opening a pipe must not wait for a writer.
    at_once = getattr(os, "O_NONBLOCK", 0)
    stream = open(file, "rb", opener=lambda name, flags: os.open(name, flags | at_once))  # noqa: SIM115 (the caller closes it)
    try:
        _refuse_kind(os.fstat(stream.fileno()).st_mode, file)
    except BaseException:
        stream.close()
        raise
    return stream


def _refuse_kind(mode: int, file: Path) -> None:
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(f"{file} is a folder")
    if not stat.S_ISREG(mode):
        kind = _KINDS.get(stat.S_IFMT(mode), Message("something else"))
        raise ValueError(Message("it is {kind} and no regular file", kind=kind))
