"""The swept car against a brute-force sweep, and the limits of what a post is."""

import numpy as np
import pytest

from cadgen.car.course.approach import approach, approach_to_edge
from cadgen.car.course.body import CarBody, CarWheel, RunPoses
from cadgen.car.course.layout import Obstacle, Shape
from tests.car.course.sweep_truth import between, corners_on_floor

CORNERS = ((60.0, 140.0), (-220.0, 130.0), (-230.0, -150.0), (-90.0, -60.0), (60.0, -140.0))
WHEELS = (
    CarWheel(name="front wheel", centre=(0.0, 0.0), radius=90.0, width=12.0, steered=True),
    CarWheel(name="drive wheel", centre=(-170.0, 160.0), radius=64.0, width=8.0),
    CarWheel(name="idle wheel", centre=(-170.0, -170.0), radius=64.0, width=8.0),
)
BODY = CarBody(corners=CORNERS, clearance=0.0, wheels=WHEELS)


def run(seed: int, count: int = 400) -> RunPoses:
    """A winding run by its curvature; coarse enough that the nearest pose lies between two of those given."""
    rng = np.random.default_rng(seed)
    s = np.linspace(0.0, 5000.0, count)
    curvature = sum(rng.normal() * 6e-4 * np.sin(k * s / 800 + rng.uniform(0, 6)) for k in range(1, 5))
    step = s[1]
    heading = np.concatenate([[0.0], np.cumsum((curvature[1:] + curvature[:-1]) / 2 * step)])
    ahead = np.exp(1j * (heading[1:] + heading[:-1]) / 2)
    fork = np.concatenate([[0.0], np.cumsum(ahead * step)])
    return RunPoses(fork=fork, heading=heading, steering=np.arctan(170 * curvature), travel=s)


def fine(poses: RunPoses, times: int):
    place = np.linspace(0, len(poses) - 1, times * (len(poses) - 1) + 1)
    number = np.arange(len(poses))
    fork = np.interp(place, number, poses.fork.real), np.interp(place, number, poses.fork.imag)
    return np.stack(fork, 1), np.interp(place, number, poses.heading), np.interp(place, number, poses.steering)


def brute(poses: RunPoses, points, filled):
    fork, heading, steering = fine(poses, 10)
    nearest = {"outline": between(corners_on_floor(CORNERS, fork, heading), points, filled).min()}
    for wheel in WHEELS:
        r, w = wheel.radius, wheel.width / 2
        rectangle = np.array([[r, w], [-r, w], [-r, -w], [r, -w]])
        turn = steering if wheel.steered else 0 * steering
        c, s = np.cos(turn)[:, None], np.sin(turn)[:, None]
        x = wheel.centre[0] + c * rectangle[:, 0] - s * rectangle[:, 1]
        y = wheel.centre[1] + s * rectangle[:, 0] + c * rectangle[:, 1]
        ch, sh = np.cos(heading)[:, None], np.sin(heading)[:, None]
        corners = np.stack([fork[:, :1] + ch * x - sh * y, fork[:, 1:] + sh * x + ch * y], -1)
        nearest[wheel.name] = between(corners, points, filled).min()
    part = min(nearest, key=nearest.__getitem__)
    return nearest[part], part


def shape(rng, poses, kind):
    far = poses.fork[rng.integers(80, len(poses) - 80)] + rng.uniform(280, 900) * np.exp(1j * rng.uniform(0, 6.3))
    around = [far + rng.uniform(20, 150) * np.exp(1j * (k + rng.uniform(0, 0.8)) * 1.256) for k in range(5)]
    points = {"post": [far], "wall": around[:3], "zone": around}[kind]
    return tuple((z.real, z.imag) for z in points)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["post", "wall", "zone"])
