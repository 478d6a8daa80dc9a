"""Errors of a train from its transmission, on angles of exact eccentric gears that another program made."""

import sys
from math import cos, degrees, radians
from pathlib import Path

import numpy as np
import pytest

from cadgen.api.design import Design
from cadgen.api.measured import Measured
from cadgen.errors import DesignError, FileError
from cadgen.inference.gearing.wheel_errors import PitchOrEncoder, RunOut
from cadgen.verdict import Readiness
from tests.inference.gearing.train_truth import Stage, Wheel, table

DESIGN = """
name = "reducer"
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 40.0
grade = 8
[[train.stages]]
driver = { teeth = 20 }
driven = { teeth = 61 }
[[train.stages]]
driver = { teeth = 21 }
driven = { teeth = 64 }
"""
COS = cos(radians(20.0))
DESIGNED = Design.from_toml(DESIGN, train_only=True)


def stages(**changes):
    made = [
        Stage(Wheel(20, 0.02, 0.4), Wheel(61, 0.03, 1.1), play=0.10),
        Stage(Wheel(21, 0.025, -2.0), Wheel(64, 0.04, 2.5), play=0.18, tooth=0.002),
    ]
    for key, value in changes.items():
        setattr(made[1].driven, key, value)
    return made


def plain():
    return [Stage(Wheel(20), Wheel(61), play=0.10), Stage(Wheel(21), Wheel(64), play=0.18)]


def judged(columns, remarks=()):
    return DESIGNED.judge_train(Measured(columns, remarks))


@pytest.fixture(scope="module")
def made():
    return judged(table(stages(), 0.003, np.random.default_rng(1), step_deg=1.3))


def parts(result):
    return {(p.wheel.stage, p.wheel.driver): p for each in result.shafts for p in each.parts if isinstance(p, RunOut)}


def test_run_out_of_each_wheel_is_told_apart(made):
    """Four wheels, two of them on one shaft, each with its size and its direction."""
    truth = {(1, True): (0.02, 0.4), (1, False): (0.03, 1.1), (2, True): (0.025, -2.0), (2, False): (0.04, 2.5)}
    found = parts(made)
    assert set(found) == set(truth)
    for place, (off, towards) in truth.items():
        part = found[place]
        assert abs(part.eccentricity - off) < 4 * part.eccentricity_sigma + 0.01 * off
        high = towards if place[1] else np.pi - towards
        assert abs(np.angle(np.exp(1j * (part.high - high)))) < radians(1.5)
    assert not any(isinstance(part, PitchOrEncoder) for each in made.shafts for part in each.parts)


def test_play_and_tooth_mesh_have_their_sizes(made):
    """Play is that of all stages at the output, from arcs along the lines of action."""
    truth = degrees(0.18 / (32 * COS) + 0.10 / (30.5 * COS) * 21 / 64)
    assert degrees(made.errors.play.value) == pytest.approx(truth, rel=0.01)
    (mesh,) = (line for line in made.errors.lines if line.meshes and not line.shafts)
    assert mesh.meshes == ((2, 1),)
    assert mesh.size == pytest.approx(0.002 / (32 * COS), rel=0.08)
    assert made.errors.explained
    assert made.errors.noise == pytest.approx(radians(0.003), rel=0.05)


def test_a_wheel_turned_as_said_is_as_good_as_said(made):
    """The other program turns it and measures again."""
    (turning,) = made.turnings
    turned = stages()
    turned[0].driven.towards += turning.angle
    again = judged(table(turned, 0.003, np.random.default_rng(2), step_deg=1.3))
    line = again.errors.line_of(2)
    assert line.size == pytest.approx(turning.after, rel=0.03)
    assert line.size < 0.6 * turning.before


def test_the_corrected_design_has_the_wanted_play(made):
    """The thinning that it says, cut by the other program: along the line of action E_sn is E_sn cos(alpha)."""
    change = made.wanted
    thinner = stages()
    thinner[1].play -= change.thinning * COS
    again = judged(table(thinner, 0.003, np.random.default_rng(3), step_deg=1.3))
    assert again.errors.play.value == pytest.approx(change.wanted, rel=0.01)
    assert again.wanted is None or abs(again.wanted.thinning) < 2e-3
    written = Design.from_toml(made.designs["reducer_corrected"], train_only=True)
    driven = written.values.train.stages[1].driven
    assert driven.E_sn_um == pytest.approx(1e3 * change.driven, abs=0.01)


def test_an_encoder_off_its_axis_is_no_run_out():
    columns = table(plain(), 0.003, np.random.default_rng(4), step_deg=1.3)
    columns["output_angle_deg"] = columns["output_angle_deg"] + 0.05 * np.sin(
        np.radians(columns["output_angle_deg"]) + 1.0
    )
    result = judged(columns)
    (shaft,) = result.shafts
    (part,) = shaft.parts
    assert isinstance(part, PitchOrEncoder)
    assert degrees(abs(part.line)) == pytest.approx(0.05, rel=0.02)
    assert result.readiness == Readiness.READY


def test_pitch_that_is_off_shows_at_its_harmonics():
    train = plain()
    train[1].driven.pitch = {2: (0.02, 0.3), 5: (0.01, 1.0)}
    result = judged(table(train, 0.003, np.random.default_rng(5), step_deg=1.3))
    found = {line.shafts[0]: line.size for line in result.errors.lines}
    assert set(found) == {(3, 2), (3, 5)}
    assert found[3, 2] == pytest.approx(0.02 / (32 * COS), rel=0.02)
    assert result.errors.explained


