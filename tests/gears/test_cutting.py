"""Room beyond teeth beside a larger gear, against tools as clouds of points and against printed diameters of hobs."""

from math import cos, inf, pi, radians, sin, tan
from pathlib import Path

import numpy as np
import pytest

from cadgen.check import CheckCode
from cadgen.design.load import load_design, train_of
from cadgen.errors import DesignError
from cadgen.gears.choices import ToothCutting
from cadgen.gears.cutting import Made, blocked, cutting_checks, cutting_notes, sheet_notes
from cadgen.gears.layout import Blanks, TrainPart, lay_out
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tools import Tool, usual_hob
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.jobs.drawings import Folder, sheets_of
from cadgen.jobs.gears.gear_train import GearTrain, plan_gears
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub

PLACES = ("drive", "intermediate", "output")


@pytest.mark.parametrize(("turned", "beside"), [(0.0, 24.0), (0.0, 76.0), (20.0, 30.0), (-35.0, 120.0)])
def test_a_cutter_reaches_as_far_as_a_cloud_of_its_points(turned: float, beside: float) -> None:
    """Points of a cylinder whose axis stands over the end of the teeth, tangent to the roots, turned by the helix."""
    gear = GearForm(teeth=20, normal_module=1.0, width=5.0, helix_angle=radians(turned))
    radius, root = 31.5, gear.root_diameter / 2
    half = 1.25 / tan(radians(20))
    around, along = np.meshgrid(np.linspace(0.0, pi / 2, 200_001), [-half, half])
    heights = root + radius - radius * np.cos(around)
    axial = radius * np.sin(around) * cos(radians(turned)) + along * sin(radians(turned))
    reached = axial[heights <= beside / 2].max()
    needed = Tool(ToothCutting.HOBBED, 63.0).run_out(gear, beside)
    assert needed == pytest.approx(reached, abs=1e-3)
    assert Tool(ToothCutting.MILLED, 63.0).run_out(gear, beside) == needed


def test_hobs_have_the_diameters_of_the_standard() -> None:
    """DIN 8002, diameters by the module as read from a damaged print, the last by judgement."""
    printed = {1: 50, 1.5: 56, 2: 63, 2.5: 70, 3: 80, 4: 90, 5: 100, 6: 110, 8: 125, 10: 140}
    assert {module: usual_hob(module) for module in printed} == printed


def test_other_tools_need_a_groove_all_or_nothing() -> None:
    gear = GearForm(teeth=20, normal_module=2.0, width=5.0)
    tools = (ToothCutting.SHAPED, ToothCutting.WIRE, ToothCutting.PRINTED)
    assert [Tool(each).run_out(gear, 80.0) for each in tools] == [5.0, inf, 0.0]


def _cluster(lower: int, upper: int, collar: float) -> tuple[TrainPart, ...]:
    """Parts of a train of two stages whose second shaft has a wheel of `lower` and a pinion of `upper` teeth."""

    def stage(driver: int, driven: int) -> SpurPair:
        gears = [GradedGear(form=GearForm(teeth=z, normal_module=1.0, width=5.0), grade=7) for z in (driver, driven)]
        return SpurPair(driver=gears[0], driven=gears[1], centre_distance=(driver + driven) / 2, bearing_span=120.0)

    blank = Blank(bore_diameter=4.0, hub=Hub(diameter=9.0, length=collar))
    blanks = Blanks(drive=Blank(), intermediate=blank, output=Blank())
    return lay_out(thinned(Train((stage(20, lower), stage(upper, 60)))), blanks).on_shafts


@pytest.mark.parametrize(("lower", "upper", "expected"), [(60, 20, [1]), (20, 60, [0]), (40, 40, [0, 1])])
def test_a_gear_is_blocked_where_the_other_stands_over_its_roots(lower: int, upper: int, expected: list[int]) -> None:
    found = list(blocked(_cluster(lower, upper, 4.0)[1]))
    assert [each.number for each in found] == expected
    assert all(each.room == pytest.approx(4.0) for each in found)
    other = {0: upper, 1: lower}
    assert all(each.beside == pytest.approx(other[each.number] + 2.0, abs=0.5) for each in found)


def test_a_shaft_with_one_gear_needs_no_room() -> None:
    assert not list(blocked(_cluster(60, 20, 1.0)[0]))


APART = '[train.intermediate]\nbore_diameter_mm = 5.0\njoint = "glued"\ncut_apart = true\n'
HELICAL = "helix_angle_deg = 15.0"
WEBBED = """hub = { diameter_mm = 12.0, length_mm = 6.0, set_screw_mm = 2.5 }
web = { thickness_mm = 3.0, rim_mm = 3.0 }
lightening = { holes = 4, hole_diameter_mm = 6.0 }
keyway = { width_mm = 1.5, depth_mm = 1.0 }
"""


