"""One verdict on a cam: by its checks, the cars that keep its course, and what is left open."""

import json
import re
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import pytest

from cadgen import Design, glossary
from cadgen.check import CheckCode
from cadgen.design.load import packaged_designs
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.readiness import GOOD_YIELD, SAMPLE, SEED, wheel_checks
from cadgen.jobs.cam.steering_cam import comparison_of
from cadgen.verdict import Readiness
from tests.conftest import UNBRAKED

ROOT = Path(__file__).parents[2]
CODES = {
    "appendix_car": (Readiness.NOT_READY, {"friction-not-stated", "cars-lost", "blend-on-path"}),
    "carbon_free_car": (Readiness.RESERVATIONS, {"friction-not-stated", "cars-lost", "blend-on-path"}),
    "figure_eight": (Readiness.READY, set()),
    "posts_and_walls": (Readiness.READY, set()),
    "s_course": (Readiness.READY, set()),
    "workshop_car": (Readiness.READY, set()),
}


@cache
def packaged(name):
    """Cam of a packaged design, planned once."""
    return Design.load(name).cam()


def codes(verdict):
    return {reservation.code for reservation in verdict.reservations}


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(CODES))
def test_the_verdict_of_each_packaged_design(name):
    verdict = packaged(name).verdict
    assert (verdict.readiness, codes(verdict)) == CODES[name]
    assert all(reservation.text and reservation.cure for reservation in verdict.reservations)
    # As docs/play.md has it.
    page = (ROOT / "docs/play.md").read_text("utf-8")
    said, kept, more = re.search(rf"^\| `{name}` \| (.*) \| (\d+) % \| (.*) \|$", page, re.MULTILINE).groups()
    (cars,) = (check.value for check in verdict.checks if check.code == CheckCode.CARS_KEEP_COURSE)
    costs = {each.code: each.cost.value for each in verdict.reservations}
    assert (said, kept) == (verdict.readiness.words, f"{cars:.0f}")
    assert ("friction" in more, "blend" in more) == ("friction-not-stated" in costs, "blend-on-path" in costs)
    for code, words in (
        ("friction-not-stated", "friction ({:.0f} mm)"),
        ("blend-on-path", "the blend ends {:.0f} mm off"),
    ):
        assert code not in costs or words.format(costs[code]) in more


@pytest.mark.long
@pytest.mark.slow
def test_every_term_of_the_lines_on_a_packaged_design_is_explained_in_the_first_steps(capsys):
    """A term is a heading of the glossary."""
    from cadgen.cli import show

    for name in packaged_designs():
        print(*show.summary(Design.load(name).cam()))
    said = " ".join(capsys.readouterr().out.split())
    used = {term for term in glossary.terms() if re.search(rf"\b{re.escape(term)}s?\b", said, re.IGNORECASE)}
    rows = re.findall(r"^\| ([^|]+) \| [^|]+ \|$", (ROOT / "docs/first-steps.md").read_text("utf-8"), re.MULTILINE)
    explained = {re.sub(r"\[(.*?)\].*", r"\1", word) for row in rows for word in re.split(r"[,;] ", row)}
    # The lines lead a path with more room, and an acceleration jumps: verbs, and not the lead and the jump of a cam.
    used -= {"cam", "ready", "follower", "stage", "tolerance", "lead", "jump"}
    # Words that `cadgen explain` has, which the page names: they are read without the table, or stand in its rows.
    used -= {"actual", "optimized", "tightest", "keep the course", "disc", "bore", "cutter", "groove"}
    used -= {"polar angle", "convex radius", "convex radius, theory", "largest cutter radius"}
    # A check's name of two words is explained where both are.
    used -= {name for name in used if set(name.split(", ")) <= explained}
    assert used <= explained | {"blend"}
    assert "closing blend" in explained
    assert "cadgen explain" in (ROOT / "README.md").read_text("utf-8")


