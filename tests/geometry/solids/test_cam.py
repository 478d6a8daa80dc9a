"""The disc as a solid: volume by Green's theorem, topology, rays from the camshaft, blanks at random."""

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from OCP.BRepGProp import BRepGProp
from OCP.collections import IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher as ShapeMap
from OCP.gp import gp_Dir, gp_Lin, gp_Pnt
from OCP.GProp import GProp_GProps
from OCP.IntCurvesFace import IntCurvesFace_ShapeIntersector
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_VERTEX
from OCP.TopExp import TopExp
from scipy.integrate import quad

from cadgen.curves.closed import ClosedCurve
from cadgen.curves.contour import Contour, circle
from cadgen.curves.spline import splines
from cadgen.errors import DesignError, FileError
from cadgen.geometry.solids.disc_solid import SPLINE_TOLERANCE, cam_part
from cadgen.geometry.solids.kernel import SolidPart, closed_wire, contour_edges, is_valid, volume
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Keyway, Lightening, SetScrew

THICKNESS = 3.0
VOLUME_BAR = 1e-6  # relative
RING = Lightening(count=6, hole_diameter=18.0, circle_diameter=78.0)
KEYED = Blank(bore_diameter=8.0, key=Keyway(width=3.0, depth=1.4), lightening=RING)
FLAT_BLANKS = {
    "plain": Blank(bore_diameter=8.0),
    "keyway and holes": KEYED,
    "D-flat": Blank(bore_diameter=8.0, key=DFlat(depth=1.0, angle=0.3)),
}
SCREW = SetScrew(diameter=4.2, height=5.0, angle=pi)
HUB = Hub(diameter=20.0, length=10.0, set_screw=SCREW)
HUB_BLANKS = {
    "outer hub": replace(KEYED, hub=HUB),
    "inner hub": replace(KEYED, hub=replace(HUB, side="inner")),
    "hub without screw": replace(KEYED, hub=replace(HUB, set_screw=None)),
}


def make(profile: ClosedCurve, blank: Blank) -> SolidPart:
    return cam_part(profile, blank, THICKNESS, name="cam", description="test")


def hub_volume(blank: Blank) -> float:
    """Hub less bore, less the drill's cut through the wall where the bore is round (quadrature)."""
    hub = blank.hub
    assert hub is not None
    whole = (pi * hub.diameter**2 / 4 - blank.bore().area()) * hub.length
    if hub.set_screw is None:
        return whole
    drill, outside, inside = hub.set_screw.diameter / 2, hub.diameter / 2, blank.bore_diameter / 2

    def wall(y: float) -> float:
        return 2 * sqrt(drill**2 - y**2) * (sqrt(outside**2 - y**2) - sqrt(inside**2 - y**2))

    return whole - quad(wall, -drill, drill, epsabs=1e-12)[0]


def count(part: SolidPart, kind) -> int:
    found = ShapeMap()
    TopExp.MapShapes_s(part.solid, kind, found)
    return found.Extent()


def farthest_hits(part: SolidPart, angles: np.ndarray, z: float) -> np.ndarray:
    """Distance at which rays from the axis at height z leave the solid for good."""
    faces = IntCurvesFace_ShapeIntersector()
    faces.Load(part.solid, 1e-9)
    hits = []
    for angle in angles:
        faces.Perform(gp_Lin(gp_Pnt(0, 0, z), gp_Dir(np.cos(angle), np.sin(angle), 0)), 0.0, 1e3)
        hits.append(max(faces.WParameter(number) for number in range(1, faces.NbPnt() + 1)))
    return np.array(hits)


@pytest.mark.parametrize("name", FLAT_BLANKS)
def test_volume_is_area_times_thickness(carbon_free_car, name):
    curve, blank = carbon_free_car.actual.curve, FLAT_BLANKS[name]
    part = make(curve, blank)
    error = volume(part.solid) / blank.disc_volume(curve.area(), THICKNESS) - 1
    print(f"\n{name}: volume off by {error:.1e}")
    assert is_valid(part.solid)
    assert abs(error) <= VOLUME_BAR


def test_the_kernel_integrates_well_only_by_the_adaptive_rule(carbon_free_car):
    curve, blank = carbon_free_car.actual.curve, FLAT_BLANKS["plain"]
    solid, exact = make(curve, blank).solid, blank.disc_volume(curve.area(), THICKNESS)
    errors = {}
    for label, integrate in {
        "default": lambda into: BRepGProp.VolumeProperties_s(solid, into),
        "Gauss, 1e-6": lambda into: BRepGProp.VolumeProperties_s(solid, into, 1e-6),
        "Gauss, 1e-9": lambda into: BRepGProp.VolumeProperties_s(solid, into, 1e-9),
        "Gauss-Kronrod, 1e-6": lambda into: BRepGProp.VolumePropertiesGK_s(solid, into, 1e-6),
        "Gauss-Kronrod, 1e-9": lambda into: BRepGProp.VolumePropertiesGK_s(solid, into, 1e-9),
    }.items():
        properties = GProp_GProps()
        integrate(properties)
        errors[label] = abs(properties.Mass() / exact - 1)
        print(f"\n{label}: {errors[label]:.1e}", end="")
    assert min(errors, key=errors.get).startswith("Gauss-Kronrod")
    assert abs(volume(solid) / exact - 1) <= VOLUME_BAR


