"""A design on its page: as a report, and in the browser, where it can be changed."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from os import PathLike
from typing import TYPE_CHECKING, Any

from cadgen.api.cam import Cam
from cadgen.api.design import MOST_CARS, MOST_PROCESSES, Design
from cadgen.api.loaded import overrides_of
from cadgen.api.measured import Data, reading_of, sources_of
from cadgen.api.values import instance, name_or_path, whole
from cadgen.check import Check, CheckList, failing
from cadgen.design.load import is_train_alone
from cadgen.design.schema import MotionDesign
from cadgen.errors import DesignError, FileError
from cadgen.figures import Facts
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing
from cadgen.progress import Progress, silent
from cadgen.viewer.editor.session import Session
from cadgen.viewer.page.car_page import plan_page
from cadgen.viewer.page.page_plan import plan_motion_page
from cadgen.viewer.page.train_page import TrainPage, plan_train_page

if TYPE_CHECKING:
    from cadgen.jobs.calibration.sources import Source
    from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan
    from cadgen.viewer.page.page_plan import PagePlan

SAMPLES = 10_000
_EXTRA = ("starlette", "uvicorn", "anyio", "h11")


def _compared(design: Design, data: Data | Iterable[Data], progress: Progress) -> "ComparedCamPlan":
    return design.compare_cam(data, progress=progress)


@dataclass(frozen=True, eq=False, repr=False)
class Report(Pictured):
    """A report of a design: cam, gears, runs and tolerance, each computed once.

    Attributes:
        computed: numeric results, with all other figures; mm and rad.

    Example:
        >>> from cadgen import Design, Report
        >>> report = Report.of(Design.load("carbon_free_car"), samples=100)
        >>> report.passed
        True
        >>> files = report.write("exports")  # doctest: +SKIP
    """

    computed: "PagePlan | TrainPage"

    @classmethod
    def of(
        cls,
        design: Design,
        profile: str | None = None,
        *,
        data: Data | Iterable[Data] | None = None,
        samples: int = SAMPLES,
        processes: int = 1,
        progress: Progress = silent,
    ) -> "Report":
        """Compute what the report of a design shows; nothing is written.

        Args:
            design: design of the report.
            profile: profile of the cam; as of `Design.cam`.
            data: measured data of one car, as of `Design.calibrate`, or of one cam, as of `Design.compare_cam`; none if
                left out.
            samples: number of random cars, 1 to 10 000 000.
            processes: number of processes that run at once, 1 to 256.
            progress: function that is called with a few words on each step.

        Data that cannot be read, or cannot be judged together, are left out, and the page says so first.

        Raises:
            DesignError: as `Design.cam`.
        """
        values = instance("design", design, Design).values
        if is_train_alone(design.text, design.file):
            return cls(plan_train_page(values, progress))
        if isinstance(values, MotionDesign):
            compare = None if data is None else partial(_compared, design, data)
            return cls(plan_motion_page(values, profile, progress, compare=compare))
        sources: tuple[Source, ...] = ()
        unread = ""
        complete = design.complete()
        try:
            sources = () if data is None else sources_of(data, reading_of(complete, None), progress=progress)
        except FileError as error:
            unread = error.message
        return cls(
            plan_page(
                complete,
                profile,
                whole("samples", samples, 1, MOST_CARS),
                whole("processes", processes, 1, MOST_PROCESSES),
                sources,
                progress,
                unread=unread,
            )
        )

    def __repr__(self) -> str:
        verdict = "passed" if self.passed else f"failed: {', '.join(check.name for check in self.failed)}"
        return f"<Report on {self.computed.origin.name}, {verdict}>"

    @property
    def checks(self) -> CheckList:
        """Checks of cam and gears."""
        return CheckList(self.computed.checks)

    @property
    def picture(self) -> Drawing:
        """Outline and lift of the cam, or the gears of a train alone."""
        if isinstance(self.computed, TrainPage):
            return self.computed.gears.picture
        return Cam.of(self.computed.cam).picture

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit, and a profile and a train could be made."""
        return self.computed.passed

    @property
    def failed(self) -> tuple[Check, ...]:
        """Checks that do not keep their limit."""
        return failing(self.checks)

    @property
    def refused(self) -> tuple[str, ...]:
        """Sentences on what could not be computed, such as a train that cannot be laid out."""
        return tuple(refusal.reason for refusal in self.computed.refusals)

    def entry(self) -> Facts:
        """Every figure of the page, as in the manifest."""
        return self.computed.figures()

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the page, also if a check fails: then it says so first.

        Args:
            folder: folder for the file; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: the file cannot be written.
        """
        from cadgen.viewer.page.report import write_page

        return write_page(self.computed, folder_of(folder), progress)


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
    def design(self) -> Design:
        """The design as it is now."""
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
            from cadgen.viewer.editor.server import serve
        except ModuleNotFoundError as error:
            if (error.name or "").partition(".")[0] not in _EXTRA:
                raise
            raise DesignError(
                "the editor needs {library}, which is not installed: "
                "pip install '.[edit]' in cadgen's folder installs it",
                library=error.name,
            ) from None
        serve(self.session, number, show, browser=browser)
