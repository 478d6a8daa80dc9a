"""Every figure that decides whether a cam may be cut, with its place, limit, verdict and what to change.

Values here are for people: each carries its own unit (mm, degrees, micrometres).
"""

from math import inf, radians

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.clearance import chamfer_clearance, cutter_room, hub_clearance, rod_reach, thinnest_wall
from cadgen.cam.contact import ROLLING_TOLERANCE, Contact, roll_curve
from cadgen.cam.envelope import Trim
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.cam.limits import CheckLimits
from cadgen.cam.loss import Loss, lost_lift
from cadgen.cam.place import cam_place, polar_place
from cadgen.cam.theoretical import theoretical_profile
from cadgen.check import Check, CheckCode
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
    """All checks of a cam.

    Args:
        lift: the steering wanted.
        follower: the rod the profile is for; radius 0 for the theoretical profile.
        curve: the profile.
        trims: where the envelope was trimmed; empty for profiles that are not an envelope.
        blank: what the disc has besides its profile.
        limits: what is allowed.
        cut: what the cutter follows, if that is another curve, which becomes the profile in its making.
    """
    theta = cam_angles(lift)
    contact, step = roll_curve(curve, follower, theta)
    outline = curve.outline(step)
    losses = lost_lift(lift, follower, trims, outline)
    driven = [loss for loss in losses if loss.driven]
    wanted = follower.lift(lift.tan_beta(theta))
    # Where the blend does not give its lift the rod stands elsewhere, and must be held there as well.
    steering = np.stack([lift.tan_beta(theta), np.where(lift.in_blend(theta), contact.tan_beta, lift.tan_beta(theta))])
    return (
        *_pressure(lift, contact, limits),
        *_curvature(lift, follower, curve, driven, max(limits.min_convex_radius, blank.edge_break), limits),
        *_undercut(lift, driven, limits),
        *_contact(lift, follower, contact, contact.lift - wanted, trims),
        *_blend(lift, contact, contact.lift - wanted, losses, limits),
        rod_reach(follower, theta, steering, blank, limits.rod_length),
        *chamfer_clearance(theta, steering, blank),
        *hub_clearance(follower, theta, steering, blank),
        cutter_room(cut or curve, limits.cutter_radius),
        thinnest_wall(blank, curve.outline(max(step, curve.length() / _WALL_POINTS)), limits.wall),
        *_closure(lift),
    )


