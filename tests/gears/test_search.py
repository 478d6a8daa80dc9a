"""Orders and searched trains against brute force that shares nothing with the search but one stage's play."""

from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import permutations, product
from math import degrees, inf, prod, radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from cadgen import Design
from cadgen.errors import DesignError
from cadgen.gears import chains
from cadgen.gears.backlash import stage_play
from cadgen.gears.contact import contact_ratio, missing_shift
from cadgen.gears.layout import Blanks, lay_out
from cadgen.gears.pair import GradedGear
from cadgen.gears.sliding import loss_factor
from cadgen.gears.spur import SpurPair
from cadgen.gears.synthesis import (
    SearchLimits,
    TrainSearch,
    _stage,
    all_orders,
    arrange,
    front_of,
    losses_of,
    pairs_within,
    search_trains,
    size_of,
)
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub


def pair(z1: int, z2: int, module: float = 0.5, width: float = 5.0, **driver_overrides: float) -> SpurPair:
    driver, driven = (GradedGear(form=GearForm(teeth=z, normal_module=module, width=width)) for z in (z1, z2))
    return SpurPair(
        driver=replace(driver, overrides=ToleranceOverrides(**driver_overrides)),
        driven=driven,
        centre_distance=module * (z1 + z2) / 2,
        bearing_span=80.0,
    )


def paper() -> Train:
    return Train((pair(30, 150, b_r=0.052), pair(40, 120), pair(40, 120)))


def return_error(stages) -> float:
    """Eq. 25, shaft by shaft."""
    lag = 0.0
    for stage in stages:
        lag = lag / float(stage.ratio) + stage_play(stage).B_max
    return lag


def brute_force(limits: SearchLimits) -> list[tuple[float, tuple[SpurPair, ...]]]:
    """Every train within the limits by plain loops, best first."""
    fewest, most = limits.teeth
    candidates = []
    for module, width in product(limits.modules, limits.widths):
        for z1, z2 in product(range(fewest, most + 1), repeat=2):
            if (
                limits.centre_distance[0] <= module * (z1 + z2) / 2 <= limits.centre_distance[1]
                and limits.stage_ratio[0] <= z2 / z1 <= limits.stage_ratio[1]
                and module * min(z1, z2) >= 5
            ):
                made = pair(z1, z2, module, width)
                thinning = limits.pattern.thinning
                made = replace(
                    made, driver=replace(made.driver, thinning=thinning), driven=replace(made.driven, thinning=thinning)
                )
                if keeps_the_limits_in_mesh(made, limits):
                    candidates.append(made)
    teeth = [(stage.driver.form.teeth, stage.driven.form.teeth) for stage in candidates]
    found = []
    for chain in product(range(len(candidates)), repeat=limits.stages):
        wheels = prod([teeth[number][1] for number in chain]) * limits.ratio.denominator
        pinions = prod([teeth[number][0] for number in chain]) * limits.ratio.numerator
        if wheels == pinions or abs(wheels / pinions - 1) <= limits.ratio_tolerance:
            stages = tuple(candidates[number] for number in chain)
            lag = 0.0
            for stage in stages:
                lag = lag / float(stage.ratio) + play_of(stage).B_max
            found.append((lag, stages))
    return sorted(found, key=lambda entry: entry[0])


play_of = cache(stage_play)  # many of the limits below allow the same pairs


@cache
def mesh_figures(made: SpurPair) -> tuple[float, float]:
    """Contact ratio and greatest missing profile shift of a pair as cut."""
    play = play_of(made)
    cut = made.cut_to(*((role.E_sns + role.E_sni) / 2 for role in (play.driver, play.driven)))
    return contact_ratio(cut), max(missing_shift(gear.form) for gear in (cut.driver, cut.driven))


def keeps_the_limits_in_mesh(made: SpurPair, limits: SearchLimits) -> bool:
    """By the tooth curves of the one pair, as cut."""
    play = play_of(made)
    if made.base_backlash(made.centre_distance - play.f_a, play.driver.E_sns + play.driven.E_sns) <= 0:
        return False
    if (limits.contact_ratio, limits.undercut) == (0.0, inf):
        return True
    overlap, undercut = mesh_figures(made)
    return overlap >= limits.contact_ratio and undercut <= limits.undercut


def within(**changes) -> SearchLimits:
    limits = SearchLimits(
        ratio=Fraction(6),
        stages=2,
        teeth=(10, 30),
        modules=(0.5,),
        widths=(5.0,),
        centre_distance=(5.0, 20.0),
        bearing_span=80.0,
        pattern=pair(20, 20).driver,
        stage_ratio=(0.0, inf),
        contact_ratio=0.0,
        undercut=inf,
        keep=25,
    )
    return replace(limits, **changes)


