"""Runs that were not used, predicted: the tricycle's two manoeuvres, and the runs of a track."""

import numpy as np
import pytest

from cadgen.design.load import load_design
from cadgen.errors import FileError
from cadgen.inference.expectation.predict import Prediction
from cadgen.inference.measurement.record import join
from cadgen.inference.records.load import load
from cadgen.jobs.calibration.advice import Predictions
from cadgen.jobs.calibration.calibration import calibrate
from cadgen.jobs.calibration.sources import Source, read

pytestmark = pytest.mark.usefixtures("tricycle")


@pytest.fixture(scope="module")
def told(measured):
    """The tricycle by its circles, and by its squares."""
    return {
        name: calibrate(load_design(), "actual", read([measured / f"{name}.csv"])) for name in ("circles", "squares")
    }


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize(("fitted", "unseen", "bar"), [("squares", "circles", 60), ("circles", "squares", 95)])
def test_the_manoeuvres_of_the_tricycle_predict_each_other(told, measured, fitted, unseen, bar):
    (found,) = Predictions.of(told[fitted], read([measured / f"{unseen}.csv"])).each
    before, after = (float(np.mean(x)) for x in found.as_logged)
    print(
        f"{unseen} by {fitted}: {before:.0f} mm before, {after:.1f} mm after, start as logged; "
        f"{found.after.mean():.1f} mm with the start registered"
    )
    assert before > 450
    assert after <= bar
    assert found.after.mean() < 45


@pytest.mark.slow
@pytest.mark.long
def test_one_manoeuvre_alone_does_not_name_what_only_both_tell(told):
    """Slip with steering does as well as the wheelbase on squares, and leaves 157 mm on circles."""
    for name in ("circles", "squares"):
        judgement = told[name].diagnoses[0].judgement
        print(name, judgement.verdict, judgement.claimed, judgement.rivals)
        assert judgement.verdict == "ambiguous"
        assert judgement.claimed == ("steering zero",)


@pytest.mark.slow
def test_runs_of_a_track_are_predicted_to_the_noise(measured):
    whole = load(measured / "track_b.csv")
    parts = [whole.only(np.array(runs)) for runs in ([0, 1], [2, 3])]
    sources = [Source(measured / f"{k}.csv", part, str(k)) for k, part in enumerate(parts)]
    told = calibrate(load_design(), "actual", sources[:1])
    (found,) = Predictions.of(told, sources[1:]).each
    print(found)
    assert set(found.effects) == {"wheel radius", "backlash"}
    assert found.before.min() > 100
    assert found.after.max() < 3.3  # 3 mm of noise
    assert found.as_logged[1].mean() < 40  # the start was set to 3 mm and 0.15 degrees
    with pytest.raises(FileError, match="which was used"):
        Predictions.of(told, sources[:1])
    with pytest.raises(FileError, match="logged runs are predicted by logged runs"):
        Predictions.of(told, read([measured / "circles.csv"]))
    assert join(parts).runs == 4


def test_the_table_has_a_row_for_each_file():
    class Kind:
        code, method = "track", None

    runs = np.array([1.0, 3.0])
    one = Prediction("a.csv", Kind(), "mm", ("backlash",), 10 * runs, runs, None)
    _, table, words = Predictions((one,)).report
    assert table.rows == (("a.csv", "2", "mm", "20", "2", "-", "-"),)
    assert words.startswith("Predicted with backlash")
    assert Predictions((one,)).facts()[0]["runs"][1] == {"before": 30.0, "after": 3.0}
