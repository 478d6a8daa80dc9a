"""Records of one car against its design: a diagnosis for each kind, by what all of them show together."""

from collections.abc import Sequence
from dataclasses import replace

from cadgen.inference.measurement.diagnose import SOUND, Step, weigh
from cadgen.inference.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.inference.measurement.nominal import LoggedCar, Nominal
from cadgen.inference.measurement.record import Record, join, refuse_many_together
from cadgen.inference.measurement.steered import diagnose_steered
from cadgen.inference.measurement.units import refuse_wrong_units

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
    together = weigh(joined, nominal.model, step, nominal.play)
    if len(joined) == 1 or together.judgement.verdict in SOUND:
        return together.told(step)
    # What no car of one kind shows may be of two cars, or of one in two states: then the records are likelier apart.
    apart = [weigh([record], nominal.model, step, nominal.play) for record in joined]
    if together.best.score < sum(alone.best.score for alone in apart) + CONTRADICTED:
        return together.told(step)
    return tuple(_contradicted(diagnosis) for alone in apart for diagnosis in alone.told(step))


def _contradicted(diagnosis: EvidenceDiagnosis) -> EvidenceDiagnosis:
    limit = (
        "the records contradict each other: they are likelier of several cars than of one, and so they were judged "
        "apart; make sure that they are of one car in one state"
    )
    judgement = replace(diagnosis.judgement, limits=(*diagnosis.judgement.limits, limit))
    return replace(diagnosis, judgement=judgement, contradicted=True)


def calibrate_tricycle(records: Sequence[Record], wheelbase: float, step: Step = lambda text: None) -> PathDiagnosis:
    """Diagnose runs of a tricycle whose steering was logged.

    Args:
        records: records of runs.
        wheelbase: distance of the axles, mm.
        step: travel and time of a step of the log.

    Raises:
        FileError: see `record.join` and `units.refuse_wrong_units`.
    """
    record, logged = join(records), LoggedCar(wheelbase)
    refuse_wrong_units(record, logged)
    model = record.kind.model
    assert model is not None
    return diagnose_steered(record, lambda part: model(part, logged), step)
