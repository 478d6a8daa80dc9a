"""The train in its car: layouts of packaged designs, what they refuse, and cures that are put in."""

import re

import numpy as np
import pytest

from cadgen.check import CheckCode, failing
from cadgen.design.load import load_design, load_train, with_overrides
from cadgen.errors import DesignError
from cadgen.jobs.cam.steering_cam import CarUse, plan_cam
from cadgen.jobs.car_layout import laid_out, layout_of, layout_reservation
from cadgen.jobs.gears.gear_train import plan_gears

LAID_OUT = ("workshop_car", "s_course", "figure_eight", "posts_and_walls")


@pytest.mark.parametrize("name", LAID_OUT)
def test_a_packaged_car_is_laid_out(name):
    layout = laid_out(load_design(name))
    assert not failing(layout.checks), failing(layout.checks)
    assert layout.arrangement.axes[0].real == pytest.approx(-layout.site.behind)


def test_the_train_that_is_made_has_the_directions_of_the_car():
    train = plan_gears(load_train("workshop_car"))
    first, last = train.layout.parts[0].axis, train.layout.parts[-1].axis
    assert train.passed
    assert (last - first).real == pytest.approx(97.0)  # 167 mm of wheelbase less 70 mm of base radius
    assert first - last == pytest.approx(train.car.arrangement.axes[0])
    assert {CheckCode.CAR_CLEARANCE, CheckCode.AXLE_REACHED} <= {check.code for check in train.checks}
    assert train.facts()["car_layout"]["camshaft_height_mm"] == train.car.arrangement.height


def test_the_exact_disc_is_no_larger_than_the_layout_reckons():
    design = load_design("workshop_car")
    cam = plan_cam(design)
    exact = float(np.hypot(*cam.curve.outline(0.1).points.T).max())
    reckoned = laid_out(design).site.disc[0].radius
    print(f"greatest radius of the disc {exact:.3f} mm, {reckoned:.3f} mm in the layout")
    assert exact <= reckoned + 0.02
    assert exact >= reckoned - 0.5


def test_directions_that_a_design_gives_are_kept():
    """Directions of 0, 20 and -20 degrees bring the drive onto the axle of the paper's car, clear of the disc."""
    stages = [f"train.stages.{n}.direction_deg={d}" for n, d in ((1, 0), (2, 20), (3, -20))]
    layout = laid_out(load_design("workshop_car", stages))
    assert not failing(layout.checks)
    turns = np.degrees(np.diff(layout.directions))
    assert (turns + 180) % 360 - 180 == pytest.approx([20, -40])


def test_a_train_that_falls_short_says_by_how_much():
    """Stages of 32.5 and 32.5 mm reach 65 mm of the 97 between camshaft and axle."""
    cut = ["train.stages=[{driver={teeth=30},driven={teeth=100}},{driver={teeth=30},driven={teeth=100}}]"]
    cut.append("car.drive_wheel_radius_mm=")
    layout = laid_out(load_design("workshop_car", cut))
    short = next(check for check in layout.checks if check.code == CheckCode.AXLE_REACHED)
    assert short.value == pytest.approx(32.0)
    assert not short.passed
    without = load_design("workshop_car", [*cut, "layout="])
    assert laid_out(without) is None
    assert layout_reservation(without).text.startswith("the train reaches 65 mm from the camshaft at most")
    assert layout_reservation(load_design("carbon_free_car")) is None


@pytest.mark.parametrize(
    "change",
    [
        "cam.base_radius_mm=62",
        "layout.floor_clearance_mm=25",
        "layout.camshaft_height_mm=75",
        "train.bearing_span_mm=26",
    ],
)
def test_a_cure_is_accepted_when_it_is_put_in(change):
    design = load_design("posts_and_walls", [change])
    wrong = failing(laid_out(design).checks)
    assert wrong, f"{change} harms nothing"
    said = next(check.advice for check in wrong if check.advice)
    put_in = re.search(r"([a-z_.]+) to ([0-9.a-z]+)", said)
    override = f"{put_in[1]}={put_in[2]}" if put_in else re.sub(r"leave ([a-z_.]+) out", r"\1=", said)
    print(said)
    assert not failing(layout_of(with_overrides(design, [override])).checks)


@pytest.mark.slow
@pytest.mark.long
def test_a_cam_that_turns_the_wrong_way_is_not_ready():
    design = load_design("s_course", ["layout.turned_over=false"])
    cam = plan_cam(design, "actual")
    assert [check.code for check in cam.verdict.failed] == [CheckCode.CAM_SENSE]
    assert "set layout.turned_over to true" in cam.verdict.failed[0].advice
    assert not any(each.code == "sense-of-train" for each in cam.verdict.reservations)
    turned = plan_cam(load_design("s_course"), "actual")
    assert turned.verdict.passed
    assert any("turned over" in note for note in CarUse.of(turned).drawing_notes(turned))


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (["train="], "[layout] says how the gear train stands in the car, and the design has none"),
        (["train.stages.1.direction_deg=10"], "train.stages.2.direction_deg is not given"),
        (["train.drive.bore_fit=", "train.drive.bore_diameter_mm=0"], "train.drive.bore_diameter_mm is missing"),
        (["layout.clearance_mm=0"], "layout.clearance_mm"),
    ],
)
def test_a_layout_that_cannot_be_is_refused(overrides, said):
    with pytest.raises(DesignError, match=re.escape(said)):
        load_design("workshop_car", overrides)


