"""Kinds of effects that no catalogue has, on the cars and benches of `tests.studies.circles_truth`.

Each changes what that world makes at one place: the car's dimensions, the form of the disc, the steps of the path, what
the dial shows, the angle of the camshaft, or the points of the measuring machine. Nothing here is shared with the
models under test.
"""

from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.interpolate import PchipInterpolator

from cadgen.inference.measurement.record import Record
from tests.inference.measurement.synthetic import DEG, TURN
from tests.inference.measurement.synthetic import Car as Bed
from tests.studies.circles_truth import CELLS, MOTOR, WAY, Car, World

Change = Callable[[np.ndarray], np.ndarray]
NOISE = {"track": 3.0, "lift": 4e-3, "transmission": 0.03, "profile": 3e-3}  # mm; of a train degrees
_RISING = np.repeat([1.0, -1.0], 341)  # sense of `WAY`
_TURNED = MOTOR / 45 * DEG
_SHARE = np.arange(CELLS) / CELLS  # of a run's turn that is over at each cell


def same(values: np.ndarray) -> np.ndarray:
    """Values as they are."""
    return values


@dataclass(frozen=True)
class Odd:
    """Changes that one size of an effect makes.

    Attributes:
        car: fields of the car.
        form: normal offset of the outline by polar angle, mm, shape (3600,).
        path: factor of each step of the path by the path, complex: travel and heading.
        place: path as the camera sees it, by the path.
        shown, turned: of what is read on `WAY` and at `MOTOR`, mm and degrees.
        points: of the measuring machine, x + iy, by the share of the run.
    """

    car: Mapping[str, Any] = field(default_factory=dict)
    form: np.ndarray = field(default_factory=lambda: np.zeros(3600))
    path: Change | None = None
    place: Change = same
    shown: Change = same
    turned: Change = same
    points: Callable[[np.ndarray, np.ndarray], np.ndarray] = lambda place, share: place