@pytest.mark.slow
@pytest.mark.parametrize("case", range(20))
def test_the_search_over_fewer_stages_finds_what_brute_force_finds(case):
    """Of all numbers of stages, without pairs of equal gears where fewer stages reach the ratio."""
    generator = np.random.default_rng(case)
    low = int(generator.integers(10, 16))
    teeth = low, low + int(generator.integers(4, 6))
    gears = [
        Fraction(*generator.integers(teeth[0], teeth[1] + 1, 2).tolist()) for _ in range(int(generator.integers(1, 4)))
    ]
    limits = within(stages=3, teeth=teeth, ratio=prod(gears, start=Fraction(1)), fewer=True, keep=40)
    expected: list[tuple[float, tuple[SpurPair, ...]]] = []
    for count in (1, 2, 3):
        longer = brute_force(replace(limits, stages=count, fewer=False))
        if expected:
            longer = [each for each in longer if all(stage.ratio != 1 for stage in each[1])]
        expected += longer
    expected.sort(key=lambda entry: entry[0])
    found = search_trains(limits)
    assert len(found) == min(limits.keep, len(expected)) > 0
    assert [play.return_error_max for play in found] == pytest.approx([lag for lag, _ in expected[: len(found)]])


@pytest.mark.slow
@pytest.mark.parametrize(
    "limits",
    [
        within(),
        within(contact_ratio=1.35, ratio=Fraction(3)),
        within(contact_ratio=1.2, undercut=0.5, stage_ratio=(1.0, 10.0), ratio=Fraction(4)),
        within(undercut=0.0, ratio=Fraction(3, 2)),
        within(pattern=replace(pair(20, 20).driver, thinning=-0.05)),
        within(pattern=replace(pair(20, 20).driver, thinning="least"), contact_ratio=1.2, ratio=Fraction(4)),
        within(stages=1, ratio=Fraction(3)),
        within(stages=1, ratio=Fraction(31, 10), ratio_tolerance=0.05),
        within(ratio=Fraction(5), ratio_tolerance=0.002),
        within(teeth=(10, 18), modules=(0.5, 0.6), widths=(4.0, 5.0, 12.0), ratio=Fraction(9, 4)),
        within(stages=3, teeth=(10, 16), ratio=Fraction(3)),
        within(stages=3, teeth=(20, 25), ratio=Fraction(1), keep=60),
        within(stages=3, teeth=(10, 16), ratio=Fraction(5, 2), ratio_tolerance=0.01),
        within(stages=4, teeth=(10, 14), ratio=Fraction(252, 125), stage_ratio=(1.0, 1.4)),
        within(centre_distance=(9.0, 11.0), ratio=Fraction(4)),
    ],
)
def test_the_search_finds_what_brute_force_finds(limits):
    expected, found = brute_force(limits), search_trains(limits)
    assert len(found) == min(limits.keep, len(expected)) > 0
    assert [play.return_error_max for play in found] == pytest.approx([lag for lag, _ in expected[: len(found)]])
    every_train = {stages for _, stages in expected}
    assert all(play.train.stages in every_train for play in found)
    assert len({play.train for play in found}) == len(found)


@pytest.mark.slow
@settings(deadline=None, max_examples=30)
@given(st.lists(st.tuples(st.integers(20, 90), st.integers(20, 90)), min_size=1, max_size=4))
def test_all_orders_are_ranked_and_complete(choice):
    train = Train(tuple(pair(z1, z2) for z1, z2 in choice))
    ranked = all_orders(train)
    assert {play.train.stages for play in ranked} == set(permutations(train.stages))
    assert len(ranked) == len(set(permutations(train.stages)))
    errors = [play.return_error_max for play in ranked]
    assert errors == sorted(errors)
    assert errors == pytest.approx([return_error(play.train.stages) for play in ranked])
    assert {play.train.ratio for play in ranked} == {train.ratio}


@settings(deadline=None, max_examples=30)
@given(st.lists(st.tuples(st.integers(20, 50), st.integers(51, 120)), min_size=2, max_size=5))
def test_the_best_order_of_reductions_is_that_of_the_exchange_argument(choice):
    # Swapping neighbours p, q behind which nothing changes gains when B_q (1 − 1/i_p) < B_p (1 − 1/i_q): the
    # best order has B / (1 − 1/i) falling towards the output.
    stages = [pair(z1, z2) for z1, z2 in choice]
    by_rule = sorted(stages, key=lambda stage: -stage_play(stage).B_max / (1 - 1 / float(stage.ratio)))
    best = all_orders(Train(tuple(stages)))[0]
    assert best.return_error_max == pytest.approx(return_error(by_rule))


