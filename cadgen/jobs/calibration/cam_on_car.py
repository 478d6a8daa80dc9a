"""The car as designed with a cam on it: the one that was measured, or one made for what was found of the car."""

from collections.abc import Iterator
from math import pi, radians

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.contact import roll_curve
from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.car.running.sampled import rolled_lift
from cadgen.design import cam_model, gear_model, variation
from cadgen.design.as_built import AsBuiltSection
from cadgen.design.schema import Design
from cadgen.gears.choices import Order
from cadgen.gears.spur import spur_pairs
from cadgen.gears.synthesis import arrange
from cadgen.inference.expectation.outlook import Unmeasured
from cadgen.inference.measurement.nominal import Nominal
from cadgen.jobs.cam.built_car import stop_as_designed
from cadgen.jobs.cam.steering_cam import CarUse, default_profile, plan_cam
from cadgen.messages import Message
from cadgen.progress import Progress, silent

# A closed path is refused with these.
_LAPS = (
    "a calibration",
    "calibrate the car on a design with an open path, and give a measured return error as play.measured_deg",
)
_STATIONS = 3600  # at which any other is rolled
INCLINOMETER_DEG = 0.01  # standard deviation of play.measured_deg


def refuse_laps(design: Design) -> None:
    """Refuse a design whose path is closed: the models of data end with the run.

    Raises:
        DesignError: the path is closed.
    """
    cam_model.refuse_laps(design, *_LAPS)


def nominal_of(design: Design, profile: str, progress: Progress = silent) -> Nominal:
    """Nominal state for data of a cam and its car: the cam as this design makes it, the car as designed.

    Raises:
        DesignError, CheckError: see `plan_cam`.
    """
    refuse_laps(design)
    bare = design.as_designed()
    rod = cam_model.leaning(bare, "a calibration")
    plan = plan_cam(design, profile, progress)
    follower = rod.point() if plan.kind.by_axis else rod
    use = CarUse.of(plan)
    lift = cut = use.steering
    if design.as_built is not None or not plan.kind.gives_lift:
        # What is cut gives the rod of the designed car another lift than the planned one.
        angle = np.linspace(0.0, 2 * pi, _STATIONS, endpoint=False)
        lift = rolled_lift(roll_curve(plan.on_shaft, follower, angle)[0], lift, blend_start=lift.blend_start)
        cut = cut if plan.kind.gives_lift else lift
    ratios, teeth = ratios_and_teeth(design)
    forces = variation.mechanics(bare, follower, cut)
    play = None if bare.play is None else bare.play.measured_deg
    return Nominal(
        lift=lift,
        cut=cut,
        mechanics=None if forces is None else forces.nominal,
        # Measured with the rod lifted, and its standard deviation.
        play=None if play is None else (radians(play), radians(INCLINOMETER_DEG)),
        follower=follower,
        profile=plan.on_shaft,
        car=cam_model.car(bare),
        track=use.track,
        ratios=ratios,
        teeth=teeth,
    )


def other_cams(design: Design, profile: str) -> Iterator[tuple[str, Design, bool]]:
    """Cams that may be on a car beside the stated one: profile, design that made it, whether an earlier one.

    These are the actual profile and the one that a cam of the design has by default; and of a design that was
    calibrated every cam with which the car was measured, the last one first.

    Args:
        design: loaded design.
        profile: of the stated cam.
    """
    for code in dict.fromkeys((ACTUAL.code, default_profile(design).code)):
        if code != profile:
            yield code, design, False
    if (known := design.as_built) is not None:
        for cam in reversed(known.cams):
            cut_for = AsBuiltSection(effects=cam.cut_for) if cam.cut_for else None
            yield cam.profile, design.model_copy(update={"as_built": cut_for}), True


def ratios_and_teeth(design: Design) -> tuple[tuple[float, ...], tuple[int, ...]]:
    """Ratio and driven wheel's teeth of each stage, in the order that the car has; nothing without [train]."""
    if design.train is None:
        return (), ()
    train = arrange(gear_model.train(design), Order(design.optimize.order))[0].train
    pairs = spur_pairs(train, Message("a calibration is"))
    return tuple(float(pair.ratio) for pair in pairs), tuple(pair.driven.form.teeth for pair in pairs)


def planned_end(design: Design, nominal: Nominal) -> complex:
    """End of the run as it is planned, x + iy, mm.

    Args:
        design: loaded design.
        nominal: its car, whose track is the planned one.
    """
    track = nominal.track
    x, y = track.position(min(track.turn * stop_as_designed(design) / TURN, track.length)).tolist()
    return complex(x, y)


def unmeasured(design: Design, nominal: Nominal) -> Unmeasured:
    """Play and friction that a car may have whose run was not measured.

    Friction that the design does not state is left out, as in the cam, whose verdict has it among its reservations.

    Args:
        design: loaded design.
        nominal: car that the records were measured against, with the play that was measured apart.
    """
    bare = design.as_designed()
    band = variation.play_bands(bare).get(design.optimize.order)
    play = (0.0, 0.0) if band is None else band.ends
    if nominal.play is not None:
        value, sigma = nominal.play
        play = max(value - 2 * sigma, 0.0), value + 2 * sigma
    forces = variation.mechanics(bare, nominal.follower, nominal.lift)
    return Unmeasured(play=play, friction=(0.0, 0.0) if forces is None else forces.friction)
