"""Kind of a stage, apart from the table of all kinds, which imports theirs. The module is light to import."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from cadgen.gears.choices import Thinning

if TYPE_CHECKING:
    from cadgen.gears.stage import Stage


@dataclass(frozen=True, kw_only=True)
class StageKind:
    """A kind of stage, beside spur gears.

    Attributes:
        code: value of `train.stages.kind`.
        meaning: a sentence for the reference.
        keys: a frozen dataclass of its keys, named as in the file, each `Annotated` with its limits and with a phrase
            for the reference; its `__post_init__` may refuse what contradicts itself by a `ValueError`, one sentence
            for the user. `bearing_span_mm` and `direction_deg` are keys of every stage and not among them.
        build: function of the keys and of the distance of the bearings, mm, that returns the stage; a `DesignError`
            where there is no such stage. One of a `toothed` kind takes a `ToothedTrain` in place of that distance.
        toothed: whether its gears take what they leave out from [train].
        explains: codes of checks of its own, each with a sentence for `cadgen explain`.
    """

    code: str
    meaning: str
    keys: type[Any]
    build: Callable[[Any, Any], Stage]
    toothed: bool = False
    explains: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, kw_only=True)
class ToothedTrain:
    """Numbers that [train] gives all gears of a train: lengths in mm, angles in rad, factors in modules.

    Attributes:
        bearing_span: distance of the bearings of the stage.
        module: normal module of gears that give none.
        width: width of gears that give none.
        pressure_angle: normal pressure angle of gears that give none.
        helix_angle: helix angle of gears that give none.
        addendum_factor: addendum of the basic rack.
        dedendum_factor: dedendum of the basic rack.
        rack_tip_radius_factor: radius at the tips of the basic rack.
        tip_chamfer: leg of the chamfer at the tips.
        grade: tolerance grade.
        without_standard: whether tolerances that are left out are 0.
        thinning: thickness that teeth are cut to.
        pin_diameter: diameter of the pins for inspection; None for one to suit each gear.
        clearance: least gap between bodies.
    """

    bearing_span: float
    module: float
    width: float
    pressure_angle: float
    helix_angle: float
    addendum_factor: float
    dedendum_factor: float
    rack_tip_radius_factor: float
    tip_chamfer: float
    grade: int
    without_standard: bool
    thinning: Thinning | float
    pin_diameter: float | None
    clearance: float
