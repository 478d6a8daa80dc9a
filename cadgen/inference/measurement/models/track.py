"""The track of the drive wheel: motor position -> cam angle behind the play -> steering -> heading -> place."""

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.car.motion.drive import MIDPOINT, Running, driven, start_pose
from cadgen.car.path.track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.steering import Car, wheel_tangent
from cadgen.deviations.catalogue import TRACK
from cadgen.deviations.effect import Active, Effect, Rows, through
from cadgen.deviations.track import RUNNING, STEERING, track_forms
from cadgen.deviations.transmission import MESH, RATIO, Turned
from cadgen.inference.measurement.models.base import elapsed, fourier
from cadgen.inference.measurement.models.floor import floor as floor_of
from cadgen.inference.measurement.models.forces import Forces
from cadgen.inference.measurement.models.rolled import Rolled
from cadgen.inference.measurement.models.start import Starts, scattered, settings
from cadgen.inference.measurement.recent import Recent
from cadgen.inference.measurement.record import Record

# Even steps of the turn. The midpoint rule errs by under 0.05 mm at the end of the paper's path.
STEPS = 2880
FORM_ORDERS = 25
_KEPT = 8  # tangents at the steps of a turn
BLEND_MARGIN = np.radians(4.0)  # the cam may lead the motor by phase and play


