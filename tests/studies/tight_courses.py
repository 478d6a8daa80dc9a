"""Tight courses with witnesses for the planner: turns near the least radius, posts close beside the car on given sides.

    python -m tests.studies.tight_courses --cases 20 --seed 1 [--processes 2] [--log FILE] [--record]

A witness is a path of straights and of turns to either side whose radius is 1.1 to 1.5 times the least one that the
fork holds for the middle of the car, with smooth ramps of the curvature between them; the base radius is 120 mm. Gates
are put on it, posts of a given side 15 to 60 mm beside the car, others 40 to 200 mm; then it is thrown away. A course
counts only if its witness, as a design of its own, passes every check. Draws of a spacing are not among these courses.

A course is planned where every check passes and a sweep by brute force, which shares no code with the planner, finds
the car clear of everything. A refusal that is said to be proven is wrong in any case.
"""

import json
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from math import pi, radians, tan

import numpy as np

from tests.studies.command import PAGES, options, tell
from tests.studies.courses import A1, A2, MIDDLE, STEP, WIDTH, Case, L, _text, inside_distance, swept

REPORT = PAGES / "tight_courses.md"
LEAST = L / tan(radians(35.0) * 0.98) + abs(MIDDLE)  # mm, least radius of the middle of the rear axle
RAMP = 450.0  # mm of a ramp of the curvature
BASE = 120.0  # mm, base radius of the cam
RATIO, SHARE = 45.0, 1 - 12 / 360  # turns of the drive wheel for one of the cam; share of its turn before the blend


