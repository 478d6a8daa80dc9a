"""Fuzzed measured data: files of every kind with one or two things wrong, and made logs with little in them."""

import csv
import io
import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

MEASURED = Path(__file__).parents[1] / "data" / "measured"
CELLS = ("nan", "inf", "-inf", "1e300", "-1e9", "", "abc", "1,5", "0x10", "ü", "1e-300", "٣", '"', "9" * 400)

Rows = list[list[str]]


@dataclass(frozen=True)
class Data:
    """Files by their names, options of the command, and what was changed, in words."""

    files: dict[str, bytes]
    options: tuple[str, ...]
    changes: tuple[str, ...]


@cache
def _base(name: str) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]:
    """Comment lines, and header with rows."""
    lines = (MEASURED / name).read_text().splitlines()
    rows = csv.reader(line for line in lines if not line.startswith("#"))
    return tuple(line for line in lines if line.startswith("#")), tuple(tuple(row) for row in rows)


@cache
def names() -> tuple[str, ...]:
    """The measured files."""
    return tuple(sorted(file.name for file in MEASURED.glob("*.csv")))


def data(seed: int, number: int) -> Data:
    """Files of a seed and number."""
    rng = random.Random(f"{seed}/calibrate/{number}")
    files, changes = {}, []
    for n in range(rng.choices([1, 2, 3], weights=[8, 1, 1])[0]):
        if rng.random() < 0.15:
            what, content = _made(rng)
        else:
            what, content = _changed(rng, rng.choice(names()))
        files[f"data_{n}.csv"] = content
        changes.append(what)
    options: list[str] = []
    for option, chance in ((["--each"], 0.15), (["--json"], 0.4), (["--form-error-um", "30"], 0.1)):
        if rng.random() < chance:
            options += option
    return Data(files, tuple(options), tuple(changes))


def trial_runs(rng: random.Random, waypoints: Sequence[Sequence[float]]) -> tuple[str, bytes]:
    """One or two trial runs near a path, for `cadgen adjust`, with one or two things wrong."""
    rows = []
    for run in range(rng.choice([1, 1, 2])):
        turn = rng.gauss(0, 0.05)
        rows += [
            [str(run + 1), f"{x - turn * y + rng.gauss(0, 10):.1f}", f"{y + turn * x + rng.gauss(0, 10):.1f}"]
            for x, y in waypoints[1:]
        ]
    return _spoilt(rng, "trial runs", (), ["run", "x_mm", "y_mm"], rows)


def _changed(rng: random.Random, name: str) -> tuple[str, bytes]:
    remarks, table = _base(name)
    header, rows = list(table[0]), [list(row) for row in table[1:]]
    # Logs have ten thousand rows: a few runs of them do as well.
    runs = list(dict.fromkeys(row[0] for row in rows))
    if len(rows) > 3000:
        keep = set(rng.sample(runs, min(len(runs), rng.choice([1, 2, 4, 5]))))
        rows = [row for row in rows if row[0] in keep]
    return _spoilt(rng, name, remarks, header, rows)


def _spoilt(rng: random.Random, name: str, remarks: Sequence[str], header: list[str], rows: Rows) -> tuple[str, bytes]:
    what = [name]
    for _ in range(rng.choices([0, 1, 2], weights=[1, 6, 3])[0]):
        change = rng.choice(READABLE if rng.random() < STILL_READABLE else CHANGES)
        told, header, rows = change(rng, header, rows)
        what.append(told)
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([header, *rows])
    text = "\n".join([*(remarks if rng.random() < 0.95 else []), out.getvalue()]).encode()
    if rng.random() < 0.05:
        told, text = rng.choice(
            [("empty", b""), ("zeros", b"\0" * 50), ("cut", text[: rng.randrange(len(text))]),
             ("UTF-16", text.decode().encode("utf-16")), ("semicolons", text.replace(b",", b";"))]
        )  # fmt: skip
        what.append(told)
    return ", ".join(what), text


Changed = tuple[str, list[str], Rows]