class OddWorld(World):
    """A world in which something is at work that no catalogue has."""

    def __init__(self, built: Any, bed: Bed, form: np.ndarray) -> None:
        super().__init__(built, bed, form)
        self.odd = Odd()

    def made(self, odd: Odd) -> "OddWorld":
        """This world with something odd; what it knows of its discs is kept where the form stays."""
        world = OddWorld(self.built, self.bed, self.form + odd.form) if odd.form.any() else copy(self)
        world.odd = odd
        return world

    def path(self, car: Car) -> np.ndarray:
        """Places of the drive wheel, each step longer and turned as the effect has it."""
        path = super().path(car)
        if self.odd.path is not None:
            path = path[0] + np.concatenate([[0], np.cumsum(np.diff(path) * self.odd.path(path))])
        return self.odd.place(path)

    def shown(self, car: Car) -> np.ndarray:
        """Readings of the dial on `WAY`, mm."""
        return self.odd.shown(super().shown(car))

    def turned(self, car: Car) -> np.ndarray:
        """Angles of the camshaft at `MOTOR`, degrees."""
        return self.odd.turned(super().turned(car))

    def profile(self, car: Car, rng: np.random.Generator) -> Record:
        """The outline, measured point by point."""
        record = super().profile(car, rng)
        x, y = (np.asarray(record.columns[name]) for name in ("x_mm", "y_mm"))
        count = len(x) // record.runs
        place = self.odd.points(x + 1j * y, np.tile(np.arange(count) / count, record.runs))
        return replace(record, columns={"x_mm": np.round(place.real, 4), "y_mm": np.round(place.imag, 4)})

    def measure(self, data: str, car: Car, rng: np.random.Generator) -> Record:
        """A record of a kind of data."""
        of = {"track": self.track, "lift": self.dial, "transmission": self.train, "profile": self.profile}
        return of[data](car, rng)

    def clean(self, data: str, car: Car) -> np.ndarray:
        """Readings of a kind of data but for noise and the places of points: mm or degrees, shape (n,)."""
        if data == "track":
            place = self.path(car)[: CELLS * 340 // 360 : 40]
            return np.concatenate([place.real, place.imag])
        if data == "profile":
            points = self.bed.disc(self.bench(car))[::20]
            place = self.odd.points(points[:, 0] + 1j * points[:, 1], np.arange(len(points)) / len(points))
            return (place * np.conj(self.bed.normal[::20] @ np.array([1, 1j]))).real
        return self.shown(car) if data == "lift" else self.turned(car)

    def seen(self, data: str, car: Car, plain: np.ndarray) -> float:
        """RMS of what a record shows beside `plain`, over its noise: less start pose, zero or clocking."""
        off, free = self.clean(data, car) - plain, np.ones((len(plain), 1))
        if data == "track":
            x, y = plain.reshape(2, -1)
            one = np.ones_like(x)
            free = np.concatenate([np.stack([one, 0 * x, -y], axis=1), np.stack([0 * x, one, x], axis=1)])
        elif data == "profile":
            free = _clocked(self.bed)
        off = off - free @ np.linalg.lstsq(free, off, rcond=None)[0]
        return float(np.sqrt(np.mean(off**2)) / NOISE[data])


def _clocked(bed: Bed) -> np.ndarray:
    """Normal offset of the outline for a small turn of the disc on the machine, shape (n, 1)."""
    x, y = bed.points[::20].T
    return (np.stack([-y, x], axis=1) * bed.normal[::20]).sum(axis=1)[:, None]


@dataclass(frozen=True)
class OddKind:
    """A kind of effect.

    Attributes:
        data: kinds of data that show it.
        draw: places and phases, then what a size makes of them.
        most: greatest size.
        signed: whether it may have either sign.
        beside: field of the car without which it does nothing; empty if there is none.
        grows: effects of the catalogue that it is at a size which changes in the run, by their names: from nothing to
            so many rad or mm, or such a share, for a size of 1. A flat spot takes its share off the radius.
        twin: of an effect of the catalogue, as that states it; empty if there is none.
    """

    data: tuple[str, ...]
    draw: Callable[[np.random.Generator], Callable[[float], Odd]]
    most: float
    signed: bool = True
    beside: str = ""
    grows: Mapping[str, float] = field(default_factory=dict)
    twin: str = ""


def _fixed(make: Callable[[float], Odd]) -> Callable[[np.random.Generator], Callable[[float], Odd]]:
    return lambda rng: make


def _car(name: str) -> Callable[[np.random.Generator], Callable[[float], Odd]]:
    return _fixed(lambda k: Odd(car={name: k}))


def _dent(rng: np.random.Generator) -> Callable[[float], Odd]:
    where = rng.uniform(20, 320) * DEG
    return lambda k: Odd(car={"dent": (k, where)})


# Steps of the path: 1 + a is a share of travel more, 1 + ib a heading that is off by b while it goes there.


def _turned_anew(path: np.ndarray, change: Change) -> np.ndarray:
    """Factors of the steps for a path whose turn in each step is another."""
    heading = np.unwrap(np.angle(np.diff(path)))
    turn = np.diff(heading, prepend=heading[0])
    return np.exp(1j * np.cumsum(change(turn) - turn))


def _travelling(path: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Factors of the steps where the drive wheel goes a share of its way: the car turns by that share, too."""
    return share * _turned_anew(path, lambda turn: share * turn)


def _travelled(path: np.ndarray) -> np.ndarray:
    """Travel before each step, mm."""
    return np.concatenate([[0], np.cumsum(np.abs(np.diff(path)))])[:-1]


def _rippled_floor(rng: np.random.Generator) -> Callable[[float], Odd]:
    length, phase = rng.uniform(400, 3000), rng.uniform(0, TURN)
    return lambda k: Odd(path=lambda path: 1 + 1j * k * np.sin(TURN * path[:-1].real / length + phase))


def _flat_spot(rng: np.random.Generator) -> Callable[[float], Odd]:
    at = rng.uniform(0, 1)
    return lambda k: Odd(path=lambda path: _travelling(path, 1 - k * (np.abs((45 * _SHARE - at) % 1 - 0.5) < 0.06)))


def _slips_at_start(rng: np.random.Generator) -> Callable[[float], Odd]:
    over = rng.uniform(100, 1000)

    def factors(path: np.ndarray, k: float) -> np.ndarray:
        return _travelling(path, 1 - np.minimum(k / over, 0.9) * np.exp(-_travelled(path) / over))

    return lambda k: Odd(path=lambda path: factors(path, k))


def _post(rng: np.random.Generator) -> Callable[[float], Odd]:
    at = rng.uniform(0.1, 0.8)
    return lambda k: Odd(path=lambda path: np.exp(1j * k * (at < _SHARE)))


def _carpet(rng: np.random.Generator) -> Callable[[float], Odd]:
    first, wide = rng.uniform(0.1, 0.5), rng.uniform(0.1, 0.3)
    return lambda k: Odd(path=lambda path: _travelling(path, 1 + k * (np.abs(_SHARE - first - wide / 2) < wide / 2)))


def _relaxed(turn: np.ndarray, share: float) -> np.ndarray:
    out, now = np.empty(len(turn)), turn[1]
    for i, asked in enumerate(turn.tolist()):
        now += (asked - now) * share
        out[i] = now
    return out


def _relaxing_tyre(rng: np.random.Generator) -> Callable[[float], Odd]:
    step = 18006.0 / CELLS  # mm of travel
    return lambda k: Odd(path=lambda path: _turned_anew(path, lambda turn: _relaxed(turn, step / (step + k))))


def _dragged(turn: np.ndarray, width: float) -> np.ndarray:
    out, now = np.empty(len(turn)), turn[1]
    for i, asked in enumerate(turn.tolist()):
        now = min(max(now, asked - width / 2), asked + width / 2)
        out[i] = now
    return out


def _loose_fork(rng: np.random.Generator) -> Callable[[float], Odd]:
    """The fork has play in its bearing: its curvature stays until the rod has gone through it."""
    step = 18006.0 / CELLS / 167.0  # turn of a step for each unit of tan(beta)
    return lambda k: Odd(path=lambda path: _turned_anew(path, lambda turn: _dragged(turn, k * step)))


def _caster(rng: np.random.Generator) -> Callable[[float], Odd]:
    """A trailing wheel swings over where the sense of turning changes, and pushes the tail aside."""
    over = rng.uniform(20, 60)

    def factors(path: np.ndarray, k: float) -> np.ndarray:
        heading = np.unwrap(np.angle(np.diff(path)))
        sense = np.sign(np.diff(heading, prepend=heading[0]))
        sense = np.where(sense == 0, 1, sense)
        pushes, now = np.zeros(len(sense)), sense[1]
        for at in np.flatnonzero(np.diff(sense[1:])) + 1:
            if sense[at + 1] != now:
                now = sense[at + 1]
                pushes[at : at + 200] += k * now / over * np.exp(-np.arange(min(200, len(pushes) - at)) / over)
        return np.exp(1j * np.cumsum(pushes))

    return lambda k: Odd(path=lambda path: factors(path, k))


def _shutter(rng: np.random.Generator) -> Callable[[float], Odd]:
    """Lines of the picture are read one after another: what is higher in it is seen later."""
    way = np.exp(1j * rng.uniform(0, TURN))

    def seen(path: np.ndarray, k: float) -> np.ndarray:
        height = (path * way.conjugate()).real
        late = k * (height - height.min()) / np.ptp(height)  # cells
        at = np.arange(CELLS + 1) - late
        return np.interp(at, np.arange(CELLS + 1), path.real) + 1j * np.interp(at, np.arange(CELLS + 1), path.imag)

    return lambda k: Odd(place=lambda path: seen(path, k))


# Readings of the dial.


def _warming_lever(rng: np.random.Generator) -> Callable[[float], Odd]:
    return lambda k: Odd(shown=lambda read: read * (1 + k * np.linspace(0, 1, len(read))))


def _sticking_rod(rng: np.random.Generator) -> Callable[[float], Odd]:
    """Dirt in one place holds the lever until the rod has gone away by so much."""
    where, wide = rng.uniform(40, 300), rng.uniform(20, 50)
    sticky = np.abs(WAY - where) < wide / 2

    def held(read: np.ndarray, k: float) -> np.ndarray:
        out, now = read.copy(), read[0]
        for i, asked in enumerate(read.tolist()):
            now = min(max(now, asked - k), asked + k) if sticky[i] else asked
            out[i] = now
        return out

    return lambda k: Odd(shown=lambda read: held(read, k))


def _pinion(rng: np.random.Generator) -> Callable[[float], Odd]:
    pitch, phase = rng.choice([1.0, 2.0, 10.0]), rng.uniform(0, TURN)
    return lambda k: Odd(shown=lambda read: read + k * np.sin(TURN * read / pitch + phase))


def _divider(rng: np.random.Generator) -> Callable[[float], Odd]:
    """A tooth of the divider's worm wheel is damaged: the angle is off about one place."""
    where = rng.uniform(20, 320)

    def off(read: np.ndarray, k: float) -> np.ndarray:
        half = len(read) // 2
        at = WAY + k * np.exp(-(((WAY - where) / 8) ** 2) / 2)
        return PchipInterpolator(WAY[:half], read[:half])(np.clip(at, WAY[0], WAY[half - 1]))

    return lambda k: Odd(shown=lambda read: off(read, k))


def _flat_rod(rng: np.random.Generator) -> Callable[[float], Odd]:
    """The rod is worn flat where it touches while the lift is nearly level."""
    wide = rng.uniform(0.1, 0.4)

    def worn(read: np.ndarray, k: float) -> np.ndarray:
        slope = np.gradient(read) / np.gradient(WAY + 1e-9 * np.arange(len(WAY)))
        slope[[340, 341]] = slope[[339, 342]]
        return read - k * np.exp(-((slope / (wide * np.abs(slope).max())) ** 2))

    return lambda k: Odd(shown=lambda read: worn(read, k))


def _loose_stand(rng: np.random.Generator) -> Callable[[float], Odd]:
    """The stand of the dial tips over while the rod is high, by so much, and back again with a delay."""
    where = rng.uniform(-0.5, 0.5)

    def tipped(read: np.ndarray, k: float) -> np.ndarray:
        level = read.mean() + where * read.std()
        over, out = False, read.copy()
        for i, asked in enumerate(read.tolist()):
            over = asked > level if not over else asked > level - 0.3 * read.std()
            out[i] += k * over
        return out

    return lambda k: Odd(shown=lambda read: tipped(read, k))


# Angles of the camshaft, degrees.


def _coarse(rng: np.random.Generator) -> Callable[[float], Odd]:
    return lambda k: Odd(turned=lambda angle: np.round(angle / max(k, 1e-6)) * max(k, 1e-6))


def _relaxing_belt(rng: np.random.Generator) -> Callable[[float], Odd]:
    """A belt gives under its drag, slowly, and anew after the turn."""
    over = rng.uniform(10, 90) * DEG

    def lag(k: float) -> np.ndarray:
        out, now = np.empty(len(_TURNED)), 0.0
        ahead = np.sign(np.diff(_TURNED, append=-1.0))
        for i, way in enumerate(ahead):
            now += (way * k - now) * (1 - np.exp(-DEG / over))
            out[i] = now
        return out

    return lambda k: Odd(turned=lambda angle: angle - lag(k))


def _universal_joint(rng: np.random.Generator) -> Callable[[float], Odd]:
    phase = rng.uniform(0, TURN)
    return lambda k: Odd(turned=lambda angle: angle + k * np.sin(2 * _TURNED + phase))


def _lost_counts(rng: np.random.Generator) -> Callable[[float], Odd]:
    """The encoder loses counts at a scratch each time it passes it forward, and none on its way back."""
    at = rng.integers(40, 320)
    return lambda k: Odd(turned=lambda angle: angle + k * (np.arange(len(angle)) > at))


# Points of the measuring machine and the outline that it measures, mm.


def _deflected(rng: np.random.Generator) -> Callable[[float], Odd]:
    """The cutter gives where it has the more to take off: a quarter and a third of the blank's outline are thicker."""
    polar, order = np.arange(3600) * TURN / 3600, rng.choice([2.5, 3.5, 4.5])
    phase = rng.uniform(0, TURN)
    return lambda k: Odd(form=k * np.maximum(np.cos(order * (polar - np.pi) + phase), 0) ** 2)


def _chatter(rng: np.random.Generator) -> Callable[[float], Odd]:
    """The cutter chatters in a part of the turn."""
    polar, where, wide = np.arange(3600) * TURN / 3600, rng.uniform(0, TURN), rng.uniform(20, 60) * DEG
    waves = rng.integers(50, 100)
    near = np.exp(-((np.angle(np.exp(1j * (polar - where))) / wide) ** 2))
    return lambda k: Odd(form=k * near * np.sin(waves * polar))


def _warming_machine(rng: np.random.Generator) -> Callable[[float], Odd]:
    return lambda k: Odd(points=lambda place, share: place * (1 + k * share))


def _slipped_clamp(rng: np.random.Generator) -> Callable[[float], Odd]:
    at, way = rng.uniform(0.2, 0.8), np.exp(1j * rng.uniform(0, TURN))
    return lambda k: Odd(points=lambda place, share: place + k * way * (share > at))


KINDS = {
    "understeer": OddKind(("track",), _car("understeer"), 2.0),
    "drifting zero": OddKind(("track",), _car("drifting"), 1.0 * DEG, grows={"steering zero": 1.0}),
    "wheel wear": OddKind(("track",), _car("wear"), 0.02, grows={"wheel radius": -1.0}),
    "growing friction": OddKind(
        ("track",), _car("rubs"), 1.0, signed=False, beside="play", grows={"sliding friction": 1.0}
    ),
    "edge worn on one flank": OddKind(("track",), _car("flank"), 0.02),
    "bounce": OddKind(("track",), _car("bounce"), 0.05, signed=False),
    "bent rod": OddKind(("track",), _car("bends"), 0.1, grows={"lever gain": 1.0}),
    "cogging": OddKind(("transmission",), _car("cogs"), 0.5 * DEG),
    "damaged tooth": OddKind(("track", "transmission"), _car("tooth"), 2.0 * DEG),
    "dent": OddKind(("track", "lift", "profile"), _dent, 0.3),
    "spiral tool wear": OddKind(
        ("track", "lift", "profile"), _car("spiral"), 0.1, grows={"cutter compensation": 1.0, "rod radius": 1.0}
    ),
    "rippled floor": OddKind(("track",), _rippled_floor, 0.1),
    # 19 or 20 of the 160 cells of a turn are flat.
    "flat spot of the tyre": OddKind(("track",), _flat_spot, 0.3, signed=False, grows={"wheel radius": -0.125}),
    "slip at the start": OddKind(("track",), _slips_at_start, 200.0, signed=False),
    "post that is hit": OddKind(("track",), _post, 5.0 * DEG),
    "strip of carpet": OddKind(("track",), _carpet, 0.05),
    "tyre that relaxes": OddKind(
        ("track",), _relaxing_tyre, 150.0, signed=False, twin="a tyre that follows the steering late"
    ),
    "loose fork": OddKind(("track",), _loose_fork, 0.05, signed=False),
    "caster that swings over": OddKind(("track",), _caster, 3.0 * DEG),
    "rolling shutter": OddKind(("track",), _shutter, 40.0),
    "lever that warms up": OddKind(("lift",), _warming_lever, 0.05, grows={"lever gain": 1.0}),
    "sticking rod": OddKind(("lift",), _sticking_rod, 0.3, signed=False),
    "eccentric pinion of the dial": OddKind(("lift",), _pinion, 0.1),
    "damaged tooth of the divider": OddKind(("lift",), _divider, 1.0),
    "flat on the rod": OddKind(("lift",), _flat_rod, 0.2, signed=False),
    "dial stand that tips": OddKind(("lift",), _loose_stand, 0.2),
    "coarse encoder": OddKind(("transmission",), _coarse, 3.0, signed=False),
    "belt that relaxes": OddKind(("transmission",), _relaxing_belt, 2.0, signed=False),
    "universal joint": OddKind(("transmission",), _universal_joint, 1.0),
    "lost counts": OddKind(("transmission",), _lost_counts, 2.0),
    "cutter that gives": OddKind(("profile", "lift"), _deflected, 0.1),
    "chatter": OddKind(("profile", "lift"), _chatter, 0.05, signed=False),
    "machine that warms up": OddKind(("profile",), _warming_machine, 0.003, grows={"uniform scale": 1.0}),
    "slipped clamp": OddKind(("profile",), _slipped_clamp, 0.1, signed=False),
}
