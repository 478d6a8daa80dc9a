"""Figures that cost next to nothing, for studies of the machinery itself: some that crash, kill or take a given time.

    python -m tests.exploration.cheap STUDY OUT PROCESSES

runs a study with them, as `cadgen explore` does with those of the program.
"""

import json
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from time import perf_counter, thread_time

import numpy as np

from cadgen.api.exploration import Exploration, Figure, explore, register_figure, remove_figure
from cadgen.studies.study_figures import Evaluated

A, B = "cam.base_radius_mm", "car.wheelbase_mm"
MILLISECOND = 1e-3


def _first(evaluated: Evaluated) -> float:
    return (evaluated.values[A] - 70) ** 2


def _second(evaluated: Evaluated) -> float:
    return (evaluated.values[A] - 60) ** 2 + abs(evaluated.values[B] - 150)


def _crash(evaluated: Evaluated) -> float:
    if 66 < evaluated.values[A] < 67:
        raise RuntimeError("no design at all")
    return 0.0


def _kill(evaluated: Evaluated) -> float:
    """Kill this process at some designs, or its parent once, as the environment says: see `killing`."""
    at, once = os.environ.get("CHEAP_KILL", "").partition(" ")[::2]
    if at and abs(evaluated.values[A] - float(at)) < 0.05:
        whom = os.getppid() if once.startswith("parent") else os.getpid()
        mark = once.partition(" ")[2]
        if not mark:
            os.kill(whom, signal.SIGKILL)
        elif not Path(mark).exists():
            Path(mark).touch()
            os.kill(whom, signal.SIGKILL)
    return 0.0


def _millisecond(evaluated: Evaluated) -> float:
    begun = thread_time()
    while thread_time() - begun < MILLISECOND:
        pass
    return 0.0


def _greedy(evaluated: Evaluated) -> float:
    if 66 < evaluated.values[A] < 67:
        return float(np.ones(400_000_000)[0])
    return 0.0


def _hang(evaluated: Evaluated) -> float:
    if 66 < evaluated.values[A] < 67:
        begun = perf_counter()
        while perf_counter() - begun < 60:
            pass
    return 0.0


FIGURES = tuple(
    Figure(code=code, meaning=code, of=of, cheap=True)
    for code, of in (
        ("cheap_first_mm", _first),
        ("cheap_second_mm", _second),
        ("cheap_crash_mm", _crash),
        ("cheap_kill_mm", _kill),
        ("cheap_millisecond_mm", _millisecond),
        ("cheap_hang_mm", _hang),
        ("cheap_greedy_mm", _greedy),
    )
)


@contextmanager
def registered() -> Iterator[None]:
    for figure in FIGURES:
        register_figure(figure)
    try:
        yield
    finally:
        for figure in FIGURES:
            remove_figure(figure)


def study_text(designs: int = 200, kind: str = "sobol", record: tuple[str, ...] = (), more: str = "") -> str:
    recorded = ", ".join(f'"{code}"' for code in record)
    return f"""
name = "cheap"
objectives = ["cheap_first_mm", "cheap_second_mm"]
record = [{recorded}]
checks = []
best = 2
{more}
[plan]
kind = "{kind}"
designs = {designs}
{"population = 20" if kind == "nsga2" else ""}

[[vary]]
key = "{A}"
least = 60
most = 80

[[vary]]
key = "{B}"
values = [150.0, 160.0, 170.0]
"""


def digest(computed: Exploration) -> str:
    """Hash of all rows, from which all files are made."""
    whole = sha256()
    for row in computed.computed.rows():
        whole.update(json.dumps(row.content).encode())
    return whole.hexdigest()


if __name__ == "__main__":
    with registered():
        explore(sys.argv[1], sys.argv[2], processes=int(sys.argv[3])).write()
