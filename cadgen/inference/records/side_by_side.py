"""Runs that stand side by side in a table, brought under each other.

Their columns have one name with numbers, as `x1_mm, y1_mm, x2_mm, y2_mm` or `Run 2 X [mm]`; the same names again; or
words for the two directions, as `lift forward, lift reverse`. Columns that stand once belong to each of the runs.
"""

import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import count

import numpy as np

from cadgen.inference.records.table_rows import TableRows
from cadgen.inference.records.units import DIRECTIONS, FLANKS, MISSING, TIMES, heading, unit_of
from cadgen.messages import Message, joined

_RUN = r"(?:run|trial|test|lauf|versuch|fahrt|messung|次数|试验|运行|第)"
_UNIT = r"[\s_/,]*[\[(（]?[^\W\d_]*[°\"]?[\])）]?"
_BEHIND = re.compile(rf"(.*?[^\W\d_])[\s_.#(\-]*(?:{_RUN}[\s_.#]*)?(\d{{1,2}})\)?({_UNIT})", re.IGNORECASE)
_BEFORE = re.compile(rf"{_RUN}[\s_.#]*(\d{{1,2}})[次\s:_.\-]+(.*)", re.IGNORECASE)
# Column of words -> words that stand in names instead.
_ALSO = {"up": "forward", "auf": "forward", "down": "reverse", "ab": "reverse"}
_BY_WORDS = {"direction": DIRECTIONS | _ALSO, "flank": FLANKS}
_LETTERS = 2  # of a word for a direction
_CLOCKS = ("frame", "frames", "sample", "samples", "image", "bild", "帧", "帧号")
_NEAR = 0.01  # of the extent of a path, within which two runs of it lie
_RIGID = 0.05  # share by which the distance of two points of one body varies at most, as measured
_FORWARD, _REVERSE = "forward", "reverse"
_SAME_ORDER = ("lift",)  # quantities that have a column of directions


def brought_under(table: TableRows, known: Collection[str]) -> tuple[TableRows, frozenset[str]] | None:
    """Table whose runs stand under each other, and the quantities that each run had as its own; None where none did.

    Args:
        table: rows of a table.
        known: quantities that are known.
    """
    names, columns = table.names, table.columns
    if any(heading(called).quantity in ("run", "direction", "flank") for called in names):
        return None
    parts = [_part(called, known) for called in names]
    # The same name again is that of a further run.
    times: dict[tuple[str, str | None], int] = {}
    for k, (base, group) in enumerate(parts):
        again = times[base, group] = times.get((base, group), -1) + 1
        if again and base:
            parts[k] = base, f"{group or ''}+{again}"
    owned = {base for base, group in parts if group is not None}
    owned = {base for base in owned if sum(base == other for other, _ in parts) > 1}
    groups = list(dict.fromkeys(group for base, group in parts if base in owned))
    own = {group: {base: k for k, (base, g) in enumerate(parts) if g == group and base in owned} for group in groups}
    if len(groups) < 2 or any(places.keys() != owned for places in own.values()):
        return None
    shared = [k for k, (base, _) in enumerate(parts) if base not in owned]
    word = next((column for column, words in _BY_WORDS.items() if set(groups) <= set(words.values())), None)
    several = frozenset(heading(base).quantity for base in owned)
    pairs = [[columns[places[base]] for base in owned] for places in own.values()]
    # Positions by one clock, or always as far apart, are of two markers, and no runs.
    clocks = {*TIMES, *_CLOCKS}
    if several & {"x", "y"} and (word or any(heading(names[k]).quantity in clocks for k in shared) or _rigid(pairs)):
        return None
    ordered = sorted(owned, key=lambda base: own[groups[0]][base])
    out: list[tuple[str, ...]] = []
    places, runs = list[int](), list[int]()
    for group, number in zip(groups, count()):
        order = range(len(columns[0]))
        # A way back beside the rows of the way there is read from its end, and belongs to the run of that.
        back = group == _REVERSE and not several & set(_SAME_ORDER)
        back = back and not any(_turns(columns[own[groups[0]][base]], columns[own[group][base]]) for base in owned)
        for row in reversed(order) if back else order:
            cells = [columns[own[group][base]][row] for base in ordered]
            if all(cell.lower() in MISSING for cell in cells):
                continue
            out.append((*(columns[k][row] for k in shared), *cells, *((group or "",) if word else ())))
            places.append(row)
            runs.append(0 if word else number)
    if not out:
        return None
    named = (*(names[k] for k in shared), *ordered, *((word,) if word else ()))
    beside = replace(
        table,
        names=named,
        lines=tuple(table.lines[row] for row in places),
        columns=tuple(zip(*out, strict=True)),
        blocks=tuple(run + table.blocks[row] * len(groups) for run, row in zip(runs, places, strict=True)),
    )
    note = Message("runs stand side by side, with {columns} of their own", columns=joined(ordered, ", "))
    return beside.noted(note), several


def _finite(column: Collection[str]) -> list[float]:
    """Numbers of a column, without cells that hold none."""
    return [float(cell) for cell in column if re.fullmatch(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", cell)]


def _turns(there: Collection[str], back: Collection[str]) -> bool:
    """Whether a column goes the other way on the way back, as in the order of time."""
    ends = [numbers[-1] - numbers[0] for numbers in map(_finite, (there, back)) if len(numbers) > 1]
    return len(ends) == len("xy") and ends[0] * ends[1] < 0


def _rigid(pairs: Sequence[Sequence[Sequence[str]]]) -> bool:
    """Whether the points of the first two groups are always as far apart as on one body."""
    first, second = ([_finite(column) for column in columns] for columns in pairs[:2])
    if len({len(column) for column in (*first, *second)}) != 1 or not first[0]:
        return False
    apart = np.sqrt(np.sum((np.array(first) - np.array(second)) ** 2, axis=0))
    # Two runs of one path lie nearer than a body is long.
    return bool(apart.mean() > _NEAR * np.ptp(first, axis=1).max() and apart.std() < _RIGID * apart.mean())


def _part(name: str, known: Collection[str]) -> tuple[str, str | None]:
    """Name of a column without the number or the word of its run, and these; None if it has none."""
    text, has = name.strip(), heading(name)
    if match := _BEFORE.fullmatch(text):
        base, group = match[2], match[1]
    elif has.quantity in known and (not has.unit or unit_of(has.unit)):
        return name, None
    elif match := _BEHIND.fullmatch(text):
        base, group = match[1] + match[3], match[2]
    else:
        words = [
            word for word in re.split(r"[\s_.,/()\[\]（）\-]+", text) if len(word) >= _LETTERS or not word.isascii()
        ]
        meant = {word: each[word.lower()] for each in _BY_WORDS.values() for word in words if word.lower() in each}
        word = next(iter(meant), "")
        base = re.sub(rf"[\s_.,\-]*[\[(（]?{re.escape(word)}[\])）]?", "", text, count=1).strip(" _")
        group = meant.get(word, "")
    return (base, group) if group and heading(base).quantity in known else (name, None)
