"""From measured data to a verdict: noise, search, comparison of the rivals, and a test on runs left out.

`calibrate` is the entry: records of one car against its design give a diagnosis for each kind of data.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.effect import UNITS, Active, Effect, Quantity
from cadgen.deviations.lift import Readings
from cadgen.inference.measurement.doubts import with_doubts
from cadgen.inference.measurement.evidence import Evidence, estimate_noise, grid_of, registered
from cadgen.inference.measurement.findings import (
    Candidate,
    EvidenceDiagnosis,
    Finding,
    HeldOut,
    Likely,
    PathDiagnosis,
    PerRun,
    Residual,
    Unnamed,
    Value,
)
from cadgen.inference.measurement.hypothesis import Hypothesis, Search, fit, sized
from cadgen.inference.measurement.joint import Build, Joint, Part
from cadgen.inference.measurement.kinds.track import TrackModel
from cadgen.inference.measurement.model import Model, repeating, rms_by_run, slopes
from cadgen.inference.measurement.nominal import LoggedCar, Nominal
from cadgen.inference.measurement.record import Datum, Kind, Record, join, refuse_many_together, refuse_wrong_units
from cadgen.inference.measurement.reservations import (
    refuse_too_few,
    resolved,
    unfit,
    with_cameras,
    with_friction_judged,
    with_known_play,
    with_reservations,
)
from cadgen.inference.measurement.runs_left_out import diagnose_logged
from cadgen.inference.measurement.search import Start, best_of, find, not_holding
from cadgen.inference.measurement.verdict import Judgement, Verdict, judge, shapes_of
from cadgen.messages import Message, joined
from cadgen.progress import Progress, silent

# A subset less likely than this does not change what is expected of the car.
LEAST_WEIGHT = 1e-3
# Noise that falls to this share once the likeliest effects are taken out was theirs.
NOT_NOISE = 0.8
# A discrepancy is said if one of its numbers is so many standard deviations from nothing.
SURE_SIGMAS = 4.0
# Of many runs several are left out at a time, for so many fits at most.
MOST_FITS = 10
# Verdicts beside which it counts that a deviation is not named.
SOUND = (Verdict.NONE, Verdict.TRACED, Verdict.COMBINATION)


@dataclass(frozen=True)
class Weighed:
    """The joint verdict, the subset that it is on, all that were fitted, and whether a known play is in it."""

    joint: Joint
    judgement: Judgement
    best: Hypothesis
    found: list[Hypothesis]
    play_known: bool

    def diagnoses(self, progress: Progress = silent) -> tuple[EvidenceDiagnosis, ...]:
        """Diagnosis of each record by the joint verdict, with the residual of runs left out."""
        return tuple(_diagnosis(self, part, progress) for part in self.joint.parts)


def weigh(
    records: Sequence[Record],
    build: Build,
    progress: Progress = silent,
    play: tuple[float, float] | None = None,
    usual: Mapping[Quantity, tuple[float, float]] | None = None,
    starts: Sequence[Start] = (),
) -> Weighed:
    """Search the effects that explain records of one car, and judge them.

    Args:
        records: measured data, one record of each kind.
        build: makes the forward model of a record; called again for records with some runs left out.
        progress: function that is called with a few words on each step.
        play: return error that was measured apart, and its standard deviation, rad.
        usual: of the workshop, as of `Nominal`.
        starts: subsets to be fitted first, with values to begin from.

    Raises:
        FileError: one run only, with too few rows to tell its noise.
    """
    models = [build(record) for record in records]
    parts, grid = [], grid_of(models)
    for record, model in zip(records, models, strict=True):
        progress(Message("{source}: telling noise from what repeats", source=record.source))
        refuse_too_few(record, model)
        noise = resolved(record, estimate_noise(model, model.residual([(e, e.start) for e in model.datum])))
        parts.append(Part(record, build, model, noise, Evidence(model, noise, grid)))
    return weigh_parts(Joint.of(parts), progress, play, usual, starts)


def weigh_parts(
    joint: Joint,
    progress: Progress = silent,
    play: tuple[float, float] | None = None,
    usual: Mapping[Quantity, tuple[float, float]] | None = None,
    starts: Sequence[Start] = (),
) -> Weighed:
    """Search the effects that explain records with their noise, and judge them; arguments as of `weigh`."""
    count = len(joint.core) + len(joint.members)
    progress(Message("{source}: comparing all small subsets of {count} effects", source=joint.source, count=count))
    found = find(joint, usual, starts)
    quieter = []
    for part in joint.parts:
        noise = resolved(part.record, estimate_noise(part.model, part.residual(found[0].active)))
        less = noise.rms <= NOT_NOISE * part.noise.rms
        quieter.append(replace(part, noise=noise, evidence=Evidence(part.model, noise, joint.grid)) if less else part)
    if any(new is not old for new, old in zip(quieter, joint.parts, strict=True)):
        # Runs that were taken differently differ by an effect, and not by noise alone.
        joint = replace(joint, parts=tuple(quieter))
        found = find(joint, usual, starts)
    judgement, best = judge(joint, found)
    searched: set[str] = set()
    while shapes_of(best) and (names := [name for name in judgement.claimed if name not in searched]):
        # What stands for a name, where something has none, is searched for: few subsets without it were fitted.
        known = {h.key: h for h in reversed(found)}
        for name in names:
            progress(Message("{source}: searching without {name}", source=joint.source, name=Message(name)))
            start = not_holding(best.effects, name), best.active
            for h in find(joint, usual, [start], name, found, found[0].score):
                known[h.key] = min(h, known.get(h.key, h), key=lambda h: h.score)
        searched |= set(names)
        found = sorted(known.values(), key=lambda h: h.score)
        judgement, best = judge(joint, found)
    judgement = with_doubts(judgement, joint, best)
    found_alone = best = sized(joint, best)
    best, another = with_known_play(joint, best, play)
    for part in joint.parts:
        after = registered(part.model, part.noise, part.residual(best.active) - _discrepancy(part, joint, best)[0])
        chance = unfit(part.model, part.evidence, part.noise, best, part.residual(best.active))
        judgement = with_reservations(judgement, part.record, part.model, part.noise, best, after, chance)
    judgement = with_cameras(judgement, joint, best)
    judgement = with_friction_judged(judgement, best, play_known=best is not found_alone)
    if another:
        judgement = replace(judgement, limits=(*judgement.limits, another))
    return Weighed(joint, judgement, best, found, best is not found_alone)


def _diagnosis(result: Weighed, part: Part, progress: Progress) -> EvidenceDiagnosis:
    """Diagnosis of one record by the joint verdict."""
    joint, best, record, model, noise = result.joint, result.best, part.record, part.model, part.noise
    none = next(h for h in result.found if not h.effects)
    before, after = (registered(model, noise, part.residual(h.active)) for h in (none, best))
    datum, held, against = _datum(record.kind.datum, part, best)
    held_out: list[tuple[Array, Array]] = []
    for runs in np.array_split(np.arange(record.runs), min(record.runs, MOST_FITS)) if record.runs > 1 else ():
        which = (
            Message("run {run}", run=runs[0] + 1)
            if len(runs) == 1
            else Message("runs {first} to {last}", first=runs[0] + 1, last=runs[-1] + 1)
        )
        progress(Message("{source}: {which} left out", source=record.source, which=which))
        held_out += _held_out(joint, part, best, runs)
    scale = UNITS[model.unit]
    whole, less = ([pair[k] for pair in held_out] for k in (0, 1))
    left_out = HeldOut(*(_rms(np.concatenate(rest)) / scale for rest in (whole, less))) if held_out else None
    entries = [(e, part.names[e.key], v, s) for e, v, s in best.values() if e.key in part.names]
    findings = tuple(replace(Finding.of(own, v, s, best.at_bound), twins=e.twins) for e, own, v, s in entries)
    here = {e.name: own.name for e, own, _, _ in entries}
    judgement = replace(
        result.judgement,
        claimed=tuple(here[name] for name in result.judgement.claimed if name in here),
        limits=(*result.judgement.limits, *against),
    )
    return EvidenceDiagnosis(
        source=record.source,
        kind=record.kind,
        unit=model.unit,
        judgement=judgement,
        findings=findings,
        leads=tuple(here[e.name] for e in best.effects if joint.kinds.get(e.key) is part.kind and e.name in here),
        datum=datum,
        held=held,
        discrepancy=_discrepancy(part, joint, best)[1],
        candidates=tuple(
            Candidate(
                tuple(e.name for e in h.effects),
                h.score - result.found[0].score,
                tuple(Finding.of(*entry, h.at_bound) for entry in h.values()),
            )
            for h in result.found
        ),
        residual=Residual(_rms(before) / scale, _rms(after) / scale, noise.rms / scale, left_out),
        per_run=PerRun(
            rms_by_run(before, model.rows.run) / scale,
            rms_by_run(after, model.rows.run) / scale,
            np.array([_rms(rest) for rest in whole]) / scale if held_out else None,
        ),
        correlation=noise.correlation,
        place=model.rows.place,
        run=model.rows.run.astype(float),
        before=before,
        after=after,
        active=[(own, v) for _, own, v, _ in entries],
        measured=model.measured,
        backwards=model.rows.direction < 0 if isinstance(model.rows, Readings) else None,
        unnamed=_unnamed(part, result),
        play_known=result.play_known,
        score=best.score,
        likely=_likely(result),
    )


def _likely(result: Weighed) -> tuple[Likely, ...]:
    """The subsets that may be true, the reported one with the values reported, with their weights."""
    joint, best = result.joint, result.best
    fitted = [best, *(h for h in result.found if h.key != best.key)]
    least = min(h.score for h in fitted)
    weight = np.exp([(least - h.score) / 2 for h in fitted])
    weight /= weight.sum()
    out = []
    for h, share in zip(fitted, weight, strict=True):
        if share < LEAST_WEIGHT and h is not best:
            continue
        first = len(h.covariance) - sum(len(v) for _, v, _ in h.values())
        effects = tuple(((joint.kinds[e.key].code, joint.own_name(e)), e, v) for e, v, _ in h.values())
        shown = tuple(
            frozenset(part.record.kind.code for part in joint.parts if e.key in part.names) for e, _, _ in h.values()
        )
        out.append(Likely(float(share), effects, h.covariance[first:, first:], shown, _at_end(joint, h)))
    total = sum(likely.weight for likely in out)
    return tuple(replace(likely, weight=likely.weight / total) for likely in out)


# A spectrum that explains a residual with less than this chance is left out.
LEAST_CHANCE = 0.02
# Chance that a car goes crabwise by as much as may be; and of that, that the camera's frame is turned instead.
CRABWISE, FRAME = 0.2, 0.25


def _at_end(joint: Joint, subset: Hypothesis) -> tuple[Unnamed, ...]:
    """Repeating error beside the effects of a subset at the end of a track, by all that it may be.

    Few runs whose starts are all turned to one side are a car that goes crabwise, or started so by chance.
    """
    part = next((part for part in joint.parts if isinstance(part.model, TrackModel)), None)
    if part is None or not isinstance(part.model, TrackModel):
        return ()
    model, misfit = part.model, joint.misfit(subset.active)
    misfit = np.where(joint.within == subset.spectrum.within, misfit, np.inf)
    near = misfit < misfit.min() - 2 * np.log(LEAST_CHANCE)
    grid = tuple(replace(joint.grid[n], whole_frame=whole) for n in np.flatnonzero(near) for whole in (False, True))
    white = part.evidence.whiten(part.residual(subset.active))
    poses = part.evidence.datum(white, int(misfit.argmin())).reshape(-1, 3)
    evidence = Evidence(model, part.noise, grid, model.shown_spread(poses))
    # Records beside the track have the same evidence with and without.
    misfit = np.repeat((misfit - part.misfit(subset.active))[near], 2) + evidence.misfit(white)
    chance = np.exp((misfit.min() - misfit) / 2) * np.tile([1 - CRABWISE, CRABWISE], int(near.sum()))
    ends, found = np.flatnonzero(model.rows.run == 0), []
    x, y = repeating(model)[ends[[len(ends) // 2 - 1, -1]]]
    slope = part.evidence.whiten(_slopes(part, subset))
    for number, spectrum in enumerate(grid):
        values, own = evidence.repeating(white, number), model.discrepancy.of_frame
        weight, orders = float(chance[number] / chance.sum()), model.form.shape[1]
        unsure, answer = evidence.unsure(number), -evidence.repeating(slope, number)
        one = Unnamed(weight, values, unsure, answer, x + 1j * y, orders, spectrum)
        if own is not None and spectrum.whole_frame:
            level = np.where(np.arange(len(values)) == own + orders, 0.0, values)
            found.append(replace(one, weight=FRAME * weight, values=level))
            one = replace(one, weight=(1 - FRAME) * weight)
        found.append(one)
    return tuple(found)


def _slopes(part: Part, subset: Hypothesis) -> Array:
    """How a record answers each parameter of a subset, shape (n, p), internal units; nothing of other records' own."""
    columns = []
    for effect, values, _ in subset.values():
        here = tuple(part.names[effect.key] for _ in range(effect.key in part.names))
        own = part.slopes(here, part.own(subset.active), part.residual(subset.active))
        columns.append(own if here else np.zeros((len(own), len(values))))
    return np.hstack([np.empty((len(part.model.rows.run), 0)), *columns])


