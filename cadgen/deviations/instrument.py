"""Effects of the instrument, each beside the effect of the part or the car that it looks like.

Two causes that cannot be told apart are one cause under two names, and are cut into no part by default. A gauge ring, a
part that is turned on the machine, a second direction or a second kind of measurement separates them.

Stages: `MACHINE` (points as a measuring machine gave them, shape (n, 2), mm, on the way back to the true ones), those
of a lift. `at` are the rows.
"""

from dataclasses import replace

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.deviation import Place
from cadgen.deviations.disc import ANISOTROPIC_SCALE, CUTTER_COMPENSATION, OUT_OF_SQUARE, UNIFORM_SCALE
from cadgen.deviations.effect import Effect, Group, Parameter, Rows, Stage
from cadgen.deviations.lift import ANGLE, PHASE, RETURN_ERROR
from cadgen.messages import Message

_MACHINE_SCALES = Group("scale of the machine")

MACHINE = Stage[Array]("machine")
_NOTED: tuple[Place, ...] = (Place.NOTED,)
_TURN_IT = "measure again with the part turned by 90 degrees on the machine: what turns with it is the part's"


def _scaled(points: Array, p: Array, at: object) -> Array:
    return np.asarray(points / (1 + p))


STYLUS_RADIUS = replace(
    CUTTER_COMPENSATION,
    name="stylus radius",
    parameters=(
        replace(
            CUTTER_COMPENSATION.parameters[0],
            name="stylus_um",
            usual=5.0,
            meaning="+: the stylus is larger than corrected",
        ),
    ),
    deviation=None,
    places=_NOTED,
    looks_like=CUTTER_COMPENSATION,
    confused_with="cutter compensation",
    separated_by="measure a gauge ring or a gauge block with the same stylus",
)
MACHINE_SCALE = Effect(
    name="scale of the measuring machine",
    stage=MACHINE,
    parameters=(
        replace(UNIFORM_SCALE.parameters[0], name="machine_percent", usual=0.005, meaning="+: it reads too much"),
    ),
    act=_scaled,
    group=_MACHINE_SCALES,
    looks_like=UNIFORM_SCALE,
    confused_with="uniform scale",
    separated_by="measure a gauge block, part and block at 20 degrees Celsius",
)
AXIS_SCALE = Effect(
    name="axis scale of the measuring machine",
    stage=MACHINE,
    parameters=tuple(
        replace(
            p,
            name=f"machine_{axis}_percent",
            usual=0.005,
            meaning=Message("+: it reads too much along {axis}", axis=axis),
        )
        for p, axis in zip(ANISOTROPIC_SCALE.parameters, "xy", strict=True)
    ),
    act=_scaled,
    group=_MACHINE_SCALES,
    includes=MACHINE_SCALE,
    looks_like=ANISOTROPIC_SCALE,
    confused_with="anisotropic scale",
    separated_by=_TURN_IT,
)
SQUARENESS = Effect(
    name="squareness of the measuring machine",
    stage=MACHINE,
    parameters=(
        replace(
            OUT_OF_SQUARE.parameters[0],
            name="machine_square_deg",
            usual=0.003,
            meaning="+: its axes enclose more than 90°",
        ),
    ),
    # A machine whose axes enclose 90 degrees plus p reads x + p y where x is.
    act=lambda points, p, at: np.stack([points[:, 0] - p[0] * points[:, 1], points[:, 1]], axis=1),
    looks_like=OUT_OF_SQUARE,
    confused_with="a part cut by a machine whose axes are out of square",
    separated_by=_TURN_IT,
)
_MOVES_OVER = 0.01  # share of a run within which a part moves in its clamp


def moved_part(when: float) -> Effect:
    """A form without a name: the part moves in its clamp at one place of every run, by p0, p1 in x and y.

    Args:
        when: share of the run from which the place is searched, from its middle, -1/2 to 1/2.
    """

    def act(points: Array, p: Array, at: Rows) -> Array:
        share = (1 + np.tanh((at.elapsed - p[2]) / _MOVES_OVER)) / 2
        return np.asarray(points - share[:, None] * p[:2])

    sizes = (Parameter.of(f"moved_{axis}_um", 500.0, 1.0) for axis in "xy")
    place = Parameter.of("moved_at_percent", 100 * when + 4, 0.2, lower=100 * when - 4, start=100 * when)
    return Effect(
        name=Message("part that moves at {when:.0f} % of each run", when=100 * (when + 0.5)),
        stage=MACHINE,
        parameters=(*sizes, place),
        act=act,
        shape=True,
        member=True,
        separated_by="clamp the part anew, and measure its first points again at the end",
    )


# The scale of the machine grows by p0 over each run.
WARMING = Effect(
    name="measuring machine that warms up",
    stage=MACHINE,
    parameters=(Parameter.of("warming_percent", 2.0, 0.002),),
    act=lambda points, p, at: np.asarray(points / (1 + at.elapsed[:, None] * p)),
    shape=True,
    member=True,
    separated_by="measure the part's first points again at the end",
)


DIVIDER_ZERO = replace(
    PHASE,
    name="zero of the divider",
    parameters=(Parameter.of("divider_deg", 5.0, 0.05, 0.2, "+: it stands ahead of its mark"),),
    deviation=None,
    places=_NOTED,
    looks_like=PHASE,
    confused_with="phase",
)


LAST_INDEX = 4  # an ellipse makes two, and the jaws that hold a divider three or four


def index_error(order: int) -> Effect:
    """Error of the divider that repeats so many times a turn: the angle is off by p0 cos(n theta) + p1 sin(n theta)."""
    once = order == 1

    def ahead(part: str, at: str) -> Message:
        return Message("+: ahead at {at}", at=at) if once else Message("+: ahead where {part}(n theta) = 1", part=part)

    return Effect(
        name="index error" if once else Message("index error, order {order}", order=order),
        stage=ANGLE,
        parameters=tuple(
            Parameter.of(f"index_{part}_deg", 2.0, 0.02, 0.02, ahead(part, at))
            for part, at in (("cos", "0°"), ("sin", "90°"))
        ),
        act=lambda angle, p, at: np.asarray(angle + p[0] * np.cos(order * at.place) + p[1] * np.sin(order * at.place)),
        cause="" if once else "index error",
        member=not once,
        confused_with="an eccentric bore" if once else "lobing of the disc",
        separated_by="turn the divider by half a turn on the shaft and measure again"
        if once
        else "turn the divider on the shaft, by half of what the error repeats in, and measure again",
    )


INDEX_ERROR = index_error(1)
READING_LAG = replace(
    RETURN_ERROR,
    name="lag of the reading",
    parameters=(
        replace(
            RETURN_ERROR.parameters[0],
            name="reading_lag_deg",
            usual=0.02,
            meaning="by which it lags, half of it either way",
        ),
    ),
    deviation=None,
    places=_NOTED,
    looks_like=RETURN_ERROR,
    confused_with="backlash",
    separated_by="measure at half the speed, or standing still: a lag follows the speed",
)

PROFILE_INSTRUMENT = (STYLUS_RADIUS, MACHINE_SCALE, AXIS_SCALE, SQUARENESS)
LIFT_INSTRUMENT = (DIVIDER_ZERO, INDEX_ERROR, READING_LAG)
