"""Span and size over pins against the literature and against flats and pins laid on the exact flanks."""

from math import cos, hypot, pi, radians, tan

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from cadgen.errors import DesignError
from cadgen.gears.inspection import ideal_pin_diameter, inspection_of, size_over_pins, span_over
from cadgen.gears.tooth import GearForm, tooth_of


def gear(teeth: int, module: float = 1.0, shift: float = 0.0, angle_deg: float = 20.0, **numbers: float) -> GearForm:
    return GearForm(
        teeth=teeth,
        normal_module=module,
        width=5.0,
        profile_shift=shift,
        normal_pressure_angle=radians(angle_deg),
        **numbers,
    )


def test_span_of_the_literature() -> None:
    # KHK, Gear Technical Reference, span measurement of spur gears: m = 3, z = 24, x = +0.4, 4 teeth.
    form = gear(24, 3.0, 0.4)
    assert span_over(form, 4) == pytest.approx(32.8266, abs=5e-5)
    assert inspection_of(form, 0.0, 0.0).span.teeth_spanned == 4
    # Worked example of a published calculator: m = 2, z = 20, 3 teeth, touching on 40.59 mm.
    plain = inspection_of(gear(20, 2.0), 0.0, 0.0).span
    assert plain.teeth_spanned == 3
    assert plain.span.nominal == pytest.approx(15.321, abs=5e-4)
    assert plain.contact_diameter == pytest.approx(40.59, abs=5e-3)


# Machinery's Handbook, Checking Spur Gear Size by Measurement Over Wires (Van Keuren): diametral pitch 1, wires
# of 1.728, so lengths in modules. Columns are pressure angles in degrees.
WIRE_ANGLES_DEG = (14.5, 17.5, 20.0, 25.0, 30.0)
OVER_WIRES = {
    6: (8.2846, 8.2927, 8.3032),
    7: (9.1116, 9.1172, 9.1260, 9.1536, 9.1928),
}


@pytest.mark.parametrize("teeth", OVER_WIRES)
def test_size_over_pins_of_the_literature(teeth: int) -> None:
    for angle_deg, printed in zip(WIRE_ANGLES_DEG, OVER_WIRES[teeth], strict=False):
        assert size_over_pins(gear(teeth, angle_deg=angle_deg), 1.728) == pytest.approx(printed, abs=5.1e-5)


def test_size_over_pins_of_the_handbooks_worked_example() -> None:
    # Ibid.: 32 teeth, 20°, 34.4130 for diametral pitch 1.
    assert size_over_pins(gear(32), 1.728) == pytest.approx(34.4130, abs=5e-5)


def test_ideal_pin_of_the_literature() -> None:
    # KHK, Gear Technical Reference, over pin measurement of spur gears: m = 1, z = 20, x = 0.
    assert ideal_pin_diameter(gear(20)) == pytest.approx(1.7245, abs=1e-4)


def pin_rest(form: GearForm, pin_diameter: float) -> tuple[float, float]:
    """Radius at which a pin pushed into a space touches the flank, and the radius of its contact, in mm."""
    flank = tooth_of(form).upper_flank
    points = flank.point(np.linspace(0.0, 1.0, 20001))
    to_space = np.exp(1j * pi / form.teeth)
    low, high = form.root_diameter / 2, form.tip_diameter / 2 + 2 * pin_diameter
    for _ in range(60):
        middle = (low + high) / 2
        clear = np.abs(points - middle * to_space).min() >= pin_diameter / 2
        low, high = (low, middle) if clear else (middle, high)
    nearest = int(np.argmin(np.abs(points - high * to_space)))
    return high, float(abs(points[nearest]))


@pytest.mark.parametrize("teeth", [9, 20, 33, 150])
@pytest.mark.parametrize("shift", [0.0, 0.4])
def test_a_pin_pushed_into_the_space_rests_where_the_formula_says(teeth: int, shift: float) -> None:
    form = gear(teeth, 0.5, shift, tooth_thickness_deviation=-0.02)
    pins = inspection_of(form, -0.02, -0.05).pins
    rest, contact = pin_rest(form, pins.pin_diameter)
    across = 2 * rest * (1.0 if teeth % 2 == 0 else cos(pi / 2 / teeth))
    assert pins.over_pins.upper == pytest.approx(across + pins.pin_diameter, abs=1e-7)
    assert pins.contact_diameter == pytest.approx(2 * contact, abs=1e-3)


@pytest.mark.parametrize("teeth", [9, 20, 33, 150])
@pytest.mark.parametrize("shift", [0.0, 0.4])
def test_flats_laid_on_the_flanks_are_the_span_apart(teeth: int, shift: float) -> None:
    form = gear(teeth, 0.5, shift, tooth_thickness_deviation=-0.02)
    span = inspection_of(form, -0.02, -0.05).span
    # The spanned teeth stand evenly about the x axis; flats across y touch the outer flanks of the outer teeth.
    flank = tooth_of(form).upper_flank.rotated((span.teeth_spanned - 1) * pi / teeth)
    points = flank.point(np.linspace(0.0, 1.0, 20001))
    highest = int(np.argmax(points.imag))
    assert 0 < highest < 20000
    assert span.span.upper == pytest.approx(2 * points.imag[highest], abs=1e-8)
    assert span.contact_diameter == pytest.approx(2 * abs(points[highest]), abs=1e-3)


