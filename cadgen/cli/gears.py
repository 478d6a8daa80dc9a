"""`cadgen gears`: the gear train as verified files."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from cadgen.cli.options import design_options, out_option

if TYPE_CHECKING:
    from cadgen.workflow.gears import GearsPlan
    from cadgen.workflow.gears_files import GearsWritten

ORDERS = ("as-given", "reordered", "search")
RANKED_SHOWN = 8


@click.command()
@design_options
@click.option(
    "--order",
    type=click.Choice(ORDERS),
    default="as-given",
    show_default=True,
    help="Stages as the design has them; the order with the least return error; or the best teeth within "
    "\\[train.search].",
)
@out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
@click.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")
def gears(design: str | None, overrides: tuple[str, ...], order: str, as_json: bool, out: Path, force: bool) -> None:
    """Make the gear train: play and return error, an assembly and every part as STEP, STL, and a table of parts.

    Nothing is exported and the exit code is 1 if a check fails, unless --force is given.
    """
    from cadgen.cli import show
    from cadgen.design.load import load_design
    from cadgen.workflow.gears import plan_gears
    from cadgen.workflow.gears_files import write_gears

    loaded = load_design(design, overrides)
    with show.progress(not as_json) as step:
        plan = plan_gears(loaded, order, step)  # type: ignore[arg-type]
        written = write_gears(plan, out, step) if plan.passed or force else None
    if as_json:
        show.document(plan.facts() if written is None else written.entry)
    else:
        _return_errors(plan)
        _ranking(plan)
        show.figures("\nteeth in mesh, measured", plan.checks)
        if written:
            _files(written, out)
        else:
            click.echo("cadgen: a check failed, so nothing was exported (--force exports all the same)", err=True)
    sys.exit(0 if plan.passed or force else 1)


def _return_errors(plan: "GearsPlan") -> None:
    """Play and return error of every stage and of the train, as made and by the standard alone."""
    from cadgen.cli.show import Output, plain_table

    facts = plan.facts()
    table = plain_table(f"{plan.design.name}, {plan.order}, ratio {facts['ratio']}")
    table.add_column("return error")
    for column in ("a, mm", "play, µm", "as cut", "least", "mean", "greatest"):
        table.add_column(column, justify="right")
    for number, stage in enumerate(facts["stages"], 1):
        least, greatest = (stage[f"return_error_{which}_deg"] for which in ("least", "greatest"))
        table.add_row(
            f"stage {number}, {stage['teeth']}",
            f"{stage['centre_distance_mm']:g}",
            f"{stage['j_bnmin_um']:.1f}-{stage['j_bnmax_um']:.1f}",
            f"{stage['play_as_cut_um']:.1f}",
            *(f"{angle:.3f}°" for angle in (least, (least + greatest) / 2, greatest)),
        )
    rows = [("train", "return_error_deg")]
    if plan.departures:
        rows.append(("train, by the standard", "return_error_by_the_standard_deg"))
    if plan.order != "as-given":
        rows.append(("train, as given", "return_error_as_given_deg"))
    for label, key in rows:
        table.add_row(label, "", "", "", *(f"{facts[key][which]:.3f}°" for which in ("least", "mean", "greatest")))
    console = Output()
    console.print(table)
    for found in facts["overridden_tolerances"]:
        standard = found["standard_um"]
        says = "no standard covers this size" if standard is None else f"the standard says {standard:g} µm"
        console.print(f"{found['symbol']} = {found['used_um']:g} µm ({found['where']}) is the design's own; {says}.")


def _ranking(plan: "GearsPlan") -> None:
    if len(plan.ranked) < 2:
        return
    from cadgen.cli.show import Output, plain_table

    table = plain_table("\ntrains, best first")
    table.add_column("teeth, from the drive")
    for column in ("least", "mean", "greatest", "against as given"):
        table.add_column(column, justify="right")
    facts = plan.facts()
    given = facts["return_error_as_given_deg"]["greatest"]
    for train in facts["ranked"][:RANKED_SHOWN]:
        angles = [train[which] for which in ("least", "mean", "greatest")]
        table.add_row(
            train["teeth"], *(f"{angle:.3f}°" for angle in angles), f"{100 * (train['greatest'] / given - 1):+.2f} %"
        )
    Output().print(table)


def _files(written: "GearsWritten", out: Path) -> None:
    """Each file with its size and what was measured on it."""
    from cadgen.cli.show import Output, plain_table

    table = plain_table(f"\n{out}{'' if str(out).endswith('/') else '/'}")
    table.add_column("file", overflow="fold")
    table.add_column("size", justify="right")
    table.add_column("read back")
    for name, facts in written.entry["files"].items():
        if "play_error_um" in facts:
            said = f"play off by {max(map(abs, facts['play_error_um'])):.3f} µm"
        elif "flank_error_um" in facts:
            said = f"flank {facts['flank_error_um']:.5f} root {facts['root_error_um']:.4f} µm"
        elif "triangles" in facts:
            said = f"watertight, {facts['triangles']} triangles"
        else:
            said = f"{facts['rows']} rows"
        table.add_row(name, f"{facts['bytes'] / 1000:.0f} kB", said)
    Output().print(table)
