"""Keys of any source of [motion], heights in the unit of the motion, and rows whose angles grow."""

from __future__ import annotations

from abc import abstractmethod
from enum import StrEnum
from itertools import pairwise
from math import degrees, radians
from typing import TYPE_CHECKING, Annotated, ClassVar

from annotated_types import Ge, Le, Len
from pydantic import Field, Strict

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.section import WORD, DesignSection
from cadgen.errors import DesignError
from cadgen.laws.unit import MM, Unit

if TYPE_CHECKING:
    from cadgen.arrays import Array
    from cadgen.laws.motion import Motion

MOST_TURNS = 100  # of a machine in a turn of its cam
SAME = 1e-9  # of the greatest height, or of a turn; a smaller difference is rounding


class DiscSense(StrEnum):
    """Sense in which a disc turns, seen on its outer face."""

    CLOCKWISE = "clockwise"
    COUNTERCLOCKWISE = "counterclockwise"


Number = Annotated[float, Ge(-1e6), Le(1e6)]
Numbers = Annotated[tuple[Number, ...], Strict(False), Len(3, 3)]
Row = Annotated[tuple[Number, Number], Strict(False)]


class MotionKeys(DesignSection):
    """Keys of any source of a motion. A source has its own besides, in a class made of this one.

    Attributes:
        code: key by which a section names the source.
        alone: keys that make no sense with another source.
    """

    code: ClassVar[str]
    alone: ClassVar[tuple[str, ...]] = ()

    turns: Annotated[DiscSense, WORD] = Field(
        description="sense of the disc seen on its outer face; files show the face on which it turns clockwise, with "
        "+z towards you: the outer one, or with counterclockwise the inner one"
    )
    speed_rpm: float | None = Field(
        default=None, gt=0, le=1e6, description="speed of the camshaft; with it velocities and accelerations are shown"
    )
    repeat: int | None = Field(
        default=None,
        ge=1,
        le=360,
        description="lobes: how often the motion is repeated in a turn, of which it then takes that part",
    )
    machine_turns: float | None = Field(
        default=None,
        gt=0,
        le=MOST_TURNS,
        description="turns of the machine in a turn of the cam, 2 for the valves of an engine: all angles of the "
        "section are then those of the machine",
    )

    @classmethod
    def named_in(cls, section: MotionKeys) -> tuple[str, ...]:
        """Keys of a section by which it names this source; none if it does not.

        Args:
            section: section [motion].
        """
        return (cls.code,) if getattr(section, cls.code) else ()

    @classmethod
    def shaped_by(cls, section: MotionKeys) -> str:
        """Key that shapes the motion, as messages name it.

        Args:
            section: section [motion] that names this source.
        """
        return f"motion.{cls.named_in(section)[0]}"

    @abstractmethod
    def motion(self, kind: FollowerKind, *, corners: bool) -> Motion:
        """Motion of the source.

        Args:
            kind: kind of the follower, whose unit the heights must have.
            corners: whether the follower may have a corner of its path, so that a refusal may name it.
        """


def columns(rows: tuple[tuple[float, float], ...], turns: float, lobes: int) -> tuple[Array, Array]:
    """Cam angles, rad, and heights of rows, repeated for every lobe.

    Args:
        rows: angle, degrees, and height of each.
        turns: turns of what the angles count in a turn of the cam.
        lobes: times that they are repeated.
    """
    import numpy as np

    angle, height = np.array(rows, dtype=float).T
    angle = np.radians(angle / turns)
    return np.concatenate([angle + lobe * 2 * np.pi / lobes for lobe in range(lobes)]), np.tile(height, lobes)


def refuse_order(name: str, rows: tuple[tuple[float, float], ...]) -> None:
    """Refuse rows whose angles do not grow.

    Args:
        name: key of the rows.
        rows: angle, degrees, and height of each.
    """
    if len(rows) > 1 and all(angle < before for (before, _), (angle, _) in pairwise(rows)):
        # Sorted, rows that a machine passes in this order would give the motion backwards.
        raise DesignError(
            "the angles of {name} fall from row to row, but they must grow as the cam turns: change their signs where "
            "the cam passes the rows in this order, or turn the order of the rows round where it passes the last "
            "one first",
            name=name,
        )
    for number, ((before, _), (angle, _)) in enumerate(pairwise(rows), 2):
        if angle == before:
            raise DesignError(
                "row {number} of {name} repeats the angle of the row before it, {angle:g} degrees: remove one of the "
                "two",
                number=number,
                name=name,
                angle=angle,
            )
        if angle < before:
            raise DesignError(
                "row {number} of {name} is at {angle:g} degrees, after one at {before:g}, but angles must grow: sort "
                "the rows by their angles",
                number=number,
                name=name,
                angle=angle,
                before=before,
            )


def in_unit(value: float, kind: FollowerKind) -> float:
    """A height of the file in the motion's unit.

    Args:
        value: height, mm or degrees.
        kind: kind of the follower.
    """
    return value if kind.unit == MM else radians(value)


def in_file(value: float, kind: FollowerKind) -> float:
    """A height in the unit of the file, mm or degrees.

    Args:
        value: height, in the motion's unit.
        kind: kind of the follower.
    """
    return value if kind.unit == MM else degrees(value)


def unit_in_file(kind: FollowerKind) -> str:
    """Unit of heights in the file, as messages show it."""
    return "mm" if kind.unit == MM else "°"


def spoken(unit: Unit) -> str:
    """Unit of heights in words."""
    return "mm" if unit == MM else "degrees"
