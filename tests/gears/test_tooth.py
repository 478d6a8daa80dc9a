"""The tooth form against a rack that is rolled over it, against the literature, and at its limits."""

import re
from dataclasses import dataclass, replace
from math import cos, pi, radians, sin, tan

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from cadgen.errors import DesignError
from cadgen.gears.tooth import GearForm, ToothError, involute, tooth_of
from cadgen.parts.loop import bernstein, bezier_poles, chord_parameters

# Rounding of the rolled rack's distance on a gear of 100 mm, with a margin.
ROLLED_ZERO_MM = 1e-9


@dataclass(frozen=True)
class RollingRack:
    """One tooth of a cutting rack, rolled on the reference circle; knows nothing of envelopes.

    The tool's straight flanks and its tip line, moved inwards by the tip radius, bound a core; the tool is all that
    lies within the tip radius of the core. Its own frame has y outwards from the datum line and the tool on x = 0.
    """

    form: GearForm

    def distance(self, gear_points: np.ndarray, angle: np.ndarray) -> np.ndarray:
        """Signed distance (mm, negative inside the tool) of gear points when the gear has turned by `angle`."""
        form = self.form
        module, alpha = form.normal_module, form.normal_pressure_angle
        radius = module * form.rack_tip_radius_factor
        shift = module * form.profile_shift + form.tooth_thickness_deviation / (2 * tan(alpha))
        # The space whose middle stands at +π/z is brought upright and turned clockwise while the rack moves
        # to +x.
        fixed = gear_points * np.exp(1j * (pi / 2 - pi / form.teeth - angle))
        reference = form.teeth * module / 2
        x, y = fixed.real - reference * angle, fixed.imag - reference - shift
        bottom = -module * form.dedendum_factor + radius
        # Flank: x cos α − y sin α = (π m / 4) cos α, moved inwards by the radius.
        corner = (module * pi / 4 * cos(alpha) - radius + bottom * sin(alpha)) / cos(alpha)
        across, height = np.abs(x) - corner, y - bottom
        beside = across * cos(alpha) - height * sin(alpha)
        up_flank = across * sin(alpha) + height * cos(alpha)
        to_corner = np.hypot(across, height)
        outside = np.where(across <= 0, -height, np.where(up_flank <= 0, to_corner, beside))
        inside_core = (beside <= 0) & (height >= 0)
        return np.where(inside_core, np.maximum(beside, -height), outside) - radius

    def deepest_cut(self, gear_points: np.ndarray) -> np.ndarray:
        """Least signed distance over the whole roll, shape of `gear_points`; zero on a cut surface."""
        angles = np.linspace(-25.0, 25.0, 2001) / self.form.teeth
        grid = self.distance(gear_points[:, None], angles)
        best, step = angles[np.argmin(grid, axis=1)], angles[1] - angles[0]
        low, high = best - step, best + step
        golden = (np.sqrt(5) - 1) / 2
        for _ in range(60):
            a, b = high - golden * (high - low), low + golden * (high - low)
            left = self.distance(gear_points, a) < self.distance(gear_points, b)
            low, high = np.where(left, low, a), np.where(left, b, high)
        return self.distance(gear_points, (low + high) / 2)


def gear(teeth: int, module: float = 1.0, shift: float = 0.0, **numbers: float) -> GearForm:
    return GearForm(teeth=teeth, normal_module=module, width=5.0, profile_shift=shift, **numbers)


CUT_GEARS = [
    gear(6, shift=0.2),
    gear(8),
    gear(12),
    gear(17),
    gear(18),
    gear(30, 0.5, tooth_thickness_deviation=-0.08),
    gear(150, 0.5, tooth_thickness_deviation=-0.12),
    gear(20, shift=0.8),
    gear(40, shift=1.0),
    gear(60, shift=-0.6),
    gear(14, 2.0, rack_tip_radius_factor=0.25),
    gear(25, rack_tip_radius_factor=0.02),
    gear(25, rack_tip_radius_factor=0.471907),
    gear(25, rack_tip_radius_factor=0.1, dedendum_factor=1.0, shift=0.9),
    gear(30, normal_pressure_angle=radians(14.5), rack_tip_radius_factor=0.3),
    gear(30, normal_pressure_angle=radians(25.0), rack_tip_radius_factor=0.25),
    gear(200, 2.0),
]


