"""`cadgen plan` as a whole: the paper's course against the bars, comments, wheels, and refusals."""

import json
from pathlib import Path

import numpy as np
import pytest

from cadgen import Design
from cadgen.car.planner.constraints import LimitKind, PathLimit
from cadgen.car.planner.kinematics import Basis
from cadgen.car.planner.path_plan import PathPlan, Reason
from cadgen.car.planner.path_task import Margins
from cadgen.car.planner.search import PathSearch, fixed_start
from cadgen.design import cam_model
from cadgen.design.begin import EXAMPLE, text_of
from cadgen.design.load import course_of
from cadgen.errors import CheckError, DesignError
from cadgen.jobs.planning.path_planning import PathPlanning
from cadgen.jobs.planning.task import task_of
from tests.studies import courses

GATES = [f"course.gates.{number}.radius_mm=50" for number in range(1, 13)]
SMALL = f"""
name = "small"            # a course of two gates
{courses.CAR}
[course]
margin_mm = 10.0          # kept
start = {{ at_mm = [0.0, 0.0], heading_deg = 0.0 }}
finish = {{ at_mm = [4000.0, 600.0], radius_mm = 50.0 }}
field = {{ corner_mm = [-600.0, -1500.0], size_mm = [5600.0, 3500.0] }}
gates = [{{ at_mm = [1800.0, -200.0], radius_mm = 30.0 }}]

[[course.posts]]
at_mm = [2600.0, 50.0]
radius_mm = 10.0
"""

NARROW = "corner_mm = [-250.0, -300.0], size_mm = [900.0, 600.0]"
DRAWN = """
[course.spacing]
from_mm = 900.0
to_mm = 1100.0
[settings]
disc_from_mm = -5.0
disc_to_mm = 5.0
head_from_mm = -0.2
head_to_mm = 0.2
wheel_from_mm = 8.0
wheel_to_mm = 25.0
start_within_mm = 30.0
start_heading_within_deg = 5.0
"""


@pytest.fixture(scope="module")
def small():
    return Design.from_toml(SMALL, train_only=True).plan()


@pytest.mark.slow
@pytest.mark.long
def test_the_papers_course_with_gates_of_50_mm():
    """The first direct collocation reached 173 mm, and 130 with the train reordered; today's path ends 306 mm off."""
    today = Design.load()
    planned = Design.load(None, GATES).plan(calm_as=today, reserve=0)
    assert planned.sound
    band = planned.cam.application.comparison.chosen.band
    reordered = planned.design.with_({"optimize.order": "reordered"}).cam()
    print(
        f"{band.worst_distance:.1f} mm, reordered {reordered.application.comparison.chosen.band.worst_distance:.1f} mm"
    )
    assert band.worst_distance <= 173
    assert reordered.comparison.chosen.band.worst_distance <= 130
    assert reordered.sound
    track, before = (cam_model.track(design.values) for design in (planned.design, today))
    slopes, most = (np.abs(each.curvature_jets[:, 1:]).max(axis=0) for each in (track, before))
    assert (slopes <= 1.002 * most).all()
    ends, were = (each.position(np.array([0.0, each.length])) for each in (track, before))
    np.testing.assert_allclose(ends, were, atol=1e-3)
    # The cost to first order, which the search makes least, is the exact one.
    assert planned.computed.plan.path.cost.distance == pytest.approx(band.worst_distance, rel=0.01)


@pytest.mark.slow
@pytest.mark.long
def test_the_papers_path_improved_within_25_mm():
    """By a linear programme on the lateral shift it was 205 mm."""
    today = Design.load()
    planned = today.plan(today, 25, reserve=0)
    distance = planned.cam.application.comparison.chosen.band.worst_distance
    print(f"{distance:.1f} mm")
    assert distance <= 205
    new, old = (cam_model.track(design.values) for design in (planned.design, today))
    points = old.position(np.linspace(0, old.length, 20_001))
    for place in new.position(np.linspace(0, new.length, 500)):
        assert np.hypot(*(points - place).T).min() < 25.01


@pytest.mark.slow
@pytest.mark.long
def test_most_cars_keep_the_course_on_the_plan_that_is_chosen():
    """By play alone the path leads along the edges of the gates, where half of the cars miss each."""
    today = Design.load()
    alone = today.plan(today, 25, reserve=0)
    kept = alone.facts()["yield"]
    assert alone.sentences[0].startswith("fewer cars than on the path before: ")
    assert kept["kept"] < 0.55 < 0.7 < kept["kept_before"]
    assert [each["reserve"] for each in kept["tried"]] == [0]
    plan = today.plan(today, 25)
    print(*plan.sentences, sep="\n")
    chosen = plan.facts()["yield"]
    assert (
        chosen["kept_before"]
        == kept["kept_before"]
        == today.tolerance(10_000, seed=1, profile=chosen["profile"]).passed
    )
    assert chosen["kept"] > chosen["kept_before"]
    assert plan.sentences[0].startswith(f"{100 * chosen['kept']:.1f} % of 10000 cars within the tolerances keep the")
    assert f"where {100 * chosen['kept_before']:.1f} % do on the path before" in plan.sentences[0]
    # What is printed is what `cadgen tolerance` finds on the file that is written.
    assert plan.design.tolerance(10_000, seed=1, profile=chosen["profile"]).passed == chosen["kept"]
    tried = {each["reserve"]: each for each in chosen["tried"]}
    assert list(tried) == [0, 1, 2, 3]
    assert max(each["kept"] for each in tried.values()) - tried[chosen["reserve"]]["kept"] <= 0.002
    assert tried[0]["worst_end_position_mm"] == pytest.approx(
        alone.cam.application.comparison.chosen.band.worst_distance
    )
    assert plan.cam.application.comparison.chosen.band.worst_distance < 1.1 * tried[0]["worst_end_position_mm"]