def _unnamed(part: Part, result: Weighed) -> dict[Deviation, Finding]:
    """How much of some quantities there could be where several runs and a sound verdict name none.

    Where it is not clear what is there, one that the likeliest subset has but cannot be claimed is looked at by itself:
    play that friction may hold is none in the run.
    """
    joint, best, judgement = result.joint, result.best, result.judgement
    # Beside a form that has a place and a size, what is not there would have been seen too.
    doubtful = judgement.verdict == Verdict.AMBIGUOUS
    sound = doubtful or judgement.verdict in SOUND or (judgement.verdict == Verdict.PARTIAL and best.spectrum.within)
    if part.model.rows.runs < 2 or not sound:
        return {}
    named = {e.deviation for e in best.effects if e.name in judgement.claimed or not doubtful}
    unnamed: dict[Deviation, Finding] = {}
    for effect in joint.core:
        deviation = effect.deviation
        if deviation is None or deviation not in part.kind.absences or deviation in named or deviation in unnamed:
            continue
        if joint.kinds[effect.key] is not part.kind:
            continue
        if effect.beside and effect.beside.name not in judgement.claimed:
            continue
        # With the effects found free beside it, what they could hide of it widens its error.
        others = tuple(e for e in best.effects if deviation not in (e.deviation, e.beside and e.beside.deviation))
        beside = fit(joint, (*others, effect), best.active, Search(1))
        unnamed[deviation] = next(
            Finding.of(*entry, beside.at_bound) for entry in beside.values() if entry[0] == effect
        )
    return unnamed