def test_limits_are_those_of_the_deviation() -> None:
    form = gear(40, 0.5)
    found = inspection_of(form, -0.033, -0.078)
    span, pins = found.span.span, found.pins.over_pins
    # DIN 21773: E_bn = E_sn cos α_n.
    assert span.upper - span.nominal == pytest.approx(-0.033 * cos(radians(20)), abs=1e-12)
    assert span.lower - span.nominal == pytest.approx(-0.078 * cos(radians(20)), abs=1e-12)
    # DIN 21773, linearised: E_M = E_sn cos α / sin α_K for an even number of teeth, good to E_sn² / m.
    centre = form.base_diameter / (pins.nominal - found.pins.pin_diameter)
    slope = cos(radians(20)) / np.sqrt(1 - centre**2)
    assert pins.upper - pins.nominal == pytest.approx(-0.033 * slope, abs=0.033**2 / 0.5)
    assert pins.nominal > pins.upper > pins.lower
    assert pins.lower == size_over_pins(form.cut_to(-0.078), found.pins.pin_diameter)


def test_pins_may_touch_where_din_3977_allows() -> None:
    # DIN 3977, figure 2: z = 35, x = +0.5: 1.73 m < D_M < 2.54 m (read off a diagram) puts the contact between 0.1 m
    # below and 0.5 m above the circle d + 2 x m.
    form = gear(35, shift=0.5)
    middle = form.reference_diameter + 1.0
    for pin_diameter, place in ((1.73, -0.1), (2.54, 0.5)):
        contact = inspection_of(form, 0.0, 0.0, pin_diameter).pins.contact_diameter
        assert (contact - middle) / 2 == pytest.approx(place, abs=0.03)


@pytest.mark.slow
@settings(max_examples=80, deadline=None)
@given(
    teeth=st.integers(8, 200),
    module=st.floats(0.2, 6.0),
    shift=st.floats(-0.3, 0.7),
    upper=st.floats(-0.05, 0.0),
    tolerance=st.floats(0.0, 0.1),
)
def test_what_is_chosen_can_be_measured(
    teeth: int, module: float, shift: float, upper: float, tolerance: float
) -> None:
    form = gear(teeth, module, shift)
    try:
        found = inspection_of(form, upper * module, (upper - tolerance) * module)
    except DesignError:
        assume(False)
    for deviation in (upper * module, (upper - tolerance) * module):
        tooth = tooth_of(form.cut_to(deviation))
        usable = (tooth.root_form_diameter, tooth.form.tip_form_diameter)
        if found.span:
            span = span_over(tooth.form, found.span.teeth_spanned)
            assert usable[0] < hypot(form.base_diameter, span) < usable[1]
        if found.pins:
            pin = found.pins.pin_diameter
            centre = size_over_pins(tooth.form, pin) - pin
            centre /= 1.0 if teeth % 2 == 0 else cos(pi / 2 / teeth)
            roll = tan(np.arccos(form.base_diameter / centre)) - pin / form.base_diameter
            assert usable[0] < form.base_diameter * hypot(1.0, roll) < usable[1]
            assert centre + pin > form.tip_diameter
            assert centre - pin > tooth.form.root_diameter
    assert found.span is not None or teeth < 12 or shift < 0


def test_bad_requests_are_refused() -> None:
    with pytest.raises(DesignError, match="E_sni"):
        inspection_of(gear(20), -0.05, -0.01)
    for pin_diameter in (0.3, 1.3, 9.0):
        with pytest.raises(DesignError, match=r"give about 1\.7"):
            inspection_of(gear(20), 0.0, -0.05, pin_diameter)
    with pytest.raises(DesignError, match="drop into its spaces"):
        size_over_pins(gear(20), 0.3)


def test_flanks_too_short_or_too_far_in_have_no_measurement() -> None:
    low = inspection_of(gear(5, shift=0.1, addendum_factor=0.5), 0.0, -0.01)
    assert low.span is None
    assert low.pins is not None
    # Over so wide a tolerance no pin touches the flanks at both limits and still stands out.
    wide = inspection_of(gear(20, addendum_factor=0.3), 0.0, -1.0)
    assert wide.pins is None


def test_a_face_too_narrow_for_the_span_says_how_wide_it_must_be():
    """W sin beta_b of the span over as few teeth as touch the flanks."""
    from math import asin, sin

    from cadgen import Gear

    narrow = {"teeth": 40, "module": 1, "helix_angle": radians(30)}
    facts = Gear(width=8, **narrow).facts()
    assert facts["span_mm"] is None
    needed = facts["span_width_needed_mm"]
    made = Gear(width=needed + 1e-6, **narrow).facts()
    lean = asin(sin(radians(30)) * cos(radians(20)))
    assert made["span_width_needed_mm"] == pytest.approx(made["span_mm"] * sin(lean))
    assert made["span_width_needed_mm"] == pytest.approx(needed)
