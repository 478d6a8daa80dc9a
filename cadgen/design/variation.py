"""How much cars of a design vary: the return error of their gears and the tolerances of their dimensions."""

from dataclasses import replace
from functools import partial
from math import degrees, inf, pi, radians

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN
from cadgen.cam.follower import Follower, edge_follower
from cadgen.cam.followers.kind import RunningSurface
from cadgen.car.against_play.band import PlayBand
from cadgen.car.against_play.remedies import holding
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import wheel_radius as drive_wheel_radius
from cadgen.car.running.friction import USUAL, DiscMaterial, friction_band
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.car.running.side_slip import CHANGE, side_slip
from cadgen.design import cam_model, gear_model
from cadgen.design.play import Braked, Hardware, MechanicsSection
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.deviations.deviation import (
    DRAG,
    ECCENTRIC_BORE,
    GEAR_ERRORS,
    PROFILE_OFFSET,
    RETURN_ERROR,
    ROD_BENDING,
    ROD_FORCE,
    ROD_RADIUS,
    SIDE_SLIP,
    SLIDING_FRICTION,
    START_GAP,
    TEMPERATURE,
    TOLERANCES,
    Deviation,
)
from cadgen.deviations.first_order import EXPANSION, Expansion
from cadgen.errors import DesignError
from cadgen.gears.choices import Order, StageOrder
from cadgen.gears.distribution import ZoneSum
from cadgen.gears.fits import clearance as fit_clearance
from cadgen.gears.synthesis import arrange
from cadgen.gears.train import OnceATurn, WholePlay, once_a_turn
from cadgen.inference.monte_carlo.random_cars import Sampler, Tolerances

# Young's modulus of rods, N/mm^2: handbooks' tables.
_STEEL = 206e3
_ELASTIC = {"aluminium": 70e3, "brass": 100e3}
_STATIONS = 3600  # of the turn at which forces are looked at
# What the micrometer head of the base radius takes out after a trial run, but for less than 1 % on the packaged cars:
# a disc or a rod that is larger all round moves the rod as a larger base radius does.
_TRIMMED = (PROFILE_OFFSET, ROD_RADIUS)