class TrackModel:
    """Where the drive wheel is at each motor position; each run's start pose is a datum.

    Rows hold first the x and then the y of a run. The form error of the cam is one of the lift, `floor` mm rms, and
    shows in the track as a twice integrated steering error.
    """

    unit = "mm"
    tangent = resolved = None
    behind = (*Rolled.stages, RATIO, MESH)

    def __init__(
        self, record: Record, rolled: Rolled, lift: PathMotion, car: Car, track: Track, forces: Forces, *, floor: float
    ) -> None:
        self.rolled, self._lift, self._car, self._forces = rolled, lift, car, forces
        self._known: Recent[tuple[int, bytes], tuple[PathMotion, Array]] = Recent(_KEPT)
        self._steepest = float(np.abs(lift.q(np.linspace(0.0, TURN, STEPS), nu=1)).max())
        self._nominal = Running(car=car, length=track.turn)
        self._grid = np.linspace(0.0, TURN, STEPS + 1)
        self._start = start_pose(track)
        # The closing blend steers no path and is made as each maker likes: it is not judged.
        record = record.where(np.radians(record["cam_angle_deg"]) < lift.blend_start - BLEND_MARGIN)
        motor = np.radians(record["cam_angle_deg"])
        xy = np.stack([record["x_mm"], record["y_mm"]])
        order = np.concatenate(
            [np.flatnonzero(record.run == k)[None, :].repeat(2, 0).ravel() for k in range(record.runs)]
        )
        axis = np.concatenate([np.repeat([0, 1], int(np.sum(record.run == k))) for k in range(record.runs)])
        self._motor, self._axis = motor[order], axis
        self.measured = xy[axis, order]
        run = record.run[order]
        key = np.round(record["cam_angle_deg"][order], 6) + 1000.0 * axis
        self.rows = Rows(
            run=run,
            place=self._motor,
            elapsed=elapsed(run),
            cell=np.unique(key, return_inverse=True)[1].astype(np.intp),
        )
        self.catalogue = (*TRACK.effects, *track_forms())
        self.shapes: tuple[Effect, ...] = ()
        self.datum: tuple[Effect, ...] = ()
        self.floor = floor / forces.mechanics.follower.inner
        self.slip = np.empty(0)
        self._starts = Starts(run, axis, self.measured)
        self.stated = settings(record)
        self.used = scattered(self._starts.poses(self.place([])), self.stated)
        self.offsets, self.spread = self._starts.columns, np.concatenate([one.spread for one in self.used])
        angle, mean = self._mean()
        at = np.searchsorted(angle, self._motor).astype(np.intp)
        self.form, self.order = self._form_response(angle, mean, at)
        self.discrepancy = floor_of(mean, at, axis)

    def residual(self, active: Active) -> Array:
        """Measured less expected coordinates, linear in the start poses (see `start`), mm."""
        return self._starts.residual(self.place(active))

    def as_logged(self, active: Active) -> Array:
        """The same, started as by design, mm."""
        place = self.place(active)
        return np.asarray(self.measured - np.where(self._axis == 0, place.real, place.imag))

    def place(self, active: Active) -> NDArray[np.complex128]:
        """Where the car is at each row, started as by design, x + iy, mm."""
        return self.at(active, self._motor)

    def finish(self, active: Active) -> complex:
        """Where the run ends, at the beginning of the cam's closing blend, x + iy, mm."""
        return complex(self.at(active, np.array([self._lift.blend_start]))[0])

    def at(self, active: Active, motor: Array) -> NDArray[np.complex128]:
        """The same at any motor positions, rad.

        Args:
            active: effects that are active, with their values.
            motor: motor positions, rad, shape (n,).
        """
        run = through(RUNNING, self._nominal, active, self._grid)
        lift = self.rolled.lift(active, self.rows)
        nodes, following = self._grid, None
        if run.play > 0:
            # Steps end where the cam jumps, so that the place answers evenly to what moves a jump.
            changed = None if lift is self._lift else lift
            following = self._forces.leads(run.friction, lift=changed).follow(lift, run.play)
            joints = following.joints(run.phase, TURN + run.phase) - run.phase
            nodes = np.union1d(nodes, joints - (self._asked(joints, active) - joints))

        def wheel(motor: Array) -> Array:
            angle = self._asked(motor, active) + run.phase
            rod = self._tangents(lift, angle if following is None else following.cam_angle(angle))
            return through(STEERING, wheel_tangent(rod, run.car), active, motor)

        length = run.length * (1 - run.wear * (nodes[1:] + nodes[:-1])[:, None] / 2 / TURN)
        _, place = driven(nodes, wheel, run.car, length, self._start, MIDPOINT)
        at = np.interp(motor, nodes, np.arange(len(nodes)))
        low = np.minimum(at.astype(np.intp), len(nodes) - 2)
        return np.asarray(place[low] + (at - low) * (place[low + 1] - place[low]))

    def _tangents(self, lift: PathMotion, cam_angle: Array) -> Array:
        """tan(beta) of the rod; remembered, for most effects leave lift and cam angles as they are."""
        # With the lift, so that no other one is taken for it.
        return self._known.of((id(lift), cam_angle.tobytes()), lambda: (lift, lift.q(cam_angle)))[1]

    def _asked(self, motor: Array, active: Active) -> Array:
        """Cam angle that the gears ask for at motor positions, rad; the cam is set on its shaft at the start."""
        if not any(effect.stage in (RATIO, MESH) for effect, _ in active):
            return motor
        turned = np.append(motor.ravel(), 0.0)
        slope = np.asarray(self._lift.q(turned % TURN, nu=1))
        at = Turned(turned=turned, torque=slope / self._steepest)
        asked = through(MESH, through(RATIO, turned, active, at), active, at)
        return np.asarray((asked[:-1] - asked[-1]).reshape(motor.shape))

    def _mean(self) -> tuple[Array, NDArray[np.complex128]]:
        """Motor positions, in order, and the mean of what was measured there, x + iy."""
        angle = np.unique(self._motor)
        mean = np.zeros((2, len(angle)))
        for axis in (0, 1):
            mine = self._axis == axis
            which = np.searchsorted(angle, self._motor[mine])
            mean[axis] = np.bincount(which, self.measured[mine]) / np.bincount(which)
        return angle, mean[0] + 1j * mean[1]

    def _form_response(self, angle: Array, mean: NDArray[np.complex128], at: NDArray[np.intp]) -> tuple[Array, Array]:
        """How the places answer a steering error of each order, about the measured track."""
        ahead = np.diff(mean)
        middle = (angle[1:] + angle[:-1]) / 2
        T = self._lift.q(middle)
        lever = self._car.steering_gain
        gain = -self._car.wheelbase * lever / (self._car.wheelbase + self._car.drive_wheel_offset * lever * T) ** 2
        waves, order = fourier(middle, FORM_ORDERS)
        turn = waves * (gain * np.abs(ahead))[:, None]
        heading = np.cumsum(turn, axis=0) - turn / 2
        place = np.vstack([np.zeros(waves.shape[1]), np.cumsum(heading * (1j * ahead)[:, None], axis=0)])[at]
        return np.where((self._axis == 0)[:, None], place.real, place.imag), order
