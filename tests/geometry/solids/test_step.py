"""STEP: size, reproducible bytes, and the round trip, read by the kernel and from the text."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from OCP.Interface import Interface_Static

from cadgen.cam.contact import roll
from cadgen.curves.contour import circle
from cadgen.errors import FileError
from cadgen.geometry.solids.disc_solid import SPLINE_TOLERANCE, cam_part
from cadgen.geometry.solids.kernel import SolidPart, contour_edges, prism, solids
from cadgen.geometry.solids.step import read_part, read_step, step_bytes
from cadgen.geometry.solids.step_text import read_rim
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub, Keyway, Lightening, SetScrew

THICKNESS = 3.0
STEP = 0.03  # mm; the rod rolled on points this dense errs by 0.005 um
SIZE_BAR = 200_000
LIFT_BAR_UM = 0.5
VOLUME_BAR = 1e-6
CAM_ANGLES = np.radians(np.arange(0, 360, 0.1))
KEYED = Blank(
    bore_diameter=8.0,
    key=Keyway(width=3.0, depth=1.4),
    lightening=Lightening(count=6, hole_diameter=18.0, circle_diameter=78.0),
)
NAME, DESCRIPTION = "carbon_free_car cam, actual", 'steering cam; it\'s 3 mm (thick), "actual" profile'


def washer(name: str = "washer") -> SolidPart:
    shape = prism(contour_edges(circle((0, 0), 5.0), 0.0), [contour_edges(circle((0, 0), 2.0), 0.0)], 3.0)
    return SolidPart(solid=solids(shape)[0], name=name, description="a small part", colour=(0.1, 0.2, 0.3))


@pytest.fixture(scope="module")
def part(carbon_free_car) -> SolidPart:
    return cam_part(carbon_free_car.actual.curve, KEYED, THICKNESS, name=NAME, description=DESCRIPTION)


@pytest.fixture(scope="module")
def data(part) -> bytes:
    return step_bytes(part)


@pytest.fixture
def file(tmp_path, data) -> Path:
    path = tmp_path / "cam.step"
    path.write_bytes(data)
    return path


def lift_error_um(car, rim) -> np.ndarray:
    wanted = car.follower.lift(car.lift.q(CAM_ANGLES))
    return 1e3 * (roll(rim, car.follower, CAM_ANGLES).lift - wanted)


def test_round_trip(carbon_free_car, part, data, file):
    content = read_step(file, STEP)
    exact = KEYED.disc_volume(carbon_free_car.actual.curve.area(), THICKNESS)
    error = np.abs(lift_error_um(carbon_free_car, content.rim)).max()
    print(f"\n{len(data)} bytes, {error:.3f} um at lift, volume off by {content.volume / exact - 1:.1e}")
    assert len(data) <= SIZE_BAR
    assert content.valid
    assert content.bodies == 1
    assert error <= LIFT_BAR_UM
    assert content.volume == pytest.approx(exact, rel=VOLUME_BAR)
    assert (content.name, content.description) == (NAME, DESCRIPTION)
    assert content.colour == pytest.approx(part.colour, abs=1e-6)


def test_the_file_adds_next_to_nothing_to_the_profile(carbon_free_car, file):
    """The rod on the file's rim against the rod on the exact profile: 0.17 um at a face change drops out."""
    car = carbon_free_car
    rim, exact = read_step(file, STEP).rim, car.actual.curve.outline(STEP)
    lift, wanted = (roll(outline, car.follower, CAM_ANGLES).lift for outline in (rim, exact))
    error = 1e3 * np.abs(lift - wanted).max()
    print(f"\nSTEP against profile: {error:.4f} um at lift")
    assert error <= 2e3 * SPLINE_TOLERANCE


def test_the_rim_in_the_text_is_the_profile(carbon_free_car, file):
    rim = read_rim(file, STEP)
    radius = carbon_free_car.actual.curve.radius(rim.angle)
    error = np.abs(np.linalg.norm(rim.points, axis=1) - radius).max()
    print(f"\nrim from the text: {1e3 * error:.4f} um")
    assert error <= 1.5 * SPLINE_TOLERANCE


@pytest.mark.slow
def test_a_rim_of_corners_and_a_hub(appendix_car, tmp_path):
    hub = Hub(diameter=20.0, length=10.0, side="inner", set_screw=SetScrew(diameter=4.2, height=5.0, angle=2.0))
    blank = Blank(bore_diameter=8.0, hub=hub)
    curve = appendix_car.actual.curve
    file = tmp_path / "cam.step"
    file.write_bytes(step_bytes(cam_part(curve, blank, 2.7, name="cam", description="hub")))
    content = read_step(file, STEP)
    error = np.abs(np.linalg.norm(content.rim.points, axis=1) - curve.radius(content.rim.angle)).max()
    print(f"\nappendix car with hub: rim off by {1e3 * error:.4f} um")
    assert content.valid
    assert content.bodies == 1
    assert error <= 1.5 * SPLINE_TOLERANCE


def test_build123d_reads_name_colour_and_volume(part, file):
    """Through the reader that users have, with its own way of finding names and colours."""
    from build123d import import_step

    solid = import_step(file)
    assert solid.label == re.sub("[ .()]", "_", NAME)
    assert tuple(solid.color)[:3] == pytest.approx(part.colour, abs=1e-6)
    assert solid.is_valid
    assert "SI_UNIT(.MILLI.,.METRE.)" in file.read_text()


def test_bytes_do_not_depend_on_what_was_written_before(part, data):
    """Nor on settings of the kernel that another writer in this process has left behind."""
    step_bytes(washer())
    assert b"PCURVE" not in data
    assert step_bytes(part) == data
    for name, value in {"write.step.schema": "AP242DIS", "write.step.unit": "INCH"}.items():
        assert Interface_Static.SetCVal_s(name, value)
    for name, number in {"write.surfacecurve.mode": 1, "write.precision.mode": 2}.items():
        assert Interface_Static.SetIVal_s(name, number)
    assert step_bytes(part) == data


