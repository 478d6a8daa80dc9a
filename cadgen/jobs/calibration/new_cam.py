"""Expected run of the car on a new cam that compensates the effects a calibration claims."""

from collections.abc import Sequence

import numpy as np

from cadgen.arrays import Array
from cadgen.design import variation
from cadgen.design.schema import Design
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.deviations.effect import UNITS
from cadgen.deviations.track import RETURN_ERROR
from cadgen.inference.expectation.outlook import Name, Outlook, outlook
from cadgen.inference.measurement.claims import Claim
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis
from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.nominal import Nominal


def expected_of(
    design: Design, nominal: Nominal, diagnoses: Sequence[Diagnosis], placed: Sequence[tuple[Claim, Place]]
) -> Outlook | None:
    """Where the run ends on the old cam and on a new one; None if the new one would be the old.

    Args:
        design: that the new cam is made by.
        nominal: what the records were measured against.
        diagnoses: what they show.
        placed: everything claimed, and what becomes of it.
    """
    told = tuple(d for d in diagnoses if isinstance(d, EvidenceDiagnosis))
    taken: dict[Name, Array] = {}
    gone: set[Name] = set()
    for claim, place in placed:
        name = claim.kind.code, claim.finding.effect
        if place in (Place.CAR, Place.PROCESS) and not claim.absent:
            taken[name] = np.array([value.value * UNITS[value.unit] for value in claim.finding.values])
        elif place == Place.PART:
            gone.add(name)
    if not (taken or gone):
        return None
    assumed = variation.tabled_play(design)
    if assumed is not None and not any(claim.deviation == deviation.RETURN_ERROR for claim, _ in placed):
        # Where nothing is known of the play, a new cam is made for the tabled one.
        taken[TRACK.code, RETURN_ERROR.name] = np.array([assumed])
    return outlook(told, nominal, taken, frozenset(gone))
