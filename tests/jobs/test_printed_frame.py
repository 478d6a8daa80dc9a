"""Frame that is printed in one piece: geometry, checks with their cures, refusals, parts, files and mounting."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
import trimesh

from cadgen import Design, DesignError
from cadgen.car.assembly.frame.one_piece import Bridge, one_piece
from cadgen.car.assembly.panels import LYING, STANDING, Panel, PartPlace, rectangle
from cadgen.check import CheckCode, failing
from cadgen.curves.contour import Contour
from cadgen.geometry.meshes.car_meshes import shape_mesh
from cadgen.jobs.car_frame import CarFrame, car_frame
from cadgen.jobs.frame_parts import frame_parts

CARS = ("workshop_car", "s_course", "posts_and_walls", "figure_eight")
PRINTED = ("frame.make=printed", "frame.material=")


def frame_of(name: str = "workshop_car", *overrides: str) -> CarFrame:
    return car_frame(Design.load(name, [*PRINTED, *overrides]).values)


@pytest.fixture(scope="module")
def workshop() -> CarFrame:
    return frame_of()


@pytest.mark.parametrize(
    "name", ["workshop_car", *(pytest.param(name, marks=[pytest.mark.slow, pytest.mark.long]) for name in CARS[1:])]
)
def test_every_packaged_car_can_have_its_frame_printed(name: str) -> None:
    made = frame_of(name)
    assert made.passed, [check.name for check in failing(made.checks)]
    printed = made.frame.printed
    mesh = shape_mesh(printed.shape, 0.02)
    body = trimesh.Trimesh(mesh.vertices.astype(np.float32), mesh.triangles)
    assert body.is_watertight
    assert body.body_count == 1
    # By the sheets' faces, whose arcs are chords: area times thickness.
    panels = (made.frame.base, *made.frame.standing)
    by_faces = sum(shapely.Polygon(panel.face(chord=0.002)).area * panel.thickness for panel in panels)
    assert printed.volume == pytest.approx(by_faces, rel=1e-4)
    assert body.volume == pytest.approx(printed.volume, rel=1e-3)
    assert body.extents == pytest.approx(printed.size, abs=1e-4)
    # Its foot is flat: the lower face is that of the base.
    assert body.bounds[0, 2] == pytest.approx(-made.frame.base.thickness)


def test_seats_stay_where_they_are_and_joints_fall_away(workshop: CarFrame) -> None:
    sheets = car_frame(Design.load("workshop_car").values)
    for wall, plate in zip(workshop.frame.plates, sheets.frame.plates, strict=True):
        assert [hole[1:] for hole in wall.holes] == [hole[1:] for hole in plate.holes]
        assert (wall.edge_holes, wall.features) == ((), ())
        assert np.allclose(wall.place.shift, plate.place.shift)
    seats = [hole for hole in workshop.frame.plates[0].holes if hole.shaft]
    apart = [np.hypot(b.u - a.u, b.v - a.v) for a, b in pairwise(seats)]
    assert apart == pytest.approx([stage.centre_distance_mm for stage in workshop.design.train.stages], abs=1e-9)
    assert {feature.name for feature in workshop.frame.base.features} == {"opening"}
    few, many = (
        {code: count for code, _, count in made.bought if code.startswith("ISO 4762")} for made in (workshop, sheets)
    )
    # Eight of the platform's spacers and two of the block: those from below into the sheets are gone.
    assert sum(few.values()) == 10
    assert sum(many.values()) == 10 + sum(hole.name == "screw from below" for hole in sheets.frame.base.holes)


def test_it_is_one_part_of_the_car_with_the_centre_of_its_mesh(workshop: CarFrame) -> None:
    parts = {part.code: part for part in frame_parts(workshop)}
    assert not {"base", "plate-near", "plate-far", "bracket-idle", "bracket-micrometer"} & parts.keys()
    part = parts["printed-frame"]
    assert part.material == "PLA"
    assert part.assumed
    mesh = shape_mesh(part.shape, 0.002)
    body = trimesh.Trimesh(mesh.vertices, mesh.triangles)
    assert part.content.centre == pytest.approx(body.center_mass, abs=0.01)
    assert part.each == pytest.approx(body.volume * 1.24e-3, rel=1e-3)
    (place,) = part.places
    # The lower face is as far over the floor as the design's own frame says, and the camshaft's seat lies at the axis.
    low = place @ [0.0, 0.0, -workshop.frame.base.thickness, 1.0]
    assert workshop.frame.arrangement.height - low[1] == pytest.approx(workshop.entry().json()["base_height_mm"])


def test_a_bed_that_is_too_small_names_cures_that_help(workshop: CarFrame) -> None:
    long, wide, high = workshop.frame.printed.size
    made = frame_of("workshop_car", "frame.bed_mm=[220, 220, 250]")
    (check,) = failing(made.checks)
    assert check.code == CheckCode.FRAME_BED
    assert check.value == pytest.approx(220 - max(long, wide))
    assert check.value == pytest.approx(220 - 232.9)
    bed = check.advice.split("set frame.bed_mm to ")[1].split(" or more")[0]
    assert frame_of("workshop_car", f"frame.bed_mm={bed}").passed
    assert "leave frame.make and frame.bed_mm out" in check.advice
    assert car_frame(Design.load("workshop_car").values).passed
    # Turned by a quarter it fits on a bed that is longer than wide.
    assert frame_of("workshop_car", f"frame.bed_mm=[{wide + 0.1:g}, {long + 0.1:g}, {high + 0.1:g}]").passed


def test_a_wall_over_an_opening_is_a_bridge() -> None:
    """A wall of 60 mm over a base with an opening of 20 mm under its middle, and one that ends over another."""

    def sheet(code: str, outline: np.ndarray, cuts: tuple[Contour, ...], thickness: float, place: PartPlace) -> Panel:
        return Panel(
            code=code,
            name=code,
            outline=Contour(outline, np.zeros(4)),
            cuts=cuts,
            holes=(),
            edge_holes=(),
            features=(),
            thickness=thickness,
            place=place,
        )

    opening = Contour(rectangle(20.0, 10.0, 40.0, 30.0), np.zeros(4))
    base = sheet("base", rectangle(0.0, 0.0, 60.0, 60.0), (opening,), 6.0, PartPlace(LYING, np.array([0.0, 56.0, 0.0])))
    over = sheet("over", rectangle(0.0, -50.0, 60.0, -10.0), (), 8.0, PartPlace(STANDING, np.array([0.0, 0.0, -24.0])))
    ends = sheet("ends", rectangle(30.0, -50.0, 60.0, -10.0), (), 4.0, PartPlace(STANDING, np.array([0.0, 0.0, -30.0])))
    made = one_piece(base, (over, ends), 50.0)
    assert [(bridge.wall, bridge.length, bridge.held) for bridge in made.bridges] == [
        ("over", pytest.approx(20.0), True),
        ("ends", pytest.approx(10.0), False),
    ]
    assert made.size == pytest.approx((60.0, 60.0, 46.0))


@pytest.mark.parametrize(("length", "wrong"), [(20.0, []), (31.0, ["frame-bridge"])])
def test_an_overhang_with_a_free_end_has_a_limit_of_its_own(
    workshop: CarFrame, length: float, wrong: list[str]
) -> None:
    def failed(*bridges: Bridge) -> list[str]:
        made = replace(workshop.frame.printed, bridges=tuple(sorted(bridges, key=lambda each: -each.length)))
        return [str(check.code) for check in failing(tuple(workshop._printed_checks(made)))]

    bridge = Bridge(wall="wall", length=length, held=True)
    assert failed(bridge) == wrong
    assert failed(bridge, Bridge(wall="free", length=0.9, held=False)) == wrong
    assert failed(bridge, Bridge(wall="free", length=1.1, held=False)) == [*wrong, "frame-overhang"]


def test_a_shaft_with_its_key_passes_the_seat_through_which_it_is_pushed(workshop: CarFrame) -> None:
    """A key of 3 x 3 mm stands 1.2 mm out of a shaft of 8 mm (DIN 6885-1): its corners lie at 5.41 mm of 8."""
    (check,) = (check for check in workshop.checks if check.code == CheckCode.FRAME_KEYS)
    assert check.value == pytest.approx(8.0 - np.hypot(5.2, 1.5))
    assert workshop.pushed_through is workshop.frame.plates[0]
    tight = frame_of("workshop_car", "train.plate.bearing_bores_mm=[11, 7, 7, 10]")
    (check,) = (check for check in tight.plain_checks if check.code == CheckCode.FRAME_KEYS)
    assert not check.passed
    assert "10.8 mm or more for shaft 4" in check.advice


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (["frame.make=printed", "frame.cutting=laser"], r"frame\.cutting is of sheets.*remove it, or set frame\.make"),
        (
            ["frame.make=printed", "frame.cutting=laser", "frame.cutter_diameter_mm=1"],
            r"frame\.cutting and frame\.cutter_diameter_mm are of sheets.*remove them",
        ),
        (["frame.bed_mm=[200, 200, 200]"], r"frame\.bed_mm is of a printed frame.*set frame\.make to \"printed\""),
        (["frame.make=cast"], r"frame\.make"),
    ],
)
def test_keys_of_the_other_make_are_refused_in_one_sentence(overrides: list[str], said: str) -> None:
    with pytest.raises(DesignError, match=said):
        Design.load("workshop_car", overrides)


def test_files_for_a_printer_take_back_what_it_does(workshop: CarFrame, tmp_path: Path) -> None:
    """Seats 0.2 mm larger and all of it 1 % larger in the files; read back without both, the volume is exact."""
    from cadgen.output.files.frame_files import FrameText, mesh_files
    from cadgen.parts.print_compensation import PrintCompensation

    text, shape = FrameText("car", "frame"), workshop.frame.printed.shape
    plain = [each.name for each in mesh_files(shape, tmp_path, "plain", text, None, 0.02)]
    assert plain == ["plain.stl", "plain.3mf"]
    printing = PrintCompensation(hole=0.2, chords=True, foot=0.1, shrinkage=0.01, shrinkage_z=0.01)
    assert len(list(mesh_files(shape, tmp_path, "larger", text, printing, 0.02))) == 2
    one, other = (trimesh.load(tmp_path / f"{name}.stl") for name in ("plain", "larger"))
    assert one.is_watertight
    assert other.is_watertight
    assert other.extents == pytest.approx(one.extents / 0.99, rel=1e-5)


@pytest.mark.slow
@pytest.mark.long
def test_every_file_of_a_printed_frame_is_written_and_read_back(tmp_path: Path) -> None:
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader

    from cadgen import verify

    made = Design.load("workshop_car", PRINTED).frame()
    written = made.write(tmp_path)
    names = {file.name.removeprefix("workshop_car_frame_") for file in written}
    for code in ("printed", "platform", "block"):
        assert {f"{code}.step", f"{code}.stl", f"{code}.3mf", f"{code}_drawing.pdf"} <= names
    for wall in ("near", "far", "idle", "micrometer"):
        assert f"printed_wall_{wall}_drawing.dxf" in names
    assert not any(name.endswith(".nc") or name.startswith(("base", "plate_", "bracket")) for name in names)
    assert verify(tmp_path).is_true
    printed = made.computed.frame.printed
    reader, found = STEPControl_Reader(), GProp_GProps()
    reader.ReadFile(str(tmp_path / "workshop_car_frame_printed.step"))
    reader.TransferRoots()
    BRepGProp.VolumeProperties_s(reader.OneShape(), found)
    assert found.Mass() == pytest.approx(printed.volume, rel=1e-9)
    body = trimesh.load(tmp_path / "workshop_car_frame_printed.stl")
    assert body.is_watertight
    assert body.volume == pytest.approx(printed.volume, rel=1e-4)
    sheet = next(file for file in written if file.name.endswith("printed_drawing.dxf"))
    assert sheet.facts["dimensions_mm"]["camshaft to fork axis"] == 70.0


@pytest.mark.slow
@pytest.mark.long
def test_the_car_is_mounted_with_shafts_pushed_through_the_walls() -> None:
    from cadgen.jobs.assembly_files import mounting_notes
    from cadgen.jobs.cam.steering_cam import plan_cam
    from cadgen.jobs.car_assembly import put_together
    from cadgen.jobs.car_gaps import part_gaps
    from cadgen.jobs.drawings import Folder, sheets_of
    from cadgen.jobs.gears.gear_train import plan_gears

    design = Design.load("workshop_car", PRINTED).values
    train = plan_gears(design)
    car = put_together(plan_cam(design, "actual"), train)
    notes = " ".join(str(note) for note in mounting_notes(car))
    assert "push each shaft from the left through one wall" in notes
    assert "plate" not in notes
    assert "tabs" not in notes
    assert not any("plate" in str(part.title) for part in car.parts)
    # What is near it under the pointer of the page, and no plate among the sheets of the gears.
    gaps = part_gaps(car)
    assert gaps["printed-frame"][0].size == pytest.approx(1.0, abs=0.01)
    assert not any(stem.endswith("_plate") for stem, _ in sheets_of(train, Folder.at(Path("nowhere"))))
