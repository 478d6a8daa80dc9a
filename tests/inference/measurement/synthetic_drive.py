"""Synthetic trains and cars: a camshaft stepped through its play, and a car driven step by step.

Written apart from the models under test: the play is a gap whose flanks push; the spring's push is a walk downhill
over a table of the lift within the gap; the car goes by short arcs of circles.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from cadgen.inference.measurement.kinds import TRACK, TRANSMISSION
from cadgen.inference.measurement.record import Record
from tests.inference.measurement.synthetic import DEG, TURN

RATIOS = (5.0, 3.0, 3.0)


@dataclass(frozen=True)
class Train:
    """A train at rest is perfect; angles in rad of the camshaft."""

    play: float = 0.0
    rate: float = 1.0
    waves: tuple[tuple[float, float, float], ...] = ()  # turns per turn of the cam, amplitude, phase
    saw: tuple[float, float] = (0.0, 0.0)  # place and size of a wedge that no catalogue has
    twist: float = 0.0  # where the cam is steepest

    def camshaft(self, motor: np.ndarray, slope: np.ndarray) -> np.ndarray:
        """Cam angle for each motor angle in turn."""
        nominal = motor / np.prod(RATIOS)
        asked = nominal * self.rate - self.twist * slope
        for order, amplitude, phase in self.waves:
            asked = asked + amplitude * np.cos(order * nominal - phase)
        where, size = self.saw
        asked = asked + size * np.clip(1 - np.abs(nominal - where) / (20 * DEG), 0, 1)
        cam, out = asked[0], np.empty(len(asked))
        for i, angle in enumerate(asked):
            if angle - cam > self.play / 2:  # the leading flank pushes
                cam = angle - self.play / 2
            elif cam - angle > self.play / 2:  # the other flank
                cam = angle + self.play / 2
            out[i] = cam
        return out


def transmission_record(car: Any, train: Train, rng: np.random.Generator, *, noise_deg: float, runs: int = 3) -> Record:
    """One turn forward in steps of 45 degrees of the motor, and back."""
    steps = np.arange(361) * 45.0
    motor = np.concatenate([steps, steps[-2::-1]])
    slope = car.built.lift.q((motor * DEG / 45) % TURN, nu=1)
    clean = train.camshaft(motor * DEG, slope / np.abs(slope).max()) / DEG
    readings = [np.round(clean + rng.normal(0, 0.05) + rng.normal(0, noise_deg, len(motor)), 2) for _ in range(runs)]
    return Record(
        kind=TRANSMISSION,
        columns={"motor_angle_deg": np.tile(motor, runs), "cam_angle_deg": np.concatenate(readings)},
        run=np.repeat(np.arange(runs), len(motor)),
        remarks=(),
        source="synthetic train",
    )


@dataclass(frozen=True)
class Wheels:
    """A car as it runs; factors of 1 and additions of 0 are the design."""

    zero: float = 0.0
    gain: float = 1.0
    radius: float = 1.0
    offset: float = 0.0
    slip: float = 0.0
    phase: float = 0.0
    play: float = 0.0
    sticky: tuple[float, float] = (0.0, 0.0)  # place and size of a steering error over ten degrees

    def track(self, built: Any, motor: np.ndarray) -> np.ndarray:
        """Places of the drive wheel at motor positions (rad, increasing), as x + iy."""
        count = 7200
        table = built.lift.q(np.arange(count) * TURN / count)
        window = round(self.play / TURN * count)
        turn = np.arange(count + 1)
        cam = np.empty(count + 1, dtype=int)
        now = 0
        for i in turn:
            now = max(now, i)
            while now < i + window and table[(now + 1) % count] < table[now % count]:
                now += 1
            cam[i] = now
        fine = built.lift.q(cam * TURN / count + self.phase)
        where, size = self.sticky
        fine = fine + size * (np.abs(turn * TURN / count - where) < 5 * DEG)
        beta = np.arctan(fine * self.gain) + self.zero
        L, A1 = built.car.wheelbase, built.car.drive_wheel_offset + self.offset
        # A right turn of the fork by beta: the rear axle's line meets the fork's at L / tan(beta) to the right of it.
        radius_inverse = np.tan(beta) / (L + A1 * np.tan(beta))
        step = built.track.length * self.radius / count * (1 - self.slip * np.abs(np.tan(beta)))
        x, y = built.track.position(0.0)
        heading = float(built.track.heading(np.array([0.0]))[0])
        place = np.empty(count + 1, dtype=complex)
        place[0] = x + 1j * y
        bend = -(radius_inverse[:-1] + radius_inverse[1:]) / 2
        travel = (step[:-1] + step[1:]) / 2
        for i in range(count):
            swing = bend[i] * travel[i]
            place[i + 1] = place[i] + travel[i] * np.exp(1j * (heading + swing / 2)) * np.sinc(swing / TURN)
            heading += swing
        at = motor / TURN * count
        return np.interp(at, turn, place.real) + 1j * np.interp(at, turn, place.imag)


def track_record(
    car: Any, wheels: Wheels, rng: np.random.Generator, *, noise_mm: float, runs: int = 4, start_deg: float = 0.15
) -> Record:
    """Every two degrees of the cam, started by hand within 3 mm and 0.15 degrees, or what else is said."""
    degrees = np.arange(0, 361, 2.0)
    clean = wheels.track(car.built, degrees * DEG)
    rows = []
    for _ in range(runs):
        turned = clean[0] + (clean - clean[0]) * np.exp(1j * rng.normal(0, start_deg) * DEG)
        turned = turned + rng.normal(0, 3) + 1j * rng.normal(0, 3)
        rows.append(turned + rng.normal(0, noise_mm, len(degrees)) + 1j * rng.normal(0, noise_mm, len(degrees)))
    place = np.concatenate(rows)
    return Record(
        kind=TRACK,
        columns={
            "cam_angle_deg": np.tile(degrees, runs),
            "x_mm": np.round(place.real, 1),
            "y_mm": np.round(place.imag, 1),
        },
        run=np.repeat(np.arange(runs), len(degrees)),
        remarks=(),
        source="synthetic track",
    )


def _runout(order: float) -> Callable[[np.random.Generator], dict[str, Any]]:
    return lambda rng: {"waves": ((order, rng.uniform(0.03, 0.4) * DEG, rng.uniform(0, TURN)),)}


# Name in the catalogue -> the drawn change of a perfect train or car.
TRAINS: dict[str, Callable[[np.random.Generator], dict[str, Any]]] = {
    "return error": lambda rng: {"play": rng.uniform(0.1, 2.0) * DEG},
    "rate": lambda rng: {"rate": 1 + rng.choice([-1, 1]) * rng.uniform(5e-4, 2e-2)},
    "wind-up": lambda rng: {"twist": rng.uniform(0.05, 0.5) * DEG},
    "runout of the camshaft": _runout(1.0),
    "runout of shaft 2": _runout(3.0),
    "runout of shaft 1": _runout(9.0),
    "runout of the motor shaft": _runout(45.0),
}
STRANGE_TRAINS = {
    "wedge": lambda rng: {"saw": (rng.uniform(40, 320) * DEG, rng.uniform(0.1, 0.5) * DEG)},
    "wave of order 5": lambda rng: {"waves": ((5.0, rng.uniform(0.05, 0.4) * DEG, rng.uniform(0, TURN)),)},
}
CARS = {
    "steering zero": lambda rng: {"zero": rng.choice([-1, 1]) * rng.uniform(0.02, 1.0) * DEG},
    "lever gain": lambda rng: {"gain": 1 + rng.choice([-1, 1]) * rng.uniform(0.002, 0.05)},
    "wheel radius": lambda rng: {"radius": 1 + rng.choice([-1, 1]) * rng.uniform(0.001, 0.02)},
    "driven wheel's offset": lambda rng: {"offset": rng.choice([-1, 1]) * rng.uniform(1.0, 10.0)},
    "slip with curvature": lambda rng: {"slip": rng.uniform(0.01, 0.1)},
    "cam phase": lambda rng: {"phase": rng.choice([-1, 1]) * rng.uniform(0.1, 2.0) * DEG},
    # A whole number of the steps by which the cam walks downhill.
    "backlash": lambda rng: {"play": int(rng.integers(2, 32)) * 0.05 * DEG},
}
STRANGE_CARS = {
    "sticky steering": lambda rng: {
        "sticky": (rng.uniform(30, 300) * DEG, rng.choice([-1, 1]) * rng.uniform(2e-3, 2e-2))
    },
}


def changed(thing: Any, *changes: dict[str, Any]) -> Any:
    """A perfect train or car with some changes; waves add up."""
    waves = tuple(wave for change in changes for wave in change.get("waves", ()))
    for change in changes:
        thing = replace(thing, **change)
    return replace(thing, waves=waves) if waves else thing
