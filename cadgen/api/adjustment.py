"""Settings of a car by hand, from trial runs: what `Design.adjust` gives."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import Any

from cadgen.api.cam import Cam
from cadgen.api.files import Written, written
from cadgen.api.values import paths, real, word
from cadgen.design.schema import Design as DesignValues
from cadgen.errors import DesignError, brief
from cadgen.inference.adjustment import Forecast, Settings
from cadgen.jobs.adjustment import plan
from cadgen.jobs.adjustment.files import adjustment_facts, write_adjustment
from cadgen.progress import Progress, silent

POINTS = tuple(point.value for point in plan.Point)
KNOBS = tuple(knob.value for knob in plan.Knob)
NOISE_MM, DIVISION_UM = (0.1, 1000.0), (0.1, 1000.0)


@dataclass(frozen=True, eq=False, repr=False)
class Adjustment:
    """Settings after trial runs, and the errors to expect in the next run.

    Attributes:
        computed: the numeric result, for figures that are not named here; mm and rad.
    """

    computed: plan.Adjustment

    def __repr__(self) -> str:
        return f"<Adjustment of {self.cam.design.name} after {len(self.computed.trials)} trial runs>"

    @cached_property
    def cam(self) -> Cam:
        """The cam on the car."""
        return Cam(self.computed.plan)

    @property
    def settings(self) -> Settings:
        """Settings of the next run as changes of the design, mm and rad."""
        return self.computed.settings

    @property
    def explained(self) -> bool:
        """Whether cars within twice the tolerances explain the trial runs; if not, set nothing by this."""
        return self.computed.explained

    @property
    def before(self) -> Forecast:
        """Position errors to expect with the settings of the last trial run, mm."""
        return self.computed.before

    @property
    def after(self) -> Forecast:
        """Position errors to expect with the new settings, mm."""
        return self.computed.after

    @property
    def sentences(self) -> tuple[str, ...]:
        """The result in words, the most important first."""
        return tuple(self.computed.sentences())

    @property
    def steps(self) -> tuple[str, ...]:
        """Settings, a sentence each."""
        return tuple(self.computed.steps())

    @property
    def line(self) -> str:
        """Comment line with these settings, for the file of the next trial run."""
        return self.computed.line

    def facts(self) -> dict[str, Any]:
        """The result as plain values, as in the manifest and with `--json`."""
        return adjustment_facts(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the result as JSON and the table for the next trial run, both or none.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            FileError: a file cannot be written.
        """
        return written(folder, lambda place: write_adjustment(self.computed, place, progress))


def adjusted(
    design: DesignValues,
    trials: "str | PathLike[str] | Iterable[str | PathLike[str]]",
    profile: str,
    point: str,
    knobs: Iterable[str],
    noise_mm: float,
    division_um: float,
    progress: Progress,
) -> Adjustment:
    """Result of `Design.adjust`; arguments and errors as there."""
    files = paths("trials", trials)
    if isinstance(knobs, str) or not isinstance(knobs, Iterable):
        raise DesignError(f"knobs is {brief(repr(knobs), 40)}; it must be several, such as [{brief(repr(knobs), 40)}]")
    named = list(dict.fromkeys(word("knobs", knob, KNOBS) for knob in knobs))
    if not named:
        raise DesignError(f"knobs is empty; name at least one of {', '.join(KNOBS)}")
    wanted = plan.Wanted(
        point=plan.Point(word("point", point, POINTS)),
        knobs=tuple(plan.Knob(knob) for knob in named),
        noise=real("noise_mm", noise_mm, *NOISE_MM, "mm"),
        division=real("division_um", division_um, *DIVISION_UM, "µm") * 1e-3,
    )
    return Adjustment(plan.adjust(design, files, profile, wanted, progress))
