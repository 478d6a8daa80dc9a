"""Random courses for the planner: grown round a drivable path that is then thrown away, and ones that cannot be driven.

A drivable path is a curve of random curvature: piecewise linear in the arc length, within what steering and cam hold.
Gates are put on it where the middle of the car passes, with some error; posts, walls and zones where the car does not
come near; the field round all of it. A course that cannot be driven is such a course with one thing wrong, and the
limit that must be blamed is known.

The generator and the check of the result share no code with the planner: the sweep here is by brute force.

    python -m tests.studies.courses --cases 50 --broken 20 --seed 1 [--record]
"""

import argparse
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

PAGE = Path(__file__).parents[2] / "docs" / "studies" / "courses.md"
STEP = 5.0  # mm of the drivable path
L, A1, A2 = 167.0, 37.0, 201.0
FRONT, LENGTH, WIDTH = 45.0, 260.0, 270.0
MIDDLE = (A1 - A2) / 2
CAR = f"""
[car]
wheelbase_mm = {L}
drive_wheel_offset_mm = {A1}
idle_wheel_offset_mm = {A2}
max_steering_angle_deg = 35.0

[car.outline]
length_mm = {LENGTH}
width_mm = {WIDTH}
front_overhang_mm = {FRONT}

[cam]
base_radius_mm = 70.0
mid_plane_mm = 25.0
thickness_mm = 3.0
blend_deg = 12.0

[follower]
radius_mm = 2.5
length_mm = 40.0

[play]
least_deg = 0.5
greatest_deg = 0.95

[[train.stages]]
centre_distance_mm = 45.0
driver = {{ teeth = 30 }}
driven = {{ teeth = 150 }}

[[train.stages]]
centre_distance_mm = 40.0
driver = {{ teeth = 40 }}
driven = {{ teeth = 120 }}

[[train.stages]]
centre_distance_mm = 40.0
driver = {{ teeth = 40 }}
driven = {{ teeth = 120 }}

[train]
module_mm = 0.5
pressure_angle_deg = 20.0
width_mm = 5.0
bearing_span_mm = 80.0
grade = 7
"""


@dataclass(frozen=True)
class Case:
    """A course as text.

    Attributes:
        name: number of the case, and what is wrong with it.
        text: design without a path.
        culprits: limits of which one must be blamed; empty if it can be driven.
        obstacles: circles and polygons with the keys of the course, for the judge.
        field: low and high corner.
        margin: distance to keep, mm.
    """

    name: str
    text: str
    culprits: tuple[str, ...]
    obstacles: tuple[tuple[str, np.ndarray, float], ...]
    field: tuple[np.ndarray, np.ndarray]
    margin: float


