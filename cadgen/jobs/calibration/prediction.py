"""Runs that a calibration did not use, predicted with what it found, in words too."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.errors import FileError
from cadgen.figures import Sheet
from cadgen.inference.expectation.predict import Prediction, predict, predict_tricycle
from cadgen.inference.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.record import Method, Record, join, refuse_wrong_units
from cadgen.jobs.calibration.plan import Calibration, Source, wheelbase_of
from cadgen.jobs.calibration.words import SIGNS
from cadgen.output.report.terminal import Block, Heading
from cadgen.progress import Progress, silent


def predicted(
    calibration: Calibration, unseen: Sequence[Source], progress: Progress = silent
) -> tuple[Prediction, ...]:
    """Predict measured files that were not used.

    Args:
        calibration: what was found in others.
        unseen: from `plan.read`.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file was used, has no model, is of another car than those used, or has other units.
    """
    known = {source.sha256: source for source in calibration.sources}
    out = []
    for source in unseen:
        if twin := known.get(source.sha256):
            raise FileError(f"{source.path} holds the same data as {twin.path}, which was used: predict others")
        progress(f"predicting {source.record.source}")
        by_method = {Method.EVIDENCE: _by_evidence, Method.RUNS_LEFT_OUT: _by_paths}
        if source.kind.method not in by_method:
            raise FileError(f"{source.record.source}: mean turns over zones are not predicted: give runs")
        out.append(by_method[source.kind.method](calibration, source.record))
    return tuple(out)


def _by_evidence(calibration: Calibration, record: Record) -> Prediction:
    told = [d for d in calibration.diagnoses if isinstance(d, EvidenceDiagnosis)]
    if not told or calibration.nominal is None:
        raise FileError(
            f"{record.source}: data of kind {record.kind.code} are not predicted by logged runs or zones: calibrate "
            "with lifts, profiles, transmissions or tracks of the car"
        )
    if any(d.contradicted for d in told):
        raise FileError(
            f"{record.source}: nothing is predicted while the files that were used contradict each other: leave out "
            "those that are not of this car in this state"
        )
    refuse_wrong_units(record, calibration.nominal)
    records = [join([s.record for s in calibration.files(d.kind)]) for d in told]
    return predict(calibration.nominal, records, told, record)


def _by_paths(calibration: Calibration, record: Record) -> Prediction:
    diagnosis = next((d for d in calibration.diagnoses if isinstance(d, PathDiagnosis)), None)
    if diagnosis is None:
        raise FileError(
            f"{record.source}: logged runs are predicted by logged runs: calibrate with some of the same car"
        )
    records = [s.record for s in calibration.files(diagnosis.kind)]
    wheelbase, _ = wheelbase_of(calibration.design, [*records, record])
    refuse_wrong_units(record, LoggedCar(wheelbase))
    return predict_tricycle(join(records), diagnosis, wheelbase, record)


def words(predictions: Sequence[Prediction]) -> list[Block]:
    """Residuals before and after in a table, and which effects predict."""
    blocks: list[Block] = [Heading("predicted, not used")]
    rows = []
    for p in predictions:
        logged = ("-", "-") if p.as_logged is None else tuple(map(_figure, p.as_logged))
        rows.append((p.source, f"{len(p.before)}", SIGNS[p.unit], _figure(p.before), _figure(p.after), *logged))
    head = ("file", "runs", "rms in", "before", "after", "start as logged, before", "after")
    blocks.append(Sheet("predicted", "", head, tuple(rows)))
    for effects in dict.fromkeys(p.effects for p in predictions):
        blocks.append(
            f"Predicted with {', '.join(effects) or 'no effect'}; nothing but the datum of each run is fitted."
        )
    if any(isinstance(p.as_logged, tuple) and p.kind.method is Method.RUNS_LEFT_OUT for p in predictions):
        blocks.append(
            "A logged car is predicted with all effects at once, each held to a size that is usual, whatever is named."
        )
    return blocks


def facts(predictions: Sequence[Prediction]) -> list[dict[str, Any]]:
    """The same as plain values, means over runs and each run's."""
    return [
        {
            "file": p.source,
            "kind": p.kind.code,
            "unit": p.unit,
            "effects": list(p.effects),
            "before": float(np.mean(p.before)),
            "after": float(np.mean(p.after)),
            "start_as_logged": p.as_logged
            and {
                "before": float(np.mean(p.as_logged[0])),
                "after": float(np.mean(p.as_logged[1])),
            },
            "runs": [{"before": b, "after": a} for b, a in zip(p.before.tolist(), p.after.tolist(), strict=True)],
        }
        for p in predictions
    ]


def _figure(values: Array) -> str:
    return f"{float(np.mean(values)):.4g}"
