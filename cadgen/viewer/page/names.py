"""Kinds of cells, figures, marks and parts on a page, as its script and its style name them."""

from enum import StrEnum


class State(StrEnum):
    """How a cell is shown."""

    PLAIN = ""
    GOOD = "good"
    BAD = "bad"
    STRONG = "strong"
    MUTED = "muted"


class FigureKind(StrEnum):
    """Kind of a figure on the course."""

    EDGE = "edge"
    POST = "post"
    WALL = "wall"
    ZONE = "zone"
    GATE = "gate"
    START = "start"
    FINISH = "finish"


class MarkKind(StrEnum):
    """Kind of a place on the turn: a peak, a valley, the begin of the blend, a jump, a wait."""

    PEAK = "peak"
    VALLEY = "valley"
    BLEND = "blend"
    JUMP = "jump"
    REVERSE = "reverse"


class Colour(StrEnum):
    """Colour of a part, by what it is."""

    CAM = "cam"
    GEAR = "gear"
    PINION = "pinion"
    FRAME = "frame"
