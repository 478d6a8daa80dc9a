"""One figure and its verdict, for cams and for gears: light to import."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum, unique
from typing import Literal


@unique
class CheckCode(StrEnum):
    """What is checked, by a code that never changes; names are for people, and may."""

    PRESSURE_ANGLE_RISE = "pressure-angle-rise"
    PRESSURE_ANGLE_RETURN = "pressure-angle-return"
    CONVEX_RADIUS_THEORY = "convex-radius-theory"
    CONVEX_RADIUS_PROFILE = "convex-radius-profile"
    LOST_LIFT_UNDERCUT = "lost-lift-undercut"
    LOST_LIFT_CROSSING = "lost-lift-crossing"
    LOST_LIFT_FACE_CHANGE = "lost-lift-face-change"
    ROD_PUSHED_OUT = "rod-pushed-out"
    ROD_FALLS_SHORT = "rod-falls-short"
    WRONG_FACE = "wrong-face-carries"
    BLEND_LIFT = "blend-lift-not-given"
    BLEND_PRESSURE_ANGLE_RISE = "blend-pressure-angle-rise"
    BLEND_PRESSURE_ANGLE_RETURN = "blend-pressure-angle-return"
    ROD_PAST_RIM = "rod-past-rim"
    LEAN_OVER_CHAMFERS = "lean-over-chamfers"
    ROD_ABOVE_HUB = "rod-above-hub"
    THINNEST_WALL = "thinnest-wall"
    CUTTER_RADIUS = "largest-cutter-radius"
    CLOSURE = "closure"
    BLEND_START = "blend-start"
    CHANCE_WORSE = "chance-worse"
    RUNS_EXPLAINED = "runs-explained"
    EDGES_BROKEN_MORE = "edges-broken-more"
    LIFT_ERROR_WITH_PLAY = "lift-error-with-play"
    CAM_RUNS_AHEAD = "cam-runs-ahead"
    CAM_HOLDS = "cam-holds"
    BEARING_WIDTH = "bearing-width"
    ROOT_CLEARANCE = "root-clearance"
    CONTACT_RATIO = "contact-ratio"
    CONTACT_RATIO_FORMULA = "contact-ratio-formula"
    TEETH_JAM = "teeth-jam"
    TEETH_HOLD = "teeth-hold"
    OVERLAP_WITHIN_PLAY = "overlap-within-play"
    OVERLAP_PAST_PLAY = "overlap-past-play"
    PLAY_AS_CUT = "play-as-cut"
    PLAY_GREATEST = "play-greatest"
    PLAY_LEAST = "play-least"
    RETURN_ERROR = "return-error"
    BODIES_OVERLAP = "bodies-overlap"


@dataclass(frozen=True)
class Check:
    """One figure and its verdict.

    Attributes:
        code: what is checked, for programs.
        name: the same for people.
        value: the figure, in `unit`.
        unit: of value and limit.
        limit: the bound; infinite for a figure that is shown and not judged.
        bound: `max` if the value must not exceed the limit, `min` if it must reach it.
        place: where the figure occurs.
        advice: what to change if it fails; empty if there is nothing to say.
    """

    code: CheckCode
    name: str
    value: float
    unit: str
    limit: float
    bound: Literal["max", "min"]
    place: str = ""
    advice: str = ""

    @property
    def passed(self) -> bool:
        """True when the value keeps its limit; a value that is not a number never does."""
        return bool(self.value <= self.limit if self.bound == "max" else self.value >= self.limit)


def failing(checks: Iterable[Check]) -> tuple[Check, ...]:
    """The checks that do not keep their limit."""
    return tuple(check for check in checks if not check.passed)
