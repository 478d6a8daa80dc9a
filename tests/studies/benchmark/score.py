"""Scorer of answers to the benchmark: `python tests/studies/benchmark/score.py ANSWERS.json ...`; no package is needed.

An answer gives numbers of a task with their standard deviations, and leaves out what it does not claim; or places on
runs that were kept out, in any frame. What does not answer a task as asked is refused, for all of it.

Numbers are scored as normal distributions by their continuous ranked probability score (Gneiting and Raftery, JASA 102
(2007) 359-378), in tolerances: in expectation only what a program believes is best, whatever it states else. A number
that is left out is claimed to be nothing. The skill is 1 for the truth, 0 for an answer that claims nothing, and below
0 for one that is worse than that. Beside it stand counts: a number is found if it errs by no more than the greater of
the task's tolerance and three of its standard deviations, of which none counts for more than the tolerance; else it is
off, and what is claimed and is not there is wrong.
"""

import csv
import json
import math
import sys
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[2]
MOST = 1e9  # greatest size of a number or place


class AnswerError(Exception):
    """Answer that does not answer the task."""


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


def crps(mean: float, sigma: float, truth: float) -> float:
    """Continuous ranked probability score of a normal distribution, in the unit of the number; 0 is best.

    Args:
        mean, sigma: of the distribution.
        truth: what is so.
    """
    z = (truth - mean) / sigma
    density = math.exp(-z * z / 2) / math.sqrt(2 * math.pi)
    return sigma * (z * math.erf(z / math.sqrt(2)) + 2 * density - 1 / math.sqrt(math.pi))


def judged_numbers(task: dict, answer: dict) -> dict:
    """Skill, and numbers found, off, wrong and missed, and how often the stated range holds.

    Args:
        task: one with `truth`: name -> value and tolerance.
        answer: name -> value and standard deviation.
    """
    found, off, wrong, held, given = 0, 0, 0, 0, 0
    claimed, nothing = 0.0, 0.0
    for name, (value, tolerance) in task["truth"].items():
        nothing += abs(value) / tolerance
        if name not in answer:
            claimed += abs(value) / tolerance
            continue
        stated, sigma = answer[name]
        claimed += crps(stated, sigma, value) / tolerance
        counted = max(tolerance, 3 * min(sigma, tolerance))
        near = abs(stated - value) <= counted
        if value:
            given += 1
            held += abs(stated - value) <= 2 * sigma
            found += near and abs(stated) > 3 * sigma
            off += not near
        else:
            wrong += not near
    # Whatever its size: it is not there, and nobody knows what size would be small.
    wrong += sum(name not in task["truth"] for name in answer)
    return {
        "skill": round(1 - claimed / nothing, 3),
        "found": found,
        "of": sum(bool(value) for value, _ in task["truth"].values()),
        "off": off,
        "wrong": wrong,
        "within two sigma": f"{held} of {given}",
    }


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
            raise AnswerError(f"run {run} has {len(places)} places for {len(measured)} rows: give one for each row")
        errors.append(rms_after_pose(measured, places))
    return {"rms mm": round(sum(errors) / len(errors), 1)}


def checked(answers: object) -> dict:
    """Answers as they were read, once all entries are such as the tasks ask for.

    Args:
        answers: value of a JSON file.

    Raises:
        AnswerError: an entry is none, in one sentence.
    """
    if not isinstance(answers, dict) or set(answers) != {"program", "answers"}:
        raise AnswerError('the file must hold {"program": name, "answers": {task: answer}} and nothing else')
    if not isinstance(answers["program"], str) or not answers["program"].isprintable() or len(answers["program"]) > 60:
        raise AnswerError("program must be a name of at most 60 letters on one line")
    if not isinstance(answers["answers"], dict):
        raise AnswerError('answers must be {task: {"numbers": {...}}} or {task: {"runs": {...}}}')
    known = tasks()
    for name, answer in answers["answers"].items():
        if name not in known:
            raise AnswerError(f"there is no task {name[:40]!r}: the tasks are {', '.join(known)}")
        key = "numbers" if "truth" in known[name] else "runs"
        if not isinstance(answer, dict) or set(answer) != {key} or not isinstance(answer[key], dict):
            raise AnswerError(f'{name}: the answer must be {{"{key}": {{...}}}}')
        if key == "numbers":
            for each, pair in answer[key].items():
                if not _is_pair(pair) or not pair[1] > 0:
                    raise AnswerError(
                        f"{name}, {each[:40]!r}: give its value and its standard deviation above 0, two numbers of at "
                        f"most {MOST:g}"
                    )
            continue
        if set(answer[key]) != set(known[name]["held_out"]):
            raise AnswerError(f"{name}: give places for runs {', '.join(known[name]['held_out'])}, and for no others")
        for run, places in answer[key].items():
            if not isinstance(places, list) or not all(_is_pair(place) for place in places):
                raise AnswerError(f"{name}, run {run}: each place must be [x, y] in mm, numbers of at most {MOST:g}")
    return answers


def _is_pair(pair: object) -> bool:
    return (
        isinstance(pair, list)
        and len(pair) == 2
        and all(isinstance(each, (int, float)) and not isinstance(each, bool) and abs(each) <= MOST for each in pair)
    )


def score(answers: object) -> dict[str, dict]:
    """Score of each task that was answered.

    Args:
        answers: `{"program": name, "answers": {task: {"numbers": {...}} or {"runs": {...}}}}`.

    Raises:
        AnswerError: an entry is none.
    """
    given, out = checked(answers)["answers"], {}
    for name, task in tasks().items():
        if name in given:
            try:
                out[name] = (
                    judged_numbers(task, given[name]["numbers"])
                    if "truth" in task
                    else judged_runs(task, given[name]["runs"])
                )
            except AnswerError as error:
                raise AnswerError(f"{name}, {error}") from None
    return out


def _once(pairs: list[tuple[str, object]]) -> dict:
    once = {}
    for name, value in pairs:
        if name in once:
            raise AnswerError(f"{name[:40]!r} is given twice: leave one")
        once[name] = value
    return once


def read(file: str) -> object:
    """Value of a JSON file.

    Args:
        file: path.

    Raises:
        AnswerError: it cannot be read, is no JSON, or has a name twice.
    """
    try:
        return json.loads(Path(file).read_text(encoding="utf-8"), object_pairs_hook=_once)
    except (OSError, ValueError, RecursionError) as error:
        raise AnswerError(f"it cannot be read as JSON: {str(error)[:120]}") from None


def main() -> int:
    """Print the scores of the files that are named; 2 where one is no answer."""
    for file in sys.argv[1:]:
        try:
            answers = read(file)
            figures = score(answers)
        except AnswerError as error:
            print(f"{file}: {error}", file=sys.stderr)
            return 2
        print(answers["program"])
        for name in tasks():
            told = figures.get(name)
            text = "not answered" if told is None else ", ".join(f"{key} {value}" for key, value in told.items())
            print(f"  {name:12s}", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
