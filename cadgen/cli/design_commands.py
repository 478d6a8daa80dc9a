"""Commands that make a design: `cadgen new`, `cadgen plan`, `cadgen card`."""

import os
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.car.planner import RESERVE, SEEDS, WITHIN_MM
from cadgen.cli import help
from cadgen.cli.options import (
    Number,
    all_option,
    design_argument,
    design_options,
    out_option,
    overrides_option,
    profile_option,
)
from cadgen.messages import Message
from cadgen.verdict import Readiness

if TYPE_CHECKING:
    from cadgen.design.schema import Design as DesignValues

_SIZES = {"car.wheelbase_mm", "car.drive_wheel_offset_mm", "car.idle_wheel_offset_mm"}


@help.command()
@click.argument("name")
@help.option(
    "--points",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Points of the path: CSV or TXT with `X Y [weight]` in mm, or a DXF with one open polyline. Each becomes a "
    "waypoint and a gate; a weight makes its gate narrower, and 0 leaves it out.",
)
@help.option("--layer", metavar="NAME", help="Layer of the polyline in a DXF that has several.")
@help.option(
    "--gate-radius-mm",
    type=Number(0, 100_000, min_open=True),
    default=50.0,
    show_default=True,
    help="Radius of the gates at the points.",
)
@help.option(
    "--field-mm",
    type=(Number(1, 1e6), Number(1, 1e6)),
    metavar="WIDTH HEIGHT",
    default=None,
    help="Size of the field, from [0, 0].",
)
@help.option(
    "--closed",
    is_flag=True,
    help="The path is a lap that is driven again and again, such as a figure 8: from its last point it goes on to the "
    "first. The polyline of a DXF is closed, too.",
)
@help.option(
    "--train",
    is_flag=True,
    help="Propose the gear train for the wheel of [car.outline], laid out in the car: see [layout].",
)
@help.option("--motion", is_flag=True, help="Begin a cam by its motion, without path and car: rises and dwells.")
@help.option(
    "--table",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Lift table of such a cam: CSV of cam angle in degrees and lift in mm.",
)
@overrides_option
@out_option(default=Path(), show_default=False, help="Folder for the file.  [default: this one]")
def new(
    name: str,
    points: Path | None,
    layer: str | None,
    gate_radius_mm: float,
    field_mm: tuple[float, float] | None,
    closed: bool,
    train: bool,
    motion: bool,
    table: Path | None,
    overrides: tuple[str, ...],
    out: Path,
) -> None:
    """Begin a design: NAME.toml, commented, with the paper's mechanism and your path; with --motion any cam.

    The dimensions of your car go in with --set, as in --set car.wheelbase_mm=180, or later in the file.

    The exit code is 1 if no car can drive the path, which the last line says; the file is written all the same.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.design.cam_model import undrivable

    design = Design.new(
        name,
        out,
        points=points,
        layer=layer,
        gate_radius_mm=gate_radius_mm,
        field_mm=field_mm,
        closed=closed,
        train=train,
        motion=motion,
        table=table,
        changes=overrides,
    )
    fault = None
    if not design.by_motion:
        _say_outline(design.complete(), overrides)
        fault = undrivable(design.complete()) if points else None
    if fault:
        show.verdict(False, Message("{file} begins the design, but {fault}", file=design.file, fault=fault))
    else:
        show.verdict(True, Message("{file} begins the design", file=design.file), f"cadgen check {design.file}")
    raise SystemExit(1 if fault else 0)


def _say_outline(design: "DesignValues", overrides: tuple[str, ...]) -> None:
    """Print that a new design has the outline of the paper's car, where sizes of another car were given."""
    from cadgen.cli.show import Output

    outline, keys = design.car.outline, [change.partition("=")[0].strip() for change in overrides]
    if outline is None or any(key.startswith("car.outline") for key in keys) or not _SIZES & set(keys):
        return
    line = Message(
        "Taken from the paper's car: car.outline, {length:g} mm long and {width:g} mm wide, with a wheel of {wheel:g} "
        "mm.",
        length=outline.length_mm,
        width=outline.width_mm,
        wheel=outline.wheel_diameter_mm,
    )
    Output().print(line)


