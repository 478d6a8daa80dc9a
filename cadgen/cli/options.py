"""Arguments and options that several commands share."""

from collections.abc import Callable, Collection
from math import isfinite
from pathlib import Path
from typing import Any

import click

from cadgen.car.against_play.profile_kinds import OPTIMIZED, codes, meanings

PLAY_PROFILES, PROFILES = codes(for_play=True), codes()

Command = Callable[..., Any]


overrides_option = click.option(
    "--set",
    "overrides",
    multiple=True,
    metavar="KEY=VALUE",
    help="Override a key of the design, as in --set cam.thickness_mm=3.2. Repeatable.",
)


def design_options(command: Command) -> Command:
    """Add DESIGN, --set and --json."""
    for decorate in (
        click.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of tables."),
        overrides_option,
        click.argument("design", required=False),
    ):
        command = decorate(command)
    return command


def profile_option(command: Command) -> Command:
    """Add --profile for a cam that is to be made or checked."""
    return click.option(
        "--profile",
        type=click.Choice(PROFILES),
        metavar="PROFILE",
        help=f"{meanings()}.  [default: optimized, or actual if the design has neither [train] nor [play]]",
    )(command)


def car_profile_option(default: str, meaning: str) -> Callable[[Command], Command]:
    """--profile of the cam on a car that was measured."""
    return click.option(
        "--profile",
        type=click.Choice(PROFILES),
        metavar="PROFILE",
        default=default,
        show_default=True,
        help=f"{meaning} One of {', '.join(PROFILES)}.",
    )


def play_profile_option(*more: str, meaning: str) -> Callable[[Command], Command]:
    """Add --profile for a cam that runs with play: profiles against play, and `more`."""
    profiles = (*PLAY_PROFILES, *more)
    return click.option(
        "--profile",
        type=click.Choice(profiles),
        metavar="PROFILE",
        default=OPTIMIZED.code,
        show_default=True,
        help=f"{meaning} One of {', '.join(profiles)}.",
    )


def out_option(**settings: Any) -> Callable[[Command], Command]:
    """Add --out, with its default and help."""
    return click.option("--out", type=_Folder(file_okay=False, path_type=Path), **settings)


def formats_option(endings: str) -> Callable[[Command], Command]:
    """Add --formats, for some of these endings."""
    return click.option(
        "--formats", metavar="LIST", help=f"Files to write, by their endings, such as step,stl.  [default: {endings}]"
    )


def design_and_files(
    arguments: tuple[str, ...], packaged: Collection[str], *, some: bool = True
) -> tuple[str | None, tuple[str, ...]]:
    """A design, if the first argument names one, and measured files.

    Args:
        arguments: of the command line.
        packaged: names of the packaged designs.
        some: whether there must be a file.

    Raises:
        click.UsageError: no file, or a design among them.
    """
    designs = [text for text in arguments if text in packaged or text.endswith(".toml")]
    if designs and (len(designs) > 1 or arguments[0] != designs[0]):
        raise click.UsageError(f"{designs[-1]} is a design and not measured data: name one design, before the files")
    design, files = (designs[0], arguments[1:]) if designs else (None, arguments)
    if some and not files:
        raise click.UsageError("no measured file was given: name at least one CSV file")
    return design, files


class Number(click.FloatRange):
    """Option of a finite number in a range; click alone would take NaN."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Convert to a number, with click's own message outside the range."""
        if not isfinite(number := super().convert(value, param, ctx)):
            self.fail(f"{number} is not a finite number", param, ctx)
        return number


class _Folder(click.Path):
    """Option of a folder; an empty text, as from an unset shell variable, is refused."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if value == "":
            self.fail("it is empty: name a folder, or write . for this one", param, ctx)
        return super().convert(value, param, ctx)
