"""Every figure that decides whether a cam may be cut, with its place, limit, verdict and what to change.

Values here are for people: each carries its own unit (mm, degrees, micrometres).
"""

from enum import StrEnum
from math import inf, radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.clearance import cutter_room, thinnest_wall
from cadgen.cam.contact import roll_curve
from cadgen.cam.envelope import Trim, TrimKind
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.cam.limits import CheckLimits
from cadgen.cam.loss import Loss, lost_lift
from cadgen.cam.place import cam_place, polar_place
from cadgen.cam.rolled import Contact, RolledCam
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve
from cadgen.parts.blank import Blank

STATIONS = 3600  # one per 0.1 degree of cam angle
# Where the exact envelope is not trimmed, the rod must neither be pushed out (the wanted place would cut into the
# disc) nor fall short (there would be a gap); this is ten times what rolling errs.
CONTACT_LIMIT_UM = 0.2
# In the closing blend the car does not drive, so a blend is only refused where it would lock: a rod that a flank drives
# outwards is held by friction from arctan(1 / mu) on, 73 degrees at mu = 0.3, the greatest of metal on metal with a
# trace of oil. Where the spring drives it back nothing locks, and the 70 degrees are the strict end of the return
# stroke's limits.
LOCKING_ANGLE = radians(70)
# Relative to the curve's own largest value; the second derivative carries rounding of some 1e-8 where nodes are
# close together, and a jump above this would turn the outline by a microradian.
CLOSURE_LIMIT = 1e-6
# The checks that fail where the profile cannot give the lift wanted.
LOST_LIFT = (CheckCode.LOST_LIFT_UNDERCUT, CheckCode.LOST_LIFT_CROSSING, CheckCode.LOST_LIFT_FACE_CHANGE)
_WALL_POINTS = 200_000  # on the outline, to look for the thinnest wall
_ORDER: dict[StrEnum, int] = {code: number for number, code in enumerate(CheckCode)}


def cam_angles(lift: LiftCurve) -> Array:
    """Stations for the checks: an even grid and every kink, rad."""
    even = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    return np.unique(np.concatenate([even, lift.kinks]))


def check_cam(
    lift: LiftCurve,
    follower: Follower,
    curve: ClosedCurve,
    trims: tuple[Trim, ...],
    blank: Blank,
    limits: CheckLimits,
    *,
    cut: ClosedCurve | None = None,
) -> tuple[Check, ...]:
    """All checks of a cam, in the order of their codes; what a follower adds under codes of its own comes last.

    Args:
        lift: lift wanted, as tan(beta) by cam angle.
        follower: follower that the profile is for; its point for the theoretical profile.
        curve: profile, mm.
        trims: places where the envelope was trimmed; empty for profiles that are not an envelope.
        blank: features of the disc besides its profile.
        limits: limits of the checks, mm and rad.
        cut: curve that is cut, mm, if it differs from the profile that it becomes in its making.
    """
    theta = cam_angles(lift)
    contact, step = roll_curve(curve, follower, theta)
    outline = curve.outline(step)
    losses = lost_lift(lift, follower, trims, outline)
    driven = [loss for loss in losses if loss.driven]
    wanted = follower.lift(lift.tan_beta(theta))
    # Where the blend does not give its lift the follower stands elsewhere, and must be held there as well.
    steering = np.stack([lift.tan_beta(theta), np.where(lift.in_blend(theta), contact.tan_beta, lift.tan_beta(theta))])
    trimmed = _trimmed(lift, theta, trims)
    cam = RolledCam(lift=lift, contact=contact, trimmed=trimmed, steering=steering, blank=blank, limits=limits)
    rows = (
        *_pressure(lift, contact, limits),
        *_curvature(lift, follower, curve, driven, max(limits.min_convex_radius, blank.edge_break), limits),
        *_undercut(lift, follower, driven, limits),
        *_contact(follower, contact, np.where(lift.in_blend(theta), 0.0, contact.lift - wanted), trimmed),
        *_blend(lift, follower, contact, contact.lift - wanted, losses, limits),
        cutter_room(cut or curve, limits.cutter_radius),
        thinnest_wall(blank, curve.outline(max(step, curve.length() / _WALL_POINTS)), limits.wall),
        *_closure(lift),
        *follower.checks(cam),
    )
    return tuple(sorted(rows, key=lambda check: _ORDER.get(check.code, len(_ORDER))))


