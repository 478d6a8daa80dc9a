"""Report of a calibration in paragraphs and tables: what the terminal shows and the text file holds."""

from collections.abc import Sequence
from itertools import pairwise
from math import floor, isfinite, log10

import numpy as np

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
    Value,
)
from cadgen.inference.measurement.record import understood_of
from cadgen.inference.measurement.verdict import Verdict
from cadgen.jobs.calibration.calibration import CalibrationPlan, ZoneMeans
from cadgen.jobs.calibration.new_cam import Built
from cadgen.jobs.calibration.sources import Source
from cadgen.jobs.cam.built_car import chance_to_be_worse
from cadgen.messages import Message, joined
from cadgen.output.report.terminal import Block, Heading

SIGNS = {"um": "µm", "deg": "°", "%": "%", "mm": "mm", "s": "s", "": ""}
PLACES = {
    Place.CAR: Message("Stays with the car: simulate predicts with it, and a new cam is made for it"),
    Place.PROCESS: Message(
        "Every disc made this way has it: simulate predicts with it, and a new cam is cut to come right"
    ),
    Place.PART: Message(
        "Belongs to the disc that was measured: simulate predicts with it, and a new cam has it no more"
    ),
    Place.NOTED: Message("Recorded only: it may be the instrument's, or it is nothing that a cam can take out"),
}
_SHOWN_CANDIDATES = 6
_CLAIMED = Message("what is claimed")
_TOGETHER = Message("what is claimed, and for effects that are not sure by name but that the run shows together,")


def report(calibration: CalibrationPlan) -> list[Block]:
    """Report of a calibration, in paragraphs and tables."""
    c = calibration
    every = all(built.claim.sure for built in c.built)
    blocks: list[Block] = [_doubt_of_cam(c)] if c.other_cam is not None else []
    blocks += [expected(c.outlook, _CLAIMED if every else _TOGETHER)] if c.outlook else []
    aside = [d.source for d in c.diagnoses if isinstance(d, EvidenceDiagnosis) and d.apart]
    if c.outlook and aside and not c.outlook.contradicted:
        blocks.append(Message("Not used for this: {files}, which no effect explains.", files=joined(aside)))
    if c.no_cam is not None:
        blocks.append(Message("No new cam can be planned for what is claimed: {reason}.", reason=c.no_cam))
    stated = {
        "name": c.against.name,
        "profile": Message(c.profile),
        "error": c.form_error_um,
        "source": c.form_error_from,
    }
    blocks.append(
        Message("{name}, {profile} profile; form error of the disc {error:g} µm rms ({source}).", **stated)
        if c.track_length
        else Message("{name}, {profile} profile.", name=c.against.name, profile=Message(c.profile))
    )
    if c.wheelbase is not None:
        by = Message("a file says so") if c.wheelbase[1] else Message("the design's, since no file says it")
        blocks.append(
            Message(
                "Wheelbase of the logged car {wheelbase:g} mm ({by}); the design's cam plays no part in it.",
                wheelbase=c.wheelbase[0],
                by=by,
            )
        )
    blocks += [Message("Warning: {text}.", text=text) for text in c.warnings]
    for diagnosis in c.diagnoses:
        blocks += _record(diagnosis, c.files(diagnosis.kind))
    if c.zones is not None:
        blocks += _zones(c.zones)
    blocks += _together(c)
    blocks += _built(c)
    return blocks


def _doubt_of_cam(c: CalibrationPlan) -> Message:
    """Sentence on another cam that the data fit as well or better, and what to do."""
    other = c.other_cam
    assert other is not None
    with_other = joined(map(Message, other.effects), " and ") or Message("no effect")
    with_stated = joined(map(Message, other.instead), " and ") or Message("no effect")
    which = {"other": other.profile, "stated": c.profile, "with_other": with_other, "with_stated": with_stated}
    if other.earlier:
        which["other"] = Message("earlier {profile}", profile=other.profile)
    cure = (
        Message("calibrate the design that it was cut from with --profile {profile}", profile=other.profile)
        if other.earlier
        else Message("calibrate with --profile {profile}", profile=other.profile)
    )
    if other.fits_better:
        return Message(
            "Do not cut a cam for this: the data fit a car with the {other} cam ({with_other}) better than one with "
            "the {stated} cam ({with_stated}); look which cam is on the car, and if it is that one, {cure}.",
            cure=cure,
            **which,
        )
    if not c.profile_stated:
        return Message(
            "Do not cut a cam for this: the data fit a car with the {other} cam ({with_other}) as well as one with "
            "the {stated} cam ({with_stated}), and nothing says which is on the car: give its --profile.",
            **which,
        )
    return Message(
        "All this holds for the {stated} cam, which is said to be on the car: the data fit a car with the {other} cam "
        "({with_other}) as well as one with the {stated} cam ({with_stated}).",
        **which,
    )


