"""Records joined: their evidence against a dense covariance, their catalogues, and the chain against a generator."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen.deviations.disc import DISC
from cadgen.deviations.effect import READING, Effect, Parameter
from cadgen.deviations.transmission import runout
from cadgen.inference.measurement.evidence import Evidence, Noise, Spectrum
from cadgen.inference.measurement.joint import Joint, Merged, Part
from cadgen.inference.measurement.kinds import LIFT, TRACK, TRANSMISSION
from cadgen.inference.measurement.model import CHANGE, Cache
from cadgen.inference.measurement.shapes import bump
from tests.inference.measurement import synthetic_drive as drive
from tests.inference.measurement.synthetic import Bench, lift_record
from tests.inference.measurement.test_statistics import _model
from tests.studies.circles_truth import CELLS, Car, World

SLOPE = Effect(
    name="slope",
    stage=READING,
    parameters=(Parameter(name="slope_mm", unit="mm", lower=-9.0, upper=9.0, step=0.1, meaning="+: up"),),
    act=lambda reading, p, at: reading + p[0] * np.cos(at.place),
)


def _part(kind, seed, sigma, correlation):
    """A made-up record of 60 angles and 3 runs; the one effect acts on its reading."""
    model, rng = _model(), np.random.default_rng(seed)
    drawn = rng.normal(0, 4, len(model.rows.run))
    model.catalogue, model.shapes, model.datum, model.behind = (SLOPE,) if kind is TRACK else (), (), (), (READING,)
    model.cameras, model.rolled, model.tangent = (), None, None
    model.residual = lambda active: drawn - sum((e.act(0 * drawn, v, model.rows) for e, v in active), 0 * drawn)
    noise = Noise(np.full(len(drawn), sigma), correlation, 0.0, 3)
    grid = (Spectrum(1.0, 2.0, 1.0), Spectrum(1.2, 4.0, 3.0))
    return Part(
        SimpleNamespace(kind=kind, source=kind.code), lambda record: model, model, noise, Evidence(model, noise, grid)
    )


def test_joint_evidence_is_that_of_the_dense_covariance_of_all_rows():
    joint = Joint.of([_part(TRACK, 1, 1.5, 0.0), _part(LIFT, 2, 0.7, 0.0)])
    active = [(SLOPE, np.array([2.0]))]
    dense = []
    for spectrum in joint.grid:
        total = 0.0
        for part in joint.parts:
            m, residual = part.model, part.residual(active)
            C = np.diag(part.noise.sigma**2) + (m.form * spectrum.variance(m.order, m.floor)) @ m.form.T
            inverse, D = np.linalg.inv(C), m.offsets
            inside = D.T @ inverse @ D
            total += residual @ (inverse - inverse @ D @ np.linalg.solve(inside, D.T @ inverse)) @ residual
            total += np.linalg.slogdet(C)[1] + np.linalg.slogdet(inside)[1]
        dense.append(total)
    ours = joint.misfit(active)
    assert ours[1] - ours[0] == pytest.approx(dense[1] - dense[0], rel=1e-9)
    # What is whitened and halved part by part has the products of all rows.
    columns = joint.slopes((SLOPE,), active)
    assert columns[:180, 0] == pytest.approx(np.cos(joint.parts[0].model.rows.place))
    assert columns[180:, 0] == pytest.approx(np.cos(joint.parts[1].model.rows.place))
    white = joint.whiten(np.column_stack([columns, joint.residual(active)]))
    halves = joint.halves(white)
    products = white.T @ white - np.swapaxes(halves, 1, 2) @ halves
    H, g = joint.normal((SLOPE,), active, [0, 1])
    assert H[:, 0, 0] == pytest.approx(products[:, 0, 0])
    assert g[:, 0] == pytest.approx(-products[:, 0, 1])
    assert joint.square(active, 1) == pytest.approx(products[1, 1, 1])


def test_slopes_that_are_known_are_not_lost_to_those_that_come_beside_them():
    """A fit of eight effects after long searches: what was remembered of one was forgotten for another's sake."""
    wave = replace(SLOPE, name="wave", act=lambda reading, p, at: reading + p[0] * np.sin(at.place))
    part = replace(_part(TRACK, 1, 1.5, 0.0), _leant=Cache(1))
    residual = part.residual([])
    part.slopes((SLOPE,), [], residual)
    both = part.slopes((SLOPE, wave), [], residual)
    place = part.model.rows.place
    assert both == pytest.approx(np.stack([np.cos(place), np.sin(place)], axis=1))


@pytest.fixture(scope="module")
def models(synthetic_car, nominal):
    """A forward model of each of three kinds."""
    rng = np.random.default_rng(70)
    records = (
        drive.track_record(synthetic_car, drive.Wheels(), rng, noise_mm=3.0, runs=2),
        drive.transmission_record(synthetic_car, drive.Train(), rng, noise_deg=0.03, runs=1),
        lift_record(synthetic_car, Bench(), rng, noise_um=4.0, runs=1),
    )
    return [(record.kind, nominal.model(record)) for record in records]


