"""Joint of a robot with an encoder on the motor and one on the output, stepped in time: no model of the package in it.

The motor follows its set angle. The output has an inertia and is driven through a spring behind a gap; friction in its
bearing and the weight of an arm act on it:

    J a'' = k gap(m / N - a) + c (m' / N - a') - f sign(a') - w sin(a)

The gap gives no torque within half of its width. The encoders count steps, and the readings of the output have noise.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.inference.measurement.kinds import TRANSMISSION
from cadgen.inference.measurement.record import Record

DEG = np.pi / 180


@dataclass(frozen=True)
class Arm:
    """Joint, by the output's side: degrees, N m, kg m^2, s."""

    play: float = 0.4
    stiffness: float = 60_000.0  # N m for each rad
    inertia: float = 1.0
    damping: float = 100.0
    friction: float = 8.0
    weight: float = 0.0
    ratio: float = 45.0
    counts: int = 2**17  # of the output's encoder in a turn
    noise: float = 0.002  # of its readings, degrees
    swing: float = 300.0  # degrees forth and back
    period: float = 60.0  # s there and back
    sines: bool = False  # three sines of random size and phase in each run in place of once there and back
    wander: float = 0.0  # degrees rms by which the output's reading wanders slowly, other in each run
    lag: float = 0.0  # s by which the output is read later than the motor


STEP = 2e-4  # s; the spring's own period is some 0.03 s


def turned(arm: Arm, start: float, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Angles of motor (through the ratio) and output at 1 kHz, degrees, from a place in the gap."""
    steps = int(arm.period / STEP)
    phase = np.arange(steps) / steps
    # Ramps with soft ends, as a drive makes them.
    way = np.interp(phase, [0, 0.02, 0.48, 0.52, 0.98, 1.0], [0, 0.01, 0.99, 0.99, 0.01, 0.0])
    width = int(0.01 * steps)
    way = np.convolve(np.pad(way, width, mode="edge"), np.ones(2 * width + 1) / (2 * width + 1), "valid")
    if arm.sines:
        turns, shift = rng.uniform(1, 8, 3), rng.uniform(0, 2 * np.pi, 3)
        way = np.sin(2 * np.pi * turns * phase[:, None] + shift) @ rng.dirichlet(np.ones(3)) / 2
        way = (way - way[0]) * np.sin(np.pi / 2 * np.minimum(1, 5 * phase)) ** 2
    motor = arm.swing * DEG * way
    rate = np.gradient(motor, STEP).tolist()
    half, angle, speed, out = arm.play * DEG / 2, start * DEG, 0.0, np.empty(steps)
    for k, ahead in enumerate(motor.tolist()):
        out[k] = angle
        off = ahead - angle
        wound = off - half if off > half else off + half if off < -half else 0.0
        drive = arm.stiffness * wound + (arm.damping * (rate[k] - speed) if wound else 0.0)
        drive -= arm.weight * np.sin(angle) if arm.weight else 0.0
        free = speed + STEP * drive / arm.inertia
        brake = STEP * arm.friction / arm.inertia
        speed = 0.0 if abs(free) <= brake else free - brake if free > 0 else free + brake
        angle += STEP * speed
    every = int(1e-3 / STEP)
    return motor[::every] / DEG, out[::every] / DEG


def joint_record(arm: Arm, rng: np.random.Generator, *, rate: float, runs: int = 3) -> Record:
    """Runs of the joint, read at 1 kHz and thinned to a rate in Hz."""
    motors, cams = [], []
    for _ in range(runs):
        start = rng.uniform(-arm.play, arm.play) / 2
        motor, cam = turned(arm, start, rng)
        step = 360.0 / arm.counts
        late = np.arange(len(cam)) - 1000 * arm.lag
        cam = np.interp(late, np.arange(len(cam)), cam)
        slow = np.fft.irfft(rng.normal(size=(2, 6)).T @ [1, 1j] * len(cam) / 2 / 3.46, len(cam)) if arm.wander else 0.0
        cam = cam + arm.wander * slow
        read = np.round((cam + rng.normal(0, arm.noise, len(cam)) + rng.uniform(0, 5)) / step) * step
        every = round(1000 / rate)
        motors.append(arm.ratio * motor[::every])
        cams.append(read[::every])
    return Record(
        kind=TRANSMISSION,
        columns={"motor_angle_deg": np.concatenate(motors), "cam_angle_deg": np.concatenate(cams)},
        run=np.repeat(np.arange(runs), [len(m) for m in motors]),
        remarks=(),
        source=f"joint at {rate:g} Hz",
    )
