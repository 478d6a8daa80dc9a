"""Friction beside play: what tells them apart, what is said where nothing does, what becomes of it in the design."""

from dataclasses import replace
from math import radians
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.car.path_motion import PathMotion
from cadgen.car.running.mechanics import Mechanics, holding_friction
from cadgen.design import cam_model, variation
from cadgen.design.as_built import AsBuiltSection
from cadgen.design.load import load_design
from cadgen.errors import FileError
from cadgen.inference.measurement.claims import no_friction
from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.kinds import kind_of
from cadgen.inference.measurement.kinds.transmission import follow
from cadgen.inference.measurement.nominal import Forces
from cadgen.inference.measurement.record import join
from cadgen.inference.measurement.reservations import with_friction_judged, with_known_play
from cadgen.inference.measurement.verdict import Judgement
from cadgen.jobs.cam.built_car import as_built_sentences
from cadgen.jobs.cam.car_facts import as_built_facts
from tests.inference.measurement.synthetic_drive import RATIOS, Train, transmission_record
from tests.inference.measurement.synthetic_rod import rod_record
from tests.studies.friction_cars import case, judged
from tests.studies.friction_truth import STEP_DEG, FrictionCar, World

TURN = 2 * np.pi


@pytest.fixture(scope="module")
def world(carbon_free_car):
    return World(carbon_free_car)


@pytest.fixture(scope="module")
def forces(carbon_free_car):
    return Forces(carbon_free_car.lift, Mechanics(follower=carbon_free_car.follower))


@pytest.mark.slow
def test_a_track_tells_apart_play_and_friction():
    # A slice of the study that studies/friction_cars.md records.
    made, told = case(1, 10, 60).car, judged(1, 10, 60)
    assert made.friction > 0.05
    assert told.told_apart
    assert not told.wrong
    assert told.play_deg == pytest.approx(made.play_deg, rel=0.03)
    assert told.friction == pytest.approx(made.friction, abs=0.03)


@pytest.mark.slow
def test_a_car_on_a_bearing_has_no_friction_named():
    told = judged(1, 64, 60)
    assert case(1, 64, 60).sort == "no friction"
    assert (told.wrong, told.friction) == ((), None)
    assert told.play_deg == pytest.approx(case(1, 64, 60).car.play_deg, rel=0.03)


@pytest.mark.slow
@pytest.mark.long
def test_a_transmission_with_the_rod_on_parts_them_too(world, nominal):
    record = rod_record(world, play=110, friction=0.3, rng=np.random.default_rng(3), runs=2)
    (told,) = calibrate([record], replace(nominal, ratios=RATIOS, teeth=()))
    assert told.judgement.claimed == ("return error", "sliding friction")
    values = {v.name: v for f in told.findings for v in f.values}
    assert values["return_error_deg"].value == pytest.approx(110 * STEP_DEG, rel=0.03)
    assert values["friction"].value == pytest.approx(0.3, abs=0.01)
    assert 0 < values["friction"].sigma < 0.01
    assert told.residual.after < 1.02 * 0.03


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("lifted", [True, False])
def test_a_track_and_a_train_are_of_one_car_whether_the_rod_was_lifted_or_not(world, nominal, synthetic_car, lifted):
    """With the rod lifted the train shows all of the play, and of friction nothing: the records contradicted."""
    rng = np.random.default_rng(5)
    track = world.record(FrictionCar(play=180, friction=0.2), rng, runs=4, noise_mm=3.0)
    if lifted:
        train = transmission_record(synthetic_car, Train(play=radians(180 * STEP_DEG)), rng, noise_deg=0.03)
    else:
        train = rod_record(world, play=180, friction=0.2, rng=rng)
    told = calibrate([track, train], replace(nominal, ratios=RATIOS, teeth=()))
    assert not told[0].apart
    assert told[0].judgement.claimed == ("backlash", "sliding friction")
    values = {v.name: v for f in told[0].findings for v in f.values}
    assert values["return_error_deg"].value == pytest.approx(180 * STEP_DEG, abs=0.02)
    assert values["friction"].value == pytest.approx(0.2, abs=0.01)
    assert [state for state in ("rod lifted", "rod on the disc") if state in " ".join(told[0].judgement.limits)] == [
        "rod lifted" if lifted else "rod on the disc"
    ]