def witness(random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Middle of the rear axle and heading along a path of straights and tight turns, shapes (k, 2) and (k,)."""
    curvature = [np.zeros(int(random.uniform(150, 500) / STEP))]
    for _ in range(random.integers(2, 5)):
        least = 1 / (LEAST * random.uniform(1.1, 1.5)) * random.choice([-1.0, 1.0])
        share = np.linspace(0, 1, int(RAMP / STEP))
        ramp = least * share**2 * (3 - 2 * share)
        hold = max(random.uniform(0.5, 3.5) - abs(least) * RAMP, 0.0) / abs(least)
        straight = np.zeros(int(random.uniform(100, 700) / STEP))
        curvature += [ramp, np.full(int(hold / STEP), least), ramp[::-1], straight]
    heading = np.cumsum(np.concatenate(curvature)) * STEP + random.uniform(0, 2 * pi)
    place = np.cumsum(np.stack([np.cos(heading), np.sin(heading)], axis=1), axis=0) * STEP
    return place, heading


def course(seed: int, number: int) -> tuple[Case, str]:
    """A course and its witness as a design."""
    random = np.random.default_rng([seed, number, 27])
    place, heading = witness(random)
    low, high = place.min(axis=0) - random.uniform(250, 400, 2), place.max(axis=0) + random.uniform(250, 400, 2)
    parts, obstacles = [], []
    for mark in np.linspace(0.15, 0.9, random.integers(2, 6)):
        at, radius = int(mark * len(place)), float(random.choice([15.0, 25.0, 40.0]))
        x, y = place[at]
        parts.append(f"[[course.gates]]\nat_mm = [{x:.1f}, {y:.1f}]\nradius_mm = {radius}\n")
    for sided in [*[True] * int(random.integers(2, 6)), *[False] * int(random.integers(2, 8))]:
        at, left = int(random.uniform(0.1, 0.9) * len(place)), random.random() < 0.5
        room = random.uniform(15, 60) if sided else random.uniform(40, 200)
        normal = (1.0 if left else -1.0) * np.array([-np.sin(heading[at]), np.cos(heading[at])])
        post = (place[at] + normal * (WIDTH / 2 + 10.0 + room)).round(1)
        if inside_distance(post[None], place, heading).min() < 10.0 + 10.0:
            continue
        # A post on the car's left is passed on its right.
        side = f'side = "{"right" if left else "left"}"\n' * sided
        parts.append(f"[[course.posts]]\nat_mm = [{post[0]}, {post[1]}]\nradius_mm = 10.0\n{side}")
        count = sum(part.startswith("[[course.posts") for part in parts)
        obstacles.append((f"course.posts.{count}", post[None], 10.0))
    text = _text(f"tight_{number}", parts, place, heading, low, high, 0.0)
    text = text.replace("base_radius_mm = 70.0", f"base_radius_mm = {BASE}", 1)
    every = np.unique(np.linspace(0, len(place) - 1, int(len(place) * STEP / 110)).astype(int))
    # The drive wheel is on the left of the middle of the axle.
    track = place + (A1 - MIDDLE) * np.stack([-np.sin(heading), np.cos(heading)], axis=1)
    length = float(np.hypot(*np.diff(track, axis=0).T).sum())
    wheel = f"drive_wheel_radius_mm = {1.001 * length / SHARE / (2 * pi * RATIO):.3f}\n"
    path = f'[path]\nspline = "quintic"\noffset_mm = {(A1 + A2) / 2}\nwaypoints_mm = {place[every].round(3).tolist()}\n'
    known = text.replace("[car]\n", f"[car]\n{wheel}", 1) + "\n" + path
    return Case(str(number), text, (), tuple(obstacles), (low.round(2), high.round(2)), 0.0), known


def outcome(seed: int, number: int) -> tuple[int, str, str, float]:
    """Number of a course, what became of it, words, and seconds of processor time."""
    from cadgen import Design

    case, known = course(seed, number)
    try:
        failed = Design.from_toml(known, f"tight_{number}").cam().failed
    except Exception as error:
        return number, "no witness", f"{type(error).__name__}: {error}"[:200], 0.0
    if failed:
        return number, "no witness", ", ".join(check.code for check in failed), 0.0
    began = time.process_time()
    try:
        text = f"{case.text}\n[path]\noffset_mm = {(A1 + A2) / 2}\n"
        plan = Design.from_toml(text, train_only=True).plan(reserve=0)
    except Exception as error:  # a study goes on, and says so
        return number, "fault", f"{type(error).__name__}: {error}"[:300], time.process_time() - began
    seconds = time.process_time() - began
    if not plan.passed:
        return number, "wrong culprit" if plan.proven else "not found", plan.sentences[0][:300], seconds
    short = {key: gap for key, gap in swept(plan.computed.text, case).items() if gap < -0.1}
    return number, "touches" if short else "planned", f"{plan.sentences[0][:160]} {short or ''}", seconds


def main() -> int:
    from cadgen import __version__

    given = options(__doc__, cases=20)
    known = [] if given.log is None or not given.log.exists() else given.log.read_text().splitlines()
    rows = [tuple(json.loads(line)) for line in known][: given.cases]
    with ProcessPoolExecutor(given.processes) as pool:
        for row in pool.map(partial(outcome, given.seed), range(len(rows), given.cases)):
            rows.append(row)
            print(*row[:2], f"{row[3]:.0f} s", row[2][:160], flush=True)
            if given.log is not None:
                with given.log.open("a", encoding="utf-8") as log:
                    log.write(json.dumps(row) + "\n")
    counted = [row for row in rows if row[1] != "no witness"]
    good = sum(row[1] == "planned" for row in counted)
    seconds = [row[3] for row in counted]
    table = "\n".join(f"| {number} | {state} | {each:.0f} | {words} |" for number, state, words, each in rows)
    text = (
        f"# Tight courses with witnesses\n\n`python -m tests.studies.tight_courses --cases {given.cases} "
        f"--seed {given.seed} --record`, cadgen {__version__}.\n\n" + (__doc__ or "").split("\n\n", 2)[2] + "\n"
        f"**{good} of {len(counted)} courses planned ({100 * good / max(len(counted), 1):.0f} %), "
        f"{sum(row[1] == 'wrong culprit' for row in counted)} with a wrong culprit named as proven; "
        f"{len(rows) - len(counted)} more were drawn whose witness fails a check.** Processor time of a course: "
        f"{np.median(seconds):.0f} s in the middle, {max(seconds):.0f} s at most.\n\n"
        f"| course | outcome | s | said |\n|---|---|---|---|\n{table}\n"
    )
    tell(text, REPORT if given.record else None)
    return 0 if good == len(counted) else 1


if __name__ == "__main__":
    sys.exit(main())
