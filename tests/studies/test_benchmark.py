"""Benchmark: its scorer on answers by hand, its records made anew, and its converter."""

import ast
import cmath
import sys

import numpy as np
import pytest

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
        else:
            assert figures[name]["rms mm"] == 0


def test_what_is_not_there_is_wrong_and_what_is_far_off_is_not_found():
    task = {"truth": {"a": [1.0, 0.1], "b": [2.0, 0.1], "c": [0.0, 0.1]}}
    told = score.judged_numbers(task, {"a": [1.05, 0.01], "b": [3.0, 0.01], "c": [1.0, 0.1], "d": [1.0, 0.1]})
    assert (told["found"], told["of"], told["wrong"]) == (1, 2, 2)
    assert told["within two sigma"] == "0 of 2"
    assert score.judged_numbers(task, {})["found"] == 0


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
