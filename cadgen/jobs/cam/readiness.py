"""Readiness of a car's cam: how many cars keep the course, and what holds the cam back, with its cost and its cure.

The cars are the same in every command: `SAMPLE` of them, drawn from the seed `SEED`. So a verdict depends on the design
and its profile alone.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import ceil, degrees, nan
from typing import Protocol

import numpy as np

from cadgen.arrays import TURN
from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.car.steering import Car
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.design import variation
from cadgen.design.schema import Design
from cadgen.deviations.deviation import RETURN_ERROR, Deviation
from cadgen.errors import DesignError
from cadgen.figures import Figure
from cadgen.inference.monte_carlo.cars import Cars
from cadgen.inference.monte_carlo.course_margins import CourseMargins, FinishItem
from cadgen.inference.monte_carlo.random_cars import Tolerances, margins_of_cars, most_moving
from cadgen.jobs.cam.comparison import NEARER, Refused
from cadgen.jobs.cam.wheel import DriveWheel
from cadgen.jobs.nominal_car import VariedCar, watched_cars
from cadgen.messages import Message
from cadgen.verdict import Reservation

SAMPLE, SEED = 1000, 1  # the standard error of a share of 25 % is 1.4 %, of one of 90 % it is 0.9 %
# Of the tolerances that move the cars most some are tried as a cure, which less than a percent of the cars is not.
_TRIED, _FIRST, _WORTH = 3, 300, 1.0
GOOD_YIELD = 90.0  # %; below it the cars that are lost are a reservation
# Relative difference of the outline's drive wheel from the wheel that the cam is for: up to the first it is rounding,
# beyond the second the outline is of another car.
WHEEL_SAME, WHEEL_OTHER = 0.02, 0.25
# Radius of a drive wheel as a share of the wheelbase: no car stands on smaller wheels, and a larger one reaches past
# the axle of the front wheel.
_LEAST_WHEEL, _MOST_WHEEL = 0.02, 1.0
_SHOWN = 0.5  # mm; less off the end of the path is not worth a sentence


class JudgedCar(VariedCar, Protocol):
    """Car of a design on which a verdict is given."""

    @property
    def design(self) -> Design:
        """Design of the car."""

    @property
    def car(self) -> Car:
        """The car in plan view."""

    @property
    def drive_wheel(self) -> DriveWheel:
        """Drive wheel that the cam is for."""

    @property
    def outlined_wheel(self) -> float | None:
        """Diameter of the drive wheel in the car's outline, mm; None if it is not said."""

    @property
    def travel(self) -> float:
        """Travel of the drive wheel's rim for one turn of the cam, mm."""

    @property
    def play_known(self) -> bool:
        """Whether the design says how much play the gears have."""

    @property
    def sense(self) -> Reservation | None:
        """Reservation on a train that turns the cam the other way round; None if it does not."""

    @property
    def unplaced(self) -> Reservation | None:
        """Reservation on a train that does not fit the car, which is not laid out; None if nothing is known of that."""

    @property
    def least_yield(self) -> float:
        """Least share of random cars that must keep the course, %."""

    def tolerances(self) -> Tolerances:
        """How cars of the design may differ."""


@dataclass(frozen=True)
class CourseYield:
    """Cars that keep the course of their design.

    Attributes:
        percent: share of the cars that keep all of it.
        binding: key of the part of the course that the fewest cars keep.
        binding_percent: share of the cars that keep that part.
        cure: what brings more cars in, in a clause; empty where enough are.
    """

    percent: float
    binding: str
    binding_percent: float
    cure: str = ""


def course_yield(use: JudgedCar, cut: ClosedCurve) -> CourseYield | None:
    """Share of random cars that keep the course; None without a course, or where the play is not known.

    Args:
        use: car with its comparison under play.
        cut: curve that its cam is cut to, mm.

    Raises:
        DesignError: a tolerance is too large for first order.
    """
    if use.course is None or use.comparison is None:
        return None
    cars = watched_cars(use, cut)
    if not cars.items:
        return None
    met = margins_of_cars(cars, use.tolerances(), SAMPLE, seed=SEED)
    kept = met.margins >= 0
    each = kept.mean(axis=1)
    least = int(np.argmin(each))
    percent = 100 * float(kept.all(axis=0).mean())
    cure = ""
    if percent < GOOD_YIELD:
        cure = _trim(use, cars) or _tighter(cars, use.tolerances(), least, percent, _room(met, least))
    return CourseYield(percent, cars.items[least].key, 100 * float(each[least]), cure)


