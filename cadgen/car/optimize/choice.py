"""The best of several profiles under limits, with the reasons."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, isnan

from cadgen.errors import CheckError


@dataclass(frozen=True, kw_only=True)
class Limit:
    """Greatest value allowed for a figure.

    Attributes:
        figure: name of the figure.
        most: greatest value allowed, in `unit`.
        unit: unit of the figure, for messages.
    """

    figure: str
    most: float
    unit: str


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A profile that may be chosen: its name and its figures, by name, in the limits' units."""

    name: str
    figures: Mapping[str, float]


@dataclass(frozen=True, kw_only=True)
class Choice:
    """The profile chosen, and a sentence on each of the candidates."""

    best: Candidate
    reasons: tuple[str, ...]


def choose(candidates: Sequence[Candidate], limits: Sequence[Limit], *, objective: str, unit: str) -> Choice:
    """Choose the candidate that keeps every limit and has the least value of a figure.

    Args:
        candidates: at least one candidate, each with a value for every figure named.
        limits: limits to be kept; a figure that is not a number keeps no limit.
        objective: name of the figure that is to be least.
        unit: its unit, for the reasons.

    Raises:
        CheckError: no candidate keeps the limits. The message has the limit that binds on the nearest candidate, and
            by how much it is exceeded.
    """
    broken = [
        [limit for limit in limits if not candidate.figures[limit.figure] <= limit.most] for candidate in candidates
    ]
    kept = [candidate for candidate, breaks in zip(candidates, broken, strict=True) if not breaks]
    if not kept:
        nearest = min(candidates, key=lambda candidate: max(_excess(candidate, limit) for limit in limits))
        binding = max(limits, key=lambda limit: _excess(nearest, limit))
        raise CheckError(
            f"none of the profiles compared keeps the design's limits: the nearest, {nearest.name}, "
            f"{_beyond(nearest, binding)}: raise the limit in [optimize], or take a train with less backlash"
        )
    best = min(kept, key=lambda candidate: candidate.figures[objective])
    reasons = []
    for candidate, breaks in zip(candidates, broken, strict=True):
        if candidate is best:
            figure = f"{candidate.figures[objective]:.4g} {unit}"
            verdict = f"chosen: the least {objective}, {figure}, of {len(kept)} that keep every limit"
        elif breaks:
            verdict = "refused: it " + ", and ".join(_beyond(candidate, limit) for limit in breaks)
        else:
            verdict = f"not chosen: its {objective} is {candidate.figures[objective]:.4g} {unit}"
        reasons.append(f"{candidate.name} {verdict}")
    return Choice(best=best, reasons=tuple(reasons))


def _excess(candidate: Candidate, limit: Limit) -> float:
    """Excess of a figure over its limit, as a share of the limit; infinite for a figure that is no number."""
    value = candidate.figures[limit.figure]
    if isnan(value):
        return inf
    return (value - limit.most) / max(abs(limit.most), 1e-300)


def _beyond(candidate: Candidate, limit: Limit) -> str:
    value = candidate.figures[limit.figure]
    return (
        f"has a {limit.figure} of {value:.4g} {limit.unit}, {value - limit.most:.4g} {limit.unit} more than the "
        f"{limit.most:.4g} allowed"
    )
