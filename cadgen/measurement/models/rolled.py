"""What effects on disc and follower make of the lift: the rod rolled on the changed disc."""

from collections.abc import Sequence

import numpy as np
from scipy.interpolate import CubicSpline

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.lift import LiftCurve
from cadgen.curves.closed import Outline
from cadgen.deviations.disc import DISC, Disc
from cadgen.deviations.effect import Active, Effect, through
from cadgen.deviations.lift import FOLLOWER, Setting
from cadgen.errors import DesignError
from cadgen.motion.sampled import sampled_lift

GRID = 720  # stations of the roll; only the change against the nominal cam is interpolated between them
STATIONS = 3600  # of a changed lift as a curve; it errs by under 0.01 um between them
_KEPT = 128  # most differences leave disc and rod alone


class Rolled:
    """The cam's lift with effects on its disc, its shaft and the rod.

    Attributes:
        stages: at which effects change it.
    """

    stages = (DISC, FOLLOWER)

    def __init__(self, lift: LiftCurve, follower: LeaningRod, disc: Disc) -> None:
        self._lift, self._follower, self._disc = lift, follower, disc
        self._grid = np.linspace(0.0, TURN, GRID, endpoint=False)
        self._nominal: Array | None = None
        self._changes: dict[bytes, CubicSpline] = {}
        self._lifts: dict[bytes, LiftCurve] = {}

    def change(self, active: Active, rows: object) -> CubicSpline | None:
        """Change of tan(beta) by cam angle; None if no effect changes disc or rod.

        Raises:
            DesignError: no rod can follow that disc.
        """
        moved = self._of(active)
        if not moved:
            return None
        key = _key(moved)
        if key not in self._changes:
            if self._nominal is None:
                self._nominal = self._roll(Outline(self._disc.points, self._disc.piece), Setting(self._follower))
            disc = through(DISC, self._disc, moved, rows)
            setting = through(FOLLOWER, Setting(self._follower), moved, rows)
            change = self._roll(Outline(disc.points, disc.piece), setting) - self._nominal
            if not np.isfinite(change).all():
                raise DesignError("no rod can follow a disc that is so far from its design")
            closed = CubicSpline(np.append(self._grid, TURN), np.append(change, change[0]), bc_type="periodic")
            self._changes = {**dict(list(self._changes.items())[-_KEPT:]), key: closed}
        return self._changes[key]

    def lift(self, active: Active, rows: object) -> LiftCurve:
        """The lift as a curve that a car can be driven by; arguments and errors as of `change`."""
        change = self.change(active, rows)
        if change is None:
            return self._lift
        key = _key(self._of(active))
        if key not in self._lifts:
            angle = np.linspace(0.0, TURN, STATIONS, endpoint=False)
            steering = self._lift.tan_beta(angle) + change(angle)
            made = sampled_lift(angle, steering, blend_start=self._lift.blend_start, level=self._lift.level)
            self._lifts = {**dict(list(self._lifts.items())[-_KEPT:]), key: made}
        return self._lifts[key]

    def _of(self, active: Active) -> list[tuple[Effect, Array]]:
        return [(e, v) for e, v in active if e.stage in self.stages]

    def _roll(self, outline: Outline, setting: Setting) -> Array:
        a, b = setting.wobble
        if a == 0 and b == 0:
            return roll(outline, setting.follower, self._grid).tan_beta
        # A wobbling disc offers its faces at w + a cos + b sin: three rolls, and a parabola through them.
        size = float(np.hypot(a, b))
        at = [roll(outline, _shifted(setting.follower, k * size), self._grid).tan_beta for k in (-1.0, 0.0, 1.0)]
        x = (a * np.cos(self._grid) + b * np.sin(self._grid)) / size
        return at[1] + x * (at[2] - at[0]) / 2 + x**2 * (at[2] - 2 * at[1] + at[0]) / 2


def _key(active: Sequence[tuple[Effect, Array]]) -> bytes:
    return b"".join(effect.key.encode() + np.asarray(values).tobytes() for effect, values in active)


def _shifted(follower: LeaningRod, by: float) -> LeaningRod:
    return LeaningRod(
        base_radius=follower.base_radius,
        inner=follower.inner + by,
        outer=follower.outer + by,
        radius=follower.radius,
    )
