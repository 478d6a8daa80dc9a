"""Misuse by a newcomer, and uses of the objects besides reading them: refused in one sentence, or it works."""

import copy
import json
import pickle
from dataclasses import replace
from math import degrees, inf, nan, pi
from pathlib import Path

import numpy as np
import pytest

import cadgen
from cadgen import (
    Cam,
    Design,
    Gear,
    GearPair,
    Measured,
    Motion,
    Report,
    Roller,
    Train,
    Written,
    draw,
    merge,
    rise,
    verify,
)
from cadgen.design.file_names import name_fault, usable_name
from cadgen.design.keys import tables
from cadgen.design.load import packaged_designs
from cadgen.errors import DesignError, FileError
from cadgen.parts.features import Hub, Keyway, Lightening, Web

GEAR = Gear(teeth=18, module=1.0, width=8.0)
PAIR = GearPair(GEAR, GEAR, backlash=0.1)

REFUSED = {
    "a number as design": (lambda car: Design.load(3), "source is 3; it must be the name of a design or the path"),
    "bytes as design": (lambda car: Design.load(b"x"), "source is b'x'"),
    "a name that no system has": (lambda car: Design.load("a" * 5000), "there is no packaged design"),
    "a number as text": (lambda car: Design.from_toml(3), "text is 3; it must be a text"),
    "no changes": (lambda car: car.with_(None), "the changes are None; give keys with their values"),
    "a key that is none": (lambda car: car.with_({3: 4}), "3 is no key; write it as in the design file"),
    # Either was read as another key, with the rest of it as the value.
    "a key with a value": (lambda car: car.with_({"cam.thickness_mm=3 #": 4}), "'cam.thickness_mm=3 #' is no key"),
    "a key with a line": (lambda car: car.with_({"cam.thickness_mm\n": 4}), "is no key"),
    "half a sign": (lambda car: car.with_({"name": "\ud800"}), "which is no text in UTF-8"),
    "a list as profile": (lambda car: car.cam(["actual"]), "there is no profile"),
    "samples as float": (lambda car: car.tolerance(1e4), "samples is 10000.0; it must be a whole number"),
    "columns that are none": (lambda car: car.calibrate(Measured(None)), "columns is None; it must map names"),
    "a list of tolerances": (lambda car: replace(GEAR, tolerances=[1, 2]), "tolerances is [1, 2]; it must map symbols"),
    "a huge module": (lambda car: replace(GEAR, module=10**400), "module is 1000"),
    "a number as directions": (lambda car: Train([PAIR], directions=3), "directions is 3; it must have 1 angles"),
    "a number as formats": (lambda car: GEAR.write("x", 3), "formats is 3; it must name step, stl, 3mf or dxf"),
    "bytes as formats": (lambda car: GEAR.write("x", b"stl"), "formats is b'stl'; it must name step, stl, 3mf or dxf"),
    "a folder that no system has": (lambda car: GEAR.write("a\0b"), "folder is 'a\\x00b'; it must be a path"),
    "a folder that is a file": (lambda car: GEAR.write(__file__, "stl"), "a file stands where the folder must go"),
    "a module beyond the design file's": (
        lambda car: replace(GEAR, module=1e9),
        "module is 1e+09; it must be a number, greater than 0 and at most 10 mm",
    ),
    "a rack without a tip": (lambda car: replace(GEAR, rack_tip_radius=0), "rack_tip_radius is 0; it must be a number"),
    "a pressure angle in degrees": (
        lambda car: replace(GEAR, pressure_angle=20.0),
        "rad, and 20 looks like degrees: give radians(20)",
    ),
    "a keyway's angle in degrees": (
        lambda car: replace(GEAR, bore=5, keyway=Keyway(width=2.0, depth=1.0, angle=90)),
        "keyway.angle is 90; it must be a number from -6.283185307 to 6.283185307 rad, and 90 looks like degrees",
    ),
    "a pressure angle beyond degrees": (
        lambda car: replace(GEAR, pressure_angle=2000.0),
        "pressure_angle is 2000; it must be a number from 0.1745329252 to 0.6108652382 rad",
    ),
    "a key that is empty": (lambda car: car.with_({"": 4}), "=4: write the key as in the design file, such as cam."),
    "half a hole": (
        lambda car: replace(GEAR, lightening=Lightening(count=2.5, hole_diameter=1.0)),
        "lightening.count is 2.5; it must be a whole number from 1 to 360",
    ),
    "a keyway of no width": (
        lambda car: replace(GEAR, bore=5, keyway=Keyway(width=float("nan"), depth=1.0)),
        "keyway.width is nan; it must be a number from 0.01 to 100 mm",
    ),
    "axes kilometres apart": (lambda car: replace(PAIR, centre_distance=1e6), "at most 2000 mm"),
    "eight stages": (lambda car: Train([PAIR] * 8), "stages has 8 pairs; it must have at most 7"),
    "a lift at no angle": (lambda car: car.cam(profile="actual").lift(nan), "cam_angle holds nan; all its numbers"),
    "a lift without end": (lambda car: car.cam(profile="actual").lift([0, inf]), "cam_angle holds inf"),
    "a lift at a word": (lambda car: car.cam(profile="actual").lift("a"), "cam_angle is 'a'; it must be a number or"),
    "a device as name": (lambda car: replace(GEAR, name="Nul.x"), "on Windows Nul is a device"),
    "a name that ends in a dot": (lambda car: replace(GEAR, name="gear."), "it must not end in a dot"),
    "a design named after a device": (lambda car: car.with_({"name": "com1"}), "on Windows com1 is a device"),
    "no trial runs": (lambda car: car.adjust(None), "trials is None; it must be the path of a file, or several"),
    "trial runs as a number": (lambda car: car.adjust(3), "trials is 3; it must be the path of a file"),
    "a setting as a number": (lambda car: car.adjust("a.csv", settings=3), "settings is 3; it must be several"),
    "a path to improve as a name": (lambda car: car.plan("carbon_free_car"), "it must be a Design"),
    "a calm path as a name": (lambda car: car.plan(calm_as="x"), "calm_as is 'x'; it must be a Design"),
    "a report on a name": (
        lambda car: Report.of("carbon_free_car"),
        "design is 'carbon_free_car'; it must be a Design",
    ),
    "a drawing of a number": (lambda car: draw("out", cam=3), "cam is 3; it must be a Cam"),
    "a drawing of a design's values": (lambda car: draw("out", train=car), "it must be a GearTrain"),
    "a new design's name as a number": (lambda car: Design.new(3), "name is 3; it must be a text"),
    "a new field of one side": (lambda car: Design.new("a", field_mm=(1000,)), "it must be width and height, mm"),
    "a new field of words": (lambda car: Design.new("a", field_mm="ab"), "field_mm is 'ab'; it must be width and"),
    "new gates of a word": (lambda car: Design.new("a", gate_radius_mm="50"), "gate_radius_mm is '50'; it must be a"),
    "new gates turned inside out": (lambda car: Design.new("a", gate_radius_mm=-5), "gate_radius_mm is -5; it must"),
    "a new design nowhere": (lambda car: Design.new("a", None), "folder is None; it must be a path"),
    "points of a number": (lambda car: Design.new("a", points=3), "points is 3; it must be the path of a file"),
    "no columns": (lambda car: Measured(None), "columns is None; it must map names with units to values"),
    "shards as a text": (lambda car: merge("folder"), "folders is 'folder'; it must be several"),
    "shards as nothing": (lambda car: merge(None), "folders is None; it must be several"),
    # Both gave numbers out of memory that nobody had written.
    "a map of nothing": (lambda car: car.tolerance(10, map=lambda work, numbers: []), "the results of 0 of 10 cars"),
    "a map of too much": (
        lambda car: car.tolerance(10, map=lambda work, numbers: 2 * list(map(work, numbers))),
        "map gave something else than its function, after 10 cars",
    ),
}


