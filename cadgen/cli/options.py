"""Arguments and options that several commands share."""

from collections.abc import Callable
from typing import Any

import click

PROFILES = ("actual", "theoretical", "published")


def design_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """DESIGN, --set, --profile and --json."""
    for decorate in (
        click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of tables."),
        click.option(
            "--profile",
            type=click.Choice(PROFILES),
            default="actual",
            show_default=True,
            help="actual: the exact envelope of the rod; theoretical: the rod's axis; published: the paper's formula.",
        ),
        click.option(
            "--set",
            "overrides",
            multiple=True,
            metavar="KEY=VALUE",
            help="Override a key of the design, as in --set cam.thickness_mm=3.2. Repeatable.",
        ),
        click.argument("design", required=False),
    ):
        command = decorate(command)
    return command
