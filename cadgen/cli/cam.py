"""`cadgen cam`: the cam as verified files."""

import sys
from pathlib import Path

import click

from cadgen.cli.options import design_options, out_option, profile_option


@click.command()
@design_options
@profile_option
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@click.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
def cam(
    design: str | None, overrides: tuple[str, ...], profile: str | None, as_json: bool, out: Path, force: bool
) -> None:
    """Make a cam: STEP, STL, 3MF, DXF, G-code and points, each read back and rolled against the rod.

    Nothing is exported and the exit code is 1 if a check fails, unless --force is given.
    """
    from cadgen.cli import show, show_play
    from cadgen.design.load import load_design
    from cadgen.workflow.cam.cures import find_cures
    from cadgen.workflow.cam.files import write_cam
    from cadgen.workflow.cam.manifest import cam_facts
    from cadgen.workflow.cam.plan import plan_cam

    loaded = load_design(design, overrides)
    with show.progress(not as_json) as step:
        plan = plan_cam(loaded, profile, step)
        cures = find_cures(plan, step)
        written = write_cam(plan, out, step, cures=cures) if plan.passed or force else None
    if as_json:
        show.document(cam_facts(plan, cures) if written is None else written.entry)
    else:
        show.checks(plan, cures)
        show_play.against(plan)
        if written:
            show.files(written, out)
        else:
            click.echo("cadgen: a check failed, so nothing was exported (--force exports all the same)", err=True)
    sys.exit(0 if plan.passed or force else 1)
