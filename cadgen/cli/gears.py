"""`cadgen gears`: the gear train as verified files."""

import sys
from collections.abc import Sequence
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.cli import help
from cadgen.cli.options import design_options, formats_option, out_option
from cadgen.figures import Sheet
from cadgen.gears.choices import Order
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen import GearTrain, Written
    from cadgen.gears.train import TrainPlay

RANKED_SHOWN = 8
REASONS_SHOWN = 3


@help.command()
@design_options
@help.option(
    "--order",
    type=click.Choice([order.value for order in Order]),
    default="as-given",
    show_default=True,
    help="Stages as the design has them; the order with the least return error; or the best teeth within "
    "[train.search].",
)
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@formats_option("train")
@help.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
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
    from cadgen.cli.show import command, failed, verdict
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
        _front(train)
        _choice(train)
        show.train_figures(train.checks)
        if written is not None:
            _files(written, out, train)
        if train.passed:
            draw = command("draw", design, "--only train", "--order", order, "--out", str(out), overrides=overrides)
            verdict(
                True,
                Message("every check holds, and each file in {out} was read back", out=out),
                Message("make them; {draw} draws them", draw=draw),
            )
        elif written is not None:
            cure = Message("do not cut these files; change {sections} as it is said above", sections=_sections(train))
            verdict(False, failed(train.checks), cure)
        else:
            result = Message(
                "{failing}, so nothing was exported (--force exports all the same)", failing=failed(train.checks)
            )
            verdict(False, result, Message("change {sections} as it is said above", sections=_sections(train)))
    sys.exit(0 if train.passed or force else 1)


def _sections(train: "GearTrain") -> Message:
    """Sections whose keys the failing checks are about: the train, its place in the car, or both."""
    of_layout = set() if train.car is None else {check.code for check in train.car.checks}
    wrong = {"[layout]" if check.code in of_layout else "[train]" for check in train.checks if not check.passed}
    return joined(sorted(wrong, reverse=True), Message(" and "))


def _return_errors(plan: "GearTrain") -> None:
    """Print play and return error of every stage and of the train, and departures from the standard."""
    from cadgen.cli.show import Output, sheet

    sheet(plan.return_errors, gap=False)
    for departure in plan.departures:
        says = Message("no standard covers this size")
        if departure.standard is not None:
            says = Message("the standard says {size:g} µm", size=departure.standard * 1e3)
        Output().print(
            Message(
                "{symbol} = {used:g} µm ({where}) is the design's own; {says}.",
                symbol=departure.symbol,
                used=departure.used * 1e3,
                where=departure.where,
                says=says,
            )
        )


def _ranking(ranked: "Sequence[TrainPlay]", baseline: "TrainPlay") -> None:
    if len(ranked) < 2:
        return
    from cadgen.cli.show import Output, sheet
    from cadgen.gears.train import teeth_of

    rows = []
    for play in ranked[:RANKED_SHOWN]:
        angles = [degrees(play.return_error_min), degrees(play.return_error_max)]
        change = 100 * (play.return_error_max / baseline.return_error_max - 1)
        pairs = play.train.stages
        modules = _each(["-" if pair.module is None else f"{pair.module:g}" for pair in pairs])
        widths = _each([_each([f"{wheel.width:g}" for wheel in pair.wheels], "/") for pair in pairs])
        rows.append((teeth_of(play), modules, widths, *(f"{angle:.3f}°" for angle in angles), f"{change:+.2f} %"))
    heads = (
        Message("teeth, from the drive"),
        Message("module"),
        Message("width"),
        Message("least"),
        Message("greatest"),
        Message("change"),
    )
    sheet(Sheet("trains", Message("trains, best first"), heads, tuple(rows)))
    Output().print(Message("Module and face width in mm; return error; its change against the train as given."))


def _front(train: "GearTrain") -> None:
    """Print the trains that no other beats in both return error and size."""
    if not train.front:
        return
    from cadgen.cli.show import Output, sheet

    rows = []
    for each in train.facts()["front"]:
        efficiency = each["efficiency"]
        rows.append(
            (
                each["teeth"],
                _each([f"{module:g}" for module in each["modules_mm"]]),
                f"{each['size_mm']:g}",
                f"{each['greatest']:.3f}°",
                f"{each['loss_factors']:.4f}",
                "-" if efficiency is None else f"{100 * efficiency:.2f} %",
            )
        )
    heads = (
        Message("teeth, from the drive"),
        Message("module"),
        Message("size, mm"),
        Message("greatest"),
        Message("losses"),
        Message("efficiency"),
    )
    title = Message("trains that no other beats in return error and size")
    if train.front_with_losses:
        title = Message("trains that no other beats in return error, size and losses")
    sheet(Sheet("front", title, heads, tuple(rows)))
    Output().print(Message("Size is the sum of the centre distances, losses that of the loss factors H_v."))
    if not train.front_whole:
        Output().print(Message("The front was not searched to its end: narrow [train.search]."))


def _each(values: list[str], between: str = " ") -> str:
    """Values of all stages in one text; a single value if they share it."""
    return values[0] if len(set(values)) == 1 else between.join(values)


def _choice(plan: "GearTrain") -> None:
    """Print which train is made, why not those before it, and what the searched trains lack."""
    from cadgen.cli.show import Output, sentences
    from cadgen.gears.train import teeth_of

    console = Output()
    reasons: dict[str, list[str]] = {}
    for skipped in plan.skipped:
        reasons.setdefault(skipped.reason, []).append(teeth_of(skipped.play))
    for reason, trains in list(reasons.items())[:REASONS_SHOWN]:
        others: str = ""
        if len(trains) > 1:
            others = Message(" and {count} more", count=len(trains) - 1)
        console.print(Message("Not made: {train}{others}: {reason}.", train=trains[0], others=others, reason=reason))
    if len(reasons) > REASONS_SHOWN:
        rest = sum(len(trains) for trains in list(reasons.values())[REASONS_SHOWN:])
        console.print(
            Message("Nor {count} more, for other reasons; the manifest and --json name them all.", count=rest)
        )
    if plan.skipped:
        change = 100 * (plan.play.return_error_max / plan.baseline.return_error_max - 1)
        made = teeth_of(plan.play)
        console.print(Message("Made: {train}, {change:+.2f} % against as given.", train=made, change=change))
    sentences(plan.notes)


def _files(written: "Written", out: Path, train: "GearTrain") -> None:
    """Print each file with its size and the errors measured on it."""
    from cadgen.cli.show import Output, heading, sheet, size, stem_of

    stem = stem_of([file.name for file in written])
    rows = [(file.name.removeprefix(stem), size(file.bytes), *file.readings) for file in written]
    heading(out, stem)
    heads = (Message("file"), Message("size"), Message("read back"))
    sheet(Sheet("files", "", heads, tuple(rows), tail=1), gap=False)
    if train.mesh_chord is None and any(file.path.suffix == ".stl" for file in written):
        chords = sorted(train.chord(part.gears) * 1e3 for part in train.layout.parts)
        Output().print(
            Message(
                "Chords of the STL files stay within {chords} µm of the teeth: 2 µm per mm of module, 5 at most, as "
                "export.mesh_chord_um is not given.",
                chords=joined(dict.fromkeys(f"{chord:g}" for chord in (chords[0], chords[-1])), " to "),
            )
        )
