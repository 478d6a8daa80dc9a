"""Published examples that no other file holds, to their printed digits; and where each of the others is.

- KHK and SDP/SI D785, helical and internal pair, table 5-3a, spans, pins, chords: `test_helical`, `test_internal`.
- LECAD planetary program: here, and the ring's shift in `test_planetary`. Its size over balls of 3 mm, 184.7755, is not
  that of balls on these flanks, 184.7491.
- Sheet by ISO 21771, ISO/TR 6336-30 example 1, MESYS calculator: `test_helical`.
- bolsover.com: here and in `test_helical`.
- GEARpie C14: its contact here.
- GEARpie H501 and hanslhansl/din3990, stresses: not held, for the program computes no strength. H501 takes F_t at the
  working circle, where ISO 6336 wants the reference circle. The centre distance of din3990 is in `test_helical`.
"""

from math import cos, pi, sqrt

import pytest

from cadgen.gears.contact import contact_ratio
from cadgen.gears.inspection import span_over
from cadgen.gears.pair import closest
from tests.gears.test_helical import gear, pair_of


def test_lecad_spans_and_shortened_tips():
    """m 1.75, 21/43 at 56.8, x 0.438/0.0426: d_a 41.7008/78.8170 with tips cut by k, W_3 13.9546, W_5 24.3530."""
    shortened = 1 + (56.8 - 56.0) / 1.75 - 0.4806
    sun, planet = (
        gear(teeth, 1.75, shift=shift, addendum_factor=shortened) for teeth, shift in ((21, 0.438), (43, 0.0426))
    )
    # 41.70088 here: it prints 4 digits cut off, as its x has three.
    assert [sun.tip_diameter, planet.tip_diameter] == pytest.approx([41.7008, 78.8170], abs=1.1e-4)
    assert [span_over(sun, 3), span_over(planet, 5)] == pytest.approx([13.9546, 24.3530], abs=6e-5)


def test_bolsover_tips_roots_and_contact():
    """m 3, 12/24 at 56.5: d_a 44.84/79.40 with tips cut by k, d_f 32.1/66.66, ε 1.202."""
    shortened = 1 + 2.5 / 3 - 0.96
    one, two = (gear(teeth, 3.0, shift=shift, addendum_factor=shortened) for teeth, shift in ((12, 0.6), (24, 0.36)))
    assert [one.tip_diameter, two.tip_diameter] == pytest.approx([44.84, 79.40], abs=5e-3)
    assert [one.root_diameter, two.root_diameter] == pytest.approx([32.1, 66.66], abs=5e-3)
    assert contact_ratio(pair_of(one, two, 56.5)) == pytest.approx(1.202, abs=5e-4)


def test_gearpie_fzg_c14():
    """FZG C: m 4.5, 16/24 at 91.5, x 0.1817/0.1715, d_a 82.46/118.36: ε_α 1.44, AC 9.50, AE 19.10."""
    one = gear(16, 4.5, shift=0.1817, addendum_factor=(82.46 / 4.5 - 16) / 2 - 0.1817)
    two = gear(24, 4.5, shift=0.1715, addendum_factor=(118.36 / 4.5 - 24) / 2 - 0.1715)
    meshing = pair_of(one, two, 91.5)
    assert closest(one, two) == pytest.approx(91.5, abs=5e-3)
    assert contact_ratio(meshing) == pytest.approx(1.44, abs=5e-3)
    pitch = pi * 4.5 * cos(one.transverse_pressure_angle)
    assert contact_ratio(meshing) * pitch == pytest.approx(19.10, abs=5e-3)
    # From the tips of the wheel to the pitch point.
    along = sqrt(two.tip_diameter**2 - two.base_diameter**2) / 2
    rolled = two.base_diameter / 2 / cos(meshing.working_pressure_angle)
    assert along - sqrt(rolled**2 - (two.base_diameter / 2) ** 2) == pytest.approx(9.50, abs=5e-3)
