"""Curves over the cam angle: lift, steering, pressure angle, curvature, torque; and the marked places of the turn."""

from dataclasses import dataclass
from math import degrees

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll_curve
from cadgen.cam.follower import Contact
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.path_motion import PathMotion
from cadgen.curves.closed import ClosedCurve
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.simulation import Simulation
from cadgen.messages import Message
from cadgen.viewer.page.document import Chart, Curve, Limit, Mark, MarkKind

STATIONS = 720  # of a chart: one each half degree; a curve on a phone has fewer dots
_POINTS_OF_A_PIECE = 400  # at which the curvature of the profile is computed


@dataclass(frozen=True)
class Charted:
    """Charts and marks of a cam."""

    charts: tuple[Chart, ...]
    marks: tuple[Mark, ...]


def charts_of(plan: CamPlan, simulation: Simulation[CamPlan] | None) -> Charted:
    """Charts of a cam that is planned, and the marks of its lift."""
    theta = np.linspace(0.0, TURN, STATIONS + 1)
    wanted = plan.curve if plan.comparison is None else plan.comparison.chosen.wanted.curve
    contact, _ = roll_curve(wanted, plan.follower, theta[:-1])
    charts = [_lift(plan, theta, contact), _pressure(plan, theta, contact), _curvature(plan, wanted, theta, contact)]
    if simulation is not None:
        charts.append(_off(simulation))
    if (torque := _torque(plan, theta)) is not None:
        charts.append(torque)
    return Charted(tuple(charts), tuple(_marks(plan)))


def _closed(values: Array) -> Array:
    return np.append(values, values[:1])


def _lift(plan: CamPlan, theta: Array, contact: Contact) -> Chart:
    """Lift wanted, and the lift that the follower gets."""
    curves = [Curve(Message("lift given"), _closed(contact.lift))]
    if plan.comparison is not None:
        wanted = plan.comparison.task.lift
        curves.append(Curve(Message("lift wanted"), np.asarray(plan.rod.lift(wanted.q(theta % TURN))), dashed=True))
    return Chart("lift", Message("Lift"), "mm", theta, tuple(curves))


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
    ahead = plan.follower.ahead(contact.q, contact.face, contact.across)
    at = (contact.cam_angle + np.arctan2(contact.across, ahead)) % TURN
    values = np.interp(at, angle, curvature, period=TURN)
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


def _off(simulation: Simulation[CamPlan]) -> Chart:
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


def _torque(plan: CamPlan, theta: Array) -> Chart | None:
    """Torque by which the rod turns the cam ahead; None without [mechanics]."""
    band = None if plan.comparison is None else plan.comparison.task.mechanics
    if band is None or plan.comparison is None:
        return None
    nominal, lift = band.nominal, plan.comparison.chosen.lift
    values = nominal.torque(lift, theta % TURN)
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


def _marks(plan: CamPlan) -> list[Mark]:
    peaks, valleys = plan.motion.extrema()
    marks = [Mark(MarkKind.PEAK, float(angle)) for angle in peaks] + [
        Mark(MarkKind.VALLEY, float(angle)) for angle in valleys
    ]
    if isinstance(plan.motion, PathMotion) and plan.motion.blended:
        marks.append(Mark(MarkKind.BLEND, plan.motion.blend_start))
    return sorted(marks, key=lambda mark: mark.angle)
