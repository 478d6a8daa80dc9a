"""Files appear in the output folder all together and complete, or not at all."""

import errno
import os
import platform
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from cadgen.errors import FileError

_LAST = "manifest.json"  # it vouches for the other files, so it is moved after them
_PREFIX = ".cadgen-"
_REPLACED = "replaced"


@dataclass
class _Run:
    """What a run has made so far, for whoever must clear it away.

    Attributes:
        staging: the folder that its files are written to.
        made: folders on the way to `out` that were not there, the innermost first.
        settled: True once files are being moved into place: from then on the run must be let to finish.
    """

    staging: Path
    made: tuple[Path, ...]
    settled: bool = False

    def clear(self) -> None:
        """Remove everything but what others have put there."""
        shutil.rmtree(self.staging, ignore_errors=True)
        for folder in self.made:
            with suppress(OSError):
                folder.rmdir()


# A signal's handler has no other way to learn of it.
_run: _Run | None = None


def abandon() -> bool:
    """Clear away what an unfinished run has written; False if its files are already in place, or on their way."""
    if _run is None:
        return True
    if _run.settled:
        return False
    _run.clear()
    return True


@contextmanager
def publishing(out: Path) -> Iterator[Path]:
    """Yield a staging folder inside `out`; when the block ends well, move its files to `out`.

    Files already there under the same names are replaced. If the block, or the moving, fails or is abandoned,
    `out` is left as it was. What a killed run has left in `out` is cleared away.

    Raises:
        FileError: the folder cannot be made or written to, or the disk is full.
    """
    global _run
    try:
        made = tuple(folder for folder in (out, *out.parents) if not folder.exists())
        # Known before anything is made, so that no moment is left in which it could not be cleared away.
        _run = _Run(out / f"{_PREFIX}{os.getpid()}-{platform.node()}", made)
        out.mkdir(parents=True, exist_ok=True)
        _sweep(out)
        _run.staging.mkdir()
        yield _run.staging
        _run.settled = True
        _move(_run.staging, out)
    except BaseException as error:
        run, _run = _run, None
        if run:
            run.clear()
        if isinstance(error, OSError):
            raise FileError(_why(error, out)) from error
        raise
    # The record stays: the files are in place.
    shutil.rmtree(_run.staging, ignore_errors=True)


def _sweep(out: Path) -> None:
    """Remove the staging folders of runs on this machine that were killed."""
    for folder in out.glob(f"{_PREFIX}*-{platform.node()}"):
        number = folder.name.removeprefix(_PREFIX).partition("-")[0]
        if not folder.is_dir() or not number.isdecimal() or _lives(int(number)):
            continue
        # If it was killed amid moving its files, those that they replaced are put back.
        if any(file.is_file() for file in folder.iterdir()):
            for file in folder.glob(f"{_REPLACED}/*"):
                os.replace(file, out / file.name)
        shutil.rmtree(folder, ignore_errors=True)


def _lives(process: int) -> bool:
    """Whether another process with this number runs."""
    if process == os.getpid():
        return False
    if os.name != "posix":  # there signal 0 would end it
        return True
    try:
        os.kill(process, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:  # it belongs to somebody else
        pass
    return True


def _move(staging: Path, out: Path) -> None:
    """Rename every staged file into place; on any failure put back what was there."""
    files = sorted((f for f in staging.iterdir() if f.is_file()), key=lambda f: (f.name == _LAST, f.name))
    backup = staging / _REPLACED
    backup.mkdir()
    done: list[Path] = []
    try:
        for file in files:
            target = out / file.name
            if target.is_dir():
                raise FileError(f"{target} is a folder where a file must go: remove it or choose another --out")
            if target.exists():
                os.replace(target, backup / file.name)
            done.append(target)
            os.replace(file, target)
    except BaseException:
        for target in done:
            target.unlink(missing_ok=True)
            if (backup / target.name).exists():
                os.replace(backup / target.name, target)
        raise


def _why(error: OSError, out: Path) -> str:
    reasons = {
        errno.ENOSPC: "the disk is full: free some space or choose another --out",
        errno.EDQUOT: "your disk quota is used up: free some space or choose another --out",
        errno.EFBIG: "a file would be larger than this system allows: choose another --out",
        errno.EACCES: "there is no permission to write there: choose another --out",
        errno.EPERM: "there is no permission to write there: choose another --out",
        errno.EROFS: "that disk is read-only: choose another --out",
        errno.EEXIST: "a file stands where the folder must go: choose another --out",
        errno.ENOTDIR: "a file stands where a folder must go: choose another --out",
        errno.ENAMETOOLONG: "the path is too long: choose a shorter --out",
    }
    reason = reasons.get(error.errno or 0, f"{error.strerror or error}: choose another --out")
    return f"nothing was written to {out}: {reason}"