def expected(o: Outlook, made_for: str = _CLAIMED) -> Message:
    """Sentences on the expected run with a new cam, and reasons not to cut it."""
    words = Message(
        "A new cam made for {made_for} is expected to end the run {new} mm off ({least} to {most} mm in 90 %), the old "
        "one {old} mm; {worse}.",
        made_for=made_for,
        new=_length(o.new),
        least=_length(o.least),
        most=_length(o.most),
        old=_length(o.old),
        worse=chance_to_be_worse(o.worse, explained=o.explained),
    )
    why = []
    if o.contradicted:
        words = Message(
            "The records contradict each other: this goes by the track, where one was measured. {words}", words=words
        )
    if o.explained is False and o.contradicted:
        why.append(Message("not all is explained"))
    elif o.explained is False:
        why.append(Message("what is found does not explain the measured runs"))
    if o.worse > WORSE:
        why.append(Message("it may be worse than the old one"))
    if why:
        return Message("Do not cut it: {why}; see what to measure below. {words}", why=listed(why, "and"), words=words)
    if o.explained is None:
        return Message("{words} No track was measured, so what else the car has is not in this.", words=words)
    return words


def _length(size: float) -> str:
    return f"{size:.0f}" if size >= 10 else f"{size:.1f}"


def summary(each: Sequence[CalibrationPlan]) -> list[Block]:
    """A row for each file judged alone, and the effects with their sizes."""
    rows, effects = [], []
    for c in each:
        name = c.sources[0].path.stem
        for diagnosis in c.diagnoses:
            if isinstance(diagnosis, PathDiagnosis):
                errors = diagnosis.residual
                figures = (errors.before, errors.after, errors.held_out, None, None)
            else:
                assert isinstance(diagnosis, EvidenceDiagnosis)
                r, left_out = diagnosis.residual, diagnosis.residual.left_out
                left = (None, None) if left_out is None else (left_out.rms, left_out.repeating)
                figures = (r.before, r.after, *left, r.noise)
            rows.append((name, diagnosis.verdict, SIGNS[diagnosis.unit], *map(_number, figures)))
            effects.append((name, sizes(diagnosis.findings) or "-"))
        if c.zones is not None:
            rows.append((name, c.zones.judgement.verdict, SIGNS["deg"], *["-"] * 5))
            effects.append((name, sizes((c.zones.finding,))))
    head = (
        *(Message("file"), Message("verdict"), Message("rms in"), Message("before"), Message("after")),
        *(Message("left out"), Message("less form"), Message("noise")),
    )
    return [
        Sheet("summary", "", head, tuple(rows), words=3),
        "",
        Sheet("effects", "", (Message("file"), Message("effects and sizes")), tuple(effects), words=2),
        "",
        Message(
            "Left out: each run with the effects fitted to the others; less form: with what the other runs say of the "
            "form error taken away too."
        ),
        *(
            Message("{file}: {text}", file=c.sources[0].path.name, text=_doubt_of_cam(c))
            for c in each
            if c.other_cam is not None
        ),
        *(Message("Warning: {text}.", text=text) for c in each for text in c.warnings),
    ]


def shown(value: Value) -> tuple[str, str]:
    """Value and standard deviation, the latter to two digits and the former to the same decimal."""
    if not (isfinite(value.sigma) and value.sigma > 0):
        return f"{value.value:.6g}", ""
    decimals = max(0, 1 - floor(log10(value.sigma)))
    return f"{value.value:.{decimals}f}", f"{value.sigma:.{decimals}f}"


def sizes(findings: Sequence[Finding]) -> str:
    """Each effect with its numbers and their standard deviations; units are at the end of the names."""
    return joined(
        (Message("{effect}: {sizes}", effect=Message(finding.effect), sizes=_sizes(finding)) for finding in findings),
        "; ",
    )


def _sizes(finding: Finding) -> str:
    numbers = [f"{v.name} {' ± '.join(text for text in shown(v) if text)}" for v in finding.values]
    return ", ".join([*numbers, *(f"{name} {number:g}" for name, number in finding.indices)])


