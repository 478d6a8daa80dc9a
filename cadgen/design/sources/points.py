"""Motion of points: a periodic quintic spline goes through them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field, Strict

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.sources.source import SAME, MotionKeys, Row, columns, in_unit, refuse_order
from cadgen.errors import DesignError
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.laws.motion import Motion

_LEAST_POINTS = 6  # of a periodic quintic spline


class PointKeys(MotionKeys):
    """Keys of a motion through points."""

    code: ClassVar[str] = "points"

    points: Annotated[tuple[Row, ...] | None, Strict(False)] = Field(
        default=None,
        min_length=_LEAST_POINTS,
        max_length=3600,
        description="[angle in degrees, lift in mm or swing in degrees] each: a periodic quintic spline goes through "
        "them",
    )

    def motion(self, kind: FollowerKind, *, corners: bool) -> Motion:
        """Periodic quintic spline through points.

        Args:
            kind: kind of the follower, whose unit the heights must have.
            corners: whether the follower may have a corner of its path; a spline has none.
        """
        from cadgen.laws.lift_table import points_motion

        points = self.points or ()
        refuse_order("motion.points", points)
        whole = 360 * (self.machine_turns or 1.0) / (self.repeat or 1)
        reach = points[-1][0] - points[0][0]
        if reach > whole * (1 - SAME):
            cure = (
                Message(
                    "remove the last one, which is the first one again (--set motion.points.{number}=)",
                    number=len(points),
                )
                if abs(reach - whole) <= SAME * whole and points[0][1] == points[-1][1]
                else Message("remove those beyond it")
            )
            raise DesignError(
                "the points of motion.points reach over {reach:g} degrees; they must reach over less than {whole:g}: "
                "{cure}",
                reach=reach,
                whole=whole,
                cure=cure,
            )
        angle, height = columns(points, self.machine_turns or 1.0, self.repeat or 1)
        return points_motion(angle, height * in_unit(1.0, kind), kind.unit)