@pytest.fixture(scope="module")
def car():
    return Design.load("carbon_free_car")


@pytest.mark.slow
@pytest.mark.parametrize("case", REFUSED)
def test_what_is_misunderstood_is_refused_in_one_sentence(car, tmp_path, monkeypatch, case):
    monkeypatch.chdir(tmp_path)
    call, said = REFUSED[case]
    with pytest.raises((DesignError, FileError)) as refusal:
        call(car)
    assert said in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_objects_are_shown_in_a_line_and_can_be_compared(car):
    """In a notebook, whose last line is shown; arrays inside made two cams of one design no question to ask."""
    cam = car.cam(profile="actual")
    shown = {
        repr(car): "<Design carbon_free_car of carbon_free_car.toml>",
        repr(
            car.with_({"cam.thickness_mm": 4})
        ): "<Design carbon_free_car of carbon_free_car.toml, changed by cam.thickness_mm=4>",
        repr(cam): "<Cam of carbon_free_car, actual profile, not ready: cars that keep the course>",
        repr(cam.profile): f"<Profile actual of carbon_free_car, {cam.profile.length:.1f} mm long>",
        repr(cam.lift): f"<Lift of carbon_free_car, {len(cam.lift.peaks)} peaks and {len(cam.lift.valleys)} valleys>",
        repr(Measured({"x_mm": np.zeros(999), "y_mm": np.zeros(999)}, name="mine")): "<Measured mine: x_mm, y_mm>",
    }
    for text, wanted in shown.items():
        assert text == wanted
    assert cam == cam
    assert cam != car.cam(profile="actual")
    assert len({cam, cam}) == 1


