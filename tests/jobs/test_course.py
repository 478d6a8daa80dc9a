"""Courses in the checks of a cam, in runs with play and over many cars; cars as mirror images."""

from dataclasses import replace
from math import degrees

import numpy as np
import pytest

from cadgen import Design
from cadgen.car.course.judge import passages
from cadgen.car.running.drive import STEPS
from cadgen.check import CheckCode
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.deviations.deviation import COLUMNS
from cadgen.inference.monte_carlo.cars import run_cars
from cadgen.inference.monte_carlo.course_margins import margins_at
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.nominal_car import cars_of, watching
from tests.conftest import UNBRAKED

pytestmark = pytest.mark.slow

POSTS = "course.posts=[{at_mm=[2900, 600], radius_mm=10, side='left'}, {at_mm=[1500, 3300], radius_mm=10}]"
OUTLINE = "car.outline={length_mm=260, width_mm=260, front_overhang_mm=60, wheel_diameter_mm=127, wheel_width_mm=4}"


@pytest.fixture(scope="module")
def plan():
    return plan_cam(load_design(None, [OUTLINE, POSTS]))


COLUMN = {name: k for k, name in enumerate(COLUMNS)}


def driven(plan, row, play):
    """Exact run of a car whose play and start differ by a row of deviations from the nominal one with this play."""
    comparison = plan.application.comparison
    start = comparison.task.start
    ahead = np.exp(1j * start.heading) * (row[COLUMN["start_x"]] + 1j * row[COLUMN["start_y"]])
    heading = start.heading + row[COLUMN["start_heading"]]
    moved = replace(start, x=start.x + ahead.real, y=start.y + ahead.imag, heading=heading)
    task = replace(comparison.task, start=moved)
    return plan.application.course.played(replace(comparison, task=task), play + row[COLUMN["play"]])


def of(checks, code):
    (found,) = (check for check in checks if check.code == code)
    return found


@pytest.mark.slow
def test_the_papers_car_passes_its_gates_as_planned_and_misses_some_with_play(plan):
    """Eleven within 1.6 mm before the blend, the last within 5 by it; with play the figures are shown, not judged."""
    planned = plan.application.course.planned
    margins = {passage.gate.key: passage.off for passage in planned.driven.passages}
    print({key: round(off, 2) for key, off in margins.items()})
    assert len(margins) == 11
    assert max(margins.values()) < 1.6
    (last,) = planned.blend.passages
    assert last.gate.key == "course.gates.12"
    assert last.off < 5.0
    assert of(plan.checks, CheckCode.COURSE_BLEND).value == pytest.approx(last.margin)
    assert of(plan.checks, CheckCode.COURSE_GATES).passed
    shown = of(plan.checks, CheckCode.COURSE_GATE_MARGIN_PLAY)
    assert shown.value < -50
    assert shown.passed


def test_a_post_on_the_wrong_side_fails_and_is_named(plan):
    wrong = of(plan.checks, CheckCode.COURSE_SIDE)
    assert not wrong.passed
    assert wrong.place == "course.posts.1 is not passed on its left"
    assert not plan.passed


def test_with_play_the_course_is_judged_where_that_is_asked(plan):
    """The same figures with a limit: no second computation of the profile is needed to see it."""
    on = plan.application.course
    judged = replace(on, course=replace(on.course, judged="play"))
    free, held = (
        one.played(plan.application.comparison, plan.application.comparison.chosen.band.plays[-1]).checks()
        for one in (on, judged)
    )
    assert [check.value for check in free] == [check.value for check in held]
    assert not of(held, CheckCode.COURSE_GATES_PLAY).passed
    assert of(held, CheckCode.COURSE_POST_PLAY).passed


def test_many_cars_are_held_against_the_course_as_one_car_is(plan):
    """Cars that differ in play and start alone, each driven exactly and judged by the sweep."""
    comparison, planned = plan.application.comparison, plan.application.course.planned
    fleet = watching(cars_of(plan.application, plan.curve, [STEPS], None, comparison.chosen.play), planned)
    rng = np.random.default_rng(1)
    deviations = np.zeros((12, len(COLUMNS)))
    low, high = comparison.band.ends
    deviations[:, COLUMN["play"]] = rng.uniform(low, high, 12) - fleet.play
    for name, size in (("start_x", 2.0), ("start_y", 5.0), ("start_heading", 0.003)):
        deviations[:, COLUMN[name]] = rng.uniform(-size, size, 12)
    poses = run_cars(fleet, deviations)
    met = margins_at(fleet.items, poses.heading, poses.position, (fleet.planned.heading, fleet.planned.position))
    quick = met.margins.min(axis=0)
    exact = []
    for row in deviations:
        run = driven(plan, row, fleet.play)
        gates = passages(run.poses, run.on.car, run.on.course.gates[:11])
        clear = [there.clearance for _, there in run.driven.approaches]
        exact.append(min([passage.margin for passage in gates] + clear))
    worst = np.abs(quick - exact)
    print(f"margins {np.round(exact, 1)}, off by {worst.max():.2f} mm")
    # An exact car counts as failing where a quick one does; margins agree to what bends the track between.
    assert ((quick >= 0) == (np.array(exact) >= 0)).all()
    assert (worst <= 1.0 + 0.02 * np.abs(exact)).all()


