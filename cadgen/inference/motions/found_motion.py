"""The motion of a measured cam: its rests, the law of each flank, the centre of its outline, and its wear.

Each flank is fitted with the rests beside it by every law (`flank_fit`). Then all flanks with their likeliest laws are
fitted together: they share the levels of the rests and, where an outline was measured, its centre. With the centre
taken off, the laws are compared once more.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees, radians

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import Follower
from cadgen.errors import FileError
from cadgen.inference.motions.candidates import candidates
from cadgen.inference.motions.flank_fit import FlankData, FlankFit, ranked, residual_of, unknown_law
from cadgen.inference.motions.lift_samples import (
    LiftSamples,
    SeenFlank,
    centre_of,
    normals_of,
    ordered,
    samples_of_points,
    seen_flanks,
)

# Two laws are told apart where one is exp(-DECIDED / 2) times as likely as the other at most; so is a law that no
# table has from the best one of the table.
DECIDED = 12.0
_BESIDE = radians(15.0)  # of the rests beside a flank that its own fit looks at, at most
_LEAST_NOISE = 2e-5  # mm; files have digits
_ROUNDS = 2
_STEPS = 10
_SETTLED = 1e-3  # of the misfit, by which a further step must lessen it
_MOST_CENTRE = 0.01  # mm; a centre that is known less well than that is not taken off
_CENTRED = 0.05  # of the noise, within which the centre is where it was taken to be
_LEAST_SAMPLES = 90
_WIDEST_GAP = radians(10.0)
_WORN = 1 / 3  # of the greatest wear, over which a place counts as worn
_LOUD = 3.0  # of the noise, that is left by flanks that do not fit together
_OVERLAP = radians(2.0)  # by which the ends of flanks without a dwell may be off
_MOST_LEFT = 2.0  # of the readings, that the misfit may be
_MOST_WEAR = 0.02  # of the rise; what is off by more is no wear of a law
_SOUND = 1.0  # of the noise; less wear than that is none
_CENTRE_ROUNDS = 4
_CENTRE_SETTLED = 2e-3  # mm; a centre that moves by less leaves the samples as they are
_LEAST_POINTS = 90
_LEAST_SIZE = 1.0  # mm; no cam is as small, but the points of one in m are


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class FoundFlank:
    """Rise or return that was found.

    Attributes:
        start: cam angle at which it begins, rad, in the frame of the samples.
        stop: cam angle at which it ends, rad, greater than the start.
        start_sigma: standard deviation of the start, rad.
        stop_sigma: standard deviation of the stop, rad.
        before: level before it, in the motion's unit.
        after: level after it.
        rise_sigma: standard deviation of the difference of both, in the motion's unit.
        fits: fits by every law, the likeliest first, that of the likeliest with the values above.
        unknown: fit by a law that is not in the table.
        fits_in: whether it ends where the next one begins, or before, and all flanks together leave no more than noise.
    """

    start: float
    stop: float
    start_sigma: float
    stop_sigma: float
    before: float
    after: float
    rise_sigma: float
    fits: tuple[FlankFit, ...]
    unknown: FlankFit
    fits_in: bool

    def __repr__(self) -> str:
        return f"<FoundFlank {self.best.candidate.code}, {degrees(self.start):.2f}° to {degrees(self.stop):.2f}°>"

    @property
    def best(self) -> FlankFit:
        """Fit of the likeliest law."""
        return self.fits[0]

    @cached_property
    def in_table(self) -> bool:
        """Whether a law of the table explains the flank, and leaves noise and a little wear and nothing else."""
        best = self.best
        depth = float(np.abs(best.wear(best.data.theta)).max())
        rise = abs(self.after - self.before) * float(np.median(best.data.push))
        sane = best.chi2 < _MOST_LEFT * len(best.data.theta) and depth < _MOST_WEAR * rise
        return self.fits_in and sane and best.score < self.unknown.score + DECIDED

    @property
    def rivals(self) -> tuple[FlankFit, ...]:
        """Laws of the table that fit about as well as the best one, the likeliest first."""
        if not self.in_table:
            return ()
        return tuple(fit for fit in self.fits if fit.score < self.best.score + DECIDED)

    @property
    def named(self) -> bool:
        """Whether one law of the table is left."""
        return len(self.rivals) == 1

    @property
    def doubtful(self) -> bool:
        """Whether a law that is not in the table, without wear, explains the flank nearly as well."""
        return self.in_table and bool(self.wear[0]) and self.best.score > self.unknown.score - DECIDED

    @property
    def apart(self) -> float:
        """Greatest difference of the lifts of the two likeliest laws, as both are fitted, in the motion's unit."""
        one, two = self.fits[:2]
        theta = np.linspace(self.start - _BESIDE, self.stop + _BESIDE, 2001)
        return float(np.abs(one.modelled(theta) - two.modelled(theta)).max())

    def share(self, theta: Array) -> Array:
        """Share of the rise at cam angles in the frame of the flank, without wear.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        u = (theta - self.start) / (self.stop - self.start)
        share = self.best.candidate.jet(u, *self.best.values[4:])[:, 0]
        if self.in_table:
            return np.asarray(share)
        fit = self.unknown
        off = fit.wear(theta) / np.interp(theta, fit.data.theta, fit.data.push)
        return np.asarray((fit.modelled(theta) - off - self.before) / (self.after - self.before))

    @cached_property
    def wear(self) -> tuple[float, float, tuple[float, float]]:
        """Greatest wear, mm, its cam angle, and the cam angles between which it is worn, rad; 0 on a sound flank."""
        theta = np.linspace(self.start - _BESIDE / 5, self.stop + _BESIDE / 5, 721)
        depth = self.best.wear(theta) if self.in_table else np.zeros_like(theta)
        top = int(np.argmax(depth))
        if depth[top] < _SOUND * self.best.data.noise:
            return 0.0, float(theta[top]), (self.start, self.start)
        worn = np.flatnonzero(depth > _WORN * depth[top])
        return float(depth[top]), float(theta[top]), (float(theta[worn[0]]), float(theta[worn[-1]]))


@dataclass(frozen=True, kw_only=True, eq=False)
class FoundMotion:
    """Motion of a measured cam.

    Attributes:
        samples: samples with the disc's centre taken off.
        flanks: flanks in order; each begins at the rest at which the one before ends.
        centre: place of the camshaft less the place taken for it, in the disc's frame, mm, shape (2,); None where
            lifts were measured, or where it cannot be told.
        centre_sigma: standard deviations of the centre, mm, shape (2,); None without one.
        seams: covariance of starts and stops in order, rad², shape (2 flanks, 2 flanks).
        rms: what is left along the normal besides wear, mm.
    """

    samples: LiftSamples
    flanks: tuple[FoundFlank, ...]
    centre: Array | None
    centre_sigma: Array | None
    seams: Array
    rms: float

    @property
    def named(self) -> bool:
        """Whether the law of every flank is named."""
        return all(flank.named for flank in self.flanks)

    @property
    def base(self) -> float:
        """Lowest level, in the motion's unit, from which the lift counts."""
        return min(flank.before for flank in self.flanks)

    def lift(self, theta: Array) -> Array:
        """Motion without wear at cam angles in the frame of the samples, in its unit, from the lowest level on.

        Args:
            theta: cam angles, rad, shape (n,).
        """
        first = self.flanks[0].start
        theta = first + np.mod(theta - first, TURN)
        q = np.full_like(theta, self.flanks[0].before)
        for flank in self.flanks:
            q = np.where(theta > flank.start, flank.before + (flank.after - flank.before) * flank.share(theta), q)
        return q - self.base

    def dwell_sigma(self, number: int) -> float:
        """Standard deviation of the angle of the rest before a flank, rad.

        Args:
            number: number of the flank, from 0.
        """
        stop, start = (2 * number - 1) % len(self.seams), 2 * number
        return float(np.sqrt(max(self.seams[stop, stop] + self.seams[start, start] - 2 * self.seams[stop, start], 0.0)))


