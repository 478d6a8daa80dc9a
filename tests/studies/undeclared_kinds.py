"""Names for effects that no catalogue has: `python -m tests.studies.undeclared_kinds --cases 280 --seed 1`.

Every record has one effect of a kind that is in no catalogue (`tests.studies.undeclared_truth`), of a size that moves
the readings by 2 to 30 times their noise (rms), or as far as it can. Every second has one effect of the catalogue
beside it. A track has four runs and 3 mm of noise, a lift by a dial three and 4 um, a train's angles three and 0.03
degrees, a profile three and 3 um; discs have a form error of 2 um of any spectrum.

A name is *wrong* if it is claimed and moves a reading by more than the noise, and is neither what was put in nor stated
as a twin of that. Nor is a name wrong that the undeclared effect is at a size which changes in the run, as
a zero that drifts is a zero, if the number claimed is one that it passes, within two standard deviations. What is said
to be ambiguous, or something without a name, claims nothing. The most by which a wrong name moves a reading, over the
noise, stands beside it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

from cadgen.deviations.effect import Effect
from cadgen.inference.measurement.record import Record
from tests.studies.circles_truth import STEP, Car, drawn_form
from tests.studies.command import PAGES, options, tell
from tests.studies.journal import outcomes, share, stamp
from tests.studies.undeclared_truth import KINDS, NOISE, OddWorld

LEAST, MOST = 2.0, 30.0  # rms of the effect over the noise
BARS = (3, 6)  # per cent of records with a wrong name: of all, and of each kind
NAMES = {
    "zero": "steering zero",
    "gain": "lever gain",
    "radius": "wheel radius",
    "bore": "eccentric bore",
    "runs_out": "runout of shaft 2",
}
BESIDE = {
    "track": ("zero", "gain", "radius", "bore", "play"),
    "lift": ("bore",),
    "transmission": ("play", "runs_out"),
    "profile": ("bore",),
}
PLAYS = {"track": "backlash", "transmission": "return error"}

Found = dict[str, Any]


@dataclass(frozen=True)
class Drawn:
    """A case: its kind by name and data, the names that are right beside it, its size and that over the noise."""

    name: str
    data: str
    truth: tuple[str, ...]
    size: float
    seen: float
    world: OddWorld
    car: Car

    def record(self, rng: np.random.Generator) -> Record:
        """The record."""
        return self.world.measure(self.data, self.car, rng)

    def right(self, effect: Effect, values: np.ndarray, sigma: np.ndarray) -> bool:
        """Whether a claimed effect with its numbers and their standard deviations is there."""
        alike = [effect.name, *effect.twins, *(other.name for other in (effect.looks_like,) if other)]
        if {*self.truth, KINDS[self.name].twin} & set(map(str, alike)):
            return True
        most = KINDS[self.name].grows.get(str(effect.name), 0.0) * self.size
        return bool(min(most, 0.0) - 2 * sigma[0] <= values[0] <= max(most, 0.0) + 2 * sigma[0]) if most else False


def _beside(data: str, field: str, rng: np.random.Generator) -> tuple[str, dict[str, Any]]:
    """An effect of the catalogue, the one given or any, and what it changes of the car."""
    drawn, sign, turn = str(rng.choice(BESIDE[data])), rng.choice([-1, 1]), rng.uniform(0, 2 * np.pi)
    plane = np.array([np.cos(turn), np.sin(turn)])
    sizes: dict[str, Any] = {
        "zero": sign * rng.uniform(0.1, 0.8) * np.pi / 180,
        "gain": 1 + sign * rng.uniform(0.005, 0.03),
        "radius": 1 + sign * rng.uniform(0.004, 0.015),
        "bore": tuple(rng.uniform(0.015, 0.05) * plane),
        "runs_out": tuple(rng.uniform(0.1, 0.4) * np.pi / 180 * plane),
        "play": round(rng.uniform(0.3, 1.0) * np.pi / 180 / STEP),
    }
    field = field or drawn
    return PLAYS[data] if field == "play" else NAMES[field], {field: sizes[field]}


@cache
def _bed() -> Any:
    """The paper's car on its disc, which each case changes."""
    from tests.conftest import build
    from tests.inference.measurement.synthetic import Car as Bed

    return Bed(build("carbon_free_car"))


