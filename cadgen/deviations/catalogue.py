"""Effects by the kind of data and the name that they are written under in an as-built design."""

import re
from collections.abc import Mapping
from difflib import get_close_matches

from cadgen.deviations.disc import LAST_LOBE, NOSE_WIDTHS_DEG, PROFILE_EFFECTS, undulation, worn_nose
from cadgen.deviations.effect import Effect
from cadgen.deviations.lift import LIFT_EFFECTS
from cadgen.deviations.names import Kind
from cadgen.deviations.track import TRACK_EFFECTS
from cadgen.deviations.transmission import RATE, RETURN_ERROR, WIND_UP, runout, tooth_mesh
from cadgen.deviations.transmission import SLIDING_FRICTION as TRAIN_FRICTION
from cadgen.deviations.tricycle import TRICYCLE_EFFECTS
from cadgen.errors import DesignError

_EFFECTS: dict[Kind, tuple[Effect, ...]] = {
    "lift": (*LIFT_EFFECTS, worn_nose(0, NOSE_WIDTHS_DEG[0])),
    "profile": (*PROFILE_EFFECTS, worn_nose(0, NOSE_WIDTHS_DEG[0]), undulation(2), undulation(LAST_LOBE + 1)),
    # Orders are those of the train; what is only noted does not need them.
    "transmission": (RETURN_ERROR, TRAIN_FRICTION, RATE, WIND_UP, runout("the camshaft", 1.0), tooth_mesh(1, 1.0)),
    "track": TRACK_EFFECTS,
    "zones": (RETURN_ERROR,),
    "steered track": TRICYCLE_EFFECTS,
}
_ORDER = re.compile(r"(?:lobing|waviness), order (\d{1,3})")
_SHAFT = re.compile(r"runout of (the motor shaft|the camshaft|shaft \d{1,2})")
_STAGE = re.compile(r"tooth mesh of stage (\d{1,2})")


def entries(kind: Kind) -> tuple[Effect, ...]:
    """The effects of a kind of data; one nose, order, shaft and stage stands for all of them."""
    return _EFFECTS[kind]


def named(kind: Kind, name: str, given: Mapping[str, float] | None = None) -> Effect:
    """The effect of a kind of data that is written under a name.

    Args:
        kind: of data.
        name: as it was claimed, such as `steering zero` or `lobing, order 3`.
        given: numbers that belong to the name (see `Effect.given`): `nose_number` of a worn nose, counted from 1 by
            polar angle; the first if left out.

    Raises:
        DesignError: there is no such effect; names the nearest.
    """
    if name == "worn nose" and kind in ("lift", "profile"):
        return worn_nose(int((given or {}).get("nose_number", 1)) - 1, NOSE_WIDTHS_DEG[0])
    for effect in _EFFECTS[kind]:
        if effect.name == name:
            return effect
    if kind == "profile" and (found := _ORDER.fullmatch(name)) and undulation(int(found[1])).name == name:
        return undulation(int(found[1]))
    if kind == "transmission" and (found := _SHAFT.fullmatch(name)):
        return runout(found[1], 1.0)
    if kind == "transmission" and (found := _STAGE.fullmatch(name)):
        return tooth_mesh(int(found[1]), 1.0)
    names = [effect.name for effect in _EFFECTS[kind]]
    near = get_close_matches(name, names, 3, 0.5) or names
    raise DesignError(f'there is no effect "{name}" in data of kind {kind}: write {" or ".join(near)}')
