"""Records of one car against its design: a diagnosis for each kind, by what all of them show together."""

from collections.abc import Sequence

from cadgen.measurement.diagnose import Step, diagnose
from cadgen.measurement.findings import EvidenceDiagnosis, PathDiagnosis
from cadgen.measurement.nominal import LoggedCar, Nominal
from cadgen.measurement.record import Record, join
from cadgen.measurement.steered import diagnose_steered
from cadgen.measurement.units import refuse_wrong_units


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
    return diagnose(joined, nominal.model, step, nominal.play)


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
