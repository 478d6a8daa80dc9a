"""First look at a follower that a kind has built: whether it has each member, of the form that the program asks for.

A kind of the package is tested; one of a plug-in, or one registered in Python, may lack what its author forgot. What a
member says is judged later, where the follower has rolled (`cadgen.cam.formulas`).
"""

import re
from collections.abc import Callable
from inspect import get_annotations

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import Follower
from cadgen.cam.round_follower import RoundFollower
from cadgen.errors import DesignError
from cadgen.laws.unit import Unit
from cadgen.messages import Message, joined

_POINTS = 3  # at which members are asked for values
_SAME = 1e-9  # of the motion's unit
# The end of Python's sentence on a class with abstract members.
_ABSTRACT = re.compile(r"abstract class \w+ with(?:out an implementation for)? abstract methods? (.+)$")


def probed(build: Callable[[], object], code: str, unit: Unit) -> Follower:
    """Follower that a kind builds, or a sentence on what it lacks.

    Args:
        build: function that builds it.
        code: code of the kind.
        unit: unit of the motion by the kind.

    Raises:
        DesignError: it cannot be built, a member is missing, or one has another form than `Follower` says.
    """
    try:
        made = build()
    except TypeError as error:
        # Of a dataclass with other fields than the function of the kind gives, or of a class that is abstract still.
        abstract = _ABSTRACT.search(str(error))
        if abstract is None:
            raise _fault(code, Message("its build fails ({error})", error=str(error))) from error
        raise _fault(code, Message("its follower lacks {members}", members=abstract[1].replace("'", ""))) from error
    if not isinstance(made, Follower):
        raise _fault(
            code, Message("its build gives {found}, and should give a Follower", found=type(made).__qualname__)
        )
    named = {name for each in type(made).__mro__ if issubclass(each, Follower) for name in get_annotations(each)}
    missing = sorted(name for name in named if not hasattr(made, name))
    if missing:
        raise _fault(code, Message("its follower lacks {members}", members=joined(missing)))
    if made.unit != unit:
        raise _fault(
            code,
            Message(
                "the motion of its follower is in {follower}, and that of the kind in {kind}: give both the same unit",
                follower=made.unit.symbol,
                kind=unit.symbol,
            ),
        )
    for member, sound in _FORMS.items():
        try:
            fits = sound(made)
        except Exception as error:
            raise _fault(
                code, Message("{member} fails ({error})", member=member, error=f"{type(error).__name__}: {error}")
            ) from error
        if not fits:
            raise _fault(code, Message("{member} gives something else than Follower says", member=member))
    return made


def _shaped(values: tuple[Array, ...], count: int) -> bool:
    """Whether values are so many arrays of the points asked for, without a nan."""
    return (
        isinstance(values, tuple)
        and len(values) == count
        and all(np.shape(each) == (_POINTS,) and not np.isnan(each).any() for each in values)
    )


def _points(follower: Follower) -> tuple[Array, Array]:
    """Points near the follower at rest."""
    return follower.base_radius - np.linspace(0.0, 1e-3, _POINTS), np.linspace(-1e-3, 1e-3, _POINTS)


def _returns(follower: Follower) -> bool:
    """Whether the motion by a lift is the motion that gives it."""
    q = np.linspace(0.01, 0.02, _POINTS)
    found = follower.of_lift(follower.lift(q))
    return _shaped(found[:2], 2) and len(found) == 3 and bool(np.allclose(found[0], q, rtol=_SAME, atol=_SAME))


_FORMS: dict[str, Callable[[Follower], bool]] = {
    "planes": lambda follower: len(follower.planes) > 0,
    "lift with of_lift": _returns,
    "least": lambda follower: _shaped(follower.least(*_points(follower)), len(follower.planes)),
    "most": lambda follower: _shaped(follower.most(*_points(follower), np.full(_POINTS, 0.1)), len(follower.planes)),
    "sector": lambda follower: len(follower.sector(follower.base_radius / 2, follower.base_radius)) == 2,
    "remedies": lambda follower: isinstance(follower.remedies(), tuple),
    "dimensions": lambda follower: isinstance(follower.dimensions(), tuple),
    "point": lambda follower: (
        isinstance(follower.point(), Follower)
        and (follower.point().radius == 0 or not isinstance(follower, RoundFollower))
    ),
    "outline": lambda follower: np.shape(follower.outline(0.0, follower.planes[0]))[1:] == (2,),
}


def _fault(code: str, what: str) -> DesignError:
    return DesignError(
        'the kind of follower "{code}" cannot be used, for {what}: correct the kind, which is none of the package',
        code=code,
        what=what,
    )
