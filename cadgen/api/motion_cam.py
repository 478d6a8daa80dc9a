"""Cams without a design file: a motion, a follower, and the cam that moves the one by the other.

Angles are in rad and lengths in mm, as everywhere in Python; what these objects say is a design with [motion], whose
keys messages name.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from math import degrees, tau
from pathlib import Path
from typing import Any

import numpy as np

from cadgen.api.values import Stated, optional, real, whole, word
from cadgen.arrays import TURN
from cadgen.cam.followers.table import has, kind_of
from cadgen.design import load
from cadgen.design.motion import motion_of
from cadgen.design.schema import MotionDesign
from cadgen.design.sources.source import DiscSense
from cadgen.errors import DesignError, brief
from cadgen.laws.table import codes
from cadgen.laws.table import has as is_law
from cadgen.laws.unit import MM
from cadgen.output.report.notebook import Plotted, lines_picture
from cadgen.output.report.style import Drawing

# Section of a design file: its keys and values.
Section = dict[str, Any]
_POINTS = 1441  # of the motion on a picture
_ANY_CIRCLE, _ANY_THICKNESS = 100.0, 5.0  # mm, of a design that is asked for its motion alone
_SENSES = tuple(sense.value for sense in DiscSense)


@dataclass(frozen=True, repr=False)
class MotionStep(Stated):
    """Rise, return or dwell of a motion; `rise` and `dwell` make it.

    Attributes:
        angle: cam angle that it takes, rad.
        height: height by which it rises, negative for a return: mm, or rad of a swing; None for a dwell.
        law: code of its motion law.
    """

    angle: float
    height: float | None = None
    law: str = ""


def rise(height: float, angle: float, law: str = "polynomial_3_4_5") -> MotionStep:
    """Rise, or with a negative height a return.

    Args:
        height: height, mm, or rad of a swing.
        angle: cam angle that it takes, rad.
        law: code of a motion law, as in docs/how-to/motion.md.

    Raises:
        DesignError: a number out of its range, or a law that is not known.
    """
    if not is_law(law):
        near = get_close_matches(str(law)[:80].lower(), codes(), 1)
        if not near:
            word("law", law, codes())
        raise DesignError(
            "{here} is {value}: did you mean {near}?", here="law", value=brief(repr(law), 60), near=near[0]
        )
    return MotionStep(_angle(angle), real("height", height, -1e6, 1e6), law)


def dwell(angle: float) -> MotionStep:
    """Dwell: the follower stands still.

    Args:
        angle: cam angle that it takes, rad.

    Raises:
        DesignError: a number out of its range.
    """
    return MotionStep(_angle(angle))


def _angle(value: float) -> float:
    return real("angle", value, 0, tau * (1 + 1e-9), "rad", above=True)


@dataclass(frozen=True, repr=False)
class Motion(Stated, Plotted):
    """Motion of a follower in a turn of the cam: steps, points of a spline, or a lift table.

    Attributes:
        steps: rises and dwells, in order; they fill a turn.
        points: cam angle, rad, and height of points of a periodic spline, in place of steps.
        turns: sense in which the disc turns, seen on its outer face: `counterclockwise` or `clockwise`.
        rpm: speed of the camshaft, rev/min; None if it is not known.
        repeat: number of times that the steps are repeated in a turn.

    Raises:
        DesignError: neither steps nor points, or both; a number out of its range.

    Example:
        >>> from math import radians as rad
        >>> from cadgen import Motion, dwell, rise
        >>> motion = Motion([rise(14, rad(80)), dwell(rad(50)), rise(-14, rad(110), "modified_sine"), dwell(rad(120))])
    """

    steps: Sequence[MotionStep] = ()
    points: Sequence[tuple[float, float]] = ()
    turns: str = DiscSense.COUNTERCLOCKWISE.value
    rpm: float | None = None
    repeat: int = 1

    def __post_init__(self) -> None:
        word("turns", self.turns, _SENSES)
        optional("rpm", self.rpm, 0, 1e6, "rev/min", above=True)
        whole("repeat", self.repeat, 1, 360)
        if not isinstance(self.steps, Iterable) or not all(isinstance(step, MotionStep) for step in self.steps):
            raise DesignError(
                "steps is {given}; it must be a list of rise(...) and dwell(...)", given=brief(repr(self.steps), 60)
            )
        if bool(len(self.steps)) == bool(len(self.points)):
            raise DesignError("a motion has either steps or points: give one of them")

    @property
    def picture(self) -> Drawing:
        """Height over the turn."""
        # A design with any follower, so that what is refused is refused in its words.
        text = cam_toml(self, Roller(radius=1.0), _ANY_CIRCLE, None, _ANY_THICKNESS, None, "motion")
        design = load.complete_of(text, Path())
        assert isinstance(design, MotionDesign)  # it has [motion]
        angle = np.linspace(0.0, TURN, _POINTS)
        heights = {"height": motion_of(design.motion, design.follower.registered, corners=False).q(angle)}
        return lines_picture("motion", "cam angle (°)", "height", np.degrees(angle), heights, signed=True)

    def section(self, *, swings: bool) -> Section:
        """Section [motion] of a design file.

        Args:
            swings: whether heights are swings, rad.
        """
        unit = "deg" if swings else "mm"

        def height(value: float) -> float:
            return _shown(degrees(value) if swings else value)

        given: Section = {"turns": self.turns}
        if self.rpm is not None:
            given["speed_rpm"] = float(self.rpm)
        if self.repeat != 1:
            given["repeat"] = self.repeat
        if self.steps:
            given["segments"] = [
                {"dwell_deg": _shown(degrees(step.angle))}
                if step.height is None
                else {f"rise_{unit}": height(step.height), "in_deg": _shown(degrees(step.angle)), "law": step.law}
                for step in self.steps
            ]
        else:
            given["points"] = [[_shown(degrees(angle)), height(value)] for angle, value in self.points]
        return given


@dataclass(frozen=True, kw_only=True)
class Roller:
    """Roller on a slide.

    Attributes:
        radius: radius, mm.
        offset: distance of the slide's line from the camshaft, mm; positive lessens the pressure angle of the rise.
    """

    radius: float
    offset: float = 0.0


@dataclass(frozen=True, kw_only=True)
class KnifeEdge:
    """Knife edge on a slide.

    Attributes:
        offset: distance of the slide's line from the camshaft, mm.
    """

    offset: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Flat:
    """Flat face on a slide.

    Attributes:
        tilt: angle of the face's normal from the slide's axis, rad.
        offset: distance of the slide's axis from the camshaft, mm; it moves the face, and not the profile.
        width: width of the face, mm; None for as wide as it must be.
    """

    tilt: float = 0.0
    offset: float = 0.0
    width: float | None = None


@dataclass(frozen=True, kw_only=True)
class SwingingRoller:
    """Roller on an arm.

    Attributes:
        radius: radius, mm.
        arm: distance of the roller's centre from the pivot, mm.
        centre_distance: distance of the pivot from the camshaft, mm.
        lifts: `against` or `with` the sense of the cam.
    """

    radius: float
    arm: float
    centre_distance: float
    lifts: str = "against"


@dataclass(frozen=True, kw_only=True)
class SwingingFlat:
    """Flat face on an arm.

    Attributes:
        centre_distance: distance of the pivot from the camshaft, mm.
        face_offset: distance of the face from the pivot, mm, positive with the pivot on its far side.
        lifts: `against` or `with` the sense of the cam.
    """

    centre_distance: float
    face_offset: float = 0.0
    lifts: str = "against"


# Of any other kind, as of a plug-in, the keys of [follower] in a design file.
AnyFollower = Roller | KnifeEdge | Flat | SwingingRoller | SwingingFlat | Mapping[str, Any]


def follower_section(follower: AnyFollower) -> Section:
    """Section [follower] of a design file.

    Args:
        follower: follower, lengths in mm and angles in rad.

    Raises:
        DesignError: it is no follower.
    """
    f = follower
    match f:
        case Mapping():
            given = dict(f)
        case Roller():
            given = {"kind": "roller", "radius_mm": f.radius, "offset_mm": f.offset}
        case KnifeEdge():
            given = {"kind": "knife", "offset_mm": f.offset}
        case Flat():
            given = {"kind": "flat", "tilt_deg": _shown(degrees(f.tilt)), "face_offset_mm": f.offset}
            given |= {} if f.width is None else {"width_mm": f.width}
        case SwingingRoller():
            given = {"kind": "swinging_roller", "radius_mm": f.radius, "arm_mm": f.arm}
            given |= {"centre_distance_mm": f.centre_distance, "lifts": f.lifts}
        case SwingingFlat():
            given = {"kind": "swinging_flat", "centre_distance_mm": f.centre_distance}
            given |= {"face_offset_mm": f.face_offset, "lifts": f.lifts}
        case _:
            raise DesignError(
                "follower is {given}; it must be a Roller, KnifeEdge, Flat, SwingingRoller or SwingingFlat, or the "
                "keys of [follower]",
                given=brief(repr(follower), 60),
            )
    return given


@dataclass(frozen=True, kw_only=True)
class Spring:
    """Spring that holds a follower on its disc.

    Attributes:
        rate: N/mm, or N mm/rad of a swinging follower.
        preload: force at lift 0, N, or moment, N mm.
    """

    rate: float = 0.0
    preload: float = 0.0


def cam_toml(
    motion: Motion,
    follower: AnyFollower,
    base_circle_radius: float | None,
    pressure_angle: float | None,
    thickness: float,
    bore: float | None,
    name: str,
) -> str:
    """Design file of a cam; arguments as of `cadgen.Cam`, lengths in mm and angles in rad.

    Raises:
        DesignError: what is given is no motion or follower, or neither or both of radius and pressure angle are.
    """
    import tomlkit

    if not isinstance(motion, Motion):
        raise DesignError("motion is {given}; it must be a Motion", given=brief(repr(motion), 60))
    if (base_circle_radius is None) == (pressure_angle is None):
        raise DesignError("give either base_circle_radius, mm, or pressure_angle, rad, which the least one then keeps")
    cam: Section = {"thickness_mm": thickness}
    if base_circle_radius is None:
        cam["pressure_angle_deg"] = _shown(degrees(real("pressure_angle", pressure_angle, 0, TURN / 4, "rad")))
    else:
        cam["base_circle_radius_mm"] = base_circle_radius
    given = follower_section(follower)
    code = given.get("kind")
    # A kind that there is not is refused where the design is read.
    swings = isinstance(code, str) and has(code) and kind_of(code).unit != MM
    tables: Section = {
        "name": name,
        "motion": motion.section(swings=swings),
        "follower": given,
        "cam": cam,
    }
    if bore is not None:
        tables["blank"] = {"bore_diameter_mm": bore}
    try:
        return tomlkit.dumps(tables)
    except (TypeError, ValueError) as error:
        raise DesignError(
            "a value is no number or text that a design file holds ({error}): correct it", error=brief(str(error), 80)
        ) from None


def _shown(value: float) -> float:
    """A number without the rounding of a change of units."""
    return float(f"{value:.13g}")
