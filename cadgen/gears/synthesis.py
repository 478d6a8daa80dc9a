"""Synthesis of a train: which order of stages, and which tooth numbers, leave the output the least return error.

In eq. 25 a stage's return error reaches the output divided by the ratios behind it, so the last stage counts
most, and is best with a large wheel and a high ratio. `all_orders` ranks every order of given stages, `search_trains`
every choice of teeth, module and face width within `SearchLimits`; both by the greatest return error, least first. A
search lays out the stages it may choose from as arrays (`Pairs`), finds where they fit in their blanks and beside each
other, and leaves the choice to `chains`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations
from math import ceil, cos, degrees, floor, inf, tan
from typing import Self

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.gears.backlash import StagePlay, play_equations
from cadgen.gears.chains import LONGEST_CHAIN, BoolArray, EndlessSearchError, Fit, best_chains
from cadgen.gears.choices import Order
from cadgen.gears.contact import (
    LEAST_CONTACT_RATIO,
    LEAST_ROOT_CLEARANCE,
    contact_ratio,
    contact_ratios,
    missing_shift,
    missing_shifts,
)
from cadgen.gears.layout import Blanks, collar_length
from cadgen.gears.pair import CENTRE_DISTANCE_ROUNDING, GradedGear
from cadgen.gears.sliding import loss_factor, loss_factors
from cadgen.gears.spur import SpurPair, spur_pairs
from cadgen.gears.stage import Stage
from cadgen.gears.tolerances import COVERED_DIAMETERS, ToleranceOverrides, centre_distance_deviation, gear_tolerances
from cadgen.gears.tooth import MINIMUM_TEETH, GearForm, involute
from cadgen.gears.train import Train, TrainPlay, train_play
from cadgen.gears.wheel_body import fits
from cadgen.messages import Message, joined
from cadgen.parts.blank import Blank

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
    factors and thinning of `pattern`. `keep` trains are returned, of fewer stages, too, where `fewer` is set. Raises
    `DesignError` for limits that are empty or out of range.
    """

    ratio: Fraction
    stages: int
    teeth: tuple[int, int]
    modules: tuple[float, ...]
    widths: tuple[float, ...]
    centre_distance: tuple[float, float]
    bearing_span: float
    pattern: GradedGear
    stage_ratio: tuple[float, float] = STAGE_RATIOS
    contact_ratio: float = CONTACT_RATIO
    undercut: float = UNDERCUT
    ratio_tolerance: float = 0.0
    keep: int = 10
    fewer: bool = False

    def __post_init__(self) -> None:
        for name, low, high in (
            ("teeth", *self.teeth),
            ("centre_distance", *self.centre_distance),
            ("stage_ratio", *self.stage_ratio),
        ):
            if not low <= high:
                raise DesignError(
                    "the search limits {name} run from {low:g} to {high:g}; give the lesser first",
                    name=name,
                    low=low,
                    high=high,
                )
        if self.teeth[0] < MINIMUM_TEETH:
            raise DesignError(
                "the search allows {teeth} teeth; give at least {least}",
                teeth=self.teeth[0],
                least=MINIMUM_TEETH,
            )
        if not 1 <= self.stages <= LONGEST_CHAIN:
            raise DesignError(
                "the search has {stages} stages; give 1 to {most}",
                stages=self.stages,
                most=LONGEST_CHAIN,
            )
        for name, value in (("ratio", self.ratio), ("bearing_span", self.bearing_span), ("keep", self.keep)):
            if not value > 0:
                raise DesignError(
                    "the search has {name} = {value:g}; give a value above 0", name=name, value=float(value)
                )
        for name, value in (("contact_ratio", self.contact_ratio), ("undercut", self.undercut)):
            if not value >= 0:
                raise DesignError("the search has {name} = {value:g}; give 0 or more", name=name, value=float(value))
        if not 0 <= self.ratio_tolerance < 1:
            raise DesignError(
                "the search has ratio_tolerance = {tolerance:g}; give 0 up to 1",
                tolerance=self.ratio_tolerance,
            )
        if not (self.modules and self.widths):
            raise DesignError("the search has no module or no face width to choose from; give at least one of each")

    def __str__(self) -> str:
        (fewest, most), (shortest, longest), (least, greatest) = self.teeth, self.centre_distance, self.stage_ratio
        stages = Message("{count} stages", count=self.stages)
        if self.stages == 1:
            stages = Message("one stage")
        elif self.fewer:
            stages = Message("up to {count} stages", count=self.stages)
        return Message(
            "{stages} with {fewest} to {most} teeth and axes {shortest:g} to {longest:g} mm apart, modules of {modules}"
            " mm and widths of {widths} mm, stage ratios of {least:g} to {greatest:g}, a contact ratio of {contact:g}"
            " or more, and undercut up to {undercut:g} modules of profile shift",
            stages=stages,
            fewest=fewest,
            most=most,
            shortest=shortest,
            longest=longest,
            modules=joined([f"{module:g}" for module in self.modules]),
            widths=joined([f"{width:g}" for width in self.widths]),
            least=least,
            greatest=greatest,
            contact=self.contact_ratio,
            undercut=self.undercut,
        )

    @classmethod
    def like(cls, train: Train) -> Self:
        """Limits that span the gears of `train`: its ratio and stage count, and its sizes and all between.

        Stage ratio, contact ratio and undercut are the usual ones, or those of the train where these go further.
        Raises `DesignError` for stages of different grade, pressure angle or bearing span: the search gives all
        stages the same.
        """
        pairs = spur_pairs(train, Message("the search is"), Message("take --order as-given or reordered"))
        gears = [gear for stage in pairs for gear in (stage.driver, stage.driven)]
        _require_one(Message("tolerance grade"), (gear.grade for gear in gears))
        _require_one(Message("pressure angle in degrees"), (degrees(gear.form.normal_pressure_angle) for gear in gears))
        _require_one(Message("bearing span in mm"), (stage.bearing_span for stage in train.stages))
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


