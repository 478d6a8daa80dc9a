"""Tolerances against the printed tables of the standards, typed in here, and against their own rules.

ISO 1328-1:1995 tables 1-4 and ISO 1328-2:1997 tables A.1, A.2 and B.1 are the same in GB/T 10095 and
JIS B 1702. Grade 4 of F_i'' at (20-50, 0.2-0.5) and (5-20, 1.0-1.5) mm is left out: the formula gives 9.26
and 9.60 there, next to a rounding border, and the printed values could not be confirmed.
"""

from functools import partial
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cadgen.errors import DesignError
from cadgen.gears import tolerances
from cadgen.gears.tolerances import (
    GRADES,
    IT_DEPARTURES,
    ToleranceOverrides,
    centre_distance_deviation,
    cutting_feed_tolerance,
    flank_tolerance,
    gear_tolerances,
    span_pitch_deviation,
    standard_tolerance,
)

# Values are multiples of 0.1 µm; a difference below this, in µm, is rounding of the binary fraction.
SAME_UM = 1e-9

# (symbol, d, m or b): µm for grades 3 to 12 (4 to 12 for part 2's composite deviations).
PRINTED = [
    ("f_pt", 10, 1, "2.3 3.3 4.7 6.5 9.5 13 19 26 37 53"),
    ("f_pt", 10, 3, "2.6 3.7 5.0 7.5 10 15 21 29 41 59"),
    ("f_pt", 30, 1, "2.5 3.5 5.0 7.0 10 14 20 28 40 56"),
    ("f_pt", 30, 5, "3.0 4.3 6.0 8.5 12 17 24 34 48 68"),
    ("f_pt", 100, 1, "2.7 3.8 5.5 7.5 11 15 21 30 43 61"),
    ("F_p", 10, 1, "5.5 8.0 11 16 23 32 45 64 90 127"),
    ("F_p", 30, 3, "7.5 10 15 21 30 42 59 84 119 168"),
    ("F_p", 100, 1, "9.0 13 18 26 37 52 74 104 147 208"),
    ("F_alpha", 10, 1, "2.3 3.2 4.6 6.5 9.0 13 18 26 37 52"),
    ("F_alpha", 10, 3, "3.3 4.7 6.5 9.5 13 19 26 37 53 75"),
    ("F_alpha", 30, 1, "2.6 3.6 5.0 7.5 10 15 21 29 41 58"),
    ("F_alpha", 100, 1, "2.9 4.1 6.0 8.5 12 17 23 33 47 66"),
    ("F_beta", 10, 5, "3.1 4.3 6.0 8.5 12 17 24 35 49 69"),
    ("F_beta", 10, 15, "3.4 4.9 7.0 9.5 14 19 28 39 55 78"),
    ("F_beta", 30, 5, "3.2 4.5 6.5 9.0 13 18 25 36 51 72"),
    ("F_beta", 100, 5, "3.3 4.7 6.5 9.5 13 19 27 38 53 76"),
    ("F_beta", 100, 15, "3.7 5.5 7.5 11 15 21 30 42 60 84"),
    ("F_r", 10, 1, "4.5 6.5 9.0 13 18 25 36 51 72 102"),
    ("F_r", 30, 1, "5.5 8.0 11 16 23 32 46 65 92 130"),
    ("F_r", 100, 1, "7.5 10 15 21 29 42 59 83 118 167"),
    ("F_i_radial", 10, 0.4, "7.5 11 15 21 30 42 60 85 120"),
    ("F_i_radial", 10, 0.7, "8.0 12 16 23 33 46 66 93 131"),
    ("F_i_radial", 30, 0.7, "10 14 20 28 40 56 80 113 160"),
    ("F_i_radial", 100, 0.4, "12 16 23 33 46 66 93 131 185"),
    ("f_i_radial", 10, 0.4, "1.0 2.0 2.5 3.5 5.0 7.0 10 14 20"),
    ("f_i_radial", 10, 0.7, "2.0 2.5 4.0 5.5 7.5 11 15 22 31"),
    ("f_i_radial", 100, 0.4, "1.5 2.0 2.5 3.5 5.0 7.5 10 15 21"),
]

# ISO 286-1 table 1, IT3 to IT12 in µm by the upper limit of the size step in mm
# (as printed at https://azom.com/article.aspx?ArticleID=1153).
PRINTED_IT = {
    3: "2 3 4 6 10 14 25 40 60 100",
    6: "2.5 4 5 8 12 18 30 48 75 120",
    10: "2.5 4 6 9 15 22 36 58 90 150",
    18: "3 5 8 11 18 27 43 70 110 180",
    30: "4 6 9 13 21 33 52 84 130 210",
    50: "4 7 11 16 25 39 62 100 160 250",
    80: "5 8 13 19 30 46 74 120 190 300",
    120: "6 10 15 22 35 54 87 140 220 350",
    180: "8 12 18 25 40 63 100 160 250 400",
    250: "10 14 20 29 46 72 115 185 290 460",
    315: "12 16 23 32 52 81 130 210 320 520",
    400: "13 18 25 36 57 89 140 230 360 570",
    500: "15 20 27 40 63 97 155 250 400 630",
}

