"""Results in a notebook: each has a picture, a line, and its figures."""

import inspect
import sys
from importlib import import_module
from math import radians
from pkgutil import walk_packages
from types import ModuleType
from xml.etree import ElementTree

import numpy as np
import pytest

import cadgen
from cadgen import Cam, Design, DesignError, Gear, GearPair, Motion, Rack, Report, Roller, Spring, dwell, rise
from cadgen.check import Bound, Check, CheckCode, CheckList
from cadgen.figures import JobResult
from cadgen.output.report.notebook import Pictured, Plotted

PINION, WHEEL = (Gear(teeth=teeth, module=1.0, width=5.0) for teeth in (18, 45))


@pytest.fixture(scope="module")
def results():
    """Results of every kind that can be had in a second or two, by name."""
    design, whole = Design.load("carbon_free_car"), Design.load("workshop_car")
    motion = Motion([rise(14, radians(80)), dwell(radians(50)), rise(-14, radians(110)), dwell(radians(120))])
    cam = Cam(motion, Roller(radius=9), base_circle_radius=32, thickness=10)
    comparison = design.optimize()
    return {
        "cam": cam,
        "steering cam": comparison.cam,
        "comparison": comparison,
        "simulation": design.simulate(),
        "tolerance": design.tolerance(50),
        "gear": PINION,
        "pair": GearPair(PINION, WHEEL, backlash=0.1),
        "rack": Rack(teeth=6, module=1.0, width=5.0),
        "lift tolerance": Design.load("roller").with_({"lift_tolerances.base_circle_um": 10.0}).lift_tolerance(50),
        "report": Report.of(design, samples=20),
        "assembly": whole.assembly(),
        "frame": whole.frame(),
    }


NAMES = ("cam", "steering cam", "comparison", "simulation", "tolerance", "gear", "pair", "rack", "lift tolerance")
NAMES = (*NAMES, "report", "assembly", "frame")


def test_every_result_has_a_picture() -> None:
    """Each result that a public function or a method of a public class gives, and each that a further result gives."""
    for module in walk_packages(cadgen.__path__, "cadgen."):
        if module.name.startswith(("cadgen.api.", "cadgen.jobs.")):
            import_module(module.name)
    waiting = [getattr(cadgen, name) for name in cadgen.__all__]
    shown: set[type] = set()
    results = {kind.__name__: kind for kind in _below(JobResult)}
    while waiting:
        each = waiting.pop()
        members = [member for _, member in inspect.getmembers(each)] if inspect.isclass(each) else [each]
        for member in members:
            found = member.fget if isinstance(member, property) else getattr(member, "func", member)
            said = str(getattr(found, "__annotations__", {}).get("return", ""))
            for word in said.replace("[", " ").replace("'", " ").replace('"', " ").split():
                kind = results.get(word.rpartition(".")[2])
                if kind is not None and kind not in shown:
                    shown.add(kind)
                    waiting.append(kind)
    shown |= {kind for kind in _below(JobResult) if kind.__module__.startswith("cadgen.api.")}
    assert len(shown) >= 20
    assert not [kind for kind in shown if not inspect.isabstract(kind) and not issubclass(kind, Plotted)]


def _below(kind: type) -> set[type]:
    return {kind, *(each for below in kind.__subclasses__() for each in _below(below))} - {JobResult, Pictured}


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_a_result_shows_itself_in_a_notebook(results, name):
    result = results[name]
    assert len(repr(result).splitlines()) == 1
    page = result._repr_html_()
    svg = ElementTree.fromstring(page[page.index("<svg") :])
    assert svg.tag.endswith("svg")
    assert page.count("<tr>") >= 3
    assert result.plot().axes


@pytest.mark.slow
def test_forces_over_the_turn_have_their_greatest_values_in_the_picture(results):
    forces = results["cam"].forces(rpm=300, mass=0.5, spring=Spring(rate=5, preload=50))
    upper, lower = forces.plot().axes
    assert np.max(upper.lines[0].get_ydata()) == pytest.approx(forces.normal.greatest, rel=1e-3)
    assert np.max(lower.lines[0].get_ydata()) == pytest.approx(forces.torque.greatest / 1000, rel=1e-3)


@pytest.mark.slow
def test_a_picture_of_gears_has_their_areas_and_no_tooth_in_another(results):
    """The sections by another library: shapely."""
    from shapely.geometry import Polygon

    from cadgen.output.report.gear_pictures import outlines

    parts = results["pair"].computed.layout.parts
    drawn = [Polygon(np.stack([found[0].real, found[0].imag], 1)) for part in parts for _, found in outlines(part)]
    assert drawn[0].intersection(drawn[1]).area < 1e-6
    assert drawn[0].distance(drawn[1]) < 0.1
    for gear, polygon in zip((PINION, WHEEL), drawn, strict=True):
        assert polygon.area * gear.width == pytest.approx(gear.volume, rel=0.02)  # thinned teeth


