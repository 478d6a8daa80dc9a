"""Formulas of a follower, held against the outline that it has rolled on and against how it rolls.

What is compared is found without the formula that it judges. Let n be the outward normal of the outline at a contact,
by the curve itself. The follower clears a point from `Follower.least` on, so a displacement of the outline along n
moves it by d least / d n, and

    V = 1 / (d least / d n)

is how fast its touching curve moves along n, by its motion. It is the normal component of a velocity. On a slide that
is one vector d for all contacts, V = n . d; on an arm a turn about one pivot C, V = +-n . i (p - C). Either is found
from all contacts together by least squares, and the pressure angle is the angle from n to the velocity. Its sign is a
kind's choice and is taken from the formula.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Contact, Follower
from cadgen.cam.round_follower import Complex, RoundFollower
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve, Jet
from cadgen.errors import DesignError
from cadgen.laws.motion import Motion
from cadgen.laws.unit import RAD
from cadgen.messages import Message

# Codes of the checks below, which are there only where they fail.
FORMULAS = (
    CheckCode.CONTACT_FORMULA,
    CheckCode.PRESSURE_ANGLE_FORMULA,
    CheckCode.LIFT_FORMULA,
    CheckCode.PUSH_FORMULA,
    CheckCode.RADIUS_FORMULA,
    CheckCode.CURVATURE_FORMULA,
    CheckCode.BOUND_FORMULA,
    CheckCode.STANDING_FORMULA,
    CheckCode.NORMAL_FORMULA,
)
# Allowed differences. A rolled angle errs by 2e-5 rad, and a contact across the follower's line by as much of its
# radius; the contact of what leans is not refined for its angle.
ANGLE_LIMIT_DEG, LEANING_LIMIT_DEG = 0.05, 0.5
PLACE_LIMIT_MM = 0.01
SHARE_LIMIT = 1e-3  # of a displacement along the normal
CURVATURE_LIMIT = 1e-2  # of a curvature at a rolled contact, or by points beside each other
BOUND_LIMIT_MM = 1e-6
_STATIONS = 360  # at most, of those that were rolled
_APART = np.radians(0.5)  # from a kink, where the normal turns; the other side of a bend has another curvature
_STEP = 1e-3  # of the follower's radius, or mm, by which an outline is displaced for a derivative
_RANK = 1e-4  # ratio of singular values; below it the normals are too nearly parallel to tell a second component
_FIT = 1e-4  # of a velocity; what the one vector, or the one pivot, may leave unexplained
_LIFT_SCALE = 2.0  # an arm of a given lever has a lift that differs from the way of its contact, but not by as much
# Share of the stations that may lie beyond a limit: close to a cusp or an edge a rolled contact errs by more.
_SPARED = 0.03
_BESIDE = 1e-4  # rad of polar angle between points of the outline for its direction and its curvature
_AROUND, _SIDES = (0.02, 0.5), 8  # mm about a contact, and directions, in which the bound of the rolling is tried


def formula_checks(
    motion: Motion, follower: Follower, curve: ClosedCurve, contact: Contact, sound: NDArray[np.bool_]
) -> tuple[Check, ...]:
    """Failing checks of a follower's formulas: none where all are right or cannot be judged.

    Args:
        motion: motion wanted.
        follower: follower that was rolled.
        curve: outline that it was rolled on, mm.
        contact: contact of the two.
        sound: stations where the outline is the follower's envelope and not trimmed, shape (n,).
    """
    off = (contact.cam_angle[:, None] - motion.kinks + np.pi) % TURN - np.pi
    rows = np.flatnonzero(sound & (np.abs(off) > _APART).all(axis=1))
    rows = rows[:: max(1, len(rows) // _STATIONS)]
    if not rows.size:
        return ()
    contact = contact.at(rows)
    return tuple(_failing(motion, follower, contact, curve))


def _failing(motion: Motion, follower: Follower, contact: Contact, curve: ClosedCurve) -> Iterator[Check]:
    theta = contact.cam_angle
    place = follower.place(contact) % TURN
    # All at once, since each look-up begins with a table of the whole curve.
    ways = np.array([[0.0], [-_BESIDE], [_BESIDE]])
    jets, owners = curve.at_angle((place + ways).ravel() % TURN)
    jet, before, after = (Jet(*columns) for columns in zip(*(np.split(column, 3) for column in jets), strict=True))
    owner, behind, ahead = np.split(owners, 3)
    inside = (owner == behind) & (owner == ahead)
    back = np.exp(-1j * (theta + follower.azimuth))
    point: Complex = (jet.point @ [1, 1j]) * back
    normal: Complex = -1j * (jet.velocity @ [1, 1j]) * back
    normal = normal / np.abs(normal) * (-1.0 if follower.encloses else 1.0)  # out of the metal

    told = follower.ahead(contact.q, contact.face, contact.across) + 1j * contact.across
    if (worst := _beyond(np.abs(told - point), PLACE_LIMIT_MM)) is not None:
        yield _wrong(
            CheckCode.CONTACT_FORMULA,
            Message("contact, by two ways"),
            float(np.abs(told - point)[worst]),
            "mm",
            PLACE_LIMIT_MM,
            Message(
                "cam angle {angle:.2f}°: {one:.4g} mm ahead of the camshaft by the formula, {other:.4g} mm by the "
                "outline",
                angle=np.degrees(theta[worst]),
                one=float(told[worst].real),
                other=float(point[worst].real),
            ),
            follower,
            "ahead",
        )
        return
    yield from _outline(follower, contact, jet, (before, after), inside)
    yield from _bound(follower, point)
    rate = _rate(follower, contact, point, normal)
    found = _velocity(follower, contact, point, normal, rate)
    if found is not None:
        yield from _angle(follower, contact, normal, found)
        yield from _lift(follower, contact, found)
    if isinstance(follower, RoundFollower):
        yield from _standing(follower, contact, point + follower.radius * normal)
    yield from _of_forces(motion, follower, contact, rate, jet.curvature)
    try:
        stated = follower.normal(motion.q(theta), motion.q(theta, nu=1))
    except DesignError:  # errors of the lift are refused for this kind
        return
    off = np.degrees(np.abs(np.angle(stated * normal.conj() * (-1.0 if follower.encloses else 1.0))))
    if (worst := _beyond(off, ANGLE_LIMIT_DEG)) is not None:
        yield _wrong(
            CheckCode.NORMAL_FORMULA,
            Message("normal of the outline, by two ways"),
            float(off[worst]),
            "°",
            ANGLE_LIMIT_DEG,
            Message("cam angle {angle:.2f}°", angle=np.degrees(theta[worst])),
            follower,
            "normal",
        )


def _outline(
    follower: Follower, contact: Contact, jet: Jet, beside: tuple[Jet, Jet], inside: NDArray[np.bool_]
) -> Iterator[Check]:
    """Curvature of the envelope, by how its direction turns from point to point."""
    before, after = (each.velocity @ [1, 1j] for each in beside)
    way = np.linalg.norm(beside[1].point - beside[0].point, axis=1)
    bent = np.angle(after * before.conj()) / way
    scale = np.abs(jet.curvature) + 1 / np.linalg.norm(jet.point, axis=1)
    off = np.where(inside, np.abs(bent - jet.curvature) / scale, 0.0)
    if (worst := _beyond(off, CURVATURE_LIMIT)) is not None:
        yield _wrong(
            CheckCode.CURVATURE_FORMULA,
            Message("curvature of the envelope, by two ways"),
            float(off[worst]),
            "",
            CURVATURE_LIMIT,
            Message(
                "cam angle {angle:.2f}°: {one:.4g}/mm by the formula, {other:.4g}/mm by its points",
                angle=np.degrees(contact.cam_angle[worst]),
                one=float(jet.curvature[worst]),
                other=float(bent[worst]),
            ),
            follower,
            "piece or centre or face_jet",
        )


def _bound(follower: Follower, point: Complex) -> Iterator[Check]:
    """Bound of the rolling over all points near a point, by points about it."""
    if follower.radius == 0:
        return
    worst = 0.0
    for off in _AROUND:
        bounds = follower.most(np.asarray(point.real), np.asarray(point.imag), np.full(len(point), off))
        for way in off * np.exp(1j * np.linspace(0.0, TURN, _SIDES, endpoint=False)):
            asked = follower.least((point + way).real, (point + way).imag)
            for bound, one in zip(bounds, asked, strict=True):
                asking = np.isfinite(one)
                short = follower.lift(one[asking]) - follower.lift(bound[asking])
                worst = max(worst, float(np.nanmax(short, initial=0.0)))
    if worst > BOUND_LIMIT_MM:
        yield _wrong(
            CheckCode.BOUND_FORMULA,
            Message("bound of the rolling, fallen short of by"),
            worst,
            "mm",
            BOUND_LIMIT_MM,
            "",
            follower,
            "most",
        )


def _standing(follower: RoundFollower, contact: Contact, centre: Complex) -> Iterator[Check]:
    """Place of the centre by its distance from the camshaft, which the theoretical profile is rolled by."""
    lift, aside = follower.standing(np.abs(centre))
    off = np.maximum(np.abs(lift - contact.lift), np.abs(aside - np.angle(centre)) * np.abs(centre))
    off = np.maximum(off, np.abs(follower.distance(contact.q, contact.face) - centre.real))
    if (worst := _beyond(off, PLACE_LIMIT_MM)) is not None:
        yield _wrong(
            CheckCode.STANDING_FORMULA,
            Message("place of the centre, by two ways"),
            float(off[worst]),
            "mm",
            PLACE_LIMIT_MM,
            Message(
                "cam angle {angle:.2f}°: a lift of {one:.4g} mm by the formula, {other:.4g} mm rolled",
                angle=np.degrees(contact.cam_angle[worst]),
                one=float(lift[worst]),
                other=float(contact.lift[worst]),
            ),
            follower,
            "standing or distance",
        )


def _angle(follower: Follower, contact: Contact, normal: Complex, velocities: list[Complex]) -> Iterator[Check]:
    """Pressure angle; a kind chooses which sign is positive, and a circle on an arm which of two points is pressed."""
    angles = [np.angle(each * normal.conj()) for each in velocities]
    given = contact.pressure_angle
    _, angle = min(
        ((float(np.abs(given - sign * each).max()), sign * each) for each in angles for sign in (1, -1)),
        key=lambda pair: pair[0],
    )
    limit = LEANING_LIMIT_DEG if follower.leans else ANGLE_LIMIT_DEG
    if (worst := _beyond(np.degrees(np.abs(given - angle)), limit)) is not None:
        yield _wrong(
            CheckCode.PRESSURE_ANGLE_FORMULA,
            Message("pressure angle, by two ways"),
            float(np.degrees(np.abs(given - angle)[worst])),
            "°",
            limit,
            Message(
                "cam angle {angle:.2f}°: {one:.3f}° by the formula, {other:.3f}° by outline and motion",
                angle=np.degrees(contact.cam_angle[worst]),
                one=float(np.degrees(given[worst])),
                other=float(np.degrees(angle[worst])),
            ),
            follower,
            "pressed or pressure_angle",
        )


def _lift(follower: Follower, contact: Contact, velocities: list[Complex]) -> Iterator[Check]:
    """Check of the scale of the lift, for errors of files are given as lift."""
    slope = _slope(follower, contact.q)
    speed = np.abs(velocities[0])  # by the motion's unit
    ratio = float(np.median(np.abs(slope) / speed))
    ratio = max(ratio, 1 / ratio) if ratio > 0 else np.inf
    if not ratio < _LIFT_SCALE:
        yield _wrong(
            CheckCode.LIFT_FORMULA,
            Message("lift, by two ways"),
            ratio,
            "",
            _LIFT_SCALE,
            Message(
                "a unit of the motion is {one:.4g} mm of lift by the formula, and {other:.4g} mm of way",
                one=float(np.median(np.abs(slope))),
                other=float(np.median(speed)),
            ),
            follower,
            "lift and of_lift",
        )


def _of_forces(motion: Motion, follower: Follower, contact: Contact, rate: Array, curvature: Array) -> Iterator[Check]:
    """Displacement along the normal and radius of the profile, for forces, of a kind that has them."""
    theta = contact.cam_angle
    q, q1, q2 = (motion.q(theta, nu=order) for order in range(3))
    off = (theta[:, None] - motion.bends + np.pi) % TURN - np.pi
    smooth = (np.abs(off) > _APART).all(axis=1)
    scale = np.abs(curvature) + 1 / np.median(np.abs(contact.lift) + follower.base_radius)

    def of_push() -> tuple[Array, Array, Array]:
        push = follower.push(q, q1)
        return push, rate, np.abs(np.abs(push) / rate - 1)

    def of_radius() -> tuple[Array, Array, Array]:
        radius = np.asarray(follower.profile_radius(q, q1, q2))
        with np.errstate(divide="ignore"):
            return radius, 1 / curvature, np.where(smooth, np.abs(1 / radius - curvature) / scale, 0.0)

    for code, name, derive, limit, member in (
        (CheckCode.PUSH_FORMULA, Message("way along the normal, by two ways"), of_push, SHARE_LIMIT, "push"),
        (
            CheckCode.RADIUS_FORMULA,
            Message("radius of the profile, by two ways"),
            of_radius,
            CURVATURE_LIMIT,
            "profile_radius",
        ),
    ):
        try:
            stated, found, off_by = derive()
        except DesignError:  # forces are refused for this kind
            continue
        if (worst := _beyond(off_by, limit)) is not None:
            yield _wrong(
                code,
                name,
                float(off_by[worst]),
                "",
                limit,
                Message(
                    "cam angle {angle:.2f}°: {one:.4g} mm by the formula, {other:.4g} mm by the outline",
                    angle=np.degrees(theta[worst]),
                    one=float(stated[worst]),
                    other=float(found[worst]),
                ),
                follower,
                member,
            )


def _slope(follower: Follower, q: Array) -> Array:
    """Slope of the lift, mm by the motion's unit, shape (n,), by differences."""
    step = 1e-6
    return np.asarray((follower.lift(q + step) - follower.lift(q - step)) / (2 * step))


