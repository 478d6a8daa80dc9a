"""Deviations of a gear's flanks by ISO 1328-1:2013, and the errors of the part that they come from.

Seen on the measured face, teeth are counted clockwise; right flanks look along the count. A deviation is positive where
there is too much material; a pitch where it is too long. Let α be the transverse pressure angle and φ_k the angle of
tooth k along the count. Let s be +1 for right flanks and −1 for left ones. A flank stands beside the middle of its
tooth, so let δ = α less half the angle of a tooth. Then errors show so:

- teeth off the axis by e towards ψ: index deviation e sin(ψ − φ_k + s δ)/cos α, along the normal e sin(s(ψ − φ_k) + δ);
- an index that is off by the machine's table: alike on both flanks;
- base radius r_b off by Δr_b: profile slope L Δr_b/r_b on both flanks, pressure angle off by −f_Hα/(L tan α);
- a hob of one start off its axis by e: e sin α, once in each base pitch of the length of roll, alike on all teeth;
- a ring: right flanks look along the count, too, δ = −(α + half the angle of a tooth), and its lines run from root to
  tip, so that slopes have the sign above;
- lead off: helix slopes of opposite sign on both flanks; taper: of one sign; an axis that leans by τ: helix slope
  τ b sin(s(ψ − φ_k) + δ).

The eccentric part and the table's are told apart because δ has the other sign on the other flanks. Slopes are those of
least-squares lines over the range of evaluation, extrapolated over the whole length L from the control to the tip
diameter, or over the facewidth b; f_Hα, f_Hβ, form and total are the worst of all measured teeth.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan, cos, hypot, pi, sin, sqrt, tan

import numpy as np
from scipy.special import ndtri, stdtrit

from cadgen.arrays import Array
from cadgen.gears.tooth import GearForm
from cadgen.inference.gearing.flank_kinds import INDEX, LEFT, RIGHT
from cadgen.inference.measurement.record import Record

_UM = 1e-3


@dataclass(frozen=True)
class Sized:
    """Size with its standard deviation, mm or rad."""

    value: float
    sigma: float

    @property
    def clear(self) -> bool:
        """Whether it differs from 0 by four standard deviations."""
        return abs(self.value) > 4 * self.sigma


@dataclass(frozen=True, kw_only=True)
class FlankFigure:
    """Deviation of one symbol on both flanks, mm; None where a flank was not measured."""

    symbol: str
    left: float | None
    right: float | None

    @property
    def worst(self) -> float:
        """Greater size of both flanks, mm."""
        return max(abs(each) for each in (self.left, self.right) if each is not None)


@dataclass(frozen=True, kw_only=True)
class PitchErrors:
    """Pitch of all teeth, mm and rad.

    Attributes:
        measured: f_p, F_p, and F_r where both flanks were measured.
        off: eccentricity of the teeth; None where it is not told from the table's error.
        towards: angle along the count from tooth 1 to where they stand out, rad.
        table: amplitude of the index error that is alike on both flanks; None where not told from an eccentricity.
        once: amplitude once a turn, where one flank alone was measured, or both fit the table and an eccentricity.
    """

    measured: tuple[FlankFigure, ...]
    off: Sized | None
    towards: float
    table: Sized | None
    once: Sized | None


@dataclass(frozen=True, kw_only=True)
class ProfileErrors:
    """Profile lines, mm and rad.

    Attributes:
        measured: f_Halpha, f_falpha, F_alpha.
        pressure_angle: error of the transverse pressure angle.
        tool: error of the normal pressure angle, as of the tool.
        cutter: run-out of a hob of one start, from axis to axis; None where the lines are shorter than a base pitch.
        covered: part of the evaluation range that the shortest line covers.
        between: half the difference of the slopes of right and left flanks, mm: a tool that leans.
    """

    measured: tuple[FlankFigure, ...]
    pressure_angle: Sized
    tool: Sized
    cutter: Sized | None
    covered: float
    between: Sized | None


@dataclass(frozen=True, kw_only=True)
class HelixErrors:
    """Helix lines, mm and rad.

    Attributes:
        measured: f_Hbeta, f_fbeta, F_beta.
        lead: mean helix slope, of right flanks with its sign, mm over `length`: another helix angle.
        taper: mean slope of one sign on both flanks, mm; None with one flank.
        leaning: angle by which the axis leans; None with fewer than three teeth.
        length: facewidth, mm.
        covered: part of the evaluation range that the shortest line covers.
        angle: error of the helix angle at the reference circle, above 0 towards a right hand where `face_mm` grows
            from the measured face into the gear.
    """

    measured: tuple[FlankFigure, ...]
    lead: Sized
    taper: Sized | None
    leaning: Sized | None
    length: float
    covered: float
    angle: Sized


def _both(symbol: str, values: dict[str, float]) -> FlankFigure:
    return FlankFigure(symbol=symbol, left=values.get(LEFT), right=values.get(RIGHT))


def _sides(record: Record) -> Array:
    return np.where(record.columns["flank"] == RIGHT, 1.0, -1.0)


def _lean(form: GearForm) -> float:
    """Angle δ by which an eccentric gear's right flanks lead its teeth, rad."""
    alpha, half = form.transverse_pressure_angle, form.half_angle(form.reference_diameter)
    # Of a ring that is half a space, and normals point inwards.
    return alpha - half if form.side > 0 else half - pi / form.teeth - alpha


