"""Made cases for studies of what is named: what is drawn, what a perfect diagnosis would say, and what was said.

`tests.studies.rates` counts several thousand of them.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from cadgen.inference.measurement.hypothesis import Hypothesis
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Record
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive

LEAST = 0.3  # of the noise: smaller effects are drawn again
COUNTS = {"none": 0, "scattered": 0, "single": 1, "strange": 1, "pair": 2, "three": 3, "four": 4}
SCATTERED_DEG = 3.0


@dataclass
class Case:
    """One synthetic record and what is in it.

    Attributes:
        sort: one of `COUNTS`.
        truth: effects, and `values` of them as the generator takes them.
        size: rms of the smallest effect, um; of a train in degrees, of a track in mm.
        noise: standard deviation, in the same unit.
        form: variance of the form error by order from 1 on, mm^2; empty where there is none.
    """

    kind: str
    sort: str
    truth: tuple[str, ...]
    size: float
    values: tuple[dict[str, Any], ...]
    record: Record
    noise: float
    form: np.ndarray


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
    truth = tuple(str(name) for name in rng.choice(names, COUNTS[sort], replace=False))
    while {"uniform scale", "anisotropic scale"} <= set(truth):  # together they are one anisotropic scale
        truth = tuple(str(name) for name in rng.choice(names, COUNTS[sort], replace=False))
    changes, sizes = [], []
    for name in truth:
        make, low, high = (way.strange if sort == "strange" else way.truths)[name]
        of, rms = make(car, rng), 0.0
        while rms < LEAST * noise:
            change = of(float(np.exp(rng.uniform(np.log(low), np.log(high)))))
            rms = _rms(way.response(car, syn.bench_with(np.zeros(1), change)) - way.response(car, syn.Bench())) * 1e3
        changes.append(change)
        sizes.append(rms)
    form, variance = syn.drawn_form(rng, syn.FORM_UM / 1e3)
    bench = syn.bench_with(form, *changes)
    record = way.make(car, bench, rng, noise_um=noise)
    return Case(kind, sort, truth, min(sizes, default=0.0), tuple(changes), record, noise, variance)


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
    truth = tuple(str(n) for n in rng.choice(sorted(table), COUNTS[sort], replace=False))
    changes, sizes = [], []
    for name in truth:
        rms = 0.0
        while rms < LEAST * noise:
            change = table[name](rng)
            rms = _drive_rms(car, kind, drive.changed(perfect, change))
        changes.append(change)
        sizes.append(rms)
    start = {"start_deg": SCATTERED_DEG} if sort == "scattered" else {}
    record = make(car, drive.changed(perfect, *changes), rng, **{keyword: noise}, **start)
    return Case(kind, sort, truth, min(sizes, default=0.0), tuple(changes), record, noise, np.empty(0))


def _drive_rms(car: syn.Car, kind: str, thing: Any) -> float:
    """RMS of an effect in the unit of the noise: degrees about its mean, or mm off the path."""
    if kind == "track":
        motor = np.arange(0, 345, 5.0) * syn.DEG
        off = thing.track(car.built, motor) - drive.Wheels().track(car.built, motor)
        return float(np.sqrt(np.mean(np.abs(off) ** 2) / 2))
    steps = np.arange(361) * 45.0
    motor = np.concatenate([steps, steps[-2::-1]]) * syn.DEG
    slope = car.built.lift.q((motor / 45) % syn.TURN, nu=1)
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


def printed(name: str, values: dict[str, Any]) -> np.ndarray:
    """Numbers that a perfect diagnosis of an effect would print, in the catalogue's units."""
    wave = name.startswith("runout")
    return np.array(_wave(values["waves"][0], 1 / syn.DEG) if wave else PRINTED[name](values))


def said_sizes(best: Hypothesis) -> dict[str, np.ndarray]:
    """Values and standard deviations of the effects of a subset by their names, in the catalogue's units."""
    return {
        effect.name: np.array(
            [(v / p.scale, s / p.scale) for p, v, s in zip(effect.parameters, values, sigma, strict=True)]
        )
        for effect, values, sigma in best.values()
    }


def sizes(case: Case, best: Hypothesis) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """True values, those found and their standard deviations of each effect that was found."""
    for name, values in zip(case.truth, case.values, strict=True):
        found = next((v for effect, v in said_sizes(best).items() if same(name, effect)), None)
        if found is not None:
            yield printed(name, values), found[:, 0], found[:, 1]


def parameter_errors(case: Case, best: Hypothesis) -> list[float]:
    """Relative error of the values of each effect that was found."""
    return [float(np.linalg.norm(have - want) / np.linalg.norm(want)) for want, have, _ in sizes(case, best)]


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def same(name: str, claim: str) -> bool:
    """Does a claim name this truth?  Lobing and waviness carry their order."""
    return claim == name or claim.startswith(name + ",")


@cache
def nominal(car: syn.Car) -> Nominal:
    """The design that all cases are measured against."""
    b = car.built
    return Nominal(
        lift=b.lift, follower=b.follower, profile=b.actual.curve, car=b.car, track=b.track, ratios=drive.RATIOS
    )
