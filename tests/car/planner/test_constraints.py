"""Gates and barriers: distances against shapely, places by brute force, derivatives by finite differences."""

from dataclasses import replace
from itertools import combinations_with_replacement, permutations
from math import pi
from pathlib import Path

import numpy as np
import pytest
import shapely

from cadgen.car.course.body import RunPoses, place_of
from cadgen.car.course.judge import judge
from cadgen.car.course.layout import CarPoint, Course, Gate, Obstacle, Shape
from cadgen.car.planner.barriers import Clearances, barriers_of, parts_of
from cadgen.car.planner.constraints import LimitKind, PathLimit
from cadgen.car.planner.gates import Passing, passing_places, planned_place
from cadgen.car.planner.kinematics import Basis, Kinematics
from cadgen.car.planner.path_task import Margins
from cadgen.car.planner.route import _improved, _inserted, _tour, in_order, route_of
from cadgen.design.load import course_of
from cadgen.jobs.planning.task import task_of
from tests.studies import courses

STEP = 1e-4  # mm
FIELD = Shape(((-300, -200), (8200, -200), (8200, 8000), (4000, 7900), (-300, 8000)), filled=True)


def course(random: np.random.Generator, track: np.ndarray) -> Course:
    """Obstacles near the track, some of them on it."""
    obstacles = []
    for number in range(4):
        for kind in ("post", "wall", "zone"):
            centre = track[random.integers(len(track))] + random.normal(size=2) * 200
            corners = [tuple(centre + random.normal(size=2) * 150) for _ in range(3)]
            shape = {
                "post": Shape.disc(tuple(centre), 15.0),
                "wall": Shape(tuple(corners), reach=5.0),
                "zone": Shape(
                    tuple(map(tuple, shapely.get_coordinates(shapely.MultiPoint(corners).convex_hull)[:-1])),
                    filled=True,
                ),
            }[kind]
            obstacles.append(Obstacle(kind=kind, key=f"course.{kind}s.{number}", shape=shape))
    return Course(edge=FIELD, obstacles=tuple(obstacles), margin=10.0)


def car_at(motion: Kinematics, place: int, corners: np.ndarray) -> shapely.Geometry:
    x, y = corners.T
    spots = motion.jets[0][place] + x[:, None] * motion.ahead[place] + y[:, None] * motion.left[place]
    return shapely.Polygon(spots) if len(spots) > 2 else shapely.Point(spots[0])


@pytest.mark.parametrize("seed", range(3))
def test_clearances_are_those_of_shapely(seed, paper_points, vehicle):
    random = np.random.default_rng(seed)
    basis = Basis(len(paper_points))
    motion = Kinematics(basis.even(20), paper_points, vehicle.path_offset)
    its_course = course(random, motion.track)
    rows = Clearances(basis, vehicle, barriers_of(its_course, vehicle.body)).constraints(paper_points)
    places = {u: number for number, u in enumerate(motion.places.u.tolist())}
    things = {obstacle.key: obstacle.shape for obstacle in its_course.obstacles}
    compared = 0
    for each in rows:
        for u, value in list(zip(each.u.tolist(), each.values.tolist(), strict=True))[::7]:
            cars = [car_at(motion, places[u], corners) for corners, _ in parts_of(vehicle)]
            reach = 0.0 if each.limit.key == "course.field" else things[each.limit.key].reach
            distance = 10.0 + 0.05 + reach - value
            if each.limit.key == "course.field":
                exact = min(
                    shapely.distance(shapely.Point(spot), shapely.Polygon(FIELD.points).exterior)
                    * (1 if shapely.covers(shapely.Polygon(FIELD.points), shapely.Point(spot)) else -1)
                    for car in cars
                    for spot in shapely.get_coordinates(car)
                )
            else:
                shape = things[each.limit.key]
                there = (
                    shapely.Polygon(shape.points)
                    if shape.filled
                    else (shapely.LineString(shape.points) if len(shape.points) > 1 else shapely.Point(shape.points[0]))
                )
                exact = min(shapely.distance(car, there) for car in cars)
                if exact == 0:  # shapely does not say how deep
                    assert distance <= 0.05 + 25.0 / 2
                    continue
                # Points stand 25 mm apart along walls and round zones.
                assert exact - 1e-6 <= distance <= exact + 3.0
                compared += 1
                continue
            assert abs(distance - exact) < 1e-6
            compared += 1
    print(f"{compared} clearances compared")
    assert compared > 30


