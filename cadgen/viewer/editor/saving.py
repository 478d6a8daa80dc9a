"""The file of a design that is edited: written in one step, in its own folder alone, never over another's changes."""

import os
from dataclasses import dataclass
from pathlib import Path

from cadgen.design.file_names import name_fault
from cadgen.design.load import MOST_BYTES, packaged_designs, read_design
from cadgen.errors import DesignError, FileError, brief
from cadgen.messages import Message
from cadgen.reading import read_regular
from cadgen.writing import write_whole

_MARK = b"\xef\xbb\xbf"  # with which some editors begin a file


@dataclass(frozen=True)
class EditedFile:
    """Where a design comes from and goes to.

    Attributes:
        folder: folder that alone is written to.
        file: file that is saved; None for a packaged design and for a link, which are saved under a new name.
        content: bytes of the file as it was last read or written; empty without one.
    """

    folder: Path
    file: Path | None
    content: bytes

    @classmethod
    def of(cls, source: str | Path | None) -> "tuple[EditedFile, str, Path]":
        """EditedFile, text and file of a design.

        Raises:
            DesignError: as `read_design`.
        """
        text, file = read_design(source)
        packaged = file.resolve() in {known.resolve() for known in packaged_designs().values()}
        if packaged or file.is_symlink():
            return cls(Path.cwd() if packaged else file.absolute().parent, None, b""), text, file
        content = (_MARK if _read(file).startswith(_MARK) else b"") + text.encode()
        return cls(file.absolute().parent, file.absolute(), content), text, file

    def save(self, text: str) -> "EditedFile":
        """Write the design's file.

        Raises:
            DesignError: there is no such file yet: a name is needed.
            FileError: the file was changed by another program, is read-only, or cannot be written.
        """
        if self.file is None:
            raise DesignError(
                Message("this is a copy of a design that stays as it is: save it under a name of its own")
            )
        if not self._unchanged(self.file):
            raise FileError(
                "{file} was changed by another program since it was opened: save under another name, or open the "
                "design again",
                file=brief(self.file.name),
            )
        content = (_MARK if self.content.startswith(_MARK) else b"") + text.encode()
        try:
            write_whole(self.file, content)
        except OSError as error:
            raise _unwritable(self.file, error) from None
        return EditedFile(self.folder, self.file, content)

    def changed_outside(self) -> bool:
        """Whether another program has changed the file since it was last read or written; not if it was removed."""
        if self.file is None:
            return False
        try:
            return self.file.is_symlink() or _read(self.file) != self.content
        except FileNotFoundError:
            return False
        except (OSError, ValueError):  # another program has put something else there
            return True

    def _unchanged(self, file: Path) -> bool:
        """Whether a file is as it was last read or written, or was removed: then it is written again.

        Raises:
            FileError: the file is read-only.
        """
        if self.changed_outside():
            return False
        if file.exists() and not os.access(file, os.W_OK):
            raise FileError(
                "{file} is read-only: save under another name, or allow writing to it", file=brief(file.name)
            )
        return True

    def save_as(self, name: str, text: str) -> "EditedFile":
        """Write a new file in the design's folder.

        Args:
            name: name of the design and, with .toml, of its file.
            text: TOML.

        Raises:
            DesignError: no file can have that name.
            FileError: there is such a file already, or it cannot be written.
        """
        refuse_name(name)
        file = self.folder / f"{name}.toml"
        content = text.encode()
        try:
            write_whole(file, content, new=True)
        except FileExistsError:
            raise FileError("{file} is there already: choose another name", file=file.name) from None
        except OSError as error:
            raise _unwritable(file, error) from None
        return EditedFile(self.folder, file, content)


def refuse_name(name: str) -> None:
    """Refuse a name that no file can have.

    Raises:
        DesignError: with the reason.
    """
    if fault := name_fault(name):
        raise DesignError('the name is "{name}"; it must {fault}', name=brief(name, 80), fault=fault)


def _read(file: Path) -> bytes:
    return read_regular(file, MOST_BYTES)


def _unwritable(file: Path, error: OSError) -> FileError:
    return FileError(
        "{file} cannot be written ({reason}): make room, or open the folder to you",
        file=brief(str(file)),
        reason=error.strerror,
    )