def found_motion(samples: LiftSamples) -> FoundMotion:
    """Motion that samples show.

    Args:
        samples: samples of a whole turn.

    Raises:
        FileError: too few samples, a part of the turn without any, or fewer than two flanks.
    """
    _refuse_few(samples)
    samples = replace(samples, noise=max(samples.noise, _LEAST_NOISE))
    seen = seen_flanks(samples)
    if len(seen) < 2:
        raise FileError(
            "the measured lift shows {count} rises and returns, where a cam has two at least: measure the whole turn, "
            "and check the unit of the lift",
            count=len(seen),
        )
    centre = np.zeros(2)
    for _ in range(_ROUNDS):
        flanks = _flanks(samples, seen)
        fits = [ranked(candidates(rises=data.high > data.low), data) for data in flanks]
        joint = _JointFit.of(samples, [each[0] for each in fits])
        if not joint.centred:
            break
        centre = centre + joint.centre
        samples = replace(samples, q=samples.q - samples.centred @ joint.centre / samples.push)
        if float(np.hypot(*joint.centre)) < _CENTRED * samples.noise:
            break
    return joint.found(samples, fits, centre)


def _refuse_few(samples: LiftSamples) -> None:
    """Refuse samples that do not show a turn."""
    angle = samples.cam_angle
    if len(angle) < _LEAST_SAMPLES:
        raise FileError(
            "{count} measured points are too few to find a motion: measure at least {least} in a turn",
            count=len(angle),
            least=_LEAST_SAMPLES,
        )
    steps = np.diff(np.append(angle, angle[0] + TURN))
    widest = int(np.argmax(steps))
    if steps[widest] > _WIDEST_GAP:
        raise FileError(
            "nothing was measured from cam angle {start:.1f} to {stop:.1f} degrees: a motion is found from points "
            "all round the cam, no more than {most:.0f} degrees apart",
            start=np.degrees(angle[widest]),
            stop=np.degrees(angle[widest] + steps[widest]),
            most=np.degrees(_WIDEST_GAP),
        )


