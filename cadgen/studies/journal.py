"""The journal of a study: every result on disk as soon as it is there, a line each, never changed.

A line is a checksum, a space and JSON. The first is the header, with study and base design, so that the journal alone
is enough to go on or to merge. A run that was killed leaves at most a torn last line, which is cut off; a line that a
disk has damaged is passed over, and its design computed again. A line whose checksum is right, but which is no result
of a study, was written by something else: such a journal is refused.
"""

import json
import os
import stat
from array import array
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from math import inf
from pathlib import Path
from typing import Any, BinaryIO
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import FileError, brief
from cadgen.messages import Message
from cadgen.output.files.lock import lock_now, unlock
from cadgen.reading import open_regular
from cadgen.studies.design_row import Row
from cadgen.studies.planned_paths import PlannedText
from cadgen.studies.study import Study

FORMAT = 1
ENDING = ".journal"
_ABSENT = -1
_LONGEST_LINE = 8_000_000


@dataclass(frozen=True)
class Header:
    """First line of a journal.

    Attributes:
        version: version of cadgen that computes the study.
        fingerprint: of the study.
        name: name of the study.
        study: text of its file.
        text: text of the base design.
        source: name of the base design's file.
        shard: number of the part of the study and number of parts; 1 and 1 for all of it.
    """

    version: str
    fingerprint: str
    name: str
    study: str
    text: str
    source: str
    shard: tuple[int, int] = (1, 1)

    def line(self) -> bytes:
        """The header as it is written."""
        return _line({"format": FORMAT, **self.__dict__})


