"""New cars from points and a wheel: whether a train is proposed that fits, and whether the car is then ready.

A path is a walk of ten points, 500 to 1000 mm apart, that turns by up to 35 degrees at each; the wheel is 60 to 140 mm.
All other sizes are those of `cadgen new`. A car that is not ready names the check that it fails; one that is refused
says why.

The frame of a car is judged by its checks, which count the threads in the feet of its sheets; no solid is written.

    python -m tests.studies.new_cars [--cases 100] [--seed 1] [--record]
"""

from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from cadgen import Design, __version__
from cadgen.check import CheckCode, failing
from cadgen.errors import CadgenError
from cadgen.jobs.cam.steering_cam import CarUse, plan_cam
from tests.studies.command import PAGES, options, tell

REPORT = PAGES / "new_cars.md"
OF_LAYOUT = {
    CheckCode.AXLE_REACHED,
    CheckCode.CAR_CLEARANCE,
    CheckCode.FLOOR_CLEARANCE,
    CheckCode.PLATE_ROOM,
    CheckCode.CAM_SENSE,
}


def walk(rng: np.random.Generator) -> str:
    """Points of a path, one a line, mm."""
    heading, places = rng.uniform(0, 2 * np.pi), [np.zeros(2)]
    for _ in range(9):
        heading += np.radians(rng.uniform(-35, 35))
        places.append(places[-1] + rng.uniform(500, 1000) * np.array([np.cos(heading), np.sin(heading)]))
    moved = np.array(places) - np.min(places, axis=0) + 500
    return "\n".join(f"{x:.1f} {y:.1f}" for x, y in moved)


def judged(points: str, wheel: float) -> tuple[str, str, bool]:
    """Verdict on a new car, what it fails or leaves open, and whether its file has a frame."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "points.csv"
        file.write_text(points)
        try:
            design = Design.new(
                "car", folder, points=file, train=True, changes={"car.outline.wheel_diameter_mm": wheel}
            )
            cam = plan_cam(design.values)
        except CadgenError as error:
            return "refused", str(error), False
    layout = CarUse.of(cam).in_car
    assert layout is not None
    assert not {check.code for check in failing(layout.checks)} & OF_LAYOUT
    verdict, framed = cam.verdict, design.values.frame is not None
    why = "; ".join(str(reservation.text) for reservation in verdict.reservations)
    if verdict.failed:
        why = ", ".join(f"{check.name} {check.text()}" for check in verdict.failed)
    return verdict.readiness.value, why, framed


def main() -> int:
    """Judge new cars, and tell how many are ready."""
    given = options(__doc__, cases=100)
    rng, count, rows = np.random.default_rng(given.seed), Counter[str](), []
    frames = 0
    for number in range(1, given.cases + 1):
        points, wheel = walk(rng), round(float(rng.uniform(60, 140)), 1)
        state, why, framed = judged(points, wheel)
        frames += framed
        count[state] += 1
        if state != "ready":
            rows.append(f"| {number} | {wheel:g} | {state} | {why} |")
        print(number, state, why, flush=True)
    told = ", ".join(f"{state} {number}" for state, number in count.most_common())
    title, *texts, _ = (__doc__ or "").strip().split("\n\n")
    text = "\n\n".join(texts)
    text = (
        f"# New cars with a proposed train\n\n`python -m tests.studies.new_cars --cases {given.cases} "
        f"--seed {given.seed} --record`, cadgen {__version__}.\n\n{title}\n\n{text}\n\nOf {given.cases} cars: {told}; "
        f"{frames} have a frame that holds their parts. "
        "Those that are not ready:\n\n| car | wheel, mm | verdict | why |\n|---|---|---|---|\n" + "\n".join(rows)
    )
    tell(text, REPORT if given.record else None)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
