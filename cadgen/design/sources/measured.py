"""Motion that is not known yet: `cadgen calibrate` finds it from the measured cam."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from pydantic import Field

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.sources.source import MotionKeys
from cadgen.errors import DesignError

if TYPE_CHECKING:
    from cadgen.laws.motion import Motion


class MeasuredKeys(MotionKeys):
    """Keys of a motion that is to be found."""

    code: ClassVar[str] = "measured"
    alone: ClassVar[tuple[str, ...]] = ("ends_at_deg",)

    measured: bool | None = Field(
        default=None,
        description="whether the motion is not known, and `cadgen calibrate` is to find it from the measured cam; the "
        "base circle is then found, too, where an outline is measured",
    )

    ends_at_deg: float | None = Field(
        default=None,
        gt=0,
        le=30,
        description="of a measured motion, step at whose multiples the drawing has the ends of all segments, counted "
        "from the first: 1 for whole degrees; left out, that is concluded where sound segments show it",
    )

    def motion(self, kind: FollowerKind, *, corners: bool) -> Motion:
        """Refusal of whatever needs a motion that is to be found.

        Args:
            kind: kind of the follower.
            corners: whether the follower may have a corner of its path.

        Raises:
            DesignError: always.
        """
        raise DesignError(
            "motion.measured is true: the motion is to be found from the measured cam first: run cadgen calibrate on "
            "this design and the file of measured points or lifts; with --out it writes the design with its motion"
        )
