"""Parts of the search: what can be set, the least greatest error, and the law of similar paths as a limit case."""

from math import pi
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import linprog

from cadgen import Design
from cadgen.car.course.layout import Course, Draw, Obstacle, Shape
from cadgen.car.draws.best_settings import Minimax
from cadgen.car.draws.setting_ranges import SettingRange, Wheels
from cadgen.design import draw_model
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.settings_maker import Maker

S_COURSE = Path(__file__).parents[2] / "data" / "draws" / "s_course.toml"
SIMILAR = """
name = "similar"
[path]
waypoints_mm = [[0, 0], [700, 250], [1500, 0], [2300, -250], [3000, 0], [3700, 200], [4400, 0]]
offset_mm = 0.0
[course.spacing]
from_mm = 700.0
to_mm = 1300.0
[settings]
disc_from_mm = -12.0
disc_to_mm = 12.0
wheel_from_mm = 5.0
wheel_to_mm = 300.0
start_within_mm = 20.0
[car]
wheelbase_mm = 150.0
drive_wheel_offset_mm = 0.0
idle_wheel_offset_mm = 150.0
max_steering_angle_deg = 60.0
[cam]
base_radius_mm = 70.0
mid_plane_mm = 30.0
thickness_mm = 0.1
[follower]
radius_mm = 0.1
length_mm = 100.0
[checks]
min_convex_radius_mm = 0.0
[train]
module_mm = 0.5
pressure_angle_deg = 20.0
width_mm = 5.0
bearing_span_mm = 80.0
stages = [{ centre_distance_mm = 45.0, driver = { teeth = 30 }, driven = { teeth = 150 } }]
"""


@pytest.mark.slow
def test_similar_paths_need_the_lever_and_the_wheel_alone():
    """With the drive wheel under the fork axis and a thin rod the law is exact, but for 0.1 mm between the faces.

    At 0.7 times the spacing these differ in their levers by 0.05 / 30 / 0.7 less 0.05 / 30, seven parts in 10 000 to
    either side: 0.4 mrad in a turn of half a radian, 2 mm on 4.4 m if nothing is set for it.
    """
    factor = 0.7
    design = Design.from_toml(SIMILAR).values
    maker = Maker(design, plan_cam(design, "actual"), draw_model.draw(design))
    row = maker.drawn(1000 * factor)
    stated = maker.cam.application.track.turn / (2 * pi * 5)
    print(row.error, row.setting)
    assert row.error < 0.7
    assert row.setting.disc == pytest.approx(30 * (factor - 1), abs=0.05)
    assert row.setting.radius == pytest.approx(factor * stated, rel=1e-3)
    assert np.hypot(row.setting.x, row.setting.y) < 1
    assert row.setting.head == 0


def test_least_greatest_error_of_a_plane():
    """Three points on a circle: the least circle about them has its middle at that of the circle."""
    points = 3 + 4j + 5 * np.exp(1j * np.array([0.1, 2.0, 4.5]))
    by = np.zeros((3, 2), complex)
    by[:, 0], by[:, 1] = -1, -1j
    problem = Minimax(points, by, np.zeros(2), np.array([[-20.0, 20.0], [-20.0, 20.0]]), np.ones(3))
    np.testing.assert_allclose(problem.best({}), [3, 4], atol=0.02)
    assert problem.worst(problem.best({})) == pytest.approx(5, rel=2e-3)
    held = problem.best({0: 6.0})
    assert held[0] == 6
    assert problem.worst(held) == pytest.approx(
        min(np.abs(points - 6 - 1j * y).max() for y in np.linspace(0, 9, 9001)), 2e-3
    )


