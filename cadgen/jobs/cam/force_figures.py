"""Forces on a follower and its camshaft in checks: whether it leaves the disc, at which speed, torque and pressure."""

from collections.abc import Callable
from math import ceil, degrees, floor, isfinite, log10

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.checks import cam_place
from cadgen.cam.follower import Follower
from cadgen.cam.forces import CamForces
from cadgen.check import Bound, Check, CheckCode
from cadgen.design.dynamics import closed_by_form, dynamics_of, most_of
from cadgen.design.schema import MotionDesign
from cadgen.figures import Facts
from cadgen.laws.motion import Motion, Peak
from cadgen.laws.unit import MM
from cadgen.messages import Message, joined

_NONE = 1e-9  # of the greatest force; a smaller one is none
_DIGITS = 4  # of a proposal, rounded to the safe side


def forces_of(design: MotionDesign, motion: Motion, follower: Follower) -> CamForces | None:
    """Forces of a design at its speed, or of a standing cam; None without [dynamics].

    Args:
        design: design with [motion].
        motion: motion of the follower.
        follower: follower of the design.
    """
    if design.dynamics is None:
        return None
    kind, keys, seat = design.follower.registered, design.follower.keys, design.seat
    roller, second, groove = kind.follower(keys, seat), kind.second(keys, seat), kind.groove(keys, seat)
    width = design.cam.thickness_mm if groove is None else groove.depth
    dynamics = dynamics_of(design.dynamics, kind, (roller, second or roller), design.blank.material, width)
    speed = (design.motion.speed_rpm or 0.0) * TURN / 60
    return CamForces(motion, follower, dynamics, speed, closed_by_form(keys), second)


def force_checks(forces: CamForces) -> tuple[Check, ...]:
    """Checks that decide: the follower stays on the disc, and its guide does not jam."""
    made = []
    if forces.dynamics.guide is not None:
        made.append(
            Check(
                CheckCode.GUIDE_JAMS,
                Message("motion along the normal that guide friction leaves"),
                forces.jams.value,
                "",
                0.0,
                Bound.MIN,
                cam_place(forces.jams.cam_angle),
                Message(
                    "the slide jams in its guide, where the tangent of the pressure angle is {limit:.4g}: lower "
                    "dynamics.guide_friction or dynamics.overhang_mm, or raise cam.base_circle_radius_mm",
                    limit=1 / forces.dynamics.guide.share,
                ),
            )
        )
    if not forces.closed and (forces.dynamics.guide is None or forces.jams.value > 0):
        most, least = forces.motion.extremes_of(forces.normal)
        if abs(least.value) < _NONE * abs(most.value):
            least = Peak(0.0, least.cam_angle)
        advice = "" if least.value >= 0 else _held(forces)
        made.append(
            Check(
                CheckCode.FORCE_LEAST,
                Message("force on the disc, least"),
                least.value,
                "N",
                0.0,
                Bound.MIN,
                cam_place(least.cam_angle),
                advice,
            )
        )
    return tuple(made)


def _held(forces: CamForces) -> str:
    """Where the follower leaves the disc, and a spring that holds it, each proved."""
    places = joined(
        Message("{start:.2f}° to {stop:.2f}°", start=degrees(start), stop=degrees(stop))
        for start, stop in forces.leaves
    )
    slides = forces.motion.unit == MM
    rate, preload = forces.least_rate(), forces.least_preload()
    keys = ("spring_rate_N_per_mm", "preload_N") if slides else ("spring_rate_Nmm_per_rad", "preload_Nmm")
    cures = []
    for key, value in zip(keys, (rate, preload), strict=True):
        if value is None:
            continue
        safe = _four_digits(value, ceil)
        if safe <= most_of(key):
            cures.append(Message("dynamics.{key} to {value:.10g}", key=key, value=safe))
    slow = _four_digits(forces.lift_off.value * 60 / TURN, floor)
    if slow > 0 and isfinite(slow):
        cures.append(Message("motion.speed_rpm to {speed:.10g}", speed=slow))
    if not cures:
        return Message(
            "the follower leaves the disc from {places}: make the motion milder, or go slower", places=places
        )
    return Message(
        "the follower leaves the disc from {places}: set {cures}, with each of which it stays",
        places=places,
        cures=joined(cures, Message(" or ")),
    )


