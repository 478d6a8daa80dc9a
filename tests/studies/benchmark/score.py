"""Scorer of answers to the benchmark: `python tests/studies/benchmark/score.py ANSWERS.json ...`; no package is needed.

An answer gives numbers of a task with their standard deviations, and leaves out what it does not claim; or places on
runs that were kept out, in any frame. A number is found if it is given and errs by no more than the greater of the
task's tolerance and three of its standard deviations. What is claimed beyond both and is not there is wrong.
"""

import csv
import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[2]


def tasks() -> dict:
    """Tasks with their records and, of the made ones, truths."""
    return json.loads((HERE / "tasks.json").read_text(encoding="utf-8"))


def rows(record: str) -> list[dict[str, str]]:
    """Rows of a record as its header names them.

    Args:
        record: path from the root of the repository.
    """
    with (ROOT / record).open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def rms_after_pose(measured: list[complex], predicted: list[complex]) -> float:
    """Root mean square distance, mm, once one frame is moved and turned onto the other by least squares.

    Args:
        measured, predicted: places x + iy of one run, mm.
    """
    count = len(measured)
    middle, other = sum(measured) / count, sum(predicted) / count
    turned = sum((m - middle) * (p - other).conjugate() for m, p in zip(measured, predicted, strict=True))
    turn = turned / abs(turned) if turned else 1.0
    left = sum(abs(m - middle - turn * (p - other)) ** 2 for m, p in zip(measured, predicted, strict=True))
    return math.sqrt(left / count)


def judged_numbers(task: dict, answer: dict) -> dict:
    """Numbers found, wrong and missed, and how often the stated range holds.

    Args:
        task: one with `truth`: name -> value and tolerance.
        answer: name -> value and standard deviation.
    """
    found, wrong, held, given = 0, 0, 0, 0
    present = {name: each for name, each in task["truth"].items() if each[0]}
    for name, (value, tolerance) in task["truth"].items():
        if name not in answer:
            continue
        stated, sigma = answer[name]
        error = abs(stated - value)
        if value:
            given += 1
            held += error <= 2 * sigma
            found += error <= max(tolerance, 3 * sigma) and abs(stated) > 3 * sigma
        else:
            wrong += abs(stated) > max(tolerance, 3 * sigma)
    wrong += sum(abs(value) > 3 * sigma for name, (value, sigma) in answer.items() if name not in task["truth"])
    return {"found": found, "of": len(present), "wrong": wrong, "within two sigma": f"{held} of {given}"}


def judged_runs(task: dict, answer: dict) -> dict:
    """Mean over held-out runs of the root mean square distance, mm.

    Args:
        task: one with `record` and `held_out`.
        answer: run -> places, one for each row.
    """
    errors = []
    for run in task["held_out"]:
        mine = [row for row in rows(task["record"]) if row["run"] == run]
        measured = [complex(float(row["x_mm"]), float(row["y_mm"])) for row in mine]
        places = [complex(*place) for place in answer[run]]
        if len(places) != len(measured):
            raise SystemExit(f"run {run}: {len(places)} places for {len(measured)} rows")
        errors.append(rms_after_pose(measured, places))
    return {"rms mm": round(sum(errors) / len(errors), 1)}


def score(answers: dict) -> dict[str, dict]:
    """Score of each task that was answered.

    Args:
        answers: `{"program": name, "answers": {task: {"numbers": {...}} or {"runs": {...}}}}`.
    """
    out = {}
    for name, task in tasks().items():
        answer = answers["answers"].get(name)
        if answer is not None:
            judge = judged_numbers if "truth" in task else judged_runs
            out[name] = judge(task, answer["numbers" if "truth" in task else "runs"])
    return out


if __name__ == "__main__":
    for file in sys.argv[1:]:
        given = json.loads(Path(file).read_text(encoding="utf-8"))
        print(given["program"])
        for name, figures in score(given).items():
            print(f"  {name:12s}", ", ".join(f"{key} {value}" for key, value in figures.items()))
