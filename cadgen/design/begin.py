"""A design to begin with: name, points of a path and changes of keys -> a commented design file.

The text has a word on every key that a team sets first, in the language that is chosen.
"""

from collections.abc import Callable, Sequence
from os import PathLike
from os.path import relpath
from pathlib import Path
from typing import NamedTuple

import tomlkit

from cadgen.design.course import MOST_OF_A_KIND
from cadgen.design.file_names import name_fault
from cadgen.design.load import complete_of, design_of
from cadgen.design.override import override
from cadgen.errors import DesignError, FileError, brief
from cadgen.inference.records.points import Points, read_points
from cadgen.messages import Message, shown
from cadgen.writing import write_whole

# Where the example's path goes, mm.
EXAMPLE = ((500.0, 700.0), (2000.0, 900.0), (3100.0, 1900.0), (4500.0, 2200.0), (6000.0, 1700.0))
# A figure 8 that is driven again and again, mm.
LAP = (
    *((3500.0, 1500.0), (4700.0, 2300.0), (5800.0, 1500.0), (4700.0, 700.0)),
    *((3500.0, 1500.0), (2300.0, 2300.0), (1200.0, 1500.0), (2300.0, 700.0)),
)
GATE_RADIUS = 50.0
BASE_RADIUS = 70.0  # mm, of the text below

_TEXT = Message("""\
# {name}: a car steered by a cam. Lengths in mm, angles in degrees; docs/design-file.md has every key.
#   cadgen check {name}.toml       whether you may cut it, and for which drive wheel; --all shows every check
#   cadgen plan {name}.toml        the path on which most cars keep the course
#   cadgen cam {name}.toml         the files
name = "{name}"

[path]
spline = "quintic"                 # a smooth curve through all waypoints
{closed}# How far it runs to the right of the drive wheel; by this the middle of the car drives it.
offset_mm = {offset}
waypoints_mm = [
{waypoints}
]

[course]                           # what every run is checked against; remove what the rules do not ask for
margin_mm = 20.0                   # that the car keeps from posts, walls, zones and the edge
gates = [                          # the middle of the car passes within radius_mm, in this order
{gates}
]
# posts = [{{ at_mm = [2500.0, 2000.0], radius_mm = 10.0 }}]
# walls = [{{ line_mm = [[0.0, 3000.0], [2000.0, 3000.0]] }}]

{field}
[car]
wheelbase_mm = 167.0               # L, fork axis to rear axle
drive_wheel_offset_mm = 37.0       # A1, fork axis to the driven wheel; positive to the left
idle_wheel_offset_mm = 201.0       # A2, fork axis to the other wheel; positive to the right
max_steering_angle_deg = 35.0      # stop of the fork
{wheel}
[car.outline]                      # from above; posts, walls, zones and the edge keep clear of it
length_mm = 290.0
width_mm = 260.0
front_overhang_mm = 60.0           # fork axis to the front
wheel_diameter_mm = 128.0
wheel_width_mm = 4.0
# ground_clearance_mm = 20.0       # lower posts pass under the body

[cam]
base_radius_mm = 70.0              # a, camshaft to fork axis
mid_plane_mm = 25.0                # e, fork axis to the disc's middle
thickness_mm = 3.0                 # C
# side = "right"                   # of the fork axis on which the disc is; left out, left
{blend}
[follower]
radius_mm = 2.5                    # r_t, of the rod
length_mm = 40.0                   # fork axis to the rod's end

[blank]
bore_diameter_mm = 8.0
# material = "aluminium"           # on the drawings, and for the feeds of the mill
# bore_fit = "H7/g6"               # of bore and shaft: what they may be apart is reckoned with

[blank.mark]                       # a hole on one side: a disc that is turned over shows it on the other
diameter_mm = 3.0
radius_mm = 12.0
angle_deg = 45.0

[tolerances]                       # half widths that the workshop holds: cadgen tolerance and cadgen plan run such cars
base_radius_mm = 0.005             # half a division of a micrometer head
inner_face_mm = 0.05
outer_face_mm = 0.05
rod_radius_mm = 0.005
profile_offset_mm = 0.01           # the disc cut too large all round
steering_zero_deg = 0.02           # front wheel, set on a trial run
steering_lost_motion_deg = 0.005   # half of the play between rod and front wheel
wheelbase_mm = 0.1
drive_wheel_offset_mm = 0.1
# wheel_radius_mm = 0.02           # with [train]
cam_phase_deg = 0.2
start_x_mm = 2.0
start_y_mm = 2.0
start_heading_deg = 0.2

[mechanics]
friction_least = 0.05              # steel on greased aluminium
friction_greatest = 0.20
{brake}
# [drawing]                        # what cadgen draw writes into the title blocks
# finish = "Ra 1.6"
# quantity = 1

{train}""")

