"""`cadgen simulate`: the runs with play, before and after."""

from pathlib import Path

import click

from cadgen.cli.options import Number, design_options, out_option, play_profile_option
from cadgen.messages import Message


@click.command()
@design_options
@play_profile_option(meaning="Profile that is compared with the actual one.")
@click.option(
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
    that fails a check is run all the same, and the check is named.
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
                True, Message("every check holds"), Message("look at the pictures; {step} runs many cars", step=step)
            )
        else:
            verdict(False, failed(simulation.cam.checks), Message("change the design as it is said above"))
