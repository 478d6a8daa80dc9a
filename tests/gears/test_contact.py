"""Contact ratio found on the tooth curves, against the line of action, overlaps of sections, and a handbook."""

import re
from dataclasses import replace
from math import pi, radians

import manifold3d
import numpy as np
import pytest

from cadgen.gears.contact import contact_ratio, found_contact_ratio
from cadgen.gears.pair import GradedGear, closest
from cadgen.gears.spur import SpurPair, has_room, roomier
from cadgen.gears.tooth import GearForm, tooth_of
from cadgen.geometry.meshes.teeth import LEAST_OVERLAP, measured_pair

# Steps of the search over a pitch, and four of them for what ends between two.
FOUND_WITHIN = 2e-3


def pair(z1: int, z2: int, module: float = 0.5, thinning: float = -0.1, **form: float) -> SpurPair:
    """`thinning` in modules."""
    one, two = (
        GradedGear(
            form=GearForm(teeth=z, normal_module=module, width=5.0, tooth_thickness_deviation=thinning * module, **form)
        )
        for z in (z1, z2)
    )
    return SpurPair(driver=one, driven=two, centre_distance=module * (z1 + z2) / 2, bearing_span=80.0)


def pressed(made: SpurPair, interference: float) -> float:
    """Pitches over which tooth 0 of the driver alone overlaps the driven gear, pressed in by `interference` (mm).

    By areas of polygons: nothing of what `contact` knows. Past its end a contact opens with the square of the way,
    so the ends found at one and at four times the interference, extrapolated, give the end at none.
    """

    def cross(points):
        return manifold3d.CrossSection([np.column_stack([points.real, points.imag])])

    def carrying(pressing: float) -> float:
        built = measured_pair(made)
        offset = built.limit(0.0, 1) - built.middle(0.0) + pressing / made.driven_pitch_radius
        tooth = np.append(built.driver.corners[0], 0j)

        def touches(angle: float) -> bool:
            driven = made.centre_distance + built.driven.teeth_towards(built.middle(angle) + offset, pi)
            return (cross(tooth * np.exp(1j * angle)) ^ cross(driven)).area() > LEAST_OVERLAP / 100

        step = 2 * pi / made.driver.form.teeth / 8
        inside = [step * number for number in range(-16, 17) if touches(step * number)]
        ends = []
        for within, outside in ((inside[0], inside[0] - step), (inside[-1], inside[-1] + step)):
            while abs(within - outside) > 1e-7:
                between = (within + outside) / 2
                within, outside = (between, outside) if touches(between) else (within, between)
            ends.append(within)
        return ends[1] - ends[0]

    return (2 * carrying(interference) - carrying(4 * interference)) * made.driver.form.teeth / (2 * pi)


@pytest.mark.parametrize("z2", [30, 150, 400])
def test_undercut_pinions_and_large_wheels_have_the_contact_of_the_line_of_action(z2):
    for z1 in (8, 10, 12, 14, 16, 17, 18):
        for thinning in (0.0, -0.3):
            made = pair(z1, z2, thinning=thinning)
            assert tooth_of(made.driver.form).undercut or z1 > 16
            assert found_contact_ratio(made) == pytest.approx(contact_ratio(made), abs=FOUND_WITHIN)


@pytest.mark.parametrize("alpha", [10.0, 12.0, 14.5, 25.0, 30.0])
def test_flat_and_steep_racks(alpha):
    for z1, z2 in ((30, 150), (150, 30), (20, 20), (40, 120)):
        made = pair(z1, z2, normal_pressure_angle=radians(alpha), rack_tip_radius_factor=0.1)
        assert found_contact_ratio(made) == pytest.approx(contact_ratio(made), abs=FOUND_WITHIN)


@pytest.mark.parametrize(("z1", "z2"), [(30, 150), (40, 120), (150, 30)])
def test_contact_found_is_where_a_tooth_overlaps_when_it_is_pressed_in(z1, z2):
    made = pair(z1, z2)
    assert found_contact_ratio(made) == pytest.approx(pressed(made, 2e-4), abs=5e-3)


def test_the_corner_of_an_undercut_is_left_so_slowly_that_it_must_be_pressed_in_very_little():
    made = pair(12, 150)
    off = [abs(pressed(made, interference) - found_contact_ratio(made)) for interference in (2e-4, 2e-5)]
    assert off[0] > 0.01
    assert off[1] < 0.005


