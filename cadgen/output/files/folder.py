"""Output folder: files appear in it all together and complete, or not at all, and are compared with its manifest.

A run writes into a staging folder of its own inside the output folder. When all is written and read back it takes the
folder's lock and moves its files into place, in an order in which the folder's manifest is true after every step:

1. a record of what is to be moved, with a copy of the manifest as it was, appears in the staging folder;
2. the manifest without the files that are about to be replaced takes the manifest's place;
3. file by file, what was there is moved into the staging folder, and the new one into its place;
4. the new manifest takes the manifest's place. From here on the run is done.

A run that fails or is killed between 1 and 4 is undone: by itself, or by the next run into that folder. Undoing goes
the same way back, and may be killed and begun again at any point too.
"""

import errno
import json
import os
import re
import secrets
import shutil
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from cadgen.errors import FileError, brief
from cadgen.figures import Facts, frame_of, html_table
from cadgen.messages import Message
from cadgen.output.files.lock import NAME as LOCK
from cadgen.output.files.lock import drop, hold, is_held, locked
from cadgen.output.files.manifest import (
    MOST_BYTES,
    file_hash,
    is_file,
    is_plain_name,
    manifest_text,
    older_files,
    read_parts,
    sound_parts,
    unchanged,
)
from cadgen.output.files.manifest import NAME as MANIFEST
from cadgen.reading import read_regular

if TYPE_CHECKING:
    from pandas import DataFrame

_PREFIX = ".cadgen-"
_STAGING = re.compile(rf"{re.escape(_PREFIX)}[0-9a-f]{{16}}")
# Names of files begin with a letter or digit, so these can meet none.
_ALIVE = ".alive"  # locked as long as the run lives
_PREPARED = ".prepared"
_REPLACED = ".replaced"
_RECORD = ".record.json"
_KEPT = ".kept.json"
_MOST_TRIES = 10


@dataclass
class _Run:
    """Folders that a run has made so far, to be cleared away if it fails.

    Attributes:
        staging: folder that its files are written to.
        created: folders on the way to `out` that were not there, the innermost first.
        alive: descriptor of the staging folder's lock.
        settled: True once files are being moved into place: from then on the run must be let to finish.
    """

    staging: Path
    created: tuple[Path, ...]
    alive: int | None = None
    settled: bool = False

    def clear(self) -> None:
        """Remove everything but what others have put there, and what is needed to undo a half-done move."""
        if self.alive is not None:
            os.close(self.alive)
            self.alive = None
        if not _is_half_moved(self.staging):
            shutil.rmtree(self.staging, ignore_errors=True)
        for folder in self.created:
            with suppress(OSError):
                folder.rmdir()


# A signal's handler has no other way to learn of it.
_run: _Run | None = None


def abandon() -> bool:
    """Clear away what an unfinished run has written; False if its files are already in place, or on their way."""
    if _run is not None and _run.settled:
        return False
    drop()
    if _run is not None:
        _run.clear()
    return True


@contextmanager
def publishing(out: Path) -> Iterator[Path]:
    """Yield a staging folder inside `out`; when the block ends well, move its files to `out`.

    The block writes the files and, by `write_manifest`, the entry that lists them. Files already there under the same
    names are replaced, links and not what they point to. If the block, or the moving, fails or is abandoned, `out` is
    left as it was. What killed runs have left in `out` is undone and cleared away.

    Raises:
        FileError: the folder cannot be made or written to, the disk is full, or another run does not let go of it.
    """
    global _run
    try:
        created = tuple(folder for folder in (out, *out.parents) if not folder.exists())
    except OSError as error:
        _refuse(error, out)
    # Known before anything is made, so that no moment is left in which it could not be cleared away.
    _run = run = _Run(out / f"{_PREFIX}{secrets.token_hex(8)}", created)
    try:
        _begin(run, out)
        yield run.staging
        with locked(out) as sure:
            undo_killed(out, sure=sure)
            run.settled = True
            _publish(run.staging, out)
    except BaseException as error:
        _run = None
        run.clear()
        if isinstance(error, OSError):
            _refuse(error, out)
        raise
    # Its record stays: the files are in place.
    run.clear()


