"""Cards of settings against a car that is driven by code of its own, and against brute force."""

import csv
import json

import numpy as np
import pytest

from cadgen import Design
from cadgen.errors import DesignError
from tests.studies import draws

S_COURSE = draws.DATA / "s_course.toml"
STEPS = {"disc_moved_mm": 0.05, "head_moved_mm": 0.005, "wheel_radius_mm": 0.05, "start_x_mm": 1.0}


@pytest.fixture(scope="module")
def s_course():
    return draws.judges("s_course", 300)


@pytest.fixture(scope="module")
def eight():
    return draws.judges("eight", 200)


@pytest.fixture(params=draws.NAMES)
def judged(request):
    return request.getfixturevalue(request.param)


@pytest.mark.slow
def test_settings_keep_the_course_and_have_the_errors_of_the_card(judged):
    card, rows = judged
    assert card.passed, card.sentences
    for judge in rows:
        error, room = judge.checked()
        print(judge.row["spacing_mm"], judge.row["error_mm"], error, judge.row["room_mm"], room)
        assert error == pytest.approx(judge.row["error_mm"], abs=0.05)
        assert room == pytest.approx(judge.row["room_mm"], abs=0.05)
        assert room > 0


@pytest.mark.slow
def test_the_worst_error_is_that_of_a_brute_force_search(judged):
    _, rows = judged
    worst = max(rows, key=lambda judge: judge.row["error_mm"])
    card, best = worst.brute(1500, np.random.default_rng(1))
    print(worst.row["spacing_mm"], card, best)
    assert card <= 1.05 * best


@pytest.mark.slow
def test_card_as_files(s_course, tmp_path):
    card, _ = s_course
    written = card.write(tmp_path)
    table, page = sorted(each.path for each in written)
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert [float(row["spacing_mm"]) for row in rows] == [700, 1000, 1300]
    assert {row["kept"] for row in rows} == {"yes"}
    assert (float(rows[1]["disc_moved_mm"]), float(rows[1]["head_moved_mm"]), float(rows[1]["error_mm"])) == (0, 0, 0)
    for row, values in zip(rows, card.settings, strict=True):
        # To the divisions that the design gives.
        for key, step in (
            ("disc_moved_mm", 0.05),
            ("head_moved_mm", 0.005),
            ("wheel_radius_mm", 0.05),
            ("start_x_mm", 1),
        ):
            assert float(row[key]) / step == pytest.approx(round(float(row[key]) / step), abs=1e-3)
            assert float(row[key]) == values[key]
    html = page.read_text()
    assert "@page { size: A4" in html
    assert html.count("<tr>") == 4
    assert "http" not in html
    entry = json.loads((tmp_path / "manifest.json").read_text())["parts"]["s_draw_card"]
    assert entry["passed"]
    assert entry["worst_error_mm"] == max(each.error for each in card.computed.drawn)


@pytest.mark.slow
def test_spacings_that_are_not_kept_are_marked(tmp_path):
    """A lane that is too narrow for the wide draws: the field does not move with the posts."""
    narrow = ["course.spacing.step_mm=600", "course.field.corner_mm=[-1000, -420]", "course.field.size_mm=[11200, 840]"]
    card = Design.load(S_COURSE, narrow).card("actual")
    assert [row["kept"] for row in card.settings] == [True, False]
    assert not card.passed
    assert card.sentences[0] == "the course is not kept at 1 of 2 spacings, posts 700 to 1300 mm apart"
    assert card.sentences[1].startswith("posts 1300 mm apart: edge of the field ")
    page = next(each.path for each in card.write(tmp_path) if each.path.suffix == ".html")
    assert page.read_text().count('<tr class="not">') == 1


@pytest.mark.parametrize(
    ("overrides", "sentence"),
    [
        (
            ["course.spacing.from_mm=1400"],
            "course.spacing.from_mm is 1400, more than course.spacing.to_mm, 1300",
        ),
        (["course.spacing.from_mm=1300"], "course.spacing.from_mm and to_mm are both 1300, so nothing is drawn"),
        (["course.spacing.nominal_mm=600"], "course.spacing.nominal_mm is 600, outside of what is drawn, 700 to 1300"),
        (["course.spacing.step_mm=1"], "more than 200 spacings: raise it to 3 or more"),
        (["course.spacing="], "course.spacing is missing"),
        (["settings="], "settings is missing, which says what can be set on the car"),
        (
            ["settings.disc_from_mm=-2"],
            "settings.disc_from_mm is -2, but with posts 700 mm apart the disc must",
        ),
        (["settings.disc_to_mm=0"], "set settings.disc_to_mm to 9.0, or bring course.spacing.to_mm nearer to 1000"),
        (["settings.disc_from_mm=-27"], "less than the rod's radius: raise it to -25.0 or more"),
        (["settings.disc_to_mm=30"], "past the end of the rod: lower it, or raise follower.length_mm"),
        (["settings.wheel_from_mm=70"], "no drive wheel for posts 700 mm apart"),
        (["settings.wheel_from_mm=130"], "settings.wheel_from_mm is 130, more than wheel_to_mm, 120: exchange them"),
        (["settings.wheel_from_mm="], "settings has only one of wheel_from_mm and wheel_to_mm"),
        (["settings.wheel_radii_mm=[60, 80]"], "not both"),
        (["settings.head_from_mm=-50", "cam.base_radius_mm=52"], "settings.head_from_mm is -50"),
        (["train=", "car.drive_wheel_radius_mm="], "train is missing, and without its ratio"),
    ],
)
def test_wrong_input_is_one_sentence_with_key_and_cure(overrides, sentence):
    with pytest.raises(DesignError) as refused:
        Design.load(S_COURSE, overrides).card("actual")
    print(refused.value)
    assert sentence in str(refused.value)
    assert "\n" not in str(refused.value)
