"""Everything that moves on the page: runs over the cam angle, course, car, shafts, and parts in 3D."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import hypot

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.cam.contact import roll_curve
from cadgen.cam.follower import EdgeFollower
from cadgen.car.assembly.car_parts import Block, BodyShape, DiscShape, GroupKind, Joined, MovingGroup
from cadgen.car.assembly.turning_train import (
    Stand,
    TurningPart,
    TurningTrain,
    height_beside,
    turned_to_axle,
    turning_train,
)
from cadgen.car.course.body import place_of
from cadgen.car.course.layout import CarPoint, Course, Gate, Shape, Side
from cadgen.car.running.drive import drive, start_pose
from cadgen.car.running.play import Following, follow
from cadgen.curves.contour import circle
from cadgen.design.course import layout_of
from cadgen.design.schema import Design
from cadgen.errors import CadgenError
from cadgen.gears.layout import TrainPart
from cadgen.geometry.meshes.car_meshes import shape_mesh, stood
from cadgen.geometry.meshes.mesh import Mesh, cam_mesh, grooved_mesh
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import CarUse
from cadgen.jobs.car_assembly import CarAssembly, put_together
from cadgen.jobs.car_gaps import part_gaps
from cadgen.jobs.gears.gear_train import GearTrain
from cadgen.laws.unit import MM
from cadgen.messages import Message, joined
from cadgen.parts.face import Face
from cadgen.parts.loop import Loop
from cadgen.viewer.page.charts import name_before
from cadgen.viewer.page.document import (
    FORK,
    STILL,
    Arm,
    CarShape,
    Colour,
    CompanionDisc,
    FloorKind,
    FloorShape,
    Going,
    RodShape,
    Scene,
    SceneLift,
    ScenePart,
    SceneShaft,
    Slide,
    Travel,
    WheelShape,
)

POSITIONS = 1440  # of the motor: one each quarter of a degree, and to either side of each jump
LIFTS = 2880  # straight lines between them err by 0.1 um where the lift bends by 150 mm/rad^2
GAP = 2.0  # mm between the cam, or its hub, and the stack of gears
_OUTLINE = 0.5  # mm between points of the profile in the plan view
_SEEN = 1.5  # mm, radius of a point that is drawn
_PLATE = 4.0  # mm, thickness of a follower of which only the side is known that touches the disc
_HOLE_CHORD = 0.02  # mm
# Half width of a slide's stem: share of the follower's half width, and bounds, mm. Rails are so many half widths long.
_STEM_SHARE, _STEM_LEAST, _STEM_MOST, _RAILS = 0.35, 1.5, 8.0, 5.0
_STRAIGHT = 1e-3  # mm², or share: a way that is no arc about a pivot
_BESIDE = 1e-7  # rad, before a jump
MOST_TRIANGLES = 60_000
# mm, of the meshes shown: the finest with which they are few enough.
_CHORDS = (0.01, 0.015, 0.02, 0.03, 0.04, 0.08, 0.16)
# mm, of the meshes shown while they move on a machine without a graphics card: as few triangles as still are the part.
_COARSE = 0.12
_BEYOND = 6.0  # mm by which a shaft is drawn longer than what sits on it


@dataclass(frozen=True)
class Bodies:
    """Bodies drawn in 3D.

    Attributes:
        shafts: shafts; the first is that of the cam.
        parts: parts on them.
        wheel: index of the shaft, height and radius of the drive wheel, mm; None if one is not known.
        fork: height of the fork's axis, mm.
        side: 1 for a cam to the left of the fork, -1 to the right.
        notes: remarks.
    """

    shafts: tuple[SceneShaft, ...]
    parts: tuple[ScenePart, ...]
    wheel: tuple[int, float, float] | None
    fork: float
    side: int
    notes: tuple[str, ...]


def scene_of(plan: CamPlan, gears: GearTrain | None) -> tuple[Scene, tuple[str, ...]]:
    """Everything that moves, and remarks on what is drawn otherwise than it will be built.

    Args:
        plan: plan of the cam.
        gears: plan of the train; None without one.
    """
    outline = plan.curve.outline(_OUTLINE).points
    bodies = bodies_of(plan, gears, float(np.hypot(*outline.T).max()))
    use = CarUse.of(plan)
    tan_beta = np.asarray(use.rolled(plan).q(np.linspace(0.0, TURN, LIFTS + 1) % TURN))
    rod = _rod(plan, bodies)
    scene = Scene(
        outline=outline,
        openings=tuple(contour.polygon(_HOLE_CHORD) for contour in plan.made_blank.inner_contours()),
        follower=rod,
        noun=plan.follower_as_built.noun,
        unit=plan.motion.unit.symbol,
        section=section_of(plan, float(tan_beta[0])),
        travel=None if rod else travel_of(plan, tan_beta),
        guide=None,
        hint=Message("seen from the left of the car, the front to the left"),
        clearance=_clearance(plan),
        base=float(plan.follower_as_built.base_radius),
        lift=SceneLift(lift=np.asarray(plan.follower_as_built.lift(tan_beta)), q=tan_beta),
        stop=use.wanted.blend_start,
        goings=tuple(_goings(plan)),
        floor=figures_of(use.layout),
        car=_car(use),
        shafts=bodies.shafts,
        parts=bodies.parts,
        wheel=bodies.wheel,
    )
    noted = (
        ()
        if use.record is None
        else (
            Message(
                "The disc is drawn as it is cut and centred on its shaft; the runs count in what [as_built] says of "
                "the car."
            ),
        )
    )
    return scene, (*bodies.notes, *noted)


def plain_scene(plan: CamPlan, gears: GearTrain | None) -> tuple[Scene, tuple[str, ...]]:
    """A cam without a car, its follower and its train; and remarks on what has no solid.

    Where the profile cannot give the motion, the follower moves as it rolls on the disc.

    Args:
        plan: plan of the cam.
        gears: plan of the train; None without one.
    """
    theta = np.linspace(0.0, TURN, LIFTS + 1) % TURN
    q = np.asarray(plan.motion.q(theta))
    if plan.trims:
        rolled, _ = roll_curve(plan.curve, plan.follower, theta[:-1])
        q = np.append(rolled.q, rolled.q[:1])
    notes: list[str] = []
    train = None if gears is None else _train(plan, gears, 1, 0.0)
    parts = _parts(plan, train, notes)
    shafts = [_camshaft(plan, train)]
    if train is not None:
        shafts += [_shaft(part, None, drawn=number > 0) for number, part in enumerate(reversed(train.parts))]
        shafts += _planets(train)
    section, travel = section_of(plan, float(q[0])), travel_of(plan, q)
    second = None if plan.second is None else _companion(plan.second, -q)
    openings = [contour.polygon(_HOLE_CHORD) for contour in plan.made_blank.inner_contours()]
    outline = plan.curve.outline(_OUTLINE).points
    if plan.groove is not None:
        # The floor of the groove is shown as a ring, its flanks joined by a seam.
        far = plan.groove.outer.curve.outline(_OUTLINE).points
        openings.append(np.concatenate([far, far[:1], outline[:1], outline[::-1]]))
        outline = circle((0.0, 0.0), plan.groove.outside_radius).polygon(_HOLE_CHORD)
    scene = Scene(
        outline=outline,
        openings=tuple(openings),
        follower=None,
        noun=plan.follower_as_built.noun,
        unit=plan.motion.unit.symbol,
        section=section,
        travel=travel,
        guide=_slide(plan, section, travel) if plan.motion.unit == MM else arm_of(plan, travel, float(q[0])),
        hint=Message("seen on its {seen} face, on which it turns clockwise", seen=Message(str(plan.seen))),
        clearance=_clearance(plan),
        base=float(plan.follower_as_built.base_radius),
        lift=SceneLift(lift=np.asarray(plan.follower_as_built.lift(q)), q=q),
        stop=TURN,
        goings=(),
        floor=(),
        car=None,
        shafts=tuple(shafts),
        parts=tuple(parts),
        second=second,
    )
    return scene, tuple(notes)


def train_scene(gears: GearTrain) -> Scene:
    """A train without a cam: its parts in mesh, turned by the angle of the output.

    Args:
        gears: plan of the train.
    """
    train, none = turning_train(gears.layout, 0.0, 0.0), np.empty((0, 2))
    output, turning = train.parts[-1], (*reversed(train.parts), *train.beside)
    shafts = [replace(_shaft(output, None, drawn=True), label=Message("output"), angle=0.0, rate=-1.0, lead=0.0)]
    shafts += [_shaft(part, None, drawn=number > 0) for number, part in enumerate(reversed(train.parts))]
    parts = _parts(None, train, [])
    # What stands nearer to the reader is drawn later.
    order = sorted(range(len(turning)), key=lambda number: turning[number].range[1])
    return Scene(
        outline=none,
        openings=(),
        follower=None,
        noun="",
        unit=MM.symbol,
        section=none,
        travel=None,
        guide=None,
        hint=Message("seen along the shafts; the slider turns the output"),
        clearance=0.0,
        base=0.0,
        lift=SceneLift(lift=np.empty(0), q=np.empty(0)),
        stop=TURN,
        goings=(),
        floor=(),
        car=None,
        shafts=(*shafts, *_planets(train)),
        parts=tuple(parts),
        wheels=tuple(
            WheelShape(number + 1, *_rings(turning[number].part), _label(turning[number].part)) for number in order
        ),
        drive=len(train.parts),
    )


def _rings(part: TrainPart) -> tuple[tuple[Array, ...], tuple[Array, ...]]:
    """Outlines of a part of a train along its axis, mm: the outermost with what is open throughout, and the others."""
    slabs = part.body.slabs
    every = list(dict.fromkeys(loop for slab in slabs for loop in (*slab.rings, *slab.holes)))
    outermost = max(every, key=lambda loop: loop.radii[1])
    filled = [outermost, *(loop for loop in every if all(loop in (*slab.rings[1::2], *slab.holes) for slab in slabs))]

    def seen(loops: Iterable[Loop]) -> tuple[Array, ...]:
        corners = (loop.polygon(_COARSE / 4) for loop in loops)
        return tuple(np.stack([each.real, (-1 if part.flipped else 1) * each.imag], axis=1) for each in corners)

    return seen(filled), seen(loop for loop in every if loop not in filled)


def _companion(plan: CamPlan, q: Array) -> CompanionDisc:
    """Second disc of a conjugate pair with its follower.

    Args:
        plan: plan of the second disc.
        q: motions of its follower, shape (n,).
    """
    travel = travel_of(plan, q)
    return CompanionDisc(
        outline=plan.curve.outline(_OUTLINE).points,
        section=section_of(plan, float(q[0])),
        travel=travel,
        arm=None if plan.motion.unit == MM else arm_of(plan, travel, float(q[0])),
        height=_height(plan),
    )


def _height(plan: CamPlan) -> float:
    """Height of the second disc of a pair above the first, beyond the hub of either, mm."""
    hub = plan.made_blank.hub
    return plan.thickness + GAP + (hub.length if hub else 0.0)


def travel_of(plan: CamPlan, q: Array) -> Travel:
    """Way of the follower's section: that of its middle, and the turn that fits it best about that.

    Args:
        plan: cam.
        q: motions of the follower, in its unit (mm or rad), shape (n,).
    """
    rolling, plane = plan.follower, plan.follower.planes[0]
    line = np.exp(1j * rolling.azimuth)
    sections = np.array([rolling.outline(float(one), plane) @ [1, 1j] for one in q]) * line
    if abs(sections[0, 0] - sections[0, -1]) < _SEEN:
        sections = sections[:, :-1]  # of a closed one, which ends where it begins
    middles = sections.mean(axis=1)
    about = sections - middles[:, None]
    turned = np.angle((about * about[0].conj()).sum(axis=1))
    way = middles - middles[0]
    return Travel((float(middles[0].real), float(middles[0].imag)), way.real, way.imag, turned)


def _slide(plan: CamPlan, section: Array, travel: Travel) -> Slide:
    """Guide of a slide, as far beyond the follower as it moves."""
    across, high = travel.centre[1], float(np.ptp(section[:, 1])) / 2
    half_width = min(max(_STEM_SHARE * high, _STEM_LEAST), _STEM_MOST)
    begin = float(section[:, 0].max() + travel.ahead.max()) + half_width
    end = begin + _RAILS * half_width
    return Slide(across, half_width, (begin, end), end + half_width - float(travel.ahead.min()))


def arm_of(plan: CamPlan, travel: Travel, q: float) -> Arm | None:
    """Arm of a follower whose section moves on a circle; of a face an arm behind it, which keeps clear of the disc.

    Args:
        plan: cam.
        travel: way of the section.
        q: motion at cam angle 0, in its unit.
    """
    pivot = pivot_of(travel)
    if pivot is None:
        return None
    rolling = plan.follower
    x, y = rolling.outline(q, rolling.planes[0]).T
    side = (x + 1j * y) * np.exp(1j * rolling.azimuth)
    middle = complex(*travel.centre)
    if abs(side[0] - side[-1]) <= _SEEN:  # closed: a roller
        return Arm((pivot.real, pivot.imag), ((middle.real, middle.imag),))
    along, behind = _face(side)
    foot = side[0] + along * ((pivot - side[0]) * along.conjugate()).real
    bends = (foot + _PLATE * behind, middle + _PLATE * behind)
    return Arm((pivot.real, pivot.imag), tuple((float(place.real), float(place.imag)) for place in bends))


def _face(side: NDArray[np.complex128]) -> tuple[complex, complex]:
    """Directions along a straight face, and away from the camshaft at right angles to it.

    Args:
        side: points of the face, mm.
    """
    along = complex(side[-1] - side[0])
    along /= abs(along)
    behind = 1j * along
    return along, behind if (side.mean() * behind.conjugate()).real > 0 else -behind


def pivot_of(travel: Travel) -> complex | None:
    """Pivot of a section whose middle moves on a circle, mm; None where it does not move, or not so."""
    middle = complex(*travel.centre) + travel.ahead + 1j * travel.across
    far = int(np.argmax(np.abs(middle - middle[0])))
    between = int(np.argmin(np.abs(np.abs(middle - middle[0]) - np.abs(middle[far] - middle[0]) / 2)))
    a, b = middle[between] - middle[0], middle[far] - middle[0]
    twice = 2 * (a.conjugate() * b).imag
    if abs(twice) < _STRAIGHT:
        return None
    pivot = middle[0] + (abs(a) ** 2 * b - abs(b) ** 2 * a) / (1j * twice)
    radius = np.abs(middle - pivot)
    return None if np.ptp(radius) > _STRAIGHT * radius.max() else complex(pivot)


def section_of(plan: CamPlan, q: float) -> Array:
    """Section of the follower that rolls on the cam, in its first plane, mm; of a point a small circle, to be seen.

    Args:
        plan: cam.
        q: motion of the follower, in its unit (mm or rad).
    """
    rolling = plan.follower
    section = rolling.outline(q, rolling.planes[0])
    if np.hypot(*(section[0] - section[-1])) > _SEEN:  # a side alone: drawn as a plate
        _, behind = _face(section[:, 0] + 1j * section[:, 1])
        back = _PLATE * np.array([behind.real, behind.imag])
        section = np.concatenate([section, section[::-1] + back, section[:1]])
    seen = np.ptp(section, axis=0).max() > _SEEN
    angle = np.linspace(0.0, TURN, 25)
    if not seen:
        section = section[:1] + _SEEN * np.column_stack([np.cos(angle), np.sin(angle)])
    if not rolling.azimuth:
        return section
    on_ray = section @ [1, 1j] * np.exp(1j * rolling.azimuth)
    return np.column_stack([on_ray.real, on_ray.imag])


def _clearance(plan: CamPlan) -> float:
    rod = plan.follower_as_built
    return float(np.hypot(*rod.outline(0.0, rod.planes[0]).T).min())


def _rod(plan: CamPlan, bodies: Bodies) -> RodShape | None:
    rod, (inner, outer) = plan.follower_as_built, plan.faces
    if not isinstance(rod, EdgeFollower):
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
    use = CarUse.of(plan)
    lift, comparison = use.rolled(plan), use.comparison
    if comparison is None:
        yield _going(use, "free", Message("this cam, without play"), follow(lift, 0.0), 0.0)
        return
    chosen, before, task = comparison.chosen, comparison.before, comparison.task
    yield _going(use, "planned", Message("planned"), task.following(task.lift, 0.0), 0.0)
    yield _going(use, "free", Message("this cam, without play"), comparison.following(chosen, 0.0), 0.0)
    yield _going(use, "played", Message("this cam, with play"), comparison.following(chosen, chosen.play), chosen.play)
    if chosen is not before:
        yield _going(use, "before", name_before(before), comparison.following(before, chosen.play), chosen.play)


def _going(use: CarUse, code: str, label: str, following: Following, play: float) -> Going:
    """A run at even motor positions, and to either side of each place where the cam jumps, stops or goes on."""
    stop = use.steering.blend_start if use.drive_wheel.known else TURN
    run = drive(
        following.lift,
        use.car,
        use.travel,
        start=start_pose(use.track),
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


def _car(use: CarUse) -> CarShape:
    car, body = use.car, use.body
    drive_wheel = place_of(CarPoint.DRIVE_WHEEL, car)

    def seen(point: tuple[float, float]) -> tuple[float, float]:
        return point[0] - drive_wheel[0], point[1] - drive_wheel[1]

    return CarShape(
        fork=seen(place_of(CarPoint.FORK, car)),
        idle=seen(place_of(CarPoint.IDLE_WHEEL, car)),
        middle=seen(place_of(CarPoint.MIDDLE, car)),
        corners=tuple(seen(corner) for corner in body.corners),
        wheel=use.drive_wheel.radius,
        steering=1 if car.steering_gain > 0 else -1,
    )


def floor_of(design: Design) -> tuple[FloorShape, ...]:
    """Everything on the floor of a design that need not be a car."""
    return figures_of(layout_of(design.course))


def figures_of(course: Course | None) -> tuple[FloorShape, ...]:
    """Everything on a course; nothing without one."""
    return () if course is None else tuple(_figures(course))


def _figures(course: Course) -> Iterator[FloorShape]:
    if course.edge is not None:
        yield _figure(FloorKind.EDGE, course.edge)
    for obstacle in course.obstacles:
        yield _figure(FloorKind(obstacle.kind), obstacle.shape)
    stands: tuple[tuple[FloorKind, Gate | None], ...] = (
        (FloorKind.START, course.start),
        (FloorKind.FINISH, course.finish),
    )
    for gate in course.gates:
        yield _figure(FloorKind.GATE, gate.place)
    for kind, stand in stands:
        if stand is not None:
            yield _figure(kind, stand.place)


def _figure(kind: FloorKind, shape: Shape) -> FloorShape:
    return FloorShape(kind, shape.points, shape.filled, shape.reach)


def bodies_of(plan: CamPlan, gears: GearTrain | None, cam_radius: float) -> Bodies:
    """Parts, shafts and remarks.

    Args:
        plan: plan of the cam.
        gears: plan of the train; None without one.
        cam_radius: greatest radius of the disc, mm.
    """
    (inner, outer), use = plan.faces, CarUse.of(plan)
    side = -1 if use.side == Side.RIGHT else 1
    fork = -inner if side > 0 else outer
    train = None if gears is None else _train(plan, gears, side, _behind(plan))
    notes: list[str] = []
    parts = _parts(plan, train, notes)
    shafts, wheel = [_camshaft(plan, train)], None
    laid_out = gears is not None and gears.car is not None and gears.car.directions is not None
    if train is not None and gears is not None and laid_out:
        shafts += [_shaft(turning, None, drawn=False) for turning in reversed(train.parts)]
        shafts += _planets(train)
        shafts[0] = replace(shafts[0], diameter=0.0)
        return Bodies(tuple(shafts), tuple(car_bodies(put_together(plan, gears), parts, shafts)), None, fork, side, ())
    if train is not None:
        reach = fork + use.car.drive_wheel_offset
        for number, turning in enumerate(reversed(train.parts)):
            # The drive's shaft goes on to its wheel.
            last = turning is train.parts[0]
            shafts.append(_shaft(turning, reach if last and use.drive_wheel.radius else None, drawn=number > 0))
        shafts += _planets(train)
        if use.drive_wheel.radius:
            wheel = (len(train.parts), reach, use.drive_wheel.radius)
        if gears is not None and (gears.car is None or gears.car.directions is None):
            notes += _notes(plan, train, cam_radius)
    return Bodies(tuple(shafts), tuple(parts), wheel, fork, side, tuple(notes))


_PAINTS = {"shaft": Colour.SHAFT, "key": Colour.SHAFT, "rod": Colour.ROD, "wheel": Colour.WHEEL, "fork": Colour.PINION}
# Chords of parts other than disc and gears, fine and coarse, mm.
_PLAIN_CHORDS = (0.02, 0.12)
# Parts of the fork are drawn apart upwards by this multiple of their distance from the middle of the car, all others
# along the shafts by so many mm from one to the next; a key comes out of its seat by so many mm more.
_APART, _NEXT, _KEY_OUT = 1.4, 14.0, 18.0


def car_bodies(assembly: CarAssembly, drawn: Sequence[ScenePart], shafts: Sequence[SceneShaft]) -> Iterator[ScenePart]:
    """All parts of a car: those of disc and train that are drawn already, and the others, each with its neighbours.

    Args:
        assembly: car put together.
        drawn: disc and gears.
        shafts: shafts of the page, the first that of the disc, then those of the train from the camshaft on.
    """
    gaps, titles = part_gaps(assembly), {part.code: part.title for part in assembly.parts}
    known = {part.code.replace("_", "-"): part for part in drawn}
    last = len(assembly.train.layout.on_shafts)
    whole = [
        (part, place, place @ np.array([*part.content.centre, 1.0])) for part in assembly.parts for place in part.places
    ]
    middle = float(np.mean([at[1] for *_, at in whole]))
    heights = sorted({round(float(at[2]), 3) for *_, at in whole})
    for part, place, at in whole:
        index, branch = STILL, Message("frame")
        if part.group.kind == GroupKind.FORK:
            index, branch = FORK, Message("fork")
        elif part.group.kind != GroupKind.FRAME:
            index, branch = (last + 1 - part.group.number, Message("shaft {shaft}", shaft=part.group.number))
            if part.group.number == last and not part.code.startswith("gear"):
                index = 0
        apart = (_APART * (float(at[1]) - middle), 0.0)
        if index != FORK:
            steps = heights.index(round(float(at[2]), 3)) - (len(heights) - 1) / 2
            apart = (0.0, _NEXT * steps + _KEY_OUT * part.code.startswith("key"))
        near = joined(
            [
                Message("{gap:.4g} mm to {part}", gap=each.size, part=titles.get(each.other, each.other))
                for each in gaps.get(part.code, ())
            ],
            "; ",
        )
        code = "cam" if part.code == "cam-disc" else part.code.removeprefix("gear-")
        if code in known:
            yield replace(known[code], label=part.title, branch=branch, apart=apart, near=near)
        elif part.shape is not None:
            fine, coarse = (_placed(part.shape, place, index, part.group, shafts, chord) for chord in _PLAIN_CHORDS)
            paint = next((paint for word, paint in _PAINTS.items() if word in part.code), Colour.FRAME)
            yield ScenePart(part.code, part.title, fine, coarse, index, paint, branch, apart, near)


def _placed(
    shape: BodyShape | DiscShape | Block | Joined,
    place: Array,
    index: int,
    group: MovingGroup,
    shafts: Sequence[SceneShaft],
    chord: float,
) -> Mesh:
    """Mesh of a part in the frame that it moves with: of its shaft, or about the axis of the fork."""
    mesh = shape_mesh(shape, chord)
    vertices = mesh.vertices @ place[:, :3].T + place[:, 3]
    if index == FORK:
        vertices = vertices - [group.axis.real, 0.0, group.axis.imag]
    elif index != STILL:
        vertices = vertices - [*shafts[index].axis, 0.0]
        c, s = np.cos(shafts[index].angle), np.sin(shafts[index].angle)
        vertices = vertices @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return Mesh(vertices, mesh.triangles)


def _train(plan: CamPlan, gears: GearTrain, side: int, behind: float) -> TurningTrain:
    """The train as it is laid out in the car, else below the disc (side 1) or above it with its drive behind."""
    if gears.car is not None and gears.car.arrangement is not None and gears.car.directions is not None:
        return turning_train(gears.layout, 0.0, gears.car.arrangement.place.raised, 1 if gears.car.turned_over else -1)
    (inner, outer), hub = plan.faces, plan.made_blank.hub
    towards = hub is not None and (hub.side == Face.INNER) == (side > 0)
    stands = hub.length if hub is not None and towards else 0.0
    plane = -GAP - stands if side > 0 else outer - inner + GAP + stands
    layout = gears.layout
    return turning_train(layout, turned_to_axle(layout, behind), height_beside(layout, plane, side))


def _behind(plan: CamPlan) -> float:
    """Distance of the rear axle behind the camshaft, mm."""
    return max(CarUse.of(plan).car.wheelbase - plan.follower_as_built.base_radius, 0.0)


def _parts(plan: CamPlan | None, train: TurningTrain | None, notes: list[str]) -> list[ScenePart]:
    """Meshes of all parts, by the finest chord with which they are few enough triangles, and by a coarse one."""
    turning = () if train is None else (*reversed(train.parts), *train.beside)
    meshes: list[Mesh | None] = []
    for chord in _CHORDS:
        disc = None if plan is None else _disc(plan, chord, notes)
        meshes = [disc, *(stood(piece.stand, chord) for part in turning for piece in part.pieces)]
        if sum(len(mesh.triangles) for mesh in meshes if mesh is not None) <= MOST_TRIANGLES:
            break
    coarse = None if plan is None else _disc(plan, _COARSE, notes)
    parts = [] if disc is None or coarse is None else [ScenePart("cam", Message("cam"), disc, coarse, 0, Colour.CAM)]
    if plan is not None and plan.second is not None:
        up = np.array([0.0, 0.0, _height(plan.second)])
        made = [_disc(plan.second, finest, notes) for finest in (chord, _COARSE)]
        raised = [Mesh(mesh.vertices + up, mesh.triangles) for mesh in made if mesh is not None]
        if len(raised) == len(made):
            parts.append(ScenePart("second-cam", Message("second cam"), raised[0], raised[1], 0, Colour.PINION))
    for number, piece in ((number, piece) for number, part in enumerate(turning, 1) for piece in part.pieces):
        parts.append(_gear(piece.part.name, _label(piece.part), number, piece.stand, chord))
    return parts


def _label(part: TrainPart) -> Message:
    """Name of a part of a train for people: its shaft with its teeth, or its stage."""
    if part.beside:
        return Message("stage {number}: {name}", number=part.stages[0], name=part.name.partition("_")[2])
    teeth = " + ".join(str(wheel.teeth) for wheel in part.gears if hasattr(wheel, "teeth"))
    if teeth:
        return Message("shaft {number} ({teeth})", number=part.shaft, teeth=teeth)
    return Message("shaft {number}", number=part.shaft)


@lru_cache(maxsize=64)  # the gears of a design whose path is edited stay as they are, normals and edges included
def _gear(code: str, label: str, shaft: int, stand: Stand, chord: float) -> ScenePart:
    return ScenePart(code, label, stood(stand, chord), stood(stand, _COARSE), shaft, Colour.GEAR)


def _disc(plan: CamPlan, chord: float, notes: list[str]) -> Mesh | None:
    """Mesh of the disc; None, and the reason in the remarks, if its features cut into each other."""
    inner, outer = plan.faces
    try:
        if plan.groove is None:
            mesh = cam_mesh(plan.curve, plan.made_blank, outer - inner, chord)
            if _turned_over(plan):  # about x, between the same planes
                mesh = Mesh(mesh.vertices * [1.0, -1.0, -1.0] + [0.0, 0.0, outer - inner], mesh.triangles)
            return mesh
        flanks, groove = (plan.curve, plan.groove.outer.curve), plan.groove
        return grooved_mesh(flanks, plan.made_blank, outer - inner, groove.depth, groove.outside_radius, chord)
    except CadgenError as error:
        notes[:] = [Message("The cam has no solid: {error}.", error=error.message)]
        return None


def _planets(train: TurningTrain) -> list[SceneShaft]:
    """Axes of the parts beside the shafts, after those of the camshaft and of the train from the output on."""
    last = len(train.parts)
    return [
        replace(_shaft(each, None, drawn=False), round=None if each.carrier is None else last - each.carrier)
        for each in train.beside
    ]


def _turned_over(plan: CamPlan) -> bool:
    """Whether the disc sits turned over on its shaft."""
    use = plan.application
    return isinstance(use, CarUse) and use.in_car is not None and use.in_car.turned_over


def _camshaft(plan: CamPlan, train: TurningTrain | None) -> SceneShaft:
    inner, outer = plan.faces
    low, high = -_BEYOND, outer - inner + _BEYOND + (0.0 if plan.second is None else _height(plan.second))
    if train is not None:
        ends = train.parts[-1].range
        low, high = min(low, ends[0] - _BEYOND), max(high, ends[1] + _BEYOND)
    rate = 1.0 if _turned_over(plan) else -1.0
    return SceneShaft(Message("camshaft"), (0.0, 0.0), plan.blank.bore_diameter, low, high, 0.0, rate, 0.0)


def _shaft(turning: TurningPart, reach: float | None, *, drawn: bool) -> SceneShaft:
    low, high = turning.range
    ends = (low, high) if reach is None else (min(low, reach), max(high, reach))
    return SceneShaft(
        Message("shaft {number}", number=turning.part.shaft),
        (turning.axis.real, turning.axis.imag),
        turning.part.blank.bore_diameter if drawn else 0.0,
        ends[0] - _BEYOND,
        ends[1] + _BEYOND,
        turning.angle,
        turning.rate,
        turning.lead,
    )


def _notes(plan: CamPlan, train: TurningTrain, cam_radius: float) -> list[str]:
    """Remarks on the place of the train in the car."""
    notes: list[str] = []
    use = CarUse.of(plan)
    behind, drive = _behind(plan), train.parts[0]
    if train.reach < behind:
        notes.append(
            Message(
                "The train as laid out reaches {reach:.1f} mm from the camshaft; the rear axle lies {behind:.1f} mm "
                "behind it. Give the stages' directions to bring the drive onto the axle.",
                reach=train.reach,
                behind=behind,
            )
        )
    room = hypot(drive.axis.real, drive.axis.imag) - drive.part.blank.bore_diameter / 2 - cam_radius
    if room < 0 and use.drive_wheel.radius:
        notes.append(
            Message(
                "As laid out, the shaft of the drive wheel runs through the circle that the cam sweeps, {depth:.1f} mm "
                "deep: lay the stages out further apart, or lead the shaft past the cam.",
                depth=-room,
            )
        )
    if drive.rate < 0:
        notes.append(
            Message(
                "With this number of stages the camshaft turns in the same sense as the drive wheel; the cam turns "
                "against it in a car that drives forwards. Put the disc on its shaft turned over, a hub with it, or "
                "add a stage."
            )
        )
    return notes
