"""Commands on a car that is framed, put together, run or measured: `cadgen frame`, `assembly`, `simulate` and more."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.car.against_play.profile_kinds import ACTUAL, OPTIMIZED
from cadgen.cli import help
from cadgen.cli.options import (
    Number,
    car_profile_option,
    columns_option,
    design_and_files,
    design_options,
    out_option,
    overrides_option,
    play_profile_option,
    profile_option,
    workshop_option,
)
from cadgen.figures import Sheet
from cadgen.messages import Message, joined
from cadgen.verdict import Readiness

if TYPE_CHECKING:
    from cadgen.api.calibration import Advice, Calibration, Predictions
    from cadgen.api.design import Design
    from cadgen.api.found_cam import ComparedCam, FoundCam
    from cadgen.api.measured_gears import MeasuredGear, MeasuredTrain
    from cadgen.progress import Progress


@help.command()
@design_options
@play_profile_option(meaning="Profile that is compared with the actual one.")
@help.option(
    "--play-deg",
    type=Number(0, 180, max_open=True),
    help="Return error of the runs, at the camshaft.  [default: that which the profile is cut for]",
)
@out_option(default=Path("exports"), show_default=True, help="Folder for tracks and pictures; it is made if need be.")
def simulate(
    design: str | None, overrides: tuple[str, ...], profile: str, play_deg: float | None, as_json: bool, out: Path
) -> None:
    """Run the car with play in its gears, on the actual profile and on one against play.

    Writes the tracks of the three wheels as CSV, and pictures of lift, tracks and errors as PNG and SVG. A profile
    that fails a check is run all the same, and the check is named. The exit code is 1 if the cam is not ready.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        simulation = loaded.simulate(profile, play_deg, progress=progress)
        written = simulation.write(out, progress=progress)
    if as_json:
        show.document(written.entry)
    else:
        show_play.runs(simulation)
        show_play.course(simulation)
        show.failures(simulation.cam)
        show.files(written, out)
        if simulation.cam.passed:
            step = command("tolerance", design, "--profile", profile, overrides=overrides)
            verdict(
                simulation.cam.verdict.readiness,
                Message("every check holds"),
                Message("look at the pictures; {step} runs many cars", step=step),
            )
        else:
            verdict(
                simulation.cam.verdict.readiness,
                failed(simulation.cam.failed),
                Message("change the design as it is said above"),
            )
    raise SystemExit(0 if simulation.cam.passed else 1)


