"""Report of a calibration in paragraphs and tables: what the terminal shows and the text file holds."""

from collections.abc import Sequence
from itertools import pairwise
from math import floor, isfinite, log10

import numpy as np

from cadgen.arrays import Array
from cadgen.design.section import listed
from cadgen.deviations.deviation import Place
from cadgen.deviations.return_error import MEASURE_FRICTION
from cadgen.deviations.transmission import WIND_UP
from cadgen.figures import Sheet
from cadgen.inference.expectation.outlook import WORSE, Outlook
from cadgen.inference.measurement.claims import at_work
from cadgen.inference.measurement.findings import (
    Candidate,
    Diagnosis,
    EvidenceDiagnosis,
    Finding,
    PathCandidate,
    PathDiagnosis,
    PathErrors,
    PerRun,
    Value,
)
from cadgen.inference.measurement.verdict import Verdict
from cadgen.jobs.calibration.calibration import CalibrationPlan, ZoneMeans
from cadgen.jobs.calibration.new_cam import Built
from cadgen.jobs.calibration.sources import Source
from cadgen.output.report.terminal import Block, Heading

SIGNS = {"um": "µm", "deg": "°", "%": "%", "mm": "mm", "s": "s", "": ""}
PLACES = {
    Place.CAR: "stays with the car: simulate predicts with it, and a new cam is made for it",
    Place.PROCESS: "every disc made this way has it: simulate predicts with it, and a new cam is cut to come right",
    Place.PART: "belongs to the disc that was measured: simulate predicts with it, and a new cam has it no more",
    Place.NOTED: "recorded only: it may be the instrument's, or it is nothing that a cam can take out",
}
_SHOWN_CANDIDATES = 6
_CLAIMED = "what is claimed"
_TOGETHER = "what is claimed, and for effects that are not sure by name but that the run shows together,"


def report(calibration: CalibrationPlan) -> list[Block]:
    """Report of a calibration, in paragraphs and tables."""
    c = calibration
    floor = f"; form error of the disc {c.form_error_um:g} µm rms ({c.form_error_from})" if c.track_length else ""
    every = all(built.claim.sure for built in c.built)
    blocks: list[Block] = [expected(c.outlook, _CLAIMED if every else _TOGETHER)] if c.outlook else []
    blocks.append(f"{c.against.name}, {c.profile} profile{floor}.")
    if c.wheelbase is not None:
        by = "a file says so" if c.wheelbase[1] else "the design's, since no file says it"
        blocks.append(
            f"Wheelbase of the logged car {c.wheelbase[0]:g} mm ({by}); the design's cam plays no part in it."
        )
    blocks += [f"Warning: {text}." for text in c.warnings]
    for diagnosis in c.diagnoses:
        blocks += _record(diagnosis, c.files(diagnosis.kind))
    if c.zones is not None:
        blocks += _zones(c.zones)
    blocks += _together(c)
    blocks += _built(c)
    return blocks


def expected(o: Outlook, made_for: str = _CLAIMED) -> str:
    """Sentences on the expected run with a new cam, and reasons not to cut it."""
    words = (
        f"A new cam made for {made_for} is expected to end the run {_length(o.new)} mm off ({_length(o.least)} to "
        f"{_length(o.most)} mm in 90 %), the old one {_length(o.old)} mm; it is worse with a chance of {o.worse:.1%}."
    )
    why = []
    if o.contradicted:
        words = f"The records contradict each other: this goes by the track, where one was measured. {words}"
    if o.explained is False:
        why.append("what is found does not explain the measured runs" if not o.contradicted else "not all is explained")
    if o.worse > WORSE:
        why.append("it may be worse than the old one")
    if why:
        return f"Do not cut it: {listed(why, 'and')}; see what to measure below. {words}"
    if o.explained is None:
        return f"{words} No track was measured, so what else the car has is not in this."
    return words


def _length(size: float) -> str:
    return f"{size:.0f}" if size >= 10 else f"{size:.1f}"


def summary(each: Sequence[CalibrationPlan]) -> list[Block]:
    """A row for each file judged alone, and the effects with their sizes."""
    rows, effects = [], []
    for c in each:
        name = c.sources[0].path.stem
        for diagnosis in c.diagnoses:
            rows.append((name, diagnosis.verdict, SIGNS[diagnosis.unit], *map(_number, _figures(diagnosis))))
            effects.append((name, sizes(diagnosis.findings) or "-"))
        if c.zones is not None:
            rows.append((name, c.zones.judgement.verdict, SIGNS["deg"], *["-"] * 5))
            effects.append((name, sizes((c.zones.finding,))))
    head = ("file", "verdict", "rms in", "before", "after", "left out", "less form", "noise")
    return [
        Sheet("summary", "", head, tuple(rows), words=3),
        "",
        Sheet("effects", "", ("file", "effects and sizes"), tuple(effects), words=2),
        "",
        "Left out: each run with the effects fitted to the others; less form: with what the other runs say of the form "
        "error taken away too.",
        *(f"Warning: {text}." for c in each for text in c.warnings),
    ]


