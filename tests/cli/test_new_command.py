"""`cadgen new`: a design that loads, from flags and from points, and nothing written over."""

import errno
import os
import tomllib

import ezdxf
import pytest
from click.testing import CliRunner

from cadgen import Design, writing
from cadgen.cli import cli
from cadgen.design.load import load_design
from cadgen.errors import CadgenError, FileError


def new(tmp_path, *arguments):
    return CliRunner().invoke(cli, ["new", *arguments, "--out", str(tmp_path)])


def test_a_new_design_loads_and_its_comments_say_what_its_keys_are(tmp_path):
    done = new(tmp_path, "my_car")
    assert done.exit_code == 0, done.output
    text = (tmp_path / "my_car.toml").read_text()
    assert text.count("#") > 30
    assert load_design(tmp_path / "my_car.toml").course.gates[1].at_mm == (2000.0, 900.0)
    assert isinstance(new(tmp_path, "my_car").exception, CadgenError)  # it is there already
    assert (tmp_path / "my_car.toml").read_text() == text


@pytest.mark.parametrize("step", ["fsync", "open", "replace"])
def test_on_a_full_disk_nothing_is_left(tmp_path, monkeypatch, step):
    """Wherever it runs full: neither half a design, nor the folders that were made for it."""

    def full(*rest, **more):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    (tmp_path / "kept").mkdir()
    with monkeypatch.context() as patch:
        if step == "open":
            patch.setattr(writing, "open", full, raising=False)
        else:
            patch.setattr(os, step, full)
        for folder in (tmp_path / "kept", tmp_path / "made" / "too"):
            error = new(folder, "my_car").exception
            assert isinstance(error, FileError)
            assert str(error) == (
                f"{folder}/my_car.toml cannot be written (No space left on device): choose another place"
            )
    assert [file.name for file in tmp_path.rglob("*")] == ["kept"]
    assert new(tmp_path / "kept", "my_car").exit_code == 0
    assert [file.name for file in (tmp_path / "kept").iterdir()] == ["my_car.toml"]


def test_what_is_commented_out_loads_too(tmp_path):
    """Every key of the template, with its remark sign taken off."""
    new(tmp_path, "c")
    lines = (tmp_path / "c.toml").read_text().splitlines()
    opened = [line.removeprefix("# ") if "=" in line or "[" in line else line for line in lines]
    values = tomllib.loads("\n".join(opened))
    assert {"posts", "walls"} <= set(values["course"])
    assert {"drive_wheel_radius_mm", "outline"} <= set(values["car"])
    (tmp_path / "open.toml").write_text("\n".join(opened))
    design = load_design(tmp_path / "open.toml")
    assert design.cam.side == "right"
    assert design.train is not None