def _discrepancy(part: Part, joint: Joint, best: Hypothesis) -> tuple[Array, Finding | None]:
    """Share of the discrepancy in the best subset's residual, and its numbers where they are significant."""
    model, evidence = part.model, part.evidence
    of, orders = model.discrepancy, model.form.shape[1]
    spectrum = joint.grid.index(best.spectrum)
    values = evidence.repeating(evidence.whiten(part.residual(best.active)), spectrum)[orders:]
    sigma = np.sqrt(np.diag(evidence.unsure(spectrum))[orders:])
    shown = tuple(map(Value.of, of.numbers, values, sigma))
    sure = any(abs(v.value) > SURE_SIGMAS * v.sigma for v in shown)
    return of.columns @ values, Finding(of.words, shown, (), ()) if sure else None


def _datum(datum: Datum, part: Part, best: Hypothesis) -> tuple[tuple[Finding, ...], str, tuple[str, ...]]:
    """The datum freedoms of each run beside the effects, what was known of them, and what speaks against that."""
    if not datum.numbers:
        return (), "", ()
    model, noise = part.model, part.noise
    mine = [(part.names[e.key], v, s) for e, v, s in best.datum() if e.key in part.names]
    fitted = (datum.fit or _offsets)(model, part.residual(best.active), noise.sigma, part.own(best.active), mine)
    held, against = datum.notes(model, *fitted) if datum.notes else ("", ())
    found = tuple(
        Finding(
            Message("{name}, run {run}", name=Message(datum.name), run=run + 1),
            tuple(Value.of(*each) for each in zip(datum.numbers, values, sigmas, strict=True)),
            (),
            (),
        )
        for run, (values, sigmas) in enumerate(zip(*fitted, strict=True))
    )
    return found, held, against


