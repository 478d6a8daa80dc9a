"""Room beyond teeth beside a larger gear, against tools as clouds of points and against printed diameters of hobs."""

from math import cos, inf, pi, radians, sin, tan

import numpy as np
import pytest

from cadgen.check import CheckCode
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.gears.choices import ToothCutting
from cadgen.gears.cutting import Blocked, Made, blocked, cutting_checks, room_notes, sheet_notes, usual_hob
from cadgen.gears.layout import Blanks, TrainPart, lay_out
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned
from cadgen.jobs.gears.gear_train import plan_gears
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub


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
    needed = Blocked(0, gear, beside, 1.0).needs(ToothCutting.HOBBED, 63.0)
    assert needed == pytest.approx(reached, abs=1e-3)
    assert Blocked(0, gear, beside, 1.0).needs(ToothCutting.MILLED, 63.0) == needed


def test_hobs_have_the_diameters_of_the_standard() -> None:
    """DIN 8002, diameters by the module as read from a damaged print, the last by judgement."""
    printed = {1: 50, 1.5: 56, 2: 63, 2.5: 70, 3: 80, 4: 90, 5: 100, 6: 110, 8: 125, 10: 140}
    assert {module: usual_hob(module) for module in printed} == printed


def test_other_tools_need_a_groove_all_or_nothing() -> None:
    stands = Blocked(0, GearForm(teeth=20, normal_module=2.0, width=5.0), 80.0, 1.0)
    assert [stands.needs(each) for each in (ToothCutting.SHAPED, ToothCutting.WIRE, ToothCutting.PRINTED)] == [
        5.0,
        inf,
        0.0,
    ]


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


def test_a_shaft_with_one_gear_or_with_gears_cut_apart_needs_no_room() -> None:
    parts = _cluster(60, 20, 1.0)
    assert not list(blocked(parts[0]))
    apart = [Made("drive"), Made("intermediate", ToothCutting.HOBBED, apart=True, joined="glued"), Made("output")]
    assert cutting_checks(parts, apart) == ()
    assert room_notes(parts, [Made(each.place, None, each.apart) for each in apart]) == ()
    assert list(sheet_notes(parts[1], apart[1])) == ["Teeth: hobbed.", "Lower and upper gear: cut apart, then glued."]


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
    makings = [Made("drive", cutting), Made("intermediate", cutting), Made("output", cutting)]
    checks, notes = cutting_checks(parts, makings), room_notes(parts, makings)
    assert [check.passed for check in checks] == ([] if passes is None else [passes])
    assert len(notes) == (passes is None)
    if notes:
        assert "on shaft 2 end 1 mm before Ø62" in notes[0]
        assert "needs 4 mm" in notes[0]


def test_a_smaller_hob_is_named_where_one_is_small_enough() -> None:
    """Ø62 stands 22.3 mm over the roots of 20 teeth: hobs of Ø50 and of Ø20 need half of their diameter."""
    for collar, named in ((9.9, False), (10.1, True)):
        parts = _cluster(60, 20, collar)
        (check,) = cutting_checks(
            parts, [Made(place, ToothCutting.HOBBED) for place in ("drive", "intermediate", "output")]
        )
        assert not check.passed
        assert ("of a smaller tool" in check.advice) == named
    smaller = [Made(place, ToothCutting.HOBBED, cutter=20.0) for place in ("drive", "intermediate", "output")]
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
