"""The planned path: a parametric spline through waypoints, or by control points."""

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import BSpline, make_interp_spline

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.messages import Message

MIN_WAYPOINTS = 4  # the cubic's end slope is that of the cubic through the first four
MIN_LAP_WAYPOINTS = 5  # fewer leave a periodic spline of degree 5 nothing to interpolate
MIN_CHORD_MM = 1e-6  # below this two waypoints are one, and the centripetal parameter stalls
_WAYPOINTS = "path.waypoints_mm", Message("waypoint")
_CONTROL_POINTS = "path.control_points_mm", Message("point")
DEGREE = 5  # of a path by control points: its rate of curvature is smooth, as that of the sixth-order spline


class SplineKind(StrEnum):
    """Spline through waypoints: of degree 5, with a continuous rate of curvature, or of 3, whose rate has kinks."""

    QUINTIC = "quintic"
    CUBIC = "cubic"


@dataclass(frozen=True)
class PlannedPath:
    """A parametric curve u -> (x, y) with its first four derivatives.

    Attributes:
        knots: parameters between which the curve is a polynomial, shape (n,): those of the waypoints, if it has any.
        spline: vector-valued B-spline on [knots[0], knots[-1]].
        smooth: True when curvature has a continuous slope at the knots.
        knot_name: name of the curve's points at its knots, in messages.
        points_key: key of the points that shape the curve, for messages.
    """

    knots: Array
    spline: BSpline
    smooth: bool
    knot_name: str = Message("waypoint")
    points_key: str = "path.waypoints_mm"

    def derivatives(self, u: Array) -> Array:
        """Position and first four derivatives by u, shape (5, n, 2); beyond the spline's degree they vanish.

        Args:
            u: parameters, shape (n,).
        """
        return np.stack([self.spline(u, nu=order) for order in range(5)])


def plan_path(waypoints: ArrayLike, kind: SplineKind) -> PlannedPath:
    """Interpolate the waypoints.

    `quintic` is the sixth-order spline of the paper's section 2.3: degree 5, natural (third and fourth
    derivative zero at both ends), centripetal parameter (square roots of the chords; Lee 1989). `cubic` is that
    of the paper's appendix: degree 3, uniform parameter, initial slope equal to that of the cubic through the
    first four waypoints, zero second derivative at the end.

    Args:
        waypoints: points in driving order, shape (n, 2), mm, n >= 4. The path may cross itself.
        kind: kind of spline, `quintic` or `cubic`.

    Raises:
        DesignError: too few waypoints, a value that is not finite, or two equal neighbours.
    """
    points = _checked(waypoints, _WAYPOINTS, MIN_WAYPOINTS)
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    # The stubs of scipy know only scalar end conditions; its documentation has lists of (order, value).
    zero = np.zeros(2)
    if kind == SplineKind.QUINTIC:
        knots = np.concatenate([[0.0], np.cumsum(np.sqrt(chords))])
        natural = [(3, zero), (4, zero)]
        spline = make_interp_spline(knots, points, k=5, bc_type=(natural, natural))  # type: ignore[arg-type]
    else:
        knots = np.arange(len(points), dtype=float)
        # Derivative at 0 of the cubic through u = 0, 1, 2, 3.
        slope = np.array([-11.0, 18.0, -9.0, 2.0]) @ points[:4] / 6.0
        spline = make_interp_spline(knots, points, k=3, bc_type=([(1, slope)], [(2, zero)]))  # type: ignore[arg-type]
    return PlannedPath(knots=knots, spline=spline, smooth=kind == SplineKind.QUINTIC)


def plan_lap(waypoints: ArrayLike) -> PlannedPath:
    """Interpolate the waypoints of a closed path by the periodic spline of degree 5 with the centripetal parameter.

    It goes on past the last waypoint to the first, where its fourth derivative is continuous as at the others.

    Args:
        waypoints: points in driving order, shape (n, 2), mm, n >= 5; the first may stand at the end again.

    Raises:
        DesignError: too few waypoints, a value that is not finite, or two equal neighbours.
    """
    distinct = _once(_checked(waypoints, _WAYPOINTS, MIN_LAP_WAYPOINTS), _WAYPOINTS, MIN_LAP_WAYPOINTS)
    points = np.vstack([distinct, distinct[:1]])
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    knots = np.concatenate([[0.0], np.cumsum(np.sqrt(chords))])
    spline = make_interp_spline(knots, points, k=DEGREE, bc_type="periodic")
    return PlannedPath(knots=knots, spline=spline, smooth=True)


