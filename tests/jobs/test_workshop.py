"""Workshop's file: from calibrated cars to the tolerances and the calibration of further ones."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.api.design import Design
from cadgen.api.measured import Measured, reading_of, sources_of
from cadgen.deviations.deviation import COLUMNS, ECCENTRIC_BORE, STEERING_ZERO, WHEEL_RADIUS, WHEELBASE
from cadgen.errors import FileError
from cadgen.gears.choices import Law
from cadgen.inference.expectation.linear import Linear
from cadgen.inference.expectation.next_measurement import proposals
from cadgen.inference.measurement.kinds import LIFT, PROFILE, TRACK, TRANSMISSION
from cadgen.inference.monte_carlo.random_cars import errors_of_cars, tolerance_run
from cadgen.inference.workshop import Habit
from cadgen.jobs.calibration.advice import PLAY
from cadgen.jobs.calibration.calibration import calibrate
from cadgen.jobs.calibration.cam_on_car import nominal_of
from cadgen.jobs.calibration.learned_workshop import workshop_of
from cadgen.jobs.calibration.workshop import _REVERSED, Workshop, is_known, read_workshop
from cadgen.jobs.cam.steering_cam import CarUse, plan_cam
from cadgen.jobs.nominal_car import watched_cars
from tests.inference.measurement import synthetic_drive as drive
from tests.inference.measurement.synthetic import Car

DEG = np.pi / 180
MADE = Workshop(
    design="carbon_free_car",
    cars=6,
    habits=(
        Habit("track", "steering zero", "steering_zero_deg", 0.02 * DEG, 0.03 * DEG, 0.02 * DEG, 0.05 * DEG, 6.0),
        Habit("track", "wheel radius", "wheel_radius_percent", 0.001, 0.002, 0.001, 0.004, 5.0),
        Habit("lift", "eccentric bore", "eccentric_x_um", 0.002, 0.004, 0.002, 0.006, 6.0),
        Habit("lift", "eccentric bore", "eccentric_y_um", -0.003, 0.004, 0.002, 0.006, 6.0),
    ),
)


@pytest.fixture(scope="module")
def planned():
    plan = plan_cam(Design.load("carbon_free_car").complete(), "actual", with_play=True)
    use = CarUse.of(plan)
    return use, watched_cars(use, plan.curve)


def test_the_file_says_what_was_learned(tmp_path):
    file = tmp_path / "workshop.toml"
    file.write_text(MADE.text().replace("track = [20.0, 3.0]", "track = [60.0, 30.0]"))
    back = read_workshop(file, "carbon_free_car")
    assert back.minutes["track"] == (60, 30)
    assert back.text() == file.read_text()
    for one, other in zip(back.habits, MADE.habits, strict=True):
        assert (one.effect, one.name) == (other.effect, other.name)
        assert (one.mean, one.spread, one.most) == pytest.approx((other.mean, other.spread, other.most), rel=1e-4)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("spread = 0.03", "spread = -1"), "spread of steering_zero_deg of steering zero is -1"),
        (("mean = 0.02", "mean = 400000"), "mean of steering_zero_deg .* is 400000; it must be a number between -"),
        (("mean = 0.02", "mean = nan"), "mean of steering_zero_deg of steering zero is nan"),
        (("mean = 0.02", 'mean = "0.02"'), "mean of steering_zero_deg .* is '0.02'"),
        (("[0.02, 0.05]", "[0.05, 0.02]"), "range_90_percent of steering_zero_deg"),
        (('name = "steering_zero_deg"', 'name = "zero"'), "no effect steering zero with the number zero of kind track"),
        (('effect = "steering zero"', 'effect = "steering"'), "no effect steering with"),
        (("cars = 6\n", "cars = \n"), "cannot be read"),
        (("cars = 6\n", "cars = -3\n"), "cars is missing or no whole number"),
        (("cars = 6.0", "cars = 7.0"), "cars of steering_zero_deg of steering zero must be"),
        (("track = [20.0, 3.0]", "track = [0, 0]"), "minutes.track is not two times"),
        (("track = [20.0, 3.0]", "tracks = [20, 3]"), "minutes has tracks"),
        (("[minutes]", "[minute]"), "there is no key minute"),
        (
            ('design = "carbon_free_car"', 'design = "another"'),
            "by another, and not by carbon_free_car: .* write design",
        ),
        (('design = "carbon_free_car"', 'design = "a"b"'), "cannot be read"),
        (('name = "eccentric_y_um"', 'name = "eccentric_x_um"'), "eccentric_x_um is given twice"),
        (('[[numbers]]\neffect = "wheel radius"', '[[number]]\neffect = "wheel radius"'), "there is no key number"),
    ],
)
def test_a_file_that_is_none_is_refused(tmp_path, change, said):
    file = tmp_path / "workshop.toml"
    assert change[0] in MADE.text()
    file.write_text(MADE.text().replace(*change, 1))
    with pytest.raises(FileError, match=said) as refused:
        read_workshop(file, "carbon_free_car")
    assert "\n" not in str(refused.value)


def test_files_that_are_no_text_or_no_file_are_refused(tmp_path):
    file = tmp_path / "workshop.toml"
    for content in (b"\xff\xfe\x00", b"[" * 100_000, b"minutes = 3\n", b""):
        file.write_bytes(content)
        with pytest.raises(FileError, match=r"workshop\.toml"):
            read_workshop(file, "carbon_free_car")
    for nothing in (tmp_path, tmp_path / "none.toml"):
        with pytest.raises(FileError, match="cannot be read as a workshop's file"):
            read_workshop(nothing, "carbon_free_car")


def test_tolerances_are_the_workshops_own(planned):
    """Cars drawn have the means and spreads of the file; what it does not name keeps the design's tolerance."""
    use, cars = planned
    given = use.tolerances()
    made = MADE.tolerances(given, cars.car, cars.wheel_radius)
    drawn = made.draw(np.random.default_rng(1), 20_000, cars.play)
    column = STEERING_ZERO.column
    assert drawn[:, column].mean() == pytest.approx(0.02 * DEG, rel=0.03)
    assert drawn[:, column].std() == pytest.approx(0.03 * DEG, rel=0.03)
    assert drawn[:, WHEEL_RADIUS.column].std() == pytest.approx(0.002 * cars.wheel_radius, rel=0.03)
    x, y = ECCENTRIC_BORE.columns
    assert drawn[:, [x, y]].mean(axis=0) == pytest.approx([-0.002, 0.003], abs=2e-4)
    assert drawn[:, [x, y]].std(axis=0) == pytest.approx([0.004, 0.004], rel=0.05)
    kept = {d: half for d, half in given.half_widths.items() if d not in (STEERING_ZERO, WHEEL_RADIUS, ECCENTRIC_BORE)}
    assert kept.items() <= made.half_widths.items()


