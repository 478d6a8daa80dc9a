"""Records of a train that are not as they should be: loads, encoders of one turn, and angles that no train gives."""

import re
import sys
from math import cos, degrees, radians
from pathlib import Path

import numpy as np
import pytest

from cadgen.api.design import Design
from cadgen.api.measured import Measured
from cadgen.errors import DesignError, FileError
from cadgen.jobs.measured_gears.measured_train import TrainFault
from cadgen.verdict import Readiness
from tests.inference.gearing.test_train_errors import DESIGN, DESIGNED, judged, plain
from tests.inference.gearing.train_truth import Stage, Wheel, loaded, table

COS = cos(radians(20.0))
RATIO = 61 / 20 * 64 / 21
STIFF, RUB = 40.0, 0.4


def with_play(play_deg, seed=1, **changes):
    """Record of a train whose play is that of its last stage."""
    stages = [Stage(Wheel(20), Wheel(61)), Stage(Wheel(21), Wheel(64, **changes), play=radians(play_deg) * 32 * COS)]
    return table(stages, 0.003, np.random.default_rng(seed), runs=2, turns=1.1, step_deg=3.1)


def pulled(torques, play=0.45, rub=RUB, seed=2, **more):
    return judged(loaded(RATIO, torques, play, STIFF, rub, 0.002, np.random.default_rng(seed), step_deg=2.0, **more))


@pytest.mark.parametrize("play", [0.1, 1.2])
def test_play_outside_the_zone_of_the_design_is_a_reservation(play):
    result = judged(with_play(play))
    assert degrees(result.errors.play.value) == pytest.approx(play, abs=0.002)
    assert result.within is False
    assert result.readiness == Readiness.RESERVATIONS
    assert judged(with_play(0.6)).within is True


@pytest.mark.parametrize("torque", [5.0, -5.0])
def test_a_steady_load_hides_the_play(torque):
    """Both ways at one flank: the lag is 2 h = 2·0.4/40 = 0.02°, and no play of 0.02° is said."""
    result = pulled([torque, torque])
    assert result.errors.play is None
    assert 2 * degrees(result.errors.friction.value) == pytest.approx(2 * RUB / STIFF, rel=0.03)
    assert result.readiness == Readiness.RESERVATIONS
    assert not result.designs
    assert "The load goes one way" in str(result)


def test_a_steady_load_less_than_the_friction_is_not_told_from_one_that_is_more():
    """A sensor's offset of 0.01 N m: the lag is the play and 2 h, and it is said that it may be so."""
    result = pulled([0.01, 0.01])
    assert result.errors.play is None
    assert 2 * degrees(result.errors.friction.value) == pytest.approx(0.45 + 2 * RUB / STIFF, rel=0.03)
    assert "the lag holds the play" in str(result)


def test_a_torque_of_0_is_no_load():
    with_torque = loaded(RATIO, [0.0, 0.0], 0.45, STIFF, RUB, 0.002, np.random.default_rng(3), step_deg=2.0)
    without = {name: values for name, values in with_torque.items() if name != "output_torque_Nm"}
    assert judged(with_torque).errors.play == judged(without).errors.play


@pytest.mark.parametrize(("offset", "noise"), [(0.0, 0.01), (0.01, 0.01), (0.05, 0.005), (-0.03, 0.02)])
def test_noise_of_a_torque_sensor_is_no_load(offset, noise):
    """A torque that moves nothing: the play is that with the wind-up by friction, as without a sensor."""
    rng = np.random.default_rng(4)
    columns = loaded(RATIO, [0.0, 0.0], 0.45, STIFF, RUB, 0.002, rng, step_deg=2.0)
    columns["output_torque_Nm"] = offset + noise * rng.standard_normal(len(columns["run"]))
    result = judged(columns)
    assert degrees(result.errors.play.value) == pytest.approx(0.45 + 2 * RUB / STIFF, abs=0.002)
    assert not result.errors.loaded
    assert result.readiness == Readiness.READY


def test_a_run_with_a_steady_load_beside_one_without_tells_play_from_friction():
    result = pulled([0.0, 5.0])
    assert degrees(result.errors.play.value) == pytest.approx(0.45, abs=0.003)
    assert 2 * degrees(result.errors.friction.value) == pytest.approx(2 * RUB / STIFF, abs=0.002)


