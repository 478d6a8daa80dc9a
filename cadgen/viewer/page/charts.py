"""Curves over the cam angle: lift, steering, pressure angle, curvature, torque; and the marked places of the turn."""

from collections.abc import Iterator
from math import degrees

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll_curve
from cadgen.cam.follower import Contact
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import MechanicsBand
from cadgen.curves.closed import ClosedCurve
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.simulation import Simulation
from cadgen.laws.unit import TAN
from cadgen.messages import Message
from cadgen.viewer.page.document import Chart, Curve, LiftMark, Limit, MarkKind

_DERIVATIVES = (
    ("velocity", Message("Velocity")),
    ("acceleration", Message("Acceleration")),
    ("jerk", Message("Jerk")),
)
_POWERS = ("", "²", "³")
STATIONS = 720  # of a chart: one each half degree; a curve on a phone has fewer dots
_POINTS_OF_A_PIECE = 400  # at which the curvature of the profile is computed


def charts_of(plan: CamPlan) -> tuple[Chart, ...]:
    """Lift, pressure angle and curvature of a cam that is planned, and of a motion its derivatives."""
    theta = np.linspace(0.0, TURN, STATIONS + 1)
    curve = plan.application.envelope(plan)
    contact, _ = roll_curve(curve, plan.follower, theta[:-1])
    return (
        _lift(plan, theta, contact),
        *_derivatives(plan, theta),
        _pressure(plan, theta, contact),
        _curvature(plan, curve, theta, contact),
    )


def _closed(values: Array) -> Array:
    return np.append(values, values[:1])


def _lift(plan: CamPlan, theta: Array, contact: Contact) -> Chart:
    """Lift wanted, and the lift that the follower gets."""
    curves = [Curve(Message("lift given"), _closed(contact.lift))]
    wanted = plan.application.planned(plan)
    if wanted is not None:
        values = np.asarray(plan.follower_as_built.lift(wanted.q(theta % TURN)))
        curves.append(Curve(Message("lift wanted"), values, dashed=True))
    return Chart("lift", Message("Lift"), "mm", theta, tuple(curves))


def _derivatives(plan: CamPlan, theta: Array) -> Iterator[Chart]:
    """Velocity, acceleration and jerk of a follower by cam angle, with its forces; none on the fork of a car."""
    unit = plan.motion.unit
    if unit == TAN:
        return
    jets = plan.motion.jets(theta)
    for order, (code, title) in enumerate(_DERIVATIVES, 1):
        by = f"{unit.symbol}/rad{_POWERS[order - 1]}"
        yield Chart(code, title, by, theta, (Curve(title, jets[:, order]),))
    forces = plan.application.forces(plan)
    if forces is not None:
        for code, title, by, values in (
            ("force", Message("Force on the disc"), "N", forces.normal(jets, theta)),
            ("torque", Message("Torque of the camshaft"), "N·mm", forces.torque(jets, theta)),
        ):
            # Where the guide jams there is none.
            yield Chart(code, title, by, theta, (Curve(title, np.where(np.isfinite(values), values, np.nan)),))


def _pressure(plan: CamPlan, theta: Array, contact: Contact) -> Chart:
    limits = plan.limits.pressure_angle
    values = np.degrees(contact.pressure_angle)
    return Chart(
        "pressure",
        Message("Pressure angle"),
        "°",
        theta,
        (Curve(Message("pressure angle"), _closed(values)),),
        (Limit(Message("limit, rise"), degrees(limits.rise)), Limit(Message("limit, return"), -degrees(limits.fall))),
    )


def _curvature(plan: CamPlan, curve: ClosedCurve, theta: Array, contact: Contact) -> Chart:
    """Curvature of the profile where the follower touches it."""
    angle, curvature = curvature_by_angle(curve)
    values = np.interp(plan.follower.place(contact) % TURN, angle, curvature, period=TURN)
    return Chart(
        "curvature",
        Message("Curvature of the profile"),
        "1/m",
        theta,
        (Curve(Message("curvature"), _closed(1e3 * values)),),
    )


def curvature_by_angle(curve: ClosedCurve) -> tuple[Array, Array]:
    """Polar angles of points on a curve, rad, in order, and the curvature there, 1/mm, convex positive."""
    jets = [piece.jet(np.linspace(piece.start, piece.stop, _POINTS_OF_A_PIECE)) for piece in curve.pieces]
    points, curvature = np.concatenate([jet.point for jet in jets]), np.concatenate([jet.curvature for jet in jets])
    angle = np.arctan2(points[:, 1], points[:, 0]) % TURN
    order = np.argsort(angle, kind="stable")
    return angle[order], curvature[order]


def name_before(before: Evaluation) -> Message:
    """Name of the run of the profile before, with play."""
    return Message("measured cam, with play" if before.measured else "plain profile, with play")


def drift_chart(simulation: Simulation[CamPlan]) -> Chart:
    """Distance from the planned place, with play."""
    motor = simulation.planned.motor
    theta = np.linspace(0.0, TURN, STATIONS + 1)

    def along(values: Array) -> Array:
        return np.where(theta <= motor[-1] + 1e-9, np.interp(theta, motor, values), np.nan)

    chosen, before = simulation.comparison.chosen, simulation.comparison.before
    curves = [Curve(Message("this cam, with play"), along(simulation.after_error.distance))]
    if chosen is not before:
        curves.append(Curve(name_before(before), along(simulation.before_error.distance), dashed=True))
    return Chart("off", Message("Distance from the planned place"), "mm", theta, tuple(curves))


def torque_chart(band: MechanicsBand, lift: PathMotion) -> Chart:
    """Torque by which the follower turns the cam ahead.

    Args:
        band: range of the forces on the cam.
        lift: lift that the cam is cut for.
    """
    theta = np.linspace(0.0, TURN, STATIONS + 1)
    values = band.nominal.torque(lift, theta % TURN)
    free = band.at(0.0, 0.0).torque(lift, theta % TURN)
    return Chart(
        "torque",
        Message("Torque of the rod on the cam"),
        "N·mm",
        theta,
        (
            Curve(Message("with friction"), np.where(np.isfinite(values), values, np.nan)),
            Curve(Message("without friction"), np.where(np.isfinite(free), free, np.nan), dashed=True),
        ),
        (Limit(Message("least drag"), band.drag[0]),) if band.drag[0] else (),
    )


def marks_of(plan: CamPlan) -> tuple[LiftMark, ...]:
    """Peaks and valleys of the motion."""
    peaks, valleys = plan.motion.extrema()
    marks = [LiftMark(MarkKind.PEAK, float(angle)) for angle in peaks] + [
        LiftMark(MarkKind.VALLEY, float(angle)) for angle in valleys
    ]
    return tuple(sorted(marks, key=lambda mark: mark.angle))