def drivable(random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Middle of the rear axle and heading along a drivable path, which may cross itself."""
    while True:
        length = random.uniform(6000, 14000)
        knots = np.arange(0, length + 700, 700.0)
        curvature = random.uniform(-1, 1, len(knots)) / random.uniform(900, 1500)
        curvature[0] = curvature[-1] = 0.0
        s = np.arange(0, length, STEP)
        heading = np.cumsum(np.interp(s, knots, curvature)) * STEP + random.uniform(0, 2 * np.pi)
        place = np.cumsum(np.stack([np.cos(heading), np.sin(heading)], axis=1), axis=0) * STEP
        if np.ptp(place, axis=0).max() > 2500:
            return place, heading


def outline(place: np.ndarray, heading: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Points of the car, x ahead of the rear axle and y left of its middle, at every pose."""
    c, s = np.cos(heading)[:, None], np.sin(heading)[:, None]
    x, y = points[:, 0], points[:, 1]
    return np.stack([place[:, :1] + c * x - s * y, place[:, 1:] + s * x + c * y], axis=2)


BODY = np.array(
    [[L + FRONT, WIDTH / 2], [L + FRONT - LENGTH, WIDTH / 2], [L + FRONT - LENGTH, -WIDTH / 2], [L + FRONT, -WIDTH / 2]]
)


def inside_distance(points: np.ndarray, place: np.ndarray, heading: np.ndarray) -> np.ndarray:
    """Distance of points from the car's rectangle at each pose, less than 0 inside; shape (poses, points)."""
    off = points[None] - place[:, None]
    c, s = np.cos(heading)[:, None], np.sin(heading)[:, None]
    x, y = c * off[..., 0] + s * off[..., 1], -s * off[..., 0] + c * off[..., 1]
    dx = np.maximum(x - (L + FRONT), (L + FRONT - LENGTH) - x)
    dy = np.abs(y) - WIDTH / 2
    outside = np.hypot(np.maximum(dx, 0), np.maximum(dy, 0))
    return np.where((dx < 0) & (dy < 0), np.maximum(dx, dy), outside)


def rim(corners: np.ndarray, spacing: float = 2.0) -> np.ndarray:
    """Points round a polygon, or along a line of two."""
    closed = np.vstack([corners, corners[:1]]) if len(corners) > 2 else corners
    pieces = [
        a + np.linspace(0, 1, max(int(np.hypot(*(b - a)) / spacing), 1), endpoint=False)[:, None] * (b - a)
        for a, b in pairwise(closed)
    ]
    return np.vstack([*pieces, closed[-1:]])


def case(seed: int, number: int) -> Case:
    """A course that can be driven."""
    random = np.random.default_rng([seed, number])
    place, heading = drivable(random)
    margin = float(random.choice([0.0, 10.0, 20.0]))
    low = place.min(axis=0) - random.uniform(300, 900, 2)
    high = place.max(axis=0) + random.uniform(300, 900, 2)
    parts, obstacles = [], []
    marks = np.sort(random.uniform(0.06, 0.94, random.integers(2, 8)))
    marks = marks[np.append(True, np.diff(marks) > 0.06)]
    for mark in marks:
        at = int(mark * len(place))
        radius = float(random.choice([20.0, 50.0, 100.0]))
        shift = random.normal(size=2)
        x, y = place[at] + shift / np.hypot(*shift) * random.uniform(0, 0.7) * radius
        direction = f"heading_deg = {_wrapped(heading[at]):.3f}\nheading_tolerance_deg = 45.0\n" * (
            random.random() < 0.3
        )
        parts.append(f"[[course.gates]]\nat_mm = [{x:.2f}, {y:.2f}]\nradius_mm = {radius}\n{direction}")
    for kind in random.choice(["post", "post", "wall", "zone"], random.integers(0, 9)):
        at = int(random.uniform(0.08, 0.97) * len(place))
        side = random.choice([-1.0, 1.0])
        normal = side * np.array([-np.sin(heading[at]), np.cos(heading[at])])
        centre = place[at] + normal * random.uniform(190, 450) + random.normal(size=2) * 20
        if kind == "post":
            points, reach = centre[None], float(random.choice([10.0, 25.0]))
            text = f"[[course.posts]]\nat_mm = [{centre[0]:.3f}, {centre[1]:.3f}]\nradius_mm = {reach}\n"
        elif kind == "wall":
            angle, half = random.uniform(0, np.pi), random.uniform(100, 500)
            along = half * np.array([np.cos(angle), np.sin(angle)])
            points, reach = np.stack([centre - along, centre + along]).round(3), 5.0
            text = f"[[course.walls]]\nline_mm = {points.tolist()}\nthickness_mm = 10.0\n"
        else:
            size = random.uniform(80, 400, 2)
            points, reach = (centre + size / 2 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])).round(3), 0.0
            text = f"[[course.zones]]\noutline_mm = {points.tolist()}\n"
        every = rim(points, 10.0) if len(points) > 1 else points
        if inside_distance(every, place[::4], heading[::4]).min() < reach + margin + 25:
            continue
        if np.any(every < low + 20) or np.any(every > high - 20):
            continue
        parts.append(text)
        number_of_kind = sum(part.startswith(text.split("\n")[0]) for part in parts)
        obstacles.append((f"course.{kind}s.{number_of_kind}", points, reach))
    text = _text(f"course_{number}", parts, place, heading, low, high, margin)
    return Case(f"{number}", text, (), tuple(obstacles), (low.round(2), high.round(2)), margin)


def _wrapped(angle: float) -> float:
    """An angle in degrees between -180 and 180."""
    return float((np.degrees(angle) + 180) % 360 - 180)


def _text(name, parts, place, heading, low, high, margin) -> str:
    order = {"[[course.gates": 0, "[[course.posts": 1, "[[course.walls": 2, "[[course.zones": 3}
    parts = sorted(parts, key=lambda part: order[part[:14]])
    size = high - low
    return (
        f'name = "{name}"\n{CAR}\n[course]\nmargin_mm = {margin}\n'
        f"field = {{ corner_mm = [{low[0]:.2f}, {low[1]:.2f}], size_mm = [{size[0]:.2f}, {size[1]:.2f}] }}\n"
        f"start = {{ at_mm = [{place[0, 0]:.3f}, {place[0, 1]:.3f}], heading_deg = {_wrapped(heading[0]):.4f} }}\n"
        f"finish = {{ at_mm = [{place[-1, 0]:.3f}, {place[-1, 1]:.3f}], radius_mm = 50.0 }}\n\n" + "\n".join(parts)
    )