def test_the_paper_s_reordering_is_the_best_of_its_three_orders():
    ranked = arrange(paper(), "reordered")
    assert [degrees(play.return_error_max) for play in ranked] == pytest.approx([0.724, 0.902, 0.962], abs=5e-4)
    assert [stage.ratio for stage in ranked[0].train.stages] == [3, 3, 5]
    assert arrange(paper(), "as-given")[0].return_error_max == ranked[-1].return_error_max


def test_the_search_beats_the_reordering_within_the_paper_s_own_sizes():
    limits = SearchLimits.like(paper())
    assert limits.ratio == 45
    assert (limits.teeth, limits.centre_distance) == ((30, 150), (40.0, 45.0))
    best = arrange(paper(), "search")[0]
    assert best.train.ratio == 45
    assert best.return_error_max < arrange(paper(), "reordered")[0].return_error_max
    assert best.return_error_max == pytest.approx(return_error(best.train.stages))
    for stage in best.train.stages:
        assert 40 <= stage.centre_distance <= 45
        assert stage.driver.overrides == ToleranceOverrides()


def test_searched_gears_take_the_pattern_s_grade_and_form():
    pattern = GradedGear(
        form=GearForm(
            teeth=20,
            normal_module=1.0,
            width=5.0,
            normal_pressure_angle=radians(25),
            addendum_factor=0.9,
            rack_tip_radius_factor=0.3,
        ),
        grade=9,
        overrides=ToleranceOverrides(b_r=0.01),
    )
    gear = search_trains(within(pattern=pattern))[0].train.stages[0].driven
    assert (gear.grade, gear.form.addendum_factor, gear.form.normal_module) == (9, 0.9, 0.5)
    assert gear.form.normal_pressure_angle == radians(25)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"teeth": (40, 10)}, "teeth run from 40 to 10; give the lesser first"),
        ({"centre_distance": (20.0, 5.0)}, "centre_distance run from 20 to 5"),
        ({"stage_ratio": (3.0, 1.0)}, "stage_ratio run from 3 to 1"),
        ({"teeth": (3, 10)}, "allows 3 teeth; give at least 4"),
        ({"stages": 0}, "0 stages; give 1 to 6"),
        ({"stages": 7}, "7 stages; give 1 to 6"),
        ({"ratio": Fraction(0)}, "ratio = 0; give a value above 0"),
        ({"bearing_span": -1.0}, "bearing_span = -1"),
        ({"keep": 0}, "keep = 0"),
        ({"ratio_tolerance": -0.1}, "ratio_tolerance = -0.1; give 0 up to 1"),
        ({"modules": ()}, "no module or no face width"),
        ({"contact_ratio": -1.0}, "contact_ratio = -1; give 0 or more"),
        ({"undercut": -1.0}, "undercut = -1; give 0 or more"),
    ],
)
def test_empty_limits_are_refused(changes, said):
    with pytest.raises(DesignError, match=said):
        within(**changes)


def test_a_ratio_out_of_reach_says_what_was_searched():
    with pytest.raises(DesignError, match=r"2 stages with 10 to 30 teeth and axes 5 to 20 mm apart, .* ratio 101/7"):
        search_trains(within(ratio=Fraction(101, 7)))
    with pytest.raises(DesignError, match="no train of 2 stages"):
        search_trains(within(centre_distance=(1.0, 2.0)))
    with pytest.raises(DesignError, match=r"module 0\.3 mm"):
        search_trains(within(modules=(0.3,), teeth=(20, 40)))


def test_stages_of_different_grade_angle_or_span_are_not_searched_for():
    """The search gives all stages one of each: taken from one stage, the others' would be dropped without a word."""
    made = paper()
    one = made.stages[1]
    for changed, said in (
        (replace(one, driver=replace(one.driver, grade=9)), "one tolerance grade, and those given have 7 and 9"),
        (replace(one, bearing_span=300.0), "one bearing span in mm, and those given have 80 and 300"),
        (
            replace(
                one,
                driver=replace(one.driver, form=replace(one.driver.form, normal_pressure_angle=radians(25))),
                driven=replace(one.driven, form=replace(one.driven.form, normal_pressure_angle=radians(25))),
            ),
            "one pressure angle in degrees, and those given have 20 and 25",
        ),
    ):
        with pytest.raises(DesignError, match=said):
            SearchLimits.like(Train((made.stages[0], changed, made.stages[2])))


