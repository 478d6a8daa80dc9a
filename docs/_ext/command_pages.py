"""Options of every command, put into the pages `reference/commands` of both languages when the site is built.

Each is what `cadgen COMMAND --help` prints, in the order of `cadgen --help`, and by the same catalogue.
"""

import os
import re
from collections.abc import Iterator
from inspect import cleandoc

import click
from sphinx.application import Sphinx

from cadgen.cli import cli, help
from cadgen.messages import CHINESE, ENGLISH, language, shown

MARK = "<!-- options of every command -->"
_OF_ALL = ("--lang", "--help")  # every command takes them; they stand with the first


def page(chosen: str) -> str:
    """Commands under their headings, each with its lines of usage, its help and its options, in Markdown.

    Args:
        chosen: code of the language.
    """
    before, stated = language(), os.environ.get("LANGUAGE")
    help.choose_language(["--lang", chosen])
    try:
        return "\n".join(_lines())
    finally:
        help.choose_language(["--lang", before])
        os.environ.pop("LANGUAGE") if stated is None else os.environ.update(LANGUAGE=stated)


def _lines() -> Iterator[str]:
    yield from _command(cli, "cadgen")
    for heading, commands in cli.sections.items():
        yield from ("", f"### {shown(heading)}", "")
        for command in commands:
            name = f"cadgen {command.name}"
            yield from (f"#### {name}", "", *_command(command, name))


def _command(command: click.Command, name: str) -> Iterator[str]:
    with click.Context(command, info_name=name, **command.context_settings) as context:
        usage = " ".join(command.collect_usage_pieces(context))
        yield from ("```text", f"{name} {usage}", "```", "")
        yield from (_plain(shown(cleandoc(command.help or ""))), "")
        for option in command.get_params(context):
            record = option.get_help_record(context)
            if isinstance(option, click.Option) and record and (command is cli or option.opts[-1] not in _OF_ALL):
                yield from (f"`{record[0]}`", f": {_plain(' '.join(record[1].split()))}", "")


def _plain(text: str) -> str:
    """Text in which nothing outside of code means a mark of Markdown; options are code, or `--` would be a dash."""
    marked = re.sub(r"(`[^`]*`)|--[a-z][\w-]*", lambda found: found[1] or f"`{found[0]}`", text)
    parts = re.split(r"(`[^`]*`)", marked)
    return "".join(part if part.startswith("`") else re.sub(r"([\\*_<\[])", r"\\\1", part) for part in parts)


def fill(app: Sphinx, name: str, source: list[str]) -> None:
    """Put the options where a page has the mark, in the page's language."""
    if MARK in source[0]:
        source[0] = source[0].replace(MARK, page(CHINESE if name.endswith(".zh-CN") else ENGLISH))


def setup(app: Sphinx) -> dict[str, bool]:
    """Have the options put into the sources when they are read."""
    app.connect("source-read", fill)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
