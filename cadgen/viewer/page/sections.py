"""Sections of the page: checks, play, tolerance, inspection, parts, calibration."""

from collections.abc import Iterable
from dataclasses import replace
from math import degrees, isinf
from typing import TYPE_CHECKING

import numpy as np

from cadgen.check import Bound, Check
from cadgen.design.as_built import AsBuiltSection
from cadgen.deviations.deviation import Place
from cadgen.figures import Cell, Emphasis, Figures, Sheet, number
from cadgen.gears.inspection import gauge_in
from cadgen.gears.layout import TrainLayout
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.remedies import Remedy
from cadgen.jobs.error_budget import shown_value
from cadgen.jobs.gears.assembly import gear_figures
from cadgen.jobs.gears.gear_train import GearTrain
from cadgen.jobs.simulation import Simulation
from cadgen.jobs.tolerance import Spread, ToleranceRun
from cadgen.messages import Message
from cadgen.parts.blank import Blank
from cadgen.parts.features import Keyway
from cadgen.viewer.page.charts import name_before
from cadgen.viewer.page.document import Bars, ChartBar, Section

if TYPE_CHECKING:
    from cadgen.jobs.calibration.calibration import CalibrationPlan
    from cadgen.jobs.worn_cam.compared_cam import ComparedCamPlan
    from cadgen.output.report.terminal import Block

_PLACES = {
    Place.CAR: Message("the car"),
    Place.PROCESS: Message("discs made this way"),
    Place.PART: Message("the disc that was measured"),
    Place.NOTED: Message("recorded only"),
}
_STEP_DEG = 10
_NO_ANGLE = 1e-9  # rad
_MOST_BARS = 8  # of a picture
_LEAD = 4  # paragraphs of a calibration above its tables: expectation, warnings and verdict come first


def checks_section(cam: CamPlan, train: GearTrain | None, title: str = Message("Cam")) -> Section:
    """Every check of cam and gears, failures first."""
    tables = [_checks("cam-checks", title, cam.figures)]
    if train is not None:
        tables.append(_checks("gear-checks", Message("Gears"), train.checks))
    return Section(
        "checks",
        Message("Checks"),
        (Message("Each figure with its limit. A figure without a limit is shown and not judged."),),
        tuple(tables),
    )


def train_sections(train: GearTrain) -> tuple[Section, ...]:
    """Checks, play, inspection sheet and parts of a train without a cam."""
    lead = Message("Each figure with its limit. A figure without a limit is shown and not judged.")
    size = Message("Sizes to measure the parts by; write what you measure into the empty cells.")
    sizes, rows = _gear_sizes(train.layout.pieces), tuple(_gear_rows(train.layout.pieces))
    parts = Sheet("parts", Message("Parts"), _part_heads(), rows, words=2)
    return (
        Section("checks", Message("Checks"), (lead,), (_checks("gear-checks", Message("Gears"), train.checks),)),
        Section("play", Message("Play"), (), (train.return_errors,)),
        *([] if sizes is None else [Section("inspection", Message("Inspection sheet"), (size,), (sizes,))]),
        Section("parts", Message("Parts list"), (), (parts, _stages(train.layout)), train.notes),
    )


def _part_heads(*, gears: bool = True, mass: bool = False) -> tuple[Message, ...]:
    """Heads of a parts list, with columns of gears and of the mass where it has them."""
    return (
        Message("part"),
        Message("material"),
        Message("quantity"),
        *((Message("teeth"), Message("module")) if gears else ()),
        Message("bore"),
        Message("width"),
        Message("volume"),
        *((Message("mass"),) if mass else ()),
    )


def _checks(code: str, caption: str, checks: Iterable[Check]) -> Sheet:
    rows = [_check(check) for check in sorted(checks, key=lambda check: check.passed)]
    heads = (Message("check"), Message("verdict"), Message("value"), Message("limit"), Message("where"))
    return Sheet(code, caption, heads, tuple(rows), words=2, tail=1)


