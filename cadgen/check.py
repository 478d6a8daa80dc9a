"""Figures with limits and verdicts, for cams and for gears. The module is light to import."""

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum, unique
from math import inf, isinf
from typing import SupportsIndex, overload

from cadgen.errors import DesignError, brief
from cadgen.figures import Figure, frame_of, html_table

# As `typing.TYPE_CHECKING`, without the time that importing it takes.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from pandas import DataFrame


class Bound(StrEnum):
    """Side on which a limit bounds a figure."""

    MAX = "max"
    MIN = "min"


@unique
class CheckCode(StrEnum):
    """Codes of the checks. A code never changes, so programs may rely on it; a check's name may change."""

    PRESSURE_ANGLE_RISE = "pressure-angle-rise"
    PRESSURE_ANGLE_RETURN = "pressure-angle-return"
    CONVEX_RADIUS_THEORY = "convex-radius-theory"
    CONVEX_RADIUS_PROFILE = "convex-radius-profile"
    LOST_LIFT_UNDERCUT = "lost-lift-undercut"
    LOST_LIFT_CROSSING = "lost-lift-crossing"
    LOST_LIFT_FACE_CHANGE = "lost-lift-face-change"
    LOST_LIFT_EFFECT = "lost-lift-effect"
    PUSHED_OUT = "rod-pushed-out"  # of every follower: the code is older than the other kinds
    FALLS_SHORT = "rod-falls-short"  # likewise
    WRONG_FACE = "wrong-face-carries"
    CONTACT_FORMULA = "contact-formula"
    PRESSURE_ANGLE_FORMULA = "pressure-angle-formula"
    LIFT_FORMULA = "lift-formula"
    PUSH_FORMULA = "push-formula"
    RADIUS_FORMULA = "radius-formula"
    CURVATURE_FORMULA = "curvature-formula"
    BOUND_FORMULA = "bound-formula"
    STANDING_FORMULA = "standing-formula"
    NORMAL_FORMULA = "normal-formula"
    BLEND_LIFT = "blend-lift-not-given"
    BLEND_PRESSURE_ANGLE_RISE = "blend-pressure-angle-rise"
    BLEND_PRESSURE_ANGLE_RETURN = "blend-pressure-angle-return"
    ROD_PAST_RIM = "rod-past-rim"
    LEAN_OVER_CHAMFERS = "lean-over-chamfers"
    ROD_ABOVE_HUB = "rod-above-hub"
    CUTTER_RADIUS = "largest-cutter-radius"
    THINNEST_WALL = "thinnest-wall"
    CLOSURE = "closure"
    BLEND_START = "blend-start"
    LAP_DRIFT = "lap-drift"
    LAP_TURN = "lap-drift-heading"
    LAP_DRIFT_PLAY = "lap-drift-play"
    LAP_TURN_PLAY = "lap-drift-heading-play"
    LAPS_DRIFT_PLAY = "laps-drift-play"
    LAPS_TURN_PLAY = "laps-drift-heading-play"
    LAP_FURTHEST_PLAY = "last-lap-off-play"
    CHANCE_WORSE = "chance-worse"
    RUNS_EXPLAINED = "runs-explained"
    MEASURED_CAM = "measured-cam"
    EDGES_BROKEN_MORE = "edges-broken-more"
    LIFT_ERROR_WITH_PLAY = "lift-error-with-play"
    END_POSITION_WITH_PLAY = "end-position-with-play"
    END_HEADING_WITH_PLAY = "end-heading-with-play"
    RUN_POSITION_WITH_PLAY = "run-position-with-play"
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
    TOOL_ROOM = "tool-room"
    TEETH_REACHED = "teeth-reached"
    COURSE_POST = "course-post"
    COURSE_WALL = "course-wall"
    COURSE_ZONE = "course-zone"
    COURSE_EDGE = "course-edge"
    COURSE_SIDE = "course-side"
    COURSE_GATES = "course-gates"
    COURSE_GATE_MARGIN = "course-gate-margin"
    COURSE_START = "course-start"
    COURSE_START_HEADING = "course-start-heading"
    COURSE_FINISH = "course-finish"
    COURSE_FINISH_HEADING = "course-finish-heading"
    COURSE_BLEND = "course-blend"
    COURSE_BLEND_PLAY = "course-blend-play"
    COURSE_POST_PLAY = "course-post-play"
    COURSE_WALL_PLAY = "course-wall-play"
    COURSE_ZONE_PLAY = "course-zone-play"
    COURSE_EDGE_PLAY = "course-edge-play"
    COURSE_SIDE_PLAY = "course-side-play"
    COURSE_GATES_PLAY = "course-gates-play"
    COURSE_GATE_MARGIN_PLAY = "course-gate-margin-play"
    COURSE_FINISH_PLAY = "course-finish-play"
    COURSE_FINISH_HEADING_PLAY = "course-finish-heading-play"
    STEERING_ANGLE = "steering-angle"
    BODIES_OVERLAP = "bodies-overlap"
    PATH_WAYPOINT = "path-waypoint"
    PATH_END = "path-end"
    CUT_WAYPOINT = "cut-waypoint"
    CUT_END = "cut-end"
    CARS_KEEP_COURSE = "cars-keep-course"
    DRIVE_WHEEL_GREATEST = "drive-wheel-greatest"
    DRIVE_WHEEL_LEAST = "drive-wheel-least"
    DRIVE_WHEEL_OUTLINE = "drive-wheel-outline"
    ENERGY_LEFT = "energy-left"
    WEIGHT_PULL = "weight-pull"
    TIPPING_SPEED = "tipping-speed"
    AXLE_REACHED = "axle-reached"
    CAR_CLEARANCE = "car-clearance"
    FLOOR_CLEARANCE = "floor-clearance"
    PLATE_ROOM = "plate-room"
    PLATE_THICKNESS = "plate-thickness"
    CAM_SENSE = "cam-sense"
    FRAME_CLEARANCE = "frame-clearance"
    FRAME_APART = "frame-apart"
    FRAME_WALL = "frame-wall"
    FRAME_JOINTS = "frame-joints"
    FRAME_PIECES = "frame-pieces"
    FRAME_FLOOR = "frame-floor"
    FRAME_BLOCK = "frame-block"
    FRAME_EDGE = "frame-edge"
    FRAME_BED = "frame-bed"
    FRAME_BRIDGE = "frame-bridge"
    FRAME_OVERHANG = "frame-overhang"
    FRAME_KEYS = "frame-keys"
    FRONT_WHEEL_ROOM = "front-wheel-room"
    DRIVE_ROOM = "drive-room"
    DRIVE_FALL = "drive-fall"
    DRIVE_SCREWS = "drive-screws"
    MOTION_VELOCITY = "motion-velocity"
    MOTION_ACCELERATION = "motion-acceleration"
    MOTION_JERK = "motion-jerk"
    FORCE_LEAST = "normal-force-least"
    FORCE_GREATEST = "normal-force-greatest"
    GUIDE_JAMS = "guide-jams"
    LIFT_OFF_SPEED = "lift-off-speed"
    TORQUE_GREATEST = "camshaft-torque-greatest"
    TORQUE_LEAST = "camshaft-torque-least"
    TORQUE_MEAN = "camshaft-torque-mean"
    POWER_MEAN = "camshaft-power-mean"
    CONTACT_PRESSURE = "contact-pressure"
    DISC_TO_PIVOT = "disc-to-pivot"
    FACE_WIDTH = "face-width"
    FACE_END = "face-end"
    PRESSURE_ANGLE_GREATEST = "pressure-angle-greatest"
    PRESSURE_ANGLE_LEAST = "pressure-angle-least"
    GROOVE_PLAY_GREATEST = "groove-play-greatest"
    GROOVE_PLAY_LEAST = "groove-play-least"
    GROOVE_WALL = "groove-wall"
    GROOVE_HOLLOW = "groove-hollow-radius"
    CONTACT_FROM = "contact-from"
    CONTACT_TO = "contact-to"