def not_counted(error: DesignError, least: float) -> Check:
    """Check that fails, for nobody knows how many cars keep the course.

    Args:
        error: what stands in the way of a count, with its cure.
        least: least share that is allowed, %.
    """
    name, place = Message("cars that keep the course"), Message("cannot be counted")
    return Check(CheckCode.CARS_KEEP_COURSE, name, nan, "%", least, Bound.MIN, place, error.message)


def yield_check(use: JudgedCar, found: CourseYield) -> Check:
    """Check of the share of cars that keep the course.

    Args:
        use: car that the cam steers.
        found: cars that keep the course.
    """
    # Part of the course that the fewest cars keep.
    binds = Message("{key}, which {share:.1f} % keep", key=found.binding, share=found.binding_percent)
    if found.binding_percent >= 100:
        binds = Message("every part of it")
    return Check(
        CheckCode.CARS_KEEP_COURSE,
        Message("cars that keep the course"),
        found.percent,
        "%",
        use.least_yield,
        Bound.MIN,
        binds,
        _better_profile(use) or found.cure,
    )


def _better_profile(use: JudgedCar) -> Message | None:
    """Advice to mend what refuses a profile that ends much nearer, or to take it; None if there is none."""
    comparison = use.comparison
    if comparison is None:
        return None
    off = comparison.chosen.band.worst_distance
    if comparison.nearer is not None:
        return Message("{nearer}: mend that first", nearer=_refused(comparison.nearer, off))
    if all(each.profile == ACTUAL for each in comparison.evaluations) and off > _SHOWN:
        return Message(
            "the play takes the car up to {off:.0f} mm off, and the plain profile does nothing against it: cadgen "
            "optimize compares it with those that do",
            off=off,
        )
    ends = {each.band.worst_distance: each for each in comparison.evaluations}
    nearest = ends[min(ends)]
    if nearest.band.worst_distance < off * NEARER:
        return Message(
            "the {nearest} ends {near:.0f} mm off at most, and this one {off:.0f}: cadgen optimize compares them, and "
            "says what refuses which",
            nearest=nearest.title,
            near=nearest.band.worst_distance,
            off=off,
        )
    return None


def _refused(nearer: Refused, off: float) -> Message:
    """Clause on a refused profile: where it ends beside the chosen one, and which checks fail."""
    return Message(
        "the {nearest} ends {near:.0f} mm off at most, and this one {off:.0f}, but it fails {failed}",
        nearest=nearer.evaluation.title,
        near=nearer.evaluation.band.worst_distance,
        off=off,
        failed=nearer.names,
    )


def _trim(use: JudgedCar, cars: Cars) -> Message | None:
    """Trim after a trial run as a cure, where a brake holds the cam and enough cars then keep the course."""
    if variation.trimmed(use.design) or not variation.braked(use.design):  # else the trim may choose another cam
        return None
    met = margins_of_cars(cars, variation.trimmed_off(use.design, use.tolerances()), SAMPLE, seed=SEED).margins >= 0
    kept = 100 * float(met.all(axis=0).mean())
    if kept < GOOD_YIELD:
        return None
    return Message(
        'set optimize.hardware to ["trim"], a trial run after which the micrometer of the base radius is set: '
        "{kept:.1f} % then keep the course",
        kept=kept,
    )


def _room(met: CourseMargins, number: int) -> Message:
    """Cure that gives cars more room at an item of the course, in a clause; at the finish it is counted.

    Args:
        met: course as the cars meet it.
        number: number of the item that the fewest cars keep.
    """
    item = met.items[number]
    if not isinstance(item, FinishItem):
        gate = item.key.partition(",")[0]  # of each lap
        return Message("lead the path with more room past {key}", key=gate)
    places, turned = met.places[number], met.turned[number]
    others = (np.delete(met.margins, number, axis=0) >= 0).all(axis=0)

    def percent(finish: FinishItem) -> float:
        return 100 * float(np.mean(others & (finish.margin(places, turned) >= 0)))

    now = percent(item)
    middle = percent(replace(item, stop=complex(item.places[0])))
    any_way = percent(replace(item, heading=None))
    if item.heading is not None and any_way > max(now, middle) + _WORTH:
        off, most = item.heading
        return Message(
            "let the path end in the direction of {key}.heading_deg, from which it is {off:.1f}° off where {most:g}° "
            "are allowed",
            key=item.key,
            off=degrees(abs(off)),
            most=degrees(most),
        )
    if middle > now + _WORTH:
        return Message(
            "let the path end in the middle of {key}, from which it is {off:.1f} mm away, with which {kept:.1f} % keep "
            "the course",
            key=item.key,
            off=abs(complex(item.places[0]) - item.stop),
            kept=middle,
        )
    reach = ceil(np.quantile(np.abs(places[:, 0] - item.stop), 0.005 + GOOD_YIELD / 100))
    return Message(
        "raise {key}.radius_mm to {reach}, with which {kept:.1f} % keep the course",
        key=item.key,
        reach=reach,
        kept=percent(replace(item, reach=float(reach))),
    )


