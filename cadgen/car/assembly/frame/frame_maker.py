"""Frame of a car: the base as high as its bearings allow, or lower until all that stands on it has room."""

from collections.abc import Sequence

from cadgen.car.assembly.arrangement import Arrangement
from cadgen.car.assembly.carried import room_across
from cadgen.car.assembly.frame.base_plate import base_plate, beside
from cadgen.car.assembly.frame.bought_parts import bought_parts
from cadgen.car.assembly.frame.built_frame import Frame
from cadgen.car.assembly.frame.fork_block import fork_block, fork_platform
from cadgen.car.assembly.frame.frame_ground import FrameGround
from cadgen.car.assembly.frame.frame_sizes import FrameSizes
from cadgen.car.assembly.frame.standing_sheets import bearing_plate, idle_bracket, micrometer_bracket
from cadgen.car.assembly.site import CarSite, OnShaft
from cadgen.messages import Message

# mm by which the base is set lower, one after the other, until all that stands on it has room.
_LOWER = (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.5, 8.0, 10.0, 12.0, 15.0, 18.0, 22.0, 27.0, 33.0, 40.0)


def frame_of(
    sizes: FrameSizes,
    site: CarSite,
    found: Arrangement,
    shafts: Sequence[Sequence[OnShaft]],
    bores: Sequence[float],
) -> Frame:
    """Frame of a car.

    Args:
        sizes: what the design states.
        site: what stands in the car.
        found: train at its place.
        shafts: round bodies on every shaft, from `shaft_bodies`.
        bores: diameter of every shaft, mm.
    """
    made = _built(FrameGround(sizes, site, found, shafts, bores))
    if sizes.base_height is not None:
        return made
    best = made
    # Lower down the base has smaller openings, and more room for what stands on it.
    highest, room = made.top, made.under - site.floor_clearance
    for lower in (highest + way for way in _LOWER if way < room):
        if best.whole:
            break
        made = _built(FrameGround(sizes, site, found, shafts, bores, lower))
        if made.whole or (made.joints[0], made.block.height) > (best.joints[0], best.block.height):
            best = made
    return best


def _built(ground: FrameGround) -> Frame:
    """Frame with its base at one height."""
    site, sizes, found = ground.site, ground.sizes, ground.found
    block = fork_block(ground)
    platform, spacers = fork_platform(ground, block)
    near, far = sorted(ground.low, key=lambda low: abs(low + site.plate / 2 - found.place.near))
    if sizes.bed is None:
        plates = (
            bearing_plate(ground, "plate_near", Message("bearing plate beside the disc"), near, platform),
            bearing_plate(ground, "plate_far", Message("bearing plate away from the disc"), far, platform),
        )
    else:
        plates = (
            bearing_plate(ground, "wall_near", Message("wall beside the disc"), near, platform),
            bearing_plate(ground, "wall_far", Message("wall away from the disc"), far, platform),
        )
    brackets = [idle_bracket(ground)]
    micrometer = None
    if sizes.stem:
        brackets.append(micrometer_bracket(ground, platform))
        micrometer = brackets[-1].panel
    standing = [*plates, *brackets]
    base = base_plate(ground, platform, spacers, standing)
    return Frame(
        sizes=sizes,
        site=site,
        arrangement=found,
        plates=(plates[0].panel, plates[1].panel),
        base=base.panel,
        platform=platform,
        brackets=tuple(each.panel for each in brackets),
        block=block,
        spacers=spacers,
        bought=tuple(bought_parts(ground, block, spacers, base, micrometer)),
        pieces=base.pieces,
        joints=(sum(each.found for each in standing), sum(each.wanted for each in standing)),
        top=ground.top,
        carried=base.carried,
        carried_room=room_across(beside(ground), site.clearance),
    )
