"""Cars whose rod rubs, calibrated: `python -m tests.studies.friction_cars --cases 60 --seed 1`.

Every case is a car of the paper with 4 runs before a camera with 3 mm of noise, made by `tests.studies.friction_truth`.
`--cases` have play (0.50 to 0.96 degrees) and friction (0 to 0.4), every second of them one effect more. Half as many
again are controls: with play on a ball bearing and another effect, and without play.

Asked:

- of the cars with a friction of 0.05 or more, in how many both play and friction are named, and in how many of these
  they are told apart: named without the limit that says that they are not;
- where they are told apart, whether the return error is within 3 % and the friction within 0.03;
- whether they are told apart, and so close, where the play was measured with the rod lifted, too, within 0.01 degrees;
- whether no effect is named that the car does not have.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from tests.studies.command import PAGES, options, tell
from tests.studies.friction_truth import DEG, STEP_DEG, FrictionCar, World
from tests.studies.journal import outcomes, stamp

RUNS, NOISE_MM = 4, 3.0
PLAYS_DEG, FRICTIONS = (0.5, 0.96), (0.0, 0.4)
LEAST_APART = 0.05  # friction from which it is to be named
PLAY_BAR, FRICTION_BAR = 0.03, 0.03  # relative; absolute
LIFTED_DEG = 0.01  # standard deviation of a play that is measured with the rod lifted
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
    """Diagnosis of a car.

    Attributes:
        verdict: its class.
        play_deg, friction: as named; None if not.
        told_apart: whether both are named, without the limit that says that the data do not tell them apart.
        wrong: names that the car does not have.
        lifted: return error, friction and whether they are told apart, the play known beforehand; None if not needed.
    """

    case: Case
    verdict: str
    play_deg: float | None
    friction: float | None
    told_apart: bool
    wrong: tuple[str, ...]
    lifted: tuple[float, float, bool] | None = None

    @property
    def close(self) -> bool:
        return (
            self.play_deg is not None and self.friction is not None and _close(self.case, self.play_deg, self.friction)
        )


def _close(case: Case, play_deg: float, friction: float) -> bool:
    return abs(play_deg / case.car.play_deg - 1) <= PLAY_BAR and abs(friction - case.car.friction) <= FRICTION_BAR


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
    from cadgen.inference.measurement.diagnosis import calibrate

    made = case(seed, number, cases)
    world, nominal = _bench()
    record = world.record(made.car, np.random.default_rng([seed, number, 1]), runs=RUNS, noise_mm=NOISE_MM)
    play, friction, apart, told = _named(calibrate([record], nominal))
    has = {made.other} | ({"backlash"} if made.car.play else set())
    has |= {"sliding friction"} if made.car.play and made.car.friction > 0 else set()
    lifted = None
    if made.car.play and made.car.friction >= LEAST_APART and not apart:
        off = float(np.random.default_rng([seed, number, 2]).normal(0, LIFTED_DEG))
        known = replace(nominal, play=((made.car.play_deg + off) * DEG, LIFTED_DEG * DEG))
        again = _named(calibrate([record], known))
        lifted = (again[0] or np.nan, again[1] or np.nan, again[2])
    wrong = tuple(name for name in told.judgement.claimed if name not in has)
    return Outcome(made, told.verdict, play, friction, apart, wrong, lifted)


def _named(told):
    """Return error (deg) and friction that are named, and whether they are told apart."""
    (one,) = told
    values = {v.name: v.value for f in one.findings if f.effect in one.judgement.claimed for v in f.values}
    play, friction = values.get("return_error_deg"), values.get("friction")
    both = play is not None and friction is not None
    return play, friction, both and not any("not told apart" in limit for limit in one.judgement.limits), one


@cache
def _bench():
    from cadgen.inference.measurement.nominal import Nominal
    from tests.conftest import build

    built = build("carbon_free_car")
    nominal = Nominal(
        lift=built.lift, follower=built.follower, profile=built.actual.curve, car=built.car, track=built.track
    )
    return World(built), nominal


def kept(seed: int, number: int, cases: int) -> dict[str, Any]:
    """The outcome of a case as what a journal holds."""
    return asdict(judged(seed, number, cases))


def run(seed: int, cases: int, log: Path | None = None, processes: int = 1) -> list[Outcome]:
    """Every case and its controls."""
    return [
        Outcome(
            case=Case(**{**one["case"], "car": FrictionCar(**one["case"]["car"])}),
            wrong=tuple(one["wrong"]),
            lifted=one["lifted"] and tuple(one["lifted"]),
            **{name: one[name] for name in ("verdict", "play_deg", "friction", "told_apart")},
        )
        for one in outcomes(kept, [(seed, number, cases) for number in range(cases + cases // 2)], log, processes)
    ]


def page(seed: int, cases: int, found: list[Outcome]) -> str:
    """The record in Markdown."""
    rubbing = [o for o in found if o.case.number < cases and o.case.car.friction >= LEAST_APART]
    named = [o for o in rubbing if o.play_deg is not None and o.friction is not None]
    apart = [o for o in rubbing if o.told_apart]
    again = [o for o in rubbing if o.lifted is not None]
    helped = [o for o in again if o.lifted[2]]
    rows = [
        ("cars with play and friction", f"{cases}"),
        (f"of these with a friction of {LEAST_APART:g} or more", f"{len(rubbing)}"),
        ("play and friction both named", _share(named, rubbing)),
        ("told apart", _share(apart, rubbing)),
        (
            f"of those told apart within {100 * PLAY_BAR:g} % and {FRICTION_BAR:g}",
            _share([o for o in apart if o.close], apart),
        ),
        (
            "greatest error of the return error where told apart",
            f"{100 * max(map(_play_error, apart), default=0):.2f} %",
        ),
        ("greatest error of the friction where told apart", f"{max(map(_friction_error, apart), default=0):.4f}"),
        (
            "greatest friction of a car that is told apart",
            f"{max((o.case.car.friction for o in apart), default=0):.3f}",
        ),
        ("not told apart by the track, but with the play measured too", _share(helped, again)),
        (
            f"of these within {100 * PLAY_BAR:g} % and {FRICTION_BAR:g}",
            _share([o for o in helped if _close(o.case, *o.lifted[:2])], helped),
        ),
        ("told apart by the track, or with the play measured too", _share([*apart, *helped], rubbing)),
        ("control cars", f"{len(found) - cases}"),
        ("cars with a wrong name", f"{sum(bool(o.wrong) for o in found)}"),
    ]
    table = "".join(f"| {name} | {value} |\n" for name, value in rows)
    whole = "".join(
        f"| {o.case.number} | {o.case.car.play_deg:.3f}° | {o.case.car.friction:.3f} | {o.case.other or '-'} | "
        f"{o.verdict} | {_shown(o.play_deg, '°')} | {_shown(o.friction)} | {'yes' if o.told_apart else '-'} | "
        f"{_lifted(o)} | {', '.join(o.wrong) or '-'} |\n"
        for o in found
    )
    return (
        "# Study: cars whose rod rubs\n\n"
        f"Cars of the paper, {RUNS} runs each before a camera with {NOISE_MM:g} mm of noise, made by\n"
        "`tests/studies/friction_truth.py`, which steps the cam through its play by forces of its own; play\n"
        f"{PLAYS_DEG[0]:g} to {PLAYS_DEG[1]:g}°, friction {FRICTIONS[0]:g} to {FRICTIONS[1]:g}, every second with one "
        "effect more; and controls with play on a\nball bearing, and with friction and no play. Parted are play and "
        "friction where both are named without the limit\nthat says that they are not; else the car is calibrated anew "
        f"with a play known within {LIFTED_DEG:g}°.\n\n"
        f"`python -m tests.studies.friction_cars --cases {cases} --seed {seed} --record`, {stamp()}\n\n"
        f"| | |\n|---|---|\n{table}\n"
        "| car | play | friction | other effect | verdict | return error named | friction named | told apart | "
        f"with the play measured | wrong names |\n|---|---|---|---|---|---|---|---|---|---|\n{whole}"
    )


def _share(some: list, of: list) -> str:
    return f"{len(some)} ({100 * len(some) / max(len(of), 1):.0f} %)"


def _play_error(o: Outcome) -> float:
    return abs(o.play_deg / o.case.car.play_deg - 1)


def _friction_error(o: Outcome) -> float:
    return abs(o.friction - o.case.car.friction)


def _lifted(o: Outcome) -> str:
    if o.lifted is None:
        return "-"
    play, friction, apart = o.lifted
    if np.isnan(play) or np.isnan(friction):
        return "not both named"
    return f"{play:.3f}°, {friction:.3f}{'' if apart else ', not told apart'}"


def _shown(value: float | None, unit: str = "") -> str:
    return "-" if value is None else f"{value:.3f}{unit}"


def main() -> None:
    """Run, print and record."""
    chosen = options(__doc__, cases=60)
    found = run(chosen.seed, chosen.cases, chosen.log, chosen.processes)
    tell(page(chosen.seed, chosen.cases, found), PAGES / "friction_cars.md" if chosen.record else None)


if __name__ == "__main__":
    main()
