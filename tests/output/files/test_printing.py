"""Files for printing: sections by elementary geometry, the way back to the part, and files that lack a compensation."""

from math import cos, pi, radians, tan

import numpy as np
import pytest
from manifold3d import CrossSection

import cadgen.geometry.meshes.printing as printing_room
from cadgen import Design, Flats, Gear, GearPair, Hub, Keyway, Lightening, PrintCompensation, Rack, SetScrew, draw
from cadgen.errors import DesignError, FileError
from cadgen.output.files.stl import read_stl

ALL = PrintCompensation(hole=0.2, chords=True, foot=0.15, foot_height=0.25, shrinkage=0.005, shrinkage_z=0.003)
FULL = Gear(
    teeth=60,
    module=1,
    width=8,
    bore=8,
    keyway=Keyway(width=2, depth=1),
    hub=Hub(diameter=20, length=8, set_screw=SetScrew(diameter=3, height=4)),
    lightening=Lightening(count=6, hole_diameter=8),
)


def section(path, height):
    """Section of a file at a height, as polygons, outermost first."""
    polygons = read_stl(path).solid().slice(height).to_polygons()
    return sorted(polygons, key=lambda each: -np.linalg.norm(each, axis=1).max())


def area(polygon):
    x, y = np.asarray(polygon).T
    return float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) / 2


def test_a_bore_is_larger_by_hole_and_chord_and_all_by_the_shrinkage(tmp_path):
    gear = Gear(teeth=20, module=1, width=8, bore=5)
    only = PrintCompensation(hole=0.3, chords=True, shrinkage=0.01, shrinkage_z=0.02)
    (file,) = gear.write(tmp_path, "stl", printing=only)
    outer, bore = section(file.path, 4.0)
    sides = np.roll(bore, -1, axis=0) - bore
    off = np.abs(bore[:, 0] * sides[:, 1] - bore[:, 1] * sides[:, 0]) / np.linalg.norm(sides, axis=1)
    assert off.min() == pytest.approx(2.65 / 0.99, abs=1e-5)  # a pin of 5.3 mm passes the chords
    assert np.linalg.norm(outer, axis=1).max() == pytest.approx(11 / 0.99, abs=1e-5)
    assert read_stl(file.path).vertices[:, 2].max() == pytest.approx(8 / 0.98, abs=1e-5)
    assert file.facts["print_compensation"]["hole_um"] == 300.0


def test_the_foot_is_narrower_by_an_offset_that_another_program_makes(tmp_path):
    gear = Gear(teeth=20, module=1, width=8, bore=5)
    (plain,) = gear.write(tmp_path, "stl")
    whole = section(plain.path, 0.05)
    (file,) = gear.write(tmp_path, "stl", printing=PrintCompensation(foot=0.1, foot_height=0.2))
    for height, left in ((0.0001, 0.1), (0.1, 0.05), (0.3, 0.0)):
        found = sum(map(area, section(file.path, height)))
        inset = CrossSection([np.array(each) for each in whole]).offset(-left, 2, 4.0)  # Clipper, with mitres
        assert found == pytest.approx(inset.area(), abs=0.03), height


PARTS = {
    "spur": Gear(teeth=20, module=1, width=8, bore=5),
    "helical, hexagon": Gear(teeth=20, module=1, width=8, bore=8, keyway=Flats(count=6), helix_angle=radians(20)),
    "ring": Gear(teeth=60, module=1, width=8, internal=True),
    "all features": FULL,
}


@pytest.mark.parametrize("name", PARTS)
def test_a_part_is_what_it_was_once_its_compensation_is_taken_out(tmp_path, name):
    part = PARTS[name]
    plain, *_ = part.write(tmp_path, "stl")
    for file in part.write(tmp_path, "stl,3mf", printing=ALL):
        assert file.facts["volume_error_relative"] == pytest.approx(plain.facts["volume_error_relative"], abs=1e-5)


def test_a_rack_has_a_foot_as_wide_as_it_bears(tmp_path):
    rack = Rack(teeth=8, module=1, width=6, helix_angle=radians(15))
    with pytest.raises(DesignError, match="give foot_um = ") as refused:
        rack.write(tmp_path, "stl", printing=ALL)
    most = int(str(refused.value).rsplit("= ", 1)[1]) * 1e-3
    rack.write(tmp_path, "stl", printing=PrintCompensation(foot=most, shrinkage=0.004))
    # Half of the root line at the bar's end is the shortest edge of the lower face.
    flat = rack.form.fillet_width / cos(radians(15))
    assert 0.8 * flat < most < 3 * flat


@pytest.mark.parametrize("lost", ["hole", "foot", "shrinkage"])
def test_a_file_without_its_compensation_is_refused(tmp_path, monkeypatch, lost):
    from dataclasses import replace

    make = printing_room.compensated
    monkeypatch.setattr(
        printing_room, "compensated", lambda mesh, holes, printing: make(mesh, holes, replace(printing, **{lost: 0.0}))
    )
    with pytest.raises(FileError, match=r"lower face|exact volume|hole of another size"):
        PARTS["spur"].write(tmp_path, "stl", printing=ALL)


def test_numbers_out_of_range_name_the_key():
    for change, says in (
        ({"hole": 3.0}, "hole is 3"),
        ({"shrinkage": 0.4}, "such as 0.004"),
        ({"foot": -1}, "foot is -1"),
    ):
        with pytest.raises(DesignError, match=says):
            PrintCompensation(**change)
    with pytest.raises(DesignError, match="give the height of a layer"):
        PrintCompensation(foot=0.1, foot_height=0.0)


def test_cams_and_trains_take_it_from_the_design_and_sheets_say_so(tmp_path):
    changes = ["export.print.hole_um=150", "export.print.foot_um=100", "export.print.shrinkage_percent=0.4"]
    design = Design.load("roller", changes)
    cam = design.cam()
    (file,) = cam.write(tmp_path, "stl")
    assert file.lift_error_um < 5
    sizes = file.facts["print_compensation"]
    assert (sizes["hole_um"], sizes["shrinkage_z_percent"]) == (150.0, 0.4)
    assert "the sizes here are those of the part" in _sheet(draw(tmp_path, cam=cam)).lower()
    pair = GearPair(PARTS["spur"], Gear(teeth=30, module=1, width=8), backlash=0.1)
    for file in pair.write(tmp_path, "stl", printing=PrintCompensation(hole=0.1)):
        assert file.facts["print_compensation"]["hole_um"] == 100.0


def _sheet(written):
    import ezdxf

    file = next(each.path for each in written if each.name.endswith("_drawing.dxf"))
    words = (entity.dxf.text.split() for entity in ezdxf.readfile(file).modelspace().query("TEXT"))
    return " ".join(word for line in words for word in line)


def test_area_of_a_ring_is_measured_with_its_hole():
    """Lower face of a hexagonal bore in a disc: the mesh's own area against elementary geometry."""
    from cadgen.geometry.meshes.mesh import body_mesh

    part = Gear(teeth=20, module=1, width=8, bore=8, keyway=Flats(count=6)).part
    bare = Gear(teeth=20, module=1, width=8).part
    found, plain = (printing_room.lower_face(body_mesh(each.body, 1e-3))[0] for each in (part, bare))
    assert plain - found == pytest.approx(6 * 16 * tan(pi / 6), rel=1e-12)