def play_bands(design: Design) -> dict[StageOrder, PlayBand]:
    """Bands of the return error at the camshaft, rad, by order of the train.

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
    if not bands and (joint := gear_model.cam_joint(design))[1] > 0:
        bands = {own: PlayBand(least=joint[0], greatest=joint[1])}
    if own in bands:
        return {**bands, own: replace(bands[own], measured=measured)}
    return {} if measured is None else {own: PlayBand(least=measured, greatest=measured, measured=measured)}


def measured_play(design: Design) -> float | None:
    """The return error that was measured on the car, rad; None if it was not."""
    found, given = cam_model.as_built(design).play, design.play
    if found is not None or given is None or given.measured_deg is None:
        return found
    return radians(given.measured_deg)


def tabled_play(design: Design) -> float | None:
    """The greatest return error that a car of this design may have as far as nothing was measured on it, rad.

    None if the design has no play.
    """
    band = play_bands(design.as_designed()).get(design.optimize.order)
    return None if band is None else band.ends[1]


def mechanics(design: Design, follower: Follower, lift: PathMotion) -> MechanicsBand | None:
    """Range of the forces on the cam; None if the design has no [mechanics].

    Where `optimize.hardware` allows a brake, its drag is one that holds. A friction that [as_built] has comes before
    the band of [mechanics]; a return error that it has from a track without one was found without friction, and keeps
    that.

    Args:
        design: loaded design.
        follower: follower of the design.
        lift: planned lift.

    Raises:
        DesignError: there are forces and the follower is not the rod, the rod's force is used up somewhere on the
            lift, or the drive cannot turn the cam.
    """
    given, known = design.mechanics, cam_model.as_built(design)
    hardware, material = design.optimize.hardware or (), design.follower.surface
    if given is None and (material or design.blank.material):
        given = MechanicsSection()  # their friction follows from the materials
    if given is None and known.friction is not None and not hardware:
        return MechanicsBand(
            follower=edge_follower(follower, "friction", "remove [as_built]"),
            friction=_measured(known.friction),
            measured=True,
        )
    if given is None:
        if hardware:
            raise DesignError(
                "optimize.hardware allows {listed}, and what that brings goes by the rod's force and "
                "friction: add [mechanics], such as --set mechanics.friction_least={least:g} --set "
                "mechanics.friction_greatest={greatest:g}",
                listed=listed(hardware, "and"),
                least=USUAL[0],
                greatest=USUAL[1],
            )
        return None
    if known.friction is not None:
        friction = _measured(known.friction)
    elif known.runs_free:
        friction = 0.0, 0.0
    elif given.friction_least is None or given.friction_greatest is None:
        friction = friction_band(material or RunningSurface.STEEL, design.blank.material, greased=given.greased)
    else:
        friction = given.friction_least, given.friction_greatest
    band = MechanicsBand(
        follower=edge_follower(follower, "friction", "remove [mechanics] and blank.material"),
        rod_force=given.rod_force_N,
        rod_rate=given.rod_rate_N_per_mm,
        friction=friction,
        drag=given.drag_Nmm,
        behind=gear_model.cam_joint(design)[1] if given.drag_on == Braked.SHAFT else 0.0,
        measured=known.friction is not None,
    )
    _refuse_lost_rod(band, lift, design.tolerances.rod_force_N or 0.0)
    need = holding(lift, band)
    if Hardware.DRAG in hardware and (band.drag[0] < need.torque or band.behind > 0):
        # A brake on the disc itself, which holds the play of its joint, too.
        band = replace(band, drag=(need.drag, max(need.drag, band.drag[1])), behind=0.0)
    _refuse_weak_drive(design, band, lift)
    return band


def _measured(friction: tuple[float, float]) -> tuple[float, float]:
    """Band of a measured friction: two standard deviations to either side; none about none."""
    value, sigma = friction
    return (max(value - 2 * sigma, 0.0), value + 2 * sigma) if value > 0 else (0.0, 0.0)


def _refuse_lost_rod(band: MechanicsBand, lift: PathMotion, tolerance: float) -> None:
    """Refuse a spring whose force ends on the way, or in some car within its tolerance (N)."""
    theta = np.linspace(0.0, TURN, _STATIONS, endpoint=False)
    height = band.follower.lift(lift.q(theta))
    force = band.nominal.force(height) - tolerance
    worst = int(np.argmin(force))
    if force[worst] <= 0:
        raise DesignError(
            "at cam angle {theta:.1f} degrees, at a lift of {height:.2f} mm, the rod's force is "
            "{force:.3g} N, so the rod leaves the disc: raise mechanics.rod_force_N to {rod_force:.3g} "
            "or more, or bring mechanics.rod_rate_N_per_mm nearer to 0",
            theta=degrees(theta[worst]),
            height=height[worst],
            force=force[worst],
            rod_force=1.01 * (band.rod_force - force[worst]),
        )


def _refuse_weak_drive(design: Design, band: MechanicsBand, lift: PathMotion) -> None:
    """Refuse a cam that the drive cannot turn: rod, friction and drag at their greatest."""
    theta = np.linspace(0.0, TURN, _STATIONS, endpoint=False)
    needed = band.at(band.friction[1], band.drag[1]).needed(lift, theta)
    worst = int(np.argmax(needed))
    if needed[worst] == inf:
        raise DesignError(
            "at cam angle {theta:.1f} degrees the rod jams on the rise at a friction of {friction:g}, "
            "and no torque turns the cam: lower mechanics.friction_greatest, raise cam.base_radius_mm, "
            "or widen the turn there",
            theta=degrees(theta[worst]),
            friction=band.friction[1],
        )
    spent = band.drag[1] * TURN * 1e-3
    has = None if design.mechanics is None else design.mechanics.drive_energy_J
    if has is not None and spent > has:
        raise DesignError(
            "the drag of {drag:.3g} N mm takes {spent:.3g} J a turn of the cam, and "
            "mechanics.drive_energy_J is {has:g}: lower mechanics.rod_force_N and the drag that holds it",
            drag=band.drag[1],
            spent=spent,
            has=has,
        )
    most = None if design.mechanics is None else design.mechanics.drive_torque_Nmm
    if most is not None and needed[worst] > most:
        raise DesignError(
            "at cam angle {theta:.1f} degrees the cam needs {needed:.3g} N mm, {drag:.3g} of it for the "
            "drag, and mechanics.drive_torque_Nmm is {most:g}: lower mechanics.rod_force_N or the drag, "
            "or gear the drive down",
            theta=degrees(theta[worst]),
            needed=needed[worst],
            drag=band.drag[1],
            most=most,
        )


def half_widths(design: Design, forces: MechanicsBand | None) -> dict[Deviation, float]:
    """Half of each tolerance zone; what is 0 is left out.

    Args:
        design: a loaded design.
        forces: range of the forces on its cam.

    Raises:
        DesignError: a tolerance of a quantity that the design lacks.
    """
    tolerances = design.tolerances
    halves: dict[Deviation, float] = {}
    for each in TOLERANCES:
        value = getattr(tolerances, each.tolerance_key, None) or 0.0 if each.zone else 0.0
        halves[each] = radians(value) if each.unit == "rad" else value
    if tolerances.gear_seat_mm is not None:
        shafts = zip(GEAR_ERRORS, once_a_turn_of(design), strict=False)
        halves.update({each: shaft.size for each, shaft in shafts})
    if (fit := design.blank.bore_fit) is not None:
        halves[ECCENTRIC_BORE] += fit_clearance(fit, design.blank.bore_diameter_mm)[1] / 2
    if forces is not None:
        halves[SLIDING_FRICTION], halves[DRAG] = (float(np.ptp(band)) / 2 for band in (forces.friction, forces.drag))
    elif halves[ROD_FORCE] > 0:
        raise DesignError("tolerances.rod_force_N needs the force itself: add [mechanics] with rod_force_N")
    if halves[START_GAP] > 0 and not braked(design):
        raise DesignError(
            "tolerances.start_gap_deg is of a cam that a brake holds; without a brake the rod turns the cam to its "
            "gears, or ahead of them: add mechanics.drag_least_Nmm, or remove tolerances.start_gap_deg"
        )
    if halves[TEMPERATURE] > 0 and design.blank.material is None:
        raise DesignError("tolerances.temperature_K needs to know what the disc is made of: set blank.material")
    return {name: half for name, half in halves.items() if half > 0}


def once_a_turn_of(design: Design) -> tuple[OnceATurn, ...]:
    """Transmission error of every shaft of the train as it is built, from the camshaft on; empty without [train]."""
    if design.train is None:
        return ()
    built = train_plays(design)[design.optimize.order].teeth
    return () if built is None else once_a_turn(built.train, design.tolerances.gear_seat_mm or 0.0)


def of_the_parts(design: Design, forces: MechanicsBand | None) -> dict[Deviation, float]:
    """Half of the zones that follow from gears, rod and wheels: what a budget has even where [tolerances] says nothing.

    Args:
        design: a loaded design.
        forces: range of the forces on its cam.
    """
    shafts = zip(GEAR_ERRORS, once_a_turn_of(design), strict=False)
    halves = {deviation: shaft.size for deviation, shaft in shafts if shaft.size > 0}
    halves[SIDE_SLIP] = CHANGE * side_slip(cam_model.car(design))
    if design.mechanics is not None and forces is not None and design.follower.bearing_width is None:
        rod, stiff = forces.follower, _ELASTIC.get(str(design.follower.surface), _STEEL)
        if rod.radius > 0:
            lever = abs(rod.inner + rod.outer) / 2
            halves[ROD_BENDING] = forces.rod_force * lever**3 / (3 * stiff * pi * rod.radius**4 / 4)
    return halves


def braked(design: Design) -> bool:
    """Whether a brake or felt holds the cam back, or `optimize.hardware` allows one."""
    given = design.mechanics
    return Hardware.DRAG in (design.optimize.hardware or ()) or (given is not None and given.drag_Nmm[1] > 0)


def expansion(design: Design) -> Expansion:
    """How disc, frame and rod grow with heat; not at all if the disc's material is not known."""
    disc, frame = design.blank.material, design.tolerances.frame_material or DiscMaterial.ALUMINIUM
    if disc is None:
        return Expansion()
    return Expansion(disc=EXPANSION[disc], frame=EXPANSION[frame], rod=EXPANSION[DiscMaterial.STEEL])