def path_knots(count: int) -> Array:
    """Knots of a path by control points: 0, 1, 2, ..., count - 5, the ends sixfold; shape (count + 6,)."""
    spans = count - DEGREE
    return np.concatenate([np.zeros(DEGREE), np.arange(spans + 1.0), np.full(DEGREE, float(spans))])


def control_path(points: ArrayLike) -> PlannedPath:
    """Return the B-spline of degree 5 by its control points, over the knots of `path_knots`.

    It starts on the first point towards the second and ends on the last, coming from the one before. Its third
    derivative is continuous, and so are the curvature of the path and its slope. The curvature lies close to what the
    points' polygon shows (de Boor, A Practical Guide to Splines, ch. IX-XI).

    Args:
        points: control points in driving order, shape (n, 2), mm, n >= 6.

    Raises:
        DesignError: too few points, a value that is not finite, or two equal neighbours.
    """
    control = _checked(points, _CONTROL_POINTS, DEGREE + 1)
    knots = path_knots(len(control))
    spline = BSpline(knots, control, DEGREE)
    knots = knots[DEGREE:-DEGREE]
    return PlannedPath(
        knots=knots, spline=spline, smooth=True, knot_name=Message("knot"), points_key=_CONTROL_POINTS[0]
    )


def closed_control_path(points: ArrayLike) -> PlannedPath:
    """Return the closed B-spline of degree 5 by its control points, over the knots 0, 1, 2, ..., n.

    Its fourth derivative is continuous everywhere. It starts at the mean of the first point (weight 66 of 120), of its
    two neighbours (26 each) and of theirs (1 each).

    Args:
        points: control points in driving order, shape (n, 2), mm, n >= 6; the first may stand at the end again.

    Raises:
        DesignError: too few points, a value that is not finite, or two equal neighbours.
    """
    control = _once(_checked(points, _CONTROL_POINTS, DEGREE + 1), _CONTROL_POINTS, DEGREE + 1)
    count = len(control)
    spline = BSpline(lap_knots(count), control[lap_columns(np.arange(count + DEGREE), count)], DEGREE)
    knots = np.arange(count + 1.0)
    return PlannedPath(
        knots=knots, spline=spline, smooth=True, knot_name=Message("knot"), points_key=_CONTROL_POINTS[0]
    )


def lap_knots(count: int) -> Array:
    """Knots of a closed path by control points: -5, -4, ..., count + 5; shape (count + 11,)."""
    return np.arange(-DEGREE, count + DEGREE + 1.0)


def lap_columns(number: NDArray[np.intp], count: int) -> NDArray[np.intp]:
    """Control points of a closed path that the B-splines over its knots belong to, by the B-splines' numbers."""
    return np.asarray((number - DEGREE // 2) % count)


def _checked(given: ArrayLike, name: tuple[str, str], least: int) -> Array:
    """Refuse points that make no path, by the key and the word of `name`."""
    key, word = name
    points = np.asarray(given, dtype=float)
    if points.ndim != 2 or points.shape[1] != 2:
        raise DesignError("{key} must be a list of [x, y] pairs", key=key)
    if len(points) < least:
        raise DesignError(
            "{key} has {count} {word}s; a path needs at least {least}: add more",
            key=key,
            count=len(points),
            word=word,
            least=least,
        )
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if bad.size:
        raise DesignError(
            "{key}: {word} {number} is not a finite number: correct it", key=key, word=word, number=bad[0] + 1
        )
    equal = np.flatnonzero(np.linalg.norm(np.diff(points, axis=0), axis=1) < MIN_CHORD_MM)
    if equal.size:
        i = equal[0]
        raise DesignError(
            "{key}: {word}s {first} and {second} are both ({x:g}, {y:g}): remove one of them",
            key=key,
            word=word,
            first=i + 1,
            second=i + 2,
            x=points[i, 0],
            y=points[i, 1],
        )
    return points


def _once(points: Array, name: tuple[str, str], least: int) -> Array:
    """The points of a closed path without the first at the end."""
    if np.linalg.norm(points[-1] - points[0]) >= MIN_CHORD_MM:
        return points
    key, word = name
    if len(points) <= least:
        raise DesignError(
            "{key} has {count} {word}s and the first again; a closed path needs at least {least}: add more",
            key=key,
            count=len(points) - 1,
            word=word,
            least=least,
        )
    return points[:-1]
