"""The catalogue of deviations: every way in which a car may differ from its design, in one entry each.

An entry says what a deviation is (name, unit, sign), which key of `[tolerances]` bounds it, and whether a hand can set
it without a new part. What it does stands beside it: exactly in the effects of `calibrate` (`disc`, `lift`,
`transmission`, `track`), to first order in `first_order`. `tolerance` varies the entries of `VARIED`, `adjust` sets
those of `SETTABLE`, and an effect names the entry that it is, so that records of different kinds agree about it.

This module is light: every design file is checked against it, and it imports no numerics.
"""

from dataclasses import dataclass, field
from enum import StrEnum
from math import radians

from cadgen.errors import DesignError
from cadgen.messages import joined


class Place(StrEnum):
    """Place of an effect in an as-built design.

    It stays with the car; every disc made this way has it; it belongs to the disc that was measured; it is only
    recorded.
    """

    CAR = "car"
    PROCESS = "process"
    PART = "part"
    NOTED = "noted"


@dataclass(frozen=True)
class ToleranceZone:
    """Tolerance of a deviation in a design file.

    Attributes:
        most: greatest half width, in the unit of the key.
        meaning: description of the key.
        optional: whether the key may be left out of the values of a design, rather than be 0 there.
    """

    most: float
    meaning: str
    optional: bool = True


class ByHand(StrEnum):
    """Part of a car that a hand sets without a new part."""

    DISC = "disc"
    HEAD = "head"
    WHEEL = "wheel"
    KEY = "key"
    START = "start"


@dataclass(frozen=True)
class Hand:
    """Setting by hand, without a new part.

    Attributes:
        setting: name of the setting.
        part: what is set; settings of one part, as those of the start, are made together.
        keys: beginning of its keys in `[settings]`; empty where no card sets it.
        limit: greatest change either way that `adjust` asks for, mm or rad; 0 where `card` alone sets it.
        probe: change from which a derivative is taken, mm or rad: a hundredth of what moves the end of the paper's car
            by a metre.
    """

    setting: str
    part: ByHand
    keys: str = ""
    limit: float = 0.0
    probe: float = 0.0


# End of a key in a design file, by the unit of the values.
_ENDINGS = {"mm": "_mm", "rad": "_deg", "N": "_N", "K": "_K", "Nmm": "_Nmm", "1": ""}


@dataclass(frozen=True)
class Deviation:
    """Way in which a car may differ from its design; two of one name are the same.

    Attributes:
        name: name in words, unique.
        key: name in tables, in JSON, and in `[tolerances]` before the unit; empty where many cars do not vary it.
        unit: unit of its values in tables: `mm`, `rad`, `N`, `K`, `Nmm`, or `1` for a ratio.
        directed: whether it is a size with a direction: its values are two components, towards polar angles of 0 and
            90 degrees of the disc, or towards the ground at the start and a quarter turn of the wheel later; of the
            camshaft in its frame, towards the fork axis and up; of gears, the cosine and the sine of a turn.
        one_sided: whether it lies between 0 and its half width.
        fleeting: whether it differs from run to run, or a trim itself sets it no closer: then no trim takes it out.
        zone: its key in `[tolerances]`; None where another section gives it, or none.
        hand: how a hand sets it; None if it cannot.
    """

    name: str
    key: str = field(default="", compare=False)
    unit: str = field(default="1", compare=False)
    directed: bool = field(default=False, compare=False)
    one_sided: bool = field(default=False, compare=False)
    fleeting: bool = field(default=False, compare=False)
    zone: ToleranceZone | None = field(default=None, compare=False)
    hand: Hand | None = field(default=None, compare=False)

    def __str__(self) -> str:
        return self.key or self.name

    @property
    def columns(self) -> list[int]:
        """Numbers of its columns in a table of deviations: one, or two of a directed deviation."""
        return _COLUMNS[self.name]

    @property
    def column(self) -> int:
        """Number of its only column."""
        (column,) = self.columns
        return column

    @property
    def tolerance_key(self) -> str:
        """Key of its tolerance in `[tolerances]`, with the unit; empty without a zone."""
        return f"{self.key}{_ENDINGS[self.unit]}" if self.zone else ""