def _tighter(cars: Cars, tolerances: Tolerances, number: int, percent: float, room: Message) -> Message:
    """Cure for cars that are lost: half of a tolerance or of the spread of the play, counted with it; else more room.

    Args:
        cars: nominal car with the items of its course.
        tolerances: how cars differ.
        number: number of the item that the fewest cars keep.
        percent: share of the cars that keep the course, %.
        room: what else gives the cars more room, in a clause.
    """

    def kept_with(halved: Deviation, samples: int) -> float:
        margins = margins_of_cars(cars, tolerances.halved(halved, cars.play), samples, seed=SEED).margins
        return 100 * float((margins >= 0).all(axis=0).mean())

    moving = [name for name in most_moving(cars, tolerances, number) if name == RETURN_ERROR or name.tolerance_key]
    # The first cars tell which is best; all of them, what is said of it.
    best, kept = None, -1.0
    for name in moving[:_TRIED]:
        share = kept_with(name, _FIRST)
        if share > kept:
            best, kept = name, share
        if kept >= GOOD_YIELD:
            break
    if best is None or (kept := kept_with(best, SAMPLE)) <= percent + _WORTH:
        return room
    if best == RETURN_ERROR:
        return Message(
            "take gears whose play varies half as much, with which {kept:.1f} % keep the course, or {room}",
            kept=kept,
            room=room,
        )
    now = tolerances.half_widths[best] * (degrees(1.0) if best.unit == "rad" else 1.0)
    return Message(
        "hold tolerances.{key} at {half:.3g} in place of {now:.3g}, with which {kept:.1f} % keep the course, or {room}",
        key=best.tolerance_key,
        half=now / 2,
        now=now,
        kept=kept,
        room=room,
    )


def wheel_checks(use: JudgedCar) -> tuple[Check, ...]:
    """Check of the drive wheel that the cam needs: of its size, and against the one in the car's outline.

    Args:
        use: car that the cam steers.
    """
    radius, base = use.drive_wheel.radius, use.car.wheelbase
    if radius is None:
        return ()
    outlined = use.outlined_wheel
    advice = Message(
        "change the ratio of [train], the wheel or the length of the path; the search of cadgen gears finds teeth"
    )
    size = Check(
        CheckCode.DRIVE_WHEEL_GREATEST,
        Message("drive wheel that the path needs"),
        2 * radius,
        "mm",
        2 * base * _MOST_WHEEL,
        place=Message("a larger one reaches past the front axle"),
        advice=advice,
    )
    least = replace(
        size,
        code=CheckCode.DRIVE_WHEEL_LEAST,
        name=Message("least drive wheel"),
        limit=2 * base * _LEAST_WHEEL,
        bound=Bound.MIN,
        place=Message("{share:g} of the wheelbase", share=2 * _LEAST_WHEEL),
    )
    if outlined is None:
        return (size, least)
    ratio = use.travel / (TURN / 2 * outlined)
    drawn = Check(
        CheckCode.DRIVE_WHEEL_OUTLINE,
        Message("drive wheel against the outline"),
        abs(2 * radius - outlined) / outlined * 100,
        "%",
        100 * WHEEL_OTHER,
        place=Message(
            "the cam is for a wheel of {needed:.1f} mm, car.outline.wheel_diameter_mm is {outlined:g}",
            needed=2 * radius,
            outlined=outlined,
        ),
        advice=Message(
            "take a [train] of {ratio:.2f} turns of the drive wheel to one of the cam, or set "
            "car.outline.wheel_diameter_mm to {needed:.1f} if the car can have that wheel",
            needed=2 * radius,
            ratio=ratio,
        ),
    )
    return (size, least, drawn)


