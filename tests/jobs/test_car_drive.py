"""Drop weight or motor of a car: room, fall, mass, and what is refused."""

import numpy as np
import pytest

from cadgen import Design, DesignError
from cadgen.check import Check, CheckCode, failing
from cadgen.design.load import load_design
from cadgen.jobs.assembly_checks import verdict_on_car
from cadgen.jobs.assembly_files import mounting_notes
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.jobs.car_assembly import parts_in, put_together
from cadgen.jobs.car_frame import CarFrame, car_frame, frame_in
from cadgen.jobs.frame_parts import frame_parts
from cadgen.jobs.gears.gear_train import plan_gears

WEIGHT = "drive={kind='weight', mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=400}"
MOTOR = "drive={kind='motor', mass_kg=0.1, size_mm=[40, 30, 25]}"


def with_drum(drum: float, fall: float = 400) -> str:
    return f"drive={{kind='weight', mass_kg=1.0, size_mm=[50, 50, 65], fall_mm={fall}, drum_mm={drum:g}}}"


def frame_of(*overrides: str) -> CarFrame:
    return car_frame(Design.load("workshop_car", ["mechanics.drive_energy_J=", *overrides]).values)


@pytest.fixture(scope="module")
def weight() -> CarFrame:
    return frame_of(WEIGHT)


def test_a_weight_stands_between_train_and_idle_wheel(weight: CarFrame) -> None:
    assert weight.passed
    frame, site = weight.frame, weight.frame.site
    carried = frame.carried
    assert carried is not None
    faces = [z - site.plate / 2 for z in (frame.arrangement.place.near, frame.arrangement.place.far)]
    assert site.idle_wheel < carried.z - 25 < carried.z + 25 < min(faces)
    # Clear of the rear axle of 5 mm by the clearance or more, and its string leads plumb to it.
    axle = frame.arrangement.axes[0].real
    assert abs(carried.x - axle) >= 25 + 2.5 + site.clearance
    # It comes up behind the axle, whose rear moves up as the car drives ahead: 3 mm to the middle of a string of 1 mm.
    strings = {(-hole.u, -hole.v) for hole in carried.top.holes if hole.name == "string"}
    assert strings == {(carried.x, carried.z), (axle - 3.0, carried.z)}
    # It ends a clearance over the base, after 400 mm.
    assert carried.low - carried.high == pytest.approx(400)
    assert frame.top - carried.low == pytest.approx(site.clearance)
    # Rods stand at the corners of a square round it, half a millimetre off, and meet holes in base and top plate.
    rods = [hole for hole in frame.base.holes if hole.name == "rod of the guide"]
    assert {(hole.u, hole.v) for hole in rods} == {
        (hole.u, hole.v) for hole in carried.top.holes if hole.name == "rod of the guide"
    }
    off = [np.hypot(-hole.u - carried.x, -hole.v - carried.z) for hole in rods]
    assert off == pytest.approx([25 + 0.5 + 3.0] * 4)


def test_the_mass_counts_and_moves_the_centre(weight: CarFrame) -> None:
    parts = {part.code: part for part in frame_parts(weight)}
    assert parts["drop-weight"].each == 1000.0
    (middle,) = [np.array(parts["drop-weight"].balance().centre)]
    carried = weight.frame.carried
    assert middle == pytest.approx([carried.x, carried.high - 32.5, carried.z])
    tubes = parts["tube-6-x-1-x-490"]
    assert tubes.quantity == 4
    assert tubes.each == pytest.approx(np.pi / 4 * (36 - 16) * 490 * 2.7e-3, rel=0.01)
    motor = {part.code: part for part in frame_parts(frame_of(MOTOR))}
    assert motor["motor"].each == 100.0
    assert "guide-top" not in motor


def test_a_drum_stands_on_the_axle_clear_of_base_and_weight() -> None:
    """Fall per turn of the wheel, against the string that a run takes off by the check of the energy."""
    design = load_design("workshop_car", ["mechanics.drive_energy_J=", with_drum(20, fall=1500)])
    cam = plan_cam(design, "actual", judged=False)
    parts = parts_in(cam.application.in_car, cam)
    drum, axle = parts.part("drum"), parts.part("shaft-1")
    made = frame_in(parts.layout)
    carried, site = made.frame.carried, made.frame.site
    assert made.passed
    assert drum.places[0][:2, 3] == pytest.approx(axle.places[0][:2, 3])
    low, high = drum.heights(drum.places[0])
    # One layer of string: its turns of 1 mm fit between the flanges of 3 mm, which the weight's middle halves.
    turns = 1500 / (np.pi * 21)
    assert high - low - 6 >= turns + 1
    assert (low + high) / 2 == pytest.approx(carried.z)
    # The flanges are 27 mm across: clear of base and weight.
    assert made.frame.top - axle.places[0][1, 3] >= 13.5 + site.clearance
    assert abs(carried.x - axle.places[0][0, 3]) >= 25 + 13.5 + site.clearance
    assert drum.each == pytest.approx(2.7e-3 * np.pi / 4 * (6 * (27**2 - 25) + (high - low - 6) * (400 - 25)), rel=3e-3)
    assert axle.shape.drilled == ()
    (energy,) = (check for check in verdict_on_car(cam).checks if check.code == CheckCode.ENERGY_LEFT)
    wheel = cam.application.drive_wheel
    let_off = wheel.turn * wheel.finish / (2 * np.pi) / (2 * np.pi * site.wheel_radius) * np.pi * 21
    assert let_off > 1000
    assert energy.place.startswith(f"of {9.81e-3 * min(1500, let_off):g} J"[:8])