def trimmed(design: Design) -> bool:
    """Whether `optimize.hardware` says that the steering is set after a trial run."""
    return Hardware.TRIM in (design.optimize.hardware or ())


def tolerances(design: Design, forces: MechanicsBand | None = None) -> Tolerances:
    """How cars of this design may differ, also in the forces on their cams; a measured return error does not.

    Cars that are trimmed after a trial run have no error left that a turn of the steering takes out of every run.
    """
    law, given = design.tolerances.law, design.play
    sample: Sampler | None = None
    if measured_play(design) is not None:
        sample = None
    elif given is None:
        if (whole := whole_play(design)) is not None:
            sample = partial(_plays, whole.return_error_distribution(law))
    else:
        band = play_bands(design)[design.optimize.order]
        sample = ZoneSum((RETURN_ERROR.key,), np.array([band.least]), np.array([band.greatest]), law).sample
    found = Tolerances(half_widths=half_widths(design, forces), law=law, play=sample)
    return trimmed_off(design, found) if trimmed(design) else found


def trimmed_off(design: Design, before: Tolerances) -> Tolerances:
    """How cars differ after a trial run, with the micrometer of the base radius set.

    Laps have no end that could be met: of them `_TRIMMED` is taken out, and nothing else.

    Args:
        design: design of the cars.
        before: how they differ before it.
    """
    if not design.path.closed:
        return replace(before, trimmed=True)
    left = {each: half for each, half in before.half_widths.items() if each not in _TRIMMED}
    return replace(before, half_widths=left)


