"""A small slice of the fuzz study, and that it sees what it is there for."""

import pytest

from tests.studies import fuzz, fuzz_data, fuzz_designs


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(("command", "first", "cases"), [("check", 1010, 4), ("calibrate", 1005, 2)])
def test_a_slice_keeps_the_contract(command, first, cases, forks, tmp_path):
    # In a process of its own, as the study runs: forks of a process with threads may wait for ever.
    options = ["--command", command, "--first", str(first), "--cases", str(cases), "--seed", "7", "--processes", "1"]
    run = forks.run("from tests.studies.fuzz import main; main()", *options, cwd=tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    assert f"| cases | {cases} |" in run.stdout
    assert "| faults | 0 |" in run.stdout


def test_cases_are_made_again_from_seed_and_number():
    for number in (0, 290, 400, 1234):
        assert fuzz_designs.case(3, number) == fuzz_designs.case(3, number)
        assert fuzz_data.data(3, number) == fuzz_data.data(3, number)
    assert fuzz_designs.case(3, 1234) != fuzz_designs.case(4, 1234)


def test_either_end_of_every_range_is_among_the_cases():
    ends = {(key.place, end) for key, end in fuzz_designs.edges()}
    assert (("follower", "radius_mm"), 0.05) in ends
    assert (("train", "stages", 0, "driver", "teeth"), 1000) in ends
    assert len(ends) > 250


@pytest.mark.parametrize(
    ("code", "said", "seconds", "kilobytes", "words"),
    [
        (0, "", 1.0, 1e5, ""),
        (1, "cadgen: a sentence", 1.0, 1e5, ""),
        (2, "cadgen: a sentence", 1.0, 1e5, ""),
        (2, "", 1.0, 1e5, "no sentence"),
        (3, "cadgen: a sentence", 1.0, 1e5, "exit code 3"),
        (3, "cadgen: a fault in cadgen, please report it (KeyError: 1)", 1.0, 1e5, "internal fault"),
        (1, "Traceback (most recent call last):", 1.0, 1e5, "internal fault"),
        (0, "x.py:1: RuntimeWarning: invalid value", 1.0, 1e5, "warning of a library"),
        (-9, "", 1.0, 1e5, "ended by SIGKILL"),
        (99, "", 1.0, 1e5, "exit code 99"),
        (2, "cadgen: " + "x" * 2000, 1.0, 1e5, "the longest of 2008 characters"),
        (0, "", 61.0, 1e5, "61 s of processor time"),
        (0, "", 1.0, 2.1e6, "2.1 GB"),
    ],
)
def test_what_is_a_fault(code, said, seconds, kilobytes, words):
    found = "; ".join(fuzz.judge("check", code, said, "", seconds, kilobytes, as_json=False))
    assert words in found
    assert bool(words) == bool(found)
