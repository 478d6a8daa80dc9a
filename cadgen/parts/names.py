"""Names that design files and the parts share: light to import."""

from enum import StrEnum


class Face(StrEnum):
    """Face of a part; of a disc, the inner one is nearer to the fork."""

    OUTER = "outer"
    INNER = "inner"
