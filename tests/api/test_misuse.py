"""What a newcomer does wrong, or does with the objects besides reading them: refused in one sentence, or it works."""

import copy
import pickle
from dataclasses import replace

import numpy as np
import pytest

import cadgen
from cadgen import Design, Gear, GearPair, Measured, Train, verify
from cadgen.api.files import Written
from cadgen.errors import DesignError, FileError

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
    "a number as formats": (lambda car: GEAR.write("x", 3), "formats is 3; it must name step or stl"),
    "bytes as formats": (lambda car: GEAR.write("x", b"stl"), "formats is b'stl'; it must name step or stl"),
    "a folder that no system has": (lambda car: GEAR.write("a\0b"), "folder is 'a\\x00b'; it must be a path"),
    "a folder that is a file": (lambda car: GEAR.write(__file__, "stl"), "a file stands where the folder must go"),
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


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_misunderstood_is_refused_in_one_sentence(car, tmp_path, monkeypatch, case):
    monkeypatch.chdir(tmp_path)
    call, said = REFUSED[case]
    with pytest.raises((DesignError, FileError)) as refusal:
        call(car)
    assert said in str(refusal.value)
    assert len(str(refusal.value).splitlines()) == 1
    assert not list(tmp_path.iterdir())


def test_objects_are_shown_in_a_line_and_can_be_compared(car):
    """In a notebook, whose last line is shown; arrays inside made two cams of one design no question to ask."""
    cam = car.cam(profile="actual")
    shown = {
        repr(car): "<Design carbon_free_car of carbon_free_car.toml>",
        repr(
            car.with_({"cam.thickness_mm": 4})
        ): "<Design carbon_free_car of carbon_free_car.toml, changed by cam.thickness_mm=4>",
        repr(cam): "<Cam of carbon_free_car, actual profile, passed>",
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
    assert repr(written) == f"<Written to {tmp_path}: gear.stl>"
    assert verify(tmp_path).is_true
