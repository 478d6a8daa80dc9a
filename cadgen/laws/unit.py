"""Units of motions: the coordinate in which a follower moves. The module is light to import."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Unit:
    """Unit of a motion.

    Attributes:
        symbol: unit as text.
        level: range within which a motion counts as level, in the unit: 0.01 um of lift on an arm of 25 mm.
    """

    symbol: str
    level: float


MM, RAD, TAN = Unit("mm", 1e-5), Unit("rad", 4e-7), Unit("tan", 4e-7)