@dataclass(frozen=True, repr=False)
class Check(Figure):
    """Figure with its limit and verdict.

    Attributes:
        code: kind of check, for programs: one of `CheckCode`, or a code of a kind of follower or gear.
        name: name of the check, for people.
        value: figure that was computed, in `unit`.
        unit: unit of value and limit, such as `mm`; empty for a ratio.
        limit: greatest or least value allowed, in `unit`; infinite for a figure that is shown and not judged.
        bound: greatest value allowed, or least.
        place: place on the part or path where the figure occurs; empty if it has none.
        advice: change that helps if the check fails, in words; empty if there is none.
    """

    code: StrEnum
    value: float
    limit: float = inf
    bound: Bound = Bound.MAX
    place: str = ""
    advice: str = ""

    def __repr__(self) -> str:
        bound = "" if isinf(self.limit) else f" ({'at most' if self.bound == Bound.MAX else 'at least'} {self.limit:g})"
        return f"<Check {self.code}: {self.text()}{bound}, {'passed' if self.passed else 'failed'}>"

    @property
    def passed(self) -> bool:
        """True when the value keeps its limit; a value that is not a number never does."""
        return bool(self.value <= self.limit if self.bound == Bound.MAX else self.value >= self.limit)

    @property
    def room(self) -> float:
        """Distance of the value from its limit, in `unit`, negative where it is past it."""
        return self.limit - self.value if self.bound == Bound.MAX else self.value - self.limit

    @property
    def unit_shown(self) -> str:
        """The unit as people read it: `mm²` for `mm2`."""
        return self.unit.replace("mm2", "mm²").replace("mm3", "mm³")


