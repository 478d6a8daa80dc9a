"""Windows of the leads: known play and friction take themselves out, by a second working-out of the run too."""

from dataclasses import replace

import numpy as np
import pytest

from cadgen.arrays import TURN
from cadgen.cam.envelope import actual_profile
from cadgen.car.against_play.band import best_for_band
from cadgen.car.against_play.lead_search import LeadSearch
from cadgen.car.against_play.trial_run import TrialRun
from cadgen.car.against_play.turned_leads import TurnedLeads
from cadgen.car.running.mechanics import Mechanics
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.jobs.cam.steering_cam import plan_cam
from tests.car.running.friction_truth import Cells, Rod, fitting_cells, run_end, steering

# Play, degrees, and friction. With the best single window for all falls these end 92, 96, 99, 81 and 90 mm off, worked
# out elsewhere without the rod's lean.
KNOWN = [(0.738, 0.15), (0.780, 0.15), (0.850, 0.20), (0.750, 0.10), (0.738, 0.30)]
# Cars on which the search is judged, none of which it is given.
OTHERS = [
    (np.radians(play), friction) for play in (0.53, 0.7, 0.84, 0.95) for friction in (0.06, 0.13, 0.17, 0.22, 0.29)
]


def trial(built) -> TrialRun:
    return TrialRun(wanted=built.lift, car=built.car, length=built.track.length)


def worst_trimmed(runs: TrialRun, follower, lift, cars=OTHERS) -> float:
    """Worst end of cars that are trimmed each after a run of its own, mm."""
    forces = [Mechanics(follower=follower, friction=friction) for _, friction in cars]
    ends = [
        runs.trimmed(lift, each.leads(lift), play).error.end_distance
        for (play, _), each in zip(cars, forces, strict=True)
    ]
    return max(ends)


@pytest.mark.parametrize(("play_deg", "friction"), KNOWN)
def test_known_play_and_friction_take_themselves_out(carbon_free_car, play_deg, friction):
    """By cadgen's chain, and by the leaning rod step by step, which shares no code with it."""
    built, play = carbon_free_car, np.radians(play_deg)
    forces = Mechanics(follower=built.follower, friction=friction)
    band = best_for_band(built.lift, built.follower, built.car, built.track.length, (play, play), mechanics=(forces,))
    error = trial(built).error(band.lift, forces.leads(band.lift), play)
    n, _ = fitting_cells(play)
    theta = TURN / n * np.arange(n)
    steps, ds = round(n * built.lift.blend_start / TURN), built.track.length / n
    plane = (built.car.wheelbase, built.car.drive_wheel_offset)
    planned = run_end(built.lift.q(theta + np.pi / n)[:steps], ds, *plane)
    rod = Rod(
        base=built.follower.base_radius,
        inner=built.follower.inner,
        outer=built.follower.outer,
        radius=built.follower.radius,
    )
    tangent = band.lift.q(theta)
    stands = Cells(rod, tangent).stands(friction, 0.0, fitting_cells(play)[1], nudge=1e-9)
    truth = abs(run_end(steering(tangent, stands)[:steps], ds, *plane) - planned)
    way = float(error.distance.max())
    print(
        f"{play_deg} degrees, friction {friction}: {error.end_distance:.2f} mm, on the way {way:.1f} mm, step by step "
        f"{truth:.2f} mm; {np.degrees(band.windows).round(3)} degrees"
    )
    assert error.end_distance <= 1.0
    assert way <= 5.0
    assert truth <= 3.0


def test_the_lift_is_the_wanted_one_but_on_the_leads(carbon_free_car):
    built, play = carbon_free_car, np.radians(0.738)
    forces = Mechanics(follower=built.follower, friction=0.15)
    leads = TurnedLeads(built.lift, built.follower, forces, 1.3 * play)
    intervals = forces.leads(built.lift).intervals
    assert leads.count == len(intervals) == 2
    turned = leads.turned([play, play])
    theta = np.linspace(0.0, TURN, 20001)
    off = theta[np.abs(turned.q(theta) - built.lift.q(theta)) > 1e-9]
    for start, stop in intervals:
        inside = (theta > start + np.radians(2.5)) & (theta < stop)
        np.testing.assert_allclose(turned.q(theta[inside]), built.lift.q(theta[inside] - play), atol=1e-9)
    near = [(off > start - np.radians(0.1)) & (off < stop + np.radians(8.0)) for start, stop in intervals]
    assert np.all(near[0] | near[1])
    assert leads.turned([0.0, 0.0]) is built.lift
    # Turned back, the lift is that of the other sign.
    back = leads.turned([-0.5 * play, 0.0])
    middle = np.radians(112.0)
    assert back.q(middle) == pytest.approx(built.lift.q(middle + 0.5 * play), abs=1e-9)
    with pytest.raises(DesignError, match="has no room for a window"):
        leads.turned([20 * play, 20 * play])