def _begin(run: _Run, out: Path) -> None:
    """Make both folders; another run that fails may remove the outer one as fast as it is made."""
    for tries in range(_MOST_TRIES):
        out.mkdir(parents=True, exist_ok=True)
        try:
            with locked(out) as sure:
                undo_killed(out, sure=sure)
                run.staging.mkdir()
                run.alive = hold(run.staging / _ALIVE)
            return
        except FileNotFoundError:
            if tries == _MOST_TRIES - 1:
                raise


def left_by_killed(out: Path) -> tuple[list[Path], list[Path]]:
    """Staging folders in `out` whose run is not known to live: those of half-done moves, and all others.

    Raises:
        OSError: `out` cannot be read.
    """
    half: list[Path] = []
    unmoved: list[Path] = []
    for folder in sorted(out.iterdir()):
        if not _STAGING.fullmatch(folder.name) or folder.is_symlink() or not folder.is_dir():
            continue
        with suppress(OSError):
            if is_held(folder / _ALIVE):
                continue
        (half if _is_half_moved(folder) else unmoved).append(folder)
    return half, unmoved


def undo_killed(out: Path, *, sure: bool) -> list[str]:
    """Undo the half-done moves of killed runs, and remove what they have left; call it with the folder locked.

    Args:
        out: output folder.
        sure: whether no other run can be at work in it, so that every staging folder in it is of a killed run.

    Returns:
        Names of the files that were put back or removed by that.

    Raises:
        FileError: a half-done move is another user's, or may be still under way.
        OSError: a file cannot be moved.
    """
    half, unmoved = left_by_killed(out)
    back: list[str] = []
    for folder in half:
        if not sure or not _is_own(folder):
            whose = Message("that may still be at work, since this folder cannot be locked")
            raise FileError(
                "{place} holds the half of what a run {whose} was to move there ({left}): when no "
                "run is at work, let that user run cadgen verify --restore on it, or choose another folder",
                place=brief(str(out)),
                whose=Message("of another user") if sure else whose,
                left=folder.name,
            )
        back += _undo(folder, out)
        shutil.rmtree(folder, ignore_errors=True)
    for folder in unmoved:
        if sure and _is_own(folder):
            shutil.rmtree(folder, ignore_errors=True)
    return back


def _is_half_moved(staging: Path) -> bool:
    return (staging / _REPLACED).is_dir() and (staging / MANIFEST).is_file()


def _is_own(folder: Path) -> bool:
    """Whether this user made it; others could have planted it."""
    try:
        return os.name != "posix" or folder.lstat().st_uid == os.geteuid()
    except FileNotFoundError:  # its run has just cleared it away
        return False


def _publish(staging: Path, out: Path) -> None:
    """Move what the staged manifest lists into place; on any failure put back what was there."""
    new = sound_parts(staging / MANIFEST)
    files = _listed(staging / MANIFEST)
    if set(os.listdir(staging)) - {_ALIVE} != {*files, MANIFEST}:
        raise ValueError("a run writes files that its manifest does not list")
    for name in (*files, MANIFEST):
        if (out / name).is_dir() and not (out / name).is_symlink():
            raise FileError(
                "{place} is a folder where a file must go: remove it or choose another folder", place=out / name
            )
    kept = {}
    for name, entry in sound_parts(out / MANIFEST).items():
        # An earlier entry stays for those of its files that are not replaced.
        staying = entry.without(files)
        known = staying.hashes.items()
        if name not in new and known and all(unchanged(out / file, digest) for file, digest in known):
            kept[name] = staying.content
    _prepare(staging, out, files, manifest_text(kept))
    beside = staging / f".new-{MANIFEST}"
    _store(beside, manifest_text(kept | {name: entry.content for name, entry in new.items()}))
    os.replace(beside, staging / MANIFEST)  # at once
    (staging / _PREPARED).rename(staging / _REPLACED)
    try:
        if (staging / _KEPT).exists():
            os.replace(staging / _KEPT, out / MANIFEST)
        for name in sorted(files):
            if os.path.lexists(out / name):
                os.replace(out / name, staging / _REPLACED / name)
            os.replace(staging / name, out / name)
        os.replace(staging / MANIFEST, out / MANIFEST)
    except BaseException:
        _undo(staging, out)
        raise


