"""Arguments and options that several commands share."""

from collections.abc import Callable, Collection
from contextlib import suppress
from math import isfinite
from pathlib import Path
from shlex import quote
from typing import Any

import click

from cadgen.car.against_play.profile_kinds import OPTIMIZED, codes, meanings
from cadgen.cli import help
from cadgen.cli.output import tell
from cadgen.errors import brief, escaped
from cadgen.messages import Message, joined, shown

PLAY_PROFILES, PROFILES = codes(for_play=True), codes()

Command = Callable[..., Any]


def _columns(_context: click.Context, _option: click.Parameter, given: tuple[str, ...]) -> dict[str, str]:
    """Columns of a kind of data -> names in the files."""
    pairs = [text.partition("=") for text in given]
    if wrong := next((text for text, pair in zip(given, pairs, strict=True) if not pair[0] or not pair[2]), None):
        raise click.UsageError(
            Message("--columns {given}: write it as NAME=HEADER, such as --columns x_mm=East", given=brief(wrong))
        )
    return {name.strip(): header.strip() for name, _, header in pairs}


overrides_option = help.option(
    "--set",
    "overrides",
    multiple=True,
    metavar="KEY=VALUE",
    help="Override a key of the design, as in --set cam.thickness_mm=3.2. Repeatable.",
)


columns_option = help.option(
    "--columns",
    "columns",
    multiple=True,
    metavar="NAME=HEADER",
    callback=_columns,
    help="Name of a column in the files, where it is not understood, as in --columns x_mm='East [m]'. Repeatable.",
)


workshop_option = help.option(
    "--workshop",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="What the cars of the workshop differ by, as calibrate --each writes it: workshop.toml.",
)


def design_argument(name: str = "design", **settings: Any) -> Callable[[Command], Command]:
    """The argument DESIGN, which may be left out."""

    def chosen(context: click.Context, _argument: click.Parameter, design: str | None) -> str | None:
        if design is None:
            _say_usual_design(context)
        return design

    made: Callable[[Command], Command] = click.argument(name, required=False, callback=chosen, **settings)
    return made


def _say_usual_design(context: click.Context) -> None:
    """Say first and last that the packaged design is taken, where the folder holds one design that could be meant."""
    from cadgen.design.load import DEFAULT_DESIGN, MOST_BYTES
    from cadgen.design.parse import parse
    from cadgen.reading import read_regular

    own = []
    for file in sorted(Path().glob("*.toml")):
        with suppress(OSError, ValueError):
            if {"path", "motion", "cam", "train", "course"} & parse(read_regular(file, MOST_BYTES).decode()).keys():
                own.append(file.name)
    if len(own) != 1:
        return
    said = Message(
        "no design was named, so this is the packaged {usual}, not {file} in this folder: for that one, write cadgen "
        "{command} {quoted}",
        usual=DEFAULT_DESIGN,
        file=escaped(own[0]),
        command=context.info_name,
        quoted=escaped(quote(own[0])),
    )
    tell(shown(said))
    context.call_on_close(lambda: tell(shown(said)))


def design_options(command: Command) -> Command:
    """Add DESIGN, --set and --json."""
    for decorate in (
        help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of tables."),
        overrides_option,
        design_argument(),
    ):
        command = decorate(command)
    return command


def profile_option(command: Command) -> Command:
    """Add --profile for a cam that is to be made or checked."""
    return help.option(
        "--profile",
        type=click.Choice(PROFILES),
        metavar="PROFILE",
        help=Message(
            "{profiles}.  [default: optimized, or actual if the design has neither [train] nor [play]]",
            profiles=meanings(),
        ),
    )(command)


def all_option(command: Command) -> Command:
    """Add --all for a command that shows the verdict on a cam."""
    return help.option(
        "--all", "every", is_flag=True, help="Show every check, by group, and what was assumed of the car."
    )(command)


def car_profile_option(default: str | None, meaning: str) -> Callable[[Command], Command]:
    """--profile of the cam on a car that was measured."""
    return help.option(
        "--profile",
        type=click.Choice(PROFILES),
        metavar="PROFILE",
        default=default,
        show_default=default is not None,
        help=Message("{meaning} One of {profiles}.", meaning=Message(meaning), profiles=joined(PROFILES)),
    )


def play_profile_option(*more: str, meaning: str) -> Callable[[Command], Command]:
    """Add --profile for a cam that runs with play: profiles against play, and `more`."""
    profiles = (*PLAY_PROFILES, *more)
    return help.option(
        "--profile",
        type=click.Choice(profiles),
        metavar="PROFILE",
        default=OPTIMIZED.code,
        show_default=True,
        help=Message("{meaning} One of {profiles}.", meaning=Message(meaning), profiles=joined(profiles)),
    )


def out_option(**settings: Any) -> Callable[[Command], Command]:
    """Add --out, with its default and help."""
    return help.option("--out", type=_Folder(file_okay=False, path_type=Path), **settings)


# Endings that are written where none is named, by the sort of part: those of `cadgen.output.files.formats`, as a test
# holds, which takes a second to load.
USUAL_FORMATS = {
    "cam": ("step", "stl", "3mf", "dxf", "nc", "xyz", "csv"),
    "gear": ("step", "stl", "3mf", "dxf"),
    "train": ("step", "stl", "csv"),
}


def formats_option(part: str) -> Callable[[Command], Command]:
    """Add --formats, with the endings that are written of a sort of part where none is named.

    Args:
        part: sort of part, a key of `USUAL_FORMATS`.
    """
    endings = ",".join(USUAL_FORMATS[part])
    return help.option(
        "--formats",
        metavar="LIST",
        help=Message("Files to write, by their endings, such as step,stl.  [default: {endings}]", endings=endings),
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
        raise click.UsageError(
            Message("{design} is a design and not measured data: name one design, before the files", design=designs[-1])
        )
    design, files = (designs[0], arguments[1:]) if designs else (None, arguments)
    if design is None:
        _say_usual_design(click.get_current_context())
    if some and not files:
        raise click.UsageError(Message("no measured file was given: name at least one CSV file"))
    return design, files


def _refused(fault: Message, param: click.Parameter | None, ctx: click.Context | None) -> click.UsageError:
    """Error as click's own, whose words can be translated."""
    option = param.get_error_hint(ctx) if param else ""
    return click.UsageError(Message("Invalid value for {option}: {fault}", option=option, fault=fault), ctx)


class Number(click.FloatRange):
    """Option of a finite number in a range; click alone would take NaN."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Convert to a number, with click's own message outside the range."""
        if not isfinite(number := super().convert(value, param, ctx)):
            raise _refused(Message("{number} is not a finite number", number=number), param, ctx)
        return number


class _Folder(click.Path):
    """Option of a folder; an empty text, as from an unset shell variable, is refused."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if value == "":
            raise _refused(Message("it is empty: name a folder, or write . for this one"), param, ctx)
        return super().convert(value, param, ctx)
