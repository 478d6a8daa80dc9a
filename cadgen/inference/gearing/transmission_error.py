"""Transmission error of a train by orders: play, wind-up, friction, rate, and lines, each with what shows it.

The transmission error is the output angle less the input angle over the ratio, TE = θ_out − θ_in/i. At the forward
flanks (side s = +1) the input pushes the output forward; at the others s = −1. The model is linear in

    TE = zero of the run + rate·θ − s·B/2 + T/k − d·h − τ·dθ/dt + Σ lines at their orders, by side,

with play B, torque T of the output, stiffness k, and h the wind-up by friction, which is against the motion d. A lag τ
of the output's reading, or drag, is told from play where times stand beside the angles and the speed changes. Without
load the side goes by the motion, and B and 2h are one number. Under load it goes by the torque, and h is seen alone.

Lines are chosen one by one while each explains more than noise does, by an F-test with a limit for all that were tried;
noise of neighbouring rows may be alike (first order autoregression, Cochrane and Orcutt 1949, doi:10.2307/2280349).
Two orders are one where the record is too short to tell them apart; the lines of the slower shafts come first.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from math import degrees, pi

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar
from scipy.stats import f as fisher

from cadgen.arrays import Array
from cadgen.errors import FileError
from cadgen.inference.gearing.train_orders import SeenMesh, SeenShaft, SeenTrain
from cadgen.inference.measurement.record import Record

CHANCE = 1e-3  # that noise alone brings one line
_APART = 0.75  # difference of two orders times turns of the output from which on they are two
_RESOLVED = 0.45  # order times the step of rows, turns, up to which a line shows
_TOOTH_HARMONICS = 3
_MOST_HARMONICS = 12  # of a shaft's turn, beside the first
_COLUMNS = 0.25  # most columns by rows
_LOADED = 0.02  # share of the greatest torque from which on it decides the side
_AT_FIRST = 0.25  # the same while the friction, which holds against it, is not known
_PASSES = 3
_LEAST_USED = 12  # rows
_TOLD = 1e-6  # share of a column that the others do not hold
_BENT = 1e-3  # of a slow shaft's wave that zero and rate do not hold, rms
_HELD = 1e-6  # rad at the output, within which the input is held
_UNNAMED = 3  # lines of no part that are looked for
_ROUNDS = 8
_ALIKE = 0.05  # by which the likeness of neighbouring noise must be greater to begin anew
_NEIGHBOURS = 2.0  # difference of orders times turns up to which chosen lines may be one between them
_FINE = 40  # orders that are tried between two


@dataclass(frozen=True, kw_only=True, eq=False)
class TrainReadings:
    """Rows of a record of a train. Angles are rad, torque N m, arrays of shape (n,).

    Attributes:
        run: number of the run.
        nominal: output angle that the ratio gives from the input.
        error: transmission error.
        torque: at the output, positive where it turns it forward.
        speed: of the output by the input, rad/s; nan without times.
        motion: sense of the motion, 1 or −1: of the input, or of the torque while the input is held.
        held: whether the input is held.
        side: flanks in contact, 1 where the input pushes the output forward, else −1.
        used: whether the row is used: not within the play after the motion turned.
        turned: whether the output turns against what the train's sense says.
        pressed: whether the sign of the torque was changed, for it fits the other way round.
        ignored: whether a torque was given that shows nowhere in the angles, and that friction holds.
    """

    run: NDArray[np.intp]
    nominal: Array
    error: Array
    torque: Array
    speed: Array
    motion: Array
    held: NDArray[np.bool_]
    side: Array
    used: NDArray[np.bool_]
    turned: bool
    pressed: bool = False
    ignored: bool = False

    @property
    def turning(self) -> float:
        """Share of the rows at which the input turns back, 0 to 1: two thirds where rows stand in any order."""
        back = 0
        for number in np.unique(self.run):
            steps = np.sign(np.diff(self.nominal[self.run == number]))
            back += int(np.count_nonzero(steps[1:] * steps[:-1] < 0))
        return back / len(self.run)


@dataclass(frozen=True, kw_only=True, eq=False)
class OrderLine:
    """Line of the transmission error at an order.

    Attributes:
        order: order.
        forward, backward: complex amplitudes at forward and other flanks, of exp(i·order·θ), rad; the same where one
            side alone was measured.
        sigma: standard deviation of either amplitude's parts, rad.
        shafts: numbers of shafts and their harmonics that have the order, the likeliest first.
        meshes: stages and harmonics of the tooth mesh that have it.
        sideband: orders of two named lines whose sum or difference it is, as of two wheels off their axes; or None.
        alias: part that passes too fast for the rows, and shows at this order in evenly spaced ones; or None.
    """

    order: float
    forward: complex
    backward: complex
    sigma: float
    shafts: tuple[tuple[int, int], ...] = ()
    meshes: tuple[tuple[int, int], ...] = ()
    sideband: tuple[float, float] | None = None
    alias: SeenShaft | SeenMesh | None = None

    @property
    def size(self) -> float:
        """Amplitude, the greater one of both sides, rad."""
        return max(abs(self.forward), abs(self.backward))

    @property
    def named(self) -> bool:
        """Whether a part of the design has the order."""
        return bool(self.shafts or self.meshes or self.sideband or self.alias)


@dataclass(frozen=True)
class Estimate:
    """Number with its standard deviation."""

    value: float
    sigma: float

    @property
    def clear(self) -> bool:
        """Whether it differs from 0 by four standard deviations."""
        return abs(self.value) > 4 * self.sigma


@dataclass(frozen=True, kw_only=True, eq=False)
class TrainErrors:
    """Errors of a train by a record. Angles at the output, rad.

    Attributes:
        readings: rows.
        both: whether both flanks were measured.
        play: play B, with the wind-up 2h of friction where no load tells them apart; None with one side alone in
            each run.
        loaded: whether loads tell play and friction apart.
        compliance: 1/k, rad per N m; None without load.
        friction: h; None where it shows nothing.
        lag: time by which the output is read later than the input, or drag that looks like it, s; None where it does
            not show.
        rate: share by which the output turns faster than the ratio says.
        lines: lines that explain more than noise, those with a name first.
        noise: standard deviation of a reading, and its likeness to the row before.
        left: rms of what is left.
        before: rms of the transmission error, its zero and rate taken out.
        unresolved: orders of shafts that the record is too short for, or meshes whose teeth pass too fast.
        fast: those that the rows are too far apart for.
        repeats: rms over noise of what repeats from run to run without a name; None without repetition.
        residual: what is left, shape (n,); nan where a row is not used.
    """

    readings: TrainReadings
    both: bool
    play: Estimate | None
    loaded: bool
    compliance: Estimate | None
    friction: Estimate | None
    lag: Estimate | None
    rate: Estimate
    lines: tuple[OrderLine, ...]
    noise: float
    likeness: float
    left: float
    before: float
    slow: tuple[SeenShaft, ...]
    fast: tuple[SeenShaft | SeenMesh, ...]
    repeats: float | None
    residual: Array

    @property
    def explained(self) -> bool:
        """Whether no line and nothing that repeats is left without a name."""
        return all(line.named for line in self.lines) and (self.repeats is None or self.repeats < _REPEATS)

    def line_of(self, shaft: int) -> OrderLine | None:
        """Line once a turn of a shaft, by its number."""
        return next((line for line in self.lines if line.shafts[:1] == ((shaft, 1),)), None)


_REPEATS = 1.5  # rms of the mean over runs by that of noise from which on it is no noise


@dataclass(eq=False)
class _Candidate:
    order: float
    shafts: list[tuple[int, int]] = field(default_factory=list)
    meshes: list[tuple[int, int]] = field(default_factory=list)


def readings_of(record: Record, train: SeenTrain, widest: float) -> TrainReadings:
    """Rows of a record, with their side and motion.

    Args:
        record: angles of input and output, and torque (`record_kinds.one_of`).
        train: train.
        widest: play up to which rows after a turning point are left out, rad.
    """
    nominal = np.radians(record["input_angle_deg"]) / train.ratio
    output = np.radians(record["output_angle_deg"])
    run = record.run
    moved = [(output[rows] - output[rows].mean()) @ (nominal[rows] - nominal[rows].mean()) for rows in record.parts]
    against = sum(moved) < 0 if any(moved) else train.sense < 0
    output = -output if against else output
    torque = record["output_torque_Nm"]
    motion = np.zeros(len(run))
    since = np.zeros(len(run))
    held = np.zeros(len(run), dtype=bool)
    for rows in record.parts:
        held[rows] = np.ptp(nominal[rows]) < _HELD
        motion[rows], since[rows] = _senses(torque[rows] if held[rows][0] else nominal[rows])
    since[held] = np.inf
    readings = TrainReadings(
        run=run,
        nominal=nominal,
        error=output - nominal,
        torque=torque,
        speed=_speed(nominal, record),
        motion=motion,
        held=held,
        side=motion,
        used=(since > widest) & (motion != 0),
        turned=against != (train.sense < 0),
    )
    # A steady load decides the side as one that changes does: it is not the load that changes that matters.
    return _by_load(readings, None) if torque.any() else readings


def _speed(nominal: Array, record: Record) -> Array:
    """Speed of the output by its neighbours in time, rad/s; nan without times, or where they do not grow."""
    time = record["t_s"]
    speed = np.full(len(nominal), np.nan)
    for rows in record.parts:
        t, q = time[rows], nominal[rows]
        if len(t) > 2 and (np.diff(t) > 0).all():
            speed[rows] = np.gradient(q, t)
    return speed


def _by_load(readings: TrainReadings, friction: float | None) -> TrainReadings:
    """Readings whose side goes by the torque that friction leaves, where there is some.

    Args:
        readings: readings.
        friction: torque of friction, N m; None where it is not known yet.
    """
    most = np.abs(readings.torque).max()
    left = readings.torque - (friction or 0.0) * readings.motion
    least = _AT_FIRST * most if friction is None else max(_LOADED * most, 0.2 * abs(friction))
    loaded = np.abs(left) > least
    used = readings.used | (loaded & (readings.motion != 0))
    for number in np.unique(readings.run):
        rows = readings.run == number
        if (readings.torque[rows] > 0).any() and (readings.torque[rows] < 0).any():
            used[rows] &= loaded[rows]
    return replace(readings, side=np.where(loaded, -np.sign(left), readings.motion), used=used)


def _senses(values: Array) -> tuple[Array, Array]:
    """Sense of a motion at each row, and the way since it turned."""
    steps = np.diff(values)
    least = 1e-9 * max(np.ptp(values), 1e-300)
    sense = np.zeros(len(values))
    way = np.zeros(len(values))
    last, turn = 0.0, values[0]
    for k in range(1, len(values)):
        step = steps[k - 1]
        if abs(step) > least and np.sign(step) != last:
            turn, last = values[k - 1], float(np.sign(step))
            way[k - 1] = 0.0  # the turning point may lie before this row
        sense[k], way[k] = last, abs(values[k] - turn)
    sense[0] = sense[1] if len(sense) > 1 else 0.0
    return sense, way


def train_errors(record: Record, train: SeenTrain, widest: float) -> TrainErrors:
    """Parts of the transmission error of a train.

    Args:
        record: angles of input and output, and torque (`record_kinds.one_of`).
        train: train.
        widest: greatest play to expect, rad; rows within it after a turning point are left out at first.

    Raises:
        FileError: too few rows beyond the play after the turning points.
    """
    readings = readings_of(record, train, widest)
    if readings.used.sum() < _LEAST_USED:
        raise FileError(
            "{file}: after each turning point {widest:.2f}° at the output are left out, since the play is passed "
            "there, and only {rows} rows are left: turn on by more than that each way, in smaller steps",
            file=record.source,
            widest=degrees(widest),
            rows=int(readings.used.sum()),
        )
    found = _fitted(readings, train)
    if found.play is not None and found.play.value > 0:
        rubbed = 2 * abs(found.friction.value if found.friction else 0.0)
        near = 1.2 * (found.play.value + 4 * found.play.sigma + rubbed)
        found = _fitted(readings_of(record, train, near), train)
    given = found.readings
    if not given.torque.any():
        return found
    senses = np.where(given.held, -given.motion, given.motion)
    back = _by_load(replace(given, torque=-given.torque, motion=senses, pressed=True), None)
    other = _fitted(back, train)
    wound = found.compliance
    ahead = found.play is not None and found.play.value < 0 and found.play.clear
    behind = ahead and other.play is not None and other.play.value > 0
    if other.left < 0.7 * found.left or (wound is not None and wound.value < 0 and wound.clear) or behind:
        found = other
    if not given.held.any() and _unmoved(found):
        columns = record.columns | {"output_torque_Nm": np.zeros(len(record.run))}
        found = train_errors(replace(record, columns=columns), train, widest)
        return replace(found, readings=replace(found.readings, ignored=True))
    for _ in range(_PASSES):
        if found.friction is None or found.compliance is None or not found.compliance.value > 0:
            break
        rub = max(found.friction.value / found.compliance.value, 0.0)
        found = _fitted(_by_load(found.readings, rub), train)
    return found


def _unmoved(found: TrainErrors) -> bool:
    """Whether friction holds against every torque, so that the side goes by the motion, as without load.

    Friction that winds the train up by h is a torque h k. It is greater than the greatest torque T where h > T/k, with
    the greatest compliance 1/k that the readings leave. A torque that does not change within a run says that nowhere;
    it is taken as none where play between runs with it and without it does not show.
    """
    rub, wound = found.friction, found.compliance
    if rub is None or not rub.clear:
        return False
    if wound is None:
        return found.play is not None and not found.play.clear
    most = float(np.abs(found.readings.torque).max())
    return abs(rub.value) - 4 * rub.sigma > (max(wound.value, 0.0) + 4 * wound.sigma) * most


def _candidates(
    readings: TrainReadings, train: SeenTrain
) -> tuple[list[_Candidate], list[SeenShaft], list[SeenShaft | SeenMesh]]:
    """Orders that may show, those of slow shafts first; shafts too slow and parts too fast for the record."""
    used = readings.used
    turns = np.ptp(readings.nominal[used]) / (2 * pi) if used.any() else 0.0
    steps = np.abs(np.diff(readings.nominal))[readings.run[1:] == readings.run[:-1]]
    moving = steps[steps > 1e-12]
    highest = _RESOLVED * 2 * pi / float(np.median(moving)) if moving.size else 0.0
    found: list[_Candidate] = []
    slow: list[SeenShaft] = []
    fast: list[SeenShaft | SeenMesh] = []

    def add(order: float, shaft: tuple[int, int] | None = None, mesh: tuple[int, int] | None = None) -> None:
        known = next((each for each in found if abs(each.order - order) * turns < _APART), None)
        if known is None:
            known = _Candidate(order)
            found.append(known)
        if shaft:
            known.shafts.append(shaft)
        if mesh:
            known.meshes.append(mesh)

    for shaft in sorted(train.shafts, key=lambda each: each.order):
        if shaft.order > highest:
            fast.append(shaft)
        elif shaft.order * turns < _APART:
            slow.append(shaft)
        else:
            add(shaft.order, shaft=(shaft.number, 1))
    for harmonic in range(1, _TOOTH_HARMONICS + 1):
        for mesh in train.meshes:
            if harmonic * mesh.order <= highest and mesh.order * turns >= _APART:
                add(harmonic * mesh.order, mesh=(mesh.stage, harmonic))
            elif harmonic == 1:
                fast.append(mesh)
    for harmonic in range(2, _MOST_HARMONICS + 1):
        for shaft in sorted(train.shafts, key=lambda each: each.order):
            teeth = max((wheel.teeth for wheel in shaft.wheels), default=0)
            if harmonic <= teeth / 2 and harmonic * shaft.order <= highest and shaft.order * turns >= _APART:
                add(harmonic * shaft.order, shaft=(shaft.number, harmonic))
    return found, slow, fast


@dataclass(eq=False)
class _OrderFit:
    """Least squares on whitened columns."""

    values: Array
    sigmas: Array
    left: Array
    squares: float
    free: int


def _whitened(columns: Array, start: NDArray[np.bool_], likeness: float) -> Array:
    """Columns whose noise is no longer alike from row to row, shape as given, (n, k)."""
    before = np.vstack([columns[:1], columns[:-1]])
    return np.where(start[:, None], columns * np.sqrt(1 - likeness**2), columns - likeness * before)


def _least_squares(columns: Array, values: Array) -> _OrderFit:
    scale = np.linalg.norm(columns, axis=0)
    scale[scale == 0] = 1.0
    q, r = np.linalg.qr(columns / scale)
    solved = np.linalg.lstsq(r, q.T @ values, rcond=1e-10)[0]
    left = values - columns / scale @ solved
    free = max(len(values) - columns.shape[1], 1)
    squares = float(left @ left)
    spread = np.linalg.pinv(r) * np.sqrt(squares / free)
    return _OrderFit(solved / scale, np.linalg.norm(spread, axis=1) / scale, left, squares, free)


def _fitted(readings: TrainReadings, train: SeenTrain) -> TrainErrors:
    used = readings.used
    run, theta, side = readings.run[used], readings.nominal[used], readings.side[used]
    motion, torque, error = readings.motion[used], readings.torque[used], readings.error[used]
    start = np.concatenate([[True], (run[1:] != run[:-1]) | (np.diff(np.flatnonzero(used)) > 1)])
    runs = np.unique(run)
    both = bool((side > 0).any() and (side < 0).any())
    base = {"zero": np.array(run[:, None] == runs, dtype=float), "rate": (theta - theta.mean())[:, None]}
    # Each run has its own zero, and motion, side and torque may go together: only what is told from the others counts.
    for name, column in (("play", -side / 2), ("torque", torque), ("friction", -motion)):
        basis = np.linalg.qr(np.hstack(list(base.values())))[0]
        if np.linalg.norm(column - basis @ (basis.T @ column)) > _TOLD * np.linalg.norm(column):
            base[name] = column[:, None]

    def columns_of(order: float) -> Array:
        wave = np.stack([np.cos(order * theta), np.sin(order * theta)], axis=1)
        return np.hstack([wave, side[:, None] * wave]) if both else wave

    candidates, slow, fast = _candidates(readings, train)
    # The part of a turn of a slow shaft's run-out, which else leaks into orders of no part.
    for shaft in slow:
        basis = np.linalg.qr(np.hstack(list(base.values())))[0]
        wave = np.stack([np.cos(shaft.order * theta), np.sin(shaft.order * theta)], axis=1)
        own = wave - basis @ (basis.T @ wave)
        directions, sizes = np.linalg.svd(own, full_matrices=False)[:2]
        if (told := directions[:, sizes > _BENT * np.sqrt(len(theta))]).size:
            base[f"part of shaft {shaft.number}"] = told
    wide = 4 if both else 2
    room = max(int(_COLUMNS * len(error)) // wide, 1)
    candidates = candidates[:room]
    plain = np.hstack(list(base.values()))
    waves = {each.order: columns_of(each.order) for each in candidates}
    whole = np.hstack([plain, *waves.values()])
    likeness = _likeness(whole, error, start)
    if (speed := readings.speed[used]).size and np.isfinite(speed).all():
        late = -speed[:, None]
        if _shows(late, whole, error, start, likeness):
            base["lag"] = late
            plain = np.hstack(list(base.values()))
            likeness = _likeness(np.hstack([plain, *waves.values()]), error, start)
    chosen: list[float] = []
    unnamed: list[_Candidate] = []
    for _ in range(_ROUNDS):
        white = _whitened(error[:, None], start, likeness)[:, 0]
        fixed = _whitened(plain, start, likeness)
        pool = {order: _whitened(wave, start, likeness) for order, wave in waves.items()}
        chosen = _chosen(fixed, white, pool)
        left = _least_squares(np.hstack([fixed, *(pool[order] for order in chosen)]), white).left
        alike = _likeness(np.hstack([plain, *(waves[order] for order in chosen)]), error, start)
        if alike > likeness + _ALIKE:
            # Many columns take the slow part of the noise along.
            likeness = alike
            continue
        spare = [each.order for each in candidates if not each.meshes and each.shafts[0][1] > 1]
        if swapped := _foreign(fixed, white, pool, chosen, spare, columns_of, start, likeness, theta):
            gone, extra = swapped
            chosen = [order for order in chosen if order not in gone]
            unnamed.append(_Candidate(extra))
            waves = {order: wave for order, wave in waves.items() if order not in gone} | {extra: columns_of(extra)}
            likeness = _likeness(np.hstack([plain, *(waves[order] for order in [*chosen, extra])]), error, start)
            continue
        other = _other_order(left, theta, [*waves, 0.0], start, fixed.shape[1])
        if other is None or len(unnamed) == _UNNAMED:
            break
        unnamed.append(_Candidate(other))
        waves[other] = columns_of(other)
    whole = np.hstack([plain, *(waves[order] for order in chosen)])
    fit = _least_squares(_whitened(whole, start, likeness), _whitened(error[:, None], start, likeness)[:, 0])
    place, numbers = 0, {}
    for name, block in base.items():
        numbers[name] = slice(place, place + block.shape[1])
        place += block.shape[1]

    def estimate(name: str, factor: float = 1.0) -> Estimate | None:
        if name not in numbers:
            return None
        at = numbers[name].start
        return Estimate(float(fit.values[at]) * factor, float(fit.sigmas[at]) * factor)

    lines = []
    for order in chosen:
        c, s = fit.values[place], fit.values[place + 1]
        dc, ds = (fit.values[place + 2], fit.values[place + 3]) if both else (0.0, 0.0)
        sigma = float(np.mean(fit.sigmas[place : place + wide])) * (2**0.5 if both else 1.0)
        known = next(each for each in [*candidates, *unnamed] if each.order == order)
        lines.append(
            OrderLine(
                order=order,
                forward=complex(c + dc, -(s + ds)),
                backward=complex(c - dc, -(s - ds)),
                sigma=sigma,
                shafts=tuple(known.shafts),
                meshes=tuple(known.meshes),
            )
        )
        place += wide
    lines = _with_causes(lines, theta, start, fast)
    left = error - whole @ fit.values
    bare = _least_squares(np.hstack([base["zero"], base["rate"]]), error).left
    residual = np.full(len(used), np.nan)
    residual[used] = left
    rate, play, friction = estimate("rate"), estimate("play"), estimate("friction")
    assert rate is not None
    return TrainErrors(
        readings=readings,
        both=both,
        play=play,
        loaded=play is not None and friction is not None,
        compliance=estimate("torque"),
        friction=friction,
        lag=estimate("lag"),
        rate=rate,
        lines=tuple(sorted(lines, key=lambda line: (not line.named, -line.size))),
        noise=float(np.sqrt(fit.squares / fit.free / max(1 - likeness**2, 1e-3))),
        likeness=likeness,
        left=float(np.sqrt(np.mean(left**2))),
        before=float(np.sqrt(np.mean(bare**2))),
        slow=tuple(slow),
        fast=tuple(fast),
        repeats=_repeating(left, theta, side, run),
        residual=residual,
    )


def _shows(column: Array, others: Array, values: Array, start: NDArray[np.bool_], likeness: float) -> bool:
    """Whether a column explains more than noise beside others, by the F-test of a single one."""
    white, rest = _whitened(values[:, None], start, likeness)[:, 0], _whitened(others, start, likeness)
    without = _least_squares(rest, white)
    with_it = _least_squares(np.hstack([rest, _whitened(column, start, likeness)]), white)
    gain = max(without.squares - with_it.squares, 0.0)
    return bool(fisher.sf(gain / max(with_it.squares / with_it.free, 1e-300), 1, with_it.free) < CHANCE)


def _with_causes(
    lines: list[OrderLine], theta: Array, start: NDArray[np.bool_], fast: Sequence[SeenShaft | SeenMesh]
) -> list[OrderLine]:
    """Lines, of which those of no part are named where they come from larger ones or from parts that pass too fast.

    In rows evenly spaced by the step s an order n shows at |n − k 2π/s|.
    """
    turns = float(np.ptp(theta)) / (2 * pi)
    steps = np.abs(np.diff(theta))[~start[1:]]
    each = 2 * pi / float(np.median(steps)) if steps.size and np.median(steps) > 0 else np.inf
    known = sorted((line for line in lines if line.named), key=lambda line: -line.size)
    seen_as = [
        (abs(harmonic * part.order - round(harmonic * part.order / each) * each), part)
        for part in fast
        for harmonic in range(1, _TOOTH_HARMONICS + 1)
        if np.isfinite(each)
    ]
    found = []
    for line in lines:
        if not line.named:
            pairs = (
                (one.order, other.order)
                for one in known
                for other in known
                for order in (one.order + other.order, one.order - other.order)
                if min(one.size, other.size) > line.size and abs(order - line.order) * turns < _APART
            )
            alias = next((part for order, part in seen_as if abs(order - line.order) * turns < _APART), None)
            line = replace(line, sideband=next(pairs, None), alias=alias)
        found.append(line)
    return found


def _likeness(columns: Array, values: Array, start: NDArray[np.bool_]) -> float:
    """Correlation of noise between neighbouring rows, by the residual of a fit of all columns."""
    left = _least_squares(columns, values).left
    inner = ~start
    inner[0] = False
    before, here = left[:-1][inner[1:]], left[1:][inner[1:]]
    if len(here) < 8 or not (before @ before) > 0:
        return 0.0
    return float(np.clip(before @ here / (before @ before), 0.0, 0.98))


def _chosen(fixed: Array, values: Array, pool: dict[float, Array]) -> list[float]:
    """Orders whose columns explain more than noise, chosen one by one."""
    basis = np.linalg.qr(fixed)[0]
    chosen: list[float] = []
    left = values - basis @ (basis.T @ values)
    while len(chosen) < len(pool):
        best, gain, added = None, 0.0, None
        for order, columns in pool.items():
            if order in chosen:
                continue
            own = columns - basis @ (basis.T @ columns)
            norms = np.linalg.norm(own, axis=0)
            if not (norms > 1e-6 * np.linalg.norm(columns, axis=0)).all():
                continue
            q = np.linalg.qr(own)[0]
            explained = float(np.sum((q.T @ left) ** 2))
            if explained > gain:
                best, gain, added = order, explained, q
        if best is None or added is None:
            break
        free = len(values) - basis.shape[1] - added.shape[1]
        rest = float(left @ left) - gain
        if free < 4 or rest <= 0:
            break
        chance = float(fisher.sf(gain / added.shape[1] / (rest / free), added.shape[1], free))
        if chance > CHANCE / len(pool):
            break
        chosen.append(best)
        left = left - added @ (added.T @ left)
        basis = np.hstack([basis, added])
    return chosen


def _foreign(
    fixed: Array,
    values: Array,
    pool: dict[float, Array],
    chosen: Sequence[float],
    spare: Sequence[float],
    columns_of: Callable[[float], Array],
    start: NDArray[np.bool_],
    likeness: float,
    theta: Array,
) -> tuple[list[float], float] | None:
    """Neighbouring harmonics that one line between them explains better, and its order; None where there are none."""
    turns = float(np.ptp(theta)) / (2 * pi)
    ours = sorted(order for order in chosen if order in spare)
    groups: list[list[float]] = []
    for order in ours:
        if groups and (order - groups[-1][-1]) * turns < _NEIGHBOURS:
            groups[-1].append(order)
        else:
            groups.append([order])
    for group in groups:
        kept = [pool[order] for order in chosen if order not in group]
        basis = np.linalg.qr(np.hstack([fixed, *kept]))[0]
        rest = values - basis @ (basis.T @ values)

        def squares(columns: Array, basis: Array = basis, rest: Array = rest) -> float:
            own = columns - basis @ (basis.T @ columns)
            return float(rest @ rest - np.sum((np.linalg.qr(own)[0].T @ rest) ** 2))

        named = squares(np.hstack([pool[order] for order in group]))
        tried = np.linspace(group[0] - _APART / turns, group[-1] + _APART / turns, _FINE)

        def cost(order: float, squares: Callable[[Array], float] = squares) -> float:
            return squares(_whitened(columns_of(order), start, likeness))

        order = float(tried[int(np.argmin([cost(order) for order in tried]))])
        near = 1.5 * float(tried[1] - tried[0])
        order = float(minimize_scalar(cost, bounds=(order - near, order + near), method="bounded").x)
        count = len(values)
        width = pool[group[0]].shape[1]
        more = np.log(count) * ((len(group) - 1) * width - 1)
        # A line of a single harmonic is that of the harmonic unless its order is off by far.
        if count * np.log(named / cost(order)) + more > (_FAR if len(group) == 1 else 0.0):
            return group, order
    return None


_FAR = 20.0


def _other_order(
    left: Array,
    theta: Array,
    known: Sequence[float],
    start: NDArray[np.bool_],
    fixed: int,
) -> float | None:
    """Order of none of the parts at which more than noise is left; None where there is none."""
    turns = np.ptp(theta) / (2 * pi)
    steps = np.abs(np.diff(theta))[~start[1:]]
    moving = steps[steps > 1e-12]
    if turns < _APART or not moving.size or len(left) < 4 * fixed:
        return None
    highest = min(_RESOLVED * 2 * pi / float(np.median(moving)), 2000.0)
    grid = np.arange(_APART / turns, highest, 0.4 / turns)[:20_000]
    known_orders = np.asarray(known)
    grid = grid[np.min(np.abs(grid[:, None] - known_orders[None, :]), axis=1) * turns > _APART]
    if not grid.size:
        return None
    # What whitening did to a line at an order is a factor that the F-test does not need.
    power = np.empty(len(grid))
    for at in range(0, len(grid), 256):
        waves = np.exp(1j * np.outer(grid[at : at + 256], theta))
        power[at : at + 256] = 2 * np.abs(waves @ left) ** 2 / len(left)
    best = int(np.argmax(power))
    rest = float(left @ left) - float(power[best])
    free = len(left) - fixed - 2
    chance = float(fisher.sf(power[best] / 2 / max(rest / free, 1e-300), 2, free))
    if chance > CHANCE / len(grid):
        return None

    def lost(order: float) -> float:
        return -float(np.abs(np.exp(1j * order * theta) @ left))

    near = 0.4 / turns
    return float(minimize_scalar(lost, bounds=(grid[best] - near, grid[best] + near), method="bounded").x)


def _repeating(left: Array, theta: Array, side: Array, run: NDArray[np.intp]) -> float | None:
    """RMS of the mean of what is left over runs at equal angles, by that of noise alone; None without repetition."""
    key = np.round(np.degrees(theta), 3) + 1e6 * (side > 0)
    _, cell, count = np.unique(key, return_inverse=True, return_counts=True)
    pairs = np.unique(np.stack([cell, run]), axis=1)
    several = np.bincount(pairs[0], minlength=len(count)) >= 2
    if several.sum() < 12:
        return None
    means = np.bincount(cell, left) / count
    scatter = left - means[cell]
    within = several[cell]
    free = within.sum() - several.sum()
    if free < 12:
        return None
    noise = float(np.sum(scatter[within] ** 2) / free)
    expected = float(np.sum(noise / count[several]))
    return float(np.sqrt(np.sum(means[several] ** 2) / max(expected, 1e-300)))
