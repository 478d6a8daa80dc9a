"""Printing of results against play: methods, remedies, runs, room on the course, many cars, error budget."""

from collections.abc import Sequence
from math import degrees
from typing import TYPE_CHECKING

from cadgen.cli.show import Output, friction, sheet
from cadgen.figures import Cell, Emphasis, Sheet, with_unit
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.api.cam import Cam
    from cadgen.api.runs import BudgetSheet, Remedy, Simulation, Spread, ToleranceRun


def comparison(cam: "Cam") -> None:
    """Print what the profile against play does, beside what the plain profile does."""
    console = Output()
    for note in cam.notes:
        console.print(note)
    comparison = cam.comparison
    if comparison is None:
        return
    chosen, before = comparison.chosen, comparison.before
    low, high = map(degrees, comparison.band.ends)
    text: str = ""  # of laps the notes say it
    if cam.car.laps is None and chosen is before:
        text = Message(
            "{profile} profile: over the band of {low:.3f} to {high:.3f}° the run ends {worst:.0f} mm off at most. ",
            profile=Message(chosen.profile.code),
            low=low,
            high=high,
            worst=chosen.band.worst_distance,
        )
    elif cam.car.laps is None:
        first = Message("the cam as measured")
        if not before.measured:
            first = Message("the {profile} profile", profile=Message(before.profile.code))
        made_for = Message("not cut for any play")
        if chosen.profile.dilated:
            made_for = Message("cut for {window}", window=chosen.cut_for)
        text = Message(
            "{profile} profile, {train}, {made_for}: with that play the run ends {end:.1f} mm and {heading:.3f}° off, "
            "over the band of {low:.3f} to {high:.3f}° {worst:.0f} mm at most; with {first} {worst_before:.0f} mm. ",
            profile=Message(chosen.profile.code),
            train=Message(chosen.train),
            made_for=made_for,
            end=chosen.error.end_distance,
            heading=abs(degrees(chosen.error.end_heading)),
            low=low,
            high=high,
            worst=chosen.band.worst_distance,
            first=first,
            worst_before=before.band.worst_distance,
        )
    console.print(joined([text, Message("cadgen optimize compares the methods.")], ""))


