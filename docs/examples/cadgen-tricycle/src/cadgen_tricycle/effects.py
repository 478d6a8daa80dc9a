"""Effects of a car whose steered and driven front wheel is logged: zero, gain, wheelbase, odometer, lag, markers.

Stages: `STEERING` (angle of the front wheel, rad), `DELAY` (s), `TRAVEL` (mm of the front wheel for each step),
`WHEELBASE` (mm), `MARKER` (place of the markers from the rear axle's centre, as x + iy, mm). `at` are the `Log`.
"""

from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import Effect, Parameter, Rows, Stage


@dataclass(frozen=True, kw_only=True)
class Log(Rows):
    """Log of a run by row, arrays of shape (n,).

    Attributes:
        time: since the run's start, s.
        steering: logged angle, rad.
        travel, turned: of the front wheel and of its steering since the row before, mm and rad.
        distance, speed: of the front wheel, mm and mm/s.
        heading: from that of the start, by the log alone, rad.
        wheel: angle of the front wheel, rad; zeros where its diameter is not known.
        sense: +1 where the steering turned to the left last, -1 to the right, 0 before it turned.
    """

    time: Array
    steering: Array
    travel: Array
    turned: Array
    distance: Array
    speed: Array
    heading: Array
    wheel: Array
    sense: Array


STEERING = Stage[Array]("steering")
DELAY = Stage[float]("delay")
TRAVEL = Stage[Array]("travel")
WHEELBASE = Stage[float]("wheelbase")
MARKER = Stage[complex]("marker")


def _add(value: Array, p: Array, at: Log) -> Array:
    return np.asarray(value + p[0])


def _times(value: Array, p: Array, at: Log) -> Array:
    return np.asarray(value * (1 + p[0]))


def _slip(travel: Array, p: Array, at: Log) -> Array:
    return np.asarray(travel * (1 - p[0] * np.abs(np.sin(at.steering))))


def _marker(place: complex, p: Array, at: Log) -> complex:
    return place + complex(p[0], p[1])


def _percent(name: str, meaning: str, limit: float, usual: float = 1.0) -> Parameter:
    return Parameter(name=name, unit="%", lower=-limit, upper=limit, step=0.05, usual=usual, meaning=meaning)


def _mm(name: str, meaning: str) -> Parameter:
    return Parameter(name=name, unit="mm", lower=-1000.0, upper=1000.0, step=0.2, usual=3.0, meaning=meaning)


def scaled(effects: tuple[Effect, ...], wheelbase: float) -> tuple[Effect, ...]:
    """Effects of a vehicle of a wheelbase, mm, whose markers' offsets are shares of that."""
    limit, usual, step = (share * wheelbase for share in (MARKER_SHARE, _USUAL_SHARE, _STEP_SHARE))
    return tuple(
        replace(
            effect,
            parameters=tuple(replace(p, lower=-limit, upper=limit, usual=usual, step=step) for p in effect.parameters),
        )
        if effect.stage is MARKER
        else effect
        for effect in effects
    )


# Markers sit between the axles or a little beyond the front one.
MARKER_SHARE, _USUAL_SHARE, _STEP_SHARE = 1.25, 0.02, 0.001
ON_THE_SPOT = "turn on the spot with the wheel at 90 degrees: there the rate of turning is the wheelbase's alone"

EFFECTS = (
    Effect(
        name="steering gain",
        stage=STEERING,
        # A log in another scale is off by several or by hundred times; below -100 % its sign is the other one.
        parameters=(
            _percent(
                "gain_percent",
                "+: the wheel turns more than was logged; below -100 %: the other sign of it or of y",
                9900.0,
            ),
        ),
        act=_times,
        confused_with="wheelbase, as long as the wheel turns little",
        separated_by=ON_THE_SPOT,
    ),
    Effect(
        name="steering zero",
        stage=STEERING,
        parameters=(
            Parameter(
                name="steering_zero_deg",
                unit="deg",
                lower=-10.0,
                upper=10.0,
                step=0.01,
                usual=2.0,
                meaning="+: the wheel points further left than was logged",
            ),
        ),
        act=_add,
        twins=("yaw of the axle",),
        separated_by="push the car straight and read the steering",
    ),
    Effect(
        name="wheelbase",
        stage=WHEELBASE,
        parameters=(_percent("wheelbase_percent", "+: longer than said", 30.0, 3.0),),
        act=_times,
        confused_with="steering gain, as long as the wheel turns little",
        separated_by=ON_THE_SPOT,
    ),
    Effect(
        name="wheel radius",
        stage=TRAVEL,
        # An odometer whose counts were taken for other lengths is off by several times.
        parameters=(
            replace(_percent("wheel_radius_percent", "+: the car goes further than was logged", 900.0), lower=-95.0),
        ),
        act=_times,
        twins=("scale of the odometer",),
        separated_by="roll the car ten turns of the wheel along a rule",
    ),
    Effect(
        name="lag of the steering",
        stage=DELAY,
        parameters=(
            Parameter(
                name="lag_s",
                unit="s",
                lower=-1.0,
                upper=3.0,
                step=0.02,
                usual=0.05,
                meaning="+: the wheel turns later than was logged",
            ),
        ),
        act=_add,
        confused_with="a marker ahead of or behind the axle",
        separated_by="repeat at half the speed: a lag in time halves in distance",
    ),
    Effect(
        name="offset of the markers",
        stage=MARKER,
        parameters=(
            _mm("marker_ahead_mm", "+: ahead of the rear axle"),
            _mm("marker_left_mm", "+: left of its middle"),
        ),
        act=_marker,
        confused_with="lag of the steering",
        separated_by="turn on the spot: the markers then draw a circle about the axle's centre",
    ),
    Effect(
        name="slip with steering",
        stage=TRAVEL,
        parameters=(_percent("slip_percent", "+: travel lost, for each unit of |sin(steering)|", 30.0),),
        act=_slip,
        confused_with="wheel radius, wheelbase",
        separated_by="compare the odometer on a straight and on the spot",
    ),
)
