"""`cadgen card`: one cam for every spacing that can be drawn, and what to set for each."""

from pathlib import Path

import click

from cadgen.cli.options import design_options, out_option, profile_option
from cadgen.messages import Message


@click.command()
@design_options
@profile_option
@out_option(help="Folder for NAME_card.html, to print, and NAME_card.csv; without it no file is written.")
def card(design: str | None, profile: str | None, overrides: tuple[str, ...], as_json: bool, out: Path | None) -> None:
    """Find what to set on the car for each spacing of the posts that can be drawn on site.

    DESIGN has [course.spacing], the range, and [settings], what can be set: the disc along its shaft, the drive wheel
    or the ratio, the micrometer head, the start. Every setting is driven by the exact chain and held against the
    course.

    The exit code is 1 if the course is not kept at some spacing, which the card says, or if the cam fails a check.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        result = loaded.card(profile, progress=progress)
        written = None if out is None or not result.cam.passed else result.write(out, progress=progress)
    if as_json:
        show.document(result.facts() if written is None else written.entry)
    else:
        show.card(result)
        if written is not None and out is not None:
            show.files(written, out)
        lost = sum(not row["kept"] for row in result.settings)
        if result.passed:
            step = command("card", design, "--out exports", overrides=overrides)
            if written:
                step = Message("print the card")
            verdict(True, Message("the course is kept at all {count} spacings", count=len(result.settings)), step)
        elif not result.cam.passed:
            verdict(False, failed(result.cam.checks), Message("change the design as it is said above"))
        else:
            result_of = Message(
                "the course is not kept at {lost} of {count} spacings", lost=lost, count=len(result.settings)
            )
            verdict(False, result_of, Message("widen [settings], or plan again with cadgen plan"))
    raise SystemExit(0 if result.passed else 1)