def _offsets(
    model: Model, residual: Array, sigma: Array, active: Active, datum: list[tuple[Effect, Array, Array]]
) -> tuple[Array, Array]:
    """Values of the linear freedoms of each run and their standard deviations; see `record.DatumFit`."""
    white = model.offsets / sigma[:, None]
    values = np.linalg.lstsq(white, residual / sigma, rcond=None)[0]
    error = np.sqrt(np.diag(np.linalg.pinv(white.T @ white)))
    shape = (model.rows.runs, -1)
    return np.asarray(values, dtype=float).reshape(shape), np.asarray(error, dtype=float).reshape(shape)


def _held_out(joint: Joint, part: Part, best: Hypothesis, runs: NDArray[np.intp]) -> list[tuple[Array, Array]]:
    """Residual of each run left out, effects from all else: datum refitted, without and with what the others repeat."""
    others, tests = joint.without(part, runs, best.spectrum)
    train = next(p for p, whole in zip(others.parts, joint.parts, strict=True) if whole is part)
    # A step within one run is no use for another.
    effects = tuple(e for e in best.effects if not e.one_run)
    active = fit(others, effects, best.active, Search(1)).active
    repeats = train.evidence.repeating(train.evidence.whiten(train.residual(active)), 0)
    out = []
    for test in tests:
        own = test.residual(active)
        # Of a datum that is no column, a run left out has its own value too.
        turned = slopes(test.model, test.model.datum, test.own(active))
        less = own - repeating(test.model) @ repeats
        out.append((registered(test.model, test.noise, own, turned), registered(test.model, test.noise, less, turned)))
    return out


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


