"""A path by control points: against the recursion of Cox and de Boor, at its ends, and on a parabola that it holds."""

import numpy as np
import pytest

from cadgen.car.path.spline import control_path
from cadgen.car.path.wheel_track import offset_track
from cadgen.errors import DesignError

POINTS = np.array([[0, 0], [300, 0], [700, 50], [1100, 400], [1300, 900], [1200, 1500], [800, 1800], [300, 1700.0]])


def basis(knots: list[float], number: int, degree: int, u: float) -> float:
    """Value of one B-spline by its definition (de Boor, A Practical Guide to Splines, ch. IX)."""
    if degree == 0:
        return float(knots[number] <= u < knots[number + 1])
    value = 0.0
    for first, sign in ((number, 1.0), (number + 1, -1.0)):
        width = knots[first + degree] - knots[first]
        if width > 0:
            start = knots[first] if sign > 0 else knots[first + degree]
            value += sign * (u - start) / width * basis(knots, first, degree - 1, u)
    return value


def test_is_the_b_spline_that_the_design_file_describes():
    """The knots 0, 1, ..., n - 5, the first and the last sixfold."""
    last = len(POINTS) - 5
    knots = [0.0] * 5 + [float(k) for k in range(last + 1)] + [float(last)] * 5
    path = control_path(POINTS)
    for u in (0.0, 0.3, 1.0, 1.7, 2.99):
        expected = sum(basis(knots, number, 5, u) * point for number, point in enumerate(POINTS))
        np.testing.assert_allclose(path.spline(u), expected, atol=1e-9)
    assert path.knots.tolist() == [0, 1, 2, 3]


def test_starts_on_the_first_point_towards_the_second_and_ends_on_the_last():
    path = control_path(POINTS)
    (r, r1, *_) = path.derivatives(path.knots[[0, -1]])
    np.testing.assert_allclose(r, POINTS[[0, -1]], atol=1e-9)
    for slope, leg in zip(r1, (POINTS[1] - POINTS[0], POINTS[-1] - POINTS[-2]), strict=True):
        np.testing.assert_allclose(slope / np.linalg.norm(slope), leg / np.linalg.norm(leg), atol=1e-12)


def test_the_track_of_a_parabola_is_exact():
    """Blossoms of x = 600 u, y = 40 u^2 are its control points; curvature and length have closed forms."""
    n = 12
    knots = np.concatenate([np.zeros(5), np.arange(n - 4.0), np.full(5, n - 5.0)])
    inner = [knots[k + 1 : k + 6] for k in range(n)]
    points = [[600 * t.mean(), 40 * (t.sum() ** 2 - (t**2).sum()) / 20] for t in inner]
    track = offset_track(control_path(np.array(points)), 0.0)
    x = track.planned(track.arc)[:, 0]
    slope, bend = 80 * x / 600**2, 80 / 600**2
    np.testing.assert_allclose(track.curvature_jets[:, 0], bend / (1 + slope**2) ** 1.5, rtol=1e-9)
    end = slope[-1]
    np.testing.assert_allclose(track.length, (end * np.hypot(1, end) + np.arcsinh(end)) / (2 * bend), rtol=1e-12)
    assert track.kinks.size == 0


@pytest.mark.parametrize(
    ("points", "words"),
    [
        (POINTS[:5], "has 5 points; a path needs at least 6: add more"),
        (POINTS[[0, 1, 2, 2, 3, 4, 5]], "points 3 and 4 are both"),
        (np.where(np.arange(8)[:, None] == 4, np.nan, POINTS), "point 5 is not a finite number"),
        (POINTS[:, :1], r"list of \[x, y\] pairs"),
    ],
)
def test_refuses(points, words):
    with pytest.raises(DesignError, match=words):
        control_path(points)


def test_a_cusp_is_named_by_its_knots():
    back = np.array([[0, 0], [500, 0], [1000, 0], [1400, 0], [1400, 100], [1000, 100], [500, 100], [0, 100.0]])
    with pytest.raises(DesignError, match=r"turns left .* between knots 2 and 3, .* has a cusp there"):
        offset_track(control_path(back), 117.5)
