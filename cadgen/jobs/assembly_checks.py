"""Whether a car with all its parts stands on its wheels at its speed, and has the energy for its path."""

from collections.abc import Iterator
from dataclasses import replace
from math import inf

import numpy as np

from cadgen.car.assembly.car_parts import Block, Content
from cadgen.car.running.tipping import Tipping, tipping
from cadgen.check import Bound, Check, CheckCode, failing
from cadgen.design.load import with_overrides
from cadgen.errors import DesignError
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.mechanics import energy_verdict
from cadgen.jobs.cam.steered_car import SteeredCar
from cadgen.jobs.car_assembly import PlacedParts, borne, parts_in
from cadgen.jobs.car_frame import frame_in
from cadgen.jobs.car_layout import layout_of
from cadgen.messages import Message
from cadgen.verdict import PartVerdict, Reservation

_LARGER = (1.1, 1.25, 1.6, 2.0, 3.0)  # shares of drum and mass of a weight that are tried
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
    spent = _spent(assembly)
    checks, wrong = spent.checks, {check.code for check in failing(spent.checks)}
    if CheckCode.WEIGHT_PULL in wrong:
        advice = _pull_cure(assembly, drums=CheckCode.ENERGY_LEFT not in wrong)
        checks = tuple(replace(each, advice=advice) if each.code == CheckCode.WEIGHT_PULL else each for each in checks)
    return PartVerdict((_tipping_check(assembly), *checks), (*spent.reservations, *_seats_in_bearings(assembly)))


def _seats_in_bearings(assembly: PlacedParts) -> Iterator[Reservation]:
    """Reservations on seats of keys that run into a plate, where the bearing or the hole of their shaft is."""
    for part in assembly.parts:
        for seat in part.shape.seats if isinstance(part.shape, Block) else ():
            zones = borne(assembly.layout, part.shaft)
            into = max((min(seat.high, high) - max(seat.low, low) for low, high in zones), default=0.0)
            if into > 1e-6:
                yield Reservation(
                    "key-seat-in-bearing",
                    Message(
                        "the seat of the key {key} in shaft {shaft} runs {into:.2g} mm into its bearing",
                        key=seat.key.size if seat.key else "",
                        shaft=part.shaft,
                        into=into,
                    ),
                    Message("take a narrower keyway, or set what it holds {into:.2g} mm off the bearing", into=into),
                )


def _spent(assembly: PlacedParts) -> PartVerdict:
    """Verdict on the energy of a car and on the pull of its weight, by the mass of its parts."""
    return energy_verdict(
        assembly.layout.design,
        assembly.use.track,
        assembly.use.wanted,
        assembly.cam.follower_as_built,
        assembly.use.car,
        assembly.use.drive_wheel,
        assembly.balance().volume * 1e-3,
    )


def _pull_cure(assembly: PlacedParts, *, drums: bool) -> Message:
    """Drum or mass with which a weight moves its car, tried with all that stands in its way.

    Args:
        assembly: car put together.
        drums: whether drums are tried: one gives no more energy than the fall has.
    """
    design, drive = assembly.layout.design, assembly.layout.design.drive
    assert drive is not None  # the check is of a weight
    wound = drive.wound(assembly.layout.bores[0])
    sizes = [f"{round(2 * (wound * share - drive.string_mm)) / 2:g}" for share in _LARGER] if drums else []
    masses = [f"{drive.mass_kg * share:.3g}" for share in _LARGER]
    for key, values in (("drive.drum_mm", sizes), ("drive.mass_kg", masses)):
        for value in values:
            try:
                layout = layout_of(with_overrides(design, [f"{key}={value}"]))
                parts = parts_in(layout, assembly.cam)
                if parts is None or failing(frame_in(layout).plain_checks) or failing(_spent(parts).checks):
                    continue
            except DesignError:
                continue
            return Message("set {key} to {value}", key=key, value=value)
    return Message(
        "no drum or mass of the weight that was tried moves it: lower the car's mass, its rolling resistance, the "
        "brake's drag or the rod's force"
    )


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
