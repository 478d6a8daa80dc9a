"""`cadgen plan`: from a course and a car to the path on which play moves the car least."""

import os
from functools import partial
from pathlib import Path

import click

from cadgen.car.planner import RESERVE, SEEDS, WITHIN_MM
from cadgen.cli.options import Number, out_option, overrides_option
from cadgen.messages import Message


@click.command()
@click.argument("course", metavar="COURSE", required=False)
@click.option(
    "--from",
    "improve",
    metavar="DESIGN",
    help="Design whose path is improved, instead of a plan from scratch; its start and finish stay.",
)
@click.option(
    "--within",
    "within_mm",
    type=Number(*WITHIN_MM),
    metavar="MM",
    help="How far the drive wheel's track may leave the path of --from.  [default: 25]",
)
@click.option(
    "--calm-as",
    metavar="DESIGN",
    help="Let the curvature change no faster than on the path of this design. With --from that is the default.",
)
@click.option(
    "--reserve",
    type=Number(*RESERVE),
    metavar="FACTOR",
    help="Room at gates and obstacles besides their margins, as a factor on the scatter of cars within the "
    "tolerances; 0 makes the error by play least.  [default: the one of 0, 1, 2 ... 5 with which most cars "
    "keep the course]",
)
@click.option(
    "--seeds",
    type=click.IntRange(*SEEDS),
    default=1,
    show_default=True,
    help="Number of searches, each from another path; the best one counts.",
)
@click.option(
    "--processes",
    type=click.IntRange(1, 100),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of searches that run at once; the plan does not depend on it.  [default: 2]",
)
@overrides_option
@click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of sentences.")
@out_option(help="Folder for NAME_planned.toml; without it no file is written.")
def plan(
    course: str | None,
    improve: str | None,
    within_mm: float | None,
    calm_as: str | None,
    reserve: float | None,
    seeds: int,
    processes: int,
    overrides: tuple[str, ...],
    as_json: bool,
    out: Path | None,
) -> None:
    """Plan the path of a course that most cars within the tolerances keep, and on which play moves them least.

    COURSE is a design with [course]: gates, posts, walls, zones and field, start and finish; it may have no path.
    The path keeps all of them and the limits of steering and cam, and is then run through every check of cadgen check.
    At gates and obstacles it has room for the scatter of cars within the tolerances, chosen by the share of 10000 cars
    that keep the course.

    The exit code is 1 if the course cannot be driven, which is said with the reason, or if a check fails.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict
    from cadgen.processes import in_processes

    if within_mm is not None and improve is None:
        raise click.UsageError("--within says how far the path of --from may be left: give --from too")
    loaded = Design.load(course, overrides, train_only=True)
    drawn = None if improve is None else Design.load(improve)
    calm = None if calm_as is None else Design.load(calm_as)
    several = seeds > 1 and processes > 1 and drawn is None
    searches = partial(in_processes, processes) if several else None
    with show.progress(not as_json) as progress:
        planned = loaded.plan(
            drawn, within_mm, calm_as=calm, reserve=reserve, seeds=seeds, map=searches, progress=progress
        )
        written = None if out is None or not planned.passed else planned.write(out, progress=progress)
    if as_json:
        show.document(planned.facts() if written is None else written.entry)
    else:
        show.plan(planned)
        if written is not None and out is not None:
            show.files(written, out)
        if planned.passed:
            path = command("plan", course, "--out exports", overrides=overrides)
            step = path if written is None or out is None else f"cadgen cam {out / written.files[0].name}"
            verdict(True, Message("the path keeps the course, and every check of its cam holds"), step)
        elif planned.cam is None:
            verdict(False, Message("the course cannot be driven"), Message("change it as it is said above"))
        else:
            verdict(False, failed(planned.cam.checks), Message("change the design"))
    raise SystemExit(0 if planned.passed else 1)
