"""An adjustment as plain values, and as a JSON file beside an empty table for the next trial run."""

import json
from collections.abc import Iterator
from math import degrees
from pathlib import Path

from cadgen.inference.adjustment import Forecast, Settings
from cadgen.jobs.adjustment.plan import AdjustmentPlan
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.progress import Progress, silent


def adjustment_facts(adjustment: AdjustmentPlan) -> dict[str, object]:
    """Result in the units of the keys' names."""
    return {
        **adjustment.described,
        "trial_runs": len(adjustment.trials),
        "points": [len(trial.points) for trial in adjustment.trials],
        "measured_point": adjustment.wanted.point.value,
        "noise_mm": adjustment.wanted.noise,
        "division_um": adjustment.wanted.division * 1e3,
        "residual_in_noise": adjustment.posterior.residual,
        "explained": adjustment.explained,
        "settings": _settings(adjustment.settings),
        "settings_of_last_trial_run": _settings(adjustment.trials[-1].settings),
        "divisions": adjustment.divisions,
        "end_position_mm": {
            "as_designed": _expected(adjustment.designed),
            "before": _expected(adjustment.before),
            "after": _expected(adjustment.after),
        },
        "chance_to_be_worse": adjustment.worse,
        "said": list(adjustment.sentences),
        "steps": list(adjustment.steps),
        "line": adjustment.line,
    }


def _settings(settings: Settings) -> dict[str, float]:
    return {
        "head_mm": settings.head,
        "key_deg": degrees(settings.key),
        "start_x_mm": settings.start_x,
        "start_y_mm": settings.start_y,
        "start_heading_deg": degrees(settings.start_heading),
    }


def _expected(errors: Forecast) -> dict[str, float]:
    return {
        "mean": float(errors.end.mean()),
        "5 %": errors.end_quantile(0.05),
        "95 %": errors.end_quantile(0.95),
        "on the way": float(errors.way.mean()),
    }


def write_adjustment(adjustment: AdjustmentPlan, out: Path, progress: Progress = silent) -> Written:
    """Publish the result as JSON, and the table of the next trial run with its settings and no rows yet.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    stem = adjustment.stem
    facts = adjustment_facts(adjustment)
    progress("writing")

    def files(folder: Path) -> Iterator[Artifact]:
        document = json.dumps(facts, indent=2, ensure_ascii=False, allow_nan=False)
        yield text_file(folder / f"{stem}.json", f"{document}\n")
        yield text_file(folder / f"{stem}_next_run.csv", f"{adjustment.line}\nrun,x_mm,y_mm\n")

    return publish(stem, out, files, facts)
