"""`cadgen check`: every check of a cam, without making a file."""

import sys

import click

from cadgen.cli.options import design_options, profile_option
from cadgen.messages import Message


@click.command()
@design_options
@profile_option
def check(design: str | None, overrides: tuple[str, ...], profile: str | None, as_json: bool) -> None:
    """Check a cam without making any file.

    Exit code 1 if a check fails.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        cam = loaded.cam(profile, progress=progress)
        cures = cam.find_cures(progress)
    if as_json:
        show.document(cam.facts())
    else:
        show.checks(cam, cures)
        show_play.comparison(cam)
        if cam.passed:
            kept = ["--profile", profile] if profile else []
            verdict(True, Message("every check holds"), command("cam", design, *kept, overrides=overrides))
        else:
            verdict(False, failed(cam.checks), Message("change the design as it is said above"))
    sys.exit(0 if cam.passed else 1)