def _plays(spread: ZoneSum, generator: np.random.Generator, size: int) -> NDArray[np.float64]:
    """Plays of cars, shape (size,), rad; teeth that jam have none."""
    return np.maximum(spread.sample(generator, size), 0.0)


def play_zones(design: Design) -> dict[str, float]:
    """Half of the zone of each part of the play, rad: of the teeth, and of every joint; empty if it was measured."""
    if measured_play(design) is not None:
        return {}
    whole = None if design.play is not None else whole_play(design)
    if whole is None:
        low, high = play_bands(design)[design.optimize.order].ends
        return {RETURN_ERROR.key: (high - low) / 2}
    teeth = whole.teeth
    of_teeth = {} if teeth is None else {"play of the teeth": (teeth.return_error_max - teeth.return_error_min) / 2}
    return {**of_teeth, **{joint.name: (joint.greatest - joint.least) / 2 for joint in whole.loose}}


def wheel_radius(design: Design, length: float) -> float:
    """Radius of the drive wheel by eq. 20, mm: the train's ratio gives it. Without a train, infinite.

    Args:
        design: loaded design.
        length: travel of the drive wheel in one turn of the cam, mm.

    Raises:
        DesignError: the radius has a tolerance but no value.
    """
    if design.train is not None:
        return drive_wheel_radius(length, float(gear_model.train(design).ratio))
    for name in ("wheel_radius_mm", "wheel_runout_mm"):
        if getattr(design.tolerances, name):
            raise DesignError(
                "tolerances.{name} needs the radius itself, which follows from the ratio of [train]: add "
                "[train], or remove tolerances.{name}",
                name=name,
            )
    return inf


def whole_play(design: Design) -> WholePlay | None:
    """Return error of the teeth, the joints and the bearings of the car; None if the design has neither.

    Raises:
        DesignError: as `train_plays`.
    """
    if design.train is not None:
        return train_plays(design)[design.optimize.order]
    alone = gear_model.loose(design, None)
    return WholePlay(teeth=None, loose=alone) if alone else None


def train_plays(design: Design) -> dict[StageOrder, WholePlay]:
    """The play of the train in the order of the design file and in the order of least return error, joints included.

    Empty if the design has no [train].

    Raises:
        DesignError: gears that cannot be, or that the standards do not cover.
    """
    if design.train is None:
        return {}
    given = gear_model.train(design)
    teeth = {order: arrange(given, Order(order))[0] for order in StageOrder}
    return {order: WholePlay(teeth=one, loose=gear_model.loose(design, one.train)) for order, one in teeth.items()}
