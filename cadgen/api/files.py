"""Files that a job has written, and the comparison of a folder with its manifest."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

from cadgen.api.values import Frozen, frozen
from cadgen.check import Bound
from cadgen.errors import DesignError, brief

if TYPE_CHECKING:
    from cadgen.check import Check
    from cadgen.output.files.manifest import Written as Entry
    from cadgen.output.files.verify import FolderState as FolderState


@dataclass(frozen=True, kw_only=True)
class WrittenFile:
    """A file that was written and proved by reading it back.

    Attributes:
        path: path of the file.
        bytes: size of the file, bytes.
        sha256: SHA-256 of its bytes, hexadecimal.
        lift_error_um: error of the follower's lift on the file read back, µm; None for a file that is no profile.
        lift_limit_um: greatest error allowed, µm.
        facts: facts on the file in the manifest.
    """

    path: Path
    bytes: int
    sha256: str
    lift_error_um: float | None
    lift_limit_um: float | None
    facts: Mapping[str, Any]

    @property
    def name(self) -> str:
        """Name of the file without the folder."""
        return self.path.name


@dataclass(frozen=True, repr=False)
class Written(Sequence[WrittenFile]):
    """The files that one job has written: a sequence of `WrittenFile`.

    Attributes:
        folder: folder of the files, with `manifest.json` beside them.
        part: name of their entry in the manifest.
        entry: content of that entry, as plain values that cannot be changed.
        files: files in the order written.
    """

    folder: Path
    part: str
    entry: Mapping[str, Any]
    files: tuple[WrittenFile, ...]

    @classmethod
    def of(cls, folder: Path, part: str, entry: dict[str, Any]) -> "Written":
        """The files of a manifest's entry.

        Args:
            folder: folder of the files.
            part: name of the entry.
            entry: content of the entry.
        """
        fixed = frozen(entry)
        files = tuple(
            WrittenFile(
                path=folder / name,
                bytes=facts["bytes"],
                sha256=facts["sha256"],
                lift_error_um=facts.get("lift_error_um"),
                lift_limit_um=facts.get("lift_limit_um"),
                facts=facts,
            )
            for name, facts in fixed["files"].items()
        )
        return cls(folder, part, fixed, files)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences on the gain that files give away."""
        return tuple(self.entry.get("warnings", ()))

    @property
    def omitted(self) -> Mapping[str, str]:
        """Reasons, by format, why files could not be made of a part that was written although a check failed."""
        return Frozen(self.entry.get("omitted", {}))

    def __repr__(self) -> str:
        names = ", ".join(file.name for file in self.files)
        return f"<Written to {self.folder}: {names}>"

    def __len__(self) -> int:
        return len(self.files)

    def __iter__(self) -> Iterator[WrittenFile]:
        return iter(self.files)

    @overload
    def __getitem__(self, index: int) -> WrittenFile: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[WrittenFile, ...]: ...
    def __getitem__(self, index: int | slice) -> WrittenFile | tuple[WrittenFile, ...]:
        return self.files[index]


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


def written(folder: str | PathLike[str], write: "Callable[[Path], Entry]") -> Written:
    """Files of a job that writes into a folder.

    Args:
        folder: folder as the caller has it.
        write: function that writes into the folder's path and returns the entry in the manifest.

    Raises:
        DesignError: the folder is no path.
    """
    place = folder_of(folder)
    entry = write(place)
    return Written.of(place, entry.part, entry.entry)


def refusal(checks: "Sequence[Check]", *, forced: bool = True) -> str:
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


def verify(folder: str | PathLike[str], *, restore: bool = False) -> "FolderState":
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
    import errno
    from dataclasses import replace

    from cadgen.errors import FileError
    from cadgen.output.files.folder import undo_killed
    from cadgen.output.files.lock import locked
    from cadgen.output.files.verify import verify as verified

    place = folder_of(folder)
    if not place.is_dir():
        raise FileError(f"there is no folder {brief(str(place))}: name one that cadgen has written to")
    restored: list[str] = []
    try:
        with locked(place):
            if restore:
                restored = undo_killed(place, sure=True)
            state = verified(place)
    except OSError as error:
        if restore or error.errno not in (errno.EACCES, errno.EPERM, errno.EROFS):
            raise FileError(f"{brief(str(place))} cannot be written to ({error.strerror}): make it writable") from None
        state = verified(place)  # this user cannot lock it
    return replace(state, restored=tuple(restored))
