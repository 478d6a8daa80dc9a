"""A kind of data and an effect that are made up here, outside the package, are registered, found, named and written."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from cadgen import Design
from cadgen.design.as_built import AsBuiltSection
from cadgen.design.load import load_design
from cadgen.deviations import catalogue
from cadgen.deviations.catalogue import Catalogue
from cadgen.deviations.deviation import Place
from cadgen.deviations.effect import READING, Effect, Parameter, Rows
from cadgen.deviations.track import STEERING
from cadgen.errors import FileError
from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.diagnosis import calibrate
from cadgen.inference.measurement.model import Discrepancy, elapsed, fourier, per_run, unknown
from cadgen.inference.measurement.record import Column, Datum, Kind, Span
from cadgen.inference.measurement.shapes import shapes
from cadgen.inference.records.load import load
from cadgen.jobs.calibration.calibration import calibrate as calibrate_files
from cadgen.jobs.calibration.files import write_calibration
from cadgen.jobs.calibration.sources import read
from tests.inference.measurement import synthetic as syn
from tests.inference.measurement import synthetic_drive as drive

DEG = np.pi / 180

PROTRACTOR = Effect(
    name="scale of the protractor",
    stage=READING,
    parameters=(
        Parameter(name="protractor_percent", unit="%", lower=-20.0, upper=20.0, step=0.1, meaning="+: too much"),
    ),
    act=lambda angle, p, at: angle * (1 + p[0]),
    separated_by="hold it against a precision square",
)


class ForkModel:
    """Angle of the fork by cam angle, the protractor's zero free in each run."""

    behind = ()
    rolled = None
    unit = "deg"
    measured = None
    datum = ()
    slip = np.empty(0)
    floor = 1e-4
    tangent = None
    resolved = None
    cameras = ()

    def __init__(self, record, nominal):
        angle = np.radians(record["cam_angle_deg"])
        self._reading, self._angle = np.radians(record["fork_deg"]), np.arctan(nominal.lift.q(angle))
        cell = np.round(record["cam_angle_deg"]).astype(np.intp)
        self.rows = Rows(run=record.run, place=angle, elapsed=elapsed(record.run), cell=cell)
        self.catalogue, self.shapes = record.kind.catalogue.effects, shapes(self.rows, self.unit, range(1, 9))
        self.offsets, (self.form, self.order) = per_run(record.run), fourier(angle, 12)
        self.spread, self.discrepancy = unknown(self.offsets), Discrepancy.none(len(angle))

    def residual(self, active):
        expected = self._angle
        for effect, values in active:
            expected = effect.act(expected, values, self.rows)
        return self._reading - expected


FORK = Kind(
    code="fork angle",
    title="Fork angle",
    columns=(
        Column(name="cam_angle_deg", lower=-1.0, upper=361.0, least_span=10.0),
        Column(name="fork_deg", lower=-90.0, upper=90.0),
    ),
    readings=("fork_deg",),
    catalogue=Catalogue(PROTRACTOR),
    datum=Datum(words="the zero of the protractor", name="zero", numbers=(("zero_deg", "deg"),)),
    model=ForkModel,
    spans=lambda record, nominal: [Span("fork_deg", float(np.ptp(record["fork_deg"])), 30.0, "deg")],
    around=True,
    nearness=9,
)


@pytest.fixture
def fork():
    """The kind, registered for one test."""
    kinds.register(FORK)
    yield FORK
    kinds.remove(FORK)


@pytest.fixture(scope="module")
def fork_file(synthetic_car, tmp_path_factory):
    """Three runs of a protractor that shows 4 % too much, by the generator's own rolling."""
    rng, angle = np.random.default_rng(5), np.arange(0.0, 342.0, 3.0)
    fork = 1.04 * np.degrees(np.arctan(synthetic_car.steering(syn.Bench(), angle * DEG)))
    path = tmp_path_factory.mktemp("fork") / "fork.csv"
    rows = [
        f"{run},{a:g},{value + 0.1 * run + rng.normal(0, 0.02):.3f}\n"
        for run in range(3)
        for a, value in zip(angle, fork, strict=True)
    ]
    path.write_text("run,cam_angle_deg,fork_deg\n" + "".join(rows))
    return path


