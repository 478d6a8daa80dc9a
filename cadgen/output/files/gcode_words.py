"""Words and comments of a program for a mill (G-code), and its moves above the work."""

import re
from dataclasses import dataclass

DECIMALS = 4  # of a coordinate: hobby controllers read as many, and rounding is 0.05 um at most
SETTINGS = "G21 G90 G17 G40 G94 G91.1"  # mm, absolute, plane XY, no compensation, mm/min, centres relative


def words(**values: float) -> str:
    """Address words with the coordinate's decimals; + 0.0 turns a negative zero positive.

    Args:
        values: coordinates by their letters, mm.
    """
    return " ".join(f"{letter}{round(float(value), DECIMALS) + 0.0:.{DECIMALS}f}" for letter, value in values.items())


def plain(text: str) -> str:
    """Text as it may stand in a comment."""
    return re.sub(r"[^ -~]|[()]", "_", text)


def comments(sentences: list[str]) -> list[str]:
    """Each sentence as a comment."""
    return [f"({plain(sentence)})" for sentence in sentences]


@dataclass(frozen=True)
class Hub:
    """A hub that stands on the face that is worked on, about the origin.

    Attributes:
        radius: radius of the hub, mm.
        height: height above the face, mm.
    """

    radius: float
    height: float
