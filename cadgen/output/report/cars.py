"""Ends of the runs of many cars, and what moves them.

What draws here is loaded beside short commands: it needs nothing that takes long to load.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from cadgen.arrays import Array
from cadgen.output.report.style import AFTER, BEFORE, BLUE, GREY, SKY, figure, zero_line

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SHARES = (0.5, 0.9, 0.99)
_BINS = 60
_MOST_BARS, _LEAST_SHARE = 10, 5e-4


@dataclass(frozen=True, kw_only=True)
class FleetPicture:
    """Content of the picture of many cars.

    Attributes:
        title: title of the picture.
        along: position error at the end along the planned heading, shape (m,), mm.
        across: position error to the left of the planned heading, shape (m,), mm.
        gate_width: width of the gate at the end, mm; None if there is none.
        passed: share of the cars that keep the course and its gates, 0 to 1; None where there is nothing to keep.
        shares: share of the variance by parameter, greatest first.
    """

    title: str
    along: Array
    across: Array
    gate_width: float | None
    passed: float | None
    shares: Mapping[str, float]


@contextmanager
def fleet_picture(content: FleetPicture) -> Iterator["Figure"]:
    """Draw the distribution of end errors and its causes."""
    distance = np.hypot(content.along, content.across)
    with figure(11.0, 3.9) as picture:
        kept = "" if content.passed is None else f"; {100 * content.passed:.1f} % keep the course"
        picture.suptitle(f"{content.title}{kept}", x=0.01, ha="left")
        left, middle, right = picture.subplots(1, 3, width_ratios=(1.25, 1.0, 1.1))
        left.hist(distance, bins=_BINS, color=SKY)
        for share, style in zip(_SHARES, ("-", "--", ":"), strict=True):
            value = float(np.quantile(distance, share))
            left.axvline(value, color=BEFORE, linestyle=style, label=f"{100 * share:g} % within {value:.0f} mm")
        left.set(title="Position error at the end", xlabel="mm", ylabel="cars", xlim=(0, float(distance.max())))
        left.legend(loc="upper right", fontsize=8, frameon=True, framealpha=1.0, edgecolor="none")

        shown = slice(None, 4000)  # enough to see the shape, and a small file
        middle.plot(
            content.across[shown], content.along[shown], ".", markersize=1.5, color=AFTER, alpha=0.35, rasterized=True
        )
        for edge in (-0.5, 0.5) if content.gate_width else ():
            middle.axvline(edge * (content.gate_width or 0.0), color=GREY, linestyle="--", linewidth=1)
        zero_line(middle)
        dashed = " (dashed: gate)" if content.gate_width else ""
        middle.set(
            title=f"Where cars end{dashed}", xlabel="left of the planned end, looking ahead (mm)", ylabel="ahead (mm)"
        )
        middle.set_aspect("equal", adjustable="datalim")
        middle.invert_xaxis()  # as one who looks ahead sees it

        names = [parameter for parameter, share in content.shares.items() if share >= _LEAST_SHARE][:_MOST_BARS][::-1]
        values = [100 * content.shares[parameter] for parameter in names]
        bars = right.barh([parameter.replace("_", " ") for parameter in names], values, color=BLUE)
        right.bar_label(bars, fmt="%.1f", fontsize=8, padding=2)
        right.grid(axis="y", visible=False)
        right.margins(x=0.15)
        right.set(title="Share of the variance", xlabel="%")
        yield picture


@contextmanager
def budget_picture(title: str, costs: Mapping[str, tuple[float, float]]) -> Iterator["Figure"]:
    """Draw the cost of every deviation, before and after a trim.

    Args:
        title: title of the picture.
        costs: distance by which each deviation moves the end of the run, before and after a trim, mm, by its name,
            greatest first.
    """
    names = list(costs)[::-1]
    place = np.arange(len(names))
    with figure(8.0, 1.6 + 0.34 * len(names)) as picture:
        axes = picture.subplots()
        for number, (label, colour) in enumerate((("after a trim", AFTER), ("before", BEFORE))):
            values = [costs[deviation][1 - number] for deviation in names]
            bars = axes.barh(place + 0.2 - 0.4 * number, values, 0.38, label=label, color=colour)
            axes.bar_label(bars, fmt="%.0f", fontsize=7, padding=2)
        axes.set_yticks(place, names)
        axes.grid(axis="y", visible=False)
        axes.margins(x=0.12)
        axes.set(title=f"{title}: what may be off", xlabel="end of the run moved by (mm)")
        axes.legend(loc="lower right", fontsize=8)
        yield picture