@pytest.mark.slow
def test_bytes_do_not_depend_on_the_process_or_the_clock():
    """Another process, with another order of hashing."""
    expected = step_bytes(washer())
    assert b"'2000-01-01T00:00:00'" in expected
    program = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
from test_step import step_bytes, washer
sys.stdout.buffer.write(step_bytes(washer()))
"""
    environment = os.environ | {"PYTHONHASHSEED": "7", "PYTHONPATH": os.pathsep.join(sys.path)}
    environment.pop("SOURCE_DATE_EPOCH", None)
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True, env=environment)
    assert run.stdout == expected


def test_source_date_epoch_sets_the_time_stamp_alone(monkeypatch):
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    usual = step_bytes(washer())
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    assert step_bytes(washer()) == usual.replace(b"2000-01-01T00:00:00", b"2023-11-14T22:13:20")
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "yesterday")
    with pytest.raises(FileError, match="SOURCE_DATE_EPOCH is 'yesterday'; it must be a number of seconds"):
        step_bytes(washer())


def test_nothing_is_printed(capfd, file):
    step_bytes(washer())
    read_step(file, 1.0)
    assert capfd.readouterr() == ("", "")


def with_pole_moved(text: str, number: int, shift: float) -> str:
    """The file with one control point of the inner face's rim shifted along x, mm."""
    for poles in re.findall(r"B_SPLINE_CURVE_WITH_KNOTS\('',5,\(([^)]*)\)", text):
        point = re.findall(r"#(\d+)", poles)[number]
        line = re.search(rf"#{point} = CARTESIAN_POINT\('',\(([^,]+),[^,]+,0\.\)\);", text)
        if line:
            moved = line.group(0).replace(line.group(1), f"{float(line.group(1)) + shift:.12f}")
            return text.replace(line.group(0), moved)
    raise AssertionError("no rim at z = 0")


def test_a_moved_control_point_shows_at_lift(carbon_free_car, file):
    """The proof must be able to fail: 10 um on one control point."""
    file.write_text(with_pole_moved(file.read_text(), 9, 0.01))
    assert np.abs(lift_error_um(carbon_free_car, read_rim(file, STEP))).max() > LIFT_BAR_UM


def test_a_file_without_its_solid_shows(file):
    file.write_text(file.read_text().replace("MANIFOLD_SOLID_BREP", "BREP"))
    content = read_step(file, STEP)
    assert (content.bodies, content.colour) == (0, None)
    assert content.volume == 0


def test_an_open_rim_is_refused(file):
    file.write_text(with_pole_moved(file.read_text(), 0, 0.01))
    with pytest.raises(FileError, match=r"the rim in cam\.step is open by 0\.01 mm"):
        read_rim(file, STEP)


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        (lambda text: text[: len(text) // 2], "cam.step is not a whole STEP file"),
        (lambda text: "", "cam.step is not a whole STEP file"),
        (lambda text: re.sub(r"#35 =.*?;\n", "", text, flags=re.DOTALL), "cam.step is damaged"),
        (lambda text: text.replace("PRODUCT_DEFINITION_SHAPE", "PRODUCT(DEFINITION"), "kernel cannot read"),
        (lambda text: text.replace(".MILLI.", "$"), "cam.step is not in millimetres"),
        (lambda text: text.replace("B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE"), "has 0 closed rims"),
        (
            lambda text: re.sub(r"(#\d+ = PRODUCT\()", r"#999999 = PRODUCT('','','',());\n\1", text),
            "2 products",
        ),
        (lambda text: text.replace("HEADER;", "HEADER é;"), "cannot read cam.step"),
    ],
    ids=[
        "cut off",
        "empty",
        "a point missing",
        "not the syntax",
        "metres",
        "no spline",
        "two products",
        "not ASCII",
    ],
)
def test_a_damaged_file_is_one_clear_error(file, damage, message):
    file.write_text(damage(file.read_text()), encoding="utf-8")
    with pytest.raises(FileError, match=message):
        read_step(file, 1.0)


@pytest.mark.parametrize(
    ("entity", "damage"),
    [
        (r"(?:CIRCLE|CYLINDRICAL_SURFACE)\('',#\d+,([\d.]+)\)", lambda radius: repr(float(radius) + 1e-5)),
        (r"CARTESIAN_POINT\('',\((2\.|5\.),0\.,[03]\.\)\)", lambda x: repr(float(x) + 1e-5)),
        (r"FACE_BOUND\('',#\d+,(\.[TF]\.)\)", lambda way: {".T.": ".F.", ".F.": ".T."}[way]),
        (r"ADVANCED_FACE\([^;]*,(\.[TF]\.)\)", lambda way: {".T.": ".F.", ".F.": ".T."}[way]),
    ],
    ids=["radius", "corner", "way round", "inside out"],
)
def test_the_kernel_mends_nothing_before_it_judges(tmp_path, entity, damage):
    sound = step_bytes(washer()).decode()
    path = tmp_path / "washer.step"
    path.write_text(sound)
    assert read_part(path).valid
    found = list(re.finditer(entity, sound))
    for one in found:
        path.write_text(sound[: one.start(1)] + damage(one[1]) + sound[one.end(1) :])
        assert not read_part(path).valid, one[0]
    print(f"{len(found)} files, each with one fault, are refused")
    assert len(found) >= 4


def test_a_missing_file_is_one_clear_error(tmp_path):
    with pytest.raises(FileError, match=r"cannot read none\.step"):
        read_step(tmp_path / "none.step", 1.0)
