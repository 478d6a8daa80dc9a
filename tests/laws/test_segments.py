"""Motions of segments: polynomials by conditions, seams, and published examples to their printed digits."""

from math import degrees, pi, radians

import numpy as np
import pytest
from scipy.optimize import brentq

from cadgen.arrays import TURN
from cadgen.errors import DesignError
from cadgen.laws.conditions import Condition, polynomial_law
from cadgen.laws.law import MotionLaw
from cadgen.laws.segments import MotionSpan, SegmentMotion
from cadgen.laws.series import HarmonicMotion
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM

INCH = 25.4


def motion(*spans, **more):
    """Motion of spans: angle in degrees, height at the end, and law; None for a dwell, conditions for a polynomial."""
    segments, at, height = [], 0.0, more.pop("start", 0.0)
    for angle, after, law in spans:
        stop, conditions = at + angle, None
        if isinstance(law, tuple):
            width = radians(angle)
            conditions = tuple(Condition(place / angle, order, value * width**order) for place, order, value in law)
            law = None
        found = law if isinstance(law, MotionLaw) else law and law_of(law)
        segments.append(MotionSpan(radians(at), radians(stop), height, after, found, conditions))
        at, height = stop, after
    return SegmentMotion.of(segments, MM, **more)


def peak(made, order, speed=1.0, sign=0):
    """Greatest value of a derivative by the second, of a sign if one is given."""
    high, low = made.extremes(order)
    value = made.greatest(order).value if sign == 0 else high.value if sign > 0 else low.value
    return value * speed**order


def rpm(speed):
    return speed * TURN / 60


CONDITIONS = [
    [(0.0, 0, 0.0), (0.0, 1, 0.0), (0.0, 2, 0.0), (1.0, 0, 1.0), (1.0, 1, 0.0), (1.0, 2, 0.0)],
    [(0.0, 0, 0.0), (0.0, 1, 0.5), (0.3, 0, 0.4), (0.7, 2, 1.0), (1.0, 0, -2.0), (1.0, 1, 0.0), (1.0, 3, 5.0)],
    [(k / 15, 0, (-1.0) ** k) for k in range(16)],
    [(place, order, 0.3 * place + order) for place in (0.0, 0.5, 1.0) for order in range(5)],
]


@pytest.mark.parametrize("conditions", CONDITIONS)
def test_a_polynomial_meets_its_conditions(conditions):
    """Each to 1e-9 of the largest, by the law's own derivatives; its degree is the count less one."""
    law = polynomial_law([Condition(*each) for each in conditions])
    found = []
    for share, order, value in conditions:
        if order < 4:
            found.append((law.derivatives(np.array([share]))[0, order], value))
    got, wanted = np.array(found).T
    np.testing.assert_allclose(got, wanted, atol=1e-9 * np.abs(wanted).max())
    u = np.linspace(0.0, 1.0, 60)
    fitted = np.polynomial.Chebyshev.fit(u, law.derivatives(u)[:, 0], len(conditions) - 1, domain=[0, 1])
    assert np.abs(fitted(u) - law.derivatives(u)[:, 0]).max() < 1e-9 * np.abs(wanted).max()


def test_rest_at_both_ends_gives_the_books_polynomials():
    u = np.linspace(0.0, 1.0, 101)
    for code, count in (("polynomial_2_3", 2), ("polynomial_3_4_5", 3), ("polynomial_5_6_7_8_9", 5)):
        ends = [Condition(share, order, share * (order == 0)) for share in (0.0, 1.0) for order in range(count)]
        np.testing.assert_allclose(polynomial_law(ends).derivatives(u), law_of(code).derivatives(u), atol=2e-11)


def test_conditions_that_leave_something_open_make_none():
    """Birkhoff: slopes at both ends and a second derivative in the middle say twice what the quadratic term is."""
    assert polynomial_law([Condition(0.0, 1, 0.0), Condition(1.0, 1, 0.0)]) is None
    even = [Condition(0.0, 0, 0.0), Condition(0.0, 1, 0.0), Condition(0.5, 2, 0.0), Condition(1.0, 1, 0.0)]
    assert polynomial_law(even) is None


