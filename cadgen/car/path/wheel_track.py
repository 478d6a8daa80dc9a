"""The drive wheel's track: the planned path offset sideways, by arc length, with signed curvature."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PPoly

from cadgen.arrays import Array, gauss_nodes
from cadgen.car.path.spline import PlannedPath
from cadgen.curves.piecewise import quintic_hermite
from cadgen.errors import DesignError
from cadgen.messages import Message

# 64 intervals a span keep the sixth-order interpolation error under 1e-9 of the curvature on the paper's path, and the
# lift within 5e-7 um; 16 keep it within 0.002 um and serve a path of many waypoints. Eight Gauss points make the arc
# length exact to rounding.
INTERVALS_PER_SPAN = 64
LEAST_INTERVALS = 16
MOST_NODES = 24_000
_ROUNDING = 64 * np.finfo(float).eps  # of a waypoint, as a share of the path's greatest coordinate
GAUSS_POINTS = 8
_NEARLY_ONE = 0.01  # share of the usual distance of two points below which they are one that was given twice
_BLOCK = 20_000  # nodes whose arc lengths are integrated at once


@dataclass(frozen=True)
class Track:
    """The path of the drive wheel's contact point, by its own arc length.

    Curvature is positive for a left turn. At a waypoint where the slope of curvature jumps, the node stands
    twice, with the jet of either side.

    Attributes:
        length: arc length of the whole track, mm.
        arc: arc length at the nodes, shape (n,), mm.
        curvature_jets: curvature, its first and second derivative by arc length, shape (n, 3), mm^-1 ...
        position: arc length -> (x, y), mm.
        planned: arc length of this track -> (x, y) of the planned path at the same moment, mm.
        kinks: arc lengths at which the slope of curvature jumps, shape (k,), mm.
        waypoint_arc: arc length of this track at each waypoint, or knot of a path without any, shape (m,), mm.
        turn: travel of the drive wheel in one turn of the cam, mm.
        knot_name: name of the waypoints or knots in messages.
        closed: whether the track ends as it starts: a lap, of which a turn of the cam has a whole number.
        points_key: key of the points that shape the path, for messages.
    """

    length: float
    arc: Array
    curvature_jets: Array
    position: PPoly
    planned: PPoly
    kinks: Array
    waypoint_arc: Array
    turn: float
    knot_name: str = Message("waypoint")
    closed: bool = False
    points_key: str = "path.waypoints_mm"

    @property
    def turn_laps(self) -> int:
        """Laps in one turn of the cam; 1 of an open track."""
        return round(self.turn / self.length) if self.closed else 1

    def heading(self, arc: Array) -> Array:
        """Direction of travel at arc lengths (mm), rad, unwrapped along the array.

        Args:
            arc: arc lengths along the track, mm, shape (n,).
        """
        tangent = self.position(arc, nu=1)
        return np.unwrap(np.arctan2(tangent[..., 1], tangent[..., 0]))

    def where(self, arc: float) -> str:
        """Place on the path at an arc length (mm), in words.

        Args:
            arc: arc length along the track, mm.
        """
        x, y = self.planned(arc)
        span = int(np.clip(np.searchsorted(self.waypoint_arc, arc, side="right"), 1, len(self.waypoint_arc) - 1))
        after = 1 if self.closed and span + 1 == len(self.waypoint_arc) else span + 1
        return Message(
            "at ({x:.0f}, {y:.0f}) mm, between {knot_name}s {span} and {after}",
            x=x,
            y=y,
            knot_name=self.knot_name,
            span=span,
            after=after,
        )


def offset_track(path: PlannedPath, offset: float, turn: float | None = None, *, laps: int | None = None) -> Track:
    """Offset the planned path to the left and return the track by arc length.

    With the planned path's curvature k (eq. 14, with its sign) and left offset m: ds_track = (1 - m k) ds,
    k_track = k / (1 - m k).

    Args:
        path: the planned path.
        offset: distance of the drive wheel to the left of the planned path, mm.
        turn: travel of the drive wheel in one turn of the cam, mm; left out, the whole track.
        laps: laps of a closed path in one turn of the cam, which decide the travel; None of an open path.

    Raises:
        DesignError: the path turns back on itself, or the offset track has a cusp (1 - m k <= 0), with the place.
    """
    # Nodes: every span subdivided, both ends included, so that a waypoint carries a jet from either side.
    intervals = min(max(MOST_NODES // (len(path.knots) - 1), LEAST_INTERVALS), INTERVALS_PER_SPAN)
    fractions = np.linspace(0.0, 1.0, intervals + 1)
    starts, widths = path.knots[:-1], np.diff(path.knots)
    u = starts[:, None] + widths[:, None] * fractions
    # One-sided derivatives: stay inside the span by less than rounding can show.
    inside = np.clip(u, starts[:, None], (starts + widths * (1 - 1e-13))[:, None])
    _refuse_turning_back(path, inside)
    position, tangent, _, k, k1, k2 = _jets(path, inside.ravel())
    _refuse_cusp(path, offset, u.ravel(), position, k)

    rows = max(1, _BLOCK // intervals)
    steps = np.concatenate([_arc_steps(path, offset, block) for block in np.split(u, range(rows, len(u), rows))])
    span_arc = np.concatenate([np.zeros((len(starts), 1)), np.cumsum(steps, axis=1)], axis=1)
    span_start = np.concatenate([[0.0], np.cumsum(span_arc[:, -1])])
    arc = (span_arc + span_start[:-1, None]).ravel()

    shrink = 1.0 - offset * k
    curvature = np.stack([k / shrink, k1 / shrink**3, k2 / shrink**4 + 3 * offset * k1**2 / shrink**5], axis=1)
    normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
    wheel = np.stack([position + offset * normal, tangent, curvature[:, :1] * normal], axis=1)
    # The planned point moves 1/(1 - m k) as far; its second derivative follows by the product rule.
    planned = np.stack(
        [
            position,
            tangent / shrink[:, None],
            (k / shrink**2)[:, None] * normal + (offset * k1 / shrink**3)[:, None] * tangent,
        ],
        axis=1,
    )
    length = float(span_start[-1])
    return Track(
        length=length,
        arc=arc,
        curvature_jets=curvature,
        position=quintic_hermite(arc, wheel),
        planned=quintic_hermite(arc, planned),
        kinks=np.array([]) if path.smooth else span_start[1:-1],
        waypoint_arc=span_start,
        turn=length * laps if laps else length if turn is None else turn,
        knot_name=path.knot_name,
        closed=laps is not None,
        points_key=path.points_key,
    )


def _arc_steps(path: PlannedPath, offset: float, u: Array) -> Array:
    """Arc length of the track between neighbouring parameters of each row, mm, by Gauss quadrature."""
    nodes, weights = gauss_nodes(GAUSS_POINTS)
    middle, half = (u[:, :-1] + u[:, 1:]) / 2, np.diff(u, axis=1) / 2
    quad_u = middle[..., None] + half[..., None] * nodes
    _, _, speed, k, _, _ = _jets(path, quad_u.ravel())
    rate = (speed * (1.0 - offset * k)).reshape(quad_u.shape)
    return np.asarray((rate @ weights) * half)


def _jets(path: PlannedPath, u: Array) -> tuple[Array, Array, Array, Array, Array, Array]:
    """Position, unit tangent, speed, and curvature with two derivatives by the path's own arc length."""
    r, r1, r2, r3, r4 = path.derivatives(u)
    speed = np.linalg.norm(r1, axis=1)
    dot12 = np.einsum("ij,ij->i", r1, r2)
    speed1 = dot12 / speed
    speed2 = (np.einsum("ij,ij->i", r2, r2) + np.einsum("ij,ij->i", r1, r3) - speed1**2) / speed
    cross, cross1, cross2 = _cross(r1, r2), _cross(r1, r3), _cross(r2, r3) + _cross(r1, r4)
    straight = _straight(path, u, (r, r1, r2, r3, r4), (cross, cross1, cross2))
    cross, cross1, cross2 = (np.where(straight, 0.0, product) for product in (cross, cross1, cross2))
    return r, r1 / speed[:, None], speed, *curvatures(speed, speed1, speed2, (cross, cross1, cross2))


