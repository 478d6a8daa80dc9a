"""Formulas for what no effect of the catalogue makes: an input of the vehicle, times what it acts on.

Each is an effect with one number. In what it acts on: turning of the body for each metre of travel or each turn of the
steering, travel, and creep to the left. In its inputs: steering angle, sense in which it turned last, speed, distance,
heading over the floor, and angle of the front wheel.
"""

from collections.abc import Callable

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.deviations.effect import Effect, Parameter, Stage
from cadgen.messages import Message
from cadgen_tricycle.effects import TRAVEL, Log

TURNING = Stage[Array]("turning")
CREEP = Stage[Array]("creep")

# Usual speed of a tricycle, mm/s, and distance of a run, mm: they scale the numbers alone.
SPEED, RUN = 100.0, 10_000.0

INPUTS: dict[str, Callable[[Log], Array]] = {
    "1": lambda at: np.ones_like(at.steering),
    "sin d": lambda at: np.sin(at.steering),
    "|sin d|": lambda at: np.abs(np.sin(at.steering)),
    "sin^2 d": lambda at: np.sin(at.steering) ** 2,
    "sin^3 d": lambda at: np.sin(at.steering) ** 3,
    "sin 2d": lambda at: np.sin(2 * at.steering),
    "cos d": lambda at: np.cos(at.steering),
    "sense": lambda at: at.sense,
    "sense cos d": lambda at: at.sense * np.cos(at.steering),
    "v": lambda at: at.speed / SPEED,
    "v sin d": lambda at: at.speed / SPEED * np.sin(at.steering),
    "v^2 sin d": lambda at: (at.speed / SPEED) ** 2 * np.sin(at.steering),
    "s": lambda at: at.distance / RUN,
    "s sin d": lambda at: at.distance / RUN * np.sin(at.steering),
    "cos psi": lambda at: np.cos(at.heading),
    "sin psi": lambda at: np.sin(at.heading),
    "cos 2psi": lambda at: np.cos(2 * at.heading),
    "sin 2psi": lambda at: np.sin(2 * at.heading),
    "cos w": lambda at: np.cos(at.wheel),
    "sin w": lambda at: np.sin(at.wheel),
}
SYMBOLS = Message(
    "of the formula; d: steering angle; sense: +1 where it turned to the left last, -1 to the right; v: speed over 100 "
    "mm/s; s: distance over 10 m; psi: heading from that of the start; w: angle of the front wheel"
)


def _formula(acts_on: str, stage: Stage[Array], most: float, per: Callable[[Log], Array], symbol: str) -> Effect:
    given = INPUTS[symbol]
    number = Parameter(
        name="formula_deg" if stage is TURNING else "formula_percent",
        unit="deg" if stage is TURNING else "%",
        lower=-most,
        upper=most,
        step=most / 1e4,
        usual=most / 20,
        meaning=SYMBOLS,
    )
    return Effect(
        name=f"{acts_on} ~ {symbol}",
        stage=stage,
        parameters=(number,),
        act=lambda state, p, at: np.asarray(state + p[0] * given(at) * per(at)),
        separated_by="drive a path on which this input goes another way",
    )


# What each number is of, with its greatest size; and the products that the catalogue has by a name.
_ACTS_ON: dict[str, tuple[Stage[Array], float, Callable[[Log], Array]]] = {
    "turning per metre": (TURNING, 90.0, lambda at: at.travel / 1000),
    "turning per quarter turn of the steering": (TURNING, 45.0, lambda at: at.turned / (TURN / 4)),
    "travel": (TRAVEL, 30.0, lambda at: at.travel),
    "creep to the left": (CREEP, 30.0, lambda at: at.travel),
}
_NAMED = {
    "turning per metre": ("sin d", "cos d"),
    "travel": ("1", "|sin d|"),
}
FORMULAS = tuple(
    _formula(acts_on, *of, symbol)
    for acts_on, of in _ACTS_ON.items()
    for symbol in INPUTS
    if symbol not in _NAMED.get(acts_on, ())
)
