"""Faces of a part, as design files name them. The module is light to import."""

from enum import StrEnum


class Face(StrEnum):
    """Face of a part; of a disc, the inner one is nearer to the fork."""

    OUTER = "outer"
    INNER = "inner"