class CheckList(tuple[Check, ...]):
    """Checks of a part, with their common verdict; `checks["pressure-angle-rise"]` is the one of that code.

    Of several with one code, as of posts of a course, it is the one with the least room to its limit.
    """

    __slots__ = ()

    @overload
    def __getitem__(self, place: SupportsIndex, /) -> Check: ...

    @overload
    def __getitem__(self, place: slice, /) -> tuple[Check, ...]: ...

    @overload
    def __getitem__(self, place: str, /) -> Check: ...

    def __getitem__(self, place: SupportsIndex | slice | str, /) -> Check | tuple[Check, ...]:
        """Check by its code, or by its place.

        Raises:
            DesignError: no check has the code.
        """
        if not isinstance(place, str):
            return super().__getitem__(place)
        found = [check for check in self if check.code == place]
        if not found:
            from difflib import get_close_matches

            codes = tuple(dict.fromkeys(str(check.code) for check in self))
            alike = [code for code in codes if place and place in code] or get_close_matches(place, codes) or codes
            raise DesignError(
                "there is no check {code}; there are: {codes}", code=brief(repr(place), 60), codes=", ".join(alike)
            )
        return min(found, key=lambda check: (check.passed, check.room))

    def __repr__(self) -> str:
        wrong = ", ".join(dict.fromkeys(str(check.code) for check in failing(self)))
        return f"<{len(self)} checks, {f'failed: {wrong}' if wrong else 'all passed'}>"

    def _repr_html_(self) -> str:
        rows = [("check", "value", "", "limit", "verdict")]
        for check in self:
            limit = "" if isinf(check.limit) else f"{'≤' if check.bound == Bound.MAX else '≥'} {check.limit:g}"
            verdict = "passed" if check.passed else "failed"
            rows.append((str(check.code), check.text(), str(check.place), limit, verdict))
        return html_table(rows)

    def to_pandas(self) -> "DataFrame":
        """Checks as a pandas frame: code, name, value, unit, bound, limit, verdict, place.

        Raises:
            DesignError: pandas is not installed.
        """
        shown = ("code", "name", "value", "unit", "bound", "limit", "passed", "place")
        return frame_of([{key: getattr(check, key) for key in shown} for check in self])

    @property
    def passed(self) -> bool:
        """Whether every check keeps its limit."""
        return not failing(self)


def failing(checks: Iterable[Check]) -> tuple[Check, ...]:
    """Checks that do not keep their limit."""
    return tuple(check for check in checks if not check.passed)
