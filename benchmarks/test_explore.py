"""Two processes against one, and dask's LocalCluster against processes, on the same designs: as ratios.

Run on a quiet machine with
`pytest benchmarks/test_explore.py -o addopts=--import-mode=importlib --benchmark-only -s`.
A first run of each engine starts its processes, so that what is compared is work after start-up.
"""

from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import Any

import pytest

from cadgen.api.exploration import explore

DESIGNS = 120  # of the paper's car, over half a second each: more than a minute of one worker
STARTED = 24  # designs of the study that starts the processes: several for each, so that each has loaded all
TWO_WORKERS = 1.85
ROUNDS = 3
DASK = 1.05

STUDY = """
objectives = ["worst_end_mm", "disc_diameter_mm"]
[plan]
kind = "sobol"
designs = {designs}
[[vary]]
key = "cam.base_radius_mm"
least = {least}
most = 90
[[vary]]
key = "follower.radius_mm"
least = 1.5
most = 4.0
"""


def timed(folder: Path, name: str, executor: Any) -> float:
    """Seconds of a study, after a short one that starts the processes."""
    for designs, least in ((STARTED, 50), (DESIGNS, 60)):
        file = folder / f"{name}{designs}.toml"
        file.write_text(STUDY.format(designs=designs, least=least))
        begun = perf_counter()
        explore(file, folder / name, executor=executor)
    return perf_counter() - begun


@pytest.fixture
def ratio(benchmark: Any) -> Callable[[str, float, float], float]:
    benchmark.pedantic(lambda: None, rounds=1)

    def said(words: str, above: float, below: float) -> float:
        benchmark.extra_info[words] = above / below
        print(f"\n{words}: {above:.1f} s against {below:.1f} s, {above / below:.3f}")
        return above / below

    return said


def test_two_processes_against_one(tmp_path, ratio):
    with ProcessPoolExecutor(1) as one:
        alone = timed(tmp_path, "one", one)
    with ProcessPoolExecutor(2) as two:
        both = timed(tmp_path, "two", two)
    assert ratio("one process against two", alone, both) >= TWO_WORKERS


def test_dask_against_processes(tmp_path, ratio):
    # Alternating, so that whatever else the machine does falls on both.
    pairs = [(dask_seconds(tmp_path / f"dask{k}"), process_seconds(tmp_path / f"two{k}")) for k in range(ROUNDS)]
    ratios = [ratio(f"dask against processes, round {k + 1}", *pair) for k, pair in enumerate(pairs)]
    print(f"\ndask against processes, median: {median(ratios):.3f} (limit {DASK})")
    assert median(ratios) <= DASK


def dask_seconds(folder: Path) -> float:
    from dask.distributed import Client, LocalCluster

    folder.mkdir()
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster, set_as_default=False) as client,
    ):
        return timed(folder, "dask", client)


def process_seconds(folder: Path) -> float:
    folder.mkdir()
    with ProcessPoolExecutor(2) as two:
        return timed(folder, "two", two)
