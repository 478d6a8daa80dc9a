"""Profile: points of the outline from a measuring machine, about the bore, by their distances from the changed disc."""

from functools import cached_property
from math import pi

import numpy as np
from scipy.optimize import least_squares

from cadgen.arrays import TURN, Array
from cadgen.deviations.catalogue import PROFILE
from cadgen.deviations.disc import DISC, NOSE_WIDTHS_DEG, Disc, undulation, worn_nose
from cadgen.deviations.effect import READING, Active, Effect, Parameter, Rows, Stage, key_of, through
from cadgen.deviations.instrument import MACHINE, WARMING, moved_part
from cadgen.errors import FileError
from cadgen.inference.measurement.model import (
    Cache,
    Discrepancy,
    Model,
    elapsed,
    fourier,
    highest_order,
    moved,
    per_run,
    slopes,
    unknown,
)
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Column, Datum, Kind, Record, Span
from cadgen.inference.measurement.shapes import shapes
from cadgen.messages import Message

FORM_ORDERS = 90
UNDULATIONS = 120
MOVED = np.linspace(-0.45, 0.45, 19)  # shares of a run from which a move of the part is searched
_KEPT = 16  # distances: forms without a name act on the reading alone

CLOCK = Stage[Array]("clock")


def _polar(points: Array) -> tuple[Array, Array]:
    """Polar angles in [0, 2 pi) and radii of points, shape (n,) each."""
    return np.arctan2(points[:, 1], points[:, 0]) % TURN, np.hypot(points[:, 0], points[:, 1])


CLOCKING = Effect(
    name="clocking",
    stage=CLOCK,
    parameters=(Parameter(name="clocking_deg", unit="deg", lower=-10.0, upper=10.0, step=0.02),),
    act=lambda angle, p, at: np.asarray(angle - p[0]),
)


class ProfileModel(Model):
    """Distance of each point from the outline along the normal, outwards positive; clocking is a datum of each run.

    A part may be clamped anew for each run or file. Every run is first turned back by the clocking that it has against
    the bare design. What an effect adds to that is common to all runs, and `CLOCKING` fits it exactly beside the
    effect. What then remains between runs is so small that tangents do: these are `offsets`, for all runs but one,
    since one is the common one.

    Attributes:
        own: clocking of each run against the bare design, shape (runs,), rad.
    """

    unit = "um"
    datum = (CLOCKING,)

    def __init__(self, record: Record, nominal: Nominal) -> None:
        disc = nominal.disc
        points = np.stack([record["x_mm"], record["y_mm"]], axis=1)
        self._points, self._disc = points, disc
        # Rising polar angle over a little more than a turn, each joint once, for interpolation.
        self._forward = np.concatenate([[True], np.diff(self._disc.angle) > 0])
        radial = np.stack([np.cos(self._disc.angle), np.sin(self._disc.angle)], axis=1)
        self._slant = np.sum(self._disc.normal * radial, axis=1)
        self._table, self._known = self._around(disc), Cache[bytes, tuple[Array, Array, Array]](_KEPT)
        seen, radius = self._polar = _polar(points)
        self.own = np.array([self._clocked(seen[mine], radius[mine]) for mine in record.parts])
        place = (seen - self.own[record.run]) % TURN
        self.rows = Rows(
            run=record.run, place=place, elapsed=elapsed(record.run), cell=np.full(len(place), -1, dtype=np.intp)
        )
        self.resolved = last = record.resolved or highest_order(place, record.run)
        self.catalogue = (
            *PROFILE.effects,
            *(worn_nose(k, width) for k in range(len(self._disc.noses)) for width in NOSE_WIDTHS_DEG),
            *(undulation(order) for order in range(2, min(UNDULATIONS, last) + 1)),
            *(moved_part(float(when)) for when in MOVED),
            WARMING,
        )
        turned = slopes(self, self.datum, [])
        self.offsets = (turned * per_run(record.run))[:, 1:]
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(place))
        # Form is what departs from the mean: a disc too large all round errs in size, which is an effect.
        self.form, self.order = fourier(place, min(FORM_ORDERS, last))
        self.floor = nominal.form_error
        self.slip = np.empty(0)

    @cached_property
    def shapes(self) -> tuple[Effect, ...]:
        """Bumps and steps; harmonics are in the catalogue."""
        return shapes(self.rows, self.unit, range(0), DISC)

    def residual(self, active: Active) -> Array:
        """Distance outside the expected outline, mm."""
        distance = self._apart(active)[2]
        return np.asarray(distance - through(READING, np.zeros(len(distance)), active, self.rows))

    def _apart(self, active: Active) -> tuple[Array, Array, Array]:
        """Polar angles of the changed outline, those of the rows, and the distances of these from it as read."""
        before = [(effect, values) for effect, values in active if effect.stage is not READING]

        def looked() -> tuple[Array, Array, Array]:
            disc = through(DISC, self._disc, active, self.rows)
            seen, radius = self._polar
            if any(effect.stage is MACHINE for effect, _ in active):
                seen, radius = _polar(through(MACHINE, self._points, active, self.rows))
            angle = through(CLOCK, seen - self.own[self.rows.run], active, self.rows)
            around = self._table if disc is self._disc else self._around(disc)
            # In the unit of the machine's reading: else a scale that shrinks the noise would seem the likelier for it.
            return around[0], angle, self._distance(around, angle, radius) * self._polar[1] / radius

        return self._known.of(key_of(before), looked)

    def tangent(self, effect: Effect, number: int, active: Active) -> Array | None:
        """Motion of the outline along its normal at each row, for one unit of an effect on the disc."""
        if effect.stage is not DISC:
            return None
        middle = np.asarray(next((v for e, v in active if e.key == effect.key), effect.start), dtype=float)
        ends = [moved(effect, middle, number, sign * effect.steps[number]) for sign in (-1.0, 1.0)]
        low, high = (effect.act(self._disc, values, self.rows).points for values in ends)
        along = np.sum((high - low) * self._disc.normal, axis=1)[self._forward] / (ends[1] - ends[0])[number]
        where, angle, _ = self._apart(active)
        return np.asarray(np.interp(angle, where[:-1], along, period=TURN), dtype=float)

    def _clocked(self, seen: Array, radius: Array) -> float:
        """Clocking of one run against the bare design; the part may be turned by quarters of a turn on the machine."""
        found: list[tuple[float, float]] = []
        for quarter in (0.0, TURN / 4, TURN / 2, 3 * TURN / 4):

            def off(clocking: Array, quarter: float = quarter) -> Array:
                return self._distance(self._table, seen - quarter - clocking[0], radius)

            # A quarter that is wrong dwarfs every effect: one look tells it.
            if found and np.sum(off(CLOCKING.start) ** 2) > found[0][0]:
                continue
            fitted = least_squares(off, CLOCKING.start, bounds=CLOCKING.bounds, x_scale=CLOCKING.steps)
            found.append((2 * float(fitted.cost), quarter + float(fitted.x[0])))
        clocking = min(found)[1]
        return clocking if clocking < TURN / 2 else clocking - TURN

    def _around(self, disc: Disc) -> tuple[Array, Array, Array]:
        """Polar angles of a disc's outline, rising, its radii, and the cosines between normal and radius."""
        points = disc.points[self._forward]
        where, reach = np.unwrap(np.arctan2(points[:, 1], points[:, 0])), np.hypot(points[:, 0], points[:, 1])
        slant = self._slant[self._forward]
        # One point beyond the turn closes the table; chords fall short of the curve by under 0.01 um.
        return np.append(where, where[0] + TURN), np.append(reach, reach[0]), np.append(slant, slant[0])

    def _distance(self, around: tuple[Array, Array, Array], angle: Array, radius: Array) -> Array:
        """Distance of points at polar angles and radii from a disc, along its normal."""
        where, reach, slant = around
        at = where[0] + (angle - where[0]) % TURN
        return np.asarray((radius - np.interp(at, where, reach)) * np.interp(at, where, slant))


