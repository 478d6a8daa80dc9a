"""Effects of the mechanism and the instrument that show in a measured lift.

Stages: `ANGLE` (cam angle of each reading), `FOLLOWER` (the `Seat`), `READING` (what the dial shows). `at` are the
`Readings`.
"""

from dataclasses import dataclass, replace

import numpy as np

from cadgen.arrays import Array
from cadgen.cam.follower import EdgeFollower
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.deviations.disc import ECCENTRIC_BORE
from cadgen.deviations.effect import READING, Effect, Group, Parameter, Rows, Stage
from cadgen.deviations.return_error import return_error
from cadgen.messages import Message


@dataclass(frozen=True, kw_only=True)
class Readings(Rows):
    """Nominal state at each reading; arrays of shape (n,).

    Attributes:
        direction: +1 while the cam turns forward, -1 in reverse.
        slope: sign of ds/dtheta of the nominal lift.
        steering: tan(beta) of the nominal cam.
    """

    direction: Array
    slope: Array
    steering: Array


@dataclass(frozen=True)
class Seat:
    """The rod and how far the disc's faces stand off by cam angle: cos and sin amplitude, mm."""

    follower: EdgeFollower
    wobble: tuple[float, float] = (0.0, 0.0)


ANGLE = Stage[Array]("angle")
FOLLOWER = Stage[Seat]("follower")


def _um(name: str, meaning: str, usual: float, limit: float, lower: float | None = None) -> Parameter:
    low = -limit if lower is None else lower
    return Parameter(name=name, unit="um", lower=low, upper=limit, step=limit / 50, usual=usual, meaning=meaning)


def _moved_rod(seat: Seat, **by: float) -> Seat:
    """Seat with dimensions of the rod that are greater by some lengths, mm."""
    rod = seat.follower
    return replace(seat, follower=replace(rod, **{name: getattr(rod, name) + more for name, more in by.items()}))


