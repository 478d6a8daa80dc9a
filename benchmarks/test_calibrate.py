"""Cost of one calibration, the whole process and its pictures, against importing build123d in the same run.

python -m pytest benchmarks/test_calibrate.py --benchmark-only -s
"""

import subprocess
import sys
from functools import cache
from pathlib import Path
from time import perf_counter

import pytest

DATA = Path(__file__).parents[1] / "tests" / "data"


def seconds(*arguments: str) -> float:
    start = perf_counter()
    subprocess.run([sys.executable, *arguments], check=True, stdout=subprocess.DEVNULL)
    return perf_counter() - start


@cache
def import_of_build123d() -> float:
    """Seconds, the least of three runs."""
    return min(seconds("-c", "import build123d") for _ in range(3))


@pytest.mark.parametrize(
    ("names", "limit"),
    [
        (["lift_d"], 3.0),
        (["profile_c"], 3.0),
        (["transmission_a"], 3.0),
        (["track_b"], 3.0),
        (["track_b", "lift_d", "transmission_a"], 8.0),
        (["circles", "squares"], 30.0),
    ],
)
def test_command(benchmark, tmp_path, names, limit):
    files = [str(DATA / "measured" / f"{name}.csv") for name in names]
    command = ["-c", "from cadgen.cli import main; main()", "calibrate", *files, "--out", str(tmp_path)]
    benchmark.pedantic(seconds, command, rounds=2)
    ratio = benchmark.stats["min"] / import_of_build123d()
    benchmark.extra_info["ratio"] = ratio
    print(f"\n{'+'.join(names)}: {ratio:.2f} imports of build123d ({import_of_build123d():.2f} s), limit {limit:g}")
    assert ratio <= limit
