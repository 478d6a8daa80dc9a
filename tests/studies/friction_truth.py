"""Cars whose rod rubs, driven without any of cadgen's mechanics: what `tests.studies.friction_cars` is judged by.

The rod is a round bar in space, T = tan(beta) aslant to the camshaft, that rests on an edge of the disc. At each of
72 000 cam angles the forces at the point of contact are written as vectors (the normal square to bar and edge, the
friction along the way that the edge slides) and their moments about the camshaft compared: above the ratio of the two
friction holds the cam, below it the rod turns it ahead. Then the cam is stepped through its play, cell by cell, and the
car is driven by short arcs. Of cadgen only the steering wanted by cam angle, the path's start and length and the car's
dimensions are used.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.record import Record

DEG, TURN = np.pi / 180, 2 * np.pi
CELLS = 72_000  # of a turn
STEP_DEG = 360 / CELLS


@dataclass(frozen=True)
class FrictionCar:
    """A car as it is; factors of 1 and additions of 0 are the design.

    Attributes:
        play: return error, in cells of a turn.
        friction: between rod and disc.
        zero: of the steering, rad.
        radius, gain: of the wheel and of the lever, as factors.
        phase: of the cam, in cells.
    """

    play: int = 0
    friction: float = 0.0
    zero: float = 0.0
    radius: float = 1.0
    gain: float = 1.0
    phase: int = 0

    @property
    def play_deg(self) -> float:
        return self.play * STEP_DEG


class World:
    """The designed cam, where friction of any size lets it go, and the car on it."""

    def __init__(self, built: Any) -> None:
        self.built = built
        self.ends = np.asarray(built.lift.q(np.arange(CELLS) * TURN / CELLS))
        self.middle = np.asarray(built.lift.q((np.arange(CELLS) + 0.5) * TURN / CELLS))
        slope = (np.roll(self.ends, -1) - self.ends) * CELLS / TURN
        # Friction above which each cell holds the cam; on a rise none is needed.
        self.holds = np.where(slope < 0, holding(built.follower, self.middle, slope), -1.0)
        # The same of a cam that is turned back: its rises are falls.
        self.holds_back = np.where(slope > 0, holding(built.follower, self.middle, -slope), -1.0)

    def cam(self, car: FrictionCar) -> np.ndarray:
        """Cell in which the shaft stands while the motor is in each cell of the turn; the disc stands ahead of it."""
        ahead = np.roll(self.holds > car.friction, -car.phase).tolist()
        out, now = [], 0
        for motor in range(CELLS):
            now = max(now, motor)
            while now < motor + car.play and ahead[now % CELLS]:
                now += 1
            out.append(now)
        return np.array(out)

    def track(self, car: FrictionCar, degrees: np.ndarray) -> np.ndarray:
        """Places of the drive wheel at motor positions, as x + iy."""
        T = self.middle[(self.cam(car) + car.phase) % CELLS]
        beta = np.arctan(T * car.gain) + car.zero
        L, A1 = self.built.car.wheelbase, self.built.car.drive_wheel_offset
        turn = -np.tan(beta) / (L + A1 * np.tan(beta)) * (length := self.built.track.length * car.radius / CELLS)
        x, y = self.built.track.position(0.0)
        heading = float(self.built.track.heading(np.array([0.0]))[0]) + np.cumsum(turn) - turn / 2
        chords = length * np.sinc(turn / TURN) * np.exp(1j * heading)
        place = complex(float(x), float(y)) + np.concatenate([[0], np.cumsum(chords)])
        at = degrees / STEP_DEG
        return np.interp(at, np.arange(CELLS + 1), place.real) + 1j * np.interp(at, np.arange(CELLS + 1), place.imag)

    def record(self, car: FrictionCar, rng: np.random.Generator, *, runs: int, noise_mm: float) -> Record:
        """Camera's rows every two degrees, started by hand within 3 mm and 0.15 degrees."""
        degrees = np.arange(0, 361, 2.0)
        clean = self.track(car, degrees)
        places = []
        for _ in range(runs):
            turned = clean[0] + (clean - clean[0]) * np.exp(1j * rng.normal(0, 0.15) * DEG)
            noise = rng.normal(0, noise_mm, (2, len(degrees)))
            places.append(turned + rng.normal(0, 3) + 1j * rng.normal(0, 3) + noise[0] + 1j * noise[1])
        place = np.concatenate(places)
        columns = {
            "cam_angle_deg": np.tile(degrees, runs),
            "x_mm": np.round(place.real, 1),
            "y_mm": np.round(place.imag, 1),
        }
        run = np.repeat(np.arange(runs), len(degrees))
        return Record(kind=TRACK, columns=columns, run=run, remarks=(), source="car that rubs")


def holding(rod: Any, T: np.ndarray, slope: np.ndarray) -> np.ndarray:
    """Moment of the normal force about the camshaft over that of as large a friction against it; on falls.

    The camshaft is the origin, x runs to the bar's centre in the face, y along the motion of the edge, z to the fork.
    """
    w = np.where(T >= 0, rod.inner, rod.outer)
    d = rod.base_radius + w * T
    A, r = rod.radius * np.sqrt(1 + T**2), rod.radius  # semi-axes of the bar's section in the face
    q = np.zeros_like(T)  # slope of the normal there
    for _ in range(60):
        m = np.stack([np.ones_like(q), q]) / np.sqrt(1 + q**2)
        h = np.sqrt((A * m[0]) ** 2 + (r * m[1]) ** 2)
        touch = np.stack([d - A**2 * m[0] / h, -(r**2) * m[1] / h])
        # The edge moves by (-y, x); the bar turns about the fork. Square to the bar neither gains on the other.
        bar = slope / (1 + T**2) * np.stack([w, np.zeros_like(w), -(touch[0] - rod.base_radius)])
        q = (touch[1] + bar[0] - T * bar[2]) / touch[0]
    normal = np.stack([m[0], m[1], -T * m[0]])
    normal /= np.linalg.norm(normal, axis=0)
    slides = np.stack([-touch[1], touch[0], np.zeros_like(T)]) - bar
    slides /= np.linalg.norm(slides, axis=0)
    assert np.abs(np.sum(normal * slides, axis=0)).max() < 1e-9
    ahead, back = (touch[1] * v[0] - touch[0] * v[1] for v in (normal, slides))
    return np.asarray(ahead / -back)