@dataclass
class Journal:
    """A journal that is open.

    Attributes:
        file: its path.
        header: its first line.
        places: place in the file of the row of each design of the shard in turn, the first, the n-th after it and so
            on for one of n shards; `_ABSENT` for one that is not there.
        paths: place of each planned path, by its key.
        seconds: processor time of all its designs, s.
        count: number of its designs.
        widths: number of values and number of figures of its rows: one pair, if all are of one study.
    """

    file: Path
    header: Header
    stream: BinaryIO
    places: "array[int]" = field(default_factory=lambda: array("q"))
    paths: dict[str, int] = field(default_factory=dict)
    seconds: float = 0.0
    count: int = 0
    widths: set[tuple[int, int]] = field(default_factory=set)

    @classmethod
    def begun(cls, file: Path, header: Header) -> "Journal":
        """Open a journal to go on with it, or begin it; it stays locked until it is closed.

        Raises:
            FileError: it cannot be written, another run holds it, or it is of another study or version.
        """
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            descriptor = os.open(file, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except OSError as error:
            raise FileError(
                "{file} cannot be written ({reason}): choose another place",
                file=brief(str(file)),
                reason=Message(str(error.strerror)),
            ) from error
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            os.close(descriptor)
            raise _no_journal(file)
        stream = os.fdopen(descriptor, "r+b")
        try:
            if not lock_now(stream.fileno()):
                raise FileError(
                    "another run is at work on {file}: let it end, or choose another folder", file=brief(str(file))
                )
            first = stream.readline(_LONGEST_LINE)
            content = _content(first)
            if content is None and header.line().startswith(first):  # empty, or killed at its first line
                stream.seek(0)
                stream.truncate()
                journal = cls(file, header, stream)
                journal._append(header.line())
                return journal
            journal = cls(file, _header(content, file), stream)
            _refuse_other(journal.header, header, file)
            stream.truncate(journal._read(len(first)))
        except BaseException:
            stream.close()
            raise
        return journal

    @classmethod
    def read(cls, file: Path) -> "Journal":
        """Open a journal to read it.

        Raises:
            FileError: it cannot be read or is no journal.
        """
        try:
            stream = open_regular(file)
        except (OSError, ValueError) as error:
            reason = Message(str(error.strerror) if isinstance(error, OSError) else error.args[0])
            raise FileError(
                "{file} cannot be read ({reason}): name another folder", file=brief(str(file)), reason=reason
            ) from error
        try:
            first = stream.readline(_LONGEST_LINE)
            journal = cls(file, _header(_content(first), file), stream)
            journal._read(len(first))
        except BaseException:
            stream.close()
            raise
        return journal

    def require_of(self, study: Study) -> None:
        """Require that the journal is of a study, and each of its rows as wide as its keys and figures.

        Raises:
            FileError: it is of another study.
        """
        width = len(study.keys), len(study.figures)
        if self.header.fingerprint != study.fingerprint or not self.widths <= {width}:
            raise _of_another(self.file)

    def close(self) -> None:
        """Close the file, and free its lock."""
        self.stream.close()

    def free(self) -> None:
        """Free the lock; what is there can still be read."""
        with suppress(OSError):
            unlock(self.stream.fileno())

    def __contains__(self, number: int) -> bool:
        turn = self._turn(number)
        return turn is not None and turn < len(self.places) and self.places[turn] != _ABSENT

    @property
    def numbers(self) -> NDArray[np.int64]:
        """Numbers of all designs that are there, in order."""
        part, parts = self.header.shard
        there = np.frombuffer(self.places, dtype=np.int64) != _ABSENT if len(self.places) else np.zeros(0, dtype=bool)
        return np.flatnonzero(there) * parts + part - 1

    def _turn(self, number: int) -> int | None:
        """Which design of the shard a number is, counted from 0; None for one of another shard."""
        part, parts = self.header.shard
        turn, other = divmod(number - part + 1, parts)
        return None if other else turn

    def add_rows(self, results: Sequence[tuple[Row, float]]) -> None:
        """Write rows of designs, with the processor time of each, s; one that is there already is left out.

        Raises:
            FileError: the disk is full or cannot be written.
        """
        new = [(row, seconds) for row, seconds in results if row.number not in self]
        lines = [_line({"seconds": round(seconds, 6), "row": row.content}) for row, seconds in new]
        place = self._append(b"".join(lines))
        for (row, seconds), line in zip(new, lines, strict=True):
            self._note(row.number, place, seconds)
            place += len(line)

    def add_path(self, planned: PlannedText) -> None:
        """Write a planned path; errors as of `add_rows`."""
        if planned.key not in self.paths:
            self.paths[planned.key] = self._append(_line({"path": [planned.key, planned.text, planned.fault]}))

    def path(self, key: str) -> PlannedText:
        """A planned path that is there."""
        return PlannedText(*self._at(self.paths[key])["path"])

    def row(self, number: int) -> Row:
        """Row of a design that is there."""
        return Row.of(self._at(self.places[number // self.header.shard[1]])["row"])

    def times(self) -> Iterator[float]:
        """Processor time of each design, s, in the order of their numbers."""
        for place in self.places:
            if place != _ABSENT:
                yield self._at(place)["seconds"]

    def _at(self, place: int) -> Any:
        self.stream.seek(place)
        content = _content(self.stream.readline(_LONGEST_LINE))
        if content is None:
            raise FileError(
                "{file} was changed while it was read: run the same command again", file=brief(str(self.file))
            )
        return content

    def _note(self, number: int, place: int, seconds: float) -> None:
        turn = self._turn(number)
        if turn is None:
            return
        if turn >= len(self.places):
            self.places.extend([_ABSENT] * max(turn + 1 - len(self.places), len(self.places)))
        if self.places[turn] == _ABSENT:
            self.count += 1
            self.seconds += seconds
        self.places[turn] = place

    def _read(self, place: int) -> int:
        """Note all lines from a place on; where the last sound one ends.

        Raises:
            FileError: a line with a right checksum is no result of a study.
        """
        good = place
        for number, line in enumerate(iter(lambda: self.stream.readline(_LONGEST_LINE), b""), 2):
            content = _content(line)
            if content is not None:
                try:
                    self._take(content, place)
                except (KeyError, TypeError, ValueError):
                    raise FileError(
                        "{file}, line {line}: this is no result of a study, though its checksum is right: remove the "
                        "line, and its design is computed again, or choose another folder",
                        file=brief(str(self.file)),
                        line=number,
                    ) from None
                good = place + len(line)
            place += len(line)
        return good

    def _take(self, content: Any, place: int) -> None:
        """Note the content of a line; `KeyError`, `TypeError` or `ValueError` if it is no result."""
        if "path" in content:
            key, *texts = content["path"]
            if not all(isinstance(text, str) for text in (key, *texts)) or len(texts) != 2:
                raise ValueError
            self.paths[key] = place
            return
        row, seconds = Row.of(content["row"]), content["seconds"]
        if not 0 <= seconds < inf or self._turn(row.number) is None:
            raise ValueError
        self._note(row.number, place, seconds)
        self.widths.add((len(row.values), len(row.figures)))

    def _append(self, content: bytes) -> int:
        """Write at the end, onto the disk; the place where it begins."""
        try:
            place = self.stream.seek(0, os.SEEK_END)
            self.stream.write(content)
            self.stream.flush()
            os.fsync(self.stream.fileno())
        except OSError as error:
            with suppress(OSError):
                self.stream.truncate(place)
            raise FileError(
                "{file} cannot be written ({reason}): free some space; run the same command again, and the study "
                "goes on where it was",
                file=brief(str(self.file)),
                reason=Message(str(error.strerror)),
            ) from error
        return place


def journal_name(name: str, shard: tuple[int, int]) -> str:
    """Name of the journal of a study, or of one of its shards."""
    part, parts = shard
    return f"{name}{ENDING}" if parts == 1 else f"{name}.{part}of{parts}{ENDING}"


def _line(content: Any) -> bytes:
    text = json.dumps(content, ensure_ascii=True, separators=(",", ":")).encode("ascii")
    return b"%08x %s\n" % (crc32(text), text)


def _content(line: bytes) -> Any:
    """Content of a line: None if it is torn or damaged, the bytes themselves if they are no JSON."""
    if len(line) < 11 or line[8:9] != b" " or not line.endswith(b"\n"):
        return None
    text = line[9:-1]
    if line[:8] != b"%08x" % crc32(text):
        return None
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return text


def _header(content: Any, file: Path) -> Header:
    try:
        texts = {name: content[name] for name in Header.__dataclass_fields__ if name != "shard"}
        part, parts = content["shard"]
        if (
            content["format"] != FORMAT
            or not all(isinstance(text, str) for text in texts.values())
            or not type(part) is type(parts) is int
            or not 1 <= part <= parts
        ):
            raise ValueError
    except (KeyError, TypeError, ValueError):
        raise _no_journal(file) from None
    return Header(**texts, shard=(part, parts))


def _no_journal(file: Path) -> FileError:
    return FileError("{file} is no journal of cadgen explore: choose another folder", file=brief(str(file)))


def _of_another(file: Path) -> FileError:
    return FileError(
        "{file} is of another study, or of another state of this one: choose another folder, or remove it",
        file=brief(str(file)),
    )


def _refuse_other(old: Header, new: Header, file: Path) -> None:
    if old.version != new.version:
        raise FileError(
            "{file} was begun by cadgen {version}, and this is {this}: end it with that version, or "
            "choose another folder",
            file=brief(str(file)),
            version=old.version,
            this=new.version,
        )
    if old.fingerprint != new.fingerprint:
        raise _of_another(file)
    if old.shard != new.shard:
        raise FileError(
            "{file} is of shard {part}/{parts}: name it {name} again",
            file=brief(str(file)),
            part=old.shard[0],
            parts=old.shard[1],
            name=journal_name(old.name, old.shard),
        )
