"""Limits of the checks of a cam, and the limits of the pressure angle in textbooks, by name."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from math import radians
from types import MappingProxyType

from cadgen.messages import Message


class PressureAngleLimitName(StrEnum):
    """Source of the limits of the pressure angle."""

    NORTON_TRANSLATING = "norton_translating"
    NORTON_OSCILLATING = "norton_oscillating"
    CHINESE_TEXTS_STRICT = "chinese_texts_strict"
    CHINESE_TEXTS = "chinese_texts"


@dataclass(frozen=True, slots=True, kw_only=True)
class PressureAngleLimit:
    """Limits of the size of the pressure angle at the true contact.

    Attributes:
        rise: limit while the cam drives the follower outwards (the working stroke), rad.
        fall: limit while the spring drives the follower back (the return stroke), rad.
        source: who recommends it, and for which follower.
    """

    rise: float
    fall: float
    source: str


@dataclass(frozen=True, kw_only=True)
class CheckLimits:
    """Limits of the checks; angles in rad, lengths in mm.

    Attributes:
        pressure_angle: limits while the cam drives the follower outwards and while the spring drives it back.
        lost_lift: greatest lift that the trimmed profile may lose; infinite where the application judges its effect.
        min_convex_radius: least convex radius of the actual profile, away from its corners.
        cutter_radius: radius of the cutter that will cut the part.
        wall: least wall between the profile and every hole.
        motion_key: key of the design file that shapes the motion, for advice.
    """

    pressure_angle: PressureAngleLimit
    lost_lift: float
    min_convex_radius: float
    cutter_radius: float
    wall: float
    motion_key: str = "path.waypoints_mm"


_NORTON = Message("R. L. Norton, Cam Design and Manufacturing Handbook, 2nd ed. (2009), chapter 7")
_CHINESE = Message("Chinese textbooks of mechanisms, oscillating follower: 40-50° working stroke, 70-80° return stroke")

PRESSURE_ANGLE_LIMITS: Mapping[PressureAngleLimitName, PressureAngleLimit] = MappingProxyType(
    {
        PressureAngleLimitName.NORTON_TRANSLATING: PressureAngleLimit(
            rise=radians(30), fall=radians(30), source=Message("{book}: translating follower", book=_NORTON)
        ),
        PressureAngleLimitName.NORTON_OSCILLATING: PressureAngleLimit(
            rise=radians(35), fall=radians(35), source=Message("{book}: follower on a pivoted arm", book=_NORTON)
        ),
        PressureAngleLimitName.CHINESE_TEXTS_STRICT: PressureAngleLimit(
            rise=radians(40), fall=radians(70), source=Message("{books}; the lower ends", books=_CHINESE)
        ),
        PressureAngleLimitName.CHINESE_TEXTS: PressureAngleLimit(
            rise=radians(50), fall=radians(80), source=Message("{books}; the upper ends", books=_CHINESE)
        ),
    }
)
