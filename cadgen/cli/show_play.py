"""Tables of the commands on play."""

from collections.abc import Sequence
from math import degrees
from typing import TYPE_CHECKING

from cadgen.cli.show import Output, friction, plain_table

if TYPE_CHECKING:
    from cadgen.workflow.cam.plan import CamPlan
    from cadgen.workflow.cam.remedies import Remedy
    from cadgen.workflow.runs.budget import BudgetSheet
    from cadgen.workflow.runs.simulation import Simulation
    from cadgen.workflow.runs.tolerance import ToleranceRun


def methods(plan: "CamPlan") -> None:
    """Print every method compared, the bound, and the reasons."""
    from cadgen.workflow.cam.as_built import as_built_sentences, assumed_play
    from cadgen.workflow.cam.plan import against_of
    from cadgen.workflow.cam.play import PAPER_PERCENT

    against = against_of(plan)
    console = Output()
    low, high = against.band.ends
    measured = "" if against.band.measured is None else f", measured {degrees(against.band.measured):.3f}°"
    errors = plain_table(
        f"\nreturn error {degrees(low):.3f} to {degrees(high):.3f}°{measured}; errors at the end of the run with the "
        "play that each is cut for, against the first profile with that play, and the worst over the band"
    )
    costs = plain_table(
        "\nwhat it is cut for; run without play, at its end and where it is furthest off; greatest error of the lift "
        "with play; sum of deflection errors (eq. 28, 30) at the greatest play"
    )
    for table, heads in (
        (errors, ("profile", "heading", "position", "off", "heading", "position", "off")),
        (costs, ("profile", "cut for", "end", "furthest", "lift", "sum", "off")),
    ):
        for head in heads:
            table.add_column(head, justify="left" if head == "profile" else "right")
    several = len({one.train for one in against.judged}) > 1
    train = ""
    for one in against.judged:
        if several and one.train != train:
            train = one.train
            for table in (errors, costs):
                table.add_row(train, style="dim")
        name = "cam as measured" if one.measured else one.profile.replace("smoothed+", "smoothed, ")
        style = "bold" if one is against.chosen else None
        first = one is against.before
        errors.add_row(
            name,
            f"{degrees(one.error.end_heading):.3f}°",
            f"{one.error.end_distance:.1f} mm",
            "" if first else _share(against.gain(one)[1]),
            f"{degrees(one.band.worst_heading):.2f}°",
            f"{one.band.worst_distance:.0f} mm",
            "" if first else _share(against.worst_gain(one.band.worst_distance)),
            style=style,
        )
        # What is skipped and repeated on a compensated profile is meant to be, and no error.
        summed = one.profile in ("actual", "smoothed")
        costs.add_row(
            name,
            f"{degrees(one.made_for):.3f}°" if one.profile.endswith("compensated") else "",
            f"{one.deviation.end_distance:.0f} mm",
            f"{one.deviation.distance.max():.0f} mm",
            f"{one.worst_lift_error * 1e3:.0f} µm",
            f"{degrees(one.deflection_sum):.3f}°" if summed else "",
            _share(against.sum_gain(one), 2) if summed and not first else "",
            style=style,
        )
    # The bound is for a rod that slides without friction.
    bounded = against.task.mechanics is None
    if bounded:
        worst = against.bound
        errors.add_row(
            "bound, same peaks",
            *("", "", ""),
            f"{degrees(worst.heading):.2f}°",
            f"{worst.distance:.0f} mm",
            _share(against.worst_gain(worst.distance)),
            style="dim",
        )
    console.print(errors)
    console.print(costs)
    for text in (
        *assumed_play(plan.design),
        *as_built_sentences(plan.design, against.task.lift.blend_start),
        *against.reasons,
        *(["The bound: no profile with the same peaks and valleys betters it, to first order."] if bounded else []),
        f"The paper's two methods together take {PAPER_PERCENT} % off its sum of deflection errors.",
    ):
        console.print(text)


def _share(value: float | None, digits: int = 1) -> str:
    return "" if value is None else f"{100 * value:.{digits}f} %"


def remedies(sheet: "Sequence[Remedy]") -> None:
    """Print what each remedy against play leaves of the error, and what to build for it."""
    if not sheet:
        return
    console = Output()
    table = plain_table(
        "\nwhat can be done: position errors in the worst car of the bands; remedies are compared without a brake"
    )
    for head in ("remedy", "cut for", "end", "on the way"):
        table.add_column(head, justify="left" if head == "remedy" else "right")
    for remedy in sheet:
        cut_for = "" if remedy.cut_for is None else f"{degrees(remedy.cut_for):.3f}°"
        ends = tuple("none" if off is None else f"{off:.0f} mm" for off in (remedy.worst_end, remedy.on_way))
        table.add_row(remedy.name, cut_for, *ends)
    console.print(table)
    for remedy in sheet:
        if remedy.build:
            console.print(f"{remedy.name}: {remedy.build}.")


