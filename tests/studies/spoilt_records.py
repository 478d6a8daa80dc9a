"""The whole circle with records that something spoils: `python -m tests.studies.spoilt_records --cases 200 --log FILE`.

Cars, worlds and calibration are those of `tests.studies.circles`. Each car's records have one fault more, in turn:

- The files state a noise that is wrong by a factor of 0.2 to 5, and the camera's is 0.5 to 3 times the usual.
- One run is another car's, in cm, or set against another stop; of the track or of the second record.
- The camera's scale is off, on both axes or on one; its lens bends lines, or it looks at the floor aslant.

A camera stays at home: the new cam must not compensate what it shows. Asked: whether any new cam is worse than the old
one, and how many cars get none although a perfect one would have halved their error, or that they were better without.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from cadgen.errors import CadgenError
from cadgen.inference.measurement.record import Record
from tests.inference.measurement.synthetic import DEG
from tests.studies.circles import NEAR, WORSE, Drawn, Outcome, draw, go_round
from tests.studies.circles_truth import declared

UNITS = {"track": "mm", "lift": "mm", "transmission": "deg", "profile": "um"}
USUAL = {"track": 3.0, "lift": 4e-3, "transmission": 0.03, "profile": 3.0}


@dataclass(frozen=True)
class Case:
    """A car with a fault in its records: what was done to them, whether that was said, and what came of it."""

    fault: str
    stated: float
    named: str
    outcome: Outcome

    @property
    def needless(self) -> bool:
        """Whether it gets no cam although a perfect one would have left less than half of its error."""
        o = self.outcome
        return not o.cut and o.stays < o.before / 2 and o.before > 2 * NEAR

    @property
    def harmed(self) -> bool:
        """Whether it is farther off on the new cam than on the old one."""
        o = self.outcome
        return o.cut and o.after > max(o.before + WORSE, NEAR)


Spoil = Callable[[Drawn, Record, np.random.Generator, float], Record]


def noise_figure(drawn: Drawn, record: Record, rng: np.random.Generator, size: float) -> Record:
    """A comment line with the usual noise times a factor."""
    code = record.kind.code
    line = f"instrument: noise {USUAL[code] * size:.5f} {UNITS[code]}"
    return replace(record, remarks=(*record.remarks, line))


def other_car(drawn: Drawn, record: Record, rng: np.random.Generator, size: float) -> Record:
    """One run of a car with two other effects."""
    car = replace(drawn.car, **declared(rng, 2, drawn.second))
    world, number = drawn.world, int(rng.integers(record.runs))
    made = {"track": partial(world.track, runs=1), "lift": partial(world.dial, runs=1)}
    made |= {"transmission": partial(world.train, runs=1)}
    return _with_run(record, number, made[record.kind.code](car, rng).columns)


def in_cm(drawn: Drawn, record: Record, rng: np.random.Generator, size: float) -> Record:
    """One run of a track in cm instead of mm."""
    number = int(rng.integers(record.runs))
    odd = record.only(np.array([number])).columns
    return _with_run(record, number, odd | {name: np.asarray(odd[name]) / 10 for name in ("x_mm", "y_mm")})


def other_stop(drawn: Drawn, record: Record, rng: np.random.Generator, size: float) -> Record:
    """One run that starts elsewhere: 20 to 60 mm and 1 to 3 degrees, or the divider set 1 to 3 degrees off."""
    number = int(rng.integers(record.runs))
    odd = {name: np.asarray(column) for name, column in record.only(np.array([number])).columns.items()}
    turn = rng.choice([-1, 1]) * rng.uniform(1, 3)
    if record.kind.code == "track":
        place = odd["x_mm"] + 1j * odd["y_mm"]
        place = place[0] + (place - place[0]) * np.exp(1j * turn * DEG)
        place = place + rng.uniform(20, 60) * np.exp(1j * rng.uniform(0, 2 * np.pi))
        odd |= {"x_mm": place.real, "y_mm": place.imag}
    elif record.kind.code == "transmission":
        odd["cam_angle_deg"] = odd["cam_angle_deg"] + turn
    else:
        way = odd["cam_angle_deg"]
        half = np.flatnonzero(np.diff(way) < 0)[0] + 1
        parts = (way[:half], odd["lift_mm"][:half]), (way[half:][::-1], odd["lift_mm"][half:][::-1])
        forward, back = (np.interp(angles + turn, angles, lift) for angles, lift in parts)
        odd["lift_mm"] = np.round(np.concatenate([forward, back[::-1]]), 3)
    return _with_run(record, number, odd)


def _with_run(record: Record, number: int, odd: Any) -> Record:
    """The record with another run of as many rows in the place of one of its own."""
    mine = record.run == number
    columns = {}
    for name, column in record.columns.items():
        columns[name] = np.array(column)
        columns[name][mine] = odd[name]
    return replace(record, columns=columns)


def camera(seen: Callable[[np.ndarray, float], np.ndarray]) -> Spoil:
    """A camera that sees the place z, as a share of half its picture from the middle, elsewhere."""

    def spoilt(drawn: Drawn, record: Record, rng: np.random.Generator, size: float) -> Record:
        if record.kind.code != "track":
            return record
        x, y = (np.asarray(record.columns[name]) for name in ("x_mm", "y_mm"))
        middle = complex((x.min() + x.max()) / 2, (y.min() + y.max()) / 2)
        half = float(np.abs(x + 1j * y - middle).max())
        place = middle + half * seen((x + 1j * y - middle) / half, size)
        return replace(record, columns={**record.columns, "x_mm": place.real.round(1), "y_mm": place.imag.round(1)})

    return spoilt


FAULTS: dict[str, Spoil] = {
    "noise figure": noise_figure,
    "another car's run": other_car,
    "run in cm": in_cm,
    "another stop": other_stop,
    "camera scale": camera(lambda z, k: z * (1 + k)),
    "camera scale of x": camera(lambda z, k: z + k * z.real),
    "lens": camera(lambda z, k: z * (1 + k * np.abs(z) ** 2)),
    "perspective": camera(lambda z, k: z / (1 + k * z.imag)),
}
RUNS = ("another car's run", "run in cm", "another stop")


def go(seed: int, number: int) -> dict[str, Any]:
    """A car whose records have a fault, as a journal holds it."""
    rng = np.random.default_rng([seed, number, 3])
    drawn = draw(seed, number)
    fault = str(rng.choice(sorted(FAULTS)))
    noise = float(np.exp(rng.uniform(np.log(0.5), np.log(3.0)))) if fault == "noise figure" else 1.0
    size = float(rng.choice([-1, 1]) * rng.uniform(0.002, 0.02))
    if fault == "noise figure":
        size = noise * float(np.exp(rng.uniform(np.log(0.2), np.log(5.0))))
    # A bad run is the track's or the other record's; a profile, of one part, is measured by a machine that knows mm.
    which = "track" if drawn.second == "profile" or fault == "run in cm" else str(rng.choice(["track", drawn.second]))
    seen: list[str] = []

    def spoil(record: Record) -> Record:
        if fault in RUNS and record.kind.code != which:
            return record
        return FAULTS[fault](drawn, record, rng, size)

    def look(told: Any) -> None:
        seen.extend(str(one) for one in told.warnings)
        seen.extend(str(limit) for d in told.diagnoses for limit in d.judgement.limits)

    try:
        outcome = go_round(seed, number, spoil=spoil, noise=noise, look=look)
    except CadgenError as error:
        ends = {"before": drawn.before, "after": drawn.before, "stays": abs(drawn.stays), "expected": drawn.before}
        words = {"verdict": "refused to read", "claimed": "", "no_cam": str(error)}
        car = {"number": number, "second": drawn.second, "effects": "", "undeclared": drawn.undeclared}
        outcome = Outcome(**car, **words, **ends, worse=0.0, refused=False)
    return {"fault": fault, "stated": size, "named": "; ".join(dict.fromkeys(seen)), "outcome": asdict(outcome)}


def page(cases: Sequence[Case], command: str) -> str:
    """The study as a page."""
    from tests.studies.journal import share, stamp

    count, outcomes = len(cases), [case.outcome for case in cases]
    made = [o for o in outcomes if o.cut]

    def row(name: str, some: Sequence[Case]) -> str:
        cut = [c.outcome for c in some if c.outcome.cut]
        out = f"{np.median([o.out for o in cut]):.1%}" if cut else "-"
        within = f"{sum(o.within for o in cut)} of {len(cut)}"
        ends = f"{sum(c.harmed for c in some)} | {sum(c.needless for c in some)}"
        return f"| {name} | {len(some)} | {ends} | {out} | {within} |"

    rows = [
        "# Study: the whole circle with spoilt records",
        "",
        "Cars as in [the study of circles](circles.md), each with one fault more in its records: a wrong figure of",
        "the noise, a bad run, or a camera that is off. *Harmed*: farther off on the new cam than on the old one, by",
        f"more than {WORSE:g} mm and beyond {NEAR:g} mm. *Without need*: no cam, although a perfect one would have",
        "halved the error. In brackets what a share may be, 95 %.",
        "",
        f"`{command}`, {stamp()}",
        "",
        "| | | asked |",
        "|---|---|---|",
        f"| cars | {count} | 200 |",
        f"| harmed | {sum(c.harmed for c in cases)} | 0 |",
        f"| no cam, without need | {share(sum(c.needless for c in cases), count)} | 3 % |",
        f"| end in the stated 90 % range, of cams cut | {share(sum(o.within for o in made), len(made))} | |",
        f"| gone of what a cam can take out, median of cams cut | {np.median([o.out for o in made] or [0]):.1%} | |",
        "",
        "| fault | cars | harmed | no cam without need | gone of what a cam can take out | in the range |",
        "|---|---|---|---|---|---|",
        *(row(f, some) for f in FAULTS if (some := [c for c in cases if c.fault == f])),
        "",
        "| car | fault | with | effects | undeclared | verdict | taken out | before | stays | after | expected | |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for case in cases:
        o = case.outcome
        end = "harmed" if case.harmed else "refused" if o.refused else f"no cam: {o.no_cam}" if o.no_cam else ""
        rows.append(
            f"| {o.number} | {case.fault} {case.stated:.3g} | {o.second} | {o.effects} | {o.undeclared or '-'} | "
            f"{o.verdict} | {o.claimed or '-'} | {o.before:.0f} mm | {o.stays:.0f} mm | {o.after:.0f} mm | "
            f"{o.expected:.0f} ({o.least:.0f}-{o.most:.0f}) mm | {end} |"
        )
    return "\n".join(rows) + "\n"


def main() -> None:
    """Run the study."""
    from tests.studies.command import PAGES, options, tell
    from tests.studies.journal import outcomes

    chosen = options(__doc__, cases=40)
    keys = [(chosen.seed, number) for number in range(chosen.cases)]
    found = outcomes(go, keys, chosen.log, chosen.processes)
    cases = [Case(one["fault"], one["stated"], one["named"], Outcome(**one["outcome"])) for one in found]
    command = f"python -m tests.studies.spoilt_records --cases {chosen.cases} --seed {chosen.seed} --record"
    tell(page(cases, command), PAGES / "spoilt_records.md" if chosen.record else None)


if __name__ == "__main__":
    main()
