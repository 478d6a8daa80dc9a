"""Help and complaints of the command line in the language that is chosen.

Commands and options are those of click, whose help texts the catalogues translate as all others. Click's own words,
such as `Usage:`, come from `cadgen/locale/LANGUAGE/LC_MESSAGES/click.mo`, by the gettext of Python. That file is made
of `click.po` beside it by `python -m tests.catalogue click`; a test compares the two.
"""

import gettext
import os
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from inspect import cleandoc
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType
from typing import Any

import click

from cadgen.messages import ENGLISH, LANGUAGES, Message, choose, language, language_of, shown

_DOMAIN = "click"
# A word, or a single wide letter, with the brackets before it and the stops behind it: no line ends inside.
_PIECE = re.compile(r"\s+|[（“]*(?:[!-⹿]+|[^\s!-⹿])[，。：；、？！）”]*")


def choose_language(arguments: Sequence[str]) -> None:
    """Choose the language of `--lang`, or else of the environment, before click reads the arguments.

    Args:
        arguments: arguments of the command line.
    """
    named = []
    for before, argument in pairwise(["", *arguments]):
        option, _, value = argument.partition("=")
        if before == "--lang" or option == "--lang":
            named.append(argument if before == "--lang" else value)
    named = [value for value in named if value in LANGUAGES]
    choose(named[-1] if named else language_of(os.environ))
    gettext.bindtextdomain(_DOMAIN, str(Path(__file__).parents[1] / "locale"))
    gettext.textdomain(_DOMAIN)
    os.environ["LANGUAGE"] = ENGLISH if "--json" in arguments else language()


def width_of(text: str) -> int:
    """Columns of a terminal that a text takes; a Chinese letter takes two."""
    return sum(1 + (unicodedata.east_asian_width(sign) in "WF") for sign in text)


def folded(text: str, width: int) -> Iterator[str]:
    """Lines of a text in a language without spaces between words.

    Args:
        text: one paragraph.
        width: columns of a line.
    """
    line = ""
    for piece in _PIECE.findall(" ".join(text.split())):
        if line and width_of(line + piece) > width:
            yield line.rstrip()
            line = ""
        line += piece if line else piece.lstrip()
    yield line.rstrip()


class _Formatter(click.HelpFormatter):
    """Layout of help, with lines that suit the language."""

    def write_text(self, text: str) -> None:
        if language() == ENGLISH:
            super().write_text(text)
            return
        room, indent = self.width - self.current_indent, " " * self.current_indent
        paragraphs = ("\n".join(f"{indent}{line}" for line in folded(part, room)) for part in text.split("\n\n"))
        self.write("\n\n".join(paragraphs) + "\n")

    def write_dl(self, rows: Iterable[tuple[str, str]], col_max: int = 30, col_spacing: int = 2) -> None:
        if language() == ENGLISH:
            super().write_dl(list(rows), col_max, col_spacing)
            return
        rows = list(rows)
        left = self.current_indent + min(max(width_of(name) for name, _ in rows), col_max) + col_spacing
        for name, text in rows:
            head = f"{' ' * self.current_indent}{name}"
            if width_of(head) > left - col_spacing:
                self.write(f"{head}\n")
                head = ""
            for line in folded(text, max(self.width - left, 10)):
                self.write(f"{head}{' ' * (left - width_of(head))}{line}\n")
                head = ""


class _Context(click.Context):
    formatter_class = _Formatter


class Command(click.Command):
    """Command whose help is said in the chosen language."""

    context_class = _Context

    def format_help_text(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the docstring of the command."""
        if language() == ENGLISH or not self.help:
            super().format_help_text(ctx, formatter)
            return
        formatter.write_paragraph()
        with formatter.indentation():
            formatter.write_text(shown(cleandoc(self.help)))

    def get_short_help_str(self, limit: int = 45) -> str:
        """First sentence, for the list of commands."""
        if language() == ENGLISH:
            return super().get_short_help_str(limit)
        return shown(cleandoc(self.help or "")).partition("。")[0]

    def get_help_option(self, ctx: click.Context) -> click.Option | None:
        """Option that shows the help."""
        option = super().get_help_option(ctx)
        if option is not None:
            option.help = shown(Message("Show this message and exit."))
        return option


class Group(Command, click.Group):
    """Group of commands whose help is said in the chosen language, in sections.

    Attributes:
        sections: commands by the heading that they stand under.
    """

    sections: Mapping[Message, Sequence[click.Command]] = MappingProxyType({})

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the first sentence of each command under its heading."""
        widest = max(len(command.name or "") for commands in self.sections.values() for command in commands)
        for heading, commands in self.sections.items():
            rows = [(f"{command.name:{widest}}", command.get_short_help_str(1000)) for command in commands]
            with formatter.section(shown(heading)):
                formatter.write_dl(rows)


class Option(click.Option):
    """Option whose help is said in the chosen language."""

    def __init__(self, declared: Sequence[str], *, help: str = "", **settings: Any) -> None:
        super().__init__(declared, help=help or None, **settings)
        self.meaning = help

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        """Names and help of the option, with its default."""
        record = super().get_help_record(ctx)
        return record and (record[0], f"{shown(self.meaning)}{record[1].removeprefix(self.meaning)}")


option = partial(click.option, cls=Option)
command = partial(click.command, cls=Command)
