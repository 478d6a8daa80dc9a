"""Effect of friction and drag on a cam, in checks and in words; the energy of a run."""

from math import ceil, degrees, inf, isinf, pi
from typing import NamedTuple

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.follower import Follower, edge_follower
from cadgen.car.against_play.band import PlayBand, over_band
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.play_task import PlayTask
from cadgen.car.against_play.remedies import holding, touched_width
from cadgen.car.path.wheel_track import Track
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.drive import Run, drive, start_pose
from cadgen.car.running.energy import GRAVITY, Resistance, RunEnergy, resistance, run_energy
from cadgen.car.running.friction import USUAL
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.car.running.run_errors import run_error
from cadgen.car.steering import Car, wheel_curvature, wheel_tangent, wheel_travel_ratio
from cadgen.check import Bound, Check, CheckCode
from cadgen.design import variation
from cadgen.design.drive import DRUM_WALL, MOST_FALL, DriveSection
from cadgen.design.play import MechanicsSection
from cadgen.design.schema import Design
from cadgen.design.section import listed
from cadgen.jobs.cam.wheel import DriveWheel
from cadgen.messages import Message
from cadgen.verdict import PartVerdict, Reservation

_FRICTION_STEP = 0.01
# Share of the end of the run by which inertia lessens it for each rad/s of the cam: at friction 0 and at 0.3, of the
# paper's car by a time integration with 0.26 N mm s^2, which gives 1 and 6 % at 1 m/s, 20 degrees/s.
_LATER = 0.03, 0.17
_UNMET = 3.0  # mm; with play and friction known the end is met within this
_STEEP = 20.0  # mm at the end of the run for that step: friction decides more than anything that is cut
_SHOWN = 1.0  # mm; less at the end is not worth a sentence
STAGE_EFFICIENCY = 0.97  # of a pair of spur gears and its bearings, where the design does not say
ROLLING_RESISTANCE = 0.015  # of hard wheels on a floor with their bearings, where the design does not say
_ENERGY_STEPS = 2000
_START = 0.01  # m in which a car must have moved off: without speed no inertia carries it over a steep place
_SPARE = 1.01  # factor on a fall or mass that is named as a cure
# kg; a weight of the contests, which a car whose design has no [drive] must carry besides its parts to be judged ready
_USUAL_DRIVE = 1.0
_TUBE, _TUBE_BORE = 6.0, 4.0  # mm, as in `cadgen.car.assembly.carried`, which loads shapely


def rubbing(task: PlayTask, band: PlayBand, chosen: Evaluation, plain: Evaluation) -> tuple[float, str]:
    """Effect of friction on a cam that was computed without it: worst end, mm, and a sentence; empty without any."""
    usual = MechanicsBand(follower=task.follower, friction=USUAL).cases
    plays = np.array(band.ends if band.measured is None else [band.measured])
    worst = [
        over_band(
            evaluation.rolled,
            task.lift,
            task.car,
            task.length,
            plays,
            least_swing=evaluation.least_swing,
            mechanics=usual,
            cut=evaluation.lift,
        ).worst_distance
        for evaluation in (chosen, plain)
    ]
    if max(worst) < _SHOWN:
        return 0.0, ""
    low, high = USUAL
    beside: str = ""
    if chosen.profile != plain.profile:
        beside = Message("; the {plain} would end up to {off:.0f} mm off", plain=plain.title, off=worst[1])
    return worst[0], Message(
        "Reckoned as if the rod slid without friction, which only a ball bearing does. With a rod that rubs (friction "
        "{low:g} to {high:g}) and these plays the car would end up to {off:.0f} mm off{beside}. Say in [mechanics] "
        "what the car has, and cadgen optimize compares what helps.",
        low=low,
        high=high,
        off=worst[0],
        beside=beside,
    )