@pytest.mark.parametrize("form", CUT_GEARS, ids=str)
def test_the_rolled_rack_touches_every_point_of_flank_and_root(form: GearForm) -> None:
    tooth = tooth_of(form)
    t = np.linspace(0.0, 1.0, 41)
    rack = RollingRack(form)
    for curve in (tooth.upper_root, tooth.upper_flank):
        deepest = rack.deepest_cut(curve.point(t))
        assert np.abs(deepest).max() < ROLLED_ZERO_MM * form.reference_diameter / 10
    floor = form.root_diameter / 2 * np.exp(1j * (pi / form.teeth + np.array([-1, 0, 1]) * tooth.root_flat_angle))
    assert np.abs(rack.deepest_cut(floor)).max() < ROLLED_ZERO_MM * form.reference_diameter / 10


def test_the_rolled_rack_leaves_the_material_and_clears_the_space() -> None:
    form = gear(9, shift=0.1)
    tooth, rack = tooth_of(form), RollingRack(form)
    for curve in (tooth.upper_root, tooth.upper_flank):
        points = curve.point(np.linspace(0.02, 0.98, 25))
        into_the_tooth = -1j * curve.tangent(np.linspace(0.02, 0.98, 25))
        outwards = points - 1e-3 * into_the_tooth
        inwards = points + 1e-3 * into_the_tooth
        assert rack.deepest_cut(inwards).min() > 0.5e-3
        assert rack.deepest_cut(outwards).max() < -0.5e-3


def test_undercut_begins_at_the_number_of_teeth_of_the_literature() -> None:
    # ISO 21771-1: z_min = 2 h_Ff* / sin² α with h_Ff* = 1.0 for ISO 53 profile A, so 17.1 teeth.
    assert tooth_of(gear(17)).undercut
    assert not tooth_of(gear(18)).undercut
    for teeth in (10, 12, 16):
        limit = 1.25 - 0.38 * (1 - sin(radians(20))) - teeth * sin(radians(20)) ** 2 / 2
        assert tooth_of(gear(teeth, shift=limit - 0.01)).undercut
        assert not tooth_of(gear(teeth, shift=limit + 0.01)).undercut


@pytest.mark.parametrize("teeth", [10, 17, 23])
def test_the_tooth_is_continuous_through_the_limit_of_undercut(teeth: int) -> None:
    limit = 1.25 - 0.38 * (1 - sin(radians(20))) - teeth * sin(radians(20)) ** 2 / 2
    diameters = [tooth_of(gear(teeth, shift=limit + e)).root_form_diameter for e in (-1e-7, -1e-9, 0, 1e-9, 1e-7)]
    assert np.ptp(diameters) < 1e-6
    assert diameters[2] == pytest.approx(gear(teeth).base_diameter, abs=1e-6)


def test_root_and_flank_meet_and_are_tangent_without_undercut() -> None:
    for form in (gear(18), gear(60), gear(150, 0.5), gear(20, shift=0.9)):
        tooth = tooth_of(form)
        gap = abs(tooth.upper_root.point(1.0) - tooth.upper_flank.point(0.0))
        assert gap < 1e-12 * form.reference_diameter
        assert abs(tooth.upper_root.tangent(1.0) - tooth.upper_flank.tangent(0.0)) < 1e-9


def test_tooth_thickness_of_the_literature() -> None:
    # SDP/SI, Elements of Metric Gear Technology, table 10-1: m = 10, z = 12, x = +0.3.
    form = gear(12, 10.0, 0.3)
    assert form.tooth_thickness == pytest.approx(17.8918, abs=5e-5)
    assert form.tip_diameter == pytest.approx(146.0)


@pytest.mark.parametrize(
    ("degrees", "printed"), [(14.5, 0.005545), (20.0, 0.014904), (25.0, 0.029975), (30.0, 0.053751)]
)
def test_the_involute_function_is_that_of_the_tables(degrees: float, printed: float) -> None:
    """Tables of inv α with six digits, as in handbooks of gears."""
    assert involute(radians(degrees)) == pytest.approx(printed, abs=5.1e-7)


def test_thinning_feeds_the_rack_and_leaves_the_tip() -> None:
    whole, thin = gear(30, 0.5, 0.2), gear(30, 0.5, 0.2, tooth_thickness_deviation=-0.06)
    assert thin.tooth_thickness == pytest.approx(whole.tooth_thickness - 0.06, abs=1e-12)
    assert thin.root_diameter == pytest.approx(whole.root_diameter - 0.06 / tan(radians(20)), abs=1e-12)
    assert thin.tip_diameter == whole.tip_diameter
    flank = tooth_of(thin).upper_flank
    on_reference = (tan(radians(20)) - flank.roll_start) / (flank.roll_end - flank.roll_start)
    point = complex(flank.point(on_reference))
    assert abs(point) == pytest.approx(thin.reference_diameter / 2, abs=1e-12)
    assert 2 * np.angle(point) * abs(point) == pytest.approx(thin.tooth_thickness, abs=1e-12)