RETURN_ERROR = Effect(
    name="backlash",
    stage=ANGLE,
    parameters=(return_error("whole play at the camshaft; the cam lags by half of it either way", 5.0, 0.05),),
    # The cam lags half the return error behind the divider, whichever way it turns.
    act=lambda angle, p, at: np.asarray(angle - at.direction * p[0] / 2),
    deviation=deviation.RETURN_ERROR,
    places=(Place.CAR,),
    group=Group("backlash"),
    confused_with="lost motion by friction",
    separated_by="hold the drive still and turn the camshaft to and fro by hand",
)
PHASE = Effect(
    name="phase",
    stage=ANGLE,
    parameters=(Parameter.of("phase_deg", 5.0, 0.05, 0.2, "+: the cam stands ahead, in its sense of turning"),),
    act=lambda angle, p, at: np.asarray(angle + p[0]),
    deviation=deviation.CAM_PHASE,
    places=(Place.CAR,),
    confused_with="backlash held by the spring",
    separated_by="mark the keyway and read the divider at the mark",
)
SHAFT_RUNOUT = replace(
    ECCENTRIC_BORE,
    name="run-out of the shaft",
    parameters=tuple(
        replace(
            p,
            name=p.name.replace("eccentric", "shaft"),
            usual=5.0,
            meaning=Message("+: it runs out towards {way} of the outline", way=way),
        )
        for p, way in zip(ECCENTRIC_BORE.parameters, ("+x", "+y"), strict=True)
    ),
    deviation=deviation.SHAFT_RUNOUT,
    places=(Place.CAR,),
    looks_like=ECCENTRIC_BORE,
    confused_with="an eccentric bore",
    separated_by="measure the profile about the bore on a CMM, and put a dial on the shaft",
)
BROKEN_EDGES = Effect(
    name="broken edges",
    stage=FOLLOWER,
    parameters=(
        _um("broken_edges_um", "both edges of the rim are broken by so much more than designed", 30.0, 2000.0, 0.0),
    ),
    # The rod rides on the land between the chamfers, which begins so much farther in on either side.
    act=lambda seat, p, at: _moved_rod(seat, inner=p[0], outer=-p[0]),
    deviation=deviation.EDGE_BREAK,
    places=(Place.CAR,),
    twins=("a thinner disc",),
    confused_with="a tilted indicator, wear of the edges",
    separated_by="measure thickness and land of the rim with a caliper, or look at its edges through a magnifier",
)
LIFT_EFFECTS = (
    # The shaft's run-out looks the same, and stays with the car.
    replace(ECCENTRIC_BORE, places=(Place.CAR, Place.PART, Place.PROCESS)),
    SHAFT_RUNOUT,
    PHASE,
    Effect(
        name="rod radius",
        stage=FOLLOWER,
        parameters=(_um("rod_radius_um", "+: the rod is too thick", 5.0, 1500.0),),
        act=lambda seat, p, at: _moved_rod(seat, radius=p[0]),
        deviation=deviation.ROD_RADIUS,
        places=(Place.CAR,),
        twins=("cutter compensation",),
        confused_with="cutter compensation of the profile",
        separated_by="measure the rod with a micrometer, or the profile on a CMM",
    ),
    Effect(
        name="lever gain",
        stage=READING,
        parameters=(Parameter.of("gain_percent", 5.0, 0.1, 0.3, "+: the dial shows too much"),),
        act=lambda reading, p, at: np.asarray(reading * (1 + p[0])),
        twins=("cosine error of the indicator",),
        confused_with="axial offset of the disc, cosine error of the indicator",
        separated_by="check the dial with gauge blocks; measure the distance from the fork axis to the disc",
    ),
    Effect(
        name="axial offset",
        stage=FOLLOWER,
        parameters=(_um("axial_offset_um", "+: the disc stands too far from the fork axis", 50.0, 4000.0),),
        act=lambda seat, p, at: _moved_rod(seat, inner=p[0], outer=p[0]),
        deviation=deviation.INNER_FACE,
        places=(Place.CAR,),
        confused_with="lever gain",
        separated_by="measure the distance from the fork axis to the disc's faces",
    ),
    BROKEN_EDGES,
    Effect(
        name="camshaft wobble",
        stage=FOLLOWER,
        parameters=(
            _um("wobble_cos_um", "+: at 0° of cam angle the face stands further from the fork axis", 30.0, 4000.0),
            _um("wobble_sin_um", "+: at 90° of cam angle", 30.0, 4000.0),
        ),
        act=lambda setting, p, at: replace(setting, wobble=(float(p[0]), float(p[1]))),
        confused_with="an eccentric bore, lever gain",
        separated_by="put the dial on the face of the disc and turn the camshaft",
    ),
    Effect(
        name="lost motion by friction",
        stage=READING,
        parameters=(_um("lost_motion_um", "by which the dial lags behind the rod, either way", 3.0, 300.0, 0.0),),
        # Coulomb friction bends the lever by a constant amount against the rod's motion.
        act=lambda reading, p, at: np.asarray(reading - p[0] * at.slope * at.direction),
        confused_with="backlash",
        separated_by="tap the lever before each reading: friction lets go, backlash stays",
    ),
    RETURN_ERROR,
    replace(
        RETURN_ERROR,
        name="backlash, held by the spring",
        cause="backlash",
        parameters=(
            return_error("whole play at the camshaft; the spring turns the cam downhill by half of it", 5.0, 0.05),
        ),
        # The spring turns the cam downhill as far as the play allows (half of it either side of the middle).
        act=lambda angle, p, at: np.asarray(angle - at.slope * p[0] / 2),
    ),
    Effect(
        name="hysteresis of the dial",
        stage=READING,
        parameters=(_um("hysteresis_um", "+: it reads less by half of it going forward, more in reverse", 2.0, 300.0),),
        # The dial itself lags by a constant amount, whichever flank the rod is on: half of it either way.
        act=lambda reading, p, at: np.asarray(reading - at.direction * p[0] / 2),
        confused_with="drift, as each run goes forward first and then back",
        separated_by="move the dial up to a gauge block and down to it, and read both",
    ),
    Effect(
        name="drift",
        stage=READING,
        parameters=(_um("drift_um_per_run", "+: the reading grows from a run's first row to its last", 3.0, 200.0),),
        act=lambda reading, p, at: np.asarray(reading + p[0] * at.elapsed),
        confused_with="runs that disagree",
        separated_by="let the dial and the car warm up, and read the zero again at the end of each run",
    ),
    Effect(
        name="tilted indicator",
        stage=READING,
        parameters=(
            Parameter.of(
                "indicator_tilt_deg",
                20.0,
                0.5,
                0.5,
                "+: its tip points away from the fork axis, so that it reads more on a lifted rod",
            ),
        ),
        # A spindle tilted by alpha in the plane of the swing meets the rod where x = t cos a, w = w0 + t sin a.
        act=lambda reading, p, at: np.asarray(reading / (np.cos(p[0]) - np.sin(p[0]) * at.steering)),
        twins=("a dial whose scale is not even",),
        confused_with="axial offset of the disc, wear",
        separated_by="set the spindle square to the rod with a precision square and measure again",
    ),
)
