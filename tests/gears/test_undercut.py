"""Contact ratio and undercut of many pairs at once against those of one tooth and one pair, on its curves."""

from math import radians, sin

import numpy as np
import pytest

from cadgen.errors import DesignError
from cadgen.gears.contact import contact_ratio, contact_ratios, missing_shift
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm, tooth_of


def pair(z1: int, z2: int, module: float, **form: float) -> SpurPair:
    driver, driven = (GradedGear(form=GearForm(teeth=z, normal_module=module, width=5.0, **form)) for z in (z1, z2))
    return SpurPair(driver=driver, driven=driven, centre_distance=module * (z1 + z2) / 2, bearing_span=40.0)


@pytest.mark.slow
def test_both_ways_to_the_contact_ratio_agree():
    rng = np.random.default_rng(20)
    compared = undercut = 0
    while compared < 150:
        angle = radians(rng.choice([14.5, 20.0, 20.0, 25.0, 30.0]))
        form = {
            "normal_pressure_angle": angle,
            "dedendum_factor": rng.choice([1.2, 1.25, 1.4]),
            "rack_tip_radius_factor": rng.choice([0.2, 0.3]),
            "addendum_factor": rng.choice([0.8, 1.0]),
            "tip_chamfer": rng.choice([0.0, 0.02]),
        }
        module = rng.choice([0.5, 1.0, 2.0])
        try:
            made = pair(int(rng.integers(5, 40)), int(rng.integers(8, 150)), module, **form)
            cut = made.cut_to(*(-module * rng.uniform(0, 0.2, 2)))
            expected = contact_ratio(cut)
        except DesignError:  # no flank, or no tip
            continue
        forms = cut.driver.form, cut.driven.form
        teeth = tuple(np.array([float(one.teeth)]) for one in forms)
        shifts = tuple(np.array([one.generating_profile_shift]) for one in forms)
        chamfer = np.array([form["tip_chamfer"] / module])
        assert contact_ratios(forms[0], teeth, shifts, chamfer)[0] == pytest.approx(expected, abs=1e-12)
        for one in forms:
            assert (missing_shift(one) > 0) == tooth_of(one).undercut
        compared += 1
        undercut += missing_shift(forms[0]) > 0
    assert undercut > 20


def test_the_missing_shift_is_what_ends_the_undercut():
    """By the textbook h_fP − ρ (1 − sin α) − z sin² α / 2 − x; with it, and no less, the flank is whole."""
    form = GearForm(teeth=11, normal_module=1.0, width=5.0, profile_shift=0.1)
    missing = missing_shift(form)
    assert missing == pytest.approx(1.25 - 0.38 * (1 - sin(radians(20))) - 11 * sin(radians(20)) ** 2 / 2 - 0.1)
    for less, undercut in ((0.001, False), (-0.01, True)):
        shifted = GearForm(teeth=11, normal_module=1.0, width=5.0, profile_shift=0.1 + missing + less)
        assert tooth_of(shifted).undercut is undercut