def test_the_chamfer_takes_its_leg_off_tip_circle_and_flank() -> None:
    form = gear(24, 2.0, tip_chamfer=0.2)
    plain, tooth = tooth_of(gear(24, 2.0)), tooth_of(form)
    assert plain.tip_land - tooth.tip_land == pytest.approx(0.4, abs=1e-12)
    assert abs(complex(tooth.upper_flank.point(1.0))) == pytest.approx(form.tip_diameter / 2 - 0.2, abs=1e-12)
    assert tooth.outline.area < plain.outline.area


def outline_gap(form: GearForm) -> float:
    """Largest distance between the end of a curve of the outline and the start of the next, in mm."""
    outline = tooth_of(form).outline
    starts = np.array([complex(curve.point(0.0)) for curve in outline.curves])
    ends = np.array([complex(curve.point(1.0)) for curve in outline.curves])
    following = np.append(starts[1:], starts[0] * np.exp(2j * pi / outline.repeats))
    return float(np.abs(ends - following).max())


def test_area_by_green_against_the_polygon_extrapolated() -> None:
    worst = 0.0
    for form in (*CUT_GEARS, gear(24, 2.0, tip_chamfer=0.2)):
        outline = tooth_of(form).outline
        areas = []
        for count in (400, 800):
            pitch = np.concatenate([c.point(np.arange(count) / count) for c in outline.curves])
            around = np.append(pitch, pitch[0] * np.exp(2j * pi / outline.repeats))
            areas.append(outline.repeats * float(np.sum((np.conj(around[:-1]) * around[1:]).imag)) / 2)
        extrapolated = (4 * areas[1] - areas[0]) / 3
        worst = max(worst, abs(extrapolated / outline.area - 1))
    print(f"area, Green against polygons: {worst:.1e} relative")
    assert worst < 1e-10


def test_flank_and_root_as_bezier_curves_keep_their_bars_for_every_number_of_teeth() -> None:
    t = np.linspace(0.0, 1.0, 333)
    worst_flank = worst_root = 0.0
    for teeth in range(12, 201):
        form = gear(teeth)
        tooth = tooth_of(form)
        poles = bezier_poles(tooth.upper_flank, 0.5e-6)
        points = bernstein(len(poles) - 1, t) @ poles
        radius = np.abs(points)
        angle = np.arccos(np.minimum(form.base_diameter / 2 / radius, 1.0))
        # Involutes of one base circle are parallel curves: an angle apart is r_b times that angle apart.
        exact = form.base_half_angle - (np.tan(angle) - angle)
        worst_flank = max(worst_flank, float(np.abs(np.angle(points) - exact).max()) * form.base_diameter / 2)
        if teeth % 9 == 3:
            poles = bezier_poles(tooth.upper_root, 5e-6)
            cut = RollingRack(form).deepest_cut(bernstein(len(poles) - 1, t[::4]) @ poles)
            worst_root = max(worst_root, float(np.abs(cut).max()))
    print(f"flank {worst_flank * 1e3:.1e} µm, root {worst_root * 1e3:.1e} µm off, z = 12 to 200, module 1 mm")
    assert worst_flank <= 1e-6
    assert worst_root <= 1e-5


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-5])
def test_chords_stay_within_their_tolerance_and_use_it(tolerance: float) -> None:
    for form in (gear(8), gear(30), gear(150, 0.5), gear(20, shift=0.8)):
        for curve in tooth_of(form).outline.curves:
            nodes = chord_parameters(curve, tolerance)
            ends = curve.point(nodes)
            share = np.linspace(0.0, 1.0, 201)[:, None]
            points = curve.point(nodes[:-1] + share * np.diff(nodes))
            chord = np.diff(ends) / np.abs(np.diff(ends))
            sag = np.abs(((points - ends[:-1]) * np.conj(chord)).imag).max()
            assert sag <= 1.01 * tolerance
            assert len(nodes) <= 6 or sag > 0.4 * tolerance


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(
    teeth=st.integers(6, 220),
    module=st.floats(0.2, 8.0),
    shift=st.floats(-0.6, 1.2),
    radius=st.floats(0.05, 0.45),
    dedendum=st.floats(1.0, 1.4),
    angle=st.floats(14.0, 27.0),
    thinning=st.floats(-0.1, 0.05),
)
def test_any_gear_is_refused_or_closed_and_cut_by_its_rack(
    teeth: int, module: float, shift: float, radius: float, dedendum: float, angle: float, thinning: float
) -> None:
    try:
        form = gear(
            teeth,
            module,
            shift,
            rack_tip_radius_factor=radius,
            dedendum_factor=dedendum,
            normal_pressure_angle=radians(angle),
            tooth_thickness_deviation=thinning * module,
        )
        tooth = tooth_of(form)
    except DesignError:
        assume(False)
    assert outline_gap(form) < 1e-9 * form.reference_diameter
    assert pi / 4 * form.root_diameter**2 < tooth.outline.area < pi / 4 * form.tip_diameter**2
    points = np.concatenate([c.point(np.linspace(0.0, 1.0, 9)) for c in (tooth.upper_root, tooth.upper_flank)])
    assert np.abs(RollingRack(form).deepest_cut(points)).max() < ROLLED_ZERO_MM * form.reference_diameter