def _contact_and_undercut(pairs: Iterable[SpurPair]) -> tuple[float, float]:
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


def _require_one(what: str, values: Iterable[float]) -> None:
    different = sorted(set(values))
    if len(different) > 1:
        raise DesignError(
            "the search gives all stages one {what}, and those given have {values}; give them all the same, or "
            "reorder them as they are",
            what=what,
            values=joined([f"{value:g}" for value in different], " and "),
        )


# Pairs of gears within the limits that a search takes on: as many take some seconds and some hundred megabytes.
MOST_PAIRS = 4_000_000
# Of a stage ratio that meets a limit but for rounding (relative), and of a room in mm: `layout` is the judge.
RATIO_ROUNDING = 1e-12
ROOM_SLACK = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Pairs:
    """Candidate stages, one row each, shapes (n,): teeth, mm and rad; `shifts` are x_E of driver and driven, as cut."""

    driver: NDArray[np.int64]
    driven: NDArray[np.int64]
    module: Array
    width: Array
    return_error: Array
    shifts: tuple[Array, Array]

    def where(self, rows: BoolArray) -> Pairs:
        """Some of the pairs."""
        return Pairs(
            self.driver[rows],
            self.driven[rows],
            self.module[rows],
            self.width[rows],
            self.return_error[rows],
            (self.shifts[0][rows], self.shifts[1][rows]),
        )

    @property
    def axes(self) -> Array:
        """Centre distances in mm."""
        return np.asarray(self.module * (self.driver + self.driven) / 2)

    def losses(self, limits: SearchLimits) -> Array:
        """Loss factors H_v, as cut.

        Args:
            limits: limits of the search, with the pattern of its gears.
        """
        teeth, form = (self.driver.astype(np.float64), self.driven.astype(np.float64)), limits.pattern.form
        return loss_factors(form, teeth, self.shifts, form.tip_chamfer / self.module)


