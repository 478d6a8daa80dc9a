"""What one calibration costs, against importing build123d in the same run.

python -m pytest benchmarks/test_calibrate.py --benchmark-only -s
"""

import subprocess
import sys
from functools import cache
from pathlib import Path
from time import perf_counter

import pytest

from cadgen.measurement.load import load
from cadgen.measurement.nominal import Nominal, calibrate, calibrate_tricycle
from tests.conftest import build

FILES = Path(__file__).parents[1] / "tests" / "data" / "measured"
WHEELBASE = 150.0  # mm, as the tricycle's files say


@cache
def import_of_build123d() -> float:
    """Seconds, the least of three runs."""
    times = []
    for _ in range(3):
        start = perf_counter()
        subprocess.run([sys.executable, "-c", "import build123d"], check=True)
        times.append(perf_counter() - start)
    return min(times)


def one_file(name: str) -> None:
    car = build("carbon_free_car")
    nominal = Nominal(
        lift=car.lift,
        follower=car.follower,
        profile=car.actual.curve,
        car=car.car,
        track=car.track,
        ratios=(5.0, 3.0, 3.0),
    )
    calibrate([load(FILES / f"{name}.csv")], nominal)


def tracks(name: str) -> None:
    calibrate_tricycle([load(FILES / f"{part}.csv") for part in name.split("+")], WHEELBASE)


@pytest.mark.parametrize(
    ("make", "name", "limit"),
    [
        (one_file, "lift_d", 5.0),
        (one_file, "profile_c", 5.0),
        (one_file, "transmission_a", 5.0),
        (one_file, "track_b", 5.0),
        (tracks, "circles+squares", 30.0),
    ],
)
def test_calibration(benchmark, make, name, limit):
    benchmark.pedantic(make, (name,), rounds=2)
    ratio = benchmark.stats["min"] / import_of_build123d()
    benchmark.extra_info["ratio"] = ratio
    print(f"\n{name}: {ratio:.2f} imports of build123d ({import_of_build123d():.2f} s), limit {limit:g}")
    assert ratio <= limit
