"""How much cars of a design vary: the return error of their gears and the tolerances of their dimensions."""

from dataclasses import replace
from functools import partial
from math import degrees, inf, radians
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from cadgen.cam.follower import Follower
from cadgen.cam.lift import LiftCurve
from cadgen.design import gears, stages
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.errors import DesignError
from cadgen.gears.backlash import TrainPlay
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.search import arrange
from cadgen.motion.drive import wheel_radius as drive_wheel_radius
from cadgen.motion.friction import USUAL, friction_band
from cadgen.motion.mechanics import MechanicsBand
from cadgen.motion.play import TURN
from cadgen.optimize.band import PlayBand
from cadgen.optimize.fleet import PARAMETERS
from cadgen.optimize.remedies import holding
from cadgen.optimize.robust import Sampler, Tolerances

_STATIONS = 3600  # of the turn at which forces are looked at

ORDERS: tuple[Literal["as-given", "reordered"], ...] = ("as-given", "reordered")


def play_bands(design: Design) -> dict[str, PlayBand]:
    """What is known of the return error at the camshaft, by order of the train.

    [play] says it of the car as built, and stands for what the tolerances of [train] leave. A return error that
    [as_built] traces to the car is a measured one, and comes before play.measured_deg, which is older. Empty if the
    design has nothing of these.

    Raises:
        DesignError: as `train_plays`.
    """
    bands = {
        # Teeth that may jam have no play then, and not less than none.
        order: PlayBand(least=max(train.return_error_min, 0.0), greatest=max(train.return_error_max, 0.0))
        for order, train in train_plays(design).items()
    }
    given, own, measured = design.play, design.optimize.order, measured_play(design)
    if given is not None and given.least_deg is not None and given.greatest_deg is not None:
        return {own: PlayBand(least=radians(given.least_deg), greatest=radians(given.greatest_deg), measured=measured)}
    if own in bands:
        return {**bands, own: replace(bands[own], measured=measured)}
    return {} if measured is None else {own: PlayBand(least=measured, greatest=measured, measured=measured)}


def measured_play(design: Design) -> float | None:
    """The return error that was measured on the car, rad; None if it was not."""
    found, given = stages.as_built(design).play, design.play
    if found is not None or given is None or given.measured_deg is None:
        return found
    return radians(given.measured_deg)


def tabled_play(design: Design) -> float | None:
    """The greatest return error that a car of this design may have as far as nothing was measured on it, rad.

    None if the design says nothing of play.
    """
    band = play_bands(design.as_designed()).get(design.optimize.order)
    return None if band is None else band.ends[1]


def mechanics(design: Design, rod: Follower, lift: LiftCurve) -> MechanicsBand | None:
    """What is known of the forces on the cam; None if the design has no [mechanics].

    Where `optimize.hardware` allows a brake, its drag is one that holds. A friction that [as_built] has comes before
    the band of [mechanics]; a return error that it has from a track without one was found without friction, and keeps
    that.

    Args:
        design: the design.
        rod: its follower.
        lift: that is planned.

    Raises:
        DesignError: the rod's force is used up somewhere on the lift, or the drive cannot turn the cam.
    """
    given, known = design.mechanics, stages.as_built(design)
    hardware = design.optimize.hardware or ()
    if given is None and known.friction is not None and not hardware:
        return MechanicsBand(follower=rod, friction=_measured(known.friction))
    if given is None:
        if hardware:
            raise DesignError(
                f"optimize.hardware allows {listed(hardware, 'and')}, and what that brings goes by the rod's force and "
                f"friction: add [mechanics], such as --set mechanics.friction_least={USUAL[0]:g} "
                f"--set mechanics.friction_greatest={USUAL[1]:g}"
            )
        return None
    if known.friction is not None:
        friction = _measured(known.friction)
    elif known.runs_free:
        friction = 0.0, 0.0
    elif given.friction_least is None or given.friction_greatest is None:
        material = design.follower.material or "steel"
        friction = friction_band(material, design.blank.material, greased=given.greased)
    else:
        friction = given.friction_least, given.friction_greatest
    band = MechanicsBand(
        follower=rod,
        rod_force=given.rod_force_N,
        rod_rate=given.rod_rate_N_per_mm,
        friction=friction,
        drag=given.drag_Nmm,
        # The share of the return error that lies between the shaft and the disc on it.
        behind=0.0,
    )
    _refuse_lost_rod(band, lift)
    if "drag" in hardware and band.drag[0] < (need := holding(lift, band)).drag:
        band = replace(band, drag=(need.drag, max(need.drag, band.drag[1])))
    _refuse_weak_drive(design, band, lift)
    return band