def methods(cam: "Cam") -> None:
    """Print every method compared, the bound, and the reasons."""
    from cadgen.api.comparison import PAPER_PERCENT

    comparison = cam.comparison
    assert comparison is not None
    low, high = map(degrees, comparison.band.ends)
    measured = comparison.band.measured
    errors, costs = list[tuple[Cell | str, ...]](), list[tuple[Cell | str, ...]]()
    several = len({evaluation.train for evaluation in comparison.evaluations}) > 1
    train = ""
    for evaluation in comparison.evaluations:
        if several and evaluation.train != train:
            train = evaluation.train
            for rows in (errors, costs):
                rows.append(_row(Emphasis.MUTED, Message(train)))
        name = Message("cam as measured")
        if not evaluation.measured:
            name = Message(evaluation.profile.code.replace("smoothed+", "smoothed, "))
        state = Emphasis.STRONG if evaluation is comparison.chosen else Emphasis.PLAIN
        first, figures, at = evaluation is comparison.before, comparison.figures(evaluation), evaluation.error.judged_at
        errors.append(
            _row(
                state,
                name,
                figures["end_heading"].text("z.3f"),
                figures[f"{at}_position"].text(".1f"),
                "" if first else figures["position_percent_off"].text(".1f"),
                figures["worst_end_heading"].text(".2f"),
                figures[f"worst_{at}_position"].text(".0f"),
                "" if first else figures["worst_position_percent_off"].text(".1f"),
            )
        )
        # What is skipped and repeated on a compensated profile is meant to be, and no error.
        cut = evaluation.profile.dilated
        costs.append(
            _row(
                state,
                name,
                evaluation.cut_for if cut else "",
                figures[f"{at}_position_without_play"].text(".0f"),
                figures["greatest_position_without_play"].text(".0f"),
                figures["lift_error"].text(".0f"),
                "" if cut else figures["deflection_sum"].text(".3f"),
                "" if cut or first else _share(comparison.sum_gain(evaluation), 2),
            )
        )
    # The bound is for a rod that slides without friction.
    bounded = comparison.task.mechanics is None
    if bounded:
        worst = comparison.bound
        ends = (
            f"{degrees(worst.heading):.2f}°",
            f"{worst.distance:.0f} mm",
            _share(comparison.worst_gain(worst.distance)),
        )
        errors.append(_row(Emphasis.MUTED, Message("bound, same peaks"), "", "", "", *ends))
    known: str = ""
    if measured is not None:
        known = Message(", measured {play:.3f}°", play=degrees(measured))
    laps: str = ""
    if cam.car.laps is not None:
        laps = Message("; positions are the greatest on the last turn of the cam")
    title = Message(
        "return error {low:.3f} to {high:.3f}°{measured}; errors at the end of the run with the play that each is cut "
        "for, against the first profile with that play, and the worst over the band{laps}",
        low=low,
        high=high,
        measured=known,
        laps=laps,
    )
    heads = (
        Message("profile"),
        Message("heading"),
        Message("position"),
        Message("off"),
        Message("worst\nheading"),
        Message("worst\nposition"),
        Message("worst\noff"),
    )
    sheet(Sheet("methods", title, heads, _filled(errors, heads)))
    title = Message(
        "what it is cut for; run without play, at its end and where it is furthest off; greatest error of the lift "
        "with play; sum of deflection errors (eq. 28, 30) at the greatest play"
    )
    heads = (
        Message("profile"),
        Message("cut for"),
        Message("end"),
        Message("furthest"),
        Message("lift"),
        Message("sum"),
        Message("off"),
    )
    sheet(Sheet("costs", title, heads, _filled(costs, heads)))
    bound = Message("The bound: no profile with the same peaks and valleys betters it, to first order.")
    paper = Message(
        "The paper's two methods together take {percent} % off its sum of deflection errors.", percent=PAPER_PERCENT
    )
    console = Output()
    for text in (*cam.notes, *comparison.reasons, *([bound] if bounded else []), paper):
        console.print(text)


def _row(state: Emphasis, *texts: str) -> tuple[Cell | str, ...]:
    return tuple(Cell(text, state=state) for text in texts)


def _filled(rows: Sequence[tuple[Cell | str, ...]], heads: Sequence[str]) -> tuple[tuple[Cell | str, ...], ...]:
    """Rows with empty cells up to the last column."""
    return tuple((*row, *[""] * (len(heads) - len(row))) for row in rows)


def _share(value: float | None, digits: int = 1) -> str:
    return "" if value is None else f"{100 * value:.{digits}f} %"


def remedies(remedies: "Sequence[Remedy]") -> None:
    """Print the error that each remedy against play leaves, and what to build for it."""
    if not remedies:
        return
    title = Message(
        "what can be done: position errors in the worst car of the bands; remedies are compared without a brake"
    )
    heads = (Message("remedy"), Message("cut for"), Message("end"), Message("on the way"))
    rows = tuple(
        (
            remedy.name,
            remedy.figures["cut_for"].text(".3f"),
            *(
                remedy.figures[code].text(".0f") or Message("none")
                for code in ("worst_end_position", "worst_position_on_run")
            ),
        )
        for remedy in remedies
    )
    sheet(Sheet("remedies", title, heads, rows))
    for remedy in remedies:
        if remedy.build:
            Output().print(Message("{remedy}: {build}.", remedy=remedy.name, build=remedy.build))


