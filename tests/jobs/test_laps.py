"""Closed paths: laps that close, drift by play against a derivation of its own, limit cases, and what is refused."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, degrees, hypot, pi, radians, sin
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tomli_w

from cadgen.arrays import TURN
from cadgen.car.against_play.laps import Drift, drift
from cadgen.car.planner.path_task import Margins
from cadgen.car.running.drive import drive
from cadgen.check import CheckCode
from cadgen.design import cam_model
from cadgen.design.load import design_of, load_design, with_overrides
from cadgen.design.schema import Design
from cadgen.deviations.deviation import COLUMNS
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.cars import run_cars
from cadgen.jobs.adjustment.plan import Wanted, adjust
from cadgen.jobs.calibration.calibration import calibrate
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.nominal_car import cars_of
from cadgen.jobs.planning.task import task_of
from tests.car.running.laps_truth import laps_with_play
from tests.conftest import DESIGNS

A, B, OFFSET = 2000.0, 1000.0, 117.5  # mm: an eight sin t, sin 2t, whose lobes this car can drive
_CAR = {"wheelbase_mm": 167.0, "drive_wheel_offset_mm": 37.0, "idle_wheel_offset_mm": 201.0}
_CAM = {"base_radius_mm": 90.0, "mid_plane_mm": 25.0, "thickness_mm": 3.0}


def eight(count: int = 16, begin: float = 0.0) -> list[list[float]]:
    """Waypoints of the eight, even in its parameter, from some parameter on."""
    angle = [begin + TURN * number / count for number in range(count)]
    return [[A * sin(t), B * sin(2 * t)] for t in angle]


def circle(count: int, radius: float = 800.0) -> list[list[float]]:
    return [[radius * cos(TURN * number / count), radius * sin(TURN * number / count)] for number in range(count)]


def design(points: Sequence[Sequence[float]], overrides: Sequence[str] = (), **path: Any) -> Design:
    """A design with a closed path, and the train of the paper's car."""
    tables = {
        "path": {"closed": True, "offset_mm": OFFSET, "waypoints_mm": points, **path},
        "car": _CAR,
        "cam": _CAM,
        "follower": {"radius_mm": 2.5},
        "play": {"least_deg": 0.5, "greatest_deg": 1.0},
        "optimize": {"max_lift_error_um": 50.0},
    }
    return design_of(tomli_w.dumps(tables), Path("laps.toml"), overrides)


def drifts(values: Design, play: float) -> Drift:
    """Drift of the lift wanted, without a profile, with a return error in rad."""
    track = cam_model.track(values)
    lift, car, travel = cam_model.lift(values, track), cam_model.car(values), cam_model.travel(values, track)
    heading = track.heading(track.arc)
    turned = TURN * round((heading[-1] - heading[0]) / TURN)
    planned = drive(lift, car, travel)
    return drift(drive(lift, car, travel, play=play), planned, track.turn_laps, turned)


@pytest.fixture(scope="module")
def plan() -> CamPlan:
    return plan_cam(design(eight()))


def of(plan: CamPlan, code: CheckCode) -> float:
    (found,) = (check for check in plan.checks if check.code == code)
    assert found.passed
    return found.value


def test_a_lap_closes_and_a_lap_and_ten_are_alike():
    """Without play: 0.01 mm and 0.001 degrees a lap are allowed."""
    found = drifts(design(eight()), 0.0)
    print(f"a lap: {found.lap[0]:.2e} mm, {degrees(found.lap[1]):.2e} deg; ten: {found.end[0]:.2e} mm")
    assert len(found.position) == 10
    assert found.position.max() < 1e-5
    assert np.degrees(np.abs(found.heading)).max() < 1e-6


