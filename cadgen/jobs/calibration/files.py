"""Files of a calibration: JSON, the report in words, pictures, and the as-built design."""

import json
from collections.abc import Iterator, Sequence
from math import isfinite
from pathlib import Path

from cadgen.design.as_built import EarlierCam
from cadgen.design.load import load_design
from cadgen.deviations import deviation
from cadgen.errors import FileError
from cadgen.figures import Facts
from cadgen.inference.expectation.outlook import Outlook
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding, PathDiagnosis
from cadgen.jobs.calibration.as_built_file import as_built_text
from cadgen.jobs.calibration.calibration import CalibrationPlan, ZoneMeans
from cadgen.jobs.calibration.calibration_report import report, summary
from cadgen.jobs.calibration.workshop import Workshop
from cadgen.output.files.manifest import versions
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.output.report.record_pictures import record_picture
from cadgen.output.report.style import save
from cadgen.output.report.terminal import plain
from cadgen.progress import Progress, silent

FORMAT = 1
_TEXT_WIDTH = 110
_EACH_WIDTH = 160


def calibration_facts(calibration: CalibrationPlan) -> Facts:
    """Facts of a calibration; docs/measurement.md explains the keys."""
    c = calibration
    return Facts(
        format=FORMAT,
        design=c.against.name,
        source=c.against.source,
        overrides=c.against.overrides,
        design_sha256=c.against.sha256,
        profile=c.profile,
        profile_stated=c.profile_stated,
        other_cam=c.other_cam
        and Facts(
            profile=c.other_cam.profile,
            earlier=c.other_cam.earlier,
            better=c.other_cam.better,
            effects=c.other_cam.effects,
            instead=c.other_cam.instead,
            fits_better=c.other_cam.fits_better,
        ),
        form_error_um=c.form_error_um,
        form_error_from=c.form_error_from,
        wheelbase_mm=c.wheelbase and c.wheelbase[0],
        warnings=c.warnings,
        readiness=c.readiness.value,
        files=[
            Facts(
                file=source.path.name,
                kind=source.kind.code,
                runs=source.record.runs,
                rows=len(source.record.run),
                sha256=source.sha256,
            )
            | (Facts(understood=source.record.notes) if source.record.notes else Facts())
            for source in c.sources
        ],
        records=[_record(diagnosis) for diagnosis in c.diagnoses],
        zones=c.zones and _zones(c.zones),
        shared=[
            Facts(thing=s.deviation.name, values=s.values, sources=s.sources, chance=s.chance, agrees=s.agrees)
            for s in c.shared
        ],
        as_built=[
            Facts(
                source=built.claim.source,
                kind=built.claim.kind.code,
                place=built.place,
                name_sure=built.claim.sure,
                mean_of=built.mean_of,
            )
            | _finding(built.claim.finding)
            for built in c.built
        ],
        outlook=c.outlook and _outlook(c.outlook),
        outlook_agreed=c.outlook_agreed and _outlook(c.outlook_agreed),
        versions=versions(),
    )


def _outlook(o: Outlook) -> Facts:
    return Facts(
        old_mm=o.old, new_mm=o.new, new_90_percent_mm=(o.least, o.most), chance_worse=o.worse, explained=o.explained
    )


def summary_facts(each: Sequence[CalibrationPlan]) -> Facts:
    """Facts of calibrations whose files were judged alone."""
    return Facts(format=FORMAT, each=[calibration_facts(c) for c in each])


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
    facts = calibration_facts(c)

    def files(folder: Path) -> Iterator[Artifact]:
        yield from _documents(folder, stem, facts, plain(report(c), _TEXT_WIDTH))
        progress("drawing")
        for diagnosis in c.diagnoses:
            yield from map(
                Artifact, save(record_picture(diagnosis, c.track_length), folder, f"{stem}_{diagnosis.kind.stem}")
            )
        if c.built:
            file = folder / f"{c.against.name}_as_built.toml"
            yield text_file(file, as_built_text(c, design_text))
            _read_back(c, file)

    return publish(stem, out, files, facts, lambda made: Facts(files_written=list(made)))


def write_each(each: Sequence[CalibrationPlan], out: Path, workshop: Workshop | None = None) -> Written:
    """Write the verdicts on files judged alone, and publish them together.

    Args:
        each: verdicts, one of each car.
        out: folder.
        workshop: what the cars differ by; None where they are too few.

    Raises:
        FileError: a file cannot be written.
    """
    stem = f"{each[0].against.name}_each"
    facts = summary_facts(each)
    text = plain(summary(each), _EACH_WIDTH)

    def files(folder: Path) -> Iterator[Artifact]:
        yield from _documents(folder, stem, facts, text)
        if workshop is not None:
            yield text_file(folder / "workshop.toml", workshop.text())

    return publish(
        stem,
        out,
        files,
        facts,
        lambda made: Facts(files_written=list(made)),
    )


