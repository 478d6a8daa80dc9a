"""The STEP file of a car read by the kernel alone: no two solids overlap, and gaps are those of the layout's check.

Names, places and solids are read here by plain OCP. For further cam angles the solids are moved by formulas of this
file: the cam by -θ, every shaft by the ratio of its teeth, the fork by the angle of the rod that touches the disc.
"""

from collections.abc import Iterator
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from manifold3d import Error, Manifold, Mesh64
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Tool
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepGProp import BRepGProp
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.collections import Sequence_TDF_Label
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf
from OCP.GProp import GProp_GProps
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_FACE, TopAbs_REVERSED
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS, TopoDS_Shape
from OCP.XCAFDoc import XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from cadgen import Design
from cadgen.api.assembly import AssembledCar
from cadgen.car.assembly.car_parts import GroupKind
from cadgen.jobs.car_frame import frame_in

pytestmark = [pytest.mark.slow, pytest.mark.long]

ANGLES = np.arange(24) * 15.0
OVERLAP = 1e-6  # mm³
AGREES = 0.01  # mm
NEAR = 3.0  # mm between the boxes of two parts, beyond which their gap is not measured: the least is smaller
# Bodies that are no part of the train, of which the layout judges every gap; and pairs that touch by design.
JUDGED = ("cam-disc", "drive-wheel", "idle-wheel", "rod", "front-wheel")


def read(path: Path) -> dict[str, TopoDS_Shape]:
    document, reader = TDocStd_Document(TCollection_ExtendedString("XCAF")), STEPCAFControl_Reader()
    reader.SetNameMode(True)
    reader.ReadFile(str(path))
    assert reader.Transfer(document)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    roots, uses = Sequence_TDF_Label(), Sequence_TDF_Label()
    tool.GetFreeShapes(roots)
    assert roots.Length() == 1
    XCAFDoc_ShapeTool.GetComponents_s(roots.First(), uses)
    shapes = {}
    for number in range(1, uses.Length() + 1):
        name = TDataStd_Name()
        assert uses.Value(number).FindAttribute(TDataStd_Name.GetID_s(), name)
        shapes[name.Get().ToExtString()] = tool.GetShape_s(uses.Value(number))
    return shapes


def near(shapes: dict[str, TopoDS_Shape]) -> Iterator[tuple[str, str]]:
    """Pairs whose boxes meet."""
    boxes = {}
    for name, shape in shapes.items():
        boxes[name] = Bnd_Box()
        BRepBndLib.AddOptimal_s(shape, boxes[name], False, False)
    return (pair for pair in combinations(shapes, 2) if not boxes[pair[0]].IsOut(boxes[pair[1]]))


def common(one: TopoDS_Shape, other: TopoDS_Shape) -> float:
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(BRepAlgoAPI_Common(one, other).Shape(), found)
    return float(found.Mass())


def turned(
    shape: TopoDS_Shape, point: tuple[float, float, float], axis: tuple[int, int, int], angle: float
) -> TopoDS_Shape:
    move = gp_Trsf()
    move.SetRotation(gp_Ax1(gp_Pnt(*point), gp_Dir(*axis)), angle)
    return BRepBuilderAPI_Transform(shape, move, False).Shape()


@pytest.fixture(scope="module")
def car() -> AssembledCar:
    return Design.load("workshop_car").assembly("actual")


@pytest.fixture(scope="module")
def shapes(car: AssembledCar, tmp_path_factory: pytest.TempPathFactory) -> dict[str, TopoDS_Shape]:
    written = car.write(tmp_path_factory.mktemp("car"))
    return read(written.folder / "workshop_car_assembly.step")


def test_names_are_those_of_the_parts(car: AssembledCar, shapes: dict[str, TopoDS_Shape]) -> None:
    assert len(shapes) == sum(len(part.places) for part in car.parts)
    assert {"cam-disc", "rod", "fork-cheek-1", "fork-cheek-2", "shaft-4"} <= shapes.keys()


@pytest.mark.parametrize("angle", [0.0, 97.5])
def test_no_two_solids_overlap(car: AssembledCar, angle: float, tmp_path: Path) -> None:
    written = car.write(tmp_path, angle)
    at_angle = read(written.folder / "workshop_car_assembly.step")
    pairs = list(near(at_angle))
    volumes = {pair: common(at_angle[pair[0]], at_angle[pair[1]]) for pair in pairs}
    worst = max(volumes, key=lambda pair: volumes[pair])
    print(f"{angle} degrees: {len(pairs)} pairs, greatest common volume {volumes[worst]:.2e} mm³ of {worst}")
    assert volumes[worst] < OVERLAP


