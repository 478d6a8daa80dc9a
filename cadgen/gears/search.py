"""Which order of stages, and which tooth numbers, leave the output the least return error.

In eq. 25 a stage's return error reaches the output divided by the ratios behind it, so the last stage counts
most and wants a large wheel and a high ratio. `all_orders` ranks every order of given stages, `search_trains`
every choice of teeth, module and face width within limits; both by the greatest return error, least first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations
from math import degrees, inf
from typing import Literal, Self

import numpy as np
from numpy.typing import NDArray

from cadgen.errors import DesignError
from cadgen.gears.backlash import TrainPlay, play_equations, train_play
from cadgen.gears.blank import fits
from cadgen.gears.chains import LONGEST_CHAIN, BoolArray, best_chains
from cadgen.gears.layout import Blanks
from cadgen.gears.tolerances import (
    COVERED_DIAMETERS,
    FloatArray,
    ToleranceOverrides,
    centre_distance_deviation,
    gear_tolerances,
)
from cadgen.gears.tooth import MINIMUM_TEETH, GearForm
from cadgen.gears.train import CENTRE_DISTANCE_ROUNDING, Gear, GearPair, Train

Order = Literal["as-given", "reordered", "search"]
# Pairs of gears within the limits that a search takes on: as many take a second and some hundred megabytes.
MOST_PAIRS = 4_000_000


@dataclass(frozen=True, slots=True, kw_only=True)
class SearchLimits:
    """What a searched train may be, lengths in mm.

    The total `ratio` is met exactly, or within the relative `ratio_tolerance`. Every stage has `teeth`, a
    `centre_distance` and a `stage_ratio` between the least and the greatest given, one of `modules`, one of
    `widths`, and no profile shift. All gears share the grade, pressure angle and tooth factors of `pattern`.
    `keep` trains are returned. Raises `DesignError` for limits that are empty or out of range.
    """

    ratio: Fraction
    stages: int
    teeth: tuple[int, int]
    modules: tuple[float, ...]
    widths: tuple[float, ...]
    centre_distance: tuple[float, float]
    bearing_span: float
    pattern: Gear
    stage_ratio: tuple[float, float] = (0.0, inf)
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
        if not 0 <= self.ratio_tolerance < 1:
            raise DesignError(f"the search has ratio_tolerance = {self.ratio_tolerance:g}; give 0 up to 1")
        if not (self.modules and self.widths):
            raise DesignError("the search has no module or no face width to choose from; give at least one of each")

    @classmethod
    def like(cls, train: Train) -> Self:
        """Limits that span the gears of `train`: its ratio and stage count, and its sizes and all between.

        Raises `DesignError` for stages of different grade, pressure angle or bearing span: the search gives all
        stages the same.
        """
        gears = [gear for stage in train.stages for gear in (stage.driver, stage.driven)]
        _require_one("tolerance grade", (gear.grade for gear in gears))
        _require_one("pressure angle in degrees", (degrees(gear.form.normal_pressure_angle) for gear in gears))
        _require_one("bearing span in mm", (stage.bearing_span for stage in train.stages))
        teeth = [gear.form.teeth for gear in gears]
        axes = [stage.centre_distance for stage in train.stages]
        return cls(
            ratio=train.ratio,
            stages=len(train.stages),
            teeth=(min(teeth), max(teeth)),
            modules=tuple(sorted({gear.form.normal_module for gear in gears})),
            widths=tuple(sorted({gear.form.width for gear in gears})),
            centre_distance=(min(axes), max(axes)),
            bearing_span=train.stages[0].bearing_span,
            pattern=gears[0],
        )


def arrange(train: Train, order: Order, limits: SearchLimits | None = None) -> tuple[TrainPlay, ...]:
    """The trains that an order calls for, least return error first.

    `as-given` gives the train alone, `reordered` every order of its stages, `search` the trains within
    `limits`, by default those `SearchLimits.like` the train.
    """
    if order == "search":
        return search_trains(limits or SearchLimits.like(train))
    return all_orders(train) if order == "reordered" else (train_play(train),)


def all_orders(train: Train) -> tuple[TrainPlay, ...]:
    """Every distinct order of the stages, least greatest return error first."""
    given = train_play(train)
    found: dict[Train, TrainPlay] = {}
    for order in permutations(range(len(train.stages))):
        reordered = train.reordered(order)
        found.setdefault(reordered, TrainPlay(train=reordered, stages=tuple(given.stages[j] for j in order)))
    return tuple(sorted(found.values(), key=lambda play: play.return_error_max))


def search_trains(limits: SearchLimits, blanks: Blanks | None = None) -> tuple[TrainPlay, ...]:
    """The `limits.keep` trains within the limits with the least greatest return error, best first.

    With `blanks` only trains whose gears fit them, each at its place, before thinning. Raises `DesignError` if no
    train is within the limits, and for limits so wide that the search would not end.
    """
    pairs = _pairs(limits)
    found = best_chains(
        pairs.driver,
        pairs.driven,
        pairs.return_error,
        ratio=limits.ratio,
        tolerance=limits.ratio_tolerance,
        length=limits.stages,
        keep=limits.keep,
        allowed=None if blanks is None else _places(pairs, limits, blanks),
    )
    if not found:
        (fewest, most), (shortest, longest) = limits.teeth, limits.centre_distance
        number = "one stage" if limits.stages == 1 else f"{limits.stages} stages"
        raise DesignError(
            f"no train of {number} with {fewest} to {most} teeth and axes {shortest:g} to"
            f" {longest:g} mm apart has the ratio {limits.ratio} within {limits.ratio_tolerance:g}"
            f"{' and gears that fit their blanks' if blanks else ''}; widen the limits or raise the ratio tolerance"
        )
    return tuple(train_play(Train(tuple(_stage(pairs, row, limits) for row in rows))) for rows in found)


@dataclass(frozen=True, slots=True, eq=False)
class _Pairs:
    """Candidate stages, one row each, shapes (n,): teeth, mm and rad."""

    driver: NDArray[np.int64]
    driven: NDArray[np.int64]
    module: FloatArray
    width: FloatArray
    return_error: FloatArray


def _pairs(limits: SearchLimits) -> _Pairs:
    """Every pair within the limits whose gears the standards cover, with its greatest return error."""
    teeth = np.arange(limits.teeth[0], limits.teeth[1] + 1)
    if teeth.size**2 * len(limits.modules) * len(limits.widths) > MOST_PAIRS:
        raise DesignError(
            f"the search has {teeth.size} tooth numbers, {len(limits.modules)} modules and {len(limits.widths)} widths"
            f" to choose from, more than {MOST_PAIRS // 1_000_000} million pairs; narrow them"
        )
    columns = np.meshgrid(teeth, teeth, limits.modules, limits.widths, indexing="ij")
    driver, driven, module, width = (column.ravel() for column in columns)
    axes, diameters = module * (driver + driven) / 2, module * np.array([driver, driven])
    shortest, longest = limits.centre_distance
    fits = (axes >= shortest - CENTRE_DISTANCE_ROUNDING) & (axes <= longest + CENTRE_DISTANCE_ROUNDING)
    fits &= (diameters.min(axis=0) >= COVERED_DIAMETERS[0]) & (diameters.max(axis=0) <= COVERED_DIAMETERS[1])
    fits &= (driven >= limits.stage_ratio[0] * driver) & (driven <= limits.stage_ratio[1] * driver)
    driver, driven, module, width, axes = (column[fits] for column in (driver, driven, module, width, axes))
    grade, alpha = limits.pattern.grade, limits.pattern.form.normal_pressure_angle
    play = play_equations(
        gear_tolerances(module * driver, module, width, grade),
        gear_tolerances(module * driven, module, width, grade),
        f_a=centre_distance_deviation(axes, grade),
        j_bn0=np.zeros(axes.shape),
        module=module,
        alpha_n=alpha,
        alpha_w=alpha,
        centre_distance=axes,
        span_to_widths=(limits.bearing_span / width, limits.bearing_span / width),
        driven_pitch_radius=module * driven / 2,
    )
    return _Pairs(driver, driven, module, width, play.B_max)


def _places(pairs: _Pairs, limits: SearchLimits, blanks: Blanks) -> list[BoolArray]:
    """Which pairs may stand at each place, from the drive on: both gears must fit their blanks there."""

    def ask(teeth: NDArray[np.int64], fit: Callable[[GearForm], bool]) -> BoolArray:
        sizes = np.column_stack([teeth, pairs.module, pairs.width])
        kinds, kind = np.unique(sizes, axis=0, return_inverse=True)
        return np.array([fit(_form(limits, int(z), m, b)) for z, m, b in kinds.tolist()], dtype=np.bool_)[
            np.ravel(kind)
        ]

    first = ask(pairs.driver, lambda form: fits(form, blanks.drive))
    later = ask(pairs.driver, lambda form: fits(form, blanks.intermediate, on_collar=True))
    before = ask(pairs.driven, lambda form: fits(form, blanks.intermediate))
    last = ask(pairs.driven, lambda form: fits(form, blanks.output))
    return [
        (first if place == 0 else later) & (last if place == limits.stages - 1 else before)
        for place in range(limits.stages)
    ]


def _require_one(what: str, values: Iterable[float]) -> None:
    given = sorted(set(values))
    if len(given) > 1:
        raise DesignError(
            f"the search gives all stages one {what}, and those given have {' and '.join(f'{v:g}' for v in given)};"
            " give them all the same, or reorder them as they are"
        )


def _form(limits: SearchLimits, teeth: int, module: float, width: float) -> GearForm:
    return replace(limits.pattern.form, teeth=teeth, normal_module=module, width=width, profile_shift=0.0)


def _stage(pairs: _Pairs, row: int, limits: SearchLimits) -> GearPair:
    teeth, module = (int(pairs.driver[row]), int(pairs.driven[row])), float(pairs.module[row])
    driver, driven = (
        replace(
            limits.pattern,
            form=_form(limits, z, module, float(pairs.width[row])),
            overrides=ToleranceOverrides(),
        )
        for z in teeth
    )
    return GearPair(
        driver=driver,
        driven=driven,
        centre_distance=module * sum(teeth) / 2,
        bearing_span=limits.bearing_span,
    )
