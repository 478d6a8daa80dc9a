"""The smallest single change that brings lost lift within its limit."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from cadgen.cam.checks import lost_lift
from cadgen.cam.envelope import actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.errors import DesignError

# The change is found to this share of itself; a shop rounds further than that.
_PRECISION = 0.01
_LARGEST_FACTOR = 64.0  # a change beyond this is no cure


@dataclass(frozen=True)
class Cure:
    """One change that makes the loss acceptable.

    Attributes:
        parameter: key of the design file.
        now: value in the design, mm.
        value: value that cures, mm.
    """

    parameter: str
    now: float
    value: float

    @property
    def factor(self) -> float:
        """How many times the parameter changes, >= 1."""
        return max(self.value / self.now, self.now / self.value)


def worst_loss(lift: LiftCurve, follower: Follower) -> float:
    """Greatest lift that the exact envelope for this rod cannot give, mm."""
    try:
        profile = actual_profile(lift, follower)
    except DesignError:
        return float("inf")
    return max((loss.lift for loss in lost_lift(lift, follower, profile.curve, profile.trims)), default=0.0)


def undercut_cures(lift: LiftCurve, follower: Follower, limit: float) -> tuple[Cure, ...]:
    """Try a thinner rod and a larger base circle, each alone, and return what cures, smallest change first.

    The loss falls with both (r / (cos(delta/2)) - r at a corner of angle delta, and delta falls as the base
    grows), so bisection on the factor finds the smallest change; every answer has been computed, not estimated.

    Args:
        lift: the steering wanted.
        follower: the rod.
        limit: lift that may be lost, mm.
    """
    cures = []
    for name, now, changed in (
        ("follower.radius_mm", follower.radius, lambda f: replace(follower, radius=follower.radius / f)),
        ("cam.base_radius_mm", follower.base_radius, lambda f: replace(follower, base_radius=follower.base_radius * f)),
    ):
        factor = _smallest_factor(lambda f, changed=changed: worst_loss(lift, changed(f)) <= limit)
        if factor is not None:
            value = now / factor if name == "follower.radius_mm" else now * factor
            cures.append(Cure(name, now, value))
    return tuple(sorted(cures, key=lambda cure: cure.factor))


def _smallest_factor(cured: Callable[[float], bool]) -> float | None:
    low, high = 1.0, 2.0
    while not cured(high):
        low, high = high, high * 2
        if high > _LARGEST_FACTOR:
            return None
    while high / low > 1 + _PRECISION:
        middle = (low * high) ** 0.5
        if cured(middle):
            high = middle
        else:
            low = middle
    return high
