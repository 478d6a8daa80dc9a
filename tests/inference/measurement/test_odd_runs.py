"""Runs in another unit or of another car are named among good ones, and no good run is."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.design.load import load_design
from cadgen.inference.measurement.odd_runs import odd_runs
from cadgen.inference.measurement.record import join
from cadgen.inference.records.load import load
from cadgen.jobs.calibration.calibration import calibrate
from cadgen.jobs.calibration.sources import read
from tests.inference.measurement import study

KINDS = ("lift_a", "lift_d", "track_a", "track_c", "transmission_b")


@pytest.mark.parametrize("name", [*KINDS, pytest.param("profile_a", marks=[pytest.mark.slow, pytest.mark.long])])
@pytest.mark.parametrize(("factor", "unit"), [(0.1, "cm"), (1 / 25.4, "inches")])
def test_a_run_in_another_unit_is_named(name, factor, unit, measured, nominal):
    record = load(measured / f"{name}.csv")
    assert odd_runs(record, nominal.model) == {}
    columns = {c: np.where(record.run == 1, record[c] * factor, record[c]) for c in record.kind.readings}
    found = odd_runs(replace(record, columns=record.columns | columns), nominal.model)
    assert list(found) == [1]
    assert (f"it seems to be in {unit} and not in mm" in found[1]) == (record.kind.reading_unit == "mm")


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("lift_a", "lift_b"),
        ("lift_b", "lift_e"),
        ("track_a", "track_b"),
        ("track_c", "track_a"),
        ("transmission_a", "transmission_b"),
    ],
)
def test_a_run_of_another_car_is_named(name, other, measured, nominal):
    good, bad = (load(measured / f"{each}.csv") for each in (name, other))
    found = odd_runs(join([bad.only(np.array([0])), good]), nominal.model)
    assert list(found) == [0]
    assert "of another car" in found[0]


def test_a_copy_of_a_run_is_left_out_and_no_good_run_is_odd_beside_it(measured, nominal):
    """Its noise is another's, and beside such a pair the other runs seemed to be of another car."""
    record = load(measured / "transmission_a.csv")
    first, last = record.only(np.array([0])), record.only(np.array([record.runs - 1]))
    found = odd_runs(join([first, first, last]), nominal.model)
    assert list(found) == [1]
    assert "it is a copy" in found[1]
    # An instrument of coarse steps repeats itself in all runs, and none of them is a copy.
    assert odd_runs(join([first, first, first]), nominal.model) == {}


def test_no_good_run_is_odd_however_it_was_started(synthetic_car, nominal):
    """Drawn cars, tracks among them whose runs start up to 3 degrees and centimetres apart."""
    for number in range(12):
        kind = ("lift", "transmission", "track")[number % 3]
        sort = "scattered" if kind == "track" and number % 2 else "pair"
        case = study.draw(synthetic_car, kind, sort, np.random.default_rng([78, number]))
        assert odd_runs(case.record, nominal.model) == {}, (number, kind, sort)


@pytest.mark.slow
def test_the_report_warns_of_the_run_and_judges_the_others(measured, tmp_path):
    lines = (measured / "lift_e.csv").read_text().splitlines()
    bad = tmp_path / "lift.csv"
    head = [line for line in lines if line.startswith(("#", "run"))]
    rows = [line.split(",") for line in lines if line not in head]
    last = rows[-1][0]
    at = head[-1].split(",").index("lift_mm")
    rows = [[*r[:at], f"{float(r[at]) / 10:.5f}", *r[at + 1 :]] if r[0] == last else r for r in rows]
    bad.write_text("\n".join([*head, *(",".join(row) for row in rows)]) + "\n")
    told = calibrate(load_design(), "actual", read([bad]))
    assert next(str(w) for w in told.warnings if "left out" in w).startswith(f"run {last} of lift.csv is left out")
    assert told.diagnoses[0].judgement.claimed == ("lever gain",)