# Records of one car are likelier together. By so much of the criterion (odds of 3 million to one) they must be likelier
# apart before they are said to contradict each other.
CONTRADICTED = 30.0


def calibrate(
    records: Sequence[Record], nominal: Nominal, progress: Progress = silent
) -> tuple[EvidenceDiagnosis, ...]:
    """Diagnose several records of one car by their joint evidence; those of one kind are taken together.

    Returns:
        What each kind shows, in the order given.

    Raises:
        DesignError, FileError: see `Nominal.model`, `record.join` and `units.refuse_wrong_units`.
    """
    return weigh_together(records, nominal, progress).diagnoses(progress)


@dataclass(frozen=True)
class WeighedTogether:
    """Joint verdict on records of one car, and on each alone where that is asked.

    Attributes:
        joint: the joint verdict.
        records: as their files are, one of each kind.
        alone: verdict on one of them.
        without: weighs the records without some.
        together: joint verdict that searches for as much as another did, from subsets to be fitted first; None if none
            of them is likelier than that one's.
        seen: joint verdict that searches for errors of the camera, too; None if none is likely.
    """

    joint: Weighed
    records: tuple[Record, ...]
    alone: Callable[[Record], Weighed]
    without: Callable[[Collection[Kind]], "WeighedTogether"]
    together: Callable[[Weighed, Sequence[Start]], Weighed | None]
    seen: Callable[[], Weighed | None]

    @cached_property
    def likeliest(self) -> Weighed:
        """Joint verdict; where it is not sound, with the camera's errors if these are likelier.

        Where that is not sound either, it is from what each record shows by itself, if that is likelier for all.
        """
        found = self.joint
        if len(self.records) == 1 or found.judgement.verdict in SOUND:
            return found
        found = self.seen() or found
        if found.judgement.verdict in SOUND:
            return found
        return self.together(found, _starts(found.joint, [self.alone(record) for record in self.records])) or found

    def diagnoses(self, progress: Progress = silent) -> tuple[EvidenceDiagnosis, ...]:
        """Diagnosis of each record: by itself where they contradict each other, or where no effect explains it."""
        joint = self.likeliest
        if len(self.records) == 1 or joint.judgement.verdict in SOUND:
            return joint.diagnoses(progress)
        # What no car of one kind shows may be of two cars, or of one in two states: records are likelier apart then.
        apart = [self.alone(record) for record in self.records]
        if joint.judgement.verdict is Verdict.UNEXPLAINED:
            odd = {r.kind: one for r, one in zip(self.records, apart, strict=True) if _unexplained(one)}
            if 0 < len(odd) < len(apart):
                return self._without(odd, progress)
        if joint.best.score < sum(each.best.score for each in apart) + CONTRADICTED:
            return joint.diagnoses(progress)
        limit = Message(
            "the records contradict each other: they are likelier of several cars than of one, and so they were judged "
            "apart; make sure that they are of one car in one state"
        )
        return tuple(
            replace(each, judgement=replace(each.judgement, limits=(*each.judgement.limits, limit)), apart=True)
            for one in apart
            for each in one.diagnoses(progress)
        )

    def _without(self, odd: Mapping[Kind, Weighed], progress: Progress) -> tuple[EvidenceDiagnosis, ...]:
        """Diagnoses where some records are unexplained by themselves: the others are judged without them."""
        limit = Message(
            "{files} by itself is explained by no effect, and is not used here: find out why, or measure it again",
            files=joined((record.source for record in self.records if record.kind in odd), " and "),
        )
        told = {each.kind: each for each in self.without(odd).diagnoses(progress)}
        for kind, each in told.items():
            told[kind] = replace(each, judgement=replace(each.judgement, limits=(*each.judgement.limits, limit)))
        for kind, one in odd.items():
            (each,) = one.diagnoses(progress)
            told[kind] = replace(each, apart=True)
        return tuple(told[record.kind] for record in self.records)


