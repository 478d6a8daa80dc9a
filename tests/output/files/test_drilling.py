"""Drilling programs: holes through the work at their places, in pecks, and what the reader refuses."""

import re
from math import pi, radians, tan

import numpy as np
import pytest

from cadgen.design.load import load_design
from cadgen.design.machining import Drilling, Machining
from cadgen.errors import DesignError, FileError
from cadgen.output.files.drilling import drills_of, write_drilling
from cadgen.output.files.gcode_reader import read_drilling
from cadgen.parts.blank import Blank
from cadgen.parts.features import DFlat, Hub, Lightening, Mark

THICKNESS = 3.0
PLAIN = Drilling()
MACHINING = Machining()
BLANK = Blank(
    bore_diameter=8.0,
    lightening=Lightening(count=5, hole_diameter=6.0, circle_diameter=34.0, start_angle=0.3),
    mark=Mark(diameter=3.0, radius=12.0, angle=0.8),
)


def written(folder, number=0, drilling=PLAIN, blank=BLANK, material=None):
    drill = drills_of(blank, THICKNESS, drilling)[number]
    path = folder / drill.file_name("cam")
    write_drilling(path, drill, MACHINING, drilling, name="cam", material=material)
    return path, drill


def read(path, diameter, drilling=PLAIN, blank=BLANK):
    bore = drills_of(blank, THICKNESS, drilling)[0].diameter
    how = {"bore": bore, "holes": blank.holes(), "thickness": THICKNESS, "hub": blank.hub}
    return read_drilling(path, MACHINING, drilling, diameter=diameter, **how)


@pytest.mark.parametrize(
    ("number", "diameter", "radius", "angles"),
    [
        (0, 8.0, 0.0, [0.0]),
        (1, 6.0, 17.0, [0.3 + 2 * pi * n / 5 for n in range(5)]),
        (2, 3.0, 12.0, [0.8]),
    ],
)
def test_every_hole_goes_through_at_its_place(tmp_path, number, diameter, radius, angles):
    path, drill = written(tmp_path, number)
    text = path.read_text()
    assert drill.diameter == diameter
    assert path.name == f"cam_drill_{diameter:g}.nc"
    places = [(float(x), float(y)) for x, y in re.findall(r"G0 X(\S+) Y(\S+)", text)]
    assert np.array(places) == pytest.approx(radius * np.stack([np.cos(angles), np.sin(angles)], axis=1), abs=6e-5)
    # The whole diameter leaves the lower face: the point, and what the design adds, are below it.
    deepest = min(float(z) for z in re.findall(r"G1 Z(\S+)", text))
    assert deepest == pytest.approx(-3.0 - 0.3 - diameter / 2 / tan(radians(59)), abs=1e-4)
    off = read(path, diameter)
    print(f"{len(angles)} holes of {diameter:g} mm, {off * 1e3:.3f} um off")
    assert off < 1e-4


def test_pecks_are_as_deep_as_the_design_says(tmp_path):
    path, _ = written(tmp_path, drilling=Drilling(peck_mm=1.5))
    cuts = [float(z) for z in re.findall(r"G1 Z(\S+)", path.read_text())]
    assert -np.diff([0.0, *cuts]) == pytest.approx([1.5, 1.5, 1.5, 5.7034 - 4.5], abs=1e-3)
    # Back in, the drill comes down at rapid speed to a millimetre above its floor.
    assert re.findall(r"G0 Z1\.0000\nG0 Z(\S+)", path.read_text()) == ["-0.5000", "-2.0000", "-3.5000"]
    read(path, 8.0, Drilling(peck_mm=1.5))
    with pytest.raises(FileError, match=r"drills 1\.500 mm at once in line .*; 1 mm is allowed"):
        read(path, 8.0, Drilling(peck_mm=1.0))


