"""`cadgen optimize`: comparison of the methods against play, alone and combined."""

import sys
from pathlib import Path

import click

from cadgen.cli.options import design_options, out_option
from cadgen.messages import Message


@click.command()
@design_options
@out_option(help="Folder for pictures of events and tracks; without it no file is written.")
def optimize(design: str | None, overrides: tuple[str, ...], as_json: bool, out: Path | None) -> None:
    """Compare the methods against play, alone and combined, and choose the best that keeps every limit.

    Each profile is judged as it would be cut: the follower rolls on its outline, with play, over the band of return
    errors. The exit code is 1 if even the best fails a check.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        comparison = loaded.optimize(progress=progress)
        written = None if out is None else comparison.write(out, progress=progress)
    cam, remedies = comparison.cam, comparison.remedies
    if as_json:
        facts = comparison.facts()
        show.document(facts if written is None else {**written.entry, **facts, **written.entry})
    else:
        show.friction(cam)
        show_play.methods(cam)
        show_play.remedies(remedies)
        show.failures(cam)
        if written is not None and out is not None:
            show.files(written, out)
        if cam.passed:
            step = command("cam", design, "--profile", "optimized", overrides=overrides)
            verdict(True, Message("the best profile keeps every limit"), step)
        else:
            result = Message("even the best profile fails a check: {failing}", failing=failed(cam.checks))
            verdict(False, result, Message("change the design as it is said above"))
    sys.exit(0 if cam.passed else 1)
