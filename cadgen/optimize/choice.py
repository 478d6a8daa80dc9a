"""The best of several profiles under limits, with the reasons."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, isnan

from cadgen.errors import CheckError


@dataclass(frozen=True, kw_only=True)
class Limit:
    """The most that a figure may be.

    Attributes:
        figure: its name.
        most: greatest value allowed, in `unit`.
        unit: of the figure, for messages.
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


def choose(candidates: Sequence[Candidate], limits: Sequence[Limit], *, least: str) -> Choice:
    """Choose the candidate that keeps every limit and has the least value of a figure.

    Args:
        candidates: at least one, each with a value for every figure named.
        limits: what must be kept; a figure that is not a number keeps none.
        least: name of the figure that decides.

    Raises:
        CheckError: nothing keeps the limits: names the one that binds on the candidate that comes nearest, and by
            how much.
    """
    broken = [[limit for limit in limits if not one.figures[limit.figure] <= limit.most] for one in candidates]
    kept = [one for one, breaks in zip(candidates, broken, strict=True) if not breaks]
    if not kept:
        nearest = min(candidates, key=lambda one: max(_excess(one, limit) for limit in limits))
        binding = max(limits, key=lambda limit: _excess(nearest, limit))
        raise CheckError(
            f"none of the profiles compared keeps the design's limits: the nearest, {nearest.name}, "
            f"{_beyond(nearest, binding)}: raise the limit in [optimize], or take a train with less backlash"
        )
    best = min(kept, key=lambda one: one.figures[least])
    reasons = []
    for one, breaks in zip(candidates, broken, strict=True):
        if one is best:
            what = f"chosen: the least {least}, {one.figures[least]:.4g}, of {len(kept)} that keep every limit"
        elif breaks:
            what = "refused: it " + ", and ".join(_beyond(one, limit) for limit in breaks)
        else:
            what = f"not chosen: its {least} is {one.figures[least]:.4g}"
        reasons.append(f"{one.name} {what}")
    return Choice(best=best, reasons=tuple(reasons))


def _excess(one: Candidate, limit: Limit) -> float:
    """How far beyond its limit a figure is, as a share of the limit; what is no number is infinitely far."""
    value = one.figures[limit.figure]
    if isnan(value):
        return inf
    return (value - limit.most) / max(abs(limit.most), 1e-300)


def _beyond(one: Candidate, limit: Limit) -> str:
    value = one.figures[limit.figure]
    return (
        f"has a {limit.figure} of {value:.4g} {limit.unit}, {value - limit.most:.4g} {limit.unit} more than the "
        f"{limit.most:.4g} allowed"
    )
