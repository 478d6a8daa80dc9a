"""Search for the windows by which a lift is turned ahead on its leads, for cars whose rod rubs.

For one car, whose play and friction are known, the windows are the play but for little, and the end of the run is met:
Gauss-Newton steps through the exact chain (turned lift, leads, run) on the end and on the headings after the leads. The
first ramps may move besides, so that there are unknowns enough on a cam that leads once or twice.

For cars that differ little about a known one, the same steps make the sum of squares of all their ends least. The end
answers to the friction by how far a lead begins and ends elsewhere. A ramp that makes the fall steeper at once lets
every friction begin the lead at one place. To the play the end answers by the leads themselves, whatever the profile.

For the cars of a wide band the worst end is made least, before or after the trim of a trial run: linear programs on
the ends within a region that shrinks where a step does not help.
"""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from math import radians

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog, lsq_linear

from cadgen.arrays import Array
from cadgen.cam.envelope import actual_profile
from cadgen.cam.follower import EdgeFollower
from cadgen.car.against_play.trial_run import SteeringTrim, TrialRun
from cadgen.car.against_play.turned_leads import TurnedLeads
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import Leads, Mechanics
from cadgen.errors import DesignError

_ROOM = 1.3  # times the play: the widest window
_EARLIER = radians(6.0)  # by which a first ramp may move at most
_HEADING = 60.0  # mm by rad: what a heading after a lead counts beside the end
_KEPT = (1.0, 0.3)  # mm by rad: what a window off the play counts, and a ramp off its place
_PROBE = (2e-4, 1e-3)  # rad, of a window and of a ramp's place
_STEPS = 12  # of a search
_LITTLE = 0.01  # of the sum of squares; a step that gains less is the last
_MET = 0.1  # mm; an end that is met
_MET_WELL = 1.0  # mm; a score at which no other places of the ramps are tried
_ON_WAY = 0.1  # mm at the end for a mm on the way
# Shares of the friction by which leads are found, where two of them may be one, and by what the ramps begin earlier at
# first, rad: for one car, and for cars that differ little, whose sum of squares has many valleys.
_PLACES = ((1.0, 0.0), (0.95, 0.0), (1.05, 0.0))
_PLACES_ALIKE = (
    *((share, radians(ahead)) for share in (1.05, 1.1) for ahead in (0.0, 1.5, -1.5)),
    *((share, radians(ahead)) for share in (0.9, 1.0) for ahead in (0.0, -1.5)),
    *((share, radians(-1.5)) for share in (0.8, 0.85)),
)
_ALIKE = (radians(0.06), 0.06)  # cars whose plays and frictions differ by no more differ little
_NEGATIVE = -0.3  # times the greatest play: the least window of cars that are trimmed
_REGION = radians(0.25)  # first step of a window over a band
_SMALLEST = radians(0.01)
_TRIM_SETTLED = 1e-4  # of tan(beta), while searching: after a step as small as that another moves the end by 0.01 mm


