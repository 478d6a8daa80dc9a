"""The error budget: what each thing costs at the finish, before and after a trim."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from cadgen.arrays import TURN
from cadgen.cam.contact import roll
from cadgen.car.running.drive import drive
from cadgen.car.running.mechanics import Mechanics
from cadgen.car.running.sampled import sampled_lift
from cadgen.deviations.deviation import (
    BASE_RADIUS,
    COLUMNS,
    ECCENTRIC_BORE,
    INNER_FACE,
    PROFILE_OFFSET,
    ROD_RADIUS,
    START_HEADING,
    STEERING_ZERO,
    TOLERANCES,
    WOBBLE,
    tolerance,
)
from cadgen.errors import DesignError
from cadgen.inference.monte_carlo.budget import HALF_WIDTHS, by_process, error_budget
from cadgen.inference.monte_carlo.cars import nominal_cars
from cadgen.inference.monte_carlo.random_cars import Tolerances, errors_of_cars, sensitivities, tolerance_run

GRID = np.linspace(0.0, TURN, 1800, endpoint=False)
PLAY = np.radians(0.738)


@pytest.fixture(scope="module")
def contact(carbon_free_car):
    return roll(carbon_free_car.actual.curve.outline(0.1), carbon_free_car.follower, GRID)


@pytest.fixture(scope="module")
def fleet(carbon_free_car, contact):
    built = carbon_free_car
    return nominal_cars(
        contact,
        built.follower,
        built.car,
        built.track.length,
        built.lift,
        drive(built.lift, built.car, built.track.length, steps=360),
        wheel_radius=63.7,
        play=PLAY,
        stations=(180, 360),
        mechanics=Mechanics(follower=built.follower, friction=0.1),
    )


def end(built, tan_beta, play, turn=0.0) -> complex:
    """End of a run that is driven, not reckoned, with the front wheel turned against the rod."""
    lift = sampled_lift(GRID, np.tan(np.arctan(tan_beta) + turn), blend_start=built.lift.blend_start)
    following = Mechanics(follower=built.follower, friction=0.1).leads(built.lift).follow(lift, play)
    run = drive(lift, built.car, built.track.length, steps=90, stop=built.lift.blend_start, following=following)
    return complex(*run.drive_wheel[-1])


@pytest.mark.parametrize("name", ["inner_face", "rod_radius", "play"])
def test_costs_are_those_of_cars_driven_and_trimmed_by_search(name, fleet, contact, carbon_free_car):
    """A car rolled anew with the deviation, and the best turn of its wheel found by a search along it."""
    built, half = carbon_free_car, {"inner_face": 0.1, "rod_radius": 0.02, "play": np.radians(0.2)}[name]
    given = ({}, {"the gears": half}) if name == "play" else ({tolerance(name): half}, {})
    (cost,) = error_budget(fleet, *given).costs
    wanted = end(built, contact.q, PLAY)
    before, after = [], []
    for side in (-half, half):
        rod, play = built.follower, PLAY
        if name == "play":
            play += side
        else:
            field = {"inner_face": "inner", "rod_radius": "radius"}[name]
            rod = replace(rod, **{field: getattr(rod, field) + side})
        T = roll(built.actual.curve.outline(0.1), rod, GRID).q
        before.append(abs(end(built, T, play) - wanted))
        search = minimize_scalar(lambda turn, T=T, play=play: abs(end(built, T, play, turn) - wanted), (-1e-3, 1e-3))
        after.append(search.fun)
    print(f"{name}: {cost.before:.1f} and {cost.after:.1f} mm; driven {max(before):.1f} and {max(after):.1f} mm")
    assert cost.before == pytest.approx(max(before), rel=0.02)
    assert cost.after == pytest.approx(max(after), rel=0.05, abs=0.6)
    assert cost.repeats


def test_a_trim_takes_out_what_repeats_and_nothing_else(fleet):
    halves = {"steering_zero": 0.002, "start_heading": 0.003, "base_radius": 0.005, "edge_wear": 0.05}
    halves = {tolerance(name): half for name, half in halves.items()}
    found = {cost.name: cost for cost in error_budget(fleet, halves, {}).costs}
    assert found["steering_zero"].after < 1e-3 < found["steering_zero"].before
    for name in ("start_heading", "base_radius"):
        assert found[name].after == found[name].before
        assert not found[name].repeats
    assert found["edge_wear"].after < 0.2 * found["edge_wear"].before


def test_the_worst_direction_is_found_and_the_ranking_goes_by_what_a_trim_leaves(fleet):
    budget = error_budget(fleet, {ECCENTRIC_BORE: 0.01, WOBBLE: 0.001, PROFILE_OFFSET: 0.01}, {})
    assert [cost.after for cost in budget.costs] == sorted((cost.after for cost in budget.costs), reverse=True)
    assert budget.costs[0].name == "eccentricity"
    (known,) = (one for one in sensitivities(fleet, Tolerances(half_widths={"eccentricity": 0.01})) if one.share)
    assert budget.costs[0].before == pytest.approx(known.distance, rel=0.01)
    assert budget.before**2 == pytest.approx(sum(cost.before**2 for cost in budget.costs))
    assert budget.after < budget.before


def test_a_trim_takes_out_disc_and_rod_that_are_too_large(fleet):
    """Cars that are trimmed are counted without them; what is left of them is under 1 %."""
    costs = error_budget(fleet, {PROFILE_OFFSET: 0.01, ROD_RADIUS: 0.005}, {}).costs
    assert len(costs) == 2
    assert all(cost.after < 0.01 * cost.before for cost in costs)


def test_processes_are_ranked_by_what_they_hold(fleet):
    found = by_process(fleet)
    assert found["wire-cut"].before < found["milled"].before < found["laser-cut"].before < found["printed"].before
    assert all(set(halves) <= set(TOLERANCES) for halves in HALF_WIDTHS.values())
    assert {cost.name for cost in found["printed"].costs if cost.rough} == {"profile_offset", "eccentricity"}
    assert not any(cost.rough for cost in found["milled"].costs)


def test_nothing_that_may_be_off_has_an_empty_budget(fleet):
    assert error_budget(fleet, {}, {}).before == 0


def test_directions_are_drawn_evenly_and_sizes_by_their_law(fleet):
    halves = {"eccentricity": 0.02, "edge_wear": 0.1, "start_y": 1.0}
    drawn = dict(
        zip(
            COLUMNS,
            Tolerances(half_widths=halves, law="uniform").draw(np.random.default_rng(1), 20000, 0.01).T,
            strict=True,
        )
    )
    along, across = drawn["eccentricity_0"], drawn["eccentricity_90"]
    assert np.hypot(along, across).max() <= 0.02
    assert along.std() == pytest.approx(0.02 / 6**0.5, rel=0.03)
    assert abs(np.corrcoef(along, across)[0, 1]) < 0.02
    assert drawn["edge_wear"].min() >= 0
    assert drawn["edge_wear"].mean() == pytest.approx(0.05, rel=0.02)


def test_other_tolerances_leave_the_numbers_of_a_seed_as_they_are():
    plain, more = (
        dict(
            zip(
                COLUMNS,
                Tolerances(half_widths=halves, play=(0.01, 0.02)).draw(np.random.default_rng(3), 50, 0.015).T,
                strict=True,
            )
        )
        for halves in ({"start_y": 1.0}, {"start_y": 1.0, "wobble": 0.001, "friction": 0.1})
    )
    for name in ("start_y", "play"):
        np.testing.assert_array_equal(plain[name], more[name])
    assert more["friction"].any()
    assert not plain["friction"].any()


@pytest.mark.parametrize(
    ("name", "half", "words"),
    [
        ("eccentricity", 0.3, "tolerances.eccentricity_mm is 0.3 mm, which turns the front wheel"),
        ("temperature", 90.0, "tolerances.temperature_K is 90 K, which turns the front wheel"),
        ("wheel_runout", 7.0, "more than a tenth of the 63.7 mm"),
        ("edge_break", 0.5, "tolerances.edge_break_mm is 0.5 mm"),
        ("steering_lost_motion", np.radians(0.5), "tolerances.steering_lost_motion_deg is 0.5 degrees"),
    ],
)
def test_what_is_beyond_first_order_is_refused(fleet, contact, carbon_free_car, name, half, words):
    from cadgen.deviations.first_order import Expansion, steering_derivatives

    hot = Expansion(disc=70e-6, frame=23e-6)
    warm = replace(
        fleet, expansion=hot, derivatives=steering_derivatives(contact, carbon_free_car.follower, expansion=hot)
    )
    with pytest.raises(DesignError, match=words):
        tolerance_run(warm, Tolerances(half_widths={name: half}), 1, seed=1)


@pytest.mark.slow
def test_cars_of_a_run_are_trimmed_as_a_search_of_the_steering_finds(fleet):
    """A repeating deviation leaves of each car what no other turn of its steering makes less."""
    repeating = {STEERING_ZERO: radians(0.02), PROFILE_OFFSET: 0.01, INNER_FACE: 0.05, ECCENTRIC_BORE: 0.01}
    cars = Tolerances(half_widths=repeating, trimmed=True)
    ends = tolerance_run(fleet, cars, 12, seed=1).distance
    drawn = cars.draw(np.random.default_rng(np.random.SeedSequence(1, spawn_key=(0,))), 12, fleet.play)
    for row, end in zip(drawn, ends, strict=True):

        def turned(turn, row=row):
            one = row.copy()
            one[STEERING_ZERO.column] += turn
            errors = errors_of_cars(fleet, one[None, :])
            return float(np.hypot(errors.along[0, -1], errors.across[0, -1]))

        least = minimize_scalar(turned, bounds=(-5e-3, 5e-3), method="bounded", options={"xatol": 1e-9}).fun
        assert end == pytest.approx(least, abs=0.02 + 0.002 * turned(0.0))
    untrimmed = tolerance_run(fleet, replace(cars, trimmed=False), 12, seed=1).distance
    assert ends.max() < 0.5 * untrimmed.max()


@pytest.mark.slow
def test_a_trim_takes_nothing_fleeting_out_but_adds_that_of_the_trial_run(fleet):
    """Along the way on which a turn of the steering moves the end two runs scatter; across it, one."""
    fleet = replace(fleet, play=0.0)
    turned = np.zeros((2, len(COLUMNS)))
    turned[1, STEERING_ZERO.column] = 1e-4
    rate = np.diff(
        [each[:, -1] for each in (errors_of_cars(fleet, turned).along, errors_of_cars(fleet, turned).across)]
    )
    way = complex(*rate[:, 0]) / np.hypot(*rate[:, 0])
    for varied, runs in (({START_HEADING: radians(0.2)}, 2.0), ({BASE_RADIUS: 0.005}, 1.0)):
        cars = Tolerances(half_widths=varied)
        before, after = (
            (each.along + 1j * each.across) / way
            for each in (tolerance_run(fleet, replace(cars, trimmed=trim), 1000, seed=1) for trim in (False, True))
        )
        np.testing.assert_allclose(after.imag, before.imag, atol=0.1)
        assert after.real.var() == pytest.approx(runs * before.real.var(), rel=0.1)