@pytest.mark.slow
def test_derivatives_of_clearances_and_gates(paper_points, vehicle):
    random = np.random.default_rng(8)
    basis = Basis(len(paper_points))
    motion = Kinematics(basis.even(20), paper_points, vehicle.path_offset)
    clearances = Clearances(basis, vehicle, barriers_of(course(random, motion.track), vehicle.body))
    gates = tuple(
        Gate(
            key=f"course.gates.{k}",
            place=Shape.disc(tuple(motion.track[at] + random.normal(size=2) * 60), 30.0),
            point=point,
        )
        for k, (at, point) in enumerate([(200, "middle"), (700, "fork"), (1100, "idle_wheel")])
    )
    a = motion.track[900] + 200 * motion.left[900] + 30 * motion.ahead[900]
    b = motion.track[900] - 250 * motion.left[900] - 60 * motion.ahead[900]
    gates = (
        *gates[:2],
        Gate(key="line", place=Shape((tuple(a), tuple(b)))),
        gates[2],
    )
    passing = Passing(basis, gates, None, None, vehicle)
    change = random.normal(size=paper_points.shape)
    flat = change.T.ravel()
    for source in (clearances, passing):
        here, ahead, back = (source.constraints(paper_points + step * change) for step in (0.0, STEP, -STEP))
        off = []
        for rows, one, other in zip(here, ahead, back, strict=True):
            if not len(rows.values) == len(one.values) == len(other.values):
                continue
            numeric = (one.values - other.values) / (2 * STEP)
            model = np.sum(rows.slopes * flat[rows.columns], axis=1)
            off += (np.abs(numeric - model) / (1 + np.abs(numeric))).tolist()
        # Where the nearest point changes, the derivative jumps; elsewhere it is exact.
        assert np.median(off) < 1e-5
        assert np.quantile(off, 0.95) < 1e-3


def test_a_post_is_passed_on_the_side_that_is_asked_for(paper_points, vehicle):
    """On the wrong side the limit pushes the car across."""
    basis = Basis(len(paper_points))
    motion = Kinematics(basis.even(20), paper_points, vehicle.path_offset)
    at = 500
    for side, sign in (("left", 1.0), ("right", -1.0)):
        post = motion.jets[0][at] + sign * 400 * motion.left[at]  # the car has it on the wrong hand
        obstacle = Obstacle(kind="post", key="post", shape=Shape.disc(tuple(post), 10.0), side=side)
        rows = Clearances(basis, vehicle, barriers_of(Course(obstacles=(obstacle,)), vehicle.body)).constraints(
            paper_points
        )
        beside = int(rows[0].values.argmax())
        assert rows[0].values[beside] > 400
        towards = np.concatenate([np.full(len(paper_points), part) for part in sign * motion.left[at]])
        assert rows[0].slopes[beside] @ towards[rows[0].columns[beside]] < -0.5


def test_a_post_that_the_path_never_comes_beside_has_the_side_on_which_the_path_begins(paper_points, vehicle):
    """As the judge of a run has it: the post is behind the start, far away, and to the right of the car or its left."""
    basis = Basis(len(paper_points))
    motion = Kinematics(basis.even(20), paper_points, vehicle.path_offset)
    for hand, sign in (("left", -1.0), ("right", 1.0)):
        post = motion.jets[0][0] - 900 * motion.ahead[0] + sign * 700 * motion.left[0]
        for side in ("left", "right"):
            obstacle = Obstacle(kind="post", key="post", shape=Shape.disc(tuple(post), 10.0), side=side)
            clearances = Clearances(basis, vehicle, barriers_of(Course(obstacles=(obstacle,)), vehicle.body))
            (row,) = clearances.constraints(paper_points)
            assert (row.worst > 400) == (side != hand)


def test_the_side_of_a_post_is_that_of_the_judge(vehicle):
    """Posts anywhere about winding paths, far off and near: `course.judge` shares no code with the limit."""
    random = np.random.default_rng(6)
    basis = Basis(24)
    both = 0
    for _ in range(12):
        heading = np.cumsum(random.normal(size=24) * 0.35)
        points = np.cumsum(220 * np.stack([np.cos(heading), np.sin(heading)], axis=1), axis=0)
        motion = Kinematics(basis.even(20), points, vehicle.path_offset)
        car = vehicle.car
        along = complex(*place_of(CarPoint.FORK, car)) - complex(-car.wheelbase, car.drive_wheel_offset)
        fork = motion.track @ [1, 1j] + along * (motion.ahead @ [1, 1j])
        still = np.zeros(len(fork))
        poses = RunPoses(fork=fork, heading=np.angle(motion.ahead @ [1, 1j]), steering=still, travel=still)
        for spot in motion.jets[0][random.integers(len(fork), size=25)] + random.normal(size=(25, 2)) * 500:
            post = Obstacle(kind="post", key="post", shape=Shape.disc(tuple(spot), 10.0), side="left")
            judged = judge(poses, car, vehicle.body, Course(obstacles=(post,)))
            clearance = judged.approaches[0][1].clearance
            if clearance > 30.0:
                barriers = barriers_of(Course(obstacles=(post,)), vehicle.body)
                (row,) = Clearances(basis, vehicle, barriers).constraints(points)
                assert (row.worst > 0) == (judged.sides[0] != "left")
                both += judged.sides[0] != "left"
    print(f"{both} of 300 on the wrong side")
    assert 50 < both < 250