def runs(simulation: "Simulation[Cam]") -> None:
    """Print the events and the ends of the runs."""
    console = Output()
    friction(simulation.cam)
    before, chosen = simulation.computed.comparison.before, simulation.computed.comparison.chosen
    for text in simulation.notes:
        console.print(text)
    known = simulation.computed.comparison.task.mechanics
    forces: str = ""
    if known is not None:
        forces = Message(
            ", friction {friction:.3g}, drag {drag:.3g} N·mm", friction=known.nominal.friction, drag=known.nominal.drag
        )
        console.print(
            Message(
                "The run is that of the car in the middle of its bands of friction and drag; the choice goes by all."
            )
        )
    begin = Message(
        "{name}, return error {play:.3f}°{forces}",
        name=simulation.cam.origin.name,
        play=degrees(simulation.play),
        forces=forces,
    )
    if simulation.events:
        _events(simulation, Message("{begin}: events of the {profile}", begin=begin, profile=before.title))
    else:
        console.print(Message("{begin}: the {profile} neither jumps nor waits.", begin=begin, profile=before.title))
    name = Message(str(chosen.profile))
    cut = name
    if chosen.profile.dilated:
        cut = Message("{profile}, cut for {window}", profile=name, window=chosen.cut_for)
    rows = tuple(
        (name, *(figure.text("z.4f" if figure.unit == "°" else ".2f") for figure in error.figures.values()))
        for name, error in (
            (before.title if before.measured else before.profile.code, simulation.before_error),
            (cut, simulation.after_error),
            (Message("{profile}, without play", profile=name), chosen.deviation),
        )
    )
    heads = (Message("profile"), Message("heading"), Message("position"), Message("greatest on the run"))
    sheet(Sheet("runs", Message("end of the run"), heads, rows))


def _events(simulation: "Simulation[Cam]", title: str) -> None:
    """Print every event of the profile before with its deflection, and their sum."""
    rows: list[tuple[Cell | str, ...]] = [
        (
            event.kind,
            event.figures["cam_angle"].text(".2f"),
            event.figures["lift"].text(".3f"),
            event.figures["deflection"].text(".4f"),
        )
        for event in simulation.events
    ]
    total = degrees(sum(event.deflection for event in simulation.events))
    rows.append(_row(Emphasis.STRONG, Message("sum"), "", "", f"{total:.4f}°"))
    heads = (Message("event"), Message("cam angle"), Message("lift"), Message("deflection"))
    sheet(Sheet("events", title, heads, tuple(rows)), gap=False)


def course(simulation: "Simulation[Cam]") -> None:
    """Print how near the car comes to everything on the course, and how far inside each gate it passes."""
    runs = simulation.computed.on_course
    if runs is None:
        return
    planned, played = (run.figures() for run in runs)
    worst: dict[str, str] = {}  # of a gate that is passed on every lap, the lap with the least margin
    for key, (_, room) in played.items():
        gate = key.partition(", lap ")[0]
        if gate not in worst or room < played[worst[gate]][1]:
            worst[gate] = key
    rows = tuple(
        (key, f"{planned[key][1]:.1f} mm", f"{played[key][1]:.1f} mm", played[key][0]) for key in worst.values()
    )
    title = Message("room on the course: clearance of the car, and margin inside each gate")
    heads = (Message("on the course"), Message("planned"), Message("with play"), Message("with play, by"))
    sheet(Sheet("course", title, heads, rows, tail=1))