def test_points_become_waypoints_and_gates_by_their_weights(tmp_path):
    (tmp_path / "p.txt").write_text("0 0\n1500 200 2\n2600 1200 0\n4000 1500\n")
    done = new(
        tmp_path, "p", "--points", str(tmp_path / "p.txt"), "--field-mm", "5000", "4000", "--gate-radius-mm", "80",
        "--set", "car.drive_wheel_offset_mm=-37", "--set", "car.idle_wheel_offset_mm=-201", "--set", "cam.side=right",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    design = load_design(tmp_path / "p.toml")
    assert len(design.path.waypoints_mm) == 4
    assert [(gate.at_mm, gate.radius_mm) for gate in design.course.gates] == [
        ((0.0, 0.0), 80.0),
        ((1500.0, 200.0), 40.0),
        ((4000.0, 1500.0), 80.0),
    ]
    assert design.path.offset_mm == -119.0
    assert design.course.field.size_mm == (5000.0, 4000.0)


def test_a_lap_goes_on_from_its_last_point_to_its_first(tmp_path):
    """The example, a file that ends with its first point, and a closed polyline of a DXF; an open one is none."""
    assert new(tmp_path, "eight", "--closed").exit_code == 0
    text = (tmp_path / "eight.toml").read_text()
    assert "blend_deg" not in text
    cam = Design.load(tmp_path / "eight.toml").cam("actual")
    assert cam.passed
    gates = next(check for check in cam.checks if check.code == "course-gates")
    assert gates.value == 10 * 8  # ten laps of eight gates
    corners = [(0, 0), (2000, 200), (2600, 2000), (300, 1800)]
    (tmp_path / "p.csv").write_text("".join(f"{x},{y}\n" for x, y in [*corners, corners[0]]))
    drawing = ezdxf.new(units=4)
    drawing.modelspace().add_lwpolyline(corners, close=True)
    drawing.saveas(tmp_path / "p.dxf")
    for suffix in ("csv", "dxf"):
        done = new(tmp_path, suffix, "--closed", "--points", str(tmp_path / f"p.{suffix}"))
        assert done.exit_code == 1  # a lap needs five points
        design = load_design(tmp_path / f"{suffix}.toml")
        assert design.path.closed
        assert design.path.waypoints_mm == tuple(map(tuple, corners))
        assert len(design.course.gates) == 4
    refused = new(tmp_path, "open", "--points", str(tmp_path / "p.dxf")).exception
    assert str(refused) == "p.dxf has no open polyline, but one that is closed: open it, or give --closed for a lap"


def test_a_cam_by_its_motion_begins_ready_and_what_is_commented_out_loads_too(tmp_path):
    done = new(tmp_path, "feeder", "--motion", "--set", "follower.radius_mm=9")
    assert done.exit_code == 0, done.output
    text = (tmp_path / "feeder.toml").read_text()
    cam = Design.load(tmp_path / "feeder.toml").cam()
    assert (cam.verdict.readiness.value, cam.follower_as_built.radius) == ("ready", 9.0)
    keys = [line[2:] for line in text.splitlines() if line.startswith("# ") and "=" in line and "closure" not in line]
    more = text.replace("# [dynamics]", "[dynamics]")
    for key in keys:
        more = more.replace(f"# {key}", key)
    assert Design.from_toml(more).cam().application.forces(cam) is not None


def test_a_lift_table_begins_a_cam_in_another_folder(tmp_path):
    rows = [(k, 10 * (10 * u**3 - 15 * u**4 + 6 * u**5)) for k in range(0, 360, 2) for u in [min(k, 360 - k) / 180]]
    (tmp_path / "lobe.csv").write_text("angle,lift\n" + "".join(f"{k},{lift:.6f}\n" for k, lift in rows))
    done = CliRunner().invoke(
        cli, ["new", "lobe", "--table", str(tmp_path / "lobe.csv"), "--out", str(tmp_path / "designs")]
    )
    assert done.exit_code == 0, done.output
    assert 'table = "../lobe.csv"' in (tmp_path / "designs" / "lobe.toml").read_text()
    cam = Design.load(tmp_path / "designs" / "lobe.toml").cam()
    assert float(cam.lift(3.141592653589793)) == pytest.approx(10.0, abs=1e-3)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--motion", "--closed"), "has no path"),
        (("--table", "absent.csv"), "there is no such file"),
        (("--motion", "--set", "follower.radius_mm=-1"), "follower.radius_mm"),
    ],
)
def test_a_motion_that_cannot_be_is_refused(arguments, said, tmp_path):
    error = new(tmp_path, "x", *arguments).exception
    assert isinstance(error, CadgenError)
    assert said in str(error)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("arguments", [("con",), ("a b",), ("x", "--layer", "A"), ("x", "--set", "car.wheelbase=3")])
def test_what_cannot_be_is_refused_and_nothing_written(arguments, tmp_path):
    assert isinstance(new(tmp_path, *arguments).exception, CadgenError)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("size", [("3000", "3000"), ("1525", "1370"), ("7000", "2000"), ("9000", "9000")])