def _prepare(staging: Path, out: Path, files: Mapping[str, str], kept: str) -> None:
    """Write down what is to be moved, and what is to stand in the manifest's place meanwhile."""
    prepared = staging / _PREPARED
    prepared.mkdir()
    _store(prepared / _RECORD, json.dumps(files))
    if os.path.lexists(out / MANIFEST):
        shutil.copyfile(out / MANIFEST, prepared / MANIFEST, follow_symlinks=False)
        if is_file(prepared / MANIFEST):
            with open(prepared / MANIFEST, "r+b") as stream:
                os.fsync(stream.fileno())
        _store(staging / _KEPT, kept)


def _recorded(staging: Path, out: Path) -> dict[str, str]:
    """Files that a half-done move was to bring, with their hashes.

    Where the record is damaged, as a disk can leave it when the power fails, they follow from the manifests and from
    what was moved aside.
    """
    replaced = staging / _REPLACED
    with suppress(OSError, ValueError, RecursionError):
        files = json.loads(read_regular(replaced / _RECORD, MOST_BYTES).decode("utf-8"))
        if isinstance(files, dict) and all(isinstance(digest, str) for digest in files.values()):
            return files
    new = _listed(staging / MANIFEST)
    kept = set().union(*(_listed(file).items() for file in (replaced / MANIFEST, staging / _KEPT, out / MANIFEST)))
    aside = set(os.listdir(replaced)) - {_RECORD, MANIFEST}
    # With the new manifest lost as well, what stands in the place of a file moved aside was put there for it.
    unknown = {name: file_hash(out / name) for name in aside - set(new) if (out / name).is_file()}
    known = {name: digest for name, digest in new.items() if name in aside or (name, digest) not in kept}
    return dict.fromkeys(aside, "") | unknown | known


def _listed(manifest: Path) -> dict[str, str]:
    """Hashes of all files that a manifest lists; none if it is damaged."""
    return {name: digest for entry in sound_parts(manifest).values() for name, digest in entry.hashes.items()}


def _undo(staging: Path, out: Path) -> list[str]:
    """Go back to what was there before a move, from wherever it, or its undoing, has stopped.

    A new file goes back to the staging folder, if it is still that file; then the one before it, if its place is free,
    to the output folder. What others have put there since stays.
    """
    replaced = staging / _REPLACED
    back = []
    for name, digest in _recorded(staging, out).items():
        if not is_plain_name(name):
            continue
        target = out / name
        if not os.path.lexists(staging / name) and unchanged(target, digest):
            os.replace(target, staging / name)
            back.append(name)
        if os.path.lexists(replaced / name) and not os.path.lexists(target):
            os.replace(replaced / name, target)
            back.append(name)
    if os.path.lexists(replaced / MANIFEST):
        os.replace(replaced / MANIFEST, out / MANIFEST)
    (staging / MANIFEST).unlink()  # from here on nothing is left to be undone
    return sorted(set(back))


def _store(file: Path, text: str) -> None:
    """Write a text onto the disk: it is there even if the power fails right after."""
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())


def _refuse(error: OSError, out: Path) -> NoReturn:
    """Raise the refusal of a folder in words."""
    reasons = {
        errno.ENOSPC: Message("the disk is full: free some space or choose another folder"),
        errno.EDQUOT: Message("your disk quota is used up: free some space or choose another folder"),
        errno.EFBIG: Message("a file would be larger than this system allows: choose another folder"),
        errno.EACCES: Message("there is no permission to write there: choose another folder"),
        errno.EPERM: Message("there is no permission to write there: choose another folder"),
        errno.EROFS: Message("that disk is read-only: choose another folder"),
        errno.EEXIST: Message("a file stands where the folder must go: choose another folder"),
        errno.ENOTDIR: Message("a file stands where a folder must go: choose another folder"),
        errno.ENAMETOOLONG: Message("the path is too long: choose a shorter one"),
    }
    reason = reasons.get(error.errno or 0)
    if reason is None:
        reason = Message("{reason}: choose another folder", reason=Message(error.strerror or str(error)))
    raise FileError("nothing was written to {folder}: {reason}", folder=brief(str(out)), reason=reason) from error


class State(StrEnum):
    """How a file stands to the manifest."""

    AS_LISTED = "as listed"
    CHANGED = "changed"
    MISSING = "missing"
    UNREADABLE = "unreadable"
    NOT_LISTED = "not listed"


