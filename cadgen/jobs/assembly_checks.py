"""Whether a car with all its parts stands on its wheels at its speed, and has the energy for its path."""

from math import inf

import numpy as np

from cadgen.car.assembly.car_parts import Content
from cadgen.car.running.tipping import Tipping, tipping
from cadgen.check import Bound, Check, CheckCode
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.mechanics import energy_verdict
from cadgen.jobs.cam.steered_car import SteeredCar
from cadgen.jobs.car_assembly import PlacedParts, parts_in
from cadgen.messages import Message
from cadgen.verdict import PartVerdict, Reservation

_EDGES = (Message("rear axle"), Message("line from idle to front wheel"), Message("line from drive to front wheel"))


def verdict_on_car(cam: CamPlan) -> PartVerdict:
    """Verdict on the car of a cam by the mass of all its parts, or by a stated mass where they have no place.

    Args:
        cam: cam of a car.
    """
    use = SteeredCar.of(cam)
    apart: tuple[Reservation, ...] = ()
    try:
        parts = None if use.in_car is None else parts_in(use.in_car, cam)
        if parts is not None:
            return assembly_verdict(parts)
    except DesignError as error:
        text = Message("the parts of the car cannot be put together, so nothing is known of their mass and of tipping")
        apart = (Reservation("car-not-put-together", text, error.message),)
    spent = energy_verdict(use.design, use.track, use.wanted, cam.follower_as_built, use.car, use.drive_wheel)
    return PartVerdict(spent.checks, (*spent.reservations, *apart))


def assembly_verdict(assembly: PlacedParts) -> PartVerdict:
    """Verdict on a car with all its parts: tipping, and the energy by their mass where the design states none."""
    spent = energy_verdict(
        assembly.layout.design,
        assembly.use.track,
        assembly.use.wanted,
        assembly.cam.follower_as_built,
        assembly.use.car,
        assembly.use.drive_wheel,
        assembly.balance().volume * 1e-3,
    )
    return PartVerdict((_tipping_check(assembly), *spent.checks), spent.reservations)


def tipping_of(assembly: PlacedParts) -> Tipping:
    """Limit of the speed of a car by tipping, with its parts as at cam angle 0."""
    site, car, track = assembly.layout.site, assembly.use.car, assembly.use.track
    found = assembly.layout.arrangement
    assert found is not None  # `put_together` refuses a car without an arrangement
    x, y, z = assembly.balance().centre
    wheels = np.array(
        [
            [0.0, 0.0],
            [0.0, -(car.drive_wheel_offset + car.idle_wheel_offset)],
            [car.wheelbase, -car.drive_wheel_offset],
        ]
    )
    centre = (x + site.behind, z - site.drive_wheel, found.height - y)
    return tipping(track.arc, track.curvature_jets[:, 0], track.curvature_jets[:, 1], wheels, centre)


def centre_of_gravity(assembly: PlacedParts, mass: Content) -> Message:
    """Mass and centre of gravity in words.

    Args:
        assembly: car put together.
        mass: mass and its centre.
    """
    x, y, z = mass.centre
    site, found = assembly.layout.site, assembly.layout.arrangement
    assert found is not None  # `put_together` refuses a car without an arrangement
    return Message(
        "Mass {mass:.0f} g. Centre of gravity {behind:.1f} mm behind the fork axis, {side:.1f} mm to its {way}, "
        "{height:.1f} mm over the floor.",
        mass=mass.volume,
        behind=site.base_radius - x,
        side=abs(z - site.fork),
        way=Message("left") if z > site.fork else Message("right"),
        height=found.height - y,
    )


def _tipping_check(assembly: PlacedParts) -> Check:
    use, found = assembly.use, tipping_of(assembly)
    keys = assembly.layout.design.mechanics
    speed = None if keys is None else keys.speed_m_per_s
    advice = Message(
        "set mechanics.speed_m_per_s to {most:.3g} or less, or bring masses lower and nearer to the middle",
        most=0.995e-3 * found.speed,
    )
    if found.room <= 0:
        advice = Message(
            "the centre of gravity lies {off:.3g} mm outside the wheels: put the motor or a weight on the other side",
            off=-found.room,
        )
    return Check(
        CheckCode.TIPPING_SPEED,
        Message("speed at which the car tips over"),
        found.speed * 1e-3,
        "m/s",
        -inf if speed is None and found.room > 0 else speed or 0.01,
        Bound.MIN,
        Message("over the {edge}, {place}", edge=_EDGES[found.edge], place=use.track.where(found.arc)),
        advice,
    )