def curvatures(
    speed: Array, speed1: Array, speed2: Array, crosses: tuple[Array, Array, Array]
) -> tuple[Array, Array, Array]:
    """Curvature with two derivatives by the arc length, shape (m,) each, 1/mm, 1/mm^2, 1/mm^3.

    With k = r' x r'' / v^3, differentiated by the parameter and then by the arc length. Real or complex.

    Args:
        speed: v = |r'|, shape (m,), mm.
        speed1: v', shape (m,), mm.
        speed2: v'', shape (m,), mm.
        crosses: r' x r'' and its two derivatives by the parameter, shape (m,) each, mm^2.
    """
    cross, cross1, cross2 = crosses
    k = cross / speed**3
    k_u = cross1 / speed**3 - 3 * k * speed1 / speed
    k_uu = (
        cross2 / speed**3
        - 3 * cross1 * speed1 / speed**4
        - 3 * k_u * speed1 / speed
        - 3 * k * (speed2 / speed - speed1**2 / speed**2)
    )
    return k, k_u / speed, (k_uu - k_u * speed1 / speed) / speed**2


def _cross(a: Array, b: Array) -> Array:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def _straight(path: PlannedPath, u: Array, derivatives: tuple[Array, ...], products: tuple[Array, ...]) -> Array:
    """Where the path turns by no more than the rounding of its waypoints, shape (n,).

    A straight path that hardly moves with its parameter would else seem to turn. A cross product of two derivatives
    errs by each factor times the other's rounding, which is that of the waypoints over a power of the span's width.
    """
    span = np.clip(np.searchsorted(path.knots, u, side="right") - 1, 0, len(path.knots) - 2)
    width = np.diff(path.knots)[span]
    size = [np.abs(each).max(axis=1) for each in derivatives]
    noise = [_ROUNDING * float(size[0].max()) / width**order for order in range(5)]
    pairs = (((1, 2),), ((1, 3),), ((2, 3), (1, 4)))
    rounding = (sum(size[a] * noise[b] + size[b] * noise[a] for a, b in pair) for pair in pairs)
    within = [np.abs(product) <= most for product, most in zip(products, rounding, strict=True)]
    return np.asarray(np.logical_and.reduce(within))


