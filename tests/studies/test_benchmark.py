"""Benchmark: its scorer on answers by hand, its records made anew, and its converter."""

import ast
import cmath
import json
import sys

import numpy as np
import pytest
from scipy.integrate import trapezoid
from scipy.stats import norm

from tests.studies.benchmark import convert, make, plain, score


def perfect():
    """Truths with small deviations, and measured places turned and moved to another frame."""
    answers = {}
    for name, task in score.tasks().items():
        if "truth" in task:
            answers[name] = {"numbers": {key: [value, 1e-3] for key, (value, _) in task["truth"].items() if value}}
        else:
            turn = cmath.exp(0.7j)
            places = {run: [] for run in task["held_out"]}
            for row in score.rows(task["record"]):
                if row["run"] in places:
                    at = turn * complex(float(row["x_mm"]), float(row["y_mm"])) + 5
                    places[row["run"]].append([at.real, at.imag])
            answers[name] = {"runs": places}
    return {"program": "by hand", "answers": answers}


def test_a_perfect_answer_has_everything_and_no_frame():
    figures = score.score(perfect())
    assert set(figures) == set(score.tasks())
    for name, task in score.tasks().items():
        if "truth" in task:
            assert (figures[name]["found"], figures[name]["wrong"]) == (figures[name]["of"], 0)
            assert figures[name]["skill"] > 0.99
        else:
            assert figures[name]["rms mm"] == 0


def test_what_is_not_there_is_wrong_and_what_is_far_off_is_not_found():
    task = {"truth": {"a": [1.0, 0.1], "b": [2.0, 0.1], "c": [0.0, 0.1]}}
    told = score.judged_numbers(task, {"a": [1.05, 0.01], "b": [3.0, 0.01], "c": [1.0, 0.1], "d": [1.0, 0.1]})
    assert (told["found"], told["of"], told["wrong"]) == (1, 2, 2)
    assert (told["off"], told["within two sigma"]) == (1, "0 of 2")
    nothing = score.judged_numbers(task, {})
    assert (nothing["found"], nothing["skill"]) == (0, 0.0)


def test_a_number_is_scored_by_the_area_between_what_is_stated_and_what_is_so():
    """CRPS by its definition: the integral of the squared difference of both distributions."""
    at = np.linspace(-60, 60, 400_001)
    for mean, sigma, truth in ((0.0, 1.0, 0.0), (1.0, 0.5, 3.0), (-2.0, 4.0, 1.0), (5.0, 0.01, 5.005)):
        below = norm.cdf(at, mean, sigma)
        area = trapezoid((below - (at >= truth)) ** 2, at)
        assert score.crps(mean, sigma, truth) == pytest.approx(area, rel=2e-3, abs=1e-4)
    assert score.crps(0.0, 1.0, 1e9) == pytest.approx(1e9)


def test_nobody_gains_by_stating_what_he_does_not_believe():
    """Expected over what a program believes, only that scores best; and deviations without end find nothing."""
    believed = norm(1.0, 0.3).ppf((np.arange(4000) + 0.5) / 4000)
    expected = {
        (mean, sigma): np.mean([score.crps(mean, sigma, truth) for truth in believed])
        for mean in (0.0, 0.8, 1.0, 1.2)
        for sigma in (1e-3, 0.1, 0.3, 0.9, 30.0)
    }
    assert min(expected, key=expected.__getitem__) == (1.0, 0.3)
    for task in (task for task in score.tasks().values() if "truth" in task):
        for size, sigma in ((0.0, 1e9), (1e6, 3.3e5), (1e-9, 1e-9)):
            told = score.judged_numbers(task, {name: [size, sigma] for name in task["truth"]})
            assert told["found"] == 0
            assert told["skill"] <= 0


