"""Content of a report page as frozen values: sections of tables, curves, meshes, motion, course.

What a page shows is decided before it is written; `cadgen.viewer.page.html` and the page's script only lay it out.
Texts are messages or labels, which the page shows in both languages. Lengths are mm and angles rad, but for cells and
curves, which stand in the unit that they name.
"""

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property

from cadgen.arrays import Array
from cadgen.figures import Cell, Sheet
from cadgen.geometry.meshes.mesh import Mesh
from cadgen.verdict import Readiness
from cadgen.viewer.page.mesh_block import Shaded, shaded


class FloorKind(StrEnum):
    """Kind of a thing on the floor."""

    EDGE = "edge"
    POST = "post"
    WALL = "wall"
    ZONE = "zone"
    GATE = "gate"
    START = "start"
    FINISH = "finish"


class MarkKind(StrEnum):
    """Kind of a place on the turn."""

    PEAK = "peak"
    VALLEY = "valley"
    BLEND = "blend"
    JUMP = "jump"
    REVERSE = "reverse"


class Colour(StrEnum):
    """Colour of a part, by what it is."""

    CAM = "cam"
    GEAR = "gear"
    PINION = "pinion"
    FRAME = "frame"
    SHAFT = "shaft"
    ROD = "rod"
    WHEEL = "wheel"


@dataclass(frozen=True)
class ChartBar:
    """A bar with its figure.

    Attributes:
        name: what it stands for.
        value: length of the bar, in the unit of its picture.
        strong: whether it is the one that counts, such as the first.
    """

    name: str
    value: float
    strong: bool = False


@dataclass(frozen=True)
class Bars:
    """Picture of lying bars, from 0 on.

    Attributes:
        code: name of the picture for programs.
        title: title of the picture.
        unit: unit of the values.
        rows: bars from the top.
    """

    code: str
    title: str
    unit: str
    rows: tuple[ChartBar, ...]

    @property
    def most(self) -> float:
        """Greatest value."""
        return max((bar.value for bar in self.rows), default=0.0)


@dataclass(frozen=True)
class Section:
    """A section of the page.

    Attributes:
        code: name of the section for programs, and its anchor.
        title: heading.
        lead: sentences under the heading.
        tables: sheets.
        notes: sentences below the tables.
        bars: pictures above the tables.
        folded: codes of sheets that are closed until they are asked for, since a picture has their point.
    """

    code: str
    title: str
    lead: tuple[str, ...] = ()
    tables: tuple[Sheet, ...] = ()
    notes: tuple[str, ...] = ()
    bars: tuple[Bars, ...] = ()
    folded: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Curve:
    """A curve over the cam angle.

    Attributes:
        label: name of the curve.
        values: values at the angles of the chart, shape (n,); NaN where there is none.
        dashed: whether it is drawn with dashes.
    """

    label: str
    values: Array
    dashed: bool = False


@dataclass(frozen=True)
class Limit:
    """A limit drawn across a chart, in the unit of the chart."""

    label: str
    value: float


@dataclass(frozen=True)
class Chart:
    """Curves of one quantity over the cam angle.

    Attributes:
        code: name of the chart for programs.
        title: name of the quantity.
        unit: unit of its values.
        angle: cam angles, shape (n,), rad.
        curves: curves.
        limits: limits.
    """

    code: str
    title: str
    unit: str
    angle: Array
    curves: tuple[Curve, ...]
    limits: tuple[Limit, ...] = ()


@dataclass(frozen=True)
class LiftMark:
    """A place on the turn that charts and slider mark."""

    kind: MarkKind
    angle: float


FORK, STILL = -1, -2  # in the place of a part's shaft


@dataclass(frozen=True)
class ScenePart:
    """A part in 3D.

    Attributes:
        code: name of the part for programs.
        label: name for people.
        mesh: its mesh in the frame of its shaft, mm; z is the height above the cam's face.
        coarse: the same with few triangles, drawn while it moves on a slow machine.
        shaft: index of the shaft that it turns with; `FORK` for the fork, `STILL` for what stands.
        colour: what it is painted as.
        branch: group of parts in whose branch of the tree it stands; empty for none.
        apart: ways by which it is drawn apart downwards and along the shafts, mm.
        near: what lies nearest to it, in words; empty where nothing is known.
    """

    code: str
    label: str
    mesh: Mesh
    coarse: Mesh
    shaft: int
    colour: Colour = Colour.GEAR
    branch: str = ""
    apart: tuple[float, float] = (0.0, 0.0)
    near: str = ""

    @cached_property
    def shades(self) -> tuple[Shaded, Shaded]:
        """Fine and coarse mesh, each with normals and edges."""
        return shaded(self.mesh), shaded(self.coarse)


