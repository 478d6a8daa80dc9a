"""Methods against play, compared."""

from dataclasses import dataclass
from os import PathLike

from cadgen.api.cam import Cam
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.figures import Facts
from cadgen.jobs.cam.car_facts import remedy_facts
from cadgen.jobs.cam.comparison import PAPER_PERCENT as PAPER_PERCENT
from cadgen.jobs.cam.remedies import Remedy
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report.notebook import Pictured
from cadgen.output.report.style import Drawing
from cadgen.progress import Progress, silent


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(Pictured):
    """The methods against play, alone and combined: what `Design.optimize` gives.

    Attributes:
        cam: the best profile that keeps every limit.
        remedies: further remedies, with what to build for them; empty if the design has no [mechanics].
    """

    cam: Cam
    remedies: tuple[Remedy, ...]

    def __repr__(self) -> str:
        return f"<Comparison for {self.cam.origin.name}, {len(self.compared)} compared, best {self.cam.profile}>"

    @property
    def compared(self) -> tuple[Evaluation, ...]:
        """Every method on every train, with its errors, mm and rad."""
        return () if self.cam.comparison is None else self.cam.comparison.evaluations

    @property
    def picture(self) -> Drawing:
        """Tracks of every method at its play, with the ends over the band of play."""
        from cadgen.jobs.simulation import methods_picture

        return methods_picture(self.cam)

    def entry(self) -> Facts:
        """The facts on the cam, and the further remedies."""
        remedies = Facts(remedies=[remedy_facts(remedy) for remedy in self.remedies]) if self.remedies else Facts()
        return self.cam.entry() | remedies

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write pictures of events and tracks, all together or none.

        Args:
            folder: folder for the files; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written.
        """
        from cadgen.jobs.simulation import write_comparison

        return write_comparison(self.cam, folder_of(folder), self.cam.find_cures(progress), progress)
