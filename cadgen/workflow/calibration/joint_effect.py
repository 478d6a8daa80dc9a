"""Effects that are not sure by name, and that a new cam takes out all the same, since their joint effect is known.

Where several subsets explain the measured runs as well, only what stands in all of them is claimed, and a cam made for
that alone misses what the others do. Each whole subset tells where the run ends, whichever is true. So the cam is made
for the one with which the run is expected to end nearest, the mean over all that may be true.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from cadgen.arrays import Array
from cadgen.deviations.effect import Effect
from cadgen.deviations.names import Place
from cadgen.expectation.outlook import Outlook
from cadgen.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding, Likely, Value
from cadgen.measurement.kinds import TRACK, kind_of
from cadgen.measurement.together import Claim
from cadgen.measurement.verdict import Verdict

# A whole subset is taken if it leaves less than this share of what the claims alone leave.
BETTER = 0.8


def with_joint_effect(
    diagnoses: Sequence[Diagnosis],
    claims: Sequence[Claim],
    expected: Callable[[Sequence[Claim]], Outlook | None],
) -> tuple[tuple[Claim, ...], Outlook | None]:
    """The claims, with what is not sure by name where that brings the run nearer; and what is then expected.

    Args:
        diagnoses: what the records show.
        claims: of their verdicts.
        expected: what a new cam is expected to do that is made for some claims; None if it would be the old one.
    """
    sure = tuple(claims)
    best, outlook = sure, expected(sure)
    for some in _whole(diagnoses, sure):
        other = expected(some)
        if other is None or not other.sound:
            continue
        now = other.old if outlook is None else outlook.new
        if other.new < (BETTER * now if best is sure else now):
            best, outlook = some, other
    return best, outlook


def _whole(diagnoses: Sequence[Diagnosis], claims: Sequence[Claim]) -> Iterator[tuple[Claim, ...]]:
    """The claims with each whole subset that may be true, where runs of a track are explained but not by sure names."""
    told = [d for d in diagnoses if isinstance(d, EvidenceDiagnosis)]
    track = next((d for d in told if d.kind is TRACK), None)
    if track is None or track.contradicted or track.verdict != Verdict.AMBIGUOUS or track.runs < 2:
        return
    sources = {d.kind.code: d.source for d in told}
    sure = {(c.kind.code, c.finding.effect): c for c in claims if c.kind.code in sources and not c.absent}
    for likely in track.likely:
        inside = {name for name, _, _ in likely.effects}
        if not sure.keys() < inside or any(e.shape or _on_bound(e, values) for _, e, values in likely.effects):
            continue
        whole = []
        for kind, finding in _findings(likely):
            if known := sure.get((kind, finding.effect)):
                whole.append(replace(known, finding=finding))
            # What is not sure is never cut into a part: it may be the instrument's.
            elif kind_of(kind).named(finding.effect, dict(finding.indices)).places[0] == Place.CAR:
                whole.append(Claim(sources[kind], kind_of(kind), finding, sure=False))
        taken = {claim.quantity for claim in whole}
        # What was judged apart stays, and that there is none of something, unless this subset has it.
        apart = [c for c in claims if (c.kind.code, c.finding.effect) not in sure and c.quantity not in taken]
        yield (*whole, *apart)


def _on_bound(effect: Effect, values: Array) -> bool:
    """Whether a number could go no further: then it is none that was found."""
    lower, upper = effect.bounds
    return bool(np.any((values <= lower) | (values >= upper)))


def _findings(likely: Likely) -> Iterator[tuple[str, Finding]]:
    sigma, first = np.sqrt(np.diag(likely.covariance)), 0
    for (kind, name), effect, values in likely.effects:
        last = first + len(values)
        yield kind, Finding(name, _values(effect, values, sigma[first:last]), effect.twins, (), effect.indices)
        first = last


def _values(effect: Effect, values: Array, sigma: Array) -> tuple[Value, ...]:
    return tuple(
        Value(p.name, float(v / p.scale), float(s / p.scale), p.unit)
        for p, v, s in zip(effect.parameters, values, sigma, strict=True)
    )
