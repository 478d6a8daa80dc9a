"""Lift tables and points: closure, noise by fourth differences, smoothing, and the spline through the rows."""

from math import comb, pi, radians, sqrt

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.errors import DesignError
from cadgen.laws.lift_table import noise_of, points_motion, table_motion
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM

# Points of a table in two decimals more than its noise, and the figures of the spline through them by another program.
POINTS = (
    "7.3816 8.4107 8.9849 9.1635 9.1335 9.1289 9.3184 9.7131 10.1452 10.3318 9.9967 8.9948 7.3816 5.3982 3.3849 1.6682 "
    "0.4732 -0.1061 -0.0816 0.4781 1.4849 2.8365 4.3967 5.9823"
)
GREATEST = {0: (10.333, 133.984, -0.16646, 261.785), 1: (6.14603, 332.027, -7.86368, 196.182)}
GREATEST[2] = (9.17667, 244.289, -10.0786, 153.515)


def lobe(theta, half=70.0, height=8.0, code="valve_lobe"):
    """Lift, velocity and acceleration of a lobe about 180 degrees, shape (n, 3)."""
    away = (theta - pi) / radians(half)
    law = law_of(code)
    jets = law.derivatives(np.clip(1 - np.abs(away), 0.0, 1.0))[:, :3] * height / radians(half) ** np.arange(3)
    jets[:, 1] *= -np.sign(away)
    jets[np.abs(away) >= 1] = 0.0
    return jets


def taken(angle, height, *, smooth=False, ramps=False, **more):
    return table_motion(angle, height, MM, smooth=smooth, ramps=ramps, key="motion.close", **more)


def test_a_spline_through_points_has_the_figures_of_another_program():
    height = np.array([float(text) for text in POINTS.split()])
    motion = points_motion(np.radians(np.arange(0.0, 360.0, 15.0)), height, MM)
    for order, (most, at_most, least, at_least) in GREATEST.items():
        high, low = motion.extremes(order)
        assert (high.value, low.value) == pytest.approx((most, least), rel=1e-5)
        np.testing.assert_allclose(np.degrees([high.cam_angle, low.cam_angle]), [at_most, at_least], atol=2e-3)
    theta = np.radians(np.arange(0.0, 360.0, 15.0))
    np.testing.assert_allclose(motion.q(theta), height, atol=1e-12)
    # The spline and its first four derivatives have no seam, at cam angle 0 neither.
    for order in range(4):
        before, behind = motion.jets(theta, before=True)[:, order], motion.jets(theta)[:, order]
        np.testing.assert_allclose(before, behind, atol=1e-8 * 10**order)


def test_a_spline_converges_by_the_sixth_power_of_its_step():
    """The curve s = exp(cos theta), whose derivatives are known, with half the step."""
    errors = []
    theta = np.linspace(0.0, TURN, 2000)
    for count in (24, 48):
        angle = np.linspace(0.0, TURN, count, endpoint=False)
        motion = points_motion(angle, np.exp(np.cos(angle)), MM)
        errors.append(np.abs(motion.q(theta) - np.exp(np.cos(theta))).max())
    assert errors[0] / errors[1] > 2**5.5


def test_fourth_differences_show_the_noise():
    """Fourth differences of equal steps have sqrt(70) times the noise, by the sum of the squared binomials."""
    assert sum(comb(4, k) ** 2 for k in range(5)) == 70
    theta = np.radians(np.arange(360.0))
    rng = np.random.default_rng(4)
    found = [noise_of(theta, lobe(theta)[:, 0] + rng.normal(0.0, 2e-3, 360)) for _ in range(20)]
    print(np.mean(found), np.std(found))
    assert np.mean(found) == pytest.approx(2e-3, rel=0.05)
    assert np.std(found) < 3e-4
    # By steps that differ by a third of themselves, too.
    uneven = theta + np.radians(rng.uniform(-0.15, 0.15, 360))
    assert noise_of(uneven, lobe(uneven)[:, 0] + rng.normal(0.0, 2e-3, 360)) == pytest.approx(2e-3, rel=0.25)