def _record(diagnosis: Diagnosis, files: Sequence[Source]) -> list[Block]:
    j = diagnosis.judgement
    rows = sum(len(source.record.run) for source in files)
    runs = Message("1 run") if diagnosis.runs == 1 else Message("{count} runs", count=diagnosis.runs)
    blocks: list[Block] = [
        Heading(
            Message(
                "{kind}: {source} ({runs}, {rows} rows)",
                kind=diagnosis.kind.code,
                source=diagnosis.source,
                runs=runs,
                rows=rows,
            )
        ),
        *(understood_of(file.record) for file in files if file.record.notes),
        Message("Verdict: {verdict}. {sentence}", verdict=Message(str(diagnosis.verdict)), sentence=j.sentence),
    ]
    for finding in diagnosis.findings:
        form = "  {effect}: {sizes}" if finding.effect in j.claimed else "  {effect} (not claimed): {sizes}"
        blocks.append(Message(form, effect=Message(finding.effect), sizes=_sizes(finding)))
    if isinstance(diagnosis, EvidenceDiagnosis):
        blocks += ["", _residuals(diagnosis, files), "", _noise(diagnosis)]
    elif isinstance(diagnosis, PathDiagnosis):
        blocks += ["", _path_errors(diagnosis, files), ""]
    blocks.append(Message("Fitted and never claimed: {datum}.", datum=_datum(diagnosis)))
    if isinstance(diagnosis, EvidenceDiagnosis) and diagnosis.discrepancy:
        blocks.append(Message("Beside the effects, and never claimed: {sizes}.", sizes=sizes([diagnosis.discrepancy])))
    if diagnosis.verdict == Verdict.AMBIGUOUS:
        blocks += [Message("To decide, {text}.", text=text) for text in j.separate]
    elif diagnosis.verdict not in (Verdict.UNEXPLAINED, Verdict.RUNS_DISAGREE):
        blocks += [Message("To make sure, {text}.", text=text) for text in j.separate]
    blocks += [Message("Limit: {text}.", text=text) for text in j.limits]
    blocks += ["", _candidates(diagnosis, files)]
    return blocks


def _noise(diagnosis: EvidenceDiagnosis) -> Message:
    unit = SIGNS[diagnosis.unit]
    noise = f"{_number(diagnosis.residual.noise)}{'' if unit == '°' else ' '}{unit}"
    if not diagnosis.correlation:
        return Message("Noise between runs {noise}.", noise=noise)
    return Message(
        "Noise between runs {noise}, correlated by {correlation:.2f} between neighbours.",
        noise=noise,
        correlation=diagnosis.correlation,
    )


def _residuals(diagnosis: EvidenceDiagnosis, files: Sequence[Source]) -> Sheet:
    """Residual before, after and on runs left out: root mean squares over runs."""
    p, left = diagnosis.per_run, diagnosis.residual.left_out
    head: list[str] = [
        Message("residual, rms in {unit}", unit=SIGNS[diagnosis.unit]),
        Message("before"),
        Message("after"),
        Message("left out"),
    ]
    columns = (p.before, p.after, p.held_out)
    rows = [
        [name, *(_number(None if x is None else float(np.sqrt(np.mean(x[part] ** 2)))) for x in columns)]
        for name, part in _parts(files).items()
    ]
    if left is not None:
        head.append(Message("less form error"))
        rows = [[*row, _number(left.repeating) if k == 0 else ""] for k, row in enumerate(rows)]
    return Sheet("residuals", "", tuple(head), tuple(tuple(row) for row in rows))


def _path_errors(diagnosis: PathDiagnosis, files: Sequence[Source]) -> Sheet:
    """Path error before, after and on runs left out: means over runs."""
    p = diagnosis.per_run
    names = Message("before"), Message("after"), Message("left out"), Message("before, start as logged")
    head = (Message("path error, rms in {unit}", unit=SIGNS[diagnosis.unit]), *names)
    rows = [
        (name, *(_number(float(np.mean(x[part]))) for x in (p.before, p.after, p.held_out, p.as_logged)))
        for name, part in _parts(files).items()
    ]
    return Sheet("path-errors", "", head, tuple(rows))