def pitch_errors(record: Record, form: GearForm) -> PitchErrors:
    """Errors of the pitch of all teeth of a gear.

    Args:
        record: single or cumulative pitch of each tooth on one flank or both.
        form: gear.
    """
    teeth, alpha, lean = form.teeth, form.transverse_pressure_angle, _lean(form)
    flanks = record.columns["flank"]
    single: dict[str, float] = {}
    total: dict[str, float] = {}
    index: dict[str, Array] = {}
    for flank in (LEFT, RIGHT):
        runs = []
        for run in range(record.runs):
            mine = (flanks == flank) & (record.run == run)
            if not mine.any():
                continue
            order = np.argsort(record["tooth"][mine])
            if record.kind is INDEX:
                runs.append(_UM * record["index_um"][mine][order])
            else:
                # The pitches of a turn add up to none; what the machine adds is its drift.
                pitch = _UM * record["pitch_um"][mine][order]
                runs.append(np.cumsum(pitch - pitch.mean()))
        if not runs:
            continue
        mean = np.mean(runs, axis=0)
        index[flank] = mean - mean.mean()
        pitches = np.diff(mean, prepend=mean[-1])
        single[flank] = float(np.abs(pitches).max())
        total[flank] = float(np.ptp(mean))
    measured = [_both("f_p", single), _both("F_p", total)]
    place = 2 * pi * np.arange(teeth) / teeth
    rows, values = [], []
    for flank, side in ((LEFT, -1.0), (RIGHT, 1.0)):
        if flank in index:
            turn = -place + side * lean
            rows.append(np.stack([np.sin(turn), np.cos(turn), np.sin(-place), np.cos(-place)], axis=1))
            values.append(index[flank])
    columns, data = np.concatenate(rows), np.concatenate(values)
    slow = _slow_noise(values, walks=record.kind is not INDEX)
    if len(values) < 2:
        solved, sigmas = _solved(columns[:, 2:], data, slow)
        once = Sized(hypot(*solved), float(np.mean(sigmas)))
        return PitchErrors(measured=tuple(measured), off=None, towards=0.0, table=None, once=once)
    solved, sigmas, sure = _fewest(columns, data, slow)
    off = Sized(hypot(solved[0], solved[1]) * cos(alpha), float(np.mean(sigmas[:2])) * cos(alpha))
    table = Sized(hypot(solved[2], solved[3]), float(np.mean(sigmas[2:])))
    # A ball in a space moves out where the space is narrow. Its flanks lie on neighbouring teeth; their normals lean by
    # α and half the angle of the space against the tangent at its middle. In a ring it moves in, and they lean by the
    # difference of the two.
    narrow = np.roll(index[RIGHT], 1) - index[LEFT]
    half = form.half_angle(form.reference_diameter)
    out = narrow * cos(alpha) / (2 * sin(alpha + pi / teeth - half if form.side > 0 else alpha - half))
    measured.append(FlankFigure(symbol="F_r", left=float(np.ptp(out)), right=None))
    if not sure:
        alike, spread = _solved(columns[:, 2:], data, slow)
        once = Sized(hypot(*alike), float(np.mean(spread)))
        return PitchErrors(measured=tuple(measured), off=None, towards=0.0, table=None, once=once)
    return PitchErrors(
        measured=tuple(measured),
        off=off,
        towards=float(np.arctan2(solved[1], solved[0]) % (2 * pi)),
        table=table,
        once=None,
    )


_PART = 12.0  # χ² that a further part must explain
_TOLD = 6.0  # χ² by which one of two causes must fit better: odds of 20 to 1
_SLOW = range(2, 9)  # orders by which the index errors of once a turn are judged
_FALLS = np.linspace(0.0, 2.0, 11)  # exponents with which their power may fall


