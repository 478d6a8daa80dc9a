"""Proposal of a gear train for a new car: from its wheel, the length of its path and its sizes.

With the wheel of the outline a turn of the cam must take the whole path before the closing blend begins:
    i = l / (1 - blend / 360°) / (π D),  at most 3 % more,
with l the length of the drive wheel's track and D the wheel's diameter. Of the trains with such a ratio those with the
least return error, estimated by its share of each stage, are laid out in the car, until one clears all parts. A brake
on the disc that keeps the cam on its gears is proposed with it: then the play does nothing. Where the base radius of
the template is too small for the pressure angle, a larger one is proposed, too.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from math import ceil, pi, radians
from pathlib import Path

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.against_play.remedies import holding
from cadgen.check import Check, CheckCode, failing
from cadgen.design import cam_model, variation
from cadgen.design.begin import BASE_RADIUS, ProposedTrain, WithTrain
from cadgen.design.load import design_of
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.jobs.car_frame import car_frame
from cadgen.jobs.car_layout import layout_of
from cadgen.messages import Message

_MOST_OVER = 1.03  # of the ratio over that with which the blend begins where the path ends
_SAME_WHEEL = 0.01  # share by which the wheel of a lap, which follows from the ratio, may differ from the outline's
_DRIVERS, _DRIVEN = (30, 32, 36, 40), tuple(range(50, 161, 5))
_LAST_DRIVEN = (60, 160)
# Numbers of stages in the order in which they are tried, with the most trains that are laid out. An odd one turns the
# cam against the wheel. One of four takes some 3 s, since its stages turn in many ways.
_MOST_LAID_OUT = {3: 60, 2: 60, 4: 10, 1: 60}
_STATIONS = 7200
_LARGER = (0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0)  # mm by which the base radius is raised
# Keys of a frame that are tried, the sturdiest first.
_FRAMES = ("", 'screws = "M2.5"\n', "base_thickness_mm = 5.0\n", 'screws = "M2"\n', "base_thickness_mm = 3.0\n")
_ANGLE_RESERVE = radians(1.0)  # for the lean of the rod, which the formula leaves aside
_ANY = ProposedTrain(((30, 150), (40, 120), (40, 120)), None)


@dataclass(frozen=True)
class _Ratio:
    """Ratios that a train may have."""

    least: float
    most: float


def proposed(text: WithTrain, name: str) -> str:
    """Text of a new design with a train that fits its car.

    Args:
        text: text of the design for a proposed train.
        name: name of the design.

    Raises:
        DesignError: the outline says no wheel, the path cannot be driven, or no train was found that fits.
    """
    file = Path(f"{name}.toml")
    design = design_of(text(_ANY), file)  # for its path and sizes, which no train changes
    outline = design.car.outline
    wheel = None if outline is None else outline.wheel_diameter_mm
    if wheel is None:
        raise DesignError(
            "a train is proposed for the drive wheel, and car.outline.wheel_diameter_mm is not given: give it, or "
            "leave the proposal out"
        )
    track = cam_model.track(design)
    cam_model.lift(design, track)  # refuses a path that no wheel makes drivable
    around = pi * wheel
    if track.closed:
        lap = track.turn_laps * track.length / around
        ratio = _Ratio(lap * (1 - _SAME_WHEEL), lap * (1 + _SAME_WHEEL))
    else:
        least = track.length / (1 - design.cam.blend_deg / 360) / around
        ratio = _Ratio(least, least * _MOST_OVER)
    _refuse_low_axle(design, wheel)
    nearest: tuple[int, tuple[Check, ...]] | None = None
    tried = 0
    for count, most in _MOST_LAID_OUT.items():
        for teeth in islice(_trains(ratio, count), most):
            tried += 1
            train = ProposedTrain(teeth, None if track.closed else wheel / 2)
            try:
                train = train._replace(base_radius=_base_radius(design_of(text(train), file)))
                wrong = failing(layout_of(design_of(text(train), file)).plain_checks)
            except DesignError:  # its gears leave no room for their bores
                continue
            if not wrong:
                # With the first frame that holds the car; without one where none does.
                framed = (train._replace(frame=keys) for keys in _FRAMES)
                holding = (each for each in framed if not failing(car_frame(design_of(text(each), file)).plain_checks))
                train = next(holding, train)
                return text(train._replace(drag=_holding_drag(design_of(text(train), file))))
            if nearest is None or _far(wrong) < _far(nearest[1]):
                nearest = count, wrong
    if nearest is None:
        raise DesignError(
            "no train of one to four stages brings a wheel of {wheel:g} mm to the path of {length:.0f} mm: change "
            "car.outline.wheel_diameter_mm, or leave the proposal out",
            wheel=wheel,
            length=track.length,
        )
    count, wrong = nearest
    raise DesignError(
        "none of the {tried} trains that were tried fits the car; the nearest, of {count} stages, fails {name}: "
        "{value}{place}, where {limit:g} is asked for; raise train.module_mm, change the sizes of the car, or leave "
        "the proposal out",
        tried=tried,
        count=count,
        name=wrong[0].name,
        value=wrong[0].text(),
        place=Message(" ({place})", place=wrong[0].place) if wrong[0].place else "",
        limit=wrong[0].limit,
    )


def _refuse_low_axle(design: Design, wheel: float) -> None:
    """Refuse a wheel whose axle is too low for the smallest pinion: it clears the floor at no place of the train."""
    try:
        layout = layout_of(design)
    except DesignError:  # said of the trains, if it is so of all
        return
    least = 2 * (max(gear.radius for gear in layout.gears[0]) + layout.site.floor_clearance)
    if wheel < least:
        raise DesignError(
            "car.outline.wheel_diameter_mm is {wheel:g}, and the smallest pinion on its axle, of {teeth} teeth, needs "
            "a wheel of at least {least:.4g} mm to clear the floor by {clearance:g} mm: take a larger wheel",
            wheel=wheel,
            teeth=_DRIVERS[0],
            least=least,
            clearance=layout.site.floor_clearance,
        )


def _far(wrong: tuple[Check, ...]) -> tuple[bool, int, float]:
    """Whether the train is too short, how many checks fail, and by how much the first does."""
    short = any(check.code == CheckCode.AXLE_REACHED for check in wrong)
    return short, len(wrong), abs(wrong[0].value - wrong[0].limit)


def _base_radius(design: Design) -> float | None:
    """Base radius of the template, or as much more as keeps the pressure angle, mm; None where the design has its own.

    The pressure angle is that of the lift s on a disc of base radius a, tan(alpha) = s' / (a + s).
    """
    now = design.cam.base_radius_mm
    if now != BASE_RADIUS:
        return None
    lift, limits = cam_model.lift(design), cam_model.check_limits(design).pressure_angle
    rod = cam_model.leaning(design, "the base radius of a new car")
    theta = np.linspace(0.0, min(lift.blend_start, TURN), _STATIONS)
    tangents = lift.q(theta)
    s, slope = rod.lift(tangents), rod.contact_face(tangents) * lift.q(theta, nu=1)
    for more in _LARGER:
        angle = np.arctan2(slope, now + more + s)
        if angle.max() <= limits.rise - _ANGLE_RESERVE and -angle.min() <= limits.fall - _ANGLE_RESERVE:
            return now + more
    return now


def _holding_drag(design: Design) -> float:
    """Torque of a brake on the disc that keeps the cam on its gears, N mm: a quarter more than the cam needs."""
    lift = cam_model.lift(design)
    band = variation.mechanics(design, cam_model.follower(design), lift)
    return 0.0 if band is None else float(ceil(holding(lift, band).drag))


def _trains(ratio: _Ratio, count: int) -> Iterator[tuple[tuple[int, int], ...]]:
    """Trains of a number of stages within a ratio, the least return error first; drivers before driven gears.

    The play of a stage is nearly the same arc for all gears. Its angle at the camshaft goes with one over the teeth of
    its driven gear, and over the ratio behind it. The sum over the stages, and a little for their size, ranks.
    """
    pairs = np.array([(z1, z2) for z1 in _DRIVERS for z2 in _DRIVEN if 1 < z2 / z1 <= 6])
    before = pairs[:0] if count == 1 else pairs
    chosen = np.zeros((1, 0, 2), dtype=int)
    for _ in range(count - 1):
        chosen = np.concatenate(
            [np.repeat(chosen, len(before), axis=0), np.tile(before[:, None], (len(chosen), 1, 1))], 1
        )
        # Ratios rise from stage to stage: the last counts most for the return error.
        ratios = chosen[..., 1] / chosen[..., 0]
        chosen = chosen[(np.diff(ratios, axis=1) >= 0).all(axis=1)] if chosen.shape[1] > 1 else chosen
        total = np.prod(chosen[..., 1] / chosen[..., 0], axis=1)
        chosen = chosen[total <= ratio.most]
    found: list[tuple[float, tuple[tuple[int, int], ...]]] = []
    for last in _DRIVERS:
        so_far = np.prod(chosen[..., 1] / chosen[..., 0], axis=1)
        teeth = np.ceil(ratio.least * last / so_far - 1e-9)
        fits = (teeth / last * so_far <= ratio.most) & (teeth >= _LAST_DRIVEN[0]) & (teeth <= _LAST_DRIVEN[1])
        for stages, driven in zip(chosen[fits].tolist(), teeth[fits].astype(int).tolist(), strict=True):
            train = (*(tuple(pair) for pair in stages), (last, driven))
            behind, error = 1.0, 0.0
            for driver, driven_teeth in reversed(train):
                error += 1 / (driven_teeth * behind)
                behind *= driven_teeth / driver
            found.append((error + 1e-5 * sum(map(sum, train)), train))
    return (train for _, train in sorted(found))
