"""The as-built design file, and one car from several kinds of data."""

import tomllib
from pathlib import Path

import pytest

from cadgen.design.load import load_design, packaged_designs
from cadgen.measurement.diagnose import Finding, Value
from cadgen.report.text import Heading, Table, plain
from cadgen.workflow.as_built_file import as_built_text
from cadgen.workflow.calibrate import calibrate, read, stated_form_error
from cadgen.workflow.calibrate_files import write_calibration
from cadgen.workflow.calibrate_words import shown, sizes

MEASURED = Path(__file__).parents[1] / "data" / "measured"


@pytest.fixture(scope="module")
def text():
    """The packaged design's own text."""
    return packaged_designs()["carbon_free_car"].read_text()


@pytest.fixture(scope="module")
def car():
    """A car with undeclared play, by its track, its train and zones: the files are of different cars."""
    names = ("transmission_c", "track_c", "paper_section5")
    return calibrate(load_design(), "actual", read([MEASURED / f"{name}.csv" for name in names]))


def test_one_thing_is_at_work_once_and_by_the_data_that_show_it_best(car):
    places = [(one.claim.kind, one.claim.finding.effect, one.place) for one in car.built]
    assert places == [
        ("transmission", "return error", "noted"),
        ("track", "backlash", "car"),
        ("zones", "return error", "noted"),
    ]
    # 1.66, 0.86 and 0.81 degrees are not one return error.
    (play,) = car.shared
    assert not play.agrees


def test_an_as_built_design_is_written_over_by_the_next(car, text):
    once = as_built_text(car, text)
    assert as_built_text(car, once) == once
    # Wherever the earlier table stood.
    head, table = once.split("[as_built]")
    first = f'name = "x"\n\n[as_built]{table}\n{head.replace("name = ", "# name = ")}'
    again = as_built_text(car, first)
    assert again.count("[as_built]") == 1
    assert tomllib.loads(again)["as_built"] == tomllib.loads(once)["as_built"]
    assert tomllib.loads(again)["cam"] == tomllib.loads(once)["cam"]


def test_a_design_without_a_name_keeps_that_of_its_file(car, text, tmp_path):
    (tmp_path / "my car.toml").write_text(text.replace("name = ", "# name = "))
    design = load_design(tmp_path / "my car.toml", ["cam.blend_deg=12", "play.measured_deg=0.7"])
    told = calibrate(design, "actual", read([MEASURED / "paper_section5.csv"]))
    written = write_calibration(told, (tmp_path / "my car.toml").read_text(), tmp_path / "out")
    assert "my_car_as_built.toml" in written.entry["files"]
    again = load_design(tmp_path / "out" / "my_car_as_built.toml")
    assert (again.name, again.play.measured_deg) == ("my_car", 0.7)
    assert again.as_designed().values() == design.values()


def test_a_printed_part_is_known_by_its_remark_or_by_the_user():
    design = load_design()
    zones = MEASURED / "paper_section5.csv"
    machined = calibrate(design, "actual", read([zones]))
    assert (machined.form_error_um, machined.form_error_from) == (2.0, "machined: no file says printed")
    assert calibrate(design, "actual", read([zones]), 5.0).form_error_um == 5.0
    printed = read([MEASURED / "profile_b.csv"])
    assert stated_form_error(printed, None) == (30.0, "profile_b.csv says printed")


@pytest.mark.parametrize(
    ("value", "sigma", "told"),
    [
        (0.55445, 0.00035, ("0.55445", "0.00035")),
        (-39.004, 0.618, ("-39.00", "0.62")),
        (123.4, 12.0, ("123", "12")),
        (1234.5, 100.0, ("1234", "100")),
        (0.1234567, 0.0, ("0.123457", "")),
    ],
)
def test_values_have_the_digits_that_their_uncertainty_allows(value, sigma, told):
    assert shown(Value("x_um", value, sigma, "um")) == told


def test_numbers_that_belong_to_an_effect_are_told_with_it():
    nose = Finding("worn nose", (Value("worn_depth_um", 20.0, 1.0, "um"),), (), (), (("nose_number", 2),))
    assert sizes([nose]) == "worn nose: worn_depth_um 20.0 ± 1.0, nose_number 2"


def test_text_is_folded_but_numbers_are_not():
    table = Table(("name", "value"), (("a very long name of many words", "1234.5678"),))
    folded = plain([Heading("head"), "words " * 30, table], 30)
    assert max(map(len, folded.splitlines())) <= 30
    assert "1234.5678" in folded
    assert folded.endswith("\n")