def mechanics_checks(
    design: Design, follower: Follower, lift: PathMotion, band: MechanicsBand | None
) -> tuple[Check, ...]:
    """Checks of the torque by which the cam runs ahead, of the drag that holds it, and of a bearing's width.

    Args:
        design: loaded design.
        follower: follower of the design.
        lift: lift that the cam is cut for.
        band: range of friction and drag; None if the design has no [mechanics].
    """
    checks: list[Check] = []
    if band is not None:
        need = holding(lift, band)
        ahead = max(need.with_friction - band.drag[0], 0.0)
        place = Message("cam angle {cam_angle:.1f}°", cam_angle=degrees(need.cam_angle))
        name = Message("torque that turns the cam ahead")
        checks.append(Check(CheckCode.CAM_RUNS_AHEAD, name, ahead, "N·mm", inf, Bound.MAX, place))
        if band.drag[1] > 0 and need.torque > 0:
            # A figure, not a verdict: 1 and more holds.
            margin = 0.0 if band.behind > 0 else band.drag[0] / need.torque
            where = Message("times what is needed, {torque:.3g} N·mm without friction", torque=need.torque)
            if band.behind > 0:
                play = degrees(band.behind)
                where = Message("nothing holds the disc's {play:.3f}° of play on its shaft", play=play)
            checks.append(
                Check(
                    CheckCode.CAM_HOLDS,
                    Message("drag over the drag that holds the cam"),
                    margin,
                    "",
                    -inf,
                    Bound.MIN,
                    where,
                )
            )
    width = design.follower.bearing_width
    if width is not None:
        checks.append(
            Check(
                CheckCode.BEARING_WIDTH,
                Message("bearing width"),
                touched_width(lift, edge_follower(follower, Message("the width of a bearing"))),
                "mm",
                width,
                Bound.MAX,
                Message("length that touches the disc in a turn"),
                Message(
                    "the bearing leaves the disc: take a wider one, or two side by side, and set follower.width_mm"
                ),
            )
        )
    return tuple(checks)


def joint_sentences(design: Design) -> list[str]:
    """Sentences on the return error from joints and bearings, with the cheapest cure."""
    whole = variation.whole_play(design)
    if whole is None or not whole.loose or design.play is not None:
        return []
    added = sum(joint.greatest for joint in whole.loose)
    parts = [Message("{joint} {play:.3f}°", joint=joint.name, play=degrees(joint.greatest)) for joint in whole.loose]
    teeth: str = ""
    if whole.teeth is not None:
        teeth = Message(" to the teeth's {play:.3f}°", play=degrees(whole.teeth.return_error_max))
    return [
        Message(
            "Joints and bearings add up to {added:.3f}°{teeth}: {parts}.",
            added=degrees(added),
            teeth=teeth,
            parts=listed(parts, "and"),
        ),
        Message("Cheapest cure: {cure}.", cure=whole.sentence()),
    ]


def start_sentence(planned: Run, car: Car, travel: float, play: float) -> Message:
    """Advice for each start of a car whose cam a brake holds, with what it costs if it is left out.

    The car then goes through the gap on the circle of its first steering angle, and its run ends so much earlier on
    the planned track.

    Args:
        planned: planned run, from motor position 0.
        car: dimensions of the car.
        travel: travel of the drive wheel's rim for one turn of the cam, mm.
        play: greatest gap between the teeth, at the camshaft, rad.
    """
    x, y = planned.drive_wheel.T
    at, stop = (x + 1j * y), float(planned.motor[-1] - play)
    arc = travel * play / TURN * float(wheel_travel_ratio(wheel_tangent(planned.tan_beta[:1], car), car)[0])
    turned = arc * float(wheel_curvature(wheel_tangent(planned.tan_beta[:1], car), car)[0])
    circle = arc * np.sinc(turned / TURN) * np.exp(1j * (turned / 2 + planned.heading[0]))
    last = np.interp(stop, planned.motor, at.real) + 1j * np.interp(stop, planned.motor, at.imag)
    end = circle + np.exp(1j * turned) * (last - at[0]) + at[0]
    return Message(
        "Before each run turn the drive forward until the cam moves, then set the car down: the brake leaves the cam "
        "where it stood, and a gap between the teeth, up to {play:.3f}° at the camshaft, moves the end of the run by "
        "up to {moved:.0f} mm.",
        play=degrees(play),
        moved=abs(end - at[-1]),
    )


