"""Curvature, poses and what the play costs: against the exact chain, and derivatives against finite differences."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.car.against_play.band import best_for_band
from cadgen.car.path.spline import control_path
from cadgen.car.path.wheel_track import offset_track
from cadgen.car.planner.constraints import LimitKind, PathLimit, curvature_limits, driving_constraints
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.sensitivity import PlayCost, TrackLength
from cadgen.curves.piecewise import quintic_hermite
from cadgen.design import cam_model
from cadgen.design.load import load_design

STEP = 1e-3  # mm
SMALL_STEP = 1e-5  # mm; falls begin and end where the rate of curvature passes through zero


def test_curvature_is_that_of_the_track(paper_points, vehicle):
    track = offset_track(control_path(paper_points), vehicle.path_offset)
    motion = Kinematics(Basis(len(paper_points)).even(8), paper_points, vehicle.path_offset)
    line = TrackLength(motion, vehicle)
    assert abs(line.length / track.length - 1) < 1e-8
    u = motion.places.u
    arc = np.interp(u, np.arange(len(track.waypoint_arc)), track.waypoint_arc)  # exact at the knots
    at_knots = np.flatnonzero(u == u.round())
    curve = quintic_hermite(track.arc, track.curvature_jets)
    for order in range(3):
        exact = curve(arc[at_knots[:-1]], nu=order)
        off = motion.quantities[order][at_knots[:-1]] - exact
        assert np.abs(off).max() < 1e-6 * np.abs(exact).max()


def test_the_cost_of_play_is_that_of_the_exact_chain(paper_points, vehicle):
    """To first order; on the paper's car it is 0.2 % off."""
    design = load_design()
    track = cam_model.track(design)
    lift = cam_model.lift(design, track)
    band = tuple(np.radians([0.51215675, 0.96199785]))
    exact = best_for_band(lift, cam_model.follower(design), cam_model.car(design), track.length, band)
    motion = Kinematics(Basis(len(paper_points)).even(8), paper_points, vehicle.path_offset)
    cost = PlayCost(TrackLength(motion, vehicle), vehicle.spread)
    print(f"{cost.distance:.1f} mm, exactly {exact.worst_distance:.1f} mm")
    assert abs(cost.distance / exact.worst_distance - 1) < 0.01
    assert abs(cost.heading / exact.worst_heading - 1) < 0.01


def test_derivatives(paper_points, vehicle):
    random = np.random.default_rng(3)
    basis = Basis(len(paper_points))
    places = basis.even(8)
    change = random.normal(size=paper_points.shape)
    flat = change.T.ravel()

    def at(points):
        motion = Kinematics(places, points, vehicle.path_offset)
        return motion, PlayCost(TrackLength(motion, vehicle), vehicle.spread)

    motion, cost = at(paper_points)
    (ahead, ahead_cost), (back, back_cost) = (at(paper_points + sign * STEP * change) for sign in (1, -1))
    numeric = (ahead.quantities - back.quantities) / (2 * STEP)
    exact = np.einsum("qmk,mk->qm", motion.slopes, flat[motion.places.both])
    for order in range(5):
        assert np.abs(numeric[order] - exact[order]).max() < 1e-5 * np.abs(numeric[order]).max()
    direction = random.normal(size=(len(places.u), 2))
    moved = np.sum(motion.moved(direction, 80.0, -40.0) * flat[places.both], axis=1)
    numeric = np.sum(direction * (ahead.point(80.0, -40.0) - back.point(80.0, -40.0)), axis=1) / (2 * STEP)
    assert np.abs(moved - numeric).max() < 1e-6 * np.abs(numeric).max()
    numeric = (ahead_cost.line.length - back_cost.line.length) / (2 * STEP)
    assert abs(cost.line.by_points @ flat - numeric) < 1e-6 * abs(numeric)


