"""Every figure that decides whether a cam may be cut, with its place, limit, verdict and what to change.

Values here are for people: each carries its own unit (mm, degrees, micrometres).
"""

from collections.abc import Callable, Iterable
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.cutter import largest_cutter
from cadgen.cam.follower import Contact, Follower, Loss, RolledCam, Trim, TrimKind, gives_nothing
from cadgen.cam.formulas import formula_checks
from cadgen.cam.limits import CheckLimits
from cadgen.cam.lost_lift import lost_lift
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.messages import Message, clauses
from cadgen.parts.blank import Blank


def cam_place(theta: float) -> str:
    """A cam angle theta, rad, in words.

    Args:
        theta: cam angle, rad.
    """
    return Message("cam angle {angle:.2f}°", angle=np.degrees(theta))


def polar_place(point: Array) -> str:
    """The direction of a point from the camshaft in words.

    Args:
        point: point, shape (2,), mm.
    """
    return Message("polar angle {angle:.2f}°", angle=np.degrees(np.arctan2(point[1], point[0])) % 360)


def thinnest_wall(blank: Blank, outline: Outline, limit: float) -> Check:
    """The thinnest wall between the profile and the holes, or between two holes, against its limit, mm.

    Args:
        blank: blank of the disc.
        outline: points of the disc's outline.
        limit: least wall allowed, mm.
    """
    wall = min(blank.walls(outline), key=lambda wall: wall.thickness)
    return Check(
        CheckCode.THINNEST_WALL,
        Message("thinnest wall"),
        wall.thickness,
        "mm",
        limit,
        Bound.MIN,
        clauses(wall.between, polar_place(wall.place)),
        Message("make the hole smaller or move it (the design's [blank]), or lower checks.min_wall_mm"),
    )


def cutter_room(curve: ClosedCurve, cutter_radius: float) -> Check:
    """Diameter of the largest cutter that can mill the whole profile, mm; the limit is the design's own cutter.

    Args:
        curve: profile, mm.
        cutter_radius: radius of the cutter, mm.
    """
    cutter = largest_cutter(curve)
    return Check(
        CheckCode.CUTTER_RADIUS,
        Message("largest cutter radius"),
        cutter.radius,
        "mm",
        cutter_radius,
        Bound.MIN,
        Message("no concave part")
        if cutter.point is None
        else Message("{place} ({kind})", place=polar_place(cutter.point), kind=Message(cutter.kind)),
        Message("choose a smaller machining.cutter_diameter_mm"),
    )


STATIONS = 3600  # one per 0.1 degree of cam angle
# Where the exact envelope is not trimmed, the follower must neither be pushed out (the wanted place would cut into the
# disc) nor fall short (there would be a gap); this is ten times what rolling errs.
CONTACT_LIMIT_UM = 0.2
# Relative to the curve's own largest value; the second derivative carries rounding of some 1e-8 where nodes are
# close together, and a jump above this would turn the outline by a microradian.
CLOSURE_LIMIT = 1e-6
# The checks that fail where the profile cannot give the lift wanted.
LOST_LIFT = (
    CheckCode.LOST_LIFT_UNDERCUT,
    CheckCode.LOST_LIFT_CROSSING,
    CheckCode.LOST_LIFT_FACE_CHANGE,
    CheckCode.LOST_LIFT_EFFECT,
)
_BETWEEN = 16  # stations more between two of them, about a peak of the pressure angle
_FINER = 4  # times finer is the outline there: the angle errs by the square of its step, the lift by the third power
_STILL = 1e-9  # of the greatest velocity; a smaller one is rounding of 0
_BESIDE = 1e-6  # rad; to see what the motion does beside a place where it stands still
_WALL_POINTS = 200_000  # on the outline, to look for the thinnest wall
# The sharpest place of a piece is closed in on in so many rounds of so many points; mm of radius that show.
_ZOOMS, _ZOOM, _SHOWS = 4, 33, 5e-5
_ORDER: dict[StrEnum, int] = {code: number for number, code in enumerate(CheckCode)}


def cam_angles(motion: Motion) -> Array:
    """Stations for the checks, rad: an even grid, every kink, and every jump of the acceleration, often a peak."""
    even = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    return np.unique(np.concatenate([even, motion.kinks, motion.bends]))


