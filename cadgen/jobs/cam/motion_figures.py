"""Figures of a motion: greatest velocity, acceleration and jerk with their places, its seams, and its table."""

from collections.abc import Callable, Sequence
from math import degrees, radians

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.checks import cam_place
from cadgen.check import Check, CheckCode
from cadgen.design.load import with_overrides
from cadgen.design.motion import motion_of
from cadgen.design.schema import MotionDesign
from cadgen.figures import Cell, Emphasis, Facts, Sheet, number
from cadgen.laws.lift_table import TableMotion
from cadgen.laws.motion import Motion
from cadgen.laws.segments import Seam, SegmentMotion, polynomial_changes, polynomial_overrides
from cadgen.laws.unit import MM, Unit
from cadgen.messages import Message, joined
from cadgen.verdict import Reservation

_NAMES = (Message("motion"), Message("velocity"), Message("acceleration"), Message("jerk"))
_GREATEST = (
    (CheckCode.MOTION_VELOCITY, Message("greatest velocity")),
    (CheckCode.MOTION_ACCELERATION, Message("greatest acceleration")),
    (CheckCode.MOTION_JERK, Message("greatest jerk")),
)
_POWERS = ("", "", "²", "³")
_MOST_PLACES = 4  # of jumps that a sentence names
_PLACES = 3600  # of a turn at which the least lift is sought
_SMALL = 0.04  # of the base circle's radius; a lift of inches that is taken for mm is less
_SMALL_SWING = radians(1.0)  # in radians that are taken for degrees it is a swing of 57 degrees
_HIGH = 0.02  # of the travel, up to which the least lift is a reading's fault or meant


def checks_of(motion: Motion, speed_rpm: float | None) -> tuple[Check, ...]:
    """Greatest velocity, acceleration and jerk in size, either side of every seam, from what the motion is made of.

    Args:
        motion: motion of the follower.
        speed_rpm: speed of the camshaft, rev/min; None to give them by rad of cam angle.
    """
    length, scale = ("m", 1e-3) if motion.unit == MM and speed_rpm is not None else (motion.unit.symbol, 1.0)
    time, speed = ("rad", 1.0) if speed_rpm is None else ("s", speed_rpm * TURN / 60)
    found = []
    for order, (code, name) in enumerate(_GREATEST, 1):
        peak = motion.greatest(order)
        value, unit = abs(peak.value) * scale * speed**order, f"{length}/{time}{_POWERS[order]}"
        found.append(Check(code, name, value, unit, place=cam_place(peak.cam_angle)))
    return tuple(found)


def facts_of(motion: Motion, speed_rpm: float | None) -> Facts:
    """Facts of a motion: peaks with their places, seams with what jumps there, and what was found of its table.

    Args:
        motion: motion of the follower.
        speed_rpm: speed of the camshaft, rev/min; None if it is not known.
    """
    unit, peaks = motion.unit.symbol, {}
    for order, name in enumerate(("velocity", "acceleration", "jerk"), 1):
        power, peak = "" if order == 1 else str(order), motion.greatest(order)
        peaks[f"greatest_{name}_{unit}_per_rad{power}"] = abs(peak.value)
        peaks[f"greatest_{name}_at_deg"] = degrees(peak.cam_angle)
        if speed_rpm is not None:
            peaks[f"greatest_{name}_{unit}_per_s{power}"] = abs(peak.value) * (speed_rpm * TURN / 60) ** order
    made = Facts(**peaks)
    if isinstance(motion, SegmentMotion):
        made |= Facts(
            vdi_2143=list(motion.vdi),
            jumps=[
                Facts(cam_angle_deg=degrees(seam.cam_angle), derivative=seam.order)
                for seam in motion.seams  # of the velocity or the acceleration
            ],
            seams=[_seam_facts(seam) for seam in motion.joints],
        )
    if isinstance(motion, TableMotion):
        made |= _table_facts(motion)
    return made


def _seam_facts(seam: Seam) -> Facts:
    return Facts(
        cam_angle_deg=degrees(seam.cam_angle),
        segment=seam.segment,
        inside=seam.inside,
        states="".join(seam.states),
        derivative=seam.order,
        before=None if seam.order is None else seam.before,
        after=None if seam.order is None else seam.after,
    )


def _table_facts(motion: TableMotion) -> Facts:
    """Facts of a table: its noise, what smoothing changed, the range of its rows with the figures there, its ramps."""
    unit, change = motion.unit.symbol, motion.smoothing
    facts = Facts(**{f"noise_{unit}": motion.noise, "covered_deg": [degrees(angle) for angle in motion.covered]})
    if change is not None:
        before = f"acceleration_before_smoothing_{unit}_per_rad2"
        facts |= Facts(
            **{f"smoothed_rms_{unit}": change.rms, f"smoothed_most_{unit}": change.most, before: list(change.before)}
        )
    for order, name in enumerate(("velocity", "acceleration"), 1):
        power = "" if order == 1 else str(order)
        facts |= Facts(**{f"{name}_in_table_{unit}_per_rad{power}": list(motion.within(order))})
    return facts | Facts(ramps_deg=[[degrees(angle) for angle in ramp] for ramp in motion.ramps])


