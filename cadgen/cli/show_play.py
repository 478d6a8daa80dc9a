"""Tables of the commands on play."""

from collections.abc import Sequence
from math import degrees
from typing import TYPE_CHECKING

from cadgen.cli.show import Output, figure_columns, friction, plain_table

if TYPE_CHECKING:
    from cadgen.api.cam import Cam
    from cadgen.api.runs import BudgetSheet, Remedy, Simulation, Spread, ToleranceRun


def comparison(cam: "Cam") -> None:
    """Print the effect of the profile against play, beside that of the profile before."""
    console = Output()
    for text in cam.notes:
        console.print(text)
    comparison = cam.comparison
    if comparison is None:
        return
    chosen, before = comparison.chosen, comparison.before
    low, high = comparison.band.ends
    over = f"over the band of {degrees(low):.3f} to {degrees(high):.3f}°"
    if cam.computed.laps is not None:
        text = ""  # the notes say it
    elif chosen is before:
        text = f"{chosen.profile.code} profile: {over} the run ends {chosen.band.worst_distance:.0f} mm off at most. "
    else:
        first = "the cam as measured" if before.measured else f"the {before.profile.code} profile"
        made_for = f"cut for {degrees(chosen.made_for):.3f}°" if chosen.profile.dilated else "not cut for any play"
        text = (
            f"{chosen.profile.code} profile, {chosen.train}, {made_for}: with that play the run ends "
            f"{chosen.error.end_distance:.1f} mm and {abs(degrees(chosen.error.end_heading)):.3f}° off, {over} "
            f"{chosen.band.worst_distance:.0f} mm at most; with {first} {before.band.worst_distance:.0f} mm. "
        )
    console.print(f"{text}cadgen optimize compares the methods.")


def methods(cam: "Cam") -> None:
    """Print every method compared, the bound, and the reasons."""
    from cadgen.api.cam import PAPER_PERCENT

    comparison = cam.comparison
    assert comparison is not None
    console = Output()
    low, high = comparison.band.ends
    measured = "" if comparison.band.measured is None else f", measured {degrees(comparison.band.measured):.3f}°"
    errors = plain_table(
        f"\nreturn error {degrees(low):.3f} to {degrees(high):.3f}°{measured}; errors at the end of the run with the "
        "play that each is cut for, against the first profile with that play, and the worst over the band"
        + ("" if cam.computed.laps is None else "; positions are the greatest on the last turn of the cam")
    )
    costs = plain_table(
        "\nwhat it is cut for; run without play, at its end and where it is furthest off; greatest error of the lift "
        "with play; sum of deflection errors (eq. 28, 30) at the greatest play"
    )
    for table, heads in (
        (errors, ("profile", "heading", "position", "off", "worst\nheading", "worst\nposition", "worst\noff")),
        (costs, ("profile", "cut for", "end", "furthest", "lift", "sum", "off")),
    ):
        figure_columns(table, heads)
    several = len({evaluation.train for evaluation in comparison.evaluations}) > 1
    train = ""
    for evaluation in comparison.evaluations:
        if several and evaluation.train != train:
            train = evaluation.train
            for table in (errors, costs):
                table.add_row(train, style="dim")
        name = "cam as measured" if evaluation.measured else evaluation.profile.code.replace("smoothed+", "smoothed, ")
        style = "bold" if evaluation is comparison.chosen else None
        first = evaluation is comparison.before
        errors.add_row(
            name,
            f"{degrees(evaluation.error.end_heading):z.3f}°",
            f"{evaluation.error.end_distance:.1f} mm",
            "" if first else _share(comparison.gain(evaluation)[1]),
            f"{degrees(evaluation.band.worst_heading):.2f}°",
            f"{evaluation.band.worst_distance:.0f} mm",
            "" if first else _share(comparison.worst_gain(evaluation.band.worst_distance)),
            style=style,
        )
        # What is skipped and repeated on a compensated profile is meant to be, and no error.
        summed = not evaluation.profile.dilated
        costs.add_row(
            name,
            f"{degrees(evaluation.made_for):.3f}°" if evaluation.profile.dilated else "",
            f"{evaluation.deviation.end_distance:.0f} mm",
            f"{evaluation.deviation.distance.max():.0f} mm",
            f"{evaluation.worst_lift_error * 1e3:.0f} µm",
            f"{degrees(evaluation.deflection_sum):.3f}°" if summed else "",
            _share(comparison.sum_gain(evaluation), 2) if summed and not first else "",
            style=style,
        )
    # The bound is for a rod that slides without friction.
    bounded = comparison.task.mechanics is None
    if bounded:
        worst = comparison.bound
        errors.add_row(
            "bound, same peaks",
            *("", "", ""),
            f"{degrees(worst.heading):.2f}°",
            f"{worst.distance:.0f} mm",
            _share(comparison.worst_gain(worst.distance)),
            style="dim",
        )
    console.print(errors)
    console.print(costs)
    for text in (
        *cam.notes,
        *comparison.reasons,
        *(["The bound: no profile with the same peaks and valleys betters it, to first order."] if bounded else []),
        f"The paper's two methods together take {PAPER_PERCENT} % off its sum of deflection errors.",
    ):
        console.print(text)


