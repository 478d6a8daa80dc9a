"""Every law against its closed form: greatest velocity, acceleration, jerk, ends, seams, and its pieces."""

import re
from itertools import pairwise
from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from cadgen.arrays import TURN
from cadgen.laws.motion import Motion
from cadgen.laws.power_laws import unequal_parabola
from cadgen.laws.segments import MotionSpan, SegmentMotion, state_of
from cadgen.laws.table import codes, law_of
from cadgen.laws.unit import MM
from cadgen.laws.valve_lobe import coefficients, valve_lobe


def scca(b, c, d):
    """Greatest velocity, acceleration and jerk of the family by its published formula."""
    acceleration = 4 * pi**2 / ((pi**2 - 8) * (b**2 - d**2) - 2 * pi * (pi - 2) * b + pi**2)
    return acceleration * ((b + d) / pi + c / 2), acceleration, acceleration * pi / b


def straight_sine(k):
    """Modified sine whose middle share k has constant velocity, by quadrature of its shape of acceleration.

    Of the half before the middle the quarter sine takes (1 - k)/8 and the quarter cosine 3(1 - k)/8.
    """
    ramp, fall = (1 - k) / 8, 3 * (1 - k) / 8

    def shape(u):
        return np.sin(pi / 2 * u / ramp) if u < ramp else np.cos(pi / 2 * (u - ramp) / fall)

    area = quad(shape, 0, ramp)[0] + quad(shape, ramp, ramp + fall)[0]
    moment = quad(lambda u: shape(u) * (ramp + fall - u), 0, ramp)[0]
    moment += quad(lambda u: shape(u) * (ramp + fall - u), ramp, ramp + fall)[0]
    scale = 1 / (2 * (moment + area * k / 2))
    return scale * area, scale, scale * pi / 2 / ramp


def of_sines(*terms):
    """Law u - sum of A sin(2 pi n u): velocity greatest in the middle, the rest by the cubic in sin^2 or by search."""

    def acceleration(u):
        return sum((2 * pi * n) ** 2 * a * np.sin(2 * pi * n * u) for n, a in terms)

    peak = max(
        -minimize_scalar(
            lambda u: -acceleration(u), bounds=(low, low + 0.05), options={"xatol": 1e-12}, method="bounded"
        ).fun
        for low in np.arange(0.0, 0.5, 0.05)
    )
    velocity = 1 - sum(2 * pi * n * a * (-1) ** n for n, a in terms)
    return velocity, peak, sum((2 * pi * n) ** 3 * a for n, a in terms)


def double_harmonic():
    """v = (pi/2)(sin x - sin(2x)/2) is greatest where cos x = cos 2x; j = -(pi^3/2)(sin x - 2 sin 2x), in x = pi u."""
    x = 2 * pi / 3
    jerk = -minimize_scalar(
        lambda x: -abs(pi**3 / 2 * (np.sin(x) - 2 * np.sin(2 * x))),
        bounds=(1.8, 3.0),
        options={"xatol": 1e-12},
        method="bounded",
    ).fun
    return pi / 2 * (np.sin(x) - np.sin(2 * x) / 2), pi**2, jerk


