"""Racks: the trial of another program, play on polygons, and files read back by the bare kernel."""

from dataclasses import replace
from math import cos, pi, radians, tan

import manifold3d
import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.TopAbs import TopAbs_VERTEX
from OCP.TopoDS import TopoDS

from cadgen import Gear, Rack
from cadgen.errors import DesignError
from cadgen.gears.rack import RackForm, RackMesh
from cadgen.gears.tooth import GearForm
from cadgen.geometry.meshes.teeth import section_of
from cadgen.geometry.solids.gear_solids import body_solid
from cadgen.geometry.solids.kernel import edges_on_surfaces, fits, is_valid, volume
from tests.gears.test_internal import trial
from tests.geometry.solids.test_helical_wall import parts, read


@pytest.fixture(scope="module")
def said():
    return trial("15_rack")


@pytest.fixture(scope="module")
def mesh(said):
    one, two = said["design"]["gear1"], said["design"]["rack"]
    return RackMesh(
        pinion=GearForm(
            teeth=one["z"],
            normal_module=one["mn"],
            width=one["b"],
            profile_shift=one["x"],
            tooth_thickness_deviation=one["E_sn"],
            helix_angle=radians(one["beta_deg"]),
        ),
        rack=RackForm(
            teeth=two["teeth"],
            normal_module=two["mn"],
            width=one["b"],
            helix_angle=radians(two["beta_deg"]),
            tooth_thickness_deviation=two["E_sn"],
        ),
        distance=said["design"]["h"],
    )


def test_play_contact_and_travel_are_those_of_another_program(said, mesh):
    wanted, play = said["expected"]["rack"], mesh.backlash
    ours = {
        "j_t": play.pitch,
        "j_bt": play.base,
        "j_bn": play.normal,
        "phi": play.driver_angle,
        "eps_alpha": mesh.contact_ratio,
        "travel_per_turn": mesh.travel,
    }
    assert ours == pytest.approx(wanted, abs=6e-7)
    assert mesh.rack.pitch == pytest.approx(said["expected"]["rack_tooth_pitch_transverse"], abs=6e-7)
    thickness = mesh.rack.pitch * cos(mesh.rack.helix_angle) / 2 + mesh.rack.tooth_thickness_deviation
    assert thickness == pytest.approx(said["expected"]["rack_tooth_thickness_normal_at_reference"], abs=6e-7)


def test_play_of_the_polygons_is_that_of_the_formula(mesh):
    """The rack is pushed to one side and to the other until it meets the pinion."""
    corners = mesh.rack.outline.polygon(1e-6)
    points = np.column_stack([corners.real, corners.imag])
    corners = section_of(mesh.pinion, 1e-6).corners.ravel()
    pitch = mesh.rack.pitch
    for turned in (0.0, 0.07):
        # A tooth of the pinion points at a space of the rack, and the rack goes along as the pinion turns.
        pinion = corners * np.exp(1j * (turned - pi / 2)) + 1j * mesh.distance
        one = manifold3d.CrossSection([np.column_stack([pinion.real, pinion.imag])])
        along = -15 * pitch + turned * mesh.pinion.reference_diameter / 2

        def overlap(more, one=one, along=along):
            return (one ^ manifold3d.CrossSection([points + np.array([along + more, 0.0])])).area()

        ends = []
        for side in (1, -1):
            free, blocked = 0.0, pitch / 4
            assert overlap(0.0) < 1e-8 < overlap(side * blocked)
            while blocked - free > 1e-6:
                middle = (free + blocked) / 2
                free, blocked = (middle, blocked) if overlap(side * middle) < 1e-8 else (free, middle)
            ends.append(free)
        assert sum(ends) == pytest.approx(mesh.backlash.pitch, abs=1e-4)


@pytest.mark.parametrize("helix", [0.0, 10.0, -35.0])
def test_a_rack_in_the_file_has_its_corners_and_its_volume(helix, tmp_path):
    form = RackForm(teeth=7, normal_module=2.0, width=12.0, helix_angle=radians(helix), tooth_thickness_deviation=-0.04)
    corners = form.outline.polygon(1e-8)
    x, y = corners.real, corners.imag
    assert form.area == pytest.approx(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y), rel=1e-7)
    solid = body_solid(form.body)
    assert is_valid(solid)
    assert fits(solid)
    assert edges_on_surfaces(solid)
    assert volume(solid) == pytest.approx(form.area * form.width, rel=5e-9)
    shape = read(solid, tmp_path / "rack.step")
    found = {
        (round(p.X(), 7), round(p.Y(), 7), round(p.Z(), 7))
        for p in (BRep_Tool.Pnt_s(TopoDS.Vertex(vertex)) for vertex in parts(shape, TopAbs_VERTEX))
    }
    # Seen from the pinion's side, where -x is to the right, right-hand teeth lean to the right as z grows.
    for corner in (each for tooth in form.corners() for each in tooth):
        for height in (0.0, form.width):
            place = np.array([corner.real - height * tan(radians(helix)), corner.imag, height])
            assert min(np.abs(np.array(each) - place).max() for each in found) < 2e-7


def test_a_rack_from_numbers(tmp_path):
    rack = Rack(teeth=10, module=1, width=6, helix_angle=radians(15))
    written = rack.write(tmp_path)
    assert {file.name for file in written} >= {"rack.step", "rack.stl"}
    assert rack.build123d().volume == pytest.approx(rack.volume, rel=5e-9)
    pinion = Gear(teeth=20, module=1, width=6, helix_angle=radians(15), hand="left")
    tight = pinion.reference_diameter / 2
    assert rack.meshed(pinion, tight).backlash.pitch == pytest.approx(0.0, abs=1e-12)


def test_what_cannot_be_is_refused_with_a_value_that_can(mesh):
    with pytest.raises(DesignError, match=r"jam at a distance_mm of 19; give at least ([\d.]+)") as refused:
        replace(mesh, distance=19.0)
    assert replace(mesh, distance=float(str(refused.value).split("at least ")[1])).backlash.pitch >= 0
    with pytest.raises(DesignError, match="do not meet at a distance_mm of 30"):
        replace(mesh, distance=30.0)
    with pytest.raises(DesignError, match='give the rack 10° and hand = "right"'):
        replace(mesh, rack=replace(mesh.rack, helix_angle=radians(-10)))
    with pytest.raises(DesignError, match=r"at most ([\d.]+)") as refused:
        RackForm(teeth=5, normal_module=1.0, width=5.0, fillet_factor=0.6)
    largest = float(str(refused.value).split("at most ")[1])
    assert RackForm(teeth=5, normal_module=1.0, width=5.0, fillet_factor=largest).area > 0
    with pytest.raises(DesignError, match="height_mm of at least"):
        RackForm(teeth=5, normal_module=1.0, width=5.0, height=1.0)


def test_a_pinion_without_room_for_its_bore_is_refused_on_a_rack():
    """A root of 9.5 mm holds no bore of 20."""
    pinion = Gear(teeth=12, module=1.0, width=8.0, bore=20.0)
    with pytest.raises(DesignError, match="bore"):
        Rack(teeth=20, module=1.0, width=8.0).meshed(pinion, 6.0)
