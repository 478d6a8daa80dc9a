"""Reading of files that a user names: regular files only, and none larger than a limit."""

import os
import stat
from pathlib import Path

_KINDS = {
    stat.S_IFIFO: "a pipe",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFSOCK: "a socket",
}


def read_regular(file: Path, most: int) -> bytes:
    """Bytes of a regular file. A pipe or device, which could keep the reader waiting, is refused at once.

    Args:
        file: path of the file; links are followed.
        most: greatest size of the file, bytes.

    Raises:
        OSError: the file cannot be opened; `IsADirectoryError` for a folder.
        ValueError: it is no regular file, is larger than `most`, or no file can have that name.
    """
    _refuse_kind(file.stat().st_mode, file)
    # Something else may have taken its place; opening a pipe must not wait for a writer.
    with open(file, "rb", opener=lambda name, flags: os.open(name, flags | getattr(os, "O_NONBLOCK", 0))) as stream:
        _refuse_kind(os.fstat(stream.fileno()).st_mode, file)
        content = stream.read(most + 1)
    if len(content) > most:
        raise ValueError(f"it is larger than {most / 1e6:g} MB")
    return content


def _refuse_kind(mode: int, file: Path) -> None:
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(f"{file} is a folder")
    if not stat.S_ISREG(mode):
        raise ValueError(f"it is {_KINDS.get(stat.S_IFMT(mode), 'something else')} and no regular file")
