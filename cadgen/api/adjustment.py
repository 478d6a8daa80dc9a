"""Settings of a car by hand, from trial runs: what `Design.adjust` gives."""

from collections.abc import Iterable
from dataclasses import dataclass, fields
from functools import cached_property
from os import PathLike

import numpy as np

from cadgen.api.cam import Cam
from cadgen.api.values import paths, real, word
from cadgen.design.schema import Design as DesignValues
from cadgen.deviations.deviation import SETTINGS, ByHand
from cadgen.errors import DesignError, brief
from cadgen.figures import Facts
from cadgen.inference.records.columns import Reading
from cadgen.jobs.adjustment.plan import AdjustmentPlan, Point, Wanted, adjust, adjustment_facts, write_adjustment
from cadgen.messages import joined
from cadgen.output.files.publisher import Written, folder_of
from cadgen.output.report.notebook import Pictured, lines_picture
from cadgen.output.report.style import Drawing
from cadgen.progress import Progress, silent

POINTS = tuple(point.value for point in Point)
NOISE_MM, DIVISION_UM = (0.1, 1000.0), (0.1, 1000.0)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Adjustment(AdjustmentPlan, Pictured):
    """Settings after trial runs, and the errors to expect in the next run; lengths in mm and angles in rad."""

    def __repr__(self) -> str:
        return f"<Adjustment of {self.plan.origin.name} after {len(self.trials)} trial runs>"

    @property
    def computed(self) -> AdjustmentPlan:
        """The whole result, for figures that are not named here: this object itself."""
        return self

    @cached_property
    def cam(self) -> Cam:
        """The cam on the car."""
        return Cam.of(self.plan)

    @property
    def picture(self) -> Drawing:
        """Share of the cars that end within a distance, with the settings of the last trial run and with the new."""
        share = np.linspace(0.0, 100.0, 101)
        ends = {
            "as set now": np.percentile(self.before.end, share),
            "with the new settings": np.percentile(self.after.end, share),
        }
        title = f"{self.plan.origin.name}: the end of the next run"
        return lines_picture(title, "cars that stay within it (%)", "off the planned end (mm)", share, ends)

    def entry(self) -> Facts:
        """Settings and the errors to expect, as in the manifest."""
        return adjustment_facts(self)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the result as JSON and the table for the next trial run, both or none.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written.
        """
        return write_adjustment(self, folder_of(folder), progress)


def adjusted(
    design: DesignValues,
    trials: "str | PathLike[str] | Iterable[str | PathLike[str]]",
    profile: str,
    point: str,
    settings: Iterable[str],
    noise_mm: float,
    division_um: float,
    reading: Reading,
    progress: Progress,
) -> Adjustment:
    """Result of `Design.adjust`; arguments and errors as there."""
    files = paths("trials", trials)
    if isinstance(settings, str) or not isinstance(settings, Iterable):
        raise DesignError("settings is {given}; it must be several, such as [{given}]", given=brief(repr(settings), 40))
    named = dict.fromkeys(word("settings", setting, tuple(SETTINGS)) for setting in settings)
    if not named:
        raise DesignError("settings is empty; name at least one of {settings}", settings=joined(SETTINGS))
    wanted = Wanted(
        point=Point(word("point", point, POINTS)),
        settings=tuple(map(ByHand, named)),
        noise=real("noise_mm", noise_mm, *NOISE_MM, "mm"),
        division=real("division_um", division_um, *DIVISION_UM, "µm") * 1e-3,
    )
    result = adjust(design, files, profile, wanted, reading, progress)
    return Adjustment(**{item.name: getattr(result, item.name) for item in fields(result)})