@pytest.mark.slow
@pytest.mark.long
def test_each_deviation_moves_a_car_the_way_its_effect_does(planned):
    """Signs of both catalogues, by the end of the run: of the forward model of a track, and of many cars."""
    use, cars = planned
    nominal = nominal_of(use.design, "actual")
    records = {p.kind: p.record for p in proposals(nominal, [], []) if p.kind is not TRANSMISSION and p.record}
    linear = Linear.of(nominal, [], [], {kind: records[kind] for kind in (TRACK, LIFT, PROFILE)}, {})
    ways = linear.ways([])
    angles = []
    for effect, span in zip(linear.effects, linear.spans, strict=True):
        deviation = effect.deviation
        if not deviation or deviation.name not in {d.name for d in (*_REVERSED, STEERING_ZERO, WHEEL_RADIUS)}:
            continue
        for k, column in enumerate(deviation.columns[: span.stop - span.start]):
            moved = np.zeros((2, len(COLUMNS)))
            moved[:, column] = 1e-4, -1e-4
            errors = errors_of_cars(cars, moved)
            end = (errors.along + 1j * errors.across)[:, cars.end] * np.exp(1j * cars.planned.heading[:, cars.end])
            sign = -1 if deviation in _REVERSED else 1
            angles.append(np.angle((end[0] - end[1]) * sign / ways[span.start + k]))
    # One turn of the frame between both, whatever the deviation.
    assert len(angles) >= 5
    turned = np.angle(np.mean(np.exp(1j * np.array(angles))))
    assert np.all(np.abs(np.angle(np.exp(1j * (np.array(angles) - turned)))) < 0.5)
    assert WHEELBASE in _REVERSED


TRUE = {"zero": 0.04 * DEG, "radius": 0.001, "gain": 0.0008}


def made_cars(built, seeds, runs=2, noise=3.0):
    """Cars of a workshop that sets the steering 0.02 degrees to the left in the mean, and their tracks."""
    for seed in seeds:
        rng = np.random.default_rng(seed)
        zero, radius, gain = (size * rng.standard_normal() for size in TRUE.values())
        wheels = drive.Wheels(zero=0.02 * DEG + zero, radius=1 + radius, gain=1 + gain)
        record = drive.track_record(Car(built), wheels, rng, noise_mm=noise, runs=runs)
        yield wheels, Measured({**record.columns, "run": record.run + 1}, (), f"car {seed}")


