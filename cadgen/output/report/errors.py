"""Deflection errors by event (the paper's figures 12, 13, 15 to 17)."""

from collections.abc import Mapping, Sequence
from math import degrees
from pathlib import Path

import numpy as np

from cadgen.car.running.errors import Event, deflection_sum
from cadgen.output.report.style import BLUE, GREEN, ORANGE, SKY, VERMILLION, figure, save, zero_line

_COLORS = (VERMILLION, ORANGE, SKY, GREEN, BLUE)
_HATCHES = ("", "///", "...", "\\\\\\", "xxx")
_MOST_EVENTS = 12  # whose labels stand upright beside each other


def draw_events(title: str, methods: Mapping[str, Sequence[Event]], folder: Path, name: str) -> list[str]:
    """Draw each event's deflection error and their sum, one bar for each method; return the files' names.

    Args:
        title: title of the picture.
        methods: events by the name of the method; all with the same events in the same order.
        folder: folder for the files.
        name: name of the files, without ending.
    """
    first = next(iter(methods.values()))
    many = len(first) > _MOST_EVENTS  # beside each other their labels would stand in one another
    labels = [f"{event.kind}{' ' if many else chr(10)}{degrees(event.cam_angle):.1f}°" for event in first]
    width = 0.8 / len(methods)
    with figure(8.5, 4.6 if many else 4.2) as picture:
        axes, total = picture.subplots(1, 2, width_ratios=(len(first), max(1.4, 0.14 * len(first))))
        for number, (method, events) in enumerate(methods.items()):
            style = {"color": _COLORS[number], "hatch": _HATCHES[number], "edgecolor": "white", "linewidth": 0.0}
            place = (number - (len(methods) - 1) / 2) * width
            heights = [degrees(event.deflection) for event in events]
            axes.bar(np.arange(len(events)) + place, heights, width, label=method, **style)
            bar = total.bar([place], [degrees(deflection_sum(tuple(events)))], width, **style)
            total.bar_label(bar, fmt="%.2f", fontsize=7, padding=2)
        for panel in (axes, total):
            zero_line(panel)
            panel.grid(axis="x", visible=False)
        axes.set_xticks(range(len(labels)), labels, **({"rotation": 90, "fontsize": 7} if many else {}))
        axes.set(title=title, ylabel="deflection error (°)", xlabel="event and its cam angle")
        picture.legend(loc="outside lower center", ncols=len(methods), fontsize=8)  # no bar may lie under it
        total.set_xticks([0], ["sum"])
        total.margins(y=0.12)
        return save(picture, folder, name)
