"""Return error of the gears and the friction that acts beside it, as several kinds of data show them.

Friction and drag hold the cam on the gentler parts of each fall, where it would else run ahead by the return error.
They do nothing without it, and act beside it.
"""

from dataclasses import replace

from cadgen.deviations.effect import Effect, Parameter
from cadgen.messages import Message

# At which a search begins. The play is found about each in proportion; between two of them the exact fit finds its way.
FRICTIONS = (0.1, 0.2, 0.3, 0.4, 0.5)
# A ball bearing with its seals holds the cam by less than this, a rod that slides by more.
NO_FRICTION = 0.03
DRAG = ("drag on the camshaft",)
MEASURE_FRICTION = (
    "measure the play with the rod lifted off the disc, where no friction holds the cam; and, the rod still lifted, "
    "pull the disc round by a thread on its rim over a spring balance: that pull times the rim's radius is the drag"
)


def return_error(meaning: str, upper: float, step: float) -> Parameter:
    """Parameter of the return error.

    Args:
        meaning: meaning of the number.
        upper: greatest return error, degrees.
        step: step for differences, degrees.
    """
    return Parameter(name="return_error_deg", unit="deg", lower=0.0, upper=upper, step=step, usual=0.2, meaning=meaning)


def friction(step: float, *, stepwise: bool = False) -> Parameter:
    """Parameter of the sliding friction.

    Args:
        step: step for differences, a ratio.
        stepwise: whether the expected readings change in steps.
    """
    return Parameter(
        name="friction",
        unit="",
        lower=0.0,
        upper=1.0,
        step=step,
        usual=0.06,
        stepwise=stepwise,
        meaning="of the rod on the disc in sliding; it holds the cam on the gentler parts of a fall",
    )


def rubbing(play: Effect, friction: Effect, start: float) -> Effect:
    """Return error and friction as one effect to begin a search from: without play friction shows nothing.

    Args:
        play, friction: effects that it stands for.
        start: coefficient of friction to begin from.
    """
    (number,) = friction.parameters
    return Effect(
        name=Message("{play} with {friction}", play=Message(play.name), friction=Message(friction.name)),
        stage=play.stage,
        parameters=(*play.parameters, replace(number, start=start)),
        act=lambda state, p, at: friction.act(play.act(state, p[:1], at), p[1:], at),
        group=play.group,
        variant=f"from {start:g}",
        member=True,
        separated_by=friction.separated_by,
        parts=(play, friction),
    )
