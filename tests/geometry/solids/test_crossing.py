"""A set screw's edges: on both their surfaces, in the part and in its file, and the volume by quadrature."""

from math import asin, pi, sqrt

import numpy as np
import pytest
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from scipy.integrate import quad

from cadgen.car.assembly.car_parts import Block, Drilled, KeySlot, Prism
from cadgen.curves.contour import circle
from cadgen.gears.tooth import GearForm
from cadgen.gears.wheel_body import gear_body
from cadgen.geometry.meshes.car_meshes import shape_mesh
from cadgen.geometry.solids.car_solids import shape_solid
from cadgen.geometry.solids.disc_solid import cam_part
from cadgen.geometry.solids.gear_solids import body_solid
from cadgen.geometry.solids.kernel import SolidPart, edges_on_surfaces, is_valid, solids, volume
from cadgen.geometry.solids.step import completed, read_document, step_bytes
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Keyway, SetScrew

CASES = {
    "plain": ({}, 20.0, 10.0, "outer", 3.3, 0.7),
    "on the seam": ({}, 30.0, 12.0, "inner", 6.0, 0.0),
    "nearly as wide as the bore": ({}, 24.0, 10.0, "outer", 7.9, 2.0),
    "through a keyway's corner": ({"key": Keyway(width=3.0, depth=1.4, angle=0.6)}, 30.0, 10.0, "outer", 5.0, 0.9),
    "slantwise through a flat": ({"key": DFlat(depth=1.2, angle=0.6)}, 22.0, 8.0, "inner", 3.0, 0.9),
}


def drilled(outside: float, inside: float, drill: float) -> float:
    """Volume of a round hole through a round wall."""

    def wall(y: float) -> float:
        return 2 * sqrt(drill**2 - y**2) * (sqrt(outside**2 - y**2) - sqrt(inside**2 - y**2))

    return quad(wall, -drill, drill, epsabs=1e-12)[0]


def read_again(part: SolidPart, path):
    path.write_bytes(step_bytes(part))
    document, _ = read_document(path)
    from OCP.collections import Sequence_TDF_Label
    from OCP.XCAFDoc import XCAFDoc_DocumentTool

    labels = Sequence_TDF_Label()
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    shapes.GetFreeShapes(labels)
    return completed(shapes.GetShape_s(labels.First()))


def by_gauss(shape) -> float:
    """Volume by the kernel's plain rule, which other programs use."""
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    return properties.Mass()


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_the_screw_of_a_cams_hub(name, tmp_path):
    key, diameter, length, side, hole, angle = CASES[name]
    screw = SetScrew(diameter=hole, height=length / 2, angle=angle)
    blank = Blank(bore_diameter=8.0, hub=Hub(diameter=diameter, length=length, side=side, set_screw=screw), **key)
    part = cam_part(circle((0, 0), 40.0).curve(), blank, 3.0, name="cam", description="test")
    again = read_again(part, tmp_path / "cam.step")
    assert edges_on_surfaces(part.solid)
    assert is_valid(again)
    assert edges_on_surfaces(again)
    exact = volume(part.solid)
    if not key:
        exact = pi * (40.0**2 - 16) * 3.0 + pi * (diameter**2 / 4 - 16) * length - drilled(diameter / 2, 4.0, hole / 2)
    print(f"{name}: volume {volume(again) / exact - 1:+.1e}, by the plain rule {by_gauss(again) / exact - 1:+.1e}")
    assert volume(again) == pytest.approx(exact, rel=2e-7)
    assert by_gauss(again) == pytest.approx(exact, rel=1e-6)
    assert len(solids(again)) == 1


@pytest.mark.slow
def test_the_screw_of_a_gears_hub(tmp_path):
    blank = Blank(bore_diameter=8.0, hub=Hub(diameter=16.0, length=6.0, set_screw=SetScrew(diameter=3.0, height=3.0)))
    body = gear_body(GearForm(teeth=30, normal_module=1.0, width=6.0), blank)
    part = SolidPart(solid=body_solid(body), name="gear", description="test", colour=(0.5, 0.5, 0.5))
    again = read_again(part, tmp_path / "gear.step")
    exact = body.prismatic_volume - drilled(8.0, 4.0, 1.5)
    assert edges_on_surfaces(again)
    assert volume(again) == pytest.approx(exact, rel=1e-7)


def test_a_hole_through_a_shaft_is_read_back(tmp_path):
    """Hole of 1.5 mm for a string across an axle of 5 mm; its volume by quadrature."""
    axle = Block(
        (Prism(circle((0.0, 0.0), 2.5), -10.0, 10.0),),
        drilled=(Drilled((0.0, -2.5, 0.0), (0.0, 1.0, 0.0), 1.5, 5.0, 1.5),),
    )
    solid = shape_solid(axle, "axle")
    again = read_again(
        SolidPart(solid=solid, name="axle", description="", colour=(0.5, 0.5, 0.5)), tmp_path / "axle.step"
    )
    assert is_valid(again)
    assert edges_on_surfaces(solids(again)[0])
    hole = quad(lambda y: 4 * sqrt((0.75**2 - y**2) * (2.5**2 - y**2)), -0.75, 0.75, epsabs=1e-12)[0]
    assert volume(again) == pytest.approx(pi * 2.5**2 * 20 - hole, rel=1e-9)


@pytest.mark.parametrize(("ends", "rounded"), [((3.0, 13.0), (True, True)), ((13.0, 20.0), (True, False))])
def test_the_seat_of_a_key_is_read_back(ends, rounded, tmp_path):
    """Seat of a key 3 x 3 in a shaft of 8 mm, closed or open at the shaft's end; its sections integrated along it."""
    radius, half, floor = 4.0, 1.5, 2.2
    seat = KeySlot(*ends, 2 * half, floor, radius, 0.7, rounded)
    shaft = Block((Prism(circle((0.0, 0.0), radius), 0.0, 20.0),), (seat,))
    solid = shape_solid(shaft, "shaft")
    again = read_again(
        SolidPart(solid=solid, name="shaft", description="", colour=(0.5, 0.5, 0.5)), tmp_path / "shaft.step"
    )

    def section(wide):
        return wide * sqrt(radius**2 - wide**2) + radius**2 * asin(wide / radius) - 2 * wide * floor

    end = quad(lambda z: section(sqrt(half**2 - z**2)), 0.0, half, epsabs=1e-12)[0]
    taken = section(half) * (ends[1] - ends[0] - half * sum(rounded)) + end * sum(rounded)
    assert is_valid(again)
    assert edges_on_surfaces(solids(again)[0])
    assert volume(again) == pytest.approx(pi * radius**2 * 20 - taken, rel=1e-9)
    assert seat.content().volume == pytest.approx(taken, rel=1e-12)
    # The centre, of the mesh.
    mesh = shape_mesh(shaft, 1e-4)
    corners = mesh.vertices[mesh.triangles]
    sizes = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert sizes @ corners.sum(axis=1) / 4 / sizes.sum() == pytest.approx(shaft.content().centre, abs=1e-4)
