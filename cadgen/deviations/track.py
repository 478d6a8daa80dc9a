"""Effects of the car that a cam steers, as its track shows them.

Stages: `RUNNING` (the `Running` car: its numbers, play, friction and the cam's seat), `STEERING` (tangent of the front
wheel's angle at motor positions). `at` are the motor positions of the stations, rad.

A gain of the lever and an error of the wheelbase turn every curvature into the same other one,
-(1 + g) T / (L + A1 (1 + g) T) = -T / (L / (1 + g) + A1 T), so no track can tell them apart; nor, but for a second
order in the angle, a yaw of the rear axle from a steering zero. A tyre whose side force comes up over a distance of
travel follows the steering by that distance late, and so does a car whose cam stands behind.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.running.drive import Running
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.deviations.disc import ECCENTRIC_BORE
from cadgen.deviations.effect import Effect, Group, Parameter, Stage
from cadgen.deviations.return_error import DRAG, FRICTIONS, MEASURE_FRICTION, friction, return_error, rubbing
from cadgen.messages import Message

RUNNING = Stage[Running]("running")
STEERING = Stage[Array]("steering")


RETURN_ERROR = Effect(
    name="backlash",
    stage=RUNNING,
    parameters=(return_error("whole play at the camshaft, between two stops", 4.0, 0.02),),
    act=lambda run, p, at: replace(run, play=float(p[0])),
    deviation=deviation.RETURN_ERROR,
    places=(Place.CAR,),
    group=Group("play"),
    confused_with="cam phase, steering zero",
    separated_by="hold the motor and turn the camshaft to and fro: an inclinometer shows the play",
)
SLIDING_FRICTION = Effect(
    name="sliding friction",
    stage=RUNNING,
    parameters=(friction(step=0.002),),
    act=lambda run, p, at: replace(run, friction=float(p[0])),
    deviation=deviation.SLIDING_FRICTION,
    places=(Place.CAR,),
    beside=RETURN_ERROR,
    twins=DRAG,
    confused_with="less play",
    separated_by=MEASURE_FRICTION,
)

# A track shows the disc by what it does to the run.
ECCENTRIC = replace(
    ECCENTRIC_BORE,
    places=(Place.CAR, Place.PART, Place.PROCESS),
    twins=("run-out of the shaft",),
    confused_with="other errors of the disc",
    separated_by="measure the lift by a dial, or the profile about the bore on a CMM",
)

TRACK_EFFECTS = (
    Effect(
        name="steering zero",
        stage=RUNNING,
        parameters=(
            Parameter.of("steering_zero_deg", 5.0, 0.005, 0.05, "+: the wheel points right where the rod is straight"),
        ),
        act=lambda run, p, at: replace(run, car=replace(run.car, steering_zero=run.car.steering_zero + float(p[0]))),
        deviation=deviation.STEERING_ZERO,
        places=(Place.CAR,),
        twins=("yaw of the axle",),
        confused_with="yaw of the rear axle, a dial or micrometer head set to another base distance",
        separated_by="push the car straight with the lever locked at zero and see where it goes",
    ),
    Effect(
        name="lever gain",
        stage=RUNNING,
        parameters=(
            Parameter.of("gain_percent", 20.0, 0.05, 0.3, "+: the wheel turns more than the rod, in its tangent"),
        ),
        act=lambda run, p, at: replace(
            run, car=replace(run.car, steering_gain=run.car.steering_gain * (1 + float(p[0])))
        ),
        deviation=deviation.WHEELBASE,
        places=(Place.CAR,),
        twins=("wheelbase",),
        confused_with="wheelbase",
        separated_by="measure the wheelbase, or the lift by a dial",
    ),
    Effect(
        name="wheel radius",
        stage=RUNNING,
        parameters=(
            Parameter.of("wheel_radius_percent", 10.0, 0.02, 0.2, "+: the car goes too far for a turn of the cam"),
        ),
        act=lambda run, p, at: replace(run, length=run.length * (1 + p[0])),
        deviation=deviation.WHEEL_RADIUS,
        places=(Place.CAR,),
        twins=("ratio of cam and wheel",),
        confused_with="wrong ratio between cam and wheel",
        separated_by="roll the car ten turns of the wheel along a rule",
    ),
    Effect(
        name="driven wheel's offset",
        stage=RUNNING,
        parameters=(
            Parameter.of(
                "drive_wheel_offset_mm", 30.0, 0.1, 0.3, "+: the driven wheel stands further left of the fork axis"
            ),
        ),
        act=lambda run, p, at: replace(run, car=replace(run.car, drive_wheel_offset=run.car.drive_wheel_offset + p[0])),
        deviation=deviation.DRIVE_WHEEL_OFFSET,
        places=(Place.CAR,),
        confused_with="lever gain where the turns all go one way",
        separated_by="measure from the fork axis to the middle of the tyre",
    ),
    Effect(
        name="slip with curvature",
        stage=RUNNING,
        parameters=(
            Parameter.of("slip_percent", 50.0, 0.2, 1.0, "+: travel lost, for each unit of |tan(beta)|", lower=-20.0),
        ),
        act=lambda run, p, at: replace(run, car=replace(run.car, slip=float(p[0]))),
        places=(Place.CAR,),
        confused_with="wheel radius",
        separated_by="run a long straight and a tight circle, each by the turns of the wheel",
    ),
    Effect(
        name="cam phase",
        stage=RUNNING,
        parameters=(Parameter.of("phase_deg", 10.0, 0.02, 0.2, "+: the cam stands ahead, in its sense of turning"),),
        act=lambda run, p, at: replace(run, phase=run.phase + float(p[0])),
        deviation=deviation.CAM_PHASE,
        places=(Place.CAR,),
        twins=("a tyre that follows the steering late",),
        confused_with="backlash",
        separated_by="mark the keyway and the rod's place at the start",
    ),
    RETURN_ERROR,
    SLIDING_FRICTION,
    ECCENTRIC,
)


def steering_bump(centre_deg: float, width_deg: float) -> Effect:
    """A form without a name: the steering is off over a part of the turn.

    Args:
        centre_deg: middle of the part, degrees of the cam angle.
        width_deg: half-width, degrees.
    """

    def act(steering: Array, p: Array, at: Array) -> Array:
        off = (at - np.radians(centre_deg) + np.pi) % TURN - np.pi
        return np.asarray(steering + p[0] * np.exp(-((off / np.radians(width_deg)) ** 2) / 2))

    return Effect(
        name=Message(
            "steering off near {centre_deg:.0f} deg over {width_deg:.0f} deg",
            centre_deg=centre_deg,
            width_deg=width_deg,
        ),
        stage=STEERING,
        parameters=(Parameter.of("steering_bump_percent", 20.0, 0.02),),
        act=act,
        shape=True,
        member=True,
        separated_by="measure the lift there",
    )


def _form(name: str, act: Callable[[Array, Array, Array], Array], unit: str, limit: float) -> Effect:
    """A form without a name that runs through the whole turn."""
    number = Parameter.of(f"{name.split()[-1]}_{_ENDS[unit]}", limit, limit / 1e3)
    return Effect(
        name=name,
        stage=STEERING,
        parameters=(number,),
        act=act,
        shape=True,
        member=True,
        separated_by="look at the linkage, and drive the same path twice on end",
    )


def _on_one_flank(tan: Array, p: Array, at: Array) -> Array:
    """Steering's tangent that is off by a constant while it grows."""
    return np.asarray(tan + p[0] * (np.gradient(tan.ravel()) > 0).reshape(tan.shape))


