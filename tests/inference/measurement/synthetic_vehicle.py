"""Logged runs of made vehicles of any size: motion in time by Runge and Kutta, log and camera apart from it.

Nothing of the package's model is used: the front wheel at steering angle d and speed v moves the rear axle by
x' = v cos d cos h, y' = v cos d sin h, h' = v sin d / L. The log has a steering, an odometer and a clock of its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.record import Record

STEP_S = 0.01


@dataclass(frozen=True)
class Vehicle:
    """Vehicle, and errors of its log.

    Attributes:
        wheelbase: mm.
        zero: of the steering, deg: the wheel points so much further left than is logged.
        gain: true angle over the logged one.
        radius: true travel over the logged one.
        longer: true wheelbase over the stated one.
        lag: of the wheel behind the log, s.
        marker: place of the markers ahead and to the left of the rear axle, shares of the wheelbase.
        slip: share of travel lost at a steering of 90 degrees.
    """

    wheelbase: float = 1200.0
    zero: float = 0.0
    gain: float = 1.0
    radius: float = 1.0
    longer: float = 1.0
    lag: float = 0.0
    marker: complex = 0j
    slip: float = 0.0


def drive(
    vehicles: list[Vehicle], seed: int, *, wander_deg: float = 0.1, noise: float = 5e-4, most_deg: float = 45.0
) -> Record:
    """One run of each vehicle on a path of its own; noise of the camera as a share of the wheelbase.

    Args:
        vehicles: of each run; all of one stated wheelbase.
        seed: of paths, disturbances and noise.
        wander_deg: standard deviation of the heading that the floor adds over a wheelbase, deg.
        noise: of the camera.
        most_deg: greatest true steering, some.
    """
    rng = np.random.default_rng(seed)
    names = ("t_s", "distance_mm", "steering_deg", "x_mm", "y_mm", "heading_deg")
    columns: dict[str, list[np.ndarray]] = {name: [] for name in names}
    counts = []
    for vehicle in vehicles:
        base = vehicle.wheelbase * vehicle.longer
        length, seconds = 14 * vehicle.wheelbase, 60.0
        time = np.arange(0, seconds, STEP_S)
        waves, phases = rng.uniform(1.5, 5.0, 3) / seconds * 2 * np.pi, rng.uniform(0, 2 * np.pi, 3)
        sizes, bias = rng.uniform(0.15, 0.5, 3) * most_deg, rng.uniform(-0.25, 0.25) * most_deg
        pulse = rng.uniform(2, 4) / seconds * 2 * np.pi

        def speed(t, length=length, seconds=seconds, pulse=pulse):
            return length / seconds * (1 - 0.4 * np.cos(pulse * t))

        def logged(t, sizes=sizes, waves=waves, phases=phases, bias=bias, vehicle=vehicle):
            wanted = bias + sizes @ np.sin(np.multiply.outer(waves, t) + phases[:, None])
            return wanted / vehicle.gain

        def wheel(t, vehicle=vehicle, logged=logged):
            return np.radians(vehicle.gain * logged(np.atleast_1d(t) - vehicle.lag) + vehicle.zero)

        bumps = rng.normal(0, np.radians(wander_deg), len(time)) * np.sqrt(speed(time) * STEP_S / vehicle.wheelbase)
        state = np.array([0.0, 0.0, rng.uniform(-np.pi, np.pi)])
        path = [state]

        def rate(t, state, vehicle=vehicle, base=base, wheel=wheel, speed=speed):
            d = float(wheel(t)[0])
            v = speed(t) * (1 - vehicle.slip * abs(np.sin(d)))
            return np.array([v * np.cos(d) * np.cos(state[2]), v * np.cos(d) * np.sin(state[2]), v * np.sin(d) / base])

        for t, bump in zip(time[:-1], bumps, strict=False):
            a = rate(t, state)
            b = rate(t + STEP_S / 2, state + STEP_S / 2 * a)
            c = rate(t + STEP_S / 2, state + STEP_S / 2 * b)
            d = rate(t + STEP_S, state + STEP_S * c)
            state = state + STEP_S / 6 * (a + 2 * b + 2 * c + d) + np.array([0, 0, bump])
            path.append(state)
        x, y, heading = np.array(path).T
        travel = np.concatenate([[0], np.cumsum((speed(time[1:]) + speed(time[:-1])) / 2 * STEP_S)])
        place = x + 1j * y + vehicle.marker * vehicle.wheelbase * np.exp(1j * heading)
        place += noise * vehicle.wheelbase * (rng.normal(size=len(time)) + 1j * rng.normal(size=len(time)))
        rows = slice(None, None, 5)  # 20 rows a second
        values = (time, travel / vehicle.radius, logged(time), place.real, place.imag, np.degrees(heading))
        for name, value in zip(names, values, strict=True):
            columns[name].append(np.asarray(value)[rows])
        counts.append(len(time[rows]))
    return Record(
        kind=kinds.kind_of("steered track"),
        columns={name: np.concatenate(parts) for name, parts in columns.items()},
        run=np.repeat(np.arange(len(vehicles)), counts),
        remarks=(),
        source="made log",
    )
