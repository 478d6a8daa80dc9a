"""Records of one car against its design: a diagnosis for each kind, what one kind says known to the others."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cadgen.deviations import quantities
from cadgen.deviations.effect import UNITS
from cadgen.measurement.diagnose import Step, diagnose
from cadgen.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.measurement.nominal import LoggedCar, Nominal
from cadgen.measurement.record import Kind, Knowledge, Record, join
from cadgen.measurement.steered import diagnose_steered
from cadgen.measurement.units import refuse_wrong_units


def calibrate(
    records: Sequence[Record], nominal: Nominal, step: Step = lambda text: None
) -> tuple[EvidenceDiagnosis, ...]:
    """Diagnose several records by their evidence; those of one kind are taken together.

    The effects on the disc that a profile's verdict claims are known to the lift and the track; the return error that a
    transmission's claims, to a track that shows friction.

    Raises:
        DesignError, FileError: see `Nominal.model`, `record.join` and `units.refuse_wrong_units`.
    """
    kinds = dict.fromkeys(record.kind for record in records)
    joined = {kind: join([record for record in records if record.kind is kind]) for kind in kinds}
    for record in joined.values():
        refuse_wrong_units(record, nominal)
    diagnoses: dict[Kind, EvidenceDiagnosis] = {}
    behind, names = nominal, tuple[str, ...]()
    play = nominal.play
    # What says something comes before what takes it.
    for kind in sorted(joined, key=lambda kind: bool(kind.takes)):
        record = joined[kind]
        taken = behind if Knowledge.DISC in kind.takes else nominal
        diagnosis = diagnose(record, taken.model, step, play if Knowledge.PLAY in kind.takes else None)
        if Knowledge.DISC in kind.takes:
            diagnosis = _behind(diagnosis, record, nominal, names)
        if kind.tells is Knowledge.PLAY:
            play = _play(diagnosis) or play
        if kind.tells is Knowledge.DISC:
            known = [(e, v) for e, v in diagnosis.active if e.name in diagnosis.judgement.claimed]
            behind, names = nominal.with_disc(known), tuple(e.name for e, _ in known)
        diagnoses[kind] = diagnosis
    return tuple(diagnoses[kind] for kind in kinds)


def _play(diagnosis: EvidenceDiagnosis) -> tuple[float, float] | None:
    """Return error that a diagnosis claims, and its standard deviation, rad."""
    for finding in diagnosis.findings:
        claimed = finding.effect in diagnosis.judgement.claimed
        if claimed and diagnosis.kind.quantity(finding.effect) == quantities.RETURN_ERROR:
            (value,) = finding.values
            return value.value * UNITS[value.unit], value.sigma * UNITS[value.unit]
    return None


def _behind(
    diagnosis: EvidenceDiagnosis, record: Record, nominal: Nominal, names: tuple[str, ...]
) -> EvidenceDiagnosis:
    """A diagnosis with the effects that were known, and a doubt where these made things worse."""
    if not names:
        return diagnosis
    model = nominal.model(record)
    residual = model.residual([])
    without = residual - model.offsets @ np.linalg.lstsq(model.offsets, residual, rcond=None)[0]
    rms = float(np.sqrt(np.mean(without**2))) / UNITS[model.unit]
    judgement = diagnosis.judgement
    if diagnosis.residual.before > rms:
        doubt = (
            f"with {' and '.join(names)} of the profile taken as known the residual before is "
            f"{diagnosis.residual.before:.4g} and without {rms:.4g}: make sure that both files are of one disc"
        )
        judgement = replace(judgement, limits=(*judgement.limits, doubt))
    return replace(diagnosis, known=names, judgement=judgement)


def calibrate_tricycle(records: Sequence[Record], wheelbase: float, step: Step = lambda text: None) -> PathDiagnosis:
    """Diagnose runs of a tricycle whose steering was logged.

    Raises:
        FileError: see `record.join` and `units.refuse_wrong_units`.
    """
    record, logged = join(records), LoggedCar(wheelbase)
    refuse_wrong_units(record, logged)
    model = record.kind.model
    assert model is not None
    return diagnose_steered(record, lambda part: model(part, logged), step)
