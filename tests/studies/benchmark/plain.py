"""Plain least squares of six numbers on steered vehicles: `python -m tests.studies.benchmark.plain OUT`.

Zero, gain, wheelbase, wheel radius and the markers' place on the vehicle, from nothing; start poses in closed form. A
number is claimed if it is three standard deviations from nothing, by residuals that are taken as independent.
"""

import json
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

from tests.studies.benchmark.score import rows, tasks

NAMES = ("steering zero", "steering gain", "wheelbase", "wheel radius", "ahead", "aside")
STEPS = np.array([1.0, 10.0, 10.0, 10.0, 100.0, 100.0])  # degrees, per cent, mm


def runs_of(record: str) -> dict[str, np.ndarray]:
    """Run -> way, steering and measured place of its rows, shape (n, 4)."""
    out: dict[str, list[list[float]]] = {}
    for row in rows(record):
        values = [float(row[name]) for name in ("distance_mm", "steering_deg", "x_mm", "y_mm")]
        out.setdefault(row["run"], []).append(values)
    return {name: np.array(values) for name, values in out.items()}


def path(run: np.ndarray, wheelbase: float, values: np.ndarray) -> np.ndarray:
    """Places by the numbers, in a frame of its own, x + iy.

    Args:
        run: rows of `runs_of`.
        wheelbase: as stated, mm.
        values: numbers in `NAMES`, in steps.
    """
    zero, gain, base, radius, ahead, aside = values * STEPS
    angle = np.radians((1 + gain / 100) * run[:, 1] + zero)
    ds = np.diff(run[:, 0]) * (1 + radius / 100)
    middle = (angle[1:] + angle[:-1]) / 2
    turn = np.concatenate([[0], np.cumsum(np.sin(middle) * ds / (wheelbase * (1 + base / 100)))])
    way = np.concatenate([[0], np.cumsum(np.exp(1j * (turn[1:] + turn[:-1]) / 2) * np.cos(middle) * ds)])
    return way + (ahead + 1j * aside) * np.exp(1j * turn)


def off(run: np.ndarray, wheelbase: float, values: np.ndarray) -> np.ndarray:
    """Rest of a run once its start pose is fitted, mm."""
    measured, places = run[:, 2] + 1j * run[:, 3], path(run, wheelbase, values)
    centred, own = measured - measured.mean(), places - places.mean()
    turned = np.vdot(own, centred)
    left = centred - turned / abs(turned) * own
    return np.concatenate([left.real, left.imag])


def fitted(runs: list[np.ndarray], wheelbase: float) -> tuple[np.ndarray, np.ndarray]:
    """Numbers in steps and their standard deviations."""
    best = None
    for gain in (0.0, 20.0, 45.0):  # a log in another scale has a valley of its own
        start = np.array([0, gain, 0, 0, 0, 0], dtype=float)
        result = least_squares(
            lambda values: np.concatenate([off(run, wheelbase, values) for run in runs]), start, max_nfev=60
        )
        if best is None or result.cost < best.cost:
            best = result
    assert best is not None
    noise = 2 * best.cost / (len(best.fun) - len(NAMES) - 3 * len(runs))
    return best.x, np.sqrt(noise * np.diag(np.linalg.pinv(best.jac.T @ best.jac)))


def main() -> None:
    """Answer what is about steered vehicles."""
    answers = {}
    for name, task in tasks().items():
        if "wheelbase_mm" not in task:
            continue
        runs, wheelbase = runs_of(task["record"]), task["wheelbase_mm"]
        kept = task.get("held_out", [])
        values, sigma = fitted([run for number, run in runs.items() if number not in kept], wheelbase)
        if kept:
            places = {number: path(runs[number], wheelbase, values) for number in kept}
            answers[name] = {
                "runs": {
                    number: [[round(p.real, 1), round(p.imag, 1)] for p in each] for number, each in places.items()
                }
            }
        else:
            sure = np.abs(values) > 3 * sigma
            answers[name] = {
                "numbers": {
                    each: [float(v), float(s)]
                    for each, v, s, is_sure in zip(NAMES, values * STEPS, sigma * STEPS, sure, strict=True)
                    if is_sure
                }
            }
    Path(sys.argv[1]).write_text(json.dumps({"program": "plain least squares", "answers": answers}) + "\n")


if __name__ == "__main__":
    main()
