"""A disc with broken edges as a solid and as STEP: its volume in closed form, and its land read from the file."""

import re
from math import pi

import numpy as np
import pytest

from cadgen.curves.chamfer import chamfered_off
from cadgen.curves.contour import Contour, circle
from cadgen.errors import CheckError, FileError
from cadgen.geometry.solids.disc_solid import cam_part
from cadgen.geometry.solids.kernel import is_valid, solids, volume
from cadgen.geometry.solids.step import read_step, step_bytes
from cadgen.geometry.solids.step_text import read_rim
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub, Keyway, Lightening, SetScrew

THICKNESS = 3.0
KEYED = Blank(
    bore_diameter=8.0,
    key=Keyway(width=3.0, depth=1.4),
    lightening=Lightening(count=6, hole_diameter=18.0, circle_diameter=78.0),
    edge_break=0.5,
)


def polygon(corners):
    return Contour(np.array(corners, dtype=float), np.zeros(len(corners))).curve()


def cone(leg, radius=30.0):
    """Frustum of a cone below one face."""
    return pi * leg * (radius**2 + radius * (radius - leg) + (radius - leg) ** 2) / 3


def pyramid(leg, side=20.0):
    small = side - 2 * leg
    return leg * (side**2 + side * small + small**2) / 3


SQUARE = [[-10, -10], [10, -10], [10, 10], [-10, 10]]
HOOK = [[-10, -10], [10, -10], [10, 2], [3, 2], [3, 10], [-10, 10]]
CUT_CORNER = [[-10, -10], [10, -10], [10, 9.8], [9.8, 10], [-10, 10]]


@pytest.mark.parametrize(
    ("curve", "frustum"),
    [(circle((0.0, 0.0), 30.0).curve(), cone), (polygon(SQUARE), pyramid)],
    ids=["circle", "square"],
)
def test_volume_in_closed_form(curve, frustum):
    blank = Blank(bore_diameter=4.0, edge_break=0.5)
    part = cam_part(curve, blank, THICKNESS, name="disc", description="test")
    exact = curve.area() * (THICKNESS - 1.0) + 2 * frustum(0.5) - pi * 4.0 * THICKNESS
    assert volume(part.solid) == pytest.approx(exact, rel=3e-7)


@pytest.mark.parametrize("corners", [HOOK, CUT_CORNER], ids=["hollow corner", "swallowed piece"])
def test_faces_that_come_to_a_point_survive_the_file(corners, tmp_path):
    curve = polygon(corners)
    blank = Blank(bore_diameter=2.0, edge_break=0.5)
    part = cam_part(curve, blank, THICKNESS, name="disc", description="test")
    assert is_valid(part.solid)
    (tmp_path / "disc.step").write_bytes(step_bytes(part))
    content = read_step(tmp_path / "disc.step", 0.1, blank.carrying(0.0, THICKNESS))
    assert content.valid
    assert content.bodies == 1
    assert content.volume == pytest.approx(volume(part.solid), rel=1e-9)
    exact = blank.disc_volume(curve.area(), THICKNESS) - 2 * chamfered_off(curve, 0.5)
    # Steiner's formula does not know that the cut corner is swallowed at 0.24 mm.
    assert content.volume == pytest.approx(exact, rel=1e-8 if corners is HOOK else 2e-6)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["carbon_free_car", "appendix_car"])
def test_a_cam_with_broken_edges(name, request, tmp_path):
    curve = request.getfixturevalue(name).actual.curve
    part = cam_part(curve, KEYED, THICKNESS, name="cam", description="test")
    file = tmp_path / "cam.step"
    file.write_bytes(step_bytes(part))
    assert step_bytes(cam_part(curve, KEYED, THICKNESS, name="cam", description="test")) == file.read_bytes()
    content = read_step(file, 0.1, (0.5, 2.5))
    exact = KEYED.disc_volume(curve.area(), THICKNESS) - 2 * chamfered_off(curve, 0.5)
    print(f"{name}: {file.stat().st_size} bytes, volume within {content.volume / exact - 1:.1e}")
    assert content.valid
    assert content.volume == pytest.approx(exact, rel=2e-8)
    off = np.linalg.norm(content.rim.points, axis=1) - curve.radius(content.rim.angle)
    assert np.abs(off).max() < 2e-5
    # The outline at the faces lies inside, by the leg over the cosine of the pressure angle or more.
    on_face = read_rim(file, 0.1)
    inside = curve.radius(on_face.angle) - np.linalg.norm(on_face.points, axis=1)
    assert inside.min() > 0.5 * (1 - 1e-3)
    # A land that leans, and one that is somewhere else.
    text = file.read_text()
    poles = re.findall(r"B_SPLINE_CURVE_WITH_KNOTS\('',5,\(([^)]*)\)", text)
    inner_poles = [re.findall(r"#(\d+)", numbers)[2] for numbers in poles]
    places = (re.search(rf"#{pole} = CARTESIAN_POINT\('',\(([^,]+),[^,]+,2\.5\)\);", text) for pole in inner_poles)
    found = next(place for place in places if place)
    file.write_text(text.replace(found[0], found[0].replace(found[1], f"{float(found[1]) + 0.001:.12f}")))
    with pytest.raises(FileError, match="is not upright"):
        read_step(file, 0.1, (0.5, 2.5))
    with pytest.raises(FileError, match=r"0 closed rims of B-splines at z = 0\.4"):
        read_step(file, 0.1, (0.4, 2.6))


@pytest.mark.slow
@pytest.mark.parametrize("side", ["outer", "inner"])
def test_with_a_hub(carbon_free_car, side):
    curve = carbon_free_car.actual.curve
    hub = Hub(diameter=20.0, length=8.0, side=side, set_screw=SetScrew(diameter=3.0, height=4.0))
    eased, sharp = (
        cam_part(
            curve, Blank(bore_diameter=8.0, hub=hub, edge_break=leg), THICKNESS, name="cam", description="test"
        ).solid
        for leg in (0.2, 0.0)
    )
    assert len(solids(eased)) == 1
    assert volume(sharp) - volume(eased) == pytest.approx(2 * chamfered_off(curve, 0.2), rel=1e-4)


def test_a_leg_beyond_the_sharpest_ridge_is_refused():
    blank = Blank(bore_diameter=2.0, edge_break=1.0)
    lens = Contour(np.array([[-10.0, -0.9], [10.0, -0.9], [10.0, 0.9], [-10.0, 0.9]]), np.array([0.4, 1.0, 0.4, 1.0]))
    with pytest.raises(CheckError, match=r"blank\.edge_break_mm is 1, but the outline is convex"):
        cam_part(lens.curve(), blank, THICKNESS, name="cam", description="test")