def border_sentences(design: Design, task: PlayTask, chosen: Evaluation, band: PlayBand) -> list[str]:
    """Advice besides the cam, and warnings where the cam may be held in one run and lead in the next, in words."""
    known, keys = task.mechanics, design.mechanics
    if known is None:
        return []
    lines: list[str] = []
    need = holding(chosen.lift, known)
    if known.drag[0] > (0.0 if keys is None else keys.drag_Nmm[0]):
        lines.append(
            Message(
                "Build: a brake on the disc itself with a drag of {drag:.3g} N·mm, a quarter more than the cam's "
                "{torque:.3g} N·mm at {cam_angle:.1f}°, for a rod force of {rod_force:g} N; it takes {energy:.2g} J a "
                "turn. The cam is made for that.",
                drag=known.drag[0],
                torque=need.torque,
                cam_angle=degrees(need.cam_angle),
                rod_force=known.rod_force,
                energy=need.energy,
            )
        )
    if known.drag[1] > 0 and max(band.ends) > 0:
        lines.append(start_sentence(task.planned(), task.car, task.length, max(band.ends)))
    if keys is not None and keys.speed_m_per_s is not None and known.drag[0] < need.torque:
        rate = 1e3 * keys.speed_m_per_s / task.length * TURN
        least, most = (100 * share * rate for share in _LATER)
        lines.append(
            Message(
                "Ends with play are those of a slow car: at {speed:g} m/s the cam turns by {rate:.0f}°/s and leads "
                "later, so they are some {least:.0f} to {most:.0f} % less, the more the rod rubs.",
                speed=keys.speed_m_per_s,
                rate=degrees(rate),
                least=least,
                most=most,
            )
        )
    if variation.trimmed(design):
        lines.append(
            Message(
                "Do: after a trial run set the micrometer of the base radius so that the end is met; the choice, and "
                "the row of this design among the remedies, go by the ends after that trim, the figures in the table "
                "are before it."
            )
        )
    weak, strong = known.at(known.friction[0], known.drag[0]), known.at(known.friction[1], known.drag[1])
    held = [not len(case.leads(chosen.lift).intervals) for case in (weak, strong)]
    if held == [False, True]:
        lines.append(
            Message(
                "Warning: the cam leads its gears at the least friction and drag and is held at the greatest, which is "
                "the worst place to be: it may do either from run to run."
            )
        )
    if held == [True, True] and max(band.ends) > 0:
        lines.append(
            Message(
                "At a friction of {least:.3g} and more the cam never leads its gears: the play does nothing, and there "
                "is nothing to compensate.",
                least=known.friction[0],
            )
            if known.drag[0] == 0
            else Message(
                "With this friction and drag the cam never leads its gears: the play does nothing, and there is "
                "nothing to compensate."
            )
        )
    off = chosen.error
    if band.measured is not None and weak == strong and not all(held) and off.end_distance > _UNMET:
        lines.append(
            Message(
                "No profile of those compared meets the end for a play of {play:.3f}° and a friction of "
                "{friction:.3g}: this one ends {end:.1f} mm off, {way:.1f} mm at most on the way. Where the cam leads, "
                "the lift is too steep or too short to be turned ahead without undercut.",
                play=degrees(band.measured),
                friction=known.friction[0],
                end=off.end_distance,
                way=float(off.distance.max()),
            )
        )
    if held == [True, True] and known.drag[0] < need.torque:
        lines.append(
            Message(
                "Warning: friction alone holds the cam on its gears, and oil or shaking undoes that: only drag is to "
                "be counted on."
            )
        )
    if known.drag[0] > 0 and known.drag[0] < need.torque:
        lines.append(
            Message(
                "Warning: the drag of {drag:.3g} N·mm does not hold the cam, which needs {torque:.3g} N·mm at "
                "{cam_angle:.1f}°, and less is no half cure.",
                drag=known.drag[0],
                torque=need.torque,
                cam_angle=degrees(need.cam_angle),
            )
        )
    if known.behind > 0 and known.drag[1] > 0:
        lines.append(
            Message(
                "Warning: the drag acts on the shaft, and the disc has {play:.3f}° of play on it that no drag holds: "
                "brake the disc itself, or take that play out.",
                play=degrees(known.behind),
            )
        )
    play = sum(band.ends) / 2 if band.measured is None else band.measured
    frictions = np.arange(known.friction[0], known.friction[1] + _FRICTION_STEP, _FRICTION_STEP)
    if len(frictions) > 2:
        planned = task.planned()
        ends = []
        for friction in frictions.tolist():
            case = known.at(friction, sum(known.drag) / 2)
            run = task.run(chosen.rolled, play, least_swing=chosen.least_swing, cut=chosen.lift, mechanics=case)
            error = run_error(run, planned)
            ends.append(complex(error.along[-1], error.across[-1]))
        moved = np.abs(np.diff(ends))
        steep = int(np.argmax(moved))
        if moved[steep] > _STEEP:
            lines.append(
                Message(
                    "Warning: near a friction of {friction:.2f} a change by {step:g} moves the end of the run by "
                    "{moved:.0f} mm.",
                    friction=frictions[steep],
                    step=_FRICTION_STEP,
                    moved=moved[steep],
                )
            )
    return lines