_NO_TRAIN = Message("""\
# The gears between drive wheel and cam: with them play is reckoned with, and the wheel's radius is known.
# [train]
# module_mm = 0.5
# width_mm = 5.0
# bearing_span_mm = 80.0
#
# [[train.stages]]
# centre_distance_mm = 45.0
# driver = { teeth = 30 }
# driven = { teeth = 150 }
#
# [[train.stages]]
# centre_distance_mm = 40.0
# driver = { teeth = 40 }
# driven = { teeth = 120 }
""")

_MOTION = Message("""\
# {name}: a cam by its motion. Lengths in mm, angles in degrees; docs/design-file.md has every key.
#   cadgen check {name}.toml       whether you may cut it; --all shows every check
#   cadgen cam {name}.toml         the files
#   cadgen report {name}.toml      a page on which it turns
name = "{name}"

[motion]
turns = "counterclockwise"         # of the disc, seen on its outer face; or "clockwise"
speed_rpm = 120.0                  # for velocity and acceleration in units of time, and for forces
{source}
[follower]
kind = "roller"                    # or knife, flat, swinging_roller, swinging_flat, rod
radius_mm = 8.0
offset_mm = 0.0                    # of its line beside the camshaft; positive lessens the pressure angle of the rise
# closure = "groove"               # the roller runs in a groove, and needs no spring

[cam]
base_circle_radius_mm = 40.0       # at lift 0; or pressure_angle_deg = 28.0, for the least radius that keeps it
thickness_mm = 8.0

[blank]
bore_diameter_mm = 10.0
# material = "steel"               # on the drawings, and for the feeds of the mill
# bore_fit = "H7/g6"               # of bore and shaft

# [dynamics]                       # forces, torque, and the speed at which the follower leaves
# mass_kg = 0.5
# spring_rate_N_per_mm = 5.0
# preload_N = 40.0
""")
_SEGMENTS = Message("""\
segments = [                       # rises, returns and dwells of a turn: 360 degrees in all
    {{ to_mm = 10.0, in_deg = 90.0, law = "modified_sine" }},
    {{ dwell_deg = 60.0 }},
    {{ to_mm = 0.0, in_deg = 120.0, law = "polynomial_3_4_5" }},
    {{ dwell_deg = 90.0 }},
]
""")
_TABLE = Message("""\
table = {table}
# table_unit = "inch"              # mm if left out; smooth = true takes the noise out
""")

_TRAIN = Message("""\
# The gears between drive wheel and cam, from the wheel on: cadgen gears {name}.toml makes them.
[train]
module_mm = 0.5
width_mm = 5.0
bearing_span_mm = 80.0
grade = 7
# material = "brass"

{stages}
[train.drive]                      # the pinion on the axle of the drive wheel
bore_diameter_mm = 5.0
hub = {{ diameter_mm = 10.0, length_mm = 6.0, set_screw_mm = 2.5 }}

[train.intermediate]               # wheel and pinion, cut apart, which any tool can do, and glued
bore_diameter_mm = 3.0
joint = "glued"
cut_apart = true

[train.output]                     # the wheel on the camshaft
bore_diameter_mm = 8.0
keyway = {{ width_mm = 3.0, depth_mm = 1.4 }}

[layout]                           # parts are set against each other; directions of the stages are found
turned_over = {turned}                # whether the disc sits turned over on its shaft
""")
_FRAME = Message("""\

[frame]                            # plates, base and fork that hold the parts: cadgen frame {name}.toml makes them
{keys}# [drive]                          # what stands on the base
# kind = "weight"                  # or "motor"
# mass_kg = 1.0
# size_mm = [50.0, 50.0, 65.0]
# fall_mm = 400.0
""")
_BRAKE = Message("""\
drag_least_Nmm = {least:.0f}             # a felt brake on the disc: the cam stays on its gears, play does nothing
drag_greatest_Nmm = {greatest:.0f}

[optimize]
hardware = ["trim"]                # after a trial run the micrometer of the base radius is set: cadgen adjust
""")
_STAGE = """\
[[train.stages]]
driver = {{ teeth = {driver} }}
driven = {{ teeth = {driven} }}
"""
_WHEEL = Message("""\
drive_wheel_radius_mm = {radius}       # R_h; the whole path is driven before the closing blend
""")