@pytest.mark.parametrize("closed", [(), ("--closed",)])
def test_gates_of_the_example_lie_within_the_field(tmp_path, size, closed):
    done = new(tmp_path, "f", "--field-mm", *size, *closed)
    assert done.exit_code == 0, done.output
    design = load_design(tmp_path / "f.toml")
    places = [gate.at_mm for gate in design.course.gates] + list(design.path.waypoints_mm)
    assert all(0 < x < float(size[0]) and 0 < y < float(size[1]) for x, y in places)


def test_points_in_metres_are_refused_in_one_sentence(tmp_path):
    (tmp_path / "p.txt").write_text("0 0\n0.5 0.4\n1.2 0.9\n2.0 0.3\n")
    refused = str(new(tmp_path, "small", "--points", str(tmp_path / "p.txt")).exception)
    assert refused.startswith("the points lie within 2 mm, and the car has a wheelbase of 167 mm: give them in mm")
    assert not (tmp_path / "small.toml").exists()
    (tmp_path / "p.txt").write_text("0 0\n500 400\n1200 900\n2000 300\n")
    assert new(tmp_path, "large", "--points", str(tmp_path / "p.txt")).exit_code == 0


@pytest.mark.parametrize("encoding", ["gb18030", "utf-16", "cp1252"])
def test_points_are_read_in_the_encodings_in_which_tables_are(tmp_path, encoding):
    remark = "Höhe" if encoding == "cp1252" else "点"
    (tmp_path / "p.csv").write_text(f"# {remark}\n500,700\n2000,900\n3100,1900\n4500,2200\n", encoding=encoding)
    assert new(tmp_path, "p", "--points", str(tmp_path / "p.csv")).exit_code == 0
    assert load_design(tmp_path / "p.toml").path.waypoints_mm[3] == (4500.0, 2200.0)


def test_what_is_wrong_with_a_file_is_said_of_that_file_and_not_of_the_design_that_is_not_there(tmp_path):
    """The folder, the line that lies beyond any path, the table with too few rows, and the key of a flag."""
    (tmp_path / "far.csv").write_text("0,0\n1e9,0\n1e9,1e9\n0,1e9\n")
    (tmp_path / "few.csv").write_text("0,0\n")
    for arguments, said in (
        (("--points", str(tmp_path)), f"{tmp_path} is a folder: give a file of points in it"),
        (("--points", str(tmp_path / "far.csv")), "far.csv, line 2: the point lies 1e+09 mm from the origin"),
        (("--table", str(tmp_path / "few.csv")), f"motion.table, {tmp_path / 'few.csv'}, has one row; it needs"),
        (("--set", "car.wheelbase_mm=-3"), "car.wheelbase_mm is -3; it must be"),
    ):
        assert str(new(tmp_path, "x", *arguments).exception).startswith(said)


def test_a_path_that_cannot_be_driven_is_said_by_the_last_line_in_the_words_of_check(tmp_path):
    (tmp_path / "p.csv").write_text("500,700\n2000,900\n3100,1900\n2000,900\n500,700\n")
    done = new(tmp_path, "back", "--points", str(tmp_path / "p.csv"))
    assert done.exit_code == 1
    with pytest.raises(CadgenError) as refused:
        Design.load(tmp_path / "back.toml").cam()
    said = f"FAIL: {tmp_path}/back.toml begins the design, but {refused.value}"
    assert "".join(done.output.split()) == said.replace(" ", "")


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ((), False),
        (("car.wheelbase_mm=150",), True),
        (("car.wheelbase_mm=150", "car.outline.wheel_diameter_mm=60"), False),
        (("car.wheelbase_mm=150", "car.outline="), False),
        (("car.max_steering_angle_deg=30",), False),
    ],
)
def test_an_outline_that_is_the_papers_is_named_where_the_sizes_of_the_car_are_given(tmp_path, changes, said):
    done = new(tmp_path, "c", *(word for change in changes for word in ("--set", change)))
    line = "Taken from the paper's car: car.outline, 290 mm long and 260 mm wide, with a wheel of 128 mm."
    assert (line in " ".join(done.output.split())) == said, done.output