def _pressure(lift: LiftCurve, contact: Contact, limits: CheckLimits) -> list[Check]:
    rising, driven = lift.tan_beta(contact.cam_angle, nu=1) >= 0, ~lift.in_blend(contact.cam_angle)
    angle = np.degrees(np.abs(contact.pressure_angle))
    checks = []
    for code, name, mine, limit in (
        (CheckCode.PRESSURE_ANGLE_RISE, "pressure angle, rise", rising & driven, limits.pressure_angle.rise),
        (CheckCode.PRESSURE_ANGLE_RETURN, "pressure angle, return", ~rising & driven, limits.pressure_angle.fall),
    ):
        value = np.where(mine, angle, 0.0)
        worst = int(np.argmax(value))
        checks.append(
            Check(
                code,
                name,
                float(value[worst]),
                "°",
                float(np.degrees(limit)),
                "max",
                cam_place(contact.cam_angle[worst]),
                f"{_soften(lift, contact.cam_angle[worst])}, raise cam.base_radius_mm, or choose another "
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
    theoretical = theoretical_profile(lift, follower)
    radius, point = _least_convex_radius(theoretical)
    place = polar_place(point)
    if lift.kinks.size:
        corners = [c for c in theoretical.corners(1e-4) if c.turn > 0 and _near(c.point, lift.kinks)]
        if corners:
            sharpest = max(corners, key=lambda c: c.turn)
            radius, point = 0.0, sharpest.point
            place = f"{polar_place(point)}, corner {np.degrees(sharpest.turn):.1f}°"
    # What is sharper than the rod is undercut; that is sized as lost lift, and bearable if the loss is.
    lost = max((loss.lift for loss in losses if loss.trim.kind == "local"), default=0.0)
    angle = float(np.arctan2(point[1], point[0])) % TURN
    checks = [
        Check(
            CheckCode.CONVEX_RADIUS_THEORY,
            "convex radius, theory",
            radius,
            "mm",
            follower.radius if lost > limits.lost_lift else 0.0,
            "min",
            place,
            f"a convex part sharper than the rod is undercut: {_soften(lift, angle)}, lower follower.radius_mm or "
            "raise cam.base_radius_mm",
        )
    ]
    radius, point = _least_convex_radius(curve)
    milder = "lower follower.radius_mm or raise cam.base_radius_mm"
    advice = f"a sharp ridge wears: {milder}"
    if allowed > limits.min_convex_radius:
        advice = f"the chamfers of the broken edges meet on a sharp ridge: lower blank.edge_break_mm, {milder}"
    code = CheckCode.CONVEX_RADIUS_PROFILE
    checks.append(Check(code, "convex radius, profile", radius, "mm", allowed, "min", polar_place(point), advice))
    return checks


def _undercut(lift: LiftCurve, losses: list[Loss], limits: CheckLimits) -> list[Check]:
    checks = []
    for code, name, kind, reason in (
        (CheckCode.LOST_LIFT_UNDERCUT, "lost lift, undercut", "local", "no profile gives this lift to this rod"),
        (CheckCode.LOST_LIFT_CROSSING, "lost lift, crossing", "global", "two flanks cut each other off"),
        (CheckCode.LOST_LIFT_FACE_CHANGE, "lost lift, face change", "face change", ""),
    ):
        mine = [loss for loss in losses if loss.trim.kind == kind]
        worst = max(mine, key=lambda loss: loss.lift, default=None)
        place = "none" if worst is None else f"{cam_place(worst.cam_angle)} ({len(mine)} in all)"
        value = 0.0 if worst is None else worst.lift * 1e3
        softer = "" if worst is None else _soften(lift, worst.cam_angle)
        advice = f"{reason}: {softer}" if reason else f"make the disc thinner (cam.thickness_mm) or {softer}"
        checks.append(Check(code, name, value, "µm", limits.lost_lift * 1e3, "max", place, advice))
    return checks


def _contact(
    lift: LiftCurve, follower: Follower, contact: Contact, error: Array, trims: tuple[Trim, ...]
) -> list[Check]:
    # Where the envelope is trimmed lift is lost, and the blend does not drive: both have checks of their own.
    trimmed = lift.in_blend(contact.cam_angle)
    error = np.where(trimmed, 0.0, error)
    for trim in trims:
        trimmed |= (contact.cam_angle - trim.before) % TURN <= (trim.after - trim.before) % TURN
    checks = []
    for code, name, beyond in (
        (CheckCode.ROD_PUSHED_OUT, "rod pushed out", error),
        (CheckCode.ROD_FALLS_SHORT, "rod falls short", np.where(trimmed, 0.0, -error)),
    ):
        worst = int(np.argmax(beyond))
        checks.append(
            Check(
                code,
                name,
                max(float(beyond[worst]) * 1e3, 0.0),
                "µm",
                CONTACT_LIMIT_UM,
                "max",
                cam_place(contact.cam_angle[worst]),
                "this profile is not the rod's envelope: use --profile actual",
            )
        )
    due = follower.contact_face(lift.tan_beta(contact.cam_angle))
    wrong = (contact.face != due) & (contact.margin > ROLLING_TOLERANCE) & ~trimmed
    inner = float(np.mean(contact.face == follower.inner)) * 100
    checks.append(
        Check(
            CheckCode.WRONG_FACE,
            "wrong face carries",
            float(np.sum(wrong)),
            "stations",
            0.0,
            "max",
            f"inner {inner:.0f} %, outer {100 - inner:.0f} %",
            "the rod rests on the other face than eq. 15 says: use --profile actual",
        )
    )
    return checks


def _blend(lift: LiftCurve, contact: Contact, error: Array, losses: list[Loss], limits: CheckLimits) -> list[Check]:
    """What the closing blend does, where the car does not drive: refused only where the rod would lock."""
    within = lift.in_blend(contact.cam_angle)
    place, value = cam_place(lift.blend_start), 0.0
    # Corners lie between the stations.
    lost = [(loss.lift, loss.cam_angle) for loss in losses if not loss.driven]
    off = list(zip(np.abs(error[within]).tolist(), contact.cam_angle[within].tolist(), strict=True))
    if lost or off:
        value, angle = max(lost + off)
        place = f"{cam_place(angle)}, where the car does not drive"
    checks = [Check(CheckCode.BLEND_LIFT, "lift not given, blend", value * 1e3, "µm", inf, "max", place)]
    rising = lift.tan_beta(contact.cam_angle, nu=1) >= 0
    angles = np.abs(contact.pressure_angle)
    rise, fall = CheckCode.BLEND_PRESSURE_ANGLE_RISE, CheckCode.BLEND_PRESSURE_ANGLE_RETURN
    for code, name, mine, usual in (
        (rise, "pressure angle, blend rise", within & rising, limits.pressure_angle.rise),
        (fall, "pressure angle, blend return", within & ~rising, limits.pressure_angle.fall),
    ):
        size = np.where(mine, angles, 0.0)
        worst = int(np.argmax(size))
        checks.append(
            Check(
                code,
                name,
                float(np.degrees(size[worst])),
                "°",
                float(np.degrees(max(LOCKING_ANGLE, usual))),
                "max",
                cam_place(contact.cam_angle[worst]) if mine.any() else "none",
                "on so steep a flank the rod locks when the cam is turned on to its start: "
                f"{_soften(lift, lift.blend_start)} or raise cam.base_radius_mm",
            )
        )
    return checks


def _closure(lift: LiftCurve) -> list[Check]:
    """Jumps of tan(beta) and its derivatives where the turn closes and where the blend begins."""
    dense = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    breaks, coefficients = lift.tan_beta.x, lift.tan_beta.c
    checks = []
    for code, name, at, left in (
        (CheckCode.CLOSURE, "closure ", 0.0, len(breaks) - 2),
        (
            CheckCode.BLEND_START,
            "start of the blend",
            lift.blend_start,
            int(np.searchsorted(breaks, lift.blend_start)) - 1,
        ),
    ):
        right = (left + 1) % (len(breaks) - 1)
        width = breaks[left + 1] - breaks[left]
        worst = 0.0
        for order in range(3):
            ends = np.polyder(coefficients[:, left], order), np.polyder(coefficients[:, right], order)
            jump = abs(float(np.polyval(ends[0], width)) - float(np.polyval(ends[1], 0.0)))
            scale = float(np.max(np.abs(lift.tan_beta(dense, nu=order))))
            worst = max(worst, jump / scale if scale > 0 else jump)
        checks.append(
            Check(
                code,
                name,
                worst,
                "",
                CLOSURE_LIMIT,
                "max",
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


def _soften(lift: LiftCurve, theta: float) -> str:
    """What makes the lift milder at a cam angle."""
    if theta >= lift.blend_start:
        return "raise cam.blend_deg (the closing blend steers there)"
    return "widen the turn there (path.waypoints_mm)"
