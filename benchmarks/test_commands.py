"""Whole commands, files and checks included, against importing build123d in the same run, or another checkout's.

Run by `pytest benchmarks -s`. For the processor time of the commands before a change, name the Python of an environment
in which the earlier checkout is installed:

    CADGEN_BEFORE=../before/.venv/bin/python pytest benchmarks/test_commands.py -k before -s
"""

import os
import statistics
import subprocess
import sys
import time

import pytest

ROUNDS = 5
# As users have it: with the bytecode of all modules kept.
USUAL = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def seconds(arguments, cwd, python=sys.executable):
    start = time.perf_counter()
    subprocess.run([python, *arguments], cwd=cwd, check=True, capture_output=True, env=USUAL)
    return time.perf_counter() - start


def processor_seconds(arguments, cwd, python=sys.executable):
    before = os.times()
    seconds(arguments, cwd, python)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


@pytest.mark.parametrize(
    ("words", "limit"),
    [
        ("cam --out out", 1.4),
        ("cam roller --out out", 1.3),
        ("check roller", 0.5),
        ("gears --out out", 2.5),
        ("optimize", 0.9),
        ("tolerance --samples 10000 --out out", 0.8),
    ],
    ids=["cam", "cam of a motion", "check of a motion", "gears", "optimize", "tolerance"],
)
def test_command_against_importing_build123d(benchmark, tmp_path, words, limit):
    command = ["-c", "from cadgen.cli import main; main()", *words.split()]
    imports = ["-c", "import build123d"]
    benchmark.pedantic(seconds, args=(command, tmp_path), rounds=1, warmup_rounds=1)
    # Alternating, so that whatever else the machine does falls on both.
    pairs = [(seconds(command, tmp_path), seconds(imports, tmp_path)) for _ in range(ROUNDS)]
    ratio = statistics.median(ours / theirs for ours, theirs in pairs)
    benchmark.extra_info["ratio"] = ratio
    print(f"\ncadgen {words} / import build123d = {ratio:.2f} (limit {limit:g})")
    assert ratio <= limit


@pytest.mark.parametrize(
    "words",
    [
        "check workshop_car",
        "cam workshop_car --out out",
        "gears workshop_car --out out",
        "tolerance workshop_car --samples 10000",
        "optimize workshop_car",
    ],
    ids=lambda words: words.split()[0],
)
@pytest.mark.skipif("CADGEN_BEFORE" not in os.environ, reason="CADGEN_BEFORE names no Python with an earlier cadgen")
def test_processor_time_against_before(benchmark, tmp_path, words):
    """Processor time of the command and of the processes that it starts.

    A first run of both is not counted: it writes the bytecode, without which a command takes some 2 s more.
    """
    command = ["-c", "from cadgen.cli import main; main()", *words.split()]
    earlier = tmp_path / "before"
    earlier.mkdir()
    before = (command, earlier, os.path.abspath(os.environ["CADGEN_BEFORE"]))
    benchmark.pedantic(processor_seconds, args=(command, tmp_path), rounds=1, warmup_rounds=1)
    processor_seconds(*before)
    pairs = [(processor_seconds(command, tmp_path), processor_seconds(*before)) for _ in range(7)]
    ours, theirs = (statistics.median(times) for times in zip(*pairs, strict=True))
    ratio = statistics.median(one / other for one, other in pairs)
    benchmark.extra_info["ratio"] = ratio
    print(f"\ncadgen {words}: processor time {ours:.2f} s, before {theirs:.2f} s, ratio {ratio:.3f} (limit 1.05)")
    assert ratio <= 1.05


@pytest.mark.parametrize("design", ["carbon_free_car", "posts_and_walls"])
def test_check_with_a_course_against_the_same_without(benchmark, tmp_path, design):
    command = ["-c", "from cadgen.cli import main; main()", "check", design]
    bare = [*command, "--set", "course="]
    benchmark.pedantic(processor_seconds, args=(command, tmp_path), rounds=1, warmup_rounds=1)
    pairs = [(processor_seconds(command, tmp_path), processor_seconds(bare, tmp_path)) for _ in range(ROUNDS)]
    ratio = statistics.median(ours / theirs for ours, theirs in pairs)
    benchmark.extra_info["ratio"] = ratio
    print(f"\ncadgen check {design} with its course / without = {ratio:.2f} (limit 1.3)")
    assert ratio <= 1.3
