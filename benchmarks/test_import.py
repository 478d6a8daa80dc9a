"""Cost of `import cadgen` against `import numpy`: processor seconds of fresh processes, in turns, in one run.

Run by `pytest benchmarks/test_import.py -s`.
"""

import statistics
import subprocess
import sys

ROUNDS = 9
LIMIT = 0.15


def seconds(script):
    """Processor seconds of an import in a fresh Python, by a clock that starts when Python is up."""
    timed = f"import time; start = time.process_time(); {script}; print(time.process_time() - start)"
    out = subprocess.run([sys.executable, "-c", timed], check=True, capture_output=True, text=True).stdout
    return float(out)


def test_import_against_numpy(benchmark):
    benchmark.pedantic(seconds, args=("import cadgen",), rounds=1, warmup_rounds=1)
    pairs = [(seconds("import cadgen"), seconds("import numpy")) for _ in range(ROUNDS)]
    ours, theirs = (statistics.median(times) for times in zip(*pairs, strict=True))
    ratio = ours / theirs
    benchmark.extra_info["ratio"] = ratio
    print(f"\nimport cadgen / import numpy = {ratio:.4f} ({1e3 * ours:.2f} ms, {1e3 * theirs:.1f} ms; limit {LIMIT:g})")
    assert ratio <= LIMIT