def seams_sheets(motion: Motion) -> tuple[Sheet, ...]:
    """Table of the seams: the state on either side, and which derivative jumps, from what to what; none without seams.

    Of the seams inside a law it has those at which the acceleration jumps; a law's jerk jumps by the law's own design.

    Args:
        motion: motion of the follower.
    """
    if not isinstance(motion, SegmentMotion):
        return ()
    heads = (
        Message("seam"),
        Message("state (VDI 2143)"),
        Message("what jumps"),
        Message("cam angle"),
        Message("value before"),
        Message("value behind"),
    )
    rows = tuple(_seam_row(seam, motion) for seam in motion.joints if not seam.inside or seam in motion.seams)
    return (Sheet("seams", Message("Seams of the motion"), heads, rows, words=3),)


def _seam_row(seam: Seam, motion: SegmentMotion) -> tuple[Cell | str, ...]:
    previous, unit = (seam.segment - 2) % motion.count + 1, motion.unit.symbol
    place = (
        Message("within segment {number}", number=seam.segment)
        if seam.inside
        else Message("segment {before} to {behind}", before=previous, behind=seam.segment)
    )
    states = joined(dict.fromkeys(seam.states), "-")
    angle = number(degrees(seam.cam_angle), "°", digits=3)
    if seam.order is None:
        return place, states, Cell(Message("none"), state=Emphasis.MUTED), angle, number(None), number(None)
    by = f"{unit}/rad{_POWERS[seam.order]}"
    return place, states, _NAMES[seam.order], angle, number(seam.before, by), number(seam.after, by)


def reservations_of(
    motion: Motion, design: MotionDesign, accepted: Callable[[Sequence[str]], bool]
) -> tuple[Reservation, ...]:
    """Reservations on a motion: corners, jumps of the acceleration, a table with noise, or one that never comes down.

    Args:
        motion: motion of the follower.
        design: design that it is from.
        accepted: function that tells whether the design with changed keys leaves a cam.
    """
    held: list[Reservation] = []
    if isinstance(motion, SegmentMotion):
        held += _jump_reservations(motion, accepted)
    if isinstance(motion, TableMotion) and design.cam.base_radius_mm is None:
        height = motion.jets(np.linspace(0.0, TURN, _PLACES, endpoint=False))[:, 0]
        held += [*_high_reservation(motion, height), *_unit_reservation(motion, height, design)]
    if isinstance(motion, TableMotion) and motion.rough:
        smooth = motion_of(with_overrides(design, ["motion.smooth=true"]).motion, design.follower.registered)
        noise, unit = small_height(motion.noise, motion.unit)
        held.append(
            Reservation(
                "table-noise",
                Message(
                    "the rows of the table have {noise:.2g} {unit} of noise, by their fourth differences, and through "
                    "them as they are the acceleration runs from {low:.4g} to {high:.4g} {per}/rad², smoothed from "
                    "{least:.4g} to {most:.4g}",
                    noise=noise,
                    unit=unit,
                    **_range("low", "high", motion.within(2)),
                    **_range("least", "most", smooth.within(2) if isinstance(smooth, TableMotion) else (0.0, 0.0)),
                    per=motion.unit.symbol,
                ),
                Message("set motion.smooth to true")
                if accepted(["motion.smooth=true"])
                else Message("measure the lift again, or smooth the rows before they are read"),
            )
        )
    return tuple(held)


def _unit_reservation(motion: TableMotion, height: Array, design: MotionDesign) -> list[Reservation]:
    """Reservation on a file without a unit whose lifts are as small as inches taken for mm, or radians for degrees."""
    if not design.motion.table or design.motion.table_unit is not None:
        return []
    travel = float(np.ptp(height))
    base = design.seat.base_radius
    if motion.unit == MM and travel < _SMALL * base:
        text = Message(
            "neither the table nor the design says the unit of the lift, and in mm, as it was taken, it is "
            "{travel:.3g} mm on a base circle of {base:g} mm",
            travel=travel,
            base=base,
        )
    elif motion.unit != MM and travel < _SMALL_SWING:
        text = Message(
            "neither the table nor the design says the unit of the swing, and in degrees, as it was taken, the arm "
            "moves {travel:.3g}° in all",
            travel=degrees(travel),
        )
    else:
        return []
    return [
        Reservation("unit-assumed", text, Message("write the unit at the column's name, or state motion.table_unit"))
    ]