def test_contact_ratio_of_the_handbook():
    """KHK gear technical reference, calculation of contact ratio: m 3, z 12/24, x 0.6/0.36, ε 1.202."""
    loose = pair(12, 24, 3.0, 0.0)
    one, two = (
        replace(gear, form=replace(gear.form, profile_shift=x))
        for gear, x in ((loose.driver, 0.6), (loose.driven, 0.36))
    )
    shifted = replace(loose, driver=one, driven=two, centre_distance=3.0 * (18 + 0.96))
    shifted = replace(shifted, centre_distance=shifted.zero_backlash_centre_distance)
    # The handbook shortens the tips by the shifts' excess over the gain in centre distance.
    short = 0.96 - (shifted.centre_distance / 3.0 - 18)
    one, two = (replace(gear, form=replace(gear.form, addendum_factor=1 - short)) for gear in (one, two))
    made = replace(shifted, driver=one, driven=two)
    assert made.driver.form.tip_diameter == pytest.approx(44.840, abs=1e-3)
    assert contact_ratio(made) == pytest.approx(1.202, abs=2e-3)
    assert found_contact_ratio(made) == pytest.approx(contact_ratio(made), abs=FOUND_WITHIN)


def test_a_chamfer_takes_contact_off_at_the_tips():
    full, cut = pair(30, 150), pair(30, 150, tip_chamfer=0.05)
    assert found_contact_ratio(cut) == pytest.approx(contact_ratio(cut), abs=FOUND_WITHIN)
    assert found_contact_ratio(cut) < found_contact_ratio(full) - 0.05


def test_tips_that_stand_apart_have_no_contact():
    apart = replace(pair(30, 60), centre_distance=23.49)
    assert contact_ratio(apart) < 0.05
    assert found_contact_ratio(apart) == pytest.approx(contact_ratio(apart), abs=FOUND_WITHIN)


@pytest.mark.parametrize(
    ("one", "other", "form"),
    [
        (9, 9, {}),
        (10, 43, {}),
        (20, 20, {"addendum_factor": 0.3}),
        (14, 40, {"addendum_factor": 1.3}),
        (20, 20, {"profile_shift": 1.5, "addendum_factor": 0.5}),
        (30, 30, {"addendum_factor": 1.2, "dedendum_factor": 1.25}),
    ],
)
def test_numbers_named_for_teeth_without_room_have_it(one, other, form):
    """Put in, the contact found on the curves suffices, roots are clear and no sections overlap midway."""
    made = pair(one, other, thinning=-0.05)
    gears = [replace(gear, form=replace(gear.form, **form)) for gear in (made.driver, made.driven)]
    apart = closest(*(gear.form.cut_to(0.0) for gear in gears))
    made = replace(made, driver=gears[0], driven=gears[1], centre_distance=apart)
    assert not has_room(made)
    named = str(roomier(made, False))
    values = [float(value) for value in re.findall(r"-?\d+\.?\d*", named)][:2]
    if "shifts" in named and "addendum" in named:
        made = replace(
            made,
            **{
                role: replace(gear, form=replace(gear.form, addendum_factor=1.0))
                for role, gear in (("driver", made.driver), ("driven", made.driven))
            },
        )
    key = "teeth" if "teeth" in named else "profile_shift" if "shifts" in named else "addendum_factor"
    both = values if len(values) == 2 else values * 2
    forms = [
        replace(gear.form, **{key: int(value) if key == "teeth" else value})
        for gear, value in zip((made.driver, made.driven), both, strict=True)
    ]
    apart = made.centre_distance if key == "addendum_factor" else closest(*(form.cut_to(0.0) for form in forms))
    cured = replace(
        made,
        driver=replace(made.driver, form=forms[0]),
        driven=replace(made.driven, form=forms[1]),
        centre_distance=apart,
    )
    assert found_contact_ratio(cured) >= 1.1
    built = measured_pair(cured)
    assert min(built.clearances()) >= 0.12 * 0.5 - 1e-9
    step = 2 * pi / cured.driver.form.teeth / 16
    assert max(built.overlap_midway(step * number) for number in range(16)) < LEAST_OVERLAP


def test_axes_too_far_apart_are_told_the_distance():
    """A stated distance gives way where nothing else helps, and stands beside shifts and teeth that need another."""
    named = str(roomier(replace(pair(20, 40, thinning=-0.05), centre_distance=15.75), False))
    assert named == "give centre_distance_mm = 15.0000"
    named = str(roomier(replace(pair(9, 9, thinning=-0.05), centre_distance=4.9), False))
    assert re.fullmatch(r"give the profile shifts 0.3 and 0.3, at centre_distance_mm = \d+\.\d{4}", named)
    named = str(roomier(replace(pair(7, 7, thinning=-0.05), centre_distance=4.0), False))
    assert re.fullmatch(r"give \d+ and \d+ teeth, at centre_distance_mm = \d+\.\d{4}", named)