@pytest.mark.parametrize("name", ["carbon_free_car", "figure_eight"])
def test_nodes_are_apart_or_one(name):
    """Rounding makes no piece between two nodes that are one: its derivatives would be anything."""
    design = load_design(name)
    lift, follower = cam_model.lift(design, cam_model.track(design)), cam_model.leaning(design, "a test")
    rng = np.random.default_rng(1)
    for _ in range(20):
        forces = Mechanics(follower=follower, friction=rng.uniform(0.05, 0.3))
        leads = TurnedLeads(lift, follower, forces, np.radians(1.0), np.radians(-0.3))
        windows, moved = rng.uniform(0.0, 1.0, leads.count), rng.uniform(-leads.later, leads.earlier)
        steps = np.diff(leads.turned(np.radians(windows), 0.2 * moved).q.x)
        assert np.all((steps == 0) | (steps > 1e-9))


@pytest.mark.parametrize("friction", [0.05, 0.12, 0.2, 0.28])
def test_ramps_leave_the_profile_a_radius(carbon_free_car, friction):
    """The envelope of the rod is trimmed nowhere that it was not."""
    built, play = carbon_free_car, np.radians(0.9)
    forces = Mechanics(follower=built.follower, friction=friction)
    search = LeadSearch(built.lift, built.follower, trial(built), [(play, forces)])
    search.run()
    assert len(actual_profile(search.best, built.follower).trims) == len(built.actual.trims)


@pytest.mark.parametrize(
    ("play_deg", "friction"), [(0.735, 0.288), pytest.param(0.653, 0.203, marks=(pytest.mark.slow, pytest.mark.long))]
)
def test_a_cam_for_a_narrow_band_is_less_moved_by_its_friction(carbon_free_car, play_deg, friction):
    """Play known within 0.02 degrees and friction within 0.01: what is left is what 0.02 degrees of play make."""
    built = carbon_free_car
    play, by = np.radians([play_deg, 0.02])
    forces = [Mechanics(follower=built.follower, friction=friction + off) for off in (-0.01, 0.0, 0.01)]
    runs = trial(built)

    def made_for(band, mechanics):
        found = best_for_band(built.lift, built.follower, built.car, built.track.length, band, mechanics=mechanics)
        ends = [
            [complex(runs.ends(runs.error(found.lift, each.leads(found.lift), play + off))[-1]) for off in (-by, 0, by)]
            for each in forces
        ]
        return np.array(ends)

    middle, narrow = made_for((play, play), forces[1:2]), made_for((play - by, play + by), forces[::2])
    by_friction, by_play = abs(narrow[2, 1] - narrow[0, 1]) / 2, abs(narrow[1, 2] - narrow[1, 0]) / 2
    print(f"{by_play:.1f} mm by play; by friction {abs(middle[2, 1] - middle[0, 1]) / 2:.1f} before, {by_friction:.1f}")
    assert abs(middle[1, 1]) < 1.0
    assert abs(narrow[1, 1]) < 3.0
    assert by_friction < abs(middle[2, 1] - middle[0, 1]) / 4
    assert by_play == pytest.approx(abs(middle[1, 2] - middle[1, 0]) / 2, rel=0.1)
    assert np.abs(narrow).max() < min(np.abs(middle).max(), 2 * by_play)


@pytest.mark.slow
@pytest.mark.long
def test_a_cam_for_a_narrow_band_can_be_cut(carbon_free_car):
    """The windows with the least ends left a flank steeper than radial here, and no cam."""
    built = carbon_free_car
    forces = [Mechanics(follower=built.follower, friction=friction) for friction in (0.194, 0.214)]
    band = np.radians(0.645), np.radians(0.685)
    found = best_for_band(built.lift, built.follower, built.car, built.track.length, band, mechanics=forces)
    actual_profile(found.lift, built.follower)
    print(f"{found.worst_distance:.1f} mm")
    assert found.worst_distance < 40.0