def _figures(diagnosis: Diagnosis) -> tuple[float | None, ...]:
    """Before, after, on runs left out, the same less form error, and noise."""
    if isinstance(diagnosis, PathDiagnosis):
        return diagnosis.residual.before, diagnosis.residual.after, diagnosis.residual.held_out, None, None
    assert isinstance(diagnosis, EvidenceDiagnosis)
    r = diagnosis.residual
    left = (None, None) if r.left_out is None else (r.left_out.rms, r.left_out.repeating)
    return r.before, r.after, *left, r.noise


def shown(value: Value) -> tuple[str, str]:
    """Value and standard deviation, the latter to two digits and the former to the same decimal."""
    if not (isfinite(value.sigma) and value.sigma > 0):
        return f"{value.value:.6g}", ""
    decimals = max(0, 1 - floor(log10(value.sigma)))
    return f"{value.value:.{decimals}f}", f"{value.sigma:.{decimals}f}"


def sizes(findings: Sequence[Finding]) -> str:
    """Each effect with its numbers and their standard deviations; units are at the end of the names."""
    return "; ".join(f"{finding.effect}: {_sizes(finding)}" for finding in findings)


def _sizes(finding: Finding) -> str:
    numbers = [f"{v.name} {' ± '.join(text for text in shown(v) if text)}" for v in finding.values]
    return ", ".join([*numbers, *(f"{name} {number:g}" for name, number in finding.indices)])


def _record(diagnosis: Diagnosis, files: Sequence[Source]) -> list[Block]:
    j = diagnosis.judgement
    rows = sum(len(source.record.run) for source in files)
    counts = f"{_plural(diagnosis.runs, 'run')}, {_plural(rows, 'row')}"
    blocks: list[Block] = [
        Heading(f"{diagnosis.kind.code}: {diagnosis.source} ({counts})"),
        f"Verdict: {diagnosis.verdict}. {j.sentence}",
    ]
    for finding in diagnosis.findings:
        claimed = "" if finding.effect in j.claimed else " (not claimed)"
        blocks.append(f"  {finding.effect}{claimed}: {_sizes(finding)}")
    if isinstance(diagnosis, EvidenceDiagnosis):
        blocks += ["", _residuals(diagnosis, files), "", _noise(diagnosis)]
    elif isinstance(diagnosis, PathDiagnosis):
        blocks += ["", _path_errors(diagnosis, files), ""]
    blocks.append(f"Fitted and never claimed: {_datum(diagnosis)}.")
    if isinstance(diagnosis, EvidenceDiagnosis) and diagnosis.discrepancy:
        blocks.append(f"Beside the effects, and never claimed: {sizes([diagnosis.discrepancy])}.")
    verb = "decide" if diagnosis.verdict == Verdict.AMBIGUOUS else "make sure"
    if diagnosis.verdict not in (Verdict.UNEXPLAINED, Verdict.RUNS_DISAGREE):
        blocks += [f"To {verb}, {text}." for text in j.separate]
    blocks += [f"Limit: {text}." for text in j.limits]
    blocks += ["", _candidates(diagnosis, files)]
    return blocks


def _noise(diagnosis: EvidenceDiagnosis) -> str:
    unit = SIGNS[diagnosis.unit]
    space = "" if unit == "°" else " "
    alike = f", correlated by {diagnosis.correlation:.2f} between neighbours" if diagnosis.correlation else ""
    return f"Noise between runs {_number(diagnosis.residual.noise)}{space}{unit}{alike}."


def _residuals(diagnosis: EvidenceDiagnosis, files: Sequence[Source]) -> Sheet:
    """Residual before, after and on runs left out: root mean squares over runs."""
    p, left = diagnosis.per_run, diagnosis.residual.left_out
    head = [f"residual, rms in {SIGNS[diagnosis.unit]}", "before", "after", "left out"]
    rows = [
        [name, *(_number(None if x is None else float(np.sqrt(np.mean(x[part] ** 2)))) for x in _columns(p))]
        for name, part in _parts(files).items()
    ]
    if left is not None:
        head.append("less form error")
        rows = [[*row, _number(left.repeating) if k == 0 else ""] for k, row in enumerate(rows)]
    return Sheet("residuals", "", tuple(head), tuple(tuple(row) for row in rows))