@pytest.mark.slow
def test_a_course_without_a_path(small, tmp_path):
    assert small.passed, small.sentences
    gap = courses.swept(
        small.computed.text,
        courses.Case(
            "",
            "",
            (),
            (("post", np.array([[2600.0, 50.0]]), 10.0),),
            (np.array([-600, -1500]), np.array([5000, 2000])),
            10,
        ),
    )
    print(gap)
    assert min(gap.values()) > 10 - 0.1
    written = small.write(tmp_path)
    (file,) = [each.path for each in written]
    assert file.name == "small_planned.toml"
    text = file.read_text()
    assert "# a course of two gates" in text
    assert "# kept" in text
    again = Design.load(file)
    assert again.values.path.spline == "b_spline"
    # The whole path is driven before the closing blend, by a wheel that the plan chose.
    track = cam_model.track(again.values)
    assert track.length <= track.turn * (1 - 12 / 360) <= track.length * 1.001
    # Nearly all cars keep it, and there is no path before it.
    facts = small.facts()["yield"]
    assert facts["kept"] > 0.99
    assert facts["kept_before"] is None
    assert "path before" not in small.sentences[0]
    assert set(facts["scatter_mm"]) == {"course.gates.1", "course.posts.1", "course.field", "course.finish"}
    entry = json.loads((tmp_path / "manifest.json").read_text())["parts"]["small_planned"]
    assert entry["passed"]
    assert entry["drive_wheel_radius_mm"] == again.values.car.drive_wheel_radius_mm


@pytest.mark.slow
@pytest.mark.long
def test_a_course_that_cannot_be_driven_is_told_with_its_cure(tmp_path):
    short = Design.from_toml(SMALL, train_only=True).with_({"car.drive_wheel_radius_mm": 12.0})
    plan = short.plan()
    print(*plan.sentences, sep="\n")
    assert not plan.passed
    assert plan.sentences[0].startswith("the course cannot be driven: the path is ")
    assert "mm longer than wheel and train drive before the closing blend" in plan.sentences[0]
    wheel = float(plan.sentences[0].rpartition("raise car.drive_wheel_radius_mm to ")[2])
    with pytest.raises(CheckError, match="the course cannot be driven"):
        plan.write(tmp_path)
    assert not list(Path(tmp_path).iterdir())
    cured = short.with_({"car.drive_wheel_radius_mm": round(wheel * 1.01, 2)}).plan()
    assert cured.passed
    assert cured.design.values.car.drive_wheel_radius_mm == round(wheel * 1.01, 2)
    assert cured.design.values.overrides == ()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (SMALL.partition("[course]")[0], "no course to plan a path for: add"),
        (SMALL.replace("start = {", "# start = {"), "course.start is missing: add"),
        (SMALL.replace("finish = {", "# finish = {").replace("gates = [", "# gates = ["), "nothing to drive to"),
        (SMALL.replace("wheelbase_mm = 167.0\n", ""), "car.wheelbase_mm is missing"),
        (SMALL + "[path]\nwaypoints_mm = 3\n", "path.waypoints_mm is 3"),
    ],
)
def test_what_cannot_be_planned_is_refused_by_its_key(text, words):
    with pytest.raises(DesignError, match=words):
        Design.from_toml(text, train_only=True).plan()


def test_a_distance_without_a_path_is_refused():
    with pytest.raises(DesignError, match="within_mm says how far a given path may be left"):
        Design.load().plan(within_mm=10)


def test_a_post_on_the_start_is_refused():
    text = SMALL.replace("at_mm = [2600.0, 50.0]", "at_mm = [10.0, 20.0]")
    with pytest.raises(
        DesignError, match=r"course\.posts\.1 stands on the car at its start, .*: move the post, or the start"
    ):
        Design.from_toml(text, train_only=True).plan()


