"""Pictures of a study: parallel coordinates, the front, and which key explains which figure."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.arrays import Array
from cadgen.output.report.style import BLUE, GREY, SKY, VERMILLION, Drawing, figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_PAIRS = 3  # of objectives, a picture each
_MOST_TICKS = 8  # of choices at an axis


@dataclass(frozen=True, kw_only=True)
class ExplorationPicture:
    """Content of the pictures of a study.

    Attributes:
        title: title of the pictures.
        keys: keys that varied.
        figures: codes of the objectives.
        more: whether more of each objective is better.
        resolutions: difference of each objective below which there is none.
        values: values of the keys and objectives of designs; None for an objective that was not computed.
        kept: whether each of them is within all limits.
        front: the same of the designs on the front.
        effects: share of the variance that a key explains, by figure and key, 0 to 1.
    """

    title: str
    keys: Sequence[str]
    figures: Sequence[str]
    more: Sequence[bool]
    resolutions: Sequence[float]
    values: Sequence[Sequence[Any]]
    kept: Sequence[bool]
    front: Sequence[Sequence[Any]]
    effects: Mapping[str, Mapping[str, float]]


def exploration_pictures(content: ExplorationPicture) -> dict[str, Drawing]:
    """Pictures of a study by their names: parallel, front, effects. One without content is left out.

    Args:
        content: content of the pictures.
    """
    drawn: dict[str, Drawing] = {}
    if content.values:
        drawn["parallel"] = _parallel_picture(content)
        if content.front and len(_differing(content)) > 1:
            drawn["front"] = _front_picture(content)
    if content.effects:
        drawn["effects"] = _effects_picture(content)
    return drawn


@contextmanager
def _parallel_picture(content: ExplorationPicture) -> Iterator["Figure"]:
    """Every design is a line across one axis for each key and objective; those of the front are strong."""
    from matplotlib.collections import LineCollection

    heads = [*content.keys, *content.figures]
    resolutions = [*[0.0] * len(content.keys), *content.resolutions]
    columns = [
        _places([row[at] for row in (*content.values, *content.front)], resolution)
        for at, resolution in enumerate(resolutions)
    ]
    heights = np.array([places for places, _ in columns]).T
    known = np.isfinite(heights).all(axis=1)
    count = len(content.values)
    kept = np.array(content.kept, dtype=bool)
    with figure(max(1.6 * len(heads), 6.0), 4.4) as picture:
        axes = picture.subplots()
        across = np.arange(len(heads))
        groups = (
            (np.flatnonzero(known[:count] & ~kept), GREY, 0.5, "outside a limit"),
            (np.flatnonzero(known[:count] & kept), SKY, 0.7, "within all limits"),
            (count + np.flatnonzero(known[count:]), VERMILLION, 1.4, "front"),
        )
        for rows, colour, width, label in groups:
            if len(rows):
                alpha = 1.0 if colour == VERMILLION else max(0.08, min(0.7, 60 / len(rows)))
                lines = np.stack([np.broadcast_to(across, heights[rows].shape), heights[rows]], axis=-1)
                axes.add_collection(
                    LineCollection(list(lines), colors=colour, linewidths=width, alpha=alpha, rasterized=True)
                )
                axes.plot([], [], color=colour, linewidth=2, label=label)
        for at, (_, ticks) in enumerate(columns):
            axes.axvline(at, color="black", linewidth=0.8)
            for place, text in ticks:
                axes.annotate(
                    text, (at, place), xytext=(3, 0), textcoords="offset points", fontsize=7, va="center",
                    bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.75, "pad": 0.8},
                )  # fmt: skip
        axes.set_xticks(across, [head.replace(".", ".\n") for head in heads], fontsize=8)  # beside each other
        axes.set_yticks([])
        axes.grid(visible=False)
        axes.spines[["left", "bottom"]].set_visible(False)
        axes.set(title=content.title, ylim=(-0.06, 1.06), xlim=(-0.15, len(heads) - 0.5))
        picture.legend(loc="outside lower center", ncols=3, fontsize=8)
        yield picture


def _differing(content: ExplorationPicture) -> list[int]:
    """Numbers of the objectives in which designs differ by more than the resolution."""
    columns = (
        [row[len(content.keys) + at] for row in (*content.values, *content.front)] for at in range(len(content.figures))
    )
    known = [[value for value in column if value is not None] for column in columns]
    return [at for at, column in enumerate(known) if column and max(column) - min(column) > content.resolutions[at]]


@contextmanager
def _front_picture(content: ExplorationPicture) -> Iterator["Figure"]:
    """Every pair of objectives against each other, with the front's designs."""
    pairs = list(combinations(_differing(content), 2))[:_MOST_PAIRS]
    start = len(content.keys)
    with figure(5.2 * len(pairs), 4.4) as picture:
        picture.suptitle(content.title, x=0.01, ha="left", fontsize=10)
        for axes, (first, second) in zip(picture.subplots(1, len(pairs), squeeze=False)[0], pairs, strict=True):
            _draw_pair(axes, content, start + first, start + second)
            for place, direction in ((first, "x"), (second, "y")):
                better = "more" if content.more[place] else "less"
                axes.set(**{f"{direction}label": f"{_axis_label(content.figures[place])}, {better} is better"})
        yield picture


