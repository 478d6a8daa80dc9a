"""A calibration in words and tables: what the terminal shows and the text file holds."""

from collections.abc import Sequence
from itertools import pairwise
from math import floor, isfinite, log10

import numpy as np

from cadgen.arrays import Array
from cadgen.design.section import listed
from cadgen.deviations.catalogue import named
from cadgen.deviations.friction import MEASURE_FRICTION
from cadgen.measurement.diagnose import Diagnosis, Finding, Value
from cadgen.measurement.together import at_work
from cadgen.report.text import Block, Heading, Table
from cadgen.workflow.calibration.plan import STEERED, Built, Calibration, Source, ZoneMeans

SIGNS = {"um": "µm", "deg": "°", "%": "%", "mm": "mm", "s": "s", "": ""}
DATUM = {
    "lift": "the zero of the dial in each run",
    "profile": "the clocking on the machine",
    "transmission": "the zero of the inclinometer in each run",
    "track": "the start pose of each run",
    STEERED: "the start pose of each run",
}
PLACES = {
    "car": "stays with the car: simulate predicts with it, and a new cam is made for it",
    "process": "every disc made this way has it: simulate predicts with it, and a new cam is cut to come right",
    "part": "belongs to the disc that was measured: simulate predicts with it, and a new cam has it no more",
    "noted": "recorded only: it may be the instrument's, or it is nothing that a cam can take out",
}
_SHOWN_CANDIDATES = 6


def report(calibration: Calibration) -> list[Block]:
    """Everything a calibration says."""
    c = calibration
    floor = f"; form error of the disc {c.form_error_um:g} µm rms ({c.form_error_from})" if c.track_length else ""
    blocks: list[Block] = [f"{c.design.name}, {c.profile} profile{floor}."]
    if c.wheelbase is not None:
        by = "a file says so" if c.wheelbase[1] else "the design's, since no file says it"
        blocks.append(
            f"Wheelbase of the logged car {c.wheelbase[0]:g} mm ({by}); the design's cam plays no part in it."
        )
    blocks += [f"Warning: {text}." for text in c.warnings]
    for told in c.told:
        blocks += _record(told, c.files(told.kind))
        if told.source in c.settled:
            one = c.settled[told.source]
            names = " and ".join(claim.finding.effect for claim in one.claims)
            by_claims = "; ".join(f"{claim.finding.effect} from {claim.source}" for claim in one.by)
            blocks.append(f"Decided by the other data ({by_claims}): {names}, which counts as claimed.")
    if c.zones is not None:
        blocks += _zones(c.zones)
    blocks += _together(c)
    blocks += _built(c)
    return blocks


def summary(each: Sequence[Calibration]) -> list[Block]:
    """A row for each file judged alone, and the effects with their sizes."""
    rows, effects = [], []
    for c in each:
        name = c.sources[0].path.stem
        for told in c.told:
            r = told.residual
            numbers = (r.before, r.after, r.held_out, r.held_out_repeating, r.noise)
            rows.append((name, told.verdict, SIGNS[told.unit], *(_number(x) for x in numbers)))
            effects.append((name, sizes(told.findings) or "-"))
        if c.zones is not None:
            rows.append((name, c.zones.judgement.verdict, SIGNS["deg"], *["-"] * 5))
            effects.append((name, sizes((c.zones.finding,))))
    head = ("file", "verdict", "rms in", "before", "after", "left out", "less form", "noise")
    return [
        Table(head, tuple(rows), words=3),
        "",
        Table(("file", "effects and sizes"), tuple(effects), words=2),
        "",
        "Left out: each run with the effects fitted to the others; less form: with what the other runs say of the form "
        "error taken away too.",
        *(f"Warning: {text}." for c in each for text in c.warnings),
    ]


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
    told = [f"{v.name} {' ± '.join(text for text in shown(v) if text)}" for v in finding.values]
    return ", ".join([*told, *(f"{name} {number:g}" for name, number in finding.given)])


def _record(told: Diagnosis, files: Sequence[Source]) -> list[Block]:
    j, unit = told.judgement, SIGNS[told.unit]
    rows = sum(len(source.record.run) for source in files)
    blocks: list[Block] = [
        Heading(f"{told.kind}: {told.source} ({_plural(told.runs, 'run')}, {_plural(rows, 'row')})"),
        f"Verdict: {told.verdict}. {j.sentence}",
    ]
    if told.known:
        blocks.append(f"Taken as known from the profile: {' and '.join(told.known)}.")
    for finding in told.findings:
        claimed = "" if finding.effect in j.claimed else " (not claimed)"
        blocks.append(f"  {finding.effect}{claimed}: {_sizes(finding)}")
    blocks += ["", _residuals(told, files), ""]
    if told.kind != STEERED:
        space = "" if unit == "°" else " "
        blocks.append(f"Noise between runs {_number(told.residual.noise)}{space}{unit}{_correlated(told)}.")
    blocks.append(f"Fitted and never claimed: {_datum(told)}.")
    verb = "decide" if told.verdict == "ambiguous" else "make sure"
    if told.verdict not in ("unexplained", "runs disagree"):
        blocks += [f"To {verb}, {text}." for text in j.separate]
    blocks += [f"Limit: {text}." for text in j.limits]
    blocks += ["", _candidates(told, files)]
    return blocks


