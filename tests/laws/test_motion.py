"""A motion shows its peaks, its valleys and where it is level, and can be mirrored."""

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.curves.piecewise import quintic_hermite
from cadgen.laws.motion import Motion
from cadgen.laws.unit import MM

RISE = np.radians([0.0, 90.0, 135.0, 315.0, 360.0])


def rise_and_return() -> Motion:
    """Up by 10 mm in 90 degrees, a dwell of 45, back in 180, a dwell of 45: 3-4-5 polynomials."""
    jets = np.zeros((5, 3))
    jets[1:3, 0] = 10.0
    return Motion(quintic_hermite(RISE, jets, periodic=True), np.array([]), unit=MM)


def test_dwells_are_level():
    level = np.degrees(rise_and_return().level)
    # A 3-4-5 polynomial stays within 0.01 um of its end over (1e-6 / 10)^(1/3) of its angle.
    np.testing.assert_allclose(level[0], [90, 135], atol=2)
    np.testing.assert_allclose(level[1], [315, 360], atol=3)


def test_the_mirrored_motion_runs_backwards():
    motion = rise_and_return()
    theta = np.linspace(0.0, TURN, 999, endpoint=False)
    assert motion.mirrored.q(theta) == pytest.approx(motion.q(TURN - theta), abs=1e-12)
    assert motion.mirrored.unit is MM


def test_one_value_is_that_of_the_curve_to_the_last_bit():
    motion = rise_and_return()
    angles = [*RISE, *np.random.default_rng(0).uniform(-2 * TURN, 2 * TURN, 500), -1e-17, np.nextafter(TURN, 0.0)]
    assert [motion.value(angle) for angle in angles] == [float(motion.q(angle)) for angle in angles]


def test_no_part_is_idle():
    assert not rise_and_return().idle(np.linspace(0.0, TURN, 9)).any()
