"""Places of claims in the as-built design, and those that they have once the user agrees."""

from collections.abc import Sequence
from dataclasses import dataclass

from cadgen.deviations.deviation import Place
from cadgen.inference.measurement.claims import Claim, at_work


@dataclass(frozen=True, slots=True)
class Built:
    """A claim with its place in the as-built design.

    Attributes:
        claim: with the mean of all that agree, if it stands for several.
        place: what becomes of it.
        instead: the claim that stands for the same thing in its stead.
        mean_of: sources of the records whose mean it has; empty if it has its own values.
    """

    claim: Claim
    place: Place
    instead: Claim | None = None
    mean_of: tuple[str, ...] = ()

    @property
    def waits(self) -> bool:
        """Whether a new cam takes it out only if the user agrees."""
        if self.place != Place.NOTED or self.instead or _instruments(self.claim):
            return False
        finding = self.claim.finding
        repeats = all(number == round(number) for _, number in finding.indices)  # with every turn of the cam
        return repeats and Place.CAR in self.claim.kind.named(finding.effect, dict(finding.indices)).places


def placed(claims: Sequence[Claim]) -> tuple[Built, ...]:
    """Everything claimed, each physical quantity at work once."""
    built = []
    for claim in claims:
        alike = [other for other in claims if other.deviation == claim.deviation]
        best, taken = at_work(alike)
        if best is not claim:
            built.append(Built(claim, Place.NOTED, best))
            continue
        built.append(
            Built(taken, _place(taken, alike), mean_of=() if taken is best else tuple(c.source for c in alike))
        )
    return tuple(built)


def _place(claim: Claim, alike: Sequence[Claim]) -> Place:
    """Default place of a claim: none for an effect that may be the instrument's in all kinds of data that show it."""
    if all(_instruments(other) for other in alike):
        return Place.NOTED
    return claim.kind.named(claim.finding.effect, dict(claim.finding.indices)).places[0]


def agreed_places(built: Sequence[Built]) -> list[Place]:
    """Places of effects once the user agrees to all that a cam can take out."""
    return [Place.CAR if each.waits else each.place for each in built]


def _instruments(claim: Claim) -> bool:
    """Whether data cannot tell a claim from an effect of their instrument."""
    twins = (claim.kind.catalogue.named(name) for name in claim.finding.twins)
    return any(twin is not None and twin.instrument for twin in twins)