def test_errors_are_caught_by_the_package_s_own_names():
    """`import cadgen` alone has no `cadgen.errors` yet."""
    with pytest.raises(cadgen.CadgenError):
        Design.load("no_such_car")
    for name in ("CheckError", "DesignError", "FileError"):
        assert name in cadgen.__all__
        assert issubclass(getattr(cadgen, name), cadgen.CadgenError)


def test_what_was_written_can_be_copied_and_sent_to_another_process(tmp_path):
    written = GEAR.write(tmp_path, "stl")
    for again in (pickle.loads(pickle.dumps(written)), copy.deepcopy(written)):
        assert isinstance(again, Written)
        assert again == written
        assert again[0].facts == written[0].facts
        with pytest.raises(TypeError):
            again.entry["x"] = 1
        with pytest.raises(TypeError):
            again[0].facts["x"] = 1
        with pytest.raises(TypeError):
            again.entry["files"]["gear.stl"]["bytes"] = 1
    assert json.loads(json.dumps(written.entry))["files"].keys() == {"gear.stl"}
    assert hash(written) == hash(copy.deepcopy(written))
    assert repr(written) == f"<Written to {tmp_path}: gear.stl>"
    assert verify(tmp_path).is_true


def test_a_gear_does_not_change_with_the_mapping_it_was_made_of():
    given = {"f_pt": 0.01}
    gear = replace(GEAR, tolerances=given)
    given["f_pt"] = 0.02
    assert gear.tolerances == {"f_pt": 0.01}
    assert {gear: 1}[pickle.loads(pickle.dumps(gear))] == 1
    for change in (gear.tolerances.clear, lambda: gear.tolerances.update(f_pt=1)):
        with pytest.raises(TypeError, match="cannot be changed"):
            change()


def test_the_folder_that_cannot_be_written_is_the_argument(tmp_path):
    """There is no `--out` in a program."""
    with pytest.raises(FileError) as refusal:
        GEAR.write(tmp_path / ("x" * 300), "stl")
    assert "--" not in str(refusal.value)
    with pytest.raises(FileError, match=r"choose another folder$"):
        GEAR.write(__file__, "stl")


def web(thickness, rim):
    return Web(thickness=thickness, rim_thickness=rim)


# Argument -> key of the design file, what an argument of 1 is in the key's unit, and a gear with that argument.
BOUNDED = {
    "module": ("train.module_mm", 1, lambda x: replace(GEAR, module=x)),
    "width": ("train.width_mm", 1, lambda x: replace(GEAR, width=x)),
    "pressure_angle": ("train.pressure_angle_deg", degrees(1), lambda x: replace(GEAR, pressure_angle=x)),
    "profile_shift": ("train.stages.driver.profile_shift", 1, lambda x: replace(GEAR, profile_shift=x)),
    "bore": ("train.drive.bore_diameter_mm", 1, lambda x: replace(GEAR, bore=x)),
    "tip_chamfer": ("train.tip_chamfer_mm", 1, lambda x: replace(GEAR, tip_chamfer=x)),
    "addendum": ("train.addendum_factor", 1, lambda x: replace(GEAR, addendum=x)),
    "dedendum": ("train.dedendum_factor", 1, lambda x: replace(GEAR, dedendum=x)),
    "rack_tip_radius": ("train.rack_tip_radius_factor", 1, lambda x: replace(GEAR, rack_tip_radius=x)),
    "thickness_deviation": ("train.E_sn_um", 1e3, lambda x: replace(GEAR, thickness_deviation=x)),
    "teeth": ("train.stages.driver.teeth", 1, lambda x: replace(GEAR, teeth=int(x))),
    "grade": ("train.grade", 1, lambda x: replace(GEAR, grade=int(x))),
    "hub.diameter": ("train.drive.hub.diameter_mm", 1, lambda x: replace(GEAR, hub=Hub(diameter=x))),
    "hub.length": ("train.drive.hub.length_mm", 1, lambda x: replace(GEAR, hub=Hub(diameter=9, length=x))),
    "keyway.width": ("train.drive.keyway.width_mm", 1, lambda x: replace(GEAR, keyway=Keyway(width=x, depth=1))),
    "keyway.depth": ("train.drive.keyway.depth_mm", 1, lambda x: replace(GEAR, keyway=Keyway(width=1, depth=x))),
    "web.thickness": (
        "train.drive.web.thickness_mm",
        1,
        lambda x: replace(GEAR, web=Web(thickness=x, rim_thickness=1)),
    ),
    "web.rim_thickness": ("train.drive.web.rim_mm", 1, lambda x: replace(GEAR, web=Web(thickness=1, rim_thickness=x))),
    "lightening.count": (
        "train.drive.lightening.holes",
        1,
        lambda x: replace(GEAR, lightening=Lightening(count=int(x), hole_diameter=1)),
    ),
    "centre_distance": ("train.stages.centre_distance_mm", 1, lambda x: replace(PAIR, centre_distance=x)),
    "bearing_span": ("train.bearing_span_mm", 1, lambda x: replace(PAIR, bearing_span=x)),
    "clearance": ("train.clearance_mm", 1, lambda x: Train([PAIR], clearance=x)),
}


