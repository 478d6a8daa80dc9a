"""Effects of the train between motor and camshaft, and of the encoders at its ends.

Stages: `DELAY` (rows by which the camshaft is read later than the motor), `RATIO` and `MESH` (angle that the gears ask
of the camshaft), `PLAY` (what the camshaft makes of it). `at` are the `Turns`.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.deviations.effect import Effect, Group, Parameter, Rows, Stage
from cadgen.deviations.return_error import DRAG, FRICTIONS, MEASURE_FRICTION, friction, return_error, rubbing
from cadgen.messages import Message


@dataclass(frozen=True, kw_only=True)
class Turned:
    """Where effects of the train act, shape (n,) each.

    Attributes:
        turned: angle of the motor divided by the nominal ratio, rad.
        torque: that the cam asks of its shaft, relative to its greatest.
    """

    turned: Array
    torque: Array


@dataclass(frozen=True, kw_only=True)
class Turns(Turned, Rows):
    """Nominal state at each reading."""


@dataclass(frozen=True)
class Play:
    """Play between the last gear and the camshaft, and the friction that acts on it.

    Attributes:
        width: of the play, rad.
        friction: between rod and disc; None with the rod lifted, or where friction holds the cam everywhere.
    """

    width: float = 0.0
    friction: float | None = None


RATIO = Stage[Array]("ratio")
MESH = Stage[Array]("mesh")
PLAY = Stage[Play]("play")
DELAY = Stage[float]("delay")


def _deg(name: str, meaning: str, limit: float, usual: float) -> Parameter:
    return Parameter(name=name, unit="deg", lower=-limit, upper=limit, step=limit / 200, usual=usual, meaning=meaning)


def _periodic(order: float) -> Callable[[Array, Array, Turned], Array]:
    def act(angle: Array, p: Array, at: Turned) -> Array:
        return np.asarray(angle + p[0] * np.cos(order * at.turned) + p[1] * np.sin(order * at.turned))

    return act


RETURN_ERROR = Effect(
    name="return error",
    stage=PLAY,
    parameters=(return_error("whole play at the camshaft, between two stops", 5.0, 0.025),),
    act=lambda play, p, at: replace(play, width=float(p[0])),
    deviation=deviation.RETURN_ERROR,
    places=(Place.CAR,),
    group=Group("play"),
    twins=("wind-up under friction", "lag at one speed"),
    confused_with="lag of an encoder, twist of the shafts under friction",
    separated_by="measure at two speeds and with a weight on the rod: lag follows the speed, twist the torque",
)
SLIDING_FRICTION = Effect(
    name="sliding friction",
    stage=PLAY,
    parameters=(friction(step=0.02, stepwise=True),),
    act=lambda play, p, at: replace(play, friction=float(p[0])),
    deviation=deviation.SLIDING_FRICTION,
    places=(Place.CAR,),
    beside=RETURN_ERROR,
    twins=DRAG,
    confused_with="a lifted rod, where it is large",
    separated_by=MEASURE_FRICTION,
)
RATE = Effect(
    name="rate",
    stage=RATIO,
    parameters=(Parameter.of("rate_percent", 20.0, 0.05, 0.01, "+: the camshaft turns too far for the motor"),),
    act=lambda angle, p, at: np.asarray(angle * (1 + p[0])),
    twins=("wrong gear ratio", "scale of an encoder"),
    confused_with="a gear with one tooth more or less, an encoder with another count",
    separated_by="count the teeth; turn the motor by hand once past a mark and read its encoder",
)
WIND_UP = Effect(
    name="wind-up",
    stage=MESH,
    parameters=(
        _deg(
            "wind_up_deg",
            "+: the camshaft lags on rises and leads on falls, by so much where the lift is steepest in the whole turn",
            5.0,
            0.03,
        ),
    ),
    act=lambda angle, p, at: np.asarray(angle - p[0] * at.torque),
    places=(Place.NOTED, Place.CAR),
    confused_with="runout of the camshaft",
    separated_by="lift the rod off the cam and measure again",
)


ENCODER_LAG = Effect(
    name="lag of the encoder",
    stage=DELAY,
    parameters=(
        Parameter(
            name="lag_rows",
            unit="",
            lower=-20.0,
            upper=20.0,
            step=0.02,
            usual=0.2,
            meaning="+: rows by which the camshaft is read later than the motor",
        ),
    ),
    act=lambda late, p, at: late + float(p[0]),
    looks_like=RETURN_ERROR,
    confused_with="return error, at one speed",
    separated_by="measure at two speeds: a lag follows the speed",
)


def runout(shaft: str, order: float) -> Effect:
    """A gear (or encoder disc) off centre on a shaft that turns `order` times for one turn of the cam.

    A weight w that turns with the camshaft, as an arm does, twists a train of stiffness k by (w / k) sin(angle). To
    every reading that is a runout of the camshaft.

    Args:
        shaft: name of the shaft.
        order: turns of the shaft for one turn of the cam.
    """
    encoder = Message("eccentric encoder on {shaft}", shaft=Message(shaft))
    twins: tuple[str, ...] = (encoder,)
    apart = "put a dial on the gear's rim, or turn the encoder on its shaft and measure again"
    if order == 1:
        twins = (*twins, Message("twist under a weight that turns with the camshaft"))
        apart = "put a dial on the gear's rim; turn the encoder, or set the shaft upright, and measure again"
    return Effect(
        name=Message("runout of {shaft}", shaft=Message(shaft)),
        stage=MESH,
        parameters=(
            _deg("runout_cos_deg", "+: the camshaft is ahead where that shaft has turned by 0°", 5.0, 0.03),
            _deg("runout_sin_deg", "+: where it has turned by 90°", 5.0, 0.03),
        ),
        act=_periodic(order),
        # Of a whole order it repeats with every turn of the cam, and a cam may take it out.
        places=(Place.NOTED, Place.CAR),
        indices=(("turns_per_turn", order),),
        twins=twins,
        confused_with="an eccentric encoder on the same shaft",
        separated_by=apart,
    )


def eccentric_encoder(shaft: str, order: float) -> Effect:
    """An encoder off centre on a shaft: its readings are those of a runout, and the car does not move by it.

    Args:
        shaft, order: as of `runout`.
    """
    gear = runout(shaft, order)
    return replace(
        gear,
        name=gear.twins[0],
        parameters=(
            _deg("encoder_cos_deg", "+: the camshaft is read ahead where that shaft has turned by 0°", 5.0, 0.03),
            _deg("encoder_sin_deg", "+: where it has turned by 90°", 5.0, 0.03),
        ),
        places=(Place.NOTED,),
        looks_like=gear,
        twins=(),
        confused_with="a gear off centre on the same shaft",
        separated_by="turn the encoder on its shaft and measure again; or measure the track, which it leaves alone",
    )


def tooth_mesh(stage: int, order: float) -> Effect:
    """Once for each tooth of a stage: pitch and profile errors that all teeth share.

    Args:
        stage: number of the stage, counted from 1.
        order: teeth that mesh in one turn of the cam.
    """
    return Effect(
        name=Message("tooth mesh of stage {stage}", stage=stage),
        stage=MESH,
        parameters=(
            _deg("mesh_cos_deg", "+: the camshaft is ahead at the start of each tooth", 2.0, 0.01),
            _deg("mesh_sin_deg", "+: a quarter of a tooth later", 2.0, 0.01),
        ),
        act=_periodic(order),
        confused_with="a count error of the encoder at the same order",
        separated_by="shift the wheel by half a tooth on its shaft and measure again",
    )


TRAIN_EFFECTS = (RETURN_ERROR, SLIDING_FRICTION, RATE, WIND_UP, ENCODER_LAG)


def train_orders(ratios: tuple[float, ...], teeth: tuple[int, ...], highest: int) -> tuple[Effect, ...]:
    """Effects of a train that repeat with its shafts and teeth, and play at several frictions to begin from.

    Args:
        ratios: of each stage, from the motor to the camshaft.
        teeth: of each stage's driven wheel; empty if unknown.
        highest: order that the data resolve.
    """
    # Rounded, so that a whole order is whole.
    orders = [round(float(np.prod(ratios[k:])), 9) for k in range(len(ratios) + 1)]
    names = ["the motor shaft", *(Message("shaft {number}", number=k) for k in range(1, len(ratios))), "the camshaft"]
    effects = [rubbing(RETURN_ERROR, SLIDING_FRICTION, start) for start in (0.0, *FRICTIONS)]
    effects += [
        make(n, o) for make in (runout, eccentric_encoder) for n, o in zip(names, orders, strict=True) if o <= highest
    ]
    meshes = [(k + 1, z * orders[k + 1]) for k, z in enumerate(teeth)]
    return tuple(effects + [tooth_mesh(stage, order) for stage, order in meshes if order <= highest])