def _share(value: float | None, digits: int = 1) -> str:
    return "" if value is None else f"{100 * value:.{digits}f} %"


def remedies(sheet: "Sequence[Remedy]") -> None:
    """Print the error that each remedy against play leaves, and what to build for it."""
    if not sheet:
        return
    console = Output()
    table = plain_table(
        "\nwhat can be done: position errors in the worst car of the bands; remedies are compared without a brake"
    )
    figure_columns(table, ("remedy", "cut for", "end", "on the way"))
    for remedy in sheet:
        cut_for = "" if remedy.cut_for is None else f"{degrees(remedy.cut_for):.3f}°"
        ends = tuple("none" if off is None else f"{off:.0f} mm" for off in (remedy.worst_end, remedy.on_way))
        table.add_row(remedy.name, cut_for, *ends)
    console.print(table)
    for remedy in sheet:
        if remedy.build:
            console.print(f"{remedy.name}: {remedy.build}.")


def runs(simulation: "Simulation[Cam]") -> None:
    """Print the events and the ends of the runs."""
    console = Output()
    friction(simulation.cam)
    before, chosen = simulation.computed.comparison.before, simulation.computed.comparison.chosen
    for text in simulation.notes:
        console.print(text)
    known = simulation.computed.comparison.task.mechanics
    forces = ""
    if known is not None:
        forces = f", friction {known.nominal.friction:.3g}, drag {known.nominal.drag:.3g} N·mm"
        console.print(
            "The run is that of the car in the middle of its bands of friction and drag; the choice goes by all."
        )
    begin = f"{simulation.cam.design.name}, return error {degrees(simulation.play):.3f}°{forces}"
    if simulation.events:
        _events(simulation, f"{begin}: events of the {before.title}")
    else:
        console.print(f"{begin}: the {before.title} neither jumps nor waits.")
    table = plain_table("\nend of the run")
    figure_columns(table, ("profile", "heading", "position", "greatest on the run"))
    made_for = f", cut for {degrees(chosen.made_for):.3f}°" if chosen.profile.dilated else ""
    for name, error in (
        (before.title if before.measured else before.profile.code, simulation.before_error),
        (f"{chosen.profile}{made_for}", simulation.after_error),
        (f"{chosen.profile}, without play", chosen.deviation),
    ):
        table.add_row(
            name,
            f"{degrees(error.end_heading):z.4f}°",
            f"{error.end_distance:.2f} mm",
            f"{error.distance.max():.2f} mm",
        )
    console.print(table)


def _events(simulation: "Simulation[Cam]", title: str) -> None:
    """Print every event of the profile before with its deflection, and their sum."""
    table = plain_table(title)
    figure_columns(table, ("event", "cam angle", "lift", "deflection"))
    total = 0.0
    for event in simulation.events:
        total += event.deflection
        table.add_row(
            event.kind, f"{degrees(event.cam_angle):.2f}°", f"{event.lift:.3f} mm", f"{degrees(event.deflection):.4f}°"
        )
    table.add_row("sum", "", "", f"{degrees(total):.4f}°", style="bold")
    Output().print(table)