def pairs_within(limits: SearchLimits) -> Pairs:
    """Every pair within the limits whose gears the standards cover, with its greatest return error."""
    teeth = np.arange(limits.teeth[0], limits.teeth[1] + 1)
    if teeth.size**2 * len(limits.modules) * len(limits.widths) > MOST_PAIRS:
        raise DesignError(
            "the search has {teeth} tooth numbers, {modules} modules and {widths} widths to choose from, more "
            "than {most} million pairs; narrow them",
            teeth=teeth.size,
            modules=len(limits.modules),
            widths=len(limits.widths),
            most=MOST_PAIRS // 1_000_000,
        )
    columns = np.meshgrid(teeth, teeth, sorted(set(limits.modules)), sorted(set(limits.widths)), indexing="ij")
    driver, driven, module, width = (column.ravel() for column in columns)
    axes, diameters = module * (driver + driven) / 2, module * np.array([driver, driven])
    shortest, longest = limits.centre_distance
    fits = (axes >= shortest - CENTRE_DISTANCE_ROUNDING) & (axes <= longest + CENTRE_DISTANCE_ROUNDING)
    fits &= (diameters.min(axis=0) >= COVERED_DIAMETERS[0]) & (diameters.max(axis=0) <= COVERED_DIAMETERS[1])
    fits &= driven >= limits.stage_ratio[0] * driver * (1 - RATIO_ROUNDING)
    fits &= driven <= limits.stage_ratio[1] * driver * (1 + RATIO_ROUNDING)
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
        thinning=(limits.pattern.thinning, limits.pattern.thinning),
    )
    x_E = tuple((gear.E_sns - gear.T_sn / 2) / (2 * module * tan(alpha)) for gear in (play.driver, play.driven))
    pairs = Pairs(driver, driven, module, width, play.B_max, (x_E[0], x_E[1]))
    return _in_mesh(pairs, play, limits)


def _in_mesh(pairs: Pairs, play: StagePlay[Array], limits: SearchLimits) -> Pairs:
    """Pairs whose teeth do not jam, clear the roots, and keep the limits of undercut and contact ratio.

    Raises `DesignError` where one of these leaves none of the pairs.
    """
    form, (x, y) = limits.pattern.form, pairs.shifts
    angle = form.normal_pressure_angle
    # At the least play: axes closer by f_a, both teeth at E_sns.
    closest = np.arccos(np.minimum(cos(angle) * pairs.axes / (pairs.axes - play.f_a), 1.0))
    opened = np.tan(closest) - closest - involute(angle)
    least_play = pairs.module * (pairs.driver + pairs.driven) * opened - play.driver.E_sns - play.driven.E_sns
    missing = np.maximum(missing_shifts(form, pairs.driver, x), missing_shifts(form, pairs.driven, y))
    clearance = form.dedendum_factor - form.addendum_factor - np.maximum(x, y)
    kept = np.ones(pairs.driver.shape, dtype=np.bool_)
    for holds, cure in (
        (least_play > 0, Message("none has play at the closest axes and the thickest teeth; thin the teeth more")),
        (
            clearance >= LEAST_ROOT_CLEARANCE,
            Message("none clears the roots by {least:g} modules; raise dedendum_factor", least=LEAST_ROOT_CLEARANCE),
        ),
        (
            missing <= limits.undercut,
            Message("each has more undercut than {most:g}; allow more teeth or more undercut", most=limits.undercut),
        ),
    ):
        kept = _kept(kept, holds, limits, cure)
    pairs = pairs.where(kept)
    teeth = pairs.driver.astype(np.float64), pairs.driven.astype(np.float64)
    ratios = contact_ratios(form, teeth, pairs.shifts, form.tip_chamfer / pairs.module)
    low = Message(
        "none has a contact ratio of {least:g}; allow more teeth or a smaller contact ratio", least=limits.contact_ratio
    )
    return pairs.where(_kept(np.ones(ratios.shape, dtype=np.bool_), ratios >= limits.contact_ratio, limits, low))


def _kept(before: BoolArray, holds: BoolArray, limits: SearchLimits, cure: str) -> BoolArray:
    kept = before & holds
    if before.any() and not kept.any():
        raise DesignError(
            "no train of {limits}: of {count} pairs of gears that are left {cure}",
            limits=str(limits),
            count=int(before.sum()),
            cure=cure,
        )
    return kept