def _flanks(samples: LiftSamples, seen: Sequence[SeenFlank]) -> list[FlankData]:
    """Readings of each flank with the rests beside it."""
    count = len(seen)
    theta = np.concatenate([samples.cam_angle - TURN, samples.cam_angle, samples.cam_angle + TURN])
    q, push = np.tile(samples.q, 3), np.tile(samples.push, 3)
    flanks = []
    for number, flank in enumerate(seen):
        before = seen[number - 1].stop - (TURN if number == 0 else 0.0)
        after = seen[(number + 1) % count].start + (TURN if number == count - 1 else 0.0)
        low = max((before + flank.start) / 2, flank.start - _BESIDE)
        high = min((flank.stop + after) / 2, flank.stop + _BESIDE)
        rows = (theta >= low) & (theta < high)
        levels = []
        for one, two in ((low, flank.start), (flank.stop, high)):
            off = np.abs(theta - (one + two) / 2)
            # Between two flanks that meet, the nearest sample.
            levels.append(float(np.median(q[off <= max((two - one) / 2, float(off.min()) + 1e-12)])))
        flanks.append(
            FlankData(theta[rows], q[rows], push[rows], samples.noise, flank.start, flank.stop, levels[0], levels[1])
        )
    return flanks


@dataclass(frozen=True, eq=False)
class _JointFit:
    """All flanks by their likeliest laws, with common levels and the centre.

    Attributes:
        fits: fits of the flanks alone.
        values: starts and stops of the flanks in order, rad, then their shapes, the levels before each flank, and the
            centre, mm.
        covariance: covariance of the values.
        centred: whether the centre is among them.
        rms: what is left along the normal, mm.
    """

    fits: tuple[FlankFit, ...]
    values: Array
    covariance: Array
    centred: bool
    rms: float

    @classmethod
    def of(cls, samples: LiftSamples, fits: Sequence[FlankFit]) -> "_JointFit":
        """Joint fit by Gauss and Newton."""
        if samples.normal is not None:
            made = cls._solved(samples, tuple(fits), centred=True)
            if np.sqrt(np.diag(made.covariance)[-2:]).max() < _MOST_CENTRE:
                return made
        return cls._solved(samples, tuple(fits), centred=False)

    @classmethod
    def _solved(cls, samples: LiftSamples, fits: tuple[FlankFit, ...], *, centred: bool) -> "_JointFit":
        count = len(fits)
        levels = [(fits[k].values[2] + fits[k - 1].values[3]) / 2 for k in range(count)]
        ends = [end for fit in fits for end in fit.values[:2]]
        shapes = [shape for fit in fits for shape in fit.values[4:]]
        values = np.array([*ends, *shapes, *levels, *([0.0, 0.0] if centred else [])])
        chi2, white, slopes = _misfit(samples, fits, values, centred=centred)
        for _ in range(_STEPS):
            step, *_ = np.linalg.lstsq(slopes, white, rcond=None)
            share = 1.0
            while share > 1e-3 and _misfit(samples, fits, values + share * step, centred=centred)[0] > chi2 + 1e-9:
                share /= 2
            if share <= 1e-3:
                break
            values = values + share * step
            before = chi2
            chi2, white, slopes = _misfit(samples, fits, values, centred=centred)
            if before - chi2 < _SETTLED:
                break
        rms = samples.noise * float(np.sqrt(chi2 / max(len(white) - len(values), 1)))
        return cls(fits, values, np.asarray(np.linalg.pinv(slopes.T @ slopes), dtype=float), centred, rms)

    @property
    def centre(self) -> Array:
        """Shift of the centre, mm, shape (2,)."""
        return np.asarray(self.values[-2:])

    def found(self, samples: LiftSamples, ranks: Sequence[tuple[FlankFit, ...]], centre: Array) -> FoundMotion:
        """Motion of the joint values, with the ranks of laws of each flank."""
        count, sigma = len(self.fits), np.sqrt(np.maximum(np.diag(self.covariance), 0.0))
        shapes = sum(len(fit.values) - 4 for fit in self.fits)
        first = 2 * count + shapes
        flanks, shape = [], 2 * count
        quiet = self.rms < _LOUD * samples.noise
        for number, fits in enumerate(ranks):
            best, after = fits[0], (number + 1) % count
            own = len(best.values) - 4
            a, b = self.values[2 * number : 2 * number + 2]
            low, high = self.values[first + number], self.values[first + after]
            values = np.array([a, b, low, high, *self.values[shape : shape + own]])
            shape += own
            following = float(self.values[2 * after]) + (TURN if after <= number else 0.0)
            both = self.covariance[np.ix_([first + number, first + after], [first + number, first + after])]
            flanks.append(
                FoundFlank(
                    start=float(a),
                    stop=float(b),
                    start_sigma=float(sigma[2 * number]),
                    stop_sigma=float(sigma[2 * number + 1]),
                    before=float(low),
                    after=float(high),
                    rise_sigma=float(np.sqrt(max(both[0, 0] + both[1, 1] - 2 * both[0, 1], 0.0))),
                    fits=(replace(best, values=values), *fits[1:]),
                    unknown=unknown_law(best),
                    fits_in=quiet and float(b) < following + _OVERLAP,
                )
            )
        return FoundMotion(
            samples=samples,
            flanks=tuple(flanks),
            centre=centre if self.centred else None,
            centre_sigma=sigma[-2:] if self.centred else None,
            seams=self.covariance[: 2 * count, : 2 * count],
            rms=self.rms,
        )