@pytest.mark.parametrize("argument", BOUNDED)
def test_arguments_are_bounded_as_the_keys_of_the_design_file(argument):
    name, unit, made = BOUNDED[argument]
    allowed = next(key for table in tables().values() for key in table.keys if key.name == name).allowed
    words = allowed.removeprefix("0, or ").replace(" and ", ", ").split(", ")
    least, most = (float(part.split()[-1]) / unit for part in words)
    outside = [least if words[0].startswith("greater") else least - 1, most + 1]
    outside += [1e-9] if allowed.startswith("0, or") else []
    for value in outside:
        with pytest.raises(DesignError, match=rf"^{argument} is .*; it must be"):
            made(value)


def test_of_a_cam_without_a_design_file_no_file_is_named():
    motion = Motion([rise(5, pi), rise(-5, pi)])
    for radius, name, said in (
        (-9, "cam", "follower.radius_mm is -9; it must be"),
        (9, "a/b", 'name is "a/b"; it must'),
    ):
        with pytest.raises(DesignError, match=f"^{said}"):
            Cam(motion, Roller(radius=radius), base_circle_radius=40, thickness=5, name=name)


def test_a_law_that_is_none_is_refused_where_it_is_written():
    with pytest.raises(DesignError, match=r"^law is 'cycloid': did you mean cycloidal"):
        rise(5, pi, "cycloid")
    with pytest.raises(DesignError, match=r"^law is 'xyzzy'; it must be one of "):
        rise(5, pi, "xyzzy")


def test_names_that_windows_cannot_have():
    for name in ("con", "PRN", "Aux.1", "nul.step", "COM0", "LPT³", "lpt9.x", "car.", "a..", "", ".a", "a/b", "a" * 65):
        assert name_fault(name)
        assert not name_fault(usable_name(name))
    for name in ("console", "com", "com10", "a.con", "1", "car.v2"):
        assert not name_fault(name)
        assert usable_name(name) == name


def test_refused_changes_of_a_program_name_the_key_and_no_option(car):
    changed, file = car.with_({"cam.thickness_mm": 3.2}), car.values.source
    for changes, head in (
        ({"cam.thickness_mm": 0}, "cam.thickness_mm=0: cam.thickness_mm is 0; it must be"),
        ({"cam.thicknes_mm": 3}, "cam.thicknes_mm=3: cam.thicknes_mm is not a key"),
        ({"cam.base_radius_mm": 1}, f"{file} with cam.thickness_mm=3.2 cam.base_radius_mm=1: "),
        ({"name": None, "cam.thickness_mm": []}, "cam.thickness_mm=[]: "),
    ):
        with pytest.raises(DesignError) as refused:
            changed.with_(changes)
        assert str(refused.value).startswith(head)
        assert "--set" not in str(refused.value)
    with pytest.raises(DesignError, match=r"^--set cam\.thickness_mm=0: "):  # as the command line has it
        changed.with_(["cam.thickness_mm=0"])


@pytest.mark.parametrize("name", [*packaged_designs(), "train alone"])
def test_a_design_comes_back_from_pickle(name):
    if name == "train alone":
        design = Design.load(Path(__file__).parents[1] / "data/gears/onlytrain.toml", train_only=True)
    else:
        design = Design.load(name, {"name": "other"})
    for again in (pickle.loads(pickle.dumps(design)), copy.deepcopy(design)):
        assert again == design
        assert type(again.values) is type(design.values)
        assert (again.sha256, again.values.overrides) == (design.sha256, design.values.overrides)


@pytest.mark.long
@pytest.mark.slow
def test_a_cam_comes_back_from_pickle_and_writes_the_same_files(tmp_path, car):
    for number, cam in enumerate((car.cam("actual"), car.cam("optimized"))):
        again = pickle.loads(pickle.dumps(cam))
        assert repr(again) == repr(cam)
        assert again.entry().json() == cam.entry().json()
        here, there = tmp_path / f"{number}a", tmp_path / f"{number}b"
        cam.write(here, "dxf,csv")
        again.write(there, "dxf,csv")
        assert {file.name: file.read_bytes() for file in here.iterdir()} == {
            file.name: file.read_bytes() for file in there.iterdir()
        }
