"""Records of one car against its design: a diagnosis for each kind, by what all of them show together."""

from collections.abc import Sequence
from dataclasses import replace

from cadgen.measurement.diagnose import SOUND, Step, diagnose
from cadgen.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.measurement.nominal import LoggedCar, Nominal
from cadgen.measurement.record import Record, join
from cadgen.measurement.steered import diagnose_steered
from cadgen.measurement.units import refuse_wrong_units
from cadgen.measurement.verdict import LEFT_OVER

# Verdicts that records of one car do not have together if each is sound alone.
NOT_ONE_CAR = ("unexplained", "runs disagree", "untraced shape", "partial")


def calibrate(
    records: Sequence[Record], nominal: Nominal, step: Step = lambda text: None
) -> tuple[EvidenceDiagnosis, ...]:
    """Diagnose several records of one car by their joint evidence; those of one kind are taken together.

    Returns:
        What each kind shows, in the order given.

    Raises:
        DesignError, FileError: see `Nominal.model`, `record.join` and `units.refuse_wrong_units`.
    """
    kinds = dict.fromkeys(record.kind for record in records)
    joined = [join([record for record in records if record.kind is kind]) for kind in kinds]
    for record in joined:
        refuse_wrong_units(record, nominal)
    told = diagnose(joined, nominal.model, step, nominal.play)
    if len(joined) == 1 or all(_explains(diagnosis) for diagnosis in told):
        return told
    # What no car of one kind shows may be of two cars, or of one in two states: then each record is sound alone.
    apart = tuple(diagnosis for record in joined for diagnosis in diagnose([record], nominal.model, step, nominal.play))
    if not all(diagnosis.verdict in SOUND and _explains(diagnosis) for diagnosis in apart):
        return told
    return tuple(_contradicted(diagnosis) for diagnosis in apart)


def _explains(diagnosis: EvidenceDiagnosis) -> bool:
    """Do the effects found leave no more than noise, with what repeats in the other runs taken out?"""
    r = diagnosis.residual
    left = r.after if r.left_out is None else r.left_out.repeating
    return diagnosis.verdict not in NOT_ONE_CAR and left <= LEFT_OVER * r.noise


def _contradicted(diagnosis: EvidenceDiagnosis) -> EvidenceDiagnosis:
    limit = (
        "the records contradict each other: no car shows all of them, though each is sound alone, so they were judged "
        "apart; make sure that they are of one car in one state"
    )
    judgement = replace(diagnosis.judgement, limits=(*diagnosis.judgement.limits, limit))
    return replace(diagnosis, judgement=judgement, contradicted=True)


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
