"""Forward models: what an instrument should have read with some effects active, and how that answers their numbers.

`Model` is the interface of every kind of data to the search. Kinds that show the lift share `Rolled`, the rod rolled on
the changed disc. A fit needs the lift of every value that it comes by, and how the lift answers each value there. The
first is rolled; the second follows from the contacts of that roll, for to first order the rod stays on the same points
of the disc (`cadgen.cam.followers.rod`).
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PPoly

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll
from cadgen.cam.follower import Contact, EdgeFollower, FirstOrder
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.sampled import sampled_lift
from cadgen.curves.closed import Outline
from cadgen.deviations.disc import DISC, Disc
from cadgen.deviations.effect import Active, Effect, Rows, Stage, key_of, through
from cadgen.deviations.lift import FOLLOWER, Seat
from cadgen.errors import DesignError
from cadgen.messages import Message

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")


class Cache(Generic[Key, Value]):
    """The last so many results by their keys; the oldest is forgotten first."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._known: dict[Key, Value] = {}

    def __contains__(self, key: Key) -> bool:
        return key in self._known

    def __getitem__(self, key: Key) -> Value:
        return self._known[key]

    def __setitem__(self, key: Key, value: Value) -> None:
        self._known.pop(key, None)
        if len(self._known) >= self._most:
            self._known.pop(next(iter(self._known)))
        self._known[key] = value

    def of(self, key: Key, make: Callable[[], Value]) -> Value:
        """The result of a key, made if it is not known."""
        if key not in self._known:
            self[key] = make()
        return self._known[key]


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
        size, rod = float(np.hypot(a, b)), setting.follower
        rods = (replace(rod, inner=rod.inner + by, outer=rod.outer + by) for by in (-size, 0.0, size))
        contacts = tuple(roll(outline, each, grid) for each in rods)
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
        out = np.zeros(self.share.shape[1])
        for share, (first, inner, ray, point, beyond) in zip(self.share, self._touching, strict=True):
            x, y = (moved[point] + beyond[:, None] * (moved[point + 1] - moved[point])).T
            c, s = ray
            face = np.where(inner, by.follower.inner, by.follower.outer) + by.wobble[0] * c + by.wobble[1] * s
            moved_here = first.displaced(x * c + y * s, y * c - x * s)
            out += share * (moved_here + first.face * face + first.thicker * by.follower.radius)
        return out

    @cached_property
    def _touching(self) -> list[tuple[FirstOrder, NDArray[np.bool_], Array, NDArray[np.intp], Array]]:
        """Where the rod touches in each contact, for whatever moves there.

        Derivatives; whether by the inner face; cosine and sine of the cam angle; the outline's point before the
        contact, and the share of the step to the next one.
        """
        angle, follower, out = self.outline.angle, self.setting.follower, []
        for contact in self.contacts:
            inner = np.abs(contact.face - contact.face.min()) < np.abs(contact.face - contact.face.max())
            theta, first = contact.cam_angle, follower.first_order(contact)
            ahead = follower.base_radius + contact.face * contact.q - first.height * first.root
            place = theta + np.arctan2(contact.across, ahead)
            at = angle[0] + (place - angle[0]) % TURN
            point = np.clip(np.searchsorted(angle, at, "right") - 1, 0, len(angle) - 2)
            step = angle[point + 1] - angle[point]
            beyond = np.clip((at - angle[point]) / np.where(step > 0, step, 1.0), 0.0, 1.0)
            out.append((first, inner, np.stack([np.cos(theta), np.sin(theta)]), point, beyond))
        return out