@help.command()
@design_options
@play_profile_option(ACTUAL.code, meaning="Profile that all cars have.")
@help.option("--samples", type=click.IntRange(1, 10_000_000), default=10_000, show_default=True, help="Number of cars.")
@help.option("--seed", type=click.IntRange(0), default=1, show_default=True, help="Seed of the random numbers.")
@help.option(
    "--processes",
    type=click.IntRange(1, 256),
    default=lambda: min(2, os.cpu_count() or 1),
    help="Number of processes that run at once; the results do not depend on it.  [default: 2]",
)
@help.option(
    "--budget",
    is_flag=True,
    help="Rank all deviations by their cost at the end of the run, before and after a trim.",
)
@workshop_option
@out_option(help="Folder for a picture; without it no file is written.")
def tolerance(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str,
    samples: int,
    seed: int,
    processes: int,
    budget: bool,
    workshop: Path | None,
    as_json: bool,
    out: Path | None,
) -> None:
    """Run random cars within the tolerances of [tolerances] and [train], or cams within [lift_tolerances].

    Reports where they end, how many pass all gates, and which tolerance matters most. A seed gives the same numbers
    on any number of processes. A profile that fails a check is run all the same, and the check is named. The exit code
    is 1 if the cam is not ready.

    Of a design with [motion] it reports by how much each tolerance moves the lift, how many cams keep
    lift_tolerances.limit_um, and what a disc does that is put on wrong side up.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    if loaded.by_motion:
        if budget or out is not None or workshop is not None:
            raise click.UsageError(
                Message(
                    "{option} is for a car, and the design has [motion]: leave it out",
                    option="--budget" if budget else "--out" if out is not None else "--workshop",
                )
            )
        _lift_tolerance(loaded, samples, seed, as_json=as_json)
    with show.progress(not as_json) as progress:
        run = loaded.tolerance(
            samples,
            seed=seed,
            profile=profile,
            budget=budget,
            processes=processes,
            workshop=workshop,
            progress=progress,
        )
        written = None if out is None else run.write(out, progress=progress)
    if as_json:
        show.document(run.facts() if written is None else written.entry)
        raise SystemExit(0 if run.cam.passed else 1)
    show_play.many_cars(run)
    if run.budget is not None:
        show_play.budget(run.budget)
    show.failures(run.cam)
    if written is not None and out is not None:
        show.files(written, out)
    if run.cam.passed:
        again = command("tolerance", design, "--profile", profile, "--budget", overrides=overrides)
        make = command("cam", design, "--profile", profile, overrides=overrides)
        step = make if budget else Message("{again} says what to hold tighter", again=again)
        share = run.computed.passed
        said = Message("every check holds")
        if share is not None:
            said = Message("every check holds, and {passed:.1f} % of the cars pass", passed=100 * share)
        verdict(run.cam.verdict.readiness, said, step)
    else:
        verdict(run.cam.verdict.readiness, failed(run.cam.failed), Message("change the design as it is said above"))
    raise SystemExit(0 if run.cam.passed else 1)


@help.command()
@click.argument("arguments", metavar="[DESIGN] FILE...", nargs=-1)
@car_profile_option(
    None,
    "Profile of the cam that was measured, or was on the car; left out, the one that a file says, or actual, and no "
    "cam is cut if the data fit another one.",
)
@help.option(
    "--form-error-um",
    type=Number(0.01, 1000),
    help="Form error to expect on the disc, µm rms.  [default: 2, or 30 if a file says that the disc is printed]",
)
@help.option(
    "--each",
    is_flag=True,
    help="Judge each file alone, as if each came from another car. Prints one table; with --out, no pictures and no "
    "as-built design are written, but of three cars and more what they differ by, workshop.toml.",
)
@help.option(
    "--next",
    "ask_next",
    is_flag=True,
    help="Say also what to measure next, ranked by where the run is then expected to end on a new cam; without a FILE, "
    "what to measure first.",
)
@help.option(
    "--predict",
    "unseen",
    multiple=True,
    metavar="FILE",
    help="Predict this file, which is not used, with what is found in the others. Repeatable.",
)
@help.option(
    "--train",
    "train_alone",
    is_flag=True,
    help="Judge the gear train alone, by angles at its input and output; set where DESIGN has no more than [train].",
)
@workshop_option
@columns_option
@overrides_option
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of the report.")
@out_option(help="Folder for the report, its pictures, JSON and the as-built design; without it no file is written.")
def calibrate(
    arguments: tuple[str, ...],
    profile: str | None,
    form_error_um: float | None,
    each: bool,
    ask_next: bool,
    unseen: tuple[str, ...],
    train_alone: bool,
    workshop: Path | None,
    columns: dict[str, str],
    overrides: tuple[str, ...],
    as_json: bool,
    out: Path | None,
) -> None:
    """Trace measured data to the effects that the design lacks, or find the motion of a worn cam.

    FILE is a CSV file of measured lifts, profile, transmission, track, zones, or a track with its steering logged. Its
    columns decide which. Several files and kinds are judged together, as data of one car. DESIGN is the first argument
    if it names a packaged design or ends in .toml.

    With [motion] and motion.measured = true in DESIGN, FILE is the outline or the lift of a cam whose motion is not
    known: dwells, laws, ends of segments and wear are found, and --out writes the design of a new cam. With a motion
    that is stated, what differs is found: disc, follower, phase, bore, wrong side up.

    With [train] alone, or with --train, FILE holds angles at the input and the output of the train, with the torque or
    without: play, wind-up, run-out of each wheel and tooth mesh are found, and --out writes the corrected design. Or
    it holds pitches, profile or helix lines, spans or sizes over balls of one gear, for its class and errors.

    The exit code is 1 if not all that was measured is explained.
    """
    from cadgen.api.calibration import Calibration, Calibrations
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import verdict
    from cadgen.design.load import is_train_alone, packaged_designs, read_design
    from cadgen.output.report.terminal import write

    design, files = design_and_files(arguments, packaged_designs(), some=not ask_next)
    train_alone = train_alone or is_train_alone(*read_design(design))
    loaded = Design.load(design, overrides, train_only=train_alone)
    if train_alone or loaded.by_motion:
        if asked := next(
            (
                name
                for name, given in (
                    ("--each", each),
                    ("--next", ask_next),
                    ("--predict", unseen),
                    ("--workshop", workshop),
                )
                if given
            ),
            "",
        ):
            raise click.UsageError(
                Message("{option} is for a car, and a train is judged alone: leave it out", option=asked)
                if train_alone
                else Message("{option} is for a car, and the design has [motion]: leave it out", option=asked)
            )
        _part_alone(loaded, files, columns, train_alone=train_alone, as_json=as_json, out=out)
    if each and (ask_next or unseen):
        asked = "--next" if ask_next else "--predict"
        raise click.UsageError(
            Message("{option} is asked of one car, and --each judges files of several: give one of them", option=asked)
        )
    if unseen and not files:
        raise click.UsageError(Message("--predict needs a measured file to predict from: name at least one"))
    if not files:
        if out is not None:
            raise click.UsageError(Message("without a measured file there is nothing to write: remove --out"))
        with show.progress(not as_json) as progress:
            first = loaded.next_measurement(
                profile=profile, form_error_um=form_error_um, workshop=workshop, progress=progress
            )
        if as_json:
            show.document({"next": first.facts()})
        else:
            write(first.report, show.Output())
            verdict(True, Message("nothing is measured yet"), Message("measure as the first row says"))
        return
    result: Calibration[Design] | Calibrations[Design]
    with show.progress(not as_json) as progress:
        judge = loaded.calibrate_each if each else loaded.calibrate
        result = judge(
            files,
            profile=profile,
            form_error_um=form_error_um,
            columns=columns,
            workshop=workshop,
            progress=progress,
        )
        more = _more(result, ask_next, unseen, columns, progress) if isinstance(result, Calibration) else {}
        written = None if out is None else result.write(out, progress=progress)
    if as_json:
        show.document(result.facts() | {name: part.facts() for name, part in more.items()})
        raise SystemExit(0 if result.readiness != Readiness.NOT_READY else 1)
    write([*result.report, *(block for part in more.values() for block in part.report)], show.Output())
    if written is not None and out is not None:
        show.files(written, out)
    show.explained(result, written=written is not None, asked=ask_next)
    raise SystemExit(0 if result.readiness != Readiness.NOT_READY else 1)


def _lift_tolerance(loaded: "Design", samples: int, seed: int, *, as_json: bool) -> None:
    """Print the errors of the lift of random cams, and exit."""
    from cadgen.cli import show
    from cadgen.cli.show import failed, verdict
    from cadgen.output.report.terminal import write

    with show.progress(not as_json) as progress:
        run = loaded.lift_tolerance(samples, seed=seed, progress=progress)
    if as_json:
        show.document(run.facts())
    else:
        write(run.report, show.Output())
        ready = run.cam.verdict.readiness
        if not run.cam.passed:
            verdict(ready, failed(run.cam.failed), Message("change the design as cadgen check says"))
        elif run.passed is None:
            verdict(
                ready, Message("every check holds"), Message("lift_tolerances.limit_um counts the cams that keep it")
            )
        else:
            verdict(ready, Message("every check holds, and {passed:.1f} % of the cams pass", passed=100 * run.passed))
    raise SystemExit(0 if run.cam.passed else 1)


def _part_alone(
    loaded: "Design",
    files: tuple[str, ...],
    columns: dict[str, str],
    *,
    train_alone: bool,
    as_json: bool,
    out: Path | None,
) -> None:
    """Find the motion of a measured cam, or what differs in a cam or a train; print or write it, and exit."""
    from cadgen.cli import show
    from cadgen.output.report.terminal import write

    result: FoundCam | ComparedCam | MeasuredGear | MeasuredTrain
    with show.progress(not as_json) as progress:
        if train_alone:
            result = loaded.judge_gears(files, columns=columns, progress=progress)
        else:
            judge = loaded.find_motion if loaded.to_be_measured else loaded.compare_cam
            result = judge(files, columns=columns, progress=progress)
        written = None if out is None else result.write(out, progress=progress)
    if as_json:
        show.document(result.facts() if written is None else written.entry)
    else:
        write(result.report, show.Output())
        if written is not None and out is not None:
            show.files(written, out)
        show.found(result, written=written is not None)
    raise SystemExit(0 if result.readiness != Readiness.NOT_READY else 1)


def _more(
    result: "Calibration[Design]",
    ask_next: bool,
    unseen: tuple[str, ...],
    columns: dict[str, str],
    progress: "Progress",
) -> "dict[str, Advice | Predictions]":
    """Results asked for beside the verdict, by its name in the JSON document."""
    more: dict[str, Advice | Predictions] = {}
    if unseen:
        more["predicted"] = result.predict(unseen, columns=columns, progress=progress)
    if ask_next:
        more["next"] = result.next_measurement(progress=progress)
    return more


@help.command()
@click.argument("arguments", metavar="[DESIGN] FILE...", nargs=-1)
@car_profile_option(OPTIMIZED.code, "Profile of the cam on the car.")
@help.option(
    "--point",
    type=click.Choice(("drive-wheel", "fork", "idle-wheel", "path")),
    default="drive-wheel",
    show_default=True,
    help="Point of the car that was measured; path is the point that follows the waypoints.",
)
@help.option(
    "--settings",
    "--knobs",
    default="head,start",
    show_default=True,
    metavar="LIST",
    help="What may be set: head (the micrometer of the base radius), key (the cam on its shaft), start.",
)
@help.option(
    "--noise-mm",
    type=Number(0.1, 1000),
    default=10.0,
    show_default=True,
    help="Standard deviation of a measured coordinate.",
)
@help.option(
    "--division-um", type=Number(0.1, 1000), default=10.0, show_default=True, help="Division of the micrometer head."
)
@columns_option
@overrides_option
@help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of sentences.")
@out_option(help="Folder for the result and the table of the next trial run; without it no file is written.")
def adjust(
    arguments: tuple[str, ...],
    profile: str,
    point: str,
    settings: str,
    noise_mm: float,
    division_um: float,
    columns: dict[str, str],
    overrides: tuple[str, ...],
    as_json: bool,
    out: Path | None,
) -> None:
    """Set micrometer, key and start after trial runs, without a new cam.

    FILE is a CSV file of one or more trial runs, in the order of driving: columns run,x_mm,y_mm with a dozen points of
    the track in the frame of the waypoints, the last where the car stopped; or with cam_angle_deg, where the motor was
    stopped for each point. A comment line, which this command prints, says what was set. DESIGN is the first argument
    if it names a packaged design or ends in .toml.

    The exit code is 1 if no car within twice the tolerances explains the trial runs.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import verdict
    from cadgen.design.load import packaged_designs

    design, files = design_and_files(arguments, packaged_designs())
    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        adjustment = loaded.adjust(
            files,
            profile=profile,
            point=point,
            settings=[setting.strip() for setting in settings.split(",")],
            noise_mm=noise_mm,
            division_um=division_um,
            columns=columns,
            progress=progress,
        )
        written = None if out is None else adjustment.write(out, progress=progress)
    if as_json:
        show.document(adjustment.facts() if written is None else written.entry)
    else:
        show.settings(adjustment)
        if written is not None and out is not None:
            show.files(written, out)
        if adjustment.explained:
            verdict(
                True,
                Message("a car within the tolerances explains the trial runs"),
                Message("set this, and drive once more"),
            )
        else:
            verdict(
                False,
                Message("no car within twice the tolerances explains the trial runs"),
                Message("measure the run again"),
            )
    raise SystemExit(0 if adjustment.explained else 1)