def _columns(p: PerRun | PathErrors) -> tuple[Array | None, ...]:
    return p.before, p.after, p.held_out


def _path_errors(diagnosis: PathDiagnosis, files: Sequence[Source]) -> Sheet:
    """Path error before, after and on runs left out: means over runs."""
    p = diagnosis.per_run
    head = (f"path error, rms in {SIGNS[diagnosis.unit]}", "before", "after", "left out", "before, start as logged")
    rows = [
        (name, *(_number(float(np.mean(x[part]))) for x in (p.before, p.after, p.held_out, p.as_logged)))
        for name, part in _parts(files).items()
    ]
    return Sheet("path-errors", "", head, tuple(rows))


def _datum(diagnosis: Diagnosis) -> str:
    """Name of the datum and the range of its values, in words."""
    spans: dict[str, list[Value]] = {}
    for finding in diagnosis.datum if isinstance(diagnosis, EvidenceDiagnosis) else ():
        for value in finding.values:
            spans.setdefault(value.name, []).append(value)
    numbers = []
    for name, values in spans.items():
        low, high = (end(values, key=lambda v: v.value) for end in (min, max))
        several = f"{shown(low)[0]} to {shown(high)[0]}" if len(values) > 1 else " ± ".join(shown(low))
        numbers.append(f"{name} {several}")
    held = f", {diagnosis.held}" if isinstance(diagnosis, EvidenceDiagnosis) and diagnosis.held else ""
    return diagnosis.kind.datum.words + held + (f" ({'; '.join(numbers)})" if numbers else "")


def _candidates(diagnosis: Diagnosis, files: Sequence[Source]) -> Sheet:
    best = diagnosis.candidates[:_SHOWN_CANDIDATES]
    rows = [*best, *(c for c in diagnosis.candidates if not c.effects and c not in best)]
    if not isinstance(diagnosis, PathDiagnosis):
        return Sheet("candidates", "", ("candidates", "worse by"), tuple((_subset(c), f"{c.score:.1f}") for c in rows))
    parts = _parts(files)
    by_path = [c for c in rows if isinstance(c, PathCandidate)]
    cells = [(_subset(c), *(_number(float(np.mean(c.held_out[p]))) for p in parts.values())) for c in by_path]
    return Sheet("candidates", "", ("candidates, mm on runs left out", *parts), tuple(cells))


def _subset(candidate: Candidate) -> str:
    return ", ".join(candidate.effects) or "no effect"


def _parts(files: Sequence[Source]) -> dict[str, slice]:
    """All runs, and the runs of each file if there are several."""
    parts = {"all runs": slice(None)}
    ends = np.cumsum([0, *(source.record.runs for source in files)]).tolist()
    if len(files) > 1:
        parts |= {s.record.source: slice(a, b) for s, (a, b) in zip(files, pairwise(ends), strict=True)}
    return parts


def _zones(means: ZoneMeans) -> list[Block]:
    z = means.zones
    blocks: list[Block] = [
        Heading(f"{means.kind.code}: {means.source}"),
        f"Verdict: {means.judgement.verdict}. {means.judgement.sentence}",
        "A run over a smooth zone turns the cam by m, over a jump by m + B, over a wait by m - B. "
        f"B = {z.return_error_deg:.3f} ± {z.sigma_deg:.3f}°; left over {z.misfit:+.2f} standard errors.",
    ]
    for (order, tabled), compared in zip(means.tabled.items(), z.compared, strict=True):
        where = "inside the interval" if compared.inside else "outside the interval"
        blocks.append(
            f"The greatest return error of the {order} train by [train] is {tabled:.3f}°: {where}, B is "
            f"{abs(compared.apart):.1f} standard errors {'above' if compared.apart > 0 else 'below'} it."
        )
    if not means.tabled:
        blocks.append("The design has no [train], so there is no tabled return error to compare with.")
    return [*blocks, *_shortfall(means)]


def _shortfall(means: ZoneMeans) -> list[Block]:
    z, why = means.zones, means.shortfall
    if why is None:
        return [
            f"The smooth zone turned {z.smooth_deg:.2f}°. What it should have turned is not known: the file's remarks "
            'must say speed and time, as in "motor 60 rpm, 15 s a trial", and the design its [train].'
        ]
    less = "less" if why.missing_deg > 0 else "more"
    return [
        f"The smooth zone turned {z.smooth_deg:.2f} ± {z.smooth_sigma_deg:.2f}° and not {why.expected_deg:.2f}°: "
        f"{abs(why.missing_deg):.2f}° {less}. Play taken up once costs no more than {z.return_error_deg:.1f}°, so it "
        "is not the cause. Each of these alone would do, and one mean cannot choose: a mean motor speed of "
        f"{why.speed_rpm:.1f} rpm; {why.lost_time_s:.2f} s of full speed lost in starting and stopping; a ratio of "
        f"{why.ratio:.2f}. To decide: an encoder on the motor, or two run times. The difference between zones does not "
        "depend on it, as long as it is the same in all of them."
    ]