REFUSED = {
    "3 teeth": {"teeth": 3},
    "a finite number": {"teeth": 20, "profile_shift": float("nan")},
    "normal_module = 0": {"teeth": 20, "normal_module": 0.0},
    "width = -1": {"teeth": 20, "width": -1.0},
    "pressure angle of 5": {"teeth": 20, "normal_pressure_angle": radians(5)},
    "rack_tip_radius_factor = 0;": {"teeth": 20, "rack_tip_radius_factor": 0.0},
    "tip_chamfer = -0.1": {"teeth": 20, "tip_chamfer": -0.1},
    "pointed teeth": {"teeth": 12, "profile_shift": 1.1},
    "give at most 0.471911": {"teeth": 20, "rack_tip_radius_factor": 0.5},
    "comes to a point": {"teeth": 20, "dedendum_factor": 2.2},
    "tip_chamfer = 0.5": {"teeth": 20, "tip_chamfer": 0.5},
    "undercut to a neck": {"teeth": 4, "profile_shift": -0.5},
    "no flank left": {"teeth": 20, "addendum_factor": 0.05, "profile_shift": -0.9},
    "root diameter": {"teeth": 4, "profile_shift": -0.9},
}


@pytest.mark.parametrize(("said", "numbers"), REFUSED.items(), ids=REFUSED)
def test_impossible_teeth_are_refused_in_one_sentence(said: str, numbers: dict[str, float]) -> None:
    with pytest.raises(DesignError) as refusal:
        tooth_of(GearForm(**{"normal_module": 1.0, "width": 5.0} | numbers))
    message = str(refusal.value)
    assert said in message
    assert "\n" not in message


def test_a_full_radius_typed_with_six_digits_is_a_full_radius() -> None:
    typed = gear(25, rack_tip_radius_factor=0.47191)
    tooth = tooth_of(typed)
    assert len(tooth.outline.curves) == 5
    root = tooth.upper_root.point(np.linspace(0.0, 1.0, 21))
    assert np.abs(RollingRack(typed).deepest_cut(root)).max() < 2e-6


@pytest.mark.parametrize(
    ("teeth", "given", "deviation"),
    [
        (12, {"profile_shift": 1.5}, 0.0),
        (6, {"profile_shift": -0.8}, 0.0),
        (4, {"profile_shift": -1.6}, 0.0),
        (20, {"addendum_factor": 2.2}, 0.0),
        (12, {"addendum_factor": 1.0}, -0.75),
        (20, {"profile_shift": -2.0}, 0.0),
    ],
)
def test_a_tooth_that_cannot_be_cut_names_values_that_make_one(teeth, given, deviation):
    """Each value that the refusal gives, put in, makes a tooth whose flank, land and root are there."""
    form = GearForm(
        teeth=teeth, normal_module=1.0, width=5.0, tooth_thickness_deviation=deviation, **{"profile_shift": 0.0} | given
    )
    with pytest.raises(ToothError) as refusal:
        tooth_of(form)
    named = re.findall(r"(profile_shift|addendum_factor|teeth) = (-?[\d.]+)", str(refusal.value.cure))
    assert named
    for key, value in named:
        tooth = tooth_of(replace(form, **{key: float(value)}))
        assert tooth.tip_land >= 0.05
        assert tooth.root_form_diameter < tooth.form.tip_diameter - 0.1
        assert tooth.form.root_diameter > 0
