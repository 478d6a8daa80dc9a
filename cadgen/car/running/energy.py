"""Energy of a run: what rolling, rod, brake and gears take, against what the drive has.

Let c be the rolling resistance, m the mass of the car, and S the mean length of the tracks of its three wheels. The
gears must give the cam the torque M(theta), `mechanics.Mechanics.needed`, and their efficiency is eta. Then
    E = c m g S + 1/eta ∫ max(M, 0) dtheta.
Where the rod drives the cam ahead, M is negative, and nothing of that comes back: the play is run through, and the
shock at its end takes it. Air and the kinetic energy at the end are left aside: 0.13 J of a car of 1 kg at 0.5 m/s.

The force against the car at a place is the derivative of E by the travel s of the drive wheel.
    F(s) = c m g dS/ds + max(M, 0) / eta dtheta/ds.
A weight that pulls with P moves it off if P > F at the start. It keeps it moving as long as P s > ∫ F ds.
"""

from dataclasses import dataclass

import numpy as np

from cadgen.arrays import Array, gauss_nodes
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run
from cadgen.car.running.mechanics import Mechanics

GRAVITY = 9.81  # m/s²
_PIECES, _NODES = 720, 4  # Gauss-Legendre rule over a turn: pieces of half a degree, and nodes of each


@dataclass(frozen=True, slots=True, kw_only=True)
class RunEnergy:
    """Energies of a run, J.

    Attributes:
        rolling: work of rolling resistance.
        rod: work of the rod against the cam, friction included, where the gears push.
        drag: work of the brake and felt on the cam, where the gears push.
        gears: loss in the gears.
    """

    rolling: float
    rod: float
    drag: float
    gears: float

    @property
    def needed(self) -> float:
        """Energy that the drive must give, J."""
        return self.rolling + self.rod + self.drag + self.gears


@dataclass(frozen=True, slots=True, kw_only=True)
class Resistance:
    """Force against a car along its run, over n steps of it.

    Attributes:
        travel: travel of the drive wheel at the end of each step, shape (n,), m.
        force: force against the car at the rim of its drive wheel, over each step, shape (n,), N.
    """

    travel: Array
    force: Array

    @property
    def work(self) -> Array:
        """Work of the force up to the end of each step, shape (n,), J."""
        summed: Array = np.cumsum(self.force * np.diff(self.travel, prepend=0.0))
        return summed


def resistance(
    lift: PathMotion, forces: Mechanics, run: Run, *, mass: float, rolling: float, efficiency: float
) -> Resistance:
    """Force against a car along its run; its work is the energy of the run.

    Args:
        lift: lift of the cam.
        forces: forces on the cam.
        run: run of the car, with the tracks of its wheels.
        mass: mass of the car, kg.
        rolling: rolling resistance, ratio of force and load.
        efficiency: share of the energy that the gears pass on to the cam, 0 to 1.
    """
    driven, *others = (
        np.hypot(*np.diff(track, axis=0).T) * 1e-3 for track in (run.drive_wheel, run.front_wheel, run.idle_wheel)
    )
    angle = np.diff(run.motor)
    middle = (run.motor[:-1] + angle / 2) % (2 * np.pi)
    cam = np.maximum(forces.needed(lift, middle), 0.0) * 1e-3 / efficiency * angle
    rolled = rolling * mass * GRAVITY * (driven + sum(others)) / 3
    return Resistance(travel=np.cumsum(driven), force=(rolled + cam) / driven)


def run_energy(
    lift: PathMotion, forces: Mechanics, run: Run, *, mass: float, rolling: float, efficiency: float
) -> RunEnergy:
    """Energies of a run up to its last motor position.

    Args:
        lift: lift of the cam.
        forces: forces on the cam.
        run: run of the car, with the tracks of its wheels.
        mass: mass of the car, kg.
        rolling: rolling resistance, ratio of force and load.
        efficiency: share of the energy that the gears pass on to the cam, 0 to 1.
    """
    stop = float(run.motor[-1])
    pieces = max(round(_PIECES * stop / (2 * np.pi)), 1)
    nodes, weights = gauss_nodes(_NODES)
    width = stop / pieces
    theta = (np.arange(pieces)[:, None] + (nodes + 1) / 2) * width
    torque = forces.needed(lift, theta.ravel() % (2 * np.pi)).reshape(theta.shape)
    pushed = np.maximum(torque, 0.0)
    # Shares of rod and drag in a torque that is the sum of both.
    drag = np.minimum(pushed, forces.drag)
    work, braked = (float(width / 2 * (each @ weights).sum()) * 1e-3 for each in (pushed, drag))
    tracks = (run.drive_wheel, run.front_wheel, run.idle_wheel)
    length = float(np.mean([np.hypot(*np.diff(track, axis=0).T).sum() for track in tracks])) * 1e-3
    return RunEnergy(
        rolling=rolling * mass * GRAVITY * length,
        rod=work - braked,
        drag=braked,
        gears=work * (1 / efficiency - 1),
    )