def test_runs_with_the_rod_lifted_and_on_the_disc_are_not_one_record(synthetic_car, nominal):
    record = transmission_record(synthetic_car, Train(), np.random.default_rng(0), noise_deg=0.03, runs=1)
    both = join([replace(record, remarks=("Rod lifted",)), replace(record, remarks=("with the rod on the disc",))])
    with pytest.raises(FileError, match="give files of one of the two"):
        replace(nominal, ratios=RATIOS).model(both)


def test_the_rod_draws_a_camshaft_as_the_generator_steps_it(world, forces):
    clean = rod_record(world, play=150, friction=0.15, rng=np.random.default_rng(0), noise_deg=0.0, runs=1)
    asked = np.radians(clean["motor_angle_deg"] / np.prod(RATIOS))
    play = 150 * STEP_DEG
    ours = np.degrees(follow(asked, clean.run, radians(play), forces.drawn(0.15))) + play / 2
    off = ours - clean["cam_angle_deg"]
    off -= np.median(off)
    # But for rows on which one of the two has jumped already, and where the run begins within the play.
    assert np.mean(np.abs(off[5:]) < 0.02) > 0.99
    held = np.degrees(follow(asked, clean.run, radians(play))) + play / 2
    assert np.mean(np.abs(held - np.median(held - clean["cam_angle_deg"]) - clean["cam_angle_deg"]) < 0.02) < 0.9


def test_a_lift_turned_back(carbon_free_car):
    lift: PathMotion = carbon_free_car.lift
    theta = np.linspace(0.01, TURN - 0.01, 997)
    back = lift.mirrored
    assert back.q(theta) == pytest.approx(lift.q(TURN - theta), abs=1e-12)
    assert back.q(theta, nu=1) == pytest.approx(-lift.q(TURN - theta, nu=1), abs=1e-10)
    assert back.mirrored.q(theta) == pytest.approx(lift.q(theta), abs=1e-12)


def test_friction_that_holds_everywhere(world, carbon_free_car, forces):
    friction, angle = holding_friction(carbon_free_car.lift, carbon_free_car.follower)
    assert friction == pytest.approx(world.holds.max(), abs=0.01)
    assert np.degrees(angle) == pytest.approx(np.argmax(world.holds) * STEP_DEG, abs=1.0)
    assert len(forces.leads(friction - 0.01).intervals)
    assert not len(forces.leads(friction + 0.01).intervals)


def _judgement(*claimed):
    return Judgement(
        verdict="combination", sentence="Traced.", claimed=claimed, reported=claimed, rivals=(), separate=()
    )


def _best(nominal, world, play_sigma, friction_sigma):
    """A fitted pair with made-up standard deviations."""
    from cadgen.deviations.track import RETURN_ERROR, SLIDING_FRICTION

    values = [
        (RETURN_ERROR, np.array([radians(0.8)]), np.array([radians(play_sigma)])),
        (SLIDING_FRICTION, np.array([0.3]), np.array([friction_sigma])),
    ]
    return SimpleNamespace(effects=(RETURN_ERROR, SLIDING_FRICTION), values=lambda: values)


@pytest.mark.parametrize(
    ("play_sigma", "friction_sigma", "known", "apart"),
    [(0.008, 0.01, False, True), (0.08, 0.01, False, False), (0.008, 0.03, False, False), (0.08, 0.01, True, True)],
)
def test_what_is_not_told_apart_is_said(nominal, world, play_sigma, friction_sigma, known, apart):
    judgement = _judgement("backlash", "sliding friction")
    told = with_friction_judged(judgement, _best(nominal, world, play_sigma, friction_sigma), play_known=known)
    assert told.claimed == judgement.claimed
    assert (told == judgement) is apart
    if not apart:
        assert "backlash and sliding friction are not told apart" in told.limits[0]
        assert "with the rod lifted" in told.limits[0]
        assert "thread on its rim" in told.limits[0]


def test_no_friction_without_a_sure_play(nominal, world):
    told = with_friction_judged(_judgement("sliding friction"), _best(nominal, world, 0.008, 0.01), play_known=False)
    assert (told.verdict, told.claimed) == ("ambiguous", ())


