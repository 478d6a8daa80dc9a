"""Racks: the trial of another program, play on polygons, and files read back by the bare kernel."""

from collections.abc import Sequence
from dataclasses import replace
from math import cos, pi, radians, tan
from pathlib import Path

import manifold3d
import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.TopAbs import TopAbs_VERTEX
from OCP.TopoDS import TopoDS

from cadgen import Gear, Rack
from cadgen.design import gear_model
from cadgen.design.load import train_of
from cadgen.errors import DesignError
from cadgen.gears.rack import RackForm, RackMesh
from cadgen.gears.rack_stage import RackStage
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


@pytest.mark.slow
@pytest.mark.parametrize(("teeth", "shift"), [(20, 0.0), (40, 0.3), (17, 0.5)])
def test_pitches_that_are_off_take_no_more_from_the_play_than_is_reckoned(teeth: int, shift: float) -> None:
    """Teeth of the rack are moved apart by so much a pitch, and the rack is pushed to either side until it meets."""
    pinion = GearForm(teeth=teeth, normal_module=1.0, width=8.0, profile_shift=shift, tooth_thickness_deviation=-0.05)
    rack = RackForm(teeth=9, normal_module=1.0, width=8.0, tooth_thickness_deviation=-0.05)
    mesh = RackMesh(pinion=pinion, rack=rack, distance=pinion.reference_diameter / 2 + shift)
    nominal, off, corners = mesh.backlash.pitch, 0.01, section_of(pinion, 1e-6).corners.ravel()

    def play(turned: float, offs: Sequence[float]) -> float:
        bars = [
            np.array([[each.real + moved, each.imag] for each in tooth[1:5]])
            for tooth, moved in zip(rack.corners(), offs, strict=True)
        ]
        placed = corners * np.exp(1j * (turned - pi / 2)) + 1j * mesh.distance
        one = manifold3d.CrossSection([np.column_stack([placed.real, placed.imag])])
        along = -4 * rack.pitch + turned * pinion.reference_diameter / 2
        ends = []
        for side in (1.0, -1.0):
            free, blocked = -nominal / 2, nominal
            while blocked - free > 2e-5:
                middle = (free + blocked) / 2
                moved = [bar[::-1] + np.array([along + side * middle, 0.0]) for bar in bars]
                met = (one ^ manifold3d.CrossSection(moved)).area() > 1e-8
                free, blocked = (free, middle) if met else (middle, blocked)
            ends.append(free)
        return sum(ends)

    # A tooth of the pinion points at a space between teeth 4 and 5; over a pitch others touch.
    turns = np.linspace(-0.5, 0.5, 17) * rack.pitch / (pinion.reference_diameter / 2)
    found = [play(turned, off * (np.arange(9) - 4.0) * way) for turned in turns.tolist() for way in (1.0, -1.0)]
    closes, opens = mesh.pitches_touched
    print(f"{closes} close, {opens} open: {nominal:.4f} mm becomes {min(found):.4f} to {max(found):.4f}")
    assert min(found) == pytest.approx(nominal - closes * off, abs=3e-4)
    assert nominal - 3e-4 < max(found) < nominal + opens * off + 3e-4
    assert play(0.0, [0.0] * 9) == pytest.approx(nominal, abs=3e-4)


@pytest.mark.parametrize(("grade", "expected"), [(7, 10.0), (10, 28.0)])
def test_the_pitch_of_a_rack_is_in_its_play(grade: int, expected: float) -> None:
    """f_pt as ISO 1328-1 prints it over 20 up to 50 mm and a module of 0.5 to 2, for a gear of as many teeth."""
    design = (
        "[train]\nmodule_mm = 1.0\nwidth_mm = 8.0\nbearing_span_mm = 60.0\n[[train.stages]]\nkind = 'rack'\n"
        "distance_mm = 10.1\ndriver = {{ teeth = 20, E_sn_um = -50.0 }}\n"
        "rack = {{ teeth = 30, E_sn_um = -50.0, grade = {grade} }}\n"
    )
    (stage,) = gear_model.train(train_of(design.format(grade=grade), Path("rack.toml"))).stages
    assert isinstance(stage, RackStage)
    without = replace(stage, rack_grade=None)
    radius, (closes, opens) = stage.driven_pitch_radius * 1e3, stage.mesh.pitches_touched
    assert closes > 0
    assert (without.play().B_min - stage.play().B_min) * radius == pytest.approx(closes * expected)
    assert (stage.play().B_max - without.play().B_max) * radius == pytest.approx(opens * expected)


def test_a_rack_from_numbers_states_the_limits_of_its_grade() -> None:
    """ISO 1328-1, grade 7, over 20 up to 50 mm, a module of 0.5 to 2 and a face of 4 to 10 mm: 10, 29, 10 and 13 µm."""
    rack = Rack(teeth=30, module=1, width=8, grade=7)
    facts = rack.entry().json()
    limits = [facts[f"{symbol}_um"] for symbol in ("f_pt", "F_p", "F_alpha", "F_beta")]
    assert limits == pytest.approx([10.0, 29.0, 10.0, 13.0], rel=0.05)
    assert "f_pt_um" not in Rack(teeth=30, module=1, width=8).entry().json()
    with pytest.raises(DesignError, match="grade is 2"):
        Rack(teeth=30, module=1, width=8, grade=2)