def test_speed_and_feed_go_by_material_and_diameter(tmp_path):
    for material, speed in (("aluminium", 45.0), ("steel", 20.0), (None, 20.0)):
        text = written(tmp_path, 2, material=material)[0].read_text()
        turns = int(re.search(r"^S(\d+) M3$", text, re.M)[1])
        assert turns * pi * 3e-3 == pytest.approx(speed, rel=1e-3)
        assert float(re.search(r" F(\S+)", text)[1]) == pytest.approx(0.03 * turns, rel=1e-2)
    given = Drilling(spindle_rpm=900.0, feed_mm_per_min=33.0)
    text = written(tmp_path, 2, given, material="steel")[0].read_text()
    assert "\nS900 M3\n" in text
    assert set(re.findall(r" F(\S+)", text)) == {"33"}


@pytest.mark.parametrize(("side", "top", "bottom"), [("outer", 6.0, -3.0), ("inner", 0.0, -9.0)])
def test_a_bore_goes_through_the_hub(tmp_path, side, top, bottom):
    blank = Blank(
        bore_diameter=8.0,
        hub=Hub(diameter=16.0, length=6.0, side=side),
        mark=Mark(diameter=3.0, radius=12.0, angle=0.0),
    )
    path, _ = written(tmp_path, blank=blank)
    text = path.read_text()
    assert f"G0 Z{top + 1:.4f}\nG1" in text
    assert min(float(z) for z in re.findall(r"G1 Z(\S+)", text)) == pytest.approx(
        bottom - 0.3 - 4 / tan(radians(59)), abs=1e-4
    )
    read(path, 8.0, blank=blank)
    if side == "outer":  # the mark's drill must pass beside the hub, or above it
        path.write_text(text.replace("G0 Z7.0000\nG1", "G0 Z1.0000\nG1"))
        with pytest.raises(FileError, match="rapid speed through the stock, at Z 1:"):
            read(path, 8.0, blank=blank)


def test_a_drill_spares_the_flat_and_leaves_the_rest_to_a_reamer():
    flat = Blank(bore_diameter=8.0, key=DFlat(depth=1.0))
    assert drills_of(flat, THICKNESS, Drilling())[0].diameter == pytest.approx(6.0)
    assert drills_of(BLANK, THICKNESS, Drilling(bore_diameter_mm=7.8))[0].file_name("cam") == "cam_drill_7.8.nc"
    with pytest.raises(DesignError, match=r"bore_diameter_mm is 8\.1; it must be at most 8, blank\.bore_diameter_mm"):
        load_design("carbon_free_car", ["machining.drilling.bore_diameter_mm=8.1"])


def test_holes_of_one_diameter_share_a_program(tmp_path):
    blank = Blank(bore_diameter=6.0, lightening=BLANK.lightening)
    drills = drills_of(blank, THICKNESS, Drilling())
    assert [(drill.diameter, len(drill.holes)) for drill in drills] == [(6.0, 6)]
    path, _ = written(tmp_path, blank=blank)
    assert "bore and lightening holes, 6 holes" in path.read_text()
    read(path, 6.0, blank=blank)


@pytest.mark.parametrize(
    ("pattern", "replacement", "message"),
    [
        (r"G0 X(\S+) Y(\S+)", r"G0 X\1 Y\g<2>1", None),
        (r"G0 X\S+ Y", "G0 X16.0000 Y", "has no hole at X"),
        (r"(?s)G0 X\S+ Y.*?G0 Z5\.0000\n", "", "drills 4 holes where the disc has 5"),
        (r"G1 Z-\S+ F", "G1 Z-2.5 F", "does not drill through"),
        (r"G1 Z-\S+ F", "G0 Z-5.1 F", "rapid speed through the stock"),
        (r"G0 Z5\.0000\nG0 X", "G0 Z2.0000\nG0 X", "sideways at rapid speed at Z 2, below the safe height of 5 mm"),
        (r"(G1 Z-\S+ F\S+)", r"\1\nG1 X20 Y20", "cuts sideways"),
        (r"M30\n", "", "no M30"),
        (r"M5\nM30", "M5\nM0\nM30", "stops before its end"),
    ],
)
def test_wrong_programs_are_refused(tmp_path, pattern, replacement, message):
    path, _ = written(tmp_path, 1)
    text, changes = re.subn(pattern, replacement, path.read_text(), count=1)
    assert changes
    path.write_text(text)
    if message is None:
        assert read(path, 6.0) < 1e-4
    else:
        with pytest.raises(FileError, match=message):
            read(path, 6.0)
