"""Paths that are planned for a study: each distinct one once, and used as it was planned."""

import pytest

from cadgen.api.design import Design
from cadgen.api.exploration import explore
from cadgen.design.load import packaged_studies
from cadgen.errors import DesignError
from cadgen.studies.planned_paths import Planner, path_key
from cadgen.studies.sampling import plan
from cadgen.studies.study_figures import kind_of
from cadgen.studies.study_file import read_study
from tests.exploration.test_figures import evaluated_of

STUDY = """
objectives = ["drift_mm", "return_error_deg"]
checks = []
[plan]
kind = "full_factorial"
[replan]
[[vary]]
key = "replan.within_mm"
values = [0.0, 3.0]
[[vary]]
key = "optimize.order"
values = ["as-given", "reordered"]
[[vary]]
key = "cam.base_radius_mm"
values = [70.0, 75.0]
"""


def test_designs_share_the_path_that_they_do_not_change(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY)
    study, _ = read_study(file)
    values = [plan("full_factorial", study.variations, study.count, 1)(number) for number in range(study.count)]
    assert {path_key(study, each) for each in values} == {None, '{"replan.within_mm": 3.0}'}
    file.write_text(STUDY.replace("[replan]", '[replan]\nplanned_for = ["cam.base_radius_mm"]'))
    study, _ = read_study(file)
    assert {path_key(study, each) for each in values} == {
        None,
        '{"replan.within_mm": 3.0, "cam.base_radius_mm": 70.0}',
        '{"replan.within_mm": 3.0, "cam.base_radius_mm": 75.0}',
    }


def test_a_path_is_planned_for_what_changes_along(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY + 'along = { "path.offset_mm" = [10.0, 12.0] }\n')
    study, _ = read_study(file)
    assert path_key(study, (3.0, "as-given", 75.0)) == (
        '{"replan.within_mm": 3.0, "cam.base_radius_mm": 75.0, "path.offset_mm": 12.0}'
    )


def test_a_path_that_takes_too_long_is_a_row(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY + "[each]\nseconds = 0.01\n")
    study, _ = read_study(file)
    planned = Planner.of(study).planned('{"replan.within_mm": 3.0}')
    assert (planned.text, planned.fault) == ("", "its path: it took longer than 0.01 s (each.seconds)")


def test_room_for_the_scatter_of_the_cars_is_planned_as_the_study_says(tmp_path, monkeypatch):
    asked = []

    def refused(design, text, drawn, wanted):
        asked.append((wanted.reserve, wanted.within))
        raise DesignError("no more than that is asked here")

    monkeypatch.setattr("cadgen.studies.planned_paths.plan_design", refused)
    file = tmp_path / "study.toml"
    for given, key in (("", "{}"), ("reserve = 2.0", "{}"), ("reserve = 2.0", '{"replan.reserve": 1.0}')):
        file.write_text(STUDY.replace("[replan]", f"[replan]\n{given}"))
        study, _ = read_study(file)
        Planner.of(study).planned(key)
    assert asked == [(0.0, 25.0), (2.0, 25.0), (1.0, 25.0)]


def test_the_packaged_study_is_read():
    study, _ = read_study(packaged_studies()["paper_car"])
    values = list(map(plan("sobol", study.variations, study.count, 1), range(study.count)))
    assert study.count == 2000
    assert len({path_key(study, each) for each in values}) == 13
    assert len(set(values)) == 2000


@pytest.mark.slow
@pytest.mark.long
def test_a_path_is_planned_once_and_used(tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY)
    computed = explore(file, tmp_path, processes=1)
    assert len(computed.computed.journals[0].paths) == 1
    rows = list(computed.rows())
    assert [row["state"] for row in rows] == ["kept"] * 8
    drawn = kind_of("drift_mm").of(evaluated_of())
    assert rows[0]["drift_mm"] == drawn
    assert all(planned["drift_mm"] < kept["drift_mm"] for kept, planned in zip(rows[:4], rows[4:], strict=True))
    written = computed.write()
    best = next(each.path for each in written if each.name.endswith("best_1.toml"))
    design = Design.load(best)
    assert len(design.values.path.control_points_mm) > 10
    again = evaluated_of(str(best))
    assert kind_of("drift_mm").of(again) == computed.front[0]["drift_mm"]
