"""`cadgen tolerance`: many cars within the design's tolerances."""

import os
from pathlib import Path

import click

from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.cli.options import design_options, out_option, play_profile_option
from cadgen.messages import Message


@click.command()
@design_options
@play_profile_option(ACTUAL.code, meaning="Profile that all cars have.")
@click.option(
    "--samples", type=click.IntRange(1, 10_000_000), default=10_000, show_default=True, help="Number of cars."
)
@click.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Seed of the random numbers.")
@click.option(
    "--processes",
    type=click.IntRange(1, 256),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of processes that run at once; the results do not depend on it.  [default: 2]",
)
@click.option(
    "--budget",
    is_flag=True,
    help="Rank all deviations by their cost at the end of the run, before and after a trim.",
)
@out_option(help="Folder for a picture; without it no file is written.")
def tolerance(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str,
    samples: int,
    seed: int,
    processes: int,
    budget: bool,
    as_json: bool,
    out: Path | None,
) -> None:
    """Run random cars within the tolerances of [tolerances] and [train].

    Reports where they end, how many pass all gates, and which tolerance matters most. A seed gives the same numbers
    on any number of processes. A profile that fails a check is run all the same, and the check is named.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        run = loaded.tolerance(
            samples, seed=seed, profile=profile, budget=budget, processes=processes, progress=progress
        )
        written = None if out is None else run.write(out, progress=progress)
    if as_json:
        show.document(run.facts() if written is None else written.entry)
        return
    show_play.fleet(run)
    if run.budget is not None:
        show_play.budget(run.budget)
    show.failures(run.cam)
    if written is not None and out is not None:
        show.files(written, out)
    if run.cam.passed:
        again = command("tolerance", design, "--profile", profile, "--budget", overrides=overrides)
        make = command("cam", design, "--profile", profile, overrides=overrides)
        step = make if budget else Message("{again} says what to hold tighter", again=again)
        verdict(
            True,
            Message("every check holds, and {passed:.1f} % of the cars pass", passed=100 * run.computed.passed),
            step,
        )
    else:
        verdict(False, failed(run.cam.checks), Message("change the design as it is said above"))
