"""The front against a comparison of all with all; effects against models whose shares are known."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen.output.report.study_pictures import ExplorationPicture, exploration_pictures
from cadgen.output.report.style import save
from cadgen.studies.design_row import Row
from cadgen.studies.front import effects, front, ranked
from cadgen.studies.study_figures import StudyFigure

LESS = StudyFigure(code="less_mm", meaning="", of=lambda evaluated: 0.0)
MORE = StudyFigure(code="more_mm", meaning="", of=lambda evaluated: 0.0, more=True)


def rows_of(points: list[tuple[float, ...]]) -> list[Row]:
    return [Row(number, (), "kept", tuple(map(float, point))) for number, point in enumerate(points)]


@settings(deadline=None)
@given(st.lists(st.tuples(st.integers(0, 6), st.integers(0, 6)), max_size=40))
def test_the_front_is_what_no_other_beats(points):
    best = front(rows_of(points), (LESS, MORE))
    beaten = {
        (x, y) for (x, y), (a, b) in product(points, points) if a <= x and b >= y and (a, b) != (x, y)
    }  # less of the first is better, more of the second
    assert {row.figures for row in best} == {(float(x), float(y)) for x, y in set(points) - beaten}
    assert len(best) == len({row.figures for row in best})
    assert all(points.index((int(row.figures[0]), int(row.figures[1]))) == row.number for row in best)


def test_designs_outside_a_limit_are_not_on_the_front():
    rows = [Row(0, (), "outside", (0.0, 9.0)), Row(1, (), "screened", (0.0, None)), Row(2, (), "kept", (5.0, 5.0))]
    assert [row.number for row in front(rows, (LESS, MORE))] == [2]


def test_differences_below_the_resolution_make_no_design_better():
    coarse = StudyFigure(code="coarse_mm", meaning="", of=lambda evaluated: 0.0, resolution=0.1)
    best = front(rows_of([(1.04, 3.0), (1.01, 3.0), (1.0, 2.0), (0.99, 2.5)]), (coarse, LESS))
    assert [row.number for row in best] == [2]


def test_the_best_in_each_objective_come_first():
    best = ranked(rows_of([(0.5, 0.4), (0.0, 0.1), (1.0, 1.0), (0.1, 0.9)]), (LESS, MORE))
    assert [row.number for row in best][:2] == [1, 2]
    assert best[2].number == 3


class _Study:
    keys = ("a", "b", "word")
    figures = (LESS, MORE)


def test_effects_are_the_shares_of_an_additive_model():
    """Of y = 2 a + b, with a and b even on 0 to 1, a explains 4/5 and b 1/5; the word explains all of the other."""
    rng = np.random.default_rng(1)
    a, b, word = rng.random(4000), rng.random(4000), rng.choice(["x", "y", "z"], 4000)
    heights = {"x": 3.0, "y": -1.0, "z": 0.5}
    rows = [Row(n, (a[n], b[n], word[n]), "kept", (float(2 * a[n] + b[n]), heights[word[n]])) for n in range(4000)]
    found = effects(_Study(), rows)
    # Ten groups miss a hundredth of a range's own variance.
    assert found["less_mm"] == pytest.approx({"a": 0.8, "b": 0.2, "word": 0.0}, abs=0.02)
    assert found["more_mm"] == pytest.approx({"a": 0.0, "b": 0.0, "word": 1.0}, abs=0.01)


def test_a_figure_that_does_not_vary_has_no_effects():
    rows = [Row(n, (float(n), 0.0, "x"), "kept", (1.0, None)) for n in range(20)]
    assert effects(_Study(), rows) == {}


class _CoarseStudy:
    keys = ("a",)
    figures = (StudyFigure(code="coarse_mm", meaning="", of=lambda evaluated: 0.0, resolution=0.1),)


@pytest.mark.parametrize(("apart", "seen"), [(0.004, False), (0.4, True)])
def test_a_range_below_the_resolution_is_no_difference(tmp_path, apart, seen):
    """Rounding that follows a key to the last digit is not explained by it, and is not drawn as a range."""
    rows = [Row(n, (float(n),), "kept", (306.1 + apart * n / 19,)) for n in range(20)]
    assert set(effects(_CoarseStudy(), rows)) == ({"coarse_mm"} if seen else set())
    picture = ExplorationPicture(
        title="t", keys=("a",), figures=("coarse_mm", "less_mm"), more=(False, False), resolutions=(0.1, 0.0),
        values=tuple((*row.values, *row.figures, float(row.number)) for row in rows), kept=(True,) * len(rows),
        front=((0.0, 306.1, 0.0),), effects={},
    )  # fmt: skip
    drawn = exploration_pictures(picture)
    assert ("front" in drawn) == seen
    save(drawn["parallel"], tmp_path, "s_parallel")
    assert ("no difference" in (tmp_path / "s_parallel.svg").read_text()) != seen
    # Designs of which none is within the limits have no front.
    assert "front" not in exploration_pictures(replace(picture, front=()))
