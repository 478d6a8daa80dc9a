"""Motion of a lift table, from a CSV or from rows of the design file."""

from __future__ import annotations

from enum import StrEnum
from math import radians
from typing import TYPE_CHECKING, Annotated, ClassVar

from pydantic import Field, Strict

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.lift_rows import MOST_ROWS
from cadgen.design.section import WORD
from cadgen.design.sources.source import SAME, MotionKeys, Row, columns, refuse_order, spoken
from cadgen.errors import DesignError, brief
from cadgen.laws.unit import MM
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.laws.motion import Motion

_INCH_MM = 25.4


class TableUnit(StrEnum):
    """Unit of the lift in a table."""

    MM = "mm"
    INCH = "inch"
    DEG = "deg"


class TableAngle(StrEnum):
    """Angle that a table counts: of the cam, or of the machine."""

    CAM = "cam"
    MACHINE = "machine"


class TableClosing(StrEnum):
    """Remedy for a table whose ends do not meet."""

    RAMPS = "ramps"


class TableKeys(MotionKeys):
    """Keys of a motion of a lift table."""

    code: ClassVar[str] = "table"
    alone: ClassVar[tuple[str, ...]] = ("table_unit", "table_angle", "smooth", "close")

    table: str | None = Field(
        default=None,
        min_length=1,
        max_length=1000,
        description="CSV of two columns, angle in degrees and lift, by its path from the folder of the design file",
    )
    table_unit: Annotated[TableUnit | None, WORD] = Field(
        default=None, description="unit of the lift in the table; left out, mm, or of a swinging follower deg"
    )
    table_angle: Annotated[TableAngle | None, WORD] = Field(
        default=None, description="whose angle the table has; left out, that of the machine if machine_turns is given"
    )
    smooth: bool | None = Field(
        default=None, description="whether the rows of the table are smoothed by the noise that their differences show"
    )
    close: Annotated[TableClosing | None, WORD] = Field(
        default=None, description="what leads the ends of a table together that do not meet; left out, it is refused"
    )
    rows: Annotated[tuple[Row, ...] | None, Strict(False)] = Field(
        default=None,
        max_length=MOST_ROWS,
        description="rows of the table, [angle, lift], instead of a file; what is read from a file is kept here",
    )

    @classmethod
    def named_in(cls, section: MotionKeys) -> tuple[str, ...]:
        """Keys of a section by which it names this source; none if it does not.

        Args:
            section: section [motion].
        """
        return tuple(key for key in ("table", "rows") if getattr(section, key))

    def motion(self, kind: FollowerKind, *, corners: bool) -> Motion:
        """Motion of a lift table.

        Args:
            kind: kind of the follower, whose unit the heights must have.
            corners: whether the follower may have a corner of its path; a table has none.
        """
        from cadgen.laws.lift_table import LEAST_ROWS, table_motion

        rows, name = self.rows or (), TableKeys.shaped_by(self)
        if len(rows) < LEAST_ROWS:
            raise DesignError(
                "{name} has one row; it needs at least {least}: add more"
                if len(rows) == 1
                else "{name} has {count} rows; it needs at least {least}: add more",
                name=Message("{name}, {file},", name=name, file=brief(self.table)) if self.table else name,
                count=len(rows),
                least=LEAST_ROWS,
            )
        refuse_order(name, rows)
        machine = self.machine_turns is not None and self.table_angle != TableAngle.CAM
        turns, lobes = (self.machine_turns or 1.0) if machine else 1.0, self.repeat or 1
        reach, whole = rows[-1][0] - rows[0][0], 360 * turns / lobes
        if reach > whole * (1 + SAME):
            raise DesignError(
                "the rows of {name} reach over {reach:g} degrees; they must reach over {whole:g} at most: remove those "
                "beyond it",
                name=name,
                reach=reach,
                whole=whole,
            )
        unit = self.table_unit or (TableUnit.MM if kind.unit == MM else TableUnit.DEG)
        if (unit == TableUnit.DEG) != (kind.unit != MM):
            raise DesignError(
                'motion.table_unit is "{unit}", and a follower of kind "{code}" moves in {spoken}: set '
                'motion.table_unit to "{right}"',
                unit=unit.value,
                code=kind.code,
                spoken=spoken(kind.unit),
                right="mm" if kind.unit == MM else "deg",
            )
        scale = {TableUnit.MM: 1.0, TableUnit.INCH: _INCH_MM, TableUnit.DEG: radians(1.0)}[unit]
        angle, height = columns(rows, turns, 1)
        smooth, ramps = bool(self.smooth), self.close is not None
        return table_motion(
            angle, height * scale, kind.unit, lobes=lobes, smooth=smooth, ramps=ramps, key="motion.close"
        )
