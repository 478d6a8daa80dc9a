"""The appendix program's own table, and why it differs from the exact lift.

The program works by finite differences on 3603 points, uniform in the spline's parameter. Two steps tie it to the
exact lift: its algorithm, written again here from the paper's listing, gives the table to its printed digits; and
the same algorithm on ever finer grids tends to the exact lift at first order (its forward differences are centred
half a step to a step and a half beside the point they are booked at). So what remains between the table and us is
the program's own discretisation.
"""

from pathlib import Path

import numpy as np
import pytest

from cadgen.car.path.spline import plan_path

DATA = Path(__file__).parent.parent / "data"
TABLE = np.genfromtxt(DATA / "appendix_cam.csv", delimiter=",", names=True)
COUNT = 3603
OFFSET, WHEELBASE, A1, FACE = 117.8, 166.65, 37.0, 25.1
ENDS = 20  # rows at either end where the program repeats differences and overwrites the last row with the first


def program(waypoints: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Cam angle (deg) and lift at the inner face (mm) as the listing computes them, with signed curvature."""
    spline = plan_path(waypoints, "cubic").spline
    x, y = spline(np.linspace(0, len(waypoints) - 1, count)).T
    dx, dy = np.diff(x), np.diff(y)
    run = np.hypot(dx, dy)
    wheel_x, wheel_y = x[:-1] - dy / run * OFFSET, y[:-1] + dx / run * OFFSET
    dx, dy = np.diff(wheel_x), np.diff(wheel_y)
    ddx, ddy = np.diff(dx), np.diff(dy)
    ddx, ddy = np.append(ddx, ddx[-1]), np.append(ddy, ddy[-1])
    with np.errstate(divide="ignore"):
        radius = -((dx**2 + dy**2) ** 1.5) / (dx * ddy - ddx * dy)
    step = np.hypot(dx, dy)
    return np.cumsum(step) / step.sum() * 360, FACE * WHEELBASE / (radius - A1)


@pytest.fixture(scope="module")
def waypoints(appendix_car):
    return appendix_car.track.planned(appendix_car.track.waypoint_arc)


@pytest.fixture(scope="module")
def exact(appendix_car):
    """Exact lift at the inner face, which the program uses for both signs; the blend is none of its business."""
    lift = appendix_car.lift
    return lambda angle_deg: FACE * lift.q(np.radians(angle_deg))


def test_the_listing_gives_the_table(waypoints):
    angle, lift = program(waypoints, COUNT)
    inside = slice(ENDS, -ENDS)
    # The program takes the sign from the peaks of the radius, which puts it one row late at two of its zeros.
    late = np.flatnonzero(lift[inside] * TABLE["lift_mm"][inside] < 0) + ENDS
    assert list(late) == [1779, 2538]
    lift[late] *= -1
    print(f"listing against table: {np.abs(lift - TABLE['lift_mm'])[inside].max():.1e} mm")
    np.testing.assert_allclose(angle[inside], TABLE["cam_angle_deg"][inside], atol=2e-7)
    np.testing.assert_allclose(lift[inside], TABLE["lift_mm"][inside], atol=2e-6)


def test_the_table_is_off_by_the_programs_discretisation(waypoints, exact):
    errors = []
    for refinement in (1, 2, 4, 8):
        angle, lift = program(waypoints, (COUNT - 1) * refinement + 1)
        inside = (angle > 2) & (angle < 346)
        errors.append(np.abs(lift - exact(angle))[inside].max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    print("program - exact, mm:", np.round(errors, 5), "orders:", np.round(orders, 2))
    assert (orders > 0.9).all()
    # First order: halving the step halves the error, so twice the change on refinement bounds the error itself.
    rows = (TABLE["cam_angle_deg"] > 2) & (TABLE["cam_angle_deg"] < 346)
    own = np.abs(TABLE["lift_mm"] - exact(TABLE["cam_angle_deg"]))[rows].max()
    print(f"table - exact: {own:.4f} mm, allowed {2.2 * (errors[0] - errors[1]):.4f} mm")
    assert own < 2.2 * (errors[0] - errors[1])


def test_the_published_formula_is_the_programs():
    """Column db of the table from its own lift: d - r sqrt(1 + T^2) at the face that carries."""
    lift = TABLE["lift_mm"]
    T = lift / FACE
    face = np.where(lift >= 0, FACE, FACE + 2.7)
    radius = 70 + face * T - 1.25 * np.sqrt(1 + T**2)
    np.testing.assert_allclose(radius[:-1], TABLE["published_actual_radius_mm"][:-1], atol=1e-6)


def test_the_track_is_the_programs(appendix_car):
    """The program offsets by the slope half a step ahead, so its track lies within a step of ours."""
    table = np.genfromtxt(DATA / "appendix_track.csv", delimiter=",", skip_header=1)
    s = np.linspace(0, appendix_car.track.length, 200_001)
    from scipy.spatial import cKDTree

    distance, _ = cKDTree(appendix_car.track.position(s)).query(table)
    step = np.linalg.norm(np.diff(table, axis=0), axis=1).max()
    turn = 117.8 * 0.5 * step / 275  # offset times half a step of heading at the tightest radius
    print(f"track: at most {distance.max():.3f} mm beside, half a step of heading moves it {turn:.2f} mm along")
    assert distance.max() < 0.1
