"""Files of a calibration: JSON, the report in words, pictures, and the as-built design."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from math import isfinite
from pathlib import Path

from cadgen.design.load import load_design
from cadgen.deviations import deviation
from cadgen.errors import FileError
from cadgen.inference.expectation.outlook import Outlook
from cadgen.inference.measurement.claims import Shared
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding, PathCandidate, PathDiagnosis
from cadgen.jobs.calibration.as_built_file import as_built_text
from cadgen.jobs.calibration.calibration import CalibrationPlan, ZoneMeans
from cadgen.jobs.calibration.calibration_report import report, summary
from cadgen.jobs.calibration.new_cam import Built
from cadgen.jobs.calibration.sources import Source
from cadgen.output.files.manifest import versions
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report.record_pictures import draw_record
from cadgen.output.report.terminal import plain
from cadgen.progress import Progress, silent

FORMAT = 1
_TEXT_WIDTH = 110
_EACH_WIDTH = 160


def document(calibration: CalibrationPlan) -> dict[str, object]:
    """Facts of a calibration, as plain values; docs/measurement.md explains the keys."""
    c = calibration
    return {
        "format": FORMAT,
        "design": c.against.name,
        "source": c.against.source,
        "overrides": list(c.against.overrides),
        "design_sha256": c.against.sha256,
        "profile": c.profile,
        "form_error_um": c.form_error_um,
        "form_error_from": c.form_error_from,
        "wheelbase_mm": c.wheelbase and c.wheelbase[0],
        "warnings": list(c.warnings),
        "files": [_file(source) for source in c.sources],
        "records": [_record(diagnosis) for diagnosis in c.diagnoses],
        "zones": c.zones and _zones(c.zones),
        "shared": [_shared(quantity) for quantity in c.shared],
        "as_built": [_built(built) for built in c.built],
        "outlook": c.outlook and _outlook(c.outlook),
        "outlook_agreed": c.outlook_agreed and _outlook(c.outlook_agreed),
        "versions": versions(),
    }


def _outlook(o: Outlook) -> dict[str, object]:
    return {
        "old_mm": o.old,
        "new_mm": o.new,
        "new_90_percent_mm": [o.least, o.most],
        "chance_worse": o.worse,
        "explained": o.explained,
    }


def _file(source: Source) -> dict[str, object]:
    return {
        "file": source.path.name,
        "kind": source.kind.code,
        "runs": source.record.runs,
        "rows": len(source.record.run),
        "sha256": source.sha256,
    }


def documents(each: Sequence[CalibrationPlan]) -> dict[str, object]:
    """Facts of calibrations whose files were judged alone."""
    return {"format": FORMAT, "each": [document(c) for c in each]}


def write_calibration(
    calibration: CalibrationPlan, design_text: str, out: Path, progress: Progress = silent
) -> Written:
    """Write, read back and publish everything together.

    Args:
        calibration: the verdicts.
        design_text: of the design file, to which the as-built table is added with the overrides.
        out: the folder; nothing appears in it unless everything succeeded.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or the as-built design, read back, is not what was meant.
    """
    c = calibration
    stem = f"{c.against.name}_calibration"
    facts = document(c)

    def files(folder: Path) -> Iterator[Artifact]:
        yield from _documents(folder, stem, facts, plain(report(c), _TEXT_WIDTH))
        progress("drawing")
        for diagnosis in c.diagnoses:
            yield from map(Artifact, draw_record(diagnosis, c.track_length, folder, f"{stem}_{diagnosis.kind.stem}"))
        if c.built:
            file = folder / f"{c.against.name}_as_built.toml"
            yield text_file(file, as_built_text(c, design_text))
            _read_back(c, file)

    return publish(stem, out, files, facts, lambda made: {"files_written": list(made)})


def write_each(each: Sequence[CalibrationPlan], out: Path) -> Written:
    """Write the verdicts on files judged alone, and publish them together.

    Raises:
        FileError: a file cannot be written.
    """
    stem = f"{each[0].against.name}_each"
    facts = documents(each)
    text = plain(summary(each), _EACH_WIDTH)
    return publish(
        stem,
        out,
        lambda folder: _documents(folder, stem, facts, text),
        facts,
        lambda made: {"files_written": list(made)},
    )


def _documents(folder: Path, stem: str, facts: dict[str, object], text: str) -> Iterator[Artifact]:
    content = json.dumps(facts, indent=2, allow_nan=False, ensure_ascii=False)
    yield text_file(folder / f"{stem}.json", f"{content}\n")
    yield text_file(folder / f"{stem}.txt", text)


def _read_back(c: CalibrationPlan, file: Path) -> None:
    """The as-built design must be the design with its overrides and nothing else but [as_built]."""
    again = load_design(file)
    meant = [(built.claim.finding.effect, built.claim.kind.code, built.place) for built in c.built]
    as_built = again.as_built
    same = again.as_designed().values() == c.against.values
    if as_built is None or not same or [(e.effect, e.kind, e.place) for e in as_built.effects] != meant:
        raise FileError(
            "{name}, read back, is not the design with what was measured: report this design", name=file.name
        )
    for built, effect in zip(c.built, as_built.effects, strict=True):
        for value in built.claim.finding.values:
            sigma = value.sigma if isfinite(value.sigma) and value.sigma > 0 else abs(value.value) * 1e-4
            # Rounding to two digits of the uncertainty moves a value by no more than a twentieth of it.
            if abs(effect.numbers[value.name] - value.value) > 0.06 * sigma:
                raise FileError(
                    "{name}, read back, has another {number}: report this design", name=file.name, number=value.name
                )


def _record(diagnosis: Diagnosis) -> dict[str, object]:
    j = diagnosis.judgement
    facts: dict[str, object] = {
        "kind": diagnosis.kind.code,
        "source": diagnosis.source,
        "verdict": diagnosis.verdict,
        "sentence": j.sentence,
        "claimed": list(j.claimed),
        "reported": list(j.reported),
        "rivals": [list(names) for names in j.rivals],
        "to_decide": list(j.separate),
        "limits": list(j.limits),
    }
    effects = [_finding(f, f.effect in j.claimed) for f in diagnosis.findings]
    by_method = _by_paths if isinstance(diagnosis, PathDiagnosis) else _by_evidence
    return {**facts, **by_method(diagnosis, effects)}


def _by_evidence(diagnosis: Diagnosis, effects: list[dict[str, object]]) -> dict[str, object]:
    assert isinstance(diagnosis, EvidenceDiagnosis)
    r, p, left = diagnosis.residual, diagnosis.per_run, diagnosis.residual.left_out
    play, friction = (diagnosis.unnamed.get(q) for q in (deviation.RETURN_ERROR, deviation.SLIDING_FRICTION))
    held_out = [None] * diagnosis.runs if p.held_out is None else p.held_out.tolist()
    return {
        "effects": effects,
        "unnamed_play": play and _finding(play),
        "unnamed_friction": friction and _finding(friction),
        "datum": [_finding(f) for f in diagnosis.datum],
        "datum_held": diagnosis.held,
        "discrepancy": diagnosis.discrepancy and _finding(diagnosis.discrepancy),
        "unit": diagnosis.unit,
        "residual": {
            "before": _plain(r.before),
            "after": _plain(r.after),
            "left_out": left and _plain(left.rms),
            "left_out_less_form_error": left and _plain(left.repeating),
            "noise": _plain(r.noise),
            "noise_correlation": _plain(diagnosis.correlation),
        },
        "runs": [
            {"before": _plain(b), "after": _plain(a), "left_out": h}
            for b, a, h in zip(p.before, p.after, held_out, strict=True)
        ],
        "candidates": [
            {
                "effects": list(c.effects),
                "worse_by": _plain(c.score),
                "values": [_finding(f) for f in c.findings],
            }
            for c in diagnosis.candidates
        ],
    }


def _by_paths(diagnosis: Diagnosis, effects: list[dict[str, object]]) -> dict[str, object]:
    """Facts by path errors, under the same keys; what path errors do not have is null."""
    assert isinstance(diagnosis, PathDiagnosis)
    r, p = diagnosis.residual, diagnosis.per_run
    return {
        "effects": effects,
        "unnamed_play": None,
        "unnamed_friction": None,
        "datum": [],
        "datum_held": "",
        "discrepancy": None,
        "unit": diagnosis.unit,
        "residual": {
            "before": _plain(r.before),
            "after": _plain(r.after),
            "left_out": _plain(r.held_out),
            "left_out_less_form_error": None,
            "noise": None,
            "noise_correlation": None,
        },
        "runs": [
            {"before": _plain(b), "after": _plain(a), "left_out": _plain(h), "before_start_as_logged": _plain(s)}
            for b, a, h, s in zip(p.before, p.after, p.held_out, p.as_logged, strict=True)
        ],
        "candidates": [_path_candidate(c) for c in diagnosis.candidates],
    }


def _path_candidate(candidate: PathCandidate) -> dict[str, object]:
    return {
        "effects": list(candidate.effects),
        "left_out_mm": _plain(candidate.score),
        "values": [_finding(f) for f in candidate.findings],
        "left_out_of_each_run_mm": list(candidate.held_out),
    }


def _shared(shared: Shared) -> dict[str, object]:
    return {
        "thing": shared.deviation.name,
        "values": [asdict(value) for value in shared.values],
        "sources": shared.sources,
        "chance": _plain(shared.chance),
        "agrees": shared.agrees,
    }


def _zones(means: ZoneMeans) -> dict[str, object]:
    z = means.zones
    return {
        "source": means.source,
        "verdict": means.judgement.verdict,
        "sentence": means.judgement.sentence,
        "return_error_deg": z.return_error_deg,
        "sigma_deg": z.sigma_deg,
        "interval_deg": list(z.interval_deg),
        "smooth_deg": z.smooth_deg,
        "misfit": z.misfit,
        "tabled": [
            {"order": order, "return_error_deg": value, "standard_errors": c.apart, "inside": c.inside}
            for (order, value), c in zip(means.tabled.items(), z.compared, strict=True)
        ],
        "shortfall": means.shortfall and asdict(means.shortfall),
    }


def _built(built: Built) -> dict[str, object]:
    return {
        "source": built.claim.source,
        "kind": built.claim.kind.code,
        "place": built.place,
        "name_sure": built.claim.sure,
        "mean_of": list(built.mean_of),
        **_finding(built.claim.finding),
    }


def _finding(finding: Finding, claimed: bool | None = None) -> dict[str, object]:
    facts: dict[str, object] = (
        {"effect": finding.effect} if claimed is None else {"effect": finding.effect, "claimed": claimed}
    )
    values = [{"name": v.name, "value": v.value, "sigma": _plain(v.sigma), "unit": v.unit} for v in finding.values]
    return {
        **facts,
        "values": values,
        "given": dict(finding.indices),
        "cannot_be_told_from": list(finding.twins),
        "on_bound": list(finding.at_bound),
    }


def _plain(value: float) -> float | None:
    return float(value) if isfinite(value) else None
