"""The car as built: what is cut for it, put through effects of the test's own, rolls to the lift that was wanted."""

import numpy as np
import pytest

from cadgen.cam.contact import roll
from cadgen.curves.closed import Outline
from cadgen.deviations.as_built import AsBuilt, Placed
from cadgen.deviations.transmission import WIND_UP, runout
from cadgen.errors import DesignError
from cadgen.inference.measurement.kinds import kind_of

THETA = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)
STEP = 0.03  # mm; rolling on it errs by under 0.01 um
SHIFT, OFFSET, SCALE, REVERSAL = (0.08, -0.05), 0.1, (-0.0019, -0.0005), (0.02, 0.012)


def as_built(*effects):
    """From (kind, name, values, place)."""
    return AsBuilt(tuple(Placed(kind_of(kind).named(name), values, place) for kind, name, values, place in effects))


def made(outline, *, shift=(0.0, 0.0), offset=0.0, scale=(0.0, 0.0)):
    """An outline as it comes out: cut larger along its normal, shrunk, then off centre."""
    points = outline.points
    ahead = np.concatenate([np.gradient(points[outline.piece == k], axis=0) for k in np.unique(outline.piece)])
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    out = points + offset * np.stack([ahead[:, 1], -ahead[:, 0]], axis=1)
    out = out * (1 + np.array(scale)) - np.array(shift)
    return trimmed(Outline(out, outline.piece))


def trimmed(outline):
    """A corner whose sides have run into each other ends where they cross."""
    angle, keep = outline.angle, np.full(len(outline.points), True)
    joints = np.flatnonzero(np.diff(outline.piece))
    for last in joints:
        if angle[last] > angle[last + 1]:
            middle = (angle[last] + angle[last + 1]) / 2
            keep &= ~((outline.piece == outline.piece[last]) & (angle > middle))
            keep &= ~((outline.piece == outline.piece[last + 1]) & (angle < middle))
    return Outline(outline.points[keep], outline.piece[keep])


@pytest.fixture(scope="module")
def wanted(carbon_free_car):
    return roll(carbon_free_car.actual.curve.outline(STEP), carbon_free_car.follower, THETA).lift


@pytest.mark.parametrize(
    ("effects", "own"),
    [
        ([("profile", "eccentric bore", SHIFT, "process")], {"shift": SHIFT}),
        ([("lift", "eccentric bore", SHIFT, "car")], {"shift": SHIFT}),
        ([("profile", "cutter compensation", (OFFSET,), "process")], {"offset": OFFSET}),
        ([("profile", "cutter compensation", (-OFFSET,), "process")], {"offset": -OFFSET}),
        ([("profile", "uniform scale", (-0.004,), "process")], {"scale": (-0.004, -0.004)}),
        ([("profile", "anisotropic scale", SCALE, "process")], {"scale": SCALE}),
        (
            [
                ("profile", "cutter compensation", (OFFSET,), "process"),
                ("profile", "anisotropic scale", SCALE, "process"),
                ("lift", "eccentric bore", SHIFT, "car"),
            ],
            {"offset": OFFSET, "scale": SCALE, "shift": SHIFT},
        ),
    ],
    ids=lambda value: " + ".join(one[1] for one in value) if isinstance(value, list) else "",
)
def test_what_is_cut_comes_out_as_wanted(carbon_free_car, wanted, effects, own):
    """Within 0.1 um of lift, where the same disc without precompensation is off by tens."""
    car, follower = as_built(*effects), carbon_free_car.follower
    cut = car.precompensated(carbon_free_car.actual.curve)
    got = roll(made(cut.outline(STEP), **own), follower, THETA).lift
    bare = roll(made(carbon_free_car.actual.curve.outline(STEP), **own), follower, THETA).lift
    print(
        f"off by {1e3 * np.abs(bare - wanted).max():.1f} um, precompensated {1e3 * np.abs(got - wanted).max():.4f} um"
    )
    assert np.abs(got - wanted).max() < 1e-4
    assert np.abs(bare - wanted).max() > 0.02
    # The room's own prediction agrees, from the curve and from points of it.
    own_roll = car.roll_new(cut, follower, THETA, 0.06).lift
    read_back = roll(car.finished(cut.outline(0.06)), follower, THETA).lift
    np.testing.assert_allclose(own_roll, wanted, atol=1e-4)
    np.testing.assert_allclose(read_back, wanted, atol=1e-4)


