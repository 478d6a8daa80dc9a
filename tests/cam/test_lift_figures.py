"""Peaks and valleys of the lift of both packaged cars, from the design file on.

The figures were worked out before this program and apart from it: lift at the face that carries the rod, in
mm, at the cam angle in degrees. Run with `-s` to see the differences.
"""

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from cadgen.design import cam_model
from cadgen.design.load import load_design

Array = NDArray[np.float64]

LIFT_BAR_UM = 0.2
ANGLE_BAR_DEG = 0.002

PEAKS = {
    "carbon_free_car": [(4.60908, 91.291), (5.52346, 178.636), (2.15553, 266.548)],
    "appendix_car": [(5.50001, 88.202), (6.40867, 180.529), (2.63659, 262.240)],
}
VALLEYS = {
    "carbon_free_car": [(0.04930, 5.823), (-6.54094, 129.361), (-0.25762, 240.586)],
    "appendix_car": [(0.20770, 13.183), (-8.22668, 128.075), (-0.51416, 244.204)],
}


@pytest.mark.parametrize("name", PEAKS)
@pytest.mark.parametrize("kind", ["peak", "valley"])
def test_peaks_and_valleys(name: str, kind: str) -> None:
    design = load_design(name)
    lift, follower = cam_model.lift(design), cam_model.follower(design)
    extrema, figures = (lift.extrema()[0], PEAKS) if kind == "peak" else (lift.extrema()[1], VALLEYS)
    # Beyond blend_start the closing blend steers, not the path.
    driven = extrema[extrema < lift.blend_start]
    assert len(driven) == len(figures[name])
    for theta, (wanted_mm, wanted_deg) in zip(driven, figures[name], strict=True):
        lift_mm, angle_deg = float(follower.lift(lift.q(theta))), float(np.degrees(theta))
        error_um, error_deg = (lift_mm - wanted_mm) * 1e3, angle_deg - wanted_deg
        print(f"{name} {kind}: {lift_mm:.5f} mm at {angle_deg:.3f} deg", end=", ")
        print(f"{error_um:+.3f} um and {error_deg:+.5f} deg off")
        assert abs(error_um) < LIFT_BAR_UM
        assert abs(error_deg) < ANGLE_BAR_DEG


@pytest.mark.parametrize("name", PEAKS)
def test_the_formulas_alone_give_the_same_figures(name: str) -> None:
    """Eq. 14-19 by the spline's own parameter and the length by quadrature, with nothing interpolated.

    This settles the appendix car's last valley, at waypoint 9, where the slope of curvature jumps: it is
    -0.51421 mm, where the figure above has -0.51416.
    """
    design = load_design(name)
    path, car, offset = cam_model.planned_path(design), cam_model.car(design), design.path.offset_mm
    lift, follower = cam_model.lift(design), cam_model.follower(design)

    def curvature_and_speed(u: Array) -> tuple[Array, Array]:
        (x1, y1), (x2, y2) = path.spline(u, nu=1).T, path.spline(u, nu=2).T
        speed = np.hypot(x1, y1)
        return (x1 * y2 - y1 * x2) / speed**3, speed

    def tan_beta(u: Array) -> Array:
        planned, _ = curvature_and_speed(u)
        right = -planned / (1 - offset * planned)
        return car.wheelbase * right / (1 - car.drive_wheel_offset * right)

    def rate(u: Array) -> Array:
        planned, speed = curvature_and_speed(u)
        return speed * (1 - offset * planned)

    def travel(u: float) -> float:
        return sum(quad(rate, *span, epsabs=1e-7)[0] for span in pairwise([*path.knots[path.knots < u], u]))

    grid = np.linspace(path.knots[0], path.knots[-1], 20_001)
    for sign, extrema in zip((-1, 1), lift.extrema(), strict=True):

        def height(u: Array, sign: int = sign) -> Array:
            return sign * tan_beta(u)

        falls = np.diff(height(grid)) < 0
        around = [(grid[i], grid[i + 2]) for i in np.flatnonzero(falls[:-1] & ~falls[1:])]
        exact = np.array([minimize_scalar(height, bounds=ends, options={"xatol": 1e-12}).x for ends in around])
        theta = 2 * np.pi * np.array([travel(u) for u in exact]) / travel(path.knots[-1])
        driven = theta < lift.blend_start
        assert theta[driven] == pytest.approx(extrema[extrema < lift.blend_start], abs=1e-6)
        wanted = follower.lift(tan_beta(exact[driven]))
        assert follower.lift(lift.q(theta[driven])) == pytest.approx(wanted, abs=1e-7)