def test_no_solid_overlaps_a_weight_and_its_guide(tmp_path: Path) -> None:
    weight = "drive={kind='weight', mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=400, drum_mm=20}"
    given = [weight, "mechanics.drive_energy_J=", "mechanics.rolling_resistance=0.007"]
    written = Design.load("workshop_car", given).assembly("actual").write(tmp_path)
    solids = read(written.folder / "workshop_car_assembly.step")
    assert {"drop-weight", "guide-top", "tube-6-x-1-x-490-4", "drum"} <= solids.keys()
    assert max(common(solids[one], solids[other]) for one, other in near(solids)) < OVERLAP


def test_gaps_are_those_of_the_layout_at_24_cam_angles(car: AssembledCar, shapes: dict[str, TopoDS_Shape]) -> None:
    found = car.computed.layout.arrangement
    assert found is not None
    a, fork_z, side = 70.0, -23.5, 1
    motion = car.computed.use.rolled(car.computed.cam)
    least = (np.inf, "", "", 0.0)
    to_frame = least
    stands = {part.code for part in car.parts if part.group.kind == GroupKind.FRAME}
    deepest, measured = 0.0, 0
    for angle in np.radians(ANGLES):
        disc = turned(shapes["cam-disc"], (0.0, 0.0, 0.0), (0, 0, 1), -angle)
        start, now = (float(np.arctan(motion.q(np.array([each])))[0]) for each in (0.0, angle))
        moved = {
            name: turned(shapes[name], (a, 0.0, fork_z), (0, 1, 0), side * (now - start))
            for name in ("rod", "front-wheel")
        }
        moved |= {"cam-disc": disc}
        at_angle = shapes | moved
        deepest = max(deepest, common(at_angle["rod"], disc))
        boxes = {name: Bnd_Box() for name in at_angle}
        for name, shape in at_angle.items():
            BRepBndLib.Add_s(shape, boxes[name], False)
        for one, other in combinations(at_angle, 2):
            stand = angle > 0 and not {one, other} & moved.keys()
            if stand or not {one, other} & set(JUDGED) or touching(one, other):
                continue
            if boxes[one].Distance(boxes[other]) < NEAR:
                gap = BRepExtrema_DistShapeShape(at_angle[one], at_angle[other]).Value()
                found_here = (gap, one, other, float(np.degrees(angle)))
                # Bearings and spacers stand several times, with a number after their code.
                if {one, other} & stands or any(name.rpartition("-")[0] in stands for name in (one, other)):
                    to_frame = min(to_frame, found_here)
                else:
                    least = min(least, found_here)
                measured += 1
    print(f"least gap {least[0]:.4f} mm between {least[1]} and {least[2]}, {found.least.size:.4f} in the layout")
    print(f"{measured} gaps at {len(ANGLES)} angles")
    print(f"greatest common volume of rod and disc {deepest:.2e} mm³")
    frame, _ = frame_in(car.computed.layout).gaps
    print(f"to the frame {to_frame[0]:.4f} mm between {to_frame[1]} and {to_frame[2]}, {frame.size:.4f} by its check")
    assert to_frame[0] >= frame.size - AGREES
    assert least[0] < NEAR
    assert least[0] == pytest.approx(found.least.size, abs=AGREES)
    assert deepest < OVERLAP


def touching(one: str, other: str) -> bool:
    """Whether two parts are on one shaft, or both of the fork, or rod and disc; gears turn about their shafts."""
    groups = {"rod": "fork", "front-wheel": "fork", "front-pin": "fork", "cam-disc": "4", "key-cam-disc": "4"}
    groups |= {"shaft-1": "1", "gear-1-pinion": "1", "drive-wheel": "1", "idle-wheel": "1"}
    groups |= {"shaft-4": "4", "gear-4-wheel": "4", "key-shaft-4": "4"}
    groups |= {"sleeve-disc": "4", "collar-disc": "4", "sleeve-idle": "1", "collar-idle": "1"}

    def group(name: str) -> str:
        return "fork" if name.startswith("fork") else groups.get(name, name)

    return group(one) == group(other) or {one, other} == {"rod", "cam-disc"}


