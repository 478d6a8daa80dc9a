"""Runs that were not used, predicted with what was found: residuals before and after.

The effects found are put into the forward model of the unseen record, as they are; nothing but the datum of each run is
fitted to it. The names of a car with logged steering are often not sure while their joint effect on its path is. So
there all effects are at work at once, each held to a usual size: the most probable numbers given the fitted runs. Path
errors are no draws of a noise; a run counts as a few numbers that err by what the best subset left.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from cadgen.arrays import Array
from cadgen.deviations.effect import UNITS, Active, activated
from cadgen.inference.expectation.linear import Linear
from cadgen.inference.measurement.evidence import Noise, registered
from cadgen.inference.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.inference.measurement.kinds.track import TrackModel
from cadgen.inference.measurement.model import Model, rms_by_run, slopes
from cadgen.inference.measurement.nominal import LoggedCar, Nominal
from cadgen.inference.measurement.record import Kind, Record

# Independent numbers in the path of one run: its errors are smooth, and the start pose takes three of them.
INDEPENDENT = 6
# Usual sizes beyond which a number that was found is no usual deviation, but another scale. Chosen on recorded
# vehicles: a steering in another scale must be beyond it, and the tricycle's slip, of seven usual sizes, must not.
_BEYOND = 20.0


@dataclass(frozen=True)
class Prediction:
    """How well runs are predicted that were not used: root mean squares of each run, shape (runs,), in the unit.

    Attributes:
        source, kind, unit: of the record.
        effects: names of the effects that predict.
        before, after: of the bare design and with the effects, the datum of each run fitted.
        as_logged: the same two with the start as it was logged; None for what is no track.
    """

    source: str
    kind: Kind
    unit: str
    effects: tuple[str, ...]
    before: Array
    after: Array
    as_logged: tuple[Array, Array] | None


def predict(
    nominal: Nominal, records: Sequence[Record], diagnoses: Sequence[EvidenceDiagnosis], unseen: Record
) -> Prediction:
    """Predict a record of any kind with the effects that others show.

    Args:
        nominal: the design.
        records: that were judged, one of each kind.
        diagnoses: what they show, in the same order.
        unseen: record that was not used.
    """
    kinds = [record.kind for record in records]
    joined = [unseen if record.kind is unseen.kind else record for record in records]
    others = {} if unseen.kind in kinds else {unseen.kind: unseen}
    linear = Linear.of(nominal, joined, diagnoses, others, {})
    model = linear.models[linear.kinds.index(unseen.kind)]
    effects = [(e, v) for e, v in linear.own(unseen.kind, linear.best) if not e.one_run]
    run, unit = model.rows.run, UNITS[model.unit]
    before, after = (rms_by_run(_registered(model, active), run) / unit for active in ([], effects))
    as_logged = None
    if isinstance(model, TrackModel):
        as_logged = rms_by_run(model.as_logged([]), run), rms_by_run(model.as_logged(effects), run)
    return Prediction(
        unseen.source, unseen.kind, model.unit, tuple(e.name for e, _ in effects), before, after, as_logged
    )


def predict_logged(record: Record, diagnosis: PathDiagnosis, wheelbase: float, unseen: Record) -> Prediction:
    """Predict logged runs with all effects at usual sizes, fitted to other logged runs.

    Args:
        record: the logged runs that are fitted.
        diagnosis: what they show.
        wheelbase: of the car, mm.
        unseen: runs that were not used.
    """
    build = record.kind.model
    assert build is not None
    fitted, model = (build(one, LoggedCar(wheelbase, diagnosis.accepted)) for one in (record, unseen))
    active = probable(fitted, diagnosis)
    before, after, *logged = (
        np.sqrt(2) * rms_by_run(residual, model.rows.run)
        for residual in (
            _registered(model, []),
            _registered(model, active),
            model.residual([]),
            model.residual(active),
        )
    )
    names = tuple(e.name for e, _ in active)
    return Prediction(unseen.source, unseen.kind, model.unit, names, before, after, (logged[0], logged[1]))


def probable(model: Model, diagnosis: PathDiagnosis) -> Active:
    """All effects of a logged car with their most probable numbers, the start pose of each run free.

    Each is held to a size that is usual. Where many times that size was found, as of a steering that was logged in
    another scale, it is held to what was found.

    Args:
        model: of the runs that are fitted.
        diagnosis: what they show.
    """
    effects, error = model.catalogue, diagnosis.residual.after / np.sqrt(2)
    found = {value.name: value.value for finding in diagnosis.findings for value in finding.values}
    numbers = [p for e in effects for p in e.parameters]
    sizes = np.array([abs(found.get(p.name, 0.0)) * p.scale for p in numbers])
    usual = np.array([p.spread for p in numbers])
    spread = np.where(sizes > _BEYOND * usual, sizes, usual)
    weight = np.sqrt(INDEPENDENT * model.rows.runs / len(model.rows.run)) / max(error, 1e-6)
    pose = np.linalg.qr(model.offsets)[0]

    def off(values: Array) -> Array:
        left = model.residual(activated(effects, values * spread))
        return np.append(weight * (left - pose @ (pose.T @ left)), values)

    def tangents(values: Array) -> Array:
        columns = slopes(model, effects, activated(effects, values * spread)) * spread
        return np.vstack([-weight * (columns - pose @ (pose.T @ columns)), np.eye(len(values))])

    start = np.concatenate([e.start for e in effects]) / spread
    return activated(effects, least_squares(off, start, jac=tangents, ftol=1e-7, max_nfev=30).x * spread)


def _registered(model: Model, active: Active) -> Array:
    """The residual less the datum of each run."""
    residual = model.residual([*active, *((e, e.start) for e in model.datum)])
    level = Noise(np.ones(len(residual)), 0.0, 0.0, model.rows.runs)
    return registered(model, level, residual, slopes(model, model.datum, active))
