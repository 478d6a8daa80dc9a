"""The gear train's files: an assembly whose parts are at their places, and parts whose teeth are the exact ones."""

import re

import numpy as np
import pytest
from build123d import import_step

from cadgen.errors import FileError
from cadgen.gears.layout import Blanks, lay_out
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned
from cadgen.geometry.meshes.teeth import MeasuredPair, measured_pair
from cadgen.geometry.solids.gear_solids import assembly_bytes, colour_of_shaft, read_assembly, train_parts
from cadgen.geometry.solids.step import step_bytes
from cadgen.geometry.solids.step_text import read_gear, solids_in
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub, Keyway, SetScrew

FLANK_BAR_UM, ROOT_BAR_UM, VOLUME_BAR = 0.001, 0.01, 1e-6


def pair(z1, z2):
    one, two = (GradedGear(form=GearForm(teeth=z, normal_module=0.5, width=4.0)) for z in (z1, z2))
    return SpurPair(driver=one, driven=two, centre_distance=(z1 + z2) / 4, bearing_span=60.0)


@pytest.fixture(scope="module")
def layout():
    blanks = Blanks(
        drive=Blank(bore_diameter=3.0, hub=Hub(diameter=7.0, length=5.0, set_screw=SetScrew(diameter=1.6, height=2.5))),
        intermediate=Blank(bore_diameter=2.0, hub=Hub(diameter=6.0, length=1.0)),
        output=Blank(bore_diameter=4.0, key=Keyway(width=1.0, depth=0.6)),
    )
    return lay_out(thinned(Train((pair(25, 48), pair(24, 36)))), blanks)


@pytest.fixture(scope="module")
def parts(layout):
    return train_parts(layout, "mine", "a train")


@pytest.fixture(scope="module")
def of_assembly(layout, parts):
    return assembly_bytes(parts, layout, "mine_train", "a train")


@pytest.fixture(scope="module")
def of_parts(parts):
    return [step_bytes(part) for part in parts]


@pytest.fixture
def assembly(of_assembly, tmp_path):
    file = tmp_path / "train.step"
    file.write_bytes(of_assembly)
    return file


@pytest.fixture
def files(parts, of_parts, tmp_path):
    found = [tmp_path / f"{part.name}.step" for part in parts]
    for file, data in zip(found, of_parts, strict=True):
        file.write_bytes(data)
    return found


@pytest.mark.slow
def test_the_assembly_has_every_part_at_its_place(layout, parts, assembly):
    for read, part, placed in zip(read_assembly(assembly), parts, layout.parts, strict=True):
        assert (read.name, read.valid, read.bodies) == (part.name, True, 1)
        assert read.colour == pytest.approx(colour_of_shaft(placed.shaft), abs=1e-6)
        assert read.transform == pytest.approx(placed.transform, abs=1e-9)
        assert read.volume == pytest.approx(placed.volume, rel=VOLUME_BAR)


@pytest.mark.slow
def test_build123d_sees_the_same_assembly(layout, parts, assembly):
    """The reader that users have: labels, and bodies whose centres lie on their axes."""
    read = import_step(assembly)
    assert [child.label for child in read.children] == [part.name for part in parts]
    for child, placed in zip(read.children, layout.parts, strict=True):
        assert child.volume == pytest.approx(placed.volume, rel=1e-5)
        box = child.bounding_box()
        assert pytest.approx(placed.axis.real, abs=0.05) == box.center().X
        assert pytest.approx(placed.axis.imag, abs=0.05) == box.center().Y


def test_the_parts_teeth_are_the_exact_ones_and_their_solids_the_assembly_s(layout, assembly, files):
    solids = solids_in(assembly.read_text())
    for file, placed, solid in zip(files, layout.parts, solids, strict=True):
        content = read_gear(file, placed.gears, placed.starts)
        print(f"\n{file.name}: flank {1e3 * content.flank_error:.6f} µm, root {1e3 * content.root_error:.5f} µm")
        assert content.flank_error * 1e3 <= FLANK_BAR_UM
        assert content.root_error * 1e3 <= ROOT_BAR_UM
        assert content.solid == solid


def test_the_files_sections_have_the_play_of_the_exact_ones(layout, files):
    made = layout.train.stages[0]
    driver, driven = (
        read_gear(file, placed.gears, placed.starts).sections
        for file, placed in zip(files[:2], layout.parts[:2], strict=True)
    )
    from_files = MeasuredPair(driver[0], driven[0], made.centre_distance)
    off = (from_files.play(0.1) - measured_pair(made).play(0.1)) * made.driven_pitch_radius
    assert abs(off) <= 0.02e-3


@pytest.mark.slow
def test_bytes_are_the_same_again(layout, parts, assembly):
    assert assembly_bytes(parts, layout, "mine_train", "a train") == assembly.read_bytes()
    step_bytes(parts[0])
    assert assembly_bytes(parts, layout, "mine_train", "a train") == assembly.read_bytes()


def moved_pole(text: str, by: float) -> str:
    """The file with one inner pole of one tooth curve moved along x."""
    pole = re.search(r"B_SPLINE_CURVE_WITH_KNOTS\('',\d+,\(#\d+,#\d+,#(\d+)", "".join(text.split()))[1]
    line = re.search(rf"#{pole} = CARTESIAN_POINT\('',\(([^,]+),", text)
    return text.replace(line[0], line[0].replace(line[1], f"{float(line[1]) + by:.9f}"), 1)


def test_a_tooth_that_differs_shows(layout, files):
    files[2].write_text(moved_pole(files[2].read_text(), 1e-4))
    with pytest.raises(FileError, match=r"teeth that differ by 0\.0001 mm"):
        read_gear(files[2], layout.parts[2].gears, layout.parts[2].starts)


def test_a_solid_that_differs_shows(assembly, files):
    first = solids_in(assembly.read_text())[2]
    assert solids_in(files[2].read_text()) == [first]
    assert solids_in(moved_pole(files[2].read_text(), 1e-6)) != [first]


def test_a_gear_with_other_teeth_shows(layout, files):
    other = [GearForm(teeth=35, normal_module=0.5, width=4.0)]
    with pytest.raises(FileError, match="does not have all the flanks and roots of 35 teeth"):
        read_gear(files[2], other, layout.parts[2].starts)


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda text: text[: len(text) // 2], "not a whole STEP file"),
        (lambda text: text.replace(".MILLI.", "$"), "not a whole STEP file of one solid in mm"),
        (lambda text: re.sub(r"CARTESIAN_POINT\('',\(1", "CARTESIAN_POINT('',(x", text), "is damaged"),
        (lambda text: text + "é", "cannot read"),
    ],
)
def test_a_damaged_part_is_one_clear_error(layout, files, damage, message):
    files[2].write_text(damage(files[2].read_text()), encoding="utf-8")
    with pytest.raises(FileError, match=message):
        read_gear(files[2], layout.parts[2].gears, layout.parts[2].starts)


def test_a_single_part_is_no_assembly(files):
    with pytest.raises(FileError, match="is not one assembly"):
        read_assembly(files[2])


def test_places_are_turnings_and_shifts(layout):
    for part in layout.parts:
        turning = part.transform[:, :3]
        assert turning @ turning.T == pytest.approx(np.eye(3), abs=1e-15)
        assert np.linalg.det(turning) == pytest.approx(1.0)
