"""Writing of files that a user names: whole or not at all."""

import os
import secrets
import shutil
from contextlib import suppress
from pathlib import Path


def write_whole(file: Path, content: bytes, *, new: bool = False) -> None:
    """Write a file so that it has, whatever happens, either its old content or the new one.

    The content goes onto the disk under another name first. Folders that are missing on the way are made, and removed
    again if the file cannot be written.

    Args:
        file: path of the file.
        content: its bytes.
        new: whether the file must not be there yet.

    Raises:
        FileExistsError: it must not be there, but is.
        OSError: it cannot be written.
    """
    made = [folder for folder in file.parents if not folder.exists()]
    # A name that nobody can foresee, and a file that was not there: a link put in its place is not written through.
    staging = file.with_name(f".{secrets.token_hex(8)}.saving")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        if new and os.path.lexists(file):
            raise FileExistsError(file)
        with open(staging, "xb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        if new:
            open(file, "x").close()  # this takes the name, so that nobody's file is written over
        with suppress(OSError):
            shutil.copymode(file, staging)
        try:
            os.replace(staging, file)
        except OSError:
            if new:
                file.unlink()
            raise
    except BaseException:
        with suppress(OSError):
            staging.unlink()
        for folder in made:
            with suppress(OSError):
                folder.rmdir()
        raise