def test_clearances_are_those_of_a_brute_force_sweep(kind):
    """Within 0.05 mm, with the same part; where they overlap, less than 0."""
    worst, overlaps = 0.0, 0
    for seed in range(8):
        rng, poses = np.random.default_rng(seed), run(seed)
        points = shape(rng, poses, kind)
        thing = Obstacle(kind=kind, key="x", shape=Shape(points, filled=kind == "zone", reach=10.0))
        found = approach(poses, BODY, thing)
        there, part = brute(poses, points, kind == "zone")
        if there < 0:
            assert found.clearance < -10
            overlaps += 1
            continue
        worst = max(worst, abs(found.clearance + 10.0 - there))
        assert found.part == part or abs(found.clearance + 10.0 - there) < 1e-3
        assert found.clearance + 10.0 <= there + 5e-3  # no nearer pose is missed
    print(f"{kind}: {worst:.2e} mm, {overlaps} of 8 overlap")
    assert worst <= 0.01
    assert overlaps < 6


def test_a_low_post_passes_under_the_body_but_not_under_a_wheel():
    s = np.linspace(0, 1000, 50)
    poses = RunPoses(fork=s + 0j, heading=0 * s, steering=0 * s, travel=s)
    body = CarBody(corners=((0, 100), (-200, 100), (-200, -100), (0, -100)), clearance=30.0, wheels=WHEELS[1:])
    low = Obstacle(kind="post", key="x", shape=Shape.disc((500.0, 0.0), 10.0), height=29.0)
    high = Obstacle(kind="post", key="x", shape=Shape.disc((500.0, 0.0), 10.0), height=30.0)
    assert approach(poses, body, high).clearance == pytest.approx(-110.0, abs=2.2)
    under = approach(poses, body, low)
    assert under.clearance == pytest.approx(156.0 - 10.0, abs=5e-3)
    assert under.part == "drive wheel"


@pytest.mark.parametrize(("way", "clearance"), [(0.0, 100.0), (299.0, -99.0), (250.0, -50.0), (100.0, 100.0)])
def test_the_edge_is_measured_from_inside_and_beyond(way, clearance):
    """A square car of 200 mm that drives towards the right side of a field of 600 by 400 mm."""
    s = np.linspace(0, way or 1.0, 30)
    body = CarBody(corners=((100, 100), (-100, 100), (-100, -100), (100, -100)), clearance=0.0, wheels=())
    poses = RunPoses(fork=s - 100 + 0j, heading=0 * s, steering=0 * s, travel=s)
    edge = Shape(((-300.0, -200.0), (200.0, -200.0), (200.0, 200.0), (-300.0, 200.0)), filled=True)
    assert approach_to_edge(poses, body, edge).clearance == pytest.approx(clearance, abs=5e-3 if clearance > 0 else 2.0)


def test_a_car_within_a_zone_overlaps_it():
    s = np.linspace(0, 10, 5)
    poses = RunPoses(fork=s + 0j, heading=0 * s, steering=0 * s, travel=s)
    zone = Shape(((-900.0, -900.0), (900.0, -900.0), (900.0, 900.0), (-900.0, 900.0)), filled=True)
    assert approach(poses, BODY, Obstacle(kind="zone", key="x", shape=zone)).clearance < -600


def test_a_long_way_beside_a_wall_takes_few_poses(monkeypatch):
    """Along a wall every pose is as near as any other: the bound by the distance's bend closes them all the same."""
    s = np.linspace(0, 8000, 3000)
    poses = RunPoses(fork=s + 0j, heading=0 * s, steering=0 * s, travel=s)
    wall = Obstacle(kind="wall", key="x", shape=Shape(((-1000.0, 300.0), (9000.0, 300.0))))
    asked = []
    at = RunPoses.at
    monkeypatch.setattr(RunPoses, "at", lambda self, place: asked.append(len(place)) or at(self, place))
    assert approach(poses, BODY, wall).clearance == pytest.approx(136.0, abs=5e-3)
    assert sum(asked) < 20_000


def test_a_wall_across_the_way_is_met_by_half_the_car():
    """A car 140 long and 160 wide: where a line crosses its middle, that is 70 mm from its front and rear."""
    s = np.linspace(0, 1000, 50)
    poses = RunPoses(fork=s + 0j, heading=0 * s, steering=0 * s, travel=s)
    body = CarBody(corners=((20, 80), (-120, 80), (-120, -80), (20, -80)), clearance=0.0, wheels=WHEELS[:1])
    wall = Obstacle(kind="wall", key="x", shape=Shape(((500.0, -300.0), (500.0, 300.0))))
    assert approach(poses, body, wall).clearance == pytest.approx(-70.0, abs=2.0)
