"""Hand of helices, from points of the written STEP file: a right-hand one turns as a screw by the right-hand rule."""

import os
from dataclasses import replace
from math import atan, cos, radians, sin, tan

import numpy as np
import pytest
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopoDS import TopoDS

from cadgen import Gear, Rack
from cadgen.gears.tooth import GearForm
from cadgen.inference.gearing.flank_kinds import HELIX_LINES
from cadgen.inference.gearing.flank_lines import helix_errors
from cadgen.inference.measurement.record import Record
from tests.geometry.solids.test_helical_wall import parts

WIDTH = 4.0
SIZES = {"module": 1.0, "width": WIDTH, "helix_angle": radians(20)}


def ends(folder):
    """Ends of the edges that run along the whole width, the one with the greater z last, shape (n, 2, 3)."""
    (file,) = folder.glob("*.step")
    reader = STEPControl_Reader()
    assert reader.ReadFile(os.fspath(file)) == IFSelect_RetDone
    reader.TransferRoots()
    found = []
    for edge in parts(reader.OneShape(), TopAbs_EDGE):
        curve = BRepAdaptor_Curve(TopoDS.Edge(edge))
        points = (curve.Value(t) for t in (curve.FirstParameter(), curve.LastParameter()))
        pair = np.array([[p.X(), p.Y(), p.Z()] for p in points])
        if abs(np.ptp(pair[:, 2]) - WIDTH) < 1e-6:
            found.append(pair[np.argsort(pair[:, 2])])
    return np.array(found)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("kind", ["gear", "ring", "rack"])
def test_teeth_turn_by_the_right_hand_rule_along_the_axis(tmp_path, kind, hand):
    """A rack is a gear whose axis lies far behind its back."""
    if kind == "rack":
        Rack(teeth=6, hand=hand, **SIZES).write(tmp_path)
    else:
        more = {"teeth": 30, "internal": True} if kind == "ring" else {"teeth": 15, "bore": 5}
        Gear(hand=hand, **more, **SIZES).write(tmp_path)
    found = ends(tmp_path)
    axis = np.array([0.0, -1e6, 0.0]) if kind == "rack" else np.zeros(3)
    turned = np.cross(found[:, 0] - axis, found[:, 1] - axis)[:, 2] / np.linalg.norm(found[0, 0, :2] - axis[:2])
    teeth = turned[np.abs(turned) > 1e-3]  # the rest are straight edges of bore and back
    assert len(teeth) >= 12
    assert np.all(teeth > 0) if hand == "right" else np.all(teeth < 0)


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("hand", ["right", "left"])
def test_helix_lines_of_a_solid_say_the_hand_that_its_teeth_have(tmp_path, hand):
    """A gear with more of its helix is measured against 20 degrees from its upper face down.

    Seen from above a flank that goes ahead clockwise by Δψ has r_b Δψ more material on the right, and less on the left.
    Its 20.05 degrees are those of its own, larger reference circle.
    """
    made = replace(Gear(teeth=15, bore=5, hand=hand, **SIZES), helix_angle=radians(20.05))
    made.write(tmp_path)
    low, high = ends(tmp_path).swapaxes(0, 1)
    turned = np.angle((low[:, 0] + 1j * low[:, 1]) / (high[:, 0] + 1j * high[:, 1]))
    clockwise = -float(np.median(turned[np.abs(turned) > 1e-3])) / WIDTH
    sign = 1 if hand == "right" else -1
    form = GearForm(teeth=15, normal_module=1.0, width=WIDTH, helix_angle=sign * radians(20))
    ahead = clockwise - 2 * tan(form.helix_angle) / form.reference_diameter
    depth = np.tile(np.linspace(0.0, WIDTH, 9), 6)
    right = np.repeat([True, False] * 3, 9)
    columns = {
        "tooth": np.repeat([1.0, 1.0, 6.0, 6.0, 11.0, 11.0], 9),
        "flank": np.where(right, "right", "left"),
        "face_mm": depth,
        "helix_um": 1e3 * np.where(right, 1, -1) * ahead * depth * form.base_diameter / 2,
    }
    record = Record(kind=HELIX_LINES, columns=columns, run=np.zeros(54, dtype=int), remarks=(), source="made")
    more = atan(sin(radians(20.05)) / cos(radians(20))) - radians(20)
    assert helix_errors(record, form).angle.value == pytest.approx(sign * more, rel=1e-3)
