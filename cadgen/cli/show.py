"""What a command prints: progress on standard error, tables or one JSON document on standard output."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.console import Console
from rich.table import Table

if TYPE_CHECKING:
    from cadgen.workflow.cam import CamPlan
    from cadgen.workflow.files import Written


@contextmanager
def progress(enabled: bool) -> Iterator[Callable[[str], None]]:
    """Yield a function that shows what is being done now; silent unless standard error is a terminal."""
    console = Console(stderr=True)
    if not enabled or not console.is_terminal:
        yield lambda text: None
        return
    with console.status("reading the design") as status:
        yield status.update


def document(facts: dict[str, Any]) -> None:
    """Print one JSON document."""
    click.echo(json.dumps(facts, indent=2, allow_nan=False))


def checks(plan: "CamPlan") -> None:
    """Print the checks as a table, then what to change for each that failed."""
    table = _table(f"{plan.design.name}, {plan.profile} profile")
    for column, justify in (("check", "left"), ("value", "right"), ("limit", "right"), ("", "left"), ("where", "left")):
        table.add_column(column, justify=justify, overflow="fold")  # type: ignore[arg-type]
    for check in plan.checks:
        verdict = "[green]ok[/]" if check.passed else "[red]FAIL[/]"
        bound = "<=" if check.bound == "max" else ">="
        table.add_row(
            check.name,
            f"{_number(check.value)}{check.unit if check.unit == '°' else ' ' + check.unit}".rstrip(),
            f"{bound} {_number(check.limit)}",
            verdict,
            check.place,
        )
    console = Console()
    console.print(table)
    # One advice may serve several checks.
    advice: dict[str, list[str]] = {}
    for check in plan.checks:
        if not check.passed:
            advice.setdefault(check.advice, []).append(check.name)
    for text, names in advice.items():
        console.print(f"[red]{' and '.join(names)}[/]: {text}.", highlight=False)
    for line in plan.cure_sentences():
        console.print(line, highlight=False)


def files(written: "Written", out: Path) -> None:
    """Print each file with its size and its error at the follower's lift."""
    table = _table(f"{out}{'' if str(out).endswith('/') else '/'}")
    for column, justify in (("file", "left"), ("size", "right"), ("error at lift", "right"), ("limit", "right")):
        table.add_column(column, justify=justify)  # type: ignore[arg-type]
    for name, facts in written.entry["files"].items():
        error, limit = facts.get("lift_error_um"), facts.get("lift_limit_um")
        table.add_row(
            name,
            f"{facts['bytes'] / 1000:.0f} kB",
            "" if error is None else f"{error:.3f} µm",
            "" if limit is None else f"{limit:g} µm",
        )
    Console().print(table)


def _table(title: str) -> Table:
    return Table(title=title, title_justify="left", title_style="bold", box=None, pad_edge=False, header_style="dim")


def _number(value: float) -> str:
    if value != value or abs(value) == float("inf"):
        return "none" if value != value else "any"
    return f"{value:.3g}" if abs(value) < 1e-3 and value else f"{value:.3f}".rstrip("0").rstrip(".")