def dragged(values, width):
    """An axis with lost motion: its command pulls it along, at half the width behind, once it has gone round."""
    place, out = values[0], np.empty(len(values))
    for _ in range(2):
        for i, command in enumerate(values):
            if command - place > width / 2:
                place = command - width / 2
            elif place - command > width / 2:
                place = command + width / 2
            out[i] = place
    return out


def test_a_reversal_is_taken_back_but_at_the_quadrants(carbon_free_car, wanted):
    """A continuous outline cannot jump where an axis turns round: there, within the ramps, a quarter of it is left."""
    car = as_built(("profile", "machine-axis reversal", REVERSAL, "process"))
    curve, follower = carbon_free_car.actual.curve, carbon_free_car.follower

    def cut(outline):
        points = np.stack([dragged(outline.points[:, k], REVERSAL[k]) for k in (0, 1)], axis=1)
        return roll(Outline(points, outline.piece), follower, THETA).lift

    made = car.precompensated(curve)
    off, bare = np.abs(cut(made.outline(STEP)) - wanted), np.abs(cut(curve.outline(STEP)) - wanted)
    beyond = 100 * np.mean(off > 1e-4)
    print(f"{1e3 * off.max():.2f} um, {beyond:.1f} % of the turn beyond 0.1; was {1e3 * bare.max():.2f} um")
    assert np.mean(off < 1e-4) > 0.98
    assert off.max() < 0.006
    assert np.mean(bare > 0.002) > 0.7
    np.testing.assert_allclose(car.roll_new(made, follower, THETA, 0.06).lift, cut(made.outline(STEP)), atol=2e-4)


def test_the_cut_curve_is_closed_and_its_jets_are_its_own(carbon_free_car):
    car = as_built(
        ("profile", "cutter compensation", (OFFSET,), "process"), ("profile", "anisotropic scale", SCALE, "process")
    )
    cut = car.precompensated(carbon_free_car.actual.curve)
    for number, piece in enumerate(cut.pieces):
        before = cut.pieces[number - 1]
        joint = before.jet(np.array([before.stop])).point[0] - piece.jet(np.array([piece.start])).point[0]
        assert np.abs(joint).max() < 1e-8
        t = np.linspace(piece.start, piece.stop, 203)[1:-1]
        h = 1e-4 * (piece.stop - piece.start)
        velocity = (piece.jet(t + h).point - piece.jet(t - h).point) / (2 * h)
        direction = np.unwrap(np.arctan2(*piece.jet(t).velocity.T[::-1]))
        np.testing.assert_allclose(piece.jet(t).velocity, velocity, rtol=1e-4, atol=1e-3)
        turned = [np.arctan2(*piece.jet(t + side * h).velocity.T[::-1]) for side in (1, -1)]
        bend = (np.angle(np.exp(1j * (turned[0] - turned[1]))) / (2 * h)) / np.linalg.norm(velocity, axis=1)
        np.testing.assert_allclose(piece.jet(t).curvature, bend, rtol=2e-3, atol=2e-4)
        assert np.isfinite(direction).all()
    # Corners are as sharp as they were: an offset leaves angles, a scale of 0.1 % nearly so.
    was, now = (np.array([c.turn for c in curve.corners()]) for curve in (carbon_free_car.actual.curve, cut))
    np.testing.assert_allclose(now, was, atol=2e-4)


def test_a_part_has_its_effects_and_a_new_disc_has_not(carbon_free_car):
    follower, curve = carbon_free_car.follower, carbon_free_car.actual.curve
    car = as_built(("profile", "lobing, order 3", (0.03, 0.0), "part"))
    assert car.precompensated(curve) is curve
    new = car.roll_new(curve, follower, THETA, 0.06).lift
    old = car.roll_measured(curve, follower, THETA, 0.06).lift
    np.testing.assert_allclose(new, carbon_free_car.follower.lift(carbon_free_car.lift.q(THETA)), atol=2e-4)
    np.testing.assert_allclose(old - new, 0.03 * np.cos(3 * THETA), atol=6e-3)  # the contact is a little beside the ray


