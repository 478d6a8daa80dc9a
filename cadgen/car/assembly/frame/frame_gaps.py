"""Least gaps of a frame: to all that moves, over all places of fork and platform, and among its own parts."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import inf

import numpy as np

from cadgen.arrays import Array
from cadgen.car.assembly.arrangement import Gap
from cadgen.car.assembly.bodies import Convex, SolidCylinder
from cadgen.car.assembly.fork_sizes import (
    BRIDGE_HEIGHT,
    BRIDGE_LENGTH,
    CHEEK,
    FRONT_WIDTH,
    GAP,
    HEAD,
    HEAD_HALF,
    SPINDLE,
    front_radius,
    hub_width,
)
from cadgen.car.assembly.frame.bought_parts import BoughtKind
from cadgen.car.assembly.frame.built_frame import Frame
from cadgen.car.assembly.panels import (
    STANDING,
    ConvexPrism,
    PartPlace,
    cylinder_box,
    least_gap,
    parallel_gap,
    pieces,
    rectangle,
)
from cadgen.car.assembly.site import STEERING_STEPS, OnShaft
from cadgen.gears.layout import RoundBody
from cadgen.messages import Message

_SAME = 1e-9  # mm


def frame_gap(frame: Frame, shafts: Sequence[Sequence[OnShaft]], bores: Sequence[float]) -> Gap:
    """Least gap between the frame's parts and all bodies that move, over all places of fork and platform.

    Args:
        frame: frame.
        shafts: round bodies on every shaft.
        bores: diameter of every shaft, mm.
    """
    site, found = frame.site, frame.arrangement
    bodies: list[tuple[int, SolidCylinder]] = []
    skipped: set[tuple[int, int]] = set()
    panels = frame.panels
    drum = None if frame.carried is None else frame.carried.turning
    wound = () if drum is None else (OnShaft(RoundBody(Message("the drum of the string"), None, *drum), False),)
    for number, (axis, on, bore) in enumerate(zip(found.axes, shafts, bores, strict=True), 1):
        for body, of_train in (*on, *wound) if number == 1 else on:
            itself = of_train and body.stage is None and body.radius == bore / 2
            borne = not of_train and body.radius == site.bearings[number - 1] / 2
            # A bearing is as long as the plate is thick; a hub as large as a bearing is none.
            if itself or (borne and abs(body.high - body.low - site.plate) < _SAME):
                skipped |= {
                    (which, len(bodies))
                    for which, panel in enumerate(panels)
                    if any(hole.shaft == number for hole in panel.holes)
                }
            solid = SolidCylinder(
                name=body.name,
                centre=(axis.real, axis.imag, (body.low + body.high) / 2),
                radius=body.radius,
                half=(body.high - body.low) / 2,
            )
            bodies.append((len(bodies), solid))
    least = Gap(inf, "", "")
    standing = [which for which, panel in enumerate(panels) if panel.place.turn is STANDING]
    for which in standing:
        for number, solid in bodies:
            if (which, number) not in skipped:
                size = parallel_gap(panels[which], solid)
                if size < least.size:
                    least = Gap(size, panels[which].name, solid.name)
    still = _still(frame)
    names = [*(panel.name for panel in panels), Message("the fork's block"), Message("a screw or spacer")]
    if frame.carried is not None:
        names.append(frame.carried.body.title)
    shut = {(which, number) for which in standing for number, _ in bodies}
    boxed = [(number, solid, cylinder_box(solid)) for number, solid in bodies]
    nearest = least_gap(still, boxed, skipped | shut)
    if nearest is not None and nearest.size < least.size:
        least = Gap(nearest.size, names[nearest.one], bodies[nearest.other][1].name)
    turning = list(_turning(frame))
    of_fork = [Message("the rod"), Message("the front wheel"), Message("the head of the fork"), Message("the spindle")]
    of_fork.append(Message("the cheeks of the fork"))
    # The spindle passes platform and block.
    passed = {(panels.index(frame.platform), _SPINDLE), (len(panels), _SPINDLE)}
    nearest = least_gap(still, turning, passed)
    if nearest is not None and nearest.size < least.size:
        least = Gap(nearest.size, names[nearest.one], of_fork[nearest.other])
    return least


_ROD, _WHEEL, _HEAD, _SPINDLE, _CHEEKS = range(5)  # bodies of the fork


def _still(frame: Frame) -> list[tuple[int, Convex, Array]]:
    """Convex pieces of the frame with their boxes: sheets, block, and heads of screws and spacers."""
    made: list[tuple[int, Convex, Array]] = []
    for which, panel in enumerate(frame.panels):
        for place in _shifted(frame, panel.place) if panel is frame.platform else (panel.place,):
            made += [(which, piece, piece.box) for piece in pieces(replace(panel, place=place))]
    count = len(frame.panels)
    for place in _shifted(frame, frame.block.place):
        block = replace(frame.block, place=place).piece
        made.append((count, block, block.box))
    for part in frame.bought:
        if part.kind == BoughtKind.BEARING:
            continue
        diameter, _, low, high = part.rounds[0]
        x, y, z = (np.asarray(part.start) + (low + high) / 2 * np.asarray(part.way)).tolist()
        body = SolidCylinder(
            name=part.name, centre=(x, y, z), axis=part.way, radius=diameter / 2, half=(high - low) / 2
        )
        made.append((count + 1, body, cylinder_box(body)))
    if frame.carried is not None:
        made.append((count + 2, frame.carried.piece, frame.carried.piece.box))
    return made


def _shifted(frame: Frame, place: PartPlace) -> tuple[PartPlace, ...]:
    """Ends of the way of what the micrometer shifts, either one."""
    way = np.array([frame.sizes.travel / 2, 0.0, 0.0])
    return (PartPlace(place.turn, place.shift - way), PartPlace(place.turn, place.shift + way))


def _turning(frame: Frame) -> Iterator[tuple[int, Convex, Array]]:
    """Bodies of the fork at its places: rod, wheel, head, spindle, and a box about bridge and cheeks."""
    site, height = frame.site, frame.arrangement.height
    wheel, hub = front_radius(site, height), hub_width(site) / 2 + CHEEK
    bridge = height - 2 * wheel - GAP - BRIDGE_HEIGHT
    x, z, upright = site.base_radius, site.fork, (0.0, 1.0, 0.0)
    for share in np.linspace(0.0, 1.0, STEERING_STEPS + 1).tolist():
        rod = next(site.fork_bodies(share, height))
        least, most = site.wheel_angles
        angle = least + share * (most - least)
        ahead, across = float(np.sin(angle)), float(np.cos(angle)) * site.rod_side
        width = site.front_width or FRONT_WIDTH
        rim = SolidCylinder(
            name="", centre=(x, height - wheel, z), axis=(ahead, 0.0, across), radius=wheel, half=width / 2
        )
        head = SolidCylinder(name="", centre=(x, 0.0, z), axis=upright, radius=HEAD / 2, half=HEAD_HALF)
        spindle = SolidCylinder(name="", centre=(x, bridge / 2, z), axis=upright, radius=SPINDLE / 2, half=bridge / 2)
        for number, body in ((_ROD, rod), (_WHEEL, rim), (_HEAD, head), (_SPINDLE, spindle)):
            yield number, body, cylinder_box(body)
        # Its own u lies along the wheel, v along its axle, w points up.
        turn = np.array([[across, ahead, 0.0], [0.0, 0.0, -1.0], [-ahead, across, 0.0]])
        half, low = BRIDGE_LENGTH / 2, height - wheel + BRIDGE_LENGTH / 2
        cheeks = ConvexPrism.of(rectangle(-half, -hub, half, hub), low - bridge, PartPlace(turn, np.array([x, low, z])))
        yield _CHEEKS, cheeks, cheeks.box


def standing_gap(frame: Frame) -> Gap:
    """Least gap between parts of the frame that do not touch: plates, brackets, platform and block over their way.

    Args:
        frame: frame.
    """
    apart = (*frame.plates, *frame.brackets, frame.platform)
    every: list[tuple[int, Convex, Array]] = []
    for number, panel in enumerate(apart):
        for place in _shifted(frame, panel.place) if panel is frame.platform else (panel.place,):
            every += [(number, each, each.box) for each in pieces(replace(panel, place=place))]
    count = len(apart)
    for place in _shifted(frame, frame.block.place):
        block = replace(frame.block, place=place).piece
        every.append((count, block, block.box))
    names = [*(panel.name for panel in apart), Message("the fork's block")]
    if frame.carried is not None:
        every.append((count + 1, frame.carried.piece, frame.carried.piece.box))
        names.append(frame.carried.body.title)
    # Each pair once; the block stands on the platform.
    touching = {(one, other) for one in range(len(names)) for other in range(one + 1)} | {(count - 1, count)}
    nearest = least_gap(every, every, touching)
    return Gap(inf, "", "") if nearest is None else Gap(nearest.size, names[nearest.one], names[nearest.other])