def _check(check: Check) -> tuple[Cell | str, ...]:
    unit, limit = check.unit_shown, number(check.limit, check.unit_shown)
    verdict = Cell(Message("ok"), state=Emphasis.GOOD)
    if isinf(check.limit):
        verdict, limit = Cell(Message("shown"), state=Emphasis.MUTED), number(None)
    else:
        limit = replace(limit, text=f"{'≤' if check.bound == Bound.MAX else '≥'} {limit.text}")
        if not check.passed:
            verdict = Cell(Message("FAILS"), state=Emphasis.BAD)
    value = number(check.value, unit, Emphasis.PLAIN if check.passed else Emphasis.BAD)
    return check.name, verdict, value, limit, check.place


def play_section(
    comparison: PlayComparison | None, simulation: Simulation[CamPlan] | None, remedies: tuple[Remedy, ...]
) -> Section:
    """Methods against play, runs, events, room on the course, remedies; a sentence without play.

    Args:
        comparison: comparison under play; None for a profile that is not for play.
        simulation: runs with play; None without play.
        remedies: further remedies against play.
    """
    if comparison is None or simulation is None:
        return Section(
            "play",
            Message("Play"),
            (
                Message(
                    "Nothing is known of the play of the gears, or this profile is not compared under play: add "
                    "[train] or [play] to the design."
                ),
            ),
        )
    low, high = comparison.band.ends
    lead = Message(
        "The train gives a return error of {low:.3f}° to {high:.3f}° at the camshaft; the profile is cut for "
        "{cut}, and the runs have {play:.3f}°.",
        low=degrees(low),
        high=degrees(high),
        cut=comparison.chosen.cut_for,
        play=degrees(simulation.play),
    )
    tables = [_methods(comparison), _runs(simulation)]
    if simulation.events:
        digits = {"cam_angle": 2, "deflection": 4}
        rows = tuple(
            (Cell(event.kind), *(figure.cell(digits=digits.get(code)) for code, figure in event.figures.items()))
            for event in simulation.events
        )
        heads = (Message("event"), *_names(simulation.events[0].figures))
        tables.append(Sheet("events", Message("Jumps and waits of the plain profile"), heads, rows))
    if simulation.on_course is not None:
        tables.append(_course(simulation))
    if remedies:
        rows = tuple(
            (Cell(remedy.name), Cell(remedy.build), *(part.cell() for part in remedy.figures.values()))
            for remedy in remedies
        )
        heads = (Message("remedy"), Message("what to build"), *_names(remedies[0].figures))
        tables.append(Sheet("remedies", Message("Remedies"), heads, rows, words=2))
    built = [remedy for remedy in remedies if remedy.worst_end is not None]
    least = min((remedy.worst_end for remedy in built if remedy.worst_end is not None), default=None)
    bars = tuple(ChartBar(remedy.name, remedy.worst_end or 0.0, remedy.worst_end == least) for remedy in built)
    notes = (*comparison.reasons, *filter(None, [comparison.rubbing]))
    return Section(
        "play",
        Message("Methods against play"),
        (
            lead,
            Message(
                "Errors are those of the drive wheel at the end of the run, with the play that each profile is cut for."
            ),
        ),
        tuple(tables),
        notes,
        (Bars("remedies", Message("End of the run in the worst car, by remedy"), "mm", bars),) if bars else (),
        frozenset({"events", "remedies"}),
    )