@pytest.mark.slow
@pytest.mark.parametrize("collar", [Hub(diameter=7.0, length=1.0), None])
def test_only_trains_that_can_be_laid_out_are_searched_for(collar):
    """Against the unrestricted list, sieved by laying the trains out: bores, hubs, collars, shafts and bearings."""
    limits = within(teeth=(14, 36), ratio=Fraction(4), keep=9000, widths=(4.0, 9.0), bearing_span=17.0)
    blanks = Blanks(
        drive=Blank(bore_diameter=5.0),
        intermediate=Blank(bore_diameter=2.0, hub=collar),
        output=Blank(bore_diameter=6.0),
    )

    def laid_out(play):
        try:
            lay_out(thinned(play.train), blanks, clearance=0.3)
        except DesignError:
            return False
        return True

    everything = search_trains(limits)
    expected = {play.train for play in everything if laid_out(play)}
    found = search_trains(limits, blanks, 0.3)
    assert 0 < len(expected) < len(everything) / 3 < limits.keep
    assert {play.train for play in found} == expected
    errors = [play.return_error_max for play in found]
    assert errors == sorted(errors)
    with pytest.raises(DesignError, match=r"no train of 2 stages .* gears that fit their blanks"):
        search_trains(limits, replace(blanks, output=Blank(bore_diameter=40.0)))


def test_a_pair_that_is_excluded_stands_nowhere():
    search = TrainSearch(within())
    before = search.best(25)
    bad = before[0].train.stages[0]
    search.exclude(bad)
    after = search.best(25)
    assert all(bad not in play.train.stages for play in after)
    kept = [play.train for play in before if bad not in play.train.stages]
    assert [play.train for play in after[: len(kept)]] == kept


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"contact_ratio": 1.9}, "none has a contact ratio of 1.9; allow more teeth"),
        ({"teeth": (8, 10), "modules": (0.8,), "undercut": 0.1}, "each has more undercut than 0.1; allow more teeth"),
        ({"pattern": replace(pair(20, 20).driver, thinning=0.0)}, "none has play at the closest axes"),
        (
            {"pattern": GradedGear(form=GearForm(teeth=20, normal_module=0.5, width=5.0, addendum_factor=1.5))},
            "none clears the roots by 0.12 modules",
        ),
    ],
)
def test_a_limit_that_no_pair_keeps_is_named(changes, said):
    with pytest.raises(DesignError, match=said):
        search_trains(within(**changes))


def test_usual_limits_are_widened_to_the_train_given():
    limits = SearchLimits.like(paper())
    assert (limits.stage_ratio, limits.contact_ratio, limits.undercut) == ((1.0, 10.0), 1.2, 0.5)
    wide = SearchLimits.like(Train((pair(12, 144), pair(40, 30))))
    cut = thinned(Train((pair(12, 144),))).stages[0]
    assert wide.stage_ratio == (0.75, 12.0)
    assert 1.1 <= wide.contact_ratio <= contact_ratio(cut) < wide.contact_ratio + 0.02
    assert missing_shift(cut.driver.form) <= wide.undercut < missing_shift(cut.driver.form) + 0.02


def test_six_stages_are_searched_through_and_a_search_without_end_is_given_up(monkeypatch):
    # 2330 pairs and 1.6e20 chains: only good bounds come to an end.
    limits = replace(SearchLimits.like(paper()), stages=6)
    best = search_trains(limits)
    assert best[0].return_error_max == pytest.approx(return_error(best[0].train.stages))
    assert best[0].train.ratio == 45
    # With pairs of ratio 1 left out, no sixth stage betters five of its own.
    assert best[0].return_error_max > search_trains(replace(limits, stages=5))[0].return_error_max
    monkeypatch.setattr(chains, "MOST_TRIED", 10_000)
    with pytest.raises(DesignError, match=r"has not ended after .* narrow the teeth"):
        search_trains(limits)
    with pytest.raises(DesignError, match=r"997 tooth numbers, 2 modules and 3 widths .* more than 4 million pairs"):
        search_trains(replace(limits, teeth=(4, 1000), modules=(0.5, 0.6), widths=(4.0, 5.0, 6.0)))


