"""Pictures of one record's verdict: residual before and after, spectrum or plan view, candidates."""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.deviations.effect import UNITS
from cadgen.measurement.diagnose import Diagnosis
from cadgen.report.style import (
    AFTER,
    BEFORE,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    SKY,
    VERMILLION,
    WANTED,
    figure,
    save,
    zero_line,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIGNS = {"um": "µm", "deg": "°", "mm": "mm"}
_RUNS = (BLUE, VERMILLION, GREEN, ORANGE, SKY)
_ORDERS = 60
_CANDIDATES = 7
_NAME = 64  # characters of a candidate that fit its bar's line
_MAGNIFIED = 10.0  # a scale this many times finer is said in the title


def draw_record(told: Diagnosis, length: float | None, folder: Path, name: str) -> list[str]:
    """Draw what a verdict rests on; return the files' names.

    Args:
        told: the verdict with residuals; of tracks, with what was measured.
        length: of the track, mm, along which a track's residual is drawn.
        folder: where to.
        name: of the files, without ending.
    """
    with figure(11.5, 7.0) as picture:
        picture.suptitle(f"{told.kind}: {told.source}. {_short(told)}", x=0.01, ha="left", fontsize=10)
        grid = picture.add_gridspec(2, 2, width_ratios=(1.5, 1.0))
        before = picture.add_subplot(grid[0, 0])
        after = picture.add_subplot(grid[1, 0], sharex=before)
        upper, lower = picture.add_subplot(grid[0, 1]), picture.add_subplot(grid[1, 1])
        track = told.measured is not None
        _residual(before, told, told.before, length)
        _residual(after, told, told.after, length)
        r, unit = told.residual, SIGNS[told.unit]
        several = f", {told.runs} runs" if told.runs > len(_RUNS) else ""
        unit = " mm per coordinate" if length is not None and track else unit if unit == "°" else f" {unit}"
        before.set_title(f"before: rms {r.before:.3g}{unit}{', start pose fitted' if track else ''}{several}")
        finer = r.before / r.after if r.after > 0 else 1.0
        scale = f"; scale {finer:.0f} times finer" if finer > _MAGNIFIED else ""
        after.set_title(f"after: rms {r.after:.3g}{unit}{scale}")
        after.set_xlabel(_abscissa(told, length))
        if 1 < told.runs <= len(_RUNS):
            _headroom(before)
            before.legend(loc="upper right", ncols=told.runs, fontsize=8, frameon=True, edgecolor="none")
        if track:
            _plan(upper, told)
        else:
            _spectrum(upper, told)
        _candidates(lower, told)
        return save(picture, folder, name)


def _short(told: Diagnosis) -> str:
    """The verdict, and the effects claimed."""
    names = ", ".join(told.judgement.claimed)
    return f"{told.verdict}: {names}" if names else told.verdict


def _abscissa(told: Diagnosis, length: float | None) -> str:
    if told.measured is None:
        return "cam angle (°)"
    return "travel of the drive wheel (m)" if length is not None else "part of the run (%)"


def _place(told: Diagnosis, length: float | None) -> Array:
    if told.measured is None:
        return np.degrees(told.place)
    return told.place / TURN * (length / 1000 if length is not None else 100.0)


def _residual(axes: "Axes", told: Diagnosis, residual: Array, length: float | None) -> None:
    """Of each run: its readings as points, or of a track the distance as a line."""
    place, unit = _place(told, length), SIGNS[told.unit]
    values = residual / UNITS[told.unit]
    for run in range(told.runs):
        mine = told.run == run
        color, name = _RUNS[run % len(_RUNS)], f"run {run + 1}"
        if told.measured is None:
            axes.plot(
                place[mine], values[mine], ".", color=color, markersize=2.0, alpha=0.6, rasterized=True, label=name
            )
        else:
            x, y = np.split(values[mine], 2)
            axes.plot(place[mine][: len(x)], np.hypot(x, y), color=color, linewidth=0.9, label=name)
    if told.measured is None:
        if np.isfinite(told.residual.noise):
            axes.axhspan(-2 * told.residual.noise, 2 * told.residual.noise, color=GREY, alpha=0.2, linewidth=0)
        zero_line(axes)
        axes.set_ylabel(f"measured less expected ({unit})")
    else:
        axes.set_ylim(bottom=0)
        axes.set_ylabel(f"distance from the path ({unit})")


def _headroom(axes: "Axes") -> None:
    """Room for a legend above the curves."""
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.12 * (high - low))