BASE_RADIUS = Deviation(
    "base radius",
    "base_radius",
    "mm",
    fleeting=True,
    zone=ToleranceZone(10, "a, camshaft to fork axis, after adjustment", optional=False),
    hand=Hand("head", ByHand.HEAD, "head", 1.0, 5e-4),
)
INNER_FACE = Deviation(
    "inner face",
    "inner_face",
    "mm",
    zone=ToleranceZone(10, "place of the disc's inner face", optional=False),
    hand=Hand("disc", ByHand.DISC, "disc"),
)
OUTER_FACE = Deviation(
    "outer face",
    "outer_face",
    "mm",
    zone=ToleranceZone(10, "place of the disc's outer face", optional=False),
    hand=Hand("disc", ByHand.DISC, "disc"),
)
ROD_RADIUS = Deviation("rod radius", "rod_radius", "mm", zone=ToleranceZone(10, "r_t, of the rod", optional=False))
# The disc cut too large all round, along its normal.
PROFILE_OFFSET = Deviation(
    "profile offset",
    "profile_offset",
    "mm",
    zone=ToleranceZone(10, "profile cut too large or too small all round, along its normal", optional=False),
)
STEERING_ZERO = Deviation(
    "steering zero", "steering_zero", "rad", zone=ToleranceZone(10, "front wheel against the rod", optional=False)
)
WHEELBASE = Deviation("wheelbase", "wheelbase", "mm", zone=ToleranceZone(10, "L, of the wheelbase", optional=False))
DRIVE_WHEEL_OFFSET = Deviation(
    "drive wheel offset",
    "drive_wheel_offset",
    "mm",
    zone=ToleranceZone(10, "A1, of the driven wheel's offset", optional=False),
)
# It scales the travel.
WHEEL_RADIUS = Deviation(
    "wheel radius",
    "wheel_radius",
    "mm",
    zone=ToleranceZone(10, "R_h, of the drive wheel as it rolls under load; needs [train]", optional=False),
    hand=Hand("wheel", ByHand.WHEEL, "wheel"),
)
# The cam set ahead on its shaft, or the run started late.
CAM_PHASE = Deviation(
    "cam phase",
    "cam_phase",
    "rad",
    fleeting=True,
    zone=ToleranceZone(10, "cam on its shaft against the start of the run", optional=False),
    hand=Hand("key", ByHand.KEY, "", radians(5.0), radians(0.02)),
)
START_X = Deviation(
    "start x",
    "start_x",
    "mm",
    fleeting=True,
    zone=ToleranceZone(100, "place at the start, along the planned heading", optional=False),
    hand=Hand("start_x", ByHand.START, "start", 100.0, 1.0),
)
START_Y = Deviation(
    "start y",
    "start_y",
    "mm",
    fleeting=True,
    zone=ToleranceZone(100, "place at the start, across it", optional=False),
    hand=Hand("start_y", ByHand.START, "start", 100.0, 1.0),
)
START_HEADING = Deviation(
    "start heading",
    "start_heading",
    "rad",
    fleeting=True,
    zone=ToleranceZone(45, "heading at the start", optional=False),
    hand=Hand("start_heading", ByHand.START, "start_heading", radians(3.0), radians(0.02)),
)
# B, of the gears at the camshaft; many cars vary it within the band of [play] or [train].
RETURN_ERROR = Deviation("return error", "play", "rad")
# Between rod and disc, and drag on the disc or its shaft: within the bands of [mechanics].
SLIDING_FRICTION = Deviation("sliding friction", "friction", "1")
DRAG = Deviation("drag", "drag", "Nmm")
ROD_FORCE = Deviation(  # at zero lift
    "rod force",
    "rod_force",
    "N",
    zone=ToleranceZone(100, "of the rod, about `mechanics.rod_force_N`; needs [mechanics]"),
)
EDGE_BREAK = Deviation(
    "edge break",
    "edge_break",
    "mm",
    zone=ToleranceZone(10, "how much more or less than wanted both edges of the rim are broken"),
)
EDGE_WEAR = Deviation(
    "edge wear",
    "edge_wear",
    "mm",
    one_sided=True,
    zone=ToleranceZone(10, "what wears off both edges at most, as a chamfer's leg; not less than 0"),
)
TAPER = Deviation(  # by which the outer face is cut larger than the inner one
    "taper",
    "taper",
    "mm",
    zone=ToleranceZone(
        10, "by which one face is cut larger than the other, half of it on either: laser, water jet, wire"
    ),
)
ROD_HEIGHT = Deviation(
    "rod height", "rod_height", "mm", zone=ToleranceZone(10, "rod's axis above or below the camshaft's")
)
ECCENTRIC_BORE = Deviation(  # the disc displaced on its shaft
    "eccentric bore",
    "eccentricity",
    "mm",
    directed=True,
    zone=ToleranceZone(
        10,
        "of the profile about the shaft, in any direction: the bore's place, and half the clearance of "
        "`blank.bore_fit`",
    ),
)
WOBBLE = Deviation(
    "wobble",
    "wobble",
    "rad",
    directed=True,
    zone=ToleranceZone(10, "by which the disc leans on its shaft, in any direction"),
)
STEERING_LOST_MOTION = Deviation(
    "steering lost motion",
    "steering_lost_motion",
    "rad",
    one_sided=True,
    zone=ToleranceZone(
        10, "half of the play between rod and front wheel, by which the wheel lags in turns to either side"
    ),
)
WHEEL_RUNOUT = Deviation(
    "wheel run-out",
    "wheel_runout",
    "mm",
    directed=True,
    zone=ToleranceZone(10, "eccentricity of the drive wheel; needs [train]"),
)
TEMPERATURE = Deviation(
    "temperature",
    "temperature",
    "K",
    fleeting=True,
    zone=ToleranceZone(
        100, "how far from that of the adjustment; needs `blank.material`, and goes by `frame_material`"
    ),
)
# The cam of a braked car stands where it was left, and the gears have so far to turn before they reach it.
START_GAP = Deviation(
    "start gap",
    "start_gap",
    "rad",
    one_sided=True,
    fleeting=True,
    zone=ToleranceZone(
        10,
        "between the teeth at the start of a run, at the camshaft, at most the play; a brake holds the cam there. Left "
        "out or 0 where the drive is turned forward until the cam moves",
    ),
)
ROD_BENDING = Deviation(  # at its contact with the disc, at zero lift
    "rod bending",
    "rod_bending",
    "mm",
    one_sided=True,
    zone=ToleranceZone(1, "by which the rod's force bends it where it touches the disc, at zero lift"),
)
WIND_UP = Deviation(
    "wind-up",
    "wind_up",
    "rad",
    one_sided=True,
    zone=ToleranceZone(
        10,
        "by which the camshaft lags its gears on the steepest part of the lift in the turn, its closing blend "
        "included: shafts that twist, and so lead on falls",
    ),
)
BEARING_SEATS = Deviation(
    "bearing seats",
    "bearing_seats",
    "rad",
    directed=True,
    zone=ToleranceZone(10, "by which the camshaft leans in the frame, in any direction: the seats of its bearings"),
)
# Each gear is ahead and behind once in a turn of its shaft, by its cumulative pitch and by its seat.
GEAR_ERRORS = tuple(
    Deviation(f"gears of shaft {number} from the camshaft", f"gears_of_shaft_{number}", "rad", directed=True)
    for number in range(5)
)
# Like a turn of the front wheel, for one run.
SIDE_SLIP = Deviation(
    "side slip",
    "side_slip",
    "rad",
    fleeting=True,
    zone=ToleranceZone(
        10,
        "by which the slip angles of front and rear wheels together differ from run to run, with the rolling "
        "resistance of the wheels that are not driven",
    ),
)
# Only measured, never varied.
SHAFT_RUNOUT = Deviation("run-out of the shaft", unit="mm")
WORN_NOSE = Deviation("worn nose", unit="mm")
AXIS_REVERSAL = Deviation("machine-axis reversal", unit="mm")
UNDULATION = Deviation("undulation", unit="mm")

