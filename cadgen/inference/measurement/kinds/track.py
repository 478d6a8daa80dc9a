"""Track: where the drive wheel is, by the cam angle that the motor has turned since the start.

The model goes from the motor's position to the cam angle behind the play, the steering, the heading and the place.

**Start.** Each run's start pose is set by hand, so known within a spread beforehand, and entered exactly. A path P that
begins at F, started (x, y) aside and turned by psi, is F + (x + iy) + (P - F) e^(i psi). For every path the most likely
pose is found in closed form (Kabsch 1976, in the plane). About it a pose is linear, so the residual of the turned path
plus that pose's share of the columns is what linear freedoms, with their spread about zero, explain.

**Floor.** On a slope g a car that goes in direction t creeps by a share of its travel: along t by (g . t), and across,
along n, by (g . n), each with a ratio of its own, since wheels roll along and slide across. A car whose axle is not
square to the edge by which it is set down goes crabwise, in all runs alike. The heading is disturbed as
a random walk by arc length; its Karhunen-Loeve expansion (Loeve 1978, sec. 37.5) has the waves
sin((k - 1/2) pi s / l).
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import pi, radians

import numpy as np
from numpy.typing import NDArray
from scipy.stats import chi2

from cadgen.arrays import TURN, Array
from cadgen.car.running.drive import TWO_STAGE, Running, driven, start_pose
from cadgen.car.steering import wheel_tangent
from cadgen.deviations import deviation
from cadgen.deviations.camera import CAMERA, CAMERA_EFFECTS, CameraView
from cadgen.deviations.catalogue import TRACK
from cadgen.deviations.effect import Active, Rows, through
from cadgen.deviations.track import RUNNING, STEERING, track_forms
from cadgen.deviations.transmission import MESH, RATIO, Turned
from cadgen.inference.measurement.model import Cache, Discrepancy, Model, Rolled, elapsed, fourier
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Abscissa, Column, Datum, Kind, Record, Span, refuse_twice, said_of_runs
from cadgen.messages import Message, joined

# A car set by hand against a line, where no file says how: mm and rad, standard deviations.
BY_HAND_MM, BY_HAND_RAD = 5.0, radians(0.5)
NUMBERS = (("start_x_mm", "mm"), ("start_y_mm", "mm"), ("start_heading_deg", "deg"))
# Starts that scatter so much by chance are none that were set as the file says.
CHANCE = 1e-3
_NUMBER = r"([0-9.]*[0-9])"
LEAST_COMMON = 10  # motor positions at which runs are compared; with fewer each pose has its own run's


@dataclass(frozen=True)
class StartSpread:
    """How a start was set: standard deviations of its place, mm, and heading, rad, and whether a file says so."""

    place: float
    heading: float
    stated: bool

    @property
    def spread(self) -> Array:
        """Standard deviations of x, y and heading, shape (3,)."""
        return np.array([self.place, self.place, self.heading])

    @property
    def words(self) -> Message:
        """Spread of place and heading, and who says so."""
        source = Message("as the file says") if self.stated else Message("no file says how it was set")
        degrees = np.degrees(self.heading)
        return Message("{place:g} mm and {heading:.3g}°, {source}", place=self.place, heading=degrees, source=source)


StartSpreads = tuple[StartSpread, ...]  # one for each run


def settings(record: Record) -> StartSpreads:
    """How each run was set: by its file's remark `start set to 3 mm and 0.15 deg`, or as by hand."""
    pattern = rf"\bstart\b.*?\b{_NUMBER} *mm\b.*?\b{_NUMBER} *deg\b"
    return tuple(
        StartSpread(float(stated[0]), radians(float(stated[1])), True)
        if stated and min(map(float, stated)) > 0
        else StartSpread(BY_HAND_MM, BY_HAND_RAD, False)
        for stated in said_of_runs(record, pattern)[: record.runs]
    )


def held(used: StartSpreads) -> Message:
    """Spreads that the start poses are held to, in words; runs of several files each by its own."""
    groups = _alike(used)
    if len(groups) == 1:
        return Message("held to {spread}", spread=used[0].words)
    spreads = (Message("{spread} ({runs})", spread=one.words, runs=_runs(runs)) for one, runs in groups.items())
    return Message("held to {spread}", spread=joined(spreads, "; "))