def test_runs_at_one_flank_each_say_no_play():
    """Each run has its own zero, so that the way from one flank to the other is in none."""
    result = pulled([5.0, -5.0])
    assert result.errors.play is None
    assert result.errors.both
    assert result.errors.compliance is None
    assert result.readiness == Readiness.RESERVATIONS


def test_a_load_that_changes_its_sign_shows_all():
    sweep = 6 * np.sin(np.linspace(0, 40, 435))
    result = pulled([sweep, -sweep], turns=1.21)
    assert degrees(result.errors.play.value) == pytest.approx(0.45, abs=0.003)
    assert degrees(result.errors.compliance.value) == pytest.approx(1 / STIFF, rel=0.02)


@pytest.fixture(scope="module")
def eccentric():
    """Record with run-out on each shaft, for which the angle of every shaft counts."""
    stages = plain()
    for stage, towards in zip(stages, (0.4, 2.0), strict=True):
        stage.driver.off, stage.driver.towards = 0.03, towards
        stage.driven.off, stage.driven.towards = 0.04, -towards
    return table(stages, 0.002, np.random.default_rng(5), turns=1.15, step_deg=2.1)


def same_lines(one, other):
    assert degrees(one.errors.play.value) == pytest.approx(degrees(other.errors.play.value), abs=1e-6)
    for mine, its in zip(one.errors.lines, other.errors.lines, strict=True):
        assert mine.order == its.order
        assert abs(mine.forward - its.forward) < 1e-8


@pytest.mark.parametrize("least", [0.0, -180.0])
def test_angles_of_a_turn_are_counted_on(eccentric, least):
    """Run-out of the slow shafts has its phase only if all runs are counted from one turn of the input."""
    anew = {name: (values - least) % 360.0 + least if "angle" in name else values for name, values in eccentric.items()}
    result = judged(anew)
    same_lines(result, judged(eccentric))
    assert "begins anew after each turn and is counted on" in str(result)


def test_an_output_of_one_turn_beside_an_input_that_counts_on_is_understood(eccentric):
    result = judged({**eccentric, "output_angle_deg": eccentric["output_angle_deg"] % 360.0})
    same_lines(result, judged(eccentric))
    assert "output_angle_deg begins anew" in str(result)
    assert "input_angle_deg begins anew" not in str(result)


def test_rows_too_far_apart_to_count_on_are_refused():
    columns = table(plain(), 0.002, np.random.default_rng(6), runs=2, step_deg=20.0)
    with pytest.raises(FileError, match="its sense cannot be told"):
        judged({**columns, "input_angle_deg": columns["input_angle_deg"] % 360.0})


def test_a_wheel_that_no_hob_cuts_is_not_ordered():
    """Play of 1.2°, for which a wheel would be thicker than leaves room for the teeth of the other."""
    result = judged(with_play(1.2))
    wanted = result.wanted
    assert wanted.driven > wanted.reach[1]
    assert not result.designs
    assert "No thickness of the driven wheel" in str(result)
    assert "it takes a new wheel" not in str(result)
    least, most = wanted.reach
    for thickness, fits in ((least + 0.002, True), (most - 0.002, True), (least - 0.002, False), (most + 0.002, False)):
        assert stands(1e3 * wanted.driver, 1e3 * thickness) == fits
    # A wheel of the greatest thickness, cut by the other program.
    arc = radians(1.2) * 32 * COS - (most - (wanted.driven - wanted.thinning)) * COS
    assert degrees(arc / (32 * COS)) == pytest.approx(degrees(wanted.reached[0]), abs=0.01)


def stands(driver, driven):
    """Whether the teeth of the second stage pass each check of the design."""
    text = DESIGN.replace("teeth = 21", f"teeth = 21, E_sn_um = {driver}")
    text = text.replace("teeth = 64", f"teeth = 64, E_sn_um = {driven}")
    try:
        checks = Design.from_toml(text, train_only=True).gears().checks
    except DesignError:
        return False
    return all(check.passed for check in checks)


def test_nothing_is_corrected_by_a_record_that_is_not_explained():
    columns = with_play(0.2)
    off = judged({**columns, "output_angle_deg": 0.95 * columns["output_angle_deg"]})
    turn = np.radians(columns["output_angle_deg"])
    foreign = judged({**columns, "output_angle_deg": columns["output_angle_deg"] + 0.05 * np.sin(4.45 * turn)})
    assert judged(columns).designs
    for result, fault in ((off, TrainFault.RATE), (foreign, TrainFault.ORDER)):
        assert result.faults[0] == fault
        assert result.readiness == Readiness.NOT_READY
        assert result.wanted is None
        assert not result.designs
        assert not result.turnings
    assert re.search(r"[45]\.\d{4} % slower", " ".join(str(off).split()))


