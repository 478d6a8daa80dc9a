"""The car as it was built: effects that stay with the car, with the process or with a disc, put to use.

Prediction: an outline goes through the effects on the disc in turn and is rolled with the rod as it is. Cutting: the
outline is moved the other way first, so that the finished disc, on this car's shaft, is the one wanted.

A camshaft may lead or lag its gears by the same at each turn, by run-out of the gears and wind-up. Where the gears ask
for theta, it stands at psi = theta + delta(theta), and the follower rests on the points that a true shaft brings under
it at psi. A disc whose points are turned back by delta, each where the follower rests on it, gives the same lift at
theta, to first order in the slope of delta.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import degrees, inf
from typing import Any

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll, rolling_step
from cadgen.cam.follower import Contact, EdgeFollower, Follower
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Running, drive, turns_of
from cadgen.car.running.sampled import rolled_lift
from cadgen.car.steering import Car
from cadgen.check import Bound, Check, CheckCode
from cadgen.curves.closed import ClosedCurve, Outline, left_normal
from cadgen.curves.derived import moved
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.deviations.disc import (
    AXIS_REVERSAL,
    DISC,
    Disc,
    joined_normals,
    lost_motion,
    nominal_disc,
    ramped_reversal,
)
from cadgen.deviations.effect import Active, Effect, through
from cadgen.deviations.lift import FOLLOWER, Seat
from cadgen.deviations.track import RUNNING
from cadgen.deviations.transmission import MESH, Turned
from cadgen.errors import DesignError
from cadgen.messages import Message

# Effects of a disc that stand still on the shaft, whatever way the disc's key is turned.
_OF_SHAFT = (deviation.ECCENTRIC_BORE, deviation.SHAFT_RUNOUT)

_Act = Callable[[Disc, Array, Any], Disc]

# Points at which a cut outline is found, mm: shifts are smooth at this scale, and their spline errs by less than 1 nm.
_NODE_STEP = 0.1
_CONVERGED = 1e-10  # mm
_MOST_STEPS = 50  # each leaves 2 % at most, the greatest scale, of what was left before
# An offset of 0.5 mm makes the sides of a corner of 8 degrees overlap by this angle, rad; more is an overhang.
_OVERLAP = 1e-3

# Radians of lead per radian of the cam beyond which first order is not good enough: what is left is this share of it.
STEEPEST = 0.1
_GRID = np.linspace(0.0, TURN, 3600, endpoint=False)
_LEAD_STEPS = 4  # to the angle that the gears ask for; each leaves a tenth of the error at most


MORE = 0.1  # mm: a hand with a file or a deburring tool takes that much off an edge without being asked
_STATIONS = 1200  # the difference of two runs then errs by 1e-3 mm
_RUN_STEPS = 1200  # of a turn; what is wanted is the difference of two
_TRIM_STEP = 1e-4  # rad, of the steering, by which the end of a run is differentiated
_TRIM_ROUNDS = 4  # of Gauss and Newton, from an end that is off by centimetres


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
    rod: EdgeFollower | None = None

    def car(self, nominal: Car) -> Car:
        """The car in plan view: offset of the drive wheel, steering zero, gain of the lever and slip."""
        return through(RUNNING, Running(car=nominal, length=TURN), self._of_car, None).car

    def follower(self, nominal: EdgeFollower) -> EdgeFollower:
        """The rod and the faces.

        Raises:
            DesignError: nothing would be left of the rod, or of its distance from the disc.
        """
        rod = through(FOLLOWER, Seat(nominal), self._of_car, None).follower
        correct = Message("correct rod_radius_um or axial_offset_um in [as_built]")
        if rod.radius <= 0:
            less = 1e3 * (nominal.radius - rod.radius)
            raise DesignError(
                "as built nothing is left of the rod: its radius of {radius:g} mm is to be {less:g} µm less: {correct}",
                radius=nominal.radius,
                less=less,
                correct=correct,
            )
        if rod.outer - rod.inner <= 0 < self.broken_edges:
            raise DesignError(
                "as built both edges are broken by {edges:g} mm more, which leaves no land of a rim of {land:g} mm: "
                "correct broken_edges_um in [as_built]",
                edges=self.broken_edges,
                land=nominal.outer - nominal.inner,
            )
        if rod.radius >= rod.inner:
            raise DesignError(
                "as built the rod's radius is {radius:g} mm and the disc's inner face {inner:g} mm {where} the fork "
                "axis; the rod must swing clear of it: {correct}",
                radius=rod.radius,
                inner=abs(rod.inner),
                where=Message("from") if rod.inner >= 0 else Message("behind"),
                correct=correct,
            )
        return rod

    @property
    def broken_edges(self) -> float:
        """By how much more than in the design the disc's edges are broken, as a chamfer's leg, mm."""
        return self._value(deviation.EDGE_BREAK) or 0.0

    def travel(self, nominal: float) -> float:
        """Travel of the drive wheel's rim for one turn of the cam, mm.

        Args:
            nominal: travel of the car as designed, mm.
        """
        return nominal * (1 + (self._value(deviation.WHEEL_RADIUS) or 0.0))

    @property
    def play(self) -> float | None:
        """Return error B, rad; None if it was not found."""
        return self._value(deviation.RETURN_ERROR)

    @property
    def friction(self) -> tuple[float, float] | None:
        """Sliding friction between rod and disc, and its standard deviation; None if it was not found."""
        found = (each for each in self.effects if each.effect.deviation == deviation.SLIDING_FRICTION)
        return next(((each.values[0], each.sigma) for each in found if each.place == Place.CAR), None)

    @property
    def runs_free(self) -> bool:
        """Whether the return error was found on a track as if the rod slid without friction."""
        return self.shows_play_with_rod and self.friction is None

    @property
    def shows_play_with_rod(self) -> bool:
        """Whether the return error, or that there is none, was found on a track."""
        return any(
            placed.place == Place.CAR and placed.effect.deviation == deviation.RETURN_ERROR and placed.on_track
            for placed in self.effects
        )

    @property
    def phase(self) -> float:
        """How far the measured cam stands ahead on its shaft, rad."""
        return self._value(deviation.CAM_PHASE) or 0.0

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
            uneven = placed.effect.deviation in (deviation.AXIS_REVERSAL, deviation.UNDULATION)
            if placed.place in places and uneven:
                height += 2 * float(np.hypot(placed.values[0], placed.values[1]))
        return height

    def roll_measured(self, curve: ClosedCurve, follower: EdgeFollower, cam_angle: Array, step: float) -> Contact:
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
                    "[as_built] has a worn nose number {number:g}, but the profile has {count}: correct nose_number",
                    number=number,
                    count=len(disc.noses),
                )
        disc = self._acted(disc, (Place.PART, Place.PROCESS, Place.CAR), 0.0, AXIS_REVERSAL.act)
        disc = self._led(disc, self.phase, disc)
        contact = roll(_outline_of(disc), follower, cam_angle + self.phase)
        return replace(contact, cam_angle=cam_angle)

    def roll_new(self, curve: ClosedCurve, follower: Follower, cam_angle: Array, step: float) -> Contact:
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
        pieces = (outline.points[outline.piece == k] for k in np.unique(outline.piece))
        tangent = np.concatenate([np.gradient(points, axis=0, edge_order=2) for points in pieces])
        # A joint's two points get one normal, so that the outline stays closed.
        normal = joined_normals(outline.points, -left_normal(tangent))
        return _outline_of(self._of_new(Disc(outline.points, normal, outline.angle, np.empty(0), outline.piece)))

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
                if placed.place == Place.CAR and placed.effect.deviation in _OF_SHAFT:
                    c, s = np.cos(turned), np.sin(turned)
                    values = np.array([c * values[0] + s * values[1], c * values[1] - s * values[0]])
                if placed.effect.deviation == deviation.AXIS_REVERSAL:
                    act = reversal
                disc = act(disc, values, at)
        return disc

    @property
    def _of_car(self) -> Active:
        """Effects that stay with the car, with their values, mm and rad."""
        return [(each.effect, np.array(each.values)) for each in self.effects if each.place == Place.CAR]

    def _value(self, which: deviation.Deviation) -> float | None:
        """Value of a deviation that stays with the car, mm or rad, by whatever data it was found; None without it."""
        found = (float(values[0]) for effect, values in self._of_car if effect.deviation == which)
        return next(found, None)


AS_DESIGNED = AsBuilt()


def _outline_of(disc: Disc) -> Outline:
    """The disc's outline, without the points by which the sides of a corner run into each other."""
    angle = np.unwrap(np.arctan2(disc.points[:, 1], disc.points[:, 0]))
    back = np.maximum.accumulate(angle) - angle
    keep = (back <= 0) | (back > _OVERLAP)
    return Outline(disc.points[keep], disc.piece[keep])