@pytest.mark.parametrize(
    ("amount", "words"),
    [
        (9.0, "move course.posts.1 by 9.1 mm, or lower course.margin_mm by that"),
        (9.96, "move course.posts.1 by 10.1 mm"),
        (11.0, "move course.posts.1 by 11.1 mm"),
    ],
)
def test_no_less_than_no_margin_is_advised(amount, words):
    """The design asks for 10 mm; after a check has failed the planner itself keeps more."""
    design = course_of(SMALL, Path("small.toml"), ())[0]
    task = task_of(design, drawn=None, near=None, within=0.0, calm=None, tightening=Margins(margin=3.0))
    assert task.course.margin == 13
    basis = Basis(16)
    path = PathSearch(task, basis, fixed_start(basis, (False, None)), lambda _: []).path(
        np.outer(np.arange(16.0), [9, 1])
    )
    reason = Reason(PathLimit(LimitKind.CLEARANCE, "course.posts.1"), amount, (0.0, 0.0), enough=True)
    found = PathPlanning(
        asked=design, task=task, plan=PathPlan(path, task, path.points), text="", cam=None, reasons=(reason,)
    )
    assert found.sentences[0].endswith(f"least change that does: {words}")


@pytest.mark.long
@pytest.mark.slow
def test_a_field_in_which_the_car_cannot_turn_round_is_named():
    text = SMALL.replace("corner_mm = [-600.0, -1500.0], size_mm = [5600.0, 3500.0]", NARROW).partition("gates = [")[0]
    back = "at_mm = [300.0, 0.0], radius_mm = 50.0, heading_deg = 180.0"
    plan = Design.from_toml(text.replace("at_mm = [4000.0, 600.0], radius_mm = 50.0", back), train_only=True).plan()
    print(plan.sentences)
    (sentence,) = plan.sentences
    assert "course.field is too small for the car to turn round in: with 35 degrees of steering" in sentence
    assert "the field holds one of 300 mm: make the field 1" in sentence
    assert "or raise car.max_steering_angle_deg to " in sentence


@pytest.mark.slow
@pytest.mark.long
def test_a_course_whose_spacing_is_drawn_and_runs_with_play_judged():
    plan = Design.from_toml(SMALL + DRAWN, train_only=True).with_({"course.judged": "play"}).plan()
    print(*plan.sentences, sep="\n")
    assert plan.passed
    for checks in (plan.cam.checks, plan.computed.drawn[0].checks):
        of_course = [check for check in checks if check.code.startswith("course")]
        played = {check.code: check for check in of_course if check.code.endswith("play")}
        assert {"course-post-play", "course-gates-play", "course-finish-play"} <= set(played)
        assert all(np.isfinite(check.limit) and check.passed for check in played.values())
    assert [each.spacing for each in plan.computed.drawn] == [900, 950, 1000, 1050, 1100]
    assert plan.sentences[-1] == "cadgen card has the settings for every spacing"
    assert plan.facts()["settings"][0]["spacing_mm"] == 900
    text = SMALL + DRAWN.partition("[settings]")[0]
    with pytest.raises(DesignError, match="settings is missing"):
        Design.from_toml(text, train_only=True).plan()


@pytest.mark.slow
def test_advice_names_the_key_of_the_path():
    sharp = ["checks.pressure_angle_limit=norton_translating"]
    planned = Design.load(Path(__file__).parents[1] / "data" / "draws" / "s_course.toml", sharp)
    paper = Design.load(None, ["cam.base_radius_mm=40"])
    for design, key in ((planned, "path.control_points_mm"), (paper, "path.waypoints_mm")):
        advice = " ".join(check.advice for check in design.cam("actual").failed)
        assert f"widen the turn there ({key})" in advice
        assert advice.count("_mm)") == advice.count(key)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(("left", "right"), [(37.0, 201.0), (-37.0, -201.0), (60.0, 180.0), (0.0, 120.0)])
def test_a_line_of_posts_for_cars_driven_on_either_side_or_in_the_middle(left, right):
    """One was refused for 4 um of a post, and one for a closing blend that was too steep for its rod."""
    posts = "".join(
        f'[[course.posts]]\nat_mm = [{1000.0 * k}, 0.0]\nradius_mm = 10.0\nside = "{"left" if k % 2 else "right"}"\n'
        for k in range(1, 7)
    )
    text = begun("line", left, right).replace("[course.field]", posts + "[course.field]", 1)
    plan = Design.from_toml(text, train_only=True).plan(reserve=0)
    print(*plan.sentences[:2], sep="\n")
    assert plan.sound, plan.sentences


def begun(name, left, right):
    """A design as `cadgen new` begins it, for a car of two offsets, with a course of posts and without a path."""
    text = text_of(name, EXAMPLE, [0.0] * len(EXAMPLE), (left + right) / 2, 50.0, None, closed=False)
    head, _, rest = text.partition("[path]")
    rest = "[car]" + rest.partition("[car]")[2]
    mechanism, _, train = rest.partition("# The gears between")
    train = "\n".join(line.removeprefix("# ") for line in train.partition("\n")[2].splitlines() if line != "#")
    mechanism = mechanism.replace("offset_mm = 37.0", f"offset_mm = {left}").replace("= 201.0", f"= {right}")
    course = """[course]
margin_mm = 10.0
start = { at_mm = [0.0, 0.0], heading_deg = 0.0 }
finish = { at_mm = [7000.0, 0.0], radius_mm = 100.0 }

[course.field]
corner_mm = [-600.0, -1000.0]
size_mm = [8400.0, 2000.0]

"""
    return head + course + mechanism + train