def _datum(diagnosis: Diagnosis) -> Message:
    """Name of the datum and the range of its values, in words."""
    spans: dict[str, list[Value]] = {}
    for finding in diagnosis.datum if isinstance(diagnosis, EvidenceDiagnosis) else ():
        for value in finding.values:
            spans.setdefault(value.name, []).append(value)
    numbers = []
    for name, values in spans.items():
        low, high = (end(values, key=lambda v: v.value) for end in (min, max))
        if len(values) > 1:
            numbers.append(Message("{name} {low} to {high}", name=name, low=shown(low)[0], high=shown(high)[0]))
        else:
            numbers.append(Message("{name} {value}", name=name, value=" ± ".join(shown(low))))
    held = diagnosis.held if isinstance(diagnosis, EvidenceDiagnosis) else ""
    words = Message(diagnosis.kind.datum.words)
    if held:
        words = Message("{datum}, {held}", datum=words, held=held)
    return Message("{datum} ({numbers})", datum=words, numbers=joined(numbers, "; ")) if numbers else words


def _candidates(diagnosis: Diagnosis, files: Sequence[Source]) -> Sheet:
    best = diagnosis.candidates[:_SHOWN_CANDIDATES]
    rows = [*best, *(c for c in diagnosis.candidates if not c.effects and c not in best)]
    if not isinstance(diagnosis, PathDiagnosis):
        head = Message("candidates"), Message("worse by")
        return Sheet("candidates", "", head, tuple((_subset(c), f"{c.score:.1f}") for c in rows))
    parts = _parts(files)
    by_path = [c for c in rows if isinstance(c, PathCandidate)]
    cells = [(_subset(c), *(_number(float(np.mean(c.held_out[p]))) for p in parts.values())) for c in by_path]
    return Sheet("candidates", "", (Message("candidates, mm on runs left out"), *parts), tuple(cells))


def _subset(candidate: Candidate) -> str:
    return joined(map(Message, candidate.effects)) or Message("no effect")


def _parts(files: Sequence[Source]) -> dict[str, slice]:
    """All runs, and the runs of each file if there are several."""
    parts: dict[str, slice] = {Message("all runs"): slice(None)}
    ends = np.cumsum([0, *(source.record.runs for source in files)]).tolist()
    if len(files) > 1:
        parts |= {s.record.source: slice(a, b) for s, (a, b) in zip(files, pairwise(ends), strict=True)}
    return parts


def _zones(means: ZoneMeans) -> list[Block]:
    z, why = means.zones, means.shortfall
    blocks: list[Block] = [
        Heading(f"{means.kind.code}: {means.source}"),
        Message(
            "Verdict: {verdict}. {sentence}",
            verdict=Message(str(means.judgement.verdict)),
            sentence=means.judgement.sentence,
        ),
        Message(
            "A run over a smooth zone turns the cam by m, over a jump by m + B, over a wait by m - B. B = {error:.3f} "
            "± {sigma:.3f}°; left over {misfit:+.2f} standard errors.",
            error=z.return_error_deg,
            sigma=z.sigma_deg,
            misfit=z.misfit,
        ),
    ]
    for (order, tabled), compared in zip(means.tabled.items(), z.compared, strict=True):
        blocks.append(
            Message(
                "The greatest return error of the {order} train by [train] is {tabled:.3f}°: {where}, B is {apart:.1f} "
                "standard errors {side} it.",
                order=order,
                tabled=tabled,
                where=Message("inside the interval") if compared.inside else Message("outside the interval"),
                apart=abs(compared.apart),
                side=Message("above") if compared.apart > 0 else Message("below"),
            )
        )
    if not means.tabled:
        blocks.append(Message("The design has no [train], so there is no tabled return error to compare with."))
    if why is None:
        blocks.append(
            Message(
                "The smooth zone turned {turned:.2f}°. What it should have turned is not known: the file's remarks "
                'must say speed and time, as in "motor 60 rpm, 15 s a trial", and the design its [train].',
                turned=z.smooth_deg,
            )
        )
        return blocks
    blocks.append(
        Message(
            "The smooth zone turned {turned:.2f} ± {sigma:.2f}° and not {expected:.2f}°: {missing:.2f}° {less}. Play "
            "taken up once costs no more than {error:.1f}°, so it is not the cause. Each of these alone would do, and "
            "one mean cannot choose: a mean motor speed of {speed:.1f} rpm; {lost:.2f} s of full speed lost in "
            "starting and stopping; a ratio of {ratio:.2f}. To decide: an encoder on the motor, or two run times. The "
            "difference between zones does not depend on it, as long as it is the same in all of them.",
            turned=z.smooth_deg,
            sigma=z.smooth_sigma_deg,
            expected=why.expected_deg,
            missing=abs(why.missing_deg),
            less=Message("less") if why.missing_deg > 0 else Message("more"),
            error=z.return_error_deg,
            speed=why.speed_rpm,
            lost=why.lost_time_s,
            ratio=why.ratio,
        )
    )
    return blocks


