"""Time that the programs for a mill take at their feeds, from the sizes that their moves have.

Rapid moves and changes of tool take what the machine takes, which no program says; they are apart.
"""

from math import pi

from cadgen.arrays import TURN
from cadgen.car.running.friction import DiscMaterial
from cadgen.design.machining import Machining
from cadgen.output.files.drilling import drill_feed, drills_of, pecks, point_length
from cadgen.output.files.gcode import levels_of
from cadgen.parts.blank import Blank


def milling_minutes(length: float, machining: Machining, thickness: float, material: DiscMaterial | None) -> float:
    """Time at the feeds of the program that mills an outline, min.

    The cutter's centre goes round on the parallel at its radius r, which is longer than the outline by 2 pi r
    (Steiner), with a quarter of a circle before and after.

    Args:
        length: of the outline, mm.
        machining: cutter, feeds, passes, tabs.
        thickness: of the disc, mm.
        material: of the disc, for the feed; None if none is given.
    """
    tabs, levels = machining.tabs, levels_of(machining, thickness)
    round_length = length + TURN * machining.cutter_diameter_mm / 2 + pi * machining.lead_radius_mm
    plunged = len(levels) * machining.approach_mm - levels[-1]
    cut = len(levels) * round_length
    if tabs is not None:
        top = tabs.height_mm - thickness
        below = [level for level in levels if level < top]
        # Over each tab in a round, and down to it in the slot when it is taken off.
        plunged += tabs.count * sum(2 * (top - level) + machining.approach_mm - level for level in below)
        apart = tabs.width_mm + machining.cutter_diameter_mm + 2 * machining.lead_radius_mm
        cut += tabs.count * len(below) * apart
    return cut / machining.feed(material) + plunged / machining.plunge_feed_mm_per_min


def drilling_minutes(blank: Blank, machining: Machining, thickness: float, material: DiscMaterial | None) -> float:
    """Time at the feeds of the programs that drill a disc, min; 0 without [machining.drilling].

    Args:
        blank: bore, hub, holes and mark.
        machining: approach, break through, drilling.
        thickness: of the disc, mm.
        material: of the disc, for the speed; None if none is given.
    """
    drilling = machining.drilling
    if drilling is None:
        return 0.0
    minutes = 0.0
    for drill in drills_of(blank, thickness, drilling):
        below = point_length(drill.diameter, drilling) + machining.break_through_mm
        peck = drilling.peck_mm or drill.diameter
        feed = drill_feed(drill.diameter, drilling, material)[1]
        for hole in drill.holes:
            floors = pecks(hole.top, hole.bottom - below, peck)
            # Each peck begins above the floor of the one before, to which the drill comes back at rapid speed.
            minutes += (hole.top - floors[-1] + len(floors) * machining.approach_mm) / feed
    return minutes
