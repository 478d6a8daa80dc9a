"""Points where an outline turns, against outlines whose points are known by geometry alone."""

import numpy as np
import pytest

from cadgen.output.drawing.cam_turns import outline_turns

STEPS = 3600
ANGLES = np.linspace(0.0, 2 * np.pi, STEPS, endpoint=False)


def said(radii, curvature):
    """Word, angle in degrees, radius and radius of curvature of each point."""
    turns = outline_turns(np.asarray(radii), np.asarray(curvature))
    return [(str(each.word), float(np.degrees(each.angle)), each.radius, each.bend) for each in turns]


def circle(angle, radius, distance, way):
    """Radii and curvature of the near or far side of a circle about (distance, 0), seen from the axis at angles."""
    cosine = distance * np.cos(angle)
    return cosine + way * np.sqrt(radius**2 - distance**2 + cosine**2), np.full(len(angle), way / radius)


def test_a_notch_between_two_rows_of_the_table_is_found():
    """A disc of 20 mm with a notch of 3 mm about a point on its rim at 125 degrees: depth 17 mm, hollow.

    Rim and notch meet where the chord of the rim is 3 mm: at 2 asin(3 / 40) to either side of it.
    """
    off = np.angle(np.exp(1j * (ANGLES - np.radians(125.0))))
    half = 2 * np.arcsin(3.0 / 40.0)
    inside = np.abs(off) < half
    radii, curvature = np.full(STEPS, 20.0), np.full(STEPS, 1 / 20.0)
    near = 20.0 * np.cos(off[inside]) - np.sqrt(9.0 - (20.0 * np.sin(off[inside])) ** 2)
    radii[inside], curvature[inside] = near, -1 / 3.0
    first, least, last = said(radii, curvature)
    assert least == ("least, hollow", pytest.approx(125.0), pytest.approx(17.0), pytest.approx(3.0))
    assert (first[0], last[0]) == ("greatest, to", "greatest, from")
    assert (first[1], last[1]) == (
        pytest.approx(125.0 - np.degrees(half), abs=0.11),
        pytest.approx(125.0 + np.degrees(half), abs=0.11),
    )


def test_an_arc_ends_where_the_next_law_begins_whether_its_curvature_leaps_or_grows():
    """Half a circle's arc from 90 to 135 degrees: before it a law of cosine, after it one of the third power."""
    before, after = np.clip(np.radians(90.0) - ANGLES, 0.0, None), np.clip(ANGLES - np.radians(135.0), 0.0, None)
    radii = 20.0 + 2.0 * (1.0 - np.cos(2.0 * before)) - 0.2 * after**3
    slope = -4.0 * np.sin(2.0 * before) - 0.6 * after**2
    bend = 8.0 * np.cos(2.0 * before) * (np.radians(90.0) >= ANGLES) - 1.2 * after
    curvature = (radii**2 + 2 * slope**2 - radii * bend) / np.hypot(radii, slope) ** 3
    found = [(word, angle) for word, angle, *_ in said(radii, curvature) if word.startswith("arc")]
    assert found == [("arc from", pytest.approx(90.0)), ("arc to", pytest.approx(135.0))]


def test_an_eccentric_disc_has_its_greatest_and_least_radius_alone():
    radii, curvature = circle(ANGLES - np.radians(40.0), 15.0, 4.0, 1.0)
    assert said(radii, curvature) == [
        ("greatest", pytest.approx(40.0), pytest.approx(19.0), pytest.approx(15.0)),
        ("least", pytest.approx(220.0), pytest.approx(11.0), pytest.approx(15.0)),
    ]


def test_an_ellipse_bends_where_it_is_high():
    """Half axes a and b: radii of curvature b²/a at the ends of the long one, a²/b at those of the short one."""
    a, b = 20.0, 10.0
    radii = a * b / np.hypot(b * np.cos(ANGLES), a * np.sin(ANGLES))
    x, y = radii * np.cos(ANGLES), radii * np.sin(ANGLES)
    curvature = 1 / (a**2 * b**2 * (x**2 / a**4 + y**2 / b**4) ** 1.5)
    assert [(angle, radius, bend) for _, angle, radius, bend in said(radii, curvature)] == [
        (pytest.approx(angle), pytest.approx(radius), pytest.approx(bend))
        for angle, radius, bend in ((0.0, a, 5.0), (90.0, b, 40.0), (180.0, a, 5.0), (270.0, b, 40.0))
    ]
