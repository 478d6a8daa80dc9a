"""Cars whose rod rubs, calibrated: `python -m tests.studies.friction_cars --cases 60 --seed 1`.

Every case is a car of the paper with 4 runs before a camera with 3 mm of noise, made by `tests.studies.friction_truth`.
`--cases` have play (0.50 to 0.96 degrees) and friction (0 to 0.4), every second of them one effect more. Half as many
again are controls: with play on a ball bearing and another effect, and with friction, another effect and no play. Asked:

- of the cars with a friction of 0.05 or more, in how many both play and friction are named;
- where they are, whether the return error is within 3 % and the friction within 0.03;
- where they are not, whether nothing wrong is named with a size: a return error off by more than 3 % is wrong;
- no effect is named that the car does not have.
"""

from __future__ import annotations

import argparse
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from tests.studies.friction_truth import DEG, STEP_DEG, FrictionCar, World

RECORD = Path(__file__).parents[2] / "docs" / "studies" / "friction_cars.md"
RUNS, NOISE_MM = 4, 3.0
PLAYS_DEG, FRICTIONS = (0.5, 0.96), (0.0, 0.4)
LEAST_PARTED = 0.05  # friction from which it is to be named
PLAY_BAR, FRICTION_BAR = 0.03, 0.03  # relative; absolute
SORTS = ("play and friction", "with another effect", "no friction", "no play")

NAMES = {"zero": "steering zero", "radius": "wheel radius", "gain": "lever gain", "phase": "cam phase"}


@dataclass(frozen=True)
class Case:
    """A car with what is wrong with it, and what calibrate said of it."""

    number: int
    sort: str
    car: FrictionCar
    other: str = ""


@dataclass(frozen=True)
class Outcome:
    """What was named, and what of it is wrong (empty if nothing is)."""

    case: Case
    verdict: str
    play_deg: float | None
    friction: float | None
    sigma: float | None
    named: tuple[str, ...]
    fault: str

    @property
    def parted(self) -> bool:
        return self.play_deg is not None and self.friction is not None


def case(seed: int, number: int, cases: int) -> Case:
    """A car by its number: the first `cases` rub, those after them are controls."""
    rng = np.random.default_rng([seed, number])
    sort = SORTS[number % 2 if number < cases else 2 + number % 2]
    car = FrictionCar(play=round(rng.uniform(*PLAYS_DEG) / STEP_DEG), friction=float(rng.uniform(*FRICTIONS)))
    if sort == SORTS[0]:
        return Case(number, sort, car)
    if sort == SORTS[2]:
        car = replace(car, friction=0.0)
    if sort == SORTS[3]:
        car = replace(car, play=0)
    other, sign = str(rng.choice(list(NAMES))), float(rng.choice([-1, 1]))
    value = {
        "zero": sign * rng.uniform(0.1, 0.8) * DEG,
        "radius": 1 + sign * rng.uniform(0.004, 0.015),
        "gain": 1 + sign * rng.uniform(0.005, 0.03),
        "phase": round(sign * rng.uniform(0.3, 1.5) / STEP_DEG),
    }[other]
    return Case(number, sort, replace(car, **{other: value}), NAMES[other])


def judged(seed: int, number: int, cases: int) -> Outcome:
    """Drive a car and calibrate it."""
    from cadgen.measurement.nominal import calibrate

    made = case(seed, number, cases)
    world, nominal = _bench()
    record = world.record(made.car, np.random.default_rng([seed, number, 1]), runs=RUNS, noise_mm=NOISE_MM)
    (told,) = calibrate([record], nominal)
    named = told.judgement.claimed
    values = {v.name: v for f in told.findings if f.effect in named for v in f.values}
    play, friction = values.get("return_error_deg"), values.get("friction")
    has = {made.other} | ({"backlash"} if made.car.play else set())
    has |= {"sliding friction"} if made.car.play and made.car.friction > 0 else set()
    faults = [f"names {name}" for name in named if name not in has]
    if play and made.car.play and abs(play.value / made.car.play_deg - 1) > PLAY_BAR:
        faults.append(f"return error {play.value:.4f} for {made.car.play_deg:.4f}°")
    if friction and made.car.play and abs(friction.value - made.car.friction) > FRICTION_BAR:
        faults.append(f"friction {friction.value:.4f} for {made.car.friction:.4f}")
    return Outcome(
        made,
        told.verdict,
        play.value if play else None,
        friction.value if friction else None,
        friction.sigma if friction else None,
        named,
        "; ".join(faults),
    )


