"""Choices that a design file offers for gears: laws, thinnings, orders of stages. The module is light to import."""

from enum import StrEnum


class Law(StrEnum):
    """Spread of a quantity in its tolerance zone: normal with 3 sigma at the limits and clipped there, or uniform."""

    NORMAL = "normal"
    UNIFORM = "uniform"


class Thinning(StrEnum):
    """Limit of their grade to which teeth are thinned, or the middle of the two."""

    LEAST = "least"
    MIDDLE = "middle"
    GREATEST = "greatest"


class ToothCutting(StrEnum):
    """How teeth are made: by a generating tool, a disc cutter, a wire through the whole width, or in a mould."""

    HOBBED = "hobbed"
    SHAPED = "shaped"
    MILLED = "milled"
    WIRE = "wire"
    PRINTED = "printed"


class HelixHand(StrEnum):
    """Hand of a helix: teeth of a right-hand one turn clockwise as they go away, as a screw does (ISO 1122-1)."""

    RIGHT = "right"
    LEFT = "left"


class ToleranceStandard(StrEnum):
    """Source of tolerances that a design leaves out: ISO 1328 and ISO 286, or none, so that they are 0."""

    ISO = "iso"
    FREE = "free"


class HeldMember(StrEnum):
    """Member of a planetary set that does not turn."""

    RING = "ring"
    CARRIER = "carrier"
    SUN = "sun"


class Spacing(StrEnum):
    """Angles between planets: equal ones, or the nearest to these at which the teeth let the planets in."""

    EQUAL = "equal"
    NEAREST = "nearest"


class StageOrder(StrEnum):
    """Order of a train's stages in the car: as the design has them, or that of least return error."""

    AS_GIVEN = "as-given"
    REORDERED = "reordered"


class SearchObjective(StrEnum):
    """Objective of a search for trains: least return error, size (sum of the centre distances) or losses."""

    RETURN_ERROR = "return_error"
    SIZE = "size"
    LOSSES = "losses"


class Order(StrEnum):
    """Plan of a train: an order of its stages, or a search for the best teeth within limits."""

    AS_GIVEN = StageOrder.AS_GIVEN.value
    REORDERED = StageOrder.REORDERED.value
    SEARCH = "search"
