"""A slice of the study of worn cams, and how it counts."""

from tests.studies import worn_cams

CASE = {
    "sort": "lift",
    "strange": False,
    "wear": "bell",
    "follower": "flat",
    "lift_um": 2.0,
    "grid": 1.0,
    "flanks": [
        {
            "law": "cycloidal",
            "said": ["cycloidal"],
            "worn": True,
            "ends_deg": [0.1, -0.2],
            "rise_um": -1.0,
            "lift_um": 2.0,
            "doubtful": False,
        }
    ],
}


def test_rows_count_named_undecided_and_wrong_cams() -> None:
    two = {**CASE, "flanks": [{**CASE["flanks"][0], "said": ["trapezoid", "cycloidal"]}]}
    wrong = {**CASE, "flanks": [{**CASE["flanks"][0], "said": ["trapezoid"], "lift_um": 9.0}]}
    text = "\n".join(worn_cams.table([CASE, two, wrong]))
    assert "| law of every flank named rightly | ≥ 18 of 20 | 0 | 1 |" in text
    assert "| undecided between two, the truth among them | ≤ 2 | 0 | 1 |" in text
    assert "| wrong | 0 | 0 | 1 |" in text
    assert "| ends of segments, worn flanks, greatest error, degrees | ≤ 0.6 | 0.000 | 0.200 |" in text
    assert len(worn_cams.wanting([CASE, two, wrong])) == 4


def test_a_slice_of_the_study_keeps_its_bars() -> None:
    cases = [worn_cams.judged(*key) for key in worn_cams.keys(3, 5) if not key[3]]
    for case in cases:
        for flank in case["flanks"]:
            assert flank["law"] in flank["said"]
            assert max(map(abs, flank["ends_deg"])) < (0.6 if flank["worn"] else 0.05)