# Peaks of the acceleration at roots of the jerk: 5 u^2 - 5 u + 1 = 0 of 4-5-6-7, 14 u^2 - 14 u + 3 = 0 of 5-6-7-8-9.
U4 = (5 - sqrt(5)) / 10
U5 = (14 - sqrt(28)) / 28
CLOSED = {
    "polynomial_2_3": (3 / 2, 6, 12),
    "polynomial_3_4_5": (15 / 8, 10 / sqrt(3), 60),
    "polynomial_4_5_6_7": (35 / 16, 420 * U4**2 * (1 - U4) ** 2 * (1 - 2 * U4), 105 / 2),
    "polynomial_5_6_7_8_9": (315 / 128, 2520 * U5**3 * (1 - U5) ** 3 * (1 - 2 * U5), 78.75),
    "cycloidal": (2, 2 * pi, 4 * pi**2),
    "half_cycloid_1": (2, pi, pi**2),
    "half_cycloid_2": (2, pi, pi**2),
    "cycloid_line_50": (4 / 3, 8 * pi / 3, 32 * pi**2 / 3),
    "modified_trapezoid": scca(0.25, 0.5, 0.25),
    "modified_sine": scca(0.25, 0.0, 0.75),
    "modified_sine_20": straight_sine(0.2),
    "modified_sine_33": straight_sine(1 / 3),
    "modified_sine_50": straight_sine(0.5),
    "modified_sine_66": straight_sine(2 / 3),
    "simple_harmonic": (pi / 2, pi**2 / 2, pi**3 / 2),
    "double_harmonic": double_harmonic(),
    "half_harmonic_1": (pi / 2, pi**2 / 4, pi**3 / 8),
    "half_harmonic_2": (pi / 2, pi**2 / 4, pi**3 / 8),
    "constant_velocity": (1, 0, 0),
    "constant_acceleration": (2, 4, 0),
    "unequal_parabola": (2, 8, 0),
    "trapezoid": (2, 16 / 3, 128 / 3),
    "gutman_1_3": of_sines((1, 15 / (32 * pi)), (3, 1 / (96 * pi))),
    "freudenstein_1_3": of_sines((1, 27 / 28 / TURN), (3, 1 / 84 / TURN)),
    "freudenstein_1_3_5": of_sines(
        (1, 1125 / 1192 / TURN), (3, 1125 / 1192 / TURN / 54), (5, 1125 / 1192 / TURN / 1250)
    ),
}
# The figures of the books, and of the table of the how-to.
PRINTED = {
    "modified_trapezoid": (2, 4.888124, 61.425975),
    "modified_sine": (1.759603, 5.527957, 69.466357),
    "modified_sine_20": (1.527539, 5.998630, 94.226265),
    "modified_sine_33": (1.404087, 6.616604, 124.720047),
    "modified_sine_50": (1.275258, 8.012683, 201.380699),
    "modified_sine_66": (1.168083, 11.008926, 415.026738),
    "gutman_1_3": (2, 5.130199, 59.217626),
    "freudenstein_1_3": (2, 5.385587, 50.757965),
    "freudenstein_1_3_5": (2, 5.060283, 59.615060),
    "double_harmonic": (2.040524, 9.869604, 42.413720),
    "polynomial_4_5_6_7": (2.1875, 7.513188, 52.5),
    "polynomial_5_6_7_8_9": (2.460938, 9.371976, 78.75),
    "cycloid_line_50": (1.333333, 8.377580, 105.275780),
}
# Ends that are not at rest: velocity and acceleration at the beginning and at the end.
MOVING = {
    "polynomial_2_3": ((0, 6), (0, -6)),
    "half_cycloid_1": ((0, 0), (2, 0)),
    "half_cycloid_2": ((2, 0), (0, 0)),
    "simple_harmonic": ((0, pi**2 / 2), (0, -(pi**2) / 2)),
    "double_harmonic": ((0, 0), (0, -(pi**2))),
    "half_harmonic_1": ((0, pi**2 / 4), (pi / 2, 0)),
    "half_harmonic_2": ((pi / 2, 0), (0, -(pi**2) / 4)),
    "constant_velocity": ((1, 0), (1, 0)),
    "constant_acceleration": ((0, 4), (0, -4)),
    "unequal_parabola": ((0, 8), (0, -8 / 3)),
}


def one_rise(law):
    """Motion of a rise of 1 in half a turn, and the way back, which may jump."""
    back = MotionSpan(pi, TURN, 1.0, 0.0, law_of("polynomial_3_4_5"))
    return SegmentMotion.of([MotionSpan(0.0, pi, 0.0, 1.0, law), back], MM, allow_velocity_jump=True)


def peaks(law):
    """Greatest sizes of the first three derivatives by the share, on both sides of every seam."""
    shares = np.concatenate([[0.0], law.seams, [1.0]])
    found = np.zeros(3)
    for start, stop in pairwise(shares):
        u = np.linspace(start, stop, 4001)
        values = np.abs(np.vstack([law.derivatives(u[:-1]), law.derivatives(u[-1:], before=True)]))[:, 1:]
        for order in range(3):
            at = int(np.argmax(values[:, order]))
            near = np.linspace(u[max(at - 1, 0)], u[min(at + 1, 4000)], 2001)[1:-1]
            found[order] = max(found[order], values[at, order], np.abs(law.derivatives(near)[:, order + 1]).max())
    return found


def test_every_law_of_the_table_is_here():
    assert set(codes()) == {*CLOSED, "valve_lobe"}


