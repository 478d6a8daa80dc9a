"""Cars within the packaged tolerances on the paper's path and on planned ones: how many pass the same gates.

The gates are those of the packaged design, 50 mm about the twelve waypoints, with its field. A path that is planned for
gates of that size passes them at their edges, where the play costs least; one that is planned for narrower gates keeps
the rest for the scatter of the cars. What binds is told by each gate alone, and by the tolerance with the greatest
share of the variance at the end.

    python -m tests.studies.yields [--cases 100000] [--seed 1] [--record]
"""

from dataclasses import replace

import numpy as np

from cadgen import Design, __version__
from cadgen.build import variation
from cadgen.monte_carlo.robust import tolerance_run
from cadgen.workflow.runs.tolerance import ToleranceRun, _fleet, comparison_of
from tests.studies.command import DOCS, options, tell
from tests.studies.planner import gates

REPORT = DOCS / "yields.md"
RADII = (25.0, 50.0)  # mm of the gates that a path is planned for
GATE = 50.0  # mm, of the packaged design
FEW = 1000  # cars that are held against each gate alone


def each_alone(run: ToleranceRun, seed: int) -> dict[str, float]:
    """Share of the cars that keep each gate alone, and the edge."""
    fleet, plan = _fleet(run.plan), run.plan
    driven = plan.course.planned.driven
    names = [passage.gate.key.removeprefix("course.") for passage in driven.passages] + ["field"]
    assert len(names) == len(fleet.watches)
    tolerances = variation.tolerances(plan.design, comparison_of(plan).task.mechanics)
    kept = {}
    for name, watch in zip(names, fleet.watches, strict=True):
        ends = tolerance_run(replace(fleet, watches=(watch,)), tolerances, FEW, seed=seed)
        kept[name] = float(np.mean(ends.margin >= 0))
    return kept


def row(name: str, design: Design, cars: int, seed: int) -> str:
    """A line of the table."""
    run = design.tolerance(cars, seed=seed, profile="optimized").computed
    alone = sorted(each_alone(run, seed).items(), key=lambda pair: pair[1])
    first = " ".join(f"{gate} {100 * share:.1f} %," for gate, share in alone[:3]).rstrip(",")
    ranked = ", ".join(f"{each.name.replace('_', ' ')} {100 * each.share:.0f} %" for each in run.sensitivities[:3])
    position, heading = run.end_position, run.end_heading_deg
    return (
        f"| {name} | {100 * run.passed:.1f} % | {position.quantiles[0.5]:.0f}, {position.quantiles[0.95]:.0f} | "
        f"{heading.quantiles[0.5]:.2f}, {heading.quantiles[0.95]:.2f} | {first} | {ranked} |"
    )


def main() -> int:
    """Run the cars of the packaged path and of planned ones."""
    given = options(__doc__, cases=100_000)
    today = Design.load()
    lines = [row("the paper's", today, given.cases, given.seed)]
    print(lines[-1], flush=True)
    for radius in RADII:
        planned = gates(radius).plan(calm_as=today)
        back = [f"course.gates.{number}.radius_mm={GATE:g}" for number in range(2, 12)]
        design = planned.design.with_(back)
        lines.append(row(f"planned for gates of {radius:g} mm", design, given.cases, given.seed))
        print(lines[-1], flush=True)
    head = (
        "| path | yield | end 50 %, 95 %, mm | heading 50 %, 95 %, ° | gates that bind, alone | share of the variance |"
    )
    title, text, *_ = (__doc__ or "").strip().split("\n\n")
    text = (
        f"# Yield of planned paths\n\n`python -m tests.studies.yields --cases {given.cases} --seed {given.seed} "
        f"--record`, cadgen {__version__}, profile `optimized`, train as given, without friction.\n\n{title}\n\n{text}"
        f"\n\n{head}\n|---|---|---|---|---|---|\n" + "\n".join(lines)
    )
    tell(text, REPORT if given.record else None)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
