"""Errors of the lift of a cam by its motion: what each tolerance costs, and how many cams keep a limit."""

from dataclasses import dataclass
from functools import cached_property
from math import degrees, radians

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.lift_errors import ECCENTRICITY, LiftError, LiftErrors, wrong_side_up
from cadgen.design.lift_tolerances import LiftTolerances
from cadgen.design.schema import MotionDesign
from cadgen.errors import DesignError
from cadgen.figures import Facts, Sheet, number
from cadgen.gears.distribution import ZoneSum
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.motion_cam import plan_motion_cam
from cadgen.messages import Message
from cadgen.output.report.notebook import Pictured, bars_picture
from cadgen.output.report.style import Drawing
from cadgen.output.report.terminal import Block
from cadgen.progress import Progress, silent
from cadgen.version import __version__

MOST_CAMS = 1_000_000
_AT_ONCE = 4000  # cams whose errors are in memory together
_QUANTILES = (0.5, 0.9, 0.95, 0.99)
_UM = 1e3
ANGLES = ("tilt", "phase")
NAMES = {
    "base_circle": Message("disc all round"),
    "roller_radius": Message("radius of the roller"),
    "offset": Message("offset of the slide"),
    "arm": Message("length of the arm"),
    "centre_distance": Message("distance of the pivot"),
    "face_offset": Message("face from its pivot"),
    "tilt": Message("tilt of the face"),
    "phase": Message("phase of the disc"),
    "eccentricity": Message("eccentric bore"),
}


@dataclass(frozen=True, kw_only=True)
class LiftCost:
    """Cost of a tolerance at the lift.

    Attributes:
        code: code of the deviation.
        half_width: half of its zone, mm or rad.
        per_unit: greatest error of the lift by a unit of it, mm by mm or rad.
        cam_angle: where that is, rad.
        share: share of the variance of the lift there where all together scatter most, 0 to 1.
    """

    code: str
    half_width: float
    per_unit: float
    cam_angle: float
    share: float

    @property
    def unit(self) -> tuple[str, float]:
        """Unit in which the zone is shown, and its number in mm or rad."""
        return ("deg", radians(1.0)) if self.code in ANGLES else ("um", 1 / _UM)

    @property
    def shown(self) -> float:
        """Half of the zone in that unit."""
        return self.half_width / self.unit[1]

    @property
    def greatest(self) -> float:
        """Greatest error of the lift at the limit of the zone, mm."""
        return self.half_width * self.per_unit


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class LiftToleranceRun(Pictured):
    """Cams within the tolerances of a design with [motion]: what `Design.lift_tolerance` gives.

    Attributes:
        cam: cam as designed.
        samples: number of cams.
        seed: seed of the random numbers.
        errors: greatest error of the lift of each cam over the turn, mm, shape (samples,).
        costs: cost of each tolerance, the dearest first.
        worst: greatest error of the lift if all are at their limits the worst way, mm.
        limit: greatest error allowed, mm; None where the design states none.
        wrong_way: greatest error of the lift of a disc that is put on with its other face outwards, mm; None where the
            follower cannot run on it.
    """

    cam: CamPlan
    samples: int
    seed: int
    errors: Array
    costs: tuple[LiftCost, ...]
    worst: float
    limit: float | None
    wrong_way: float | None

    def __repr__(self) -> str:
        kept = "" if self.passed is None else f", {self.passed:.1%} pass"
        return f"<LiftToleranceRun of {self.cam.origin.name}, {self.samples} cams{kept}>"

    @property
    def passed(self) -> float | None:
        """Share of the cams whose lift keeps the limit; None without a limit."""
        return None if self.limit is None else float(np.mean(self.errors <= self.limit))

    @cached_property
    def quantiles(self) -> dict[float, float]:
        """Greatest error of the lift that a share of the cams does not exceed, mm, by the share."""
        return {part: float(np.quantile(self.errors, part)) for part in _QUANTILES}

    @property
    def picture(self) -> Drawing:
        """Greatest error of the lift by each tolerance at its limit, the dearest first."""
        bars = {str(NAMES[cost.code]): _UM * cost.greatest for cost in self.costs}
        return bars_picture(f"{self.cam.origin.name}: tolerances at their limits", "lift off by (µm)", bars)

    def entry(self) -> Facts:
        """The run for JSON."""
        return self.cam.origin.entry() | Facts(
            cadgen=__version__,
            passed=self.cam.passed,
            samples=self.samples,
            seed=self.seed,
            limit_um=None if self.limit is None else _UM * self.limit,
            **{"yield": self.passed},
            lift_error_um={f"{100 * part:g} %": _UM * value for part, value in self.quantiles.items()},
            worst_um=_UM * self.worst,
            wrong_side_up_um=None if self.wrong_way is None else _UM * self.wrong_way,
            costs=[
                Facts(
                    tolerance=cost.code,
                    half_width=cost.shown,
                    unit=cost.unit[0],
                    lift_um_per_unit=_UM * cost.per_unit * cost.unit[1],
                    lift_um=_UM * cost.greatest,
                    cam_angle_deg=degrees(cost.cam_angle),
                    share_of_variance=cost.share,
                )
                for cost in self.costs
            ],
        )

    @property
    def report(self) -> list[Block]:
        """Table of the tolerances, and sentences on the cams."""
        rows = tuple(
            (
                NAMES[cost.code],
                number(cost.shown, "°" if cost.code in ANGLES else "µm"),
                number(_UM * cost.greatest, "µm", digits=1),
                number(degrees(cost.cam_angle), "°", digits=0),
                number(100 * cost.share, "%", digits=0),
            )
            for cost in self.costs
        )
        heads = (
            Message("Tolerance"),
            Message("Half width"),
            Message("Lift off by"),
            Message("At"),
            Message("Share of variance"),
        )
        said: list[Block] = [Sheet("lift-tolerances", Message("What each tolerance costs at the lift"), heads, rows)]
        said.append(
            Message(
                "Greatest error of the lift over the turn: half of the cams stay within {half:.1f} µm, 95 % within "
                "{most:.1f} µm; all at their limits the worst way {worst:.1f} µm.",
                half=_UM * self.quantiles[0.5],
                most=_UM * self.quantiles[0.95],
                worst=_UM * self.worst,
            )
        )
        if self.passed is not None and self.limit is not None:
            said.append(
                Message(
                    "{passed:.1f} % of {samples} cams keep the limit of {limit:g} µm.",
                    passed=100 * self.passed,
                    samples=self.samples,
                    limit=_UM * self.limit,
                )
            )
        if self.wrong_way is None:
            said.append(Message("Put on with its other face outwards, the disc does not run under its follower."))
        else:
            said.append(
                Message(
                    "Put on with its other face outwards, the disc gives a lift up to {off:.3g} mm off, turned to "
                    "where it does best.",
                    off=self.wrong_way,
                )
            )
        return said