@pytest.mark.parametrize("code", CLOSED)
def test_greatest_velocity_acceleration_and_jerk(code):
    np.testing.assert_allclose(peaks(law_of(code)), CLOSED[code], rtol=1e-9, atol=1e-12)
    if code in PRINTED:
        np.testing.assert_allclose(CLOSED[code], PRINTED[code], atol=6e-7)


@pytest.mark.parametrize("code", codes())
def test_value_and_slope_at_both_ends(code):
    law = law_of(code)
    low, high = law.derivatives(np.array([0.0]))[0], law.derivatives(np.array([1.0]), before=True)[0]
    if code == "valve_lobe":
        np.testing.assert_allclose([*low, *high[:2]], [0, 0, 0, 0, 1, 0], atol=1e-12)
        assert law.ends == ((0, 0), (0, pytest.approx(high[2])))
        return
    ends = MOVING.get(code, ((0, 0), (0, 0)))
    np.testing.assert_allclose([low[0], high[0], low[1], high[1]], [0, 1, ends[0][0], ends[1][0]], atol=1e-12)
    np.testing.assert_allclose([low[2], high[2]], [ends[0][1], ends[1][1]], atol=1e-11)
    np.testing.assert_allclose(law.ends, ends, atol=1e-11)


@pytest.mark.parametrize("code", codes())
def test_derivatives_are_those_of_the_law(code):
    """Central differences of each derivative give the next, within every part."""
    law, step = law_of(code), 1e-6
    for start, stop in zip((0.0, *law.seams), (*law.seams, 1.0), strict=True):
        u = np.linspace(start, stop, 41)[1:-1]
        quotient = (law.derivatives(u + step) - law.derivatives(u - step)) / (2 * step)
        values = law.derivatives(u)
        np.testing.assert_allclose(quotient[:, :3], values[:, 1:], atol=1e-8 * max(1.0, np.abs(values).max()))


@pytest.mark.parametrize("code", codes())
def test_pieces_follow_the_law(code):
    """Quintic pieces err by 5e-11 of the rise, 6e-9 of v, 8e-7 of a and 6e-5 of j at most; knots stand on seams."""
    law = law_of(code)
    motion = one_rise(law)
    theta = np.linspace(0.0, pi, 20_003)[1:-1]
    theta = theta[np.abs(theta[:, None] / pi - np.array([0.0, *law.seams])).min(axis=1) > 1e-6]
    exact = motion.jets(theta)
    for order, within in enumerate((1e-10, 1e-8, 2e-6, 2e-4)):
        off = np.abs(motion.q(theta, nu=order) - exact[:, order]).max()
        assert off <= within * max(1.0, np.abs(exact[:, order]).max()), order
    assert all(np.abs(motion.q.x - seam * pi).min() < 1e-14 for seam in law.seams)


def test_each_side_of_a_seam_has_its_own_derivatives():
    motion = one_rise(law_of("modified_trapezoid"))
    seam = np.array([pi / 8])
    before, behind = motion.jets(seam, before=True)[0], motion.jets(seam)[0]
    np.testing.assert_allclose(before[:3], behind[:3], atol=1e-12)
    # The quarter sine ends level, where its acceleration is at its greatest.
    assert before[2] * pi**2 == pytest.approx(scca(0.25, 0.5, 0.25)[1], rel=1e-12)
    assert before[3] == pytest.approx(0.0, abs=1e-9)
    trapezoid = one_rise(law_of("trapezoid"))
    before, behind = trapezoid.jets(seam, before=True)[0], trapezoid.jets(seam)[0]
    assert (before[3], behind[3]) == pytest.approx((128 / 3 / pi**3, 0.0), abs=1e-12)
    assert before[2] == pytest.approx(16 / 3 / pi**2)


def test_peaks_have_their_places():
    """Of equal peaks, the first."""
    law, third = law_of("modified_sine"), TURN / 6
    spans = [MotionSpan(0.0, third / 2, 0.0, 1.0, law), MotionSpan(third / 2, 2 * third, 1.0, 0.0, law)]
    motion = SegmentMotion.of(spans, MM, repeat=3)
    assert motion.count == 2
    high, low = motion.extremes(1)
    assert high.value == pytest.approx(scca(0.25, 0.0, 0.75)[0] / (third / 2), rel=1e-12)
    assert high.cam_angle == pytest.approx(third / 4, abs=1e-6)
    assert low.value == pytest.approx(-scca(0.25, 0.0, 0.75)[0] / (1.5 * third), rel=1e-12)
    assert low.cam_angle == pytest.approx(1.25 * third, abs=1e-6)
    assert motion.greatest(2).cam_angle == pytest.approx(third / 16, abs=1e-6)