# f_a in µm by the upper limit of the centre distance, as Chinese textbooks print it for GB/T 10095.
PRINTED_F_A = {
    5: {10: 7.5, 18: 9, 30: 10.5, 50: 12.5, 80: 15, 120: 17.5, 180: 20, 250: 23, 315: 26, 400: 28.5},
    7: {10: 11, 18: 13.5, 30: 16.5, 50: 19.5, 80: 23, 120: 27, 180: 31.5, 250: 36, 315: 40.5, 400: 44.5},
    9: {10: 18, 18: 21.5, 30: 26, 50: 31, 80: 37, 120: 43.5, 180: 50, 250: 57.5, 315: 65, 400: 70},
}


def numbers(line: str) -> list[float]:
    return [float(word) for word in line.split()]


@pytest.mark.parametrize(("symbol", "diameter", "other", "line"), PRINTED)
def test_rules_of_iso_1328_give_the_printed_tables(symbol, diameter, other, line):
    printed = numbers(line)
    grades = GRADES[-len(printed) :]
    assert 1000 * np.array([flank_tolerance(symbol, diameter, other, grade) for grade in grades]) == pytest.approx(
        printed, abs=SAME_UM
    )


@pytest.mark.parametrize(("upper", "line"), PRINTED_IT.items())
def test_standard_tolerances_are_those_of_iso_286_over_the_whole_step(upper, line):
    lower = max([0, *(limit for limit in PRINTED_IT if limit < upper)])
    sizes = [lower + 1e-6, (lower + upper) / 2, upper]
    for grade, printed in zip(GRADES, numbers(line), strict=True):
        assert 1000 * standard_tolerance(sizes, grade) == pytest.approx(printed, abs=SAME_UM)


def test_no_departure_of_the_printed_it_table_is_idle(monkeypatch):
    printed = {(grade, upper): um for grade, row in IT_DEPARTURES.items() for upper, um in row.items()}
    monkeypatch.setattr(tolerances, "IT_DEPARTURES", {})
    for (grade, upper), um in printed.items():
        row = tolerances.SIZE_STEPS[1:].index(upper)
        assert tolerances._it_um.__wrapped__(grade)[row] != um


@pytest.mark.parametrize("grade", PRINTED_F_A)
def test_centre_distance_deviation_is_the_textbooks(grade):
    uppers = list(PRINTED_F_A[grade])
    for same in (grade, grade + 1):
        assert 1000 * centre_distance_deviation(uppers, same) == pytest.approx(
            list(PRINTED_F_A[grade].values()), abs=SAME_UM
        )


@pytest.mark.parametrize(
    ("grade", "multiple"), [(4, 1.26 * 25), (5, 39), (6, 1.26 * 39), (7, 62), (8, 1.26 * 62), (9, 100)]
)
def test_cutting_feed_tolerance_follows_the_handbooks(grade, multiple):
    assert 1000 * cutting_feed_tolerance(40, grade) == pytest.approx(multiple, abs=SAME_UM)


def test_values_behind_table_3_of_the_paper():
    small, large = (gear_tolerances(d, 0.5, 5.0, 7) for d in (15.0, 75.0))
    expected = {
        "f_pt": (9.5, 11),
        "F_beta": (12, 13),
        "F_r": (18, 29),
        "F_i_radial": (21, 33),
        "b_r": (43, 74),
    }
    for symbol, values in expected.items():
        assert (1000 * getattr(small, symbol), 1000 * getattr(large, symbol)) == pytest.approx(values)
    assert 1000 * cutting_feed_tolerance(20, 7) == pytest.approx(52)


@given(st.floats(5, 10000), st.floats(0.5, 70), st.sampled_from(GRADES))
def test_runout_is_four_fifths_of_the_total_pitch_deviation(diameter, module, grade):
    runout, pitch = (
        1000 * flank_tolerance("F_r", diameter, module, grade),
        1000 * flank_tolerance("F_p", diameter, module, grade),
    )
    # Each is rounded by at most half a unit of 1 µm, or of 0.5 µm up to 10 µm.
    assert abs(runout - 0.8 * pitch) <= 0.5 + 0.8 * 0.5


