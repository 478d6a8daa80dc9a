"""Calibration of a car: measured files -> one verdict for each kind of data, and what they say together."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import degrees, radians
from typing import Any

import numpy as np

from cadgen.car.against_play.profile_kinds import ACTUAL
from cadgen.car.running.mechanics import holding_friction
from cadgen.design import variation
from cadgen.design.as_built import EarlierCam, EffectSection
from cadgen.design.schema import Design
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Place
from cadgen.errors import CheckError, DesignError, FileError
from cadgen.gears.choices import StageOrder
from cadgen.inference.expectation.outlook import Outlook
from cadgen.inference.measurement.camera_frame import in_design_frame
from cadgen.inference.measurement.claims import Claim, Shared, claims, no_friction, no_play, shared
from cadgen.inference.measurement.diagnosis import (
    SOUND,
    WeighedTogether,
    calibrate_logged,
    weigh_together,
)
from cadgen.inference.measurement.findings import Diagnosis, EvidenceDiagnosis, Finding
from cadgen.inference.measurement.kinds import TRACK
from cadgen.inference.measurement.kinds.zones import Shortfall, Zones, judged, return_error, shortfall
from cadgen.inference.measurement.nominal import LoggedCar, Nominal
from cadgen.inference.measurement.odd_logs import odd_logs
from cadgen.inference.measurement.odd_runs import odd_runs
from cadgen.inference.measurement.other_cam import OtherCam, other_cam
from cadgen.inference.measurement.record import Kind, Method, Record, join, refuse_wrong_units, said
from cadgen.inference.measurement.verdict import LEFT_OVER, Judgement, Verdict
from cadgen.jobs.calibration.cam_on_car import nominal_of, other_cams, ratios_and_teeth, refuse_laps
from cadgen.jobs.calibration.new_cam import Built, agreed_places, expected_of, placed, with_joint_effect
from cadgen.jobs.calibration.sources import Source, stated_form_error
from cadgen.jobs.calibration.workshop import Workshop
from cadgen.messages import Message, joined
from cadgen.progress import Progress, silent
from cadgen.verdict import Readiness


@dataclass(frozen=True, kw_only=True)
class MeasuredDesign:
    """Facts of the design that a car was measured against, as it was loaded.

    Attributes:
        name, source, overrides, sha256: which design it is.
        values: its values without [as_built].
        cut_for: effects of [as_built] that the measured cam was made for.
        earlier: cams with which the car was measured before.
        wheelbase: of its car, mm.
        drag: greatest drag of its [mechanics], N mm.
    """

    name: str
    source: str
    overrides: tuple[str, ...]
    sha256: str
    values: Mapping[str, Any]
    cut_for: tuple[EffectSection, ...]
    earlier: tuple[EarlierCam, ...]
    wheelbase: float
    drag: float

    @classmethod
    def of(cls, design: Design) -> "MeasuredDesign":
        """Take them of a loaded design."""
        earlier = design.as_built.effects if design.as_built else ()
        return cls(
            name=design.name,
            source=design.source,
            overrides=tuple(design.overrides),
            sha256=design.content_hash,
            values=design.as_designed().values(),
            cut_for=tuple(known for known in earlier if known.place in (Place.CAR, Place.PROCESS)),
            earlier=design.as_built.cams if design.as_built else (),
            wheelbase=design.car.wheelbase_mm,
            drag=design.mechanics.drag_Nmm[1] if design.mechanics else 0.0,
        )


@dataclass(frozen=True, kw_only=True)
class ZoneMeans:
    """Return error by mean turns over zones, with its verdict.

    Attributes:
        source, kind: source and kind of the record.
        judgement, finding: verdict, and return error.
        zones: return error and turns, degrees.
        tabled: greatest return errors of the design's train by the order of its stages, deg; empty if it has none.
        shortfall: causes that would explain the smooth zone's turn; None without speed and time, or without a train.
    """

    source: str
    kind: Kind
    judgement: Judgement
    finding: Finding
    zones: Zones
    tabled: dict[StageOrder, float]
    shortfall: Shortfall | None


@dataclass(frozen=True, kw_only=True)
class CalibrationPlan:
    """Calibration of a car by measured files: everything that its report and its files say.

    Attributes:
        against: design that they were measured against.
        profile: profile of the cam that was measured, or on the car.
        profile_stated: whether the caller or a file said so.
        form_error_um: stated, and `form_error_from`: by whom.
        wheelbase: of logged tracks, mm, and whether a file said it; None without such a track.
        track_length: of the design's track, mm; None if only logged tracks and zones were given.
        sources: the files.
        diagnoses: what each kind with a forward model shows.
        zones: on means over zones.
        claims: what the verdicts claim, that there is no play where that was seen, and what is not sure by name but
            taken out for its effect on the run.
        warnings: what does not fit, but was let pass.
        outlook: what a new cam is expected to do; None where nothing is claimed that it could take out.
        outlook_agreed: the same once the user agrees to all that a cam can take out; None where nothing waits for that.
        no_cam: why no new cam can be planned for what is claimed; None where one can, or none is needed.
        other_cam: another cam that the data fit as well or better; None where there is none.
        nominal: the design as data of its kinds were judged against it; None without such data.
        holds: friction from which on the cam never leads, and the cam angle that takes it, rad; None where no such data
            show a car without play.
        workshop: what the cars of its workshop differ by; None where that is not known.
    """

    against: MeasuredDesign
    profile: str
    form_error_um: float
    form_error_from: str
    wheelbase: tuple[float, bool] | None
    track_length: float | None
    sources: tuple[Source, ...]
    diagnoses: tuple[Diagnosis, ...]
    zones: ZoneMeans | None
    claims: tuple[Claim, ...]
    warnings: tuple[str, ...]
    holds: tuple[float, float] | None = None
    outlook: Outlook | None = None
    outlook_agreed: Outlook | None = None
    no_cam: Message | None = None
    other_cam: OtherCam | None = None
    profile_stated: bool = True
    nominal: Nominal | None = None
    workshop: Workshop | None = None

    @cached_property
    def built(self) -> tuple[Built, ...]:
        """Everything claimed, each physical quantity at work once."""
        return placed(self.claims)

    @cached_property
    def shared(self) -> tuple[Shared, ...]:
        """Quantities that several kinds of data show."""
        return shared(self.claims)

    def files(self, kind: Kind) -> tuple[Source, ...]:
        """The files of a kind, in the order given."""
        return tuple(source for source in self.sources if source.kind is kind)

    @property
    def verdicts(self) -> dict[str, str]:
        """Kind of data -> class of the verdict on it, such as `traced` or `ambiguous`."""
        return {source.kind.code: self.verdict(source.kind) for source in self.sources}

    @property
    def unclear(self) -> dict[str, str]:
        """Verdicts that leave something unexplained or undecided, by the kind of data."""
        return {kind: verdict for kind, verdict in self.verdicts.items() if verdict not in SOUND}

    @property
    def left(self) -> float:
        """RMS of what remains without a name, over the noise, where it is most; 1 where only noise remains."""
        return max((diagnosis.judgement.left for diagnosis in self.diagnoses), default=1.0)

    @property
    def readiness(self) -> Readiness:
        """Whether all that was measured is explained, and with it the car: a cam made by less may end anywhere."""
        if self.unclear or self.no_cam is not None or (self.outlook is not None and not self.outlook.sound):
            return Readiness.NOT_READY
        if self.cam_unknown:
            return Readiness.NOT_READY
        return Readiness.RESERVATIONS if self.left > LEFT_OVER else Readiness.READY

    @property
    def cam_unknown(self) -> bool:
        """Whether another cam was on the car by the data, or nothing says which of two that they fit alike."""
        return self.other_cam is not None and (self.other_cam.fits_better or not self.profile_stated)

    def verdict(self, kind: Kind) -> Verdict:
        """Verdict on the files of a kind."""
        if self.zones is not None and kind is self.zones.kind:
            return self.zones.judgement.verdict
        return next(diagnosis.verdict for diagnosis in self.diagnoses if diagnosis.kind is kind)


def calibrate(
    design: Design,
    profile: str | None,
    sources: Sequence[Source],
    form_error_um: float | None = None,
    progress: Progress = silent,
    nominal: Nominal | None = None,
    workshop: Workshop | None = None,
    made: dict[tuple[str, int], Nominal | None] | None = None,
) -> CalibrationPlan:
    """Judge measured files of one car against its design.

    Args:
        design: a loaded design.
        profile: of the cam that was measured, or on the car; None for what a file says, or the actual profile.
        sources: from `read`; files of one kind are taken together.
        form_error_um: stated form error of the disc, rms; if left out, that of a printed disc if a file says that it
            is printed, and else of a machined one.
        progress: function that is called with a few words on each step.
        nominal: from `nominal_of`, if that is at hand already.
        workshop: what the cars of its workshop differ by, if that is known.
        made: designs with other cams that were made already, which is added to; see `_other_cam`.

    Raises:
        DesignError: the design or its profile cannot be built, or it has no train for a transmission's data.
        FileError: files that cannot be judged together, whose units cannot be, or that the design has in it already.
    """
    refuse_laps(design)
    _refuse_known(design, sources)
    said_of_cam = [profile] if profile is not None else [code for code in map(stated_profile, sources) if code]
    cam = said_of_cam[0] if said_of_cam else ACTUAL.code
    floor, stated = stated_form_error(sources, form_error_um)
    diagnoses: dict[Kind, Diagnosis] = {}
    track_length, holds, known, weighed = None, None, None, None
    left_out: list[Message] = []
    records = {method: [s.record for s in sources if s.kind.method is method] for method in Method}
    zones = (
        zone_means(design, join(records[Method.ZONE_MEANS]), ratios_and_teeth(design)[0])
        if records[Method.ZONE_MEANS]
        else None
    )
    if records[Method.EVIDENCE]:
        known = replace(nominal or nominal_of(design, cam, progress), form_error=floor * 1e-3)
        if workshop is not None:
            known = replace(known, usual=workshop.usual)
        if zones is not None and zones.judgement.claimed:
            known = replace(known, play=(radians(zones.zones.return_error_deg), radians(zones.zones.sigma_deg)))
        against = known

        def odd_of(whole: Record) -> dict[int, Message]:
            refuse_wrong_units(whole, against)
            return odd_runs(whole, against.model)

        sources, left_out = _without_odd_runs(
            [in_frame(source, against) for source in sources], Method.EVIDENCE, odd_of
        )
        records[Method.EVIDENCE] = [s.record for s in sources if s.kind.method is Method.EVIDENCE]
        track_length = known.track.length
        weighed = weigh_together(records[Method.EVIDENCE], known, progress)
        diagnoses |= {diagnosis.kind: diagnosis for diagnosis in weighed.diagnoses(progress)}
        holds = holding_friction(known.cut or known.lift, known.follower)
    wheelbase = None
    if logged := records[Method.RUNS_LEFT_OUT]:
        wheelbase = wheelbase_of(design.car.wheelbase_mm, logged)
        accepted = accepted_formulas(design, logged[0].kind)
        vehicle = LoggedCar(wheelbase[0], accepted)
        sources, more = _without_odd_runs(sources, Method.RUNS_LEFT_OUT, lambda whole: odd_logs(whole, vehicle))
        left_out += more
        logged = [s.record for s in sources if s.kind.method is Method.RUNS_LEFT_OUT]
        diagnosis = calibrate_logged(logged, wheelbase[0], progress, accepted)
        diagnoses[diagnosis.kind] = diagnosis
    found = _claims(design, diagnoses.values(), zones)
    if not any(c.absent and c.deviation == deviation.RETURN_ERROR and c.kind.rod_on for c in found):
        holds = None
    calibration = CalibrationPlan(
        against=MeasuredDesign.of(design),
        profile=cam,
        profile_stated=bool(said_of_cam),
        form_error_um=floor,
        form_error_from=stated,
        wheelbase=wheelbase,
        track_length=track_length,
        sources=tuple(sources),
        diagnoses=tuple(diagnoses[kind] for kind in dict.fromkeys(s.kind for s in sources) if kind in diagnoses),
        zones=zones,
        claims=tuple(found),
        warnings=(*left_out, *_warnings(design, cam, sources)),
        holds=holds,
        nominal=known,
        workshop=workshop,
    )
    if known is None:
        return calibration

    refused: list[Message] = []

    def expected(built: Sequence[Built], places: Sequence[Place]) -> Outlook | None:
        claimed = [(each.claim, place) for each, place in zip(built, places, strict=True)]
        try:
            return expected_of(design, known, calibration.diagnoses, claimed, cam, progress)
        except (DesignError, CheckError) as error:
            refused.append(error.message)
            return None

    def with_claims(some: Sequence[Claim]) -> Outlook | None:
        built = placed(some)
        return expected(built, [each.place for each in built])

    taken, outlook = with_joint_effect(calibration.diagnoses, found, with_claims)
    no_cam = refused[0] if refused and outlook is None else None
    calibration = replace(calibration, claims=taken, outlook=outlook, no_cam=no_cam)
    if weighed is not None and (outlook is not None or calibration.unclear):
        another = _other_cam(design, cam, weighed, known, progress, {} if made is None else made)
        calibration = replace(calibration, other_cam=another)
    given, agreed = [built.place for built in calibration.built], agreed_places(calibration.built)
    return calibration if agreed == given else replace(calibration, outlook_agreed=expected(calibration.built, agreed))


def calibrate_each(
    design: Design,
    profile: str | None,
    sources: Sequence[Source],
    form_error_um: float | None = None,
    progress: Progress = silent,
    workshop: Workshop | None = None,
) -> tuple[CalibrationPlan, ...]:
    """Judge every file alone, as if each were of a car of its own. Arguments and errors as in `calibrate`."""
    cams = [profile or stated_profile(source) or ACTUAL.code for source in sources]
    nominals = {cam: nominal_of(design, cam, progress) for cam in dict.fromkeys(cams)}
    made: dict[tuple[str, int], Nominal | None] = {}
    return tuple(
        calibrate(design, profile, [source], form_error_um, progress, nominals[cam], workshop, made)
        for source, cam in zip(sources, cams, strict=True)
    )


def _other_cam(
    design: Design,
    profile: str,
    weighed: WeighedTogether,
    known: Nominal,
    progress: Progress,
    made: dict[tuple[str, int], Nominal | None],
) -> OtherCam | None:
    """The cam that the records fit best of those that may be on the car beside the stated one; None if none does.

    Args:
        design: loaded design.
        profile: of the stated cam.
        weighed: joint verdict against it.
        known: what the records were measured against.
        progress: function that is called with a few words on each step.
        made: the design with each of these cams, by the stated profile and the cam's number; None for one that cannot
            be made. Those that are missing are added.
    """
    found: list[OtherCam] = []
    for number, (code, other, earlier) in enumerate(other_cams(design, profile)):
        if (profile, number) not in made:
            try:
                made[profile, number] = nominal_of(other, code, progress)
            except (DesignError, CheckError):  # a cam that cannot be made is on no car
                made[profile, number] = None
        bare = made[profile, number]
        if bare is None:
            continue
        nominal = replace(bare, form_error=known.form_error, play=known.play, usual=known.usual)
        one = other_cam(weighed.likeliest, known, nominal, code, earlier=earlier, progress=progress)
        found += [one] if one is not None else []
    return max(found, key=lambda one: one.better, default=None)


def _claims(design: Design, diagnoses: Iterable[Diagnosis], zones: ZoneMeans | None) -> list[Claim]:
    """Claims of the verdicts, and of no play where they would have claimed play of the tabled size."""
    tabled = variation.tabled_play(design)
    found: list[Claim | None] = []
    for diagnosis in diagnoses:
        found += claims(diagnosis)
        unnamed = diagnosis.unnamed if isinstance(diagnosis, EvidenceDiagnosis) else {}
        if tabled is not None and (play := unnamed.get(deviation.RETURN_ERROR)):
            found.append(no_play(diagnosis.source, diagnosis.kind, play, degrees(tabled)))
        if friction := unnamed.get(deviation.SLIDING_FRICTION):
            found.append(no_friction(diagnosis.source, diagnosis.kind, friction))
    if zones is not None and zones.judgement.claimed:
        found.append(Claim(zones.source, zones.kind, zones.finding))
    elif zones is not None and tabled is not None and zones.judgement.verdict in SOUND:
        found.append(no_play(zones.source, zones.kind, zones.finding, degrees(tabled)))
    return [claim for claim in found if claim is not None]


def accepted_formulas(design: Design, kind: Kind) -> frozenset[str]:
    """Names of the effects of a kind of logged runs that the design has, formulas among them.

    Args:
        design: loaded design.
        kind: of the logged runs.
    """
    known = design.as_built.effects if design.as_built else ()
    return frozenset(effect.effect for effect in known if effect.kind == kind.code)


def wheelbase_of(designed: float, records: Sequence[Record]) -> tuple[float, bool]:
    """Wheelbase of the logged car, mm, and whether it is from a file.

    Args:
        designed: wheelbase of the design, mm, which holds where no file says it.
        records: records of the logged car.
    """
    stated = {float(match[0]) for record in records if (match := said(record, r"wheelbase ([0-9.]*[0-9]) mm"))}
    if len(stated) > 1:
        raise FileError(
            "{names} say different wheelbases, {stated} mm: judge them apart",
            names=joined((r.source for r in records), " and "),
            stated=sorted(stated),
        )
    return (stated.pop(), True) if stated else (designed, False)


def _refuse_known(design: Design, sources: Sequence[Source]) -> None:
    """The effects of a file that a design was calibrated with are in it, and would be found a second time."""
    known = {} if design.as_built is None else {source.sha256: source.file for source in design.as_built.sources}
    for source in sources:
        if source.sha256 in known:
            raise FileError(
                "{file} is among the files that {name} was calibrated with ({known} in [as_built.sources]), so its "
                "effects would count twice: judge it against the design that it came from, or measure again with the "
                "new cam",
                file=source.path,
                name=design.name,
                known=known[source.sha256],
            )


def in_frame(source: Source, known: Nominal) -> Source:
    """File whose places are in the frame of the design; others as they are.

    Args:
        source: measured file.
        known: the design.
    """
    if source.kind is not TRACK:
        return source
    return replace(source, record=in_design_frame(source.record, known.track))


def _without_odd_runs(
    sources: Sequence[Source], method: Method, odd_of: Callable[[Record], dict[int, Message]]
) -> tuple[list[Source], list[Message]]:
    """Files less the runs that are not of the others' car, and a sentence on each of these.

    Args:
        sources: all files.
        method: by which the kinds are judged that are looked at.
        odd_of: finds those runs in the joined record of a kind, with what is off about each.
    """
    kept, words = [], []
    odd: dict[Kind, dict[int, Message]] = {}
    before: dict[Kind, int] = {}
    for source in sources:
        kind, runs = source.kind, source.record.runs
        if kind.method is method and kind not in odd:
            odd[kind] = odd_of(join([other.record for other in sources if other.kind is kind]))
        first = before.get(kind, 0)
        before[kind] = first + runs
        mine = {number - first: why for number, why in odd.get(kind, {}).items() if first <= number < first + runs}
        words += [
            Message("run {run} of {file} is left out: {why}", run=number + 1, file=source.path.name, why=why)
            for number, why in mine.items()
        ]
        if rest := [number for number in range(runs) if number not in mine]:
            kept.append(replace(source, record=source.record.only(np.array(rest))) if mine else source)
    return kept, words


def _warnings(design: Design, profile: str, sources: Sequence[Source]) -> list[str]:
    found: list[str] = []
    if design.as_built is not None and design.as_built.profile == profile:
        found.append(
            Message(
                "the design has [as_built] of a car with the {profile} profile, and was judged "
                "with --profile {profile}: that means a new cam, cut for what [as_built] says; "
                "data of the older cam belong to the design without it",
                profile=profile,
            )
        )
    for source in sources:
        name = said(source.record, r"^design: *([A-Za-z0-9._-]+)")
        if source.kind.of_design and name and name[0] != design.name:
            found.append(
                Message(
                    "{source} says design {name}, but it was judged against {design}",
                    source=source.record.source,
                    name=name[0],
                    design=design.name,
                )
            )
        made = stated_profile(source)
        if made and made != profile:
            found.append(
                Message(
                    "{source} says {made} profile, but it was judged against {profile}",
                    source=source.record.source,
                    made=made,
                    profile=profile,
                )
            )
    return found


def stated_profile(source: Source) -> str:
    """Code of the profile that a file says was on the car; empty if it says none.

    Args:
        source: measured file.
    """
    made = said(source.record, r"\b(actual|theoretical|published|optimized|compensated|smoothed) profile\b")
    return made[0] if made else ""


def zone_means(design: Design, record: Record, ratios: tuple[float, ...]) -> ZoneMeans:
    """Judge mean turns over zones.

    Args:
        design: design with the train, for its return errors.
        record: record of zones.
        ratios: ratios of the train's stages; empty if there is none.

    Raises:
        FileError: a zone that is unknown or missing.
    """
    tabled = {order: degrees(play.return_error_max) for order, play in variation.train_plays(design).items()}
    zones = return_error(record, tuple(tabled.values()))
    judgement, finding = judged(record, zones)
    speed, time = said(record, r"([0-9.]*[0-9]) rpm"), said(record, r"([0-9.]*[0-9]) s a trial")
    ratio = float(np.prod(ratios))
    why = None
    if speed and time and design.train is not None:
        why = shortfall(zones, rpm=float(speed[0]), seconds=float(time[0]), ratio=ratio)
    return ZoneMeans(
        source=record.source,
        kind=record.kind,
        judgement=judgement,
        finding=finding,
        zones=zones,
        tabled=tabled,
        shortfall=why,
    )
