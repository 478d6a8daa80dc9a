"""Claims at their places in the as-built design, and the new cam that is made for them.

Where several subsets explain the measured runs as well, only what stands in all of them is claimed, and a cam made for
that alone misses what the others do. Each whole subset tells where the run ends, whichever is true. So the cam is made
for the one with which the run is expected to end nearest, over all that may be true: effects that are not sure by name
are taken out all the same, since their joint effect is known.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isfinite

import numpy as np

from cadgen.design.as_built import AsBuiltSection
from cadgen.design.schema import Design
from cadgen.deviations.deviation import Place
from cadgen.inference.expectation.outlook import Name, NextCam, Outlook, outlook
from cadgen.inference.measurement.claims import Claim, at_work
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding, Likely, Value
from cadgen.inference.measurement.hypothesis import on_bound
from cadgen.inference.measurement.kinds import TRACK, kind_of
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Kind
from cadgen.inference.measurement.verdict import Verdict
from cadgen.jobs.calibration.cam_on_car import nominal_of, planned_end, unmeasured
from cadgen.jobs.cam.steering_cam import default_profile
from cadgen.progress import Progress, silent


@dataclass(frozen=True, slots=True, repr=False)
class Built:
    """A claim with its place in the as-built design.

    Attributes:
        claim: with the mean of all that agree, if it stands for several.
        place: what becomes of it.
        instead: the claim that stands for the same thing in its stead.
        mean_of: sources of the records whose mean it has; empty if it has its own values.
    """

    claim: Claim
    place: Place
    instead: Claim | None = None
    mean_of: tuple[str, ...] = ()

    def __repr__(self) -> str:
        values = (f"{each.name} {each.value:.4g} ± {each.sigma:.2g}" for each in self.claim.finding.values)
        return f"<Built {self.claim.finding.effect}: {', '.join(values)}>"

    @property
    def waits(self) -> bool:
        """Whether a new cam takes it out only if the user agrees."""
        if self.place != Place.NOTED or self.instead or _instruments(self.claim):
            return False
        finding = self.claim.finding
        repeats = all(number == round(number) for _, number in finding.indices)  # with every turn of the cam
        return repeats and Place.CAR in self.claim.kind.named(finding.effect, dict(finding.indices)).places


def placed(claims: Sequence[Claim]) -> tuple[Built, ...]:
    """Everything claimed, each physical quantity at work once."""
    built = []
    for claim in claims:
        alike = [other for other in claims if other.deviation == claim.deviation]
        best, taken = at_work(alike)
        if best is not claim:
            built.append(Built(claim, Place.NOTED, best))
            continue
        place = Place.NOTED  # of an effect that may be the instrument's in all kinds of data that show it
        if not all(_instruments(other) for other in alike):
            place = taken.kind.named(taken.finding.effect, dict(taken.finding.indices)).places[0]
        built.append(Built(taken, place, mean_of=() if taken is best else tuple(c.source for c in alike)))
    return tuple(built)


def agreed_places(built: Sequence[Built]) -> list[Place]:
    """Places of effects once the user agrees to all that a cam can take out."""
    return [Place.CAR if each.waits else each.place for each in built]


def _instruments(claim: Claim) -> bool:
    """Whether data cannot tell a claim from an effect of their instrument."""
    twins = (claim.kind.catalogue.named(name) for name in claim.finding.twins)
    return any(twin is not None and twin.instrument for twin in twins)


def expected_of(
    design: Design,
    nominal: Nominal,
    diagnoses: Sequence[Diagnosis],
    placed: Sequence[tuple[Claim, Place]],
    profile: str,
    progress: Progress = silent,
) -> Outlook | None:
    """Where the run ends on the old cam and on a new one; None if the new one would be the old.

    Args:
        design: loaded design.
        nominal: what the records were measured against.
        diagnoses: what they show.
        placed: everything claimed, and what becomes of it.
        profile: of the cam that is on the car.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError, CheckError: no cam can be planned for it.
    """
    judged = tuple(d for d in diagnoses if isinstance(d, EvidenceDiagnosis))
    gone = gone_with_the_disc([d.kind for d in judged], placed)
    if not gone and not any(place in _TAKEN_OUT and not claim.absent for claim, place in placed):
        return None
    progress("driving the car on the next cam")
    built = as_built_design(design, placed, profile)
    new = NextCam(
        nominal=replace(nominal_of(built, default_profile(built).code), form_error=nominal.form_error),
        gone=gone,
    )
    return outlook(judged, nominal, new, planned_end(design, nominal), unmeasured(design, nominal))


def gone_with_the_disc(kinds: Sequence[Kind], placed: Sequence[tuple[Claim, Place]]) -> frozenset[Name]:
    """Effects that a new disc has not, by the names that they have in each kind of data.

    Of records that were judged apart each may name one thing of the disc that it came with.

    Args:
        kinds: of the records.
        placed: everything claimed, and what becomes of it.
    """
    parts = [claim for claim, place in placed if place == Place.PART]
    alike = {claim.deviation for claim in parts}
    return frozenset((claim.kind.code, claim.finding.effect) for claim in parts) | {
        (kind.code, effect.name) for kind in kinds for effect in kind.catalogue.effects if effect.deviation in alike
    }


def as_built_design(design: Design, placed: Sequence[tuple[Claim, Place]], profile: str) -> Design:
    """The design with everything claimed, as its file will have it.

    Args:
        design: loaded design.
        placed: everything claimed, and what becomes of it.
        profile: of the cam that is on the car.
    """
    effects = [
        {
            "effect": str(claim.finding.effect),
            "kind": claim.kind.code,
            "place": place,
            "values": [
                *(
                    {"name": v.name, "value": v.value, "sigma": v.sigma if isfinite(v.sigma) else None}
                    for v in claim.finding.values
                ),
                *({"name": name, "value": number} for name, number in claim.finding.indices),
            ],
        }
        for claim, place in placed
    ]
    cut_for = [e.model_dump() for e in design.as_built.effects if e.place in _TAKEN_OUT] if design.as_built else []
    section = AsBuiltSection.model_validate({"profile": profile, "effects": effects, "cut_for": cut_for})
    return design.model_copy(update={"as_built": section})


_TAKEN_OUT = (Place.CAR, Place.PROCESS)
_UNSURE = (Verdict.AMBIGUOUS, Verdict.PARTIAL)
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
    best = tuple(claims)
    outlook = expected(best)
    # A cam for the claims that would not be cut has nothing to be kept for.
    share = BETTER if outlook is None or outlook.sound else 1.0
    for some in _whole(diagnoses, best):
        other = expected(some)
        if other is None or not other.sound:
            continue
        if other.new < share * (other.old if outlook is None else outlook.new):
            best, outlook, share = some, other, 1.0
    return best, outlook


def _whole(diagnoses: Sequence[Diagnosis], claims: Sequence[Claim]) -> Iterator[tuple[Claim, ...]]:
    """The claims with each whole subset that may be true, where sure names alone do not explain the runs of a track.

    A form without a name stays: no cam is made for it. Where other records contradict the track, its own subsets go
    before what these claim of the same quantities, since it shows how the car runs.
    """
    judged = [d for d in diagnoses if isinstance(d, EvidenceDiagnosis)]
    track = next((d for d in judged if d.kind is TRACK), None)
    if track is None or track.verdict not in _UNSURE or track.runs < 2:
        return
    sources = {d.kind.code: d.source for d in judged}
    together = {track.kind.code} if track.apart else sources.keys()
    sure = {(c.kind.code, c.finding.effect): c for c in claims if c.kind.code in together and not c.absent}
    # What was judged apart, and that there is none of something, is sure as well.
    apart = [c for c in claims if (c.kind.code, c.finding.effect) not in sure]
    for likely in track.likely:
        inside = {name for name, _, _ in likely.effects}
        # A number that could go no further is none that was found.
        found = not any(on_bound(values, np.array(effect.bounds)).any() for _, effect, values in likely.effects)
        if not (found and sure.keys() < inside):
            continue
        whole = list(_claims(likely, sources, sure))
        unsure = {claim.deviation for claim in whole if not claim.sure}
        # A name that is left out of a subset must do nothing to the run, as an error of the camera does not.
        kept = {(claim.kind.code, claim.finding.effect) for claim in whole}
        moves = [TRACK.code in kinds for kinds in likely.shown]
        every = zip(likely.effects, moves, strict=True)
        lost = any(
            runs and not (effect.shape or effect.instrument) and name not in kept for (name, effect, _), runs in every
        )
        beside = [c for c in apart if not (track.apart and c.deviation in unsure)]
        if unsure and not lost and not unsure & {claim.deviation for claim in beside}:
            yield (*whole, *beside)


def _claims(likely: Likely, sources: Mapping[str, str], sure: Mapping[tuple[str, str], Claim]) -> Iterator[Claim]:
    """A subset as claims: the sure ones with its values, and of the others what is not cut into a part.

    What is not sure may be the instrument's.
    """
    sigma, first = np.sqrt(np.diag(likely.covariance)), 0
    for (kind, name), effect, values in likely.effects:
        last = first + len(values)
        numbers = tuple(
            Value(p.name, float(v / p.scale), float(s / p.scale), p.unit)
            for p, v, s in zip(effect.parameters, values, sigma[first:last], strict=True)
        )
        finding = Finding(name, numbers, effect.twins, (), effect.indices)
        first = last
        if effect.shape:
            continue
        if known := sure.get((kind, name)):
            yield replace(known, finding=finding)
        elif kind_of(kind).named(name, dict(effect.indices)).places[0] in (Place.CAR, Place.PART):
            yield Claim(sources[kind], kind_of(kind), finding, sure=False)