@help.command()
@design_options
@profile_option
@help.option(
    "--cam-angle",
    "cam_angle_deg",
    type=click.FloatRange(0, 360),
    default=0.0,
    show_default=True,
    help="Cam angle at which the moving parts stand, degrees.",
)
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@help.option("--force", is_flag=True, help="Write even if a check fails, and say so in the manifest.")
def assembly(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str | None,
    as_json: bool,
    cam_angle_deg: float,
    out: Path,
    force: bool,
) -> None:
    """Put the car together: one STEP file of all parts, the list of parts, its sheet, and the steps of mounting.

    Parts have names, colours and places; moving ones stand as at --cam-angle. The list of parts is also a CSV file with
    materials and masses. The design needs [layout]. Unless --force is given, nothing is written and the exit code is 1
    if a check of the cam itself, of the gears or of the car fails.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        car = loaded.assembly(profile, progress=progress)
        written = car.write(out, cam_angle_deg, force=force, progress=progress) if car.passed or force else None
    if as_json:
        show.document(car.facts() if written is None else written.entry)
        sys.exit(0 if car.passed or force else 1)
    broken_parts = [check for check in car.failed if check not in car.own_checks]
    show.figures(Message("the car put together"), [*broken_parts, *car.own_checks])
    if written is None:
        asked = joined((command(verb, design, overrides=overrides) for verb in ("check", "gears")), " and ")
        verdict(
            False,
            Message("{broken}, so nothing was written (--force writes all the same)", broken=failed(car.failed)),
            Message("see {asked} for what to change", asked=asked),
        )
    else:
        show.drawings(written, out)
        sentence = Message("{count} parts of {mass:.0f} g in all", count=car.count, mass=car.balance().volume)
        if car.passed:
            makers = ("draw", *(["frame"] if car.computed.layout.design.frame is not None else []))
            draw = joined((command(verb, design, "--out", str(out), overrides=overrides) for verb in makers), " and ")
            verdict(True, sentence, Message("make the parts; {draw} draws them", draw=draw))
        else:
            verdict(False, failed(car.failed), Message("do not build this car; change the design"))
    sys.exit(0 if car.passed or force else 1)


@help.command()
@design_options
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@help.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
def frame(design: str | None, overrides: tuple[str, ...], as_json: bool, out: Path, force: bool) -> None:
    """Make the frame of a car: bearing plates, base, fork block and brackets, as STEP, DXF, G-code and sheets.

    With frame.make = "printed" base, plates and brackets are one part, as STEP, STL and 3MF.

    The design needs [layout], which says where the parts stand, and [frame], which may be empty. Nothing is exported
    and the exit code is 1 if a check fails, unless --force is given.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show
    from cadgen.cli.show import failed, verdict

    made = Design.load(design, overrides).frame()
    with show.progress(not as_json) as progress:
        written = made.write(out, force=force, progress=progress) if made.passed or force else None
    if as_json:
        show.document(made.facts() if written is None else written.entry)
        sys.exit(0 if made.passed or force else 1)
    show.figures(Message("the parts in the car"), made.layout_checks)
    show.figures(Message("the frame"), made.own_checks, gap=True)
    show.sentences([made.sentence])
    rows = [(code, Message(name), str(number)) for code, name, number in made.bought]
    heads = (Message("to order"), Message("part"), Message("number"))
    show.sheet(Sheet("bought", Message("bought parts"), heads, tuple(rows)))
    if written is not None:
        show.files(written, out)
    if made.passed:
        verdict(
            True,
            Message("every check holds, and each file in {out} was read back", out=out),
            Message("cut the sheets, and mount them with the base first")
            if made.computed.frame.printed is None
            else Message("print the parts, ream the seats, and push the shafts through the walls"),
        )
    elif written is not None:
        verdict(False, failed(made.checks), Message("do not cut these files; change the design as it is said above"))
    else:
        result = Message(
            "{failing}, so nothing was exported (--force exports all the same)", failing=failed(made.checks)
        )
        verdict(False, result, Message("change the design as it is said above"))
    sys.exit(0 if made.passed or force else 1)
