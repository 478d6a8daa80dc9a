"""Publisher of every job: files are written and read back in a staging folder, then moved into place with a manifest.

A job says how its files are made and which facts belong to them. The rest is the same for all jobs: staging, hashes,
versions, the manifest's entry, and what the caller gets to see of it.
"""

import errno
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from html import escape
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, overload

from cadgen.check import Bound, Check
from cadgen.errors import DesignError, FileError, brief
from cadgen.figures import Facts, Figures, frame_of, html_table
from cadgen.messages import Message, joined
from cadgen.output.files.folder import FolderState, folder_state, publishing, undo_killed
from cadgen.output.files.lock import locked
from cadgen.output.files.manifest import file_facts, versions, write_manifest

if TYPE_CHECKING:
    from pandas import DataFrame


@dataclass(frozen=True)
class Artifact:
    """File that was written into the staging folder and proved by reading it back.

    Attributes:
        name: name of the file.
        facts: what was read back, for the manifest.
        readings: what was read back in words, by the columns of the job's table of files.
        in_use: figures of the part in its use, as the file has it.
    """

    name: str
    facts: Facts = field(default_factory=Facts)
    readings: tuple[str, ...] = ()
    in_use: Figures = field(default_factory=Figures)


def publish(
    part: str,
    out: Path,
    make: Callable[[Path], Iterable[Artifact]],
    facts: Facts,
    outcome: Callable[[Sequence[str]], Facts] = lambda names: Facts(),
) -> "Written":
    """Make the files of a job, and publish them together with their entry in the manifest, all or none.

    Args:
        part: name of the entry.
        out: folder for the files; it is made if need be.
        make: function that writes the files into a staging folder, reads them back and gives them one by one.
        facts: facts on the part.
        outcome: function of the names of all files that gives further facts once they are made.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    with publishing(out) as staging:
        made = list(make(staging))
        files = {each.name: file_facts(staging / each.name) | each.facts | each.in_use for each in made}
        facts |= Facts(versions=versions()) | outcome(list(files)) | Facts(files=files)
        entry = write_manifest(staging, part, facts)
    return Written.of(out, part, entry, {each.name: each.readings for each in made})


def text_file(file: Path, text: str) -> Artifact:
    """Write a text in UTF-8, and require that it is read back as it was written.

    Args:
        file: file in the staging folder.
        text: content of the file.

    Raises:
        FileError: it is not what was written.
    """
    file.write_text(text, encoding="utf-8", newline="")
    if file.read_bytes() != text.encode("utf-8"):
        raise FileError(
            "{file}: read back it is not what was written; try again or choose another disk", file=file.name
        )
    return Artifact(file.name)


def read_file(file: Path) -> bytes:
    """Content of a file that was written.

    Raises:
        FileError: it cannot be read.
    """
    try:
        return file.read_bytes()
    except OSError as error:
        raise FileError("cannot read {file}: {reason}", file=file.name, reason=Message(str(error.strerror))) from error


def require(holds: bool, file: str, fault: str) -> None:
    """Require something of a file that was read back.

    Args:
        holds: whether it is so.
        file: name of the file.
        fault: what is wrong otherwise, after the file's name.

    Raises:
        FileError: it is not so.
    """
    if not holds:
        raise FileError("{file}, read back, {fault}: report this design", file=file, fault=fault)


class Frozen(dict[str, Any]):
    """A mapping that nobody can change, which has a hash and can be copied, pickled and written as JSON."""

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(frozenset(self.items()))

    def __reduce__(self) -> tuple[object, ...]:
        return Frozen, (dict(self),)

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("this mapping cannot be changed: make a dict of it first")

    __setitem__ = __delitem__ = __ior__ = update = setdefault = pop = popitem = clear = _refuse


def frozen(value: Any) -> Any:
    """Freeze a value: its mappings become `Frozen` and its lists tuples, all the way down.

    Args:
        value: plain values, such as the content of a JSON file.
    """
    if isinstance(value, Mapping):
        return Frozen({key: frozen(inside) for key, inside in value.items()})
    return tuple(map(frozen, value)) if isinstance(value, list | tuple) else value


@dataclass(frozen=True, kw_only=True, repr=False)
class WrittenFile:
    """A file that was written and proved by reading it back.

    Attributes:
        path: path of the file.
        bytes: size of the file, bytes.
        sha256: SHA-256 of its bytes, hexadecimal.
        lift_error_um: error of the follower's lift on the file read back, µm; None for a file that is no profile.
        lift_limit_um: greatest error allowed, µm.
        end_position_mm: end of the run with play on it, off the planned end, mm; None where nothing runs on it.
        facts: facts on the file in the manifest.
        readings: what was read back in words, by the columns of the job's table of files.
    """

    path: Path
    bytes: int
    sha256: str
    lift_error_um: float | None
    lift_limit_um: float | None
    end_position_mm: float | None
    facts: Mapping[str, Any]
    readings: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"<WrittenFile {self.name}, {self.bytes} bytes>"

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
    def of(
        cls, folder: Path, part: str, entry: Mapping[str, Any], readings: Mapping[str, tuple[str, ...]] | None = None
    ) -> "Written":
        """The files of a manifest's entry.

        Args:
            folder: folder of the files.
            part: name of the entry.
            entry: content of the entry.
            readings: what was read back of each file in words, by its name.
        """
        fixed = frozen(entry)
        files = tuple(
            WrittenFile(
                path=folder / name,
                bytes=facts["bytes"],
                sha256=facts["sha256"],
                lift_error_um=facts.get("lift_error_um"),
                lift_limit_um=facts.get("lift_limit_um"),
                end_position_mm=facts.get("end_position_mm"),
                facts=facts,
                readings=(readings or {}).get(name, ()),
            )
            for name, facts in fixed["files"].items()
        )
        return cls(folder, part, fixed, files)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences on the gain that files give away, and on what programs assume of the material."""
        assumed = (file.facts["assumed"] for file in self.files if "assumed" in file.facts)
        return tuple(dict.fromkeys((*self.entry.get("warnings", ()), *assumed)))

    @property
    def omitted(self) -> Mapping[str, str]:
        """Reasons, by format, why files could not be made of a part that was written although a check failed."""
        return Frozen(self.entry.get("omitted", {}))

    @property
    def not_stated(self) -> Mapping[str, str]:
        """Facts that drawings leave open, each with the key of the design that states it."""
        return Frozen(self.entry.get("not_stated", {}))

    def __repr__(self) -> str:
        names = ", ".join(file.name for file in self.files)
        return f"<Written to {self.folder}: {names}>"

    def to_pandas(self) -> "DataFrame":
        """Files as a pandas frame, with what was read back of each.

        Raises:
            DesignError: pandas is not installed.
        """
        return frame_of([{"file": file.name, **file.facts} for file in self.files])

    def _repr_html_(self) -> str:
        heads = ("file", "kB", "lift off by, µm")
        rows = (
            (file.name, f"{file.bytes / 1000:.1f}", "" if file.lift_error_um is None else f"{file.lift_error_um:.3g}")
            for file in self.files
        )
        return f"<p><code>{escape(str(self.folder))}</code></p>{html_table((heads, *rows))}"

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
        raise DesignError("folder is {given}; it must be a path, such as exports", given=brief(repr(folder), 80))
    return Path(folder)


