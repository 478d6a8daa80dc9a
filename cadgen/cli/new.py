"""`cadgen new`: a commented design to begin with."""

from pathlib import Path

import click

from cadgen.cli.options import Number, out_option, overrides_option
from cadgen.messages import Message


@click.command()
@click.argument("name")
@click.option(
    "--points",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Points of the path: CSV or TXT with `X Y [weight]` in mm, or a DXF with one open polyline. Each becomes a "
    "waypoint and a gate; a weight makes its gate narrower, and 0 leaves it out.",
)
@click.option("--layer", metavar="NAME", help="Layer of the polyline in a DXF that has several.")
@click.option(
    "--gate-radius-mm",
    type=Number(0, 100_000, min_open=True),
    default=50.0,
    show_default=True,
    help="Radius of the gates at the points.",
)
@click.option(
    "--field-mm",
    type=(Number(1, 1e6), Number(1, 1e6)),
    metavar="WIDTH HEIGHT",
    default=None,
    help="Size of the field, from [0, 0].",
)
@click.option(
    "--closed",
    is_flag=True,
    help="The path is a lap that is driven again and again, such as a figure 8: from its last point it goes on to the "
    "first. The polyline of a DXF is closed, too.",
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
    overrides: tuple[str, ...],
    out: Path,
) -> None:
    """Begin a design: NAME.toml, commented, with the paper's mechanism and your path.

    The dimensions of your car go in with --set, as in --set car.wheelbase_mm=180, or later in the file.
    """
    from cadgen.api.design import Design
    from cadgen.cli.show import verdict

    design = Design.new(
        name,
        out,
        points=points,
        layer=layer,
        gate_radius_mm=gate_radius_mm,
        field_mm=field_mm,
        closed=closed,
        changes=overrides,
    )
    verdict(True, Message("{file} begins the design", file=design.file), f"cadgen check {design.file}")
