"""Commands that show a design: `cadgen report`, `cadgen edit`, `cadgen draw`."""

import os
import sys
from pathlib import Path

import click

from cadgen.cli import help
from cadgen.cli.options import (
    design_and_files,
    design_argument,
    design_options,
    out_option,
    overrides_option,
    profile_option,
)
from cadgen.cli.output import tell
from cadgen.gears.choices import Order
from cadgen.messages import Message, joined, shown
from cadgen.verdict import Readiness


@help.command()
@click.argument("arguments", nargs=-1, metavar="[DESIGN] [FILE]...")
@overrides_option
@profile_option
@help.option(
    "--samples",
    type=click.IntRange(1, 10_000_000),
    default=10_000,
    show_default=True,
    help="Number of random cars within the tolerances.",
)
@help.option(
    "--processes",
    type=click.IntRange(1, 256),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of processes that run at once; the results do not depend on it.  [default: 2]",
)
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of a summary.")
@out_option(default=Path("exports"), show_default=True, help="Folder for the page; it is made if need be.")
def report(
    arguments: tuple[str, ...],
    overrides: tuple[str, ...],
    profile: str | None,
    samples: int,
    processes: int,
    as_json: bool,
    out: Path,
) -> None:
    """Show a design on one page: an HTML file that needs no network.

    The page has the model in 3D and in plan, curves over the cam angle, every check, the methods against play,
    tolerance, an inspection sheet and the parts. FILE is a CSV file of measured data, as for
    `cadgen calibrate`; with it the page shows the calibration, too. Of gears without a cam it has the gears in mesh,
    their checks and play, an inspection sheet and the parts.

    The page is written also if a check fails, with the failures on top; the exit code is then 1.
    """
    from cadgen.api.design import Design
    from cadgen.api.views import Report
    from cadgen.cli import show
    from cadgen.cli.show import failed, verdict
    from cadgen.design.load import is_train_alone, packaged_designs, read_design

    design, files = design_and_files(arguments, packaged_designs(), some=False)
    loaded = Design.load(design, overrides, train_only=is_train_alone(*read_design(design)))
    with show.progress(not as_json) as progress:
        result = Report.of(loaded, profile, data=files or None, samples=samples, processes=processes, progress=progress)
        written = result.write(out, progress=progress)
    if as_json:
        show.document(written.entry)
    else:
        show.files(written, out)
        for text in result.refused:
            tell(shown(text))
        if result.passed:
            verdict(
                result.computed.readiness,
                Message("every check holds"),
                Message("open {name} in a browser", name=out / written.files[0].name),
            )
        else:
            result_of = failed(result.failed) if result.failed else Message("a part of the design was refused")
            verdict(
                result.computed.readiness, result_of, Message("see the top of {name}", name=out / written.files[0].name)
            )
    sys.exit(0 if result.passed else 1)


@help.command()
@design_argument()
@overrides_option
@help.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    help="Port of the page on 127.0.0.1.  [default: any that is free]",
)
@help.option("--no-browser", is_flag=True, help="Print the address only, and open no browser.")
def edit(design: str | None, overrides: tuple[str, ...], port: int, no_browser: bool) -> None:
    """Edit a design on its page in the browser: drag waypoints, gates and posts, move sliders, and see the part.

    Of a cam by its motion, drag the ends of its segments in the timing diagram and choose their laws.

    The page is that of cadgen report. It is served to this computer alone, at an address with a random token. The
    actual cam follows each move, the cam of cadgen check soon after; what cannot be computed is said, and the last good
    part stays. Saving writes the design's file, where comments stay. Of a packaged design a copy is edited, which is
    saved under a name of its own in the current folder.

    Ctrl-C ends it. It needs an extra: pip install '.[edit]' in cadgen's folder.
    """
    from cadgen.api.views import Editor

    editor = Editor.open(design, overrides)
    editor.serve(
        port,
        browser=not no_browser,
        show=lambda address: click.echo(shown(Message("{address}  (Ctrl-C ends it)", address=address))),
    )
    ended = Message("ended; nothing is unsaved")
    if editor.unsaved:
        ended = Message("ended; changes that were not saved are gone")
    click.echo(shown(ended))


@help.command()
@design_options
@profile_option
@help.option(
    "--order",
    type=click.Choice([order.value for order in Order]),
    default="as-given",
    show_default=True,
    help="Which gear train, as for cadgen gears.",
)
@help.option("--only", type=click.Choice(["cam", "train"]), help="Draw one of the two.  [default: what the design has]")
@out_option(
    default=Path("exports"),
    show_default=True,
    help="Folder for the files; drawings name the cam's and the gears' files that lie there by their hashes.",
)
@help.option("--force", is_flag=True, help="Draw even if a check fails.")
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

    Beside them: the outline of the cam and of every gear as DXF for a laser or a wire, and a form for the inspection of
    the cam that cadgen calibrate reads. Unless --force is given, nothing is drawn if a check of the cam itself or of
    the gears fails, and the exit code is 1 if a part is not ready.
    """
    from cadgen.api.design import Design
    from cadgen.api.drawing import draw as drawn
    from cadgen.api.drawing import parts_of
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict
    from cadgen.design.load import is_train_alone, read_design
    from cadgen.output.drawing.sheet import scale_text

    if only is None and is_train_alone(*read_design(design)):
        only = "train"
    loaded = Design.load(design, overrides, train_only=only == "train")
    with_train = only != "cam" and (only == "train" or loaded.values.train is not None)
    with show.progress(not as_json) as progress:
        cam = None if only == "train" else loaded.cam(profile, progress=progress)
        train = loaded.gears(order, progress=progress) if with_train else None
        passed = (cam is None or cam.sound) and (train is None or train.passed)
        ready = passed and (cam is None or cam.passed)
        written = drawn(out, cam=cam, train=train, force=force, progress=progress) if passed or force else None
    if as_json:
        ruling = parts_of(cam, train).verdict
        unmade = {"passed": ruling.passed, "verdict": ruling.entry().json()}
        show.document(unmade if written is None else written.entry)
        sys.exit(0 if ready or force else 1)
    unready = False if cam is None else Readiness.NOT_READY
    own = [check for part in (cam, train) if part is not None for check in part.checks]
    broken = failed(cam.failed if passed and cam is not None else own)
    if written is None:
        asked = [verb for verb, part in (("check", cam), ("gears", train)) if part is not None]
        see = joined((command(verb, design, overrides=overrides) for verb in asked), " and ")
        verdict(
            unready,
            Message("{broken}, so nothing was drawn (--force draws all the same)", broken=broken),
            Message("see {see} for what to change", see=see),
        )
    else:
        show.drawings(written, out)
        look = Message("measure the part by the dimensions of its sheet")
        pages = [file for file in written if file.name.endswith(".pdf")]
        if full := [file.name for file in pages if file.readings[1:2] == (scale_text(1.0),)]:
            look = Message("print {pages} at 100 %, and lay each part on its sheet", pages=joined(full))
            if len(full) == len(pages):
                look = Message("print the PDF at 100 %, and lay the part on it")
        if "PDF" in written.omitted:
            look = Message("open the DXF in a CAD program")
        if ready:
            readiness = True if cam is None else cam.verdict.readiness
            verdict(readiness, Message("each dimension was read back"), look)
        else:
            verdict(unready, broken, Message("do not make these parts; change the design"))
    sys.exit(0 if ready or force else 1)