def _spectrum(axes: "Axes", told: Diagnosis) -> None:
    """Amplitude by order, runs together, beside what noise alone would make."""
    orders = np.arange(1, _ORDERS + 1)
    waves = np.exp(-1j * told.place[:, None] * orders)
    for residual, color, label, mark in ((told.before, BEFORE, "before", "o"), (told.after, AFTER, "after", "s")):
        amplitude = 2 * np.abs(np.mean(waves * residual[:, None], axis=0)) / UNITS[told.unit]
        axes.semilogy(orders, amplitude, color=color, marker=mark, markersize=2.5, linewidth=0.8, label=label)
    noise = told.residual.noise * np.sqrt(np.pi / len(told.place))
    axes.axhline(noise, color=GREY, linestyle="--", linewidth=1, label="noise alone")
    axes.set(title="amplitude by order", xlabel="waves round the cam", ylabel=SIGNS[told.unit])
    axes.legend(loc="upper right", fontsize=8, ncols=3, frameon=True, edgecolor="none")
    axes.margins(y=0.15)


def _plan(axes: "Axes", told: Diagnosis) -> None:
    """Measured and expected path, the start registered; the first run of many."""
    assert told.measured is not None
    mine = told.run == 0
    measured = np.stack(np.split(told.measured[mine], 2)) / 1000
    lines: tuple[tuple[Array, str, object, float, str], ...] = (
        (told.measured - told.before, BEFORE, (0, (5, 2)), 1.2, "expected before"),
        (told.measured - told.after, AFTER, "-", 1.2, "expected after"),
    )
    axes.plot(*measured, ".", color=WANTED, markersize=3.5, label="measured")
    for path, color, style, width, label in lines:
        x, y = np.split(path[mine], 2)
        axes.plot(x / 1000, y / 1000, color=color, linestyle=style, linewidth=width, label=label)
    axes.plot(*measured[:, 0], "o", color=WANTED, markersize=7, fillstyle="none")
    axes.set(title="plan view, run 1 (circle: start)", xlabel="x (m)", ylabel="y (m)", aspect="equal")
    axes.set_adjustable("datalim")
    axes.legend(loc="best", fontsize=8, frameon=True, edgecolor="none")


def _candidates(axes: "Axes", told: Diagnosis) -> None:
    """The best subsets and the bare design, by how much worse than the best they are."""
    steered = told.unit == "mm" and not np.isfinite(told.residual.noise)
    best = [c for c in told.candidates if c.effects][: _CANDIDATES - 1]
    shown = sorted([*best, *(c for c in told.candidates if not c.effects)], key=lambda c: c.score)
    rows = np.arange(len(shown))
    bars = axes.barh(rows + 0.22, [c.score for c in shown], height=0.34, color=SKY)
    axes.bar_label(bars, labels=[_score(c.score) for c in shown], padding=3, fontsize=8)
    for row, candidate in zip(rows, shown, strict=True):
        names = ", ".join(candidate.effects) or "no effect"
        told_name = names if len(names) <= _NAME else f"{names[: _NAME - 1]}…"
        axes.text(0.01, float(row), told_name, transform=axes.get_yaxis_transform(), fontsize=7.5, va="bottom")
    axes.set_xscale("symlog", linthresh=10)
    axes.set_ylim(len(shown) - 0.4, -0.5)
    axes.set_xlim(0, max(c.score for c in shown) * 4 + 10)
    axes.set_yticks([])
    axes.grid(axis="y", visible=False)
    axes.set_title("candidates")
    axes.set_xlabel("path error on runs left out (mm)" if steered else "worse than the best by (information criterion)")


def _score(value: float) -> str:
    return f"{value:.1f}" if value < 1000 else f"{value:.0f}"