@pytest.mark.parametrize("name", HUB_BLANKS)
def test_volume_with_hub(carbon_free_car, name):
    curve, blank = carbon_free_car.actual.curve, HUB_BLANKS[name]
    part = make(curve, blank)
    error = volume(part.solid) / (blank.disc_volume(curve.area(), THICKNESS) + hub_volume(blank)) - 1
    print(f"\n{name}: volume off by {error:.1e}")
    assert is_valid(part.solid)
    assert abs(error) <= VOLUME_BAR


def test_one_prism_with_shared_vertices(carbon_free_car):
    """Of n edges around: n vertices and n edges on either face, n edges between, n walls and two faces."""
    curve = carbon_free_car.actual.curve
    part = make(curve, KEYED)
    around = len(splines(curve, SPLINE_TOLERANCE, 5)) + len(KEYED.bore().bulges) + RING.count
    counts = [count(part, kind) for kind in (TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE)]
    assert counts == [2 * around, 3 * around, around + 2]


@pytest.mark.slow
@pytest.mark.parametrize("blank", [KEYED, HUB_BLANKS["outer hub"]], ids=["disc", "hub"])
def test_rays_from_the_camshaft_meet_the_profile(carbon_free_car, blank):
    angles = np.radians(np.arange(0, 360, 0.1))
    curve = carbon_free_car.actual.curve
    hits = farthest_hits(make(curve, blank), angles, THICKNESS / 2)
    error = np.abs(hits - curve.radius(angles)).max()
    print(f"\n3600 rays, B-rep: {error * 1e3:.4f} um")
    # Along the ray the spline's error grows by 1 / cos of the angle between ray and normal, under 1.5 here.
    assert error <= 1.5 * SPLINE_TOLERANCE


@pytest.mark.slow
def test_a_profile_with_corners(appendix_car):
    curve = appendix_car.actual.curve
    part = make(curve, KEYED)
    angles = np.radians(np.arange(0, 360, 0.1))
    error = np.abs(farthest_hits(part, angles, THICKNESS / 2) - curve.radius(angles)).max()
    off = volume(part.solid) / KEYED.disc_volume(curve.area(), THICKNESS) - 1
    print(f"\nappendix car: {error * 1e3:.4f} um along rays, volume off by {off:.1e}")
    assert is_valid(part.solid)
    assert abs(off) <= VOLUME_BAR
    assert error <= 1.5 * SPLINE_TOLERANCE


def test_build123d_sees_the_same_part(carbon_free_car):
    curve = carbon_free_car.actual.curve
    part = cam_part(curve, KEYED, THICKNESS, name="steering cam", description="test")
    solid = part.build123d()
    assert solid.label == "steering cam"
    assert tuple(solid.color)[:3] == pytest.approx(part.colour, abs=1e-6)
    assert solid.is_valid
    heights = [vertex.Z for vertex in solid.vertices()]
    assert min(heights) == pytest.approx(0.0, abs=1e-9)
    assert max(heights) == pytest.approx(THICKNESS, abs=1e-9)


@st.composite
def blanks(draw) -> Blank:
    """Blanks that fit an eccentric circle whose rim is never nearer than 34 mm."""
    bore = draw(st.floats(4, 12))
    angle = draw(st.floats(-pi, pi))
    keyway, flat = (
        Keyway(width=0.3 * bore, depth=0.2 * bore, angle=angle),
        DFlat(depth=0.1 * bore, angle=angle),
    )
    key = draw(st.sampled_from([None, keyway, flat]))
    core = 0.75 * bore
    hub = None
    if draw(st.booleans()):
        hub_radius, length = core + draw(st.floats(0.5, 5)), draw(st.floats(3, 15))
        core = hub_radius
        # Opposite the key, where the bore is round.
        screw = SetScrew(diameter=min(0.4 * bore, 0.6 * length), height=length / 2, angle=angle + pi)
        hub = Hub(
            diameter=2 * hub_radius,
            length=length,
            side=draw(st.sampled_from(["outer", "inner"])),
            set_screw=draw(st.sampled_from([None, screw])),
        )
    hole = draw(st.floats(1, (33 - core) / 2 - 0.5))
    ring = draw(st.floats(core + hole + 0.3, 33 - hole))
    most = int(pi / np.arcsin((hole + 0.2) / ring))
    lightening = Lightening(
        count=draw(st.integers(1, min(most, 12))),
        hole_diameter=2 * hole,
        circle_diameter=2 * ring,
        start_angle=draw(st.floats(-pi, pi)),
    )
    holes = draw(st.sampled_from([None, lightening]))
    return Blank(bore_diameter=bore, key=key, hub=hub, lightening=holes)


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(blanks())
def test_any_blank_that_fits_gives_its_volume(blank):
    profile = circle((4.0, 4.0), 40.0).curve()
    part = make(profile, blank)
    exact = blank.disc_volume(pi * 40.0**2, THICKNESS) + (hub_volume(blank) if blank.hub else 0.0)
    assert min(wall.thickness for wall in blank.walls(profile.outline(0.1))) > 0
    assert volume(part.solid) == pytest.approx(exact, rel=VOLUME_BAR)