def _unexplained(one: Weighed) -> bool:
    return one.judgement.verdict is Verdict.UNEXPLAINED


def weigh_together(records: Sequence[Record], nominal: Nominal, progress: Progress = silent) -> WeighedTogether:
    """Weigh several records as those of one car; arguments and errors as of `calibrate`."""
    kinds = dict.fromkeys(record.kind for record in records)
    joined = [join([record for record in records if record.kind is kind]) for kind in kinds]
    refuse_many_together(joined)
    for record in joined:
        refuse_wrong_units(record, nominal)
    known: dict[Kind, Weighed] = {}

    def alone(record: Record) -> Weighed:
        if record.kind not in known:
            known[record.kind] = weigh([record], nominal.model, progress, nominal.play, nominal.usual)
        return known[record.kind]

    def without(kinds: Collection[Kind]) -> WeighedTogether:
        return weigh_together([record for record in joined if record.kind not in kinds], nominal, progress)

    if len(joined) == 1:
        one = alone(joined[0])
        return WeighedTogether(one, tuple(joined), alone, without, lambda found, starts: None, lambda: None)
    # Friction acts in all records of a car, but where the rod was lifted.
    settled = [record.kind.settled(record, partial(_shown, alone, record)) for record in joined]

    rest = progress, nominal.play, nominal.usual
    first = _with_states(weigh(settled, nominal.model, *rest), joined)

    def weighed(joint: Joint, starts: Sequence[Start]) -> Weighed:
        return _with_states(weigh_parts(joint, *rest, starts), joined)

    def together(found: Weighed, starts: Sequence[Start]) -> Weighed | None:
        better = best_of(found.joint, nominal.usual, starts).score < found.found[0].score
        return weighed(found.joint, starts) if better else None

    def seen() -> Weighed | None:
        joint, best, cameras = first.joint.with_cameras, first.best, first.joint.cameras
        # A search for them takes as long as the first, so one of them beside what was found must be likelier, or all.
        beside = [((*best.effects, *some), best.active) for some in (*((each,) for each in cameras), cameras) if some]
        if not beside or best_of(joint, nominal.usual, beside).score >= first.found[0].score:
            return None
        found = weighed(joint, [(best.effects, best.active)])
        return found if found.found[0].score < first.found[0].score else None

    return WeighedTogether(first, tuple(joined), alone, without, together, seen)


