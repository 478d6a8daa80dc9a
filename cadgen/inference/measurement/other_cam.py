"""Cams that fit the records of a car better than the stated cam, or as well.

A cam is named by its user, who may be wrong: the profile against play and the plain one differ by less than the eye
sees. Effects of the car then stand for the difference of the two, and a new cam made for them leads the car astray. So
the same records are judged against each other cam that the design can have made, with the same noise, by the same
criterion. A wrong cam needs effects that the right one does not need, and what each costs is in the criterion.
"""

from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from cadgen.arrays import TURN
from cadgen.deviations.deviation import RETURN_ERROR
from cadgen.errors import DesignError
from cadgen.inference.measurement.diagnosis import SOUND, Weighed
from cadgen.inference.measurement.evidence import Evidence
from cadgen.inference.measurement.hypothesis import Hypothesis, Search, fit
from cadgen.inference.measurement.joint import Joint, Part
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.reservations import DWARFED
from cadgen.inference.measurement.search import find
from cadgen.inference.measurement.verdict import left_over
from cadgen.messages import Message
from cadgen.progress import Progress, silent

# The effects found, and some of them, are fitted to the other cam. All subsets are searched if these come so near, in
# the criterion: what stands for the difference of two cams may have displaced an effect that is there.
NEAR = 300.0
# Of the effects found so many are left out.
LESS = 2


# Odds at which one of two cams is taken: 150 to 1, in -2 log of likelihood; and for each shape without a name that one
# needs more, since what two cams differ by is such a shape.
SURE = 10.0
# Two cams are the same if their lifts nowhere differ by more, as the tangent of the steering angle: 0.2 um of the lift.
ALIKE = 1e-5
_STATIONS = 720
_HALF = 0.5  # standard deviations within which two findings are the same


@dataclass(frozen=True)
class OtherCam:
    """Cam that may have been on the car in place of the stated one.

    Attributes:
        profile: code of its profile.
        earlier: whether it is the cam that the design had before it was calibrated.
        better: by how much the records fit it better than the stated cam, in the criterion: -2 log of likelihood with
            the price of the effects. It pays `SURE` for each shape that it needs more.
        effects: names of the effects that the car has then, in the order of the catalogue.
        instead: those that it has with the stated cam.
    """

    profile: str
    earlier: bool
    better: float
    effects: tuple[str, ...]
    instead: tuple[str, ...]

    @property
    def fits_better(self) -> bool:
        """Whether it is surely not the stated cam that was on the car."""
        return self.better > SURE


def other_cam(
    weighed: Weighed,
    stated: Nominal,
    other: Nominal,
    profile: str,
    *,
    earlier: bool = False,
    progress: Progress = silent,
) -> OtherCam | None:
    """How well the records fit another cam.

    None where the stated one surely fits better, the two are alike, or the records show the same of the car with either
    cam, as those of a transmission do: then a cam made for it does not ask which one was on it. None, too, where the
    other cam leaves as much of the records unexplained as dwarfs every effect.

    Args:
        weighed: joint verdict on the records, against the stated cam.
        stated: the design with the stated cam.
        other: the design with the other cam.
        profile: code of the other cam's profile.
        earlier: see `OtherCam`.
        progress: function that is called with a few words on each step.
    """
    angle = np.linspace(0.0, TURN, _STATIONS)
    if np.abs(stated.lift.jets(angle)[0] - other.lift.jets(angle)[0]).max() < ALIKE:
        return None
    progress(Message("comparing with the {profile} profile", profile=Message(profile)))
    best = min(weighed.found, key=lambda h: h.score)
    # Of a car whose wheel was measured the run ends at another cam angle: both cams are judged over the same rows.
    joint = _against(weighed.joint, replace(other, blend_start=stated.lift.blend_start))
    if weighed.judgement.verdict in SOUND and _nearest(joint, best, best.score) > best.score + NEAR:
        return None
    found = find(joint, stated.usual, against=best.score)[0]
    # What was measured of the play apart speaks for a cam as well.
    better = float(best.score + _off(best, stated.play) - found.score - _off(found, other.play))
    better -= SURE * max(sum(e.shape for e in found.effects) - sum(e.shape for e in best.effects), 0)
    if better < -SURE or (better <= SURE and _same(best, found)):
        return None
    # Where neither cam comes near the records, that one of them is nearer says nothing.
    if max(left_over(part, joint, found) for part in joint.parts) > DWARFED:
        return None
    names, instead = (tuple(e.name for e in h.effects if not e.shape) for h in (found, best))
    return OtherCam(profile, earlier, better, names, instead)


def _same(one: Hypothesis, other: Hypothesis) -> bool:
    """Whether two subsets have the same effects, of sizes that differ by less than half a standard deviation."""
    first, second = ({e.key: (v, s) for e, v, s in each.values()} for each in (one, other))
    return first.keys() == second.keys() and all(
        bool(np.all(np.abs(first[key][0] - second[key][0]) <= _HALF * np.maximum(first[key][1], second[key][1])))
        for key in first
    )


def _off(found: Hypothesis, known: tuple[float, float] | None) -> float:
    """Misfit of the play of a subset to a play that was measured apart, in -2 log of likelihood.

    Args:
        found: subset of effects; play that is not in it is none.
        known: play and its standard deviation, rad; None if it was not measured.
    """
    if known is None:
        return 0.0
    numbers = [(float(v[0]), float(s[0])) for e, v, s in found.values() if e.deviation == RETURN_ERROR]
    play, sigma = numbers[0] if numbers else (0.0, 0.0)
    return (play - known[0]) ** 2 / (sigma**2 + known[1] ** 2)


def _against(joint: Joint, nominal: Nominal) -> Joint:
    """The records against another design, with the noise that they have."""
    parts = []
    for part in joint.parts:
        model = nominal.model(part.record)
        evidence = Evidence(model, part.noise, part.evidence.grid)
        # A part of its own: one that is replaced keeps what it remembers of the stated cam.
        parts.append(Part(part.record, nominal.model, model, part.noise, evidence))
    against = Joint.of(parts)
    return against if joint.cameras else against.with_cameras


def _nearest(joint: Joint, best: Hypothesis, stated: float) -> float:
    """Least score of the effects found, or of some of them, against another cam."""
    own = {e.key: e for e in (*joint.core, *joint.members, *joint.shapes)}
    datum = {e.key: e for e in joint.datum}
    start = [(own.get(e.key) or datum[e.key], v) for e, v in best.active if e.key in own or e.key in datum]
    effects = tuple(own[e.key] for e in best.effects if e.key in own)
    search, scores = Search(joint.rows), [float("inf")]
    for count in range(min(LESS, len(effects)) + 1):
        for gone in combinations(effects, count):
            some = tuple(e for e in effects if e not in gone)
            if any(e.beside and e.beside.key not in {one.key for one in some} for e in some):
                continue
            with suppress(DesignError):
                scores.append(fit(joint, some, start, search, level=stated + NEAR).score)
                if scores[-1] < stated + NEAR:
                    return scores[-1]
    return min(scores)
