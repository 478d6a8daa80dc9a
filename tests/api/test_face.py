"""The face: values in, objects out; one sentence where something is wrong, and not a word printed."""

import json
import subprocess
import sys
from dataclasses import replace
from math import degrees, radians

import numpy as np
import pytest

import cadgen
from cadgen import Design, Gear, GearPair, Hub, Train, verify
from cadgen.api.loaded import overrides_of
from cadgen.api.values import map_of
from cadgen.design.load import load_design
from cadgen.errors import CheckError, DesignError, FileError

PINION = Gear(teeth=18, module=1.0, width=8.0)
WHEEL = Gear(teeth=45, module=1.0, width=8.0)


@pytest.fixture(scope="module")
def car():
    return Design.load("carbon_free_car")


@pytest.fixture(scope="module")
def cam(car):
    """Of the paper's car; its walls are said to be too thin."""
    return car.with_({"checks.min_wall_mm": 50}).cam(profile="actual")


def test_importing_cadgen_imports_nothing_else():
    script = (
        "import sys, json; before = set(sys.modules); import cadgen; assert 'Design' in dir(cadgen); "
        "print(json.dumps(sorted(set(sys.modules) - before)))"
    )
    out = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    assert json.loads(out) == ["cadgen", "cadgen.version"]


def test_every_public_name_is_there():
    for name in cadgen.__all__:
        assert getattr(cadgen, name).__doc__ or name == "__version__"
        assert name in dir(cadgen)
    with pytest.raises(AttributeError, match="has no attribute 'Desing'"):
        cadgen.Desing  # noqa: B018


CHANGES = [
    ({"cam.thickness_mm": 3.2}, ["cam.thickness_mm=3.2"]),
    ({"path.waypoints_mm.3": [1000, 250.5]}, ["path.waypoints_mm.3=[1000, 250.5]"]),
    ({"path.spline": "cubic"}, ["path.spline=cubic"]),
    ({"blank.keyway": None, "cam.thickness_mm": np.float64(3.0)}, ["blank.keyway=", "cam.thickness_mm=3.0"]),
    ({"train.stages.1.driver": {"teeth": 31}, "train.stages.1.centre_distance_mm": 45.25}, None),
]


@pytest.mark.parametrize(("changes", "texts"), CHANGES)
def test_changes_are_those_of_the_command_line(car, changes, texts):
    changed = car.with_(changes)
    given = overrides_of(changes) if texts is None else texts
    assert changed.values.values() == load_design("carbon_free_car", given).values()
    assert Design.load("carbon_free_car", changes).sha256 == changed.sha256 != car.sha256
    assert changed.with_({}).values == changed.values


WRONG = [
    {"cam.thickness_mm": -1},
    {"cam.thicknes_mm": 3},
    {"cam.thickness_mm": "thick"},
    {"path.waypoints_mm.99": [0, 0]},
    {"follower.radius_mm": float("nan")},
    {"cam": None},
]


@pytest.mark.parametrize("changes", WRONG)
def test_what_is_wrong_is_said_as_on_the_command_line(car, capfd, changes):
    with pytest.raises(DesignError) as here:
        car.with_(changes)
    with pytest.raises(DesignError) as there:
        load_design("carbon_free_car", overrides_of(changes))
    assert str(here.value) == str(there.value)
    assert capfd.readouterr() == ("", "")