def test_a_plain_cam_that_no_car_keeps_the_course_with_is_not_ready():
    """The play of the paper's train takes the car past its gates: the cam is right, and nobody should cut it."""
    cam = Design.load("carbon_free_car").cam("actual")
    (failed,) = cam.failed
    assert (failed.code, failed.limit, failed.place) == (
        CheckCode.CARS_KEEP_COURSE,
        25.0,
        "course.gates.7, which 0.0 % keep",
    )
    assert failed.value < 0.5
    assert cam.sound
    assert not cam.passed


def test_the_share_of_cars_is_that_of_a_tolerance_run_with_the_same_cars():
    (check,) = [each for each in packaged("s_course").verdict.checks if each.code == CheckCode.CARS_KEEP_COURSE]
    run = Design.load("s_course").tolerance(SAMPLE, seed=SEED)
    assert check.value == pytest.approx(100 * run.passed)


def test_the_cure_for_lost_cars_was_counted():
    """With the tolerance that it names at half the design keeps as many cars as it says."""
    design = Design.load("s_course", UNBRAKED).with_({"layout": None, "frame": None})
    (lost,) = (each for each in design.cam().verdict.reservations if each.code == "cars-lost")
    said = r"hold tolerances\.(\w+) at (\S+) in place of (\S+), with which (\S+) % keep the course"
    key, half, now, kept = re.match(said, lost.cure).groups()
    assert float(half) == pytest.approx(float(now) / 2)
    verdict = design.with_({f"tolerances.{key}": float(half)}).cam().verdict
    (check,) = (each for each in verdict.checks if each.code == CheckCode.CARS_KEEP_COURSE)
    assert f"{check.value:.1f}" == kept
    assert check.value >= 101 - lost.cost.value


@pytest.mark.slow
@pytest.mark.long
def test_the_cures_at_a_finish_were_counted():
    """Scatter asks for a wider disc, a path that ends beside the middle for its middle, a wrong heading for that."""
    plain = Design.load("workshop_car", ["layout=", "frame="])

    def kept(x, y, **keys):
        changed = plain.with_({"course.finish": {"at_mm": [x, y], "radius_mm": 30.0, **keys}})
        (check,) = (each for each in changed.cam().verdict.checks if each.code == CheckCode.CARS_KEEP_COURSE)
        return check.value, check.advice

    met, wider = kept(6703.79, 7200.0)
    said = re.search(r"raise course\.finish\.radius_mm to (\d+), with which (\S+) % keep", wider)
    assert f"{kept(6703.79, 7200.0, radius_mm=float(said[1]))[0]:.1f}" == said[2]
    beside, nearer = kept(6713.79, 7235.0)
    said = re.search(r"let the path end in the middle of course\.finish.*with which (\S+) % keep", nearer)
    assert beside < met == pytest.approx(float(said[1]), abs=1.5)
    none, turned = kept(6703.79, 7200.0, heading_deg=180.0, heading_tolerance_deg=5.0)
    assert none == 0
    assert "in the direction of course.finish.heading_deg" in turned


def test_cars_that_only_play_moves_are_told_of_the_gears():
    """With a wide band of play and no tolerance half of its spread brings cars in; the cam stays as it is."""
    design = Design.load("s_course", UNBRAKED).with_({"tolerances": None, "layout": None, "frame": None})
    verdict = design.with_({"play.least_deg": 0.2, "play.greatest_deg": 1.4}).cam().verdict
    (lost,) = (each for each in verdict.reservations if each.code == "cars-lost")
    assert lost.cure.startswith("take gears whose play varies half as much, with which ")


@pytest.mark.slow
@pytest.mark.long
def test_a_trim_is_a_cure_where_a_brake_holds_the_cam():
    """A trial run takes out disc and rod that are too large all round; cars are counted as it says."""
    design = Design.load("s_course").with_({"optimize.hardware": None, "frame": None})
    verdict = design.cam().verdict
    (lost,) = (each for each in verdict.reservations if each.code == "cars-lost")
    (kept,) = re.findall(r'set optimize\.hardware to \["trim"\].*: (\S+) % then keep the course', lost.cure)
    trimmed = design.with_({"optimize.hardware": ["trim"]}).cam().verdict
    assert trimmed.readiness == Readiness.READY
    (check,) = (each for each in trimmed.checks if each.code == CheckCode.CARS_KEEP_COURSE)
    assert f"{check.value:.1f}" == kept