def test_of_noise_nothing_is_named():
    """Forty records of noise, half of it alike from row to row."""
    rng, named = np.random.default_rng(6), 0
    columns = table(plain(), 0.0, rng, runs=2, turns=1.1, step_deg=4.0)
    for number in range(30):
        noise = rng.standard_normal(len(columns["run"]))
        if number % 2:
            for k in range(1, len(noise)):
                noise[k] += 0.7 * noise[k - 1]
        result = judged({**columns, "output_angle_deg": columns["output_angle_deg"] + 0.003 * noise})
        named += len(result.errors.lines)
    assert named <= 1


def test_an_order_of_no_part_is_said():
    columns = table(plain(), 0.003, np.random.default_rng(7), step_deg=1.3)
    turn = np.radians(columns["output_angle_deg"])
    result = judged({**columns, "output_angle_deg": columns["output_angle_deg"] + 0.02 * np.sin(4.6 * turn)})
    (line,) = (each for each in result.errors.lines if not each.named)
    assert line.order == pytest.approx(4.6, abs=0.2)
    assert result.readiness == Readiness.NOT_READY


def test_other_numbers_of_teeth_are_said():
    train = plain()
    train[1] = Stage(Wheel(21), Wheel(65), play=0.18)
    result = judged(table(train, 0.003, np.random.default_rng(8), step_deg=1.3))
    assert result.errors.rate.value == pytest.approx(64 / 65 - 1, rel=0.01)
    assert result.readiness == Readiness.NOT_READY


def test_teeth_that_pass_between_rows_show_at_another_order():
    """Rows 3.1 degrees apart: the 64 teeth show at order 360/3.1 - 64."""
    train = plain()
    train[1].tooth = 0.004
    result = judged(table(train, 0.002, np.random.default_rng(13), step_deg=3.1))
    (line,) = result.errors.lines
    assert line.order == pytest.approx(360 / 3.1 - 64, abs=0.1)
    assert line.alias is not None
    assert line.alias.order == 64
    assert result.readiness == Readiness.READY


# Play 0.3°, stiffness 40 N m/°, friction 0.8 N m at the output.
PLAY, STIFF, RUB = 0.3, 40.0, 0.8


def loop(rng, sign=1.0):
    """Input held, torque up and down twice; output by the torque that friction leaves."""
    torque = np.concatenate([np.linspace(0, 10, 60), np.linspace(10, -10, 120), np.linspace(-10, 10, 120)])
    rising = np.sign(np.gradient(torque))
    left = torque - RUB * rising
    out = left / STIFF + PLAY / 2 * np.tanh(left / 0.02)
    rows = len(torque)
    return {
        "run": np.ones(rows, dtype=int),
        "input_angle_deg": np.zeros(rows),
        "output_angle_deg": out + 0.002 * rng.standard_normal(rows),
        "output_torque_Nm": sign * torque,
    }


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_load_tells_play_friction_and_wind_up_apart(sign):
    result = judged(loop(np.random.default_rng(9), sign))
    e = result.errors
    assert degrees(e.compliance.value) == pytest.approx(1 / STIFF, rel=0.02)
    assert 2 * degrees(e.friction.value) == pytest.approx(2 * RUB / STIFF, rel=0.1)
    assert degrees(e.play.value) == pytest.approx(PLAY, abs=0.005)
    assert e.readings.pressed == (sign < 0)


def test_one_side_alone_names_twins_and_no_play():
    columns = table(stages(), 0.003, np.random.default_rng(10), step_deg=1.3)
    forward = np.concatenate([[True], np.diff(columns["input_angle_deg"]) > 0])
    result = judged({name: values[forward] for name, values in columns.items()})
    assert result.errors.play is None
    assert not any(each.parts for each in result.shafts)
    assert result.readiness == Readiness.RESERVATIONS
    assert "One side of the teeth alone" in str(result)


def test_names_of_motor_and_cam_are_understood():
    columns = table(plain(), 0.003, np.random.default_rng(11), runs=2, step_deg=4.0)
    other = {"run": columns["run"], "motor_angle_deg": columns["input_angle_deg"]}
    result = judged({**other, "cam_angle_deg": columns["output_angle_deg"]})
    assert degrees(result.errors.play.value) == pytest.approx(0.4086, rel=0.02)


def test_bad_records_are_refused():
    still = {"input_angle_deg": np.zeros(40), "output_angle_deg": np.linspace(0, 1, 40)}
    with pytest.raises(FileError, match="neither the input turns"):
        judged(still)
    with pytest.raises(FileError):
        judged({"input_angle_deg": np.arange(40.0)})
    with pytest.raises(DesignError, match="no gear train"):
        Design.load("roller").judge_train(Measured(still))


def test_the_command_writes_the_corrected_design(tmp_path, monkeypatch, capsys):
    from cadgen.cli import interrupt, main

    monkeypatch.setattr(interrupt, "install", lambda: None)
    monkeypatch.chdir(tmp_path)
    Path("reducer.toml").write_text(DESIGN)
    columns = table(stages(), 0.003, np.random.default_rng(12), runs=2, step_deg=3.1)
    rows = zip(*(values.tolist() for values in columns.values()), strict=True)
    Path("angles.csv").write_text("\n".join([",".join(columns), *(",".join(map(str, row)) for row in rows)]) + "\n")

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["cadgen", "calibrate", *arguments])
        with pytest.raises(SystemExit) as left:
            main()
        return left.value.code

    assert run("reducer.toml", "angles.csv", "--out", "out") == 0
    assert "run-out of the" in capsys.readouterr().out
    assert {path.name for path in Path("out").iterdir()} >= {"reducer_corrected.toml", "reducer_transmission.json"}
    assert run("reducer.toml", "angles.csv", "--next") == 2
    assert "a train is judged alone" in capsys.readouterr().err