@pytest.mark.slow
@pytest.mark.long
def test_a_workshop_is_learned_and_its_cars_are_foretold(carbon_free_car, planned, tmp_path):
    """Four cars are measured; further ones end as the file lets expect, and not as the tolerances do."""
    design = Design.load("carbon_free_car")
    nominal = nominal_of(design.complete(), "actual")
    cars = list(made_cars(carbon_free_car, range(40, 44)))
    sources = sources_of([table for _, table in cars], reading_of(design.values, None))
    plans = [calibrate(design.complete(), "actual", [source], nominal=nominal) for source in sources]
    file = tmp_path / "workshop.toml"
    file.write_text(workshop_of(design.complete(), plans).text())
    found = read_workshop(file, "carbon_free_car")
    known = {habit.name: habit for habit in found.habits}
    for name, size, mean in (
        ("steering_zero_deg", TRUE["zero"], 0.02 * DEG),
        ("wheel_radius_percent", TRUE["radius"], 0.0),
        ("gain_percent", TRUE["gain"], 0.0),
    ):
        habit = known[name]
        assert habit.least < size < habit.most
        assert abs(habit.mean - mean) < 2.5 * habit.spread / 2 + 1e-5
    _, nominal_cars = planned
    given = planned[0].tolerances()
    true = {
        "steering_zero_deg": (0.02 * DEG, TRUE["zero"]),
        "wheel_radius_percent": (0.0, TRUE["radius"]),
        "gain_percent": (0.0, TRUE["gain"]),
    }
    habits = [replace(h, mean=m, spread=s) for h in found.habits for m, s in [true.get(h.name, (0.0, 1e-9))]]
    truth = replace(found, habits=tuple(habits))
    of = [each.tolerances(given, nominal_cars.car, nominal_cars.wheel_radius) for each in (found, truth)]
    default, learned, made = (
        float(np.median(tolerance_run(nominal_cars, each, 1000, seed=1).distance)) for each in (given, *of)
    )
    assert abs(np.log(learned / made)) < abs(np.log(default / made)), (default, learned, made)


def test_an_effect_that_no_catalogue_has_is_in_no_file():
    backlash = next(e for e in LIFT.catalogue.entries if e.name == "backlash")
    assert is_known(LIFT, backlash)
    assert not is_known(LIFT, replace(backlash, name="backlash (lift)"))
    assert not is_known(PROFILE, backlash)


def _named(kind, effect, name):
    return Habit(kind, effect, name, 0.001, 0.002, 0.001, 0.003, 3.0)


def test_play_is_one_number_whatever_data_call_it(tmp_path, planned):
    """By each of its four names it is found again by calibrations of every kind, and drawn by tolerance."""
    use, cars = planned
    given = use.tolerances()
    names = [("lift", "backlash"), ("lift", "backlash, held by the spring"), ("track", "backlash")]
    for kind, effect in [*names, ("transmission", "return error")]:
        one = replace(MADE, habits=(_named(kind, effect, "return_error_deg"),))
        assert one.usual == {PLAY: (0.001, 0.002)}
        assert one.tolerances(given, cars.car, cars.wheel_radius).play(np.random.default_rng(0), 9).max() < 0.01
    for data in (LIFT, TRACK, TRANSMISSION):
        assert any(PLAY in e.quantities for e in data.catalogue.entries)
    file = tmp_path / "workshop.toml"
    file.write_text(replace(MADE, habits=tuple(_named(*each, "return_error_deg") for each in names[:2])).text())
    with pytest.raises(FileError, match="given twice, by backlash of kind lift and by backlash, held by the spring"):
        read_workshop(file, "carbon_free_car")


def test_a_levers_gain_reaches_the_wheelbase_and_a_dials_does_not(tmp_path, planned):
    use, cars = planned
    given, file = use.tolerances(), tmp_path / "workshop.toml"
    half = {}
    for kind in ("track", "lift"):
        file.write_text(replace(MADE, habits=(_named(kind, "lever gain", "gain_percent"),)).text())
        back = read_workshop(file, "carbon_free_car")
        made = back.tolerances(given, cars.car, cars.wheel_radius)
        half[kind] = made.half_widths[WHEELBASE]
        assert dict(made.means).get(WHEELBASE.column, 0.0) == pytest.approx(
            -0.001 * cars.car.wheelbase if kind == "track" else 0.0
        )
    assert half["lift"] == given.half_widths[WHEELBASE]
    assert half["track"] == pytest.approx(0.002 * cars.car.wheelbase * (3 if given.law is Law.NORMAL else np.sqrt(3)))
    file.write_text(file.read_text().replace('kind = "lift"\n', ""))
    with pytest.raises(FileError, match="one thing in data of kind lift, and another in those of kind track"):
        read_workshop(file, "carbon_free_car")


def test_a_size_with_a_direction_is_given_as_a_whole(tmp_path):
    file = tmp_path / "workshop.toml"
    file.write_text(replace(MADE, habits=MADE.habits[:3]).text())
    with pytest.raises(FileError, match="eccentric_x_um of eccentric bore is given without eccentric_y_um"):
        read_workshop(file, "carbon_free_car")
