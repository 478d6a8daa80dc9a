"""`cadgen report`: one page with model, curves and tables of a design."""

import os
import sys
from pathlib import Path

import click

from cadgen.cli.options import design_and_files, out_option, overrides_option, profile_option
from cadgen.cli.output import tell
from cadgen.messages import Message, shown


@click.command()
@click.argument("arguments", nargs=-1, metavar="[DESIGN] [FILE]...")
@overrides_option
@profile_option
@click.option(
    "--samples",
    type=click.IntRange(1, 10_000_000),
    default=10_000,
    show_default=True,
    help="Number of random cars within the tolerances.",
)
@click.option(
    "--processes",
    type=click.IntRange(1, 256),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of processes that run at once; the results do not depend on it.  [default: 2]",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of a summary.")
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
    `cadgen calibrate`; with it the page shows the calibration, too.

    The page is written also if a check fails, with the failures on top; the exit code is then 1.
    """
    from cadgen.api.design import Design
    from cadgen.api.views import Report
    from cadgen.cli import show
    from cadgen.cli.show import failed, verdict
    from cadgen.design.load import packaged_designs

    design, files = design_and_files(arguments, packaged_designs(), some=False)
    loaded = Design.load(design, overrides)
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
                True,
                Message("every check holds"),
                Message("open {name} in a browser", name=out / written.files[0].name),
            )
        else:
            result_of = failed(result.failed) if result.failed else Message("a part of the design was refused")
            verdict(False, result_of, Message("see the top of {name}", name=out / written.files[0].name))
    sys.exit(0 if result.passed else 1)