def led(
    disc: Disc, effects: Sequence[tuple[Effect, tuple[float, ...]]], ahead: float, rod: EdgeFollower, asking: Disc
) -> Disc:
    """The disc that gives on a true shaft the lift that a disc gives on a shaft that leads.

    Args:
        disc: as finished, on the shaft that leads.
        effects: of the train on the camshaft's angle, with their values, rad.
        ahead: angle by which the disc stands ahead on its shaft, rad.
        rod: that follows, as designed.
        asking: disc whose lift on a true shaft sets the torque that winds the train up.

    Raises:
        DesignError: the lead changes too fast for this.
    """
    contact = _contact(disc, rod)[0] - ahead
    slope = _slope(asking, ahead, rod)

    def lead(angle: Array) -> Array:
        turned = np.append(angle, 0.0)
        leading, at = turned, Turned(turned=turned, torque=np.interp(turned, _GRID, slope, period=TURN))
        for effect, values in effects:
            leading = effect.act(leading, np.array(values), at)
        off = leading - turned
        return np.asarray(off[:-1] - off[-1], dtype=float)

    off = lead(contact)
    steepest = np.abs(np.diff(lead(_GRID))).sum() / TURN
    if steepest > STEEPEST:
        raise DesignError(
            "as built the camshaft gains and loses {steepest:.1f} degrees on its gears in a turn, and a cam takes out "
            "{most:.0f} at most: mend the train, or set place to noted",
            steepest=np.degrees(steepest * TURN),
            most=np.degrees(STEEPEST * TURN),
        )
    for _ in range(_LEAD_STEPS):
        off = lead(contact - off)
    c, s = np.cos(off), np.sin(off)
    x, y = disc.points.T
    return replace(disc, points=np.stack([c * x + s * y, c * y - s * x], axis=1))


