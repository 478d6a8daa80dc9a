"""The stages that a search may choose from, as arrays, and where they fit: in their blanks, and beside each other."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import cos, inf, tan

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.errors import DesignError
from cadgen.gears.backlash import StagePlay, play_equations
from cadgen.gears.blank import fits
from cadgen.gears.chains import BoolArray, Fit
from cadgen.gears.contact import LEAST_ROOT_CLEARANCE
from cadgen.gears.layout import Blanks, collar_length
from cadgen.gears.limits import SearchLimits
from cadgen.gears.pair import CENTRE_DISTANCE_ROUNDING
from cadgen.gears.tolerances import COVERED_DIAMETERS, centre_distance_deviation, gear_tolerances
from cadgen.gears.tooth import GearForm, involute
from cadgen.gears.undercut import contact_ratios, missing_shifts

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


def pairs_within(limits: SearchLimits) -> Pairs:
    """Every pair within the limits whose gears the standards cover, with its greatest return error."""
    teeth = np.arange(limits.teeth[0], limits.teeth[1] + 1)
    if teeth.size**2 * len(limits.modules) * len(limits.widths) > MOST_PAIRS:
        raise DesignError(
            f"the search has {teeth.size} tooth numbers, {len(limits.modules)} modules and {len(limits.widths)} widths"
            f" to choose from, more than {MOST_PAIRS // 1_000_000} million pairs; narrow them"
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
    """Those pairs whose teeth do not jam, clear the roots, and keep the limits of undercut and contact ratio.

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
        (least_play > 0, "none has play at the closest axes and the thickest teeth; thin the teeth more"),
        (
            clearance >= LEAST_ROOT_CLEARANCE,
            f"none clears the roots by {LEAST_ROOT_CLEARANCE:g} modules; raise dedendum_factor",
        ),
        (
            missing <= limits.undercut,
            f"each has more undercut than {limits.undercut:g}; allow more teeth or more undercut",
        ),
    ):
        kept = _kept(kept, holds, limits, cure)
    pairs = pairs.where(kept)
    teeth = pairs.driver.astype(np.float64), pairs.driven.astype(np.float64)
    ratios = contact_ratios(form, teeth, pairs.shifts, form.tip_chamfer / pairs.module)
    low = f"none has a contact ratio of {limits.contact_ratio:g}; allow more teeth or a smaller contact ratio"
    return pairs.where(_kept(np.ones(ratios.shape, dtype=np.bool_), ratios >= limits.contact_ratio, limits, low))


def _kept(before: BoolArray, holds: BoolArray, limits: SearchLimits, cure: str) -> BoolArray:
    kept = before & holds
    if before.any() and not kept.any():
        raise DesignError(f"no train of {limits}: of {int(before.sum())} pairs of gears that are left {cure}")
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
    shafts = [blanks.drive, *[blanks.intermediate] * (stages - 1), blanks.output]
    bores = [blank.bore_diameter / 2 for blank in shafts]
    hubs = [blank.hub.diameter / 2 if blank.hub else 0.0 for blank in shafts]
    collar = blanks.intermediate.hub
    rubbing = wheel if collar and collar.length < clearance else np.zeros_like(wheel)

    def past(size: float | Array) -> Array:
        """Room that the axes of a stage leave beside a body of a radius on one shaft; any if there is no body."""
        return np.where(np.asarray(size) > 0, pairs.axes - size - clearance + ROOM_SLACK, inf)

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
        after=np.array([past(np.maximum(bore, rubbing)) for bore in bores[2:]]).reshape(-1, wheel.size),
        before=np.array([past(bore) for bore in bores[:-2]]).reshape(-1, wheel.size),
        height=pairs.width,
        most_height=limits.bearing_span - _length_of_hubs(blanks, stages, clearance),
    )


def _length_of_hubs(blanks: Blanks, stages: int, clearance: float) -> float:
    """Share of the bearing span that hubs and collars take, in mm."""
    ends = sum(blank.hub.length for blank in (blanks.drive, blanks.output) if blank.hub)
    collar = blanks.intermediate.hub
    return ends + (stages - 1) * (collar.length if collar else collar_length(clearance))


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

    first = ask(pairs.driver, pairs.shifts[0], lambda form: fits(form, blanks.drive))
    later = ask(pairs.driver, pairs.shifts[0], lambda form: fits(form, blanks.intermediate, upper=True))
    before = ask(pairs.driven, pairs.shifts[1], lambda form: fits(form, blanks.intermediate, upper=False))
    last = ask(pairs.driven, pairs.shifts[1], lambda form: fits(form, blanks.output))
    return np.array(
        [
            (first if place == 0 else later) & (last if place == limits.stages - 1 else before)
            for place in range(limits.stages)
        ]
    )


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
