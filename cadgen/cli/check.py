"""`cadgen check`: every check of a cam, without making a file."""

import sys

import click

from cadgen.cli.options import design_options, profile_option


@click.command()
@design_options
@profile_option
def check(design: str | None, overrides: tuple[str, ...], profile: str | None, as_json: bool) -> None:
    """Check a cam without making any file.

    Exit code 1 if a check fails.
    """
    from cadgen.cli import show, show_play
    from cadgen.design.load import load_design
    from cadgen.workflow.cam.cures import find_cures
    from cadgen.workflow.cam.manifest import cam_facts
    from cadgen.workflow.cam.plan import plan_cam

    loaded = load_design(design, overrides)
    with show.progress(not as_json) as step:
        plan = plan_cam(loaded, profile, step)
        cures = find_cures(plan, step)
    if as_json:
        show.document(cam_facts(plan, cures))
    else:
        show.checks(plan, cures)
        show_play.against(plan)
    sys.exit(0 if plan.passed else 1)