def _contact(disc: Disc, rod: EdgeFollower) -> tuple[Array, Array]:
    """Cam angles at which the rod rests on a disc's points, rad, and distances of its middle there, mm."""
    x, y = (disc.points + rod.radius * disc.normal).T
    return np.arctan2(y, x), np.hypot(x, y)


def _slope(disc: Disc, ahead: float, rod: EdgeFollower) -> Array:
    """Slope of tan(beta) on the grid, over its greatest: the torque of the shaft as `transmission.Turned` has it."""
    contact, reach = _contact(disc, rod)
    place = (contact - ahead) % TURN
    order = np.argsort(place)
    lift = np.interp(_GRID, place[order], reach[order], period=TURN) - rod.base_radius
    tangent = lift / rod.contact_face(lift)
    slope = np.roll(tangent, -1) - np.roll(tangent, 1)
    return np.asarray(slope / np.abs(slope).max(), dtype=float)


def edges_check(
    lift: PathMotion, follower: EdgeFollower, cut: ClosedCurve, as_built: AsBuilt, car: Car, travel: float
) -> Check:
    """Error at the end of the run with both edges broken by `MORE` beyond the design, before and after a trim.

    Both runs are without play: its jumps are the same in both. A trim is one constant added to the steering.

    Args:
        lift: lift that the profile is made for.
        follower: follower that rolls on the profile.
        cut: curve that is cut, mm.
        as_built: deviations of the disc in its making and on the car.
        car: dimensions of the car.
        travel: travel of the drive wheel's rim for one turn of the cam, mm.

    Returns:
        The error, mm, as a figure without a limit; its place has the error after the trim.
    """
    more = min(MORE, follower.land / 2)
    worn = replace(follower, inner=follower.inner + more, outer=follower.outer - more)
    theta, step = np.linspace(0.0, TURN, _STATIONS, endpoint=False), rolling_step(cut, follower)
    wanted, got = (
        rolled_lift(as_built.roll_new(cut, rod, theta, step), lift, blend_start=lift.blend_start)
        for rod in (follower, worn)
    )
    end = _end(wanted, car, travel)

    def off(trim: float) -> complex:
        return _end(got, replace(car, steering_zero=car.steering_zero + trim), travel) - end

    trim = 0.0
    for _ in range(_TRIM_ROUNDS):
        error, slope = off(trim), (off(trim + _TRIM_STEP) - off(trim - _TRIM_STEP)) / (2 * _TRIM_STEP)
        trim -= (error * slope.conjugate()).real / abs(slope) ** 2
    return Check(
        CheckCode.EDGES_BROKEN_MORE,
        Message("edges broken {more:g} mm more", more=more),
        abs(off(0.0)),
        "mm",
        inf,
        Bound.MAX,
        Message(
            "at the finish; {off:.1f} mm with the steering trimmed by {trim:.3f}°",
            off=abs(off(trim)),
            trim=degrees(trim),
        ),
    )


def _end(lift: PathMotion, car: Car, travel: float) -> complex:
    """End of a run without play as x + iy, mm."""
    x, y = drive(lift, car, travel, steps=_RUN_STEPS * turns_of(lift.blend_start)).drive_wheel[-1].tolist()
    return complex(x, y)