def broken(seed: int, number: int) -> Case:
    """A course that cannot be driven, for one reason."""
    random = np.random.default_rng([seed, 1_000_000 + number])
    place, heading = drivable(random)
    low, high = place.min(axis=0) - 700, place.max(axis=0) + 700
    kind = ("turn", "gap", "field", "finish", "direction")[number % 5]
    at = int(random.uniform(0.35, 0.65) * len(place))
    x, y = place[at]
    ahead = np.array([np.cos(heading[at]), np.sin(heading[at])])
    left = np.array([-ahead[1], ahead[0]])
    gate = "[[course.gates]]\nat_mm = [{:.2f}, {:.2f}]\nradius_mm = {}\n"
    parts: list[str] = []
    obstacles: list[tuple[str, np.ndarray, float]] = []
    culprits: tuple[str, ...] = ()
    if kind == "turn":  # forward and back again within less than the car can turn in
        for step, side in ((0.0, 0.0), (150.0, 60.0), (0.0, 120.0)):
            spot = place[at] + step * ahead + side * left
            angle = _wrapped(heading[at] + np.radians((0, 90, 180)[len(parts)]))
            parts.append(gate.format(*spot, 5.0) + f"heading_deg = {angle:.2f}\nheading_tolerance_deg = 20.0\n")
        culprits = ("turn", "pressure angle", "convex radius", "course.gates")
    elif kind == "gap":  # a wall across the field with a gap that is narrower than the car
        far = 20_000.0
        for side in (1, -1):
            ends = np.stack([place[at] + side * left * 120, place[at] + side * left * far]).round(2)
            ends = np.stack([ends[0], _clipped(ends[0], ends[1], low, high)])
            parts.append(f"[[course.walls]]\nline_mm = {ends.round(2).tolist()}\nthickness_mm = 10.0\n")
            obstacles.append((f"course.walls.{len(parts)}", ends, 5.0))
        parts.insert(0, gate.format(x, y, 30.0))
        culprits = ("course.walls",)
    elif kind == "field":  # a gate so near to the edge that the car does not fit
        low, high = place.min(axis=0) - 700, place.max(axis=0) + 700
        low[0] = x - 60
        place_kept = place[:, 0] > low[0] + 330
        if place_kept[0] and place_kept[-1]:
            parts.append(gate.format(x, y, 20.0))
            culprits = ("course.field", "course.gates")
        else:
            low[0], kind = place[:, 0].min() - 700, "finish"
    if kind == "finish":  # the finish right behind the start
        back = place[0] - 250 * np.array([np.cos(heading[0]), np.sin(heading[0])])
        parts = []
        place, heading = np.stack([place[0], back]), heading[:2]
        low, high = place.min(axis=0) - 330, place.max(axis=0) + 330
        culprits = ("course.field", "turn", "course.finish", "pressure angle", "convex radius")
    elif kind == "direction":  # two gates in line, the second against the direction of travel, with no room to turn
        one, two = place[at], place[at] + 400 * ahead
        turned = _wrapped(heading[at])
        parts.append(gate.format(*one, 5.0) + f"heading_deg = {turned:.2f}\nheading_tolerance_deg = 10.0\n")
        parts.append(gate.format(*two, 5.0) + f"heading_deg = {turned - 180:.2f}\nheading_tolerance_deg = 10.0\n")
        for side in (1, -1):
            ends = np.stack([one - 600 * ahead + side * left * 260, two + 600 * ahead + side * left * 260]).round(2)
            parts.append(f"[[course.walls]]\nline_mm = {ends.tolist()}\nthickness_mm = 10.0\n")
            obstacles.append((f"course.walls.{len(obstacles) + 1}", ends, 5.0))
        culprits = ("turn", "course.walls", "course.gates", "pressure angle", "convex radius")
    text = _text(f"broken_{number}", parts, place, heading, low, high, 0.0)
    return Case(f"{number} {kind}", text, culprits, tuple(obstacles), (low, high), 0.0)