@pytest.mark.parametrize("code", ["valve_lobe", "polynomial_3_4_5", "modified_sine", "simple_harmonic"])
def test_a_smooth_table_shows_none(code):
    theta = np.radians(np.arange(360.0))
    assert noise_of(theta, lobe(theta, code=code)[:, 0]) == 0.0
    coarse = np.radians(np.arange(0.0, 360.0, 15.0))
    assert noise_of(coarse, np.array([float(text) for text in POINTS.split()])) == 0.0


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize(
    ("code", "half", "height"),
    [("valve_lobe", 70.0, 8.0), ("polynomial_3_4_5", 80.0, 10.0), ("polynomial_4_5_6_7", 90.0, 12.0)],
)
def test_a_noisy_table_is_smoothed(code, half, height, seed):
    """2 um at 1 degree: the lift within 1.5 um rms, the greatest accelerations of both signs within 2 %."""
    theta = np.radians(np.arange(360.0))
    rng = np.random.default_rng(seed)
    rows = lobe(theta, half, height, code)[:, 0] + rng.normal(0.0, 2e-3, 360)
    motion = taken(theta, rows, smooth=True)
    fine = np.linspace(0.0, TURN, 7201)
    true = lobe(fine, half, height, code)
    rms = sqrt(np.mean((motion.q(fine) - true[:, 0]) ** 2)) * 1e3
    peaks = [motion.within(2)[side] / (true[:, 2].min(), true[:, 2].max())[side] - 1 for side in (0, 1)]
    print(f"{rms:.2f} um rms, peaks {peaks[0]:+.1%} and {peaks[1]:+.1%}, was {motion.smoothing.before}")
    assert rms < 1.5
    assert np.abs(peaks).max() < 0.02
    # What was changed is the noise, and what the rows as they are would have given is said.
    assert motion.smoothing.rms == pytest.approx(motion.noise, rel=0.05)
    assert motion.smoothing.before[0] < 1.5 * true[:, 2].min()
    assert motion.noise == pytest.approx(2e-3, rel=0.2)


def test_without_smoothing_the_rows_are_kept():
    theta = np.radians(np.arange(360.0))
    rows = lobe(theta)[:, 0] + np.random.default_rng(1).normal(0.0, 2e-3, 360)
    motion = taken(theta, rows)
    np.testing.assert_allclose(motion.q(theta), rows, atol=1e-12)
    assert motion.smoothing is None
    assert motion.noise > 0


@pytest.mark.parametrize("angle", [np.arange(0.0, 6.2832, 0.02), np.linspace(0.0, 2 * pi, 361)])
def test_a_table_in_radians_is_said_to_be_one(angle):
    with pytest.raises(DesignError, match=r"reaches over 6\.283? degrees alone.*multiply each by 57\.29577951"):
        taken(np.radians(angle), 4 * (1 - np.cos(angle + 0.1)) + 0.1 * angle)


@pytest.mark.parametrize("count", [360, 361])
def test_a_closed_table_in_radians_is_no_lobe_of_six_degrees(count):
    angle = np.radians(np.arange(float(count)))
    with pytest.raises(DesignError, match=r"reaches over 6\.2[68]\d* degrees alone.*multiply each by 57\.29577951"):
        taken(np.radians(angle), 4 * (1 - np.cos(angle)))
    assert taken(np.radians(np.degrees(angle)), 4 * (1 - np.cos(angle))).covered == (0.0, TURN)
    lobe_of_six = np.radians(np.linspace(0.0, 6.0, 61))
    assert taken(lobe_of_six, 0.01 * (1 - np.cos(lobe_of_six * 60))).covered[1] == pytest.approx(radians(6.0))


def test_the_first_row_again_closes_a_turn():
    theta = np.radians(np.arange(361.0))
    rows = 5 - 5 * np.cos(theta)
    motion = taken(theta, rows)
    assert motion.covered == (0.0, TURN)
    assert np.abs(motion.q(theta + 0.3) - (5 - 5 * np.cos(theta + 0.3))).max() < 1e-9
    with pytest.raises(DesignError, match=r"begins 0 µm above the base circle.* ends 20 µm above it, at 360"):
        taken(theta, rows + 0.02 * theta / TURN)


def test_a_step_across_the_start_is_seen():
    theta = np.radians(np.arange(360.0))
    with pytest.raises(DesignError, match="the table does not close"):
        taken(theta, 5 - 5 * np.cos(theta) + theta * 0.05)
    motion = taken(theta, 5 - 5 * np.cos(theta) + theta * 0.05, ramps=True)
    ((start, stop),) = motion.ramps
    assert stop - start == pytest.approx(radians(20), abs=radians(1.01))
    inside = np.linspace(0.01, start - 0.01, 500)
    np.testing.assert_allclose(motion.q(inside), 5 - 5 * np.cos(inside) + inside * 0.05, atol=1e-6)


