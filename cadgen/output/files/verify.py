"""Comparison of an output folder with its manifest."""

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Any

from cadgen.errors import FileError, brief
from cadgen.output.files.folder import left_by_killed
from cadgen.output.files.lock import NAME as LOCK
from cadgen.output.files.manifest import NAME as MANIFEST
from cadgen.output.files.manifest import file_hash, is_file, is_plain_name, read_parts


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


@dataclass(frozen=True)
class FolderState:
    """State of a folder against its manifest.

    Attributes:
        files: state of each listed file, part by part, then of the files that no part lists.
        half_moved: staging folders of runs that were killed while they moved their files into place.
        left: staging folders of runs that were killed before that.
        restored: files that were put back first.
    """

    files: tuple[FileState, ...]
    half_moved: tuple[str, ...]
    left: tuple[str, ...]
    restored: tuple[str, ...] = ()

    @property
    def is_true(self) -> bool:
        """Whether every file in the manifest has the hash stated there, and no killed run has left files half moved."""
        return not self.half_moved and all(file.state in (State.AS_LISTED, State.NOT_LISTED) for file in self.files)

    def facts(self, folder: Path) -> dict[str, Any]:
        """The state as plain values, for JSON."""
        return {
            "folder": str(folder),
            "true": self.is_true,
            "half_moved": list(self.half_moved),
            "left": list(self.left),
            "files": [{"name": file.name, "part": file.part, "state": file.state} for file in self.files],
            "restored": list(self.restored),
        }


def verify(folder: Path) -> FolderState:
    """Compare every file of a folder with its manifest; call it with the folder locked, if it can be.

    Raises:
        FileError: the folder has no manifest, though no move is half done, or the manifest cannot be read.
    """
    try:
        half, left = left_by_killed(folder)
        present = sorted(file.name for file in folder.iterdir() if not file.is_dir() or file.is_symlink())
    except OSError as error:
        raise FileError(f"{brief(str(folder))} cannot be read ({error.strerror}): name a folder that can") from None
    try:
        parts = read_parts(folder / MANIFEST)
    except FileNotFoundError:
        if not half:
            raise FileError(
                f"there is no {MANIFEST} in {brief(str(folder))}: name a folder that cadgen has written to"
            ) from None
        parts = {}
    except (OSError, ValueError) as error:
        raise FileError(
            f"{brief(str(folder / MANIFEST))} cannot be used ({brief(str(error))}): export again into this folder"
        ) from None
    files = [
        FileState(name, part, _state(folder, name, facts))
        for part, entry in parts.items()
        for name, facts in _listed(part, entry).items()
    ]
    known = {file.name for file in files} | {MANIFEST, LOCK}
    files += [FileState(name, "", State.NOT_LISTED) for name in present if name not in known]
    return FolderState(tuple(files), tuple(folder.name for folder in half), tuple(folder.name for folder in left))


def _listed(part: str, entry: Any) -> dict[str, Any]:
    files = entry.get("files") if isinstance(entry, dict) else None
    if not isinstance(files, dict) or not all(isinstance(facts, dict) for facts in files.values()):
        raise FileError(f"the manifest's entry {brief(part, 80)} lists no files: export that part again")
    return files


def _state(folder: Path, name: str, facts: dict[str, Any]) -> State:
    if not is_plain_name(name):  # it means no file of this folder
        return State.MISSING
    try:
        if not is_file(folder / name):
            return State.CHANGED
        return State.AS_LISTED if file_hash(folder / name) == facts.get("sha256") else State.CHANGED
    except FileNotFoundError:
        return State.MISSING
    except (OSError, ValueError):
        return State.UNREADABLE