def run_lift_tolerance(design: MotionDesign, samples: int, seed: int, progress: Progress = silent) -> LiftToleranceRun:
    """Errors of the lift of random cams within the tolerances of a design.

    Args:
        design: design with [motion] and [lift_tolerances].
        samples: number of cams.
        seed: seed of the random numbers.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: nothing varies, or the follower's kind does not say what its dimensions do.
    """
    given = design.lift_tolerances or LiftTolerances()
    halves = given.half_widths()
    if not halves:
        raise DesignError(
            "no dimension of the design varies: give [lift_tolerances] half widths above 0, such as "
            "lift_tolerances.base_circle_um = 10"
        )
    plan = plan_motion_cam(design, None, progress)
    set_at = None if given.set_at_deg is None else radians(given.set_at_deg)
    errors = LiftErrors.of(plan.motion, plan.follower_as_built, set_at)
    varied = [each for each in errors.errors if each.code in halves]
    progress("drawing cams")
    greatest = _drawn(varied, halves, given, samples, seed)
    try:
        wrong_way: float | None = wrong_side_up(plan.curve, plan.motion, plan.follower_as_built)
    except DesignError:
        wrong_way = None
    reach = np.stack([halves[each.code] * each.greatest for each in varied])
    spread = np.sum(reach**2, axis=0)
    place = int(np.argmax(spread))
    costs = [
        LiftCost(
            code=each.code,
            half_width=halves[each.code],
            per_unit=float(each.greatest.max()),
            cam_angle=float(errors.cam_angle[np.argmax(each.greatest)]),
            share=float(part[place] ** 2 / spread[place]) if spread[place] else 0.0,
        )
        for each, part in zip(varied, reach, strict=True)
    ]
    return LiftToleranceRun(
        cam=plan,
        samples=samples,
        seed=seed,
        errors=greatest,
        costs=tuple(sorted(costs, key=lambda cost: -cost.greatest)),
        worst=float(reach.sum(axis=0).max()),
        limit=None if given.limit_um is None else given.limit_um / _UM,
        wrong_way=wrong_way,
    )


def _drawn(varied: list[LiftError], halves: dict[str, float], given: LiftTolerances, samples: int, seed: int) -> Array:
    """Greatest error of the lift of random cams, mm, shape (samples,)."""
    generator = np.random.default_rng(seed)
    columns = []
    for each in varied:
        half = np.array([halves[each.code]])
        if each.code == ECCENTRICITY:
            size = ZoneSum((each.code,), np.zeros(1), half, given.law).sample(generator, samples)
            angle = generator.uniform(0.0, TURN, samples)
            columns += [size * np.cos(angle), size * np.sin(angle)]
        else:
            columns.append(ZoneSum((each.code,), -half, half, given.law).sample(generator, samples))
    drawn, of_unit = np.stack(columns, axis=1), np.concatenate([each.of_unit for each in varied], axis=1)
    parts = [np.abs(drawn[first : first + _AT_ONCE] @ of_unit.T).max(axis=1) for first in range(0, samples, _AT_ONCE)]
    return np.concatenate(parts)