@pytest.mark.parametrize(("keys", "features"), [("", ""), (HELICAL, ""), ("", WEBBED)])
def test_gears_that_are_cut_apart_are_two_bodies_that_make_up_the_part(keys: str, features: str) -> None:
    """Their meshes are closed, do not overlap, and fill the part where they are joined."""
    plan = planned(TWO, keys, APART + features)
    (part,) = (each for each in plan.layout.parts if each.name == "2_cluster")
    pieces = [each for each in plan.layout.pieces.parts if each.joined_to]
    assert [(each.name, each.joined_to) for each in pieces] == [("2_wheel", "2_pinion"), ("2_pinion", "2_wheel")]
    assert [each.stages for each in pieces] == [(1,), (2,)]
    assert sum(each.volume for each in pieces) == pytest.approx(part.volume, rel=1e-12)
    # The lower one has the collar; the upper one is as long as its teeth.
    lengths = [each.body.slabs[-1].end for each in pieces]
    collar = 6.0 if features else 1.0
    assert lengths == pytest.approx([8.0 + collar, 8.0])
    whole, *solids = (body_mesh(each.body, 0.01).solid().transform(each.transform) for each in (part, *pieces))
    assert all(len(each.decompose()) == 1 for each in solids)
    assert (solids[0] ^ solids[1]).volume() < 1e-6
    rest = (whole - solids[0] - solids[1]).volume() + ((solids[0] + solids[1]) - whole).volume()
    assert rest < 2e-4 * part.volume
    for each, solid in zip(pieces, solids, strict=True):
        assert solid.volume() == pytest.approx(each.volume, rel=1e-3)


@pytest.mark.slow
def test_gears_that_are_cut_apart_can_be_ordered_from_their_files_and_sheets(tmp_path: Path) -> None:
    plan = planned(TWO, 'cutting = "wire"', APART)
    assert plan.passed
    written = {each.name.removeprefix(plan.stem) for each in plan.write(tmp_path, "step,stl,3mf,dxf,csv")}
    for name in ("2_wheel", "2_pinion"):
        assert {f"_{name}.step", f"_{name}.stl", f"_{name}.3mf", f"_{name}.dxf"} <= written
    assert not any("cluster" in name for name in written)
    rows = (tmp_path / f"{plan.stem}_parts.csv").read_text("utf-8").splitlines()
    assert [row.split(",")[0] for row in rows[1:]] == ["1_pinion", "2_wheel", "2_pinion", "3_wheel"]
    sheets = {stem.removeprefix(plan.stem): sheet for stem, sheet in sheets_of(plan, Folder({}, "2026-01-01"))}
    lower, upper = sheets["_2_wheel"], sheets["_2_pinion"]
    assert (lower.dimensions["hub length"], lower.dimensions["length"], lower.title.quantity) == (1.0, 9.0, 1)
    assert "hub length" not in upper.dimensions
    joined = "on the same shaft, glued. Angle between the teeth of both: free."
    assert f"On its collar stands 2_pinion, {joined}" in lower.notes
    assert f"Stands on the collar of 2_wheel, {joined}" in upper.notes


@pytest.mark.parametrize(
    ("cutting", "collar", "passes"),
    [
        (ToothCutting.SHAPED, 3.9, False),
        (ToothCutting.SHAPED, 4.0, True),
        (ToothCutting.HOBBED, 24.0, False),
        (None, 1.0, None),
    ],
)
def test_room_is_judged_where_the_tool_is_stated_and_else_told(
    cutting: ToothCutting | None, collar: float, passes: bool | None
) -> None:
    """A shaper's cutter of module 1 needs 4 mm. The hob of Ø50 stands higher than half before Ø62 over Ø17.5."""
    parts = _cluster(60, 20, collar)
    makings = [Made(place, cutting=cutting) for place in PLACES]
    checks, notes = cutting_checks(parts, makings), cutting_notes(parts, makings, None)
    assert [check.passed for check in checks] == ([] if passes is None else [passes])
    assert len(notes) == (passes is None)
    if notes:
        assert "on shaft 2 end 1 mm before Ø62" in notes[0]
        assert "needs 4 mm" in notes[0]