@pytest.mark.parametrize("seed", range(4))
def test_least_greatest_error_is_that_of_the_linear_programme(seed):
    """HiGHS on tangents in 96 directions: each length is at most 1 / cos(pi / 96) of the greatest of its parts."""
    random = np.random.default_rng(seed)
    t = np.linspace(0, 1, 301)
    waves = np.exp(2j * np.pi * np.outer(t, np.arange(5)) * random.uniform(0.2, 1))
    errors, *slopes = (waves @ random.normal(size=(5, 7)) + 1j * waves @ random.normal(size=(5, 7))).T
    by = np.stack(slopes, axis=1) * 10 ** random.uniform(-2, 2, 6)
    bounds = np.stack([-random.uniform(0.01, 3, 6), random.uniform(0.01, 3, 6)], axis=1)
    bounds[2] = 0.0  # what cannot be set
    weights = np.where(np.abs(t - 0.3) < 0.04, 2.0, 1.0)
    problem = Minimax(errors, by, np.zeros(6), bounds, weights)
    towards = np.multiply.outer(np.exp(-2j * np.pi * np.arange(96) / 96), weights)
    rows = (towards[..., None] * by).real.reshape(-1, 6)
    for fixed in ({}, {1: 0.005}, {0: bounds[0, 0], 3: 0.0}):
        box = np.array([[fixed.get(k, low), fixed.get(k, high)] for k, (low, high) in enumerate(bounds)])
        least = linprog(
            np.append(np.zeros(6), 1),
            A_ub=np.column_stack([rows, -np.ones(len(rows))]),
            b_ub=-(towards * errors).real.ravel(),
            bounds=[*box, (0, None)],
        ).fun
        chosen = problem.best(fixed)
        assert (box[:, 0] - 1e-12 <= chosen).all()
        assert (chosen <= box[:, 1] + 1e-12).all()
        assert least * (1 - 1e-9) <= problem.worst(chosen) <= least * 1.002


def test_what_can_be_set_on_either_side():
    assert SettingRange(-5.0, 5.0, 0.5).adjacent(1.2) == (1.0, 1.5)
    assert SettingRange(-5.0, 5.0, 0.5).adjacent(1.5) == (1.5,)
    assert SettingRange(-5.0, 5.0).adjacent(1.23) == (1.23,)
    # What is shown is 10.2 more, and set to whole numbers.
    assert SettingRange(-5.0, 5.0, 1.0, 10.2).adjacent(0.0) == pytest.approx((-0.2, 0.8))
    hand = Wheels((50.0, 60.0), (10.0, 11.0))
    assert hand.adjacent(2 * pi * 610) == ((60.0, 10.0), (60.0, 11.0))
    assert hand.adjacent(2 * pi * 400) == ((50.0, 10.0),)
    assert not hand.free
    assert Wheels((50.0, 60.0), (10.0,), made=True).free
    assert Wheels((50.0, 60.0), (10.0,), made=True, step=0.5).adjacent(2 * pi * 552) == ((55.0, 10.0), (55.5, 10.0))


def test_what_moves_with_the_spacing():
    draw = Draw(spacings=(700.0, 1300.0), stated=1000.0, about=(100.0, 0.0), kinds=frozenset({"posts"}))
    course = Course(
        obstacles=(
            Obstacle(kind="post", key="course.posts.1", shape=Shape.disc((1100.0, 50.0), 10.0)),
            Obstacle(kind="wall", key="course.walls.1", shape=Shape(((0.0, 500.0), (900.0, 500.0)), reach=5.0)),
        )
    )
    post, wall = draw.course(course, 700.0).obstacles
    assert post.shape == Shape.disc((800.0, 35.0), 10.0)
    assert wall == course.obstacles[1]
    # Made as much smaller again, what moves is where it was, and the wall is farther off.
    seen, far = draw.seen(course, 0.5).obstacles
    assert seen == course.obstacles[0]
    assert far.shape.points == ((-100.0, 1000.0), (1700.0, 1000.0))
    assert draw.without_moving(course).obstacles == (wall,)


def test_branches_of_equal_error_have_an_order():
    """A head of 0.1 µm has divisions whose errors are equal to the last bit; finer ones are no worse."""
    errors = {}
    for step in (0.0001, 0.005):
        design = Design.load(S_COURSE, [f"settings.head_step_mm={step}"]).values
        maker = Maker(design, plan_cam(design, "actual"), draw_model.draw(design))
        row = maker.drawn(1300.0)
        parts = (design.cam.base_radius_mm + row.setting.head) / step
        assert parts == pytest.approx(round(parts), abs=1e-3)
        errors[step] = row.error
    assert errors[0.0001] <= 1.02 * errors[0.005]
