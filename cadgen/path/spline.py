"""The planned path: a parametric spline through waypoints, or by control points."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.path.names import SplineKind

MIN_WAYPOINTS = 4  # the cubic's end slope is that of the cubic through the first four
MIN_CHORD_MM = 1e-6  # below this two waypoints are one, and the centripetal parameter stalls
DEGREE = 5  # of a path by control points: its rate of curvature is smooth, as that of the sixth-order spline


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
    knot_name: str = "waypoint"
    points_key: str = "path.waypoints_mm"

    def derivatives(self, u: Array) -> Array:
        """Position and first four derivatives by u, shape (5, n, 2); beyond the spline's degree they vanish."""
        return np.stack([self.spline(u, nu=order) for order in range(5)])


def plan_path(waypoints: Array, kind: SplineKind) -> PlannedPath:
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
    waypoints = np.asarray(waypoints, dtype=float)
    if waypoints.ndim != 2 or waypoints.shape[1] != 2:
        raise DesignError("path.waypoints_mm must be a list of [x, y] pairs")
    if len(waypoints) < MIN_WAYPOINTS:
        raise DesignError(
            f"path.waypoints_mm has {len(waypoints)} waypoints; a path needs at least {MIN_WAYPOINTS}: add more"
        )
    bad = np.flatnonzero(~np.isfinite(waypoints).all(axis=1))
    if bad.size:
        raise DesignError(f"path.waypoints_mm: waypoint {bad[0] + 1} is not a finite number: correct it")
    chords = np.linalg.norm(np.diff(waypoints, axis=0), axis=1)
    equal = np.flatnonzero(chords < MIN_CHORD_MM)
    if equal.size:
        i = equal[0]
        raise DesignError(
            f"path.waypoints_mm: waypoints {i + 1} and {i + 2} are both "
            f"({waypoints[i, 0]:g}, {waypoints[i, 1]:g}): remove one of them"
        )
    # The stubs of scipy know only scalar end conditions; its documentation has lists of (order, value).
    zero = np.zeros(2)
    if kind == "quintic":
        knots = np.concatenate([[0.0], np.cumsum(np.sqrt(chords))])
        natural = [(3, zero), (4, zero)]
        spline = make_interp_spline(knots, waypoints, k=5, bc_type=(natural, natural))  # type: ignore[arg-type]
    else:
        knots = np.arange(len(waypoints), dtype=float)
        # Derivative at 0 of the cubic through u = 0, 1, 2, 3.
        slope = np.array([-11.0, 18.0, -9.0, 2.0]) @ waypoints[:4] / 6.0
        spline = make_interp_spline(knots, waypoints, k=3, bc_type=([(1, slope)], [(2, zero)]))  # type: ignore[arg-type]
    return PlannedPath(knots=knots, spline=spline, smooth=kind == "quintic")


def path_knots(count: int) -> Array:
    """Knots of a path by control points: 0, 1, 2, ..., count - 5, the ends sixfold; shape (count + 6,)."""
    spans = count - DEGREE
    return np.concatenate([np.zeros(DEGREE), np.arange(spans + 1.0), np.full(DEGREE, float(spans))])


def control_path(points: Array) -> PlannedPath:
    """Return the B-spline of degree 5 by its control points, over the knots of `path_knots`.

    It starts on the first point towards the second and ends on the last, coming from the one before. Its third
    derivative is continuous, so the curvature of the path and the slope of its curvature are, and its curvature
    lies close to what the points' polygon shows (de Boor, A Practical Guide to Splines, ch. IX-XI).

    Args:
        points: control points in driving order, shape (n, 2), mm, n >= 6.

    Raises:
        DesignError: too few points, a value that is not finite, or two equal neighbours.
    """
    points = np.asarray(points, dtype=float)
    if points.ndim != 2 or points.shape[1] != 2:
        raise DesignError("path.control_points_mm must be a list of [x, y] pairs")
    if len(points) <= DEGREE:
        raise DesignError(
            f"path.control_points_mm has {len(points)} points; a path needs at least {DEGREE + 1}: add more"
        )
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if bad.size:
        raise DesignError(f"path.control_points_mm: point {bad[0] + 1} is not a finite number: correct it")
    equal = np.flatnonzero(np.linalg.norm(np.diff(points, axis=0), axis=1) < MIN_CHORD_MM)
    if equal.size:
        i = equal[0]
        raise DesignError(
            f"path.control_points_mm: points {i + 1} and {i + 2} are both "
            f"({points[i, 0]:g}, {points[i, 1]:g}): remove one of them"
        )
    knots = path_knots(len(points))
    spline = BSpline(knots, points, DEGREE)
    knots = knots[DEGREE:-DEGREE]
    return PlannedPath(knots=knots, spline=spline, smooth=True, knot_name="knot", points_key="path.control_points_mm")
