"""An adjustment as facts, and as a JSON file beside an empty table for the next trial run."""

import json
from collections.abc import Iterator
from math import degrees
from pathlib import Path

from cadgen.figures import Facts
from cadgen.inference.adjustment import Forecast, Settings
from cadgen.jobs.adjustment.plan import AdjustmentPlan
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.progress import Progress, silent


def adjustment_facts(adjustment: AdjustmentPlan) -> Facts:
    """Result in the units of the keys' names."""
    a = adjustment
    return a.described | Facts(
        trial_runs=len(a.trials),
        points=[len(trial.points) for trial in a.trials],
        measured_point=a.wanted.point.value,
        noise_mm=a.wanted.noise,
        division_um=a.wanted.division * 1e3,
        residual_in_noise=a.posterior.residual,
        explained=a.explained,
        settings=_settings(a.settings),
        settings_of_last_trial_run=_settings(a.trials[-1].settings),
        divisions=a.divisions,
        end_position_mm=Facts(as_designed=_expected(a.designed), before=_expected(a.before), after=_expected(a.after)),
        chance_to_be_worse=a.worse,
        understood=a.understood,
        said=a.sentences,
        steps=a.steps,
        line=a.line,
    )


def _settings(settings: Settings) -> Facts:
    return Facts(
        head_mm=settings.head,
        key_deg=degrees(settings.key),
        start_x_mm=settings.start_x,
        start_y_mm=settings.start_y,
        start_heading_deg=degrees(settings.start_heading),
    )


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
        document = json.dumps(facts.json(), indent=2, ensure_ascii=False, allow_nan=False)
        yield text_file(folder / f"{stem}.json", f"{document}\n")
        yield text_file(folder / f"{stem}_next_run.csv", f"{adjustment.line}\nrun,x_mm,y_mm\n")

    return publish(stem, out, files, facts)