def test_many_cars_are_held_against_the_finish_as_one_car_is():
    """The plan ends 14 mm within the finish: cars that start off or have another play end in it or beyond."""
    plan = plan_cam(load_design("s_course", UNBRAKED), "actual", with_play=True)
    comparison = plan.application.comparison
    fleet = watching(
        cars_of(plan.application, plan.curve, [STEPS], None, comparison.chosen.play), plan.application.course.planned
    )
    (number,) = (k for k, item in enumerate(fleet.items) if item.key == "course.finish")
    rng = np.random.default_rng(1)
    deviations = np.zeros((8, len(COLUMNS)))
    deviations[:, COLUMN["start_x"]], deviations[:, COLUMN["start_y"]] = rng.uniform(-20.0, 20.0, (2, 8))
    deviations[:, COLUMN["start_heading"]] = rng.uniform(-0.003, 0.003, 8)
    deviations[:, COLUMN["play"]] = rng.uniform(*comparison.band.ends, 8) - fleet.play
    poses = run_cars(fleet, deviations)
    met = margins_at(fleet.items, poses.heading, poses.position, (fleet.planned.heading, fleet.planned.position))
    exact = []
    for row in deviations:
        run = driven(plan, row, fleet.play)
        exact.append(run.on.course.finish.place.reach - run.driven.finish.off)
    print(np.round(met.margins[number], 2), np.round(exact, 2))
    np.testing.assert_allclose(met.margins[number], exact, atol=0.05)
    assert min(exact) < 0 < max(exact)


def test_a_finish_of_a_place_alone_is_none_that_cars_are_counted_by():
    """Where only the place is given, a course of such a finish alone has no share of cars; a stated radius has one."""
    changes = ["car.drive_wheel_radius_mm=70", "course={finish={at_mm=[6703.79, 7200]}}"]
    run = Design.load(None, changes).tolerance(50, profile="actual")
    assert (run.watched, run.passed) == ("", None)
    within = [
        Design.load(None, [*changes, f"course.finish.radius_mm={radius}"]).tolerance(50, profile="actual").passed
        for radius in (3.0, 5.0, 6.0, 300.0)
    ]
    assert within == sorted(within)
    assert within[0] < 1
    wider = Design.load(None, [*changes, "course.finish.radius_mm=1300"]).tolerance(50, profile="actual")
    assert wider.watched == "the finish"
    assert 0 < wider.passed < 1


def test_with_a_wheel_the_run_is_judged_to_the_finish():
    design = load_design(
        None, ["car.drive_wheel_radius_mm=70", "course.finish={at_mm=[6703.79, 7200], radius_mm=1300}"]
    )
    plan = plan_cam(design, "actual")
    assert plan.sound
    assert plan.application.drive_wheel.blend is None
    assert plan.application.steering.blend_start == pytest.approx(plan.application.track.length / (70.0 * 45.0))
    assert plan.application.course.stop == plan.application.steering.blend_start
    assert plan.application.drive_wheel.sentence().startswith(
        "Drive wheel: radius 70.000 mm, the car goes 19792 mm in a turn"
    )
    assert of(plan.checks, CheckCode.COURSE_FINISH).value == pytest.approx(1.5, abs=0.01)
    # The lift at the finish is that of the path's end: nothing of it is left to the blend.
    bare = plan_cam(load_design(None, ["car.drive_wheel_radius_mm=70", "course="]), "actual")
    end = cam_model.cam_angle(design, plan.application.track, np.array([plan.application.track.length]))[0]
    print(f"finish at {degrees(end):.2f} degrees")
    assert end == pytest.approx(plan.application.steering.blend_start)
    assert bare.application.steering.blend_start == plan.application.steering.blend_start


def test_without_a_radius_the_wheel_is_that_of_the_whole_turn(plan):
    wheel = plan.application.drive_wheel
    assert wheel.radius == pytest.approx(plan.application.track.length / (2 * np.pi * 45.0))
    assert wheel.sentence().startswith("Drive wheel: radius 63.683 mm")
    assert wheel.blend.stretch == pytest.approx(plan.application.track.length * 12 / 360)
    assert wheel.blend.off < 10


@pytest.mark.slow
def test_a_mirrored_car_has_the_same_cam_on_its_other_side():
    """Path, wheels and cam mirrored: the lift is the same, and the run with play the mirror image."""
    plain = load_design(None, ["course="])
    path = [[x, -y] for x, y in plain.path.waypoints_mm]
    car, offset = plain.car, plain.path.offset_mm
    mirrored = load_design(
        None,
        [
            "course=",
            f"path.waypoints_mm={path}",
            f"path.offset_mm={-offset}",
            f"car.drive_wheel_offset_mm={-car.drive_wheel_offset_mm}",
            f"car.idle_wheel_offset_mm={-car.idle_wheel_offset_mm}",
            "cam.side=right",
            "blank.hub={diameter_mm=16, length_mm=6}",
        ],
    )
    a, b = plan_cam(plain, "compensated"), plan_cam(mirrored, "compensated")
    angle = np.linspace(0, 2 * np.pi, 1000)
    np.testing.assert_allclose(a.application.steering.q(angle), b.application.steering.q(angle), atol=1e-12)
    for wheel in ("drive_wheel", "front_wheel", "idle_wheel"):
        runs = [getattr(each.application.comparison.chosen.run, wheel) for each in (a, b)]
        np.testing.assert_allclose(runs[0] * [1, -1], runs[1], atol=1e-6)
    # On the car the hub is on the outer face; files show the disc from the car's left, where that is behind.
    assert (b.blank.hub.side, b.made_blank.hub.side) == ("outer", "inner")