def test_a_polynomial_takes_what_its_neighbours_do():
    """Nothing given at a seam is the neighbour's height, velocity and acceleration, from either side."""
    made = motion(
        (90, 10.0, ()), (90, 20.0, "constant_velocity"), (90, 8.0, ((30, 1, -9.0),)), (90, 0.0, "simple_harmonic")
    )
    for angle in (0.0, 90.0, 180.0, 270.0):
        at = np.array([radians(angle)])
        np.testing.assert_allclose(made.jets(at, before=True)[0, :3], made.jets(at)[0, :3], atol=1e-9)
    assert made.jets(np.array([radians(210)]))[0, 1] == pytest.approx(-9.0, abs=1e-9)
    assert made.vdi == ("UG", "GG", "GU", "UU")
    assert [seam.order for seam in made.joints] == [3, 3, 3, 3]


def test_derivatives_at_an_end_are_those_given():
    made = motion((180, 5.0, ((180, 1, 0.0), (180, 2, -4.0))), (180, 0.0, ()))
    before = made.jets(np.array([pi]), before=True)[0]
    np.testing.assert_allclose(before[:3], [5.0, 0.0, -4.0], atol=1e-9)
    # The other polynomial takes them from it, and both are at rest where neither says anything.
    np.testing.assert_allclose(made.jets(np.array([pi]))[0, :3], before[:3], atol=1e-9)
    np.testing.assert_allclose(made.jets(np.array([0.0]))[0, :3], 0.0, atol=1e-9)


def test_seams_say_what_jumps_and_where():
    made = motion((90, 10.0, "cycloidal"), (60, 10.0, None), (90, 0.0, "simple_harmonic"), (120, 0.0, None))
    found = [(round(degrees(seam.cam_angle)), seam.order) for seam in made.joints]
    assert found == [(0, 3), (90, 3), (150, 2), (240, 2)]
    jump = made.joints[2]
    assert (jump.before, jump.after) == (0.0, pytest.approx(-10 * pi**2 / 2 / (pi / 2) ** 2))
    assert jump.states == ("R", "U")
    assert made.vdi == ("RR", "RU", "RR", "UR")


def test_a_motion_that_does_not_close_is_refused():
    with pytest.raises(DesignError, match=r"the motion jumps at 0 degrees of cam angle from 1 to 0"):
        motion((180, 5.0, "cycloidal"), (180, 1.0, "cycloidal"))


def test_the_mirrored_motion_runs_backwards_with_its_laws():
    made = motion((90, 10.0, "unequal_parabola"), (60, 10.0, None), (90, 0.0, ()), (120, 0.0, None))
    theta = np.linspace(0.1, TURN, 77)
    sign = np.array([1.0, -1.0, 1.0, -1.0])
    np.testing.assert_allclose(made.mirrored.jets(theta), made.jets(TURN - theta, before=True) * sign, atol=1e-9)


def test_harmonics_are_their_series():
    series = HarmonicMotion.of([(0, 5.0, 0.0), (1, -4.0, 1.0), (7, 0.3, 0.2)], MM)
    theta = np.linspace(0.0, TURN, 999)
    lift = 5 - 4 * np.cos(theta) + np.sin(theta) + 0.3 * np.cos(7 * theta) + 0.2 * np.sin(7 * theta)
    np.testing.assert_allclose(series.jets(theta)[:, 0], lift, atol=1e-13)
    np.testing.assert_allclose(series.q(theta), lift, atol=1e-9)
    jerk = -4 * np.sin(-theta) - np.cos(theta) + 343 * (0.3 * np.sin(7 * theta) - 0.2 * np.cos(7 * theta))
    np.testing.assert_allclose(series.jets(theta)[:, 3], jerk - 8 * np.sin(theta), atol=1e-10)
    np.testing.assert_allclose(series.mirrored.q(theta), series.q(TURN - theta), atol=1e-12)


def test_example_1_cycloidal_point():
    """A rise of 10 mm in 120 degrees at 1000 rev/min, at 100 degrees: 9.711656 mm, 0.25 m/s, -136.03495 m/s²."""
    made = motion((120, 10.0, "cycloidal"), (240, 0.0, "cycloidal"))
    s, v, a, _ = made.jets(np.array([radians(100)]))[0]
    speed = rpm(1000)
    assert s == pytest.approx(9.711656, abs=5e-7)
    assert v * speed == pytest.approx(250.000, abs=5e-4)
    assert a * speed**2 == pytest.approx(-136034.95, abs=5e-3)