def _alike(stated: StartSpreads) -> dict[StartSpread, list[int]]:
    """Numbers of the runs that were set alike."""
    groups: dict[StartSpread, list[int]] = {}
    for run, setting in enumerate(stated):
        groups.setdefault(setting, []).append(run)
    return groups


def _runs(runs: list[int]) -> Message:
    """Runs in words, counted from 1."""
    if len(runs) == 1:
        return Message("run {number}", number=runs[0] + 1)
    if runs == list(range(runs[0], runs[-1] + 1)):
        return Message("runs {first} to {last}", first=runs[0] + 1, last=runs[-1] + 1)
    return Message("runs {numbers}", numbers=joined(str(run + 1) for run in runs))


class Starts:
    """Start poses of measured runs.

    Attributes:
        columns: response to x, y and heading of each run, shape (n, 3 runs).
    """

    def __init__(self, run: NDArray[np.intp], axis: NDArray[np.intp], measured: Array) -> None:
        """Take the rows of a track.

        Args:
            run, axis: of each row, shape (n,); rows hold first the x and then the y of a run.
            measured: coordinates, shape (n,), mm.
        """
        runs = range(int(run.max()) + 1)
        self._rows = [tuple(np.flatnonzero((run == k) & (axis == a)) for a in (0, 1)) for k in runs]
        self._measured = [measured[x] + 1j * measured[y] for x, y in self._rows]
        self.columns = np.zeros((len(run), 3 * len(self._rows)))
        for k, ((x, y), measured_run) in enumerate(zip(self._rows, self._measured, strict=True)):
            across = 1j * (measured_run - measured_run[0])
            self.columns[x, 3 * k], self.columns[y, 3 * k + 1] = 1.0, 1.0
            self.columns[x, 3 * k + 2], self.columns[y, 3 * k + 2] = across.real, across.imag

    def residual(self, place: NDArray[np.complex128]) -> Array:
        """Measured less expected coordinates, linear in the start poses, shape (n,), mm.

        Args:
            place: of the car as started by design at each row, x + iy, shape (n,), mm.
        """
        out = np.empty(len(place))
        for (x, y), measured in zip(self._rows, self._measured, strict=True):
            path = place[x] - place[x[0]]
            turned = _turned(path, measured)
            left = measured - place[x[0]] - path * np.exp(1j * turned) + 1j * turned * (measured - measured[0])
            out[x], out[y] = left.real, left.imag
        return out

    def poses(self, place: NDArray[np.complex128], motor: Array) -> Array:
        """The most likely pose of each run against a path, shape (runs, 3), mm and rad.

        Runs are compared at common motor positions, if they have any: what they share then turns and shifts each of
        them alike, also where points of one of them are missing.

        Args:
            place: of the car as started by design at each row, x + iy, shape (n,), mm.
            motor: position of the motor at each row, shape (n,), rad.
        """
        turns, start = [motor[x] for x, _ in self._rows], place[np.argmin(motor)]
        common = np.unique(motor)
        common = common[(common >= max(map(np.min, turns))) & (common <= min(map(np.max, turns)))]
        out = []
        for (x, _), measured, turn in zip(self._rows, self._measured, turns, strict=True):
            at, order = common if len(common) >= LEAST_COMMON else turn, np.argsort(turn, kind="stable")
            # Interpolated is how far a run is off, which is smoother than the run.
            path, off = (np.interp(at, turn[order], v[order]) for v in (place[x], measured - place[x]))
            path, seen = path - start, path + off - start
            turned = _turned(path, seen)
            aside = np.mean(seen - path * np.exp(1j * turned))
            out.append((aside.real, aside.imag, turned))
        return np.array(out)


def _turned(path: NDArray[np.complex128], measured: NDArray[np.complex128]) -> float:
    """By which a path is turned so that it comes nearest to what was measured, rad."""
    return float(np.angle(np.vdot(path - path.mean(), measured - measured.mean())))