def test_an_own_motion_has_jets_of_its_pieces():
    """A motion without laws gives the derivatives of its pieces, either side of a break."""
    spans = one_rise(law_of("constant_acceleration"))
    plain = Motion(spans.q, np.array([]), unit=MM)
    for theta in (0.3, pi / 2, pi, 5.0):
        for before in (False, True):
            at = np.array([theta])
            np.testing.assert_allclose(plain.jets(at, before=before), spans.jets(at, before=before), atol=1e-9)


def test_a_law_backwards_is_a_law():
    u = np.linspace(0.0, 1.0, 101)
    law = law_of("unequal_parabola")
    back = law.backwards
    np.testing.assert_allclose(back.derivatives(u)[:, 0], 1 - law.derivatives(1 - u)[:, 0], atol=1e-15)
    np.testing.assert_allclose(back.derivatives(u)[:, 1], law.derivatives(1 - u)[:, 1], atol=1e-15)
    assert back.seams == (0.75,)
    at = np.array([0.75])
    assert back.derivatives(at, before=True)[0, 2] == pytest.approx(8 / 3)
    assert back.derivatives(at)[0, 2] == pytest.approx(-8.0)


@pytest.mark.parametrize("ratio", [0.1, 1.0, 3.0, 7.0])
def test_parabolas_of_any_ratio(ratio):
    law = unequal_parabola(ratio)
    share = 1 / (1 + ratio)
    values = law.derivatives(np.array([0.0, share / 2, share, 0.999]))
    np.testing.assert_allclose(values[:, 2], [2 / share, 2 / share, -2 / (1 - share), -2 / (1 - share)])
    assert values[2, 0] == pytest.approx(share)


@pytest.mark.parametrize("powers", [(10, 18, 26, 34), (4, 6, 8, 10), (12, 13, 14, 60)])
def test_a_valve_lobe_meets_its_ten_conditions(powers):
    """At the end lift and four derivatives are 0, by sums of whole numbers; C_2 by the product formula of the nodes."""
    factors = coefficients(powers)
    every = (2, *powers)
    # Vandermonde in the exponents: C_i = -prod over j of (0 - n_j) / (n_i - n_j).
    for i, n in enumerate(every):
        expected = -np.prod([(0 - m) / (n - m) for j, m in enumerate(every) if j != i])
        assert factors[i] == pytest.approx(expected, rel=1e-12)
    law = valve_lobe(powers)
    end = law.derivatives(np.array([0.0]))[0]
    np.testing.assert_allclose(end, 0.0, atol=1e-9)
    assert law.derivatives(np.array([1.0]))[0, 2] == pytest.approx(2 * factors[0])


@pytest.mark.parametrize(
    "powers", [(10, 18, 26), (18, 10, 26, 34), (2, 18, 26, 34), (10, 18, 26, 61), (10, 10, 26, 34)]
)
def test_other_powers_make_no_lobe(powers):
    with pytest.raises(ValueError, match="it must be four whole numbers that grow, from 3 to 60"):
        valve_lobe(powers)


def test_ratios_out_of_range_are_refused():
    for ratio in (0.0, 51.0):
        with pytest.raises(ValueError, match="acceleration_ratio is"):
            unequal_parabola(ratio)


def test_the_table_of_the_how_to_has_every_law_with_its_figures():
    """Figures to the printed digits, and the letters of the ends by velocity and acceleration there."""
    text = (Path(__file__).parents[2] / "docs/how-to/motion.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+)` \| ([\d.]*) ?\| ([\d.]*) ?\| ([\d.]*) ?\| (\w+) \|", text, re.M)
    assert {row[0] for row in rows} == {*codes(), "polynomial"}
    for code, velocity, acceleration, jerk, ends in rows:
        if code == "polynomial":
            continue
        law = law_of(code)
        np.testing.assert_allclose([float(velocity), float(acceleration), float(jerk)], peaks(law), atol=6e-7)
        assert ends == state_of(*law.ends[0]) + state_of(*law.ends[1]), code