def test_the_drive_wheel_runs_beside_the_curve_lap_after_lap():
    """Against the parallel of the curve itself: of 96 waypoints the spline errs by some micrometres."""
    values = design(eight(96))
    track = cam_model.track(values)
    run = drive(cam_model.lift(values, track), cam_model.car(values), cam_model.travel(values, track), steps=14_400)
    t = np.linspace(0.0, TURN, 4001)
    tangent = A * np.cos(t) + 2j * B * np.cos(2 * t)
    ahead = tangent / np.abs(tangent)
    parallel = A * np.sin(t) + 1j * B * np.sin(2 * t) + OFFSET * 1j * ahead
    wheel = (run.drive_wheel @ [1, 1j])[::16] * ahead[0] + parallel[0]
    nearest = np.abs(wheel[:, None] - parallel[None, :-1]).argmin(axis=1)
    off = np.abs(((wheel - parallel[nearest]) * ahead[nearest].conj()).imag).max()
    print(f"off the parallel by {off:.4f} mm at most over {len(wheel)} places of ten laps")
    assert off < 0.05


@pytest.mark.parametrize("begin", [0.0, 2.4])
def test_play_acts_across_the_wrap_as_step_by_step(begin):
    """At parameter 2.4 the lap begins on a fall; the oracle sets the cam on its gears, and its first lap settles."""
    values = design(eight(begin=begin), laps=4)
    track = cam_model.track(values)
    lift, car = cam_model.lift(values, track), cam_model.car(values)
    count, play = 60_000, 120
    table = lift.q(TURN / count * np.arange(count)).tolist()
    poses = laps_with_play(table, play, 4, track.turn, car.wheelbase, car.drive_wheel_offset)
    found = drifts(values, TURN * play / count)
    print([round(degrees(heading), 4) for heading in found.heading])
    for before, after in pairwise(poses[1:]):  # from the second lap on
        turned = after.heading - before.heading
        assert degrees(turned - found.heading[0]) == pytest.approx(0.0, abs=0.02)
        assert hypot(after.x - before.x, after.y - before.y) == pytest.approx(found.position[0], abs=0.5)
    # A turn of the cam moves the car by the same motion each time.
    assert np.diff(found.heading) == pytest.approx(found.heading[0], abs=1e-9)
    end = hypot(poses[4].x - poses[1].x, poses[4].y - poses[1].y)
    assert end == pytest.approx(found.position[2], abs=1.5)


def test_a_circle_does_not_drift_whatever_the_play():
    found = [drifts(design(circle(180)), radians(play)) for play in (0.5, 3.0)]
    print([(each.end[0], degrees(each.end[1])) for each in found])
    for each in found:
        assert each.position.max() < 1e-3
        assert degrees(np.abs(each.heading).max()) < 1e-4


def test_laps_in_a_turn_are_the_path_repeated():
    """Three laps to a turn: the lift of one, three times as fast, and the drift of one with a third of the play."""
    one, three = design(eight(), laps=3), design(eight(), laps=3, laps_per_turn=3)
    lifts = [cam_model.lift(values) for values in (one, three)]
    angle = np.linspace(0.0, TURN, 721)
    assert lifts[1].q(angle) == pytest.approx(lifts[0].q(3 * angle % TURN), abs=1e-12)
    assert cam_model.track(three).turn == pytest.approx(3 * cam_model.track(one).length)
    single, triple = drifts(one, 0.012), drifts(three, 0.004)
    assert triple.position == pytest.approx(single.position, abs=1e-4)
    assert triple.heading == pytest.approx(single.heading, abs=1e-8)


def test_the_first_point_may_stand_at_the_end_again():
    for key, spline in (("waypoints_mm", "quintic"), ("control_points_mm", "b_spline")):
        points = eight()
        path = [{"closed": True, "spline": spline, key: some} for some in (points, [*points, points[0]])]
        tables = [
            {"path": each, "car": _CAR, "cam": _CAM, "follower": {"radius_mm": 2.5}, "name": "laps"} for each in path
        ]
        once, twice = (cam_model.track(design_of(tomli_w.dumps(table), Path("laps.toml"))) for table in tables)
        assert once.length == twice.length
        assert np.array_equal(once.curvature_jets, twice.curvature_jets)
        # Curvature with two derivatives goes on where the lap closes.
        scale = np.abs(once.curvature_jets).max(axis=0)
        assert np.abs(once.curvature_jets[-1] - once.curvature_jets[0]).max() < 1e-9 * scale.max()