def _four_digits(value: float, rounded: Callable[[float], int]) -> float:
    """A value rounded up or down to four digits; as it is where it is 0 or infinite."""
    if not value or not isfinite(value):
        return value
    unit = 10.0 ** (floor(log10(abs(value))) - _DIGITS + 1)
    return rounded(value / unit) * unit


def force_figures(forces: CamForces) -> tuple[Check, ...]:
    """Figures that are shown: greatest force, speed of lift-off, torque, power, pressure in the line of contact."""
    motion, made = forces.motion, []
    both = motion.extremes_of(forces.normal)
    high = max(both, key=lambda peak: abs(peak.value)) if forces.closed else both[0]
    high = Peak(abs(high.value) if forces.closed else high.value, high.cam_angle)
    made.append(
        _shown(CheckCode.FORCE_GREATEST, Message("force on the disc, greatest"), high.value, "N", high.cam_angle)
    )
    off = forces.lift_off
    if isfinite(off.value) and not forces.closed:
        name = Message("speed at which the follower leaves")
        made.append(_shown(CheckCode.LIFT_OFF_SPEED, name, off.value * 60 / TURN, "rev/min", off.cam_angle))
    if isfinite(high.value):
        most, least = motion.extremes_of(forces.torque)
        made += [
            _shown(CheckCode.TORQUE_GREATEST, Message("camshaft torque, greatest"), most.value, "N·mm", most.cam_angle),
            _shown(CheckCode.TORQUE_LEAST, Message("camshaft torque, least"), least.value, "N·mm", least.cam_angle),
            Check(CheckCode.TORQUE_MEAN, Message("camshaft torque, mean"), forces.mean_torque, "N·mm"),
        ]
        if forces.speed:
            power = forces.mean_torque * forces.speed * 1e-3
            made.append(Check(CheckCode.POWER_MEAN, Message("camshaft power, mean"), power, "W"))
        if forces.dynamics.line is not None:
            worst = motion.extremes_of(forces.pressure)[0]
            name = Message("pressure in the line of contact")
            made.append(_shown(CheckCode.CONTACT_PRESSURE, name, worst.value, "MPa", worst.cam_angle))
    return tuple(made)


def _shown(code: CheckCode, name: str, value: float, unit: str, cam_angle: float) -> Check:
    return Check(code, name, value, unit, place=cam_place(cam_angle))


def force_facts(forces: CamForces) -> Facts:
    """Facts of the forces: each peak with its cam angle, and where the follower leaves."""
    motion = forces.motion
    facts = Facts()
    for name, unit, figure in (
        ("force_along", "N" if motion.unit == MM else "Nmm", forces.along),
        ("normal_force", "N", forces.normal),
        ("camshaft_torque", "Nmm", forces.torque),
        ("contact_pressure", "MPa", forces.pressure),
    ):
        for word, peak in zip(("greatest", "least"), motion.extremes_of(figure), strict=True):
            place = degrees(peak.cam_angle)
            facts |= Facts(**{f"{name}_{word}_{unit}": peak.value, f"{name}_{word}_at_deg": place})
    stretches = "second_flank_deg" if forces.closed else "leaves_deg"
    return facts | Facts(
        lift_off_rpm=forces.lift_off.value * 60 / TURN,
        lift_off_at_deg=degrees(forces.lift_off.cam_angle),
        **{stretches: [[degrees(angle) for angle in stretch] for stretch in forces.leaves]},
        camshaft_torque_mean_Nmm=forces.mean_torque,
        work_Nmm=forces.work,
        peak_power_W=float(np.abs([peak.value for peak in motion.extremes_of(forces.torque)]).max())
        * forces.speed
        * 1e-3,
    )