def test_a_measured_cam_ahead_on_its_shaft(carbon_free_car):
    """With phase p the rod meets at shaft angle theta what was meant for theta + p."""
    phase = np.radians(1.3)
    car = as_built(("track", "cam phase", (phase,), "car"))
    lift, follower = carbon_free_car.lift, carbon_free_car.follower
    old = car.roll_measured(carbon_free_car.actual.curve, follower, THETA, 0.06)
    np.testing.assert_array_equal(old.cam_angle, THETA)
    np.testing.assert_allclose(old.lift, follower.lift(lift.q(THETA + phase)), atol=2e-4)


def test_the_shafts_run_out_stays_with_the_shaft_when_the_key_is_turned(carbon_free_car, wanted):
    """In the world: the rod at polar angle 0, the shaft turned by -theta with its run-out, the disc held by its key.

    The measured disc, key at polar angle k, stood so that the rod met its polar angle theta + p at shaft angle theta.
    A new disc with its key at k - p is turned by p more against the shaft.
    """
    phase, run_out = np.radians(40.0), complex(*SHIFT)
    car = as_built(("lift", "eccentric bore", SHIFT, "car"), ("lift", "phase", (np.radians(4.0),), "car"))
    car = AsBuilt((car.effects[0], Placed(car.effects[1].effect, (phase,), "car")))
    cut = car.precompensated(carbon_free_car.actual.curve).outline(STEP)
    for number in range(0, 720, 24):
        theta = THETA[number]
        key_on_old, key_on_new = 0.7, 0.7 - phase
        key_in_world = key_on_old - (theta + phase)
        turned = np.exp(1j * (key_in_world - key_on_new))
        off_centre = run_out * np.exp(-1j * (theta + phase))
        world = (cut.points[:, 0] + 1j * cut.points[:, 1]) * turned - off_centre
        disc = Outline(np.stack([world.real, world.imag], axis=1), cut.piece)
        lift = roll(disc, carbon_free_car.follower, np.array([0.0])).lift[0]
        assert lift == pytest.approx(wanted[number], abs=1e-4)


def test_the_rods_and_the_cars_numbers(carbon_free_car):
    car = as_built(
        ("lift", "rod radius", (0.1,), "car"),
        ("lift", "axial offset", (-0.4,), "car"),
        ("track", "driven wheel's offset", (2.0,), "car"),
        ("track", "lever gain", (0.02,), "car"),
        ("track", "slip with curvature", (0.05,), "car"),
        ("track", "wheel radius", (0.011,), "car"),
        ("zones", "return error", (0.015,), "car"),
    )
    rod, plan = car.follower(carbon_free_car.follower), car.car(carbon_free_car.car)
    assert (rod.radius, rod.inner, rod.outer) == pytest.approx((2.6, 23.1, 26.1))
    assert (plan.drive_wheel_offset, plan.steering_gain, plan.slip, plan.steering_zero) == (39.0, 1.02, 0.05, 0.0)
    assert (car.travel(1000.0), car.play, AsBuilt().play) == (pytest.approx(1011.0), 0.015, None)
    thin = as_built(("lift", "rod radius", (-1.5,), "car"), ("lift", "axial offset", (-4.0,), "car"))
    assert thin.follower(carbon_free_car.follower).radius == 1.0
    none = AsBuilt((Placed(kind_of("lift").named("rod radius"), (-2.5,), "car"),))
    with pytest.raises(DesignError, match="nothing is left of the rod"):
        none.follower(carbon_free_car.follower)


