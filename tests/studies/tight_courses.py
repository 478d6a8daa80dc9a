"""Tight courses with witnesses for the planner: turns near the least radius, posts on given sides, draws of a spacing.

    python -m tests.studies.tight_courses --cases 200 --seed 1 [--processes 2] [--log FILE] [--record]

A witness is a path of straights and of turns to either side whose radius is 1.05 to 1.5 times the least one that the
fork holds for the middle of the car, with smooth ramps of the curvature of 300 to 700 mm between them; the base radius
is 70, 90 or 120 mm. Discs and lines as gates are put on it, 2 to 5 posts of a given side 10 to 60 mm beside the car,
2 to 8 others and a wall 40 to 200 mm; every other course asks for the heading of its finish within 10 degrees. Then the
witness is thrown away.

Every fourth course is drawn: posts, gates, start and finish stand 5 to 25 % nearer and farther than they are stated,
and one cam must serve all. There the turns keep their radius and the posts their room at the least spacing.

A course counts only if its witness, as a design of its own, passes every check, and where it is drawn can be set for
five spacings. It is planned where every check passes and a sweep by brute force, which shares no code with the planner,
finds the car clear of everything, at both ends of the draw, too. A refusal that is said to be proven is wrong in any
case.
"""

import json
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from math import pi, radians, tan

import numpy as np

from tests.studies.command import PAGES, options, tell
from tests.studies.courses import A1, A2, MIDDLE, STEP, WIDTH, Case, L, _text, _wrapped, inside_distance, rim, swept
from tests.studies.journal import share, stamp

REPORT = PAGES / "tight_courses.md"
LEAST = L / tan(radians(35.0) * 0.98) + abs(MIDDLE)  # mm, least radius of the middle of the rear axle
RATIO, SHARE = 45.0, 1 - 12 / 360  # turns of the drive wheel for one of the cam; share of its turn before the blend
LEVER, STEEPEST = 25.0, 28.0  # mm from the fork axis to the disc's middle; degrees of the pressure angle
DRAWN = 4  # one of so many courses is drawn
SETTINGS = """
[settings]
disc_from_mm = -9.0
disc_to_mm = 10.0
disc_step_mm = 0.05
head_from_mm = -0.5
head_to_mm = 0.5
head_step_mm = 0.005
wheel_from_mm = 5.0
wheel_to_mm = 200.0
wheel_step_mm = 0.01
start_within_mm = 60.0
start_step_mm = 1.0
start_heading_within_deg = 8.0
start_heading_step_deg = 0.1
"""


@dataclass(frozen=True)
class TightCourse:
    """A course with its witness.

    Attributes:
        case: course as the planner and the judge have it.
        known: text of the witness, a design with a path.
        ends: least and greatest spacing as factors on the stated one.
    """

    case: Case
    known: str
    ends: tuple[float, float]


def witness(random: np.random.Generator, least: float, base: float) -> tuple[np.ndarray, np.ndarray]:
    """Middle of the rear axle and heading along a path of straights and tight turns, shapes (k, 2) and (k,).

    Args:
        random: source of the path.
        least: least radius of a turn, mm.
        base: base radius of the cam, mm; paths that are too steep for it are thrown away.
    """
    while True:
        place, heading, curvature = _path(random, least)
        lift = LEVER * L * curvature / (1 - abs(MIDDLE) * np.abs(curvature))  # at most, on either side
        slope = np.gradient(lift, STEP) * len(place) * STEP / SHARE / (2 * pi)  # by the cam angle
        if np.degrees(np.arctan2(np.abs(slope), base - np.abs(lift))).max() < STEEPEST:
            return place, heading