def test_the_least_share_is_the_designs_own():
    design = Design.load("s_course").with_({"checks.min_yield_percent": 95.0})
    verdict = design.cam().verdict
    assert [check.code for check in verdict.failed] == [CheckCode.CARS_KEEP_COURSE]
    assert "cars-lost" not in codes(verdict)  # said once, as what fails
    assert GOOD_YIELD == 90.0


@pytest.mark.slow
@pytest.mark.long
def test_a_tolerance_too_wide_to_count_cars_by_is_not_ready():
    """Many cars are reckoned to first order; where that does not hold, nobody knows how many keep the course."""
    verdict = Design.load("s_course").with_({"tolerances.steering_zero_deg": 5.0}).cam().verdict
    (failed,) = verdict.failed
    assert (failed.code, failed.place) == (CheckCode.CARS_KEEP_COURSE, "cannot be counted")
    assert "tolerances.steering_zero_deg is 5 degrees" in failed.advice
    assert "make it 0.19 degrees or less" in failed.advice
    held = Design.load("s_course").with_({"tolerances.steering_zero_deg": 0.19}).cam().verdict
    assert all(check.place != "cannot be counted" for check in held.checks)


def test_what_a_design_does_not_state_is_a_reservation():
    bare = Design.load("s_course", UNBRAKED).with_({"tolerances": None})
    assert "tolerances-not-stated" in codes(bare.cam().verdict)
    without = Design.load("carbon_free_car").with_({"train": None, "course": None, "tolerances": None})
    assert "play-not-stated" in codes(without.cam().verdict)


def test_the_cure_of_a_blend_on_the_path_names_a_wheel_that_does():
    design = Design.load("carbon_free_car")
    (blend,) = [each for each in packaged("carbon_free_car").verdict.reservations if each.code == "blend-on-path"]
    (radius,) = re.findall(r"set car.drive_wheel_radius_mm to ([\d.]+), for a wheel", blend.cure)
    cured = design.with_({"car.drive_wheel_radius_mm": float(radius)}).cam().verdict
    assert "blend-on-path" not in codes(cured)


def test_what_the_car_misses_on_the_blend_is_a_reservation():
    # The last waypoint lies on the blend, which ends elsewhere: a gate there is not judged, but said.
    bare = Design.load("carbon_free_car").with_(
        {"train": None, "tolerances": None, "course": None, "car.drive_wheel_radius_mm": None}
    )
    end = bare.values.path.waypoints_mm[-1]
    for radius, missed in ((500.0, False), (1.0, True)):
        gate = {"at_mm": list(end), "radius_mm": radius}
        verdict = bare.with_({"course": {"gates": [gate]}}).cam().verdict
        assert ("course-on-blend" in codes(verdict)) == missed


@pytest.mark.parametrize(
    ("diameter", "readiness", "code"),
    [
        (130.0, Readiness.RESERVATIONS, "wheel-of-outline"),
        (90.0, Readiness.NOT_READY, None),  # said once, as what fails
    ],
)
def test_the_wheel_of_the_outline_is_held_against_the_wheel_of_the_cam(diameter, readiness, code):
    verdict = Design.load("s_course").with_({"car.outline.wheel_diameter_mm": diameter}).cam().verdict
    assert verdict.readiness == readiness
    assert ("wheel-of-outline" in codes(verdict)) == (code is not None)
    if readiness == Readiness.NOT_READY:
        (failed,) = verdict.failed
        assert failed.code == CheckCode.DRIVE_WHEEL_OUTLINE
        assert "137.6 mm, car.outline.wheel_diameter_mm is 90" in failed.place
        assert "take a [train] of 22.93 turns of the drive wheel" in failed.advice


def wheel(radius):
    """A car of the paper's wheelbase without an outline, whose cam needs a wheel of this radius, mm."""
    return SimpleNamespace(
        drive_wheel=SimpleNamespace(radius=radius),
        car=SimpleNamespace(wheelbase=167.0),
        outlined_wheel=None,
        travel=1.0,
    )