def _ways(motion: Motion, theta: Array) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Whether cam angles belong to a rise or a dwell, and whether to a return, shape (n,) each.

    The end of a return, where the velocity is 0, belongs to it, too: its pressure angle is the limit of those beside.

    Args:
        motion: motion wanted.
        theta: cam angles, rad, shape (n,).
    """
    velocity, before, after = (motion.q((theta + side) % TURN, nu=1) for side in (0.0, -_BESIDE, _BESIDE))
    still = _STILL * float(np.max(np.abs(velocity)))
    falling = velocity < -still
    ends = ~falling & (velocity <= still) & (np.minimum(before, after) < -still)
    return ~falling, falling | ends


def _with_peaks(motion: Motion, follower: Follower, curve: ClosedCurve, contact: Contact, step: float) -> Contact:
    """Contact at its stations and close about those of the greatest pressure angles, which lie between stations."""
    size = np.abs(contact.pressure_angle)
    worst = {int(np.argmax(np.where(part, size, -1.0))) for part in _ways(motion, contact.cam_angle)}
    worst |= {int(np.argmax(contact.pressure_angle)), int(np.argmin(contact.pressure_angle))}
    near = np.linspace(-TURN, TURN, 2 * _BETWEEN + 1) / STATIONS
    theta = (contact.cam_angle[sorted(worst), None] + near).ravel() % TURN
    try:
        return contact.joined(roll(curve.outline(step / _FINER), follower, theta))
    except DesignError:  # so fine an outline shows a fold beside a crossing, whose lift is judged as lost
        return contact


def check_cam(
    motion: Motion,
    follower: Follower,
    curve: ClosedCurve,
    trims: tuple[Trim, ...],
    blank: Blank,
    limits: CheckLimits,
    *,
    cut: ClosedCurve | None = None,
    application: Callable[[RolledCam], Iterable[Check]] = lambda cam: (),
) -> tuple[Check, ...]:
    """All checks of a cam, in the order of their codes; what a follower adds under codes of its own comes last.

    Args:
        motion: motion wanted.
        follower: follower that the profile is for; its point for the theoretical profile.
        curve: profile, mm.
        trims: places where the envelope was trimmed; empty for profiles that are not an envelope.
        blank: features of the disc besides its profile.
        limits: limits of the checks, mm and rad.
        cut: curve that is cut, mm, if it differs from the profile that it becomes in its making.
        application: function that adds the checks of what the cam is for.
    """
    theta = cam_angles(motion)
    contact, step = roll_curve(curve, follower, theta)
    if not follower.leans:
        contact = _with_peaks(motion, follower, curve, contact, step)
        theta = contact.cam_angle
    outline = curve.outline(step)
    losses = lost_lift(motion, follower, trims, outline)
    driven = [loss for loss in losses if loss.driven]
    wanted = follower.lift(motion.q(theta))
    # Where nothing depends on the motion the follower may stand elsewhere, and must be held there as well.
    positions = np.stack([motion.q(theta), np.where(motion.idle(theta), contact.q, motion.q(theta))])
    # Where the envelope is trimmed, or nothing depends on the motion, other checks judge the lift.
    trimmed = motion.idle(theta)
    for trim in trims:
        trimmed |= (theta - trim.before) % TURN <= (trim.after - trim.before) % TURN
    cam = RolledCam(
        motion=motion,
        follower=follower,
        contact=contact,
        error=contact.lift - wanted,
        losses=tuple(losses),
        trimmed=trimmed,
        positions=positions,
        blank=blank,
        limits=limits,
    )
    rows = (
        *_pressure(motion, follower, contact, limits),
        *_curvature(motion, follower, curve, driven, max(limits.min_convex_radius, blank.edge_break), limits),
        *_undercut(motion, follower, driven, limits),
        *_contact(follower, contact, np.where(motion.idle(theta), 0.0, contact.lift - wanted), trimmed),
        *formula_checks(motion, follower, curve, contact, ~trimmed),
        cutter_room(cut or curve, limits.cutter_radius),
        thinnest_wall(blank, curve.outline(max(step, curve.length() / _WALL_POINTS)), limits.wall),
        seam_check(motion, 0.0),
        *_own_checks(follower, cam),
        *application(cam),
    )
    return tuple(sorted(rows, key=lambda check: _ORDER.get(check.code, len(_ORDER))))


def riding_checks(
    motion: Motion, follower: Follower, contact: Contact, blank: Blank, limits: CheckLimits
) -> tuple[Check, ...]:
    """Checks of a follower on a disc that stands elsewhere than it was made for: pressure angle and room.

    Args:
        motion: motion that the disc gives there.
        follower: follower as it stands to the disc.
        contact: contact of the two.
        blank: features of the disc besides its profile.
        limits: limits of the checks, mm and rad.
    """
    cam = RolledCam(
        motion=motion,
        follower=follower,
        contact=contact,
        error=np.zeros_like(contact.lift),
        losses=(),
        trimmed=motion.idle(contact.cam_angle),
        positions=np.stack([contact.q, contact.q]),
        blank=blank,
        limits=limits,
    )
    return (*_pressure(motion, follower, contact, limits), *_own_checks(follower, cam))


def _own_checks(follower: Follower, cam: RolledCam) -> tuple[Check, ...]:
    """Checks that a follower adds itself; of a plug-in it may return none at all, which is refused."""
    own: tuple[Check, ...] | None = follower.checks(cam)
    if own is None:
        raise gives_nothing(follower, "checks")
    return own


def signed_pressure(cam: RolledCam) -> tuple[Check, ...]:
    """Figures of the greatest and the least pressure angle with their signs, degrees.

    Args:
        cam: cam that is rolled.
    """
    angle = np.degrees(cam.contact.pressure_angle)
    return tuple(
        Check(code, name, float(angle[at]), "°", place=cam_place(cam.contact.cam_angle[at]))
        for code, name, at in (
            (CheckCode.PRESSURE_ANGLE_GREATEST, Message("pressure angle, greatest"), int(np.argmax(angle))),
            (CheckCode.PRESSURE_ANGLE_LEAST, Message("pressure angle, least"), int(np.argmin(angle))),
        )
    )


def _pressure(motion: Motion, follower: Follower, contact: Contact, limits: CheckLimits) -> list[Check]:
    rising, falling = _ways(motion, contact.cam_angle)
    driven = ~motion.idle(contact.cam_angle)
    angle = np.degrees(np.abs(contact.pressure_angle))
    checks = []
    for code, name, of_kind, limit in (
        (CheckCode.PRESSURE_ANGLE_RISE, Message("pressure angle, rise"), rising & driven, limits.pressure_angle.rise),
        (
            CheckCode.PRESSURE_ANGLE_RETURN,
            Message("pressure angle, return"),
            falling & driven,
            limits.pressure_angle.fall,
        ),
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
                Message(
                    "{softer}, raise {base_key}, or choose another checks.pressure_angle_limit; the present limit "
                    "is from {source}",
                    softer=motion.softer(float(contact.cam_angle[worst]), limits.motion_key),
                    base_key=follower.base_key,
                    source=limits.pressure_angle.source,
                ),
            )
        )
    return checks


def _curvature(
    motion: Motion,
    follower: Follower,
    curve: ClosedCurve,
    losses: list[Loss],
    allowed: float,
    limits: CheckLimits,
) -> list[Check]:
    pitch = follower.pitch_curve(motion)
    checks = [] if pitch is None else [_pitch_radius(motion, follower, pitch, losses, limits)]
    radius, point = _least_convex_radius(curve)
    milder = follower.milder
    advice = Message("a sharp ridge wears: {milder}", milder=milder)
    if allowed > limits.min_convex_radius:
        advice = Message(
            "the chamfers of the broken edges meet on a sharp ridge: lower blank.edge_break_mm, {milder}", milder=milder
        )
    code = CheckCode.CONVEX_RADIUS_PROFILE
    checks.append(
        Check(code, Message("convex radius, profile"), radius, "mm", allowed, Bound.MIN, polar_place(point), advice)
    )
    return checks


def _pitch_radius(
    motion: Motion, follower: Follower, pitch: ClosedCurve, losses: list[Loss], limits: CheckLimits
) -> Check:
    radius, point = _least_convex_radius(pitch)
    place = polar_place(point)
    if motion.kinks.size:
        corners = []
        for corner in pitch.corners(1e-4):
            off = (np.arctan2(corner.point[1], corner.point[0]) - motion.kinks + np.pi) % TURN - np.pi
            if corner.turn > 0 and np.any(np.abs(off) < 1e-6):
                corners.append(corner)
        if corners:
            sharpest = max(corners, key=lambda c: c.turn)
            radius, point = 0.0, sharpest.point
            place = Message("{place}, corner {turn:.1f}°", place=polar_place(point), turn=np.degrees(sharpest.turn))
    # What is sharper than the follower is undercut; that is sized as lost lift, and bearable if the loss is.
    lost = max((loss.lift for loss in losses if loss.trim.kind == TrimKind.LOCAL), default=0.0)
    angle = float(np.arctan2(point[1], point[0])) % TURN
    return Check(
        CheckCode.CONVEX_RADIUS_THEORY,
        Message("convex radius, theory"),
        radius,
        "mm",
        follower.radius if lost > limits.lost_lift else 0.0,
        Bound.MIN,
        place,
        Message(
            "a convex part sharper than the {follower} is undercut: {softer}, {milder}",
            follower=Message(follower.noun),
            softer=motion.softer(angle, limits.motion_key),
            milder=follower.milder,
        ),
    )


def _undercut(motion: Motion, follower: Follower, losses: list[Loss], limits: CheckLimits) -> list[Check]:
    checks = []
    for code, name, kind, reason in (
        (
            CheckCode.LOST_LIFT_UNDERCUT,
            Message("lost lift, undercut"),
            TrimKind.LOCAL,
            Message("no profile gives this lift to this {follower}", follower=Message(follower.noun)),
        ),
        (
            CheckCode.LOST_LIFT_CROSSING,
            Message("lost lift, crossing"),
            TrimKind.GLOBAL,
            Message("two flanks cut each other off"),
        ),
        (CheckCode.LOST_LIFT_FACE_CHANGE, Message("lost lift, face change"), TrimKind.FACE_CHANGE, ""),
    ):
        if kind == TrimKind.FACE_CHANGE and len(follower.planes) < 2:
            continue  # in one plane there is no other face to go over to
        of_kind = [loss for loss in losses if loss.trim.kind == kind]
        worst = max(of_kind, key=lambda loss: loss.lift, default=None)
        place = (
            Message("none")
            if worst is None
            else Message("{place} ({count} in all)", place=cam_place(worst.cam_angle), count=len(of_kind))
        )
        value = 0.0 if worst is None else worst.lift * 1e3
        softer = "" if worst is None else motion.softer(float(worst.cam_angle), limits.motion_key)
        advice = (
            Message("{reason}: {softer}", reason=reason, softer=softer)
            if reason
            else Message("make the disc thinner (cam.thickness_mm) or {softer}", softer=softer)
        )
        checks.append(Check(code, name, value, "µm", limits.lost_lift * 1e3, Bound.MAX, place, advice))
    return checks


def _contact(follower: Follower, contact: Contact, error: Array, trimmed: NDArray[np.bool_]) -> list[Check]:
    checks = []
    for code, name, beyond in (
        (CheckCode.PUSHED_OUT, Message("{follower} pushed out", follower=Message(follower.noun)), error),
        (
            CheckCode.FALLS_SHORT,
            Message("{follower} falls short", follower=Message(follower.noun)),
            np.where(trimmed, 0.0, -error),
        ),
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
                Message(
                    "this profile is not the {follower}'s envelope: use --profile actual, or, if it is that one, "
                    "correct the kind of follower, whose envelope and contact disagree",
                    follower=Message(follower.noun),
                ),
            )
        )
    return checks


def seam_check(motion: Motion, at: float, code: StrEnum = CheckCode.CLOSURE, name: str = Message("closure ")) -> Check:
    """Check of the jumps of a motion and its first two derivatives at a seam, as where the turn closes.

    A derivative that is meant to jump there, by the law of a segment, is left out.

    Args:
        motion: motion wanted.
        at: cam angle of the seam, rad.
        code: code of the check.
        name: name of the check.
    """
    dense = np.linspace(0.0, TURN, STATIONS, endpoint=False)
    breaks, coefficients = motion.q.x, motion.q.c
    left = (int(np.searchsorted(breaks, at)) - 1) % (len(breaks) - 1)
    right = (left + 1) % (len(breaks) - 1)
    width = breaks[left + 1] - breaks[left]
    worst = 0.0
    for order in range(motion.continuous(at)):
        ends = np.polyder(coefficients[:, left], order), np.polyder(coefficients[:, right], order)
        jump = abs(float(np.polyval(ends[0], width)) - float(np.polyval(ends[1], 0.0)))
        # On a circle the derivatives are rounding: what is small beside the lift itself is no jump.
        scale = max(float(np.max(np.abs(motion.q(dense, nu=some)))) for some in {0, order})
        worst = max(worst, jump / scale if scale > 0 else jump)
    return Check(
        code,
        name,
        worst,
        "",
        CLOSURE_LIMIT,
        Bound.MAX,
        cam_place(at),
        Message("lift, slope and second derivative must not jump: report this design"),
    )


def _least_convex_radius(curve: ClosedCurve) -> tuple[float, Array]:
    least, point = np.inf, curve.pieces[0].jet(np.array([curve.pieces[0].start])).point[0]
    for piece in curve.pieces:
        t = np.linspace(piece.start, piece.stop, STATIONS)
        for zoom in range(_ZOOMS):
            jet = piece.jet(t)
            worst = int(np.argmax(jet.curvature))
            radius = 1 / float(jet.curvature[worst]) if jet.curvature[worst] > 0 else np.inf
            if radius < least - (_SHOWS if zoom else 0.0):
                least, point = radius, jet.point[worst]
            elif zoom == 0:
                break  # another piece is sharper
            t = np.linspace(t[max(worst - 1, 0)], t[min(worst + 1, len(t) - 1)], _ZOOM)
    return least, point
