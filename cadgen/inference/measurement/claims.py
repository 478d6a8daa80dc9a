"""Claims of all records of a car, each physical quantity used once.

Data with a forward model are judged together (`joint`), and claim a thing once. Mean turns over zones and logged
steering are judged by themselves: where they show a quantity that the others show too, the values must agree.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import hypot

import numpy as np
from scipy.stats import chi2

from cadgen.deviations.deviation import RETURN_ERROR, Deviation
from cadgen.deviations.return_error import NO_FRICTION
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding, Value
from cadgen.inference.measurement.record import Kind

# Less likely than this, and the values are not those of one effect.
AGREE = 1e-3

# Play beyond this share of the tabled return error would have been seen: what is certainly less is none.
NO_PLAY = 0.1


@dataclass(frozen=True, slots=True)
class Claim:
    """An effect that a record's verdict names.

    Attributes:
        source, kind: of the record.
        finding: the effect with its values.
        informed: True if its value was fitted with the same quantity measured in another record.
        sure: False if the name is not sure, and it is here for what it does to the run together with the others.
    """

    source: str
    kind: Kind
    finding: Finding
    informed: bool = False
    sure: bool = True

    @property
    def deviation(self) -> Deviation:
        """Entry of the catalogue that it is."""
        return self.kind.deviation(self.finding.effect)

    @property
    def absent(self) -> bool:
        """True if what is claimed is that there is none of it."""
        return all(value.value == 0 for value in self.finding.values)


@dataclass(frozen=True, slots=True)
class Shared:
    """A physical quantity found in several records.

    Attributes:
        deviation: which.
        values: means weighted by their variances.
        sources: of the records.
        chance: of values so far apart if they were one effect's.
    """

    deviation: Deviation
    values: tuple[Value, ...]
    sources: tuple[str, ...]
    chance: float

    @property
    def agrees(self) -> bool:
        """True if the records may show one and the same effect."""
        return self.chance > AGREE


def claims(diagnosis: Diagnosis) -> tuple[Claim, ...]:
    """Claims of a diagnosis: of the effects that several records show together, those of its own catalogue."""
    claimed = set(diagnosis.judgement.claimed)
    if isinstance(diagnosis, EvidenceDiagnosis):
        claimed &= set(diagnosis.leads)
    known = isinstance(diagnosis, EvidenceDiagnosis) and diagnosis.play_known
    kind = diagnosis.kind
    return tuple(
        Claim(diagnosis.source, kind, f, informed=known and kind.deviation(f.effect) == RETURN_ERROR)
        for f in diagnosis.findings
        if f.effect in claimed
    )


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
    """Claim that stands for all claims of one deviation, as it was found and as it is taken.

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
    for deviation in dict.fromkeys(claim.deviation for claim in found):
        several = [claim for claim in found if claim.deviation == deviation and not claim.informed]
        if len({claim.source for claim in several}) > 1:
            values, chance = _mean([claim.finding for claim in several])
            out.append(Shared(deviation, values, tuple(claim.source for claim in several), chance))
    return tuple(out)


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
