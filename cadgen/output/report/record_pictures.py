"""Pictures of one record's verdict: residual before and after, spectrum or plan view, candidates."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations.effect import UNITS
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis, PathDiagnosis
from cadgen.inference.measurement.record import Abscissa
from cadgen.output.report.style import (
    AFTER,
    BEFORE,
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    SKY,
    VERMILLION,
    WANTED,
    figure,
    zero_line,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIGNS = {"um": "µm", "deg": "°", "mm": "mm"}
_RUNS = (BLUE, VERMILLION, GREEN, ORANGE, SKY)
_MANY_RUNS = "viridis"  # from the first run to the last, where there are more
_START_SHARE = 0.03  # of a track, over which its direction at the start is taken
_ORDERS = 60
_CANDIDATES = 7
_NAME = 64  # characters of a candidate that fit its bar's line
_MAGNIFIED = 10.0  # a scale this many times finer is noted in the title


@contextmanager
def record_picture(diagnosis: Diagnosis, length: float | None) -> Iterator["Figure"]:
    """Draw the residuals and candidates of a verdict.

    Args:
        diagnosis: verdict with residuals; for tracks, with the measured points.
        length: length of the track, mm, along which a track's residual is drawn; None for other data.
    """
    with figure(11.5, 7.0) as picture:
        claimed = ", ".join(diagnosis.judgement.claimed)
        verdict = f"{diagnosis.verdict}: {claimed}" if claimed else diagnosis.verdict
        picture.suptitle(f"{diagnosis.kind.code}: {diagnosis.source}. {verdict}", x=0.01, ha="left", fontsize=10)
        grid = picture.add_gridspec(2, 2, width_ratios=(1.5, 1.0))
        before = picture.add_subplot(grid[0, 0])
        after = picture.add_subplot(grid[1, 0], sharex=before)
        upper, lower = picture.add_subplot(grid[0, 1]), picture.add_subplot(grid[1, 1])
        plan, unit = diagnosis.kind.plan_view, SIGNS[diagnosis.unit]
        without = _from_the_start(diagnosis) if plan else diagnosis.before
        _residual(before, diagnosis, without, length)
        _residual(after, diagnosis, diagnosis.after, length)
        assert isinstance(diagnosis, EvidenceDiagnosis | PathDiagnosis)
        rms = diagnosis.residual.before, diagnosis.residual.after
        several = f", {diagnosis.runs} runs, coloured from the first to the last" if _many(diagnosis) else ""
        space = "" if unit == "°" else " "
        unit = f"{space}{unit}{' per coordinate' if plan and isinstance(diagnosis, EvidenceDiagnosis) else ''}"
        before.set_title(f"before: rms {_three(rms[0])}{unit}{', if the start is fitted too' if plan else ''}{several}")
        finer = rms[0] / rms[1] if rms[1] > 0 else 1.0
        scale = f"; scale {finer:.0f} times finer" if finer > _MAGNIFIED else ""
        after.set_title(f"after: rms {_three(rms[1])}{unit}{scale}")
        after.set_xlabel(diagnosis.kind.abscissa.value)
        _runs_legend(before, diagnosis)
        if plan:
            _plan(upper, diagnosis, without)
        else:
            _spectrum(upper, diagnosis)
        _candidates(lower, diagnosis)
        yield picture


def _three(value: float) -> str:
    """A number of three digits, without a power of ten."""
    return f"{float(f'{value:.3g}'):.12g}"


def _abscissa(diagnosis: Diagnosis, length: float | None) -> Array:
    """Abscissa of each row, in its unit."""
    match diagnosis.kind.abscissa:
        case Abscissa.CAM_ANGLE:
            return np.degrees(diagnosis.place)
        case Abscissa.TRAVEL:
            assert length is not None
            return diagnosis.place / TURN * (length / 1000)
        case Abscissa.SHARE:
            return diagnosis.place / TURN * 100.0


def _runs_legend(axes: "Axes", diagnosis: Diagnosis) -> None:
    """Name the runs by their colours, and the ways of the cam by their marks, in a row above the curves."""
    handles, labels = axes.get_legend_handles_labels()
    if diagnosis.runs == 1:
        handles, labels = [], []
    for _, mark, way in _ways(diagnosis):
        if way:
            handles += axes.plot([], [], mark, color=BLACK, markersize=2.5)
            labels.append(way)
    if labels:
        low, high = axes.get_ylim()
        axes.set_ylim(low, high + 0.12 * (high - low))  # room for the legend above the curves
        how = {"fontsize": 8, "frameon": True, "edgecolor": "none", "markerscale": 2.0}
        axes.legend(handles, labels, loc="upper right", ncols=len(labels), columnspacing=1.2, **how)


def _many(diagnosis: Diagnosis) -> bool:
    return diagnosis.runs > len(_RUNS)


def _ways(diagnosis: Diagnosis) -> "list[tuple[NDArray[np.bool_], str, str]]":
    """Rows by the way that the cam was turned, with the mark of each and its name; without one if there is one way."""
    everywhere = np.ones(len(diagnosis.place), dtype=bool)
    back = diagnosis.backwards
    if back is None or not 0 < back.sum() < len(back):
        return [(everywhere, ".", "")]
    return [(~back, ".", "forward"), (back, "x", "reverse")]


def _residual(axes: "Axes", diagnosis: Diagnosis, residual: Array, length: float | None) -> None:
    """Draw the residual of each run: readings as points, or the distance from a track as a line."""
    from matplotlib import colormaps

    place, unit = _abscissa(diagnosis, length), SIGNS[diagnosis.unit]
    values = residual / UNITS[diagnosis.unit]
    scale = colormaps[_MANY_RUNS](np.linspace(0.0, 0.9, diagnosis.runs))
    for run in range(diagnosis.runs):
        color = scale[run] if _many(diagnosis) else _RUNS[run]
        rows = diagnosis.run == run
        # Of many runs the first and the last are named.
        name = f"run {run + 1}" if not _many(diagnosis) or run in (0, diagnosis.runs - 1) else ""
        if not diagnosis.kind.plan_view:
            for number, (way, mark, _) in enumerate(_ways(diagnosis)):
                axes.plot(
                    place[rows & way],
                    values[rows & way],
                    mark,
                    color=color,
                    markersize=2.0 if mark == "." else 2.5,
                    markeredgewidth=0.6,
                    alpha=0.6,
                    rasterized=True,
                    label="" if number else name,
                )
        else:
            x, y = np.split(values[rows], 2)
            axes.plot(place[rows][: len(x)], np.hypot(x, y), color=color, linewidth=0.9, label=name)
    if not diagnosis.kind.plan_view:
        if isinstance(diagnosis, EvidenceDiagnosis):
            noise = diagnosis.residual.noise
            axes.axhspan(-2 * noise, 2 * noise, color=GREY, alpha=0.2, linewidth=0)
        zero_line(axes)
        axes.set_ylabel(f"measured less expected ({unit})")
    else:
        axes.set_ylim(bottom=0)
        axes.set_ylabel(f"distance from the path ({unit})")


def _spectrum(axes: "Axes", diagnosis: Diagnosis) -> None:
    """Draw the amplitude by order, runs together, beside the amplitude of noise alone."""
    orders = np.arange(1, _ORDERS + 1)
    waves = np.exp(-1j * diagnosis.place[:, None] * orders)
    for residual, color, label, mark in (
        (diagnosis.before, BEFORE, "before", "o"),
        (diagnosis.after, AFTER, "after", "s"),
    ):
        amplitude = 2 * np.abs(np.mean(waves * residual[:, None], axis=0)) / UNITS[diagnosis.unit]
        axes.semilogy(orders, amplitude, color=color, marker=mark, markersize=2.5, linewidth=0.8, label=label)
    if isinstance(diagnosis, EvidenceDiagnosis):
        noise = diagnosis.residual.noise * np.sqrt(np.pi / len(diagnosis.place))
        axes.axhline(noise, color=GREY, linestyle="--", linewidth=1, label="noise alone")
    axes.set(title="amplitude by order", xlabel="waves round the cam", ylabel=SIGNS[diagnosis.unit])
    axes.legend(loc="upper right", fontsize=8, ncols=3, frameon=True, edgecolor="none")
    axes.margins(y=0.15)


def _plan(axes: "Axes", diagnosis: Diagnosis, without: Array) -> None:
    """Draw the measured and the expected path of the first run, both expected ones from the start that was found.

    `without` is the residual before, as of `_from_the_start`.
    """
    assert diagnosis.measured is not None
    first_run = diagnosis.run == 0
    measured = np.stack(np.split(diagnosis.measured[first_run], 2)) / 1000
    lines: tuple[tuple[Array, str, object, float, str], ...] = (
        (diagnosis.measured - without, BEFORE, (0, (5, 2)), 1.2, "expected before"),
        (diagnosis.measured - diagnosis.after, AFTER, "-", 1.2, "expected after"),
    )
    axes.plot(*measured, ".", color=WANTED, markersize=3.5, label="measured")
    for path, color, style, width, label in lines:
        x, y = np.split(path[first_run], 2)
        axes.plot(x / 1000, y / 1000, color=color, linestyle=style, linewidth=width, label=label)
    axes.plot(*measured[:, 0], "o", color=WANTED, markersize=7, fillstyle="none")
    axes.set(title="plan view, run 1 (circle: start)", xlabel="x (m)", ylabel="y (m)", aspect="equal")
    axes.set_adjustable("datalim")
    axes.legend(loc="best", fontsize=8, frameon=True, edgecolor="none")


def _from_the_start(diagnosis: Diagnosis) -> Array:
    """Residual before, each run's expected track moved as a whole so that it starts where and as the one after does.

    The residual of the diagnosis has the start pose fitted to the whole track: drawn so, a wrong radius looks like a
    wrong start, and not like an error that grows along the run.
    """
    assert diagnosis.measured is not None
    residual = np.empty(len(diagnosis.before))
    for run in range(diagnosis.runs):
        rows = diagnosis.run == run
        x, y = np.split(diagnosis.measured[rows], 2)
        before, after = (
            x - across + 1j * (y - up)
            for across, up in (np.split(part[rows], 2) for part in (diagnosis.before, diagnosis.after))
        )
        ahead = max(1, round(_START_SHARE * len(x)))
        first, second = before[ahead] - before[0], after[ahead] - after[0]
        turn = second / abs(second) * abs(first) / first if first and second else 1.0
        off = x + 1j * y - (after[0] + turn * (before - before[0]))
        residual[rows] = np.concatenate([off.real, off.imag])
    return residual


def _candidates(axes: "Axes", diagnosis: Diagnosis) -> None:
    """Draw the best subsets of effects and the bare design, by their score above the best."""
    by_paths = isinstance(diagnosis, PathDiagnosis)
    best = [c for c in diagnosis.candidates if c.effects][: _CANDIDATES - 1]
    shown = sorted([*best, *(c for c in diagnosis.candidates if not c.effects)], key=lambda c: c.score)
    rows = np.arange(len(shown))
    bars = axes.barh(rows + 0.22, [c.score for c in shown], height=0.34, color=SKY)
    axes.bar_label(bars, fmt=lambda score: f"{score:.{1 if score < 1000 else 0}f}", padding=3, fontsize=8)
    for row, candidate in zip(rows, shown, strict=True):
        names = ", ".join(candidate.effects) or "no effect"
        shown_name = names if len(names) <= _NAME else f"{names[: _NAME - 1]}…"
        axes.text(0.01, float(row), shown_name, transform=axes.get_yaxis_transform(), fontsize=7.5, va="bottom")
    axes.set_xscale("symlog", linthresh=10)
    axes.set_ylim(len(shown) - 0.4, -0.5)
    axes.set_xlim(0, max(c.score for c in shown) * 4 + 10)
    axes.set_yticks([])
    axes.grid(axis="y", visible=False)
    axes.set_title("candidates")
    axes.set_xlabel(
        "path error on runs left out (mm)" if by_paths else "worse than the best by (information criterion)"
    )