def _starts(joint: Joint, apart: Sequence[Weighed]) -> list[Start]:
    """Named effects that each record shows by itself, and all of them together, as effects of all records."""
    effects, starts = {e.key: e for e in (*joint.core, *joint.members)}, []
    for one in apart:
        (alone,) = one.joint.parts
        here = {own.key: key for part in joint.parts if part.kind is alone.kind for key, own in part.names.items()}
        values = {here.get(alone.names[e.key].key, ""): v for e, v in one.best.active if e in one.best.effects}
        starts.append({key: v for key, v in values.items() if key in effects and not effects[key].shape})
    starts.append({key: v for start in starts for key, v in start.items()})
    return [
        (tuple(e for key, e in effects.items() if key in start), [(effects[key], v) for key, v in start.items()])
        for start in starts
        if start
    ]


def _shown(alone: Callable[[Record], Weighed], record: Record) -> list[str]:
    return [effect.name for effect in alone(record).best.effects]


def _with_states(result: Weighed, records: Sequence[Record]) -> Weighed:
    """The verdict that says in which state of the car records are taken to be whose files do not say, where it counts.

    Args:
        result: of the records in that state.
        records: as their files are.
    """
    if not any(effect.beside for effect in result.best.effects):
        return result
    limits = tuple(
        Message(
            'no remark in {file} says where the rod was; "{state}" is taken, by what it shows: write it as a remark, '
            "or what is true",
            file=record.source,
            state=remark,
        )
        for record, part in zip(records, result.joint.parts, strict=True)
        for remark in part.record.remarks[len(record.remarks) :]
    )
    return replace(result, judgement=replace(result.judgement, limits=(*result.judgement.limits, *limits)))


def calibrate_logged(
    records: Sequence[Record], wheelbase: float, progress: Progress = silent, accepted: Collection[str] = ()
) -> PathDiagnosis:
    """Diagnose logged runs of a vehicle by a kind of data that is judged on runs left out.

    Args:
        records: records of runs.
        wheelbase: distance of the axles, mm.
        progress: function that is called with a few words on each step.
        accepted: names of formulas that the user has accepted as effects of this vehicle.

    Raises:
        FileError: see `record.join` and `units.refuse_wrong_units`.
    """
    record, logged = join(records), LoggedCar(wheelbase, frozenset(accepted))
    refuse_wrong_units(record, logged)
    model = record.kind.model
    assert model is not None
    return replace(diagnose_logged(record, lambda part: model(part, logged), progress), accepted=logged.accepted)
