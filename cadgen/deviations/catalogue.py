"""The effects that are looked for in each kind of data, from the tables of the files beside this one.

A new effect stands in the file of what it acts on, and its name in the tuple at the end of that file: `LIFT_EFFECTS`
in `lift`, `PROFILE_EFFECTS` in `disc`, `TRAIN_EFFECTS` in `transmission`, `TRACK_EFFECTS` in `track`, or those of
instruments in `instrument`. It may also be registered, or come from a plug-in. Nothing is changed here.

A name is unique in its catalogue; it is what verdicts claim and as-built designs write.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from cadgen.deviations.camera import CAMERA_EFFECTS
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.disc import LAST_LOBE, NOSE_WIDTHS_DEG, PROFILE_EFFECTS, undulation, worn_nose
from cadgen.deviations.effect import Effect, Quantity
from cadgen.deviations.instrument import LAST_INDEX, LIFT_INSTRUMENT, PROFILE_INSTRUMENT, index_error
from cadgen.deviations.lift import LIFT_EFFECTS
from cadgen.deviations.track import TRACK_EFFECTS
from cadgen.deviations.transmission import RETURN_ERROR, TRAIN_EFFECTS, eccentric_encoder, runout, tooth_mesh
from cadgen.messages import Message
from cadgen.registry import load_plugins, used


@dataclass(frozen=True)
class Family:
    """Effects of which there are many, one for each order, nose, shaft or stage, or that are not always looked for.

    Attributes:
        examples: effects that stand for all of them on the page of effects.
        pattern: regular expression of their names.
        member: function of a matched name and the numbers with it that returns the effect; one of another name is none.
    """

    examples: tuple[Effect, ...]
    pattern: re.Pattern[str]
    member: Callable[[re.Match[str], Mapping[str, float]], Effect]


class Catalogue:
    """The effects of one kind of data.

    Attributes:
        families: families of effects; the forward model adds the members that its data resolve.
        formulas: effects that are proposed for what has no name, and not looked for until a user accepts one.
    """

    def __init__(self, *effects: Effect, families: tuple[Family, ...] = (), formulas: tuple[Effect, ...] = ()) -> None:
        self._effects: list[Effect] = []
        self.families = families
        self.formulas = formulas
        for effect in effects:
            self.register(effect)

    @property
    def effects(self) -> tuple[Effect, ...]:
        """Effects that are no members of a family, in the order in which they are tried."""
        _look_for_plugins()
        return tuple(map(used, self._effects))

    @property
    def entries(self) -> tuple[Effect, ...]:
        """Effects, and the examples of the families."""
        return (*self.effects, *(example for family in self.families for example in family.examples))

    def register(self, effect: Effect) -> None:
        """Add an effect, which is then looked for, claimed, written and read back like any other.

        Raises:
            ValueError: an effect of that name exists.
        """
        if self._named(effect.name, {}) is not None:
            raise ValueError(Message('there is an effect "{name}" already: give another name', name=effect.name))
        self._effects.append(effect)

    def remove(self, effect: Effect) -> None:
        """Take a registered effect out again."""
        self._effects.remove(effect)

    def named(self, name: str, indices: Mapping[str, float] | None = None) -> Effect | None:
        """The effect that is written under a name; None if there is none.

        Args:
            name: as it was claimed, such as `steering zero` or `lobing, order 3`.
            indices: numbers that belong to the name (`Effect.indices`): `nose_number` of a worn nose, counted from 1
                by polar angle; the first if left out.
        """
        known = self._named(name, indices or {})
        if known is None:
            _look_for_plugins()
            known = self._named(name, indices or {})
        effect: Effect | None = used(known)
        return effect

    def _named(self, name: str, indices: Mapping[str, float]) -> Effect | None:
        for effect in (*self._effects, *self.formulas):
            if effect.name == name:
                return effect
        matched = ((family, family.pattern.fullmatch(name)) for family in self.families)
        members = (family.member(match, indices) for family, match in matched if match)
        return next((effect for effect in members if effect.name == name), None)


@dataclass(frozen=True)
class EffectOf:
    """Effect that a plug-in brings for data of a kind of the package, by an entry point in `cadgen.effects`.

    Attributes:
        catalogue: one of the catalogues below, such as `TRACK`.
        effect: effect that is then looked for in such data.
    """

    catalogue: Catalogue
    effect: Effect


_looked_for: set[str] = set()  # groups whose plug-ins are in the catalogues


def _look_for_plugins() -> None:
    group = "cadgen.effects"
    if group not in _looked_for:
        _looked_for.add(group)
        load_plugins(group, EffectOf, lambda brought: brought.catalogue.register(brought.effect))


def _of_shafts(make: Callable[[str, float], Effect], words: str) -> Family:
    """Effects of one sort, one for each shaft of a train: its order stands in the indices."""

    def member(match: re.Match[str], indices: Mapping[str, float]) -> Effect:
        shaft = Message("shaft {number}", number=int(match[2])) if match[2] else match[1]
        return make(shaft, float(indices.get("turns_per_turn", 1.0)))

    pattern = re.compile(rf"{words} (the motor shaft|the camshaft|shaft (\d{{1,2}}))")
    return Family((make("the camshaft", 1.0),), pattern, member)


_NOSES = Family(
    (worn_nose(0, NOSE_WIDTHS_DEG[0]),),
    re.compile(r"worn nose"),
    lambda match, indices: worn_nose(int(indices.get("nose_number", 1)) - 1, NOSE_WIDTHS_DEG[0]),
)
_UNDULATIONS = Family(
    (undulation(2), undulation(LAST_LOBE + 1)),
    re.compile(r"(?:lobing|waviness), order (\d{1,3})"),
    lambda match, indices: undulation(int(match[1])),
)
# Orders are those of the train; what is only noted does not need them.
_RUNOUTS = _of_shafts(runout, "runout of")
_ENCODERS = _of_shafts(eccentric_encoder, "eccentric encoder on")
_MESHES = Family(
    (tooth_mesh(1, 1.0),),
    re.compile(r"tooth mesh of stage (\d{1,2})"),
    lambda match, indices: tooth_mesh(int(match[1]), 1.0),
)
_DIVIDERS = Family(
    (index_error(2),),
    re.compile(rf"index error, order ([2-{LAST_INDEX}])"),
    lambda match, indices: index_error(int(match[1])),
)
_CAMERAS = Family(
    CAMERA_EFFECTS,
    re.compile("|".join(re.escape(effect.name) for effect in CAMERA_EFFECTS)),
    lambda match, indices: next(effect for effect in CAMERA_EFFECTS if effect.name == match[0]),
)

LIFT = Catalogue(*LIFT_EFFECTS, *LIFT_INSTRUMENT, families=(_NOSES, _DIVIDERS))
PROFILE = Catalogue(*PROFILE_EFFECTS, *PROFILE_INSTRUMENT, families=(_NOSES, _UNDULATIONS))
TRANSMISSION = Catalogue(*TRAIN_EFFECTS, families=(_RUNOUTS, _ENCODERS, _MESHES))
TRACK = Catalogue(*TRACK_EFFECTS, families=(_CAMERAS,))
ZONES = Catalogue(RETURN_ERROR)


def spreads(halves: Mapping[Deviation, float], sizes: Mapping[Deviation, float]) -> dict[Quantity, float]:
    """Standard deviations of effects' numbers that tolerances allow: half a zone, as of twice the zone.

    Args:
        halves: half of the tolerance zone of each deviation that varies, in its unit.
        sizes: nominal sizes of deviations that effects state in per cent, mm.

    Returns:
        Standard deviations by the keys of the numbers, internal units.
    """
    return {
        key: halves[known] / (sizes[known] if number.unit == "%" else 1.0)
        for kind in (LIFT, PROFILE, TRACK)
        for effect in kind.effects
        if (known := effect.deviation) and known in halves
        for key, number in zip(effect.quantities, effect.parameters, strict=True)
    }