@pytest.mark.parametrize("case", range(20))
def test_the_front_is_that_of_brute_force(case):
    """Trains that no other beats in both greatest return error and sum of centre distances, of one to three stages."""
    generator = np.random.default_rng(100 + case)
    low, stages = int(generator.integers(10, 16)), 2 if case % 4 else 3
    teeth = low, low + int(generator.integers(4, 10) if stages == 2 else generator.integers(3, 5))
    gears = [Fraction(*generator.integers(teeth[0], teeth[1] + 1, 2).tolist()) for _ in range(stages)]
    modules = (0.5,) if stages == 3 else (0.5, 0.6)
    limits = within(stages=stages, teeth=teeth, ratio=prod(gears, start=Fraction(1)), modules=modules, fewer=True)
    every: list[tuple[float, tuple[SpurPair, ...]]] = []
    for count in range(1, stages + 1):
        longer = brute_force(replace(limits, stages=count, fewer=False))
        every += [each for each in longer if not every or all(stage.ratio != 1 for stage in each[1])]
    points = sorted({(round(lag, 12), round(sum(stage.centre_distance for stage in made), 9)) for lag, made in every})
    expected: list[tuple[float, float]] = []
    for point in points:
        if not expected or point[1] < expected[-1][1] - 1e-9:
            expected.append(point)
    found, whole = front_of(limits)
    assert whole
    assert [play.return_error_max for play in found] == pytest.approx([lag for lag, _ in expected])
    assert [size_of(play.train) for play in found] == pytest.approx([size for _, size in expected])


@pytest.mark.parametrize("case", range(12))
def test_the_front_with_losses_is_that_of_brute_force(case):
    """Trains that no other beats in return error, size and sum of loss factors, of one and two stages."""
    generator = np.random.default_rng(200 + case)
    low = int(generator.integers(10, 16))
    teeth = low, low + int(generator.integers(4, 9))
    gears = [Fraction(*generator.integers(teeth[0], teeth[1] + 1, 2).tolist()) for _ in range(2)]
    limits = within(stages=2, teeth=teeth, ratio=prod(gears, start=Fraction(1)), modules=(0.5, 0.6), fewer=True)
    every: list[tuple[float, tuple[SpurPair, ...]]] = []
    for count in (1, 2):
        longer = brute_force(replace(limits, stages=count, fewer=False))
        every += [each for each in longer if not every or all(stage.ratio != 1 for stage in each[1])]
    points = {
        (
            round(lag, 11),
            round(sum(stage.centre_distance for stage in made), 8),
            round(sum(loss_factor(stage.as_cut()) for stage in made), 8),
        )
        for lag, made in every
    }
    kept = [one for one in points if not any(o != one and all(np.less_equal(o, one)) for o in points)]
    found, whole = front_of(limits, losses=True)
    assert whole
    figures = [(play.return_error_max, size_of(play.train), losses_of(play.train)) for play in found]
    assert np.sort(figures, axis=0) == pytest.approx(np.sort(kept, axis=0), abs=2e-8)


def test_loss_factors_of_pairs_at_once_are_those_of_each():
    limits = within(teeth=(12, 40), stages=1)
    pairs = pairs_within(limits)
    rows = np.random.default_rng(3).integers(0, pairs.driver.size, 12)
    search = TrainSearch(replace(limits, stages=1, fewer=False), pairs=pairs)
    for row in rows.tolist():
        made = _stage(pairs, row, search._limits)
        assert pairs.losses(limits)[row] == pytest.approx(loss_factor(made.as_cut()), abs=1e-9)


def test_a_design_asks_for_the_smallest_train_and_the_front(tmp_path):
    file = tmp_path / "three.toml"
    file.write_text(
        "[train]\nmodule_mm = 0.5\nwidth_mm = 5.0\nbearing_span_mm = 60.0\nfriction_coefficient = 0.1\n"
        "friction_source = 'estimated'\n[train.search]\nobjective = 'size'\n"
        "[[train.stages]]\ndriver = { teeth = 30 }\ndriven = { teeth = 90 }\n"
        "[[train.stages]]\ndriver = { teeth = 36 }\ndriven = { teeth = 72 }\n"
    )
    train = Design.load(file, train_only=True).gears("search")
    front = train.facts()["front"]
    assert len(front) > 3
    assert [each["size_mm"] for each in front] == sorted((each["size_mm"] for each in front), reverse=True)
    assert [each["greatest"] for each in front] == sorted(each["greatest"] for each in front)
    made = sum(stage.centre_distance for stage in train.layout.train.stages)
    assert made == pytest.approx(min(each["size_mm"] for each in front))
    assert all(0.9 < each["efficiency"] < 1 for each in front)
    assert "front" not in Design.load(file, ["train.search.objective="], train_only=True).gears("search").facts()