def _misfit(
    samples: LiftSamples, fits: Sequence[FlankFit], values: Array, *, centred: bool
) -> tuple[float, Array, Array]:
    """Misfit of joint values, the whitened residuals, shape (n,), and the derivatives of the model, shape (n, k)."""
    count, k = len(fits), len(values)
    first = 2 * count + sum(len(fit.values) - 4 for fit in fits)
    shift = values[-2:] if centred else np.zeros(2)
    parts, shape = [], 2 * count
    free = np.ones(len(samples.cam_angle), dtype=bool)
    for number, fit in enumerate(fits):
        own = len(fit.values) - 4
        places = [2 * number, 2 * number + 1, first + number, first + (number + 1) % count, *range(shape, shape + own)]
        shape += own
        residual, slopes = residual_of(fit.candidate, fit.data, values[places])
        rows = np.searchsorted(samples.cam_angle, np.mod(fit.data.theta, TURN) - 1e-10) % len(samples.cam_angle)
        free[rows] = False
        whole = np.zeros((len(residual), k + 1))
        whole[:, 0] = residual
        for place, column in zip(places, slopes.T, strict=True):
            whole[:, place + 1] += column
        if centred:
            whole[:, 0] -= samples.centred[rows] @ shift
            whole[:, -2:] = samples.centred[rows]
        parts.append(fit.process.whitened(whole))
    # What lies farther in the rests.
    rows = np.flatnonzero(free)
    starts = np.array([fit.data.start for fit in fits])
    rest = np.searchsorted(np.mod(starts, TURN), samples.cam_angle[rows]) % count
    whole = np.zeros((len(rows), k + 1))
    whole[:, 0] = samples.push[rows] * (samples.q[rows] - values[first + rest])
    whole[np.arange(len(rows)), first + rest + 1] = samples.push[rows]
    if centred:
        whole[:, 0] -= samples.centred[rows] @ shift
        whole[:, -2:] = samples.centred[rows]
    parts.append(whole / samples.noise)
    every = np.concatenate(parts)
    return float(every[:, 0] @ every[:, 0]), every[:, 0], every[:, 1:]