@dataclass(frozen=True)
class FileState:
    """A file, the part whose entry lists it (empty if none does), and how it stands to that entry."""

    name: str
    part: str
    state: State


@dataclass(frozen=True, repr=False)
class FolderState:
    """State of a folder against its manifest.

    Attributes:
        files: state of each listed file, part by part, then of the files that no part lists.
        half_moved: staging folders of runs that were killed while they moved their files into place.
        left: staging folders of runs that were killed before that.
        restored: files that were put back first.
        older: files of an earlier version of their design than others in the folder, with its name.
    """

    files: tuple[FileState, ...]
    half_moved: tuple[str, ...]
    left: tuple[str, ...]
    restored: tuple[str, ...] = ()
    older: Mapping[str, str] = field(default_factory=dict)

    def __repr__(self) -> str:
        counts = Counter(str(file.state) for file in self.files)
        said = ", ".join(f"{count} {state}" for state, count in counts.items())
        return f"<FolderState {'true' if self.is_true else 'not true'}: {said or 'no files'}>"

    def to_pandas(self) -> "DataFrame":
        """Files as a pandas frame: name, part and state.

        Raises:
            DesignError: pandas is not installed.
        """
        return frame_of([asdict(file) for file in self.files])

    def _repr_html_(self) -> str:
        rows = (("file", "state"), *((file.name, str(file.state)) for file in self.files))
        return f"<p><code>{escape(repr(self))}</code></p>{html_table(rows)}"

    @property
    def is_true(self) -> bool:
        """Whether every file in the manifest has the hash stated there, and no killed run has left files half moved."""
        return not self.half_moved and all(file.state in (State.AS_LISTED, State.NOT_LISTED) for file in self.files)

    def entry(self, folder: Path) -> Facts:
        """The state, for JSON."""
        return Facts(
            folder=str(folder),
            true=self.is_true,
            half_moved=self.half_moved,
            left=self.left,
            files=self.files,
            restored=self.restored,
            older=tuple(self.older),
        )


def folder_state(folder: Path) -> FolderState:
    """Compare every file of a folder with its manifest; call it with the folder locked, if it can be.

    Raises:
        FileError: the folder has no manifest, though no move is half done, or the manifest cannot be read.
    """
    try:
        half, left = left_by_killed(folder)
        present = sorted(file.name for file in folder.iterdir() if not file.is_dir() or file.is_symlink())
    except OSError as error:
        raise FileError(
            "{folder} cannot be read ({reason}): name a folder that can",
            folder=brief(str(folder)),
            reason=Message(str(error.strerror)),
        ) from None
    try:
        parts = read_parts(folder / MANIFEST)
    except FileNotFoundError:
        if not half:
            raise FileError(
                "there is no {manifest} in {folder}: name a folder that cadgen has written to",
                manifest=MANIFEST,
                folder=brief(str(folder)),
            ) from None
        parts = {}
    except (OSError, ValueError) as error:
        raise FileError(
            "{folder} cannot be used ({error}): export again into this folder",
            folder=brief(str(folder / MANIFEST)),
            error=brief(str(error)),
        ) from None
    files = []
    for part, entry in parts.items():
        if entry is None:
            raise FileError("the manifest's entry {part} lists no files: export that part again", part=brief(part, 80))
        files += [FileState(name, part, _state(folder, name, digest)) for name, digest in entry.hashes.items()]
    known = {file.name for file in files} | {MANIFEST, LOCK}
    files += [FileState(name, "", State.NOT_LISTED) for name in present if name not in known]
    older = older_files({part: entry for part, entry in parts.items() if entry is not None})
    moved, begun = (tuple(folder.name for folder in folders) for folders in (half, left))
    return FolderState(tuple(files), moved, begun, older=older)


def _state(folder: Path, name: str, digest: str) -> State:
    if not is_plain_name(name):  # it means no file of this folder
        return State.MISSING
    try:
        if not is_file(folder / name):
            return State.CHANGED
        return State.AS_LISTED if file_hash(folder / name) == digest else State.CHANGED
    except FileNotFoundError:
        return State.MISSING
    except (OSError, ValueError):
        return State.UNREADABLE