def test_catalogues_are_merged_by_what_effects_are(models):
    merged = Merged.of(models)
    track, train, lift = merged.names
    # One play, which the track calls backlash; that of a lift's divider is another thing.
    assert (track["backlash"].name, train["backlash"].name) == ("backlash", "return error")
    assert "backlash" not in lift
    assert merged.kinds["backlash"] is TRACK
    assert lift["backlash (lift)"].name == "backlash"
    # What the train and the disc have moves the cam and the rod under the track.
    for name, kind in (("runout of shaft 2", TRANSMISSION), ("eccentric bore", TRACK), ("axial offset", LIFT)):
        assert track[name].name == name
        assert merged.kinds[name] is kind
    # What the instrument has stays in its own record, and so do forms without a name.
    assert "index error" not in track
    assert "lever gain (lift)" not in track
    assert lift["lever gain (lift)"].name == "lever gain"
    assert not any(e.shape for e in track.values() if e.stage is READING)


def test_one_record_keeps_its_catalogue(models):
    kind, model = models[0]
    merged = Merged.of([(kind, model)])
    assert merged.catalogue == model.catalogue
    assert merged.names == ({e.key: e for e in (*model.catalogue, *model.shapes, *model.datum, *model.cameras)},)


@pytest.mark.slow
def test_effects_of_disc_and_train_move_the_track_as_the_generator_has_it(synthetic_car, nominal):
    """A bore off by 40 um, and a gear that runs out by 0.3 degrees three times a turn, by the studies' own stepping."""
    world = World(synthetic_car.built, synthetic_car, np.zeros(1))
    rng = np.random.default_rng(71)
    model = nominal.model(drive.track_record(synthetic_car, drive.Wheels(), rng, noise_mm=1.0, runs=1))
    degrees = model.rows.place[: len(model.rows.place) // 2]
    at = np.round(degrees / (2 * np.pi) * CELLS).astype(int)
    effects = {
        "bore": (LIFT.catalogue.named("eccentric bore"), (0.03, -0.025)),
        "runs_out": (runout("shaft 2", 3.0), (0.004, -0.003)),
    }
    bare = model.place([])[: len(degrees)] - world.path(Car())[at]
    for key, (effect, values) in effects.items():
        moved = model.place([(effect, np.array(values))])[: len(degrees)]
        theirs = world.path(Car(**{key: values}))[at]
        assert np.abs(theirs - world.path(Car())[at]).max() > 100
        assert np.abs(moved - theirs - bare).max() < 1.5


@pytest.mark.slow
def test_a_dent_that_a_lift_or_a_profile_shows_moves_the_track_as_the_generator_has_it(synthetic_car, nominal):
    """0.3 mm at 130 degrees, of the outline, and as the lift has it."""
    world, dented = World(synthetic_car.built, synthetic_car, np.zeros(1)), Car(dent=(0.3, np.radians(130.0)))
    model = nominal.model(
        drive.track_record(synthetic_car, drive.Wheels(), np.random.default_rng(71), noise_mm=1.0, runs=1)
    )
    degrees = model.rows.place[: len(model.rows.place) // 2]
    at = np.round(degrees / (2 * np.pi) * CELLS).astype(int)
    theirs = world.path(dented)[at] - world.path(Car())[at]
    assert np.abs(theirs).max() > 100
    outline = model.rolled.shown(replace(bump(130.0, 3.0, "um"), form_of=DISC))
    values = np.array([-0.3, np.radians(130.0), np.radians(3.0)])
    ours = (model.place([(outline, values)]) - model.place([]))[: len(degrees)]
    assert np.abs(ours - theirs).max() < 2.0

    class Lifted(World):
        def lift(self, car):
            off = (np.arange(CELLS) / CELLS * 2 * np.pi - values[1]) / values[2]
            return super().lift(car) - 0.2 / self.built.follower.inner * np.exp(-(off**2) / 2)

    lifted = Lifted(synthetic_car.built, synthetic_car, np.zeros(1))
    theirs = lifted.path(Car())[at] - world.path(Car())[at]
    lift = model.rolled.shown(replace(bump(130.0, 3.0, "um"), form_of=CHANGE))
    ours = (model.place([(lift, np.array([-0.2, *values[1:]]))]) - model.place([]))[: len(degrees)]
    assert np.abs(theirs).max() > 100
    assert np.abs(ours - theirs).max() < 0.5


def test_a_form_of_the_lift_acts_in_the_track_and_one_of_a_single_run_does_not(models):
    merged = Merged.of(models)
    track = merged.names[0]
    bumps = [e for e in merged.shapes if e.name.startswith("local bump") and e.name.endswith("(lift)")]
    assert bumps
    assert all(track[e.key].stage is CHANGE for e in bumps)
    assert not any(e.key in track for e in merged.shapes if e.one_run)