def _slow_noise(index: Sequence[Array], *, walks: bool) -> float:
    """Variance of an index whose errors all were as slow as once a turn, mm²; neighbouring teeth have much the same.

    Sums of single pitches walk: their power falls with the order k as 1/sin²(π k/z). So does an index that a machine
    has added up of pitches itself; one that was read as such need not fall. So its exponent p is that of the record,
    each from 0 to 2 weighed by its likelihood: powers P are exponential about s k^-p, with the mean of P k^p for s.

    Args:
        index: deviations of all z teeth, mm, by flank.
        walks: whether the index is a sum of single pitches.
    """
    teeth = len(index[0])
    orders = np.array([k for k in (range(2, teeth) if walks else _SLOW) if k <= teeth // 2], dtype=float)
    if not orders.size:
        return 0.0
    power = np.concatenate([2 * np.abs(np.fft.rfft(each)[orders.astype(int)] / teeth) ** 2 for each in index])
    order = np.tile(orders, len(index))
    if walks:
        return float(np.mean(power * (np.sin(pi * order / teeth) / sin(pi / teeth)) ** 2)) * teeth / 2
    size = np.maximum((power * order ** _FALLS[:, None]).mean(axis=1), _LEAST**2)
    likely = _FALLS * np.log(order).sum() - len(order) * np.log(size)
    weight = np.exp(likely - likely.max())
    return float(size @ weight / weight.sum()) * teeth / 2


def _fewest(columns: Array, data: Array, slow: float) -> tuple[Array, Array, bool]:
    """Coefficients of eccentricity and of the table's error with their deviations; 0 for one that is not needed.

    Last whether the one that is needed is told from the other.
    """
    whole, _ = _solved(columns, data)
    noise = max(float(np.sum((data - columns @ whole) ** 2)) / max(len(data) - 4, 1), slow, _LEAST**2)
    found = []
    for part in (slice(0, 2), slice(2, 4), slice(0, 4)):
        solved, sigmas = _solved(columns[:, part], data, noise)
        cost = float(np.sum((data - columns[:, part] @ solved) ** 2)) / noise + _PART * (part.stop - part.start) / 2
        values, spread = np.zeros(4), np.zeros(4)
        values[part], spread[part] = solved, sigmas
        found.append((cost, values, spread))
    costs = [cost for cost, _, _ in found]
    best = int(np.argmin(costs))
    return found[best][1], found[best][2], best == 2 or abs(costs[0] - costs[1]) > _TOLD


_LEAST = 1e-6  # mm: no machine reads finer


def _solved(columns: Array, data: Array, least: float = _LEAST**2) -> tuple[Array, Array]:
    """Least squares and standard deviations, from what is left, or a greater variance."""
    solved = np.linalg.lstsq(columns, data, rcond=None)[0]
    rest = data - columns @ solved
    noise = max(float(rest @ rest) / max(len(data) - columns.shape[1], 1), least)
    spread: Array = np.sqrt(noise * np.diag(np.linalg.pinv(columns.T @ columns)))
    return solved.astype(float), spread


EVALUATED = 0.95  # part of the usable length of roll, from the control diameter, that is evaluated (ISO 1328-1:2013)
END = 0.05  # part of the facewidth left out at each end, at most one module (ISO 1328-1:2013)
_EDGE = 1e-6  # mm by which a range is wider, for points that lie on its end


@dataclass(frozen=True)
class Range:
    """Evaluation range of flank lines, and reference length of their slopes, mm.

    Attributes:
        start, end: of the evaluation.
        whole: length over which the mean line is extrapolated to tell its slope: from the control to the tip
            diameter, or the facewidth.
    """

    start: float
    end: float
    whole: float

    def covered(self, places: Array) -> float:
        """Part of the evaluation range over which points lie.

        Args:
            places: of the points, mm.
        """
        within = places[(places >= self.start - _EDGE) & (places <= self.end + _EDGE)]
        return float(np.ptp(within)) / (self.end - self.start) if within.size else 0.0


def profile_range(control: float, tip: float) -> Range:
    """Range of evaluation of profile lines, along the length of roll.

    Args:
        control: length of roll at the profile control diameter, where contact begins, mm.
        tip: at the tip form diameter, mm.
    """
    return Range(control, control + EVALUATED * (tip - control), tip - control)


def helix_range(width: float, module: float, places: Array) -> Range:
    """Range of evaluation of helix lines, along the axis: the facewidth less an end zone on both sides.

    Args:
        width: facewidth b, mm.
        module: normal module, mm.
        places: of the points, whose middle is that of the facewidth, mm.
    """
    middle = float(places.max() + places.min()) / 2
    half = width / 2 - min(END * width, module)
    return Range(middle - half, middle + half, width)


@dataclass(frozen=True)
class _Line:
    """Mean line of one trace: its slope over the whole length, that slope's deviation, form and total, mm."""

    tooth: int
    side: float
    slope: float
    sigma: float
    form: float
    total: float
    x: Array
    y: Array


def _traces(record: Record, along: str, reading: str, over: Range) -> list[_Line]:
    side, found = _sides(record), []
    place = record[along]
    within = (place >= over.start - _EDGE) & (place <= over.end + _EDGE)
    for run in range(record.runs):
        for tooth in np.unique(record["tooth"][record.run == run]):
            for each in (-1.0, 1.0):
                mine = within & (record.run == run) & (record["tooth"] == tooth) & (side == each)
                if np.unique(place[mine]).size < 3:
                    continue
                x, y = place[mine], _UM * record[reading][mine]
                (steepness, _), (sigma, _) = _solved(np.stack([x - x.mean(), np.ones_like(x)], axis=1), y)
                rest = y - y.mean() - steepness * (x - x.mean())
                whole = over.whole
                found.append(
                    _Line(
                        tooth=int(tooth),
                        side=each,
                        slope=float(steepness) * whole,
                        sigma=float(sigma) * whole,
                        form=float(np.ptp(rest)),
                        total=float(np.ptp(y)),
                        x=x,
                        y=y,
                    )
                )
    return found


def _covered(record: Record, along: str, over: Range) -> float:
    """Part of the evaluation range that the shortest line covers."""
    side, tooth, places = _sides(record), record["tooth"], record[along]
    lines = sorted(set(zip(record.run.tolist(), tooth.tolist(), side.tolist(), strict=True)))
    return min(over.covered(places[(record.run == r) & (tooth == t) & (side == s)]) for r, t, s in lines)


def _by_flank(lines: Sequence[_Line], slope: str, form: str, total: str) -> tuple[FlankFigure, ...]:
    slopes: dict[str, float] = {}
    forms: dict[str, float] = {}
    totals: dict[str, float] = {}
    for flank, side in ((LEFT, -1.0), (RIGHT, 1.0)):
        mine = [line for line in lines if line.side == side]
        if mine:
            slopes[flank] = max((line.slope for line in mine), key=abs)
            forms[flank] = max(line.form for line in mine)
            totals[flank] = max(line.total for line in mine)
    return _both(slope, slopes), _both(form, forms), _both(total, totals)


def _by_few(free: int) -> float:
    """Factor of a deviation found from few, by Student's distribution, so that four of it are as rare as of many."""
    return float(stdtrit(free, _RARE) / ndtri(_RARE))


_RARE = 0.999


def _pooled(values: Array, sides: Array, noise: float) -> dict[float, Sized]:
    """Mean on each flank, with the scatter between teeth of both, and no less than the noise of one line."""
    means = {side: float(values[sides == side].mean()) for side in np.unique(sides)}
    free = len(values) - len(means)
    scatter = sum(float(np.sum((values[sides == side] - mean) ** 2)) for side, mean in means.items())
    spread = max(sqrt(scatter / free) * _by_few(free) if free else 0.0, noise, _LEAST)
    return {side: Sized(mean, spread / sqrt(float(np.sum(sides == side)))) for side, mean in means.items()}


def _cutter(lines: Sequence[_Line], pitch: float, whole: float, sides: Array) -> tuple[Sized, dict[float, Sized]]:
    """Amplitude that goes round once in a base pitch of roll, alike on all teeth, and slopes without it.

    Hobs of one start turn once while a tooth is made, so what is off their axis shows once in each base pitch. A
    straight edge cuts no hollow: of waves over L/z², with the length of roll L, the gear shows less.
    """
    fits = [
        _solved(
            np.stack(
                [
                    np.sin(2 * pi * line.x / pitch),
                    np.cos(2 * pi * line.x / pitch),
                    line.x - line.x.mean(),
                    np.ones_like(line.x),
                ],
                axis=1,
            ),
            line.y,
        )
        for line in lines
    ]
    values, sigmas = (np.array([fit[part] for fit in fits]) for part in (0, 1))
    waves = [_pooled(values[:, n], sides, float(np.sqrt(np.mean(sigmas[:, n] ** 2)))) for n in (0, 1)]
    slopes = _pooled(whole * values[:, 2], sides, whole * float(np.sqrt(np.mean(sigmas[:, 2] ** 2))))
    flanks = [hypot(waves[0][side].value, waves[1][side].value) for side in slopes]
    spread = hypot(*(wave.sigma for part in waves for wave in part.values())) / (sqrt(2) * len(flanks))
    return Sized(float(np.mean(flanks)), spread), slopes


def profile_errors(record: Record, form: GearForm, over: Range) -> ProfileErrors | None:
    """Errors of the profile of a gear; None without a line of three points.

    Args:
        record: profile lines by the length of roll, of a ring by that below 0, which grows to its tip.
        form: gear.
        over: range of evaluation.
    """
    lines = _traces(record, "roll_length_mm", "profile_um", over)
    if not lines:
        return None
    sides = np.array([line.side for line in lines])
    noise = sqrt(float(np.mean([line.sigma**2 for line in lines])))
    slopes = _pooled(np.array([line.slope for line in lines]), sides, noise)
    pitch = pi * form.base_diameter / form.teeth
    off, cutter = None, None
    # No hob cuts a ring.
    if form.side > 0 and all(np.unique(line.x).size > 6 and np.ptp(line.x) > pitch for line in lines):
        wave, without = _cutter(lines, pitch, over.whole, sides)
        alpha = form.transverse_pressure_angle
        off, cutter = Sized(wave.value / sin(alpha), wave.sigma / sin(alpha)), without
    if cutter is not None and off is not None and off.clear:
        slopes = cutter
    flanks = list(slopes.values())
    middle = Sized(
        float(np.mean([each.value for each in flanks])), hypot(*(each.sigma for each in flanks)) / len(flanks)
    )
    between = None
    if len(flanks) == 2:
        between = Sized((slopes[1.0].value - slopes[-1.0].value) / 2, hypot(*(each.sigma for each in flanks)) / 2)
    # The tool's angle lies in the normal section: tan α_n = tan α_t cos β.
    by_slope = 1 / (over.whole * tan(form.transverse_pressure_angle))
    normal = (
        cos(form.helix_angle) * (cos(form.normal_pressure_angle) / cos(form.transverse_pressure_angle)) ** 2 * by_slope
    )
    return ProfileErrors(
        measured=_by_flank(lines, "f_Halpha", "f_falpha", "F_alpha"),
        pressure_angle=Sized(-middle.value * by_slope, middle.sigma * by_slope),
        tool=Sized(-middle.value * normal, middle.sigma * normal),
        cutter=off,
        covered=_covered(record, "roll_length_mm", over),
        between=between,
    )


def helix_errors(record: Record, form: GearForm) -> HelixErrors | None:
    """Errors of the helix of a gear; None without a line of three points.

    Args:
        record: helix lines along the axis.
        form: gear.
    """
    over = helix_range(form.width, form.normal_module, record["face_mm"])
    lines = _traces(record, "face_mm", "helix_um", over)
    if not lines:
        return None
    side = np.array([line.side for line in lines])
    slope = np.array([line.slope for line in lines])
    place = 2 * pi * (np.array([line.tooth for line in lines]) - 1) / form.teeth
    both = np.unique(side).size == 2
    alpha, lean = form.transverse_pressure_angle, _lean(form)
    leans = len({line.tooth for line in lines}) >= 3 and len(lines) > 4
    columns = [side] + ([np.ones(len(lines))] if both else [])
    if leans:
        columns += [np.sin(lean - side * place), side * np.cos(lean - side * place)]
    solved, sigmas = _solved(np.stack(columns, axis=1), slope)
    sigmas = sigmas * _by_few(max(len(lines) - len(columns), 1))
    floor = sqrt(float(np.mean([line.sigma**2 for line in lines])) / len(lines))
    lead = Sized(float(solved[0]), max(float(sigmas[0]), floor))
    taper = Sized(float(solved[1]), max(float(sigmas[1]), floor)) if both else None
    leaning = None
    if leans:
        leaning = Sized(hypot(*solved[-2:]) / over.whole, max(float(np.mean(sigmas[-2:])), floor) / over.whole)
    beta = form.helix_angle
    off = atan(tan(beta) + lead.value / (cos(alpha) * over.whole)) - beta
    return HelixErrors(
        measured=_by_flank(lines, "f_Hbeta", "f_fbeta", "F_beta"),
        lead=lead,
        taper=taper,
        leaning=leaning,
        length=over.whole,
        covered=_covered(record, "face_mm", over),
        angle=Sized(off, lead.sigma / (cos(alpha) * over.whole) * cos(beta) ** 2),
    )
