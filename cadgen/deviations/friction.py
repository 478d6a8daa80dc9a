"""Common parts of the effects of sliding friction in tracks and in transmissions."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from cadgen.arrays import Array
from cadgen.deviations.effect import Effect, Parameter

# At which a search begins. The play is found about each in proportion; between two of them the exact fit finds its way.
FRICTIONS = (0.1, 0.2, 0.3, 0.4, 0.5)
# A ball bearing with its seals holds the cam by less than this, a rod that slides by more.
NO_FRICTION = 0.03
DRAG = ("drag on the camshaft",)
MEASURE_FRICTION = (
    "measure the play with the rod lifted off the disc, where no friction holds the cam; and, the rod still lifted, "
    "pull the disc round by a thread on its rim over a spring balance: that pull times the rim's radius is the drag"
)


def friction(step: float) -> Parameter:
    """The number, with a step for differences.

    Args:
        step: step for differences, a ratio.
    """
    return Parameter(
        name="friction",
        unit="",
        lower=0.0,
        upper=1.0,
        step=step,
        meaning="of the rod on the disc in sliding; it holds the cam on the gentler parts of a fall",
    )


def rubbing(play: Effect, friction: Effect, act: Callable[[Any, Array, Any], Any], start: float) -> Effect:
    """Play and friction as one, for a search to begin from: at no play friction does nothing that could be seen.

    Args:
        play, friction: effects that it stands for.
        act: function by which both act together.
        start: coefficient of friction to begin from.
    """
    (number,) = friction.parameters
    return Effect(
        name=f"{play.name} with {friction.name}",
        stage=play.stage,
        parameters=(*play.parameters, replace(number, start=start)),
        act=act,
        group=play.group,
        variant=f"from {start:g}",
        numerous=True,
        separated_by=friction.separated_by,
        parts=(play, friction),
    )