@pytest.mark.parametrize(
    ("answers", "said"),
    [
        ({"gear": {"numbers": {"taper, um": [float("nan"), 1.0]}}}, "gear, 'taper, um': give its value"),
        ({"gear": {"numbers": {"taper, um": [4.0, float("inf")]}}}, "deviation above 0"),
        ({"gear": {"numbers": {"taper, um": [4.0, 0.0]}}}, "deviation above 0"),
        ({"gear": {"numbers": {"taper, um": [4.0, True]}}}, "deviation above 0"),
        ({"gear": {"numbers": {"taper, um": [4.0, 10**400]}}}, "deviation above 0"),
        ({"gear": {"numbers": {"taper, um": 4.0}}}, "deviation above 0"),
        ({"gear": {"runs": {}}}, 'gear: the answer must be {"numbers": {...}}'),
        ({"gears": {"numbers": {}}}, "there is no task 'gears'"),
        ({"circles": {"runs": {"2": []}}}, "circles: give places for runs 2, 4, 6, 8, and for no others"),
        ({"squares": {"runs": {"2": [[0, "1"]], "4": [], "6": []}}}, "squares, run 2: each place must be"),
        ({"squares": {"runs": {"2": [[0, 1]], "4": [], "6": []}}}, "squares, run 2 has 1 places for"),
        ([], "answers must be"),
    ],
)
def test_an_entry_that_is_none_is_refused_in_a_sentence(tmp_path, capsys, monkeypatch, answers, said):
    file = tmp_path / "answers.json"
    file.write_text(json.dumps({"program": "bad", "answers": answers}))
    monkeypatch.setattr(sys, "argv", ["score.py", str(file)])
    assert score.main() == 2
    told = capsys.readouterr()
    assert said in told.err
    assert (told.err.count("\n"), told.out) == (1, "")


@pytest.mark.parametrize(
    "text",
    [
        *("", "{", "[]", "[" * 100_000, "\x00"),
        *('{"program": "a\\nb", "answers": {}}', '{"answers": {}}', '{"program": "a", "program": "a"}'),
    ],
)
def test_a_file_that_holds_no_answers_is_refused(tmp_path, capsys, monkeypatch, text):
    file = tmp_path / "answers.json"
    file.write_text(text)
    monkeypatch.setattr(sys, "argv", ["score.py", str(file)])
    assert score.main() == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_the_scorer_and_the_converter_need_no_package():
    for module in (score, convert):
        with open(module.__file__, encoding="utf-8") as file:
            tree = ast.parse(file.read())
        names = {alias.name for node in ast.walk(tree) if isinstance(node, ast.Import) for alias in node.names}
        names |= {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        assert names <= set(sys.stdlib_module_names)


def test_the_made_records_are_the_generators():
    for number, (name, truth) in enumerate(make.VEHICLES.items()):
        made = make.run(truth, np.random.default_rng(100 + number), 25, 0)
        kept = [row for row in score.rows(score.tasks()[name]["record"]) if row["run"] == "1"]
        places = np.array([[float(row["x_mm"]), float(row["y_mm"])] for row in kept])
        assert places == pytest.approx(made[:, 3:5], abs=0.06)


def test_plain_least_squares_find_what_is_off():
    task = score.tasks()["steered_2"]
    runs = list(plain.runs_of(task["record"]).values())[:3]
    values, sigma = plain.fitted(runs, task["wheelbase_mm"])
    base = plain.NAMES.index("wheelbase")
    assert values[base] * plain.STEPS[base] == pytest.approx(4.0, abs=max(0.5, 4 * sigma[base] * plain.STEPS[base]))


def test_a_raw_log_is_converted():
    """A vehicle that drives 1 m straight on while its counter overflows, seen in a frame that is turned."""
    raw = [
        "time: 100.0 ticks: 8182 4294967246 model_pose: 0 0 0 tracker_pose: 1.0 2.0 1.5707963267948966",
        "nothing of interest",
        "time: 101.5 ticks: 10 50 model_pose: 1 0 0 tracker_pose: 1.0 3.0 1.5707963267948966",
    ]
    header, first, second = convert.converted("\n".join(raw))
    assert header.startswith("run,t_s,distance_mm")
    assert first.split(",") == ["1", "0.000", "0.00", "-0.044", "0.0", "0.0", "0.000"]
    _, time, way, angle, x, y, _ = second.split(",")
    assert (time, way, angle, x) == ("1.500", f"{1e3 * convert.K_TRACTION * 100 / 5000:.2f}", "0.044", "1000.0")
    assert abs(float(y)) < 0.05
