"""Locks between runs: files that the operating system locks for a process, and frees when it ends, however it ends.

They are advisory: they keep runs of this program apart, on one machine and, where the file system passes locks on (as
NFS does), on several. Links are never followed, and nothing is ever written into a lock's file.
"""

import errno
import logging
import os
import stat
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from cadgen.errors import FileError
from cadgen.messages import Message

NAME = ".cadgen-lock"
_POLL_S = 0.02  # between two looks at a lock that another run holds
PATIENCE_S = 60.0  # files are moved in milliseconds; whoever takes longer has been stopped
_UNSUPPORTED = {errno.ENOLCK, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP, errno.EINVAL}
_OPEN = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
_log = logging.getLogger(__name__)

# A signal's handler has no other way to learn of it.
_taken: Path | None = None


@contextmanager
def locked(folder: Path, patience_s: float = PATIENCE_S) -> Iterator[bool]:
    """Hold a folder's lock; its file is there only as long as a run holds the lock or waits for it.

    Yields False, after a warning, where the file system has no locks.

    Args:
        folder: folder to hold.
        patience_s: longest wait, s.

    Raises:
        FileError: another run kept the lock for longer than `patience_s`, or something else has the lock's name.
        OSError: the folder cannot be written to.
    """
    global _taken
    descriptor = _acquire(folder / NAME, time.monotonic() + patience_s)
    _taken = folder / NAME
    try:
        yield descriptor is not None
    finally:
        _taken = None
        _release(folder / NAME, descriptor)


def drop() -> None:
    """Remove the file of the lock that this process holds: it is about to end."""
    if _taken is not None:
        with suppress(OSError):
            _taken.unlink()


def hold(file: Path) -> int | None:
    """Make a file and lock it for as long as the returned descriptor is open; None if the file system has no locks."""
    descriptor = os.open(file, _OPEN | os.O_EXCL, 0o666)
    try:
        _lock(descriptor)
    except OSError as error:
        os.close(descriptor)
        if error.errno not in _UNSUPPORTED:
            raise
        return None
    return descriptor


def lock_now(descriptor: int) -> bool:
    """Lock an open file for as long as it is open; False if another process has it, True where there are no locks."""
    try:
        return _lock(descriptor)
    except OSError as error:
        if error.errno not in _UNSUPPORTED:
            raise
        return True


def unlock(descriptor: int) -> None:
    """Free the lock of an open file."""
    from filelock import unlock_descriptor

    unlock_descriptor(descriptor)


def is_held(file: Path) -> bool:
    """Whether a process holds the lock of a file; False if there is no such file."""
    try:
        descriptor = os.open(file, _OPEN & ~os.O_CREAT)
    except FileNotFoundError:
        return False
    try:
        return not _lock(descriptor)
    finally:
        os.close(descriptor)


def _acquire(file: Path, deadline: float) -> int | None:
    while True:
        descriptor = _opened(file)
        try:
            if not _lock(descriptor):
                _wait(descriptor, file, deadline)
            # The run before may have removed the file that was waited for, and the next one made another.
            with suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(descriptor), os.stat(file, follow_symlinks=False)):
                    return descriptor
        except OSError as error:
            if error.errno in _UNSUPPORTED:
                os.close(descriptor)
                with suppress(OSError):
                    file.unlink()
                _log.warning(
                    Message(
                        "{folder} cannot be locked ({reason}): let no other run write into it at the same time",
                        folder=file.parent,
                        reason=Message(str(error.strerror)),
                    )
                )
                return None
            os.close(descriptor)
            raise
        except BaseException:
            os.close(descriptor)
            raise
        os.close(descriptor)


def _opened(file: Path) -> int:
    try:
        descriptor = _made_or_found(file)
        if stat.S_ISREG(os.fstat(descriptor).st_mode):
            return descriptor
        os.close(descriptor)
    except OSError as error:
        if error.errno not in (errno.ELOOP, errno.EISDIR, errno.ENXIO):
            raise
    raise FileError("{file} is a link or no file, but the folder's lock must go there: remove it", file=file)


def _made_or_found(file: Path) -> int:
    """Descriptor of a file that was made here, with rights for all, or that was there, as it is."""
    while True:
        with suppress(FileExistsError):
            descriptor = os.open(file, _OPEN | os.O_EXCL, 0o666)
            if hasattr(os, "fchmod"):
                with suppress(OSError):  # who may write into the folder may wait for its lock
                    os.fchmod(descriptor, 0o666)
            return descriptor
        with suppress(FileNotFoundError):  # the run that made it has removed it meanwhile
            return os.open(file, _OPEN & ~os.O_CREAT)


def _release(file: Path, descriptor: int | None) -> None:
    if descriptor is None:
        return
    if sys.platform == "win32":  # there an open file cannot be removed
        os.close(descriptor)
    with suppress(OSError):
        file.unlink()
    if sys.platform != "win32":
        os.close(descriptor)


def _wait(descriptor: int, file: Path, deadline: float) -> None:
    """Wait for a lock that another process holds."""
    left = max(deadline - time.monotonic(), 0.0)
    _log.warning(
        Message(
            "another run is moving its files into {folder}: waiting for it, at most {left:.0f} s",
            folder=file.parent,
            left=left,
        )
    )
    while not _lock(descriptor):
        if time.monotonic() > deadline:
            raise FileError(
                "another run still holds {file} after the wait, so nothing was written: end that run, or choose "
                "another folder",
                file=file,
            )
        time.sleep(_POLL_S)


def _lock(descriptor: int) -> bool:
    """Lock an open file; False if another process has it locked."""
    from filelock import lock_descriptor  # only what writes files needs it

    return lock_descriptor(descriptor, blocking=False)