def _together(c: CalibrationPlan) -> list[Block]:
    if not c.shared:
        return []
    blocks: list[Block] = [Heading("together")]
    for common in c.shared:
        sources = listed(common.sources, "and")
        if common.agrees:
            values = ", ".join(f"{v.name} {' ± '.join(shown(v))}" for v in common.values)
            blocks.append(f"{common.deviation.name} shows in {sources}, and they agree: {values} together.")
        else:
            best = at_work([claim for claim in c.claims if claim.deviation == common.deviation])[0]
            blocks.append(
                f"{common.deviation.name} shows in {sources}, but not with one size (chance {common.chance:.0e}): it "
                "is not one effect, or something else hides in one of them. That of the "
                f"{best.kind.code} is taken, which is nearest to what the car drives with."
            )
    return blocks


def _built(c: CalibrationPlan) -> list[Block]:
    if not c.built:
        return [Heading("as built"), "Nothing is claimed, so there is no as-built design."]
    return [Heading("as built"), *map(sentence, c.built), *_waiting(c), *_held(c)]


def _waiting(c: CalibrationPlan) -> list[Block]:
    """Sentence on what is expected once the user agrees to all that a new cam can take out."""
    if (o := c.outlook_agreed) is None:
        return []
    names = listed([f"{b.claim.finding.effect}, from {b.claim.kind.code}" for b in c.built if b.waits], "and")
    return [
        f'With place = "car" for {names}, the run is expected to end {_length(o.new)} mm off ({_length(o.least)} to '
        f"{_length(o.most)} mm in 90 %), the new cam to be worse with a chance of {o.worse:.1%}."
    ]


def _held(c: CalibrationPlan) -> list[Block]:
    """Sentence that a car without play may be held by friction or drag."""
    if c.holds is None:
        return []
    friction, angle = c.holds
    most = c.against.drag
    drag = f"the drag of up to {most:g} N·mm that the design has" if most else "drag"
    return [
        f"No play shows on this track, though the design allows some. Either the gears have none, or the cam is held: "
        f"sliding friction above {friction:.2f} does that everywhere (at {np.degrees(angle):.0f}° it takes most), or "
        f"{drag}, and oil or shaking would set it free. To know, {MEASURE_FRICTION}."
    ]


def sentence(built: Built) -> str:
    """A claimed effect, the sense of its numbers, and what becomes of it."""
    finding, place = built.claim.finding, PLACES[built.place]
    if built.instead is not None:
        place = f"recorded only: the {built.instead.finding.effect} from {built.instead.kind.code} stands for it"
    name = f"no {finding.effect}" if built.claim.absent else finding.effect
    signs = "; ".join(p.meaning for p in built.claim.kind.named(finding.effect, dict(finding.indices)).parameters)
    if built.place == Place.NOTED and built.instead is None:
        place = _of_train(finding) or place
    of = f", the mean of {listed(built.mean_of, 'and')}" if built.mean_of else ""
    unsure = "" if built.claim.sure else " The name is not sure; what it does to the run together with the others is."
    words = f"{place[0].upper()}{place[1:]}.{unsure}"
    return f"{name}, from {built.claim.kind.code}: {_sizes(finding)}{of} ({signs}). {words}"


def _of_train(finding: Finding) -> str:
    """Why an effect of the train is only noted, and what a cam can do about it; empty for another effect."""
    turns = dict(finding.indices).get("turns_per_turn")
    if turns is not None and turns != round(turns):
        return "recorded only: it does not repeat with every turn of the cam, and no cam takes it out"
    if turns is None and finding.effect != WIND_UP.name:
        return ""
    return (
        'recorded only, as it may be the instrument\'s; it repeats with every turn of the cam, so with place = "car" '
        "a new cam takes it out, and every wheel must then stay on its shaft and in mesh as it was measured"
    )


def _number(value: float | None) -> str:
    return "-" if value is None or not isfinite(value) else f"{value:.4g}"


def _plural(count: int, name: str) -> str:
    return f"{count} {name}{'' if count == 1 else 's'}"
