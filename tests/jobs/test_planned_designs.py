"""The packaged designs that `cadgen plan` made: every check passes, and a sweep of its own finds them clear."""

from math import degrees, hypot

import numpy as np
import pytest
from scipy.interpolate import BSpline

from cadgen.design.load import course_of, load_design, packaged_designs
from cadgen.jobs.cam.steering_cam import plan_cam
from tests.conftest import UNBRAKED

PLANNED = ("figure_eight", "posts_and_walls", "s_course")
# mm and degrees at the end of the run, worst over the band; of the figure 8 on and after the tenth lap.
WORST = {"figure_eight": (120, 9.0), "posts_and_walls": (15, 0.5), "s_course": (45, 0.9)}


@pytest.fixture(scope="module", params=PLANNED)
def plan(request):
    return plan_cam(load_design(request.param, UNBRAKED), "compensated")  # as the optimized profile is without a brake


def poses(design):
    """Middle of the axle and direction of travel along the planned path, from its control points alone."""
    points, closed = np.array(design.path.control_points_mm), design.path.closed
    n = len(points)
    if closed:
        spline = BSpline(np.arange(-5, n + 6), points[(np.arange(n + 5) - 2) % n], 5)
    else:
        spline = BSpline(np.concatenate([[0] * 5, np.arange(n - 4), [n - 5] * 5]), points, 5)
    u = np.linspace(0, n if closed else n - 5, 8001)
    middle, along = spline(u) @ [1, 1j], spline(u, nu=1) @ [1, 1j]
    return middle, along / np.abs(along)


def nearest(design, points):
    """Least distance of the car's rectangle from points on the floor, x + iy."""
    middle, ahead = poses(design)
    outline, length = design.car.outline, design.car.wheelbase_mm
    front = length + outline.front_overhang_mm
    rear, half = front - outline.length_mm, outline.width_mm / 2
    best = np.inf
    for point in points:
        seen = (point - middle) * ahead.conj()
        x = np.maximum(np.maximum(rear - seen.real, seen.real - front), 0.0)
        y = np.maximum(np.abs(seen.imag) - half, 0.0)
        best = min(best, float(np.hypot(x, y).min()))
    return best


@pytest.mark.parametrize("name", PLANNED)
def test_their_files_are_courses_with_a_plan(name):
    """Without its control points each file is still a course to plan."""
    text = packaged_designs()[name].read_text()
    start = text.index("spline = ")
    _, drawn = course_of(text[:start] + text[text.index("[course]") :], packaged_designs()[name])
    assert not drawn
    design = load_design(name)
    assert design.path.spline == "b_spline"
    assert design.course.judged == "play"


@pytest.mark.parametrize("name", PLANNED)
def test_they_keep_their_margin_by_a_sweep_of_its_own(name):
    design = load_design(name)
    course = design.course
    rooms = [nearest(design, [complex(*post.at_mm)]) - post.radius_mm for post in course.posts]
    for wall in course.walls:
        (a, b) = (complex(*point) for point in wall.line_mm)
        along = np.linspace(0, 1, 400)
        rooms.append(nearest(design, a + along * (b - a)) - wall.thickness_mm / 2)
    print(name, np.round(rooms, 1))
    assert min(rooms) > course.margin_mm


@pytest.mark.slow
def test_they_pass_every_check_with_every_play_of_the_band(plan):
    band, name = plan.application.comparison.chosen.band, plan.application.design.name
    print(f"{name}: {band.worst_distance:.1f} mm, {degrees(band.worst_heading):.2f} deg")
    assert plan.passed, [check.name for check in plan.failed]
    distance, heading = WORST[name]
    assert band.worst_distance < distance
    assert degrees(band.worst_heading) < heading
    if name == "figure_eight":
        bound = plan.application.comparison.bound
        assert degrees(bound.heading) == pytest.approx(degrees(band.worst_heading), rel=0.01)
        drift = plan.application.laps.of(plan.application.comparison.chosen.run)
        assert drift.end[0] < 0.05
        assert degrees(abs(drift.end[1])) < 0.01
        # The end is the end, and what the choice goes by has a name of its own.
        comparison = plan.application.comparison
        figures = comparison.figures(comparison.before)
        before = plan.application.laps.of(comparison.run(comparison.before, comparison.before.play))
        assert figures.value("end_position") == pytest.approx(before.end[0], rel=0.01)
        assert figures.value("last_turn_position") == pytest.approx(before.furthest, rel=0.01)
        assert figures.value("worst_last_turn_position") == comparison.before.band.worst_distance
        assert figures.value("last_turn_position") > 100 * figures.value("end_position")
        assert "worst_end_position" not in figures
    else:
        track, finish = plan.application.track, plan.application.design.course.finish
        x, y = track.planned(track.length) - finish.at_mm
        assert hypot(x, y) < finish.radius_mm
