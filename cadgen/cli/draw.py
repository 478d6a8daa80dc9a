"""`cadgen draw`: drawings for a workshop."""

import sys
from pathlib import Path

import click

from cadgen.cli.options import design_options, out_option, profile_option
from cadgen.gears.choices import Order
from cadgen.messages import Message, joined


@click.command()
@design_options
@profile_option
@click.option(
    "--order",
    type=click.Choice([order.value for order in Order]),
    default="as-given",
    show_default=True,
    help="Which gear train, as for cadgen gears.",
)
@click.option(
    "--only", type=click.Choice(["cam", "train"]), help="Draw one of the two.  [default: what the design has]"
)
@out_option(
    default=Path("exports"),
    show_default=True,
    help="Folder for the files; drawings name the cam's and the gears' files that lie there by their hashes.",
)
@click.option("--force", is_flag=True, help="Draw even if a check fails.")
def draw(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str | None,
    as_json: bool,
    order: str,
    only: str | None,
    out: Path,
    force: bool,
) -> None:
    """Draw the cam, every part of the gear train and the plate for its axes, as PDF and DXF, each dimension read back.

    Beside them: the outline of every gear as DXF for a laser or a wire, and a form for the inspection of the cam that
    cadgen calibrate reads. Nothing is drawn and the exit code is 1 if a check fails, unless --force is given.
    """
    from cadgen.api.design import Design
    from cadgen.api.drawing import draw as drawn
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides, train_only=only == "train")
    with_train = only != "cam" and (only == "train" or loaded.values.train is not None)
    with show.progress(not as_json) as progress:
        cam = None if only == "train" else loaded.cam(profile, progress=progress)
        train = loaded.gears(order, progress=progress) if with_train else None
        passed = all(part.passed for part in (cam, train) if part is not None)
        written = drawn(out, cam=cam, train=train, force=force, progress=progress) if passed or force else None
    if as_json:
        show.document({"passed": passed} if written is None else written.entry)
        sys.exit(0 if passed or force else 1)
    broken = failed([check for part in (cam, train) if part is not None for check in part.checks])
    if written is None:
        see = joined((command(verb, design) for verb, part in (("check", cam), ("gears", train)) if part), " and ")
        verdict(
            False,
            Message("{broken}, so nothing was drawn (--force draws all the same)", broken=broken),
            Message("{see} say what to change", see=see),
        )
    else:
        show.drawings(written, out)
        if passed:
            without = "PDF" in written.entry.get("omitted", {})
            look = Message("print the PDF at 100 %, and lay the part on it")
            if without:
                look = Message("open the DXF in a CAD program")
            verdict(True, Message("each dimension was read back"), look)
        else:
            verdict(False, broken, Message("do not make these parts; change the design"))
    sys.exit(0 if passed or force else 1)
