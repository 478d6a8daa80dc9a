"""Files appear in the output folder all together and complete, or not at all."""

import errno
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from cadgen.errors import FileError

_LAST = "manifest.json"  # it vouches for the other files, so it is moved after them


@contextmanager
def publishing(out: Path) -> Iterator[Path]:
    """Yield a staging folder inside `out`; when the block ends well, move its files to `out`.

    Files already there under the same names are replaced. If the block, or the moving, fails or is interrupted,
    `out` is left as it was.

    Raises:
        FileError: the folder cannot be made or written to, or the disk is full.
    """
    made = not out.exists()
    try:
        out.mkdir(parents=True, exist_ok=True)
        staging = Path(tempfile.mkdtemp(prefix=".cadgen-", dir=out))
    except OSError as error:
        raise FileError(_why(error, out)) from error
    published = False
    try:
        yield staging
        _move(staging, out)
        published = True
    except OSError as error:
        raise FileError(_why(error, out)) from error
    finally:
        shutil.rmtree(staging, ignore_errors=True)
        if made and not published and not any(out.iterdir()):
            out.rmdir()


def _move(staging: Path, out: Path) -> None:
    """Rename every staged file into place; on any failure put back what was there."""
    files = sorted((f for f in staging.iterdir() if f.is_file()), key=lambda f: (f.name == _LAST, f.name))
    backup = staging / "replaced"
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