_OPEN = {
    "closed": "",
    "wheel": Message(
        "# drive_wheel_radius_mm = 64.0     # R_h; with it (and [train]) the whole path is driven before the "
        "closing blend\n"
    ),
    "blend": Message("blend_deg = 12.0                   # the last part of the turn leads back to the start\n"),
}
_CLOSED = {
    "closed": Message("""\
closed = true                      # a lap: from the last waypoint the path goes on to the first
# laps_per_turn = 1                # laps in a turn of the cam; the drive wheel's radius follows from it
# laps = 10                        # of a run, which the course is asked of
"""),
    "wheel": "",
    "blend": "",
}
_FIELD = Message("""\
[course.field]
size_mm = [{width}, {height}]        # corner_mm is [0, 0] unless it is given
""")
_NO_FIELD = Message("""\
# [course.field]
# size_mm = [8000.0, 8000.0]       # corner_mm is [0, 0] unless it is given
""")


class ProposedTrain(NamedTuple):
    """Train for a new design.

    Attributes:
        teeth: teeth of driver and driven gear of every stage, from the drive on.
        wheel_radius: radius of the drive wheel, mm; None where it follows from the ratio.
        drag: torque of a brake on the disc that keeps the cam on its gears, N mm; 0 for none.
        base_radius: distance from the camshaft to the fork axis, mm; None for that of the design.
        frame: keys of its frame, a line each; None for no frame.
    """

    teeth: tuple[tuple[int, int], ...]
    wheel_radius: float | None
    drag: float = 0.0
    base_radius: float | None = None
    frame: str | None = None


WithTrain = Callable[[ProposedTrain | None], str]


def text_of(
    name: str,
    places: Sequence[tuple[float, float]],
    weights: Sequence[float],
    offset: float,
    gate_radius: float,
    field: tuple[float, float] | None,
    *,
    closed: bool,
    train: ProposedTrain | None = None,
) -> str:
    """Text of a design file, with comments in the chosen language.

    Args:
        name: name of the design.
        places: waypoints, mm.
        weights: weight of each: its gate is that much narrower, and of weight 0 there is none.
        offset: how far the path runs to the right of the drive wheel, mm.
        gate_radius: radius of a gate of weight 1, mm.
        field: width and height of the field, mm; None if it is not known.
        closed: whether the path is a lap.
        train: train that it has; None for one that is commented out.
    """
    gates = [
        f"    {{ at_mm = [{_number(x)}, {_number(y)}], radius_mm = {_number(gate_radius / weight)} }},"
        for (x, y), weight in zip(places, weights, strict=True)
        if weight > 0
    ]
    parts = {key: shown(text) for key, text in (_CLOSED if closed else _OPEN).items()}
    if train is not None and train.wheel_radius is not None:
        parts["wheel"] = shown(_WHEEL).format(radius=_number(train.wheel_radius))
    return shown(_TEXT).format(
        **parts,
        brake=""
        if train is None or not train.drag
        else shown(_BRAKE).format(least=train.drag, greatest=_MOST_DRAG * train.drag),
        train=shown(_NO_TRAIN)
        if train is None
        else shown(_TRAIN).format(
            name=name,
            stages="\n".join(_STAGE.format(driver=driver, driven=driven) for driver, driven in train.teeth),
            turned="true " if len(train.teeth) % 2 == 0 else "false",
        )
        + ("" if train.frame is None else shown(_FRAME).format(name=name, keys=train.frame)),
        name=name,
        offset=_number(offset),
        waypoints="\n".join(f"    [{_number(x)}, {_number(y)}]," for x, y in places),
        gates="\n".join(gates),
        field=shown(_NO_FIELD)
        if field is None
        else shown(_FIELD).format(width=_number(field[0]), height=_number(field[1])),
    )


def _number(value: float) -> str:
    """A number as TOML has it, to a ten-thousandth of a millimetre."""
    return repr(round(float(value), 4) + 0.0)


_CAR = ("car.drive_wheel_offset_mm=", "car.idle_wheel_offset_mm=")
_MOST_DRAG = 1.4  # a felt brake at its strongest, of what it is at its weakest
_EXAMPLE_FIELD = (7000.0, 3000.0)


