"""`cadgen gears`: the gear train as verified files."""

import sys
from collections.abc import Sequence
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.cli.options import design_options, formats_option, out_option
from cadgen.gears.choices import Order

if TYPE_CHECKING:
    from cadgen import GearTrain, Written
    from cadgen.gears.train import TrainPlay, WholePlay

RANKED_SHOWN = 8
REASONS_SHOWN = 3


@click.command()
@design_options
@click.option(
    "--order",
    type=click.Choice([order.value for order in Order]),
    default="as-given",
    show_default=True,
    help="Stages as the design has them; the order with the least return error; or the best teeth within "
    "[train.search].",
)
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@formats_option("step,stl,csv")
@click.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
def gears(
    design: str | None,
    overrides: tuple[str, ...],
    order: str,
    as_json: bool,
    out: Path,
    formats: str | None,
    force: bool,
) -> None:
    """Make the gear train: play and return error, an assembly and every part as STEP, STL, and a table of parts.

    Nothing is exported and the exit code is 1 if a check fails, unless --force is given.
    """
    from cadgen.api.design import Design
    from cadgen.api.gears import NotMadeError
    from cadgen.cli import show
    from cadgen.cli.verdict import command, failed, verdict
    from cadgen.output.files.formats import TRAIN

    loaded = Design.load(design, overrides, train_only=True)
    TRAIN.chosen(formats)  # before anything that takes time
    try:
        with show.progress(not as_json) as progress:
            train = loaded.gears(order, progress=progress)
            written = train.write(out, formats, force=force, progress=progress) if train.passed or force else None
    except NotMadeError as error:
        if not as_json:
            _ranking(error.ranked, error.baseline)
        raise
    if as_json:
        show.document(train.facts() if written is None else written.entry)
    else:
        _return_errors(train)
        _ranking(train.ranked, train.baseline)
        _choice(train)
        show.figures("\nteeth in mesh, measured", train.checks)
        if written is not None:
            _files(written, out, chord_is_given=loaded.values.export.mesh_chord_um is not None)
        if train.passed:
            draw = command("draw", design, "--only train", "--order", order, "--out", str(out), overrides=overrides)
            verdict(True, f"every check holds, and each file in {out} was read back", f"make them; {draw} draws them")
        elif written is not None:
            verdict(False, failed(train.checks), "do not cut these files; change [train] as it is said above")
        else:
            result = f"{failed(train.checks)}, so nothing was exported (--force exports all the same)"
            verdict(False, result, "change [train] as it is said above")
    sys.exit(0 if train.passed or force else 1)


def _return_errors(plan: "GearTrain") -> None:
    """Print play and return error of every stage and of the train, as made and by the standard alone."""
    from cadgen.cli.show import Output, plain_table

    table = plain_table(f"{plan.name}, {plan.order}, ratio {plan.play.train.ratio}: return error")
    table.add_column("stage")
    for column in ("a, mm", "play, µm", "as cut", "least", "mean", "greatest"):
        table.add_column(column, justify="right")
    for number, (stage, play) in enumerate(zip(plan.layout.train.stages, plan.play.stages, strict=True), 1):
        arc = stage.driven_pitch_radius * 1e3
        table.add_row(
            f"{number}, {stage.label}",
            f"{stage.centre_distance:g}",
            f"{play.B_min * arc:.1f}{' to ' if play.B_min < 0 else '-'}{play.B_max * arc:.1f}",
            f"{stage.free_angle() * arc:.1f}",
            *_angles(play.B_min, (play.B_min + play.B_max) / 2, play.B_max),
        )
    rows: list[tuple[str, TrainPlay | WholePlay]] = [("train", plan.play)]
    if plan.departures and plan.standard:
        rows.append(("train, by the standard", plan.standard))
    if plan.order != Order.AS_GIVEN:
        rows.append(("train, as given", plan.designed))
    if plan.baseline is not plan.designed:
        rows.append(("as given, by the standard", plan.baseline))
    for label, play_of_train in rows:
        table.add_row(label, "", "", "", *_return_error(play_of_train))
    for joint in plan.whole.loose:
        table.add_row(joint.name, "", "", "", *_angles(joint.least, (joint.least + joint.greatest) / 2, joint.greatest))
    if plan.whole.loose:
        table.add_row("train with these", "", "", "", *_return_error(plan.whole))
    console = Output()
    console.print(table)
    for departure in plan.departures:
        standard = departure.standard
        says = "no standard covers this size" if standard is None else f"the standard says {standard * 1e3:g} µm"
        console.print(
            f"{departure.symbol} = {departure.used * 1e3:g} µm ({departure.where}) is the design's own; {says}."
        )


