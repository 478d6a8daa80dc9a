"""Tables of the page on cam and play: checks, methods, runs, course, tolerance."""

from collections.abc import Iterable
from math import degrees, isinf

from cadgen.car.optimize.evaluate import Evaluation
from cadgen.check import Bound, Check
from cadgen.jobs.cam.comparison import PlayComparison
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.cam.remedies import Remedy
from cadgen.jobs.runs.budget import shown_value
from cadgen.jobs.runs.simulation import Simulation
from cadgen.jobs.runs.tolerance import Spread, ToleranceRun
from cadgen.viewer.page.check_words import check_name, place_words
from cadgen.viewer.page.content.plan import PagePlan
from cadgen.viewer.page.document import Cell, Section, Table, Text, Words, number
from cadgen.viewer.page.names import State
from cadgen.viewer.page.sentences import generated
from cadgen.viewer.page.words import named, say


def checks_section(plan: PagePlan) -> Section:
    """Every check of cam and gears, failures first."""
    tables = [_checks("cam-checks", say("Cam and course"), plan.cam.figures)]
    if plan.gears is not None:
        tables.append(_checks("gear-checks", say("Gears"), plan.gears.checks))
    return Section("checks", say("Checks"), (say("checks-lead"),), tuple(tables))


def _checks(code: str, caption: Text, checks: Iterable[Check]) -> Table:
    rows = [_check(check) for check in sorted(checks, key=lambda check: check.passed)]
    heads = (say("check"), say("verdict"), say("value"), say("limit"), say("where"))
    return Table(code, caption, heads, tuple(rows), words=2, tail=1)


def _check(check: Check) -> tuple[Cell, ...]:
    figure = isinf(check.limit)
    verdict = (
        Cell(say("shown"), state=State.MUTED)
        if figure
        else Cell(say("ok"), state=State.GOOD)
        if check.passed
        else Cell(say("FAILS"), state=State.BAD)
    )
    bound = "≤ " if check.bound == Bound.MAX else "≥ "
    unit = check.unit_shown
    limit = number(None) if figure else number(check.limit, unit)
    if not figure:
        limit = Cell(bound + str(limit.text), limit.value, limit.unit)
    return (
        Cell(check_name(check)),
        verdict,
        number(check.value, unit, State.PLAIN if check.passed else State.BAD),
        limit,
        Cell(place_words(check.place)),
    )


def play_section(plan: PagePlan) -> Section:
    """Methods against play, runs, events, room on the course, remedies."""
    comparison, simulation = plan.cam.comparison, plan.simulation
    if comparison is None or simulation is None:
        return Section("play", say("Play"), (say("no-play"),))
    low, high = comparison.band.ends
    lead = Words(
        f"The train gives a return error of {degrees(low):.3f}° to {degrees(high):.3f}° at the camshaft; the profile "
        f"is cut for {degrees(comparison.chosen.made_for):.3f}°, and the runs have {degrees(simulation.play):.3f}°.",
        f"轮系在凸轮轴上的回程误差为 {degrees(low):.3f}° 至 {degrees(high):.3f}°；轮廓按 "
        f"{degrees(comparison.chosen.made_for):.3f}° 补偿，仿真运行取 {degrees(simulation.play):.3f}°。",
    )
    tables = [_methods(comparison), _runs(simulation)]
    if simulation.events:
        tables.append(_events(simulation))
    if simulation.on_course is not None:
        tables.append(_course(simulation))
    if plan.remedies:
        tables.append(_remedies(plan.remedies))
    notes = tuple(map(generated, (*comparison.reasons, *filter(None, [comparison.rubbing]))))
    return Section("play", say("Methods against play"), (lead, say("methods-lead")), tuple(tables), notes)


def profile_name(evaluation: Evaluation) -> Text:
    """Name of a profile in both languages."""
    return say("cam as measured") if evaluation.measured else named(evaluation.profile.code)


def _methods(comparison: PlayComparison) -> Table:
    several = len({evaluation.train for evaluation in comparison.evaluations}) > 1
    rows = []
    for evaluation in comparison.evaluations:
        chosen = evaluation is comparison.chosen
        state: State = State.STRONG if chosen else State.PLAIN
        gain = None if evaluation is comparison.before else comparison.gain(evaluation)[1]
        name = profile_name(evaluation)
        cells = [Cell(name, state=state)]
        if several:
            cells.append(Cell(named(evaluation.train), state=state))
        cells += [
            Cell(say("chosen") if chosen else "", state=State.GOOD if chosen else State.PLAIN),
            number(degrees(evaluation.error.end_heading), "°", state),
            number(evaluation.error.end_distance, "mm", state),
            number(None if gain is None else 100 * gain, "%", state, 1),
            number(evaluation.band.worst_distance, "mm", state),
            number(evaluation.worst_lift_error * 1e3, "µm", state),
            number(evaluation.deviation.end_distance, "mm", state),
        ]
        rows.append(tuple(cells))
    heads = (
        say("profile"),
        *((say("train"),) if several else ()),
        "",
        say("heading at the end"),
        say("position at the end"),
        say("taken off"),
        say("worst position over the band"),
        say("lift error with play"),
        say("position without play"),
    )
    return Table("methods", say("Profiles compared"), heads, tuple(rows), words=3 if several else 2)


