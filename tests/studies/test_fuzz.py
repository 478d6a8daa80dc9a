"""A small slice of the fuzz study, and that it sees what it is there for."""

import json
import tomllib

import numpy as np
import pytest

from cadgen import Design
from cadgen.design.load import packaged_designs
from tests.studies import fuzz, fuzz_data, fuzz_designs, fuzz_truth


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


def test_deep_cases_courses_and_studies_are_made_again_and_are_mostly_whole_designs():
    deep = fuzz._deep("check", True)
    made = [fuzz_designs.case(3, number, deep=deep) for number in range(60)]
    assert made == [fuzz_designs.case(3, number, deep=deep) for number in range(60)]
    assert {name for case in made for name in case.changes} >= {"motion", "figure_eight", "draws/eight.toml"}
    for number in range(5):
        assert fuzz_designs.course(3, number) == fuzz_designs.course(3, number)
        assert fuzz_designs.study(3, number) == fuzz_designs.study(3, number)
    one, study = fuzz_designs.study(3, 1)
    (key, *_) = (vary["key"] for vary in tomllib.loads(study.decode())["vary"])
    assert key in one.changes[-1]


@pytest.mark.slow
def test_the_independent_driver_finds_a_false_ready(tmp_path):
    """A cloud that is 0.02 % too large, and an outline with another wheel, are not what a ready cam has."""
    design = packaged_designs()["s_course"]
    assert Design.load("s_course").cam("actual").write(tmp_path, formats=["xyz"])
    assert not list(fuzz_truth.judge(design, (), tmp_path, 0))
    other = "car.outline.wheel_diameter_mm=60"
    assert [fault[:39] for fault in fuzz_truth.judge(design, [other], tmp_path, 0)] == [
        "a false ready: a drive wheel of 137.6 mm"[:39]
    ]
    (cloud,) = tmp_path.glob("*.xyz")
    points = np.loadtxt(cloud, comments="#")
    np.savetxt(cloud, points * [1.0002, 1.0002, 1.0], fmt="%.6f")
    for code, words in ((0, "a false ready"), (1, "not as the manifest says")):
        (fault,) = fuzz_truth.judge(design, (), tmp_path, code)
        assert fault.startswith(f"{words}: a waypoint is missed by")


def test_an_exit_code_that_does_not_follow_the_verdict_is_a_fault():
    printed = json.dumps({"verdict": {"readiness": "not-ready"}})
    assert "exit code 0 for not-ready" in fuzz.judge("check", 0, "", printed, 1.0, 1e5, as_json=True)
    assert not list(fuzz.judge("check", 1, "", printed, 1.0, 1e5, as_json=True))


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
