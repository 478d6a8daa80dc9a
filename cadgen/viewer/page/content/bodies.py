"""Parts and shafts in 3D: the cam, the train beside it, the drive wheel's place."""

from dataclasses import dataclass
from functools import lru_cache
from math import hypot

from cadgen.car.course.layout import Side
from cadgen.design import cam_model
from cadgen.errors import CadgenError
from cadgen.geometry.meshes.mesh import Mesh, cam_mesh
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.parts.face import Face
from cadgen.viewer.page.content.train import GAP, Stand, TurningPart, TurningTrain, turning_train
from cadgen.viewer.page.document import Part, Shaft, Text, Words
from cadgen.viewer.page.names import Colour
from cadgen.viewer.page.words import say

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

    shafts: tuple[Shaft, ...]
    parts: tuple[Part, ...]
    wheel: tuple[int, float, float] | None
    fork: float
    side: int
    notes: tuple[Text, ...]


def bodies_of(plan: CamPlan, gears: GearsPlan | None, cam_radius: float) -> Bodies:
    """Parts, shafts and remarks.

    Args:
        plan: plan of the cam.
        gears: plan of the train; None without one.
        cam_radius: greatest radius of the disc, mm.
    """
    (inner, outer), side = plan.design.cam.faces_mm, -1 if plan.design.cam.side == Side.RIGHT else 1
    fork = -inner if side > 0 else outer
    train = None if gears is None else _train(plan, gears, side)
    notes: list[Text] = []
    parts = _parts(plan, train, notes)
    shafts, wheel = [_camshaft(plan, train)], None
    if train is not None:
        reach = fork + cam_model.car(plan.design).drive_wheel_offset
        for number, turning in enumerate(reversed(train.parts)):
            # The drive's shaft goes on to its wheel.
            last = turning is train.parts[0]
            shafts.append(_shaft(turning, reach if last and plan.wheel.radius else None, drawn=number > 0))
        if plan.wheel.radius:
            wheel = (len(train.parts), reach, plan.wheel.radius)
        notes += _notes(plan, train, cam_radius)
    return Bodies(tuple(shafts), tuple(parts), wheel, fork, side, tuple(notes))


def _train(plan: CamPlan, gears: GearsPlan, side: int) -> TurningTrain:
    """The train on the side of the cam that looks to the fork."""
    (inner, outer), hub = plan.design.cam.faces_mm, plan.made_blank.hub
    towards = hub is not None and (hub.side == Face.INNER) == (side > 0)
    stands = hub.length if hub is not None and towards else 0.0
    plane = -GAP - stands if side > 0 else outer - inner + GAP + stands
    return turning_train(gears.layout, _behind(plan), plane, side)


def _behind(plan: CamPlan) -> float:
    """Distance of the rear axle behind the camshaft, mm."""
    return max(cam_model.car(plan.design).wheelbase - plan.rod.base_radius, 0.0)


def _parts(plan: CamPlan, train: TurningTrain | None, notes: list[Text]) -> list[Part]:
    """Meshes of all parts, by the finest chord with which they are few enough triangles, and by a coarse one."""
    turning = () if train is None else tuple(reversed(train.parts))
    meshes: list[Mesh | None] = []
    for chord in _CHORDS:
        meshes = [_disc(plan, chord, notes), *(part.stand.mesh(chord) for part in turning)]
        if sum(len(mesh.triangles) for mesh in meshes if mesh is not None) <= MOST_TRIANGLES:
            break
    disc = meshes[0]
    coarse = _disc(plan, _COARSE, notes)
    parts = [] if disc is None or coarse is None else [Part("cam", say("cam"), disc, coarse, 0, Colour.CAM)]
    for number, part in enumerate(turning, 1):
        parts.append(_gear(part.part.name, _label(part), number, part.stand, chord))
    return parts


@lru_cache(maxsize=64)  # the gears of a design whose path is edited stay as they are, normals and edges included
def _gear(code: str, label: Words, shaft: int, stand: Stand, chord: float) -> Part:
    return Part(code, label, stand.mesh(chord), stand.mesh(_COARSE), shaft, Colour.GEAR)


def _disc(plan: CamPlan, chord: float, notes: list[Text]) -> Mesh | None:
    """Mesh of the disc; None, and the reason in the remarks, if its features cut into each other."""
    inner, outer = plan.design.cam.faces_mm
    try:
        return cam_mesh(plan.curve, plan.made_blank, outer - inner, chord)
    except CadgenError as error:
        notes[:] = [Words(f"The cam has no solid: {error}.", f"凸轮无法生成实体：{error}。")]
        return None


def _label(turning: TurningPart) -> Words:
    part = turning.part
    teeth = " + ".join(str(wheel.teeth) for wheel in part.gears if hasattr(wheel, "teeth"))
    shown = f" ({teeth})" if teeth else ""
    return Words(f"shaft {part.shaft}{shown}", f"{part.shaft} 轴{shown}")


def _camshaft(plan: CamPlan, train: TurningTrain | None) -> Shaft:
    inner, outer = plan.design.cam.faces_mm
    low, high = -_BEYOND, outer - inner + _BEYOND
    if train is not None:
        ends = train.parts[-1].range
        low, high = min(low, ends[0] - _BEYOND), max(high, ends[1] + _BEYOND)
    return Shaft(say("camshaft"), (0.0, 0.0), plan.design.blank.bore_diameter_mm, low, high, 0.0, -1.0, 0.0)


def _shaft(turning: TurningPart, reach: float | None, *, drawn: bool) -> Shaft:
    low, high = turning.range
    ends = (low, high) if reach is None else (min(low, reach), max(high, reach))
    return Shaft(
        Words(f"shaft {turning.part.shaft}", f"{turning.part.shaft} 轴"),
        (turning.axis.real, turning.axis.imag),
        turning.part.blank.bore_diameter if drawn else 0.0,
        ends[0] - _BEYOND,
        ends[1] + _BEYOND,
        turning.angle,
        turning.rate,
        turning.lead,
    )


def _notes(plan: CamPlan, train: TurningTrain, cam_radius: float) -> list[Text]:
    """Remarks on the place of the train in the car."""
    notes: list[Text] = []
    behind, drive = _behind(plan), train.parts[0]
    if train.reach < behind:
        notes.append(
            Words(
                f"The train as laid out reaches {train.reach:.1f} mm from the camshaft; the rear axle lies "
                f"{behind:.1f} mm behind it. Give the stages' directions to bring the drive onto the axle.",
                f"按当前布置，轮系从凸轮轴伸出 {train.reach:.1f} mm，而后轴位于其后 {behind:.1f} mm。"
                "请给出各级方向，使驱动轴落在后轴上。",
            )
        )
    room = hypot(drive.axis.real, drive.axis.imag) - drive.part.blank.bore_diameter / 2 - cam_radius
    if room < 0 and plan.wheel.radius:
        notes.append(
            Words(
                f"As laid out, the shaft of the drive wheel runs through the circle that the cam sweeps, {-room:.1f} "
                "mm deep: lay the stages out further apart, or lead the shaft past the cam.",
                f"按当前布置，驱动轮轴穿过凸轮扫过的圆，深入 {-room:.1f} mm：请加大各级布置距离，或让轴避开凸轮。",
            )
        )
    if drive.rate < 0:
        notes.append(say("even-stages"))
    return notes
