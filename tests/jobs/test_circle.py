"""The whole circle on one car; `python -m tests.jobs.circle` goes round with more."""

import numpy as np
import pytest
from click.testing import CliRunner

from cadgen.cli import cli
from cadgen.jobs.calibration import files as calibration_files
from cadgen.output.files import formats
from cadgen.registry import Registry
from tests.jobs import circle


def cadgen(*arguments: str) -> None:
    result = CliRunner().invoke(cli, arguments)
    assert result.exit_code == 0, result.output


@pytest.fixture(autouse=True)
def only_what_the_circle_reads(monkeypatch):
    """Pictures and the other formats, which take long, have tests of their own."""
    monkeypatch.setattr(calibration_files, "save", lambda *content: [])
    monkeypatch.setattr(formats, "FORMATS", Registry("format", [formats.FORMATS.kind_of("dxf")]))


@pytest.mark.slow
@pytest.mark.long
def test_a_car_without_play_is_not_given_the_tabled_one(carbon_free_car, tmp_path):
    """Against the tabled return error the new cam would end some 1000 mm off."""
    rng = np.random.default_rng(8)
    wheels = circle.draw(rng, play=False)
    round_ = circle.go_round(carbon_free_car, wheels, rng, tmp_path, cadgen)
    print(f"{round_.before:.0f} mm -> {round_.after:.1f} mm: {100 * round_.gone:.2f} % gone")
    assert round_.before > 500
    assert round_.gone >= 0.95
    (play,) = (one for one in round_.told["as_built"] if one["effect"] == "backlash")
    assert play["place"] == "car"
    assert play["values"][0]["value"] == 0
    assert 0 < play["values"][0]["sigma"] < 0.02


@pytest.mark.slow
@pytest.mark.long
def test_a_measured_car_gets_the_cam_that_it_needs(carbon_free_car, tmp_path):
    rng = np.random.default_rng(7)
    wheels = circle.draw(rng)
    round_ = circle.go_round(carbon_free_car, wheels, rng, tmp_path, cadgen)
    print(f"{round_.before:.0f} mm -> {round_.after:.1f} mm: {100 * round_.gone:.2f} % gone")
    assert round_.before > 500
    assert round_.gone >= 0.95
    (told,) = round_.told["records"]
    assert told["verdict"] == "combination"
    assert sorted(told["claimed"]) == ["backlash", "steering zero", "wheel radius"]
    found = {value["name"]: value["value"] for one in told["effects"] for value in one["values"]}
    assert found["steering_zero_deg"] == pytest.approx(np.degrees(wheels.zero), abs=0.02)
