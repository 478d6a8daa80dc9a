"""Differences of a measured cam from its design: what is off, and which of what may be off explains the record.

Readings are compared along the outline's normal, where a disc that is larger by d is off by d, and everything else by
its displacement to first order (`cadgen.cam.lift_errors`). All sets of up to three deviations are tried, and each
pays for its numbers; those that explain the record as well are rivals. What is found is then fitted exactly, by rolling
the changed follower, or by the changed follower that the disc was cut for.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from typing import Any, ClassVar

import numpy as np
from scipy.optimize import minimize_scalar

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import Ring, rolling_step
from cadgen.cam.follower import Follower
from cadgen.cam.lift_errors import ECCENTRICITY, PHASE, displacements
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.errors import DesignError
from cadgen.inference.motions.lift_samples import LiftSamples, normals_of, ordered, samples_of_lifts, samples_of_points
from cadgen.laws.motion import Motion

BASE_CIRCLE = "base_circle"
# Fields of a follower by the code of the dimension, where they are called otherwise.
_FIELDS = {BASE_CIRCLE: "base"}
# Dimensions that do as much to the lift as a larger disc, and are not told from it.
TWINS = {"roller_radius": BASE_CIRCLE, "face_offset": BASE_CIRCLE}
_MOST = 3  # deviations that are claimed together
_PAYS = 12.0  # of the misfit, for each number
_RIVAL = 8.0  # of the score, within which another set explains the record as well
_SIGMAS = 4.0  # that a deviation must be away from none
_HUBER = 2.0  # standard deviations beyond which a reading counts less
_WIDEST = 1.0  # mm or rad, beyond which nothing is taken to be off
_ROUNDS = 4
_STEP = 1e-5  # mm or rad, of quotients of differences
_TURNED = 720  # angles at which a disc is tried for where it stands
_LOUD = 0.01  # of the travel; a record with more noise shows nothing
_LEAST_NOISE = 2e-5  # mm; files have digits
_CLOSE = np.radians(2.0)


@dataclass(frozen=True, kw_only=True)
class CamDifference:
    """Deviation of a cam or its follower.

    Attributes:
        code: code of the deviation.
        values: its number, or two along x and y of the disc, mm or rad.
        sigmas: standard deviations of the numbers.
    """

    code: str
    values: tuple[float, ...]
    sigmas: tuple[float, ...]

    @property
    def size(self) -> float:
        """Size, mm or rad, signed where it has no direction."""
        return self.values[0] if len(self.values) == 1 else float(np.linalg.norm(self.values))


class CamReadings(ABC):
    """Record of a cam whose motion is known, and what is left of it by deviations.

    Attributes:
        datum: codes of the numbers that are fitted and never claimed.
    """

    datum: ClassVar[tuple[str, ...]]

    @property
    @abstractmethod
    def codes(self) -> tuple[str, ...]:
        """Deviations that the record can show."""

    @property
    def first(self) -> float:
        """Number of the datum to begin with, mm or rad."""
        return 0.0

    @abstractmethod
    def left(self, values: Mapping[str, Array]) -> tuple[Array, Array]:
        """Readings less what deviations make of them, along the normal, mm, and their cam angles, rad, shape (n,).

        Args:
            values: numbers of deviations and of the datum by code, mm or rad.
        """

    @property
    @abstractmethod
    def noise(self) -> float:
        """Standard deviation of a reading along the normal, mm."""

    @property
    @abstractmethod
    def travel(self) -> float:
        """Way of the follower, mm."""

    @abstractmethod
    def columns(self, values: Mapping[str, Array]) -> dict[str, Array]:
        """Displacements of the readings by a unit of each code, mm by unit, shape (n, k).

        Args:
            values: numbers of deviations and of the datum by code, mm or rad.
        """


@dataclass(frozen=True, eq=False)
class LiftReadings(CamReadings):
    """Lifts by cam angle, on a dial with a zero of its own.

    Attributes:
        samples: samples of the lift.
        motion: motion wanted.
        follower: follower as designed.
        disc: outline of the disc as designed.
    """

    samples: LiftSamples
    motion: Motion
    follower: Follower
    disc: Outline

    datum: ClassVar[tuple[str, ...]] = ("zero",)

    @property
    def travel(self) -> float:
        """Way of the follower, mm."""
        return _travel(self.motion, self.follower)

    @property
    def noise(self) -> float:
        """Standard deviation of a reading along the normal, mm."""
        return max(self.samples.noise, _LEAST_NOISE)

    @cached_property
    def codes(self) -> tuple[str, ...]:
        """Every deviation but twins."""
        return tuple(code for code in self.columns({}) if code not in ("zero", *TWINS))

    @property
    def _push(self) -> Array:
        jets = self.motion.jets(self.samples.cam_angle)
        return self.follower.push(jets[:, 0], jets[:, 1])

    def columns(self, values: Mapping[str, Array]) -> dict[str, Array]:
        """Displacements of the readings by a unit of each code, with the zero of the dial, on the cam as designed.

        Args:
            values: numbers of deviations, which count for nothing.
        """
        found = displacements(self.motion, self.follower, self.samples.cam_angle)
        return {**{each.code: each.of_unit for each in found}, "zero": self._push[:, None]}

    def left(self, values: Mapping[str, Array]) -> tuple[Array, Array]:
        """Readings less the lift of the changed follower on the changed disc."""
        theta, disc, follower = self.samples.cam_angle, self.disc, self.follower
        shift, grown = values.get(ECCENTRICITY), float(values.get(BASE_CIRCLE, np.zeros(1))[0])
        if shift is not None or grown:
            points = disc.points + (0.0 if shift is None else shift) + grown * normals_of(disc.points)
            disc = Outline(points, disc.piece)
        fields = {code: float(each[0]) for code, each in values.items() if code not in (*_APART, "zero")}
        follower = changed(follower, fields)
        turned = theta + float(values.get(PHASE, np.zeros(1))[0])
        rolled = Ring.of(disc, follower).contact(turned).q + _rest(follower) - _rest(self.follower)
        return (self.samples.q - float(values["zero"][0]) - rolled) * self._push, theta


@dataclass(frozen=True, eq=False)
class OutlineReadings(CamReadings):
    """Points of an outline about the bore, clocked anyhow.

    Attributes:
        points: points on the face that files show, counter-clockwise, mm, shape (n, 2).
        motion: motion wanted.
        follower: follower as designed.
    """

    points: Array
    motion: Motion
    follower: Follower

    datum: ClassVar[tuple[str, ...]] = ("clocking",)

    @property
    def first(self) -> float:
        """Clocking at which the record lies best, rad."""
        angle, q = self._plain.cam_angle, self._plain.q

        def off(turn: float) -> float:
            away = q - self.motion.q(np.mod(angle + turn, TURN))
            return float(np.median(np.abs(away - np.median(away))))

        return float(min(np.arange(_TURNED) * TURN / _TURNED, key=off))

    @cached_property
    def _normals(self) -> Array:
        return normals_of(self.points)

    @cached_property
    def _plain(self) -> LiftSamples:
        return samples_of_points(self.points, self._normals, self.follower)

    @property
    def travel(self) -> float:
        """Way of the follower, mm."""
        return _travel(self.motion, self.follower)

    @property
    def noise(self) -> float:
        """Standard deviation of a point along the normal, mm."""
        return max(self._plain.noise, _LEAST_NOISE)

    @cached_property
    def codes(self) -> tuple[str, ...]:
        """Every deviation of the disc: what stands beside it does not show, and where it is keyed is the datum."""
        return (*(each.code for each in self.follower.dimensions() if each.code not in TWINS), ECCENTRICITY)

    def columns(self, values: Mapping[str, Array]) -> dict[str, Array]:
        """Displacements of the points by a unit of each code, as quotients of differences.

        Args:
            values: numbers of deviations and of the clocking by code, mm or rad.
        """
        now, found = self.left(values)[0], {}
        for code in (*self.codes, "clocking"):
            size = 2 if code == ECCENTRICITY else 1
            given = values.get(code, np.zeros(size))
            steps = [self.left({**values, code: given + row})[0] for row in _STEP * np.eye(size)]
            found[code] = np.stack([(now - each) / _STEP for each in steps], axis=1)
        return found

    def left(self, values: Mapping[str, Array]) -> tuple[Array, Array]:
        """Points less the outline that a disc has which was cut for the changed follower."""
        clocking = float(values["clocking"][0])
        # The vector of the bore is given in the frame of the design.
        along, across = values.get(ECCENTRICITY, np.zeros(2))
        shift = complex(along, across) * np.exp(-1j * clocking)
        normals = self._normals
        points = self.points - np.array([shift.real, shift.imag])
        points = points - float(values.get(BASE_CIRCLE, np.zeros(1))[0]) * normals
        fields = {code: float(each[0]) for code, each in values.items() if code not in (*_APART, "clocking")}
        follower = changed(self.follower, fields)
        angle, q = follower.touching(points, normals)
        angle = angle + clocking
        jets = self.motion.jets(np.mod(angle, TURN))
        # Lift 0 of the changed follower is on the base circle, as it is of that designed.
        return (q - jets[:, 0]) * self.follower.push(jets[:, 0], jets[:, 1]), np.mod(angle, TURN)


_APART = (ECCENTRICITY, PHASE, BASE_CIRCLE)


def changed(follower: Follower, fields: Mapping[str, float]) -> Follower:
    """Follower with dimensions changed.

    Args:
        follower: follower, a dataclass.
        fields: changes by the code of the dimension, mm or rad.
    """
    made: Any = follower
    for code, change in fields.items():
        name = _FIELDS.get(code, code)
        made = replace(made, **{name: getattr(made, name) + change})
    found: Follower = made
    return found


def _travel(motion: Motion, follower: Follower) -> float:
    return float(np.ptp(follower.lift(motion.stations[1])))


def _rest(follower: Follower) -> float:
    """Place of a follower where its motion is 0: an angle of its arm, rad, or its distance on a slide, mm."""
    rest: float = getattr(follower, "rest", follower.base_radius)
    return rest


@dataclass(frozen=True, kw_only=True, eq=False)
class CamComparison:
    """Comparison of a measured cam with its design.

    Attributes:
        found: deviations that explain the record, none if nothing differs.
        rivals: sets of codes that explain it as well.
        datum: numbers of the datum by code, mm or rad.
        noise: standard deviation of a reading along the normal, mm.
        before: rms along the normal with the datum alone, mm.
        after: rms that is left, mm.
        travel: way of the follower along the normal, mm.
        worst: greatest departure that is left over some degrees, mm, negative for material that is missing, and its
            cam angle, rad.
        mirrored: whether the disc is wrong side up.
    """

    found: tuple[CamDifference, ...]
    rivals: tuple[tuple[str, ...], ...]
    datum: Mapping[str, float]
    noise: float
    before: float
    after: float
    travel: float
    worst: tuple[float, float]
    mirrored: bool

    @property
    def explained(self) -> bool:
        """Whether no more than noise is left, and the noise is small beside the lift."""
        quiet = self.after < _LOUD * self.travel
        return quiet and abs(self.worst[0]) < _SIGMAS * self.noise and self.after < 1.5 * self.noise


def compared(readings: CamReadings, *, mirrored: bool = False) -> CamComparison:
    """Deviations that explain readings.

    Args:
        readings: record of the cam.
        mirrored: whether the record is that of the disc wrong side up.
    """
    values: dict[str, Array] = {name: np.array([readings.first]) for name in readings.datum}
    values, _, before = _fitted(readings, (), values)
    left, _ = readings.left(values)
    columns = readings.columns(values)
    weight = _weights(left, columns, readings)
    scored = sorted(
        (_score(left, columns, readings, chosen, weight), chosen)
        for size in range(_MOST + 1)
        for chosen in combinations(readings.codes, size)
    )
    # What else is off on a disc that is wrong side up shows when it is turned over.
    score, best = (scored[0][0], ()) if mirrored else scored[0]
    rivals = tuple(chosen for other, chosen in scored[1:] if other < score + _RIVAL and not set(best) < set(chosen))
    found: list[CamDifference] = []
    while True:
        plain = {name: values[name] for name in readings.datum}
        values, covariance, after = _fitted(readings, best, plain)
        found = _numbered(readings, best, values, np.sqrt(np.maximum(np.diag(covariance), 0.0)))
        kept = tuple(each.code for each in found if abs(each.size) > _SIGMAS * max(each.sigmas))
        if kept == best:
            break
        best = kept
    left, theta = readings.left(values)
    return CamComparison(
        found=tuple(found),
        rivals=rivals,
        datum={name: float(values[name][0]) for name in readings.datum},
        noise=readings.noise,
        before=before,
        after=after,
        travel=readings.travel,
        worst=_worst(left, theta),
        mirrored=mirrored,
    )


def _numbered(
    readings: CamReadings, codes: Sequence[str], values: Mapping[str, Array], sigma: Array
) -> list[CamDifference]:
    """Deviations with their numbers and standard deviations, which follow those of the datum."""
    found, at = [], len(readings.datum)
    for code in codes:
        count = len(values[code])
        numbers = tuple(values[code].tolist())
        found.append(CamDifference(code=code, values=numbers, sigmas=tuple(sigma[at : at + count].tolist())))
        at += count
    return found


def _huber(left: Array, noise: float) -> Array:
    """Weights of readings, less for those far off."""
    spread = max(noise, float(np.median(np.abs(left))) / 0.6745)
    return np.asarray(np.minimum(1.0, _HUBER * spread / np.maximum(np.abs(left), 1e-12)))


def _weights(left: Array, columns: Mapping[str, Array], readings: CamReadings) -> Array:
    """Weights by what all deviations together leave."""
    every = np.concatenate([columns[code] for code in (*readings.datum, *readings.codes)], axis=1)
    weight = np.ones(len(left))
    for _ in range(3):
        root = np.sqrt(weight)
        solved, *_ = np.linalg.lstsq(every * root[:, None], left * root, rcond=1e-9)
        weight = _huber(left - every @ solved, readings.noise)
    return weight


def _score(
    left: Array, columns: Mapping[str, Array], readings: CamReadings, chosen: Sequence[str], weight: Array
) -> float:
    """Misfit of a set of deviations, with what each of its numbers pays."""
    every = np.concatenate([columns[code] for code in (*readings.datum, *chosen)], axis=1)
    root = np.sqrt(weight) / readings.noise
    solved, *_ = np.linalg.lstsq(every * root[:, None], left * root, rcond=1e-9)
    off = (left - every @ solved) * root
    return float(off @ off + _PAYS * sum(columns[code].shape[1] for code in chosen))


def _fitted(
    readings: CamReadings, chosen: Sequence[str], values: Mapping[str, Array]
) -> tuple[dict[str, Array], Array, float]:
    """Numbers of deviations by Gauss and Newton, their covariance, and the rms that is left, mm."""
    names = (*readings.datum, *chosen)
    now = dict(values)
    covariance: Array = np.zeros((0, 0))
    for _ in range(_ROUNDS):
        left, _ = readings.left(now)
        columns = readings.columns(now)
        now |= {name: np.zeros(columns[name].shape[1]) for name in names if name not in now}
        every = np.concatenate([columns[name] for name in names], axis=1)
        weight = _huber(left, readings.noise)
        for _ in range(2):
            root = np.sqrt(weight)
            step, *_ = np.linalg.lstsq(every * root[:, None], left * root, rcond=1e-9)
            weight = _huber(left - every @ step, readings.noise)
        covariance = np.asarray(np.linalg.pinv((every * weight[:, None]).T @ every) * readings.noise**2, dtype=float)
        at = 0
        for name in names:
            count = columns[name].shape[1]
            moved = now[name] + step[at : at + count]
            now[name] = moved if name in readings.datum else np.clip(moved, -_WIDEST, _WIDEST)
            at += count
    left, _ = readings.left(now)
    return now, covariance, float(np.sqrt(np.mean(left**2)))


def _worst(left: Array, theta: Array) -> tuple[float, float]:
    """Greatest mean of what is left over a few degrees, mm, and its cam angle, rad."""
    order = np.argsort(theta)
    angle, values = theta[order], left[order]
    count = max(5, int(len(angle) * _CLOSE * 2 / TURN))
    around = np.concatenate([values, values[:count]])
    means: Array = np.convolve(around, np.full(count, 1 / count), "valid")[: len(values)]
    place = int(np.argmax(np.abs(means)))
    return float(means[place]), float(angle[(place + count // 2) % len(angle)])


def lift_readings(cam_angle: Array, q: Array, motion: Motion, follower: Follower, curve: ClosedCurve) -> LiftReadings:
    """Lifts that were read on a cam.

    Args:
        cam_angle: cam angles, rad, shape (n,).
        q: lifts, in the motion's unit, shape (n,).
        motion: motion wanted.
        follower: follower as designed.
        curve: outline of the disc as designed, mm.
    """
    jets = motion.jets(np.mod(cam_angle, TURN))
    samples = samples_of_lifts(cam_angle, q, follower.push(jets[:, 0], jets[:, 1]))
    return LiftReadings(samples, motion, follower, curve.outline(rolling_step(curve, follower)))


def wrong_side_readings(readings: LiftReadings) -> LiftReadings:
    """Lifts as of the disc wrong side up, turned to where it explains them best.

    Args:
        readings: lifts as of the disc as it is meant.

    Raises:
        DesignError: the follower cannot run on it.
    """
    disc = readings.disc
    turned = Outline(disc.points[::-1] * [1.0, -1.0], disc.piece.max() - disc.piece[::-1])
    theta = np.arange(_TURNED) * TURN / _TURNED
    had = Ring.of(turned, readings.follower).contact(theta).q
    seen = np.interp(theta, readings.samples.cam_angle, readings.samples.q, period=TURN)

    def off(turn: float) -> float:
        return float(np.std(np.interp(theta + turn, theta, had, period=TURN) - seen))

    best = float(min(theta, key=off))
    best = float(minimize_scalar(off, bounds=(best - _CLOSE, best + _CLOSE), method="bounded").x)
    back = np.exp(-1j * best)
    points = (turned.points[:, 0] + 1j * turned.points[:, 1]) * back
    return replace(readings, disc=Outline(np.stack([points.real, points.imag], axis=1), turned.piece))


def outline_readings(points: Array, motion: Motion, follower: Follower) -> OutlineReadings:
    """Points of an outline that were measured about the bore.

    Args:
        points: points on the face that files show, mm, shape (n, 2).
        motion: motion wanted.
        follower: follower as designed.
    """
    return OutlineReadings(ordered(points), motion, follower)


def either_side(right: CamComparison, other: Callable[[], CamReadings]) -> CamComparison:
    """Comparison of the side that explains a record better: as the cam is meant, or wrong side up.

    Args:
        right: comparison of the disc as it is meant.
        other: function that gives the record as of the disc wrong side up.
    """
    try:
        wrong = compared(other(), mirrored=True)
    except DesignError:
        return right
    return wrong if wrong.after < right.after / 2 else right
