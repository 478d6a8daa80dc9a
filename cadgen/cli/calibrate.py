"""`cadgen calibrate`: from measured files to the effects that the design lacks."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.cli.options import Number, car_profile_option, design_and_files, out_option, overrides_option
from cadgen.messages import Message, joined

if TYPE_CHECKING:
    from cadgen.api.calibration import Advice, Calibration, Predictions
    from cadgen.api.design import Design
    from cadgen.progress import Progress


@click.command()
@click.argument("arguments", metavar="[DESIGN] FILE...", nargs=-1)
@car_profile_option(ACTUAL.code, "Profile of the cam that was measured, or was on the car.")
@click.option(
    "--form-error-um",
    type=Number(0.01, 1000),
    help="Form error to expect on the disc, µm rms.  [default: 2, or 30 if a file says that the disc is printed]",
)
@click.option(
    "--each",
    is_flag=True,
    help="Judge each file alone, as if each came from another car. Prints one table; with --out, no pictures and no "
    "as-built design are written.",
)
@click.option(
    "--next",
    "ask_next",
    is_flag=True,
    help="Say also what to measure next, ranked by where the run is then expected to end on a new cam; without a FILE, "
    "what to measure first.",
)
@click.option(
    "--predict",
    "unseen",
    multiple=True,
    metavar="FILE",
    help="Predict this file, which is not used, with what is found in the others. Repeatable.",
)
@overrides_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of the report.")
@out_option(help="Folder for the report, its pictures, JSON and the as-built design; without it no file is written.")
def calibrate(
    arguments: tuple[str, ...],
    profile: str,
    form_error_um: float | None,
    each: bool,
    ask_next: bool,
    unseen: tuple[str, ...],
    overrides: tuple[str, ...],
    as_json: bool,
    out: Path | None,
) -> None:
    """Trace measured data to the effects that the design lacks.

    FILE is a CSV file of measured lifts, profile, transmission, track, zones, or a track with its steering logged. Its
    columns decide which. Several files and kinds are judged together, as data of one car. DESIGN is the first argument
    if it names a packaged design or ends in .toml.
    """
    from cadgen.api.calibration import Calibration, Calibrations
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import verdict
    from cadgen.design.load import packaged_designs
    from cadgen.output.report.terminal import write

    design, files = design_and_files(arguments, packaged_designs(), some=not ask_next)
    loaded = Design.load(design, overrides)
    if each and (ask_next or unseen):
        asked = "--next" if ask_next else "--predict"
        raise click.UsageError(f"{asked} is asked of one car, and --each judges files of several: give one of them")
    if unseen and not files:
        raise click.UsageError("--predict needs a measured file to predict from: name at least one")
    if not files:
        if out is not None:
            raise click.UsageError("without a measured file there is nothing to write: remove --out")
        with show.progress(not as_json) as progress:
            first = loaded.next_measurement(profile=profile, form_error_um=form_error_um, progress=progress)
        if as_json:
            show.document({"next": first.facts()})
        else:
            write(first.report, show.Output())
            verdict(True, Message("nothing is measured yet"), Message("measure as the first row says"))
        return
    result: Calibration[Design] | Calibrations[Design]
    with show.progress(not as_json) as progress:
        judge = loaded.calibrate_each if each else loaded.calibrate
        result = judge(files, profile=profile, form_error_um=form_error_um, progress=progress)
        more = _more(result, ask_next, unseen, progress) if isinstance(result, Calibration) else {}
        written = None if out is None else result.write(out, progress=progress)
    if as_json:
        show.document(result.facts() | {name: part.facts() for name, part in more.items()})
        return
    write([*result.report, *(block for part in more.values() for block in part.report)], show.Output())
    if written is not None and out is not None:
        show.files(written, out)
    unclear = result.unclear
    if unclear:
        kinds = joined(Message("{name} {what}", name=name, what=Message(what)) for name, what in unclear.items())
        step: str = Message("measure again, or other data")
        if not (ask_next or each):
            step = Message("the same command with --next says what to measure")
        verdict(False, Message("not all is explained ({kinds})", kinds=kinds), step)
    elif isinstance(result, Calibration) and result.effects:
        made = Message("--out writes the as-built design, for cadgen cam")
        if written:
            made = Message("cadgen cam on the as-built design")
        verdict(True, Message("what was measured is explained"), made)
    else:
        step = "" if each else Message("nothing differs from the design: drive")
        verdict(True, Message("what was measured is explained"), step)


def _more(
    result: "Calibration[Design]", ask_next: bool, unseen: tuple[str, ...], progress: "Progress"
) -> "dict[str, Advice | Predictions]":
    """Results asked for beside the verdict, by its name in the JSON document."""
    more: dict[str, Advice | Predictions] = {}
    if unseen:
        more["predicted"] = result.predict(unseen, progress=progress)
    if ask_next:
        more["next"] = result.next_measurement(progress=progress)
    return more