def _residuals(told: Diagnosis, files: Sequence[Source]) -> Table:
    """Before, after and on runs left out."""
    r, p, steered = told.residual, told.per_run, told.kind == STEERED
    head = [f"{'path error' if steered else 'residual'}, rms in {SIGNS[told.unit]}", "before", "after", "left out"]
    parts = _parts(files)
    columns = [p.before, p.after, p.held_out]
    if p.as_logged is not None:
        head.append("before, start as logged")
        columns.append(p.as_logged)
    rows = [[name, *(_number(_mean(x[part], steered)) for x in columns)] for name, part in parts.items()]
    if isfinite(r.held_out_repeating):
        head.append("less form error")
        rows = [[*row, _number(r.held_out_repeating) if k == 0 else ""] for k, row in enumerate(rows)]
    return Table(tuple(head), tuple(tuple(row) for row in rows))


def _mean(values: Array, steered: bool) -> float:
    """Of path errors the mean over runs, of residuals the root mean square."""
    return float(np.mean(values) if steered else np.sqrt(np.mean(values**2)))


def _correlated(told: Diagnosis) -> str:
    return f", correlated by {told.correlation:.2f} between neighbours" if told.correlation else ""


def _datum(told: Diagnosis) -> str:
    """What it is, and how far its values go."""
    spans: dict[str, list[Value]] = {}
    for finding in told.datum:
        for value in finding.values:
            spans.setdefault(value.name, []).append(value)
    numbers = []
    for name, values in spans.items():
        low, high = (end(values, key=lambda v: v.value) for end in (min, max))
        several = f"{shown(low)[0]} to {shown(high)[0]}" if len(values) > 1 else " ± ".join(shown(low))
        numbers.append(f"{name} {several}")
    return DATUM[told.kind] + (f" ({'; '.join(numbers)})" if numbers else "")


def _candidates(told: Diagnosis, files: Sequence[Source]) -> Table:
    best = told.candidates[:_SHOWN_CANDIDATES]
    shown_ones = [*best, *(c for c in told.candidates if not c.effects and c not in best)]
    names = [", ".join(c.effects) or "no effect" for c in shown_ones]
    if told.kind != STEERED:
        rows = [(name, f"{c.score:.1f}") for name, c in zip(names, shown_ones, strict=True)]
        return Table(("candidates", "worse by"), tuple(rows))
    parts = _parts(files)
    steered = [
        (name, *(_number(float(np.mean(c.held_out[part]))) for part in parts.values()))
        for name, c in zip(names, shown_ones, strict=True)
    ]
    return Table(("candidates, mm on runs left out", *parts), tuple(steered))


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
        Heading(f"zones: {means.source}"),
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


def _together(c: Calibration) -> list[Block]:
    if not c.shared:
        return []
    blocks: list[Block] = [Heading("together")]
    for one in c.shared:
        sources = listed(one.sources, "and")
        if one.agrees:
            values = ", ".join(f"{v.name} {' ± '.join(shown(v))}" for v in one.values)
            blocks.append(f"{one.thing} shows in {sources}, and they agree: {values} together.")
        else:
            best = at_work([claim for claim in c.claims if claim.thing == one.thing])[0]
            blocks.append(
                f"{one.thing} shows in {sources}, but not with one size (chance {one.chance:.0e}): it is not one "
                f"effect, or something else hides in one of them. That of the {best.kind} is taken, which is nearest "
                "to what the car drives with."
            )
    return blocks


def _built(c: Calibration) -> list[Block]:
    if not c.built:
        return [Heading("as built"), "Nothing is claimed, so there is no as-built design."]
    return [Heading("as built"), *(sentence(one) for one in c.built), *_held(c)]


def _held(c: Calibration) -> list[Block]:
    """That a car without play may be held by friction or drag."""
    if c.holds is None:
        return []
    friction, angle = c.holds
    most = c.design.mechanics.drag_Nmm[1] if c.design.mechanics else 0.0
    drag = f"the drag of up to {most:g} N·mm that the design has" if most else "drag"
    return [
        f"No play shows on this track, though the design allows some. Either the gears have none, or the cam is held: "
        f"sliding friction above {friction:.2f} does that everywhere (at {np.degrees(angle):.0f}° it takes most), or "
        f"{drag}, and oil or shaking would set it free. To know, {MEASURE_FRICTION}."
    ]


def sentence(one: Built) -> str:
    """A claimed effect, the sense of its numbers, and what becomes of it."""
    finding, place = one.claim.finding, PLACES[one.place]
    if one.instead is not None:
        place = f"recorded only: the {one.instead.finding.effect} from {one.instead.kind} stands for it"
    name = f"no {finding.effect}" if one.claim.absent else finding.effect
    if one.claim.remainder:
        name += f" beside the profile's ({one.claim.thing})"
    signs = "; ".join(p.meaning for p in named(one.claim.kind, finding.effect, dict(finding.given)).parameters)
    of = f", the mean of {listed(one.mean_of, 'and')}" if one.mean_of else ""
    return f"{name}, from {one.claim.kind}: {_sizes(finding)}{of} ({signs}). {place[0].upper()}{place[1:]}."


def _number(value: float) -> str:
    return f"{value:.4g}" if isfinite(value) else "-"


def _plural(count: int, name: str) -> str:
    return f"{count} {name}{'' if count == 1 else 's'}"
