"""Measurements that could be made next, each as the record that it would give of a car as it is known so far."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.effect import Active
from cadgen.inference.measurement.kinds import LIFT, PROFILE, TRACK, TRANSMISSION
from cadgen.inference.measurement.kinds.track import run_of
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Direction, Kind, Record

# Standard deviation of a reading, by code of the kind, internal units: usual instruments, where no record shows better.
NOISE = {LIFT.code: 4e-3, PROFILE.code: 2e-3, TRANSMISSION.code: float(np.radians(0.03)), TRACK.code: 3.0}
# The play at the camshaft, by hand and an inclinometer with the rod lifted.
BY_HAND = float(np.radians(0.01))
STOP = "start set to 0.5 mm and 0.05 deg"
TRACK_STEP, LIFT_STEP, PROFILE_POINTS, TRAIN_STEP = 2.0, 2.0, 360, 2.0  # degrees of cam angle; points of one run
LAST_DEG = 340.0  # of a lift: the closing blend of the cam steers no path


@dataclass(frozen=True)
class Proposal:
    """A measurement that could be made.

    Attributes:
        words: what to do.
        kind: of the data; None for the play by hand, which is a number of the design.
        runs: how many.
        record: as it would be read of the car as it is known so far; None for the play by hand.
        idle: quantities that do not act in it, as friction does not with the rod lifted.
    """

    words: str
    kind: Kind | None
    runs: int
    record: Record | None
    idle: frozenset[Deviation] = frozenset()


def proposals(nominal: Nominal, known: Active, measured: Sequence[Kind]) -> tuple[Proposal, ...]:
    """Everything that may be measured next.

    Args:
        nominal: the design.
        known: effects as a track names them, with their values so far.
        measured: kinds of data that there are already.
    """
    more = "more " if TRACK in measured else ""
    out = [_track(nominal, known, count, more) for count in (2, 4, 8)]
    out.append(_track(nominal, known, 4, more, STOP))
    out += [_lift(nominal, both=True), _lift(nominal, both=False)]
    out += [_profile(nominal, quarters=False), _profile(nominal, quarters=True)]
    if nominal.ratios:
        out += [_train(nominal, lifted=True, back=True), _train(nominal, lifted=False, back=True)]
        out.append(_train(nominal, lifted=True, back=False))
        by_hand = "the play at the camshaft, the rod lifted, by an inclinometer to and fro; set play.measured_deg"
        out.append(Proposal(by_hand, None, 1, None))
    return tuple(out)


def _record(kind: Kind, columns: Mapping[str, NDArray[np.generic]], runs: int, remark: str = "") -> Record:
    rows = len(next(iter(columns.values())))
    run = np.repeat(np.arange(runs), rows)
    repeated: dict[str, NDArray[np.generic]] = {name: np.tile(values, runs) for name, values in columns.items()}
    remarks = (remark,) if remark else ()
    return Record(kind=kind, columns=repeated, run=run, remarks=remarks, source=f"a {kind.code} to be measured")


def _track(nominal: Nominal, known: Active, runs: int, more: str, remark: str = "") -> Proposal:
    motor = np.arange(0.0, 360.0, TRACK_STEP)
    place = run_of(nominal).at(known, np.radians(motor))
    columns = {"cam_angle_deg": motor, "x_mm": place.real, "y_mm": place.imag}
    words = f"{runs} {more}runs of the track before a camera"
    if remark:
        words += ", the start set against a stop, to 0.5 mm and 0.05°"
    return Proposal(words, TRACK, runs, _record(TRACK, columns, runs, remark))


def _lift(nominal: Nominal, *, both: bool, runs: int = 3) -> Proposal:
    there = np.arange(0.0, LAST_DEG + LIFT_STEP / 2, LIFT_STEP)
    angle = np.concatenate([there, there[::-1]]) if both else there
    forward = np.arange(len(angle)) < len(there)
    columns = {
        "direction": np.where(forward, Direction.FORWARD, Direction.REVERSE),
        "cam_angle_deg": angle,
        "lift_mm": nominal.follower.inner * nominal.lift.q(np.radians(angle)),
    }
    words = f"the lift by a dial, {runs} runs, {'forward and back' if both else 'forward only'}"
    return Proposal(words, LIFT, runs, _record(LIFT, columns, runs))


def _profile(nominal: Nominal, *, quarters: bool, runs: int = 4) -> Proposal:
    disc = nominal.disc
    angle = np.linspace(0.0, TURN, PROFILE_POINTS, endpoint=False) + disc.angle[0]
    radius = np.interp(angle, disc.angle, np.linalg.norm(disc.points, axis=1), period=TURN)
    turned = [angle + (TURN / 4 * run if quarters else 0.0) for run in range(runs)]
    columns: dict[str, NDArray[np.generic]] = {
        "x_mm": np.concatenate([radius * np.cos(way) for way in turned]),
        "y_mm": np.concatenate([radius * np.sin(way) for way in turned]),
    }
    run = np.repeat(np.arange(runs), PROFILE_POINTS)
    record = Record(kind=PROFILE, columns=columns, run=run, remarks=(), source="a profile to be measured")
    how = "turned on by a quarter from run to run" if quarters else "clamped as it lies"
    return Proposal(f"the profile on a measuring machine, {runs} runs, the disc {how}", PROFILE, runs, record)


def _train(nominal: Nominal, *, lifted: bool, back: bool, runs: int = 3) -> Proposal:
    there = np.arange(0.0, 360.0 + TRAIN_STEP / 2, TRAIN_STEP)
    cam = np.concatenate([there, there[-2::-1]]) if back else there
    columns = {"motor_angle_deg": cam * float(np.prod(nominal.ratios)), "cam_angle_deg": cam}
    rod, way = "lifted" if lifted else "on the disc", "forward and back" if back else "forward only"
    words = f"angles at both ends of the train, {runs} runs, {way}, the rod {rod}"
    idle = frozenset({deviation.SLIDING_FRICTION} if lifted else ())
    return Proposal(words, TRANSMISSION, runs, _record(TRANSMISSION, columns, runs), idle)


def around(kind: Kind | None) -> bool:
    """Whether a part of the turn may be measured alone."""
    return kind in (LIFT, PROFILE)