def _path(random: np.random.Generator, least: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    curvature = [np.zeros(int(random.uniform(150, 500) / STEP))]
    length = random.uniform(300, 700)
    for _ in range(random.integers(2, 5)):
        most = 1 / (least * random.uniform(1.05, 1.5)) * random.choice([-1.0, 1.0])
        along = np.linspace(0, 1, int(length / STEP))
        ramp = most * along**2 * (3 - 2 * along)
        hold = max(random.uniform(0.5, 3.5) - abs(most) * length, 0.0) / abs(most)
        straight = np.zeros(int(random.uniform(100, 700) / STEP))
        curvature += [ramp, np.full(int(hold / STEP), most), ramp[::-1], straight]
    every = np.concatenate(curvature)
    heading = np.cumsum(every) * STEP + random.uniform(0, 2 * pi)
    place = np.cumsum(np.stack([np.cos(heading), np.sin(heading)], axis=1), axis=0) * STEP
    return place, heading, every


def course(seed: int, number: int) -> TightCourse:
    """A course and its witness as a design."""
    random = np.random.default_rng([seed, number, 27])
    drawn = number % DRAWN == DRAWN - 1
    nearest, farthest = (1 - random.uniform(0.05, 0.25), 1 + random.uniform(0.05, 0.25)) if drawn else (1.0, 1.0)
    base = float(random.choice([70.0, 90.0, 120.0]))
    place, heading = witness(random, LEAST / nearest, base)
    low = farthest * place.min(axis=0) - random.uniform(250, 400, 2) - (farthest - 1) * 500
    high = farthest * place.max(axis=0) + random.uniform(250, 400, 2) + (farthest - 1) * 500
    low, high = np.minimum(low, place.min(axis=0) - 300), np.maximum(high, place.max(axis=0) + 300)
    parts, obstacles = [], []

    def left_of(at: int) -> np.ndarray:
        return np.array([-np.sin(heading[at]), np.cos(heading[at])])

    def clear(points: np.ndarray, reach: float) -> bool:
        return inside_distance(nearest * points, nearest * place, heading).min() >= reach + 10.0

    for mark in np.linspace(0.15, 0.9, random.integers(2, 6)):
        at, radius = int(mark * len(place)), float(random.choice([15.0, 25.0, 40.0])) + 40.0 * drawn
        x, y = place[at]
        if random.random() < 0.25:
            ends = np.round(place[at] + np.outer([-2 * radius, 2 * radius], left_of(at)), 1).tolist()
            parts.append(f"[[course.gates]]\nfrom_mm = {ends[0]}\nto_mm = {ends[1]}\n")
        else:
            parts.append(f"[[course.gates]]\nat_mm = [{x:.1f}, {y:.1f}]\nradius_mm = {radius}\n")
    for sided in [*[True] * int(random.integers(2, 6)), *[False] * int(random.integers(2, 8))]:
        at, left = int(random.uniform(0.1, 0.9) * len(place)), random.random() < 0.5
        room = random.uniform(10, 60) if sided else random.uniform(40, 200)
        normal = (1.0 if left else -1.0) * left_of(at)
        post = (place[at] + normal * (WIDTH / 2 + 10.0 + room) / nearest).round(1)
        if not clear(post[None], 10.0):
            continue
        # A post on the car's left is passed on its right.
        side = f'side = "{"right" if left else "left"}"\n' * sided
        parts.append(f"[[course.posts]]\nat_mm = [{post[0]}, {post[1]}]\nradius_mm = 10.0\n{side}")
        count = sum(part.startswith("[[course.posts") for part in parts)
        obstacles.append((f"course.posts.{count}", post[None], 10.0))
    at, turned, half = int(random.uniform(0.1, 0.9) * len(place)), random.uniform(0, pi), random.uniform(50, 150)
    middle = place[at] + random.choice([-1.0, 1.0]) * left_of(at) * (WIDTH / 2 + random.uniform(40, 200)) / nearest
    wall = (middle + np.outer([-half, half], [np.cos(turned), np.sin(turned)])).round(1)
    if not drawn and clear(rim(wall), 6.0):  # a wall grows with the draw, and so would its ends
        parts.append(f"[[course.walls]]\nline_mm = {wall.tolist()}\nthickness_mm = 12.0\n")
        obstacles.append(("course.walls.1", wall, 6.0))
    text = _text(f"tight_{number}", parts, place, heading, low, high, 0.0)
    text = text.replace("base_radius_mm = 70.0", f"base_radius_mm = {base}", 1)
    if random.random() < 0.5:
        aimed = f"radius_mm = 50.0, heading_deg = {_wrapped(heading[-1]):.2f}, heading_tolerance_deg = 10.0 }}\n\n"
        text = text.replace("radius_mm = 50.0 }\n\n", aimed, 1)
    if drawn:
        text += (
            f"\n[course.spacing]\nfrom_mm = {1000 * nearest:.1f}\nto_mm = {1000 * farthest:.1f}\nnominal_mm = 1000.0\n"
            f"step_mm = {250 * (farthest - nearest) - 0.1:.2f}\n{SETTINGS}"
        )
    every = np.unique(np.linspace(0, len(place) - 1, int(len(place) * STEP / 110)).astype(int))
    # The drive wheel is on the left of the middle of the axle.
    track = place + (A1 - MIDDLE) * np.stack([-np.sin(heading), np.cos(heading)], axis=1)
    length = float(np.hypot(*np.diff(track, axis=0).T).sum())
    wheel = f"drive_wheel_radius_mm = {1.001 * length / SHARE / (2 * pi * RATIO):.3f}\n"
    path = f'[path]\nspline = "quintic"\noffset_mm = {(A1 + A2) / 2}\nwaypoints_mm = {place[every].round(3).tolist()}\n'
    known = text.replace("[car]\n", f"[car]\n{wheel}", 1) + "\n" + path
    case = Case(str(number), text, (), tuple(obstacles), (low.round(2), high.round(2)), 0.0)
    return TightCourse(case, known, (nearest, farthest))


def failures(text: str, name: str, *, drawn: bool) -> list[str]:
    """Checks that a design with a path fails, at any of its spacings; the share of cars is not asked for."""
    from cadgen import Design

    design = Design.from_toml(text, name)
    cam = design.cam()
    failed = [] if cam.sound else [check.code for check in cam.failed]
    if drawn and not failed:
        failed = [check.code for each in design.card().drawn for check in each.failed]
    return failed


def outcome(seed: int, number: int) -> tuple[int, str, str, float]:
    """Number of a course, what became of it, words, and seconds of processor time."""
    from cadgen import Design

    tight = course(seed, number)
    drawn = tight.ends[0] < 1
    try:
        failed = failures(tight.known, f"tight_{number}", drawn=drawn)
    except Exception as error:
        return number, "no witness", f"{type(error).__name__}: {error}"[:200], 0.0
    if failed:
        return number, "no witness", ", ".join(dict.fromkeys(failed)), 0.0
    began = time.process_time()
    try:
        text = f"{tight.case.text}\n[path]\noffset_mm = {(A1 + A2) / 2}\n"
        plan = Design.from_toml(text, train_only=True).plan(reserve=0)
    except Exception as error:  # a study goes on, and says so
        return number, "fault", f"{type(error).__name__}: {error}"[:300], time.process_time() - began
    seconds = time.process_time() - began
    if not plan.sound:
        failed = [] if plan.cam is None or plan.cam.sound else [str(check.code) for check in plan.cam.failed]
        words = ", ".join([*failed, *(check.code for each in plan.drawn for check in each.failed)])
        return number, "wrong culprit" if plan.proven else "not found", f"{plan.sentences[0][:300]} {words}", seconds
    short = {
        f"{key} at {factor:.2f}": round(gap, 2)
        for factor in dict.fromkeys((1.0, *tight.ends))
        for key, gap in swept(plan.computed.text, tight.case, factor).items()
        if gap < -0.1
    }
    track = plan.computed.plan.path.cost.line.length
    kind = f"drawn {tight.ends[0]:.2f} to {tight.ends[1]:.2f}; " if drawn else ""
    return number, "touches" if short else "planned", f"{kind}{track:.0f} mm {short or ''}", seconds


def main() -> int:
    given = options(__doc__, cases=200)
    known = [] if given.log is None or not given.log.exists() else given.log.read_text(encoding="utf-8").splitlines()
    rows = [tuple(json.loads(line)) for line in known]

    def counted() -> list[tuple]:
        return [row for row in rows if row[1] != "no witness"][: given.cases]

    with ProcessPoolExecutor(given.processes) as pool:
        while len(counted()) < given.cases:
            some = range(len(rows), len(rows) + 4 * given.processes)
            for row in pool.map(partial(outcome, given.seed), some):
                rows.append(row)
                print(*row[:2], f"{row[3]:.0f} s", row[2][:160], flush=True)
                if given.log is not None:
                    with given.log.open("a", encoding="utf-8") as log:
                        log.write(json.dumps(row) + "\n")
    found = counted()
    rows = [row for row in rows if row[0] <= found[-1][0]]
    good, seconds = sum(row[1] == "planned" for row in found), [row[3] for row in found]
    drawn = [row for row in found if row[0] % DRAWN == DRAWN - 1]
    table = "\n".join(f"| {number} | {state} | {each:.0f} | {words} |" for number, state, words, each in found)
    text = (
        f"# Tight courses with witnesses\n\n`python -m tests.studies.tight_courses --cases {given.cases} "
        f"--seed {given.seed} --record`, {stamp()}.\n\n" + (__doc__ or "").split("\n\n", 2)[2] + "\n"
        f"**{good} of {len(found)} courses planned: {share(good, len(found))}; of them "
        f"{sum(row[1] == 'planned' for row in drawn)} of {len(drawn)} that are drawn; "
        f"{sum(row[1] == 'wrong culprit' for row in found)} with a wrong culprit named as proven; "
        f"{len(rows) - len(found)} more were made whose witness fails a check.** Processor time of a course: "
        f"{np.median(seconds):.0f} s in the middle, {max(seconds):.0f} s at most.\n\n"
        f"| course | outcome | s | said |\n|---|---|---|---|\n{table}\n"
    )
    tell(text, REPORT if given.record else None)
    return 0 if good >= 0.97 * len(found) else 1


if __name__ == "__main__":
    sys.exit(main())
