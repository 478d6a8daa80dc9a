"""Results of a study as sentences and tables."""

from pathlib import Path
from typing import TYPE_CHECKING

from cadgen.cli import show
from cadgen.cli.show import Output

if TYPE_CHECKING:
    from cadgen import Written
    from cadgen.api.exploration import Exploration

_MOST_ROWS = 10  # of the front
_STATES = {
    "kept": "within all limits",
    "outside": "outside a limit or check",
    "screened": "screened out",
    "refused": "no design",
    "crashed": "crashed",
}


def results(computed: "Exploration", written: "Written | None", out: Path, *, as_json: bool) -> None:
    """Print counts, front and files; of a shard, which has none of these yet, only JSON.

    Args:
        computed: results.
        written: files that were written; None for a shard.
        out: folder of the results.
        as_json: whether to print one JSON document instead.
    """
    if as_json:
        show.document(computed.facts() if written is None else written.entry)
        return
    if written is None:
        return
    console, summary = Output(), computed.summary
    states = [f"{count} {_STATES[state]}" for state, count in summary.states.items()]
    console.print(f"{computed.name}: {computed.computed.count} designs, {', '.join(states)}.")
    if summary.front:
        _front(computed)
    show.files(written, out)


def outcome(computed: "Exploration", out: Path) -> tuple[bool, str, str]:
    """Whether any design keeps all limits and checks, the result in words, and the next step."""
    name, count = computed.name, len(computed.summary.front)
    if not count:
        reasons = f"the columns failed and sentence of {out / name}.csv say what is in the way"
        return False, "no design keeps all limits and checks", reasons
    best = f"cadgen cam {out / name}_best_1.toml" if computed.computed.study.file.best else "raise best in the study"
    return True, f"every design has its row; on the front: {count}", best


def _front(computed: "Exploration") -> None:
    study, front = computed.computed.study, computed.summary.front
    count = "1 design" if len(front) == 1 else f"{len(front)} designs"
    table = show.plain_table(f"\nfront: {count}" + (", the first:" if len(front) > _MOST_ROWS else ""))
    heads = ["number", *study.keys, *(figure.code for figure in study.figures)]
    for head in heads:
        table.add_column(head, justify="right", overflow="fold")
    for row in front[:_MOST_ROWS]:
        known = [f"{value:.6g}" if isinstance(value, float) else str(value) for value in (*row.values, *row.figures)]
        table.add_row(str(row.number), *known)
    Output().print(table)
