"""Files that a user names: only plain ones, and only as large as such a file can be."""

import os
import stat
from pathlib import Path

_KINDS = {
    stat.S_IFIFO: "a pipe",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFSOCK: "a socket",
}


def read_given(file: Path, most: int) -> bytes:
    """Bytes of a file, refused at once if it could keep the reader waiting, or is too large.

    Args:
        file: a path; links are followed.
        most: number of bytes that the file may have.

    Raises:
        OSError: as the system says; `IsADirectoryError` for a folder.
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