def test_a_smaller_hob_is_named_where_one_is_small_enough() -> None:
    """Ø62 stands 22.3 mm over the roots of 20 teeth: hobs of Ø50 and of Ø20 need half of their diameter."""
    for collar, named in ((9.9, False), (10.1, True)):
        parts = _cluster(60, 20, collar)
        (check,) = cutting_checks(parts, [Made(place, cutting=ToothCutting.HOBBED) for place in PLACES])
        assert not check.passed
        assert ("of a smaller tool" in check.advice) == named
    smaller = [Made(place, cutting=ToothCutting.HOBBED, cutter=20.0) for place in PLACES]
    assert cutting_checks(_cluster(60, 20, 10.1), smaller)[0].passed


@pytest.mark.slow
def test_the_cures_of_a_stated_tool_hold_and_a_wire_reaches_what_is_cut_apart() -> None:
    def found(*keys: str) -> dict[str, bool]:
        plan = plan_gears(load_design("workshop_car", ["layout=", "frame=", *keys]))
        return {each.code: each.passed for each in plan.checks if each.code in ("tool-room", "teeth-reached")}

    shaped = ["train.cutting=shaped", "train.intermediate.cut_apart="]
    assert found(*shaped) == {CheckCode.TOOL_ROOM: False}
    longer = ["train.intermediate.hub.diameter_mm=10", "train.intermediate.hub.length_mm=3.5"]
    assert found(*shaped, *longer) == {CheckCode.TOOL_ROOM: True}
    assert found("train.cutting=wire", "train.intermediate.cut_apart=") == {CheckCode.TEETH_REACHED: False}
    assert found("train.cutting=wire", "train.intermediate.cut_apart=true") == {}


@pytest.mark.parametrize("keys", [["train.drive.cut_apart=true"], ["train.intermediate.cut_apart=true"]])
def test_gears_that_are_cut_apart_are_two_and_have_a_joint(keys: list[str]) -> None:
    with pytest.raises(DesignError, match="cut_apart"):
        load_design("workshop_car", [*keys, "train.intermediate.joint="])


HEAD = "[train]\nmodule_mm = 1.0\nwidth_mm = 8.0\nbearing_span_mm = 90.0\n"
PAIR = "[[train.stages]]\ndriver = { teeth = 18 }\ndriven = { teeth = 54 }\n"
RING = "[[train.stages]]\ndriver = { teeth = 18 }\ndriven = { teeth = 54, internal = true }\n"
SET = '[[train.stages]]\nkind = "planetary"\nsun = { teeth = 18 }\nplanet = { teeth = 27 }\n'
TWO = PAIR + "[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 60 }\n"


def planned(train: str, keys: str = "", end: str = "") -> GearTrain:
    return plan_gears(train_of(f"{HEAD}{keys}\n{train}{end}", Path("train.toml")))


def out_of_reach(plan: GearTrain) -> list[str]:
    return [f"{each.name}: {each.advice}" for each in plan.failed if each.code == CheckCode.TEETH_REACHED]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("train", "keys", "said"),
    [
        (PAIR, 'cutting = "wire"', ""),
        (PAIR, 'cutting = "wire"\nhelix_angle_deg = 15.0', "helical teeth, cut by wire"),
        (PAIR, 'cutting = "hobbed"\nhelix_angle_deg = 15.0', ""),
        (PAIR.replace("driver", "double = true\ndriver"), 'cutting = "milled"\nhelix_angle_deg = 15.0', "double helix"),
        (PAIR.replace("driver", "double = true\ndriver"), 'cutting = "shaped"\nhelix_angle_deg = 15.0', ""),
        (RING, 'cutting = "hobbed"', ""),
        (RING, 'cutting = "wire"', ""),
        (RING, 'cutting = "hobbed"\noutput = { cutting = "hobbed" }', "inside teeth, hobbed: give train.output"),
        (SET, 'cutting = "milled"', ""),
        (
            f'{SET}ring = {{ cutting = "milled" }}\n',
            "",
            "inside teeth, milled with a disc cutter: give train.stages.1.ring.cutting",
        ),
        (f'{SET}ring = {{ cutting = "wire" }}\n', 'cutting = "hobbed"', ""),
    ],
)  # fmt: skip
def test_teeth_that_a_tool_does_not_reach_fail_with_another_way(train: str, keys: str, said: str) -> None:
    found = out_of_reach(planned(train, keys))
    assert bool(found) == bool(said)
    assert not said or said in found[0]


