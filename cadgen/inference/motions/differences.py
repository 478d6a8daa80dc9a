"""Differences of a measured cam from its design: what is off, and which of what may be off explains the record.

Readings are compared along the outline's normal, where a disc that is larger by d is off by d, and everything else by
its displacement to first order (`cadgen.cam.lift_errors`). All sets of up to three deviations are tried, with wear of a
flank and without (`cadgen.inference.motions.disc_wear`), and each pays for its numbers; those that explain the record
as well are rivals. What is found is then fitted exactly, by rolling the changed follower, or by the changed follower
that the disc was cut for. Where neither explains the record, nothing is named that leaves most of it.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import combinations
from typing import Any, ClassVar

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import Ring, rolling_step
from cadgen.cam.follower import Follower
from cadgen.cam.lift_errors import ECCENTRICITY, PHASE, displacements
from cadgen.curves.closed import ClosedCurve, Outline
from cadgen.errors import DesignError
from cadgen.inference.motions.disc_wear import DiscWear, FlankWear, wears
from cadgen.inference.motions.lift_samples import LiftSamples, normals_of, ordered, samples_of_lifts, samples_of_points
from cadgen.laws.motion import Motion

BASE_CIRCLE = "base_circle"
# Disc that was cut for another base circle: off by d along the motion, and not along the normal. Both have one name.
_BASE_CUT = "base_circle_cut"
# Fields of a follower by the code of the dimension, where they are called otherwise.
_FIELDS = {_BASE_CUT: "base", "roller_radius": "radius"}
WEAR = "wear"
# Dimensions that do as much to the lift as a larger disc, and are not told from it. Discs are seldom cut for others:
# these pay twice.
TWINS = {"roller_radius": BASE_CIRCLE, "face_offset": BASE_CIRCLE}
_MOST = 3  # deviations that are claimed together
_PAYS = 12.0  # of the misfit, for each number
_RIVAL = 8.0  # of the score, within which another set explains the record as well
_SIGMAS = 4.0  # that a deviation must be away from none
_MOSTLY = 0.2  # of what is off: deviations that leave more, and do not explain the record, are not named
_ALIKE = 1e-10  # of the largest, below which numbers are not told apart
_ADDED = 30.0  # of the misfit, for material that would have to be added, beyond which it is no wear
_JUDGED = 40  # explanations by wear that are judged by that
_OUTLIER = 5.0  # standard deviations from its neighbours
_BESIDE = 5  # neighbours on each side
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
        motion: motion wanted.
    """

    datum: ClassVar[tuple[str, ...]]
    motion: Motion

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
        dimensions = [each.code for each in self.follower.dimensions()]
        cut = [_BASE_CUT] if BASE_CIRCLE in dimensions and hasattr(self.follower, "base") else []
        return (*dimensions, *cut, ECCENTRICITY)

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
        worn: flanks that are worn.
        rivals: sets of codes that explain it as well, with that of wear.
        datum: numbers of the datum by code, mm or rad.
        noise: standard deviation of a reading along the normal, mm.
        before: rms along the normal with the datum alone, mm.
        after: rms that is left, mm.
        travel: way of the follower along the normal, mm.
        worst: greatest departure that is left over some degrees, mm, negative for material that is missing, and its
            cam angle, rad.
        mirrored: whether the disc is wrong side up.
        departures: readings less the design along the normal, with the datum that goes with what is found, mm, and
            their cam angles, rad, shape (n,) each.
    """

    found: tuple[CamDifference, ...]
    worn: tuple[FlankWear, ...]
    rivals: tuple[tuple[str, ...], ...]
    datum: Mapping[str, float]
    noise: float
    before: float
    after: float
    travel: float
    worst: tuple[float, float]
    mirrored: bool
    departures: tuple[Array, Array]

    @property
    def explained(self) -> bool:
        """Whether no more than noise is left beside wear, and the noise is small beside the lift."""
        quiet = self.after < _LOUD * self.travel
        return quiet and abs(self.worst[0]) < _SIGMAS * self.noise and self.after < 1.5 * self.noise

    @property
    def surely_worn(self) -> bool:
        """Whether a flank is worn by all that explains the record."""
        return bool(self.worn) and all(WEAR in codes for codes in self.rivals)


def compared(readings: CamReadings, *, mirrored: bool = False) -> CamComparison:
    """Deviations that explain readings.

    Args:
        readings: record of the cam.
        mirrored: whether the record is that of the disc wrong side up.
    """
    values: dict[str, Array] = {name: np.array([readings.first]) for name in readings.datum}
    values, _, before = _fitted(readings, (), values)
    # What else is off on a disc that is wrong side up shows when it is turned over.
    scored = [Explanation((), None, 0.0)] if mirrored else _explanations(readings, values)
    if scored[0].codes:  # once more, of first order about what was found
        near, _, _ = _fitted(readings, scored[0].codes, values, scored[0].wear)
        scored = _explanations(readings, near)
    best = scored[0]
    rivals = [
        other.names
        for other in scored[1:]
        if other.likely < best.likely + _RIVAL and not set(best.names) <= set(other.names)
    ]
    chosen, least = best.codes, best.score + _RIVAL
    found: list[CamDifference] = []
    while True:
        plain = {name: values[name] for name in readings.datum}
        values, covariance, after = _fitted(readings, chosen, plain, best.wear)
        found = _numbered(readings, chosen, values, np.sqrt(np.maximum(np.diag(covariance), 0.0)))
        kept = tuple(each.code for each in found if abs(each.size) > _SIGMAS * max(each.sigmas))
        if kept == chosen:
            break
        chosen = kept
    for other in scored[1:]:  # a disc that is larger in another way
        if set(other.names) == set(best.names) and chosen == best.codes != other.codes and other.score < least:
            plain = {name: values[name] for name in readings.datum}
            numbers, _, _ = _fitted(readings, other.codes, plain, other.wear)
            found = [_spread(each, numbers) for each in found]
            break
    left, theta = readings.left(values)
    worn = () if best.wear is None else best.wear.depths(left)
    if best.wear is not None:
        left = left + best.wear.expected(left)
        after = float(np.sqrt(np.mean(left**2)))
    said = _named([*(each.code for each in found), *([WEAR] if best.wear is not None else [])])
    rivals = list({frozenset(each): each for each in reversed([best.names, *rivals])}.values())
    result = CamComparison(
        found=tuple(replace(each, code=_named([each.code])[0]) for each in found),
        worn=worn,
        rivals=tuple(each for each in reversed(rivals) if set(each) != set(said)),
        datum={name: float(values[name][0]) for name in readings.datum},
        noise=readings.noise,
        before=before,
        after=after,
        travel=readings.travel,
        worst=_worst(left, theta),
        mirrored=mirrored,
        departures=readings.left({name: values[name] for name in readings.datum}),
    )
    if result.explained or after < _MOSTLY * before or not (found or worn):
        return result
    # Names that leave most of it are none.
    plain = {name: values[name] for name in readings.datum}
    values, _, after = _fitted(readings, (), plain)
    datum = {name: float(values[name][0]) for name in readings.datum}
    departures = readings.left(values)
    worst = _worst(*departures)
    return replace(result, found=(), worn=(), rivals=(), datum=datum, after=after, worst=worst, departures=departures)


@dataclass(frozen=True, eq=False)
class Explanation:
    """Deviations and wear that may explain a record.

    Attributes:
        codes: codes of the deviations.
        wear: wear of the disc; None without.
        score: misfit, with what each number pays, and what wear would have to add.
    """

    codes: tuple[str, ...]
    wear: DiscWear | None
    score: float

    @property
    def likely(self) -> float:
        """Score in which what is rare pays as anything else, so that it is named among what is as likely."""
        return self.score - _PAYS * _rare(self.codes)

    @property
    def names(self) -> tuple[str, ...]:
        """Codes of the deviations, and of wear."""
        return _named(self.codes if self.wear is None else (*self.codes, WEAR))


def _named(codes: Sequence[str]) -> tuple[str, ...]:
    """Codes by which deviations are named, each once."""
    return tuple(dict.fromkeys(BASE_CIRCLE if code == _BASE_CUT else code for code in codes))


def _rare(codes: Sequence[str]) -> int:
    """Number of deviations that discs seldom have."""
    return len(set(codes) & set(TWINS))


def _explanations(readings: CamReadings, values: Mapping[str, Array]) -> list[Explanation]:
    """Sets of deviations with and without wear, the likeliest first.

    Args:
        readings: record of the cam.
        values: numbers of the datum, and of deviations about which displacements are of first order.
    """
    left, theta = readings.left(values)
    columns = readings.columns(values)
    for code in values.keys() & set(readings.codes):
        left = left + columns[code] @ values[code]
    names = (*readings.datum, *readings.codes)
    every = np.concatenate([columns[name] for name in names], axis=1)
    widths = [columns[name].shape[1] for name in names]
    ends = np.cumsum(widths)
    places = {name: list(range(end - width, end)) for name, end, width in zip(names, ends, widths, strict=True)}
    datum = [place for name in readings.datum for place in places[name]]
    sets = [chosen for size in range(_MOST + 1) for chosen in combinations(readings.codes, size)]
    sets = [chosen for chosen in sets if len(_named(chosen)) == len(chosen)]
    keep = _sound(left, every, theta)
    found: list[Explanation] = []
    for wear in wears(readings.motion, theta, readings.noise, keep):
        white = wear.whitened(np.column_stack([left, every])) * keep[:, None]
        gram = white.T @ white
        scale = np.sqrt(np.maximum(np.diag(gram), 1e-300))
        for chosen in sets:
            taken = [0, *(1 + place for place in datum), *(1 + place for code in chosen for place in places[code])]
            part = gram[np.ix_(taken, taken)] / np.outer(scale[taken], scale[taken])
            solved, *_ = np.linalg.lstsq(part[1:, 1:], part[1:, 0], rcond=_ALIKE)
            misfit = float(gram[0, 0] * (1 - part[0, 1:] @ solved))
            pays = _PAYS * (len(taken) - 1 - len(datum) + _rare(chosen) + bool(wear.flanks))
            found.append(Explanation(chosen, wear if wear.flanks else None, misfit + pays + wear.log_determinant))
    found.sort(key=lambda each: each.score)
    return sorted(_signed(found, left, every, places, readings.datum, keep), key=lambda each: each.score)


def _signed(
    found: Sequence[Explanation],
    left: Array,
    every: Array,
    places: Mapping[str, Sequence[int]],
    datum: Sequence[str],
    keep: NDArray[np.bool_],
) -> list[Explanation]:
    """Likeliest explanations, those with wear with what it would have to add.

    Args:
        found: explanations, the likeliest first.
        left: readings less the design, mm, shape (n,).
        every: displacements by a unit of all numbers, shape (n, k).
        places: columns of each code.
        datum: codes that are always fitted.
        keep: readings that count, shape (n,).
    """
    signed: list[Explanation] = []
    least, judged = np.inf, 0
    for each in found:
        if each.score > least + _RIVAL + _MOST * _PAYS:
            break
        if each.likely > least + _RIVAL:
            continue
        score = each.score
        if each.wear is not None:
            judged += 1
            if judged > _JUDGED:
                continue
            taken = [place for code in (*datum, *each.codes) for place in places[code]]
            white = each.wear.whitened(np.column_stack([left, every[:, taken]])) * keep[:, None]
            scale = np.maximum(np.linalg.norm(white[:, 1:], axis=0), 1e-300)
            covariance = np.linalg.pinv(white[:, 1:] / scale, rcond=1e-6)
            solved = covariance @ white[:, 0] / scale
            covariance = (covariance @ covariance.T) / np.outer(scale, scale)
            added = each.wear.sign_cost(left - every[:, taken] @ solved, every[:, taken], covariance)
            if added > _ADDED:
                continue
            score += added
        least = min(least, score)
        signed.append(replace(each, score=score))
    return signed


def _sound(left: Array, every: Array, theta: Array) -> NDArray[np.bool_]:
    """Readings that are no outliers among their neighbours, by what all deviations leave, shape (n,).

    Args:
        left: readings less the design, mm, shape (n,).
        every: displacements by a unit of all numbers, shape (n, k).
        theta: cam angles, rad, shape (n,).
    """
    solved, *_ = np.linalg.lstsq(every, left, rcond=1e-9)
    order = np.argsort(theta)
    off = (left - every @ solved)[order]
    around = np.concatenate([off[-_BESIDE:], off, off[:_BESIDE]])
    away = off - np.median(sliding_window_view(around, 2 * _BESIDE + 1), axis=1)
    sound = np.empty(len(left), dtype=bool)
    sound[order] = np.abs(away) < _OUTLIER * float(np.median(np.abs(away))) / 0.6745 + 1e-12
    return sound


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


def _spread(difference: CamDifference, others: Mapping[str, Array]) -> CamDifference:
    """Deviation whose standard deviations reach to the numbers of an explanation that is as likely."""
    alike = (difference.code, *((BASE_CIRCLE, _BASE_CUT) if difference.code in (BASE_CIRCLE, _BASE_CUT) else ()))
    other = next(others[code] for code in alike if code in others)
    apart = np.hypot(difference.sigmas, np.array(difference.values) - other)
    return replace(difference, sigmas=tuple(apart.tolist()))


def _huber(left: Array, noise: float) -> Array:
    """Weights of readings, less for those far off."""
    spread = max(noise, float(np.median(np.abs(left))) / 0.6745)
    return np.asarray(np.minimum(1.0, _HUBER * spread / np.maximum(np.abs(left), 1e-12)))


def _fitted(
    readings: CamReadings, chosen: Sequence[str], values: Mapping[str, Array], wear: DiscWear | None = None
) -> tuple[dict[str, Array], Array, float]:
    """Numbers of deviations by Gauss and Newton, their covariance, and the rms that is left, mm, with any wear."""
    names, wear = (*readings.datum, *chosen), wear or DiscWear((), 0, readings.noise)
    now = dict(values)
    covariance: Array = np.zeros((0, 0))
    for _ in range(_ROUNDS):
        left, _ = readings.left(now)
        columns = readings.columns(now)
        now |= {name: np.zeros(columns[name].shape[1]) for name in names if name not in now}
        every = np.concatenate([columns[name] for name in names], axis=1)
        weight = _huber(left + wear.expected(left), readings.noise)
        for _ in range(2):
            white = wear.whitened(np.column_stack([left, every])) * np.sqrt(weight)[:, None]
            step, *_ = np.linalg.lstsq(white[:, 1:], white[:, 0], rcond=1e-9)
            away = left - every @ step
            weight = _huber(away + wear.expected(away), readings.noise)
        covariance = np.asarray(np.linalg.pinv(white[:, 1:].T @ white[:, 1:]), dtype=float)
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
    return wrong if wrong.after < min(right.after / 2, _LOUD * wrong.travel) else right