class Rolled:
    """The cam's lift with effects on its disc, its shaft and the rod.

    Attributes:
        stages: at which effects change it.
    """

    stages = (DISC, FOLLOWER)

    def __init__(self, lift: PathMotion, follower: EdgeFollower, disc: Disc) -> None:
        self._lift, self._follower, self._disc = lift, follower, disc
        self._grid = np.linspace(0.0, TURN, GRID, endpoint=False)
        self._rolls: Cache[bytes, _Roll] = Cache(_KEPT)
        self._changes: Cache[bytes, PPoly] = Cache(_KEPT)
        self._lifts: Cache[bytes, PathMotion] = Cache(_KEPT)

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
        here = self._of(active)
        base = self._roll(here, rows)
        values = next((v for e, v in here if e.key == effect.key), effect.start)
        step = effect.steps[number]
        ends = []
        for sign in (-1.0, 1.0):
            there = moved(effect, np.asarray(values, dtype=float), number, sign * step)
            others = [(e, there if e.key == effect.key else v) for e, v in here]
            if all(e.key != effect.key for e, _ in here):
                others.append((effect, there))
            disc = through(DISC, self._disc, others, rows)
            ends.append((there[number], disc.points, through(FOLLOWER, Seat(self._follower), others, rows)))
        (low, before, less), (high, after, more) = ends
        by = high - low
        follower = replace(
            self._follower,
            base_radius=0.0,
            inner=(more.follower.inner - less.follower.inner) / by,
            outer=(more.follower.outer - less.follower.outer) / by,
            radius=(more.follower.radius - less.follower.radius) / by,
        )
        (a, b), (a_less, b_less) = more.wobble, less.wobble
        seat = Seat(follower, ((a - a_less) / by, (b - b_less) / by))
        slope = self._closed(base.answer((after - before) / by, seat))
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
        """A periodic cubic spline through values on the grid.

        With even steps h the slopes m of m_(i-1) + 4 m_i + m_(i+1) = 3 (y_(i+1) - y_(i-1)) / h follow wave by wave.
        """
        step = TURN / len(values)
        wave = np.arange(len(values) // 2 + 1) * step
        slope = np.fft.irfft(np.fft.rfft(values) * 3j * np.sin(wave) / (2 + np.cos(wave)), len(values)) / step
        rise, next_slope = (np.roll(values, -1) - values) / step, np.roll(slope, -1)
        terms = [(slope + next_slope - 2 * rise) / step**2, (3 * rise - 2 * slope - next_slope) / step, slope, values]
        return PPoly.construct_fast(np.stack(terms), np.append(self._grid, TURN), extrapolate="periodic")


def _plus(change: PPoly | None, slope: PPoly, by: float) -> PPoly:
    coefficients = by * slope.c if change is None else change.c + by * slope.c
    return PPoly.construct_fast(coefficients, slope.x, extrapolate="periodic")


SMALL = 0.1  # of the step of a parameter


@dataclass(frozen=True)
class Discrepancy:
    """Systematic errors of a kind of record that no effect describes: columns with amplitudes of a known spread.

    Attributes:
        words: as in "fitted and never claimed: the slope of the floor".
        columns: response to one unit of each amplitude, shape (n, k).
        sigma: standard deviation of each amplitude beforehand, internal units, shape (k,).
        numbers: name and unit of each amplitude that is reported; empty where none is.
        of_frame: number of an amplitude that may be the instrument's frame instead of the car, and may be there
            whatever the size of the others; None without.
    """

    words: str = ""
    columns: Array = field(default_factory=lambda: np.empty((0, 0)))
    sigma: Array = field(default_factory=lambda: np.empty(0))
    numbers: tuple[tuple[str, str], ...] = ()
    of_frame: int | None = None

    @classmethod
    def none(cls, rows: int) -> "Discrepancy":
        """Nothing beside effects and form error, of so many rows."""
        return cls(columns=np.empty((rows, 0)))

    def variance(self, size: float, *, whole_frame: bool = False) -> Array:
        """Variance of each amplitude beforehand, shape (k,).

        Args:
            size: size of the discrepancy as a multiple of what it may be, dimensionless.
            whole_frame: whether the amplitude that may be the instrument's frame is as large as it may be.
        """
        sizes = np.full(len(self.sigma), size)
        if whole_frame and self.of_frame is not None:
            sizes[self.of_frame] = 1.0
        return np.asarray((sizes * self.sigma) ** 2)


class Model(ABC):
    """A forward model with its data; the model of a kind brings what has no default.

    Attributes:
        unit: key of `UNITS` of residuals as they are reported.
        rows: place of each number.
        catalogue: effects that can show, members of families included.
        offsets: linear datum freedoms as columns, shape (n, d).
        spread: standard deviation of each datum freedom beforehand, shape (d,); infinite where nothing is known.
        discrepancy: repeating errors beside effects and form error.
        form: response to each harmonic of the form error, for one unit of amplitude, shape (n, q).
        order: order of each column of `form`, shape (q,).
        floor: stated form error, rms, in the unit of amplitude of `form`.
        slip: response to an error of the abscissa that a whole run shares, shape (n,); empty if none can be.
        datum: effects that are always fitted and never claimed.
        behind: stages at which effects that other kinds of data show change this one too.
        rolled: lift that effects on disc and rod change; None where they act otherwise, or not at all.
        tangent: answer of the readings to a number of an effect about what is active, shape (n,), or None for a number
            for which differences do; None where they do for all.
        resolved: highest order that the spacing of the rows resolves; None where no catalogue goes by it.
        measured: coordinate of each row of a track, mm; None for what is no track.
        cameras: effects of the instrument that what is found is held against, and that are looked for beside other
            records.
        formulas: effects that are proposed for what repeats without a name.
        notes: what the record shows of its instruments before any effect is looked for, as limits of the verdict.
    """

    unit: str
    rows: Rows
    catalogue: tuple[Effect, ...]
    offsets: Array
    spread: Array
    discrepancy: Discrepancy
    form: Array
    order: Array
    floor: float
    slip: Array
    datum: tuple[Effect, ...] = ()
    behind: tuple[Stage[Any], ...] = ()
    rolled: Rolled | None = None
    tangent: Callable[[Effect, int, Active], Array | None] | None = None
    resolved: int | None = None
    measured: Array | None = None
    cameras: tuple[Effect, ...] = ()
    formulas: tuple[Effect, ...] = ()
    notes: tuple[Message, ...] = ()

    @property
    def shapes(self) -> tuple[Effect, ...]:
        """Anonymous forms that compete with the catalogue and act on the reading alone."""
        return ()

    @abstractmethod
    def residual(self, active: Active) -> Array:
        """Measured less expected with some effects active, shape (n,), internal units."""


def repeating(model: Model) -> Array:
    """Columns of form error and discrepancy, shape (n, q + k): what repeats between runs without a name."""
    return np.hstack([model.form, model.discrepancy.columns])


def unknown(columns: Array) -> Array:
    """Infinite standard deviations for freedoms of which nothing is known, one for each column.

    Args:
        columns: columns of the freedoms, shape (n, d), internal units (mm, rad).
    """
    return np.full(columns.shape[1], np.inf)


def fourier(angle: Array, last: int) -> tuple[Array, Array]:
    """Cosines and sines of orders 1 to `last`, shape (n, 2 last), and the order of each column.

    Args:
        angle: angles, rad, shape (n,).
        last: highest order.
    """
    orders = np.arange(1, last + 1)
    waves = angle[:, None] * orders
    return np.hstack([np.cos(waves), np.sin(waves)]), np.tile(orders, 2).astype(float)


def highest_order(angle: Array, run: NDArray[np.intp]) -> int:
    """The highest order that the spacing of the points resolves (Nyquist), with a fifth in hand.

    Args:
        angle: angles of the readings, rad, shape (n,).
        run: number of the run of each, shape (n,).
    """
    widest = 0.0
    for number in range(int(run.max()) + 1):
        mine = np.unique(np.round(angle[run == number] % (2 * np.pi), 9))
        widest = max(widest, float(np.median(np.diff(mine)))) if len(mine) > 1 else np.pi
    return max(1, int(0.8 * np.pi / widest))


def per_run(run: NDArray[np.intp]) -> Array:
    """Columns of each run's own zero, shape (n, runs)."""
    return np.asarray((run[:, None] == np.arange(run.max() + 1)).astype(float))


def rms_by_run(residual: Array, run: NDArray[np.intp]) -> Array:
    """Root mean square of a residual in each run, shape (runs,), in its unit.

    Args:
        residual: residual, shape (n,), mm or rad.
        run: number of the run of each row, shape (n,).
    """
    return np.array([np.sqrt(np.mean(residual[run == number] ** 2)) for number in range(int(run.max()) + 1)])


def elapsed(run: NDArray[np.intp]) -> Array:
    """Place of each row within its run, -1/2 to 1/2."""
    out = np.empty(len(run))
    for number in range(int(run.max()) + 1):
        mine = np.flatnonzero(run == number)
        out[mine] = np.linspace(-0.5, 0.5, len(mine)) if len(mine) > 1 else 0.0
    return out


def slopes(model: Model, effects: tuple[Effect, ...], active: Active, known: Array | None = None) -> Array:
    """How the expected value answers each parameter of some effects, shape (n, sum of parameters).

    Central differences over each parameter's own step, one-sided where a bound is in the way, about the value of an
    active effect or the start of any other. In place of an effect on disc or rod its change of the lift to first order
    is varied, by a small step to one side: the rod is rolled once, and what follows the lift is smooth. Members of
    families that are not active are small, and a step to one side does for them, too.

    Args:
        model: model of the record.
        effects: effects.
        active: effects that are active, with their values.
        known: residual with these, shape (n,), mm or rad; computed if left out.
    """
    values = {effect.key: v for effect, v in active}

    @cache
    def base() -> Array:
        return model.residual(active) if known is None else known

    columns = []
    for effect in effects:
        rolled = model.rolled if model.rolled and effect.stage in model.rolled.stages else None
        others = [(e, v) for e, v in active if e.key != effect.key]
        # A linearised search may have begun beyond a bound, where both sides would be the bound itself.
        middle = np.clip(np.asarray(values.get(effect.key, effect.start), dtype=float), *effect.bounds)
        for k, step in enumerate(effect.steps):
            if rolled:
                standing = rolled.first_order(effect, k, active, model.rows), np.array([SMALL * step])
                columns.append((base() - model.residual([*active, standing])) / (SMALL * step))
                continue
            if model.tangent and (column := model.tangent(effect, k, active)) is not None:
                columns.append(column)
                continue
            one_sided = effect.member and effect.key not in values
            low, high = (middle if one_sided else moved(effect, middle, k, -step)), moved(effect, middle, k, step)
            before = base() if one_sided else model.residual([*others, (effect, low)])
            columns.append((before - model.residual([*others, (effect, high)])) / (high[k] - low[k]))
    return np.stack(columns, axis=1) if columns else np.empty((len(model.rows.run), 0))


def moved(effect: Effect, values: Array, number: int, by: float) -> Array:
    """Values of an effect of which one is moved by `by`, in its unit (rad, mm), as far as its bounds let it.

    Args:
        effect: effect.
        values: values of its parameters, internal units (mm, rad).
        number: number of the parameter that is moved.
        by: change, mm or rad.
    """
    there, (lower, upper) = values.copy(), effect.bounds
    there[number] = np.clip(there[number] + by, lower[number], upper[number])
    return there