@dataclass(frozen=True)
class SceneShaft:
    """A shaft and the law of its turning: angle + rate φ + lead u.

    φ is the motor's position in cam units and u, 0 to 1, the share of the play that the cam has run ahead.

    Attributes:
        label: name.
        axis: place, mm: x ahead of the camshaft, y below it.
        diameter: diameter, mm; 0 for a shaft that is not drawn.
        low: height at which it begins, mm.
        high: height at which it ends, mm.
        angle: angle of its parts at φ = 0 with the driving flanks in contact, rad.
        rate: turns by turn of the cam, with sign.
        lead: angle that it is ahead when the cam has run through the play, rad.
        round: number of the shaft that its axis goes round with, for a planet; None for an axis that stands.
    """

    label: str
    axis: tuple[float, float]
    diameter: float
    low: float
    high: float
    angle: float
    rate: float
    lead: float
    round: int | None = None


@dataclass(frozen=True)
class RodShape:
    """The leaning rod as it is drawn.

    Attributes:
        base: distance of the fork's axis from the camshaft, mm.
        radius: radius of the rod, mm.
        length: length from the fork's axis, mm.
        faces: lateral distances of the disc's faces from the fork's axis, mm.
        height: height of the fork's axis above z = 0, mm.
        side: 1 if the rod points along z, -1 against it.
    """

    base: float
    radius: float
    length: float
    faces: tuple[float, float]
    height: float
    side: int


@dataclass(frozen=True)
class SceneLift:
    """Motion that a cam gives its follower, at even cam angles from 0 to a full turn; all arrays have shape (n,).

    Attributes:
        lift: lift of the follower, mm.
        q: motion, in the follower's unit: on a car the tangent of the steering angle.
    """

    lift: Array
    q: Array


@dataclass(frozen=True)
class Travel:
    """Way of a follower's section from where it stands at cam angle 0, by the cam angles of `Lift`.

    Attributes:
        centre: place of its middle at cam angle 0 in the frame of the ray, mm.
        ahead: way along the ray, shape (n,), mm.
        across: way across it, shape (n,), mm.
        turned: angle by which it is turned about its middle, shape (n,), rad.
    """

    centre: tuple[float, float]
    ahead: Array
    across: Array
    turned: Array


@dataclass(frozen=True)
class Slide:
    """Guide of a follower that moves along the ray, as it is drawn: two rails with the stem between them.

    Attributes:
        across: distance of the stem's middle from the ray, mm.
        half_width: half width of the stem, mm.
        rails: places along the ray where the rails begin and end, mm.
        stem: place where the stem ends at cam angle 0, mm.
    """

    across: float
    half_width: float
    rails: tuple[float, float]
    stem: float


@dataclass(frozen=True)
class Arm:
    """Arm of a swinging follower, as it is drawn at cam angle 0: a bent line, which turns about its pivot.

    Attributes:
        pivot: place of the pivot in the frame of the ray, mm.
        bends: places where the line goes on to from the pivot, the last on the follower, mm.
    """

    pivot: tuple[float, float]
    bends: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class CompanionDisc:
    """Second disc of a conjugate pair with its own follower, in the frame of the first.

    Attributes:
        outline: profile of the disc, shape (n, 2), mm.
        section: section of its follower at cam angle 0, shape (k, 2), mm.
        travel: way of that section.
        arm: arm of that follower; None on a slide.
        height: height of its disc above that of the first in 3D, mm.
    """

    outline: Array
    section: Array
    travel: Travel
    arm: Arm | None
    height: float


@dataclass(frozen=True)
class RimDeviations:
    """Deviations along the rim of the disc.

    Attributes:
        label: what deviates from what.
        unit: unit of the values.
        places: places on the outline, counterclockwise, shape (n, 2), mm.
        values: deviations there, positive outwards, shape (n,).
    """

    label: str
    unit: str
    places: Array
    values: Array


@dataclass(frozen=True)
class Going:
    """A run of the car by motor position; all arrays have shape (n,).

    Attributes:
        code: name for programs.
        label: name for people.
        motor: motor positions in cam units, rad.
        cam_angle: angle of the cam, rad.
        x: place of the drive wheel, mm.
        y: place of the drive wheel, mm.
        heading: direction of travel, rad.
        play: return error of the run, rad.
    """

    code: str
    label: str
    motor: Array
    cam_angle: Array
    x: Array
    y: Array
    heading: Array
    play: float = 0.0