def _together(c: CalibrationPlan) -> list[Block]:
    blocks: list[Block] = [Heading(Message("together"))] if c.shared else []
    for common in c.shared:
        name, sources = Message(common.deviation.name), listed(common.sources, "and")
        if common.agrees:
            values = ", ".join(f"{v.name} {' ± '.join(shown(v))}" for v in common.values)
            blocks.append(
                Message(
                    "{name} shows in {sources}, and they agree: {values} together.",
                    name=name,
                    sources=sources,
                    values=values,
                )
            )
        else:
            best = at_work([claim for claim in c.claims if claim.deviation == common.deviation])[0]
            blocks.append(
                Message(
                    "{name} shows in {sources}, but not with one size (chance {chance:.0e}): it is not one effect, or "
                    "something else hides in one of them. That of the {kind} is taken, which is nearest to what the "
                    "car drives with.",
                    name=name,
                    sources=sources,
                    chance=common.chance,
                    kind=best.kind.code,
                )
            )
    return blocks


def _built(c: CalibrationPlan) -> list[Block]:
    if not c.built:
        return [Heading(Message("as built")), Message("Nothing is claimed, so there is no as-built design.")]
    blocks: list[Block] = [Heading(Message("as built")), *map(sentence, c.built)]
    if (o := c.outlook_agreed) is not None:  # once the user agrees to all that a new cam can take out
        names = [
            Message("{effect}, from {kind}", effect=Message(b.claim.finding.effect), kind=b.claim.kind.code)
            for b in c.built
            if b.waits
        ]
        blocks.append(
            Message(
                'With place = "car" for {names}, the run is expected to end {new} mm off ({least} to {most} mm in 90 '
                "%); {worse}.",
                names=listed(names, "and"),
                new=_length(o.new),
                least=_length(o.least),
                most=_length(o.most),
                worse=chance_to_be_worse(o.worse, explained=o.explained),
            )
        )
    if c.holds is not None:  # a car without play may be held by friction or drag
        friction, angle = c.holds
        drag = Message("drag")
        if c.against.drag:
            drag = Message("the drag of up to {drag:g} N·mm that the design has", drag=c.against.drag)
        blocks.append(
            Message(
                "No play shows on this track, though the design allows some. Either the gears have none, or the cam is "
                "held: sliding friction above {friction:.2f} does that everywhere (at {angle:.0f}° it takes most), or "
                "{drag}, and oil or shaking would set it free. To know, {how}.",
                friction=friction,
                angle=np.degrees(angle),
                drag=drag,
                how=Message(MEASURE_FRICTION),
            )
        )
    return blocks


def sentence(built: Built) -> Message:
    """Sentence on a claimed effect, the sense of its numbers, and what becomes of it."""
    finding, kind = built.claim.finding, built.claim.kind
    place = PLACES[built.place]
    if built.instead is not None:
        place = Message(
            "Recorded only: the {effect} from {kind} stands for it",
            effect=Message(built.instead.finding.effect),
            kind=built.instead.kind.code,
        )
    elif built.place == Place.NOTED:
        place = _of_train(finding) or place
    name = Message(finding.effect)
    words = Message(
        "{name}, from {kind}: {sizes} ({signs}). {place}.",
        name=Message("no {effect}", effect=name) if built.claim.absent else name,
        kind=kind.code,
        sizes=Message("{sizes}, the mean of {sources}", sizes=_sizes(finding), sources=listed(built.mean_of, "and"))
        if built.mean_of
        else _sizes(finding),
        signs=joined((Message(p.meaning) for p in kind.named(finding.effect, dict(finding.indices)).parameters), "; "),
        place=place,
    )
    if built.claim.sure:
        return words
    return Message("{words} The name is not sure; what it does to the run together with the others is.", words=words)


def _of_train(finding: Finding) -> Message | None:
    """Reason why an effect of the train is only noted, and what a cam can do about it; None for another effect."""
    turns = dict(finding.indices).get("turns_per_turn")
    if turns is not None and turns != round(turns):
        return Message("Recorded only: it does not repeat with every turn of the cam, and no cam takes it out")
    if turns is None and finding.effect != WIND_UP.name:
        return None
    return Message(
        'Recorded only, as it may be the instrument\'s; it repeats with every turn of the cam, so with place = "car" a '
        "new cam takes it out, and every wheel must then stay on its shaft and in mesh as it was measured"
    )


def _number(value: float | None) -> str:
    return "-" if value is None or not isfinite(value) else f"{value:.4g}"
