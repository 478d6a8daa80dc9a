"""Whether the drive has the energy for the run."""

from cadgen.cam.follower import Follower
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.energy import RunEnergy, run_energy
from cadgen.car.steering import Car
from cadgen.check import Bound, Check, CheckCode
from cadgen.design import variation
from cadgen.design.schema import Design
from cadgen.jobs.cam.wheel import DriveWheel
from cadgen.messages import Message

STAGE_EFFICIENCY = 0.97  # of a pair of spur gears and its bearings, where the design does not say
ROLLING_RESISTANCE = 0.015  # of hard wheels on a floor with their bearings, where the design does not say
_STEPS = 2000


def energy_checks(
    design: Design, track: Track, lift: PathMotion, follower: Follower, car: Car, wheel: DriveWheel
) -> tuple[Check, ...]:
    """Energy left at the end of the path, at the greatest friction and drag; empty where the design says no mass.

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift that the cam is cut for.
        follower: follower of the design.
        car: dimensions of the car.
        wheel: drive wheel that the cam is for.
    """
    keys = design.mechanics
    if keys is None or keys.drive_energy_J is None or keys.car_mass_kg is None:
        return ()
    band = variation.mechanics(design, follower, lift)
    assert band is not None  # the design has [mechanics]
    run = drive(lift, car, wheel.turn, start=start_pose(track), stop=wheel.finish, steps=_STEPS)
    stages = 0 if design.train is None else len(design.train.stages)
    efficiency = keys.train_efficiency or STAGE_EFFICIENCY**stages
    spent = run_energy(
        lift,
        band.at(band.friction[1], band.drag[1]),
        run,
        mass=keys.car_mass_kg,
        rolling=ROLLING_RESISTANCE if keys.rolling_resistance is None else keys.rolling_resistance,
        efficiency=efficiency,
    )
    return (_check(spent, keys.drive_energy_J),)


def _check(spent: RunEnergy, has: float) -> Check:
    return Check(
        CheckCode.ENERGY_LEFT,
        Message("energy left at the end of the path"),
        has - spent.needed,
        "J",
        0.0,
        Bound.MIN,
        Message(
            "of {has:g} J rolling takes {rolling:.2f}, the rod {rod:.2f}, the brake {drag:.2f}, the gears {gears:.2f}",
            has=has,
            rolling=spent.rolling,
            rod=spent.rod,
            drag=spent.drag,
            gears=spent.gears,
        ),
        Message(
            "raise mechanics.drive_energy_J to {needed:.3g}, or lower the mass, the brake's drag or the rod's force",
            needed=1.005 * spent.needed,
        ),
    )