def scattered(poses: Array, stated: StartSpreads) -> StartSpreads:
    """The setting that runs show which were set alike, where they scatter by more than was stated; else that.

    Args:
        poses: of each run, shape (runs, 3). What all runs share, such as an effect's, is left out.
        stated: of each run by its file.
    """
    used = list(stated)
    for setting, runs in _alike(stated).items():
        if len(runs) > 1:
            spread, freedom = np.std(poses[runs], axis=0, ddof=1), len(runs) - 1
            beyond = spread > setting.spread * np.sqrt(chi2.isf(CHANCE, freedom) / freedom)
            place = float(spread[:2].max()) if beyond[:2].any() else setting.place
            shown = replace(setting, place=place, heading=float(spread[2]) if beyond[2] else setting.heading)
            for run in runs:
                used[run] = shown
    return tuple(used)


def start_reservations(used: StartSpreads, stated: StartSpreads, values: Array, sigmas: Array) -> tuple[str, ...]:
    """Warnings about the starts: runs that scatter by more than was stated, or start off together.

    Args:
        used: settings that the runs were judged with.
        stated: of their files.
        values, sigmas: start poses as fitted and their standard deviations, shape (runs, 3), mm and rad.
    """
    found, groups = [], _alike(stated)
    for setting, runs in groups.items():
        here = "" if len(groups) == 1 else Message(" of {runs}", runs=_runs(runs))
        shown = used[runs[0]]
        if shown != setting:
            found.append(
                Message(
                    "the starts{here} scatter by {place:.3g} mm and {heading:.3g}°, not by {stated}: they were judged "
                    "with the scatter that they show; set the car against a stop",
                    here=here,
                    place=shown.place,
                    heading=np.degrees(shown.heading),
                    stated=setting.words,
                )
            )
        mean = values[runs].mean(axis=0)
        error = np.sqrt((shown.spread**2 + np.mean(sigmas[runs] ** 2, axis=0)) / len(runs))
        if chi2.sf(np.sum((mean / error) ** 2), 3) < CHANCE:
            which = Message("all runs") if len(groups) == 1 else _runs(runs)
            found.append(
                Message(
                    "{which} {start}, by ({x:.1f}, {y:.1f}) mm and {turned:.2f}°, where {place:.3g} mm and "
                    "{heading:.3g}° were expected: make sure of the camera's frame, and of the line from which the car "
                    "starts",
                    which=which if len(values) > 1 else Message("the run"),
                    start=Message("start off together") if len(runs) > 1 else Message("starts off"),
                    x=mean[0],
                    y=mean[1],
                    turned=np.degrees(mean[2]),
                    place=shown.place,
                    heading=np.degrees(shown.heading),
                )
            )
    return tuple(found)


# Of a workshop's floor and its covering: 2 mm per metre of travel, and 0.005 degrees after the first metre.
CREEP = 2e-3
WALK = radians(0.005) / 1000**0.5  # rad per root of mm
WAVES = 12
CRAB = 5e-3  # rad; the axle against the edge by which the car is set down
CREEPS = (
    ("creep_along_x_percent", "%"),
    ("creep_along_y_percent", "%"),
    ("creep_across_x_percent", "%"),
    ("creep_across_y_percent", "%"),
    ("crabwise_deg", "deg"),
)


def floor(place: NDArray[np.complex128], at: NDArray[np.intp], axis: NDArray[np.intp]) -> Discrepancy:
    """Columns of creep and of a disturbed heading.

    Args:
        place: along the track, x + iy, shape (m,), mm.
        at: which place each row shows, shape (n,).
        axis: of each row, 0 for x and 1 for y, shape (n,).
    """
    ahead = np.diff(place)
    step = np.abs(ahead)
    along = ahead / np.where(step > 0, step, 1.0)
    across = 1j * along
    moves = [part * way * step for way in (along, across) for part in (way.real, way.imag)]
    moves.append(across * step)
    travel, length = np.cumsum(step) - step / 2, float(step.sum())
    order = (np.arange(1, WAVES + 1) - 0.5) * pi
    waves = np.sqrt(2 * length) / order * np.sin(order * travel[:, None] / max(length, 1e-9))
    moves += list((waves * (1j * ahead)[:, None]).T)
    drift = np.vstack([np.zeros(len(moves)), np.cumsum(np.array(moves).T, axis=0)])[at]
    columns: Array = np.where((axis == 0)[:, None], drift.real, drift.imag)
    sigma = np.concatenate([np.full(len(CREEPS) - 1, CREEP), [CRAB], np.full(WAVES, WALK)])
    return Discrepancy("the creep of the car on the floor", columns, sigma, CREEPS, of_frame=len(CREEPS) - 1)