def energy_verdict(
    design: Design,
    track: Track,
    lift: PathMotion,
    follower: Follower,
    car: Car,
    wheel: DriveWheel,
    mass: float | None = None,
) -> PartVerdict:
    """Verdict on the energy left at the end of the path, at the greatest friction and drag.

    A weight of a design without [mechanics] is judged by the values that its keys have where they are left out. Without
    [drive] the mass of the parts lacks motor or weight, which rolls along: what is left must carry a usual one. A
    weight must move the car off, too, and keep it moving until it has landed.

    Args:
        design: loaded design.
        track: track of the drive wheel.
        lift: lift that the cam is cut for.
        follower: follower of the design.
        car: dimensions of the car.
        wheel: drive wheel that the cam is for.
        mass: mass of the car by its parts, kg, which counts where the design states none.
    """
    # A weight falls, of whose run nothing is known.
    assumed = design.mechanics is None and design.drive is not None and design.drive.fall_mm is not None
    keys = MechanicsSection() if assumed else design.mechanics
    if keys is None:
        return PartVerdict(())
    unwound = _unwound(design, wheel)
    falls = None if design.drive is None else design.drive.energy_of(unwound.length)
    has = falls if keys.drive_energy_J is None else min(keys.drive_energy_J, inf if falls is None else falls)
    if has is None:
        return PartVerdict(())
    mass = mass if keys.car_mass_kg is None else keys.car_mass_kg
    if mass is None:
        text = Message("the energy of the run is not judged, for the mass of the car is not known")
        cure = Message("state mechanics.car_mass_kg, with motor or weight")
        return PartVerdict((), (Reservation("energy-not-judged", text, cure),))
    band = variation.mechanics(design.model_copy(update={"mechanics": keys}), follower, lift)
    assert band is not None  # the copy has [mechanics]
    run = drive(lift, car, wheel.turn, start=start_pose(track), stop=wheel.finish, steps=_ENERGY_STEPS)
    stages = 0 if design.train is None else len(design.train.stages)
    efficiency = keys.train_efficiency or STAGE_EFFICIENCY**stages
    forces = band.at(band.friction[1], band.drag[1])
    rolling = ROLLING_RESISTANCE if keys.rolling_resistance is None else keys.rolling_resistance
    spent = run_energy(lift, forces, run, mass=mass, rolling=rolling, efficiency=efficiency)
    name = Message("energy left at the end of the path")
    held_back = _by_usual_values() if assumed else ()
    if keys.car_mass_kg is None and design.drive is None:
        carried = (has - spent.needed) * mass / spent.rolling if spent.rolling > 0 else inf
        name = Message("energy left at the end of the path, motor or weight not counted in the mass")
        held_back = (*held_back, *_uncounted_drive(carried if has >= spent.needed else -1.0))
    guide = _guide(design) if keys.car_mass_kg is None else 0.0
    stated = keys.drive_energy_J is not None
    check = _energy_check(spent, has, falls, name, design.drive, unwound, mass, guide, stated=stated)
    if design.drive is None or falls is None or isinf(unwound.length):
        return PartVerdict((check,), held_back)
    against = resistance(lift, forces, run, mass=mass, rolling=rolling, efficiency=efficiency)
    fallen = min(design.drive.fall_mm or 0.0, unwound.length)
    pulls = _pull_check(against, has, float(against.travel[-1]) * fallen / unwound.length, track)
    return PartVerdict((check, pulls), held_back)