@pytest.mark.parametrize("play", [5.0, 17.0])
def test_play_of_more_than_the_teeth_is_not_that_of_teeth(play):
    """Half a pitch of each stage at the output, 360/64/2 + 360/61/2·21/64 = 3.78°."""
    result = judged(with_play(play))
    assert result.faults == (TrainFault.LOOSE,)
    assert degrees(result.most_play) == pytest.approx(180 / 64 + 180 / 61 * 21 / 64)


def test_rows_in_any_order_are_no_train():
    columns = with_play(0.6)
    rows = np.random.default_rng(7).permutation(len(columns["run"]))
    mixed = {name: values[rows] for name, values in columns.items()}
    order = np.argsort(mixed["run"], kind="stable")
    result = judged({name: values[order] for name, values in mixed.items()})
    assert result.faults[0] == TrainFault.OUT_OF_ORDER
    assert not result.designs


def test_rows_sorted_by_the_input_are_a_reservation():
    columns = with_play(0.6)
    order = np.lexsort((columns["input_angle_deg"], columns["run"]))
    result = judged({name: values[order] for name, values in columns.items()})
    assert result.noisy
    assert result.readiness != Readiness.READY


def test_noise_is_held_against_the_play():
    columns = with_play(0.6)
    noise = np.random.default_rng(8).standard_normal(len(columns["run"]))
    loud = judged({**columns, "output_angle_deg": columns["output_angle_deg"] + 0.6 * noise})
    assert TrainFault.NOISE in loud.faults
    some = judged({**columns, "output_angle_deg": columns["output_angle_deg"] + 0.13 * noise})
    assert some.readiness == Readiness.RESERVATIONS


def test_angles_that_no_train_gives_are_refused():
    columns = with_play(0.6)
    turned, followed = columns["input_angle_deg"], columns["output_angle_deg"]
    exchanged = {"run": columns["run"], "input_angle_deg": followed, "output_angle_deg": turned}
    with pytest.raises(FileError, match="both angles are exchanged"):
        judged(exchanged)
    names = {"input_angle_deg": "output_angle_deg", "output_angle_deg": "input_angle_deg"}
    assert DESIGNED.judge_train(Measured(exchanged), columns=names).readiness == Readiness.READY
    with pytest.raises(FileError, match="the output stands still"):
        judged({**columns, "output_angle_deg": 0 * followed + 1.0})
    rocked = np.tile([0.0, 4.0, 8.0, 4.0], 12)
    with pytest.raises(FileError, match="turn on by more"):
        judged({"input_angle_deg": rocked, "output_angle_deg": rocked / RATIO})


def test_each_fault_has_its_own_step(tmp_path, monkeypatch, capsys):
    """The last line of the command names what belongs to the reason; a lag of the input gives play below 0."""
    from cadgen.cli import interrupt, main

    monkeypatch.setattr(interrupt, "install", lambda: None)
    monkeypatch.chdir(tmp_path)
    Path("reducer.toml").write_text(DESIGN)
    columns = with_play(0.0)
    way = np.sign(np.diff(columns["input_angle_deg"], prepend=-1))
    columns["output_angle_deg"] = columns["output_angle_deg"] + 0.15 * way
    rows = zip(*(values.tolist() for values in columns.values()), strict=True)
    Path("angles.csv").write_text("\n".join([",".join(columns), *(",".join(map(str, row)) for row in rows)]) + "\n")
    monkeypatch.setattr(sys, "argv", ["cadgen", "calibrate", "reducer.toml", "angles.csv"])
    with pytest.raises(SystemExit) as left:
        main()
    said = " ".join(capsys.readouterr().out.split())
    assert left.value.code == 1
    assert "next: read both angles at the same moment" in said
    assert "order that is left" not in said
    assert len({fault.step for fault in TrainFault}) == len(TrainFault)


def test_a_part_of_a_turn_says_nothing_of_the_rate():
    """Run-out within a quarter of a turn of the output looks like a rate."""
    stages = plain()
    stages[1].driven.off = 0.05
    result = judged(table(stages, 0.001, np.random.default_rng(9), turns=0.2, step_deg=0.5))
    assert abs(result.errors.rate.value) > 1e-4
    assert TrainFault.RATE not in result.faults
    assert result.readiness == Readiness.RESERVATIONS
