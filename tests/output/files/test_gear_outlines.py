"""DXF and 3MF of gears of every kind: outlines read by ezdxf against formulas of their own."""

from math import atan, cos, pi, radians, tan

import ezdxf
import numpy as np
import pytest

from cadgen import Gear, GearPair, Rack
from cadgen.errors import FileError
from cadgen.output.files.threemf import read_3mf

BETA = radians(20)


def points_on(file, layer="CAM_PROFILE"):
    """Points on the splines of a layer, mm."""
    space = ezdxf.readfile(file).modelspace()
    splines = [each for each in space.query("SPLINE") if each.dxf.layer == layer]
    return np.concatenate([[complex(x, y) for x, y, _ in each.construction_tool().approximate(40)] for each in splines])


def flank_angle(points, teeth):
    """Angle of points from the middle of the tooth (of a ring: space) that the involute bounds, less its own, rad."""
    alpha = atan(tan(radians(20)) / cos(BETA))
    base = teeth / cos(BETA) * cos(alpha) / 2
    inv = np.vectorize(lambda a: tan(a) - a)
    at = inv(np.arccos(base / np.abs(points)))
    return pi / 2 / teeth + (tan(alpha) - alpha) - at


@pytest.mark.parametrize("internal", [False, True])
def test_outline_of_a_helical_gear_is_its_section_at_the_lower_face(tmp_path, internal):
    teeth, width = (60, 8.0) if internal else (30, 8.0)
    gear = Gear(teeth=teeth, module=1, width=width, helix_angle=BETA, internal=internal, bore=0 if internal else 5)
    made = gear.write(tmp_path, "dxf")
    points = points_on(tmp_path / "gear.dxf")
    reference = teeth / cos(BETA) / 2
    flanks = points[np.abs(np.abs(points) - reference) < 0.3]
    turned = np.angle(flanks) + width / 2 * tan(BETA) / reference  # below the middle, a right-hand tooth is behind
    pitch = 2 * pi / teeth
    # A ring has a space beside the tooth that stands on x.
    off = np.abs((turned - (pitch / 2 if internal else 0.0) + pitch / 2) % pitch - pitch / 2)
    assert len(flanks) > 20 * teeth
    assert np.abs(off - flank_angle(flanks, teeth)).max() * reference < 2e-5
    space = ezdxf.readfile(tmp_path / "gear.dxf").modelspace()
    (note,) = space.query("TEXT")
    assert note.dxf.text.startswith("transverse section at the lower face: helix 20 degrees, right hand, lead ")
    circles = [(each.dxf.layer, each.dxf.radius) for each in space.query("CIRCLE")]
    assert circles == [("RIM", pytest.approx(gear.form.rim_diameter / 2)) if internal else ("BORE", 2.5)]
    assert made[0].facts["outline_error_um"] < 0.02


@pytest.mark.parametrize("beta", [0.0, 20.0, 45.0])
def test_outline_of_a_rack_against_its_lines(tmp_path, beta):
    lean = radians(beta)
    rack = Rack(teeth=5, module=2, width=8, helix_angle=lean, thickness_deviation=-0.1)
    (file,) = rack.write(tmp_path, "dxf")
    points = points_on(file.path)
    assert file.facts["outline_error_um"] < 0.02
    assert points.real.max() == pytest.approx(5 * 2 * pi / cos(lean))
    assert (points.imag.max(), points.imag.min()) == (pytest.approx(2.0), pytest.approx(-2 * 3.25))
    flank = points[(np.abs(points.imag) < 1.9) & (points.real > 1e-6) & (points.real < points.real.max() - 1e-6)]
    pitch = 2 * pi / cos(lean)
    half = np.abs(flank.real % pitch - pitch / 2) * cos(lean)
    wanted = 2 * pi / 4 - 0.05 - flank.imag * tan(radians(20))
    assert len(flank) >= 20
    assert np.abs(half - wanted).max() < 1e-5


def test_3mf_of_every_kind_holds_the_volume(tmp_path):
    gear, ring = (Gear(teeth=z, module=1, width=6, internal=z > 40, name=f"g{z}") for z in (20, 60))
    rack = Rack(teeth=10, module=1, width=6)
    for part in (gear, ring, rack):
        (file,) = part.write(tmp_path, "3mf")
        mesh, name = read_3mf(file.path)
        assert name == part.name
        assert mesh.solid().volume() == pytest.approx(part.volume, rel=1e-3)
    pair = GearPair(gear, Gear(teeth=25, module=1, width=6), backlash=0.1)
    names = [file.name for file in pair.write(tmp_path, "3mf,dxf")]
    assert names == ["pair_1_pinion.3mf", "pair_2_wheel.3mf", "pair_1_pinion.dxf", "pair_2_wheel.dxf"]
    assert {file.suffix for file in tmp_path.glob("pair*")} == {".3mf", ".dxf"}


def test_outline_without_a_hole_or_with_another_rack_is_refused(tmp_path, monkeypatch):
    import cadgen.output.files.dxf as dxf

    write = dxf.write_dxf
    monkeypatch.setattr(dxf, "write_dxf", lambda path, profile, bore, *rest: write(path, profile, None, *rest))
    with pytest.raises(FileError, match="another bore"):
        Gear(teeth=20, module=1, width=6, bore=5).write(tmp_path, "dxf")
    section = dxf._rack_section
    monkeypatch.setattr(dxf, "_rack_section", lambda form: section(Rack(teeth=4, module=1.0001, width=6).form))
    with pytest.raises(FileError, match="off the exact teeth"):
        Rack(teeth=4, module=1, width=6).write(tmp_path, "dxf")
