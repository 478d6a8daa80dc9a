"""How often the right effect is named: several hundred synthetic cases, from seeds that no tuning has seen.

    python -m tests.measurement.study [--cases 100] [--seed 1] [--kind all]

prints the table of docs/measurement.md.
"""

import argparse
import json
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np

from cadgen.errors import CadgenError
from cadgen.measurement.diagnose import diagnose
from cadgen.measurement.findings import EvidenceDiagnosis
from cadgen.measurement.nominal import Nominal
from cadgen.measurement.record import Record
from tests.measurement import synthetic as syn
from tests.measurement import synthetic_drive as drive

LEAST = 0.3  # of the noise: smaller effects are drawn again


@dataclass
class Case:
    """One synthetic record and what is in it."""

    kind: str
    sort: str  # single, pair, none, strange
    truth: tuple[str, ...]
    size: float  # rms of the smallest effect, um
    values: tuple[dict[str, Any], ...]
    record: Record


@dataclass
class Kind:
    """How to make and how to read one kind of data."""

    truths: syn.Truths
    strange: syn.Truths
    make: Callable[..., Record]
    response: Callable[[syn.Car, syn.Bench], np.ndarray]


def _lift_response(car: syn.Car, bench: syn.Bench) -> np.ndarray:
    degrees = np.concatenate([np.arange(0, 341, 4.0), np.arange(340, -1, -4.0)])
    direction = np.repeat([1.0, -1.0], len(degrees) // 2)
    reading = car.readings(bench, degrees * syn.DEG, direction)
    if bench.jump[2]:
        reading = reading + bench.jump[2] * (np.linspace(0, 1, len(reading)) > bench.jump[1])
    return reading - reading.mean()


def _profile_response(car: syn.Car, bench: syn.Bench) -> np.ndarray:
    return np.asarray(np.sum((car.disc(bench) - car.points) * car.normal, axis=1)[::20])


KINDS = {
    "lift": Kind(syn.LIFT_TRUTHS, syn.STRANGE_LIFT, syn.lift_record, _lift_response),
    "profile": Kind(syn.PROFILE_TRUTHS, syn.STRANGE, syn.profile_record, _profile_response),
}


def draw(car: syn.Car, kind: str, sort: str, rng: np.random.Generator) -> Case:
    """One random case."""
    if kind in DRIVES:
        return _draw_drive(car, kind, sort, rng)
    way = KINDS[kind]
    noise = float(np.exp(rng.uniform(np.log(2), np.log(20))))
    names = sorted(way.strange if sort == "strange" else way.truths)
    count = {"none": 0, "pair": 2}.get(sort, 1)
    truth = tuple(str(name) for name in rng.choice(names, count, replace=False))
    while set(truth) == {"uniform scale", "anisotropic scale"}:  # together they are one anisotropic scale
        truth = tuple(str(name) for name in rng.choice(names, count, replace=False))
    changes, sizes = [], []
    for name in truth:
        make, low, high = (way.strange if sort == "strange" else way.truths)[name]
        of, rms = make(car, rng), 0.0
        while rms < LEAST * noise:
            change = of(float(np.exp(rng.uniform(np.log(low), np.log(high)))))
            rms = _rms(way.response(car, syn.bench_with(np.zeros(1), change)) - way.response(car, syn.Bench())) * 1e3
        changes.append(change)
        sizes.append(rms)
    form = syn.form_error(rng, syn.FORM_UM / 1e3)
    bench = syn.bench_with(form, *changes)
    record = way.make(car, bench, rng, noise_um=noise)
    return Case(kind, sort, truth, min(sizes, default=0.0), tuple(changes), record)


# Perfect thing, its effects, what is strange to it, record, noise drawn between, its keyword.
DRIVES = {
    "transmission": (
        drive.Train(),
        drive.TRAINS,
        drive.STRANGE_TRAINS,
        drive.transmission_record,
        (0.01, 0.1),
        "noise_deg",
    ),
    "track": (drive.Wheels(), drive.CARS, drive.STRANGE_CARS, drive.track_record, (1.0, 10.0), "noise_mm"),
}


def _draw_drive(car: syn.Car, kind: str, sort: str, rng: np.random.Generator) -> Case:
    perfect, truths, strange, make, noises, keyword = DRIVES[kind]
    noise = float(np.exp(rng.uniform(*np.log(noises))))
    table = strange if sort == "strange" else truths
    truth = tuple(str(n) for n in rng.choice(sorted(table), {"none": 0, "pair": 2}.get(sort, 1), replace=False))
    changes, sizes = [], []
    for name in truth:
        rms = 0.0
        while rms < LEAST * noise:
            change = table[name](rng)
            rms = _drive_rms(car, kind, drive.changed(perfect, change))
        changes.append(change)
        sizes.append(rms)
    record = make(car, drive.changed(perfect, *changes), rng, **{keyword: noise})
    return Case(kind, sort, truth, min(sizes, default=0.0), tuple(changes), record)


def _drive_rms(car: syn.Car, kind: str, thing: Any) -> float:
    """RMS of an effect in the unit of the noise: degrees about its mean, or mm off the path."""
    if kind == "track":
        motor = np.arange(0, 345, 5.0) * syn.DEG
        off = thing.track(car.built, motor) - drive.Wheels().track(car.built, motor)
        return float(np.sqrt(np.mean(np.abs(off) ** 2) / 2))
    steps = np.arange(361) * 45.0
    motor = np.concatenate([steps, steps[-2::-1]]) * syn.DEG
    slope = car.built.lift.tan_beta((motor / 45) % syn.TURN, nu=1)
    off = thing.camshaft(motor, slope / np.abs(slope).max()) - motor / 45
    return float(np.std(off) / syn.DEG)


UM, PERCENT = 1e3, 100.0


def _wave(wave: tuple[float, float, float], scale: float) -> tuple[float, float]:
    """Cosine and sine amplitudes of amplitude * cos(order x - phase)."""
    return wave[1] * np.cos(wave[2]) * scale, wave[1] * np.sin(wave[2]) * scale


# What a perfect diagnosis of each truth would print, in the catalogue's units.
PRINTED: dict[str, Callable[[dict[str, Any]], tuple[float, ...]]] = {
    "eccentric bore": lambda v: (v["shift"][0] * UM, v["shift"][1] * UM),
    "phase": lambda v: (v["phase"] / syn.DEG,),
    "rod radius": lambda v: (v["rod"] * UM,),
    "lever gain": lambda v: ((v["gain"] - 1) * PERCENT,),
    "axial offset": lambda v: (v["axial"] * UM,),
    "camshaft wobble": lambda v: _wave((1, *v["wobble"]), UM),
    "lost motion by friction": lambda v: (v["friction"] * UM,),
    "backlash": lambda v: (v["play"] / syn.DEG,),
    "drift": lambda v: (v["drift"] * UM,),
    "tilted indicator": lambda v: (v["tilt"] / syn.DEG,),
    "worn nose": lambda v: (v["dent"][2] * UM, v["dent"][1] / syn.DEG),
    "cutter compensation": lambda v: (v["offset"] * UM,),
    "uniform scale": lambda v: ((v["scale"][0] - 1) * PERCENT,),
    "anisotropic scale": lambda v: ((v["scale"][0] - 1) * PERCENT, (v["scale"][1] - 1) * PERCENT),
    "lobing": lambda v: _wave(v["lobes"], UM),
    "waviness": lambda v: _wave(v["ripples"], UM),
    "machine-axis reversal": lambda v: (v["reversal"][0] * UM, v["reversal"][1] * UM),
    "return error": lambda v: (v["play"] / syn.DEG,),
    "rate": lambda v: ((v["rate"] - 1) * PERCENT,),
    "wind-up": lambda v: (v["twist"] / syn.DEG,),
    "steering zero": lambda v: (v["zero"] / syn.DEG,),
    "wheel radius": lambda v: ((v["radius"] - 1) * PERCENT,),
    "driven wheel's offset": lambda v: (v["offset"],),
    "slip with curvature": lambda v: (v["slip"] * PERCENT,),
    "cam phase": lambda v: (v["phase"] / syn.DEG,),
}


def sizes(case: Case, result: EvidenceDiagnosis) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """True values, those found and their standard deviations of each effect that was found."""
    for name, values in zip(case.truth, case.values, strict=True):
        found = next((f for f in result.findings if same(name, f.effect)), None)
        if found:
            wave = name.startswith("runout")
            want = np.array(_wave(values["waves"][0], 1 / syn.DEG) if wave else PRINTED[name](values))
            values_found = np.array([(value.value, value.sigma) for value in found.values])
            yield want, values_found[:, 0], values_found[:, 1]


def parameter_errors(case: Case, result: EvidenceDiagnosis) -> list[float]:
    """Relative error of the values of each effect that was found."""
    return [float(np.linalg.norm(have - want) / np.linalg.norm(want)) for want, have, _ in sizes(case, result)]


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def same(name: str, claim: str) -> bool:
    """Does a claim name this truth?  Lobing and waviness carry their order."""
    return claim == name or claim.startswith(name + ",")


def run(car: syn.Car, case: Case) -> EvidenceDiagnosis:
    """Diagnose one case without knowing it."""
    (told,) = diagnose([case.record], nominal(car).model)
    return told


@cache
def nominal(car: syn.Car) -> Nominal:
    """The design that all cases are measured against."""
    b = car.built
    return Nominal(
        lift=b.lift, follower=b.follower, profile=b.actual.curve, car=b.car, track=b.track, ratios=drive.RATIOS
    )


SHARES = {"single": 1.0, "none": 0.5, "strange": 0.5, "pair": 0.5}


def cases(car: syn.Car, kind: str, count: int, seed: int, sorts: Sequence[str] = tuple(SHARES)) -> Iterator[Case]:
    """As many single effects as asked, half as many pairs, none and strange."""
    for sort in sorts:
        share = SHARES[sort]
        for number in range(int(count * share)):
            yield draw(car, kind, sort, np.random.default_rng([seed, number, len(sort), len(kind)]))


@dataclass
class Tally:
    """Results over the cases of one kind or of all."""

    marks: dict[str, list[bool]] = field(default_factory=dict)
    ratios: list[float] = field(default_factory=list)
    errors: list[float] = field(default_factory=list)
    deviations: list[float] = field(default_factory=list)

    def add(self, case: Case, result: EvidenceDiagnosis) -> bool:
        """Count a case; True if its verdict is right."""
        claimed, reported = result.judgement.claimed, result.judgement.reported
        wrong = any(not any(same(t, c) for t in case.truth) for c in claimed)
        if case.sort == "none":
            marks = {"none: named": bool(claimed), "none: flagged": result.verdict != "none"}
            right = result.verdict == "none"
        elif case.sort == "strange":
            full = result.verdict in ("traced", "combination")
            marks = {"outside: claimed as traced": full, "outside: a name in a partial verdict": bool(claimed)}
            right = not claimed
        else:
            named = all(any(same(t, c) for c in claimed) for t in case.truth)
            inside = all(any(same(t, c) for c in reported) for t in case.truth)
            marks = {f"{case.sort}: named": named, f"{case.sort}: in the set": inside, f"{case.sort}: wrong": wrong}
            right = named and not wrong
            self.errors += parameter_errors(case, result)
            for want, have, sigma in sizes(case, result):
                self.deviations += np.abs((have - want) / sigma).tolist()
            self.ratios.append(result.residual.left_out.repeating / result.residual.noise)
        self.count(marks)
        return right

    def count(self, marks: dict[str, bool]) -> None:
        """Count some marks of one case."""
        for name, value in marks.items():
            self.marks.setdefault(name, []).append(value)

    def join(self, other: "Tally") -> None:
        """Take in the cases of another."""
        for name, hits in other.marks.items():
            self.marks.setdefault(name, []).extend(hits)
        self.ratios += other.ratios
        self.errors += other.errors
        self.deviations += other.deviations

    def show(self, kind: str) -> None:
        """Print the column of the table."""
        for name, hits in self.marks.items():
            print(f"{kind:12} {name:40} {np.mean(hits):7.1%} of {len(hits)}")
        wrong = [hit for name, hits in self.marks.items() if name.endswith("wrong") for hit in hits]
        if self.ratios:
            print(f"{kind:12} {'single and pair: wrong':40} {np.mean(wrong):7.1%} of {len(wrong)}")
            print(
                f"{kind:12} held out over noise: median {np.median(self.ratios):.3f}, worst {np.max(self.ratios):.3f}"
            )
            median, tail = np.median(self.errors), np.quantile(self.errors, 0.9)
            print(f"{kind:12} relative error of the parameters: median {median:.2%}, 90 % below {tail:.1%}")
            within = np.mean(np.array(self.deviations) <= 2)
            print(f"{kind:12} within two stated standard deviations: {within:.1%} of {len(self.deviations)} numbers")


def _line(case: Case, result: EvidenceDiagnosis) -> str:
    """A case in one line of JSON."""
    told = {
        "kind": case.kind,
        "error": parameter_errors(case, result) if case.sort in ("single", "pair") else [],
        "sort": case.sort,
        "truth": case.truth,
        "size": case.size,
        "verdict": result.verdict,
        "noise": result.residual.noise,
        "claimed": result.judgement.claimed,
        "reported": result.judgement.reported,
        "candidates": [(c.effects, c.score) for c in result.candidates],
    }
    return json.dumps(told) + "\n"


def main() -> None:
    """Run the study; print a line for each case that is not right, and the table."""
    from tests.conftest import build

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", default="all", choices=("all", *KINDS, *DRIVES))
    parser.add_argument("--sorts", nargs="+", default=tuple(SHARES), choices=tuple(SHARES))
    parser.add_argument("--all", action="store_true", help="print right cases too")
    parser.add_argument("--dump", help="append every case to this file as a line of JSON")
    options = parser.parse_args()
    car = syn.Car(build("carbon_free_car"))
    together = Tally()
    begin = time.perf_counter()
    for kind in (*KINDS, *DRIVES) if options.kind == "all" else (options.kind,):
        tally = Tally()
        for case in cases(car, kind, options.cases, options.seed, options.sorts):
            try:
                result = run(car, case)
            except CadgenError as error:
                tally.count({"refused": True})
                print(case.sort, case.truth, "refused:", error)
                continue
            right = tally.add(case, result)
            if options.dump:
                with open(options.dump, "a") as sink:
                    sink.write(_line(case, result))
            if not right or options.all:
                told = (case.sort, case.truth, f"{case.size:.1f} um, noise {result.residual.noise:.1f}", result.verdict)
                print(*told, result.judgement.claimed, result.judgement.reported, result.judgement.sentence[:90])
        tally.show(kind)
        together.join(tally)
    together.show("together")
    print(f"{time.perf_counter() - begin:.0f} s")


if __name__ == "__main__":
    main()