def test_a_section_is_open_where_the_part_is():
    """Signed areas of what is filled, against the exact volumes: openings run the other way round."""
    chord = 0.01
    turned = (Gear(teeth=20, module=1.0, width=5.0, bore=6.0), Gear(teeth=40, module=1.0, width=5.0, internal=True))
    rack = Rack(teeth=12, module=1.0, width=5.0)
    for gear in turned:
        (patch,) = gear.plot().axes[0].patches
        assert sum(map(_signed, patch.get_path().to_polygons())) == pytest.approx(
            gear.volume / gear.width, abs=chord * gear.tip_diameter * 5
        )
    meshed = rack.meshed(turned[0], 10.05)
    assert repr(meshed) == "<MeshedRack, 12 teeth under a pinion of 20, backlash 0.0364 mm>"
    assert "<svg" in meshed._repr_html_()
    assert meshed.facts()["travel_mm"] == pytest.approx(20 * np.pi)
    bar, pinion = (patch.get_path().to_polygons() for patch in meshed.plot().axes[0].patches)
    assert sum(map(_signed, bar)) == pytest.approx(rack.volume / rack.width, rel=0.01)
    from shapely.geometry import Polygon

    assert Polygon(bar[0]).intersection(Polygon(pinion[0])).area < 1e-3
    assert Polygon(bar[0]).distance(Polygon(pinion[0])) < 0.02


def _signed(ring):
    x, y = ring.T
    return float(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def test_files_and_their_folder_are_told_in_a_line(results, tmp_path):
    written = results["cam"].write(tmp_path, formats=["csv"])
    (tmp_path / "of_mine.txt").touch()
    assert repr(written[0]) == f"<WrittenFile cam_actual.csv, {written[0].bytes} bytes>"
    state = cadgen.verify(tmp_path)
    assert repr(state) == "<FolderState true: 1 as listed, 1 not listed>"
    assert state._repr_html_().count("<tr>") == 3
    written[0].path.write_text("changed")
    assert repr(cadgen.verify(tmp_path)).startswith("<FolderState not true: 1 changed")


def test_a_motion_and_what_is_asked_of_a_cam_have_pictures(results):
    cam = results["cam"]
    wave = Motion(points=[(float(angle), float(1 - np.cos(angle))) for angle in np.arange(6)])
    for each in (wave, cam.lift, cam.profile):
        assert len(repr(each).splitlines()) == 1
        assert each.plot().axes
        assert "<svg" in each._repr_html_()
    few = Motion(points=[(0.0, 0.0), (2.0, 10.0)])
    with pytest.raises(DesignError, match=r"motion\.points"):
        few.plot()
    assert "motion.points" in few._repr_html_()


def test_what_is_stated_says_no_more_than_was_given():
    assert repr(PINION) == "Gear(teeth=18, module=1.0, width=5.0)"
    assert eval(repr(PINION)) == PINION  # such a text can be run


@pytest.mark.slow
def test_a_check_goes_by_its_code(results):
    checks = results["cam"].checks
    assert checks["pressure-angle-rise"] is checks[0]
    assert repr(checks[0]).startswith("<Check pressure-angle-rise: ")
    assert checks[:2] == (checks[0], checks[1])
    with pytest.raises(DesignError, match="no check 'pressure-angle'; there are: pressure-angle-rise, pressure-angle-"):
        checks["pressure-angle"]
    steering = Design.load("s_course").cam("actual").checks
    posts = [check for check in steering if check.code == "course-post"]
    worst = steering["course-post"]
    assert worst.room == min(abs(check.value - check.limit) for check in posts)
    assert checks._repr_html_().count("<tr>") == len(checks) + 1


@pytest.mark.slow
def test_tables_become_frames(results, monkeypatch):
    """Pandas need not be there: its one function is called with plain rows."""
    stand_in = ModuleType("pandas")
    stand_in.json_normalize = list
    monkeypatch.setitem(sys.modules, "pandas", stand_in)
    assert set(results["pair"].tables) == {"stages", "checks", "parts"}
    assert len(results["pair"].to_pandas("parts")) == 2
    assert "ratio" in results["pair"].to_pandas("stages")[0]
    (whole,) = results["gear"].to_pandas()
    assert whole["teeth"] == 18
    assert [row["code"] for row in results["cam"].checks.to_pandas()] == [check.code for check in results["cam"].checks]
    with pytest.raises(DesignError, match="no table 'part'; there are: stages, checks, parts"):
        results["pair"].to_pandas("part")
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(DesignError, match=r"pip install '\.\[notebook\]' in cadgen's folder"):
        results["gear"].to_pandas()


@pytest.mark.slow
def test_viewers_take_parts_as_they_are(results):
    """Attributes that ocp_tessellate asks of a shape: the shape of the kernel, its children, name and colour."""
    from OCP.TopoDS import TopoDS_Compound, TopoDS_Solid

    gear, pair = PINION, results["pair"]
    assert isinstance(gear.wrapped, TopoDS_Solid)
    assert isinstance(pair.wrapped, TopoDS_Compound)
    assert gear.wrapped is gear.wrapped
    assert not gear.children
    assert [part.label for part in pair.children] == ["pair_pinion", "pair_wheel"]
    assert gear.label == "gear"
    assert tuple(gear.color)
    assert gear.location.position.length == 0.0


def test_a_motion_by_an_array_is_shown_in_a_line():
    points = np.stack([np.arange(0.0, 6.2, 0.1), 1 - np.cos(np.arange(0.0, 6.2, 0.1))], axis=1)
    for given in (points, points.tolist()):
        shown = repr(Motion(points=given))
        assert "\n" not in shown
        assert len(shown) < 300


def test_a_check_that_fails_comes_before_one_that_passes():
    posts = [Check(CheckCode.THINNEST_WALL, "wall", value, "mm", 1.0, Bound.MIN) for value in (2.0, float("nan"))]
    for order in (posts, posts[::-1]):
        assert not CheckList(order)["thinnest-wall"].passed