def part(first, last):
    """Part of a lobe of 80 degrees about cam angle 0 that begins and ends above the base circle."""
    angle = np.radians(np.arange(-first, last + 0.25, 0.5))
    return angle, lobe(angle + pi, half=80.0)[:, 0]


def test_a_part_of_the_turn_dwells_for_the_rest():
    angle, rows = part(80, 80)
    motion = taken(angle, rows)
    assert np.degrees(motion.covered) == pytest.approx((-80, 80))
    theta = np.linspace(radians(80), radians(280), 300)
    np.testing.assert_allclose(motion.jets(theta)[1:-1], 0.0, atol=1e-12)
    inside = np.linspace(-1.2, 1.2, 500)
    np.testing.assert_allclose(motion.q(inside), lobe(inside + pi, half=80.0)[:, 0], atol=2e-5)
    assert motion.level.shape == (1, 2)


def test_an_open_table_is_refused_with_both_figures_or_led_by_ramps():
    """Ends 13.0 and 134.0 um above the base circle, as those of a measured valve lobe."""
    angle, rows = part(80, 80)
    start = np.searchsorted(rows, 0.013)
    stop = len(rows) - np.searchsorted(rows, 0.134) - 1
    angle, rows = angle[start : stop + 1], rows[start : stop + 1].copy()
    rows[0], rows[-1] = 0.013, 0.134
    with pytest.raises(DesignError, match=r"begins 13 µm above the base circle, .* and ends 134 µm above it, .*: set"):
        taken(angle, rows)
    motion = taken(angle, rows, ramps=True)
    (down, off), (on, up) = motion.ramps
    assert down == angle[-1]
    assert up == pytest.approx(angle[0] + TURN)
    assert down < off < on < up
    np.testing.assert_allclose(motion.q(angle), rows, atol=1e-12)
    # Height, velocity and acceleration are whole at both ends of each ramp, and it stays above the base circle.
    for place in (down, off, on, up):
        at = np.array([place])
        np.testing.assert_allclose(motion.jets(at, before=True)[0, :3], motion.jets(at)[0, :3], atol=1e-7)
    assert motion.q(np.linspace(off, on, 100)) == pytest.approx(0.0, abs=1e-12)
    assert motion.q(np.linspace(0.0, TURN, 5000)).min() > -1e-3 * rows.max()
    # Figures of the table's range take nothing from the ramps.
    true = lobe(np.linspace(angle[0] + pi, angle[-1] + pi, 5000), half=80.0)[:, 2]
    inner = motion.jets(np.linspace(angle[3], angle[-4], 20_000))[:, 2]
    assert inner.min() == pytest.approx(true.min(), rel=1e-3)


def test_smoothing_keeps_the_dwell_beside_a_lobe():
    angle, rows = part(80, 80)
    noisy = rows + np.random.default_rng(3).normal(0.0, 2e-3, len(rows))
    motion = taken(angle, noisy, smooth=True)
    inside = np.linspace(-1.3, 1.3, 4000)
    off = motion.q(inside) - lobe(inside + pi, half=80.0)[:, 0]
    assert sqrt(np.mean(off**2)) < 1.5e-3
    rest = np.linspace(radians(90), radians(270), 400)
    assert np.abs(motion.q(rest)).max() < 1e-3


def test_lobes_of_a_part_repeat_with_their_dwell():
    angle = np.radians(np.linspace(0.0, 80.0, 161))
    rows = lobe(angle * 2 + pi - radians(80), half=80.0)[:, 0]
    motion = taken(angle, rows, lobes=3)
    theta = np.linspace(0.0, TURN / 3, 300)
    np.testing.assert_allclose(motion.q(theta + TURN / 3), motion.q(theta), atol=1e-12)
    np.testing.assert_allclose(motion.q(angle), rows, atol=1e-4)
    assert np.abs(motion.q(np.linspace(radians(81), radians(119), 50))).max() < 1e-12


def test_the_mirrored_table_runs_backwards():
    angle, rows = part(80, 80)
    motion = taken(angle, rows)
    theta = np.linspace(0.0, TURN, 400)
    np.testing.assert_allclose(motion.mirrored.q(theta), motion.q(TURN - theta), atol=1e-12)
    assert motion.mirrored.covered == pytest.approx((-angle[-1], -angle[0]))