def course(simulation: "Simulation[Cam]") -> None:
    """Print how near the car comes to everything on the course, and how far inside each gate it passes."""
    runs = simulation.computed.on_course
    if runs is None:
        return
    planned, played = (run.figures() for run in runs)
    table = plain_table("\nroom on the course: clearance of the car, and margin inside each gate")
    table.add_column("on the course")
    for head in ("planned", "with play"):
        table.add_column(head, justify="right")
    table.add_column("with play, by")
    worst: dict[str, str] = {}  # of a gate that is passed on every lap, the lap with the least margin
    for key, (_, room) in played.items():
        gate = key.partition(", lap ")[0]
        if gate not in worst or room < played[worst[gate]][1]:
            worst[gate] = key
    for key in worst.values():
        where, room = played[key]
        table.add_row(key, f"{planned[key][1]:.1f} mm", f"{room:.1f} mm", where)
    Output().print(table)


def fleet(run: "ToleranceRun[Cam]") -> None:
    """Print the ends of the cars, how many pass, and the sensitivities."""
    from cadgen.api.runs import shown_value

    console = Output()
    result = run.computed
    friction(run.cam)
    design = result.cam.car.design
    for text in run.notes:
        console.print(text)
    console.print(
        f"{design.name}, {result.cam.kind} profile: {result.samples} cars, seed {result.seed}, "
        f"{design.tolerances.law} law",
        style="bold",
    )
    if result.cam.laps is not None:
        console.print(
            "Position and heading are those where the last lap ends; a lap that turns about its start is right there "
            "and off elsewhere, so go by the heading, and by the course."
        )
    position, heading = result.end_position, result.end_heading_deg
    for label, values, unit in (
        ("position", {"mean": position.mean, **_parts(position), "greatest": position.greatest}, " mm"),
        ("heading", {"mean of size": heading.mean, **_parts(heading)}, "°"),
    ):
        texts = ", ".join(f"{name} {value:.3g}{unit}" for name, value in values.items())
        console.print(f"{label} error at the end: {texts}")
    gates = "" if result.gate_width is None else f"pass all {result.gates} gates of {result.gate_width:g} mm"
    course = f"keep the course: {result.watched}" if result.watched else ""
    console.print(f"{100 * result.passed:.2f} % {' and '.join(filter(None, [gates, course]))}")
    if result.watched:
        kept = ", ".join(f"{100 * part:g} % {margin:.3g} mm" for part, margin in result.margins.items())
        console.print(f"margin to the course that a share of the cars keeps: {kept}")
    table = plain_table("\nwhat matters most: errors at the end for a step of each tolerance")
    figure_columns(table, ("tolerance", "half width", "step", "position", "heading", "of the variance"))
    for sensitivity in result.sensitivities:
        deviation = sensitivity.deviation
        table.add_row(
            sensitivity.name.replace("_", " "),
            shown_value(deviation, result.half_widths[deviation]),
            shown_value(deviation, sensitivity.step),
            f"{sensitivity.distance:.3f} mm",
            f"{degrees(sensitivity.heading):.4f}°",
            f"{100 * sensitivity.share:.1f} %",
        )
    console.print(table)


def _parts(spread: "Spread") -> dict[str, float]:
    return {f"{100 * part:g} %": value for part, value in spread.quantiles.items()}


def budget(sheet: "BudgetSheet") -> None:
    """Print the cost of every deviation, before and after a trim, and what to hold tighter."""
    from cadgen.api.runs import shown_half_width

    console = Output()
    table = plain_table("\nerror budget: how far the end of the run is moved, before and after a trim")
    figure_columns(table, ("what may be off", "by", "before", "trimmed"))
    for cost in sheet.budget.costs:
        rough = "~" if cost.rough else ""
        table.add_row(
            cost.name.replace("_", " ") + ("" if cost.repeats else " *"),
            shown_half_width(cost),
            f"{rough}{cost.before:.1f} mm",
            f"{rough}{cost.after:.1f} mm",
        )
    table.add_row("all, root of squares", "", f"{sheet.budget.before:.1f} mm", f"{sheet.budget.after:.1f} mm")
    console.print(table)
    table = plain_table("\nthe disc by processes, with what they usually hold: mm before and after a trim")
    table.add_column("what may be off")
    for process in sheet.processes:
        table.add_column(process, justify="right")
    for name, cells in sheet.rows():
        table.add_row(name.replace("_", " "), *cells)
    console.print(table)
    for text in sheet.sentences():
        console.print(text)
