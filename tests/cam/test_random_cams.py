"""Random cams: whatever the lift and the rod, envelope and contact agree, and nothing is trimmed in silence."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen.cam.contact import roll_curve
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.lost_lift import lost_lift
from cadgen.car.path_motion import PathMotion
from cadgen.curves.piecewise import quintic_hermite

TURN = 2 * np.pi


@st.composite
def cams(draw):
    """tan(beta) as a short Fourier series with peaks up to 0.3, and a mechanism around it."""
    orders = draw(st.lists(st.integers(1, 7), min_size=1, max_size=4, unique=True))
    # Higher orders get less, so that most pitch curves can be followed and some cannot.
    amplitudes = [draw(st.floats(0.005, 0.3)) / (order**1.5) for order in orders]
    phases = [draw(st.floats(0.0, TURN)) for _ in orders]
    mean = draw(st.floats(-0.1, 0.1))
    theta = np.linspace(0, TURN, 721)
    jets = np.zeros((len(theta), 3))
    jets[:, 0] = mean
    for order, amplitude, phase in zip(orders, amplitudes, phases, strict=True):
        for n in range(3):
            jets[:, n] += amplitude * order**n * np.cos(order * theta + phase + n * np.pi / 2)
    jets[-1] = jets[0]
    lift = PathMotion(quintic_hermite(theta, jets, periodic=True), np.array([]), TURN - 0.2)
    inner = draw(st.floats(10.0, 50.0))
    return lift, LeaningRod(
        base_radius=draw(st.floats(40.0, 120.0)),
        inner=inner,
        outer=inner + draw(st.floats(0.5, 10.0)),
        radius=draw(st.floats(0.5, 5.0)),
    )


@pytest.mark.slow
@pytest.mark.long
@settings(max_examples=40, deadline=None)
@given(cams())
def test_envelope_and_contact_agree(cam):
    lift, follower = cam
    profile = actual_profile(lift, follower)
    theta = np.linspace(0, TURN, 900, endpoint=False)
    wanted = follower.lift(lift.q(theta))
    contact, step = roll_curve(profile.curve, follower, theta)
    rolled = contact.lift
    trimmed = np.zeros(len(theta), dtype=bool)
    for trim in profile.trims:
        trimmed |= (theta - trim.before) % TURN <= (trim.after - trim.before) % TURN
    assert np.abs(rolled - wanted)[~trimmed].max(initial=0.0) < 5e-5
    # Inside a trimmed interval lift is lost, never gained, and never more than stated.
    losses = lost_lift(lift, follower, profile.trims, profile.curve.outline(step))
    assert (wanted - rolled)[trimmed].max(initial=0.0) <= max((loss.lift for loss in losses), default=0.0) + 5e-5
    assert (rolled - wanted).max() < 5e-5


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(cams())
def test_area_and_radius_agree(cam):
    """Two ways round the same curve: Green's theorem on the pieces, and half R^2 over the polar angle."""
    lift, follower = cam
    curve = actual_profile(lift, follower).curve
    angle = np.linspace(0, TURN, 20_000, endpoint=False)
    sector = 0.5 * np.mean(curve.radius(angle) ** 2) * TURN
    assert abs(sector / curve.area() - 1) < 1e-6
