"""The run of the car: steering by motor position -> heading -> the tracks of its three wheels.

The motor turns the drive wheel without play, so the wheel's travel is proportional to the motor position (eq. 20):
arc = length phi / (2 pi), length = 2 pi R_h i for one turn of the cam. Heading and position then follow from
    d(heading) = kappa d(arc),  d(position) = (cos heading, sin heading) d(arc),
with kappa the signed curvature of the drive wheel's track at the steering angle (eq. 21 with signs). Heading here
is the direction of travel, counterclockwise from the x axis.

The paper's eq. 23 measures its angle so that the car runs along (-sin, -cos), and puts the change beta where the
heading beta_1 of eq. 22 belongs; v_1 and dx in eq. 21 and 23 count the travel twice. Its eq. 24 then shifts the
wheels sideways by (cos, sin), which is not square to that direction. Here the wheels stand where the frame has
them: the fork axis L ahead and A1 to the right of the drive wheel, the idle wheel A1 + A2 to its right.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import ceil

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.course.body import RunPoses
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.play import LEAST_SWING, Following, follow
from cadgen.car.steering import Car, wheel_curvature, wheel_tangent, wheel_travel_ratio
from cadgen.errors import DesignError

STEPS = 3600  # of a turn: the position errs by less than 1e-5 mm on the paper's path

Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class Rule:
    """A Gauss collocation rule (Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, sec. II.7).

    It needs no value at the ends of a step, so none at a jump itself. Of s nodes its order is 2 s.

    Attributes:
        nodes: places within a step, 0 to 1, shape (s,).
        matrix: weights that give the heading at the nodes, shape (s, s).
    """

    nodes: Array
    matrix: Array


MIDPOINT = Rule(np.array([0.5]), np.array([[0.5]]))
TWO_STAGE = Rule(
    0.5 + np.array([-1.0, 1.0]) * np.sqrt(3) / 6,
    np.array([[0.25, 0.25 - np.sqrt(3) / 6], [0.25 + np.sqrt(3) / 6, 0.25]]),
)


@dataclass(frozen=True, kw_only=True)
class Pose:
    """Position of the drive wheel, mm, and heading of the car, rad."""

    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Run:
    """A run of the car; n motor positions.

    Attributes:
        motor: position phi of the motor in cam units, shape (n,), rad.
        cam_angle: angle theta of the cam, shape (n,), rad.
        tan_beta: tangent of the steering angle, shape (n,).
        heading: direction of travel, shape (n,), rad, not wrapped.
        drive_wheel: position of the left rear wheel, shape (n, 2), mm.
        front_wheel: position of the fork axis, shape (n, 2), mm.
        idle_wheel: position of the right rear wheel, shape (n, 2), mm.
    """

    motor: Array
    cam_angle: Array
    tan_beta: Array
    heading: Array
    drive_wheel: Array
    front_wheel: Array
    idle_wheel: Array


@dataclass(frozen=True, kw_only=True)
class Running:
    """A car as it runs, with the quantities that the effects in a track change.

    Attributes:
        car: dimensions, lever and slip.
        length: travel of the drive wheel's rim in one turn of the motor's shaft in cam units, mm.
        phase: angle by which the cam stands ahead on its shaft, rad.
        play: return error B at the camshaft, rad.
        friction: sliding, between rod and disc.
        wear: share of the travel that is lost at the end of the turn, growing evenly from its start.
    """

    car: Car
    length: float
    phase: float = 0.0
    play: float = 0.0
    friction: float = 0.0
    wear: float = 0.0


def turns_of(stop: float) -> int:
    """Turns of the motor's shaft in cam units that are begun up to a motor position, rad.

    Args:
        stop: motor position at which the run ends, rad.
    """
    return max(ceil(stop / TURN - 1e-9), 1)


def start_pose(track: Track) -> Pose:
    """Pose of the car at the start of the drive wheel's track."""
    x, y = track.position(0.0)
    return Pose(x=float(x), y=float(y), heading=float(track.heading(np.array([0.0]))[0]))


def wheel_radius(length: float, ratio: float) -> float:
    """Radius R_h of the drive wheel whose travel in one turn of the cam is `length`, mm (eq. 20).

    Args:
        length: length of the drive wheel's track, mm.
        ratio: transmission ratio i, turns of the drive wheel per turn of the cam.
    """
    return length / (TURN * ratio)


def driven(
    nodes: Array, wheel: Callable[[Array], Array], car: Car, length: float | Array, start: Pose, rule: Rule
) -> tuple[Array, Complex]:
    """Heading and position of the drive wheel at motor positions, by integration of eq. 21 and 23.

    Simulation, comparison of profiles and the forward model of measured tracks all run the car by this.

    Args:
        nodes: motor positions between which the steering is smooth, shape (n,), increasing, rad.
        wheel: tangent of the front wheel's angle at motor positions, shape (n - 1, s) -> the same.
        car: its dimensions and slip; its steering zero and gain are in `wheel`.
        length: travel of the drive wheel's rim in one turn of the motor's shaft in cam units, mm; where it changes
            along the run, on each step, shape (n - 1, 1).
        start: pose at the first node.
        rule: integration rule on each step, with s nodes.

    Returns:
        Heading, rad, not wrapped, and position x + iy, mm, each of shape (n,).
    """
    widths = np.diff(nodes)[:, None]
    tangent = wheel(nodes[:-1, None] + widths * rule.nodes)
    going = length / TURN * wheel_travel_ratio(tangent, car)
    turning = going * wheel_curvature(tangent, car) * widths
    heading = _summed(start.heading, turning)
    inside = heading[:-1, None] + turning @ rule.matrix.T
    travel = going * widths
    position = np.empty(len(nodes), dtype=complex)
    position.real, position.imag = _summed(start.x, travel * np.cos(inside)), _summed(start.y, travel * np.sin(inside))
    return heading, position


