"""A planned path: what `Design.plan` gives."""

from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import Any, Generic

from cadgen.api.calibration import D
from cadgen.api.cam import Cam
from cadgen.api.values import map_of, optional, whole
from cadgen.car.planner import RESERVE, SEEDS, WITHIN_MM
from cadgen.design import cam_model
from cadgen.design.schema import Design as DesignValues
from cadgen.errors import CheckError, DesignError
from cadgen.jobs.planning.path_report import facts, sentences
from cadgen.jobs.planning.plan import PathPlanning, PlanRequest, plan_design
from cadgen.jobs.planning.write import write_plan
from cadgen.output.files.publisher import Written, folder_of, refusal
from cadgen.progress import Progress, silent

_WITHIN_MM = 25.0


@dataclass(frozen=True, eq=False, repr=False)
class Plan(Generic[D]):
    """Result of `Design.plan`: a path with its cam and checks, or the reasons why there is none.

    Attributes:
        computed: the whole result, for figures that are not named here; mm and rad.
        source: design that a path was planned for.
    """

    computed: PathPlanning
    source: D

    def __repr__(self) -> str:
        state = "passed" if self.passed else "failed" if self.computed.cam else "no path"
        return f"<Plan of {self.computed.design.name}: {state}>"

    @property
    def passed(self) -> bool:
        """Whether there is a path and all its checks pass."""
        return self.computed.passed

    @property
    def sentences(self) -> tuple[str, ...]:
        """The result in words, the most important first."""
        return tuple(sentences(self.computed))

    @cached_property
    def cam(self) -> Cam | None:
        """The cam for the path, with all its checks; None if there is no path."""
        return None if self.computed.cam is None else Cam.of(self.computed.cam)

    @cached_property
    def design(self) -> D:
        """The design with the planned path.

        Raises:
            CheckError: there is no path.
        """
        if not self.computed.text:
            raise CheckError(self.sentences[0])
        return type(self.source).from_toml(self.computed.text, self.computed.design.name)

    def facts(self) -> dict[str, Any]:
        """The result as plain values, as in the manifest and with `--json`."""
        return facts(self.computed)

    def write(self, folder: str | PathLike[str], *, progress: Progress = silent) -> Written:
        """Write the design with the planned path, `NAME_planned.toml`, where comments of the file stay.

        Args:
            folder: where to; it is made if need be.
            progress: function that is called with a few words on each step.

        Raises:
            CheckError: there is no path, or a check fails.
            FileError: the file cannot be written.
        """
        if self.computed.cam is None:
            raise CheckError(self.sentences[0])
        if not self.passed:
            drawn = (check for each in self.computed.drawn for check in each.checks)
            raise CheckError(refusal((*self.computed.cam.checks, *drawn), forced=False))
        return write_plan(self.computed, folder_of(folder), progress)


def planned(
    source: D,
    text: str,
    course: tuple[DesignValues, bool],
    others: tuple[DesignValues | None, DesignValues | None],
    within_mm: float | None,
    reserve: float | None,
    seeds: int,
    pool: Any,
    progress: Progress,
) -> Plan[D]:
    """Plan a path; see `Design.plan`.

    Args:
        source: design that a path is planned for.
        text: text of its file.
        course: the same as it is planned, and whether it has a path of its own.
        others: design whose path is improved, and one whose curvature's slopes are not exceeded; None without.
        within_mm: how far the first may be left, mm.
        reserve: room besides the margins, as a factor on the scatter of cars; None to choose it.
        seeds: number of searches.
        pool: executor, pool or function like the built-in `map` that runs several searches; None for this process.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: as `Design.plan`.
    """
    (known, drawn), (near, calm) = course, (None if other is None else cam_model.track(other) for other in others)
    room = optional("reserve", reserve, *RESERVE, "times the scatter of the cars")
    within = optional("within_mm", within_mm, *WITHIN_MM, "mm")
    if within is not None and near is None:
        raise DesignError("within_mm says how far a given path may be left: give improve too, or leave it out")
    reach, count = _WITHIN_MM if within is None else within, whole("seeds", seeds, *SEEDS)
    before = known if drawn else None
    if others[0] is not None:
        before = known.model_copy(update={"path": others[0].path})
    wanted = PlanRequest(near, reach, calm or near, count, map_of(pool), before, room)
    own = cam_model.track(known) if drawn else None
    return Plan(plan_design(known, text, own, wanted, progress), source)