def _refuse_turning_back(path: PlannedPath, u: Array) -> None:
    """Refuse a path whose tangent turns by more than a right angle between neighbouring parameters of a row of `u`.

    A spline through points that lie on a line and run back and forth stops and reverses there. Its curvature is zero
    on both sides, so nothing else shows that no car can follow it.
    """
    rate = path.spline(u, nu=1)
    back = np.argwhere(np.einsum("ijk,ijk->ij", rate[:, :-1], rate[:, 1:]) <= 0)
    if not back.size:
        return
    row, column = back[0].tolist()
    x, y = path.spline(u[row, column])
    knots = path.spline(path.knots)
    nearest = int(np.argmin(np.hypot(knots[:, 0] - x, knots[:, 1] - y)[row : row + 2])) + row
    _refuse_near_double(path, row)
    raise DesignError(
        "the path turns back on itself at ({x:.0f}, {y:.0f}) mm, by {knot_name} {number}, and a car cannot: put the "
        "points in the order in which they are driven, or lead the path round a turn ({points_key})",
        x=x,
        y=y,
        knot_name=path.knot_name,
        number=nearest + 1,
        points_key=path.points_key,
    )


def _refuse_near_double(path: PlannedPath, span: int) -> None:
    """Refuse two points that are nearly one, beside the place of a fault that they cause: in a span or next to it."""
    if path.points_key != PlannedPath.points_key:
        return  # its knots are no points that are given
    knots = path.spline(path.knots)
    chords = np.hypot(*np.diff(knots, axis=0).T)
    first = max(0, span - 1)
    short = first + int(np.argmin(chords[first : span + 2]))
    if chords[short] >= _NEARLY_ONE * np.median(chords):
        return
    raise DesignError(
        "{knot_name}s {first} and {second} are {apart:.2g} mm apart, at ({x:.0f}, {y:.0f}) mm, so that the path turns "
        "too sharply there: remove one of them ({points_key})",
        knot_name=path.knot_name,
        first=short + 1,
        second=short + 2,
        apart=float(chords[short]),
        x=knots[short, 0],
        y=knots[short, 1],
        points_key=path.points_key,
    )


def _refuse_cusp(path: PlannedPath, offset: float, u: Array, position: Array, k: Array) -> None:
    shrink = 1.0 - offset * k
    worst = int(np.argmin(shrink))
    if shrink[worst] > 0 and np.isfinite(k).all():
        return
    span = int(np.clip(np.searchsorted(path.knots, u[worst], side="right"), 1, len(path.knots) - 1))
    _refuse_near_double(path, span - 1)
    side = Message("left") if k[worst] > 0 else Message("right")
    raise DesignError(
        "the path turns {side} with a radius of {radius:.1f} mm at ({x:.0f}, {y:.0f}) mm, "
        "between {knot_name}s {span} and {span2}, but the drive wheel runs {offset:.1f} mm inside "
        "it, so its track has a cusp there: lead the path through a wider turn ({points_key})",
        side=side,
        radius=1 / abs(k[worst]),
        x=position[worst, 0],
        y=position[worst, 1],
        knot_name=path.knot_name,
        span=span,
        span2=span + 1,
        offset=abs(offset),
        points_key=path.points_key,
    )