def test_example_3_a_roller_on_a_lever():
    """A load on 52 mm of a lever moves by 3.2, 0.95 and 0 mm; its roller on 65 mm at 187.8097 mm/s, 15.7339 m/s²."""
    swing = [np.arcsin(height / 52) for height in (0.0, 3.2, 0.95)]
    made = motion(
        (5, 0.0, None),
        (45, swing[1], "modified_sine"),
        (50, swing[1], None),
        (70, swing[2], "modified_sine"),
        (90, swing[2], None),
        (90, 0.0, "modified_sine"),
        (10, 0.0, None),
    )
    assert 65 * abs(peak(made, 1, rpm(200))) == pytest.approx(187.8097, abs=5e-5)
    assert 65e-3 * abs(peak(made, 2, rpm(200))) == pytest.approx(15.7339, abs=5e-5)


def test_example_4_sarkar():
    """Harmonic 40 mm in 60 and 90 degrees at 300 rev/min, parabolic 25 mm in 120 and 90 degrees at 1000 rev/min."""
    harmonic = motion((60, 40.0, "simple_harmonic"), (90, 0.0, "simple_harmonic"), (210, 0.0, None))
    assert peak(harmonic, 2, rpm(300), 1) * 1e-3 == pytest.approx(177.653, abs=5e-4)
    fall = harmonic.jets(np.radians([60.0 + 1e-9, 150 - 1e-9]))[:, 2] * rpm(300) ** 2 * 1e-3
    np.testing.assert_allclose(fall, [-78.957, 78.957], atol=5e-4)
    parabolic = motion((120, 25.0, "constant_acceleration"), (90, 0.0, "constant_acceleration"), (150, 0.0, None))
    found = parabolic.jets(np.radians([30.0, 150.0]))[:, 2] * rpm(1000) ** 2 * 1e-3
    np.testing.assert_allclose(found, [250.000, -444.444], atol=5e-4)


def test_example_8_rothbart():
    """Parabolic 3:1, 1.25 in in 160 degrees at 1200 rev/min, 2 lb: 20 250 and -6 750 in/s², 104.9 and -35.0 lb."""
    made = motion((160, 1.25 * INCH, "unequal_parabola"), (200, 0.0, "cycloidal"))
    values = made.jets(np.radians([20.0, 100.0]))[:, 2] * rpm(1200) ** 2 / INCH
    np.testing.assert_allclose(values, [20250, -6750], atol=0.5)
    np.testing.assert_allclose(2 * values / 386.0886, [104.9, -35.0], atol=0.05)
    assert made.jets(np.radians([40.0]))[0, 0] / INCH == pytest.approx(5 / 16, abs=1e-12)


def test_example_9_a_flat_face():
    """Face 152.789 mm, least base circle 192.908 mm at 44.73°, the acceleration jumps at 90, 150, 300, 330 and 0°."""
    made = motion(
        (60, 40.0, "cycloidal"),
        (30, 40.0, None),
        (60, 20.0, "simple_harmonic"),
        (60, 20.0, None),
        (60, 40.0, "polynomial_3_4_5"),
        (30, 40.0, None),
        (60, 0.0, "constant_acceleration"),
    )
    high, low = made.extremes(1)
    assert high.value - low.value == pytest.approx(152.789, abs=5e-4)
    theta = np.linspace(radians(44), radians(45.5), 200_001)
    jets = made.jets(theta)
    least = -(jets[:, 0] + jets[:, 2])
    assert least.max() == pytest.approx(192.908, abs=5e-4)
    assert degrees(theta[np.argmax(least)]) == pytest.approx(44.73, abs=0.005)
    assert sorted(round(degrees(seam.cam_angle)) for seam in made.seams) == [0, 90, 150, 300, 330]


def test_example_10_inventors_cubic():
    made = motion((90, 1.0, "polynomial_2_3"), (270, 0.0, "polynomial_2_3"))
    tenths = made.jets(np.radians(np.arange(1, 10) * 9.0))[:, 0]
    np.testing.assert_allclose(tenths, [0.028, 0.104, 0.216, 0.352, 0.5, 0.648, 0.784, 0.896, 0.972], atol=1e-13)


def test_peaks_of_the_how_to_are_found_by_another_way():
    """3-4-5: the jerk is 0 at u = (3 - sqrt(3)) / 6, where the acceleration is 10 / sqrt(3)."""
    made = motion((80, 14.0, "polynomial_3_4_5"), (280, 0.0, "cycloidal"))
    share = brentq(lambda u: 60 - 360 * u + 360 * u**2, 0.0, 0.5)
    assert made.greatest(2).cam_angle == pytest.approx(share * radians(80), abs=1e-7)
    assert made.greatest(2).value == pytest.approx(14 * 10 / np.sqrt(3) / radians(80) ** 2, rel=1e-12)