@given(st.floats(5, 500), st.floats(0.5, 10), st.floats(4, 1000), st.sampled_from(GRADES[:-2]))
def test_a_coarser_grade_is_never_finer_and_two_grades_double_the_tolerance(diameter, module, width, grade):
    one, next_one, double = (gear_tolerances(diameter, module, width, grade + step) for step in (0, 1, 2))
    for symbol in ("f_pt", "F_beta", "F_r", "F_i_radial"):
        value, next_value, doubled = (1000 * getattr(gear, symbol) for gear in (one, next_one, double))
        assert value < next_value < doubled
        assert doubled == pytest.approx(2 * value, abs=0.5 + 2 * 0.25)
    assert one.b_r < next_one.b_r < double.b_r


@given(st.sampled_from(list(pairwise(tolerances.DIAMETER_STEPS))), st.floats(0.001, 1), st.sampled_from(GRADES))
def test_a_tolerance_is_constant_over_a_step_that_includes_its_upper_limit(step, share, grade):
    lower, upper = step
    inside = lower + share * (upper - lower)
    assert flank_tolerance("f_pt", inside, 2, grade) == flank_tolerance("f_pt", upper, 2, grade)
    assert flank_tolerance("f_pt", upper * (1 + 1e-15), 2, grade) == flank_tolerance("f_pt", upper, 2, grade)


def test_arrays_give_what_their_elements_give():
    diameters = np.array([5.0, 20.0, 20.1, 75.0, 499.0])
    together = gear_tolerances(diameters, 0.5, 5.0, 8)
    for row, diameter in enumerate(diameters):
        alone = gear_tolerances(float(diameter), 0.5, 5.0, 8)
        assert [getattr(together, name)[row] for name in alone.__slots__] == [
            getattr(alone, name) for name in alone.__slots__
        ]


def test_span_deviation_of_two_pitches_exceeds_one_pitch_by_its_formula():
    # Unrounded at grade 5, d = 10 (means 10 and 1): f_pt = 4.679 and 4.679 + 1.6 √(9 · 1) = 9.479.
    assert 1000 * span_pitch_deviation(10, 1, 10, 5) == pytest.approx(9.5)
    with pytest.raises(DesignError, match="1 pitches"):
        span_pitch_deviation(10, 1, 1, 5)


@pytest.mark.parametrize(
    ("rule", "arguments", "said"),
    [
        (partial(flank_tolerance, "f_pt"), (4.9, 1, 7), "reference diameter 4.9 mm .* 5 to 10000 mm"),
        (partial(flank_tolerance, "f_pt"), ([20, 10001], 1, 7), "reference diameter 10001 mm"),
        (partial(flank_tolerance, "f_pt"), (20, 0.4, 7), "module 0.4 mm .* 0.5 to 70 mm"),
        (partial(flank_tolerance, "F_beta"), (20, 3, 7), "face width 3 mm .* 4 to 1000 mm"),
        (partial(flank_tolerance, "F_i_radial"), (1001, 1, 7), "reference diameter 1001 mm .* 5 to 1000 mm"),
        (partial(flank_tolerance, "F_i_radial"), (20, 11, 7), "module 11 mm .* 0.2 to 10 mm"),
        (partial(flank_tolerance, "F_i_radial"), (float("nan"), 1, 7), "reference diameter nan"),
        (standard_tolerance, (501, 7), "size 501 mm .* 0 to 500 mm"),
        (standard_tolerance, (0, 7), "size 0 mm"),
        (standard_tolerance, (20, 2), "IT grade 2 .* 3 to 12"),
        (partial(flank_tolerance, "F_p"), (20, 1, 13), "grade 13 .* 3 to 12"),
        (centre_distance_deviation, (20, 2), "grade 2 .* 3 to 12"),
        (cutting_feed_tolerance, (20, 7.5), r"grade 7\.5 .* 3 to 12"),
    ],
)
def test_what_the_standards_do_not_cover_is_refused_by_value_and_range(rule, arguments, said):
    with pytest.raises(DesignError, match=said):
        rule(*arguments)


def test_an_override_stands_in_for_the_rule_even_outside_its_range():
    overrides = ToleranceOverrides(b_r=0.052)
    assert gear_tolerances(15.0, 0.5, 5.0, 7, overrides).b_r == 0.052
    everything = ToleranceOverrides(f_pt=0.01, F_beta=0.012, F_r=0.018, b_r=0.05, F_i_radial=0.02)
    assert gear_tolerances(2.0, 0.1, 1.0, 7, everything).F_r == 0.018
    with pytest.raises(DesignError, match=r"b_r = -0.1 mm"):
        ToleranceOverrides(b_r=-0.1)