def _methods(comparison: PlayComparison) -> Sheet:
    at = comparison.chosen.error.judged_at
    compared = (
        "end_heading",
        f"{at}_position",
        "position_percent_off",
        f"worst_{at}_position",
        "lift_error",
        f"{at}_position_without_play",
    )
    several = len({evaluation.train for evaluation in comparison.evaluations}) > 1
    rows, names = [], tuple[str, ...]()
    for evaluation in comparison.evaluations:
        chosen = evaluation is comparison.chosen
        state = Emphasis.STRONG if chosen else Emphasis.PLAIN
        figures = comparison.figures(evaluation)
        names = tuple(figures[code].name for code in compared)
        cells = {code: figures[code].cell(state) for code in compared}
        gain = None if evaluation is comparison.before else figures["position_percent_off"].value
        cells["position_percent_off"] = number(gain, "%", state, 1)
        name = Message("cam as measured") if evaluation.measured else evaluation.profile.code
        rows.append(
            (
                Cell(name, state=state),
                *((Cell(evaluation.train, state=state),) if several else ()),
                Cell(Message("chosen"), state=Emphasis.GOOD) if chosen else "",
                *cells.values(),
            )
        )
    heads = (Message("profile"), *((Message("train"),) if several else ()), "", *names)
    return Sheet("methods", Message("Profiles compared"), heads, tuple(rows), words=3 if several else 2)


def _names(figures: Figures) -> tuple[str, ...]:
    return tuple(figure.name for figure in figures.values())


def _runs(simulation: Simulation[CamPlan]) -> Sheet:
    chosen, before = simulation.comparison.chosen, simulation.comparison.before
    runs = (
        (Cell(name_before(before)), simulation.before_error),
        (Cell(Message("this cam, with play"), state=Emphasis.STRONG), simulation.after_error),
        (Cell(Message("this cam, without play")), chosen.deviation),
    )
    rows = tuple((name, *(figure.cell() for figure in error.figures.values())) for name, error in runs)
    heads = (Message("run"), *_names(simulation.after_error.figures))
    return Sheet("runs", Message("End of the run"), heads, rows)


def _course(simulation: Simulation[CamPlan]) -> Sheet:
    assert simulation.on_course is not None
    planned, played = (run.figures() for run in simulation.on_course)
    rows = [
        (
            key,
            where,
            number(planned[key][1], "mm", Emphasis.BAD if planned[key][1] < 0 else Emphasis.PLAIN),
            number(room, "mm", Emphasis.BAD if room < 0 else Emphasis.PLAIN),
        )
        for key, (where, room) in played.items()
    ]
    heads = (Message("on the course"), Message("with play, by"), Message("planned"), Message("with play"))
    return Sheet("course", Message("Room on the course"), heads, tuple(rows), words=2)


def tolerance_section(run: ToleranceRun[CamPlan] | None, reason: str) -> Section:
    """Many cars within the tolerances; or the reason why there are none."""
    title = Message("Tolerance")
    if run is None:
        return Section("tolerance", title, (reason,))
    lead = Message(
        "{samples} random cars with this cam (seed {seed}, {law} law).",
        samples=run.samples,
        seed=run.seed,
        law=Message(run.law),
    )
    spreads: tuple[tuple[str, Spread, str], ...] = (
        (Message("position at the end"), run.end_position, "mm"),
        (Message("heading at the end"), run.end_heading_deg, "°"),
    )
    ends = Sheet(
        "ends",
        Message("Errors at the end"),
        (
            Message("error"),
            Message("mean"),
            *(f"{100 * part:g} %" for part in run.end_position.quantiles),
            Message("greatest"),
        ),
        tuple(
            (
                name,
                number(spread.mean, unit),
                *(number(value, unit) for value in spread.quantiles.values()),
                number(spread.greatest, unit),
            )
            for name, spread, unit in spreads
        ),
    )
    table = _sensitivities(run)
    # Share of each tolerance in the variance of the ends, the small ones together.
    most, others = run.sensitivities[:_MOST_BARS], run.sensitivities[_MOST_BARS:]
    rows = [ChartBar(item.name.replace("_", " "), 100 * item.share, not count) for count, item in enumerate(most)]
    if rest := sum(100 * item.share for item in others):
        rows.append(ChartBar(Message("all others"), rest))
    bars = Bars("shares", Message("What costs most of the scatter at the end"), "%", tuple(rows))
    return Section("tolerance", title, (lead,), (ends, table), bars=(bars,), folded=frozenset({table.code}))