CHORD = 0.002  # mm, of the meshes by which gaps of a printed frame are taken: its solid is too large for the kernel's
RATES = {1: 45.0, 2: -9.0, 3: 3.0, 4: -1.0}  # turns of each shaft by turn of the cam: 150/30 x 120/40 x 120/40


def meshed(shape: TopoDS_Shape) -> Manifold:
    """Mesh of a solid by the kernel's own triangulation, corners of faces that meet put together."""
    BRepMesh_IncrementalMesh(shape, CHORD, False, 0.1, True)
    points, triangles, count = [], [], 0
    faces = TopExp_Explorer(shape, TopAbs_FACE)
    while faces.More():
        face, place = TopoDS.Face(faces.Current()), TopLoc_Location()
        found = BRep_Tool.Triangulation_s(face, place)
        nodes = [found.Node(number).Transformed(place.Transformation()) for number in range(1, found.NbNodes() + 1)]
        corners = np.array([found.Triangle(number).Get() for number in range(1, found.NbTriangles() + 1)]) - 1
        triangles.append((corners[:, ::-1] if face.Orientation() == TopAbs_REVERSED else corners) + count)
        points.append(np.array([[node.X(), node.Y(), node.Z()] for node in nodes]))
        count += len(nodes)
        faces.Next()
    every = np.concatenate(points)
    _, first, own = np.unique(np.round(every, 6), axis=0, return_index=True, return_inverse=True)
    corners = own.reshape(-1)[np.concatenate(triangles)]
    corners = corners[[len(set(each)) == 3 for each in corners.tolist()]]
    solid = Manifold(Mesh64(every[first], corners.astype(np.uint64)))
    assert solid.status() == Error.NoError
    return solid


def test_gaps_of_a_printed_frame_are_those_of_its_checks_at_24_cam_angles(tmp_path: Path) -> None:
    """Gaps between meshes of the STEP file's solids; the frame's check knows the gears by the circles of their tips."""
    printed = Design.load("workshop_car", ["frame.make=printed", "frame.material="]).assembly("actual")
    written = printed.write(tmp_path)
    solids = {name: meshed(shape) for name, shape in read(written.folder / "workshop_car_assembly.step").items()}
    layout, motion = printed.computed.layout, printed.computed.use.rolled(printed.computed.cam)
    groups = {}
    for part in printed.parts:
        for number in range(1, len(part.places) + 1):
            groups[part.code if part.quantity == 1 else f"{part.code}-{number}"] = part.group
    assert groups.keys() == solids.keys()
    axes = layout.arrangement.axes
    borne = ("shaft", "sleeve", "fork-spindle", "bearing")  # they stand in seats of the frame, or on its bearings

    def moved(name: str, angle: float) -> Manifold:
        group, solid = groups[name], solids[name]
        if group.kind == GroupKind.FRAME:
            return solid
        axis, turn, place = (0, 0, 1), RATES.get(group.number, 0.0) * angle, (0.0, 0.0, 0.0)
        if group.kind == GroupKind.FORK:
            start, now = (float(np.arctan(motion.q(np.array([each])))[0]) for each in (0.0, angle))
            axis, turn, place = (0, 1, 0), now - start, (70.0, 0.0, -23.5)
        else:
            place = (axes[group.number - 1].real, axes[group.number - 1].imag, 0.0)
        degrees = np.degrees(turn) * np.array(axis)
        return solid.translate([-each for each in place]).rotate(degrees.tolist()).translate(place)

    least, to_frame, shared = np.inf, np.inf, 0.0
    for angle in np.radians(ANGLES):
        now = {name: moved(name, angle) for name in solids}
        shared = max(shared, (now["rod"] ^ now["cam-disc"]).volume())
        for one, other in combinations(now, 2):
            kinds = {groups[one].kind, groups[other].kind}
            if groups[one] == groups[other] or kinds == {GroupKind.FRAME} or {one, other} == {"rod", "cam-disc"}:
                continue
            if GroupKind.FRAME in kinds:
                if not any(name.startswith(borne) for name in (one, other)):
                    to_frame = min(to_frame, now[one].min_gap(now[other], NEAR))
            elif {one, other} & set(JUDGED):
                least = min(least, now[one].min_gap(now[other], NEAR))
    print(f"least gap {least:.4f} mm, {to_frame:.4f} to the frame; rod and disc share {shared:.1e} mm³")
    assert least == pytest.approx(layout.arrangement.least.size, abs=AGREES)
    assert to_frame == pytest.approx(frame_in(layout).gaps[0].size, abs=AGREES)
    assert shared < OVERLAP