@pytest.mark.slow
def test_a_made_up_kind_is_read_judged_and_written(fork, fork_file, nominal, tmp_path):
    design = load_design()
    calibration = calibrate_files(design, "actual", read([fork_file]), nominal=nominal)
    (diagnosis,) = calibration.diagnoses
    assert (diagnosis.kind, diagnosis.verdict, diagnosis.judgement.claimed) == (FORK, "traced", (PROTRACTOR.name,))
    (value,) = diagnosis.findings[0].values
    assert value.value == pytest.approx(4.0, abs=3 * value.sigma)
    assert value.sigma < 0.1
    assert [finding.effect for finding in diagnosis.datum] == [f"zero, run {run}" for run in (1, 2, 3)]
    zeros = [finding.values[0].value for finding in diagnosis.datum]
    assert np.diff(zeros) == pytest.approx([0.1, 0.1], abs=0.01)
    # The as-built design is read back in this, against the catalogue of the kind.
    text = (Path(__file__).parents[3] / "designs" / f"{design.name}.toml").read_text(encoding="utf-8")
    written = write_calibration(calibration, text, tmp_path)
    assert f"{design.name}_calibration_fork_angle.png" in written.entry["files_written"]
    report = (tmp_path / f"{design.name}_calibration.txt").read_text(encoding="utf-8")
    assert "Fitted and never claimed: the zero of the protractor (zero_deg" in report


def test_without_it_the_file_is_of_no_kind(fork_file):
    with pytest.raises(FileError, match=r"are no kind of measured data; nearest is"):
        load(fork_file)
    with pytest.raises(ValueError, match='must be "lift", "profile"'):
        AsBuiltSection.model_validate({"sources": [{"file": "a.csv", "kind": "fork angle", "sha256": "0" * 64}]})


def test_kinds_and_effects_have_codes_of_their_own(fork):
    with pytest.raises(ValueError, match="cannot be told from fork angle"):
        kinds.register(FORK)
    with pytest.raises(ValueError, match="already"):
        FORK.catalogue.register(PROTRACTOR)
    for kind in kinds.kinds():
        names = [effect.name for effect in kind.catalogue.entries]
        assert len(set(names)) == len(names)
        assert all(kind.named(name).name == name for name in names)


LINKAGE = Effect(
    name="uneven linkage",
    stage=STEERING,
    parameters=(Parameter(name="cubic_percent", unit="%", lower=-99.0, upper=99.0, step=0.5, meaning="+: more"),),
    act=lambda steering, p, at: steering + p[0] * steering**3,
    separated_by="turn the fork through its range and read both of its ends",
)


@pytest.fixture
def linkage():
    """The effect, registered for one test."""
    catalogue.TRACK.register(LINKAGE)
    yield LINKAGE
    catalogue.TRACK.remove(LINKAGE)


@pytest.mark.slow
def test_a_made_up_effect_is_found_and_named(linkage, carbon_free_car, nominal):
    built, rng = carbon_free_car, np.random.default_rng(8)

    def bent(angle):
        tangent = built.lift.q(angle)
        return tangent + 0.2 * tangent**3

    car = SimpleNamespace(built=SimpleNamespace(lift=SimpleNamespace(q=bent), car=built.car, track=built.track))
    record = drive.track_record(car, drive.Wheels(), rng, noise_mm=3.0)
    (diagnosis,) = calibrate([record], nominal)
    assert (diagnosis.verdict, diagnosis.judgement.claimed) == ("traced", ("uneven linkage",))
    (value,) = diagnosis.findings[0].values
    assert value.value == pytest.approx(20.0, abs=max(3 * value.sigma, 0.5))
    assert diagnosis.residual.after < 1.1 * diagnosis.residual.noise
    # The same by the face: written to the design as built, read back, and taken by the next cam.
    found = Design.load("carbon_free_car").calibrate({"run": record.run, **record.columns})
    places = {effect.effect: effect.place for effect in found.as_built.values.as_built.effects}
    print(places)
    assert places["uneven linkage"] == Place.NOTED
    assert any("uneven linkage" in note for note in found.as_built.cam("actual").notes)