def reservations(use: JudgedCar, found: CourseYield | None) -> Iterator[Reservation]:
    """Reservations on a cam whose checks hold: what costs accuracy or cars, or is left open.

    Args:
        use: car that the cam steers.
        found: cars that keep the course; None where that is not known.
    """
    if found is not None and use.least_yield <= found.percent < GOOD_YIELD:
        yield Reservation(
            "cars-lost",
            Message(
                "{lost:.1f} % of the cars leave the course, most of them at {key}",
                lost=100 - found.percent,
                key=found.binding,
            ),
            found.cure,
            Figure("cars_lost", Message("cars lost"), 100 - found.percent, "%"),
        )
    comparison = use.comparison
    if use.course is not None and found is not None and not any(use.tolerances().half_widths.values()):
        yield Reservation(
            "tolerances-not-stated",
            Message("no tolerance is stated, so the cars that were counted differ by their play alone"),
            Message("say in [tolerances] what the workshop holds; cadgen new writes usual ones"),
        )
    if comparison is None and not use.play_known:
        yield Reservation(
            "play-not-stated",
            Message("the play of the gears is not stated, and where the car ends depends on it"),
            Message("give [train], or the play measured at the camshaft in [play]"),
        )
    if comparison is not None and comparison.rubs > 0:
        worst = comparison.rubs
        yield Reservation(
            "friction-not-stated",
            Message("friction is not stated; a rod that rubs takes the car up to {worst:.0f} mm off", worst=worst),
            Message("say in [mechanics] what the car has, and cadgen optimize compares what helps"),
            Figure("friction", Message("off with friction"), worst, "mm"),
        )
    if comparison is not None and comparison.nearer is not None:
        off, near = (each.band.worst_distance for each in (comparison.chosen, comparison.nearer.evaluation))
        yield Reservation(
            "nearer-profile-refused",
            _refused(comparison.nearer, off),
            Message(
                "mend that; cadgen check with --profile {code} says where",
                code=comparison.nearer.evaluation.profile.code,
            ),
            Figure("further_off", Message("further off the finish"), off - near, "mm"),
        )
    yield from _on_blend(use)
    radius, outlined = use.drive_wheel.radius, use.outlined_wheel
    if (
        radius is not None
        and outlined is not None
        and WHEEL_SAME * outlined < abs(2 * radius - outlined) <= WHEEL_OTHER * outlined
    ):
        yield Reservation(
            "wheel-of-outline",
            Message(
                "the cam is for a drive wheel of {needed:.1f} mm, and the outline has one of {outlined:g} mm",
                needed=2 * radius,
                outlined=outlined,
            ),
            Message("set car.outline.wheel_diameter_mm to {needed:.1f}", needed=2 * radius),
        )
    yield from filter(None, (use.sense, use.unplaced))


def _on_blend(use: JudgedCar) -> Iterator[Reservation]:
    """Reservations on a closing blend that steers the last of the path: where it ends, what the car misses there."""
    wheel = use.drive_wheel
    if wheel.blend is None:
        return
    cure = (
        Message("give [train]; then car.drive_wheel_radius_mm can put the blend behind the path")
        if wheel.radius is None
        else Message(
            "set car.drive_wheel_radius_mm to {radius:.2f}, for a wheel with which the path ends before the blend",
            radius=ceil(100 * wheel.radius * TURN / wheel.finish) / 100,
        )
    )
    if wheel.blend.off > _SHOWN:
        yield Reservation(
            "blend-on-path",
            Message(
                "the closing blend steers the last {stretch:.0f} mm, and ends {off:.1f} mm and {turned:.1f}° off the "
                "path's end",
                stretch=wheel.blend.stretch,
                off=wheel.blend.off,
                turned=degrees(abs(wheel.blend.turned)),
            ),
            cure,
            Figure("blend_off", Message("off the path's end"), wheel.blend.off, "mm"),
        )
    behind = use.course.planned.blend if use.course is not None else None
    missed = {} if behind is None else {key: room for key, (_, room) in behind.figures().items() if room < 0}
    if missed:
        worst = min(missed, key=missed.__getitem__)
        yield Reservation(
            "course-on-blend",
            Message(
                "on the closing blend, where the course is not judged, the car misses or meets {key} by {room:.1f} mm",
                key=worst,
                room=-missed[worst],
            ),
            cure,
            Figure("course_on_blend", Message("off the course on the blend"), -missed[worst], "mm"),
        )
