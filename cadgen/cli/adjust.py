"""`cadgen adjust`: from trial runs to what a hand sets before the next."""

from pathlib import Path

import click

from cadgen.car.against_play.profile_kinds import OPTIMIZED
from cadgen.cli.options import Number, car_profile_option, design_and_files, out_option, overrides_option
from cadgen.messages import Message


@click.command()
@click.argument("arguments", metavar="[DESIGN] FILE...", nargs=-1)
@car_profile_option(OPTIMIZED.code, "Profile of the cam on the car.")
@click.option(
    "--point",
    type=click.Choice(("drive-wheel", "fork", "idle-wheel", "path")),
    default="drive-wheel",
    show_default=True,
    help="Point of the car that was measured; path is the point that follows the waypoints.",
)
@click.option(
    "--knobs",
    default="head,start",
    show_default=True,
    metavar="LIST",
    help="What may be set: head (the micrometer of the base radius), key (the cam on its shaft), start.",
)
@click.option(
    "--noise-mm",
    type=Number(0.1, 1000),
    default=10.0,
    show_default=True,
    help="Standard deviation of a measured coordinate.",
)
@click.option(
    "--division-um", type=Number(0.1, 1000), default=10.0, show_default=True, help="Division of the micrometer head."
)
@overrides_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of sentences.")
@out_option(help="Folder for the result and the table of the next trial run; without it no file is written.")
def adjust(
    arguments: tuple[str, ...],
    profile: str,
    point: str,
    knobs: str,
    noise_mm: float,
    division_um: float,
    overrides: tuple[str, ...],
    as_json: bool,
    out: Path | None,
) -> None:
    """Set micrometer, key and start after trial runs, without a new cam.

    FILE is a CSV file of one or more trial runs, in the order of driving: columns run,x_mm,y_mm with a dozen points of
    the track in the frame of the waypoints, the last where the car stopped; or with cam_angle_deg, where the motor was
    stopped for each point. A comment line, which this command prints, says what was set. DESIGN is the first argument
    if it names a packaged design or ends in .toml.

    The exit code is 1 if no car within twice the tolerances explains the trial runs.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import verdict
    from cadgen.design.load import packaged_designs

    design, files = design_and_files(arguments, packaged_designs())
    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        adjustment = loaded.adjust(
            files,
            profile=profile,
            point=point,
            knobs=[knob.strip() for knob in knobs.split(",")],
            noise_mm=noise_mm,
            division_um=division_um,
            progress=progress,
        )
        written = None if out is None else adjustment.write(out, progress=progress)
    if as_json:
        show.document(adjustment.facts() if written is None else written.entry)
    else:
        show.settings(adjustment)
        if written is not None and out is not None:
            show.files(written, out)
        if adjustment.explained:
            verdict(
                True,
                Message("a car within the tolerances explains the trial runs"),
                Message("set this, and drive once more"),
            )
        else:
            verdict(
                False,
                Message("no car within twice the tolerances explains the trial runs"),
                Message("measure the run again"),
            )
    raise SystemExit(0 if adjustment.explained else 1)
