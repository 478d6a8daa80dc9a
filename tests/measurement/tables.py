"""The tables of docs/measurement.md from the measured files.

    python -m tests.measurement.tables

prints, as Markdown: the blind files' verdicts with sizes and errors before and after, the tricycle's, and what the
paper's section 5 implies.
"""

from pathlib import Path

import numpy as np

from cadgen.measurement.diagnose import Diagnosis
from cadgen.measurement.leave_out import leave_runs_out
from cadgen.measurement.load import join, load
from cadgen.measurement.models.tricycle import TricycleModel
from cadgen.measurement.nominal import calibrate, calibrate_tricycle
from cadgen.measurement.zones import return_error, shortfall
from tests.conftest import build
from tests.measurement import study
from tests.measurement.synthetic import Car

FILES = Path(__file__).parents[1] / "data" / "measured"
WHEELBASE = 150.0


def _sizes(told: Diagnosis) -> str:
    return "; ".join(f"{v.name} {v.value:.4g} ± {v.sigma:.2g}" for f in told.findings for v in f.values) or "-"


def blind() -> None:
    """A row for each blind file."""
    nominal = study.nominal(Car(build("carbon_free_car")))
    print("| file | verdict | of what | sizes | before | after | left out | left out, less form error | noise |")
    print("|---|---|---|---|---|---|---|---|---|")
    for path in sorted(FILES.glob("*_?.csv")):
        (told,) = calibrate([load(path)], nominal)
        r = told.residual
        numbers = " | ".join(f"{x:.4g}" for x in (r.before, r.after, r.held_out, r.held_out_repeating, r.noise))
        what = ", ".join(f.effect for f in told.findings) or "-"
        print(f"| {path.stem} ({told.unit}) | {told.verdict} | {what} | {_sizes(told)} | {numbers} |")


def tricycle() -> None:
    """Path errors of the tricycle before and after, mean over runs."""
    records = [load(FILES / f"{name}.csv") for name in ("circles", "squares")]
    told = calibrate_tricycle(records, WHEELBASE)
    both = join(records)
    path = TricycleModel(both, WHEELBASE).path([])
    off = np.abs(path - both["x_mm"] - 1j * both["y_mm"])
    raw = np.array([np.sqrt(np.mean(off[both.run == k] ** 2)) for k in range(both.runs)])
    print(f"\n{told.judgement.sentence} {_sizes(told)}\n")
    print(f"before, start pose as logged: circles {raw[:8].mean():.1f}, squares {raw[8:].mean():.1f} mm\n")
    print("| subset (mm, runs left out) | circles | squares | all |")
    print("|---|---|---|---|")
    left = leave_runs_out(both, lambda record: TricycleModel(record, WHEELBASE))
    wanted = [set(), {"steering zero", "steering gain"}, {"steering zero", "wheelbase"}]
    for trial in left.trials:
        names = {e.name for e in trial.effects}
        if trial in left.trials[:5] or names in wanted:
            circles, squares = trial.held_out[:8].mean(), trial.held_out[8:].mean()
            print(f"| {', '.join(sorted(names)) or 'none'} | {circles:.1f} | {squares:.1f} | {trial.error:.1f} |")


def section_five() -> None:
    """The return error of the three means, and the smooth zone's shortfall."""
    zones = return_error(load(FILES / "paper_section5.csv"), (0.962, 0.724))
    low, high = zones.interval_deg
    print(f"\nB = {zones.return_error_deg:.3f} deg, 95 % from {low:.3f} to {high:.3f}")
    print(f"left over: {zones.misfit:+.2f} sigma")
    for c in zones.compared:
        print(f"tabled {c.tabled_deg}: {c.apart:+.2f} sigma, {'inside' if c.inside else 'outside'}")
    why = shortfall(zones, rpm=60.0, seconds=15.0, ratio=45.0, rival_ratio=48.0)
    print(why)


if __name__ == "__main__":
    blind()
    tricycle()
    section_five()