# Even steps of the turn, each by Gauss's rule of two places. Eight times as many move no place of the paper's car by
# more than 1e-4 mm, and by 0.02 mm on the profile against play, whose peaks are narrow.
STEPS = 720
FORM_ORDERS = 25
_KEPT = 8  # tangents at the steps of a turn
BLEND_MARGIN = np.radians(4.0)  # the cam may lead the motor by phase and play


class TrackModel(Model):
    """Where the drive wheel is at each motor position; each run's start pose is a datum.

    Rows hold first the x and then the y of a run. The form error of the cam is one of the lift, `floor` mm rms, and
    shows in the track as a twice integrated steering error.
    """

    unit = "mm"
    behind = (*Rolled.stages, RATIO, MESH)
    rolled: Rolled
    measured: Array

    def __init__(self, record: Record, nominal: Nominal) -> None:
        self.rolled, self._lift, self._forces = nominal.rolled, nominal.lift, nominal.forces
        self._car, lift, track = nominal.car, nominal.lift, nominal.track
        self._known: Cache[bytes, Array] = Cache(_KEPT)
        self._steepest = float(np.abs(lift.q(np.linspace(0.0, TURN, STEPS), nu=1)).max())
        self._nominal = Running(car=nominal.car, length=track.turn)
        self._grid = np.linspace(0.0, TURN, STEPS + 1)
        self._start = start_pose(track)
        # The closing blend steers no path and is made as each maker likes: it is not judged.
        start = lift.blend_start if nominal.blend_start is None else nominal.blend_start
        record = record.where(np.radians(record["cam_angle_deg"]) < start - BLEND_MARGIN)
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
        self.floor = nominal.form_error / self._forces.mechanics.follower.inner
        self.slip = np.empty(0)
        self._starts = Starts(run, axis, self.measured)
        self.stated = settings(record)
        self.used = scattered(self._starts.poses(self.place([]), self._motor), self.stated)
        self.offsets, self.spread = self._starts.columns, np.concatenate([one.spread for one in self.used])
        angle, mean = self._mean()
        # A camera is aimed at the middle of the field that the track takes up.
        middle = complex(np.ptp(mean.real) / 2 + mean.real.min(), np.ptp(mean.imag) / 2 + mean.imag.min())
        self._view, self.cameras = (
            CameraView(middle, float(np.abs(mean - middle).max()), complex(self.place([])[0])),
            CAMERA_EFFECTS,
        )
        at = np.searchsorted(angle, self._motor).astype(np.intp)
        self.form, self.order = self._form_response(angle, mean, at)
        self.discrepancy = floor(mean, at, axis)

    def residual(self, active: Active) -> Array:
        """Measured less expected coordinates, linear in the start poses (see `start`), mm."""
        return self._starts.residual(self.place(active))

    def shown_spread(self, poses: Array) -> Array:
        """Standard deviations of start poses, shape (3 runs,), mm and rad: as runs scatter where no file says them.

        What is usual of a car set by hand counts as much as one run does.

        Args:
            poses: of each run as found, shape (runs, 3), mm and rad.
        """
        spread, by_hand = self.spread.reshape(-1, 3).copy(), [not one.stated for one in self.used]
        if sum(by_hand) > 1:
            scatter = np.sum((poses[by_hand] - poses[by_hand].mean(axis=0)) ** 2, axis=0)
            spread[by_hand] = np.sqrt((spread[by_hand] ** 2 + scatter) / sum(by_hand))
        return spread.ravel()

    def as_logged(self, active: Active) -> Array:
        """Measured less expected coordinates of a car started as by design, mm."""
        place = self.place(active)
        return np.asarray(self.measured - np.where(self._axis == 0, place.real, place.imag))

    def place(self, active: Active) -> NDArray[np.complex128]:
        """Where the car is at each row, started as by design, x + iy, mm."""
        place = self.at(active, self._motor)
        if not any(effect.stage is CAMERA for effect, _ in active):
            return place
        return np.asarray(through(CAMERA, place, active, self._view))

    def finish(self, active: Active) -> complex:
        """Where the run ends, at the beginning of the cam's closing blend, x + iy, mm."""
        return complex(self.at(active, np.array([self._lift.blend_start]))[0])

    def at(self, active: Active, motor: Array) -> NDArray[np.complex128]:
        """Place of the car at any motor positions, started as by design, x + iy, mm.

        Args:
            active: effects that are active, with their values.
            motor: motor positions, rad, shape (n,).
        """
        run = through(RUNNING, self._nominal, active, self._grid)
        change = self.rolled.change(active, self.rows)
        # Steps end where the lift has a kink or the cam jumps: the place then answers evenly to what moves a jump.
        joints, following = self._lift.kinks - run.phase, None
        if run.play > 0:
            lift = self.rolled.lift(active, self.rows)
            following = self._forces.leads(run.friction, lift=None if change is None else lift).follow(lift, run.play)
            joints = np.append(joints, following.joints(run.phase, TURN + run.phase) - run.phase)
        joints = (joints - (self._asked(joints, active) - joints)) % TURN
        nodes = np.union1d(self._grid, joints) if len(joints) else self._grid

        def wheel(motor: Array) -> Array:
            angle = self._asked(motor, active) + run.phase
            at = angle if following is None else following.cam_angle(angle)
            # Most effects leave cam angles as they are.
            rod = self._known.of(at.tobytes(), lambda: self._lift.q(at))
            return through(STEERING, wheel_tangent(rod if change is None else rod + change(at), run.car), active, motor)

        length = run.length * (1 - run.wear * (nodes[1:] + nodes[:-1])[:, None] / 2 / TURN)
        heading, place = driven(nodes, wheel, run.car, length, self._start, TWO_STAGE)
        at = np.interp(motor, nodes, np.arange(len(nodes)))
        low = np.minimum(at.astype(np.intp), len(nodes) - 2)
        # Within a step the car goes on an arc.
        share, bend = at - low, (heading[low + 1] - heading[low]) / 2
        return np.asarray(place[low] + (share - 1j * bend * share * (1 - share)) * (place[low + 1] - place[low]))

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


