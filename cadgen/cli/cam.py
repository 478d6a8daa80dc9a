"""`cadgen cam`: the cam as verified files."""

import sys
from pathlib import Path

import click

from cadgen.cli.options import design_options, formats_option, out_option, profile_option
from cadgen.messages import Message


@click.command()
@design_options
@profile_option
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@formats_option("step,stl,3mf,dxf,nc,xyz,csv")
@click.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
def cam(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str | None,
    as_json: bool,
    out: Path,
    formats: str | None,
    force: bool,
) -> None:
    """Make a cam: STEP, STL, 3MF, DXF, G-code and points, each read back and rolled against the rod.

    Nothing is exported and the exit code is 1 if a check fails, unless --force is given.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict
    from cadgen.output.files.formats import CAM

    loaded = Design.load(design, overrides)
    CAM.chosen(formats)  # before anything that takes time
    with show.progress(not as_json) as progress:
        plan = loaded.cam(profile, progress=progress)
        cures = plan.find_cures(progress)
        written = plan.write(out, formats, force=force, progress=progress) if plan.passed or force else None
    if as_json:
        show.document(plan.facts() if written is None else written.entry)
    else:
        show.checks(plan, cures)
        show_play.comparison(plan)
        if written is not None:
            show.files(written, out)
        if plan.passed:
            kept = ["--profile", profile] if profile else []
            draw = command("draw", design, "--only cam", *kept, "--out", str(out), overrides=overrides)
            verdict(
                True,
                Message("every check holds, and each file in {out} was read back", out=out),
                Message("cut it; {draw} draws it", draw=draw),
            )
        elif written is not None:
            verdict(
                False, failed(plan.checks), Message("do not cut these files; change the design as it is said above")
            )
        else:
            result = Message(
                "{failing}, so nothing was exported (--force exports all the same)", failing=failed(plan.checks)
            )
            verdict(False, result, Message("change the design as it is said above"))
    sys.exit(0 if plan.passed or force else 1)