def test_a_play_of_another_car_is_not_used(nominal, world):
    best = _best(nominal, world, 0.01, 0.01)
    same, why = with_known_play(None, best, (radians(0.5), radians(0.01)))
    assert same is best
    assert "0.500°, is not the 0.800 ± 0.010°" in why
    assert with_known_play(None, best, None) == (best, "")


def test_friction_of_nothing_is_claimed_where_data_would_have_shown_it():
    from cadgen.inference.measurement.findings import Finding, Value

    fitted = Finding("sliding friction", (Value("friction", 0.002, 0.008, ""),), (), ())
    claim = no_friction("a track", "track", fitted)
    assert claim.absent
    assert no_friction("a track", "track", replace(fitted, values=(Value("friction", 0.0, 0.05, ""),))) is None


def _as_built(*effects):
    names = {"backlash": ("return_error_deg", 0.8, 0.01), "sliding friction": ("friction", 0.2, 0.01)}
    rows = []
    for name in effects:
        number, value, sigma = names[name.removeprefix("no ")]
        value = 0.0 if name.startswith("no ") else value
        values = [{"name": number, "value": value, "sigma": sigma}]
        rows.append({"effect": name.removeprefix("no "), "kind": "track", "place": "car", "values": values})
    return AsBuiltSection.model_validate({"effects": rows})


@pytest.mark.parametrize(
    ("effects", "mechanics", "friction", "words"),
    [
        (("backlash", "sliding friction"), False, (0.18, 0.22), "as it was then"),
        (("backlash", "sliding friction"), True, (0.18, 0.22), "as it was then"),
        (("backlash", "no sliding friction"), True, (0.0, 0.0), ""),
        (("backlash",), True, (0.0, 0.0), "as if the rod slid without friction, and is used so instead of"),
        (("backlash",), False, None, "as if the rod slid without friction, and is used so: "),
        (("no backlash",), True, (0.0, 0.0), "no play with the rod on"),
    ],
)
def test_friction_of_a_measured_car_in_its_design(effects, mechanics, friction, words):
    band = ["mechanics.friction_least=0.1", "mechanics.friction_greatest=0.3"] if mechanics else []
    design = load_design(None, band).model_copy(update={"as_built": _as_built(*effects)})
    lift = cam_model.lift(design)
    found = variation.mechanics(design, cam_model.follower(design), lift)
    assert (None if found is None else found.friction) == (friction and pytest.approx(friction))
    told = " ".join(as_built_sentences(design, lift.blend_start))
    assert words in told
    assert ("as if the rod slid" in told) is ("as if the rod slid" in words)
    facts = as_built_facts(design, lift.blend_start).json()
    assert facts["play_found_without_friction"] is ("sliding friction" not in " ".join(effects))


def test_a_true_play_goes_by_the_friction_of_the_design():
    keys = ["play.measured_deg=0.8", "mechanics.friction_least=0.1", "mechanics.friction_greatest=0.3"]
    design = load_design(None, keys)
    assert variation.mechanics(design, cam_model.follower(design), cam_model.lift(design)).friction == (0.1, 0.3)
    assert variation.measured_play(design) == pytest.approx(radians(0.8))


def test_a_play_that_has_the_others_in_it_is_taken_as_it_is():
    from cadgen.inference.measurement.claims import Claim, at_work, shared
    from cadgen.inference.measurement.findings import Finding, Value

    def claim(kind, effect, value, **more):
        return Claim(
            kind, kind_of(kind), Finding(effect, (Value("return_error_deg", value, 0.01, "deg"),), (), ()), **more
        )

    train, track = claim("transmission", "return error", 0.80), claim("track", "backlash", 0.81, informed=True)
    assert at_work([train, track]) == (track, track)
    assert shared([train, track]) == ()
    assert at_work([train, replace(track, informed=False)])[1].finding.values[0].value == pytest.approx(0.805)


@pytest.mark.slow
@pytest.mark.long
def test_an_eccentric_bore_does_not_stand_for_little_friction():
    """Play of 0.89 degrees, a friction of 0.068 and a steering zero: a bore off by 14 um does nearly the same."""
    told = judged(2, 13, 60)
    assert told.wrong == ()
    assert told.play_deg == pytest.approx(told.case.car.play_deg, rel=0.01)
    assert told.friction == pytest.approx(told.case.car.friction, abs=0.01)