# What many cars may vary, in the order of the columns of a table of deviations.
VARIED = (
    *(BASE_RADIUS, INNER_FACE, OUTER_FACE, ROD_RADIUS, PROFILE_OFFSET, STEERING_ZERO, WHEELBASE, DRIVE_WHEEL_OFFSET),
    *(WHEEL_RADIUS, CAM_PHASE, START_X, START_Y, START_HEADING, RETURN_ERROR, SLIDING_FRICTION, DRAG, ROD_FORCE),
    *(EDGE_BREAK, EDGE_WEAR, TAPER, ROD_HEIGHT, ECCENTRIC_BORE, WOBBLE, STEERING_LOST_MOTION, WHEEL_RUNOUT),
    *(TEMPERATURE, START_GAP, ROD_BENDING, WIND_UP, BEARING_SEATS, *GEAR_ERRORS, SIDE_SLIP),
)
_FIRST = [sum(1 + other.directed for other in VARIED[:number]) for number in range(len(VARIED) + 1)]
_COLUMNS = {each.name: list(range(_FIRST[k], _FIRST[k + 1])) for k, each in enumerate(VARIED)}
# Names of the columns, and units of their values.
COLUMNS = {f"{each.key}{part}": each.unit for each in VARIED for part in (("_0", "_90") if each.directed else ("",))}
_DRAWN_LAST = VARIED[VARIED.index(START_GAP) :]
# What has a half width: all but the return error, which has a band. In this order a seed draws them: sizes with a
# direction after those without, and what came to the catalogue later after both, so that it leaves their numbers alone.
TOLERANCES = tuple(
    sorted(
        (each for each in VARIED if each != RETURN_ERROR), key=lambda each: 2 * (each in _DRAWN_LAST) + each.directed
    )
)
# What a hand sets after a trial run.
SETTABLE = tuple(each for each in VARIED if each.hand and each.hand.limit)
# The same by the part that is set.
SETTINGS = {
    part: tuple(each for each in SETTABLE if each.hand and each.hand.part == part)
    for part in dict.fromkeys(each.hand.part for each in SETTABLE if each.hand)
}
STARTS = (START_X, START_Y, START_HEADING)
# What comes anew in every run, which no trim and no cam takes out.
EACH_RUN = (*STARTS, START_GAP, SIDE_SLIP)


def tolerance(key: str) -> Deviation:
    """Deviation with a tolerance, by its key without the unit.

    Raises:
        DesignError: no tolerance has that key.
    """
    for each in TOLERANCES:
        if each.key == key:
            return each
    raise DesignError(
        "there is no tolerance named {key}; use one of {names}", key=key, names=joined(map(str, TOLERANCES), ", ")
    )
