"""The car as it was built: effects that stay with the car, with the process or with a disc, put to use.

Prediction: an outline goes through the effects on the disc in turn and is rolled with the rod as it is. Cutting: the
outline is moved the other way first, so that the finished disc, on this car's shaft, is the one wanted.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.contact import roll
from cadgen.cam.follower import Contact
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.steering import Car
from cadgen.curves.closed import ClosedCurve, Outline, left_normal
from cadgen.curves.derived import moved
from cadgen.deviations import quantities
from cadgen.deviations.disc import (
    AXIS_REVERSAL,
    DISC,
    Disc,
    joined_normals,
    lost_motion,
    nominal_disc,
    ramped_reversal,
)
from cadgen.deviations.effect import Effect
from cadgen.deviations.lead import led
from cadgen.deviations.names import Place
from cadgen.deviations.transmission import MESH
from cadgen.errors import DesignError

# Which of a disc's effects stand still on the shaft, whatever way the disc's key is turned.
_OF_SHAFT = (quantities.ECCENTRIC_BORE, quantities.SHAFT_RUNOUT)

_Act = Callable[[Disc, Array, Any], Disc]

# Points at which a cut outline is found, mm: shifts are smooth at this scale, and their spline errs by less than 1 nm.
_NODE_STEP = 0.1
_CONVERGED = 1e-10  # mm
_MOST_STEPS = 50  # each leaves 2 % at most, the greatest scale, of what was left before
# An offset of 0.5 mm makes the sides of a corner of 8 degrees overlap by this angle, rad; more is an overhang.
_OVERLAP = 1e-3


@dataclass(frozen=True)
class Placed:
    """An effect, its values in mm and rad, and what becomes of it.

    Attributes:
        sigma: standard deviation of the first value; 0 if it is not known.
        on_track: whether a track showed it.
    """

    effect: Effect
    values: tuple[float, ...]
    place: Place
    sigma: float = 0.0
    on_track: bool = False

    @property
    def leads(self) -> bool:
        """Whether the camshaft leads or lags its gears by it, the same at each turn."""
        return self.effect.stage is MESH and self.place == Place.CAR


@dataclass(frozen=True)
class AsBuilt:
    """The effects of a car, in the order in which they act; none for a car as designed.

    Attributes:
        effects: of the car.
        rod: as designed; None for another follower, which has none of these effects.
    """

    effects: tuple[Placed, ...] = ()
    rod: LeaningRod | None = None

    def car(self, nominal: Car) -> Car:
        """The car in plan view: offset of the drive wheel, steering zero, gain of the lever and slip."""
        return replace(
            nominal,
            drive_wheel_offset=nominal.drive_wheel_offset + self._of_car("drive_wheel_offset_mm"),
            steering_zero=self._of_car("steering_zero_deg"),
            steering_gain=nominal.steering_gain * (1 + self._of_car("gain_percent")),
            slip=self._of_car("slip_percent"),
        )

    def follower(self, nominal: LeaningRod) -> LeaningRod:
        """The rod and the faces.

        Raises:
            DesignError: nothing would be left of the rod, or of its distance from the disc.
        """
        away, radius = self._of_car("axial_offset_um"), nominal.radius + self._of_car("rod_radius_um")
        inner, outer = nominal.inner + away, nominal.outer + away
        correct = "correct rod_radius_um or axial_offset_um in [as_built]"
        if radius <= 0:
            less = 1e3 * (nominal.radius - radius)
            raise DesignError(
                f"as built nothing is left of the rod: its radius of {nominal.radius:g} mm is to be {less:g} µm less: "
                f"{correct}"
            )
        if radius >= inner:
            raise DesignError(
                f"as built the rod's radius is {radius:g} mm and the disc's inner face {abs(inner):g} mm "
                f"{'from' if inner >= 0 else 'behind'} the fork axis; the rod must swing clear of it: {correct}"
            )
        return replace(nominal, inner=inner, outer=outer, radius=radius)

    def travel(self, nominal: float) -> float:
        """Travel of the drive wheel's rim for one turn of the cam, mm.

        Args:
            nominal: travel of the car as designed, mm.
        """
        return nominal * (1 + self._of_car("wheel_radius_percent"))

    @property
    def play(self) -> float | None:
        """Return error B, rad; None if it was not found."""
        return self._of_car("return_error_deg") if "return_error_deg" in self._numbers() else None

    @property
    def friction(self) -> tuple[float, float] | None:
        """Sliding friction between rod and disc, and its standard deviation; None if it was not found."""
        for placed in self.effects:
            if placed.place == Place.CAR and placed.effect.quantity == quantities.SLIDING_FRICTION:
                return placed.values[0], placed.sigma
        return None

    @property
    def runs_free(self) -> bool:
        """Whether the return error was found on a track as if the rod slid without friction."""
        return self.shows_play_with_rod and self.friction is None

    @property
    def shows_play_with_rod(self) -> bool:
        """Whether the return error, or that there is none, was found on a track."""
        return any(
            placed.place == Place.CAR and placed.effect.quantity == quantities.RETURN_ERROR and placed.on_track
            for placed in self.effects
        )

    @property
    def phase(self) -> float:
        """How far the measured cam stands ahead on its shaft, rad."""
        return self._of_car("phase_deg")

    @property
    def shapes_discs(self) -> bool:
        """Whether a new disc comes out, or runs, other than it is cut."""
        return any(
            placed.leads or (placed.effect.stage is DISC and placed.place in (Place.PROCESS, Place.CAR))
            for placed in self.effects
        )

    def unevenness(self, *, measured: bool) -> float:
        """Rises and falls of the lift that waves and steps of the outline may make, mm: they are no events of a path.

        Args:
            measured: whether the disc is the one that was measured, or else a new one.
        """
        places: tuple[Place, ...] = (Place.PART, Place.PROCESS) if measured else (Place.PROCESS,)
        height = 0.0
        for placed in self.effects:
            uneven = placed.effect.quantity in (quantities.AXIS_REVERSAL, quantities.UNDULATION)
            if placed.place in places and uneven:
                height += 2 * float(np.hypot(placed.values[0], placed.values[1]))
        return height

    def roll_measured(self, curve: ClosedCurve, follower: LeaningRod, cam_angle: Array, step: float) -> Contact:
        """Contact of the rod with the cam that was measured.

        Args:
            curve: profile of that cam as designed, mm.
            follower: rod as built.
            cam_angle: angles of the shaft for the contact, shape (n,), rad.
            step: step of the outline, mm.

        Raises:
            DesignError: as `roll`, or a worn nose that the profile does not have.
        """
        disc = nominal_disc(curve, step)
        for placed in self.effects:
            number = dict(placed.effect.indices).get("nose_number", 0)
            if placed.place == Place.PART and number > len(disc.noses):
                raise DesignError(
                    f"[as_built] has a worn nose number {number:g}, but the profile has {len(disc.noses)}: correct "
                    "nose_number"
                )
        disc = self._acted(disc, (Place.PART, Place.PROCESS, Place.CAR), 0.0, AXIS_REVERSAL.act)
        disc = self._led(disc, self.phase, disc)
        contact = roll(_outline_of(disc), follower, cam_angle + self.phase)
        return replace(contact, cam_angle=cam_angle)

    def roll_new(self, curve: ClosedCurve, follower: LeaningRod, cam_angle: Array, step: float) -> Contact:
        """The rod on a new cam that is cut to `curve`; arguments as for `roll_measured`.

        Args:
            curve: curve that is cut, mm.
            follower: rod as designed.
            cam_angle: cam angles, rad, shape (n,).
            step: step of the outline, mm.

        Raises:
            DesignError: as `roll`.
        """
        if not self.shapes_discs:
            return roll(curve.outline(step), follower, cam_angle)
        return roll(_outline_of(self._of_new(nominal_disc(curve, step))), follower, cam_angle)

    def finished(self, outline: Outline) -> Outline:
        """Outline on this car's shaft of a disc cut to an outline, such as one read back from a file, mm."""
        if not self.shapes_discs:
            return outline
        return _outline_of(self._of_new(_disc_of(outline)))

    def precompensated(self, wanted: ClosedCurve) -> ClosedCurve:
        """The curve to be cut, so that the finished disc on the car's shaft is the one wanted.

        The effects on the disc are solved for the points by fixed-point iteration, with the normals of the wanted
        curve: those of the cut one are the same for an offset and differ by the scale for a scale, so the error is of
        second order. A machine-axis reversal is taken back over ramps at the four quadrants, since no cutter can make
        a step: there, over a hundredth of the turn, a part of it is left.

        Args:
            wanted: profile of the disc.
        """
        if not self.shapes_discs:
            return wanted
        at = wanted.parameters(_NODE_STEP)
        jets = [piece.jet(t) for piece, t in zip(wanted.pieces, at, strict=True)]
        points = np.concatenate([jet.point for jet in jets])
        disc = Disc(
            points=points,
            normal=-left_normal(np.concatenate([jet.velocity for jet in jets])),
            angle=np.unwrap(np.arctan2(points[:, 1], points[:, 0])),
            noses=np.empty(0),
            piece=np.repeat(np.arange(len(at)), [len(t) for t in at]),
        )
        curvature = np.concatenate([jet.curvature for jet in jets])
        cut = disc
        for _ in range(_MOST_STEPS):
            missing = points - self._of_new(cut, ramped_reversal, curvature, asking=disc).points
            cut = replace(cut, points=cut.points + missing)
            if np.abs(missing).max() < _CONVERGED:
                break
        return moved(wanted, at, tuple(np.split(cut.points - points, np.cumsum([len(t) for t in at])[:-1])))

    def _of_new(
        self, disc: Disc, reversal: _Act = lost_motion, at: Array | None = None, asking: Disc | None = None
    ) -> Disc:
        """Deviations of a new disc in its making and on the shaft; `asking` as of `led`, its own lift if left out."""
        finished = self._acted(disc, (Place.PROCESS, Place.CAR), self.phase, reversal, at)
        # The torque follows the lift on the shaft as it leads, found here in one step.
        return self._led(finished, 0.0, asking or self._led(finished, 0.0, finished))

    def _led(self, disc: Disc, ahead: float, asking: Disc) -> Disc:
        """Let the shaft lead or lag; arguments as of `led`."""
        leading = [(placed.effect, placed.values) for placed in self.effects if placed.leads]
        return led(disc, leading, ahead, self.rod, asking) if leading and self.rod else disc

    def _acted(
        self, disc: Disc, places: tuple[Place, ...], turned: float, reversal: _Act, at: Array | None = None
    ) -> Disc:
        """Let the effects of some places act; the shaft's are turned back by an angle, as the disc's key is."""
        for placed in self.effects:
            if placed.effect.stage is DISC and placed.place in places:
                values, act = np.array(placed.values), placed.effect.act
                if placed.place == Place.CAR and placed.effect.quantity in _OF_SHAFT:
                    c, s = np.cos(turned), np.sin(turned)
                    values = np.array([c * values[0] + s * values[1], c * values[1] - s * values[0]])
                if placed.effect.quantity == quantities.AXIS_REVERSAL:
                    act = reversal
                disc = act(disc, values, at)
        return disc

    def _of_car(self, name: str) -> float:
        return self._numbers().get(name, 0.0)

    def _numbers(self) -> dict[str, float]:
        """Values of what stays with the car by the names of the parameters, mm and rad."""
        return {
            parameter.name: value
            for placed in self.effects
            if placed.place == Place.CAR
            for parameter, value in zip(placed.effect.parameters, placed.values, strict=True)
        }


AS_DESIGNED = AsBuilt()


def _outline_of(disc: Disc) -> Outline:
    """The disc's outline, without the points by which the sides of a corner run into each other."""
    angle = np.unwrap(np.arctan2(disc.points[:, 1], disc.points[:, 0]))
    back = np.maximum.accumulate(angle) - angle
    keep = (back <= 0) | (back > _OVERLAP)
    return Outline(disc.points[keep], disc.piece[keep])


def _disc_of(outline: Outline) -> Disc:
    """An outline with normals from its own points; a joint's two points get one normal, so that it stays closed."""
    points = outline.points
    tangent = np.concatenate(
        [np.gradient(points[outline.piece == k], axis=0, edge_order=2) for k in np.unique(outline.piece)]
    )
    return Disc(points, joined_normals(points, -left_normal(tangent)), outline.angle, np.empty(0), outline.piece)
