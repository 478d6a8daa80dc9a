"""Profiles for a band of return errors: the play that one is best cut for, and a bound for profiles of its kind.

A car's play is known only to lie in a band. The compensated profile errs by nearly as much for each degree that the
real play differs from its own, to either side; cut for the right play in between, its worst error over the band is
least. `fixed_profile_bound` says how much of that no profile with the same peaks and valleys can avoid.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from cadgen.arrays import TURN, Array
from cadgen.cam.follower import EdgeFollower
from cadgen.car.against_play.compensation import compensated_lift, lost_dips
from cadgen.car.against_play.lead_search import LeadSearch
from cadgen.car.against_play.trial_run import TrialRun
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import drive, turns_of
from cadgen.car.running.mechanics import Leads, Mechanics
from cadgen.car.running.play import LEAST_SWING, falls
from cadgen.car.steering import Car, track_curvature, travel_ratio
from cadgen.errors import DesignError

BAND_PLAYS = 5  # of the band at which errors are reported; the worst lies at an end unless the band is very wide
_FINE = 1e-4  # rad of play, with friction; it moves the worst end of the paper's car by 8 mm at most
_TOLERANCE = 1e-6  # rad of play; it moves the worst error by less than a millimetre's hundredth
_MIDDLE = 0.12  # of friction; over a wider band the windows of the middle car are the best for no car but it
_NO_BETTER = 0.1  # mm; where the ends meet they do so within this
_MET = 1.0  # mm; where the windows of the leads leave no more, none for all falls is sought
_COARSE = 13  # plays to cut for, across a band, at which the worst end over plays and frictions is first looked at
_DIRECTIONS = 720  # in which the bound is taken; each alone is a bound


@dataclass(frozen=True, kw_only=True)
class PlayBand:
    """Return error of a train, as far as it is known, rad.

    Attributes:
        least: least return error of the cars that may be built, rad.
        greatest: greatest return error of these cars, rad.
        measured: return error measured on the car that the cam is for, rad; None if it was not measured.
    """

    least: float
    greatest: float
    measured: float | None = None

    @property
    def ends(self) -> tuple[float, float]:
        """Least and greatest return error, rad; a measured value beyond them widens the band."""
        known = [self.least, self.greatest, *([] if self.measured is None else [self.measured])]
        return min(known), max(known)


@dataclass(frozen=True, kw_only=True)
class BandResult:
    """A profile and its errors over a band of plays.

    Attributes:
        lift: lift of the profile.
        made_for: play that the profile is cut for, rad; the greatest of `windows` where it has them.
        plays: plays across the band, shape (n,), rad.
        heading: heading error at the end of the run at each play, with the friction and drag that make it greatest,
            shape (n,), rad.
        distance: position error at the end, likewise, shape (n,), mm.
        worst: friction and drag with the greatest position error; None where they are left out.
        windows: windows of the leads one by one, rad; empty where one is for all falls.
    """

    lift: PathMotion
    made_for: float
    plays: Array
    heading: Array
    distance: Array
    worst: Mechanics | None = None
    windows: tuple[float, ...] = ()

    @property
    def worst_heading(self) -> float:
        """Greatest heading error over the band, rad."""
        return float(np.abs(self.heading).max())

    @property
    def worst_distance(self) -> float:
        """Greatest position error over the band, mm."""
        return float(self.distance.max())


@dataclass(frozen=True, kw_only=True)
class EndBound:
    """Lower bound of the worst end of run over a band, for profiles with the wanted peaks and valleys: rad and mm."""

    heading: float
    distance: float


def best_for_band(
    lift: PathMotion,
    follower: EdgeFollower,
    car: Car,
    length: float,
    band: tuple[float, float],
    *,
    wanted: PathMotion | None = None,
    mechanics: Sequence[Mechanics] = (),
    trimmed: bool = False,
) -> BandResult:
    """Compensated profile with the least worst position error at the end of the run, over a band of plays.

    For a single play the error falls, then grows, with the play the cam is cut for. So the error at the band's lower
    end grows with it and that at the upper end falls, and where the two are equal the worse of them is least. A lift
    that is off the path without any play, such as a smoothed one, may be worse at the same end of the band whatever
    it is cut for; then one end of the band is best to cut for.

    With friction the cam leads on part of each fall, and by how much the profile must make up for that depends on it:
    then each lead may have a window of its own. What is made least is the worst end over plays and frictions, or over
    the cars that are trimmed after a trial run.

    Args:
        lift: lift that is compensated.
        follower: follower of the car.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        band: least and greatest return error B, rad; the two may be equal.
        wanted: lift that the run is compared with; `lift` itself if left out.
        mechanics: friction and drag of the cars that may be built; without them the rod slides freely.
        trimmed: whether each car is trimmed after a trial run of its own; it needs `mechanics`.

    Raises:
        DesignError: the band does not run upwards from 0 or more.
    """
    low, high = _checked(band)
    if mechanics:
        return _best_with_friction(lift, follower, car, length, (low, high), wanted or lift, mechanics, trimmed)
    tried: list[float] = []
    runs = TrialRun(wanted=wanted or lift, car=car, length=length)

    def at(made_for: float, plays: Array) -> BandResult:
        cam = compensated_lift(lift, follower, made_for)
        return over_band(cam, runs.wanted, car, length, plays, made_for, runs=runs)

    @cache
    def ends(made_for: float) -> tuple[float, float]:
        tried.append(made_for)
        lower, upper = at(made_for, np.array([low, high])).distance.tolist()
        return lower, upper

    def lower_end_worse(made_for: float) -> float:
        lower, upper = ends(made_for)
        return lower - upper

    if high - low <= _TOLERANCE:
        made_for = (low + high) / 2
    elif lower_end_worse(low) < 0 < lower_end_worse(high):
        made_for = float(brentq(lower_end_worse, low, high, xtol=_TOLERANCE))
        # Where a dip of the lift is lost to a slightly wider play, the two ends may jump past each other.
        best = min(tried, key=lambda play: max(ends(play)))
        if max(ends(best)) < max(ends(made_for)) - _NO_BETTER:
            made_for = best
    else:
        made_for = min((low, high), key=lambda end: max(ends(end)))
    return at(made_for, np.linspace(low, high, BAND_PLAYS))


def _best_with_friction(
    lift: PathMotion,
    follower: EdgeFollower,
    car: Car,
    length: float,
    band: tuple[float, float],
    wanted: PathMotion,
    mechanics: Sequence[Mechanics],
    trimmed: bool,
) -> BandResult:
    """`best_for_band` over plays and frictions: a window for each lead, or where that ends nearer one for all falls."""
    plays = np.linspace(*band, BAND_PLAYS) if band[1] > band[0] else np.array(band[:1])
    cars = [(play, forces) for play in dict.fromkeys(band) for forces in mechanics]
    runs = TrialRun(wanted=wanted, car=car, length=length)

    def at(made_for: float, plays: Array) -> BandResult:
        cam = compensated_lift(lift, follower, made_for)
        return over_band(cam, wanted, car, length, plays, made_for, mechanics=mechanics, runs=runs)

    if not any(len(forces.leads(lift).intervals) for forces in mechanics):
        return at(0.0, plays)  # nothing turns the cam ahead

    def by_lead(search: LeadSearch, before: float) -> BandResult:
        assert search.best is not None
        windows = tuple(before + window for window in search.windows)
        found = over_band(search.best, wanted, car, length, plays, max(windows), mechanics=mechanics, runs=runs)
        return replace(found, windows=windows)

    search = LeadSearch(lift, follower, runs, cars, trimmed)
    if trimmed or len(cars) == 1:
        search.run()
        if search.best is not None and (trimmed or search.worst < _MET):
            return by_lead(search, 0.0)

    @cache
    def worst(made_for: float) -> float:
        return at(made_for, np.array(band)).worst_distance

    tried = np.linspace(0.0, band[1], _COARSE)
    best = int(np.argmin([worst(float(made_for)) for made_for in tried]))
    made_for = float(tried[best])
    low, high = float(tried[max(best - 1, 0)]), float(tried[min(best + 1, _COARSE - 1)])
    # A worst end that falls up to an end of the range is least there.
    if low < made_for < high or worst(min(max(made_for, low + _FINE), high - _FINE)) < worst(made_for):
        fine = minimize_scalar(worst, bounds=(low, high), method="bounded", options={"xatol": _FINE})
        made_for = min(float(fine.x), made_for, key=worst)
    if len(cars) > 1:
        # Where the cars differ little, as one that was measured, they are one known car and those about it.
        middle = replace(
            mechanics[0],
            friction=float(np.mean([forces.friction for forces in mechanics])),
            drag=float(np.mean([forces.drag for forces in mechanics])),
        )
        about = LeadSearch(lift, follower, runs, [(sum(band) / 2, middle), *cars])
        known = about if about.alike else LeadSearch(lift, follower, runs, about.cars[:1])
        if np.ptp([forces.friction for forces in mechanics]) <= _MIDDLE:
            known.run()
        if about.alike and known.worst < worst(made_for) - _NO_BETTER:
            return by_lead(known, 0.0)
        search = LeadSearch(compensated_lift(lift, follower, made_for), follower, runs, cars)
        search.run()
        if known.best is not None:
            ends = over_band(known.best, wanted, car, length, np.array(band), mechanics=mechanics).worst_distance
            if ends < min(search.worst, worst(made_for)) - _NO_BETTER:
                return by_lead(known, 0.0)
    if search.worst >= worst(made_for) - _NO_BETTER:
        return at(made_for, plays)
    return by_lead(search, made_for if len(cars) > 1 else 0.0)


def over_band(
    cam: PathMotion,
    wanted: PathMotion,
    car: Car,
    length: float,
    plays: Array,
    made_for: float = 0.0,
    *,
    least_swing: float = LEAST_SWING,
    mechanics: Sequence[Mechanics] = (),
    cut: PathMotion | None = None,
    runs: TrialRun | None = None,
) -> BandResult:
    """Errors of any cam at the end of the run for several plays.

    Args:
        cam: lift of the cam.
        wanted: lift wanted by motor position.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        plays: return errors, shape (n,), rad.
        made_for: play that the cam is cut for, rad; only passed on.
        least_swing: rises and falls of the cam's tan(beta) smaller than this are noise, not events.
        mechanics: friction and drag of the cars that may be built, of which the worst counts; without them the rod
            slides freely.
        cut: lift that the cam was cut for, which decides where it leads with friction; `cam` if left out.
        runs: runs of the car for the lift wanted, whose planned run many bands share; made if left out.
    """
    runs = runs or TrialRun(wanted=wanted, car=car, length=length)
    cases = tuple(case.leads(cut or cam) for case in mechanics) or (Leads(falls(cam, least_swing)),)
    heading, distance = np.empty((2, len(cases), len(plays)))
    for row, leads in enumerate(cases):
        for column, play in enumerate(np.asarray(plays).tolist()):
            error = runs.error(cam, leads, play)
            heading[row, column], distance[row, column] = error.end_heading, error.end_distance
    columns = np.arange(len(plays))
    return BandResult(
        lift=cam,
        made_for=made_for,
        plays=plays,
        heading=heading[np.abs(heading).argmax(axis=0), columns],
        distance=distance.max(axis=0),
        worst=mechanics[int(distance.max(axis=1).argmax())] if mechanics else None,
    )


def fixed_profile_bound(lift: PathMotion, car: Car, length: float, band: tuple[float, float]) -> EndBound:
    """A lower bound, to first order in the band's width, on the worst end of run of one profile for all plays.

    It holds for profiles whose lift rises and falls where the wanted one does, and which reach its peaks, its valleys
    and its values where the run starts and stops. A flatter profile depends less on play, and so does one for another
    path. Dips narrower than the greatest play count as filled, since no profile gives them back.

    Let f be the turning rate that the profile gives over a fall. With play B the car meets f(phi + B) there; the rises
    it meets unchanged. So between the plays at the band's ends, D apart, the turning differs by f(phi + D) - f(phi).
    The integral of that over fall k is D M_k, with M_k the rise of the turning rate from peak to valley. So at one end
    of the band the heading is off by at least half of D sum(M_k), whatever f does in between.

    A change of heading at a place Q moves the end E of the run about Q. So the ends of the two runs differ by
    D sum(M_k (E - Q_k)), turned by 90 degrees; each Q_k is a mean of places on fall k that the profile may choose.
    For every direction u this is at least D sum(M_k min over the fall of u.(E - Q)). Half the greatest of these
    bounds the worse end.

    A staircase of many small falls, each followed by a rise, would hold the cam against the gears and escape this;
    it would shake the rod, and a rod of any thickness cannot follow it on a falling flank.

    Args:
        lift: lift wanted.
        car: dimensions of the car.
        length: travel of the drive wheel in one turn of the cam, mm.
        band: least and greatest return error, rad.

    Raises:
        DesignError: the band does not run upwards from 0 or more.
    """
    low, high = _checked(band)
    run = drive(lift, car, length)
    stop = lift.blend_start
    events = _events(lift, high)
    rate = length / TURN
    rises, places = [], []
    for peak, valley in np.concatenate([events + TURN * turn for turn in range(-1, turns_of(stop))]):
        start, end = max(peak, 0.0), min(valley, stop)
        if start < end:
            tan_beta = lift.q(np.array([start, end]))
            ends = rate * track_curvature(tan_beta, car) * travel_ratio(tan_beta, car)
            rises.append(float(ends[1] - ends[0]))
            places.append(run.drive_wheel[(run.motor >= start) & (run.motor <= end)])
    angle = np.linspace(0.0, TURN, _DIRECTIONS, endpoint=False)
    direction = np.stack([np.cos(angle), np.sin(angle)])
    total = np.zeros(_DIRECTIONS)
    for rise, place in zip(rises, places, strict=True):
        total += rise * ((run.drive_wheel[-1] - place) @ direction).min(axis=0)
    half = (high - low) / 2
    return EndBound(heading=half * sum(rises), distance=half * max(float(total.max()), 0.0))


def _events(lift: PathMotion, play: float) -> Array:
    """Falls of the lift once the dips narrower than a play are filled, shape (k, 2), rad."""
    events = falls(lift)
    while len(events) > 1 and (filled := _apart([dip.whole for dip in lost_dips(lift, play, events)])):
        # A filled dip takes the lower of its two peaks with it.
        after = (np.array(filled) + 1) % len(events)
        first, second = lift.q(events[filled, 0]), lift.q(events[after, 0])
        stop = events[after, 1] + np.where(after == 0, TURN, 0.0)
        joined = np.stack([events[filled, 0], stop], axis=1)
        events[after] = np.where((first >= second)[:, None], joined, events[after])
        events = np.delete(events, filled, axis=0)
        events = events[np.argsort(events[:, 0])]
    return events


def _apart(whole: Sequence[bool]) -> list[int]:
    """Numbers of filled dips of which none is beside another: that one has other peaks once its neighbour is gone."""
    chosen: list[int] = []
    taken: set[int] = set()
    for number in np.flatnonzero(whole).tolist():
        beside = {number, (number + 1) % len(whole)}
        if not beside & taken:
            chosen.append(number)
            taken |= beside
    return chosen


def _checked(band: tuple[float, float]) -> tuple[float, float]:
    low, high = band
    if not 0 <= low <= high:
        raise DesignError(
            "the band of return errors from {least:g} to {greatest:g} degrees is not one: it must run "
            "upwards from 0 or more",
            least=np.degrees(low),
            greatest=np.degrees(high),
        )
    return low, high