@dataclass(frozen=True)
class FloorShape:
    """Thing on the floor, drawn from above.

    Attributes:
        kind: what it is.
        points: its points, mm.
        filled: whether they are the corners of an area.
        reach: distance from the points that belongs to it, mm.
    """

    kind: FloorKind
    points: tuple[tuple[float, float], ...]
    filled: bool = False
    reach: float = 0.0


@dataclass(frozen=True)
class CarShape:
    """The car from above: x ahead, y to the left, the origin at the drive wheel, mm.

    Attributes:
        fork: place of the fork's axis.
        idle: place of the other rear wheel.
        middle: point of the car that the gates go by, drawn as its track.
        corners: outline of the body; empty if the design has none.
        wheel: radius of the drive wheel; None if it is not known.
        steering: 1 or -1: a positive steering angle turns the front wheel to the right, or to the left.
    """

    fork: tuple[float, float]
    idle: tuple[float, float]
    middle: tuple[float, float]
    corners: tuple[tuple[float, float], ...]
    wheel: float | None
    steering: int = 1


@dataclass(frozen=True)
class WheelShape:
    """Part of a train alone, seen along its axis.

    Attributes:
        shaft: index of the shaft that it turns with.
        outlines: its outermost outline, and what is open through the whole part, shape (n, 2) each, mm.
        edges: further outlines that are seen, likewise.
        label: name.
    """

    shaft: int
    outlines: tuple[Array, ...]
    edges: tuple[Array, ...]
    label: str


@dataclass(frozen=True)
class Scene:
    """Everything that moves with the slider.

    Attributes:
        outline: profile of the disc, shape (n, 2), mm.
        openings: bore and holes of the disc, shape (m, 2) each, mm.
        follower: leaning rod, which leans as it moves; None for another follower, whose section moves as a whole.
        noun: name of the follower.
        unit: unit of its motion: mm, rad or tan.
        section: section of the follower at cam angle 0, by points in the frame of the ray, shape (k, 2), mm.
        travel: way of that section; None of the leaning rod.
        guide: what leads the follower; None of one on a car's fork, or where it is not known.
        hint: sentence on the side from which cam and follower are seen.
        clearance: least distance of the follower from the camshaft where its motion is 0, mm.
        base: base radius of the follower, mm.
        lift: lift by cam angle.
        stop: motor position at which runs are judged, rad.
        goings: runs of the car.
        floor: course on the floor.
        car: the car; None of a cam without one.
        shafts: shafts, the camshaft first.
        parts: parts in 3D.
        wheel: index of the shaft, place along it and radius of the drive wheel, mm; None if it is not known.
        second: second disc of a conjugate pair; None for one disc.
        rim: deviations on the rim; None where there are none.
        wheels: parts of a train without a cam, the last on top; then nothing of a cam is there.
        drive: index of the shaft that drives that train.
    """

    outline: Array
    openings: tuple[Array, ...]
    follower: RodShape | None
    noun: str
    unit: str
    section: Array
    travel: Travel | None
    guide: Slide | Arm | None
    hint: str
    clearance: float
    base: float
    lift: SceneLift
    stop: float
    goings: tuple[Going, ...]
    floor: tuple[FloorShape, ...]
    car: CarShape | None
    shafts: tuple[SceneShaft, ...]
    parts: tuple[ScenePart, ...]
    wheel: tuple[int, float, float] | None = None
    second: CompanionDisc | None = None
    rim: RimDeviations | None = None
    wheels: tuple[WheelShape, ...] = ()
    drive: int = 0


@dataclass(frozen=True)
class Failure:
    """A check that fails, or another reason not to make the part: what, and what to change."""

    what: str
    advice: str = ""


@dataclass(frozen=True)
class Page:
    """A report page.

    Attributes:
        name: name of the design.
        subtitle: kind and profile of the part.
        readiness: verdict on the cam and its gears.
        failures: what fails, the first things on the page.
        reservations: what costs accuracy or cars, or is left open.
        summary: the figures at the top, by name.
        scene: what moves.
        charts: curves over the cam angle.
        marks: marked places on the turn.
        sections: tables.
        notes: sentences about what the page leaves out or assumes.
        origin: version, hash and file of the design, by name.
        files: files of the design in the page's folder, by the names of what they are of.
    """

    name: str
    subtitle: str
    readiness: Readiness
    failures: tuple[Failure, ...]
    reservations: tuple[Failure, ...]
    summary: tuple[tuple[str, Cell], ...]
    scene: Scene
    charts: tuple[Chart, ...]
    marks: tuple[LiftMark, ...]
    sections: tuple[Section, ...]
    notes: tuple[str, ...] = ()
    origin: tuple[tuple[str, str], ...] = field(default=())
    files: tuple[tuple[str, tuple[str, ...]], ...] = field(default=())