def _draw_pair(axes: "Axes", content: ExplorationPicture, first: int, second: int) -> None:
    groups = (
        ([row for row, kept in zip(content.values, content.kept, strict=True) if not kept], GREY, 8, "outside a limit"),
        ([row for row, kept in zip(content.values, content.kept, strict=True) if kept], SKY, 10, "within all limits"),
        (content.front, VERMILLION, 26, "front"),
    )
    for number, (rows, colour, size, label) in enumerate(groups):
        points = np.array([(row[first], row[second]) for row in rows if None not in (row[first], row[second])])
        if len(points):
            axes.scatter(points[:, 0], points[:, 1], s=size, color=colour, label=label, linewidths=0, zorder=2 + number)
    axes.legend(loc="best", fontsize=8, frameon=True, framealpha=0.9, edgecolor="none")


@contextmanager
def _effects_picture(content: ExplorationPicture) -> Iterator["Figure"]:
    """Share of each figure's variance that each key explains alone, as bars."""
    codes = list(content.effects)
    with figure(min(3.4 * len(codes) + 1.6, 16.0), 1.2 + 0.32 * len(content.keys)) as picture:
        picture.suptitle(f"{content.title}; variance explained by each key alone", x=0.01, ha="left", fontsize=10)
        panels = picture.subplots(1, len(codes), squeeze=False, sharey=True)[0]
        keys = list(content.keys)[::-1]
        for axes, code in zip(panels, codes, strict=True):
            shares = [100 * content.effects[code][key] for key in keys]
            bars = axes.barh(keys, shares, color=BLUE if code in content.figures else SKY)
            axes.bar_label(bars, fmt="%.0f", fontsize=7, padding=2)
            axes.set_title(_axis_label(code), fontsize=9)
            axes.set(xlabel="%", xlim=(0, 112))
            axes.grid(axis="y", visible=False)
        yield picture


def _places(values: Sequence[Any], resolution: float) -> tuple[Array, list[tuple[float, str]]]:
    """Places of values on an axis from 0 to 1, NaN for None, and the axis's ticks.

    Numbers that differ by no more than a resolution stand in the middle.
    """
    if all(value is None or (isinstance(value, int | float) and not isinstance(value, bool)) for value in values):
        numbers = np.array([np.nan if value is None else float(value) for value in values])
        known = numbers[np.isfinite(numbers)]
        low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)
        if high - low <= resolution:
            label = f"{low:.6g}" if high == low else f"{low:.6g}\nno difference"
            return numbers * 0 + 0.5, [(0.5, label)]
        return (numbers - low) / (high - low), [(at, f"{low + at * (high - low):.4g}") for at in (0.0, 0.5, 1.0)]
    choices = list(dict.fromkeys(map(str, values)))
    where = {choice: at / max(len(choices) - 1, 1) for at, choice in enumerate(choices)}
    step = max(len(choices) // _MOST_TICKS, 1)
    return np.array([where[str(value)] for value in values]), [(where[c], c[:18]) for c in choices[::step]]


def _axis_label(code: str) -> str:
    name, _, unit = code.rpartition("_")
    return f"{name.replace('_', ' ')} ({'%' if unit == 'percent' else '°' if unit == 'deg' else unit})"