def _measured(friction: tuple[float, float]) -> tuple[float, float]:
    """Band of a measured friction: two standard deviations to either side; none about none."""
    value, sigma = friction
    return (max(value - 2 * sigma, 0.0), value + 2 * sigma) if value > 0 else (0.0, 0.0)


def _refuse_lost_rod(band: MechanicsBand, lift: LiftCurve) -> None:
    """Refuse a spring whose force ends on the way."""
    theta = np.linspace(0.0, TURN, _STATIONS, endpoint=False)
    height = band.follower.lift(lift.tan_beta(theta))
    force = band.nominal.force(height)
    worst = int(np.argmin(force))
    if force[worst] <= 0:
        raise DesignError(
            f"at cam angle {degrees(theta[worst]):.1f} degrees, at a lift of {height[worst]:.2f} mm, the rod's force "
            f"is {force[worst]:.3g} N, so the rod leaves the disc: raise mechanics.rod_force_N above "
            f"{band.rod_force - force[worst]:.3g} or bring mechanics.rod_rate_N_per_mm nearer to 0"
        )


def _refuse_weak_drive(design: Design, band: MechanicsBand, lift: LiftCurve) -> None:
    """Refuse a cam that the drive cannot turn: rod, friction and drag at their greatest."""
    most = None if design.mechanics is None else design.mechanics.drive_torque_Nmm
    if most is None:
        return
    theta = np.linspace(0.0, TURN, _STATIONS, endpoint=False)
    needed = band.at(band.friction[1], band.drag[1]).needed(lift, theta)
    worst = int(np.argmax(needed))
    if needed[worst] > most:
        raise DesignError(
            f"at cam angle {degrees(theta[worst]):.1f} degrees the cam needs {needed[worst]:.3g} N mm, "
            f"{band.drag[1]:.3g} of it for the drag, and mechanics.drive_torque_Nmm is {most:g}: lower "
            f"mechanics.rod_force_N or the drag, or gear the drive down"
        )


def half_widths(design: Design) -> dict[str, float]:
    """Half of each tolerance zone by the names of `optimize.fleet.PARAMETERS`, mm or rad; what is 0 is left out."""
    given = design.tolerances
    found = {}
    for name, unit in PARAMETERS.items():
        if name != "play":
            half = getattr(given, f"{name}_mm") if unit == "mm" else radians(getattr(given, f"{name}_deg"))
            if half > 0:
                found[name] = half
    return found


def tolerances(design: Design) -> Tolerances:
    """How cars of this design may differ; a measured return error does not."""
    law, given = design.tolerances.law, design.play
    sample: Sampler | None = None
    if measured_play(design) is not None:
        sample = None
    elif given is None and design.train is not None:
        spread = train_plays(design)[design.optimize.order].return_error_distribution(law)
        sample = partial(_plays, spread)
    elif given:
        band = play_bands(design)[design.optimize.order]
        sample = ZoneSum(("play",), np.array([band.least]), np.array([band.greatest]), law).sample
    return Tolerances(half_widths=half_widths(design), law=law, play=sample)


def _plays(spread: ZoneSum, generator: np.random.Generator, size: int) -> NDArray[np.float64]:
    """Plays of cars, shape (size,), rad; teeth that jam have none."""
    return np.maximum(spread.sample(generator, size), 0.0)


def wheel_radius(design: Design, length: float) -> float:
    """Radius of the drive wheel by eq. 20, mm: the train's ratio gives it. Without a train, infinite.

    Raises:
        DesignError: the radius has a tolerance but no value.
    """
    if design.train is not None:
        return drive_wheel_radius(length, float(gears.train(design).ratio))
    if design.tolerances.wheel_radius_mm > 0:
        raise DesignError(
            "tolerances.wheel_radius_mm needs the radius itself, which follows from the ratio of [train]: add [train], "
            "or remove tolerances.wheel_radius_mm"
        )
    return inf


def train_plays(design: Design) -> dict[str, TrainPlay]:
    """The play of the train in the order of the design file and in the order of least return error.

    Empty if the design has no [train].

    Raises:
        DesignError: gears that cannot be, or that the standards do not cover.
    """
    if design.train is None:
        return {}
    given = gears.train(design)
    return {order: arrange(given, order)[0] for order in ORDERS}
