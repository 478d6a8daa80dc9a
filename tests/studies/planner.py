"""The paper's path planned anew: gates of several radii, and its own path improved within a few millimetres.

    python -m tests.studies.planner [--record]

The gates stand at the twelve waypoints for the middle of the car; start and finish pose stay; slope and second
derivative of the curvature are no greater than today's. Each path is planned from scratch and goes through the exact
chain: lift, profile `optimized`, every check, runs with play over the band of the train as given and of the train
reordered. Bars are for the least error by play (`--reserve 0`); beside it is what `cadgen plan` chooses by the share of
10 000 cars that keep the course. Time is processor time of one process, that of the exact chain and of the cars among
it; `import build123d` takes IMPORTS s of it, and the bar is 15 of them.
"""

import argparse
import os
import subprocess
import sys
import time

import numpy as np

from cadgen import Design, __version__
from cadgen.api.planning import Plan
from cadgen.design import cam_model
from tests.studies.command import PAGES

REPORT = PAGES / "planner.md"
# Gates' radius or distance from the given path (mm): what a first direct collocation reached, as given and reordered.
GATES = {0.001: (214, 161), 25.0: (190, 143), 50.0: (173, 130), 100.0: (146, None)}
NEAR = {10.0: 237, 25.0: 205, 50.0: 183}


def gates(radius: float) -> Design:
    """The paper's car with gates of a radius; at the first and the last the pose of the path holds."""
    return Design.load(None, [f"course.gates.{number}.radius_mm={radius}" for number in range(2, 12)])


def figures(design: Design) -> tuple[float, float, bool]:
    """Worst end over the band: position, mm, and heading, degrees; whether all checks pass."""
    cam = design.cam()
    band = cam.car.comparison.chosen.band
    return band.worst_distance, float(np.degrees(band.worst_heading)), cam.passed


def importing() -> float:
    """Processor time of a fresh process that imports the CAD kernel, s."""
    before = os.times()
    subprocess.run([sys.executable, "-c", "import build123d"], check=True)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def row(name: str, planned: Plan[Design], bar: object, seconds: float) -> tuple[str, bool]:
    """A line of the table, and whether the bars are kept."""
    design, cars = planned.design, planned.facts()["yield"]
    track = np.abs(cam_model.track(design.values).curvature_jets).max(axis=0)
    today = np.abs(cam_model.track(Design.load().values).curvature_jets).max(axis=0)
    distance, heading, passed = figures(design)
    reordered = figures(design.with_({"optimize.order": "reordered"}))
    slopes = ", ".join(f"{100 * share:.0f} %" for share in (track / today)[1:])
    text = (
        f"| {name} | {cars['reserve']:g} | {distance:.1f} | {heading:.2f} | {reordered[0]:.1f} | "
        f"{100 * cars['kept']:.1f} % ({100 * cars['kept_before']:.1f} %), {cars['binding']} | {slopes} | "
        f"{'pass' if passed and reordered[2] else 'FAIL'} | {seconds:.0f} | {bar} |"
    )
    limits = bar if isinstance(bar, tuple) else (bar or None, None)
    kept = all(limit is None or value <= limit for value, limit in zip((distance, reordered[0]), limits, strict=True))
    return text, kept and passed and reordered[2] and bool((track[1:] <= 1.002 * today[1:]).all())


def main() -> int:
    """Plan all, print the table, and record it if asked."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--record", action="store_true")
    given = options.parse_args()
    today = Design.load()
    distance, heading, _ = figures(today)
    before = figures(today.with_({"optimize.order": "reordered"}))
    lines = [f"| today's spline | | {distance:.1f} | {heading:.2f} | {before[0]:.1f} | | 100 %, 100 % | pass | | |"]
    kept = True
    jobs = [(f"gates of {radius:.3g} mm", gates(radius), {"calm_as": today}, bar) for radius, bar in GATES.items()]
    near = [
        (f"within {within:g} mm of today's", today, {"improve": today, "within_mm": within}, bar)
        for within, bar in NEAR.items()
    ]
    for name, design, asked, bar in jobs + near:
        for reserve, limit in ((0.0, bar), (None, "")):
            began = time.process_time()
            planned = design.plan(**asked, reserve=reserve)
            line, good = row(name, planned, limit, time.process_time() - began)
            lines.append(line)
            kept &= good and planned.sound
            print(line, flush=True)
    imports = importing()
    print(f"import build123d: {imports:.1f} s of processor time")
    print("all bars kept" if kept else "NOT all bars kept")
    if given.record:
        head = (
            "| path | reserve | worst end, mm | heading, ° | reordered, mm | cars that keep the course (before), "
            "what binds | κ', κ'' of today's greatest | checks | s | bar, mm |"
        )
        REPORT.write_text(
            "# The paper's path, planned anew\n\n"
            f"`python -m tests.studies.planner --record`, cadgen {__version__}.\n\n"
            + "\n".join((__doc__ or "").strip().split("\n\n")[2:]).replace("IMPORTS", f"{imports:.1f}")
            + f"\n\n{head}\n|---|---|---|---|---|---|---|---|---|---|\n"
            + "\n".join(lines)
            + "\n",
            encoding="utf-8",
        )
    return 0 if kept else 1


if __name__ == "__main__":
    raise SystemExit(main())