SCREWED = replace(HUB, set_screw=replace(SCREW, angle=0.7))


@pytest.mark.parametrize(
    "blank",
    [
        *HUB_BLANKS.values(),
        Blank(bore_diameter=8.0, hub=replace(HUB, side="inner")),
        Blank(bore_diameter=8.0, key=Keyway(width=3.0, depth=1.4, angle=0.7), hub=SCREWED),
        Blank(bore_diameter=8.0, key=Keyway(width=3.0, depth=1.4, angle=0.4), hub=SCREWED),
        Blank(bore_diameter=8.0, key=DFlat(depth=1.0, angle=0.7), hub=SCREWED),
    ],
    ids=[*HUB_BLANKS, "plain", "screw on the key", "screw beside the key", "screw on the flat"],
)
def test_the_volume_of_a_hub_is_the_kernels(blank):
    profile, blank = circle((4.0, 4.0), 40.0).curve(), replace(blank, lightening=None)
    hub = volume(make(profile, blank).solid) - blank.disc_volume(pi * 40.0**2, THICKNESS)
    print(f"hub {hub:.2f} mm3, off by {blank.hub_volume() / hub - 1:.1e}")
    assert blank.hub_volume() == pytest.approx(hub, rel=2e-6)


def test_walls_against_closed_forms():
    """Eccentric rim of radius 40, 5 off the axis: the nearest rim is at polar angle pi, 35 mm off."""
    blank = Blank(
        bore_diameter=8.0,
        key=Keyway(width=3.0, depth=1.5, angle=pi / 2),
        hub=Hub(diameter=20.0, length=5.0, set_screw=SetScrew(diameter=2.5, height=2.25, angle=pi / 2)),
        lightening=Lightening(count=2, hole_diameter=10.0, circle_diameter=50.0, start_angle=pi),
    )
    walls = {wall.between: wall for wall in blank.walls(circle((5.0, 0.0), 40.0).outline(0.01))}
    expected = {
        "bore and profile": 31.0,
        "hub and profile": 25.0,
        "bore and hub": 10 - np.hypot(5.5, 1.5),
        "set screw and disc": 1.0,
        "set screw and the hub's end": 1.5,
        "lightening hole 1 and profile": 5.0,
        "lightening hole 1 and hub": 10.0,
        "two lightening holes": 40.0,
    }
    assert {name: wall.thickness for name, wall in walls.items()} == pytest.approx(expected, abs=1e-4)
    assert walls["lightening hole 1 and profile"].place == pytest.approx([-35.0, 0.0], abs=0.02)
    assert walls["set screw and disc"].place == pytest.approx([0.0, 10.0])
    corner = np.array([1.5, 5.5])  # of the keyway's floor, on either side
    assert np.abs(walls["bore and hub"].place) == pytest.approx(10 * corner / np.hypot(*corner), abs=0.05)


@pytest.mark.parametrize(
    ("blank", "what"),
    [
        (
            replace(KEYED, lightening=replace(RING, count=1, circle_diameter=20.0)),
            "lightening hole . and bore",
        ),
        (replace(KEYED, lightening=replace(RING, circle_diameter=125.0)), "lightening hole . and profile"),
        (replace(KEYED, lightening=replace(RING, circle_diameter=300.0)), "lightening hole . and profile"),
        (replace(KEYED, lightening=replace(RING, count=14)), "two lightening holes"),
        (replace(KEYED, hub=replace(HUB, diameter=64.0)), "lightening hole . and hub"),
        (replace(KEYED, hub=replace(HUB, diameter=9.0)), "bore and hub"),
        (replace(KEYED, lightening=None, hub=replace(HUB, diameter=125.0)), "hub and profile"),
        (Blank(bore_diameter=140.0), "bore and profile"),
    ],
)
def test_what_does_not_fit_is_refused(carbon_free_car, blank, what):
    with pytest.raises(DesignError, match=f"{what} overlap by .* mm at .*: make one of them smaller"):
        make(carbon_free_car.actual.curve, blank)


def test_an_open_outline_is_refused():
    square = Contour(np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]]), np.zeros(4))
    edges = contour_edges(square, 0.0)
    with pytest.raises(FileError, match="open by 1 mm at"):
        closed_wire(edges[:1] + edges[2:])
