"""Records of one car against its design: a diagnosis for each kind, by what all of them show together."""

from collections.abc import Sequence
from dataclasses import replace

from cadgen.measurement.diagnose import SOUND, Step, diagnose
from cadgen.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.measurement.nominal import LoggedCar, Nominal
from cadgen.measurement.record import Record, join, refuse_many_together
from cadgen.measurement.steered import diagnose_steered
from cadgen.measurement.units import refuse_wrong_units

# Records of one car are likelier together. By so much of the criterion (odds of 3 million to one) they must be likelier
# apart before they are said to contradict each other.
CONTRADICTED = 30.0


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
    refuse_many_together(joined)
    for record in joined:
        refuse_wrong_units(record, nominal)
    told = diagnose(joined, nominal.model, step, nominal.play)
    if len(joined) == 1 or told[0].verdict in SOUND:
        return told
    # What no car of one kind shows may be of two cars, or of one in two states: then the records are likelier apart.
    apart = tuple(diagnosis for record in joined for diagnosis in diagnose([record], nominal.model, step, nominal.play))
    if told[0].score < sum(diagnosis.score for diagnosis in apart) + CONTRADICTED:
        return told
    return tuple(_contradicted(diagnosis) for diagnosis in apart)


def _contradicted(diagnosis: EvidenceDiagnosis) -> EvidenceDiagnosis:
    limit = (
        "the records contradict each other: they are likelier of several cars than of one, and so they were judged "
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