def _clipped(a: np.ndarray, b: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Where the way from a towards b leaves the field, a little beyond."""
    share = 1.0
    for axis in range(2):
        for edge in (low[axis] - 50, high[axis] + 50):
            if (b[axis] - edge) * (a[axis] - edge) < 0:
                share = min(share, (edge - a[axis]) / (b[axis] - a[axis]))
    return a + share * (b - a)


def swept(text: str, course: Case, factor: float = 1.0) -> dict[str, float]:
    """Least distance of the planned car from each obstacle and from the edge, by brute force, mm.

    At another spacing path and obstacles are `factor` times as far from the origin; car and field stay.
    """
    import tomllib

    from scipy.interpolate import BSpline

    path = tomllib.loads(text)["path"]
    points = factor * np.array(path["control_points_mm"])
    last = len(points) - 5
    knots = np.concatenate([np.zeros(5), np.arange(last + 1), np.full(5, last)])
    spline = BSpline(knots, points, 5)
    u = np.linspace(0, last, 400 * last + 1)
    r, r1 = spline(u), spline(u, nu=1)
    heading = np.arctan2(r1[:, 1], r1[:, 0])
    # The path runs offset_mm to the right of the drive wheel; the middle of the axle (A1 + A2) / 2 to its right.
    normal = np.stack([-np.sin(heading), np.cos(heading)], axis=1)
    middle = r + (path["offset_mm"] - (A1 + A2) / 2) * normal
    result = {}
    for key, corners, reach in course.obstacles:
        every = rim(factor * corners) if len(corners) > 1 else factor * corners
        near = (
            np.hypot(*(middle[:, None] - every[None, :: max(len(every) // 20, 1)]).transpose(2, 0, 1)).min(axis=1) < 900
        )
        if near.any():
            result[key] = float(inside_distance(every, middle[near], heading[near]).min()) - reach
    corners = outline(middle, heading, BODY)
    low, high = course.field
    result["course.field"] = float(min((corners - low).min(), (high - corners).min()))
    return result


def planned(course: Case, seeds: int = 1) -> tuple[str, bool, str, float]:
    """Outcome of a course: its name, whether that is right, words, seconds of processor time."""
    from cadgen import Design

    began = time.process_time()
    try:
        plan = Design.from_toml(course.text, train_only=True).plan(seeds=seeds)
    except Exception as error:  # a study goes on, and says so
        kind = type(error).__name__
        fine = kind == "DesignError" and any(name in str(error) for name in course.culprits)
        return course.name, fine, f"{kind}: {error}", time.process_time() - began
    words = " | ".join(plan.sentences)
    if not course.culprits:
        if not plan.sound:
            failed = (
                ""
                if plan.cam is None
                else ", ".join(f"{check.name} {check.value:.2f} {check.place}" for check in plan.cam.failed)
            )
            return course.name, False, f"{words} {failed}", time.process_time() - began
        short = {key: gap for key, gap in swept(plan.computed.text, course).items() if gap < course.margin - 0.1}
        return course.name, not short, f"{words} {short or ''}", time.process_time() - began
    reasons = plan.facts()["reasons"]
    fine = bool(reasons) and reasons[0]["limit"].startswith(course.culprits)
    return course.name, fine, words, time.process_time() - began


def record(given: argparse.Namespace, summary: str, wrong: list, seconds: list[float]) -> None:
    """Write the page."""
    from cadgen import __version__

    text = (__doc__ or "").strip().split("\n\n")
    command = (
        f"python -m tests.studies.courses --cases {given.cases} --broken {given.broken} --seed {given.seed} --record"
    )
    failures = "\n".join(f"- {row[1]}: {row[3]}" for row in wrong) or "none"
    PAGE.write_text(
        f"# Random courses planned\n\n`{command}`, cadgen {__version__}.\n\n{text[1]}\n\n{text[2]}\n\n"
        f"**{summary[0].upper()}{summary[1:]}.** Processor time of a course: {np.median(seconds):.0f} s in the middle, "
        f"{max(seconds):.0f} s at most.\n\nCourses that failed: {failures}\n",
        encoding="utf-8",
    )


def main() -> int:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--cases", type=int, default=50)
    options.add_argument("--broken", type=int, default=20)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--seeds", type=int, default=1)
    options.add_argument("--processes", type=int, default=2)
    options.add_argument("--record", action="store_true")
    options.add_argument("--only", type=int)
    given = options.parse_args()
    numbers = range(given.cases) if given.only is None else [given.only]
    courses = [case(given.seed, number) for number in numbers] + [broken(given.seed, k) for k in range(given.broken)]
    with ProcessPoolExecutor(given.processes) as pool:
        rows = []
        for course, row in zip(courses, pool.map(planned, courses, [given.seeds] * len(courses)), strict=True):
            rows.append((course, *row))
            print("ok  " if row[1] else "FAIL", *row[0:1], f"{row[3]:.0f} s", row[2][:300], flush=True)
    solvable = [row for row in rows if not row[0].culprits]
    other = [row for row in rows if row[0].culprits]
    summary = (
        f"{sum(row[2] for row in solvable)} of {len(solvable)} courses planned, each clear by the brute-force sweep; "
        f"{sum(row[2] for row in other)} of {len(other)} that cannot be driven refused with the right limit named"
    )
    print(summary)
    if given.record:
        record(given, summary, [row for row in rows if not row[2]], [row[4] for row in rows])
    return 0 if all(row[2] for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