def _high_reservation(motion: TableMotion, height: Array) -> list[Reservation]:
    """Reservation on rows that are all above lift 0, as radii are, or readings of a dial that was not set to zero."""
    height, unit = (height, "mm") if motion.unit == MM else (np.degrees(height), "°")
    least, travel = float(height.min()), float(np.ptp(height))
    if least <= _HIGH * travel:
        return []
    return [
        Reservation(
            "never-at-zero",
            Message(
                "the follower never comes down to 0, where it stands on the base circle: its rows are {least:.4g} "
                "{unit} and more, as radii are, or a dial that was not set to zero, and the disc is larger by that",
                least=least,
                unit=unit,
            ),
            Message("subtract {least:.4g} {unit} from each row", least=least, unit=unit),
        )
    ]


def _jump_reservations(motion: SegmentMotion, accepted: Callable[[Sequence[str]], bool]) -> list[Reservation]:
    """Reservation on the corners, and on the jumps of the acceleration, each with its places."""
    said = {
        1: (
            "velocity-jumps",
            Message("the velocity jumps, which makes a corner of the path of the follower, {places} {unit}/rad"),
            Message("go slowly, or lead to it by a law that meets its neighbours"),
        ),
        2: (
            "acceleration-jumps",
            Message("the acceleration, in {unit}/rad², jumps {places}"),
            Message("go slowly, or take laws that meet their neighbours"),
        ),
    }
    held: list[Reservation] = []
    if not motion.seams:
        return held
    numbers = motion.milder
    if numbers and accepted(polynomial_overrides(numbers)):
        changed = Message("set {changes}, which ends it, or go slowly", changes=polynomial_changes(numbers))
    else:
        changed = None
    for order, (code, text, cure) in said.items():
        jumps = [seam for seam in motion.seams if seam.order == order]
        if not jumps:
            continue
        places = [
            Message(
                "at {angle:.4g} degrees from {before:.4g} to {after:.4g}",
                angle=degrees(seam.cam_angle),
                before=seam.before,
                after=seam.after,
            )
            for seam in jumps[:_MOST_PLACES]
        ]
        if len(jumps) > _MOST_PLACES:
            places.append(Message("and at {count} more", count=len(jumps) - _MOST_PLACES))
        held.append(
            Reservation(code, Message(text.template, places=joined(places), unit=motion.unit.symbol), changed or cure)
        )
    return held


def notes_of(motion: Motion, speed_rpm: float | None) -> tuple[str, ...]:
    """Sentences on a motion: its peaks at the speed, and what was done to its table.

    Args:
        motion: motion of the follower.
        speed_rpm: speed of the camshaft, rev/min; None if it is not known.
    """
    said: list[str] = []
    if speed_rpm is not None:
        figures = [
            Message("{value:.4g} {unit} ({place})", value=check.value, unit=check.unit, place=check.place)
            for check in checks_of(motion, speed_rpm)
        ]
        said.append(
            Message(
                "At {speed:g} rev/min the follower moves at up to {figures}.", speed=speed_rpm, figures=joined(figures)
            )
        )
    if isinstance(motion, TableMotion) and motion.smoothing is not None:
        change = motion.smoothing
        (rms, unit), (most, _) = (small_height(value, motion.unit) for value in (change.rms, change.most))
        said.append(
            Message(
                "The rows of the table were smoothed by {rms:.2g} {unit} rms, {most:.2g} {unit} at most, which is "
                "their noise by fourth differences; the acceleration, which ran from {low:.4g} to {high:.4g} "
                "{per}/rad², now runs from {least:.4g} to {greatest:.4g}.",
                rms=rms,
                most=most,
                unit=unit,
                **_range("low", "high", change.before),
                **_range("least", "greatest", motion.within(2)),
                per=motion.unit.symbol,
            )
        )
    if isinstance(motion, TableMotion) and motion.ramps:
        said.append(
            Message(
                "The ends of the table do not meet; polynomials lead them together from {ramps} of cam angle. Within "
                "its rows the velocity runs from {slow:.4g} to {fast:.4g} {unit}/rad, the acceleration from {low:.4g} "
                "to {high:.4g} {unit}/rad².",
                ramps=joined(
                    Message("{start:.5g}° to {stop:.5g}°", start=degrees(start), stop=degrees(stop))
                    for start, stop in motion.ramps
                ),
                unit=motion.unit.symbol,
                **_range("slow", "fast", motion.within(1)),
                **_range("low", "high", motion.within(2)),
            )
        )
    return tuple(said)


def small_height(value: float, unit: Unit) -> tuple[float, str]:
    """A small height in µm, or a small swing in µrad, with that unit.

    Args:
        value: height or swing, in the unit of a motion.
        unit: unit of the motion.
    """
    return (value * 1e3, "µm") if unit == MM else (value * 1e6, "µrad")


def _range(low: str, high: str, values: tuple[float, float]) -> dict[str, float]:
    return {low: values[0], high: values[1]}