def begin(
    name: str,
    points: Points | None = None,
    changes: Sequence[str] = (),
    gate_radius: float = GATE_RADIUS,
    field: tuple[float, float] | None = None,
    closed: bool = False,
    train: ProposedTrain | None = None,
) -> str:
    """Text of a new design, which loads.

    Args:
        name: name of the design and of its file.
        points: points of its path, mm; an example if left out.
        changes: `key=value` each, as with `--set`.
        gate_radius: radius of the gates at the points, mm.
        field: width and height of the field, mm.
        closed: whether the path is a lap that ends as it starts.
        train: train that it has; None for one that is commented out.

    Raises:
        DesignError: a name that files cannot have, or values that cannot be.
    """
    if fault := name_fault(name):
        raise DesignError('the name is "{name}"; it must {fault}', name=brief(name[:80]), fault=fault)
    given = points
    if points is None:
        example: tuple[tuple[float, float], ...] = LAP if closed else EXAMPLE
        field = field or _EXAMPLE_FIELD
        # In the middle of the field, and smaller where the field is smaller than the example's.
        share = min(1.0, *(size / full for size, full in zip(field, _EXAMPLE_FIELD, strict=True)))
        if share < 1:
            corner = [(size - share * full) / 2 for size, full in zip(field, _EXAMPLE_FIELD, strict=True)]
            example = tuple((round(corner[0] + share * x, 1), round(corner[1] + share * y, 1)) for x, y in example)
        points = Points(example, (1.0,) * len(example))
    elif closed and points.places[0] == points.places[-1]:  # once is enough, and one gate
        points = Points(points.places[:-1], points.weights[:-1])
    count = sum(weight > 0 for weight in points.weights)
    if count > MOST_OF_A_KIND:
        raise DesignError(
            "{count} points would each be a gate, and a course has at most {most_of_a_kind}: give fewer "
            "points, or a weight of 0 to those that only lead the path",
            count=count,
            most_of_a_kind=MOST_OF_A_KIND,
        )
    # The middle of the car is to drive the path, unless the changes say where it runs.
    document = tomlkit.parse(
        text_of(name, points.places, points.weights, 0.0, gate_radius, field, closed=closed, train=train)
    )
    for change in changes:
        override(document, change)
    car = document["car"]
    if given is not None:
        _refuse_small(given, car.get("wheelbase_mm"))
    if not any(change.replace(" ", "").startswith("path.offset_mm=") for change in changes):
        offsets = [car.get(key) for key in ("drive_wheel_offset_mm", "idle_wheel_offset_mm")]
        if all(isinstance(offset, int | float) for offset in offsets):
            document["path"]["offset_mm"] = round(sum(map(float, offsets)) / 2, 4)
    if train is not None and train.base_radius is not None:
        document["cam"]["base_radius_mm"] = train.base_radius
    text = tomlkit.dumps(document)
    design_of(text, Path())  # of no file yet, which messages would name
    return text


def _refuse_small(points: Points, wheelbase: object) -> None:
    """Refuse points that lie nearer together than the axles of their car: they are in another unit than mm."""
    sizes = [max(column) - min(column) for column in zip(*points.places, strict=True)]
    if isinstance(wheelbase, int | float) and max(sizes) < wheelbase:
        raise DesignError(
            "the points lie within {size:.3g} mm, and the car has a wheelbase of {wheelbase:g} mm: give them in mm, "
            "which is 1000 times what they are in m",
            size=max(sizes),
            wheelbase=wheelbase,
        )


def begin_motion(name: str, table: Path | None = None, changes: Sequence[str] = (), folder: Path = Path()) -> str:
    """Text of a new design of a cam by its motion, which loads.

    Args:
        name: name of the design and of its file.
        table: file of a lift table; an example of rises and dwells if left out.
        changes: `key=value` each, as with `--set`.
        folder: folder of the design file, from which it names the table.

    Raises:
        DesignError: a name that files cannot have, values that cannot be, or a table that is no motion.
    """
    if fault := name_fault(name):
        raise DesignError('the name is "{name}"; it must {fault}', name=brief(name[:80]), fault=fault)

    def text(path: str) -> str:
        source = shown(_TABLE).format(table=tomlkit.string(path).as_string()) if path else shown(_SEGMENTS).format()
        document = tomlkit.parse(shown(_MOTION).format(name=name, source=source))
        for change in changes:
            override(document, change)
        return tomlkit.dumps(document)

    # The folder may not be there yet, so the table is looked for where it is.
    complete_of(text("" if table is None else str(table)), Path())
    return text("" if table is None else Path(relpath(table, folder)).as_posix())


def points_of(file: str | PathLike[str] | None, layer: str | None, *, closed: bool) -> Points | None:
    """Points of a path from a file; None without one.

    Args:
        file: CSV, TXT or DXF.
        layer: layer of the polyline in a DXF with several.
        closed: whether the path is a lap.

    Raises:
        DesignError: a layer of no file.
        FileError: points that cannot be read.
    """
    if file is not None:
        return read_points(Path(file), layer, closed=closed)
    if layer is not None:
        raise DesignError("a layer is named, but no DXF with points: give the DXF too, or leave the layer out")
    return None


def write_new(text: str, file: Path) -> None:
    """Write a new design's file whole or not at all, and nothing over one that is there.

    Raises:
        FileError: the file is there already, or cannot be written.
    """
    try:
        write_whole(file, text.encode(), new=True)
    except FileExistsError:
        raise FileError("{file} is there already: choose another name, or remove it", file=brief(str(file))) from None
    except OSError as error:
        raise FileError(
            "{file} cannot be written ({strerror}): choose another place",
            file=brief(str(file)),
            strerror=Message(str(error.strerror)),
        ) from None