def _return_error(play: "TrainPlay | WholePlay") -> tuple[str, ...]:
    """Least, mean and greatest return error, as texts."""
    return _angles(play.return_error_min, play.return_error_distribution().mean, play.return_error_max)


def _angles(*angles: float) -> tuple[str, ...]:
    return tuple(f"{degrees(angle):.3f}°" for angle in angles)


def _ranking(ranked: "Sequence[TrainPlay]", baseline: "TrainPlay") -> None:
    if len(ranked) < 2:
        return
    from cadgen.cli.show import Output, plain_table
    from cadgen.gears.train import teeth_of

    table = plain_table("\ntrains, best first")
    table.add_column("teeth, from the drive")
    for column in ("module", "width", "least", "greatest", "change"):
        table.add_column(column, justify="right")
    for play in ranked[:RANKED_SHOWN]:
        angles = [degrees(play.return_error_min), degrees(play.return_error_max)]
        change = 100 * (play.return_error_max / baseline.return_error_max - 1)
        pairs = play.train.stages
        modules = _each(["-" if pair.module is None else f"{pair.module:g}" for pair in pairs])
        widths = _each([_each([f"{wheel.width:g}" for wheel in pair.wheels], "/") for pair in pairs])
        table.add_row(teeth_of(play), modules, widths, *(f"{angle:.3f}°" for angle in angles), f"{change:+.2f} %")
    console = Output()
    console.print(table)
    console.print("Module and face width in mm; return error; its change against the train as given.")


def _each(values: list[str], between: str = " ") -> str:
    """Values of all stages in one text; a single value if they share it."""
    return values[0] if len(set(values)) == 1 else between.join(values)


def _choice(plan: "GearTrain") -> None:
    """Print which train is made, why not those before it, and what the searched trains lack."""
    from cadgen.cli.show import Output
    from cadgen.gears.train import teeth_of

    console = Output()
    reasons: dict[str, list[str]] = {}
    for skipped in plan.skipped:
        reasons.setdefault(skipped.reason, []).append(teeth_of(skipped.play))
    for reason, trains in list(reasons.items())[:REASONS_SHOWN]:
        others = f" and {len(trains) - 1} more" if len(trains) > 1 else ""
        console.print(f"Not made: {trains[0]}{others}: {reason}.")
    if len(reasons) > REASONS_SHOWN:
        rest = sum(len(trains) for trains in list(reasons.values())[REASONS_SHOWN:])
        console.print(f"Nor {rest} more, for other reasons; the manifest and --json name them all.")
    if plan.skipped:
        change = 100 * (plan.play.return_error_max / plan.baseline.return_error_max - 1)
        console.print(f"Made: {teeth_of(plan.play)}, {change:+.2f} % against as given.")
    for note in plan.notes:
        console.print(f"{note[0].upper()}{note[1:]}.")


def _files(written: "Written", out: Path, *, chord_is_given: bool) -> None:
    """Print each file with its size and the errors measured on it."""
    from cadgen.cli.show import Output, heading, plain_table, size, stem_of

    stem = stem_of(written.entry["files"])
    table = plain_table("")
    table.add_column("file", overflow="fold")
    table.add_column("size", justify="right")
    table.add_column("read back")
    for name, facts in written.entry["files"].items():
        if "play_error_um" in facts:
            errors = facts["play_error_um"]
            off = [abs(error) for error in errors or () if error is not None]
            reading = f"play off by {max(off):.3f} µm" if off else "no play to measure: see the checks"
        elif "flank_error_um" in facts:
            reading = f"flank {facts['flank_error_um']:.5f} root {facts['root_error_um']:.4f} µm"
        elif "rim_error_um" in facts:
            reading = f"rim {facts['rim_error_um']:.5f} µm"
        elif "triangles" in facts:
            reading = f"watertight, {facts['triangles']} triangles"
        else:
            reading = f"{facts['rows']} rows"
        table.add_row(name.removeprefix(stem), size(facts["bytes"]), reading)
    heading(out, stem)
    console = Output()
    console.print(table)
    chords = sorted({facts["chord_um"] for facts in written.entry["files"].values() if "chord_um" in facts})
    if chords and not chord_is_given:
        console.print(
            f"Chords of the STL files stay within {' to '.join(f'{c:g}' for c in {chords[0]: 0, chords[-1]: 0})} µm of "
            "the teeth: 2 µm per mm of module, 5 at most, as export.mesh_chord_um is not given."
        )
