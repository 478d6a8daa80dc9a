"""Folders for files, refusals of an export, and the comparison of a folder with its manifest."""

import errno
from collections.abc import Callable, Sequence
from dataclasses import replace
from os import PathLike
from pathlib import Path

from cadgen.check import Bound, Check
from cadgen.errors import DesignError, FileError, brief
from cadgen.output.files.folder import FolderState as FolderState
from cadgen.output.files.folder import folder_state, undo_killed
from cadgen.output.files.lock import locked
from cadgen.output.files.publisher import Written as Written


def folder_of(folder: str | PathLike[str]) -> Path:
    """Path of the folder for files.

    Args:
        folder: path as the caller has it.

    Raises:
        DesignError: it is no path, is empty, or is not possible on any system.
    """
    try:
        text = str(Path(folder)) if str(folder) else ""
    except TypeError:
        text = ""
    if not text or "\0" in text:
        raise DesignError(f"folder is {brief(repr(folder), 80)}; it must be a path, such as exports")
    return Path(folder)


def written(folder: str | PathLike[str], write: Callable[[Path], Written]) -> Written:
    """Files of a job that writes into a folder.

    Args:
        folder: folder as the caller has it.
        write: function that writes into the folder's path.

    Raises:
        DesignError: the folder is no path.
    """
    return write(folder_of(folder))


def refusal(checks: Sequence[Check], *, forced: bool = True) -> str:
    """Message on a failed export: each check that fails, with its limit and what to change.

    Args:
        checks: checks, of which those that fail are named.
        forced: whether the caller can write all the same, by `force`.
    """
    parts = []
    for check in checks:
        if not check.passed:
            bound = "at most" if check.bound == Bound.MAX else "at least"
            figures = f"{check.name} is {check.value:.4g} {check.unit}".rstrip()
            limit = f"{figures}; it must be {bound} {check.limit:.4g} {check.unit}".rstrip()
            parts.append(f"{limit}: {check.advice}" if check.advice else limit)
    anyway = "; force=True writes all the same" if forced else ""
    return f"a check failed, so nothing was written ({'; '.join(parts)}){anyway}"


def verify(folder: str | PathLike[str], *, restore: bool = False) -> FolderState:
    """Compare the files of a folder with its manifest.

    Args:
        folder: folder that a job has written to.
        restore: whether half-done moves of killed runs are undone first.

    Returns:
        State of every file; `is_true` if all that the manifest lists are as listed, and `restored`, the names of the
        files put back.

    Raises:
        FileError: the folder or its manifest cannot be read.

    Example:
        >>> from cadgen import verify
        >>> verify("exports").is_true  # doctest: +SKIP
        True
    """
    place = folder_of(folder)
    if not place.is_dir():
        raise FileError(f"there is no folder {brief(str(place))}: name one that cadgen has written to")
    restored: list[str] = []
    try:
        with locked(place):
            if restore:
                restored = undo_killed(place, sure=True)
            state = folder_state(place)
    except OSError as error:
        if restore or error.errno not in (errno.EACCES, errno.EPERM, errno.EROFS):
            raise FileError(f"{brief(str(place))} cannot be written to ({error.strerror}): make it writable") from None
        state = folder_state(place)  # this user cannot lock it
    return replace(state, restored=tuple(restored))
