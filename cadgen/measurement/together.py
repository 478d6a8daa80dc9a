"""Several kinds of data of one car: what one record claims is known to the others.

An effect has a name of its own in each kind of data (play is *backlash* in a track, a *return error* in a train); what
they mean is one physical thing. Where two records claim it, their values must agree; where one is ambiguous, the claim
of another leaves only those of its likely subsets that hold it. What a lift shows beside a disc whose bore is known
from its profile is the shaft's: a thing of its own, and nothing to compare with the whole.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot

import numpy as np
from scipy.stats import chi2

from cadgen.deviations.friction import NO_FRICTION
from cadgen.deviations.names import Kind
from cadgen.measurement.diagnose import Diagnosis, Finding, Value

# Less likely than this, and the values are not those of one effect.
AGREE = 1e-3

# Play beyond this share of the tabled return error would have been seen: what is certainly less is none.
NO_PLAY = 0.1

# Physical things -> their names by kind of data, the kind first that shows best what the car does.
THINGS: dict[str, tuple[tuple[str, str], ...]] = {
    "return error": (
        ("track", "backlash"),
        ("zones", "return error"),
        ("transmission", "return error"),
        ("lift", "backlash"),
        ("lift", "backlash, held by the spring"),
    ),
    "sliding friction": (("track", "sliding friction"), ("transmission", "sliding friction")),
    "cam phase": (("track", "cam phase"), ("lift", "phase")),
    "eccentric bore": (("profile", "eccentric bore"), ("lift", "eccentric bore")),
    "worn nose": (("profile", "worn nose"), ("lift", "worn nose")),
}
# What an effect is that shows beside the same one of a known profile.
BESIDE_PROFILE = {"eccentric bore": "run-out of the shaft"}


@dataclass(frozen=True, slots=True)
class Claim:
    """An effect that a record's verdict names.

    Attributes:
        source, kind: of the record.
        finding: the effect with its values.
        informed: True if its value was fitted with the same quantity measured in another record.
        remainder: True if an effect of this name was known from the profile, so that this is what it leaves.
    """

    source: str
    kind: Kind
    finding: Finding
    remainder: bool = False
    informed: bool = False

    @property
    def thing(self) -> str:
        """What it is physically."""
        name = self.finding.effect
        if self.remainder:
            return BESIDE_PROFILE.get(name, f"{name} beside the profile's ({self.kind})")
        return _thing(self.kind, name)

    @property
    def absent(self) -> bool:
        """True if what is claimed is that there is none of it."""
        return all(value.value == 0 for value in self.finding.values)

    @property
    def rank(self) -> int:
        """Place among the kinds that show this thing, the best first."""
        places = THINGS.get(self.thing, ())
        name = (self.kind, self.finding.effect)
        return places.index(name) if name in places else len(places)


@dataclass(frozen=True, slots=True)
class Shared:
    """A physical thing found in several records.

    Attributes:
        thing: its name.
        values: means weighted by their variances.
        sources: of the records.
        chance: of values so far apart if they were one effect's.
    """

    thing: str
    values: tuple[Value, ...]
    sources: tuple[str, ...]
    chance: float

    @property
    def agrees(self) -> bool:
        """True if the records may show one and the same effect."""
        return self.chance > AGREE


@dataclass(frozen=True, slots=True)
class Settled:
    """An ambiguous record that others decide.

    Attributes:
        claims: what it may now claim.
        by: claims of the other records that decide it.
        left: likely subsets that hold these, best first.
    """

    claims: tuple[Claim, ...]
    by: tuple[Claim, ...]
    left: tuple[tuple[str, ...], ...]


def claims(told: Diagnosis) -> tuple[Claim, ...]:
    """What a diagnosis claims."""
    return tuple(_claim(told, f) for f in told.findings if f.effect in told.judgement.claimed)


def no_play(source: str, kind: Kind, fitted: Finding, tabled_deg: float) -> Claim | None:
    """The claim that a car has no play, or None where the data would not have shown it.

    Args:
        source, kind: of a record with a sound verdict that names no play.
        fitted: the play beside what the verdict names.
        tabled_deg: return error that would be assumed without this record.
    """
    return _absent(source, kind, fitted, NO_PLAY * tabled_deg)


def no_friction(source: str, kind: Kind, fitted: Finding) -> Claim | None:
    """The claim that the rod slides freely, or None where the data would not have shown friction; see `no_play`."""
    return _absent(source, kind, fitted, NO_FRICTION)


def _absent(source: str, kind: Kind, fitted: Finding, most: float) -> Claim | None:
    (value,) = fitted.values
    if not (value.sigma > 0 and abs(value.value) + 2 * value.sigma <= most):
        return None
    none = replace(value, value=0.0, sigma=hypot(value.value, value.sigma))
    return Claim(source, kind, replace(fitted, values=(none,), at_bound=()))


def at_work(found: Sequence[Claim]) -> tuple[Claim, Claim]:
    """Of the claims of one thing that which stands for all, as it was found and as it is taken.

    Where they agree it is the most accurate one, with the mean of all; where they do not, the one whose kind of data
    is nearest to what the car drives with, as it was found.
    """
    if informed := next((claim for claim in found if claim.informed), None):
        return informed, informed
    common = shared(found)
    if not (common and common[0].agrees):
        best = min(found, key=lambda claim: claim.rank)
        return best, best
    best = min(found, key=lambda claim: float(np.prod([value.sigma for value in claim.finding.values])))
    return best, replace(best, finding=replace(best.finding, values=common[0].values))


def shared(found: Sequence[Claim]) -> tuple[Shared, ...]:
    """Things claimed in two records or more, with their common values."""
    out = []
    for thing in dict.fromkeys(claim.thing for claim in found):
        several = [claim for claim in found if claim.thing == thing and not claim.informed]
        if len({claim.source for claim in several}) > 1:
            values, chance = _mean([claim.finding for claim in several])
            out.append(Shared(thing, values, tuple(claim.source for claim in several), chance))
    return tuple(out)


def settled(told: Diagnosis, others: Sequence[Claim]) -> Settled | None:
    """What the claims of other records decide in an ambiguous one, or None.

    Of its likely subsets those remain that hold every thing that another record claims and that at least one of them
    holds, with a value that agrees; claimed is what all of them have in common.
    """
    likely = {
        tuple(sorted(f.effect for f in told.findings)),
        *(tuple(sorted(names)) for names in told.judgement.rivals),
    }
    subsets = [c for c in told.candidates if tuple(sorted(c.effects)) in likely]
    if told.verdict != "ambiguous" or told.runs < 2 or len(subsets) < 2:
        return None
    left, by = subsets, []
    for claim in others:
        holding = [c for c in left if any(_same(claim, _claim(told, f)) for f in c.findings)]
        if holding and len(holding) < len(left):
            left = holding
            by.append(claim)
    common = set(left[0].effects).intersection(*(c.effects for c in left)) - set(told.judgement.claimed)
    if not by or not common:
        return None
    new = tuple(_claim(told, f) for f in left[0].findings if f.effect in common and not f.within_error)
    if not new:
        return None
    return Settled(new, tuple(by), tuple(c.effects for c in left))


def _claim(told: Diagnosis, finding: Finding) -> Claim:
    informed = told.play_known and _thing(told.kind, finding.effect) == "return error"
    return Claim(told.source, told.kind, finding, finding.effect in told.known, informed)


def _thing(kind: str, effect: str) -> str:
    return next((thing for thing, names in THINGS.items() if (kind, effect) in names), f"{effect} ({kind})")


def _same(one: Claim, other: Claim) -> bool:
    if one.thing != other.thing:
        return False
    return _mean([one.finding, other.finding])[1] > AGREE


def _mean(found: Sequence[Finding]) -> tuple[tuple[Value, ...], float]:
    """Values of one thing, each weighted by its variance, and the chance that they are so far apart."""
    values = np.array([[v.value for v in f.values] for f in found])
    weight = 1 / np.array([[v.sigma for v in f.values] for f in found]) ** 2
    mean = np.sum(weight * values, axis=0) / np.sum(weight, axis=0)
    sigma = 1 / np.sqrt(np.sum(weight, axis=0))
    common = tuple(
        Value(v.name, float(m), float(s), v.unit) for v, m, s in zip(found[0].values, mean, sigma, strict=True)
    )
    return common, float(chi2.sf(np.sum(weight * (values - mean) ** 2), values.size - mean.size))