def test_without_a_drum_the_axle_has_the_strings_hole(weight: CarFrame) -> None:
    cam = plan_cam(weight.design, "actual", judged=False)
    parts = parts_in(cam.application.in_car, cam)
    assert "drum" not in {part.code for part in parts.parts}
    (hole,) = parts.part("shaft-1").shape.drilled
    body = weight.frame.carried.body
    assert (hole.diameter, hole.depth) == (1.5, 5.0)
    # At one end of the winding: 21.2 turns of 1 mm.
    assert body.turns == pytest.approx(400 / (np.pi * 6))
    assert hole.start[2] == pytest.approx(weight.frame.carried.z - body.winding / 2)
    assert body.winding >= body.turns


@pytest.mark.slow
@pytest.mark.long
def test_the_mounting_plan_winds_the_string_before_the_slack_is_taken_up() -> None:
    """400 mm of string on a circle of 6 mm are 21.2 turns; by the teeth, 5 x 3 x 3, they turn the cam back by 170°."""
    design = Design.load("workshop_car", [WEIGHT, "mechanics.drive_energy_J="]).values
    notes = [str(note) for note in mounting_notes(put_together(plan_cam(design, "actual"), plan_gears(design)))]
    first = [note.split()[0] for note in notes]
    assert first.index("Knot") < first.index("Wind") < first.index("Take") < first.index("Start:")
    turns, ratio = 400 / (np.pi * 6.0), 150 / 30 * 120 / 40 * 120 / 40
    wind = notes[first.index("Wind")]
    assert f"{turns:.1f} turns" in wind
    assert f"by {360 * turns / ratio:.0f}°" in wind


def test_cures_of_the_energy_pass_when_they_are_put_in() -> None:
    """A longer fall has a longer guide, which rolls along; a drum lets the string off faster."""
    tried = set()
    for rolling in (0.015, 0.02):
        given = ["mechanics.drive_energy_J=", f"mechanics.rolling_resistance={rolling}"]

        def left(*more: str, given: list[str] = given) -> Check:
            cam = plan_cam(load_design("workshop_car", [*given, *more]), "actual", judged=False)
            (check,) = (check for check in verdict_on_car(cam).checks if check.code == CheckCode.ENERGY_LEFT)
            return check

        lacks = left(WEIGHT)
        assert not lacks.passed
        fall = float(lacks.advice.split("drive.fall_mm to ")[1].split(",")[0].split(" ")[0])
        drum = lacks.advice.split("drive.drum_mm = ")[1].split(",")[0] if "drum_mm" in lacks.advice else ""
        tried.add(bool(drum))
        assert 0 <= left(with_drum(float(drum), fall) if drum else WEIGHT.replace("400", f"{fall:g}")).value < 0.15
    assert tried == {False, True}


def test_a_weight_that_holds_its_car_up_names_a_drum_that_moves_it() -> None:
    """Its energy suffices for the way, but the pull is too small for what is against it before the way is done."""
    long_fall = "drive={kind='weight', mass_kg=1.0, size_mm=[50, 50, 65], fall_mm=840}"
    given = [long_fall, "mechanics.drive_energy_J=", "mechanics.rolling_resistance=0.0155"]

    def checks(*more: str) -> dict[str, Check]:
        cam = plan_cam(load_design("workshop_car", [*given, *more]), "actual", judged=False)
        return {check.code: check for check in verdict_on_car(cam).checks}

    made = checks()
    assert made[CheckCode.ENERGY_LEFT].passed
    assert not made[CheckCode.WEIGHT_PULL].passed
    key, value = made[CheckCode.WEIGHT_PULL].advice.removeprefix("set ").split(" to ")
    assert key == "drive.drum_mm"
    assert not failing(tuple(checks(f"{key}={value}").values()))