def many_cars(run: "ToleranceRun[Cam]") -> None:
    """Print the ends of the cars, how many pass, and the sensitivities."""
    from cadgen.api.runs import shown_value

    console = Output()
    result = run.computed
    friction(run.cam)
    for text in run.notes:
        console.print(text)
    title = Message(
        "{name}, {profile} profile: {cars} cars, seed {seed}, {law} law",
        name=result.cam.origin.name,
        profile=Message(str(result.cam.kind)),
        cars=result.samples,
        seed=result.seed,
        law=Message(result.law),
    )
    console.print(title, style="bold")
    if result.cam.car.laps is not None:
        console.print(
            Message(
                "Position and heading are those where the last lap ends; a lap that turns about its start is right "
                "there and off elsewhere, so go by the heading, and by the course."
            )
        )
    position, heading = result.end_position, result.end_heading_deg
    ends = (Message("mean"), position.mean), *_parts(position), (Message("greatest"), position.greatest)
    console.print(Message("position error at the end: {values}", values=_spread(ends, "mm")))
    sizes = (Message("mean of size"), heading.mean), *_parts(heading)
    console.print(Message("heading error at the end: {values}", values=_spread(sizes, "°")))
    kept = []
    if result.gate_width is not None:
        kept.append(Message("pass all {gates} gates of {width:g} mm", gates=result.gates, width=result.gate_width))
    if result.watched:
        kept.append(Message("keep the course: {parts}", parts=result.watched))
    if result.passed is not None:
        console.print(Message("{percent:.2f} % {kept}", percent=100 * result.passed, kept=joined(kept, " and ")))
    if result.watched:
        margins = joined(f"{100 * part:g} % {margin:.3g} mm" for part, margin in result.margins.items())
        console.print(Message("margin to the course that a share of the cars keeps: {margins}", margins=margins))
    rows = tuple(
        (
            Message(item.name.replace("_", " ")),
            shown_value(item.deviation, result.half_widths[item.deviation]),
            shown_value(item.deviation, item.step),
            f"{item.distance:.3f} mm",
            f"{degrees(item.heading):.4f}°",
            f"{100 * item.share:.1f} %",
        )
        for item in result.sensitivities
    )
    heads = (
        Message("tolerance"),
        Message("half width"),
        Message("step"),
        Message("position"),
        Message("heading"),
        Message("of the variance"),
    )
    title = Message("what matters most: errors at the end for a step of each tolerance")
    if result.trimmed:
        title = Message("what matters most: errors at the end for a step of each tolerance, after a trim")
    sheet(Sheet("sensitivities", title, heads, rows))


def _parts(spread: "Spread") -> tuple[tuple[str, float], ...]:
    return tuple((f"{100 * part:g} %", value) for part, value in spread.quantiles.items())


def _spread(values: Sequence[tuple[str, float]], unit: str) -> Message:
    return joined(Message("{name} {value}", name=name, value=with_unit(f"{value:.3g}", unit)) for name, value in values)


def budget(content: "BudgetSheet") -> None:
    """Print the cost of every deviation, before and after a trim, and what to hold tighter."""
    from cadgen.api.runs import shown_half_width

    rows: list[tuple[str, ...]] = []
    for cost in content.budget.costs:
        rough, mark = "~" if cost.rough else "", "" if cost.repeats else " *"
        rows.append(
            (
                Message("{name}{mark}", name=Message(cost.name.replace("_", " ")), mark=mark),
                shown_half_width(cost),
                f"{rough}{cost.before:.1f} mm",
                f"{rough}{cost.after:.1f} mm",
            )
        )
    together = Message("all, root of squares")
    rows.append((together, "", f"{content.budget.before:.1f} mm", f"{content.budget.after:.1f} mm"))
    if content.anew:
        rows.append((Message("of it anew in every run"), "", f"{content.anew:.1f} mm", f"{content.anew:.1f} mm"))
    heads = (Message("what may be off"), Message("by"), Message("before"), Message("trimmed"))
    title = Message("error budget: how far the end of the run is moved, before and after a trim")
    sheet(Sheet("budget", title, heads, tuple(rows)))
    rows = [(Message(name.replace("_", " ")), *cells) for name, cells in content.rows()]
    title = Message("the disc by processes, with what they usually hold: mm before and after a trim")
    sheet(Sheet("processes", title, (Message("what may be off"), *map(Message, content.processes)), tuple(rows)))
    for text in content.sentences():
        Output().print(text)