@pytest.mark.slow
@pytest.mark.parametrize(("train", "place"), [(RING, "train.output.cutting"), (SET, "train.stages.1.ring.cutting")])
def test_a_ring_of_a_hobbed_train_is_taken_as_shaped_and_that_is_told(train: str, place: str) -> None:
    plan = planned(train, 'cutting = "hobbed"')
    ways = {part.gears[0].noun: made.cutting for part, made in zip(plan.layout.parts, plan.makings, strict=True)}
    assert [way for noun, way in ways.items() if "ring" in noun] == [ToothCutting.SHAPED]
    assert {way for noun, way in ways.items() if "ring" not in noun} == {ToothCutting.HOBBED}
    (note,) = (each for each in plan.notes if "taken as shaped" in each)
    assert place in note
    sheets = [sheet for _, sheet in sheets_of(plan, Folder({}, "2026-01-01"))]
    assert sum("Teeth: shaped." in sheet.notes for sheet in sheets) == 1


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ('cutting = "hobbed"\ncutter_diameter_mm = 0.01', ["module 1", "give at least 9", "usual 50"]),
        ('cutting = "milled"\ncutter_diameter_mm = 8.99', ["is 8.99"]),
        ('cutting = "hobbed"\ncutter_diameter_mm = 9.0', []),
        ("cutter_diameter_mm = 20.0", []),
        ('cutting = "wire"\ncutter_diameter_mm = 50.0', ["no teeth are hobbed or milled: remove it"]),
        ('cutting = "shaped"\ncutter_diameter_mm = 50.0', ["remove it"]),
        ('cutting = "wire"\ncutter_diameter_mm = 50.0\ndrive = { cutting = "hobbed" }', []),
    ],
)
def test_a_cutter_is_of_teeth_that_it_cuts_and_larger_than_its_teeth(keys: str, words: list[str]) -> None:
    """Teeth of a tool are 2.25 modules high, and take half of the radius of one of 9 modules."""
    design = f"{HEAD}{keys}\n{PAIR}"
    if not words:
        train_of(design, Path("train.toml"))
        return
    with pytest.raises(DesignError, match=r"train\.cutter_diameter_mm") as refused:
        train_of(design, Path("train.toml"))
    assert all(word in str(refused.value) for word in words)


@pytest.mark.parametrize(
    ("keys", "collar"),
    [
        ("", 1.0),
        ('cutting = "printed"', 1.0),
        ('cutting = "shaped"', 4.0),
        ('cutting = "hobbed"\ncutter_diameter_mm = 20.0', 10.0),
        ('cutting = "hobbed"\ncutter_diameter_mm = 50.0', 24.4),
        ('cutting = "hobbed"\nintermediate = { cutting = "shaped" }', 4.0),
        ('cutting = "hobbed"\nintermediate = { cut_apart = true, joint = "glued" }', 1.0),
    ],
)
def test_a_collar_that_is_not_stated_leaves_a_stated_tool_its_room(keys: str, collar: float) -> None:
    """Ø56 stands 19.3 mm over roots of Ø17.5 less the thinning: √(19.3 · 30.7) = 24.34 mm of a hob of Ø50."""
    plan = planned(TWO, keys)
    part = plan.layout.parts[1]
    assert part.starts[1] - part.gears[0].width == pytest.approx(collar, abs=1e-9)
    assert [each.passed for each in plan.checks if each.code == CheckCode.TOOL_ROOM] in ([], [True])


def test_sheets_and_checks_hear_of_a_printer_alike() -> None:
    plan = planned(TWO, end="[export.print]\nhole_um = 50.0\n")
    assert {made.cutting for made in plan.makings} == {ToothCutting.PRINTED}
    assert sum("grade 7, which no printer keeps" in note for note in plan.notes) == 1
    for stem, sheet in sheets_of(plan, Folder({}, "2026-01-01")):
        assert "plate" in stem or "Teeth: printed or moulded; a printer does not keep grade 7." in sheet.notes
        assert not any("hob" in note for note in sheet.notes)


@pytest.mark.parametrize(
    ("cutting", "grade", "said"),
    [
        (ToothCutting.WIRE, 9, "Teeth: cut by wire; a laser or a jet does not keep grade 9."),
        (ToothCutting.WIRE, 10, "Teeth: cut by wire, laser or jet."),
        (ToothCutting.WIRE, None, "Teeth: cut by wire, laser or jet."),
        (ToothCutting.PRINTED, 9, "Teeth: printed or moulded; a printer does not keep grade 9."),
        (ToothCutting.PRINTED, 10, "Teeth: printed or moulded."),
        (ToothCutting.HOBBED, 7, "Teeth: hobbed."),
    ],
)
def test_of_wire_laser_and_jet_a_fine_grade_leaves_the_wire(
    cutting: ToothCutting, grade: int | None, said: str
) -> None:
    assert next(sheet_notes(_cluster(60, 20, 1.0)[0], Made("drive", cutting=cutting), grade)) == said