@pytest.mark.parametrize(
    ("name", "most"), [("carbon_free_car", 45.0), ("appendix_car", 42.0), ("s_course", 1.2), ("posts_and_walls", 3.4)]
)
def test_one_trim_leaves_half_of_what_the_plain_cam_leaves(name, most):
    """Over plays of 0.51 to 0.96 degrees and frictions of 0.05 to 0.30, on others than were searched on."""
    design = load_design(name)
    track = cam_model.track(design)
    lift, follower = cam_model.lift(design, track), cam_model.leaning(design, "a test")
    runs = TrialRun(wanted=lift, car=cam_model.car(design), length=cam_model.travel(design, track))
    cases = [Mechanics(follower=follower, friction=friction) for friction in np.linspace(0.05, 0.3, 6)]
    band = np.radians(0.51), np.radians(0.96)
    found = best_for_band(lift, follower, runs.car, runs.length, band, mechanics=cases, trimmed=True)
    plain, left = worst_trimmed(runs, follower, lift), worst_trimmed(runs, follower, found.lift)
    print(f"{name}: plain {plain:.1f} mm, windows of {np.degrees(found.windows).round(2)} degrees {left:.1f} mm")
    assert left <= most
    assert left <= 0.51 * plain


def test_a_car_that_never_leads_is_not_compensated(carbon_free_car):
    built, play = carbon_free_car, np.radians(0.738)
    for held in (Mechanics(follower=built.follower, drag=60.0), Mechanics(follower=built.follower, friction=0.6)):
        found = best_for_band(
            built.lift, built.follower, built.car, built.track.length, (play, play), mechanics=(held,)
        )
        assert found.lift is built.lift
        assert found.made_for == 0.0
        assert found.worst_distance < 0.01


def test_laps_are_trimmed_by_their_last_one():
    """A car that turns about its start is near there, and far off elsewhere."""
    design = load_design("figure_eight")
    track = cam_model.track(design)
    lift, follower = cam_model.lift(design, track), cam_model.leaning(design, "a test")
    runs = TrialRun(wanted=lift, car=cam_model.car(design), length=cam_model.travel(design, track))
    forces = Mechanics(follower=follower, friction=0.15)
    found = runs.trimmed(lift, forces.leads(lift), np.radians(0.7))
    before = runs.error(lift, forces.leads(lift), np.radians(0.7)).end_distance
    others = [
        np.abs(runs.ends(runs.error(lift, forces.leads(lift), np.radians(0.7), found.tan_beta + by))).sum()
        for by in (-1e-3, 0.0, 1e-3)
    ]
    assert found.error.end_distance < before / 5
    assert min(others) == others[1]


@pytest.mark.slow
def test_the_cam_that_is_cut_ends_there():
    """Rolled on the outline that is cut, the leaning rod and its edges counted."""
    known = {
        "mechanics.friction_least": 0.15,
        "mechanics.friction_greatest": 0.15,
        "play.measured_deg": 0.738,
        "optimize.max_end_position_mm": None,
    }
    design = load_design("carbon_free_car", [f"{key}={'' if value is None else value}" for key, value in known.items()])
    plan = plan_cam(design, "optimized")
    chosen = plan.application.comparison.chosen
    print(f"{chosen.cut_for}: {chosen.error.end_distance:.2f} mm at the end")
    assert chosen.error.end_distance <= 3.0
    assert float(chosen.error.distance.max()) <= 15.0
    assert len(chosen.windows) == 2
    assert chosen.by_lead
    assert replace(chosen, windows=(0.01,)).cut_for == "0.573°"


# Points of a random walk, whose second lead has no room for a wider window: to probe it ended the whole search.
TIGHT = """path.waypoints_mm=[[6636.6,1548.7],[5786.0,1861.2],[5203.6,1722.5],[4525.3,1580.9],[3937.0,1369.5],\
[3206.3,1474.7],[2514.5,1455.9],[1943.5,1045.8],[1100.7,710.8],[500.0,500.0]]"""
TIGHT_TRAIN = "train.stages=[{driver={teeth=40},driven={teeth=50}},{driver={teeth=30},driven={teeth=115}},\
{driver={teeth=30},driven={teeth=160}}]"


@pytest.mark.slow
def test_a_lead_without_room_to_one_side_does_not_end_the_search():
    friction = "mechanics={friction_least=0.05,friction_greatest=0.2}"
    changes = [TIGHT, TIGHT_TRAIN, friction, "course=", "car.drive_wheel_radius_mm=41.45", "tolerances=", "layout="]
    comparison = plan_cam(load_design("workshop_car", changes)).application.comparison
    print(
        f"worst end {comparison.chosen.band.worst_distance:.0f} mm, before {comparison.before.band.worst_distance:.0f}"
    )
    assert comparison.chosen.band.worst_distance < comparison.before.band.worst_distance
