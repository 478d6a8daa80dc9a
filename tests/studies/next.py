"""The advice on the next measurement against having measured it: `python -m tests.studies.next --cases 100 --seed 1`.

Every car has one to three effects and was measured once: by two runs before a camera of 3 to 10 mm of noise, by a dial
on the lift, or by encoders on the train. `cadgen calibrate --next` ranks what may be measured next. Then four of these
are measured, five times with other noise, each time calibrated together with the first data, and asked where the run
now ends on a new cam: the median of the five. All of the world is made by `tests.studies.circles_truth`, which shares
no code with the models.

Asked: whether the measurement that is ranked first of the four takes away as much of that distance as any of them, or
within a tenth of the best; where none takes away 5 %, whether that is said.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np

from cadgen.inference.expectation.next_measurement import proposals
from tests.studies.circles_truth import Car, World, declared, drawn_form

FIRST = ("track", "lift", "transmission")
# Beginnings of what the ranking says, and how the world measures that.
MEASURED = {
    "4 more runs of the track before a camera, the start": "track, against a stop",
    "4 runs of the track before a camera, the start": "track, against a stop",
    "4 more runs of the track before a camera": "track",
    "4 runs of the track before a camera": "track",
    "the lift by a dial, 3 runs, forward and back": "lift",
    "angles at both ends of the train, 3 runs, forward and back, the rod lifted": "train",
}
WORTH, WITHIN = 0.05, 0.10
TIMES = 5  # each measurement is made, with other noise each time


@dataclass(frozen=True)
class Outcome:
    """A car, what was ranked, and what came of it: mean distances of the end of the run, mm.

    Attributes:
        expected, found: by measurement, in the order ranked.
    """

    number: int
    first: str
    effects: str
    verdict: str
    now: float
    expected: dict[str, float]
    found: dict[str, float]

    @property
    def gained(self) -> list[float]:
        """Share of the distance that each takes away, in the order ranked."""
        return [1 - after / self.now for after in self.found.values()]

    @property
    def idle(self) -> bool:
        """Whether none is worth making."""
        return max(self.gained) < WORTH

    @property
    def said_idle(self) -> bool:
        """Whether the ranking says so of these."""
        return max(1 - after / self.now for after in self.expected.values()) < WORTH

    @property
    def right(self) -> bool:
        """Whether the first is the best or within a tenth of it; or none is worth making, which was said."""
        if self.idle:
            return self.said_idle or self.gained[0] >= max(self.gained) - WORTH
        return self.gained[0] >= (1 - WITHIN) * max(self.gained)


@cache
def _ground():
    from cadgen.design.load import load_design
    from cadgen.jobs.calibration.cam_on_car import nominal_of
    from tests.conftest import build
    from tests.inference.measurement import synthetic as syn

    built, design = build("carbon_free_car"), load_design()
    return built, syn.Car(built), design, nominal_of(design, "actual")


def _readings(world: World, car: Car, what: str, noise: float, rng: np.random.Generator):
    if what == "lift":
        return world.dial(car, rng)
    if what in ("train", "transmission"):
        return world.train(car, rng)
    if what == "track, against a stop":
        remarks = ("start set to 0.5 mm and 0.05 deg",)
        return replace(world.track(car, rng, noise_mm=noise, start=(0.5, 0.05)), remarks=remarks)
    return world.track(car, rng, noise_mm=noise)


def _now(calibration: Any, design: Any) -> float:
    """Mean distance of the end of the run on a new cam, mm; of one proposal only, for the others take time."""
    from cadgen.inference.expectation import next_measurement
    from cadgen.jobs.calibration.advice import Advice

    def few(nominal: Any, known: Any, measured: Any) -> Any:
        every = proposals(nominal, known, measured)
        return every[:1] if known else every  # all of them say which kinds of data there are

    with patch.object(next_measurement, "proposals", few):
        return float(Advice.after(calibration, design).computed.now.mean)


def measured(seed: int, number: int) -> Outcome:
    """Calibrate a car, rank what may be measured, and measure it."""
    from cadgen.jobs.calibration.advice import Advice
    from cadgen.jobs.calibration.calibration import calibrate
    from cadgen.jobs.calibration.sources import Source

    rng = np.random.default_rng([seed, number])
    built, bed, design, nominal = _ground()
    first = FIRST[number % 3]
    car = replace(Car(), **declared(rng, 1 + number // 3 % 3, "lift" if first == "lift" else "transmission"))
    world = World(built, bed, drawn_form(rng))
    noise = float(rng.uniform(3, 10)) if first == "track" else 3.0
    begun = world.track(car, rng, runs=2, noise_mm=noise) if first == "track" else _readings(world, car, first, 0, rng)

    def told(*records):
        sources = [Source(Path(f"{k}.csv"), r, f"{number}{k}") for k, r in enumerate(records)]
        return calibrate(design, "actual", sources, nominal=nominal)

    one = told(begun)
    ranking = Advice.after(one, design).computed
    expected, found = {}, {}
    for entry in ranking.ranked:
        what = next((name for words, name in MEASURED.items() if entry.words.startswith(words)), None)
        if what is None or what in expected:
            continue
        expected[what] = entry.end.mean
        made = [np.random.default_rng([seed, number, len(what), time]) for time in range(TIMES)]
        more = [_readings(world, car, what, noise, one) for one in made]
        found[what] = float(np.median([_now(told(begun, one), design) for one in more]))
    effects = ", ".join(k for k, v in vars(car).items() if v != getattr(Car(), k))
    return Outcome(number, first, effects, one.diagnoses[0].verdict, ranking.now.mean, expected, found)


def kept(seed: int, number: int) -> dict[str, Any]:
    """The same as what a journal holds."""
    return asdict(measured(seed, number))


def page(outcomes: list[Outcome], command: str) -> str:
    """The study as a page."""
    from tests.studies.journal import share, stamp

    right = sum(o.right for o in outcomes)
    worth = [o for o in outcomes if not o.idle]
    near = sum(min(o.found.values()) * (1 + WITHIN) >= next(iter(o.found.values())) for o in outcomes)
    right_share = share(right, len(outcomes))
    rows = [
        "# Study: what to measure next",
        "",
        "Cars with one to three effects, measured once, by a camera (two runs), a dial or encoders; the measurement",
        f"that is ranked first of four against having made each of the four {TIMES} times and calibrated again.",
        "Distances are those of the end of the run on a new cam, in mm, as ranked: mean expected before the",
        f"measurement, and median of the {TIMES} found after it.",
        "",
        f"`{command}`, {stamp()}",
        "",
        "| | |",
        "|---|---|",
        f"| cars | {len(outcomes)} |",
        f"| the first takes away most, or within 10 % of the best (or none takes away 5 %, as said) | {right_share} |",
        f"| of them with a measurement worth making | {sum(o.right for o in worth)} of {len(worth)} |",
        f"| distance left by the first within 10 % of the least that any leaves | {near} |",
        "",
        "| car | first data | effects | verdict | now | measurement: expected, found | |",
        "|---|---|---|---|---|---|---|",
    ]
    for o in outcomes:
        each = "; ".join(f"{name}: {_mm(o.expected[name])}, {_mm(o.found[name])}" for name in o.found)
        right_words = "" if o.right else "not the best"
        rows.append(f"| {o.number} | {o.first} | {o.effects} | {o.verdict} | {_mm(o.now)} | {each} | {right_words} |")
    return "\n".join(rows) + "\n"


def _mm(size: float) -> str:
    return f"{size:.0f}" if size >= 10 else f"{size:.1f}"


def main() -> None:
    """Run the study."""
    from tests.studies.command import PAGES, options, tell
    from tests.studies.journal import outcomes

    chosen = options(__doc__, cases=100)
    keys = [(chosen.seed, number) for number in range(chosen.cases)]
    found = [Outcome(**one) for one in outcomes(kept, keys, chosen.log, chosen.processes)]
    command = f"python -m tests.studies.next --cases {chosen.cases} --seed {chosen.seed} --record"
    tell(page(found, command), PAGES / "next.md" if chosen.record else None)


if __name__ == "__main__":
    main()