def fit_of(pairs: Pairs, limits: SearchLimits, blanks: Blanks, clearance: float) -> Fit:
    """Where pairs may stand, with both gears as cut in their blanks, and which clear the shafts beside them.

    Args:
        pairs: pairs of gears.
        limits: limits of the search.
        blanks: bores, hubs and webs by place in the train.
        clearance: least gap between parts, mm.
    """
    stages, form = limits.stages, limits.pattern.form
    wheel, pinion = (pairs.module * (teeth / 2 + form.addendum_factor) for teeth in (pairs.driven, pairs.driver))
    shafts = blanks.by_shaft(stages + 1)
    bores = [blank.shaft_diameter / 2 for blank in shafts]
    hubs = [blank.hub.diameter / 2 if blank.hub else 0.0 for blank in shafts]
    collars = [blank.hub for blank in shafts[1:-1]]
    rubbing = [wheel if collar and collar.length < clearance else np.zeros_like(wheel) for collar in collars]

    def past(size: float | Array) -> Array:
        """Room that the axes of a stage leave beside a body of a radius on one shaft; any if there is no body."""
        return np.where(np.asarray(size) > 0, pairs.axes - size - clearance + ROOM_SLACK, inf)

    ends = sum(blank.hub.length for blank in (blanks.drive, blanks.output) if blank.hub)
    between = sum(collar.length if collar else collar_length(clearance) for collar in collars)
    allowed = _places(pairs, limits, blanks)
    for place in range(stages):
        for shaft, other in ((place, place + 1), (place + 1, place)):
            allowed[place] &= max(hubs[other], bores[other]) <= past(bores[shaft])
        # A hub ends where the gear on the other shaft begins.
        allowed[place] &= (wheel <= past(hubs[place])) & (pinion <= past(hubs[place + 1]))
    return Fit(
        allowed=allowed,
        wheel=wheel,
        pinion=pinion,
        after=np.array([past(np.maximum(bore, rubs)) for bore, rubs in zip(bores[2:], rubbing, strict=True)]).reshape(
            -1, wheel.size
        ),
        before=np.array([past(bore) for bore in bores[:-2]]).reshape(-1, wheel.size),
        height=pairs.width,
        most_height=limits.bearing_span - (ends + between),
    )


def _places(pairs: Pairs, limits: SearchLimits, blanks: Blanks) -> BoolArray:
    """Which pairs may stand at each place, from the drive on, shape (stages, n): both gears must fit their blanks."""

    def ask(teeth: NDArray[np.int64], x_E: Array, fit: Callable[[GearForm], bool]) -> BoolArray:
        """Whether the gear of each pair fits; the thinner a tooth is cut the smaller its root, and nothing else."""
        sizes = np.column_stack([teeth, pairs.module, pairs.width])
        kinds, kind = np.unique(sizes, axis=0, return_inverse=True)
        kind = np.ravel(kind)
        low, high = np.full(len(kinds), inf), np.full(len(kinds), -inf)
        np.minimum.at(low, kind, x_E)
        np.maximum.at(high, kind, x_E)
        at_least, at_most = (
            np.array(
                [fit(form_of(limits, int(z), m, b, x)) for (z, m, b), x in zip(kinds.tolist(), ends, strict=True)], bool
            )
            for ends in (low.tolist(), high.tolist())
        )
        fitting = at_most[kind]
        for row in np.flatnonzero(at_most & ~at_least).tolist():
            z, m, b = sizes[row].tolist()
            fitting[row] = fit(form_of(limits, int(z), m, b, float(x_E[row])))
        return np.asarray(fitting)

    drive, *between, output = blanks.by_shaft(limits.stages + 1)
    known: dict[tuple[Blank, bool], BoolArray] = {}  # most shafts between have one blank

    def cluster(blank: Blank, upper: bool) -> BoolArray:
        if (blank, upper) not in known:
            teeth, x_E = (pairs.driver, pairs.shifts[0]) if upper else (pairs.driven, pairs.shifts[1])
            known[blank, upper] = ask(teeth, x_E, lambda form: fits(form, blank, upper=upper))
        return known[blank, upper]

    first = ask(pairs.driver, pairs.shifts[0], lambda form: fits(form, drive))
    last = ask(pairs.driven, pairs.shifts[1], lambda form: fits(form, output))
    drivers = [first, *(cluster(blank, True) for blank in between)]
    driven = [*(cluster(blank, False) for blank in between), last]
    return np.array([above & below for above, below in zip(drivers, driven, strict=True)])


