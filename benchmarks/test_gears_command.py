"""The whole of `cadgen gears`, six gears, all files and mesh checks, against importing build123d in the same run.

Run by `pytest benchmarks -s`.
"""

import statistics
import subprocess
import sys
import time

ROUNDS = 5
LIMIT = 4.0


def seconds(arguments, cwd):
    start = time.perf_counter()
    subprocess.run([sys.executable, *arguments], cwd=cwd, check=True, capture_output=True)
    return time.perf_counter() - start


def test_gears_command_against_importing_build123d(benchmark, tmp_path):
    command = ["-c", "from cadgen.cli import main; main()", "gears", "--out", "out"]
    imports = ["-c", "import build123d"]
    benchmark.pedantic(seconds, args=(command, tmp_path), rounds=1, warmup_rounds=1)
    # Alternating, so that whatever else the machine does falls on both.
    pairs = [(seconds(command, tmp_path), seconds(imports, tmp_path)) for _ in range(ROUNDS)]
    ratio = statistics.median(ours / theirs for ours, theirs in pairs)
    benchmark.extra_info["ratio"] = ratio
    print(f"\ncadgen gears / import build123d = {ratio:.2f} (limit {LIMIT})")
    assert ratio <= LIMIT
