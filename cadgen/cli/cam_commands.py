"""Commands on a cam: `cadgen check`, `cadgen cam`, `cadgen optimize`."""

import shlex
import sys
from pathlib import Path

from cadgen.cli import help
from cadgen.cli.options import all_option, design_options, formats_option, out_option, profile_option
from cadgen.messages import Message


@help.command()
@design_options
@profile_option
@all_option
def check(design: str | None, overrides: tuple[str, ...], profile: str | None, every: bool, as_json: bool) -> None:
    """Say whether a cam is ready to be cut, without making any file.

    Exit code 1 if it is not ready.
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
        show.checks(cam, cures, every=every)
        if every:
            show_play.comparison(cam)
        kept = ["--profile", profile] if profile else []
        if cam.passed:
            step = command("cam", design, *kept, overrides=overrides)
            verdict(cam.verdict.readiness, show.with_assumed(Message("every check holds"), cam), step)
        else:
            step = Message("change the design as it is said above")
            if cures.whole is not None and not overrides and all(each in cam.checks for each in cam.failed):
                step = command("check", design, *kept, "--set", shlex.quote(cures.whole))
            verdict(cam.verdict.readiness, failed(cam.failed), step)
    sys.exit(0 if cam.passed else 1)


@help.command()
@design_options
@profile_option
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@formats_option("cam")
@help.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
@all_option
def cam(
    design: str | None,
    overrides: tuple[str, ...],
    profile: str | None,
    as_json: bool,
    out: Path,
    formats: str | None,
    force: bool,
    every: bool,
) -> None:
    """Make a cam: STEP, STL, 3MF, DXF, G-code and points, each read back and rolled against its follower.

    Nothing is exported if a check of the cam itself fails, unless --force is given. The exit code is 1 if the cam is
    not ready: also if it is right, and its car is not.
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
        written = plan.write(out, formats, force=force, progress=progress) if plan.sound or force else None
    if as_json:
        show.document(plan.facts() if written is None else written.entry)
    else:
        show.checks(plan, cures, every=every)
        if every:
            show_play.comparison(plan)
        if written is not None:
            show.files(written, out)
        if plan.passed:
            kept = ["--profile", profile] if profile else []
            draw = command("draw", design, "--only cam", *kept, "--out", str(out), overrides=overrides)
            result = Message("every check holds, and each file in {out} was read back", out=out)
            if any(file.path.suffix == ".nc" for file in written or ()):
                result = show.with_assumed(result, plan)
            verdict(plan.verdict.readiness, result, Message("cut it; {draw} draws it", draw=draw))
        elif written is not None:
            verdict(
                plan.verdict.readiness,
                failed(plan.failed),
                Message("do not cut these files; change the design as it is said above"),
            )
        else:
            result = Message(
                "{failing}, so nothing was exported (--force exports all the same)", failing=failed(plan.failed)
            )
            verdict(plan.verdict.readiness, result, Message("change the design as it is said above"))
    sys.exit(0 if plan.passed or force else 1)


@help.command()
@design_options
@out_option(help="Folder for pictures of events and tracks; without it no file is written.")
def optimize(design: str | None, overrides: tuple[str, ...], as_json: bool, out: Path | None) -> None:
    """Compare the methods against play, alone and combined, and choose the best that keeps every limit.

    Each profile is judged as it would be cut: the follower rolls on its outline, with play, over the band of return
    errors. The exit code is 1 if even the best fails a check.
    """
    from cadgen.api.design import Design
    from cadgen.cli import show, show_play
    from cadgen.cli.show import command, failed, verdict

    loaded = Design.load(design, overrides)
    with show.progress(not as_json) as progress:
        comparison = loaded.optimize(progress=progress)
        written = None if out is None else comparison.write(out, progress=progress)
    cam, remedies = comparison.cam, comparison.remedies
    if as_json:
        facts = comparison.facts()
        show.document(facts if written is None else {**written.entry, **facts, **written.entry})
    else:
        show.friction(cam)
        show_play.methods(cam)
        show_play.remedies(remedies)
        show.failures(cam)
        if written is not None and out is not None:
            show.files(written, out)
        if cam.passed:
            step = command("cam", design, "--profile", "optimized", overrides=overrides)
            verdict(cam.verdict.readiness, Message("the best profile keeps every limit"), step)
        else:
            result = Message("even the best profile fails a check: {failing}", failing=failed(cam.failed))
            verdict(cam.verdict.readiness, result, Message("change the design as it is said above"))
    sys.exit(0 if cam.passed else 1)