def test_broken_edges_leave_the_land_between_them(carbon_free_car):
    rod = carbon_free_car.follower
    car = as_built(("lift", "broken edges", (0.2,), "car"))
    land = car.follower(rod)
    assert (land.inner, land.outer) == pytest.approx((rod.inner + 0.2, rod.outer - 0.2))
    assert (car.broken_edges, AsBuilt().broken_edges) == (0.2, 0.0)
    with pytest.raises(DesignError, match=r"leaves no land of a rim of 3 mm: correct broken_edges_um"):
        as_built(("lift", "broken edges", (1.5,), "car")).follower(rod)


def test_a_nose_that_is_not_there_is_refused(carbon_free_car):
    effect = kind_of("profile").named("worn nose", {"nose_number": 9})
    car = AsBuilt((Placed(effect, (0.02, 0.07), "part"),))
    with pytest.raises(DesignError, match="worn nose number 9"):
        car.roll_measured(carbon_free_car.actual.curve, carbon_free_car.follower, THETA, 0.1)


@pytest.mark.parametrize(
    ("kind", "name", "near"),
    [
        ("track", "steerin zero", "steering zero"),
        ("lift", "steering zero", "index error"),
        ("profile", "lobing, order 30", "lobing"),
    ],
)
def test_an_unknown_name_names_the_nearest(kind, name, near):
    with pytest.raises(DesignError, match=f'no effect "{name}" in data of kind {kind}.*{near}'):
        kind_of(kind).named(name)
    assert kind_of("profile").named("waviness, order 30").name == "waviness, order 30"
    assert kind_of("transmission").named("runout of shaft 2").name == "runout of shaft 2"
    assert kind_of("transmission").named("tooth mesh of stage 3").name == "tooth mesh of stage 3"
    assert kind_of("lift").named("worn nose", {"nose_number": 3}).indices == (("nose_number", 3),)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("effects", "order", "lag"),
    [
        ([(runout("the camshaft", 1.0), (5e-3, -3e-3))], 1, 0.0),
        ([(runout("shaft 2", 3.0), (4e-3, 3e-3))], 3, 0.0),
        ([(runout("shaft 1", 15.0), (1.5e-3, -1e-3))], 15, 0.0),
        ([(WIND_UP, (8e-3,))], 1, 8e-3),
        ([(runout("shaft 2", 3.0), (4e-3, 3e-3)), (WIND_UP, (8e-3,))], 3, 8e-3),
    ],
    ids=["order 1", "order 3", "order 15", "wind-up", "both"],
)
def test_what_repeats_at_each_turn_is_taken_out(effects, order, lag, carbon_free_car, wanted):
    """The shaft that the test turns ahead by its own formula; share of the lift error that is left, on the path."""
    car, path = carbon_free_car, carbon_free_car.lift.blend_start > THETA
    cosine, sine = effects[0][1] if effects[0][0] is not WIND_UP else (0.0, 0.0)
    slope = car.lift.q(np.linspace(0.0, 2 * np.pi, 7200), nu=1)
    asked = (car.lift.q(THETA, nu=1) - slope[0]) / np.abs(slope).max()
    turned = THETA + cosine * (np.cos(order * THETA) - 1) + sine * np.sin(order * THETA) - lag * asked
    built = AsBuilt(tuple(Placed(e, values, "car") for e, values in effects), car.follower)

    def error(curve):
        return (roll(curve.outline(STEP), car.follower, turned).lift - wanted)[path]

    before, after = error(car.actual.curve), error(built.precompensated(car.actual.curve))
    foretold = (built.roll_measured(car.actual.curve, car.follower, THETA, STEP).lift - wanted)[path]
    left, wrong = (np.std(off) / np.std(before) for off in (after, foretold - before))
    print(f"{1e3 * np.std(before):.1f} um rms; {100 * left:.2f} % left, {100 * wrong:.2f} % foretold wrong")
    assert np.std(before) > 0.015
    assert max(left, wrong) < (0.03 if lag else 0.005)


def test_a_shaft_that_leads_by_too_much_is_refused(carbon_free_car):
    built = AsBuilt((Placed(runout("the motor shaft", 45.0), (0.01, 0.0), "car"),), carbon_free_car.follower)
    with pytest.raises(DesignError, match=r"gains and loses 103\.\d degrees .* set place to noted"):
        built.precompensated(carbon_free_car.actual.curve)
