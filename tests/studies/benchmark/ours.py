"""Answers of this package to the benchmark: `python -m tests.studies.benchmark.ours OUT` writes them."""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.api.design import Design
from cadgen.errors import CadgenError
from cadgen.inference.expectation import predict
from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.diagnosis import calibrate_logged
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.records.load import load
from tests.studies.benchmark.score import ROOT, tasks

_NUMBERS = {
    "steering_zero_deg": "steering zero",
    "gain_percent": "steering gain",
    "wheelbase_percent": "wheelbase",
    "wheel_radius_percent": "wheel radius",
}
_ERRORS = {
    "eccentricity": "eccentricity, um",
    "table": "table, um",
    "pressure-angle": "pressure angle, deg",
    "cutter": "hob run-out, um",
    "helix-angle": "helix angle, deg",
    "taper": "taper, um",
    "leaning": "leaning, deg",
}


def steered(task: dict[str, Any]) -> dict[str, Any]:
    """Numbers that are claimed of a vehicle, or its places on runs that were kept out."""
    record, wheelbase = load(ROOT / task["record"]), float(task["wheelbase_mm"])
    kept = [int(run) - 1 for run in task.get("held_out", [])]
    used = record.only(np.array([run for run in range(record.runs) if run not in kept]))
    told = calibrate_logged([used], wheelbase)
    if not kept:
        claimed = [f for f in told.findings if f.effect in told.judgement.claimed]
        return {
            "numbers": {
                _NUMBERS.get(value.name, value.name): [value.value, value.sigma] for f in claimed for value in f.values
            }
        }
    build = record.kind.model
    assert build is not None
    fitted, model = (build(one, LoggedCar(wheelbase, told.accepted)) for one in (used, record))
    active = predict.probable(fitted, told)
    places = model.path(active)  # type: ignore[attr-defined]
    return {
        "runs": {
            str(run + 1): [[round(float(p.real), 1), round(float(p.imag), 1)] for p in places[record.run == run]]
            for run in kept
        }
    }


def _train(task: dict[str, Any], pairs: list[list[int]]) -> str:
    """Design of a train of pairs."""
    width = task.get("width_mm", 8.0)
    head = f"module_mm = {task['module_mm']}\nwidth_mm = {width}\nbearing_span_mm = 40.0\ngrade = 8\n"
    stages = (f"[[train.stages]]\ndriver = {{ teeth = {a} }}\ndriven = {{ teeth = {b} }}\n" for a, b in pairs)
    return f'name = "train"\n[train]\n{head}{"".join(stages)}'


def reducer(task: dict[str, Any]) -> dict[str, Any]:
    """Run-outs of the wheels of a train."""
    text = _train(task, task["teeth"])
    facts = Design.from_toml(text, train_only=True).judge_train(ROOT / task["record"]).facts()
    return {
        "numbers": {
            f"run-out of {'driver' if part['driver'] else 'driven'} {part['stage']}, um": [
                part["eccentricity_um"],
                part["sigma_um"],
            ]
            for shaft in facts["shafts"]
            for part in shaft["parts"]
            if part["what"] == "run-out"
        }
    }


def gear(task: dict[str, Any]) -> dict[str, Any]:
    """Errors of one gear by its flank lines and spans."""
    text = _train(task, [[task["mates_with"], task["teeth"]]])
    facts = Design.from_toml(text, train_only=True).judge_gear([ROOT / each for each in task["records"]]).facts()
    clear = [each for each in facts["errors"] if abs(each["value"]) > 4 * each["sigma"]]
    return {
        "numbers": {
            **{_ERRORS[each["error"]]: [each["value"], each["sigma"]] for each in clear},
            "E_sn, um": [facts["E_sn_um"], facts["E_sn_sigma_um"]],
        }
    }


def main() -> None:
    """Answer every task."""
    if not kinds.has("steered track"):
        sys.path.insert(0, str(ROOT / "docs" / "examples" / "cadgen-tricycle" / "src"))
        from cadgen_tricycle import STEERED_TRACK

        kinds.register(STEERED_TRACK)
    by_name = {"reducer": reducer, "gear": gear}
    answers = {}
    for name, task in tasks().items():
        try:
            answers[name] = by_name.get(name, steered)(task)
        except CadgenError as error:
            print(name, error)
    Path(sys.argv[1]).write_text(json.dumps({"program": "cadgen", "answers": answers}) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
