"""Several kinds of data of one car: an effect that shows in more than one of them is one effect."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from cadgen.measurement.diagnose import Diagnosis, Value

# Less likely than this, and the values are not those of one effect.
AGREE = 1e-3


@dataclass(frozen=True, slots=True)
class Shared:
    """An effect found in several records.

    Attributes:
        effect: its name.
        values: means weighted by their variances.
        sources: of the records.
        chance: of values so far apart if they were one effect's.
    """

    effect: str
    values: tuple[Value, ...]
    sources: tuple[str, ...]
    chance: float

    @property
    def agrees(self) -> bool:
        """True if the records may show one and the same effect."""
        return self.chance > AGREE


def shared(told: Sequence[Diagnosis]) -> tuple[Shared, ...]:
    """Effects claimed in two records or more, with their common values."""
    names = sorted({name for d in told for name in d.judgement.claimed})
    out = []
    for name in names:
        found = [(d.source, f) for d in told for f in d.findings if f.effect == name and name in d.judgement.claimed]
        printed = {tuple(v.name for v in f.values) for _, f in found}
        if len(found) < 2 or len(printed) > 1:
            continue
        values = np.array([[v.value for v in f.values] for _, f in found])
        weight = 1 / np.array([[v.sigma for v in f.values] for _, f in found]) ** 2
        mean = np.sum(weight * values, axis=0) / np.sum(weight, axis=0)
        sigma = 1 / np.sqrt(np.sum(weight, axis=0))
        square = float(np.sum(weight * (values - mean) ** 2))
        common = tuple(
            Value(v.name, float(m), float(s), v.unit) for v, m, s in zip(found[0][1].values, mean, sigma, strict=True)
        )
        chance = float(chi2.sf(square, values.size - mean.size))
        out.append(Shared(name, common, tuple(source for source, _ in found), chance))
    return tuple(out)


def narrowed(told: Diagnosis, others: Sequence[Diagnosis]) -> tuple[str, ...]:
    """Which of an ambiguous record's likely names another record claims outright."""
    certain = {name for d in others for name in d.judgement.claimed}
    return tuple(name for name in told.judgement.reported if name in certain)