def form_of(limits: SearchLimits, teeth: int, module: float, width: float, x_E: float = 0.0) -> GearForm:
    """A searched gear, cut with the generating profile shift x_E.

    Args:
        limits: limits of the search, with the pattern of its gears.
        teeth: number of teeth.
        module: normal module, mm.
        width: face width, mm.
        x_E: generating profile shift, in modules: a pure number.
    """
    pattern = limits.pattern.form
    deviation = x_E * 2 * module * tan(pattern.normal_pressure_angle)
    return replace(
        pattern,
        teeth=teeth,
        normal_module=module,
        width=width,
        profile_shift=0.0,
        tooth_thickness_deviation=deviation,
    )


def arrange(train: Train, order: Order, limits: SearchLimits | None = None) -> tuple[TrainPlay, ...]:
    """The trains that an order calls for, least return error first.

    `as-given` gives the train alone, `reordered` every order of its stages, `search` the trains within
    `limits`, by default those `SearchLimits.like` the train.
    """
    if order == Order.SEARCH:
        return search_trains(limits or SearchLimits.like(train))
    return all_orders(train) if order == Order.REORDERED else (train_play(train),)


def all_orders(train: Train) -> tuple[TrainPlay, ...]:
    """Every distinct order of the stages, least greatest return error first."""
    designed = train_play(train)
    plays: dict[Train, TrainPlay] = {}
    for order in permutations(range(len(train.stages))):
        reordered = train.reordered(order)
        plays.setdefault(reordered, TrainPlay(train=reordered, stages=tuple(designed.stages[j] for j in order)))
    return tuple(sorted(plays.values(), key=lambda play: play.return_error_max))


def search_trains(limits: SearchLimits, blanks: Blanks | None = None, clearance: float = 0.0) -> tuple[TrainPlay, ...]:
    """The `limits.keep` trains within the limits with the least greatest return error, best first.

    With `blanks` only trains whose gears fit them, each at its place, and whose wheels pass the shafts beside them
    with `clearance` (mm). Raises `DesignError` if no train is within the limits, and for limits so wide that the
    search would not end.

    Args:
        limits: limits of the search.
        blanks: blanks that the gears must fit; None for any.
        clearance: least gap between a wheel and the shafts beside it, mm.
    """
    return search_of(limits, blanks, clearance).best(limits.keep)


def search_of(
    limits: SearchLimits, blanks: Blanks | None = None, clearance: float = 0.0
) -> TrainSearch | SearchOverStages:
    """Search within limits, over fewer stages, too, where they say so.

    Args:
        limits: limits of the search.
        blanks: blanks that the gears must fit; None for any.
        clearance: least gap between a wheel and the shafts beside it, mm.
    """
    if limits.fewer and limits.stages > 1:
        return SearchOverStages(limits, blanks, clearance)
    return TrainSearch(limits, blanks, clearance)


# By which the next train of a front must be smaller than the one before, mm, and lose less.
SMALLER, LESS_LOSS = 1e-6, 1e-8
# Trains that are looked for, of a front of return error and size, and of one with losses.
MOST_OF_FRONT, MOST_WITH_LOSSES = 40, 400


def size_of(train: Train) -> float:
    """Size of a train: the sum of its centre distances, mm."""
    return sum(stage.centre_distance for stage in train.stages)


