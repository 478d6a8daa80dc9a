"""The lift with effects on disc and follower: the rod rolled on the changed disc.

A fit needs the lift of every value that it comes by, and how the lift answers each value there. The first is rolled;
the second follows from the contacts of that roll, for to first order the rod stays on the same points of the disc
(`cadgen.cam.followers.rod_first_order`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.interpolate import CubicSpline, PPoly

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll
from cadgen.cam.follower import Contact
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.followers.rod_first_order import FirstOrder
from cadgen.car.motion.sampled import sampled_lift
from cadgen.car.path_motion import PathMotion
from cadgen.curves.closed import Outline
from cadgen.deviations.disc import DISC, Disc
from cadgen.deviations.effect import Active, Effect, Rows, Stage, key_of, through
from cadgen.deviations.first_order import displaced
from cadgen.deviations.lift import FOLLOWER, Seat
from cadgen.errors import DesignError
from cadgen.inference.measurement.recent import Recent

GRID = 720  # stations of the roll; only the change against the nominal cam is interpolated between them
STATIONS = 3600  # of a changed lift as a curve; it errs by under 0.01 um between them
_KEPT = 128  # most differences leave disc and rod alone

# Change of tan(beta) by cam angle, as a periodic spline; nothing where disc and rod are as designed.
CHANGE = Stage[PPoly | None]("change of the lift")


@dataclass(frozen=True)
class _Roll:
    """The rod rolled on a disc.

    Attributes:
        outline, setting: of the disc, and of the rod on it.
        contacts: with the disc as it stands, or with a wobbling one in its two extremes and the middle.
        share: of each of them at each cam angle, shape (1 or 3, n).
    """

    outline: Outline
    setting: Seat
    contacts: tuple[Contact, ...]
    share: Array

    @classmethod
    def of(cls, disc: Disc, setting: Seat, grid: Array) -> "_Roll":
        """Roll at the cam angles of a grid."""
        outline = Outline(disc.points, disc.piece)
        a, b = setting.wobble
        if a == 0 and b == 0:
            return cls(outline, setting, (roll(outline, setting.follower, grid),), np.ones((1, len(grid))))
        # A wobbling disc offers its faces at w + a cos + b sin: three rolls, and a parabola through them.
        size = float(np.hypot(a, b))
        contacts = tuple(roll(outline, _shifted(setting.follower, k * size), grid) for k in (-1.0, 0.0, 1.0))
        x = (a * np.cos(grid) + b * np.sin(grid)) / size
        return cls(outline, setting, contacts, np.stack([(x**2 - x) / 2, 1 - x**2, (x**2 + x) / 2]))

    @property
    def tan_beta(self) -> Array:
        """tan(beta) on the grid."""
        return np.asarray(sum(share * c.q for share, c in zip(self.share, self.contacts, strict=True)))

    def answer(self, moved: Array, by: Seat) -> Array:
        """Change of tan(beta) on the grid to first order.

        Args:
            moved: displacement of the outline's points, shape (m, 2), mm.
            by: change of the rod's dimensions and of the wobble, mm.
        """
        angle = self.outline.angle
        out = np.zeros(self.share.shape[1])
        for share, contact in zip(self.share, self.contacts, strict=True):
            inner = np.abs(contact.face - contact.face.min()) < np.abs(contact.face - contact.face.max())
            theta = contact.cam_angle
            follower = self.setting.follower
            first = FirstOrder.of(contact, follower)
            ahead = follower.base_radius + contact.face * contact.q - first.height * first.root
            place = theta + np.arctan2(contact.across, ahead)
            at = angle[0] + (place - angle[0]) % TURN
            x, y = (np.interp(at, angle, column) for column in moved.T)
            c, s = np.cos(theta), np.sin(theta)
            face = np.where(inner, by.follower.inner, by.follower.outer) + by.wobble[0] * c + by.wobble[1] * s
            out += share * (displaced(first, theta, x, y) + first.face * face + first.thicker * by.follower.radius)
        return out


class Rolled:
    """The cam's lift with effects on its disc, its shaft and the rod.

    Attributes:
        stages: at which effects change it.
    """

    stages = (DISC, FOLLOWER)

    def __init__(self, lift: PathMotion, follower: LeaningRod, disc: Disc) -> None:
        self._lift, self._follower, self._disc = lift, follower, disc
        self._grid = np.linspace(0.0, TURN, GRID, endpoint=False)
        self._rolls: Recent[bytes, _Roll] = Recent(_KEPT)
        self._changes: Recent[bytes, PPoly] = Recent(_KEPT)
        self._lifts: Recent[bytes, PathMotion] = Recent(_KEPT)

    def change(self, active: Active, rows: object) -> PPoly | None:
        """Change of tan(beta) by cam angle; None if no effect changes disc or rod.

        Raises:
            DesignError: no rod can follow that disc.
        """
        moved = self._of(active)

        def changed() -> PPoly:
            change = self._roll(moved, rows).tan_beta - self._roll([], rows).tan_beta
            if not np.isfinite(change).all():
                raise DesignError("no rod can follow a disc that is so far from its design")
            return self._closed(change)

        return through(CHANGE, self._changes.of(key_of(moved), changed) if moved else None, active, rows)

    def lift(self, active: Active, rows: object) -> PathMotion:
        """The lift as a curve that a car can be driven by; arguments and errors as of `change`."""
        change = self.change(active, rows)
        if change is None:
            return self._lift

        def sampled() -> PathMotion:
            angle = np.linspace(0.0, TURN, STATIONS, endpoint=False)
            steering = self._lift.q(angle) + change(angle)
            return sampled_lift(angle, steering, blend_start=self._lift.blend_start, level=self._lift.level)

        return self._lifts.of(key_of([(e, v) for e, v in active if e.stage in (*self.stages, CHANGE)]), sampled)

    def first_order(self, effect: Effect, number: int, active: Active, rows: object) -> Effect:
        """An effect on the lift that stands, to first order, for a number of an effect on disc or rod.

        Args:
            effect: on disc or rod, active or not.
            number: which of its numbers; the effect returned adds its value to that.
            active: about which; an effect that is not among them, about its start, where it does nothing.
            rows: of the model.
        """
        moved = self._of(active)
        base = self._roll(moved, rows)
        values = next((v for e, v in moved if e.key == effect.key), effect.start)
        step = effect.steps[number]
        ends = []
        for sign in (-1.0, 1.0):
            there = np.array(values, dtype=float)
            there[number] = np.clip(there[number] + sign * step, effect.bounds[0][number], effect.bounds[1][number])
            others = [(e, there if e.key == effect.key else v) for e, v in moved]
            if len(others) == len(moved) and all(e.key != effect.key for e, _ in moved):
                others.append((effect, there))
            disc = through(DISC, self._disc, others, rows)
            ends.append((there[number], disc.points, through(FOLLOWER, Seat(self._follower), others, rows)))
        (low, before, less), (high, after, more) = ends
        by = high - low
        follower = LeaningRod(
            base_radius=0.0,
            inner=(more.follower.inner - less.follower.inner) / by,
            outer=(more.follower.outer - less.follower.outer) / by,
            radius=(more.follower.radius - less.follower.radius) / by,
        )
        wobble = tuple((m - w) / by for m, w in zip(more.wobble, less.wobble, strict=True))
        slope = self._closed(base.answer((after - before) / by, Seat(follower, (wobble[0], wobble[1]))))
        return Effect(
            name=effect.name,
            variant=f"{effect.variant} {number} {hash(slope.c.tobytes())}",
            stage=CHANGE,
            parameters=(effect.parameters[number],),
            act=lambda change, p, at: _plus(change, slope, float(p[0])),
        )

    def shown(self, form: Effect) -> Effect:
        """A form without a name that another record shows of the lift or the outline, as it acts here."""

        def read(place: Array, p: Array) -> Array:
            none = np.zeros(len(place), dtype=np.intp)
            return np.asarray(form.act(0.0 * place, p, Rows(run=none, place=place, elapsed=0.0 * place, cell=none - 1)))

        def on_lift(change: PPoly | None, p: Array, at: object) -> PPoly:
            return _plus(change, self._closed(read(self._grid, p) / self._follower.inner), 1.0)

        def on_outline(disc: Disc, p: Array, at: object) -> Disc:
            return disc.moved(read(disc.angle, p))

        if form.form_of is CHANGE:
            return replace(form, stage=CHANGE, act=on_lift)
        return replace(form, stage=DISC, act=on_outline)

    def _of(self, active: Active) -> list[tuple[Effect, Array]]:
        return [(e, v) for e, v in active if e.stage in self.stages]

    def _roll(self, moved: Sequence[tuple[Effect, Array]], rows: object) -> _Roll:
        def rolled() -> _Roll:
            disc = through(DISC, self._disc, moved, rows)
            return _Roll.of(disc, through(FOLLOWER, Seat(self._follower), moved, rows), self._grid)

        return self._rolls.of(key_of(moved), rolled)

    def _closed(self, values: Array) -> PPoly:
        """A periodic spline through values on the grid."""
        return CubicSpline(np.append(self._grid, TURN), np.append(values, values[0]), bc_type="periodic")


def _plus(change: PPoly | None, slope: PPoly, by: float) -> PPoly:
    coefficients = by * slope.c if change is None else change.c + by * slope.c
    return PPoly.construct_fast(coefficients, slope.x, extrapolate="periodic")


def _shifted(follower: LeaningRod, by: float) -> LeaningRod:
    return LeaningRod(
        base_radius=follower.base_radius,
        inner=follower.inner + by,
        outer=follower.outer + by,
        radius=follower.radius,
    )