def refusal(checks: Sequence[Check], *, forced: bool = True) -> Message:
    """Message on a failed export: each check that fails, with its limit and what to change.

    Args:
        checks: checks, of which those that fail are named.
        forced: whether the caller can write all the same, by `force`.
    """
    failing = joined([_fault(check) for check in checks if not check.passed], "; ")
    if forced:
        return Message(
            "a check failed, so nothing was written ({failing}); force=True writes all the same", failing=failing
        )
    return Message("a check failed, so nothing was written ({failing})", failing=failing)


def _fault(check: Check) -> Message:
    value, limit = (f"{figure:.4g} {check.unit}".rstrip() for figure in (check.value, check.limit))
    most = check.bound == Bound.MAX
    fault = Message(
        "{name} is {value}; it must be at most {limit}" if most else "{name} is {value}; it must be at least {limit}",
        name=Message(check.name),
        value=value,
        limit=limit,
    )
    return Message("{fault}: {advice}", fault=fault, advice=Message(check.advice)) if check.advice else fault


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
        raise FileError("there is no folder {folder}: name one that cadgen has written to", folder=brief(str(place)))
    restored: list[str] = []
    try:
        with locked(place):
            if restore:
                restored = undo_killed(place, sure=True)
            state = folder_state(place)
    except OSError as error:
        if restore or error.errno not in (errno.EACCES, errno.EPERM, errno.EROFS):
            raise FileError(
                "{folder} cannot be written to ({reason}): make it writable",
                folder=brief(str(place)),
                reason=Message(str(error.strerror)),
            ) from None
        state = folder_state(place)  # this user cannot lock it
    return replace(state, restored=tuple(restored))