def _rate(follower: Follower, contact: Contact, point: Complex, normal: Complex) -> Array:
    """How fast the touching curve moves along the normal, mm by the motion's unit, shape (n,)."""
    if follower.radius == 0:
        return np.asarray((normal.conj() * _way_of_point(follower, point)).real)
    step = _STEP * min(follower.radius, 1.0)
    plane = np.argmin(np.abs(np.asarray(follower.planes)[:, None] - contact.face), axis=0)
    out, into = (
        np.stack(follower.least((point + side * step * normal).real, (point + side * step * normal).imag))
        for side in (1, -1)
    )
    rows = np.arange(len(point))
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(2 * step / (out - into)[plane, rows])


def _way_of_point(follower: Follower, point: Complex) -> Complex:
    """Velocity of a follower that is a point, mm by the motion's unit, shape (n,), by where it stands."""
    distance = np.abs(point)
    step = _STEP
    stands = []
    for side in (1, -1):
        lift, aside = follower.standing(distance + side * step)
        stands.append((follower.of_lift(lift)[0], (distance + side * step) * np.exp(1j * aside)))
    (q, z), (q_before, z_before) = stands
    return np.asarray((z - z_before) / (q - q_before))


def _velocity(
    follower: Follower, contact: Contact, point: Complex, normal: Complex, rate: Array
) -> list[Complex] | None:
    """Velocities of the points on which the force may act, mm by the motion's unit; None where no velocity fits."""
    if not np.isfinite(rate).all():
        return None
    if follower.radius == 0:
        return [_way_of_point(follower, point)]
    slope = _slope(follower, contact.q)  # on a slide the lift is its way
    if follower.leans:
        # The axis of a straight rod moves level, and the force is square to it: of the outline's normal in the plane of
        # the disc the part along the ray is longer by the lean.
        lean = np.arctan2(normal.imag, normal.real * np.hypot(1.0, contact.q))
        way: Complex = np.exp(-1j * lean) * normal * slope
        return [way]
    if follower.unit == RAD:
        return _turning(follower, point, normal, rate)
    speed = rate / slope
    components = np.column_stack([normal.real, normal.imag])
    line, _, _, singular = np.linalg.lstsq(components, speed, rcond=None)
    if singular[1] > _RANK * singular[0] and np.abs(components @ line - speed).max() < _FIT:
        return [np.asarray(complex(*line) * slope)]
    # One normal, as of a face, or no slide: the size of the angle is known, and its sign is taken from the formula.
    across = np.sqrt(np.maximum(1.0 - speed**2, 0.0)) * np.sign(contact.pressure_angle)
    return [np.asarray((speed + 1j * across) * normal * slope)]