def test_a_layout_needs_a_car(tmp_path):
    file = tmp_path / "only_train.toml"
    text = "[train]\nmodule_mm = 1\nwidth_mm = 6.0\nbearing_span_mm = 40.0\n[train.drive]\nbore_diameter_mm = 5\n"
    text += "[train.output]\nbore_diameter_mm = 5\n[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 60 }\n"
    file.write_text(text + "[layout]\n")
    with pytest.raises(DesignError, match=r"lacks \[path\], \[car\], \[cam\] and \[follower\]"):
        plan_gears(load_train(file))


def test_plates_thinner_than_their_bearings_are_not_ready():
    """A 608 takes a shaft of 8 mm, and is 22 mm across and 7 mm wide; a 625 has 5, 16 and 5 mm, a 623 3, 10 and 4."""
    plates = "train.plate={thickness_mm=5,bearing_bores_mm=[16,10,10,22]}"
    (check,) = failing(laid_out(load_design("workshop_car", [plates])).checks)
    assert check.code == CheckCode.PLATE_THICKNESS
    assert check.limit == 7.0
    assert not failing(laid_out(load_design("workshop_car", [plates.replace("=5", "=7", 1)])).checks)


def test_a_camshaft_that_no_train_reaches_is_not_ready():
    """With the floor 400 mm away the camshaft stands 473 mm high, and the stages reach 125 mm."""
    for change in ("layout.floor_clearance_mm=400", "layout.camshaft_height_mm=400"):
        wrong = failing(laid_out(load_design("workshop_car", [change])).plain_checks)
        assert {check.code for check in wrong} & {CheckCode.CAR_CLEARANCE, CheckCode.FLOOR_CLEARANCE}


def test_a_shaft_on_the_axis_of_the_camshaft_is_seen():
    """Stages of 48, 50, 40 and 40 mm, the last one back: shaft 3 comes to stand on the camshaft's axis."""
    stages = ",".join(
        f"{{driver={{teeth={a}}},driven={{teeth={b}}},direction_deg={d}}}"
        for a, b, d in ((32, 160, 0), (95, 105, 0), (40, 120, 0), (80, 80, 180))
    )
    changes = [f"train.stages=[{stages}]", "cam.base_radius_mm=74", "layout.turned_over=true"]
    changes.append("car.drive_wheel_radius_mm=")
    changes += [f"train.{place}.{key}=" for place in ("output", "intermediate") for key in ("lightening", "web")]
    layout = laid_out(load_design("workshop_car", changes))
    (check,) = (each for each in failing(layout.plain_checks) if each.code == CheckCode.CAR_CLEARANCE)
    assert check.value < 0


def test_the_drive_wheel_stands_in_no_plate():
    """With 18 mm from fork axis to wheel the wheel stands in the plate beside the disc, at -10 to -2 mm of it."""
    layout = laid_out(load_design("workshop_car", ["car.drive_wheel_offset_mm=18", "layout.train_face=inner"]))
    (check,) = (each for each in failing(layout.plain_checks) if each.code == CheckCode.CAR_CLEARANCE)
    assert check.value < 0


def test_the_rod_clears_the_front_wheel():
    """A wheel of 90 mm reaches 15 mm past a rod that stands 75 mm high."""
    wheel = "car.outline={length_mm=290,width_mm=260,front_overhang_mm=60,front_wheel_diameter_mm=90,\
front_wheel_width_mm=4,wheel_diameter_mm=128,wheel_width_mm=4}"
    layout = laid_out(load_design("workshop_car", [wheel]))
    assert layout.arrangement.height >= 90 + 2.5 + 1
    low = laid_out(load_design("workshop_car", [wheel, "layout.camshaft_height_mm=82"]))
    assert any(check.code == CheckCode.CAR_CLEARANCE for check in failing(low.plain_checks))


def test_a_disc_turned_over_takes_its_hub_along():
    hub = 'blank.hub={diameter_mm=20,length_mm=8,side="outer"}'
    upright, over = (
        laid_out(load_design("workshop_car", [hub, f"layout.turned_over={value}"])).site.disc[1]
        for value in ("false", "true")
    )
    assert (upright.low, upright.high) == (3.0, 11.0)
    assert (over.low, over.high) == (-8.0, 0.0)


def test_the_bearing_span_of_a_stage_is_named():
    design = load_design("workshop_car", ["train.stages.2.bearing_span_mm=30"])
    (check,) = (each for each in failing(laid_out(design).plain_checks) if each.code == CheckCode.PLATE_ROOM)
    assert check.advice.startswith("raise train.stages.2.bearing_span_mm to ")
    put_in = check.advice.replace("raise ", "").replace(" to ", "=")
    assert not failing(layout_of(with_overrides(design, [put_in])).plain_checks)


def test_a_mass_without_an_energy_is_refused():
    with pytest.raises(DesignError, match=r"give mechanics\.drive_energy_J, or remove car_mass_kg"):
        load_design("workshop_car", ["mechanics.car_mass_kg=1.5", "mechanics.drive_energy_J="])