PLANNED_ROWS = 36


def _extent(x: Array, y: Array) -> float:
    return float(np.hypot(np.ptp(x), np.ptp(y)))


def _spans(record: Record, nominal: Nominal) -> Iterable[Span]:
    share = np.radians(record["cam_angle_deg"]) / (2 * pi)
    path = nominal.track.position(np.clip(share * nominal.track.turn, 0.0, nominal.track.length))
    yield Span("x_mm, y_mm", _extent(record["x_mm"], record["y_mm"]), _extent(*path.T), "mm")


KIND = Kind(
    code="track",
    title=Message("Track"),
    columns=(
        Column(name="cam_angle_deg", lower=-1.0, upper=361.0, least_span=10.0),
        Column(name="x_mm", lower=-1e6, upper=1e6),
        Column(name="y_mm", lower=-1e6, upper=1e6),
    ),
    readings=("x_mm", "y_mm"),
    catalogue=TRACK,
    datum=Datum(
        words="the start pose of each run",
        name="start pose",
        numbers=NUMBERS,
        notes=lambda model, values, sigmas: (
            held(model.used),
            start_reservations(model.used, model.stated, values, sigmas),
        ),
    ),
    model=TrackModel,
    check=lambda record: refuse_twice(record, np.stack([record.run, record["cam_angle_deg"]]), "cam_angle_deg"),
    spans=_spans,
    absences=(deviation.RETURN_ERROR, deviation.SLIDING_FRICTION),
    noise=3.0,
    nearness=1,
    rod_on=True,
    abscissa=Abscissa.TRAVEL,
    plan_view=True,
)


def run_of(nominal: Nominal) -> TrackModel:
    """The model of a car that runs as designed: for what effects do to its run, where no track was measured."""
    motor = np.arange(0.0, 360.0, 360.0 / PLANNED_ROWS)
    x, y = nominal.track.position(np.minimum(motor / 360.0 * nominal.track.turn, nominal.track.length)).T
    columns = {"cam_angle_deg": motor, "x_mm": x, "y_mm": y}
    run = np.zeros(len(motor), dtype=np.intp)
    return TrackModel(Record(kind=KIND, columns=columns, run=run, remarks=(), source="the planned track"), nominal)
