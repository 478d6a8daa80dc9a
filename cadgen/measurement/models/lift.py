"""The lift that a dial reads: the rod rolled on the changed disc."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicSpline

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import Outline
from cadgen.deviations.catalogue import LIFT
from cadgen.deviations.disc import DISC, NOSE_WIDTHS_DEG, Disc, worn_nose
from cadgen.deviations.effect import READING, Active, Effect, through
from cadgen.deviations.lift import ANGLE, FOLLOWER, Readings, Setting
from cadgen.errors import DesignError
from cadgen.measurement.models.base import Discrepancy, elapsed, fourier, per_run, unknown
from cadgen.measurement.record import Record
from cadgen.measurement.shapes import shapes

GRID = 720  # stations of the roll; only the change against the nominal cam is interpolated between them
FORM_ORDERS = 90
SHAPE_ORDERS = range(1, 61)


class LiftModel:
    """Lift by cam angle, run and direction: reading = w_in tan(beta), the dial at the inner face's nominal place."""

    unit = "um"
    measured = None

    def __init__(self, record: Record, lift: LiftCurve, follower: Follower, disc: Disc, *, floor: float) -> None:
        self._lift, self._follower = lift, follower
        self._disc = disc
        self._reading = record["lift_mm"]
        angle = np.radians(record["cam_angle_deg"])
        forward = record.columns["direction"] == "forward"
        key = np.round(record["cam_angle_deg"], 6) + 1000.0 * forward
        slope = np.asarray(lift.tan_beta(angle, nu=1))
        self.rows = Readings(
            run=record.run,
            place=angle,
            elapsed=elapsed(record.run),
            cell=np.unique(key, return_inverse=True)[1].astype(np.intp),
            direction=np.where(forward, 1.0, -1.0),
            slope=np.sign(slope),
            steering=np.asarray(lift.tan_beta(angle)),
        )
        noses = range(len(self._disc.noses))
        self.catalogue = (*LIFT.effects, *(worn_nose(k, width) for k in noses for width in NOSE_WIDTHS_DEG))
        self.datum: tuple[Effect, ...] = ()
        self.offsets = per_run(record.run)
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(angle))
        self.form, self.order = fourier(angle, FORM_ORDERS)
        self.floor = floor
        self.slip = follower.inner * slope
        self._grid = np.linspace(0.0, TURN, GRID, endpoint=False)
        self._known: dict[bytes, CubicSpline] = {}
        self._rolled = self._roll(Outline(disc.points, disc.piece), Setting(follower))

    @cached_property
    def shapes(self) -> tuple[Effect, ...]:
        """Harmonics, bumps and steps of the reading."""
        return shapes(self.rows, self.unit, SHAPE_ORDERS)

    def residual(self, active: Active) -> Array:
        """Measured less expected reading, mm."""
        angle = through(ANGLE, self.rows.place, active, self.rows)
        steering = self._lift.tan_beta(angle)
        moved = [(e, v) for e, v in active if e.stage in (DISC, FOLLOWER)]
        if moved:
            steering = steering + self._change(moved)(angle)
        reading = through(READING, self._follower.inner * steering, active, self.rows)
        return self._reading - reading

    def _change(self, active: Sequence[tuple[Effect, Array]]) -> CubicSpline:
        """Change of tan(beta) by cam angle; remembered, since most differences leave disc and rod alone."""
        key = b"".join(effect.key.encode() + np.asarray(values).tobytes() for effect, values in active)
        if key not in self._known:
            disc = through(DISC, self._disc, active, self.rows)
            setting = through(FOLLOWER, Setting(self._follower), active, self.rows)
            change = self._roll(Outline(disc.points, disc.piece), setting) - self._rolled
            if not np.isfinite(change).all():
                raise DesignError("no rod can follow a disc that is so far from its design")
            closed = np.append(change, change[0])
            self._known = {
                **dict(list(self._known.items())[-32:]),
                key: CubicSpline(np.append(self._grid, TURN), closed, bc_type="periodic"),
            }
        return self._known[key]

    def _roll(self, outline: Outline, setting: Setting) -> Array:
        a, b = setting.wobble
        if a == 0 and b == 0:
            return roll(outline, setting.follower, self._grid).tan_beta
        # A wobbling disc offers its faces at w + a cos + b sin: three rolls, and a parabola through them.
        size = float(np.hypot(a, b))
        at = [roll(outline, _shifted(setting.follower, k * size), self._grid).tan_beta for k in (-1.0, 0.0, 1.0)]
        x = (a * np.cos(self._grid) + b * np.sin(self._grid)) / size
        return at[1] + x * (at[2] - at[0]) / 2 + x**2 * (at[2] - 2 * at[1] + at[0]) / 2


def _shifted(follower: Follower, by: float) -> Follower:
    return Follower(
        base_radius=follower.base_radius,
        inner=follower.inner + by,
        outer=follower.outer + by,
        radius=follower.radius,
    )