def losses_of(train: Train) -> float:
    """Sum of the loss factors H_v of a train of spur gears, as cut; times μ the share of the power that teeth lose."""
    return sum(loss_factor(stage.as_cut()) for stage in spur_pairs(train, Message("losses are")))


def front_of(limits: SearchLimits, losses: bool = False) -> tuple[tuple[TrainPlay, ...], bool]:
    """Pareto front of return error and size: the trains that no other beats in both, least return error first.

    For every number of stages the train of the least return error is found, then that among the smaller ones, and so
    on. With losses all of that is done again among the trains that lose less than the worst of the last ones found. The
    second value is whether the front is whole: wide limits end it early.

    Args:
        limits: limits of the search.
        losses: whether no other may beat them in the losses of the teeth, either.
    """
    if losses:
        return _front_with_losses(limits)
    counts = range(1, limits.stages + 1) if limits.fewer else (limits.stages,)
    pairs, found, whole = pairs_within(limits), list[TrainPlay](), True
    for count in counts:
        search = TrainSearch(replace(limits, stages=count, fewer=False), pairs=pairs)
        if found:
            search.without_even_pairs()
        size = inf
        for _ in range(MOST_OF_FRONT):
            try:
                (play,) = search.smaller(size).best(1)
            except EndlessSearchError:
                whole = False
                break
            except DesignError:
                break
            found.append(play)
            size = size_of(play.train) - SMALLER
        else:
            whole = False
    front: list[TrainPlay] = []
    for play in sorted(found, key=lambda play: (play.return_error_max, size_of(play.train))):
        if not front or size_of(play.train) < size_of(front[-1].train) - SMALLER / 2:
            front.append(play)
    return tuple(front), whole


def _front_with_losses(limits: SearchLimits) -> tuple[tuple[TrainPlay, ...], bool]:
    """Pareto front of return error, size and losses, least return error first, and whether it is whole."""
    counts = range(1, limits.stages + 1) if limits.fewer else (limits.stages,)
    pairs, found, left = pairs_within(limits), dict[TrainPlay, tuple[float, float, float]](), MOST_WITH_LOSSES
    for count in counts:
        search = TrainSearch(replace(limits, stages=count, fewer=False), pairs=pairs)
        if found:
            search.without_even_pairs()
        most, last = inf, [0.0]
        while last:
            size, last = inf, []
            while left:
                left -= 1
                try:
                    (play,) = search.smaller(size, most).best(1)
                except EndlessSearchError:
                    left = 0
                    break
                except DesignError:
                    break
                found[play] = play.return_error_max, size_of(play.train), losses_of(play.train)
                last.append(found[play][2])
                size = found[play][1] - SMALLER
            most = max(last, default=0.0) - LESS_LOSS

    def beaten(one: tuple[float, float, float]) -> bool:
        slack = (1e-12, SMALLER / 2, LESS_LOSS / 2)
        return any(
            other != one and all(theirs <= own + room for theirs, own, room in zip(other, one, slack, strict=True))
            for other in found.values()
        )

    front = [play for play, figures in found.items() if not beaten(figures)]
    return tuple(sorted(front, key=lambda play: found[play])), left > 0


