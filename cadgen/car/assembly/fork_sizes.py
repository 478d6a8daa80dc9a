"""Sizes of fork, hubs and shaft ends that no design states, mm.

The fork is a spindle with a head that holds the rod, a bridge over the front wheel, and two cheeks beside the wheel.
"""

from cadgen.car.assembly.site import CarSite

SPINDLE, HEAD, HEAD_HALF, JOURNAL = 6.0, 14.0, 7.0, 12.0
BRIDGE_LENGTH, BRIDGE_HEIGHT, CHEEK, PIN, GAP = 18.0, 8.0, 3.0, 4.0, 2.0
FRONT_RADIUS, FRONT_WIDTH = 20.0, 4.0  # at most, where [car.outline] does not say
FRONT_HUB_DIAMETER, FRONT_HUB = 10.0, 12.0
WHEEL_HUB = 6.0  # by which the hub of a rear wheel stands out, away from the disc
CLAMP = 8.0  # of camshaft beyond the disc for its clamp
# Between the top of the front wheel and the rod, without two clearances: half of the head, two bearings of the spindle,
# the sheet that bears their block, the heads of its screws, bridge and gap.
_OVER_WHEEL = HEAD_HALF + 12.0 + 6.0 + 3.0 + BRIDGE_HEIGHT + GAP


def front_radius(site: CarSite, height: float) -> float:
    """Radius of the front wheel, mm: the design's, or the largest one for which there is room under the rod.

    Args:
        site: what stands in the car.
        height: height of the camshaft over the floor, mm.
    """
    return site.front_radius or min(FRONT_RADIUS, (height - _OVER_WHEEL - 2 * site.clearance) / 2)


def hub_width(site: CarSite) -> float:
    """Width of the front wheel's hub, mm."""
    return max(FRONT_HUB, (site.front_width or FRONT_WIDTH) + 2 * GAP)
