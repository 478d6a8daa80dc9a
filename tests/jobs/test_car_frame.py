"""The frame of a car: its geometry from the design alone, its checks and their cures, and its files."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely

from cadgen import Design, DesignError
from cadgen.car.assembly.frame.frame_gaps import frame_gap
from cadgen.check import CheckCode, failing
from cadgen.errors import CheckError
from cadgen.jobs.car_frame import CarFrame, car_frame
from tests.forks import Forks

LONG = [pytest.mark.slow, pytest.mark.long]
CARS = ("workshop_car", "s_course", "posts_and_walls", "figure_eight")


def frame_of(name: str = "workshop_car", *overrides: str) -> CarFrame:
    return car_frame(Design.load(name, overrides).values)


@pytest.fixture(scope="module")
def workshop() -> CarFrame:
    return frame_of()


@pytest.mark.parametrize("name", CARS)
def test_the_empty_section_of_every_packaged_car_gives_a_frame(name: str) -> None:
    made = frame_of(name)
    assert made.passed, [check.name for check in failing(made.checks)]


def test_shoulders_of_brackets_stand_on_the_base_beside_their_opened_corners(workshop: CarFrame) -> None:
    """Every straight piece of a foot is at least as long as a wall is thick: less is a lip that a file takes off."""
    brackets = [sheet for sheet in workshop.frame.sheets if sheet.code.startswith("bracket")]
    assert len(brackets) == 2
    for sheet in brackets:
        foot = max(each.v + each.across / 2 for each in sheet.features if each.name == "tab")
        points, bulges = sheet.outline.vertices, sheet.outline.bulges
        ends = np.roll(points, -1, axis=0)
        on_it = (abs(points[:, 1] - foot) < 1e-6) & (abs(ends[:, 1] - foot) < 1e-6) & (bulges == 0.0)
        lengths = np.abs(ends - points)[on_it, 0]
        assert len(lengths) == 3
        assert lengths.min() >= 2.0  # frame.wall_mm


def test_seats_lie_where_the_design_puts_the_axes(workshop: CarFrame) -> None:
    design = workshop.design
    for plate in workshop.frame.plates:
        seats = [hole for hole in plate.holes if hole.shaft]
        apart = [np.hypot(b.u - a.u, b.v - a.v) for a, b in pairwise(seats)]
        assert apart == pytest.approx([stage.centre_distance_mm for stage in design.train.stages], abs=1e-9)
        places = plate.place.out(np.array([[hole.u, hole.v, 0.0] for hole in seats]))
        # The camshaft lies at the origin; the rear axle behind it, a wheel's radius over the floor.
        assert places[-1, :2] == pytest.approx([0.0, 0.0], abs=1e-9)
        assert places[0, 0] == pytest.approx(design.cam.base_radius_mm - design.car.wheelbase_mm)
        height = workshop.layout.arrangement.height
        assert height - places[0, 1] == pytest.approx(workshop.layout.site.wheel_radius)


@pytest.mark.parametrize("name", ["workshop_car", "figure_eight"])
def test_every_shaft_has_two_bearings(name: str) -> None:
    """The rear axle runs in a bearing plate and in the idle bracket, and clears the plate between by the clearance."""
    made = frame_of(name).frame
    count = dict.fromkeys(made.arrangement.axes, 0)
    for part in made.bought:
        axis = complex(*part.start[:2])
        if part.kind == "bearing" and part.way == (0.0, 0.0, 1.0):
            count[axis] += 1
    assert set(count.values()) == {2}
    (passage,) = (hole for plate in made.plates for hole in plate.holes if not hole.fit)
    assert passage.shaft == 1
    assert passage.diameter == 5.0 + 2 * made.site.clearance


def test_fork_and_slots_lie_the_base_radius_ahead_of_the_camshaft(workshop: CarFrame) -> None:
    platform, base = workshop.frame.platform, workshop.frame.base
    spindle = platform.holes[0]
    (x, _, z), *_ = platform.place.out(np.array([[spindle.u, spindle.v, 0.0]]))
    assert (x, z) == pytest.approx((70.0, -23.5))  # base radius, and the inner face's distance: 25 - 3 / 2
    screws = [hole for hole in base.holes if hole.name == "screw of a spacer"]
    assert np.mean([hole.u for hole in screws]) == pytest.approx(-70.0)
    # Each slot of the platform lies over its spacer, and is as long as the way and a clearance hole.
    slots = {(feature.u, feature.v) for feature in platform.features}
    assert slots == {(hole.u, hole.v) for hole in screws}
    assert {feature.along for feature in platform.features} == {4.0 + 3.4}


def test_tabs_fit_their_slots(workshop: CarFrame) -> None:
    frame = workshop.frame
    slots = [feature for feature in frame.base.features if feature.name == "slot for a tab"]
    tabs = []
    for panel in (*frame.plates, *frame.brackets):
        for feature in panel.features:
            corner = np.array([[feature.u, feature.v, panel.thickness / 2]])
            tabs.append((panel, feature, frame.base.place.within(panel.place.out(corner))[0]))
    assert len(slots) == len(tabs) == 8
    for panel, tab, (u, v, w) in tabs:
        assert 0 < w < frame.base.thickness
        (slot,) = (each for each in slots if np.hypot(each.u - u, each.v - v) < 1.0)
        sizes = sorted((slot.along, slot.across))
        # A slot at an edge of the base is open there, and ends with the sheet.
        assert sizes[1] - max(tab.along, panel.thickness) == pytest.approx(0.1, abs=0.051)
        assert sizes[0] - min(tab.along, panel.thickness) == pytest.approx(0.1, abs=0.051)


def test_screws_meet_the_threads_in_the_feet(workshop: CarFrame) -> None:
    frame = workshop.frame
    holes = {(round(-hole.u, 6), round(-hole.v, 6)) for hole in frame.base.holes if hole.name == "screw from below"}
    threads = set()
    for panel in (*frame.plates, *frame.brackets):
        for each in panel.edge_holes:
            x, y, z = panel.place.out(np.array([[each.u, each.v, panel.thickness / 2]]))[0].tolist()
            assert y == pytest.approx(frame.top)
            threads.add((round(x, 6), round(z, 6)))
    assert holes == threads


def test_a_hub_as_large_as_a_bearing_is_measured(workshop: CarFrame) -> None:
    """The hub on the camshaft, of 16 mm as its bearing, is brought 0.6 mm nearer to the plate than the clearance."""
    shafts = [list(on) for on in workshop.layout.shafts]
    ((at, hub),) = ((k, each) for k, each in enumerate(shafts[-1]) if each.body.name == "the hub on shaft 4")
    assert 2 * hub.body.radius == workshop.layout.site.bearings[-1] == 16.0
    shafts[-1][at] = hub._replace(body=hub.body.raised(0.6))
    found = frame_gap(workshop.frame, shafts, workshop.layout.bores)
    assert found.size == pytest.approx(0.4)
    assert (found.one, found.other) == ("bearing plate beside the disc", "the hub on shaft 4")


@pytest.mark.parametrize(
    ("override", "code", "cure"),
    [
        ("frame.base_height_mm=60", CheckCode.FRAME_WALL, "leave frame.base_height_mm out"),
        ("frame.screws=M5", CheckCode.FRAME_EDGE, "frame.screws"),
        # The train of a short car folds, and its largest gear meets platform or block of the fork.
        ("car.wheelbase_mm=90", CheckCode.FRAME_CLEARANCE, "layout.camshaft_height_mm"),
        *(
            pytest.param(f"car.wheelbase_mm={size}", CheckCode.FRAME_CLEARANCE, "layout.camshaft_height_mm", marks=LONG)
            for size in (75, 80, 85, 95, 105, 110, 120)
        ),
    ],
)
def test_a_frame_that_fails_names_a_cure_that_helps(override: str, code: CheckCode, cure: str) -> None:
    made = frame_of("workshop_car", override)
    wrong = failing(made.plain_checks)
    assert code in {check.code for check in wrong}
    (check,) = (check for check in made.checks if check.code == code)
    assert cure in check.advice
    if "set" in check.advice:
        key, value = check.advice.removeprefix("set ").split(" to ")
        assert frame_of("workshop_car", override, f"{key}={value}").passed


@pytest.mark.slow
@pytest.mark.long
def test_the_frame_of_a_proposed_train_is_cured_by_more_room_between_the_parts(forks: Forks, tmp_path: Path) -> None:
    """A proposed car, driven at its right, whose base has too little material beside a hole at a clearance of 2 mm."""
    points = [(0, 0), (450, 125), (950, 550), (1500, 620), (2050, 200), (2550, -280), (3100, -300), (3650, 150)]
    (tmp_path / "points.csv").write_text("x,y\n" + "".join(f"{x},{y}\n" for x, y in points))
    wheels = [f"car.{key}_mm={size}" for key, size in (("drive_wheel_offset", -60), ("idle_wheel_offset", -150))]
    settings = [text for each in ("car.wheelbase_mm=180", *wheels) for text in ("--set", each)]
    command = ["new", "car", "--points", str(tmp_path / "points.csv"), "--train", *settings]
    assert forks.run("from cadgen.cli import main; main()", *command, cwd=tmp_path).returncode == 0
    (tmp_path / "car.toml").write_text((tmp_path / "car.toml").read_text() + "\n[frame]\n")
    design = str(tmp_path / "car.toml")
    (wrong,) = failing(frame_of(design).own_checks)
    assert (wrong.code, wrong.advice) == (CheckCode.FRAME_WALL, "set layout.clearance_mm to 3")
    assert frame_of(design, "layout.clearance_mm=3").passed


def test_a_failing_frame_is_not_written(tmp_path: Path) -> None:
    with pytest.raises(CheckError, match="least material beside a hole"):
        Design.load("workshop_car", ["frame.base_height_mm=60"]).frame().write(tmp_path)
    assert not list(tmp_path.iterdir())


def test_plates_thinner_than_their_bearings_are_refused() -> None:
    made = frame_of("workshop_car", "train.plate={thickness_mm=4}")
    assert CheckCode.PLATE_THICKNESS in {check.code for check in failing(made.layout.checks)}


def test_designs_without_frame_or_layout_say_what_to_add() -> None:
    with pytest.raises(DesignError, match=r"has no \[frame\].*--set frame=\{\}"):
        car_frame(Design.load("workshop_car", ["frame="]).values)
    with pytest.raises(DesignError, match=r"\[frame\] holds the parts where \[layout\] puts them"):
        frame_of("workshop_car", "layout=")
    with pytest.raises(DesignError, match=r"no bearing of the table suits shaft 2 of 3\.3 mm"):
        frame_of("workshop_car", "train.intermediate.bore_diameter_mm=3.3")


def test_nuts_in_slots_take_the_screws_of_a_laser() -> None:
    made = frame_of("workshop_car", "frame.cutting=laser")
    assert made.passed
    plate = made.frame.plates[0]
    assert not plate.edge_holes
    assert not plate.outline.bulges.any()
    # Each slot takes the screw's hole over its depth, and the nut's width over its height.
    depth, nut = 12.0 - 6.0 + 2.0, (5.7 - 3.4) * 2.6
    corners = plate.outline.vertices
    upper = corners[corners[:, 1] > -made.frame.top - 1e-9]
    whole = shapely.MultiPoint(upper).convex_hull.area + 2 * 10.0 * 6.0  # with both tabs
    assert whole - plate.outline.area() == pytest.approx(2 * (3.4 * depth + nut), abs=1e-6)


def test_a_sheet_is_written_milled_and_read_back(workshop: CarFrame, tmp_path: Path) -> None:
    from cadgen.design.machining import Machining
    from cadgen.output.files.frame_files import FrameText, panel_files

    bracket = workshop.frame.brackets[1]
    text = FrameText("car", "frame, design 0")
    machining = Machining(cutter_diameter_mm=2.0)
    files = list(panel_files(bracket, tmp_path, "car_bracket", text, machining, "H7"))
    assert [each.name for each in files] == ["car_bracket_outline.dxf", "car_bracket.step", "car_bracket.nc"]
    facts = files[-1].facts.json()
    assert facts["gouge_mm"] < 1e-3
    with pytest.raises(DesignError, match="choose a smaller cutter"):
        list(panel_files(bracket, tmp_path, "car_bracket", text, Machining(cutter_diameter_mm=4.0), "H7"))


@pytest.mark.slow
@pytest.mark.long
def test_every_file_of_a_frame_is_written_and_read_back(tmp_path: Path) -> None:
    from cadgen import verify

    written = Design.load("workshop_car").frame().write(tmp_path)
    names = {file.name.removeprefix("workshop_car_frame_") for file in written}
    for code in ("plate_near", "plate_far", "base", "platform", "bracket_idle", "bracket_micrometer"):
        assert {f"{code}_outline.dxf", f"{code}.step", f"{code}.nc", f"{code}_drawing.dxf"} <= names
    assert {"block.step", "block_drawing.dxf", "bought.csv"} <= names
    assert verify(tmp_path).is_true
    assert {each["code"] for each in written.entry["bought"]} >= {"ISO 4762 M3 x 12", "628/8-2Z"}
    sheet = next(file for file in written if file.name.endswith("base_drawing.dxf"))
    assert sheet.facts["dimensions_mm"]["camshaft to fork axis"] == 70.0


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(
    ("name", "overrides"), [*((name, ()) for name in CARS), ("workshop_car", ("frame.make=printed",))]
)
def test_no_part_of_the_frame_overlaps_another_part_of_the_car(
    name: str, overrides: tuple[str, ...], tmp_path: Path
) -> None:
    """Common volume of the solids of the STEP files, read back by the kernel alone, at four angles of the cam."""
    from itertools import combinations

    from OCP.Bnd import Bnd_Box
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
    from OCP.BRepBndLib import BRepBndLib
    from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
    from OCP.BRepGProp import BRepGProp
    from OCP.gp import gp_Trsf
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader

    from cadgen.geometry.solids.car_solids import car_solids
    from cadgen.geometry.solids.step import step_bytes
    from cadgen.jobs.cam.steering_cam import plan_cam
    from cadgen.jobs.car_assembly import put_together
    from cadgen.jobs.gears.gear_train import plan_gears

    design = Design.load(name, overrides).values
    car = put_together(plan_cam(design, "actual"), plan_gears(design))
    solids = {}
    for code, part in car_solids(car.parts, "").items():
        file = tmp_path / f"{code}.step"
        file.write_bytes(step_bytes(part))
        reader = STEPControl_Reader()
        reader.ReadFile(str(file))
        reader.TransferRoots()
        solids[code] = reader.OneShape()
    of_frame = {part.code for part in car.parts if part.group.kind == "frame"}
    one = {"printed-frame"} if overrides else {"plate-near", "plate-far", "base", "bracket-idle"}
    assert {"platform", "fork-block", *one} <= of_frame
    for angle in np.linspace(0.0, 2 * np.pi, 4, endpoint=False).tolist():
        placed = []
        for part in car.parts:
            for place in part.placed(angle, car.fork_angle(angle)) if part.shape is not None else ():
                trsf, box = gp_Trsf(), Bnd_Box()
                trsf.SetValues(*(float(value) for value in place.ravel()))
                solid = BRepBuilderAPI_Transform(solids[part.code], trsf, True).Shape()
                BRepBndLib.AddOptimal_s(solid, box, False, False)
                placed.append((part.code, solid, box))
        for (one, first, around), (other, second, beside) in combinations(placed, 2):
            if {one, other} & of_frame and not around.IsOut(beside):
                found = GProp_GProps()
                BRepGProp.VolumeProperties_s(BRepAlgoAPI_Common(first, second).Shape(), found)
                assert found.Mass() < 1e-6, (one, other, angle, found.Mass())
