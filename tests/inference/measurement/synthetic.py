"""Synthetic measurements by a forward model of its own.

It shares no code with the models under test: the rod is let down on dense points of the distorted outline by the
angle at which each point would stop it; profiles are sampled from the same points; camshaft and car are stepped
through reading by reading. What is drawn (form error, noise, index error, steps of the instrument) is described in
`Bench`.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from cadgen.inference.measurement.kinds import LIFT, PROFILE
from cadgen.inference.measurement.record import Record

TURN = 2 * np.pi
DEG = np.pi / 180
FORM_UM = 2.0


@dataclass
class Bench:
    """The state of the part, the mechanism and the instrument; every field at rest is a perfect one."""

    shift: tuple[float, float] = (0.0, 0.0)  # bore off centre, mm
    scale: tuple[float, float] = (1.0, 1.0)
    offset: float = 0.0  # along the normal, mm
    lobes: tuple[int, float, float] = (1, 0.0, 0.0)  # order, amplitude mm, phase
    ripples: tuple[int, float, float] = (1, 0.0, 0.0)  # waviness beside the lobes
    reversal: tuple[float, float] = (0.0, 0.0)  # lost motion of each axis, mm
    dent: tuple[float, float, float] = (0.0, 1.0, 0.0)  # polar angle, half-width, depth mm
    sector: tuple[float, float, float] = (0.0, 1.0, 0.0)  # polar angle, half-width, step of the radius mm
    rod: float = 0.0  # added radius, mm
    axial: float = 0.0
    wobble: tuple[float, float] = (0.0, 0.0)
    edge: float = 0.0  # width of the broken edges, mm: a rod at less than 45 degrees touches where the chamfer begins
    phase: float = 0.0
    gain: float = 1.0
    tilt: float = 0.0
    friction: float = 0.0
    play: float = 0.0
    drift: float = 0.0
    jump: tuple[int, float, float] = (0, 0.0, 0.0)  # run, place, mm
    square: float = 0.0  # reading + square * reading^2 / mm
    ripple: tuple[int, float, float] = (1, 0.0, 0.0)  # harmonic of the reading
    form: np.ndarray = field(default_factory=lambda: np.zeros(1))


def form_error(rng: np.random.Generator, rms: float, variance: np.ndarray | None = None) -> np.ndarray:
    """Correlated error round the turn, 3600 values: white noise smoothed over 4 to 20 degrees, or a random walk."""
    return drawn_form(rng, rms, variance)[0]


def drawn_form(
    rng: np.random.Generator, rms: float, variance: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray]:
    """A form error, and the variance that each order from 1 on has beforehand, shape (1800,), adding up to rms^2.

    The variance is drawn, too, but where that of another disc is given.
    """
    white = rng.standard_normal(3600)
    spectrum = np.fft.rfft(white)
    order = np.arange(len(spectrum))
    if variance is not None:
        shape = np.append(0.0, np.sqrt(variance))
    elif rng.random() < 0.5:
        shape = np.exp(-((order * rng.uniform(4, 20) * DEG) ** 2) / 2)
    else:
        shape = 1 / np.sqrt(1 + (order * rng.uniform(10, 30) * DEG) ** 2)
    shape[0] = 0
    values = np.fft.irfft(spectrum * shape)
    return values * rms / values.std(), (shape**2 / np.sum(shape**2) * rms**2)[1:]


class Car:
    """Dense points of the nominal outline and what the generator needs of the design."""

    def __init__(self, built: Any) -> None:
        outline = built.actual.curve.outline(0.025)
        keep = np.concatenate([[True], np.linalg.norm(np.diff(outline.points, axis=0), axis=1) > 1e-9])
        self.points = outline.points[keep]
        ahead = np.roll(self.points, -1, axis=0) - np.roll(self.points, 1, axis=0)
        ahead /= np.linalg.norm(ahead, axis=1)[:, None]
        self.ahead, self.normal = ahead, np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
        self.polar = np.arctan2(self.points[:, 1], self.points[:, 0]) % TURN
        self.built = built
        self._nominal: np.ndarray | None = None
        f = built.follower
        self.a, self.w, self.r = f.base_radius, (f.inner, f.outer), f.radius
        radius = np.linalg.norm(self.points, axis=1)
        # Only what no neighbour overtops can be the highest within 0.3 rad.
        tops = np.flatnonzero((radius >= np.roll(radius, 1)) & (radius >= np.roll(radius, -1)))
        self.noses = [
            float(self.polar[i])
            for i in tops
            if radius[i] == radius[np.abs((self.polar - self.polar[i] + np.pi) % TURN - np.pi) < 0.3].max()
        ]

    def disc(self, bench: Bench) -> np.ndarray:
        """The distorted outline about the bore."""
        out = np.zeros(len(self.points))
        out += bench.offset
        for order, amplitude, phase in (bench.lobes, bench.ripples):
            out += amplitude * np.cos(order * self.polar - phase)
        where, width, depth = bench.dent
        out -= depth * np.exp(-((np.angle(np.exp(1j * (self.polar - where))) / width) ** 2) / 2)
        out += np.interp(self.polar, np.arange(len(bench.form)) * TURN / len(bench.form), bench.form, period=TURN)
        where, width, step = bench.sector
        off = np.abs(np.angle(np.exp(1j * (self.polar - where))))
        out += step * (1 - np.tanh((off - width) / (2 * DEG))) / 2
        points = self.points + out[:, None] * self.normal
        points = points * np.array(bench.scale) - np.sign(self.ahead) * np.array(bench.reversal) / 2
        return points - np.array(bench.shift)

    def steering(self, bench: Bench, theta: np.ndarray) -> np.ndarray:
        """tan(beta): each point of the rim under the rod stops it at an angle; the greatest holds."""
        points = self.disc(bench)
        polar = np.arctan2(points[:, 1], points[:, 0]) % TURN
        order = np.argsort(polar)
        polar, points = polar[order], points[order]
        radius = self.r + bench.rod
        reach = 1.05 * radius / np.linalg.norm(points, axis=1).min()
        tripled = np.concatenate([polar - TURN, polar, polar + TURN])
        out = np.empty(len(theta))
        sway = bench.axial + bench.wobble[0] * np.cos(theta - bench.wobble[1])
        faces = [self.w[0] + bench.edge + sway, self.w[1] - bench.edge + sway]
        for i, angle in enumerate(theta % TURN):
            near = np.arange(*np.searchsorted(tripled, [angle - reach, angle + reach])) % len(points)
            c, s = np.cos(angle), np.sin(angle)
            x, y = points[near, 0] * c + points[near, 1] * s, points[near, 1] * c - points[near, 0] * s
            under = np.abs(y) < radius
            x, h = x[under] - self.a, np.sqrt(radius**2 - y[under] ** 2)
            out[i] = max(float(np.max(np.arctan2(x, w[i]) + np.arcsin(h / np.hypot(x, w[i])))) for w in faces)
        return np.tan(out)

    def readings(self, bench: Bench, theta: np.ndarray, direction: np.ndarray) -> np.ndarray:
        """Readings of the dial, mm, in the order measured."""
        at = theta + bench.phase - direction * bench.play / 2
        T = self._fine(bench, at)
        # Where the spindle's line w = w0 + t sin, x = t cos meets the rod's line x = w T.
        reading = self.w[0] * T / (np.cos(bench.tilt) - T * np.sin(bench.tilt))
        reading = reading * bench.gain
        reading = reading - bench.friction * self._rising(theta) * direction
        reading = reading + bench.square * reading**2
        order, amplitude, phase = bench.ripple
        reading = reading + amplitude * np.cos(order * theta - phase)
        return reading + bench.drift * np.linspace(-0.5, 0.5, len(theta))

    def _rising(self, theta: np.ndarray) -> np.ndarray:
        if self._nominal is None:
            self._nominal = self.steering(Bench(), np.arange(3600) * DEG / 10)
        slope = np.roll(self._nominal, -1) - np.roll(self._nominal, 1)
        return np.sign(np.interp(theta, np.arange(3600) * DEG / 10, slope, period=TURN))

    def _fine(self, bench: Bench, theta: np.ndarray) -> np.ndarray:
        unique, back = np.unique(np.round(theta, 12), return_inverse=True)
        return self.steering(bench, unique)[back]


def lift_record(
    car: Car, bench: Bench, rng: np.random.Generator, *, noise_um: float, index_deg: float = 0.01, runs: int = 3
) -> Record:
    """Readings every degree to 340 and back, each run with its own zero."""
    forward = np.arange(341.0)
    degrees = np.concatenate([forward, forward[::-1]])
    direction = np.concatenate([np.ones(341), -np.ones(341)])
    clean = car.readings(bench, degrees * DEG, direction)
    slope = np.gradient(clean[:341], DEG)
    slope = np.concatenate([slope, slope[::-1]])
    rows = []
    for run in range(runs):
        place = np.linspace(0, 1, len(degrees))
        where, when, size = bench.jump
        reading = clean + size * ((run == where) & (place > when))
        reading = reading + slope * rng.normal(0, index_deg * DEG, len(degrees)) + rng.normal(0, 0.02)
        reading = reading + rng.normal(0, noise_um / 1e3, len(degrees))
        rows.append(np.round(reading, 3))
    return Record(
        kind=LIFT,
        columns={
            "cam_angle_deg": np.tile(degrees, runs),
            "direction": np.tile(np.where(direction > 0, "forward", "reverse"), runs),
            "lift_mm": np.concatenate(rows),
        },
        run=np.repeat(np.arange(runs), len(degrees)),
        remarks=(),
        source="synthetic lift",
    )


def profile_record(
    car: Car,
    bench: Bench,
    rng: np.random.Generator,
    *,
    noise_um: float,
    runs: int = 3,
    count: int = 720,
    clock_deg: float | None = None,
    turn: float | None = None,
    scatter: float | None = None,
) -> Record:
    """Points at random places, clocked by up to half a degree.

    Half of the parts are measured all round, the others to 345 degrees; half are clamped anew for each run, with
    0.2 degrees of scatter.
    """
    outline = car.disc(bench)
    outline = np.concatenate([outline, outline[:1]])
    length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(outline, axis=0), axis=1))])
    polar = np.unwrap(np.arctan2(outline[:, 1], outline[:, 0]))
    common = (rng.uniform(-0.5, 0.5) if clock_deg is None else clock_deg) * DEG
    turn = (TURN if rng.random() < 0.5 else 345 * DEG) if turn is None else turn
    scatter = (0.2 * DEG if rng.random() < 0.5 else 0.0) if scatter is None else scatter
    points = []
    for _ in range(runs):
        wanted = polar[0] + np.sort(rng.uniform(0, turn, count))
        at = np.interp(wanted, polar, length)
        xy = np.stack([np.interp(at, length, outline[:, k]) for k in (0, 1)], axis=1)
        clock = common + rng.normal(0, scatter)
        c, s = np.cos(clock), np.sin(clock)
        xy = np.stack([c * xy[:, 0] - s * xy[:, 1], s * xy[:, 0] + c * xy[:, 1]], axis=1)
        points.append(np.round(xy + rng.normal(0, noise_um / 1e3, xy.shape), 4))
    xy = np.concatenate(points)
    return Record(
        kind=PROFILE,
        columns={"x_mm": xy[:, 0], "y_mm": xy[:, 1]},
        run=np.repeat(np.arange(runs), count),
        remarks=(),
        source="synthetic profile",
    )


Sized = Callable[[float], dict[str, Any]]
Truths = dict[str, tuple[Callable[[Car, np.random.Generator], Sized], float, float]]


def _plane(rng: np.random.Generator, size: float) -> tuple[float, float]:
    angle = rng.uniform(0, TURN)
    return (size * np.cos(angle), size * np.sin(angle))


def _sign(rng: np.random.Generator) -> float:
    return float(rng.choice([-1.0, 1.0]))


# Name in the catalogue -> how it is drawn, and between which sizes (log-uniform): mm, rad or shares, as met in a
# workshop and on a bench.
LIFT_TRUTHS: Truths = {
    "eccentric bore": (lambda car, rng: _eccentric(rng), 5e-3, 80e-3),
    "phase": (lambda car, rng: _signed(rng, "phase"), 0.02 * DEG, 0.5 * DEG),
    "rod radius": (lambda car, rng: _signed(rng, "rod"), 20e-3, 300e-3),
    "lever gain": (lambda car, rng: _about_one(rng, "gain"), 2e-3, 30e-3),
    "axial offset": (lambda car, rng: _signed(rng, "axial"), 0.1, 1.0),
    "camshaft wobble": (lambda car, rng: _wobble(rng), 0.05, 0.8),
    "lost motion by friction": (lambda car, rng: lambda k: {"friction": k}, 2e-3, 30e-3),
    "backlash": (lambda car, rng: lambda k: {"play": k}, 0.05 * DEG, 1.5 * DEG),
    "drift": (lambda car, rng: _signed(rng, "drift"), 5e-3, 60e-3),
    "tilted indicator": (lambda car, rng: _signed(rng, "tilt"), 0.5 * DEG, 8 * DEG),
    "worn nose": (lambda car, rng: _worn(car, rng), 8e-3, 80e-3),
}
PROFILE_TRUTHS: Truths = {
    "eccentric bore": (lambda car, rng: _eccentric(rng), 5e-3, 100e-3),
    "cutter compensation": (lambda car, rng: _signed(rng, "offset"), 10e-3, 100e-3),
    "uniform scale": (lambda car, rng: _uniform(rng), 3e-4, 4e-3),
    "anisotropic scale": (lambda car, rng: _anisotropic(rng), 3e-4, 4e-3),
    "lobing": (lambda car, rng: _lobes(rng, "lobes", 2, 8), 3e-3, 30e-3),
    "waviness": (lambda car, rng: _lobes(rng, "ripples", 9, 90), 2e-3, 20e-3),
    "machine-axis reversal": (lambda car, rng: _reversal(rng), 8e-3, 50e-3),
    "worn nose": (lambda car, rng: _worn(car, rng), 8e-3, 80e-3),
}
# Nothing of these is in the catalogue.
STRANGE: Truths = {
    "dent": (lambda car, rng: _dent(car, rng), 10e-3, 80e-3),
    "raised sector": (lambda car, rng: _sector(rng), 8e-3, 60e-3),
    "rough form": (lambda car, rng: _rough(rng), 8e-3, 40e-3),
}
STRANGE_LIFT: Truths = STRANGE | {
    "harmonic of the reading": (lambda car, rng: _ripple(rng), 5e-3, 40e-3),
    "jump of the zero": (lambda car, rng: _jump(rng), 8e-3, 60e-3),
}


def _signed(rng: np.random.Generator, name: str) -> Sized:
    sign = _sign(rng)
    return lambda k: {name: sign * k}


def _about_one(rng: np.random.Generator, name: str) -> Sized:
    sign = _sign(rng)
    return lambda k: {name: 1 + sign * k}


def _eccentric(rng: np.random.Generator) -> Sized:
    way = np.array(_plane(rng, 1.0))
    return lambda k: {"shift": tuple(k * way)}


def _wobble(rng: np.random.Generator) -> Sized:
    angle = rng.uniform(0, TURN)
    return lambda k: {"wobble": (k, angle)}


def _worn(car: Car, rng: np.random.Generator) -> Sized:
    where, width = rng.choice(car.noses), rng.uniform(3, 6) * DEG
    return lambda k: {"dent": (where, width, k)}


def _uniform(rng: np.random.Generator) -> Sized:
    sign = _sign(rng)
    return lambda k: {"scale": (1 + sign * k, 1 + sign * k)}


def _anisotropic(rng: np.random.Generator) -> Sized:
    sign, share = _sign(rng), rng.uniform(-0.5, 0.4)
    return lambda k: {"scale": (1 + sign * k, 1 + sign * share * k)}


def _lobes(rng: np.random.Generator, name: str, first: int, last: int) -> Sized:
    order, phase = int(rng.integers(first, last + 1)), rng.uniform(0, TURN)
    return lambda k: {name: (order, k, phase)}


def _reversal(rng: np.random.Generator) -> Sized:
    x, y = rng.uniform(0.3, 1.0, 2)
    return lambda k: {"reversal": (k * x, k * y)}


def _dent(car: Car, rng: np.random.Generator) -> Sized:
    while True:
        where = rng.uniform(10, 330) * DEG
        if min(abs(np.angle(np.exp(1j * (where - nose)))) for nose in car.noses) > 15 * DEG:
            break
    width, sign = rng.uniform(2, 8) * DEG, _sign(rng)
    return lambda k: {"dent": (where, width, sign * k)}


def _sector(rng: np.random.Generator) -> Sized:
    where, width, sign = rng.uniform(0, TURN), rng.uniform(15, 60) * DEG, _sign(rng)
    return lambda k: {"sector": (where, width, sign * k)}


def _rough(rng: np.random.Generator) -> Sized:
    form = form_error(rng, 1.0)
    return lambda k: {"form": form * k}


def _ripple(rng: np.random.Generator) -> Sized:
    order, phase = int(rng.integers(2, 12)), rng.uniform(0, TURN)
    return lambda k: {"ripple": (order, k, phase)}


def _jump(rng: np.random.Generator) -> Sized:
    run, when = int(rng.integers(0, 3)), rng.uniform(0.2, 0.8)
    return lambda k: {"jump": (run, when, k)}


def bench_with(form: np.ndarray, *changes: dict[str, Any]) -> Bench:
    """A bench with a form error and some effects."""
    bench = Bench(form=form)
    for change in changes:
        for name, value in change.items():
            setattr(bench, name, value + form if name == "form" else value)
    return bench