def _turning(follower: Follower, point: Complex, normal: Complex, rate: Array) -> list[Complex] | None:
    """Velocities on an arm: of the contact, and of the centre of a circle, on which the force of a roller acts."""
    moment = (normal.conj() * 1j * point).real
    best: tuple[float, list[Complex]] | None = None
    for side in (1, -1):
        components = side * np.column_stack([normal.imag, -normal.real])
        pivot, _, _, singular = np.linalg.lstsq(-components, rate - side * moment, rcond=None)
        if singular[1] <= _RANK * singular[0]:
            return None
        left = float(np.abs(rate - side * moment + components @ pivot).max() / np.abs(rate).max())
        acting = [point]
        if isinstance(follower, RoundFollower):
            acting.insert(0, point + follower.radius * normal)
        if best is None or left < best[0]:
            best = left, [np.asarray(side * 1j * (each - complex(*pivot))) for each in acting]
    return best[1] if best is not None and best[0] < _FIT else None


def _beyond(values: Array, limit: float) -> int | None:
    """Number of the greatest value but for the share that is spared, if it is beyond a limit, or is none."""
    values = np.where(np.isfinite(values), values, np.inf)
    worst = int(np.argsort(values)[int((1 - _SPARED) * (len(values) - 1))])
    return worst if values[worst] > limit else None


def _wrong(
    code: CheckCode, name: str, value: float, unit: str, limit: float, place: str, follower: Follower, member: str
) -> Check:
    return Check(
        code,
        name,
        value,
        unit,
        limit,
        Bound.MAX,
        place,
        Message(
            "this is a fault of the follower's formulas and not of the design: correct {member} of the {follower} "
            "({kind})",
            member=member,
            follower=Message(follower.noun),
            kind=type(follower).__qualname__,
        ),
    )