def test_a_small_weight_has_the_pulleys_screws_outside_its_tubes() -> None:
    small = "drive={kind='weight', mass_kg=0.1, size_mm=[10, 10, 65], fall_mm=200}"
    assert frame_of(small).passed


def test_a_motor_is_screwed_to_the_base() -> None:
    made = frame_of(MOTOR)
    assert made.passed
    carried = made.frame.carried
    assert carried.low == carried.high == made.frame.top
    holes = np.array([(hole.u, hole.v) for hole in made.frame.base.holes if hole.name == "motor"])
    assert np.ptp(holes, axis=0) == pytest.approx([30.0, 20.0])
    assert holes.mean(axis=0) == pytest.approx([-carried.x, -carried.z])


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"size_mm": [130, 130, 10]}, CheckCode.DRIVE_ROOM),
        ({"drum_mm": 60}, CheckCode.DRIVE_ROOM),
        ({"start_height_mm": 410}, CheckCode.DRIVE_FALL),
    ],
)
def test_what_does_not_fit_names_a_cure_that_helps(changes: dict[str, object], code: CheckCode) -> None:
    overrides = [WEIGHT, *(f"drive.{key}={value}" for key, value in changes.items())]
    made = frame_of(*overrides)
    assert {check.code for check in failing(made.plain_checks)} == {code}
    (check,) = (check for check in made.checks if check.code == code)
    if code == CheckCode.DRIVE_ROOM:
        key, value = check.advice.removeprefix("set ").split(" to ")
        assert key == ("drive.drum_mm" if "drum_mm" in changes else "car.idle_wheel_offset_mm")
        assert frame_of(*overrides, f"{key}={value}").passed
    else:
        start, fall = (float(check.advice.split(f"{word} to ")[1].split(",")[0]) for word in ("it", "drive.fall_mm"))
        assert frame_of(*overrides, f"drive.start_height_mm={start}").passed
        assert frame_of(*overrides, f"drive.fall_mm={fall}").passed


def test_the_width_that_is_told_has_the_tubes_in_it_and_suffices() -> None:
    """A small weight is narrower than the tubes round it: the idle wheel set out to the width told gives a place."""
    small = "drive={kind='weight', mass_kg=0.1, size_mm=[30, 30, 65], fall_mm=200}"
    made = frame_of(small, "car.idle_wheel_offset_mm=110")
    (check,) = (check for check in made.plain_checks if check.code == CheckCode.DRIVE_ROOM)
    room, needed = (float(text) for text in (check.place.split(" mm")[0], check.place.split(", ")[1].split(" are")[0]))
    assert needed == pytest.approx(2**0.5 * (15 + 0.5 + 3) + 6, abs=0.1)
    assert frame_of(small, f"car.idle_wheel_offset_mm={110 + needed - room}").frame.carried is not None
    assert frame_of(small, f"car.idle_wheel_offset_mm={110 + needed - room - 0.5}").frame.carried is None


def test_a_motor_smaller_than_its_holes_fails_with_its_size() -> None:
    small = "drive={kind='motor', mass_kg=0.1, size_mm=[20, 15, 25]}"
    (check,) = failing(frame_of(small).checks)
    assert check.code == CheckCode.DRIVE_SCREWS
    assert "20 x 15 mm" in check.place
    holes, size = check.advice.split(", or take a motor of ")
    assert frame_of(small, holes.replace("set ", "").replace(" to ", "=")).passed
    along, across = (int(text.split(" ")[0]) for text in (size, size.split("car and ")[1]))
    assert frame_of(f"drive={{kind='motor', mass_kg=0.1, size_mm=[{along}, {across}, 25]}}").passed


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        ([WEIGHT, "drive.start_height_mm=300"], "the weight hits the floor.*lower fall_mm"),
        ([WEIGHT, "drive.fall_mm="], r"give drive\.fall_mm, such as 400"),
        ([WEIGHT, "drive.size_mm=[50, 40, 65]"], "a weight is round"),
        ([MOTOR, "drive.fall_mm=400"], "of a weight, and drive.kind is motor"),
        ([MOTOR, "drive.drum_mm=20"], r"drive\.drum_mm is of a weight, and drive.kind is motor"),
        ([WEIGHT, "drive.drum_mm=7"], r"raise drum_mm to 9 or more"),
        ([WEIGHT, "frame="], r"\[drive\] stands on the base of \[frame\]"),
        ([WEIGHT, "mechanics.drive_energy_J=5"], r"that falls drive\.fall_mm = 400 mm has 3\.92 J"),
    ],
)
def test_bad_input_is_one_sentence_with_key_and_cure(overrides: list[str], said: str) -> None:
    with pytest.raises(DesignError, match=said):
        frame_of(*overrides)
