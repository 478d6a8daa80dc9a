"""Closed paths of the planner: their B-splines, the start that they keep, derivatives of their cost, and a plan."""

from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.car.course.layout import Course, Gate, Shape
from cadgen.car.path.spline import closed_control_path
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_plan import best_plan
from cadgen.car.planner.path_task import PathTask
from cadgen.car.planner.search import fixed_start
from cadgen.car.planner.sensitivity import PlayCost, TrackLength

COUNT = 24


@pytest.fixture(scope="module")
def points():
    """Control points of a lap with two lobes, none like the other."""
    angle = TURN * np.arange(COUNT) / COUNT
    return np.stack([1500 * np.sin(angle) + 200 * np.cos(2 * angle), 1100 * np.cos(angle + 0.3)], axis=1)


@pytest.fixture(scope="module")
def lap_vehicle(vehicle):
    return replace(vehicle, end=1.0, closed=True)


def test_the_planned_lap_is_the_curve_of_the_design(points):
    basis, path = Basis(COUNT, closed=True), closed_control_path(points)
    places = basis.even(7)
    assert np.abs(places.jets(points) - path.derivatives(places.u)).max() < 1e-9
    assert places.u[-1] == path.knots[-1]


def test_a_lap_keeps_its_start(points):
    """Steps that the equations allow move the start by nothing and turn it by nothing."""
    basis = Basis(COUNT, closed=True)
    here, ahead = basis.first.jets(points)[:2, 0]
    fixed = fixed_start(basis, (True, float(np.arctan2(ahead[1], ahead[0]))))
    _, _, rows = np.linalg.svd(fixed.matrix)
    allowed = rows[len(fixed.matrix) :].T @ np.random.default_rng(1).normal(size=2 * COUNT - len(fixed.matrix))
    moved, turned = basis.first.jets(points + 5 * allowed.reshape(2, COUNT).T)[:2, 0]
    assert moved == pytest.approx(here, abs=1e-9)
    assert np.cross(np.append(turned, 0.0), np.append(ahead, 0.0))[2] == pytest.approx(0.0, abs=1e-6)
    assert turned @ ahead > 0


def test_derivatives_of_length_and_error_go_round_the_lap(points, lap_vehicle):
    basis = Basis(COUNT, closed=True)

    def cost(at):
        return PlayCost(TrackLength(Kinematics(basis.even(8), at, lap_vehicle.path_offset), lap_vehicle), 0.01)

    here, rng = cost(points), np.random.default_rng(2)
    change = rng.normal(size=(COUNT, 2))
    step = 1e-4
    more, less = cost(points + step * change), cost(points - step * change)
    along = change.T.ravel()
    assert here.line.by_points @ along == pytest.approx((more.line.length - less.line.length) / (2 * step), rel=1e-6)
    # The error changes by its levers, and by the changes of the curvature; which intervals fall stays the same.
    direction = here.error / here.distance
    columns, slopes = here.by_rises()
    rises = np.zeros(len(here.rises))
    np.add.at(rises, np.arange(len(rises))[:, None].repeat(columns.shape[1], 1), slopes * along[columns])
    weight = here.factor * (here.levers @ direction) * here.line.driven * (here.rises > 0)
    slope = here.by_levers(direction) @ along + weight @ rises
    assert slope == pytest.approx(float((more.error - less.error) @ direction) / (2 * step), rel=2e-3)


@pytest.mark.slow
def test_a_round_course_is_planned_as_a_circle(lap_vehicle, limits):
    """On a circle the lift never falls: play does nothing, whatever the gates leave."""
    gates = tuple(
        Gate(
            key=f"course.gates.{number + 1}",
            place=Shape(tuple((radius * np.cos(angle), radius * np.sin(angle)) for radius in (1000, 1800))),
            heading=angle + pi / 2,
            heading_tolerance=radians(60),
        )
        for number, angle in enumerate(np.arange(1, 6) * pi / 3)
    )
    start = Gate(key="course.start", place=Shape.disc((1400.0, 0.0), 0.0), heading=pi / 2 + 0.05, heading_tolerance=0.0)
    result = best_plan(
        PathTask(vehicle=lap_vehicle, limits=limits, course=Course(gates=gates, start=start, finish=start))
    )
    curvature = result.path.cost.line.motion.quantities[0]
    print(
        f"heading off {np.degrees(result.path.cost.heading):.4f} deg, curvature {curvature.min()} to {curvature.max()}"
    )
    assert not result.missed
    assert np.degrees(result.path.cost.heading) < 0.02
    assert np.ptp(curvature) < 0.02 * curvature.mean()