def _runs(simulation: Simulation) -> Table:
    chosen, before = simulation.comparison.chosen, simulation.comparison.before
    rows = [
        (
            Cell(say("measured cam, with play" if before.measured else "plain profile, with play")),
            simulation.before_error,
        ),
        (Cell(say("this cam, with play"), state=State.STRONG), simulation.after_error),
        (Cell(say("this cam, without play")), chosen.deviation),
    ]
    heads = (say("run"), say("heading at the end"), say("position at the end"), say("greatest on the run"))
    return Table(
        "runs",
        say("End of the run"),
        heads,
        tuple(
            (
                name,
                number(degrees(error.end_heading), "°"),
                number(error.end_distance, "mm"),
                number(float(error.distance.max()), "mm"),
            )
            for name, error in rows
        ),
    )


def _events(simulation: Simulation) -> Table:
    rows = [
        (
            Cell(named(event.kind)),
            number(degrees(event.cam_angle), "°", digits=2),
            number(event.lift, "mm"),
            number(degrees(event.deflection), "°", digits=4),
        )
        for event in simulation.events
    ]
    heads = (say("event"), say("cam angle"), say("lift"), say("deflection"))
    return Table("events", say("Jumps and waits of the plain profile"), heads, tuple(rows))


def _course(simulation: Simulation) -> Table:
    assert simulation.on_course is not None
    planned, played = (run.figures() for run in simulation.on_course)
    rows = [
        (
            Cell(place_words(key)),
            Cell(place_words(where)),
            number(planned[key][1], "mm", State.BAD if planned[key][1] < 0 else State.PLAIN),
            number(room, "mm", State.BAD if room < 0 else State.PLAIN),
        )
        for key, (where, room) in played.items()
    ]
    heads = (say("on the course"), say("with play, by"), say("planned"), say("with play"))
    return Table("course", say("Room on the course"), heads, tuple(rows), words=2)


def _remedies(sheet: tuple[Remedy, ...]) -> Table:
    rows = [
        (
            Cell(generated(remedy.name)),
            Cell(generated(remedy.build)),
            number(None if remedy.cut_for is None else degrees(remedy.cut_for), "°"),
            number(remedy.worst_end, "mm"),
            number(remedy.on_way, "mm"),
        )
        for remedy in sheet
    ]
    heads = (say("remedy"), say("what to build"), say("cut for"), say("worst end"), say("worst on the way"))
    return Table("remedies", say("Remedies"), heads, tuple(rows), words=2)


def tolerance_section(run: ToleranceRun | None, reason: Text) -> Section:
    """Many cars within the tolerances; or the reason why there are none."""
    title = say("Tolerance")
    if run is None:
        return Section("tolerance", title, (reason,))
    passing = 100 * run.passed
    lead = Words(
        f"{run.samples} random cars with this cam (seed {run.seed}, {run.plan.design.tolerances.law} law): "
        f"{passing:.2f} % keep the course and its gates.",
        f"{run.samples} 辆随机小车使用此凸轮（种子 {run.seed}，{named(run.plan.design.tolerances.law).zh}分布）："
        f"{passing:.2f} % 满足赛道与赛道门要求。",
    )
    spreads: tuple[tuple[Text, Spread, str], ...] = (
        (say("position at the end"), run.end_position, "mm"),
        (say("heading at the end"), run.end_heading_deg, "°"),
    )
    ends = Table(
        "ends",
        say("Errors at the end"),
        (say("error"), say("mean"), *(f"{100 * part:g} %" for part in run.end_position.quantiles), say("greatest")),
        tuple(
            (
                Cell(name),
                number(spread.mean, unit),
                *(number(value, unit) for value in spread.quantiles.values()),
                number(spread.greatest, unit),
            )
            for name, spread, unit in spreads
        ),
    )
    return Section("tolerance", title, (lead,), (ends, _sensitivities(run)))


def _sensitivities(run: ToleranceRun) -> Table:
    rows = [
        (
            Cell(named(item.name.replace("_", " "))),
            Cell(shown_value(item.name, run.half_width(item.name))),
            Cell(shown_value(item.name, item.step)),
            number(item.distance, "mm"),
            number(degrees(item.heading), "°", digits=4),
            number(100 * item.share, "%", digits=1),
        )
        for item in run.sensitivities
    ]
    heads = (
        say("tolerance"),
        say("half width"),
        say("step"),
        say("position for a step"),
        say("heading for a step"),
        say("of the variance"),
    )
    return Table("sensitivities", say("What matters most"), heads, tuple(rows), words=3)


def cam_notes(plan: CamPlan) -> tuple[Text, ...]:
    """Sentences on the cam: its drive wheel."""
    return (generated(plan.wheel.sentence()),)
