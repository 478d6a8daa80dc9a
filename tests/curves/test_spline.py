"""B-splines against an implicit equation, their order, and the rod."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen.cam.contact import roll
from cadgen.curves.closed import Outline
from cadgen.curves.spline import splines
from tests.curves.shapes import TURN, ellipse, lens, off_ellipse


def sampled(arcs, count=4001):
    return np.stack([arc.point(np.linspace(arc.knots[0], arc.knots[-1], count)) for arc in arcs])


def ring(arcs):
    return zip(arcs, [*arcs[1:], arcs[0]], strict=True)


@settings(max_examples=15, deadline=None)
@given(b=st.floats(5.0, 80.0), exponent=st.floats(-6.0, -1.0), degree=st.sampled_from([3, 5]))
def test_no_spline_strays_further_than_allowed(b, exponent, degree):
    tolerance = 10**exponent
    points = sampled(splines(ellipse(40.0, b), tolerance, degree)).reshape(-1, 2)
    assert np.abs(off_ellipse(points, 40.0, b)).max() <= tolerance


@pytest.mark.parametrize(("degree", "order"), [(3, 4), (5, 6)])
def test_the_error_falls_with_the_power_of_degree_plus_one(degree, order):
    tolerances = [1e-5, 1e-8]
    fits = [splines(ellipse(70.0, 50.0), tolerance, degree) for tolerance in tolerances]
    spans = [sum(len(arc.control_points) - degree for arc in fit) for fit in fits]
    assert np.log(1e3) / np.log(spans[1] / spans[0]) == pytest.approx(order, rel=0.1)


def test_a_closed_curve_has_three_edges_at_least_that_share_their_ends_bit_for_bit():
    whole = splines(ellipse(40.0, 40.0), 1e-4, 5)
    assert len(whole) == 3
    with_corners = splines(lens(50.0, 0.6).curve(), 1e-4, 5)
    assert len(with_corners) == 2  # neither turns by a third of a turn
    for arcs in (whole, with_corners):
        for arc, following in ring(arcs):
            assert np.array_equal(arc.control_points[-1], following.control_points[0])


@pytest.mark.parametrize("degree", [3, 5])
def test_neighbours_of_a_smooth_curve_share_tangent_and_curvature(degree):
    arcs = splines(ellipse(70.0, 50.0, starts=(0.3, 2.0, 4.5)), 1e-5, degree)
    for arc, following in ring(arcs):
        ends = []
        for one, end in ((arc, -1), (following, 0)):
            # End derivatives of a clamped B-spline from its first control points (Piegl and Tiller, eq. 3.7-3.9).
            points, knots, p = one.control_points[:: 1 if end == 0 else -1], one.knots, one.degree
            gaps = np.diff(knots)[p : p + 2] if end == 0 else np.diff(knots)[::-1][p : p + 2]
            first = p * (points[1] - points[0]) / gaps[0]
            slope = p * (points[2] - points[1]) / (gaps[0] + gaps[1])
            second = (p - 1) * (slope - first) / gaps[0]
            if end == -1:
                first = -first
            ends.append((first, (first[0] * second[1] - first[1] * second[0]) / np.linalg.norm(first) ** 3))
        (before, bend_before), (after, bend_after) = ends
        assert before == pytest.approx(after, abs=1e-8)
        assert bend_before == pytest.approx(bend_after, rel=1e-7 if degree == 5 else 1e-2)


def test_knots_are_clamped_and_rising():
    for arc in splines(lens(50.0, 0.6).curve(), 1e-4, 5):
        assert len(arc.knots) == len(arc.control_points) + arc.degree + 1
        assert np.ptp(arc.knots[: arc.degree + 1]) == 0
        assert np.ptp(arc.knots[-arc.degree - 1 :]) == 0
        assert all(a < b for a, b in pairwise(arc.knots[arc.degree : -arc.degree]))


@pytest.mark.parametrize(("degree", "most"), [(5, 160), (3, 210)])
def test_the_rod_on_the_splines_gives_the_lift(carbon_free_car, degree, most):
    car = carbon_free_car
    arcs = splines(car.actual.curve, 1e-4, degree)
    points = sampled(arcs)
    owner = np.repeat(np.arange(len(arcs)), points.shape[1])
    angle = np.linspace(0, TURN, 3600, endpoint=False)
    rolled = roll(Outline(points.reshape(-1, 2), owner), car.follower, angle).lift
    wanted = car.follower.lift(car.lift.q(angle))
    exact = roll(car.actual.curve.outline(0.03), car.follower, angle).lift
    count = sum(len(arc.control_points) for arc in arcs)
    print(f"degree {degree}: {count} control points, {np.abs(rolled - wanted).max() * 1e3:.3f} um from the lift wanted")
    assert np.abs(rolled - exact).max() < 1e-4 / np.cos(np.radians(27)) + 5e-6
    assert count <= most  # a regression bound: the size of the STEP file rests on it