class TrainSearch:
    """The pairs within limits, and the best trains of those that have not been excluded."""

    def __init__(
        self,
        limits: SearchLimits,
        blanks: Blanks | None = None,
        clearance: float = 0.0,
        pairs: Pairs | None = None,
    ) -> None:
        self._limits, self._blanks = limits, blanks
        self._pairs = pairs_within(limits) if pairs is None else pairs
        self._fit = (
            Fit.anywhere(limits.stages, self._pairs.driver.size)
            if blanks is None
            else fit_of(self._pairs, limits, blanks, clearance)
        )
        self._excluded: set[int] = set()

    def best(self, keep: int) -> tuple[TrainPlay, ...]:
        """The `keep` trains of the least greatest return error, best first.

        Raises `DesignError` if there is none, or none left, and if the search would not end.
        """
        limits, pairs = self._limits, self._pairs
        chains = best_chains(
            pairs.driver,
            pairs.driven,
            pairs.return_error,
            ratio=limits.ratio,
            tolerance=limits.ratio_tolerance,
            length=limits.stages,
            keep=keep,
            fit=self._fit,
        )
        if not chains:
            kept = (
                Message(", gears that fit their blanks and wheels that pass the shafts beside them")
                if self._blanks
                else ""
            )
            left: str = ""
            if self._excluded:
                left = Message(", {count} pairs left out whose teeth fail", count=len(self._excluded))
            raise DesignError(
                "no train of {limits}{kept}{left} has the ratio {ratio} within {tolerance:g}; widen the limits "
                "or raise the ratio tolerance",
                limits=str(limits),
                kept=kept,
                left=left,
                ratio=limits.ratio,
                tolerance=limits.ratio_tolerance,
            )
        return tuple(train_play(Train(tuple(_stage(pairs, row, limits) for row in rows))) for rows in chains)

    def smaller(self, size: float, most_loss: float | None = None) -> Self:
        """The search, without blanks, among trains whose centre distances add up to no more than a size, mm.

        Args:
            size: greatest sum of the centre distances, mm.
            most_loss: greatest sum of the loss factors; None where they do not matter.
        """
        self._fit = replace(self._fit, height=self._pairs.axes, most_height=size)
        if most_loss is not None:
            loss = self._pairs.losses(self._limits) if self._fit.loss is None else self._fit.loss
            self._fit = replace(self._fit, loss=loss, most_loss=most_loss)
        return self

    def exclude(self, stage: Stage) -> None:
        """Leave out a pair, at every place: its teeth cannot be made, or fail their checks."""
        (pair,) = spur_pairs(Train((stage,)), Message("the search is"))
        driver, driven = pair.driver.form, pair.driven.form
        same = (self._pairs.driver == driver.teeth) & (self._pairs.driven == driven.teeth)
        same &= (self._pairs.module == driver.normal_module) & (self._pairs.width == driver.width)
        self._fit.allowed[:, same] = False
        self._excluded.update(np.flatnonzero(same).tolist())

    def without_even_pairs(self) -> None:
        """Leave out pairs of two equal gears, which only pass the motion on."""
        self._fit.allowed[:, self._pairs.driver == self._pairs.driven] = False


class SearchOverStages:
    """Searches for trains of one stage up to so many; a train with an even pair gives way to one of fewer stages."""

    def __init__(self, limits: SearchLimits, blanks: Blanks | None = None, clearance: float = 0.0) -> None:
        pairs = pairs_within(limits)
        self._searches = [
            TrainSearch(replace(limits, stages=count, fewer=False), blanks, clearance, pairs)
            for count in range(1, limits.stages + 1)
        ]

    def best(self, keep: int) -> tuple[TrainPlay, ...]:
        """The `keep` trains of the least greatest return error of all numbers of stages, best first.

        Raises `DesignError` if there is none of any number.
        """
        found: list[TrainPlay] = []
        for number, search in enumerate(self._searches, 1):
            if found:
                search.without_even_pairs()
            try:
                found += search.best(keep)
            except DesignError:
                if number == len(self._searches) and not found:
                    raise
        return tuple(sorted(found, key=lambda play: play.return_error_max)[:keep])

    def exclude(self, stage: Stage) -> None:
        """Leave out a pair, at every place of every number of stages.

        Args:
            stage: pair whose teeth cannot be made, or fail their checks.
        """
        for search in self._searches:
            search.exclude(stage)


def _stage(pairs: Pairs, row: int, limits: SearchLimits) -> SpurPair:
    teeth, module = (int(pairs.driver[row]), int(pairs.driven[row])), float(pairs.module[row])
    driver, driven = (
        replace(
            limits.pattern,
            form=form_of(limits, z, module, float(pairs.width[row])),
            overrides=ToleranceOverrides(),
        )
        for z in teeth
    )
    return SpurPair(
        driver=driver,
        driven=driven,
        centre_distance=module * sum(teeth) / 2,
        bearing_span=limits.bearing_span,
    )