REFUSED = {
    "a design": (lambda car: Design.load("no_such_car"), "there is no packaged design"),
    "a profile": (lambda car: car.cam(profile="best"), 'there is no profile "best"'),
    "an order": (lambda car: car.gears(order="shuffled"), "order is 'shuffled'; it must be one of as-given, reordered"),
    "play": (lambda car: car.simulate(play_deg=-1), "play_deg is -1; it must be a number from 0 to 180 degrees"),
    "samples": (lambda car: car.tolerance(0), "samples is 0; it must be a whole number from 1 to 10000000"),
    "a map": (lambda car: car.tolerance(5, map=3), "map is 3; it must be a function"),
    "a form error": (
        lambda car: car.calibrate("x.csv", form_error_um=0),
        "form_error_um is 0; it must be a number from 0.01",
    ),
    "no data": (lambda car: car.calibrate([]), "data is []; give at least one CSV file"),
    "data": (lambda car: car.calibrate([3.0]), "data has 3.0; each must be a path"),
    "columns": (lambda car: car.calibrate({"x_mm": [1, 2], "y_mm": [1]}), "every column must be one row of as many"),
    "a value": (lambda car: car.with_({"cam.thickness_mm": object()}), "is given a object; a value must be a number"),
    "changes": (lambda car: car.with_("cam.thickness_mm=3"), "give keys with their values"),
    "teeth": (lambda car: replace(PINION, teeth=3), "teeth is 3; it must be a whole number from 4 to 1000"),
    "a module": (lambda car: replace(PINION, module="1"), "module is '1'; it must be a number"),
    "a width": (
        lambda car: replace(PINION, width=-1.0),
        "width is -1; it must be a number from 0.01 to 500 mm",
    ),
    "a bore": (lambda car: replace(PINION, bore=16.0).part, "has a bore that reaches to 16 mm"),
    "a hub": (lambda car: replace(PINION, hub=3), "hub is 3; it must be a Hub"),
    "a tolerance": (
        lambda car: replace(PINION, tolerances={"f_x": 1}),
        "symbol of tolerances is 'f_x'; it must be one",
    ),
    "a name": (lambda car: replace(PINION, name="../x"), "it must be 1 to 64 letters"),
    "modules": (lambda car: GearPair(PINION, replace(WHEEL, module=2.0), backlash=0.1), "joins the modules 1 and 2 mm"),
    "no backlash": (lambda car: GearPair(PINION, WHEEL), "backlash is not given; give it in mm, or bearing_span"),
    "axes": (
        lambda car: GearPair(PINION, WHEEL, backlash=0.1, centre_distance=30),
        "jams at the centre distance 30 mm",
    ),
    "no gear": (lambda car: GearPair(PINION, 45, backlash=0.1), "wheel is 45; it must be a Gear"),
    "no stages": (lambda car: Train([]), "stages is []; it must hold at least one GearPair"),
    "a folder": (lambda car: PINION.write(""), "folder is ''; it must be a path"),
    "a format": (lambda car: PINION.write("x", "stp"), 'formats has "stp"; it must name step, stl, 3mf or dxf'),
    "no formats": (lambda car: PINION.write("x", []), "formats is empty"),
    "no folder": (lambda car: verify("no_such_folder"), "there is no folder no_such_folder"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_is_refused_in_one_sentence(car, capfd, tmp_path, monkeypatch, case):
    monkeypatch.chdir(tmp_path)
    call, said = REFUSED[case]
    with pytest.raises((DesignError, FileError)) as refusal:
        call(car)
    assert said in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1
    assert capfd.readouterr() == ("", "")
    assert list(tmp_path.iterdir()) == []


def test_a_design_of_a_train_alone():
    text = Design.load().text
    train = text[text.index("[train]") :].partition("\n[play]")[0]
    alone = Design.from_toml(train, "gears", train_only=True)
    assert (alone.name, alone.with_({"train.grade": 8}).values.train.grade) == ("gears", 8)
    for refused in (lambda: alone.cam(), lambda: Design.from_toml(train, "gears")):
        with pytest.raises(DesignError, match=r"gears\.toml: the sections \[path\], .* are missing"):
            refused()


def test_a_failed_check_refuses_to_write_unless_forced(cam, capfd, tmp_path):
    assert not cam.passed
    with pytest.raises(CheckError, match=r"a check failed.*it must be at least 50 mm.*force=True"):
        cam.write(tmp_path / "out")
    assert not (tmp_path / "out").exists()
    (file,) = cam.write(tmp_path / "out", formats="XYZ", force=True)
    assert file.name == "carbon_free_car_actual.xyz"
    cloud = np.loadtxt(file.path)[:, :2]
    assert np.abs(np.hypot(*cloud.T).max() - np.hypot(*cam.profile.points().T).max()) < 1e-3
    assert verify(tmp_path / "out").is_true
    assert capfd.readouterr() == ("", "")


@pytest.mark.slow
def test_a_cam_is_drawn(cam):
    outline, lift = cam.plot().axes
    assert lift.get_xlabel() == "cam angle (°)"
    drawn = lift.lines[0].get_xydata()
    assert drawn[:, 1] == pytest.approx(cam.lift(np.radians(drawn[:, 0])))
    assert len(outline.patches) == 1 + len(cam.computed.blank.inner_contours())


@pytest.mark.slow
def test_the_gears_of_a_design_are_those_given_by_numbers(car):
    """The paper's train, from the design and from its numbers: one tooth, one return error."""
    made = car.gears()
    keys = car.values.train
    stages = []
    for stage in keys.stages:
        gears = [
            Gear(
                teeth=gear.teeth,
                module=keys.module_mm,
                width=gear.width_mm or keys.width_mm,
                grade=keys.grade,
                tolerances={
                    name: value * 1e-3
                    for name in ("f_pt", "F_beta", "F_r", "b_r", "F_i_radial")
                    if (value := getattr(gear, f"{name}_um")) is not None
                },
            )
            for gear in (stage.driver, stage.driven)
        ]
        stages.append(
            GearPair(
                *gears,
                bearing_span=stage.bearing_span_mm or keys.bearing_span_mm,
                centre_distance=stage.centre_distance_mm,
                centre_distance_deviation=None if stage.f_a_um is None else stage.f_a_um * 1e-3,
            )
        )
    train = Train(stages)
    assert degrees(made.return_error.greatest) == pytest.approx(0.962, abs=5e-4)
    assert train.return_error.greatest == pytest.approx(made.return_error.greatest, rel=1e-12)
    assert train.return_error.least == pytest.approx(made.return_error.least, rel=1e-12)
    assert train.return_error.as_cut == pytest.approx(made.return_error.as_cut, rel=1e-12)
    assert train.ratio == made.ratio
    forms = [form for part in train.computed.layout.parts for form in part.gears]
    assert forms == [form for part in made.computed.layout.parts for form in part.gears]
    assert train.passed
    assert made.passed


def test_the_backlash_is_the_gap_between_teeth_on_the_pitch_circles():
    """s_1 + s_2 + backlash = p_w, the thicknesses read off involutes that are rolled here."""
    for pair in (
        GearPair(PINION, WHEEL, backlash=0.1),
        GearPair(replace(PINION, profile_shift=0.4), WHEEL, backlash=0.03, centre_distance=32.0),
        GearPair(replace(PINION, thickness_deviation=-0.02), WHEEL, backlash=0.2),
    ):
        apart = pair.axes_apart
        space = 2 * np.pi * apart / (18 + 45)
        for gear in (pair.cut.driver.form, pair.cut.driven.form):
            pitch_radius = apart * gear.teeth / 63
            corners = tooth_corners(gear)
            upper = corners[corners.imag > 0]
            order = np.argsort(np.abs(upper))
            half = np.interp(pitch_radius, np.abs(upper)[order], np.angle(upper)[order])
            space -= 2 * half * pitch_radius
        assert space == pytest.approx(pair.backlash, abs=2e-4)
    assert pair.cut.driver.form.tooth_thickness_deviation == pytest.approx(-0.02)


def tooth_corners(form):
    """Points on the flanks of the tooth on x, by rolling a string off the base circle; thickness by its definition."""
    base = form.base_diameter / 2
    roll = np.linspace(0.02, 1.2, 20_000)
    points = base * (1 + 1j * roll) * np.exp(-1j * roll)
    angle = radians(20)
    thickness = np.pi / 2 * form.normal_module + 2 * form.profile_shift * form.normal_module * np.tan(angle)
    thickness += form.tooth_thickness_deviation
    at_reference = np.interp(form.reference_diameter / 2, np.abs(points), np.unwrap(np.angle(points)))
    flank = points * np.exp(-1j * at_reference) * np.exp(1j * thickness / form.reference_diameter)
    return flank[np.abs(flank) < form.tip_diameter / 2 + 1]


@pytest.mark.slow
def test_the_size_of_a_gear_is_named_by_what_it_is_measured_with():
    """Of a helical gear with odd teeth two pins read more than two balls."""
    helical = Gear(teeth=13, module=2, width=20, helix_angle=radians(17))
    names = [gear.entry().json() for gear in (Gear(teeth=13, module=2, width=8), helical)]
    assert {"pin_diameter_mm", "over_pins_mm"} <= set(names[0])
    assert {"ball_diameter_mm", "over_balls_mm"} <= set(names[1])
    assert "over_pins_mm" not in names[1]


def test_gears_and_trains_are_written_and_proved(tmp_path, capfd):
    small = Gear(
        teeth=12, module=1.0, profile_shift=0.3, width=5.0, bore=4.0, hub=Hub(diameter=8.0, length=4.0), name="small"
    )
    (step,) = small.write(tmp_path, "step")
    assert step.path == tmp_path / "small.step"
    assert step.facts["flank_error_um"] < 0.001
    assert step.facts["volume_mm3"] == pytest.approx(small.volume, rel=1e-6)
    pair = GearPair(replace(PINION, teeth=12, profile_shift=0.3), replace(PINION, teeth=18), backlash=0.1)
    train = Train([pair], name="two")
    files = train.write(tmp_path, formats=["step"])
    assert [file.name for file in files] == ["two_train.step", "two_1_pinion.step", "two_2_wheel.step"]
    assert files[0].facts["play_um"] == pytest.approx([100.0], abs=0.1)
    assert train.return_error.as_cut == pytest.approx(0.1 / (pair.axes_apart * 18 / 30))
    compound = train.build123d()
    assert [part.label for part in compound.children] == ["two_1_pinion", "two_2_wheel"]
    assert sum(part.volume for part in train.computed.layout.parts) == pytest.approx(compound.volume, rel=1e-4)
    # Files of another format stand beside those already there, and the manifest lists both.
    small.write(tmp_path, "stl")
    parts = json.loads((tmp_path / "manifest.json").read_text())["parts"]
    assert {name: list(part["files"]) for name, part in parts.items()} == {
        "small_gear_step": ["small.step"],
        "two_train_step": [file.name for file in files],
        "small_gear_stl": ["small.stl"],
    }
    assert verify(tmp_path).is_true
    assert capfd.readouterr() == ("", "")


def test_a_pool_is_anything_with_a_map():
    class Pool:
        map = map

    assert map_of(Pool()) is map
    assert map_of(map) is map
    assert map_of(None) is None
