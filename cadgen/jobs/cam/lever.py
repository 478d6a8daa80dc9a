"""Longer lever as a remedy: disc and lever are enlarged alike, and every error of the lift turns the wheel less.

The lift is lever times tan(beta). With lever and base radius longer by one factor the cam keeps its pressure angles,
and play does what it did; a micrometre of disc, rod or micrometer head turns the front wheel less by that factor.
"""

from dataclasses import replace

from cadgen.check import failing
from cadgen.curves.closed import ClosedCurve
from cadgen.design.load import with_overrides
from cadgen.design.schema import Design
from cadgen.deviations.deviation import (
    BASE_RADIUS,
    ECCENTRIC_BORE,
    EDGE_BREAK,
    EDGE_WEAR,
    INNER_FACE,
    OUTER_FACE,
    PROFILE_OFFSET,
    ROD_BENDING,
    ROD_RADIUS,
    TAPER,
    WOBBLE,
)
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.random_cars import margins_of_cars
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.readiness import GOOD_YIELD, SAMPLE, SEED, JudgedCar
from cadgen.jobs.cam.remedies import Remedy, remedies
from cadgen.jobs.cam.steering_cam import CarUse, comparison_of
from cadgen.jobs.car_layout import laid_out
from cadgen.jobs.nominal_car import watched_cars
from cadgen.messages import Message, joined
from cadgen.progress import Progress, silent

LONGER = 1.4  # times the lever and the base radius
# Deviations whose effect on the steering falls as the lever grows.
_OF_THE_LIFT = {
    *(BASE_RADIUS, INNER_FACE, OUTER_FACE, ROD_RADIUS, PROFILE_OFFSET, EDGE_BREAK, EDGE_WEAR, TAPER),
    *(ECCENTRIC_BORE, WOBBLE, ROD_BENDING),
}


def remedies_of(plan: CamPlan, progress: Progress = silent) -> tuple[Remedy, ...]:
    """Sheet of remedies for the car of a cam, a longer lever among them.

    Args:
        plan: cam with its profiles against play.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the design has no [mechanics].
    """
    use = CarUse.of(plan)
    sheet = remedies(use.design, comparison_of(plan), progress)
    return (*sheet, *longer_lever(use.design, use, plan.curve, sheet[0]))


def longer_lever(design: Design, use: JudgedCar, cut: ClosedCurve, now: Remedy) -> tuple[Remedy, ...]:
    """Row of the sheet of remedies for a longer lever; none where no cars are counted or enough keep the course.

    Args:
        design: loaded design.
        use: its car, compared under play.
        cut: curve that its cam is cut to, mm.
        now: row of the design as it is.
    """
    overrides = _overrides(design)
    if use.course is None:
        return ()
    try:
        layout = laid_out(with_overrides(design, overrides))
        cars, tolerances = watched_cars(use, cut), use.tolerances()
        if not cars.items:
            return ()
        shares = []
        for factor in (1.0, LONGER):
            widths = {
                each: half / factor if each in _OF_THE_LIFT else half for each, half in tolerances.half_widths.items()
            }
            met = margins_of_cars(cars, replace(tolerances, half_widths=widths), SAMPLE, seed=SEED)
            shares.append(100 * float((met.margins >= 0).all(axis=0).mean()))
    except DesignError:
        return ()
    if shares[0] >= GOOD_YIELD:
        return ()
    build = Message(
        "an error of disc, rod or micrometer then turns the front wheel less, so that some {percent:.0f} % of the cars "
        "keep the course, not {before:.0f}; play moves the end as before: {changes}",
        percent=shares[1],
        before=shares[0],
        changes=" ".join(f"--set {override}" for override in overrides),
    )
    if layout is not None and (wrong := failing(layout.plain_checks)):
        room = Message(
            "first give its parts room, for {name} is then {value} ({place})",
            name=wrong[0].name,
            value=wrong[0].text(),
            place=wrong[0].place,
        )
        build = joined((room, build), "; ")
    return (replace(now, name=Message("lever and disc {factor:g} times as large", factor=LONGER), build=build),)


def _overrides(design: Design) -> list[str]:
    """Changes of the design's keys that make lever, base radius and rod longer."""
    cam, rod = design.cam, design.follower
    moved = (LONGER - 1) * sum(cam.faces_mm) / 2
    given = {key: getattr(cam, key) for key in ("inner_face_mm", "outer_face_mm", "mid_plane_mm")}
    places = {f"cam.{key}": value + moved for key, value in given.items() if value is not None}
    length = getattr(rod, "length_mm", None)
    if length is not None:
        places["follower.length_mm"] = length + moved
    return [f"{key}={value:g}" for key, value in {**places, "cam.base_radius_mm": LONGER * cam.base_radius_mm}.items()]
