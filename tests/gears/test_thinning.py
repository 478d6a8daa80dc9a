"""Thinning, and what is said of teeth that it destroys: the stage, the limit and what thins most."""

from dataclasses import replace
from math import pi

import pytest

from cadgen.errors import DesignError
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tolerances import ToleranceOverrides
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned, train_play


def pair(z1: int = 30, z2: int = 150, span: float = 80.0, grade: int = 7, f_a: float | None = None, **given: float):
    driver, driven = (GradedGear(form=GearForm(teeth=z, normal_module=0.5, width=5.0), grade=grade) for z in (z1, z2))
    return SpurPair(
        driver=replace(driver, overrides=ToleranceOverrides(**given)),
        driven=driven,
        centre_distance=(z1 + z2) / 4,
        bearing_span=span,
        centre_distance_deviation=f_a,
    )


@pytest.mark.parametrize(
    ("changes", "source"),
    [
        (
            {"span": 5000.0},
            r"has no flank left.*, cut with E_sn.*most of it for j_n = 69\d\d.*span of 5000 mm",
        ),
        ({"grade": 12}, r"bearing span of 80 mm"),
        ({"f_a": 10.0}, r"most of it for f_a = 10000 µm"),
        ({"b_r": 10.0}, r"most of it for T_sn = 7279.. µm, from F_r = 18 and b_r = 10000 µm"),
    ],
)
def test_teeth_thinned_away_name_the_stage_and_what_thins_most(changes, source):
    play = train_play(Train((pair(40, 120), pair(**changes))))
    with pytest.raises(DesignError, match=rf"in stage 2, the gear with 30 teeth of module 0\.5 .*{source}"):
        thinned(play.train)


def test_a_limit_that_cannot_be_cut_is_named_though_the_middle_could():
    play = train_play(Train((pair(b_r=0.5),)))
    with pytest.raises(DesignError, match=r"in stage 1, .*at the lower limit of its thickness.*b_r = 500 µm"):
        thinned(play.train)


def cut_to(made: SpurPair, thinning) -> SpurPair:
    return replace(made, driver=replace(made.driver, thinning=thinning), driven=replace(made.driven, thinning=thinning))


def test_a_given_thinning_is_blamed_itself():
    with pytest.raises(DesignError, match=r"E_sn = -10000 µm, which is given; thin it to no more than E_sn = -\d+ µm"):
        thinned(Train((cut_to(pair(), -10.0),)))


def test_a_tooth_that_fails_at_full_thickness_is_not_blamed_on_thinning():
    made = pair()
    pointed = replace(made.driver, form=replace(made.driver.form, profile_shift=1.6))
    play = train_play(Train((replace(made, driver=pointed, centre_distance=45.78),)))
    with pytest.raises(DesignError, match=r"in stage 1, the gear with 30 teeth of module 0\.5 has pointed teeth"):
        thinned(play.train)


@pytest.mark.parametrize("choice", ["least", "middle", "greatest", -0.05, 0.02])
def test_teeth_are_cut_to_what_is_asked_and_their_zone_lies_about_it(choice):
    """Eq. 8's zone moves with the thickness; what opens the play moves with it, by the sum of both gears' shifts."""
    grade = train_play(Train((pair(20, 60),))).stages[0]
    play = train_play(Train((cut_to(pair(20, 60), choice),)))
    moved, shifts = play.stages[0], []
    for gear, own, limits in zip(
        (g.form for s in thinned(play.train).stages for g in (s.driver, s.driven)),
        (moved.driver, moved.driven),
        (grade.driver, grade.driven),
        strict=True,
    ):
        wanted = {
            "least": limits.E_sns,
            "middle": (limits.E_sns + limits.E_sni) / 2,
            "greatest": limits.E_sni,
        }.get(choice, choice)
        assert gear.tooth_thickness_deviation == pytest.approx(wanted)
        assert gear.tooth_thickness == pytest.approx(0.5 * pi / 2 + wanted)
        assert own.T_sn == limits.T_sn
        assert (own.E_sns, own.E_sni) == pytest.approx((wanted + own.T_sn / 2, wanted - own.T_sn / 2))
        shifts.append(wanted - (limits.E_sns + limits.E_sni) / 2)
    assert moved.j_bnmax == pytest.approx(grade.j_bnmax - sum(shifts))
    assert moved.j_bnmin == pytest.approx(grade.j_bnmin - sum(shifts))
    assert play.return_error_max == pytest.approx(moved.j_bnmax / 15)