def _summed(start: float, parts: Array) -> Array:
    """A value at the nodes from what it gains at the places within each step, shape (n - 1, s), weighted alike."""
    gains = parts[:, 0] if parts.shape[1] == 1 else parts.mean(axis=1)
    return start + np.concatenate([[0.0], np.cumsum(gains)])


@dataclass(frozen=True, kw_only=True)
class Steered:
    """Steering of a run by motor position, looked up once for runs with any trim.

    Steps end where the cam jumps, stops, goes on or meets a kink, so the rule keeps its fourth order.

    Attributes:
        nodes: motor positions between which the steering is smooth, shape (n,), increasing, rad.
        tan_beta: tangent of the rod's steering angle at the places of `TWO_STAGE` within each step, shape (n - 1, 2).
        motor: motor positions of the result, rad.
    """

    nodes: Array
    tan_beta: Array
    motor: Array

    @classmethod
    def by(
        cls, following: Following, *, steps: int, stop: float, at_joints: bool = False, at: Array | None = None
    ) -> "Steered":
        """Look up the steering by a cam that follows the motor; arguments as for `drive`."""
        motor = np.linspace(0.0, stop, steps + 1)
        nodes = np.union1d(motor, following.joints(0.0, stop))
        if at is not None:
            nodes, motor = np.union1d(nodes, at), at
        places = nodes[:-1, None] + np.diff(nodes)[:, None] * TWO_STAGE.nodes
        return cls(nodes=nodes, tan_beta=following.tan_beta(places), motor=nodes if at_joints else motor)

    def driven(self, car: Car, length: float, start: Pose, trim: float = 0.0) -> tuple[Array, Complex]:
        """Heading, rad, and position of the drive wheel x + iy, mm, at `motor`.

        Args:
            car: dimensions of the car.
            length: travel of the drive wheel's rim in one turn of the cam, mm.
            start: pose at the first motor position.
            trim: constant added to the tangent of the rod's steering angle.
        """
        tangent = self.tan_beta + trim if trim else self.tan_beta
        heading, position = driven(self.nodes, lambda _: wheel_tangent(tangent, car), car, length, start, TWO_STAGE)
        shown = np.searchsorted(self.nodes, self.motor)
        return heading[shown], position[shown]


def drive(
    lift: PathMotion,
    car: Car,
    length: float,
    *,
    play: float = 0.0,
    start: Pose | None = None,
    steps: int | None = None,
    stop: float | None = None,
    least_swing: float = LEAST_SWING,
    following: Following | None = None,
    at_joints: bool = False,
    at: Array | None = None,
) -> Run:
    """Run the car on a cam.

    Args:
        lift: lift of the cam.
        car: dimensions of the car.
        length: travel of the drive wheel's rim in one turn of the motor's shaft in cam units, mm.
        play: return error B, rad.
        start: pose at motor position 0; the origin along x if left out.
        steps: number of even steps of the result; `STEPS` for each turn that is begun if left out.
        stop: last motor position, rad; the end of the lift's run if left out, at the closing blend or after its laps.
        least_swing: rises and falls of tan(beta) smaller than this are noise, not events.
        following: how the cam follows the motor, with friction and drag; if given, it stands for lift and play.
        at_joints: whether the result has, besides the even steps, the motor positions at which the cam jumps, stops,
            goes on or meets a kink.
        at: motor positions of the result, increasing, rad, shape (n,); the even steps if left out.

    Raises:
        DesignError: the play is negative or no number, or there are no steps.
    """
    start = start or Pose()
    stop = lift.blend_start if stop is None else stop
    if steps is None:
        steps = STEPS * turns_of(stop)
    if steps < 1:
        raise DesignError("a run of {steps} steps goes nowhere: ask for at least 1", steps=steps)
    following = following or follow(lift, play, least_swing=least_swing)
    steered = Steered.by(following, steps=steps, stop=stop, at_joints=at_joints, at=at)
    motor, heading, position = steered.motor, *steered.driven(car, length, start)
    ahead = np.exp(1j * heading)
    cam_angle = following.cam_angle(motor)
    return Run(
        motor=motor,
        cam_angle=cam_angle,
        tan_beta=lift.q(cam_angle),
        heading=heading,
        drive_wheel=_plane(position),
        front_wheel=_plane(position + (car.wheelbase - 1j * car.drive_wheel_offset) * ahead),
        idle_wheel=_plane(position - 1j * (car.drive_wheel_offset + car.idle_wheel_offset) * ahead),
    )


def _plane(z: Complex) -> Array:
    return np.stack([z.real, z.imag], axis=-1)


def poses_of(run: Run, car: Car) -> RunPoses:
    """Poses of a run.

    Args:
        run: run of the car, with what happens between its steps.
        car: the car that ran.
    """
    drive_wheel, fork = (wheel[:, 0] + 1j * wheel[:, 1] for wheel in (run.drive_wheel, run.front_wheel))
    return RunPoses(
        fork=fork,
        heading=run.heading,
        steering=-np.arctan(wheel_tangent(run.tan_beta, car)),
        travel=np.concatenate([[0.0], np.cumsum(np.abs(np.diff(drive_wheel)))]),
    )
