"""`cadgen assembly`: the car put together, as verified files."""

import sys
from pathlib import Path

import click

from cadgen.cli import help
from cadgen.cli.options import design_options, out_option, profile_option
from cadgen.messages import Message, joined


@help.command()
@design_options
@profile_option
@help.option(
    "--cam-angle",
    "cam_angle_deg",
    type=click.FloatRange(0, 360),
    default=0.0,
    show_default=True,
    help="Cam angle at which the moving parts stand, degrees.",
)
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@help.option("--force", is_flag=True, help="Write even if a check fails, and say so in the manifest.")
def assembly(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str | None,
    as_json: bool,
    cam_angle_deg: float,
    out: Path,
    force: bool,
) -> None:
    """Put the car together: one STEP file of all parts, the list of parts, its sheet, and the steps of mounting.

    Parts have names, colours and places; moving ones stand as at --cam-angle. The list of parts is also a CSV file with
    materials and masses. The design needs [layout]. Unless --force is given, nothing is written and the exit code is 1
    if a check of the cam itself, of the gears or of the car fails.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        car = loaded.assembly(profile, progress=progress)
        written = car.write(out, cam_angle_deg, force=force, progress=progress) if car.passed or force else None
    if as_json:
        show.document(car.facts() if written is None else written.entry)
        sys.exit(0 if car.passed or force else 1)
    broken_parts = [check for check in car.failed if check not in car.own_checks]
    show.figures(Message("the car put together"), [*broken_parts, *car.own_checks])
    if written is None:
        asked = joined((command(verb, design, overrides=overrides) for verb in ("check", "gears")), " and ")
        verdict(
            False,
            Message("{broken}, so nothing was written (--force writes all the same)", broken=failed(car.failed)),
            Message("see {asked} for what to change", asked=asked),
        )
    else:
        show.drawings(written, out)
        sentence = Message("{count} parts of {mass:.0f} g in all", count=car.count, mass=car.balance().volume)
        if car.passed:
            draw = command("draw", design, "--out", str(out), overrides=overrides)
            verdict(True, sentence, Message("make the parts; {draw} draws them", draw=draw))
        else:
            verdict(False, failed(car.failed), Message("do not build this car; change the design"))
    sys.exit(0 if car.passed or force else 1)