_ENDS = {"deg": "deg", "%": "percent"}
# What a linkage that gives, a wheel that slides, a zero that wanders and an edge worn on one side make of the tangent.
_OF_STEERING = (
    _form("steering that drifts", lambda tan, p, at: np.asarray(tan + p[0] * at / TURN), "deg", 5.0),
    _form("steering that bends", lambda tan, p, at: np.asarray(tan + p[0] * np.abs(tan)), "%", 30.0),
    _form("steering off on one flank", _on_one_flank, "deg", 5.0),
    _form("steering that fades", lambda tan, p, at: np.asarray(tan * (1 - p[0] * tan**2)), "%", 300.0),
)
# Forms with one number that run through the whole turn; the last is of a wheel that shrinks.
SMOOTH_FORMS = (
    *_OF_STEERING,
    replace(
        _OF_STEERING[0],
        name="travel that fades",
        stage=RUNNING,
        parameters=(Parameter.of("fades_percent", 20.0, 0.05),),
        act=lambda run, p, at: replace(run, wear=run.wear + float(p[0])),
    ),
)


def track_forms() -> tuple[Effect, ...]:
    """Play at several frictions for a search to begin from, and the local forms that compete."""
    bumps = [steering_bump(c, w) for w in (5.0, 15.0) for c in np.arange(w / 2, 360.0, w)]
    return (
        *(rubbing(RETURN_ERROR, SLIDING_FRICTION, mu) for mu in FRICTIONS),
        *SMOOTH_FORMS,
        *bumps,
    )