def draw(seed: int, number: int) -> Drawn:
    """A case by its number."""
    rng = np.random.default_rng([seed, number])
    name, turn = list(KINDS)[number % len(KINDS)], number // len(KINDS)
    kind = KINDS[name]
    data = kind.data[turn % len(kind.data)]
    truth, fields = _beside(data, kind.beside, rng)
    if not (kind.beside or turn // len(kind.data) % 2):
        truth, fields = "", {}
    plain, bare = OddWorld(_bed().built, _bed(), drawn_form(rng)), Car(**fields)
    make, wanted = kind.draw(rng), float(np.exp(rng.uniform(np.log(LEAST), np.log(MOST))))
    sign = float(rng.choice([-1, 1])) if kind.signed else 1.0
    nothing = plain.clean(data, bare)

    def tried(k: float) -> tuple[float, OddWorld, Car]:
        odd = make(sign * k)
        world, car = plain.made(odd), replace(bare, **odd.car)
        return world.seen(data, car, nothing), world, car

    k = kind.most
    size, world, car = tried(k)
    for _ in range(4):
        if abs(size - wanted) > 0.2 * wanted and (k < kind.most or size > wanted):
            k = min(k * wanted / size, kind.most)
            size, world, car = tried(k)
    return Drawn(name, data, (truth,) if truth else (), sign * k, size, world, car)


def judged(seed: int, number: int) -> Found:
    """A case and what was said of it."""
    from cadgen.errors import CadgenError
    from cadgen.inference.measurement.diagnosis import weigh
    from cadgen.inference.measurement.evidence import registered
    from tests.inference.measurement.study import nominal

    case = draw(seed, number)
    found: Found = {"kind": case.name, "data": case.data, "truth": list(case.truth), "size": case.seen}
    try:
        record = case.record(np.random.default_rng([seed, number, 1]))
        weighed = weigh([record], nominal(case.world.bed).model)
    except CadgenError as error:
        return found | {"refused": str(error), "verdict": "refused", "claimed": [], "said": [], "wrong": []}
    said, best, (part,) = weighed.judgement, weighed.best, weighed.joint.parts
    wrong = []
    for effect, values, sigma in best.values():
        rest = [(e, v) for e, v in best.active if e is not effect]
        change = registered(part.model, part.noise, part.residual(rest) - part.residual(best.active))
        most = float(np.abs(change).max() / part.noise.rms)
        if effect.name in said.claimed and most > 1 and not case.right(effect, values, sigma):
            wrong.append((str(effect.name), most))
    return found | {
        "verdict": str(said.verdict),
        "claimed": list(map(str, said.claimed)),
        "said": [str(e.name) for e in best.effects],
        "left": said.left,
        "wrong": wrong,
    }


def table(found: Sequence[Found]) -> Iterator[str]:
    """Shares of records with a wrong name, of all, of each kind of data and of each kind of effect."""
    yield "| | data | records | wrong names | bar | put in beside and named | other names, right or within the noise |"
    yield "|---" * 7 + "|"

    def row(words: str, some: Sequence[Found], bar: int) -> str:
        data = ", ".join(dict.fromkeys(f["data"] for f in some))
        beside = [f for f in some if f["truth"]]
        named = sum(all(t in f["claimed"] for t in f["truth"]) for f in beside)
        wrong = sum(bool(f["wrong"]) for f in some)
        others = sum(bool(set(f["claimed"]) - {*f["truth"], *dict(f["wrong"])}) for f in some)
        shares = f"{share(wrong, len(some))} | ≤ {bar} % | {named} of {len(beside)} | {others}"
        return f"| {words} | {data} | {len(some)} | {shares} |"

    yield row("all", found, BARS[0])
    for data in NOISE:
        if some := [f for f in found if f["data"] == data]:
            yield row(f"all of a {data}", some, BARS[0])
    for name in KINDS:
        if some := [f for f in found if f["kind"] == name]:
            yield row(name, some, BARS[1])


def wanting(found: Sequence[Found]) -> Iterator[str]:
    """Records with a wrong name, one a line."""
    for f in found:
        if f["wrong"]:
            wrong = ", ".join(f"{name} ({size:.1f})" for name, size in f["wrong"])
            yield (
                f"| {f['kind']} | {f['data']} | {', '.join(f['truth']) or '-'} | {f['size']:.1f} | {f['verdict']} | "
                f"{', '.join(f['said'])} | {wrong} |"
            )


def main() -> None:
    """Run, print and record."""
    chosen = options(__doc__, cases=8 * len(KINDS))
    found = outcomes(judged, [(chosen.seed, n) for n in range(chosen.cases)], chosen.log, chosen.processes)
    command = f"python -m tests.studies.undeclared_kinds --cases {chosen.cases} --seed {chosen.seed} --record"
    text = [
        "# Study: what is named when something undeclared is at work",
        "",
        *(__doc__ or "").split("\n\n", 1)[1].strip().splitlines(),
        "",
        f"`{command}`, {stamp()}",
        "",
        f"{len(found)} records of {len({f['kind'] for f in found})} kinds; in brackets what a share may be, 95 %.",
        "",
        *table(found),
        "",
        "## Wrong names",
        "",
        "Sizes are rms of the readings over their noise.",
        "",
        "| kind | data | beside it | size | verdict | best subset | wrong names |",
        "|---|---|---|---|---|---|---|",
        *wanting(found),
    ]
    tell("\n".join(text), PAGES / "undeclared_kinds.md" if chosen.record else None)


if __name__ == "__main__":
    main()