@cache
def _bench():
    from cadgen.measurement.nominal import Nominal
    from tests.conftest import build

    built = build("carbon_free_car")
    nominal = Nominal(
        lift=built.lift, follower=built.follower, profile=built.actual.curve, car=built.car, track=built.track
    )
    return World(built), nominal


def run(seed: int, cases: int, workers: int = 2) -> list[Outcome]:
    """Every case and its controls."""
    numbers = range(cases + cases // 2)
    if workers == 1:
        return [judged(seed, number, cases) for number in numbers]
    with ProcessPoolExecutor(workers) as pool:
        return list(pool.map(judged, [seed] * len(numbers), numbers, [cases] * len(numbers)))


def page(seed: int, cases: int, found: list[Outcome]) -> str:
    """The record in Markdown."""
    from cadgen import __version__

    rubbing = [o for o in found if o.case.number < cases and o.case.car.friction >= LEAST_PARTED]
    parted = [o for o in rubbing if o.parted]
    play = max((abs(o.play_deg / o.case.car.play_deg - 1) for o in parted), default=0.0)
    friction = max((abs(o.friction - o.case.car.friction) for o in parted), default=0.0)
    rows = [
        ("cars with play and friction", f"{cases}"),
        (f"of these with a friction of {LEAST_PARTED:g} or more", f"{len(rubbing)}"),
        ("parted: play and friction both named", f"{len(parted)} ({100 * len(parted) / len(rubbing):.0f} %)"),
        ("greatest error of the return error where parted", f"{100 * play:.2f} %"),
        ("greatest error of the friction where parted", f"{friction:.4f}"),
        ("control cars", f"{len(found) - cases}"),
        ("cars with a wrong name or size", f"{sum(bool(o.fault) for o in found)}"),
    ]
    table = "".join(f"| {name} | {value} |\n" for name, value in rows)
    whole = "".join(
        f"| {o.case.number} | {o.case.car.play_deg:.3f}° | {o.case.car.friction:.3f} | {o.case.other or '-'} | "
        f"{o.verdict} | {_shown(o.play_deg, '°')} | {_shown(o.friction)} | {o.fault or '-'} |\n"
        for o in found
    )
    return (
        "# Study: cars whose rod rubs\n\n"
        f"Cars of the paper, {RUNS} runs each before a camera with {NOISE_MM:g} mm of noise, made by\n"
        "`tests/studies/friction_truth.py`, which steps the cam through its play by forces of its own; play\n"
        f"{PLAYS_DEG[0]:g} to {PLAYS_DEG[1]:g}°, friction {FRICTIONS[0]:g} to {FRICTIONS[1]:g}, every second with one "
        "effect more; and controls with play on a\nball bearing, and with friction and no play. Wrong is an effect that "
        f"the car does not have, a return\nerror off by more than {100 * PLAY_BAR:g} %, a friction off by more than "
        f"{FRICTION_BAR:g}.\n\n"
        f"`python -m tests.studies.friction_cars --cases {cases} --seed {seed} --record`, cadgen {__version__}\n\n"
        f"| | |\n|---|---|\n{table}\n"
        "| car | play | friction | other effect | verdict | return error named | friction named | wrong |\n"
        f"|---|---|---|---|---|---|---|---|\n{whole}"
    )


def _shown(value: float | None, unit: str = "") -> str:
    return "-" if value is None else f"{value:.3f}{unit}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()
    text = page(options.seed, options.cases, run(options.seed, options.cases, options.workers))
    print(text)
    if options.record:
        RECORD.parent.mkdir(parents=True, exist_ok=True)
        RECORD.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