def riding_checks(
    lift: LiftCurve, follower: Follower, contact: Contact, blank: Blank, limits: CheckLimits
) -> tuple[Check, ...]:
    """Checks of a follower on a disc that stands elsewhere than it was made for: pressure angle and room.

    Args:
        lift: lift that the disc gives there.
        follower: follower as it stands to the disc.
        contact: contact of the two.
        blank: features of the disc besides its profile.
        limits: limits of the checks, mm and rad.
    """
    steering = np.stack([contact.tan_beta, contact.tan_beta])
    idle = lift.in_blend(contact.cam_angle)
    cam = RolledCam(lift=lift, contact=contact, trimmed=idle, steering=steering, blank=blank, limits=limits)
    return (*_pressure(lift, contact, limits), *follower.checks(cam))


def _trimmed(lift: LiftCurve, theta: Array, trims: tuple[Trim, ...]) -> NDArray[np.bool_]:
    """Where the envelope is trimmed lift is lost, and the blend does not drive: both have checks of their own."""
    trimmed = lift.in_blend(theta)
    for trim in trims:
        trimmed |= (theta - trim.before) % TURN <= (trim.after - trim.before) % TURN
    return trimmed


def _pressure(lift: LiftCurve, contact: Contact, limits: CheckLimits) -> list[Check]:
    rising, driven = lift.tan_beta(contact.cam_angle, nu=1) >= 0, ~lift.in_blend(contact.cam_angle)
    angle = np.degrees(np.abs(contact.pressure_angle))
    checks = []
    for code, name, of_kind, limit in (
        (CheckCode.PRESSURE_ANGLE_RISE, "pressure angle, rise", rising & driven, limits.pressure_angle.rise),
        (CheckCode.PRESSURE_ANGLE_RETURN, "pressure angle, return", ~rising & driven, limits.pressure_angle.fall),
    ):
        value = np.where(of_kind, angle, 0.0)
        worst = int(np.argmax(value))
        checks.append(
            Check(
                code,
                name,
                float(value[worst]),
                "°",
                float(np.degrees(limit)),
                Bound.MAX,
                cam_place(contact.cam_angle[worst]),
                f"{_soften(lift, contact.cam_angle[worst], limits)}, raise cam.base_radius_mm, or choose another "
                f"checks.pressure_angle_limit (now {limits.pressure_angle.source})",
            )
        )
    return checks


def _curvature(
    lift: LiftCurve,
    follower: Follower,
    curve: ClosedCurve,
    losses: list[Loss],
    allowed: float,
    limits: CheckLimits,
) -> list[Check]:
    pitch = follower.pitch_curve(lift)
    checks = [] if pitch is None else [_pitch_radius(lift, follower, pitch, losses, limits)]
    radius, point = _least_convex_radius(curve)
    milder = follower.milder
    advice = f"a sharp ridge wears: {milder}"
    if allowed > limits.min_convex_radius:
        advice = f"the chamfers of the broken edges meet on a sharp ridge: lower blank.edge_break_mm, {milder}"
    code = CheckCode.CONVEX_RADIUS_PROFILE
    checks.append(Check(code, "convex radius, profile", radius, "mm", allowed, Bound.MIN, polar_place(point), advice))
    return checks


