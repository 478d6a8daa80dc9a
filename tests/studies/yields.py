"""Cars within the packaged tolerances on the paper's path and on planned ones: how many pass the same gates.

The gates are those of the packaged design, 50 mm about the twelve waypoints, with its field. A path that is planned
by play alone (`--reserve 0`) passes them at their edges, where the play costs least; by default `cadgen plan` keeps
room for the scatter of the cars. What binds is shown by the share that passes each gate alone, and by the tolerance
with the greatest share of the variance at the end.

    python -m tests.studies.yields [--cases 100000] [--seed 1] [--record]
"""

import numpy as np

from cadgen import Design, __version__
from cadgen.inference.monte_carlo.random_cars import margins_of_cars
from cadgen.jobs.nominal_car import watched_cars
from cadgen.jobs.tolerance import ToleranceRun, comparison_of
from tests.studies.command import PAGES, options, tell
from tests.studies.planner import gates

REPORT = PAGES / "yields.md"
GATE, WITHIN = 50.0, (10.0, 25.0, 50.0)  # mm: of the packaged design's gates, and from its path
MODES = (("by play alone", 0.0), ("by yield", None))
FEW = 1000  # cars that are held against each gate alone


def each_alone(run: ToleranceRun, seed: int) -> dict[str, float]:
    """Share of the cars that keep each gate alone, and the edge."""
    plan = run.cam
    fleet = watched_cars(plan.application, plan.curve)
    tolerances = plan.application.tolerances()
    margins = margins_of_cars(fleet, tolerances, FEW, seed=seed).margins
    return {
        watch.key.removeprefix("course."): float(np.mean(each >= 0))
        for watch, each in zip(fleet.items, margins, strict=True)
    }


def row(name: str, design: Design, cars: int, seed: int) -> str:
    """A line of the table."""
    run = design.tolerance(cars, seed=seed, profile="optimized").computed
    alone = sorted(each_alone(run, seed).items(), key=lambda pair: pair[1])
    first = " ".join(f"{gate} {100 * share:.1f} %," for gate, share in alone[:3]).rstrip(",")
    ranked = ", ".join(f"{each.name.replace('_', ' ')} {100 * each.share:.0f} %" for each in run.sensitivities[:3])
    position, heading = run.end_position, run.end_heading_deg
    band = comparison_of(run.cam).chosen.band
    return (
        f"| {name} | {100 * run.passed:.1f} % | {band.worst_distance:.0f}, {np.degrees(band.worst_heading):.2f} | "
        f"{position.quantiles[0.5]:.0f}, {position.quantiles[0.95]:.0f} | "
        f"{heading.quantiles[0.5]:.2f}, {heading.quantiles[0.95]:.2f} | {first} | {ranked} |"
    )


def main() -> int:
    """Run the cars of the packaged path and of planned ones."""
    given = options(__doc__, cases=100_000)
    today = Design.load()
    lines = [row("the paper's", today, given.cases, given.seed)]
    print(lines[-1], flush=True)
    jobs = [(f"planned, {words}", gates(GATE), {"calm_as": today, "reserve": reserve}) for words, reserve in MODES]
    for within in WITHIN:
        asked = {"improve": today, "within_mm": within}
        jobs += [(f"within {within:g} mm, {words}", today, {**asked, "reserve": reserve}) for words, reserve in MODES]
    for name, source, asked in jobs:
        lines.append(row(name, source.plan(**asked).design, given.cases, given.seed))
        print(lines[-1], flush=True)
    head = (
        "| path | yield | band: worst end, mm, ° | end 50 %, 95 %, mm | heading 50 %, 95 %, ° | gates that bind, alone "
        "| share of the variance |"
    )
    title, text, *_ = (__doc__ or "").strip().split("\n\n")
    text = (
        f"# Yield of planned paths\n\n`python -m tests.studies.yields --cases {given.cases} --seed {given.seed} "
        f"--record`, cadgen {__version__}, profile `optimized`, train as given, without friction.\n\n{title}\n\n{text}"
        f"\n\n{head}\n|---|---|---|---|---|---|---|\n" + "\n".join(lines)
    )
    tell(text, REPORT if given.record else None)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
