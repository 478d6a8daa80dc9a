"""Cases of a study, kept in a file as they come: the same command again does what is missing."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context
from pathlib import Path
from typing import Any

from scipy.stats import binomtest

from cadgen.version import __version__

Key = tuple[Any, ...]


def outcomes(
    work: Callable[..., dict[str, Any]], keys: Sequence[Key], log: Path | None, processes: int = 1
) -> list[dict[str, Any]]:
    """Outcomes `work(*key)` of every key, in the order of the keys.

    Args:
        work: of one case; gives what JSON can hold.
        keys: arguments of each case.
        log: file of a line for each case that is done; nothing is kept if left out.
        processes: how many at once, 1 or more.
    """
    done = dict(_kept(log))
    missing = [key for key in keys if key not in done]
    # A fresh process reads it; in a forked one numpy has its threads already, which burn twice the time of a case.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    with ProcessPoolExecutor(processes, mp_context=get_context("spawn")) as pool:
        running = {pool.submit(work, *key): key for key in missing}
        for one in as_completed(running):
            done[running[one]] = one.result()
            if log:
                with log.open("a", encoding="utf-8") as sink:
                    sink.write(json.dumps([running[one], done[running[one]]]) + "\n")
    return [done[key] for key in keys]


def _kept(log: Path | None) -> Iterator[tuple[Key, dict[str, Any]]]:
    for line in log.read_text(encoding="utf-8").splitlines() if log and log.exists() else []:
        key, found = json.loads(line)
        yield tuple(key), found


def share(hits: int, of: int) -> str:
    """A share of cases with its 95 % interval (Wilson 1927), as a page shows it."""
    if not of:
        return "-"
    low, high = binomtest(hits, of).proportion_ci(0.95, method="wilson")
    return f"{100 * hits / of:.1f} % of {of} ({100 * low:.1f}-{100 * high:.1f})"


def stamp() -> str:
    """Version and commit of the code that a study runs on."""
    asked = ["git", "-C", str(Path(__file__).parent), "rev-parse", "--short", "HEAD"]
    commit = subprocess.run(asked, capture_output=True, text=True, check=False).stdout.strip()
    return f"cadgen {__version__}" + (f", commit {commit}" if commit else "")
