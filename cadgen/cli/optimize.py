"""`cadgen optimize`: what the methods against play do, alone and combined."""

import sys
from pathlib import Path

import click

from cadgen.cli.options import design_options, out_option


@click.command()
@design_options
@out_option(help="Folder for pictures of events and tracks; without it no file is written.")
def optimize(design: str | None, overrides: tuple[str, ...], as_json: bool, out: Path | None) -> None:
    """Compare the methods against play, alone and combined, and choose the best that keeps every limit.

    Each profile is judged as it would be cut: rolled on its outline, with play, over the band of return errors. The
    exit code is 1 if even the best fails a check.
    """
    from cadgen.cli import show, show_play
    from cadgen.design.load import load_design
    from cadgen.optimize.profiles.optimized import OPTIMIZED
    from cadgen.workflow.cam.cures import find_cures
    from cadgen.workflow.cam.manifest import cam_facts, remedy_facts
    from cadgen.workflow.cam.plan import against_of, plan_cam
    from cadgen.workflow.cam.remedies import remedies

    loaded = load_design(design, overrides)
    written = None
    with show.progress(not as_json) as step:
        plan = plan_cam(loaded, OPTIMIZED.code, step, all_trains=True)
        cures = find_cures(plan, step)
        against = against_of(plan)
        sheet = remedies(loaded, against, step) if against.task.mechanics else ()
        if out is not None:
            from cadgen.workflow.runs.files import write_comparison

            written = write_comparison(plan, out, step, cures=cures)
    if as_json:
        facts = cam_facts(plan, cures) if written is None else written.entry
        show.document({**facts, "remedies": [remedy_facts(remedy) for remedy in sheet]} if sheet else facts)
    else:
        show.friction(plan)
        show_play.methods(plan)
        show_play.remedies(sheet)
        show.failed(plan)
        if written is not None and out is not None:
            show.files(written, out)
        if not plan.passed:
            click.echo("cadgen: even the best profile fails a check, so cadgen cam would not export it", err=True)
    sys.exit(0 if plan.passed else 1)