def runs(simulation: "Simulation") -> None:
    """Print the events and where the runs end."""
    from cadgen.workflow.cam.as_built import as_built_sentences, assumed_play
    from cadgen.workflow.cam.mechanics import joint_sentences

    console = Output()
    friction(simulation.plan)
    before, chosen = simulation.against.before, simulation.against.chosen
    design = simulation.plan.design
    for text in (
        *assumed_play(design),
        *joint_sentences(design),
        *as_built_sentences(design, float(simulation.planned.motor[-1])),
    ):
        console.print(text)
    known = simulation.against.task.mechanics
    forces = ""
    if known is not None:
        forces = f", friction {known.nominal.friction:.3g}, drag {known.nominal.drag:.3g} N·mm"
        console.print(
            "The run is that of the car in the middle of its bands of friction and drag; the choice goes by all."
        )
    table = plain_table(
        f"{simulation.plan.design.name}, return error {degrees(simulation.play):.3f}°{forces}: events of the "
        f"{before.title}"
    )
    for column in ("event", "cam angle", "lift", "deflection"):
        table.add_column(column, justify="left" if column == "event" else "right")
    total = 0.0
    for event in simulation.events:
        total += event.deflection
        table.add_row(
            event.kind, f"{degrees(event.cam_angle):.2f}°", f"{event.lift:.3f} mm", f"{degrees(event.deflection):.4f}°"
        )
    table.add_row("sum", "", "", f"{degrees(total):.4f}°", style="bold")
    console.print(table)
    table = plain_table("\nend of the run")
    for column in ("profile", "heading", "position", "greatest on the run"):
        table.add_column(column, justify="left" if column == "profile" else "right")
    for name, error in (
        (before.title if before.measured else "actual", simulation.before_error),
        (f"{chosen.profile}, cut for {degrees(chosen.made_for):.3f}°", simulation.after_error),
        (f"{chosen.profile}, without play", chosen.deviation),
    ):
        table.add_row(
            name,
            f"{degrees(error.end_heading):.4f}°",
            f"{error.end_distance:.2f} mm",
            f"{error.distance.max():.2f} mm",
        )
    console.print(table)


def fleet(run: "ToleranceRun") -> None:
    """Print where the cars end, how many pass, and what matters most."""
    from cadgen.workflow.cam.as_built import as_built_sentences, assumed_play
    from cadgen.workflow.cam.mechanics import joint_sentences

    console = Output()
    friction(run.plan)
    facts = run.facts()
    design = run.plan.design
    for text in (
        *assumed_play(design),
        *joint_sentences(design),
        *as_built_sentences(design, run.plan.lift.blend_start),
    ):
        console.print(text)
    console.print(
        f"{facts['design']}, {facts['profile']} profile: {facts['samples']} cars, seed {facts['seed']}, "
        f"{facts['law']} law",
        style="bold",
    )
    for label, key, unit in (("position", "end_position_mm", " mm"), ("heading", "end_heading_deg", "°")):
        values = ", ".join(f"{name} {value:.3g}{unit}" for name, value in facts[key].items())
        console.print(f"{label} error at the end: {values}")
    console.print(
        f"{100 * facts['yield']:.2f} % pass all {facts['gates']} gates of {facts['gate_width_mm']:g} mm",
    )
    table = plain_table("\nwhat matters most: errors at the end for a step of each tolerance")
    for column in ("tolerance", "half width", "step", "position", "heading", "of the variance"):
        table.add_column(column, justify="left" if column == "tolerance" else "right")
    for one in facts["sensitivities"]:
        unit = {"deg": "°", "1": ""}.get(one["unit"], f" {one['unit']}")
        table.add_row(
            one["tolerance"].replace("_", " "),
            f"{one['half_width']:.3g}{unit}",
            f"{one['step']:.3g}{unit}",
            f"{one['position_mm_per_step']:.3f} mm",
            f"{one['heading_deg_per_step']:.4f}°",
            f"{100 * one['share_of_variance']:.1f} %",
        )
    console.print(table)


def budget(sheet: "BudgetSheet") -> None:
    """Print what everything that may be off costs, before and after a trim, and what to hold tighter."""
    from cadgen.workflow.runs.budget import shown_half_width

    console = Output()
    table = plain_table("\nerror budget: how far the end of the run is moved, before and after a trim")
    for column in ("what may be off", "by", "before", "trimmed"):
        table.add_column(column, justify="left" if column == "what may be off" else "right")
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
