"""Motion of harmonics: a sum of cosines and sines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field, Strict

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.sources.source import MotionKeys, Numbers, in_unit
from cadgen.errors import DesignError

if TYPE_CHECKING:
    from cadgen.laws.motion import Motion

_MOST_HARMONIC = 60


class HarmonicKeys(MotionKeys):
    """Keys of a motion of harmonics."""

    code: ClassVar[str] = "harmonics"

    harmonics: Annotated[tuple[Numbers, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=1,
        max_length=_MOST_HARMONIC + 1,
        description="[k, a, b] each: a cos(k theta) + b sin(k theta), mm or degrees; k = 0 is the mean",
    )

    def motion(self, kind: FollowerKind, *, corners: bool) -> Motion:
        """Motion of harmonics.

        Args:
            kind: kind of the follower, whose unit the heights must have.
            corners: whether the follower may have a corner of its path; harmonics have none.
        """
        from cadgen.laws.series import HarmonicMotion

        lobes, found = self.repeat or 1, {}
        for place, (number, cosine, sine) in enumerate(self.harmonics or (), 1):
            if number not in range(_MOST_HARMONIC + 1) or number in found:
                raise DesignError(
                    "motion.harmonics.{place} is for k = {number:g}; k must be a whole number from 0 to {most}, each "
                    "once: correct it",
                    place=place,
                    number=number,
                    most=_MOST_HARMONIC,
                )
            found[number] = (int(number) * lobes, in_unit(cosine, kind), in_unit(sine, kind))
        return HarmonicMotion.of(list(found.values()), kind.unit)
