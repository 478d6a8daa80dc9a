"""Figures of a design that a study may aim at or limit. A new one is an entry here, or is registered from outside."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from math import degrees
from typing import Any

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.against_play.band import PlayBand
from cadgen.car.against_play.remedies import holding
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import drive, turns_of
from cadgen.car.steering import track_curvature, travel_ratio
from cadgen.check import CheckCode
from cadgen.design import cam_model, variation
from cadgen.design.schema import Design, MotionDesign
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_plan import DENSITY, CamPlan
from cadgen.jobs.cam.comparison import known_trains
from cadgen.jobs.cam.motion_cam import plan_motion_cam
from cadgen.jobs.cam.steering_cam import comparison_of, plan_cam
from cadgen.jobs.tolerance import CarSample, ToleranceRun, tolerance_of
from cadgen.messages import Message
from cadgen.output.files.nc import drilling_minutes, milling_minutes
from cadgen.registry import Registry


class Evaluated:
    """A design of a study.

    Args:
        values: value of each varied key.
        read: function that reads the design, checked.
        profile: profile of the cam; that of `cadgen cam` if None.
        cars: number of random cars.
        seed: seed of the random cars, the same for all designs, so that they differ by design alone.
    """

    def __init__(
        self,
        values: Mapping[str, Any],
        read: Callable[[], Design | MotionDesign],
        profile: str | None,
        cars: int,
        seed: int,
    ) -> None:
        self.values, self._read, self._profile, self._cars, self._seed = values, read, profile, cars, seed

    @cached_property
    def read(self) -> Design | MotionDesign:
        """The design, checked by its schema."""
        return self._read()

    @property
    def design(self) -> Design:
        """Design of a car.

        Raises:
            DesignError: it has [motion].
        """
        if isinstance(self.read, MotionDesign):
            raise DesignError("this figure is of a car, and the design has [motion]: take another figure")
        return self.read

    @cached_property
    def track(self) -> Track:
        """Track of the drive wheel."""
        return cam_model.track(self.design)

    @cached_property
    def lift(self) -> PathMotion:
        """Planned lift."""
        return cam_model.lift(self.design, self.track)

    @cached_property
    def band(self) -> PlayBand:
        """Return error of the train that the design is made for."""
        return known_trains(self.design)[self.design.optimize.order]

    @cached_property
    def plan(self) -> CamPlan:
        """Cam with all its checks, compared under play where a car has it."""
        if isinstance(self.read, MotionDesign):
            return plan_motion_cam(self.read, self._profile)
        return plan_cam(self.design, self._profile, with_play=bool(variation.play_bands(self.design)))

    @cached_property
    def tolerance(self) -> ToleranceRun[CamPlan]:
        """Random cars with that cam."""
        return tolerance_of(self.plan, CarSample(samples=self._cars, seed=self._seed))


class FigureScope(StrEnum):
    """Designs that have a figure: cams of a car, cams by their motion, or both."""

    CAR = "car"
    MOTION = "by-motion"
    BOTH = "both"


@dataclass(frozen=True, kw_only=True)
class StudyFigure:
    """A figure of a design.

    Attributes:
        code: name in studies and tables, with its unit at the end.
        meaning: a phrase.
        of: function that computes it, a finite number; a function of a module, so that other processes find it.
        more: whether a greater figure is better.
        resolution: differences below it are those of rounding and search, and make no design better.
        cheap: whether it takes milliseconds; a limit on it then screens, and nothing else of the design is computed.
        scope: designs that have it.
    """

    code: str
    meaning: str
    of: Callable[[Evaluated], float]
    more: bool = False
    resolution: float = 0.0
    cheap: bool = False
    scope: FigureScope = FigureScope.BOTH

    def aim(self, value: float) -> float:
        """A value in the figure's own unit, rounded to its resolution, with the sign by which less is better.

        Args:
            value: value of the figure, a number in its own unit.
        """
        seen = round(value / self.resolution) * self.resolution if self.resolution else value
        return -seen if self.more else seen


# Greatest distance between the points of an outline whose diameter is taken, mm: the radius then errs by 1e-5 mm.
_STEP = 0.1
_DRIFT_STEPS = 720  # of a turn: the drift errs by some 0.01 %

_FIGURES: Registry[StudyFigure] = Registry(Message("figure"), ())
register, remove, codes, kind_of, has = (
    _FIGURES.register,
    _FIGURES.remove,
    _FIGURES.codes,
    _FIGURES.kind_of,
    _FIGURES.has,
)
_Computation = Callable[[Evaluated], float]


def _figure(
    code: str, meaning: str, resolution: float = 0.0, scope: FigureScope = FigureScope.BOTH, **marks: bool
) -> Callable[[_Computation], _Computation]:
    """Register the decorated function as the figure of a code."""

    def registered(of: _Computation) -> _Computation:
        register(StudyFigure(code=code, meaning=meaning, of=of, resolution=resolution, scope=scope, **marks))
        return of

    return registered


@_figure("worst_end_mm", "worst position error at the end over the band of play", 0.1, FigureScope.CAR)
def _worst_end(evaluated: Evaluated) -> float:
    return comparison_of(evaluated.plan).chosen.band.worst_distance


@_figure("worst_end_heading_deg", "worst heading error at the end over the band of play", 1e-3, FigureScope.CAR)
def _worst_heading(evaluated: Evaluated) -> float:
    return degrees(comparison_of(evaluated.plan).chosen.band.worst_heading)


@_figure("passed_percent", "share of random cars that keep the course", scope=FigureScope.CAR, more=True)
def _passed(evaluated: Evaluated) -> float:
    share = evaluated.tolerance.passed
    if share is None:
        raise DesignError("passed_percent counts cars that keep the course: add [course], or take another figure")
    return 100 * share


@_figure("disc_diameter_mm", "diameter of the circle about the camshaft that holds the disc", 0.01)
def _diameter(evaluated: Evaluated) -> float:
    plan = evaluated.plan
    if plan.groove is not None:
        return 2 * plan.groove.outside_radius
    return 2 * max(float(np.linalg.norm(disc.curve.outline(_STEP).points, axis=1).max()) for disc in plan.discs)


@_figure("disc_mass_g", "mass of the disc without its hub", 0.01)
def _mass(evaluated: Evaluated) -> float:
    """Area less bore and holes, times thickness and density."""
    plan = evaluated.plan
    material = plan.making.material
    if material is None:
        raise DesignError("the mass of the disc needs its material: add blank.material, such as aluminium")
    if plan.groove is not None:
        return (plan.volume - plan.blank.hub_volume()) * DENSITY[material] * 1e-3
    return sum(disc.blank.disc_volume(disc.area, disc.thickness) for disc in plan.discs) * DENSITY[material] * 1e-3


@_figure("holding_energy_J", "energy in a turn of the cam that the drag takes which holds it", 1e-4, FigureScope.CAR)
def _energy(evaluated: Evaluated) -> float:
    comparison = comparison_of(evaluated.plan)
    if comparison.task.mechanics is None:
        raise DesignError("the energy that holds the cam needs the rod's force: add [mechanics] with rod_force_N")
    return holding(comparison.chosen.lift, comparison.task.mechanics).energy


@_figure("return_error_deg", "greatest return error at the camshaft", 1e-4, FigureScope.CAR, cheap=True)
def _return_error(evaluated: Evaluated) -> float:
    return degrees(evaluated.band.ends[1])


@_figure("cutting_time_min", "time that the programs for the mill move at a feed", 0.01)
def _minutes(evaluated: Evaluated) -> float:
    """Cuts, leads, plunges, tabs and drills, by their own moves."""
    plan = evaluated.plan
    if plan.groove is not None:
        raise DesignError("cutting_time_min is of discs that are milled along their rim, and this one has a groove")
    machining, material = plan.making.machining, plan.making.material
    return sum(
        milling_minutes(disc.curve.length(), machining, disc.thickness, material)
        + drilling_minutes(disc.made_blank, machining, disc.thickness, material)
        for disc in plan.discs
    )


@_figure("pressure_angle_deg", "greatest pressure angle, of either sign", 1e-3)
def _pressure_angle(evaluated: Evaluated) -> float:
    return max(
        check.value
        for disc in evaluated.plan.discs
        for check in disc.checks
        if check.code in (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN)
    )


@_figure("least_radius_mm", "least convex radius of the profile", 1e-3, more=True)
def _least_radius(evaluated: Evaluated) -> float:
    radii = [
        check.value
        for disc in evaluated.plan.discs
        for check in disc.checks
        if check.code == CheckCode.CONVEX_RADIUS_PROFILE
    ]
    return min(radii)


@_figure("contact_pressure_MPa", "greatest pressure in the line of contact, after Hertz", 0.01, FigureScope.MOTION)
def _contact_pressure(evaluated: Evaluated) -> float:
    return _of_forces(evaluated, CheckCode.CONTACT_PRESSURE)


@_figure("camshaft_torque_Nmm", "greatest torque of the camshaft, of either sign", 0.01, FigureScope.MOTION)
def _torque(evaluated: Evaluated) -> float:
    return max(abs(_of_forces(evaluated, code)) for code in (CheckCode.TORQUE_GREATEST, CheckCode.TORQUE_LEAST))


@_figure(
    "least_force_N", "least force on the disc, below which the follower leaves", 1e-3, FigureScope.MOTION, more=True
)
def _least_force(evaluated: Evaluated) -> float:
    return _of_forces(evaluated, CheckCode.FORCE_LEAST)


def _of_forces(evaluated: Evaluated, code: CheckCode) -> float:
    found = [check.value for check in evaluated.plan.figures if check.code == code]
    if not found:
        raise DesignError(
            "{code} is no figure of this cam: it needs [dynamics], and a follower that a spring presses on its disc",
            code=code.value,
        )
    return found[0]


@_figure("drift_mm", "end of the run by half of the band of play, to first order", 0.1, FigureScope.CAR, cheap=True)
def _drift(evaluated: Evaluated) -> float:
    """End of the run by play, to first order: closed, and so cheap enough to screen thousands of designs.

    A cam that is cut for the middle of the band errs by half of the band's width d at either end. On a fall the car
    then meets its turning rate f(theta + d) for f(theta). So a piece of the fall turns it by d df more, about the place
    Q where that happens. It moves the end E of the run by d df J (E - Q), J a quarter turn:

        drift = d | sum over all falls of df J (E - Q) |.

    The exact chain adds what is of higher order, what smoothing gains, and the jumps. On the paper's car this gives
    within 1 % of the exact chain's worst end.
    """
    design, lift = evaluated.design, evaluated.lift
    car, length = cam_model.car(design), cam_model.travel(design, evaluated.track)
    run = drive(lift, car, length, steps=_DRIFT_STEPS * turns_of(lift.blend_start))
    turning = length / TURN * track_curvature(run.tan_beta, car) * travel_ratio(run.tan_beta, car)
    place = run.drive_wheel @ np.array([1.0, 1j])
    lever = place[-1] - (place[1:] + place[:-1]) / 2
    falling = np.diff(run.tan_beta) < 0
    low, high = evaluated.band.ends
    return (high - low) / 2 * float(abs(np.sum(np.diff(turning)[falling] * lever[falling])))