def test_the_linear_model_of_the_error(paper_points, vehicle):
    """Along any direction, but for the place at which the run ends, which the model holds."""
    basis = Basis(len(paper_points))
    change = np.random.default_rng(5).normal(size=paper_points.shape)
    flat = change.T.ravel()

    def at(points):
        return PlayCost(TrackLength(Kinematics(basis.even(8), points, vehicle.path_offset), vehicle), vehicle.spread)

    cost, ahead, back = at(paper_points), at(paper_points + SMALL_STEP * change), at(paper_points - SMALL_STEP * change)
    columns, slopes = cost.by_rises()
    rises = np.sum(slopes * flat[columns], axis=1)
    for direction in cost.directions():
        weights = np.where(cost.rises > 0, cost.factor * cost.line.driven * (cost.levers @ direction), 0.0)
        slope = cost.by_levers(direction)
        np.add.at(slope, columns, weights[:, None] * slopes)
        numeric = direction @ (ahead.error - back.error) / (2 * SMALL_STEP)
        assert weights @ rises + cost.by_levers(direction) @ flat == pytest.approx(slope @ flat)
        # A random change mostly cancels: what it is off by is held against what such a change can do.
        assert abs(slope @ flat - numeric) < 0.002 * np.linalg.norm(slope)


def test_a_mirrored_car_on_a_mirrored_path_is_the_same(paper_points, vehicle, limits):
    """Wheels on the other hand, cam on the other side: cost and limits of the mirror image."""
    car = vehicle.car
    other = replace(
        vehicle,
        path_offset=-vehicle.path_offset,
        car=replace(
            car,
            drive_wheel_offset=-car.drive_wheel_offset,
            idle_wheel_offset=-car.idle_wheel_offset,
            steering_gain=-1.0,
        ),
    )
    basis, figures = Basis(len(paper_points)), []
    for its_vehicle, points in ((vehicle, paper_points), (other, paper_points * [1, -1])):
        motion = Kinematics(basis.even(8), points, its_vehicle.path_offset)
        line = TrackLength(motion, its_vehicle)
        left, right = curvature_limits(its_vehicle)
        its_limits = replace(limits, left=left, right=right, valley=40.0)
        rows = driving_constraints(motion, line, its_vehicle, its_limits)
        figures.append([PlayCost(line, its_vehicle.spread).cost, *(each.worst for each in rows)])
    np.testing.assert_allclose(figures[0], figures[1], rtol=1e-9)


def test_the_step_that_the_blend_must_come_over(paper_points, vehicle, limits):
    """Its value from the curvature at start and end of the run, its derivative by finite differences."""
    random, basis = np.random.default_rng(5), Basis(len(paper_points))
    change, places = random.normal(size=paper_points.shape), basis.even(8)
    held = replace(limits, step=2.0)

    def row(points):
        motion = Kinematics(places, points, vehicle.path_offset)
        line = TrackLength(motion, vehicle)
        (found,) = [
            rows
            for rows in driving_constraints(motion, line, vehicle, held)
            if rows.limit == PathLimit(LimitKind.BLEND)
        ]
        return found, motion, line

    rows, motion, line = row(paper_points)
    last = line.end[0] + round(line.end[1])
    lifts = []
    for curvature in motion.quantities[0][[0, last]]:
        tangent = -vehicle.car.wheelbase * curvature / (1 + vehicle.car.drive_wheel_offset * curvature)
        lifts.append(tangent * vehicle.faces[0 if tangent > 0 else 1])
    assert rows.values[0] == pytest.approx(abs(lifts[1] - lifts[0]) / 2.0 - 1, abs=1e-9)
    flat = change.T.ravel()
    by = float(rows.slopes[0] @ flat[rows.columns[0]])
    moved = [row(paper_points + sign * STEP * change)[0].values[0] for sign in (1, -1)]
    assert by == pytest.approx((moved[0] - moved[1]) / (2 * STEP), rel=1e-4)