def _column(rng: random.Random, header: list[str]) -> int:
    return rng.randrange(len(header))


def _drop(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c = _column(rng, header)
    return f"without {header[c]}", header[:c] + header[c + 1 :], [row[:c] + row[c + 1 :] for row in rows]


def _reading(rng: random.Random, header: list[str]) -> int:
    """A column of what an instrument reads: neither the run nor a setting."""
    return rng.choice([c for c, name in enumerate(header) if name not in SETTINGS] or [0])


def _permute(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    order = rng.sample(range(len(header)), len(header))
    return "columns permuted", [header[k] for k in order], [[row[k] for k in order if k < len(row)] for row in rows]


def _swap(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    a, b = rng.randrange(len(header)), rng.randrange(len(header))
    names = list(header)
    names[a], names[b] = names[b], names[a]
    return f"{header[a]} under {header[b]}", names, rows


def _cell(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c, value = _column(rng, header), rng.choice(CELLS)
    for row in rng.sample(rows, min(len(rows), rng.choice([1, 3]))):
        row[min(c, len(row) - 1)] = value
    return f"{value[:9]!r} in {header[c]}", header, rows


def _constant(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c = _column(rng, header)
    value = rng.choice([rows[0][c], "0", "1"]) if rows else "0"
    return f"{header[c]} constant", header, [[*row[:c], value, *row[c + 1 :]] for row in rows]


def _scaled(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c = _column(rng, header)
    factor = rng.choice([1e-3, 1e3, 25.4, 1 / 25.4, math.pi / 180, 180 / math.pi, -1.0, 0.0, 1.01, 1e6, 2.0])
    return f"{header[c]} times {factor:g}", header, _applied(rows, c, lambda x: x * factor)


def _shifted(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c, more = _column(rng, header), rng.choice([1e-3, 0.1, 1.0, 90.0, 360.0, -5.0])
    return f"{header[c]} plus {more:g}", header, _applied(rows, c, lambda x: x + more)


def _noisy(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c, size = _column(rng, header), 10 ** rng.uniform(-4, 3)
    return f"{header[c]} with noise {size:.2g}", header, _applied(rows, c, lambda x: x + rng.gauss(0, size))


def _near(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    """A scale and an offset as an instrument's or a workshop's."""
    c, factor, more = _reading(rng, header), rng.uniform(0.97, 1.03), rng.choice([0.0, 1e-3, 0.1, -0.5])
    return f"{header[c]} times {factor:.3f} plus {more:g}", header, _applied(rows, c, lambda x: x * factor + more)


def _disturbed(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    """A bump, a drift or noise of a share of what the column spans."""
    c = _reading(rng, header)
    values = [float(row[c]) for row in rows if c < len(row) and _is_number(row[c])]
    size = (max(values, default=0.0) - min(values, default=0.0)) * 10 ** rng.uniform(-4, -1)
    how = rng.choice(["noise", "drift", "bump"])
    centre, width = rng.random() * len(rows), 1 + len(rows) * rng.choice([0.003, 0.03, 0.3])
    for n, row in enumerate(rows):
        if c < len(row) and _is_number(row[c]):
            shift = {"noise": rng.gauss(0, 1), "drift": n / len(rows), "bump": math.exp(-(((n - centre) / width) ** 2))}
            row[c] = f"{float(row[c]) + size * shift[how]:.5f}"
    return f"{header[c]} with a {how} of {size:.2g}", header, rows


def _is_number(cell: str) -> bool:
    try:
        return math.isfinite(float(cell))
    except ValueError:
        return False


def _rounded(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c, digits = _column(rng, header), rng.choice([-2, -1, 0, 1])
    return f"{header[c]} to {digits} digits", header, _applied(rows, c, lambda x: round(x, digits))


def _few(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    count = rng.choice([0, 1, 2, 5, 23, 24, 30, 60])
    return f"{count} rows", header, rows[:count]


def _thinned(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    every = rng.choice([2, 3, 5, 10])
    return f"every {every}th row", header, rows[::every]


def _shuffled(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    return "rows shuffled", header, rng.sample(rows, len(rows))


def _runs_named(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    how = rng.choice(["one run", "a run each row", "runs in blocks", "named"])
    for n, row in enumerate(rows):
        row[0] = {"one run": "1", "a run each row": str(n), "runs in blocks": str(n // 50), "named": f"run {row[0]}"}[
            how
        ]
    return how, header, rows


def _finely_rounded(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    c, digits = _reading(rng, header), rng.choice([1, 2, 3])
    return f"{header[c]} to {digits} digits", header, _applied(rows, c, lambda x: round(x, digits))


def _repeated(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    """One more run, nearly the first one's."""
    c = _reading(rng, header)
    run = [["more", *row[1:]] for row in rows if row[:1] == rows[0][:1]]
    return f"a run repeated with other {header[c]}", header, rows + _applied(run, c, lambda x: x + rng.gauss(0, 1e-3))


def _copied(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    return "runs copied", header, rows + [["copy", *row[1:]] for row in rows if row[:1] == rows[0][:1]]


def _many(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    times = rng.choice([3, 10, 40])
    more = []
    for k in range(times):
        for row in rows[:2000]:
            more.append([f"{k}/{row[0]}" if row else "", *[_jittered(rng, cell) for cell in row[1:]]])
    return f"{len(more)} rows in {times} times the runs", header, more


def _part(rng: random.Random, header: list[str], rows: Rows) -> Changed:
    a, b = sorted(rng.randrange(len(rows) + 1) for _ in range(2))
    return f"rows {a} to {b}", header, rows[a:b]


CHANGES = (
    _drop, _permute, _swap, _cell, _constant, _constant, _scaled, _scaled, _shifted, _noisy, _rounded, _few, _thinned,
    _shuffled, _runs_named, _copied, _many, _part,
)  # fmt: skip
# Changes that leave a file readable come first, so that most cases reach the inference behind the reader.
STILL_READABLE = 0.85
READABLE = (_near, _near, _disturbed, _disturbed, _disturbed, _finely_rounded, _thinned, _repeated, _permute)
SETTINGS = ("run", "direction", "cam_angle_deg", "motor_angle_deg", "t_s", "zone", "n")


def _jittered(rng: random.Random, cell: str) -> str:
    try:
        return f"{float(cell) + rng.gauss(0, 1e-3):.4f}"
    except ValueError:
        return cell


def _applied(rows: Rows, c: int, change: Callable[[float], float]) -> Rows:
    for row in rows:
        try:
            row[c] = f"{change(float(row[c])):.6g}"
        except (ValueError, IndexError, OverflowError):
            continue
    return rows


def _made(rng: random.Random) -> tuple[str, bytes]:
    """A logged track that says little: the wheel held, straight on, one circle, few points, standing still."""
    steering = rng.choice([0.0, 5.0, -20.0, 60.0, 90.0])
    runs, count = rng.choice([1, 2, 4, 6]), rng.choice([2, 24, 24, 60, 60, 200])
    step, noise = rng.choice([0.0, 5.0, 5.0, 20.0, 20.0]), rng.choice([0.0, 0.3, 0.3, 5.0, 5.0])
    lines = ["run,t_s,distance_mm,steering_deg,x_mm,y_mm,heading_deg"]
    for run in range(runs):
        x = y = heading = 0.0
        for k in range(count):
            lines.append(
                f"{run + 1},{0.05 * k:.2f},{step * k:.2f},{steering:.3f},{x + rng.gauss(0, noise):.2f},"
                f"{y + rng.gauss(0, noise):.2f},{math.degrees(heading):.2f}"
            )
            heading += math.sin(math.radians(steering)) / 150 * step
            x += step * math.cos(math.radians(steering)) * math.cos(heading)
            y += step * math.cos(math.radians(steering)) * math.sin(heading)
    return f"log of {runs} runs of {count} rows at {steering:g} degrees, {step:g} mm each", "\n".join(lines).encode()