def _pitch_radius(
    lift: LiftCurve, follower: Follower, pitch: ClosedCurve, losses: list[Loss], limits: CheckLimits
) -> Check:
    radius, point = _least_convex_radius(pitch)
    place = polar_place(point)
    if lift.kinks.size:
        corners = [c for c in pitch.corners(1e-4) if c.turn > 0 and _near(c.point, lift.kinks)]
        if corners:
            sharpest = max(corners, key=lambda c: c.turn)
            radius, point = 0.0, sharpest.point
            place = f"{polar_place(point)}, corner {np.degrees(sharpest.turn):.1f}°"
    # What is sharper than the follower is undercut; that is sized as lost lift, and bearable if the loss is.
    lost = max((loss.lift for loss in losses if loss.trim.kind == TrimKind.LOCAL), default=0.0)
    angle = float(np.arctan2(point[1], point[0])) % TURN
    return Check(
        CheckCode.CONVEX_RADIUS_THEORY,
        "convex radius, theory",
        radius,
        "mm",
        follower.radius if lost > limits.lost_lift else 0.0,
        Bound.MIN,
        place,
        f"a convex part sharper than the {follower.noun} is undercut: {_soften(lift, angle, limits)}, "
        f"{follower.milder}",
    )


def _undercut(lift: LiftCurve, follower: Follower, losses: list[Loss], limits: CheckLimits) -> list[Check]:
    checks = []
    for code, name, kind, reason in (
        (
            CheckCode.LOST_LIFT_UNDERCUT,
            "lost lift, undercut",
            TrimKind.LOCAL,
            f"no profile gives this lift to this {follower.noun}",
        ),
        (CheckCode.LOST_LIFT_CROSSING, "lost lift, crossing", TrimKind.GLOBAL, "two flanks cut each other off"),
        (CheckCode.LOST_LIFT_FACE_CHANGE, "lost lift, face change", TrimKind.FACE_CHANGE, ""),
    ):
        of_kind = [loss for loss in losses if loss.trim.kind == kind]
        worst = max(of_kind, key=lambda loss: loss.lift, default=None)
        place = "none" if worst is None else f"{cam_place(worst.cam_angle)} ({len(of_kind)} in all)"
        value = 0.0 if worst is None else worst.lift * 1e3
        softer = "" if worst is None else _soften(lift, worst.cam_angle, limits)
        advice = f"{reason}: {softer}" if reason else f"make the disc thinner (cam.thickness_mm) or {softer}"
        checks.append(Check(code, name, value, "µm", limits.lost_lift * 1e3, Bound.MAX, place, advice))
    return checks


def _contact(follower: Follower, contact: Contact, error: Array, trimmed: NDArray[np.bool_]) -> list[Check]:
    checks = []
    for code, name, beyond in (
        (CheckCode.ROD_PUSHED_OUT, f"{follower.noun} pushed out", error),
        (CheckCode.ROD_FALLS_SHORT, f"{follower.noun} falls short", np.where(trimmed, 0.0, -error)),
    ):
        worst = int(np.argmax(beyond))
        checks.append(
            Check(
                code,
                name,
                max(float(beyond[worst]) * 1e3, 0.0),
                "µm",
                CONTACT_LIMIT_UM,
                Bound.MAX,
                cam_place(contact.cam_angle[worst]),
                f"this profile is not the {follower.noun}'s envelope: use --profile actual",
            )
        )
    return checks