def _sensitivities(run: ToleranceRun[CamPlan]) -> Sheet:
    rows = [
        (
            item.name.replace("_", " "),
            shown_value(item.deviation, run.half_widths[item.deviation]),
            shown_value(item.deviation, item.step),
            number(item.distance, "mm"),
            number(degrees(item.heading), "°", digits=4),
            number(100 * item.share, "%", digits=1),
        )
        for item in run.sensitivities
    ]
    heads = (
        Message("tolerance"),
        Message("half width"),
        Message("step"),
        Message("position for a step"),
        Message("heading for a step"),
        Message("of the variance"),
    )
    return Sheet("sensitivities", Message("What matters most"), heads, tuple(rows), words=3)


def parts_sections(cam: CamPlan, train: GearTrain | None) -> tuple[Section, Section]:
    """Inspection sheet and parts list of a cam and its train, if it has one."""
    return _inspection(cam, train), _parts(cam, train)


def _inspection(cam: CamPlan, train: GearTrain | None) -> Section:
    """Figures to measure the cam and the gears by, with room for what is measured."""
    # A groove has no outline to be measured: its sizes are in the parts list and the checks.
    tables = [*([] if cam.groove is not None else map(_cam_sizes, cam.discs)), _lift_table(cam)]
    if train is not None and (gears := _gear_sizes(train.layout.pieces)) is not None:
        tables.append(gears)
    return Section(
        "inspection",
        Message("Inspection sheet"),
        (
            Message(
                "Sizes to measure the parts by; write what you measure into the empty cells. The lift holds on the "
                "finished cam with its follower."
            ),
            _zero(cam.made_blank),
        ),
        tuple(tables),
    )


def _zero(blank: Blank) -> Message:
    """Place of cam angle 0 on the disc, by what a hand finds there: key, flat, set screw, mark, or none of them."""
    where: tuple[str, float] | None = None
    if blank.key is not None:
        key = (
            Message("the middle of the keyway") if isinstance(blank.key, Keyway) else Message("the middle of the flat")
        )
        where = key, blank.key.angle
    elif blank.hub is not None and blank.hub.set_screw is not None:
        where = Message("the set screw"), blank.hub.set_screw.angle
    elif blank.mark is not None:
        where = Message("the mark"), blank.mark.angle
    if where is None:
        return Message(
            "The bore is plain: cam angle 0 is the X axis of drawing and files. Scribe it on the disc before the disc "
            "leaves the machine."
        )
    what, angle = where
    if abs(angle) < _NO_ANGLE:
        return Message("Cam angle 0 is at {what}, on the X axis of drawing and files.", what=what)
    return Message(
        "Cam angle 0 is on the X axis of drawing and files, and {what} at {angle:.4g}°, counterclockwise there.",
        what=what,
        angle=degrees(angle) % 360,
    )


def _cam_sizes(plan: CamPlan) -> Sheet:
    blank = plan.made_blank
    radius = np.hypot(*plan.curve.outline(0.1).points.T)
    rows: list[tuple[str, float]] = [
        (Message("greatest radius of the disc"), float(radius.max())),
        (Message("least radius of the disc"), float(radius.min())),
        (Message("thickness"), plan.thickness),
        (Message("bore diameter"), blank.bore_diameter),
    ]
    if isinstance(blank.key, Keyway):
        rows += [(Message("keyway width"), blank.key.width), (Message("keyway depth"), blank.key.depth)]
    if blank.edge_break:
        rows.append((Message("broken edges, leg of the chamfer"), blank.edge_break))
    return Sheet(
        "second-cam-sizes" if plan.part else "cam-sizes",
        Message("Second cam") if plan.part else Message("Cam"),
        (Message("dimension"), Message("nominal"), Message("measured")),
        tuple((name, number(value, "mm"), "") for name, value in rows),
    )


