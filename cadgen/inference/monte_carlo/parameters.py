"""Quantities in which cars may differ: names, units, and their columns in a table of deviations."""

from enum import StrEnum

from cadgen.errors import DesignError


class Parameter(StrEnum):
    """A quantity that may deviate. The order is that of the columns of a table of deviations."""

    BASE_RADIUS = "base_radius"  # a, camshaft to fork axis
    INNER_FACE = "inner_face"  # of the disc from the fork axis
    OUTER_FACE = "outer_face"
    ROD_RADIUS = "rod_radius"
    PROFILE_OFFSET = "profile_offset"  # the disc cut too large all round, along its normal
    STEERING_ZERO = "steering_zero"  # of the front wheel against the rod
    WHEELBASE = "wheelbase"
    DRIVE_WHEEL_OFFSET = "drive_wheel_offset"
    WHEEL_RADIUS = "wheel_radius"  # of the drive wheel: it scales the travel
    CAM_PHASE = "cam_phase"  # the cam set ahead on its shaft, or the run started late
    START_X = "start_x"
    START_Y = "start_y"
    START_HEADING = "start_heading"
    PLAY = "play"  # B, added to the nominal one
    FRICTION = "friction"  # sliding, between rod and disc
    DRAG = "drag"  # on the disc or its shaft
    ROD_FORCE = "rod_force"  # at zero lift
    EDGE_BREAK = "edge_break"  # leg of the chamfer on both edges of the rim
    EDGE_WEAR = "edge_wear"  # what the rod wears off both edges, as a chamfer would
    TAPER = "taper"  # by which the outer face is cut larger than the inner one
    ROD_HEIGHT = "rod_height"  # of the rod's axis over the camshaft's plane
    ECCENTRICITY_0 = "eccentricity_0"  # of the disc on its shaft, towards its polar angles 0 and 90 degrees
    ECCENTRICITY_90 = "eccentricity_90"
    WOBBLE_0 = "wobble_0"  # of the disc, tilted towards these
    WOBBLE_90 = "wobble_90"
    STEERING_LOST_MOTION = "steering_lost_motion"  # of the front wheel against the rod
    WHEEL_RUNOUT_0 = (
        "wheel_runout_0"  # eccentricity of the drive wheel, towards the ground at the start and a quarter turn on
    )
    WHEEL_RUNOUT_90 = "wheel_runout_90"
    TEMPERATURE = "temperature"

    @property
    def column(self) -> int:
        """Number of its column."""
        return COLUMN[self]

    @property
    def unit(self) -> str:
        """Unit of its deviations: `mm`, `rad`, `N`, `Nmm`, `K`, or `1` for a ratio."""
        return PARAMETERS[self]


class Directed(StrEnum):
    """A deviation drawn as a size and a direction: half a width stands for both."""

    ECCENTRICITY = "eccentricity"
    WOBBLE = "wobble"
    WHEEL_RUNOUT = "wheel_runout"

    @property
    def parts(self) -> tuple[Parameter, Parameter]:
        """Its parts, towards 0 and 90 degrees."""
        return Parameter(f"{self}_0"), Parameter(f"{self}_90")

    @property
    def unit(self) -> str:
        """Unit of its size."""
        return self.parts[0].unit


# Quantities with their units.
PARAMETERS: dict[Parameter, str] = {
    Parameter.BASE_RADIUS: "mm",
    Parameter.INNER_FACE: "mm",
    Parameter.OUTER_FACE: "mm",
    Parameter.ROD_RADIUS: "mm",
    Parameter.PROFILE_OFFSET: "mm",
    Parameter.STEERING_ZERO: "rad",
    Parameter.WHEELBASE: "mm",
    Parameter.DRIVE_WHEEL_OFFSET: "mm",
    Parameter.WHEEL_RADIUS: "mm",
    Parameter.CAM_PHASE: "rad",
    Parameter.START_X: "mm",
    Parameter.START_Y: "mm",
    Parameter.START_HEADING: "rad",
    Parameter.PLAY: "rad",
    Parameter.FRICTION: "1",
    Parameter.DRAG: "Nmm",
    Parameter.ROD_FORCE: "N",
    Parameter.EDGE_BREAK: "mm",
    Parameter.EDGE_WEAR: "mm",
    Parameter.TAPER: "mm",
    Parameter.ROD_HEIGHT: "mm",
    Parameter.ECCENTRICITY_0: "mm",
    Parameter.ECCENTRICITY_90: "mm",
    Parameter.WOBBLE_0: "rad",
    Parameter.WOBBLE_90: "rad",
    Parameter.STEERING_LOST_MOTION: "rad",
    Parameter.WHEEL_RUNOUT_0: "mm",
    Parameter.WHEEL_RUNOUT_90: "mm",
    Parameter.TEMPERATURE: "K",
}
COLUMN = {parameter: number for number, parameter in enumerate(PARAMETERS)}
Tolerance = Parameter | Directed
TOLERANCES: tuple[Tolerance, ...] = (
    *(
        parameter
        for parameter in Parameter
        if parameter != Parameter.PLAY and not any(parameter in directed.parts for directed in Directed)
    ),
    *Directed,
)


_TOLERANCE_OF = {tolerance.value: tolerance for tolerance in TOLERANCES}


def tolerance(name: str) -> Tolerance:
    """Tolerance of a name.

    Args:
        name: one of the words of `TOLERANCES`.

    Raises:
        DesignError: there is no such tolerance.
    """
    if name not in _TOLERANCE_OF:
        raise DesignError(f"there is no tolerance named {name}; use one of {', '.join(TOLERANCES)}")
    return _TOLERANCE_OF[name]


def parts_of(name: Tolerance) -> tuple[Parameter, ...]:
    """Parameters that a tolerance acts on."""
    return name.parts if isinstance(name, Directed) else (name,)
