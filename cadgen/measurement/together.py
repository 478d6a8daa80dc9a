"""Several kinds of data of one car: what one record claims is known to the others.

An effect has a name of its own in each kind of data (play is *backlash* in a track, a *return error* in a train); what
they mean is one physical quantity. Where two records claim it, their values must agree; where one is ambiguous, the
claim of another leaves only those of its likely subsets that hold it. What a lift shows beside a disc whose bore is
known from its profile is the shaft's: a quantity of its own, and nothing to compare with the whole.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot

import numpy as np
from scipy.stats import chi2

from cadgen.deviations.friction import NO_FRICTION
from cadgen.deviations.quantities import ECCENTRIC_BORE, RETURN_ERROR, Quantity
from cadgen.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding, Value
from cadgen.measurement.record import Kind

# Less likely than this, and the values are not those of one effect.
AGREE = 1e-3

# Play beyond this share of the tabled return error would have been seen: what is certainly less is none.
NO_PLAY = 0.1

# What an effect is that shows beside the same one of a known profile.
BESIDE_PROFILE = {ECCENTRIC_BORE: Quantity("run-out of the shaft")}


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
    def quantity(self) -> Quantity:
        """What it is physically."""
        quantity = self.kind.quantity(self.finding.effect)
        if self.remainder:
            beside = Quantity(f"{self.finding.effect} beside the profile's ({self.kind.code})")
            return BESIDE_PROFILE.get(quantity, beside)
        return quantity

    @property
    def absent(self) -> bool:
        """True if what is claimed is that there is none of it."""
        return all(value.value == 0 for value in self.finding.values)


@dataclass(frozen=True, slots=True)
class Shared:
    """A physical quantity found in several records.

    Attributes:
        quantity: which.
        values: means weighted by their variances.
        sources: of the records.
        chance: of values so far apart if they were one effect's.
    """

    quantity: Quantity
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


def claims(diagnosis: Diagnosis) -> tuple[Claim, ...]:
    """What a diagnosis claims."""
    return tuple(_claim(diagnosis, f) for f in diagnosis.findings if f.effect in diagnosis.judgement.claimed)


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
    """Of the claims of one quantity that which stands for all, as it was found and as it is taken.

    Where they agree it is the most accurate one, with the mean of all; where they do not, the one whose kind of data
    is nearest to what the car drives with, as it was found.
    """
    if informed := next((claim for claim in found if claim.informed), None):
        return informed, informed
    common = shared(found)
    if not (common and common[0].agrees):
        best = min(found, key=lambda claim: claim.kind.nearness)
        return best, best
    best = min(found, key=lambda claim: float(np.prod([value.sigma for value in claim.finding.values])))
    return best, replace(best, finding=replace(best.finding, values=common[0].values))


def shared(found: Sequence[Claim]) -> tuple[Shared, ...]:
    """Quantities claimed in two records or more, with their common values."""
    out = []
    for quantity in dict.fromkeys(claim.quantity for claim in found):
        several = [claim for claim in found if claim.quantity == quantity and not claim.informed]
        if len({claim.source for claim in several}) > 1:
            values, chance = _mean([claim.finding for claim in several])
            out.append(Shared(quantity, values, tuple(claim.source for claim in several), chance))
    return tuple(out)


def settled(diagnosis: Diagnosis, others: Sequence[Claim]) -> Settled | None:
    """What the claims of other records decide in an ambiguous one, or None.

    Of its likely subsets those remain that hold every quantity that another record claims and that at least one of them
    holds, with a value that agrees; claimed is what all of them have in common.
    """
    likely = {
        tuple(sorted(f.effect for f in diagnosis.findings)),
        *(tuple(sorted(names)) for names in diagnosis.judgement.rivals),
    }
    subsets = [c for c in diagnosis.candidates if tuple(sorted(c.effects)) in likely]
    if diagnosis.verdict != "ambiguous" or diagnosis.runs < 2 or len(subsets) < 2:
        return None
    left, by = subsets, []
    for claim in others:
        holding = [c for c in left if any(_same(claim, _claim(diagnosis, f)) for f in c.findings)]
        if holding and len(holding) < len(left):
            left = holding
            by.append(claim)
    common = set(left[0].effects).intersection(*(c.effects for c in left)) - set(diagnosis.judgement.claimed)
    if not by or not common:
        return None
    new = tuple(_claim(diagnosis, f) for f in left[0].findings if f.effect in common and not f.within_error)
    if not new:
        return None
    return Settled(new, tuple(by), tuple(c.effects for c in left))


def _claim(diagnosis: Diagnosis, finding: Finding) -> Claim:
    if not isinstance(diagnosis, EvidenceDiagnosis):
        return Claim(diagnosis.source, diagnosis.kind, finding)
    informed = diagnosis.play_known and diagnosis.kind.quantity(finding.effect) == RETURN_ERROR
    return Claim(diagnosis.source, diagnosis.kind, finding, finding.effect in diagnosis.known, informed)


def _same(claim: Claim, other: Claim) -> bool:
    return claim.quantity == other.quantity and _mean([claim.finding, other.finding])[1] > AGREE


def _mean(found: Sequence[Finding]) -> tuple[tuple[Value, ...], float]:
    """Values of one quantity, each weighted by its variance, and the chance that they are so far apart."""
    values = np.array([[v.value for v in f.values] for f in found])
    weight = 1 / np.array([[v.sigma for v in f.values] for f in found]) ** 2
    mean = np.sum(weight * values, axis=0) / np.sum(weight, axis=0)
    sigma = 1 / np.sqrt(np.sum(weight, axis=0))
    common = tuple(
        Value(v.name, float(m), float(s), v.unit) for v, m, s in zip(found[0].values, mean, sigma, strict=True)
    )
    return common, float(chi2.sf(np.sum(weight * (values - mean) ** 2), values.size - mean.size))