def _lift_table(plan: CamPlan) -> Sheet:
    """Lift each ten degrees, by which a dial gauge on the follower proves the disc."""
    rolled = plan.application.rolled(plan)
    angles = np.arange(0, 360, _STEP_DEG)
    lift = plan.follower_as_built.lift(rolled.q(np.radians(angles)))
    half = len(angles) // 2
    rows = [
        (
            number(float(angles[row]), "°", digits=0),
            number(float(lift[row]), "mm", digits=3),
            "",
            number(float(angles[row + half]), "°", digits=0),
            number(float(lift[row + half]), "mm", digits=3),
            "",
        )
        for row in range(half)
    ]
    head = (Message("cam angle"), Message("lift"), Message("measured"))
    return Sheet("lift-table", Message("Lift of the follower"), (*head, *head), tuple(rows), words=0)


def _gear_sizes(layout: TrainLayout) -> Sheet | None:
    """Span and size over pins of each gear; None for wheels without teeth."""

    def columns(gear: Figures) -> tuple[tuple[str, int | None], ...]:
        gauge = gauge_in(gear)
        return (
            ("teeth", 0),
            ("teeth_spanned", 0),
            ("span_min", 3),
            ("span_max", 3),
            (gauge.diameter, None),
            (f"{gauge.size}_min", 3),
            (f"{gauge.size}_max", 3),
        )

    rows: list[tuple[Cell | str, ...]] = [
        (part.name, *(gear[code].cell(digits=digits) for code, digits in columns(gear)), "")
        for part, gears in zip(layout.parts, gear_figures(layout), strict=True)
        for gear in gears.values()
        if "span_max" in gear
    ]
    heads = (
        Message("part"),
        Message("teeth"),
        Message("teeth spanned"),
        Message("span, least"),
        Message("span, greatest"),
        Message("pins, of helical gears and rings balls"),
        Message("size over them, least"),
        Message("size over them, greatest"),
        Message("measured"),
    )
    return (
        Sheet("gear-sizes", Message("Gears: base tangent length and size over pins or balls"), heads, tuple(rows))
        if rows
        else None
    )


def _parts(cam: CamPlan, train: GearTrain | None) -> Section:
    """Parts list; without gears it has no columns of gears, and without a material no column of the mass."""
    gears, mass = train is not None, cam.mass
    teeth = (number(None), number(None)) if gears else ()
    rows: list[tuple[Cell | str, ...]] = [
        (
            Message("second cam") if disc.part else Message("cam"),
            disc.making.ordered or "–",
            number(1, digits=0),
            *teeth,
            number(disc.made_blank.bore_diameter, "mm"),
            number(disc.thickness, "mm"),
            number(disc.volume * 1e-3, "cm³"),
            *(() if mass is None else (number(disc.mass, "g", digits=1),)),
        )
        for disc in cam.discs
    ]
    if train is not None:
        rows += [(*row, *(() if mass is None else (number(None),))) for row in _gear_rows(train.layout.pieces)]
    heads = _part_heads(gears=gears, mass=mass is not None)
    tables = [Sheet("parts", Message("Parts"), heads, tuple(rows), words=2)]
    if train is not None:
        tables.append(_stages(train.layout))
    notes = () if train is None else train.notes
    return Section("parts", Message("Parts list"), (), tuple(tables), notes)


def _gear_rows(layout: TrainLayout) -> list[tuple[Cell | str, ...]]:
    rows: list[tuple[Cell | str, ...]] = []
    for part, gears in zip(layout.parts, gear_figures(layout), strict=True):
        teeth, modules, widths = (
            [value for gear in gears.values() if (value := gear.value(code)) is not None]
            for code in ("teeth", "module", "width")
        )
        rows.append(
            (
                part.name,
                Cell("–", state=Emphasis.MUTED),
                number(1, digits=0),
                Cell(" + ".join(map(str, teeth)) or "–"),
                Cell(" + ".join(f"{module:g}" for module in sorted(set(modules))) or "–", unit="mm" if modules else ""),
                number(part.blank.bore_diameter, "mm"),
                Cell(" + ".join(f"{width:g}" for width in widths) or "–", unit="mm"),
                number(part.volume * 1e-3, "cm³"),
            )
        )
    return rows