def _blend(
    lift: LiftCurve, follower: Follower, contact: Contact, error: Array, losses: list[Loss], limits: CheckLimits
) -> list[Check]:
    """Checks of the closing blend, where the car does not drive: refused only where the follower would lock."""
    if not lift.blended:
        return []
    within = lift.in_blend(contact.cam_angle)
    place, value = cam_place(lift.blend_start), 0.0
    # Corners lie between the stations.
    lost = [(loss.lift, loss.cam_angle) for loss in losses if not loss.driven]
    off = list(zip(np.abs(error[within]).tolist(), contact.cam_angle[within].tolist(), strict=True))
    if lost or off:
        value, angle = max(lost + off)
        place = f"{cam_place(angle)}, where the car does not drive"
    checks = [Check(CheckCode.BLEND_LIFT, "lift not given, blend", value * 1e3, "µm", inf, Bound.MAX, place)]
    rising = lift.tan_beta(contact.cam_angle, nu=1) >= 0
    angles = np.abs(contact.pressure_angle)
    rise, fall = CheckCode.BLEND_PRESSURE_ANGLE_RISE, CheckCode.BLEND_PRESSURE_ANGLE_RETURN
    for code, name, of_kind, usual in (
        (rise, "pressure angle, blend rise", within & rising, limits.pressure_angle.rise),
        (fall, "pressure angle, blend return", within & ~rising, limits.pressure_angle.fall),
    ):
        size = np.where(of_kind, angles, 0.0)
        worst = int(np.argmax(size))
        checks.append(
            Check(
                code,
                name,
                float(np.degrees(size[worst])),
                "°",
                float(np.degrees(max(LOCKING_ANGLE, usual))),
                Bound.MAX,
                cam_place(contact.cam_angle[worst]) if of_kind.any() else "none",
                f"on so steep a flank the {follower.noun} locks when the cam is turned on to its start: "
                f"{_soften(lift, lift.blend_start, limits)} or raise cam.base_radius_mm",
            )
        )
    return checks


def _closure(lift: LiftCurve) -> list[Check]:
    """Jumps of tan(beta) and its derivatives where the turn closes and where the blend begins."""
    dense = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    breaks, coefficients = lift.tan_beta.x, lift.tan_beta.c
    checks = []
    seams = [(CheckCode.CLOSURE, "closure ", 0.0, len(breaks) - 2)]
    if lift.blended:
        left = int(np.searchsorted(breaks, lift.blend_start)) - 1
        seams.append((CheckCode.BLEND_START, "start of the blend", lift.blend_start, left))
    for code, name, at, left in seams:
        right = (left + 1) % (len(breaks) - 1)
        width = breaks[left + 1] - breaks[left]
        worst = 0.0
        for order in range(3):
            ends = np.polyder(coefficients[:, left], order), np.polyder(coefficients[:, right], order)
            jump = abs(float(np.polyval(ends[0], width)) - float(np.polyval(ends[1], 0.0)))
            # On a circle the derivatives are rounding: what is small beside the lift itself is no jump.
            scale = max(float(np.max(np.abs(lift.tan_beta(dense, nu=some)))) for some in {0, order})
            worst = max(worst, jump / scale if scale > 0 else jump)
        checks.append(
            Check(
                code,
                name,
                worst,
                "",
                CLOSURE_LIMIT,
                Bound.MAX,
                cam_place(at),
                "lift, slope and second derivative must not jump: report this design",
            )
        )
    return checks


def _least_convex_radius(curve: ClosedCurve) -> tuple[float, Array]:
    radius, point = np.inf, curve.pieces[0].jet(np.array([curve.pieces[0].start])).point[0]
    for piece in curve.pieces:
        jet = piece.jet(np.linspace(piece.start, piece.stop, STATIONS))
        worst = int(np.argmax(jet.curvature))
        if jet.curvature[worst] > 0 and 1 / jet.curvature[worst] < radius:
            radius, point = float(1 / jet.curvature[worst]), jet.point[worst]
    return radius, point


def _near(point: Array, angles: Array) -> bool:
    off = (np.arctan2(point[1], point[0]) - angles + np.pi) % TURN - np.pi
    return bool(np.any(np.abs(off) < 1e-6))


def _soften(lift: LiftCurve, theta: float, limits: CheckLimits) -> str:
    """Advice that makes the lift milder at a cam angle, in words."""
    if theta >= lift.blend_start:
        return "raise cam.blend_deg (the closing blend steers there)"
    return f"widen the turn there ({limits.points_key})"