@dataclass(frozen=True, kw_only=True, eq=False)
class OutlineMotion:
    """Motion of an outline.

    Attributes:
        found: motion.
        centre: place of the camshaft in the frame of the points, mm, shape (2,).
        centred: whether the centre was found, and not taken to be the origin.
        base: radius of the base circle, mm.
    """

    found: FoundMotion
    centre: Array
    centred: bool
    base: float


def outline_motion(points: Array, follower: Follower) -> OutlineMotion:
    """Motion that points of an outline show.

    Args:
        points: points on the face on which the disc turns clockwise, in any order and about any origin, mm, (n, 2).
        follower: follower, whose base circle may be any.

    Raises:
        FileError: the points do not show a cam that the follower can run on.
    """
    points = ordered(points)
    if len(points) < _LEAST_POINTS:
        raise FileError(
            "{count} points are too few to find a motion: measure at least {least} of the outline",
            count=len(points),
            least=_LEAST_POINTS,
        )
    size = float(np.ptp(points, axis=0).max())
    if size < _LEAST_SIZE:
        raise FileError(
            "the points lie within {size:.3g} mm: give them in mm, which is 1000 times what they are in m", size=size
        )
    normals, centre = normals_of(points), centre_of(points)
    placed = centre is not None
    at = np.zeros(2) if centre is None else centre
    found = None
    for _ in range(_CENTRE_ROUNDS):
        found = found_motion(samples_of_points(points - at, normals, follower))
        if found.centre is None:
            break
        at, placed = at + found.centre, True
        if float(np.hypot(*found.centre)) < _CENTRE_SETTLED:
            break
    assert found is not None
    return OutlineMotion(found=found, centre=at, centred=placed, base=follower.dwelling(found.base))
