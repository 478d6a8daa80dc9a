"""Everything that moves on the page: runs over the cam angle, course, car, shafts, and parts in 3D."""

from collections.abc import Iterator

import numpy as np

from cadgen.arrays import TURN
from cadgen.cam.followers.rod import LeaningRod
from cadgen.car.course.body import place_of
from cadgen.car.course.layout import CarPoint, Course, Gate, Shape
from cadgen.car.motion.drive import drive, start_pose
from cadgen.car.motion.play import Following, follow
from cadgen.car.path_motion import PathMotion
from cadgen.design import cam_model, course_model
from cadgen.design.schema import Design
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.viewer.page.content.bodies import Bodies, bodies_of
from cadgen.viewer.page.document import CarShape, Figure, Going, Lift, RodShape, Scene, Text
from cadgen.viewer.page.names import FigureKind
from cadgen.viewer.page.words import say

POSITIONS = 1440  # of the motor: one each quarter of a degree, and to either side of each jump
LIFTS = 2880  # straight lines between them err by 0.1 um where the lift bends by 150 mm/rad^2
_OUTLINE = 0.5  # mm between points of the profile in the plan view
_HOLE_CHORD = 0.02  # mm
_BESIDE = 1e-7  # rad, before a jump


def rolled_lift_of(plan: CamPlan) -> PathMotion:
    """Lift that the follower gets on the cam that is made."""
    return plan.lift if plan.comparison is None else plan.comparison.chosen.rolled


def scene_of(plan: CamPlan, gears: GearsPlan | None) -> tuple[Scene, tuple[Text, ...]]:
    """Everything that moves, and remarks on what is drawn otherwise than it will be built.

    Args:
        plan: plan of the cam.
        gears: plan of the train; None without one.
    """
    outline = plan.curve.outline(_OUTLINE).points
    bodies = bodies_of(plan, gears, float(np.hypot(*outline.T).max()))
    tan_beta = rolled_lift_of(plan).q(np.linspace(0.0, TURN, LIFTS + 1) % TURN)
    scene = Scene(
        outline=outline,
        openings=tuple(contour.polygon(_HOLE_CHORD) for contour in plan.made_blank.inner_contours()),
        follower=_rod(plan, bodies),
        base=float(plan.rod.base_radius),
        lift=Lift(lift=np.asarray(plan.rod.lift(tan_beta)), tan_beta=np.asarray(tan_beta)),
        stop=plan.lift.blend_start if plan.comparison is None else plan.comparison.task.lift.blend_start,
        goings=tuple(_goings(plan)),
        floor=floor_of(plan.design),
        car=_car(plan),
        shafts=bodies.shafts,
        parts=bodies.parts,
        wheel=bodies.wheel,
    )
    noted = () if plan.design.as_built is None else (say("as-built-drawn"),)
    return scene, (*bodies.notes, *noted)


def _rod(plan: CamPlan, bodies: Bodies) -> RodShape | None:
    rod, (inner, outer) = plan.rod, plan.design.cam.faces_mm
    if not isinstance(rod, LeaningRod):
        return None
    return RodShape(
        base=rod.base_radius,
        radius=rod.radius,
        length=min(rod.length, 4 * outer),
        faces=(inner, outer),
        height=bodies.fork,
        side=bodies.side,
    )


def _goings(plan: CamPlan) -> Iterator[Going]:
    """Runs: planned, this cam without and with play, the plain profile with play."""
    lift, comparison, design = rolled_lift_of(plan), plan.comparison, plan.design
    if comparison is None:
        yield _going(plan, "free", say("this cam, without play"), follow(lift, 0.0), 0.0)
        return
    chosen, before, task = comparison.chosen, comparison.before, comparison.task
    yield _going(plan, "planned", say("planned"), task.following(task.lift, 0.0), 0.0)
    yield _going(plan, "free", say("this cam, without play"), comparison.following(chosen, 0.0), 0.0)
    yield _going(plan, "played", say("this cam, with play"), comparison.following(chosen, chosen.play), chosen.play)
    if chosen is not before:
        known = say("plain profile, with play" if design.as_built is None else "measured cam, with play")
        yield _going(plan, "before", known, comparison.following(before, chosen.play), chosen.play)


def _going(plan: CamPlan, code: str, label: Text, following: Following, play: float) -> Going:
    """A run at even motor positions, and to either side of each place where the cam jumps, stops or goes on."""
    design, track = plan.design, plan.track
    stop = TURN if design.car.drive_wheel_radius_mm is None else plan.lift.blend_start
    run = drive(
        following.lift,
        cam_model.car(design),
        cam_model.travel(design, track),
        start=start_pose(track),
        stop=stop,
        steps=POSITIONS,
        following=following,
        at_joints=True,
    )
    peaks = following.leads[:, 0] if len(following.leads) else np.empty(0)
    motor = np.union1d(run.motor, np.clip(peaks - _BESIDE, 0.0, stop))
    x, y, heading = (np.interp(motor, run.motor, values) for values in (*run.drive_wheel.T, run.heading))
    cam_angle = following.cam_angle(motor)
    return Going(code=code, label=label, motor=motor, cam_angle=cam_angle, x=x, y=y, heading=heading, play=play)


def _car(plan: CamPlan) -> CarShape:
    car, body = cam_model.car(plan.design), course_model.body(plan.design)
    drive_wheel = place_of(CarPoint.DRIVE_WHEEL, car)

    def seen(point: tuple[float, float]) -> tuple[float, float]:
        return point[0] - drive_wheel[0], point[1] - drive_wheel[1]

    return CarShape(
        fork=seen(place_of(CarPoint.FORK, car)),
        idle=seen(place_of(CarPoint.IDLE_WHEEL, car)),
        middle=seen(place_of(CarPoint.MIDDLE, car)),
        corners=tuple(seen(corner) for corner in body.corners),
        wheel=plan.wheel.radius,
        steering=1 if car.steering_gain > 0 else -1,
    )


def floor_of(design: Design) -> tuple[Figure, ...]:
    """Everything on the floor."""
    course = course_model.course(design)
    return () if course is None else tuple(_figures(course))


def _figures(course: Course) -> Iterator[Figure]:
    if course.edge is not None:
        yield _figure(FigureKind.EDGE, course.edge)
    for obstacle in course.obstacles:
        yield _figure(FigureKind(obstacle.kind), obstacle.shape)
    stands: tuple[tuple[FigureKind, Gate | None], ...] = (
        (FigureKind.START, course.start),
        (FigureKind.FINISH, course.finish),
    )
    for gate in course.gates:
        yield _figure(FigureKind.GATE, gate.place)
    for kind, stand in stands:
        if stand is not None:
            yield _figure(kind, stand.place)


def _figure(kind: FigureKind, shape: Shape) -> Figure:
    return Figure(kind, shape.points, shape.filled, shape.reach)