MOST_TURN = 2 * pi + 0.5  # of one run, rad: a little over a turn may be measured twice


def _check(record: Record) -> None:
    turned = np.arctan2(record["y_mm"], record["x_mm"])
    for run, mine in enumerate(record.parts):
        steps = np.diff(turned[mine])
        swept = float(np.sum((steps + pi) % (2 * pi) - pi))
        if abs(swept) > MOST_TURN:
            raise FileError(
                "{file}: run {run} goes round {swept:.1f} times; number each turn as its own run",
                file=record.source,
                run=run + 1,
                swept=abs(swept) / (2 * pi),
            )


def _clocking(
    model: ProfileModel, residual: Array, sigma: Array, active: Active, datum: list[tuple[Effect, Array, Array]]
) -> tuple[Array, Array]:
    """Clocking of each run: its own, what all runs share, and what its tangents show beside."""
    ((_, common, unsure),) = datum
    white = slopes(model, model.datum, active) * per_run(model.rows.run) / sigma[:, None]
    left = -np.linalg.lstsq(white, residual / sigma, rcond=None)[0]
    angle = model.own + common[0] + left
    return angle[:, None], np.hypot(unsure[0], 1 / np.linalg.norm(white, axis=0))[:, None]


KIND = Kind(
    code="profile",
    title=Message("Profile"),
    columns=(Column(name="x_mm", lower=-1e3, upper=1e3), Column(name="y_mm", lower=-1e3, upper=1e3)),
    readings=("x_mm", "y_mm"),
    catalogue=PROFILE,
    datum=Datum(
        words="the clocking on the machine", name="clocking", numbers=(("clocking_deg", "deg"),), fit=_clocking
    ),
    model=ProfileModel,
    check=_check,
    spans=lambda record, nominal: [
        Span(
            "x_mm, y_mm",
            float(np.hypot(record["x_mm"], record["y_mm"]).max()),
            float(np.linalg.norm(nominal.disc.points, axis=1).max()),
            "mm",
        )
    ],
    around=True,
    noise=2e-3,
    nearness=0,
)