@pytest.mark.parametrize(
    ("radius", "failed"),
    [(64.0, None), (15_000.0, CheckCode.DRIVE_WHEEL_GREATEST), (1.0, CheckCode.DRIVE_WHEEL_LEAST)],
)
def test_a_wheel_that_no_car_has_is_not_ready(radius, failed):
    """A wheel of 30 m, and one of 2 mm, on a wheelbase of 167 mm."""
    assert [check.code for check in wheel_checks(wheel(radius)) if not check.passed] == ([failed] if failed else [])


def test_gates_are_never_invented():
    """Without [course] no share of cars is told; a width of gates that the design states is kept."""
    design = Design.load("carbon_free_car").with_({"course": None})
    run = design.tolerance(200)
    assert run.passed is None
    assert run.facts()["yield"] is None
    assert not [check for check in run.cam.verdict.checks if check.code == CheckCode.CARS_KEEP_COURSE]
    stated = design.with_({"tolerances.gate_width_mm": 400.0}).tolerance(200)
    assert (stated.gates, stated.gate_width) == (11, 400.0)
    assert stated.passed is not None
    narrow = design.with_({"tolerances.gate_width_mm": 100.0}).tolerance(200)
    assert 0 < narrow.passed < stated.passed


def test_all_commands_have_the_same_verdict(tmp_path):
    design = Design.load("workshop_car").with_({"optimize.hardware": None})  # cars are lost
    cam = design.cam()
    wanted = cam.facts()["verdict"]
    assert wanted["readiness"] == "ready-with-reservations"
    assert wanted["reservations"][0]["cost_unit"] == "%"
    manifest = json.loads((cam.write(tmp_path, formats=["xyz"]).folder / "manifest.json").read_text())
    assert wanted in [part["verdict"] for part in manifest["parts"].values()]
    assert design.tolerance(50).cam.verdict.entry().json() == cam.verdict.entry().json()


# A random walk whose return needs a pressure angle of 35.7 degrees: the smoothed profile keeps 35, and ends 446 mm off.
STEEP = (
    (695.2, 5465.8),
    (500.0, 4749.3),
    (809.8, 3818.7),
    (1242.3, 3180.9),
    (1426.8, 2630.7),
    (2019.4, 2158.0),
    (2356.4, 1419.5),
    (2915.7, 838.4),
    (3413.1, 687.4),
    (4118.3, 500.0),
)


@pytest.fixture
def steep(tmp_path):
    points = tmp_path / "points.csv"
    points.write_text("\n".join(f"{x} {y}" for x, y in STEEP))
    design = Design.new("steep", tmp_path, points=points, train=True, changes={"car.outline.wheel_diameter_mm": 65})
    return design.with_({"cam.base_radius_mm": 70})


@pytest.mark.long
@pytest.mark.slow
def test_a_profile_that_loses_every_car_is_not_taken_for_a_missed_pressure_angle(steep):
    """The plain profile brings 94 % of the cars in and misses the angle by 0.7 degrees, which a cure mends."""
    cam = steep.cam()
    (check,) = cam.verdict.failed
    assert check.code == CheckCode.PRESSURE_ANGLE_RETURN
    assert "the smoothed profile keeps that, but ends 446 mm off at most, and fails cars that keep" in check.advice
    assert any("taken in the end, though it fails" in reason for reason in comparison_of(cam).reasons)
    (change, value) = find_cures(cam).proved[0].override.split("=")
    assert steep.with_({change: float(value)}).cam().verdict.passed


@pytest.mark.slow
@pytest.mark.long
def test_without_a_course_the_nearer_profile_that_was_refused_is_a_reservation(steep):
    cam = steep.with_({"course": None}).cam()
    held = next(each for each in cam.verdict.reservations if each.code == "nearer-profile-refused")
    assert cam.passed
    assert held.cost.value == pytest.approx(446.0, abs=0.1)
    assert held.text.endswith("ends 0 mm off at most, and this one 446, but it fails pressure angle, return")
