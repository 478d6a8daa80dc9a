"""The plate for the axes: its holes where ezdxf and the text of the STEP file have them; bores that do not fit."""

import ezdxf
import pytest

from cadgen import Design, draw
from cadgen.errors import DesignError, FileError
from cadgen.output.files.plate import Axis, Plate, bearing_bores, plate_files

PLATE = Plate(
    (
        Axis(shaft=1, x=0.0, y=0.0, bore=13.0, reach=11.0),
        Axis(shaft=2, x=30.0, y=40.0, bore=0.0, reach=33.0),
        Axis(shaft=3, x=-35.25, y=12.5, bore=8.0, reach=20.0),
        Axis(shaft=4, x=-35.25, y=12.5, bore=6.0, reach=10.0),
    ),
    5.0,
)


def test_plate_files_hold_its_holes(tmp_path):
    outline, solid = plate_files(PLATE, tmp_path, "plate")
    circles = ezdxf.readfile(tmp_path / outline.name).modelspace().query("CIRCLE")
    found = sorted((c.dxf.center.x, c.dxf.center.y, c.dxf.radius, c.dxf.layer) for c in circles)
    assert found == [(-35.25, 12.5, 4.0, "HOLES"), (0.0, 0.0, 6.5, "HOLES")]  # of two on one axis the larger
    facts = outline.facts.json()
    assert [hole["shaft"] for hole in facts["holes_mm"]] == [1, 3]
    left, low, right, high = facts["sides_mm"]
    assert (left, low, right, high) == (-70.0, -25.0, 75.0, 85.0)
    area = (right - left) * (high - low) - 3.141592653589793 * (6.5**2 + 4.0**2)
    assert solid.facts.json()["volume_mm3"] == pytest.approx(5 * area, rel=1e-9)


def test_a_hole_elsewhere_in_a_file_is_found(tmp_path, monkeypatch):
    import cadgen.output.files.plate as files

    write = files.write_dxf
    moved = Plate((Axis(shaft=1, x=0.0, y=1e-5, bore=13.0, reach=11.0), *PLATE.axes[1:]), 5.0)
    monkeypatch.setattr(files, "write_dxf", lambda path, outline, bore, holes: write(path, outline, bore, moved.holes))
    with pytest.raises(FileError, match="other holes or sides"):
        list(plate_files(PLATE, tmp_path, "plate"))


def test_bores_that_do_not_fit_are_refused_with_those_that_do():
    with pytest.raises(DesignError, match=r"2 values and the train 3 shafts; give one for all, or \[8.0, 8.0, 8.0\]"):
        bearing_bores([8.0, 9.0], [3.0, 3.0, 3.0])
    assert bearing_bores([8.0], [3.0, 0.0]) == (8.0, 8.0)
    assert bearing_bores(None, [3.0, 0.0]) == (3.0, 0.0)
    axes = [Axis(shaft=n, x=20.0 * n, y=0.0, bore=25.0, reach=10.0) for n in (1, 2)]
    with pytest.raises(DesignError, match=r"train.plate.bearing_bores_mm has 25 and 25 .* give both at most 19.8$"):
        Plate(tuple(axes))
    Plate(tuple(Axis(shaft=a.shaft, x=a.x, y=0.0, bore=19.8, reach=10.0) for a in axes))


def test_draw_makes_the_plate_with_its_bearings(tmp_path):
    file = tmp_path / "pair.toml"
    file.write_text(
        "[train]\nmodule_mm = 1.0\nwidth_mm = 8.0\nbearing_span_mm = 60.0\ngrade = 7\n"
        "[train.plate]\nthickness_mm = 4.0\nbearing_bores_mm = [10.0, 19.0]\nhole_fit = 'H7/h6'\n"
        "[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 60, internal = true }\n"
    )
    train = Design.load(file, train_only=True).gears()
    entry = draw(tmp_path, train=train).entry["files"]
    assert entry["pair_plate_outline.dxf"]["holes_mm"][1]["bore"] == 19.0
    # The ring's rim, not its tips, has room on the plate: 67.5 mm, with 10 mm round it.
    _, low, right, high = entry["pair_plate_outline.dxf"]["sides_mm"]
    assert (high - low, right) == (90.0, 65.0)
    assert "pair_plate.step" in entry
