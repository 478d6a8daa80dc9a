"""How the study of rates counts, and how a journal goes on."""

import json

import numpy as np
import pytest

from tests.studies import rates
from tests.studies.journal import outcomes, share

RIGHT = {
    "kind": "lift",
    "sort": "single",
    "truth": ["phase"],
    "size": 9.0,
    "noise": 4.0,
    "verdict": "traced",
    "claimed": ["phase"],
    "reported": ["phase"],
    "limit": 0.98,
    "least": [0.01, 0.02, 0.03],
    "errors": [0.02],
    "sigmas": [0.5],
}


def test_rows_count_names_of_all_kinds_and_of_each():
    unsure = {**RIGHT, "claimed": [], "reported": ["phase", "zero"], "errors": [0.04], "sigmas": [2.5]}
    wrong = {**RIGHT, "kind": "track", "claimed": ["phase", "zero"], "limit": 1.0}
    quiet = {**RIGHT, "sort": "none", "truth": [], "claimed": []}
    text = "\n".join(rates.table([RIGHT, unsure, wrong, quiet]))
    assert f"| single effect named | ≥ 95.5 % | {share(2, 3)} | {share(1, 2)} | - | - | {share(1, 1)} |" in text
    assert f"| a wrong name, one effect or two | ≤ 1 % | {share(1, 3)} | {share(0, 2)} |" in text
    assert f"| nothing there: named | ≤ 1 % | {share(0, 1)} |" in text
    assert "| the judge names | | 98.7 % | 98.0 % |" in text
    assert "| over the judge's | ≤ 1.25 | 1.00 | 1.50 |" in text
    assert [row.split(" | ")[5] for row in rates.wanting([RIGHT, unsure, wrong, quiet])] == ["-", "phase, zero"]


def test_any_first_part_of_the_cases_has_all_sorts():
    first = rates.keys(100, 1)[:100]
    assert {(kind, sort) for _, kind, sort, _ in first} == {(k, s) for k in rates.KINDS for s in rates.SHARES} | {
        ("track", "scattered")
    }
    assert len(set(rates.keys(100, 1))) == len(rates.keys(100, 1)) == 2700


def test_an_interval_is_wilsons():
    n, p, z = 500, 5 / 500, 1.959964
    middle, wide = p + z * z / (2 * n), z * np.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    low, high = (100 * (middle - wide) / (1 + z * z / n), 100 * (middle + wide) / (1 + z * z / n))
    assert share(5, 500) == f"1.0 % of 500 ({low:.1f}-{high:.1f})"


def square(number: int) -> dict[str, int]:
    """A case."""
    return {"square": number**2}


def test_a_journal_goes_on_where_it_was(tmp_path):
    log = tmp_path / "log"
    log.write_text(json.dumps([[1], {"square": -1}]) + "\n")  # kept, and not made again
    found = outcomes(square, [(1,), (2,), (3,)], log, processes=1)
    assert found == [{"square": -1}, {"square": 4}, {"square": 9}]
    assert len(log.read_text().splitlines()) == 3
    assert outcomes(square, [(3,), (1,)], log) == [{"square": 9}, {"square": -1}]


@pytest.mark.slow
@pytest.mark.parametrize(("kind", "sort"), [("transmission", "three"), ("track", "single")])
def test_a_case_of_each_sort_is_judged(kind, sort):
    found = rates.judged(7, kind, sort, 0)
    assert set(found["claimed"]) <= set(found["truth"])
    if sort == "three":
        assert 0.5 < found["held"] < rates.AS_QUIET
    else:
        assert 0.0 <= found["limit"] <= 1.0
        assert len(found["errors"]) == len(found["truth"])
