"""The planned path: a parametric spline through the waypoints."""

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.path.names import SplineKind

MIN_WAYPOINTS = 4  # the cubic's end slope is that of the cubic through the first four
MIN_CHORD_MM = 1e-6  # below this two waypoints are one, and the centripetal parameter stalls


@dataclass(frozen=True)
class PlannedPath:
    """A parametric curve u -> (x, y) through the waypoints, with its first four derivatives.

    Attributes:
        waypoints: points in driving order, shape (n, 2), mm.
        knots: parameter of each waypoint, shape (n,).
        spline: vector-valued B-spline on [knots[0], knots[-1]].
        smooth: True when curvature has a continuous slope at the waypoints.
    """

    waypoints: Array
    knots: Array
    spline: BSpline
    smooth: bool

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
    return PlannedPath(waypoints=waypoints, knots=knots, spline=spline, smooth=kind == "quintic")
