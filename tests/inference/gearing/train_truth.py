"""Angles of a train of eccentric involute gears with play, made without the package.

The gears are exact: base circles whose centres go round their shafts. With γ the turn and a' the length of the way from
one centre to the other, and cos α' = (r_b1 + r_b2)/a', forward flanks touch where

    r_b2 (θ2 − γ) = r_b1 (θ1 + γ) − (r_b1 + r_b2)(inv α' − inv α),

θ1 clockwise and θ2 counter-clockwise, and the others where the last term has the other sign; from the string that
unwinds from one circle onto the other. Each stage has play beside that, and holds the angle while it is passed.
"""

import math
from dataclasses import dataclass, field

import numpy as np


def inv(angle):
    return np.tan(angle) - angle


@dataclass
class Wheel:
    teeth: int
    off: float = 0.0  # mm
    towards: float = 0.0  # rad, from the way to the other axis at angle 0
    pitch: dict = field(default_factory=dict)  # harmonic of its turn -> (amplitude, phase) of arc at its base, mm, rad


@dataclass
class Stage:
    driver: Wheel
    driven: Wheel
    module: float = 1.0
    pressure: float = math.radians(20.0)
    play: float = 0.0  # arc along the line of action, mm
    tooth: float = 0.0  # mm at the base, once a tooth

    def flanks(self, turned, turned_driven):
        """Angle of the driven wheel at forward and at other flanks, for angles of the driver."""
        r1, r2 = (wheel.teeth * self.module / 2 * math.cos(self.pressure) for wheel in (self.driver, self.driven))
        apart = (self.driver.teeth + self.driven.teeth) * self.module / 2
        c1 = self.driver.off * np.exp(1j * (self.driver.towards - turned))
        c2 = apart + self.driven.off * np.exp(1j * (self.driven.towards + turned_driven))
        way = c2 - c1
        gamma, alpha = np.angle(way), np.arccos((r1 + r2) / np.abs(way))
        opened = (r1 + r2) * (inv(alpha) - inv(self.pressure)) + self.play / 2
        extra = self.tooth * np.sin(self.driver.teeth * turned)
        for wheel, angle, sign in ((self.driver, turned, 1), (self.driven, turned_driven, -1)):
            for order, (size, phase) in wheel.pitch.items():
                extra = extra + sign * size * np.sin(order * angle + phase)
        middle = gamma + (r1 * (turned + gamma) + extra) / r2
        return middle - opened / r2, middle + opened / r2


def driven_angles(stage, turned):
    """Path of the driven wheel as the driver's angles go on, friction holding it within the play."""
    ratio = stage.driven.teeth / stage.driver.teeth
    about = turned / ratio
    for _ in range(3):
        low, high = stage.flanks(turned, about)
        path = np.empty_like(turned)
        at = low[0] if turned[min(1, len(turned) - 1)] >= turned[0] else high[0]
        for k, (least, most) in enumerate(zip(low, high, strict=True)):
            at = min(max(at, least), most)
            path[k] = at
        about = path
    return path


def outputs(stages, turned):
    for stage in stages:
        turned = driven_angles(stage, turned)
    return turned


def there_and_back(ratio, turns=1.2, step_deg=1.0, lead_deg=0.0):
    up = np.arange(-lead_deg, turns * 360.0, step_deg)
    way = np.concatenate([up, up[-2::-1]])
    return np.radians(way) * ratio


def table(stages, noise_deg, rng, runs=3, turns=1.2, step_deg=1.0):
    """Columns of a record."""
    ratio = math.prod(stage.driven.teeth / stage.driver.teeth for stage in stages)
    sense = (-1) ** len(stages)
    columns = {"run": [], "input_angle_deg": [], "output_angle_deg": []}
    for run in range(runs):
        turned = there_and_back(ratio, turns, step_deg)
        out = outputs(stages, turned) + math.radians(noise_deg) * rng.standard_normal(len(turned))
        columns["run"] += [run + 1] * len(turned)
        columns["input_angle_deg"] += np.degrees(turned).tolist()
        columns["output_angle_deg"] += (sense * np.degrees(out) + rng.uniform(-5, 5)).tolist()
    return {name: np.array(values) for name, values in columns.items()}


def loaded(ratio, torques, play_deg, stiff, rub, noise_deg, rng, turns=1.2, step_deg=1.0):
    """Columns of a rigid train with one play and a spring at its output, pulled by a torque while the input turns.

    Friction holds against the motion; what it leaves of the torque, net, lies at one flank and winds the spring up:
    the output is off by net/stiff + sign(net) play/2. Torques are those of each run, one number or one of each row.
    """
    turned = np.degrees(there_and_back(ratio, turns, step_deg))
    motion = np.sign(np.diff(turned, prepend=turned[0] - turned[1]))
    columns = {"run": [], "input_angle_deg": [], "output_angle_deg": [], "output_torque_Nm": []}
    for run, torque in enumerate(torques):
        pull = np.broadcast_to(torque, turned.shape)
        net = pull - rub * motion
        out = turned / ratio + net / stiff + np.sign(net) * play_deg / 2 + noise_deg * rng.standard_normal(len(turned))
        columns["run"] += [run + 1] * len(turned)
        columns["input_angle_deg"] += turned.tolist()
        columns["output_angle_deg"] += (out + rng.uniform(-5, 5)).tolist()
        columns["output_torque_Nm"] += pull.tolist()
    return {name: np.array(values) for name, values in columns.items()}
