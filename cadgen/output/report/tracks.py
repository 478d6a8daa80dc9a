"""The wheels on the field (the paper's figures 6, 10 and 18 to 20), and the errors along the run."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import Array
from cadgen.car.course.layout import Shape
from cadgen.car.running.drive import Run
from cadgen.car.running.run_errors import RunError
from cadgen.output.report.style import AFTER, BEFORE, BLUE, GREEN, GREY, ORANGE, SKY, WANTED, figure, zero_line

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MARGIN = 300.0  # mm around what is shown
_PANEL = 4.0  # inches
_COLUMNS = 4
_SHOWN = slice(None, None, 6)  # of a run's 3601 positions; the curves are smooth, and the files smaller
_ARROW = 0.09  # length of the arrow at the start, of what is shown
DARK = "#4d4d4d"
_WHEELS = (
    ("drive_wheel", "drive wheel", BLUE, "-"),
    ("front_wheel", "front wheel", ORANGE, (0, (6, 1.5))),
    ("idle_wheel", "right wheel", GREEN, (0, (1.5, 1))),
)


@dataclass(frozen=True, kw_only=True)
class Field:
    """The field with what stands on it.

    Attributes:
        edge: corners of the field, shape (k, 2), mm; None without an edge.
        obstacles: posts, walls and zones.
        gates: gates.
        car: corners of the car in its own frame, x ahead of the fork and y to the left, shape (k, 2), mm; None without.
    """

    edge: Array | None = None
    obstacles: Sequence[Shape] = ()
    gates: Sequence[Shape] = ()
    car: Array | None = None


@dataclass(frozen=True, kw_only=True)
class TrackPanel:
    """Picture of the field: a run, and the ends of the drive wheel for other plays, shape (k, 2), mm."""

    title: str
    run: Run
    ends: Array | None = None


@contextmanager
def tracks_picture(panels: Sequence[TrackPanel], planned: Run, field: Field) -> Iterator["Figure"]:
    """Draw the three wheels' tracks of several runs over the planned one."""
    shown = np.concatenate(
        [np.concatenate([getattr(panel.run, wheel) for wheel, *_ in _WHEELS]) for panel in panels]
        + [panel.ends for panel in panels if panel.ends is not None]
        + [np.array(shape.points) for shape in (*field.obstacles, *field.gates)]
        + ([] if field.edge is None else [field.edge])
    )
    low, high = shown.min(axis=0) - _MARGIN, shown.max(axis=0) + _MARGIN
    columns = min(_COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    tall = float(np.clip(_PANEL * (high[1] - low[1]) / (high[0] - low[0]), 2.0, 6.0))
    with figure(_PANEL * columns, (tall + 0.4) * rows + 0.5) as picture:
        grid = picture.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
        for unused in grid.ravel()[len(panels) :]:
            unused.set_axis_off()
        for axes, panel in zip(grid.ravel(), panels, strict=False):
            _field(axes, field)
            axes.plot(
                *(planned.drive_wheel.T / 1000), color=GREY, linewidth=3.5, alpha=0.35, label="planned, drive wheel"
            )
            for wheel, label, color, style in _WHEELS:
                axes.plot(
                    *(getattr(panel.run, wheel).T / 1000), color=color, linestyle=style, linewidth=1.1, label=label
                )
            _ends(axes, planned.drive_wheel, float(np.max(high - low)))
            _car(axes, field, panel.run)
            if panel.ends is not None:
                axes.plot(*(panel.ends.T / 1000), "x-", color=BEFORE, markersize=5, label="ends over the band of play")
            axes.set(title=panel.title, aspect="equal")
            axes.set_xlim(low[0] / 1000, high[0] / 1000)
            axes.set_ylim(low[1] / 1000, high[1] / 1000)
        for axes in grid[:, 0]:
            axes.set_ylabel("y (m)")
        for axes in grid[-1]:
            axes.set_xlabel("x (m)")
        handles, labels = grid.ravel()[len(panels) - 1].get_legend_handles_labels()
        known = dict(zip(labels, handles, strict=True))  # of posts and of gates one stands for all
        picture.legend([*known.values()], [*known], loc="outside lower center", ncols=5)
        yield picture


def _car(axes: "Axes", field: Field, run: Run) -> None:
    """Draw the car where its run begins and where it ends."""
    from matplotlib.patches import Polygon

    if field.car is None:
        return
    for number in (0, -1):
        c, s = np.cos(run.heading[number]), np.sin(run.heading[number])
        corners = run.front_wheel[number] + field.car @ np.array([[c, s], [-s, c]])
        axes.add_patch(
            Polygon(corners / 1000, facecolor=SKY, edgecolor=BLUE, alpha=0.45, linewidth=0.6, zorder=2.5, label="car")
        )


def _ends(axes: "Axes", track: Array, across: float) -> None:
    """Mark where the drive wheel begins, with an arrow the way that it goes, and where it is planned to end."""
    start, end = track[0] / 1000, track[-1] / 1000
    way = track[min(len(track) - 1, _SHOWN.step or 1)] / 1000 - start
    tip = start + _ARROW * across / 1000 * way / np.linalg.norm(way)
    axes.annotate(
        "", xy=tip, xytext=start, arrowprops={"arrowstyle": "-|>", "color": WANTED, "shrinkA": 0, "shrinkB": 0}
    )
    axes.plot(*start, marker="o", markersize=4, color=WANTED, linestyle="none", label="start")
    axes.plot(*end, marker="s", markersize=6, color=WANTED, fillstyle="none", linestyle="none", label="planned end")


@dataclass(frozen=True, kw_only=True)
class ErrorLine:
    """Errors of a profile along the run: at the play shown, and at the ends of the band."""

    label: str
    at_play: RunError
    at_ends: tuple[RunError, RunError]


@contextmanager
def run_errors_picture(title: str, lines: Sequence[ErrorLine], length: float) -> Iterator["Figure"]:
    """Draw heading and position error along the run, the band shaded.

    Args:
        title: title of the picture.
        lines: errors of one profile or two: before and after.
        length: travel of the drive wheel in one turn of the cam, mm.
    """
    with figure(8.0, 6.0) as picture:
        picture.suptitle(title, x=0.02, ha="left")
        upper, lower = picture.subplots(2, 1, sharex=True)
        for line, color, style in zip(lines, (BEFORE, AFTER), ("-", (0, (5, 2))), strict=False):
            travel = line.at_play.motor[_SHOWN] * length / (2 * np.pi) / 1000
            for axes, values, edges in (
                (upper, np.degrees(line.at_play.heading), [np.degrees(error.heading) for error in line.at_ends]),
                (lower, line.at_play.distance, [error.distance for error in line.at_ends]),
            ):
                values, *edges = (part[_SHOWN] for part in (values, *edges))
                axes.fill_between(
                    travel,
                    np.min([values, *edges], axis=0),
                    np.max([values, *edges], axis=0),
                    color=color,
                    alpha=0.18,
                    linewidth=0,
                )
                axes.plot(travel, values, color=color, linestyle=style, label=line.label)
        zero_line(upper)
        upper.set(ylabel="heading error (°)")
        lower.set(ylabel="position error (mm)", xlabel="travel of the drive wheel (m); shaded: the band of play")
        upper.set_xlim(0, travel[-1])
        upper.legend(loc="upper left")
        yield picture


def _field(axes: "Axes", field: Field) -> None:
    from matplotlib.patches import Polygon

    if field.edge is not None:
        axes.add_patch(Polygon(field.edge / 1000, fill=False, edgecolor=GREY, linewidth=0.8))
    for shape in field.obstacles:
        _shape(axes, shape, filled=True)
    for shape in field.gates:
        _shape(axes, shape, filled=False)


def _shape(axes: "Axes", shape: Shape, *, filled: bool) -> None:
    """Draw what stands on the field in dark, and gates as outlines."""
    from matplotlib.patches import Circle, Polygon

    points = np.array(shape.points) / 1000
    label = "post, wall or zone" if filled else "gate"
    face, edge = (DARK, "none") if filled else ("none", DARK)
    if shape.filled:
        axes.add_patch(Polygon(points, facecolor=face, edgecolor=edge, linewidth=0.8, zorder=3, label=label))
    elif len(points) > 1:
        axes.plot(*points.T, color=DARK, linewidth=2.0 if filled else 0.8, zorder=3, label=label)
    else:
        middle = float(points[0, 0]), float(points[0, 1])
        round_about = Circle(middle, shape.reach / 1000, facecolor=face, edgecolor=edge, linewidth=0.8, zorder=3)
        round_about.set_label(label)
        axes.add_patch(round_about)
        if filled:
            axes.plot(*middle, ".", color=DARK, markersize=4, zorder=3)  # so that a thin post is seen on a large field
