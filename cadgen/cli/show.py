"""Printing of results: progress on standard error, tables or one JSON document on standard output."""

import json
import os
import shutil
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import takewhile
from math import isinf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.table import Table
from rich.text import Text

from cadgen.check import Bound
from cadgen.cli.output import hush
from cadgen.output.report.terminal import FittedConsole, FittedTable
from cadgen.progress import Progress

if TYPE_CHECKING:
    from cadgen import Written
    from cadgen.api.cam import Cam, Cures
    from cadgen.check import Check


# Columns of a terminal below which a check's place stands under its name and not beside its figures.
_NARROW = 72


class Output(FittedConsole):
    """Standard output or error."""

    def __init__(self, *, stderr: bool = False) -> None:
        super().__init__(stderr=stderr)
        if self.width < 1:  # COLUMNS=0 says that the width is not known
            self.width = shutil.get_terminal_size().columns

    def on_broken_pipe(self) -> None:
        """Say nothing more, but let the command end with its own exit code."""
        hush()


@contextmanager
def progress(enabled: bool) -> Iterator[Progress]:
    """Yield a function that shows the current step; silent unless standard error is a terminal."""
    console = Output(stderr=True)
    if not enabled or not console.is_terminal:
        yield lambda text: None
        return
    with console.status("reading the design") as status:
        yield status.update


def document(facts: Mapping[str, Any]) -> None:
    """Print one JSON document."""
    try:
        click.echo(json.dumps(dict(facts), indent=2, allow_nan=False))
    except BrokenPipeError:
        hush()


def checks(cam: "Cam", cures: "Cures") -> None:
    """Print the checks as a table, then the advice for each that failed, and the cures of lost lift."""
    for sentence in filter(None, [cam.expected, cam.wheel]):
        Output().print(sentence)
    friction(cam)
    figures(f"{cam.design.name}, {cam.profile} profile", (*cam.checks, *filter(None, [cam.edges])))
    for line in cures.sentences():
        Output().print(line)


def friction(cam: "Cam") -> None:
    """Print the effect that friction would have on the result, if it was computed without friction."""
    if cam.comparison is not None and cam.comparison.rubbing:
        Output().print(Text(cam.comparison.rubbing, "yellow"))


def failed(cam: "Cam") -> None:
    """Print the checks that fail, with their advice; nothing if all pass."""
    if cam.failed:
        figures(f"\n{cam.design.name}: the {cam.profile} profile fails its checks", cam.failed)


def figures(title: str, checks: "Sequence[Check]") -> None:
    """Print checks as a table, then the advice for each that failed."""
    console = Output()
    narrow = console.width < _NARROW
    table = plain_table(title)
    table.add_column("check", overflow="fold")
    table.add_column("value", justify="right", no_wrap=True)
    table.add_column("limit", justify="right", no_wrap=True)
    table.add_column("", no_wrap=True)
    if not narrow:
        table.add_column("where", overflow="fold")
    for check in checks:
        verdict = Text("ok", "green") if check.passed else Text("FAIL", "red")
        if isinf(check.limit):  # a figure, not a verdict
            verdict = Text("")
        bound = "<=" if check.bound == Bound.MAX else ">="
        table.add_row(
            Text.assemble(check.name, (f"\n{check.place}", "dim")) if narrow else check.name,
            f"{_number(check.value)}{check.unit if check.unit == '°' else ' ' + check.unit_shown}".rstrip(),
            f"{bound} {_number(check.limit)}",
            verdict,
            *([] if narrow else [check.place]),
        )
    console.print(table)
    # One advice may serve several checks.
    advice: dict[str, list[str]] = {}
    for check in checks:
        if not check.passed and check.advice:
            advice.setdefault(check.advice, []).append(check.name)
    for text, names in advice.items():
        console.print(Text.assemble((" and ".join(names), "red"), f": {text}."))


def files(written: "Written", out: Path) -> None:
    """Print each file with its size, its error at the follower's lift, and the end of a run with play on it.

    The common start of their names stands above the table, so that it fits a narrow terminal.
    """
    entries = written.entry["files"]
    stem = written.part if all(name.startswith(written.part) for name in entries) else ""
    table = plain_table("")
    with_lift, with_play = (
        any(key in facts for facts in entries.values()) for key in ("lift_error_um", "end_position_mm")
    )
    table.add_column("file", overflow="fold")
    heads = ["size", *(["at lift", "limit"] if with_lift else []), *(["end of run"] if with_play else [])]
    for column in heads:
        table.add_column(column, justify="right")
    for name, facts in entries.items():
        error, limit, end = (facts.get(key) for key in ("lift_error_um", "lift_limit_um", "end_position_mm"))
        cells = [size(facts["bytes"])]
        if with_lift:
            cells += ["" if error is None else f"{error:.3f} µm", "" if limit is None else f"{limit:g} µm"]
        if with_play:
            cells.append("" if end is None else f"{end:.2f} mm")
        table.add_row(name.removeprefix(stem), *cells)
    heading(out, stem)
    console = Output()
    console.print(table)
    _omitted(written)
    for warning in written.entry.get("warnings", []):
        console.print(Text.assemble(("Warning", "yellow"), f": {warning}."))


def size(count: int) -> str:
    """Size of a file of so many bytes."""
    return f"{count / 1000:.0f} kB" if count >= 1000 else f"{count / 1000:.1f} kB"


def heading(out: Path, stem: str) -> None:
    """Print the folder of files, and what their names begin with, above their table."""
    Output().print(f"\n{out / stem}{'' if stem else os.sep}", style="bold", overflow="fold")


def _omitted(written: "Written") -> None:
    for label, reason in written.entry.get("omitted", {}).items():
        Output().print(Text.assemble((f"{label} left out", "yellow"), f": {reason}."))


def plain_table(title: str) -> Table:
    """A table without rules, with a title above it."""
    return FittedTable(
        title=title or None, title_justify="left", title_style="bold", box=None, pad_edge=False, header_style="dim"
    )


def figure_columns(table: Table, heads: Sequence[str]) -> None:
    """Add the columns of a table of figures: the first has names, the others numbers."""
    table.add_column(heads[0])
    for head in heads[1:]:
        table.add_column(head, justify="right")


def _number(value: float) -> str:
    if value != value or abs(value) == float("inf"):
        return "none" if value != value else "any"
    return f"{value:.3g}" if abs(value) < 1e-3 and value else f"{value:.3f}".rstrip("0").rstrip(".")


def stem_of(names: Collection[str]) -> str:
    """The words that all names of files begin with; it stands above their table, which then fits a narrow terminal."""
    first, last = min(names), max(names)
    same = takewhile(lambda letters: letters[0] == letters[1], zip(first, last, strict=False))
    return "".join(letter for letter, _ in same).rpartition("_")[0]


def drawings(written: "Written", out: Path) -> None:
    """Print each drawing with its sheet, and what else was written."""
    stem = stem_of(written.entry["files"])
    table = plain_table("")
    table.add_column("file", overflow="fold")
    for column in ("sheet", "scale", "dimensions"):
        table.add_column(column, justify="right")
    for name, facts in written.entry["files"].items():
        count = len(facts["dimensions_mm"]) if "dimensions_mm" in facts else ""
        table.add_row(name.removeprefix(stem), facts.get("sheet", ""), facts.get("scale", ""), str(count))
    heading(out, stem)
    Output().print(table)
    _omitted(written)
    if left_open := written.entry.get("not_stated"):
        named = ", ".join(f"{name} ({key})" for name, key in left_open.items())
        Output().print(f"The sheets say that these are not stated: {named}. State them in the design, or on the paper.")
