"""Cost of a planned lap with room for the scatter of its cars: the S ring, in processor time of one process.

python -m pytest benchmarks/test_plan.py --benchmark-only -s
"""

from pathlib import Path
from time import process_time

from cadgen import Design

RING = Path(__file__).parents[1] / "tests" / "data" / "trials" / "ring_s.toml"
LIMIT = 60.0  # s


def test_closed_ring_with_reserve(benchmark):
    used = []

    def plan():
        begun = process_time()
        found = Design.load(RING, train_only=True).plan()
        used.append(process_time() - begun)
        return found

    found = benchmark.pedantic(plan, rounds=1)
    benchmark.extra_info["processor time, s"] = used[0]
    tried = [each["reserve"] for each in found.facts()["yield"]["tried"]]
    print(f"\nS ring, reserves {tried}: {used[0]:.1f} s of processor time, limit {LIMIT:g}")
    assert found.passed
    assert len(tried) > 1
    assert used[0] <= LIMIT