def _stages(layout: TrainLayout) -> Sheet:
    """Each stage with its ratio and play."""
    rows = [
        (
            number(count, digits=0),
            stage.label,
            number(float(stage.ratio)),
            number(stage.centre_distance, "mm"),
            number(degrees(stage.free_angle()), "°"),
            number(degrees(layout.directions[count - 1]) % 360, "°", digits=1),
        )
        for count, stage in enumerate(layout.train.stages, 1)
    ]
    heads = (
        Message("stage"),
        Message("teeth"),
        Message("ratio"),
        Message("centre distance"),
        Message("play as cut, at the driven wheel"),
        Message("direction"),
    )
    return Sheet("stages", Message("Stages"), heads, tuple(rows), words=2)


def calibration_section(calibration: "CalibrationPlan | None", record: AsBuiltSection | None, reason: str) -> Section:
    """Measurements: verdicts on files, or the effects of an as-built design; a sentence without either.

    Args:
        calibration: verdict on measured files; None without any.
        record: section [as_built]; None of a car as designed.
        reason: why the measured data are left out; empty if they are not.
    """
    if reason:
        return refused_section(reason)
    if calibration is not None:
        from cadgen.jobs.calibration.calibration_report import report

        return _of_blocks(report(calibration))
    if record is None:
        return Section(
            "calibration",
            Message("Calibration"),
            (
                Message(
                    "Nothing was measured on this car: name measured files after the design, and what they say stands "
                    "here."
                ),
            ),
        )
    rows = [
        (
            effect.effect.replace("_", " "),
            _PLACES[effect.place],
            value.name,
            number(value.value),
            number(value.sigma),
        )
        for effect in record.effects
        for value in effect.values
    ]
    heads = (
        Message("effect"),
        Message("stays with"),
        Message("number"),
        Message("value"),
        Message("standard deviation"),
    )
    sources = [(source.file, source.kind, source.verdict or "–") for source in record.sources]
    tables = [Sheet("as-built", Message("Effects on the car as built"), heads, tuple(rows), words=3)]
    if sources:
        head = (Message("file"), Message("kind of data"), Message("verdict"))
        tables.append(Sheet("sources", Message("Measured files"), head, tuple(sources), words=3))
    return Section(
        "calibration",
        Message("Calibration"),
        (Message("The design holds what was measured on the car; every figure of this page counts it in."),),
        tuple(tables),
    )


def refused_section(reason: str) -> Section:
    """Section of measured data that cannot be judged.

    Args:
        reason: sentence of the refusal.
    """
    left_out = Message("The measured data are left out: {reason}.", reason=reason)
    return Section("calibration", Message("Calibration"), (left_out,))


def compared_section(compared: "ComparedCamPlan") -> Section:
    """Deviations of a measured cam by a motion from its design.

    Args:
        compared: measured cam beside its design.
    """
    from cadgen.jobs.worn_cam.compared_cam import compared_report

    return _of_blocks(compared_report(compared))


def _of_blocks(blocks: "Iterable[Block]") -> Section:
    """Section of the page from the blocks of a report for a terminal."""
    from cadgen.output.report.terminal import Heading

    lead: list[str] = []
    tables: list[Sheet] = []
    title: str = Message("Calibration")
    for block in blocks:
        if isinstance(block, Sheet):
            tables.append(replace(block, code=f"calibration-{len(tables) + 1}", title=title))
        elif isinstance(block, Heading):
            title = block.text
        elif block.strip():
            lead.append(block.strip())
    return Section("calibration", Message("Calibration"), tuple(lead[:_LEAD]), tuple(tables), tuple(lead[_LEAD:]))