def test_gates_are_passed_in_their_order_where_the_path_is_nearest(vehicle):
    """On a path that crosses itself: against all rows of places on a coarse grid."""
    angle = np.linspace(0, 2 * pi, 24)
    points = 1500 * np.stack([np.sin(angle), np.sin(angle) * np.cos(angle)], axis=1)
    basis = Basis(len(points))
    motion = Kinematics(basis.even(3), points, vehicle.path_offset)
    gates = tuple(
        Gate(key=str(k), place=Shape.disc(spot, 20.0))
        for k, spot in enumerate([(0.0, 30.0), (900.0, 400.0), (10.0, 0.0), (-1000.0, -500.0)])
    )
    u = passing_places(motion, gates, vehicle)
    assert (np.diff(u) >= -1e-9).all()
    x, y = planned_place(gates[0], vehicle)
    track = motion.point(x, y)
    off = np.stack([np.linalg.norm(track - gate.place.points[0], axis=1) ** 2 for gate in gates])
    best = min(
        combinations_with_replacement(range(len(track)), 4), key=lambda row: sum(off[k, at] for k, at in enumerate(row))
    )
    assert np.abs(u - motion.places.u[list(best)]).max() < motion.places.u[1]


def test_free_gates_get_the_order_of_the_shortest_way():
    random = np.random.default_rng(2)
    worse = 0
    for _ in range(10):
        spots = random.uniform(0, 5000, (5, 2))
        gates = tuple(Gate(key=str(k), place=Shape.disc(tuple(spot), 50.0), free=True) for k, spot in enumerate(spots))
        start = Gate(key="start", place=Shape.disc((0.0, 0.0), 1.0), heading=0.7)
        its_course = Course(gates=gates, start=start)
        best = min(_tour(its_course, row) for row in permutations(gates))
        assert _tour(its_course, in_order(its_course).gates) == pytest.approx(best)
        cost = _tour(its_course, _improved(its_course, _inserted(its_course, [], list(gates))))
        worse += cost > 1.02 * best
    print(f"without trying all, {worse} of 10 are longer by 2 % or more")
    assert worse <= 3


def test_gates_with_an_order_keep_it():
    gates = tuple(
        Gate(key=str(k), place=Shape.disc((x, 0.0), 50.0), free=k == 3) for k, x in enumerate([3000, 1000, 2000, 1500])
    )
    start = Gate(key="start", place=Shape.disc((0.0, 0.0), 1.0))
    order = [gate.key for gate in in_order(Course(gates=gates, start=start)).gates]
    assert [key for key in order if key != "3"] == ["0", "1", "2"]
    assert set(order) == {"0", "1", "2", "3"}


def test_a_way_round_something_begins_in_the_direction_of_its_gate():
    """A course on which the short way from its second gate leads back, round a zone right before the car."""
    case = courses.case(1, 20)
    design, _ = course_of(case.text, Path("case.toml"))
    task = task_of(design, drawn=None, near=None, within=25.0, calm=None, tightening=Margins())
    route = route_of(task.course, task.vehicle)
    second = int(np.flatnonzero(route.is_stop)[2])
    gate = task.course.gates[1]
    ahead = np.array([np.cos(gate.heading), np.sin(gate.heading)])
    assert not route.is_stop[second + 1]
    assert (route.places[second + 1] - route.places[second]) @ ahead > 200


def test_room_besides_gives_way_before_a_gate_does(paper_points, vehicle):
    """A gate has its limit and, by a tenth of the weight, one that is nearer by the room, up to its middle."""
    basis = Basis(len(paper_points))
    gate = Gate(key="course.gates.1", place=Shape.disc((4000.0, 2000.0), 50.0))
    for room, most in ((20.0, 20.0), (90.0, 49.98)):
        hard, soft = Passing(basis, (gate,), None, None, vehicle, spare={gate.key: room}).constraints(paper_points)
        np.testing.assert_allclose(soft.values, hard.values + most)
        assert soft.weight == pytest.approx(hard.weight / 10)
        assert (soft.limit, hard.limit) == (replace(hard.limit, spare=True), PathLimit(LimitKind.GATE, gate.key))
        assert (soft.slopes == hard.slopes).all()