def _pull_check(against: Resistance, has: float, landing: float, track: Track) -> Check:
    """Check that a weight moves its car off from rest, and keeps it moving until it has landed.

    In the first centimetre its pull must beat all that is against it. Later the mean of that from the start on counts,
    for a car that moves has what the pull gave it before.

    Args:
        against: force against the car along its run.
        has: energy of the weight that the car gets, J.
        landing: travel at which the weight has landed, m.
        track: track of the drive wheel.
    """
    pull, travel = has / landing, against.travel
    start = travel <= max(_START, float(travel[0]))
    mean = np.where(start, against.force[start].max(), against.work / travel)[travel <= max(landing, _START)]
    worst = int(np.argmax(mean))
    place = Message("in the first {way:g} mm", way=1e3 * _START)
    if not start[worst]:
        place = Message("on average up to the place {place}", place=track.where(1e3 * float(travel[worst])))
    return Check(
        CheckCode.WEIGHT_PULL,
        Message("pull of the weight beyond what is against it"),
        pull - float(mean[worst]),
        "N",
        0.0,
        Bound.MIN,
        Message(
            "{pull:.3g} N at the rim of the wheel, and {most:.3g} N against it {place}",
            pull=pull,
            most=mean[worst],
            place=place,
        ),
        Message("give the weight more mass (drive.mass_kg), or its string a larger drum (drive.drum_mm)"),
    )


def _uncounted_drive(carried: float) -> tuple[Reservation, ...]:
    """Reservation where the energy that is left carries no usual motor or weight.

    Args:
        carried: mass that it carries, kg; less than 0 where it does not suffice for the car.
    """
    if not 0 <= carried < _USUAL_DRIVE:
        return ()
    text = Message(
        "the mass of the car is without motor or weight, and the energy that is left carries {carried:.3f} kg more",
        carried=carried,
    )
    cure = Message("give it a place and a mass in [drive], or state mechanics.car_mass_kg with it")
    return (Reservation("drive-not-counted", text, cure),)


def _by_usual_values() -> tuple[Reservation, ...]:
    """Reservation on a weight whose run is judged without [mechanics]."""
    usual = MechanicsSection()
    text = Message(
        "there is no [mechanics], so the energy of the weight is judged with a rod force of {force:g} N, a rolling "
        "resistance of {rolling:g}, and no brake",
        force=usual.rod_force_N,
        rolling=ROLLING_RESISTANCE,
    )
    cure = Message("say in [mechanics] rod_force_N, rolling_resistance and drag_least_Nmm")
    return (Reservation("energy-by-usual-values", text, cure),)


class _Unwound(NamedTuple):
    """String that a run takes off drum or axle; a weight cannot fall farther.

    Attributes:
        length: its length, mm: pi d for a turn of the axle, d being the diameter of the middle of the wound string.
        turns: turns of the axle.
        drum: diameter of the least drum for the axle, mm.
    """

    length: float
    turns: float
    drum: float


