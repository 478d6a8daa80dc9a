"""A design edited in the browser."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

from cadgen.api.overrides import overrides_of
from cadgen.api.values import name_or_path, whole
from cadgen.errors import DesignError
from cadgen.viewer.editor.session import Session

if TYPE_CHECKING:
    from cadgen.api.design import Design

_EXTRA = ("starlette", "uvicorn", "anyio", "h11")


@dataclass(frozen=True, eq=False, repr=False)
class Editor:
    """A design that is edited in the browser, on this computer alone.

    Attributes:
        session: its text, changes and file.

    Example:
        >>> from cadgen import Editor
        >>> editor = Editor.open("carbon_free_car")
        >>> editor.unsaved
        False
        >>> editor.serve()  # doctest: +SKIP
    """

    session: Session

    @classmethod
    def open(
        cls, source: str | PathLike[str] | None = None, changes: Mapping[str, Any] | Iterable[str] = ()
    ) -> "Editor":
        """Open a design; a packaged one as a copy, which is saved under a name of its own in the current folder.

        Args:
            source: as of `Design.load`.
            changes: changes as for `Design.with_`, written into the text, but not yet into the file.

        Raises:
            DesignError: as `Design.load`.
        """
        return cls(Session(name_or_path("source", source), overrides_of(changes)))

    def __repr__(self) -> str:
        return f"<Editor of {self.session.name}{', unsaved changes' if self.unsaved else ''}>"

    @property
    def unsaved(self) -> bool:
        """Whether there are changes that are in no file."""
        return self.session.unsaved

    @property
    def design(self) -> "Design":
        """The design as it is now."""
        from cadgen.api.design import Design

        return Design.from_toml(self.session.now.text, self.session.name)

    def serve(self, port: int = 0, *, browser: bool = True, show: Callable[[str], object] = print) -> None:
        """Serve the page on 127.0.0.1 until Ctrl-C; it needs the extra `edit`.

        The processes that compute begin anew, so that a script calls this under `if __name__ == "__main__":`.

        Args:
            port: port, 0 to 65535; 0 for any that is free.
            browser: whether to open the page in the browser.
            show: function that is called with the page's address as soon as it can be opened.

        Raises:
            DesignError: the extra is not installed.
            FileError: the port is taken.
        """
        number = whole("port", port, 0, 65535)
        try:
            from cadgen.viewer.editor.running import serve
        except ModuleNotFoundError as error:
            if (error.name or "").partition(".")[0] not in _EXTRA:
                raise
            raise DesignError(
                f"the editor needs {error.name}, which is not installed: "
                "pip install '.[edit]' in cadgen's folder installs it"
            ) from None
        serve(self.session, number, show, browser=browser)