@pytest.mark.slow
def test_the_optimized_cam_keeps_its_laps_at_the_play_it_is_cut_for(plan):
    """At least 95 % less than the plain cam over ten laps, in position and heading; its band beside the bound."""
    comparison = plan.application.comparison
    play = comparison.chosen.made_for
    plain, own = (
        plan.application.laps.of(comparison.run(each, play)) for each in (comparison.before, comparison.chosen)
    )
    worst, bound = comparison.chosen.band, comparison.bound
    print(
        f"ten laps at {degrees(play):.3f} deg: plain {plain.end[0]:.1f} mm {degrees(plain.end[1]):.2f} deg, "
        f"optimized {own.end[0]:.2f} mm {degrees(own.end[1]):.3f} deg; last lap {plain.furthest:.0f} -> "
        f"{own.furthest:.1f} mm; band {degrees(worst.worst_heading):.2f} deg, bound {degrees(bound.heading):.2f} deg"
    )
    assert own.end[0] <= 0.05 * plain.end[0]
    assert abs(own.end[1]) <= 0.05 * abs(plain.end[1])
    assert own.furthest <= 0.05 * plain.furthest
    assert bound.heading <= worst.worst_heading <= 1.05 * bound.heading
    assert of(plan, CheckCode.LAP_DRIFT) < 1e-5
    assert of(plan, CheckCode.LAP_TURN) < 1e-6
    assert of(plan, CheckCode.LAPS_DRIFT_PLAY) == pytest.approx(own.end[0])
    assert of(plan, CheckCode.LAP_FURTHEST_PLAY) == pytest.approx(own.furthest)
    assert CheckCode.BLEND_START not in {check.code for check in plan.checks}


@pytest.mark.slow
def test_a_course_is_checked_on_every_lap(plan):
    """Two gates and a post; with a play that the cam is not cut for the car gets ever further off them."""
    course = (
        "course={posts=[{at_mm=[1200, 0], radius_mm=10, side='left'}], "
        f"gates=[{{at_mm=[{A * sin(pi / 4)}, {B}], radius_mm=100}}, {{at_mm=[0, 0], radius_mm=100}}]}}"
    )
    outline = "car.outline={length_mm=300, width_mm=260, front_overhang_mm=60}"
    on_course = plan_cam(design(eight(), [course, outline]), "compensated")
    (gates,) = (check for check in on_course.checks if check.code == CheckCode.COURSE_GATES)
    assert gates.passed
    assert gates.limit == 20
    played = on_course.application.course.played(on_course.application.comparison, radians(1.0))
    gate = "course.gates.1, lap "
    margins = [where.margin for where in played.driven.passages if where.gate.key.startswith(gate)]
    print([round(margin, 1) for margin in margins])
    assert len(margins) == 10
    assert (np.diff(margins[:5]) < -10).all()
    # The middle of the axle at its nearest to the gate on lap 3, from the run's own wheels.
    run = played.run
    lap = (run.motor > 2 * TURN) & (run.motor < 3 * TURN)
    middle = (run.drive_wheel[lap] + run.idle_wheel[lap]) / 2
    near = np.linalg.norm(middle - [A * sin(pi / 4), B], axis=1).min()
    assert margins[2] == pytest.approx(100.0 - near, abs=0.05)


@pytest.mark.slow
def test_many_cars_drive_all_laps(plan):
    """The nominal car of a fleet and one with more play, against runs of their own."""
    more = radians(0.1)
    fleet = cars_of(plan.application, plan.curve, [36_000], None, plan.application.comparison.chosen.play)
    deviations = np.zeros((2, len(COLUMNS)))
    deviations[1, list(COLUMNS).index("play")] = more
    ends = run_cars(fleet, deviations)
    for car, play in enumerate((0.0, more)):
        found = plan.application.laps.of(
            plan.application.comparison.run(
                plan.application.comparison.chosen, plan.application.comparison.chosen.play + play
            )
        )
        print(f"{degrees(ends.heading[car, -1]):.4f} deg, {abs(ends.position[car, -1]):.3f} mm")
        assert degrees(ends.heading[car, -1] - found.end[1]) == pytest.approx(0.0, abs=0.02)
        assert abs(ends.position[car, -1]) == pytest.approx(found.end[0], abs=0.5)