def _unwound(design: Design, wheel: DriveWheel) -> _Unwound:
    """String that a run takes off drum or axle.

    Args:
        design: design of the car.
        wheel: drive wheel that the cam is for.
    """
    axle = 0.0 if design.train is None else design.train.drive.bore_diameter_mm or 0.0
    if not axle or not wheel.radius or design.drive is None:
        return _Unwound(inf, inf, 0.0)
    turns = wheel.turn * wheel.finish / (2 * pi) / (2 * pi * wheel.radius)
    return _Unwound(turns * pi * design.drive.wound(axle), turns, axle + 2 * DRUM_WALL)


def _energy_check(
    spent: RunEnergy,
    has: float,
    falls: float | None,
    name: Message,
    drive: DriveSection | None,
    unwound: _Unwound,
    mass: float,
    guide: float,
    *,
    stated: bool,
) -> Check:
    advice = Message(
        "raise mechanics.drive_energy_J to {needed:.3g}, or lower the mass, the brake's drag or the rod's force",
        needed=1.005 * spent.needed,
    )
    # What a stated energy lacks no longer fall gives, unless it is more than all that the weight has.
    if drive is not None and falls is not None and 1.005 * spent.needed > falls:
        advice = _fall_advice(spent, drive, unwound, mass, guide)
    if stated and falls is not None and 1.005 * spent.needed > falls:
        advice = Message("leave mechanics.drive_energy_J out; {advice}", advice=advice)
    return Check(
        CheckCode.ENERGY_LEFT,
        name,
        float(has - spent.needed),
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
        advice,
    )


def _fall_advice(spent: RunEnergy, drive: DriveSection, unwound: _Unwound, mass: float, guide: float) -> Message:
    """Fall, drum or mass of a weight with which the run has its energy.

    Args:
        spent: energies of the run.
        drive: weight.
        unwound: string that a run takes off.
        mass: mass of the car, kg.
        guide: mass by which the guide grows with the fall, kg/mm.
    """
    most, fall = unwound.length, drive.fall_mm or 0.0
    rolled = spent.rolling / mass  # J/kg: what the car gains in mass rolls on its wheels, too
    gained = drive.mass_kg * GRAVITY * 1e-3 - rolled * guide  # J/mm
    farther = _SPARE * (spent.needed - rolled * guide * fall) / gained if gained > 0 else inf
    if farther <= min(most, MOST_FALL):
        return Message(
            "raise drive.fall_mm to {fall:.0f}, or lower the car's mass, its rolling resistance, the brake's drag or "
            "the rod's force",
            fall=farther,
        )
    if farther <= MOST_FALL:
        return Message(
            "a run takes {unwound:.0f} mm of string off, and a weight falls no farther: raise drive.fall_mm to "
            "{fall:.0f} with drive.drum_mm = {drum:g}, a drum for it on the axle",
            unwound=most,
            fall=farther,
            drum=max(ceil(2 * (farther / (pi * unwound.turns) - drive.string_mm)) / 2, unwound.drum),
        )
    if (more := GRAVITY * most * 1e-3 - rolled) > 0:
        return Message(
            "a run takes {unwound:.0f} mm of string off, and a weight falls no farther: let it fall by that, with "
            "drive.mass_kg at {heavier:.3g}",
            unwound=most,
            heavier=_SPARE * (spent.needed + rolled * guide * (most - fall) - rolled * drive.mass_kg) / more,
        )
    return Message("lower the car's mass, its rolling resistance, the brake's drag or the rod's force")


def _guide(design: Design) -> float:
    """Mass by which the guide of a weight grows with the fall, kg/mm: four tubes of aluminium with rods of steel."""
    screw = 3.0 if design.frame is None else float(design.frame.screws.value[1:])
    return pi * ((_TUBE**2 - _TUBE_BORE**2) * 2.7e-6 + screw**2 * 7.85e-6)
