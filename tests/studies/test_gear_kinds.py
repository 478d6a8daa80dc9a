"""A small slice of the study of gears of all kinds, and that cures are put in where a refusal names them."""

from tests.studies.gear_kinds import Case, case, cured, run


def test_cases_are_made_again_and_a_slice_has_no_fault():
    assert [case(1, number) for number in range(20)] == [case(1, number) for number in range(20)]
    found = run(5, 4, 1)
    assert not [each for each in found if "fault" in each[1] or "not cured" in each[1]], found


def test_a_cure_is_put_in():
    made = Case(0, "gears", {"stages": [{"kind": "planetary", "planet": {"count": 4}}]})
    better = cured(made, "cadgen: in stage 1, 4 planets do not fit; give planets (planet.count) = 2 or 3")
    assert better.given["stages"][0]["planet"]["count"] == 2
    flags = Case(0, "pair", {"teeth": "20,25"})
    assert cured(flags, "give the ring at least 31 teeth, at a centre_distance_mm of 5.5").given["teeth"] == "20,31"
