"""The disc of a design with [motion]: its base circle, given or found for a pressure angle, and its thickness."""

from dataclasses import replace
from functools import lru_cache
from math import ceil, inf, radians
from typing import TYPE_CHECKING

from pydantic import Field, model_validator

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.follower import FollowerSection
from cadgen.design.motion import MotionSection, motion_of
from cadgen.design.section import DesignSection
from cadgen.errors import DesignError
from cadgen.laws.unit import RAD, TAN
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.laws.motion import Motion

_ROLLED = 1e-5  # rad; what the pressure angle of a rolled contact may err by, so that a limit that is asked for is kept
_ROUNDED = 1e4  # parts of a millimetre to which a base circle that is found is rounded up


class MotionCam(DesignSection):
    """The disc of a design with [motion]: `base_circle_radius_mm` or `pressure_angle_deg` fixes its base circle."""

    base_circle_radius_mm: float | None = Field(
        default=None, gt=0, le=1000, description="radius of the disc under a follower that rests at lift 0"
    )
    pressure_angle_deg: float | None = Field(
        default=None,
        ge=1,
        le=60,
        description="of a roller, a knife edge or a follower on an arm, instead of the radius: greatest pressure "
        "angle, for which the least base circle is taken",
    )
    base_radius_mm: float | None = Field(
        default=None, gt=0, le=500, description="of a rod, instead of the radius: a, camshaft to fork axis"
    )
    inner_face_mm: float | None = Field(
        default=None, gt=0, le=500, description="of a rod, fork axis to the disc's nearer face"
    )
    thickness_mm: float = Field(ge=0.1, le=100, description="between the disc's faces")
    outside_diameter_mm: float | None = Field(
        default=None,
        gt=0,
        le=5000,
        description="of a disc with a groove; left out, what leaves 5 mm and `checks.min_wall_mm` beyond the groove",
    )

    @model_validator(mode="after")
    def _base_circle_is_fixed_once(self) -> "MotionCam":
        names = ("base_circle_radius_mm", "pressure_angle_deg", "base_radius_mm")
        given = [name for name in names if getattr(self, name) is not None]
        if len(given) > 1:
            raise ValueError(
                Message(
                    "cam.{one} and cam.{other} both fix the base circle: remove one of them",
                    one=given[0],
                    other=given[1],
                )
            )
        if (self.base_radius_mm is None) != (self.inner_face_mm is None):
            raise ValueError(
                Message(
                    "cam.base_radius_mm and cam.inner_face_mm are the place of a disc under a rod, and one of them is "
                    "missing: add it, or, under another follower, give cam.base_circle_radius_mm in their place"
                )
            )
        return self

    @property
    def faces_mm(self) -> tuple[float, float]:
        """Heights of the disc's faces; under a rod their distances from the fork axis."""
        inner = self.inner_face_mm or 0.0
        return inner, inner + self.thickness_mm


def follower_motion(section: MotionSection, kind: FollowerKind, *, corners: bool = True) -> "Motion":
    """Motion of a design in the follower's unit: of a rod the tangent of the steering angle that the section gives.

    Args:
        section: section [motion].
        kind: kind of the follower.
        corners: as of `motion_of`.

    Raises:
        ValueError: as `motion_of`.
        DesignError: as `motion_of`.
    """
    if kind.unit != TAN:
        return motion_of(section, kind, corners=corners)
    from cadgen.cam.derived_motions import TangentMotion

    return TangentMotion.of(motion_of(section, replace(kind, unit=RAD), corners=corners))


@lru_cache(maxsize=64)  # a design is asked for its seat again and again
def base_circle_radius(cam: MotionCam, motion: MotionSection, follower: FollowerSection) -> float:
    """Radius of the base circle, mm: as given, or the least that keeps the pressure angle.

    Args:
        cam: section [cam].
        motion: section [motion].
        follower: section [follower].

    Raises:
        ValueError: the kind of the follower has no such radius, or it is smaller than nothing.
    """
    if (radius := cam.base_circle_radius_mm or cam.base_radius_mm) is not None:
        return radius
    if cam.pressure_angle_deg is None:
        raise ValueError(
            Message(
                "cam.base_circle_radius_mm is missing: add it, or cam.pressure_angle_deg, for which the least is taken"
            )
        )
    kind = follower.registered
    if kind.least_base is None:
        raise ValueError(
            Message(
                "cam.pressure_angle_deg is for a roller, a knife edge or a follower on an arm, and follower.kind is "
                '"{code}": give cam.base_circle_radius_mm instead',
                code=kind.code,
            )
        )
    try:
        moved = motion_of(motion, kind)
    except DesignError as error:
        raise ValueError(error.message) from None
    least = kind.least_base(follower.keys, moved, radians(cam.pressure_angle_deg) - _ROLLED)
    if least == inf:
        raise ValueError(
            Message(
                "cam.pressure_angle_deg is {angle:g}; no base circle keeps it with this arm and motion: raise it, lead "
                "the follower less far, or give cam.base_circle_radius_mm instead",
                angle=cam.pressure_angle_deg,
            )
        )
    if least <= 0:
        raise ValueError(
            Message(
                "cam.pressure_angle_deg is {angle:g}; it is kept by every base circle, down to nothing: give "
                "cam.base_circle_radius_mm instead",
                angle=cam.pressure_angle_deg,
            )
        )
    return ceil(least * _ROUNDED) / _ROUNDED
