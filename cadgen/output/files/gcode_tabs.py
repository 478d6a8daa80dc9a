"""Tabs of a milling program: sides of the cutter's path over which it is lifted."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from cadgen.arrays import Array
from cadgen.curves.contour import Contour
from cadgen.design.machining import Machining, Tabs
from cadgen.errors import DesignError


@dataclass(frozen=True, eq=False)
class Slot:
    """The cutter's path round a disc, cut into sides at the ends of its tabs.

    Attributes:
        centre: path of the cutter's centre, clockwise, mm.
        lifted: whether the cutter passes over a tab on a side, shape (n,).
        tabs: sides along which each tab is taken off, with as much of the slot before and after it as the cutter is led
            in and out elsewhere.
    """

    centre: Contour
    lifted: NDArray[np.bool_]
    tabs: tuple[range, ...] = ()


def slot_with_tabs(centre: Contour, machining: Machining) -> Slot:
    """The path with its tabs in equal steps, the first half a step from where the cutter is led in.

    A tab is narrowest in the middle of the slot, where the cutter's places before and after it are its width and a
    diameter apart.

    Raises:
        DesignError: the tabs have no room between each other or beside the leads.
    """
    tabs = machining.tabs
    if tabs is None:
        return Slot(centre, np.zeros(len(centre.bulges), dtype=bool))
    ends = np.append(0.0, np.cumsum(centre.lengths))
    step, apart = ends[-1] / tabs.count, tabs.width_mm + machining.cutter_diameter_mm
    room = 2 * apart + 4 * machining.lead_radius_mm
    if step < room:
        raise DesignError(
            f"machining.tabs.count is {tabs.count}; tabs {tabs.width_mm:g} mm wide, with the cutter and its leads, "
            f"need {room:.1f} mm each of the {ends[-1]:.0f} mm round the disc: lower machining.tabs.count or width_mm"
        )
    spans = [_span(centre, ends, (number + 0.5) * step, apart) for number in range(tabs.count)]
    return _split(centre, ends, np.array(spans), machining.lead_radius_mm)


def tabs_note(tabs: Tabs) -> str:
    """Tabs in words."""
    return f"{tabs.count} tabs {tabs.width_mm:g} mm wide and {tabs.height_mm:g} mm high"


def _span(centre: Contour, ends: Array, middle: float, apart: float) -> tuple[float, float]:
    """Lengths along the path, evenly to either side of `middle`, at which it is `apart` from itself, mm."""

    def between(half: float) -> float:
        points = [_point(centre, ends, middle + side * half) for side in (-1, 1)]
        return float(np.linalg.norm(points[1] - points[0])) - apart

    half = float(brentq(between, apart / 4, min(apart, 0.49 * ends[-1]), xtol=1e-9))
    return middle - half, middle + half


def _point(centre: Contour, ends: Array, at: float) -> Array:
    side = int(np.clip(np.searchsorted(ends, at, "right") - 1, 0, len(centre.bulges) - 1))
    point: Array = centre.side(side, np.array([(at - ends[side]) / (ends[side + 1] - ends[side])]))[0]
    return point


def _split(centre: Contour, ends: Array, spans: Array, lead: float) -> Slot:
    """The path with corners added at both ends of every span, and a lead (mm) before and after it."""
    led = spans + np.array([-lead, lead])
    corners = np.sort(np.concatenate([spans, led], axis=None))
    vertices, bulges, middles = [], [], []
    for number, (start, stop) in enumerate(pairwise(ends)):
        within = corners[(corners > start) & (corners < stop)]
        shares = (np.concatenate([[start], within, [stop]]) - start) / (stop - start)
        vertices.append(centre.side(number, shares[:-1]))
        bulges.append(np.tan(centre.sweeps[number] * np.diff(shares) / 4))
        middles.append(start + (shares[:-1] + shares[1:]) / 2 * (stop - start))
    middle = np.concatenate(middles)
    lifted = np.any((middle[:, None] > spans[:, 0]) & (middle[:, None] < spans[:, 1]), axis=1)
    tabs = tuple(range(*np.searchsorted(middle, ends_of_tab)) for ends_of_tab in led)
    return Slot(Contour(np.concatenate(vertices), np.concatenate(bulges)), lifted, tabs)
