"""Biarcs against implicit equations, the error formula of Meek and Walton, and the rod."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen.cam.contact import roll
from cadgen.curves.biarc import arcs
from cadgen.curves.contour import circle, keyway_bore
from tests.curves.shapes import TURN, ellipse, lens, off_ellipse


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(b=st.floats(5.0, 80.0), exponent=st.floats(-5.0, -1.0))
def test_no_arc_strays_further_than_allowed(b, exponent):
    tolerance = 10**exponent
    chain = arcs(ellipse(40.0, b), tolerance)
    off = np.abs(off_ellipse(chain.outline(0.02).points, 40.0, b))
    assert off.max() <= tolerance + 1e-12


def test_the_number_of_arcs_is_near_that_of_even_errors_and_of_third_order():
    a, b = 70.0, 50.0
    t = np.linspace(0, TURN, 20001)
    speed = np.hypot(a * np.sin(t), b * np.cos(t))
    # d/ds of the ellipse's curvature a b / speed^3.
    slope = -3 * a * b * (a**2 - b**2) * np.sin(t) * np.cos(t) / speed**6
    tolerances = np.array([1e-2, 1e-3, 1e-4, 1e-6])
    counts = np.array([len(arcs(ellipse(a, b), tolerance).bulges) for tolerance in tolerances])
    # Spans of error tolerance, of |slope| h^3 / 324 each: this many arcs, two to a span.
    even = np.array([2 * np.trapezoid((np.abs(slope) / 324 / tol) ** (1 / 3) * speed, t) for tol in tolerances])
    print("arcs", counts, "even errors", even.round(1))
    # The slope vanishes at the four vertices, and the density with it; the arcs there are worth three more each.
    assert np.all(counts < 1.1 * even + 12)
    order = np.log(counts[3] / counts[2]) / np.log(tolerances[2] / tolerances[3])
    assert order == pytest.approx(1 / 3, abs=0.02)


def test_arcs_meet_with_one_tangent_but_for_the_corners(carbon_free_car):
    chain = arcs(carbon_free_car.actual.curve, 2e-4)
    heading = np.arctan2(chain.chords[:, 1], chain.chords[:, 0])
    leaving, arriving = heading - chain.sweeps / 2, heading + chain.sweeps / 2
    turn = (leaving - np.roll(arriving, 1) + np.pi) % TURN - np.pi
    corners = carbon_free_car.actual.curve.corners()
    sharp = np.abs(turn) > 1e-7
    assert chain.vertices[sharp] == pytest.approx(np.array([corner.point for corner in corners]), abs=1e-12)
    assert turn[sharp] == pytest.approx([corner.turn for corner in corners], abs=1e-7)


def test_circles_and_lines_come_back_as_they_are():
    ring = arcs(circle((3.0, 1.0), 20.0).curve(), 1e-4)
    assert len(ring.bulges) == 4  # a quarter turn is the longest span
    assert ring.radii == pytest.approx(20.0, rel=1e-12)
    bore = keyway_bore(8.0, 3.0, 1.4, 0.3)
    again = arcs(bore.curve(), 1e-4)
    assert np.sum(again.bulges == 0) == 3
    assert again.area() == pytest.approx(bore.area(), rel=1e-12)


def test_corners_are_kept():
    chain = arcs(lens(50.0, 0.6).curve(), 1e-3)
    for tip in lens(50.0, 0.6).vertices:
        assert np.abs(chain.vertices - tip).max(axis=1).min() < 1e-13


def test_the_rod_on_the_arcs_gives_the_lift(carbon_free_car):
    car = carbon_free_car
    angle = np.linspace(0, TURN, 7200, endpoint=False)
    chain = arcs(car.actual.curve, 2e-4)
    rolled = roll(chain.outline(0.05), car.follower, angle).lift
    exact = roll(car.actual.curve.outline(0.03), car.follower, angle).lift
    wanted = car.follower.lift(car.lift.q(angle))
    print(f"{len(chain.bulges)} arcs: {np.abs(rolled - wanted).max() * 1e3:.3f} um from the lift wanted")
    # The arcs stray by the tolerance along the normal, at 27 degrees from the rod's travel at most.
    assert np.abs(rolled - exact).max() < 2e-4 / np.cos(np.radians(27)) + 5e-6