@help.command()
@design_argument("course", metavar="COURSE")
@help.option(
    "--from",
    "improve",
    metavar="DESIGN",
    help="Design whose path is improved, instead of a plan from scratch; its start and finish stay.",
)
@help.option(
    "--within",
    "within_mm",
    type=Number(*WITHIN_MM),
    metavar="MM",
    help="How far the drive wheel's track may leave the path of --from.  [default: 25]",
)
@help.option(
    "--calm-as",
    metavar="DESIGN",
    help="Let the curvature change no faster than on the path of this design. With --from that is the default.",
)
@help.option(
    "--reserve",
    type=Number(*RESERVE),
    metavar="FACTOR",
    help="Room at gates and obstacles besides their margins, as a factor on the scatter of cars within the "
    "tolerances; 0 makes the error by play least.  [default: the one of 0, 1, 2 ... 5 with which most cars "
    "keep the course]",
)
@help.option(
    "--seeds",
    type=click.IntRange(*SEEDS),
    default=1,
    show_default=True,
    help="Number of searches, each from another path; the best one counts.",
)
@help.option(
    "--processes",
    type=click.IntRange(1, 100),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of searches that run at once; the plan does not depend on it.  [default: 2]",
)
@overrides_option
@all_option
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of sentences.")
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
    every: bool,
    as_json: bool,
    out: Path | None,
) -> None:
    """Plan the path of a course that most cars within the tolerances keep, and on which play moves them least.

    COURSE is a design with [course]: gates, posts, walls, zones and field, start and finish; it may have no path.
    The path keeps all of them and the limits of steering and cam, and is then run through every check of cadgen check.
    At gates and obstacles it has room for the scatter of cars within the tolerances, chosen by the share of 10000 cars
    that keep the course.

    The exit code is 1 if no path was found, which is said with the reason, or if a check fails.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict
    from cadgen.processes import in_processes

    if within_mm is not None and improve is None:
        raise click.UsageError(Message("--within says how far the path of --from may be left: give --from too"))
    loaded = Design.load(course, overrides, train_only=True)
    drawn = None if improve is None else Design.load(improve)
    calm = None if calm_as is None else Design.load(calm_as)
    several = seeds > 1 and processes > 1 and drawn is None
    searches = partial(in_processes, processes) if several else None
    with show.progress(not as_json) as progress:
        planned = loaded.plan(
            drawn, within_mm, calm_as=calm, reserve=reserve, seeds=seeds, map=searches, progress=progress
        )
        written = None if out is None or not planned.sound else planned.write(out, progress=progress)
    if as_json:
        show.document(planned.facts() if written is None else written.entry)
    else:
        show.plan(planned, every=every)
        if written is not None and out is not None:
            show.files(written, out)
        lost = sum(bool(each.failed) for each in planned.drawn)
        if planned.cam is None:
            fault = Message("the course cannot be driven") if planned.proven else Message("no path was found")
            verdict(False, fault, Message("change it as it is said above"))
        elif planned.cam.failed:
            verdict(planned.cam.verdict.readiness, failed(planned.cam.failed), Message("change the design"))
        elif lost:
            result = Message(
                "the course is not kept at {lost} of {count} spacings", lost=lost, count=len(planned.drawn)
            )
            verdict(Readiness.NOT_READY, result, Message("widen [settings], or narrow [course.spacing]"))
        else:
            path = command("plan", course, "--out exports", overrides=overrides)
            step = path if written is None or out is None else f"cadgen cam {out / written.files[0].name}"
            said = Message("the path keeps the course, and every check of its cam holds")
            verdict(planned.cam.verdict.readiness, said, step)
    raise SystemExit(0 if planned.passed else 1)


@help.command()
@design_options
@profile_option
@out_option(help="Folder for NAME_card.html, to print, and NAME_card.csv; without it no file is written.")
def card(design: str | None, profile: str | None, overrides: tuple[str, ...], as_json: bool, out: Path | None) -> None:
    """Find what to set on the car for each spacing of the posts that can be drawn on site.

    DESIGN has [course.spacing], the range, and [settings], what can be set: the disc along its shaft, the drive wheel
    or the ratio, the micrometer head, the start. Every setting is driven by the exact chain and held against the
    course.

    The exit code is 1 if the course is not kept at some spacing, which the card says, or if the cam is not ready.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        result = loaded.card(profile, progress=progress)
        written = None if out is None or not result.cam.sound else result.write(out, progress=progress)
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
            kept = Message("the course is kept at all {count} spacings", count=len(result.settings))
            verdict(result.verdict.readiness, kept, step)
        elif result.cam.failed:
            verdict(
                result.verdict.readiness, failed(result.cam.failed), Message("change the design as it is said above")
            )
        else:
            result_of = Message(
                "the course is not kept at {lost} of {count} spacings", lost=lost, count=len(result.settings)
            )
            verdict(result.verdict.readiness, result_of, Message("widen [settings], or plan again with cadgen plan"))
    raise SystemExit(0 if result.passed else 1)
