"""Limits of a search for trains: sizes, ratios, contact ratio and undercut, with their defaults."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, degrees, floor, inf
from typing import Self

from cadgen.errors import DesignError
from cadgen.gears.chains import LONGEST_CHAIN
from cadgen.gears.contact import LEAST_CONTACT_RATIO, contact_ratio
from cadgen.gears.kinds.spur import GearPair, spur_pairs
from cadgen.gears.pair import Gear
from cadgen.gears.tooth import MINIMUM_TEETH
from cadgen.gears.train import Train
from cadgen.gears.undercut import missing_shift

# Limits of a search that is asked for nothing else. A stage that speeds up only wastes what another gains; more than
# ten to one is hardly ever built with spur gears.
STAGE_RATIOS = (1.0, 10.0)
# Least contact ratio in design, with some reserve over what is checked (Norton, Machine Design: 1.2 at least).
CONTACT_RATIO = 1.2
# Profile shift in modules that a gear may lack, as cut: unshifted gears of 12 teeth, the least that makers list, lack
# 0.30 by their numbers and, thinned, 0.4 to 0.5.
UNDERCUT = 0.5


@dataclass(frozen=True, slots=True, kw_only=True)
class SearchLimits:
    """Limits of a search for trains, lengths in mm.

    The total `ratio` is met exactly, or within the relative `ratio_tolerance`. Every stage has `teeth`, a
    `centre_distance` and a `stage_ratio` between the least and the greatest given, one of `modules`, one of
    `widths`, and no profile shift. As cut it has at least the `contact_ratio`, and its gears lack no more profile
    shift than `undercut`, in modules, to be free of undercut. All gears share the grade, pressure angle, tooth
    factors and thinning of `pattern`. `keep` trains are returned. Raises `DesignError` for limits that are empty or
    out of range.
    """

    ratio: Fraction
    stages: int
    teeth: tuple[int, int]
    modules: tuple[float, ...]
    widths: tuple[float, ...]
    centre_distance: tuple[float, float]
    bearing_span: float
    pattern: Gear
    stage_ratio: tuple[float, float] = STAGE_RATIOS
    contact_ratio: float = CONTACT_RATIO
    undercut: float = UNDERCUT
    ratio_tolerance: float = 0.0
    keep: int = 10

    def __post_init__(self) -> None:
        for name, low, high in (
            ("teeth", *self.teeth),
            ("centre_distance", *self.centre_distance),
            ("stage_ratio", *self.stage_ratio),
        ):
            if not low <= high:
                raise DesignError(f"the search limits {name} run from {low:g} to {high:g}; give the lesser first")
        if self.teeth[0] < MINIMUM_TEETH:
            raise DesignError(f"the search allows {self.teeth[0]} teeth; give at least {MINIMUM_TEETH}")
        if not 1 <= self.stages <= LONGEST_CHAIN:
            raise DesignError(f"the search has {self.stages} stages; give 1 to {LONGEST_CHAIN}")
        for name, value in (("ratio", self.ratio), ("bearing_span", self.bearing_span), ("keep", self.keep)):
            if not value > 0:
                raise DesignError(f"the search has {name} = {float(value):g}; give a value above 0")
        for name, value in (("contact_ratio", self.contact_ratio), ("undercut", self.undercut)):
            if not value >= 0:
                raise DesignError(f"the search has {name} = {float(value):g}; give 0 or more")
        if not 0 <= self.ratio_tolerance < 1:
            raise DesignError(f"the search has ratio_tolerance = {self.ratio_tolerance:g}; give 0 up to 1")
        if not (self.modules and self.widths):
            raise DesignError("the search has no module or no face width to choose from; give at least one of each")

    def __str__(self) -> str:
        (fewest, most), (shortest, longest), (least, greatest) = self.teeth, self.centre_distance, self.stage_ratio
        return (
            f"{'one stage' if self.stages == 1 else f'{self.stages} stages'} with {fewest} to {most} teeth and axes"
            f" {shortest:g} to {longest:g} mm apart, modules of {_listed(self.modules)} mm and widths of"
            f" {_listed(self.widths)} mm, stage ratios of {least:g} to {greatest:g}, a contact ratio of"
            f" {self.contact_ratio:g} or more, and undercut up to {self.undercut:g} modules of profile shift"
        )

    @classmethod
    def like(cls, train: Train) -> Self:
        """Limits that span the gears of `train`: its ratio and stage count, and its sizes and all between.

        Stage ratio, contact ratio and undercut are the usual ones, or those of the train where these go further.
        Raises `DesignError` for stages of different grade, pressure angle or bearing span: the search gives all
        stages the same.
        """
        pairs = spur_pairs(train, "the search is", "take --order as-given or reordered")
        gears = [gear for stage in pairs for gear in (stage.driver, stage.driven)]
        _require_one("tolerance grade", (gear.grade for gear in gears))
        _require_one("pressure angle in degrees", (degrees(gear.form.normal_pressure_angle) for gear in gears))
        _require_one("bearing span in mm", (stage.bearing_span for stage in train.stages))
        teeth = [gear.form.teeth for gear in gears]
        axes = [stage.centre_distance for stage in train.stages]
        ratios = [float(stage.ratio) for stage in train.stages]
        contact, undercut = _contact_and_undercut(pairs)
        return cls(
            ratio=train.ratio,
            stages=len(train.stages),
            teeth=(min(teeth), max(teeth)),
            modules=tuple(sorted({gear.form.normal_module for gear in gears})),
            widths=tuple(sorted({gear.form.width for gear in gears})),
            centre_distance=(min(axes), max(axes)),
            bearing_span=train.stages[0].bearing_span,
            pattern=gears[0],
            stage_ratio=(min(STAGE_RATIOS[0], *ratios), max(STAGE_RATIOS[1], *ratios)),
            contact_ratio=max(min(CONTACT_RATIO, contact), LEAST_CONTACT_RATIO),
            undercut=max(UNDERCUT, undercut),
        )


def _contact_and_undercut(pairs: Iterable[GearPair]) -> tuple[float, float]:
    """Least contact ratio and worst undercut of pairs as cut, to the outer hundredth; of those that can be cut."""
    contact, undercut = inf, 0.0
    for pair in pairs:
        try:
            cut = pair.as_cut()
            contact = min(contact, contact_ratio(cut))
            undercut = max(undercut, missing_shift(cut.driver.form), missing_shift(cut.driven.form))
        except DesignError:
            continue
    return floor(contact * 100) / 100 if contact < inf else inf, ceil(undercut * 100) / 100


def _listed(values: Iterable[float]) -> str:
    return ", ".join(f"{value:g}" for value in values)


def _require_one(what: str, values: Iterable[float]) -> None:
    different = sorted(set(values))
    if len(different) > 1:
        raise DesignError(
            f"the search gives all stages one {what}, and those given have {' and '.join(f'{v:g}' for v in different)};"
            " give them all the same, or reorder them as they are"
        )
