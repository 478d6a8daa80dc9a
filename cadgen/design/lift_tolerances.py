"""The section [lift_tolerances]: what a cam with [motion] and its follower may be off by, and the limit of its lift."""

from math import radians
from typing import Annotated

from pydantic import Field

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.section import WORD, DesignSection, listed
from cadgen.errors import DesignError
from cadgen.gears.choices import Law

# Keys of followers that have such a dimension, with the word of the follower in messages.
_OF = {
    "roller_radius_um": ("roller", "swinging_roller"),
    "offset_um": ("roller", "knife"),
    "arm_um": ("swinging_roller",),
    "centre_distance_um": ("swinging_roller", "swinging_flat"),
    "face_offset_um": ("swinging_flat",),
    "tilt_deg": ("flat",),
}


class LiftTolerances(DesignSection):
    """Half widths of the tolerance zones of a cam with [motion] and of its follower, for `cadgen tolerance`."""

    base_circle_um: float | None = Field(
        default=None, ge=0, le=5000, description="of the disc all round, along its normal"
    )
    roller_radius_um: float | None = Field(default=None, ge=0, le=5000, description="of the roller's radius")
    offset_um: float | None = Field(default=None, ge=0, le=5000, description="of the slide's line from the camshaft")
    arm_um: float | None = Field(default=None, ge=0, le=5000, description="of the arm's length")
    centre_distance_um: float | None = Field(
        default=None, ge=0, le=5000, description="of the pivot's distance from the camshaft"
    )
    face_offset_um: float | None = Field(
        default=None, ge=0, le=5000, description="of the distance of a swinging face from its pivot"
    )
    tilt_deg: float | None = Field(default=None, ge=0, le=5, description="of a flat face on its slide")
    phase_deg: float | None = Field(default=None, ge=0, le=10, description="of the disc on its shaft")
    eccentricity_um: float | None = Field(
        default=None, ge=0, le=5000, description="of the bore, in any direction: the greatest"
    )
    law: Annotated[Law, WORD] = Field(
        default=Law.NORMAL, description="how they lie in their zones: normal with 3 sigma at the limits, or uniform"
    )
    set_at_deg: float | None = Field(
        default=0.0,
        ge=0,
        le=360,
        description="cam angle at which the follower is set, where its lift has no error",
    )
    limit_um: float | None = Field(
        default=None,
        gt=0,
        le=5000,
        description="greatest error of the lift allowed, on an arm along the way of the contact: cams within it count",
    )

    def half_widths(self) -> dict[str, float]:
        """Half widths of the zones that are stated, mm and rad, by the code of the deviation."""
        found = {}
        for name in type(self).model_fields:
            code, _, unit = name.rpartition("_")
            value = getattr(self, name)
            if name in ("law", "set_at_deg", "limit_um") or not value:
                continue
            found[code] = value / 1e3 if unit == "um" else radians(value)
        return found

    def refuse(self, kind: FollowerKind) -> None:
        """Refuse a tolerance of a dimension that the follower has not.

        Args:
            kind: kind of the follower.

        Raises:
            DesignError: there is one.
        """
        for name, codes in _OF.items():
            if getattr(self, name) is not None and kind.code not in codes:
                raise DesignError(
                    'lift_tolerances.{name} is for {kinds}, and follower.kind is "{code}": remove it (on the command '
                    "line with --set lift_tolerances.{name}=)",
                    name=name,
                    kinds=listed(codes, "and"),
                    code=kind.code,
                )