@dataclass
class LeadSearch:
    """Search for the profile with the least worst end of run over the cars that may be built.

    Attributes:
        lift: lift that is turned ahead.
        follower: follower of the car.
        runs: runs of the car and the lift that they are compared with.
        cars: return error, rad, and forces of each car.
        trimmed: whether each car is trimmed after a trial run of its own.
        best: lift with the least worst end so far; None before the search and where no lead can be turned.
        windows: its windows, rad.
        worst: that end, mm.
        score: figure by which the best is chosen, mm: the worst end, for one car with a share of the error on the way.
    """

    lift: PathMotion
    follower: EdgeFollower
    runs: TrialRun
    cars: Sequence[tuple[float, Mechanics]]
    trimmed: bool = False
    best: PathMotion | None = None
    windows: tuple[float, ...] = ()
    worst: float = np.inf
    score: float = np.inf
    _trims: dict[int, SteeringTrim] = field(default_factory=dict, repr=False)

    @property
    def alike(self) -> bool:
        """Whether the cars differ little: in play and friction, and not in drag."""
        plays, frictions, drags = zip(
            *((play, forces.friction, forces.drag) for play, forces in self.cars), strict=True
        )
        return bool(np.ptp(plays) <= _ALIKE[0] and np.ptp(frictions) <= _ALIKE[1] and np.ptp(drags) == 0)

    def run(self) -> None:
        """Search over the leads of one car, of cars about the first one that differ little, or of a band's cars."""
        if len(self.cars) == 1 and not self.trimmed:
            for share, ahead in _PLACES:
                self._known(share, ahead)
                if self.score < _MET_WELL:
                    return
        elif self.alike and not self.trimmed:
            found = [replace(self, best=None, score=np.inf, _trims={}) for _ in _PLACES_ALIKE]
            for each, (share, ahead) in zip(found, _PLACES_ALIKE, strict=True):
                each._known(share, ahead)
            for each in sorted(found, key=lambda each: each.score):
                # A ramp that was moved to a steep place may leave a flank that no rod follows.
                if each.best is not None:
                    with suppress(DesignError):
                        actual_profile(each.best, self.follower)
                        self.best, self.windows, self.worst, self.score = (
                            each.best,
                            each.windows,
                            each.worst,
                            each.score,
                        )
                        return
        else:
            # The leads are those of the least friction, of cars that are trimmed those of the middle one.
            ordered = sorted((forces for _, forces in self.cars), key=lambda forces: (forces.friction, forces.drag))
            forces = ordered[len(ordered) // 2 if self.trimmed else 0]
            self._band(forces, max(play for play, _ in self.cars))

    def _known(self, share: float, ahead: float) -> None:
        """Gauss-Newton steps within bounds, halved where they do not help.

        Args:
            share: share of the first car's friction by which the leads are found.
            ahead: angle by which the first ramps begin earlier at first, rad.
        """
        play, forces = self.cars[0]
        leads = TurnedLeads(self.lift, self.follower, replace(forces, friction=share * forces.friction), _ROOM * play)
        count = leads.count
        if not count:
            return
        marks = np.minimum(leads.valleys + radians(1.0), self.runs.wanted.blend_start)
        low = np.concatenate([np.zeros(count), -np.minimum(leads.later, _EARLIER)])
        high = np.concatenate([np.full(count, _ROOM * play), np.minimum(leads.earlier, _EARLIER)])
        first = np.clip(np.repeat([play, ahead], count), low, high)
        kept, probe = np.repeat(_KEPT, count), np.repeat(_PROBE, count)

        def residual(at: Array) -> Array:
            cam = leads.turned(at[:count], at[count:])
            stretches = {forces: forces.leads(cam) for forces in dict.fromkeys(forces for _, forces in self.cars)}
            errors = [self.runs.error(cam, stretches[forces], play) for play, forces in self.cars]
            worst = max(error.end_distance for error in errors)
            self._note(cam, at[:count], worst, worst + _ON_WAY * float(errors[0].distance.max()))
            ends = np.concatenate([self.runs.ends(error) for error in errors])
            heading = np.interp(marks, errors[0].motor, errors[0].heading)
            return np.concatenate([ends.real, ends.imag, _HEADING * heading, kept * (at - first)])

        try:
            at, now = first, residual(first)
        except DesignError:
            return
        for _ in range(_STEPS):
            slope = np.zeros((len(now), 2 * count))
            for column, each in zip(slope.T, np.diag(probe), strict=True):
                for way in (each, -each):
                    with suppress(DesignError):  # a window without room to one side is tried to the other
                        column[:] = (residual(at + way) - now) / way.sum()
                        break
            step = lsq_linear(slope, -now, bounds=(low - at - 1e-12, high - at + 1e-12)).x
            for share in (1.0, 0.5, 0.25, 0.1):
                tried = np.clip(at + share * step, low, high)
                try:
                    then = residual(tried)
                except DesignError:
                    continue
                if then @ then < now @ now:
                    break
            else:
                return
            gained = 1 - (then @ then) / (now @ now)
            at, now = tried, then
            if gained < _LITTLE or self.worst < _MET:
                return

    def _band(self, forces: Mechanics, play: float) -> None:
        """Least worst end over the band: linear programs in a region around the best windows so far."""
        low, high = _NEGATIVE * play, play
        leads = TurnedLeads(self.lift, self.follower, forces, high, low)
        count = leads.count
        if not count:
            return
        at = np.zeros(count)
        now = self._ends(leads, at)
        region = _REGION
        for _ in range(_STEPS):
            if region < _SMALLEST:
                return
            slope = np.zeros((count, len(now)), dtype=np.complex128)
            for row, each in zip(slope, _PROBE[0] * np.eye(count), strict=True):
                with suppress(DesignError):  # a window without room for more stays
                    row[:] = (self._ends(leads, at + each) - now) / _PROBE[0]
            size = np.maximum(np.abs(now), 1e-9)
            away = np.real(np.conj(now / size) * slope).T  # of each end, by each window
            bounds = [(max(low - each, -region), min(high - each, region)) for each in at]
            found = linprog(
                np.append(np.zeros(count), 1.0),
                A_ub=np.column_stack([away, -np.ones(len(size))]),
                b_ub=-size,
                bounds=[*bounds, (None, None)],
            )
            if found.x is None:
                return
            while region >= _SMALLEST:
                step = np.clip(found.x[:count], -region, region)
                try:
                    then = self._ends(leads, at + step)
                except DesignError:
                    then = np.full_like(now, np.inf)
                if (gained := 1 - np.abs(then).max() / np.abs(now).max()) > 0:
                    at, now, region = at + step, then, 1.5 * region
                    break
                region /= 2
            if gained < _LITTLE:
                return

    def _ends(self, leads: TurnedLeads, windows: Array) -> NDArray[np.complex128]:
        """Position errors of all cars at their ends, mm, each after its trim if cars are trimmed."""
        cam = leads.turned(windows)
        ends, worst = [], 0.0
        known: dict[Mechanics, Leads] = {}
        for number, (play, forces) in enumerate(self.cars):
            stretches = known.get(forces) or known.setdefault(forces, forces.leads(cam))
            if self.trimmed:
                found = self.runs.trimmed(cam, stretches, play, near=self._trims.get(number), settled=_TRIM_SETTLED)
                self._trims[number], error = found, found.error
            else:
                error = self.runs.error(cam, stretches, play)
            ends.append(self.runs.ends(error))
            worst = max(worst, error.end_distance)
        self._note(cam, windows, worst, worst)
        return np.concatenate(ends)

    def _note(self, cam: PathMotion, windows: Array, worst: float, score: float) -> None:
        if score < self.score:
            self.best, self.windows, self.worst, self.score = cam, tuple(windows.tolist()), worst, score