def _documents(folder: Path, stem: str, facts: Facts, text: str) -> Iterator[Artifact]:
    content = json.dumps(facts.json(), indent=2, allow_nan=False, ensure_ascii=False)
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
    before = (*c.against.earlier, EarlierCam(profile=c.profile, cut_for=c.against.cut_for))
    if [_known(cam) for cam in as_built.cams] != [_known(cam) for cam in before]:
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


def _known(cam: EarlierCam) -> tuple[str, list[tuple[str, str, str, dict[str, float]]]]:
    return cam.profile, [(e.effect, e.kind, e.place, e.numbers) for e in cam.cut_for]


def _record(diagnosis: Diagnosis) -> Facts:
    j = diagnosis.judgement
    return Facts(
        kind=diagnosis.kind.code,
        source=diagnosis.source,
        verdict=diagnosis.verdict,
        sentence=j.sentence,
        claimed=j.claimed,
        reported=j.reported,
        rivals=j.rivals,
        to_decide=j.separate,
        limits=j.limits,
        effects=[Facts(effect=f.effect, claimed=f.effect in j.claimed) | _numbers(f) for f in diagnosis.findings],
    ) | (_by_paths(diagnosis) if isinstance(diagnosis, PathDiagnosis) else _by_evidence(diagnosis))


def _by_evidence(diagnosis: Diagnosis) -> Facts:
    assert isinstance(diagnosis, EvidenceDiagnosis)
    r, p, left = diagnosis.residual, diagnosis.per_run, diagnosis.residual.left_out
    play, friction = (diagnosis.unnamed.get(q) for q in (deviation.RETURN_ERROR, deviation.SLIDING_FRICTION))
    held_out = [None] * diagnosis.runs if p.held_out is None else p.held_out
    return Facts(
        unnamed_play=play and _finding(play),
        unnamed_friction=friction and _finding(friction),
        datum=[_finding(f) for f in diagnosis.datum],
        datum_held=diagnosis.held,
        discrepancy=diagnosis.discrepancy and _finding(diagnosis.discrepancy),
        unit=diagnosis.unit,
        residual=Facts(
            before=r.before,
            after=r.after,
            left_out=left and left.rms,
            left_out_less_form_error=left and left.repeating,
            noise=r.noise,
            noise_correlation=diagnosis.correlation,
        ),
        runs=[Facts(before=b, after=a, left_out=h) for b, a, h in zip(p.before, p.after, held_out, strict=True)],
        candidates=[
            Facts(effects=c.effects, worse_by=c.score, values=[_finding(f) for f in c.findings])
            for c in diagnosis.candidates
        ],
    )


def _by_paths(diagnosis: PathDiagnosis) -> Facts:
    """Facts by path errors, under the same keys; what path errors do not have is null."""
    r, p = diagnosis.residual, diagnosis.per_run
    return Facts(
        unnamed_play=None,
        unnamed_friction=None,
        datum=[],
        datum_held="",
        discrepancy=None,
        unit=diagnosis.unit,
        residual=Facts(
            before=r.before,
            after=r.after,
            left_out=r.held_out,
            left_out_less_form_error=None,
            noise=None,
            noise_correlation=None,
        ),
        runs=[
            Facts(before=b, after=a, left_out=h, before_start_as_logged=s)
            for b, a, h, s in zip(p.before, p.after, p.held_out, p.as_logged, strict=True)
        ],
        candidates=[
            Facts(
                effects=c.effects,
                left_out_mm=c.score,
                values=[_finding(f) for f in c.findings],
                left_out_of_each_run_mm=c.held_out,
            )
            for c in diagnosis.candidates
        ],
    )


def _zones(means: ZoneMeans) -> Facts:
    z = means.zones
    return Facts(
        source=means.source,
        verdict=means.judgement.verdict,
        sentence=means.judgement.sentence,
        return_error_deg=z.return_error_deg,
        sigma_deg=z.sigma_deg,
        interval_deg=z.interval_deg,
        smooth_deg=z.smooth_deg,
        misfit=z.misfit,
        tabled=[
            Facts(order=order, return_error_deg=value, standard_errors=c.apart, inside=c.inside)
            for (order, value), c in zip(means.tabled.items(), z.compared, strict=True)
        ],
        shortfall=means.shortfall,
    )


def _finding(finding: Finding) -> Facts:
    return Facts(effect=finding.effect) | _numbers(finding)


def _numbers(finding: Finding) -> Facts:
    return Facts(
        values=finding.values,
        given=dict(finding.indices),
        cannot_be_told_from=finding.twins,
        on_bound=finding.at_bound,
    )