def test_a_mirrored_car_closes_its_laps_and_drifts_the_other_way():
    """Left and right exchanged, the cam on the other side: the same drift, turned over."""
    points = [[x, -y] for x, y in eight()]
    mirror = ["car.drive_wheel_offset_mm=-37", "car.idle_wheel_offset_mm=-201", 'cam.side="right"']
    own, other = drifts(design(eight()), 0.012), drifts(design(points, mirror, offset_mm=-OFFSET), 0.012)
    assert other.position == pytest.approx(own.position, abs=1e-4)
    assert other.heading == pytest.approx(-own.heading, abs=1e-7)


@pytest.mark.parametrize(
    ("path", "overrides", "sentence"),
    [
        ({"spline": "cubic"}, (), 'set path.spline = "quintic" or "b_spline", or remove path.closed'),
        ({}, ["cam.blend_deg=12"], "nothing is blended: remove cam.blend_deg"),
        ({"closed": False, "laps": 3}, (), "the path is not closed: set path.closed = true, or remove path.laps"),
        ({"laps": 2, "laps_per_turn": 3}, (), "raise path.laps or lower path.laps_per_turn"),
        ({"waypoints_mm": circle(4)}, (), "needs at least 5: add more"),
        ({"waypoints_mm": [*circle(4), circle(4)[0]]}, (), "4 waypoints and the first again"),
    ],
)
def test_what_is_no_lap_is_refused(path, overrides, sentence):
    with pytest.raises(DesignError, match=sentence):
        cam_model.track(design(eight(), overrides, **path))


def test_jobs_for_runs_with_an_end_refuse_laps():
    values = design(eight())
    with pytest.raises(DesignError, match="a calibration is worked out for a run with an end"):
        calibrate(values, "actual", [])
    with pytest.raises(DesignError, match="an adjustment by trial runs is worked out for a run with an end"):
        adjust(values, [], "actual", Wanted())
    course = ["course.start={at_mm=[0, 0], heading_deg=0}", "course.gates=[{at_mm=[500, 0]}]"]
    with pytest.raises(DesignError, match="each lap ends where it starts: remove"):
        task_of(
            design(eight(), [*course, "course.finish={at_mm=[0, 0]}"]),
            drawn=None,
            near=None,
            within=0.0,
            calm=None,
            tightening=Margins(),
        )
    with pytest.raises(DesignError, match=r"set path\.closed alike in both"):
        task_of(
            design(eight(), course),
            drawn=None,
            near=cam_model.track(load_design()),
            within=10.0,
            calm=None,
            tightening=Margins(),
        )


def test_the_values_of_a_closed_design_make_it_again():
    """No blend stands among them, which would be refused."""
    values = design(eight(), laps_per_turn=2)
    assert "blend_deg" not in values.values()["cam"]
    again = with_overrides(values, ["path.laps=12"])
    assert (again.path.run_laps, again.path.turn_laps) == (12, 2)


def test_a_wheel_must_fit_its_laps():
    text = (DESIGNS / "carbon_free_car.toml").read_text()
    points = ", ".join(f"[{x}, {y}]" for x, y in eight())
    overrides = ["cam.blend_deg=", "path.closed=true", f"path.waypoints_mm=[{points}]", "path.laps_per_turn=2"]
    with pytest.raises(DesignError, match=r"its 2 laps take one turn .* must be \d+\.\d{4} mm") as refused:
        cam_model.track(design_of(text, Path("x.toml"), [*overrides, "car.drive_wheel_radius_mm=64"]))
    fits = str(refused.value).split("must be ")[1].split(" mm")[0]
    track = cam_model.track(design_of(text, Path("x.toml"), [*overrides, f"car.drive_wheel_radius_mm={fits}"]))
    # The paper's train turns the camshaft once for 45 turns of the drive wheel's shaft.
    assert TURN * float(fits) * 45 == pytest.approx(2 * track.length, rel=2e-6)
