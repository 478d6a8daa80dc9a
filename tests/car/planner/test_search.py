"""Small searches: limits and gates are kept, seeds reproduce, what cannot be driven is blamed on the right limit."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from cadgen.car.course.layout import Course, Gate, Obstacle, Shape
from cadgen.car.planner.barriers import Clearances, barriers_of
from cadgen.car.planner.gates import planned_place
from cadgen.car.planner.kinematics import Basis
from cadgen.car.planner.path_plan import best_plan, reasons, smaller
from cadgen.car.planner.path_task import PathTask
from cadgen.car.planner.search import PathSearch, best_step, fixed_ends


def disc(key: str, x: float, y: float, radius: float, heading: float | None = None, tolerance: float = pi / 2) -> Gate:
    place = Shape.disc((x, y), radius)
    return Gate(key=key, place=place, heading=heading, heading_tolerance=tolerance)


START, FINISH = disc("course.start", 0, 0, 1.0, 0.0), disc("course.finish", 4000, 600, 50.0)


@pytest.fixture(scope="module")
def task(vehicle, limits) -> PathTask:
    course = Course(start=START, gates=(disc("course.gates.1", 1800, -200, 30.0),), finish=FINISH, margin=10.0)
    return PathTask(vehicle=vehicle, limits=limits, course=course)


@pytest.mark.slow
@pytest.mark.long
def test_a_post_on_the_way_is_passed_on_either_side(task):
    sides = {}
    for side in ("left", "right"):
        post = Obstacle(kind="post", key="course.posts.1", shape=Shape.disc((2000.0, 100.0), 10.0), side=side)
        found = best_plan(replace(task, course=replace(task.course, gates=(), obstacles=(post,))))
        assert not found.missed
        motion = found.path.cost.line.motion
        near = int(np.linalg.norm(motion.jets[0] - [2000, 100], axis=1).argmin())
        sides[side] = (motion.jets[0][near] - [2000, 100]) @ motion.left[near]
    assert sides["right"] < -100 < 100 < sides["left"]


@pytest.mark.slow
@pytest.mark.parametrize("penalty", [1.0, 100.0, 1e4])
def test_a_programme_that_may_not_move_promises_what_the_path_costs(task, penalty):
    """Violations of limits add up place by place; of a distance that is kept besides the greatest one counts."""
    posts = tuple(
        Obstacle(kind="post", key=f"course.posts.{k}", shape=Shape.disc((x, y), 10.0))
        for k, (x, y) in enumerate([(1000.0, 0.0), (2500.0, 300.0)], 1)
    )
    course = replace(task.course, obstacles=posts)
    asked = replace(
        task, course=course, spare={"course.posts.1": 40.0, "course.posts.2": 300.0, "course.gates.1": 20.0}
    )
    path = best_plan(asked).path
    points = path.points + 30 * np.random.default_rng(3).normal(size=path.points.shape)
    basis = Basis(len(points))
    clearances = Clearances(basis, asked.vehicle, barriers_of(course, asked.vehicle.body), asked.spare)
    fixed = fixed_ends(len(points), (True, 0.0), (False, None))
    path = PathSearch(asked, basis, fixed, clearances.constraints).path(points)
    spare = [each for each in path.constraints if each.limit.spare]
    assert len(spare) == 2
    for each in spare:
        assert each.violation == max(each.values) > 0
    assert sum(each.violation > each.worst > 0 for each in path.constraints if not each.limit.spare) > 2
    _, promised = best_step(path.cost, list(path.constraints), penalty, 1e-9, fixed)
    assert promised == pytest.approx(path.total(penalty), rel=1e-6)


@pytest.mark.slow
def test_a_plan_is_reproducible_and_more_searches_are_no_worse(task):
    one, again, more = best_plan(task), best_plan(task), best_plan(task, seeds=2)
    assert not one.missed
    np.testing.assert_array_equal(one.path.points, again.path.points)
    assert more.path.cost.cost <= one.path.cost.cost


@pytest.mark.slow
@pytest.mark.parametrize(
    "place",
    [Shape(((0.0, -400.0), (0.0, 300.0))), Shape.disc((0.0, 100.0), 150.0)],
    ids=["on a line", "in a disc"],
)
def test_a_start_that_is_no_point_is_kept_and_used(task, place):
    """The path starts on the line or in the disc, and where it costs least there."""
    start = Gate(key="course.start", place=place, heading=0.0)
    found = best_plan(replace(task, course=replace(task.course, start=start)))
    assert not found.missed
    wheel = found.path.cost.line.motion
    middle = wheel.point(*planned_place(start, task.vehicle))[0]
    print(middle)
    if len(place.points) == 2:
        assert abs(middle[0]) < 0.01
        assert -400 < middle[1] < 300
    else:
        assert np.hypot(*(middle - place.points[0])) <= 150


@pytest.mark.slow
@pytest.mark.long
def test_a_hairpin_whose_route_has_a_sharp_corner_is_driven(task):
    """Back by 124 degrees with 1.8 m for it, where the fork holds turns of 0.3 m; it was said that none can."""
    course = Course(
        start=disc("course.start", 600, 600, 1.0, 0.0),
        gates=tuple(
            disc(f"course.gates.{k}", x, y, r)
            for k, (x, y, r) in enumerate([(2500, 1500, 50), (4000, 2000, 50), (5500, 1500, 20)], 1)
        ),
        finish=disc("course.finish", 5000, 3200, 60),
    )
    found = best_plan(replace(task, course=course))
    assert not found.missed


def test_a_smaller_car_is_one_about_its_middle(task):
    """Every point of it is nearer to the middle of the outline by the size, and it keeps so much less room."""
    small, body = smaller(task, 0.3), task.vehicle.body
    assert small.course.margin == pytest.approx(3.0)
    middle = np.array([(45 - 215) / 2, (55 - 215) / 2])
    np.testing.assert_allclose(np.array(small.vehicle.body.corners) - middle, 0.3 * (np.array(body.corners) - middle))
    for one, whole in zip(small.vehicle.body.wheels, body.wheels, strict=True):
        np.testing.assert_allclose(np.array(one.centre) - middle, 0.3 * (np.array(whole.centre) - middle))
        assert (one.radius, one.width) == pytest.approx((0.3 * whole.radius, 0.3 * whole.width))
    assert small.vehicle.car == task.vehicle.car


@pytest.mark.parametrize(
    ("course", "limit", "least", "most"),
    [
        # The field ends 100 mm beside the gate.
        (
            Course(
                start=START,
                gates=(disc("course.gates.1", 2000, 400, 10.0),),
                finish=disc("course.finish", 4000, 0, 50.0),
                edge=Shape(((-400, -1500), (4500, -1500), (4500, 500), (-400, 500)), filled=True),
            ),
            ("course.field", "course.gates.1"),
            10.0,
            60.0,
        ),
    ],
)
@pytest.mark.slow
@pytest.mark.long
def test_what_cannot_be_driven_is_blamed_on_the_right_limit(task, course, limit, least, most):
    found = best_plan(replace(task, course=course))
    assert found.missed
    (first, *_) = reasons(found)
    print(first)
    assert str(first.limit).startswith(limit)
    assert least <= first.amount <= most
