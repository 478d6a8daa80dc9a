"""Bodies of a car besides its train: disc, camshaft, rod, wheels, bearings and floor.

The frame is that of the room. A train stands between two plates beside the disc. The near plate stands
two clearances away from the disc, or from its hub; the middle of the far one is a bearing span away from its own.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import cos, sin
from typing import NamedTuple

from cadgen.car.assembly.bodies import SolidCylinder
from cadgen.gears.layout import RoundBody
from cadgen.messages import Message

_STANDOFF = 2.0  # clearances between the disc and the plate beside it
STEERING_STEPS = 24  # places of the fork, from stop to stop of its motion, at which gaps are taken


class OnCamshaft(NamedTuple):
    """Part of the disc: a round body that holds all that it sweeps.

    Attributes:
        name: what it is, for people.
        radius: radius, mm.
        low: height at which it begins, mm.
        high: height at which it ends, mm.
    """

    name: str
    radius: float
    low: float
    high: float


@dataclass(frozen=True, slots=True, kw_only=True)
class CarSite:
    """Places and sizes of what a train must fit between.

    Attributes:
        base_radius: distance from the camshaft to the fork axis, mm.
        behind: distance from the camshaft to the rear axle, mm; the axle lies that far behind it.
        fork: height z of the fork axis, mm.
        drive_wheel: height z of the drive wheel's middle, mm.
        idle_wheel: height z of the idle wheel's middle, mm.
        wheel_radius: radius of the rear wheels, mm.
        wheel_width: their width, mm.
        front_radius: radius of the front wheel, mm; 0 where it is not known.
        front_width: its width, mm.
        disc: rim and hub of the disc.
        rod_radius: radius of the rod, mm.
        rod_length: length of the rod from the fork axis, mm.
        rod_side: 1 for a rod to the left of the fork axis, -1 to the right.
        rod_angles: least and greatest angle of the rod, rad; positive angles lead its end ahead.
        wheel_angles: least and greatest angle of the front wheel, rad, in the same sense.
        clearance: least gap between bodies of different shafts, but of parts of the train among themselves, mm.
        gear_clearance: least gap between parts of the train, mm.
        floor_clearance: least gap between the floor and all bodies but the wheels, mm.
        plate: thickness of the plates, mm.
        bearings: outer diameter of each shaft's bearings in the plates, from the drive on, mm; 0 for none.
        ending: whether each shaft ends at its gears instead of running from plate to plate.
        span: distance between the middles of the two plates, mm.
    """

    base_radius: float
    behind: float
    fork: float
    drive_wheel: float
    idle_wheel: float
    wheel_radius: float
    wheel_width: float
    front_radius: float
    front_width: float
    disc: tuple[OnCamshaft, ...]
    rod_radius: float
    rod_length: float
    rod_side: int
    rod_angles: tuple[float, float]
    wheel_angles: tuple[float, float]
    clearance: float
    gear_clearance: float
    floor_clearance: float
    plate: float
    bearings: tuple[float, ...]
    ending: tuple[bool, ...]
    span: float

    @property
    def least_height(self) -> float:
        """Least height of the camshaft over the floor, mm: the disc clears it, and the rod the front wheel."""
        over_wheel = 2 * self.front_radius + self.rod_radius + self.clearance if self.front_radius else 0.0
        return max(over_wheel, max(part.radius for part in self.disc) + self.floor_clearance)

    def stack(self, towards: int, low: float, high: float) -> "StackPlace":
        """Place of a train along its shafts.

        Args:
            towards: side of the disc, -1 below it and 1 above.
            low: height at which the stack begins in the train's own frame, mm.
            high: height at which it ends there, mm.
        """
        if towards < 0:
            near = min(part.low for part in self.disc) - _STANDOFF * self.clearance - self.plate / 2
            raised = near - self.plate / 2 - self.clearance - high
        else:
            near = max(part.high for part in self.disc) + _STANDOFF * self.clearance + self.plate / 2
            raised = near + self.plate / 2 + self.clearance - low
        room = self.span - self.plate - 2 * self.clearance - (high - low)
        return StackPlace(towards, raised, near, near + towards * self.span, room)

    def fork_bodies(self, share: float, height: float) -> Iterator[SolidCylinder]:
        """Rod and front wheel at a place of the fork.

        Args:
            share: share of the way from the least to the greatest angle, 0 to 1.
            height: height of the camshaft over the floor, mm.
        """

        def turned(angles: tuple[float, float]) -> tuple[float, float]:
            angle = angles[0] + share * (angles[1] - angles[0])
            return sin(angle), cos(angle) * self.rod_side

        ahead, across = turned(self.rod_angles)
        half = self.rod_length / 2
        yield SolidCylinder(
            name=Message("the rod"),
            centre=(self.base_radius + half * ahead, 0.0, self.fork + half * across),
            axis=(ahead, 0.0, across),
            radius=self.rod_radius,
            half=half,
        )
        if self.front_radius:
            ahead, across = turned(self.wheel_angles)
            yield SolidCylinder(
                name=Message("the front wheel"),
                centre=(self.base_radius, height - self.front_radius, self.fork),
                axis=(ahead, 0.0, across),
                radius=self.front_radius,
                half=self.front_width / 2,
            )


class StackPlace(NamedTuple):
    """Place of a train along its shafts.

    Attributes:
        towards: side of the disc, -1 below it and 1 above.
        raised: height by which the train's own frame is raised, mm.
        near: height of the middle of the plate next to the disc, mm.
        far: height of the middle of the other plate, mm.
        room: length between the plates that is left over, mm; negative where the stack is too high.
    """

    towards: int
    raised: float
    near: float
    far: float
    room: float


class OnShaft(NamedTuple):
    """Round body on a shaft.

    Attributes:
        body: body at its height in the car.
        of_train: whether it is a gear, a hub or a shaft of the train, which keep clear of each other by a clearance of
            their own.
    """

    body: RoundBody
    of_train: bool


def shaft_bodies(
    site: CarSite, train: Sequence[Sequence[RoundBody]], bores: Sequence[float], place: StackPlace
) -> list[list[OnShaft]]:
    """Round bodies on every shaft, from the drive to the camshaft, at their heights in the car.

    Args:
        site: what stands in the car.
        train: gears and hubs of every shaft, in the train's own frame.
        bores: diameter of every shaft, mm.
        place: place of the train along its shafts.
    """
    ends = sorted((place.near, place.far))
    plates = (ends[0] - site.plate / 2, ends[1] + site.plate / 2)
    last, on_shafts = len(train) - 1, []
    for number, (gears, bore) in enumerate(zip(train, bores, strict=True)):
        bodies = [OnShaft(gear.raised(place.raised), True) for gear in gears]
        reach = [z for body, _ in bodies for z in (body.low, body.high)] if site.ending[number] else [*plates]
        name = Message("shaft {shaft} itself", shaft=number + 1)
        if number == last:
            name = Message("the camshaft")
            bodies += [
                OnShaft(RoundBody(part.name, None, part.radius, part.low, part.high), False) for part in site.disc
            ]
            reach += [z for part in site.disc for z in (part.low, part.high)]
        elif number == 0:
            name, half = Message("the axle of the drive wheel"), site.wheel_width / 2
            wheels = ((Message("the drive wheel"), site.drive_wheel), (Message("the idle wheel"), site.idle_wheel))
            bodies += [
                OnShaft(RoundBody(wheel, None, site.wheel_radius, z - half, z + half), False) for wheel, z in wheels
            ]
            reach += [site.drive_wheel - half, site.drive_wheel + half]
        if bore:
            bodies.append(OnShaft(RoundBody(name, None, bore / 2, min(reach), max(reach)), True))
        if site.bearings[number] and not site.ending[number]:
            name, half = Message("a bearing of shaft {shaft}", shaft=number + 1), site.plate / 2
            bodies += [
                OnShaft(RoundBody(name, None, site.bearings[number] / 2, z - half, z + half), False)
                for z in (place.near, place.far)
            ]
        on_shafts.append(bodies)
    return on_shafts
