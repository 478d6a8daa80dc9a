"""Made records of steered vehicles, with their truths: `python -m tests.studies.benchmark.make` writes them anew.

A vehicle with a steered and driven front wheel is integrated in steps of 0.2 mm along the front wheel's way: its rear
axle's centre goes cos(d) ds ahead and turns by sin(d) ds / L. What is logged is not what is: the angle is
d = gain * logged + zero, the way (1 + radius) * logged, the wheelbase (1 + base) * 150 mm.
"""

import json

import numpy as np

from tests.studies.benchmark.score import HERE, tasks

WHEELBASE, NOISE_MM = 150.0, 1.0
STEP = 0.2
# deg, %, %, %; tolerances of the benchmark
TOLERANCES = {"steering zero": 0.1, "wheelbase": 1.0, "wheel radius": 0.5, "steering gain": 1.0}
VEHICLES = {
    "steered_1": {"steering zero": 1.2, "wheel radius": -1.5},
    "steered_2": {"wheelbase": 4.0},
    "steered_3": {"steering zero": -0.8, "steering gain": 3.0},
}


def run(truth: dict, rng: np.random.Generator, wave: float, bias: float) -> np.ndarray:
    """Rows of one run: way and angle as logged, place and heading as measured; mm and degrees.

    Args:
        truth: what is off.
        rng: source of the noise.
        wave, bias: amplitude and mean of the steering, degrees.
    """
    off = {name: truth.get(name, 0.0) for name in TOLERANCES}
    logged = np.arange(0, 3000 + STEP / 2, STEP)
    angle = bias + wave * np.sin(logged / 300.0)
    true = np.radians((1 + off["steering gain"] / 100) * angle + off["steering zero"])
    ds = STEP * (1 + off["wheel radius"] / 100)
    middle = (true[1:] + true[:-1]) / 2
    turned = np.concatenate([[0], np.cumsum(np.sin(middle) * ds / (WHEELBASE * (1 + off["wheelbase"] / 100)))])
    ahead = np.exp(1j * (turned[1:] + turned[:-1]) / 2) * np.cos(middle) * ds
    place = np.concatenate([[0], np.cumsum(ahead)])
    rows = slice(None, None, 100)
    towards = rng.normal(0, 0.3)
    pose = np.exp(1j * towards) * place + complex(*rng.normal(0, 20, 2))
    noise = NOISE_MM * (rng.standard_normal(len(logged[rows])) + 1j * rng.standard_normal(len(logged[rows])))
    seen = pose[rows] + noise
    return np.stack(
        [logged[rows] / 200, logged[rows], angle[rows], seen.real, seen.imag, np.degrees(turned[rows] + towards)], 1
    )


def main() -> None:
    """Write the records and their truths."""
    known = {name: task for name, task in tasks().items() if not name.startswith("steered")}
    for number, (name, truth) in enumerate(VEHICLES.items()):
        rng = np.random.default_rng(100 + number)
        lines = ["# made; wheelbase 150 mm", "run,t_s,distance_mm,steering_deg,x_mm,y_mm,heading_deg"]
        for count, (wave, bias) in enumerate(((25, 0), (10, 20), (10, -20), (40, 5), (15, 12), (15, -12)), 1):
            lines += [
                f"{count},{t:.2f},{s:.2f},{d:.3f},{x:.1f},{y:.1f},{h:.2f}"
                for t, s, d, x, y, h in run(truth, rng, wave, bias)
            ]
        record = HERE / "records" / f"{name}.csv"
        record.write_text("\n".join(lines) + "\n", encoding="utf-8")
        known[name] = {
            "record": f"tests/studies/benchmark/records/{name}.csv",
            "wheelbase_mm": WHEELBASE,
            "truth": {each: [truth.get(each, 0.0), TOLERANCES[each]] for each in TOLERANCES},
        }
    (HERE / "tasks.json").write_text(json.dumps(known, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
