"""Ranking of measurements by how near to its planned end each is expected to bring the run on the next cam.

What is known so far is a set of likely subsets of effects, each a normal distribution of their numbers; what no record
could have shown yet lies as cars differ, and what the records would have shown is not there. A measurement that could
be made adds its information (`linear`) to each subset and weighs the subsets anew. So a car is drawn from what is
known, its readings from the car, and a new cam is made for what would then be claimed; the spread of the ends of many
such runs is what is expected of that measurement (preposterior analysis; Raiffa and Schlaifer 1961, chapter 4, and for
normal distributions the c-optimal design of Chaloner and Verdinelli, Statistical Science 10 (1995) 273-304).

A track shows where the run ends, whatever the names: what it shows is taken out by the effects that it is traced to.
Without a track an effect is taken out if the data show it by itself. Where something without a name is left, nothing is
taken out until a kind of data has named it; it may be any one effect that acts on the records so far and stands in the
catalogue of another kind, by how well it explains what is left.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import TURN, Array
from cadgen.deviations import deviation
from cadgen.deviations.deviation import Deviation, Place
from cadgen.deviations.effect import Active
from cadgen.inference.expectation.linear import LEAST_WEIGHT, Knowledge, Linear, PriorKnowledge, WhitenedRows
from cadgen.inference.expectation.outlook import RANGE, new_form
from cadgen.inference.measurement.findings import EvidenceDiagnosis
from cadgen.inference.measurement.kinds import LIFT, PROFILE, TRACK, TRANSMISSION
from cadgen.inference.measurement.kinds.track import run_of
from cadgen.inference.measurement.nominal import Nominal
from cadgen.inference.measurement.record import Direction, Kind, Record
from cadgen.inference.measurement.verdict import MARGIN, SIGMAS, SURE
from cadgen.messages import Message

# The play at the camshaft, by hand and an inclinometer with the rod lifted.
BY_HAND = float(np.radians(0.01))
STOP = "start set to 0.5 mm and 0.05 deg"
TRACK_STEP, LIFT_STEP, PROFILE_POINTS, TRAIN_STEP = 2.0, 2.0, 360, 2.0  # degrees of cam angle; points of one run
LAST_DEG = 340.0  # of a lift: the closing blend of the cam steers no path


@dataclass(frozen=True)
class Proposal:
    """A measurement that could be made.

    Attributes:
        words: what to do.
        kind: of the data; None for the play by hand, which is a number of the design.
        runs: how many.
        record: as it would be read of the car as it is known so far; None for the play by hand.
        idle: quantities that do not act in it, as friction does not with the rod lifted.
    """

    words: str
    kind: Kind | None
    runs: int
    record: Record | None
    idle: frozenset[Deviation] = frozenset()


def proposals(nominal: Nominal, known: Active, measured: Sequence[Kind]) -> tuple[Proposal, ...]:
    """Everything that may be measured next.

    Args:
        nominal: the design.
        known: effects as a track names them, with their values so far.
        measured: kinds of data that there are already.
    """
    more = Message("more ") if TRACK in measured else ""
    out = [_track(nominal, known, count, more) for count in (2, 4, 8)]
    out.append(_track(nominal, known, 4, more, STOP))
    out += [_lift(nominal, both=True), _lift(nominal, both=False)]
    out += [_profile(nominal, quarters=False), _profile(nominal, quarters=True)]
    if nominal.ratios:
        out += [_train(nominal, lifted=True, back=True), _train(nominal, lifted=False, back=True)]
        out.append(_train(nominal, lifted=True, back=False))
        by_hand = Message(
            "the play at the camshaft, the rod lifted, by an inclinometer to and fro; set play.measured_deg"
        )
        out.append(Proposal(by_hand, None, 1, None))
    return tuple(out)


def _record(kind: Kind, columns: Mapping[str, NDArray[np.generic]], runs: int, remark: str = "") -> Record:
    rows = len(next(iter(columns.values())))
    run = np.repeat(np.arange(runs), rows)
    repeated: dict[str, NDArray[np.generic]] = {name: np.tile(values, runs) for name, values in columns.items()}
    remarks = (remark,) if remark else ()
    return Record(kind=kind, columns=repeated, run=run, remarks=remarks, source=f"a {kind.code} to be measured")


def _track(nominal: Nominal, known: Active, runs: int, more: str, remark: str = "") -> Proposal:
    motor = np.arange(0.0, 360.0, TRACK_STEP)
    place = run_of(nominal).at(known, np.radians(motor))
    columns = {"cam_angle_deg": motor, "x_mm": place.real, "y_mm": place.imag}
    words = Message("{runs} {more}runs of the track before a camera", runs=runs, more=more)
    if remark:
        words = Message("{words}, the start set against a stop, to 0.5 mm and 0.05°", words=words)
    return Proposal(words, TRACK, runs, _record(TRACK, columns, runs, remark))


def _lift(nominal: Nominal, *, both: bool, runs: int = 3) -> Proposal:
    there = np.arange(0.0, LAST_DEG + LIFT_STEP / 2, LIFT_STEP)
    angle = np.concatenate([there, there[::-1]]) if both else there
    forward = np.arange(len(angle)) < len(there)
    columns = {
        "direction": np.where(forward, Direction.FORWARD, Direction.REVERSE),
        "cam_angle_deg": angle,
        "lift_mm": nominal.follower.inner * nominal.lift.q(np.radians(angle)),
    }
    words = Message("the lift by a dial, {runs} runs, {way}", runs=runs, way=_way(both))
    return Proposal(words, LIFT, runs, _record(LIFT, columns, runs))


def _way(back: bool) -> Message:
    return Message("forward and back") if back else Message("forward only")


def _profile(nominal: Nominal, *, quarters: bool, runs: int = 4) -> Proposal:
    disc = nominal.disc
    angle = np.linspace(0.0, TURN, PROFILE_POINTS, endpoint=False) + disc.angle[0]
    radius = np.interp(angle, disc.angle, np.linalg.norm(disc.points, axis=1), period=TURN)
    turned = [angle + (TURN / 4 * run if quarters else 0.0) for run in range(runs)]
    columns: dict[str, NDArray[np.generic]] = {
        "x_mm": np.concatenate([radius * np.cos(way) for way in turned]),
        "y_mm": np.concatenate([radius * np.sin(way) for way in turned]),
    }
    run = np.repeat(np.arange(runs), PROFILE_POINTS)
    record = Record(kind=PROFILE, columns=columns, run=run, remarks=(), source="a profile to be measured")
    how = Message("turned on by a quarter from run to run") if quarters else Message("clamped as it lies")
    return Proposal(
        Message("the profile on a measuring machine, {runs} runs, the disc {how}", runs=runs, how=how),
        PROFILE,
        runs,
        record,
    )


def _train(nominal: Nominal, *, lifted: bool, back: bool, runs: int = 3) -> Proposal:
    there = np.arange(0.0, 360.0 + TRAIN_STEP / 2, TRAIN_STEP)
    cam = np.concatenate([there, there[-2::-1]]) if back else there
    columns = {"motor_angle_deg": cam * float(np.prod(nominal.ratios)), "cam_angle_deg": cam}
    rod = Message("lifted") if lifted else Message("on the disc")
    words = Message(
        "angles at both ends of the train, {runs} runs, {way}, the rod {rod}", runs=runs, way=_way(back), rod=rod
    )
    idle = frozenset({deviation.SLIDING_FRICTION} if lifted else ())
    return Proposal(words, TRANSMISSION, runs, _record(TRANSMISSION, columns, runs), idle)


def around(kind: Kind | None) -> bool:
    """Whether a part of the turn may be measured alone."""
    return kind in (LIFT, PROFILE)


DRAWS = 4000
# A number that is shown to this share of what cars differ by is known well enough to be taken out.
SEEN = 0.5
# Ends of the run that differ by this share are as good as the same.
ALIKE = 0.03
# Parts of the turn that are looked at, rad, and how far they are moved on.
PART, MOVED = TURN / 3, TURN / 12


@dataclass(frozen=True)
class EndRange:
    """Distance of the end of the run from the planned one, mm: mean, and between what it lies with 90 %."""

    mean: float
    least: float
    most: float


@dataclass(frozen=True)
class Expected:
    """Expected gain of a measurement.

    Attributes:
        words: what to do.
        kind: of the data; None for the play by hand.
        runs: how many.
        end: of the run on a new cam made for what is then claimed.
        names_sure: chance that the likeliest names are then sure.
        part: of the turn that says most, begin and end, rad, and the end of the run if that alone is measured; None
            where it is not looked at.
    """

    words: str
    kind: Kind | None
    runs: int
    end: EndRange
    names_sure: float
    part: tuple[float, float, EndRange] | None = None


@dataclass(frozen=True)
class Next:
    """The measurement to take next.

    Attributes:
        now: end of the run on a new cam made for what is found so far.
        names_sure: chance of the likeliest names so far; 1 before any measurement.
        rivals: what else may be true, as names.
        ranked: what could be measured, the best first.
    """

    now: EndRange
    names_sure: float
    rivals: tuple[tuple[str, ...], ...]
    ranked: tuple[Expected, ...]

    def shrinks(self, expected: Expected) -> float:
        """Share of the mean distance of the end that a measurement takes away."""
        return 1 - expected.end.mean / self.now.mean


def next_measurement(
    nominal: Nominal, records: Sequence[Record], diagnoses: Sequence[EvidenceDiagnosis], prior: PriorKnowledge
) -> Next:
    """Rank what could be measured.

    Args:
        nominal: the design.
        records: measured so far, one of each kind; none is right.
        diagnoses: what they show, in the same order.
        prior: what is known without them.
    """
    measured = [record.kind for record in records]
    first = {p.kind: p.record for p in proposals(nominal, [], measured) if p.kind and p.record}
    others = {kind: record for kind, record in first.items() if kind not in measured}
    linear = Linear.of(nominal, records, diagnoses, others, prior.spread)
    state = _State(linear, prior)
    rows = state.proposed(proposals(nominal, linear.own(TRACK, state.about), measured))
    now, names_sure = state.expected(np.zeros((linear.size, linear.size)), measured)
    ranked = []
    for proposal, known in rows:
        kinds = [*measured, *([proposal.kind] if proposal.kind else [])]
        information = state.by_hand if known is None else known.information()
        end, sure = state.expected(information, kinds)
        ranked.append((Expected(proposal.words, proposal.kind, proposal.runs, end, sure), known, proposal))
    # Of measurements that bring as much, the one with the fewest runs.
    ranked.sort(key=lambda entry: (round(np.log(entry[0].end.mean) / ALIKE), entry[0].runs))
    out = [entry[0] for entry in ranked]
    best, known, proposal = ranked[0]
    if known is not None and proposal.kind and around(proposal.kind):
        out[0] = state.with_part(best, known, [*measured, proposal.kind])
    rivals = sorted(linear.likely, key=lambda entry: -entry[0])[1:]
    names = tuple(tuple(e.name for e, _ in active) for weight, active in rivals if weight >= LEAST_WEIGHT)
    return Next(now, names_sure, names, tuple(out))


class _State:
    """Knowledge so far, and as expected after a measurement.

    Attributes:
        about: effects with the values about which everything is taken in proportion.
        by_hand: information of a play that was measured by hand.
    """

    def __init__(self, linear: Linear, prior: PriorKnowledge) -> None:
        self._linear, self._assumed, size = linear, prior.assumed, linear.size
        self._effects = list(zip(linear.effects, linear.spans, strict=True))
        known = Knowledge(linear, prior)
        self.about, self._subsets = known.about, known.subsets
        self._ways = linear.ways(self.about)
        # A subset is one, whatever the floor.
        self._keys = list(dict.fromkeys(subset.key for subset in self._subsets))
        self._of = np.array([self._keys.index(subset.key) for subset in self._subsets])
        self._nested = np.array([[one <= other for one in self._keys] for other in self._keys])
        self._draw()
        self.by_hand = np.zeros((size, size))
        for effect, span in self._effects:
            if effect.deviation == deviation.RETURN_ERROR and not effect.member:
                self.by_hand[span, span] = (linear.scale[span] / BY_HAND) ** 2

    def _draw(self) -> None:
        """Cars by what is known, and the chance of their readings."""
        rng = np.random.default_rng(0)
        weights = np.array([s.weight for s in self._subsets])
        which = np.repeat(np.arange(len(weights)), rng.multinomial(DRAWS, weights / weights.sum()))
        normal = rng.standard_normal((DRAWS, self._linear.size))
        self._cars = np.zeros((DRAWS, self._linear.size))
        for number, subset in enumerate(self._subsets):
            mine = which == number
            root = np.linalg.cholesky(np.linalg.inv(subset.precision))
            self._cars[np.ix_(mine, subset.at)] = subset.mean + normal[mine][:, subset.at] @ root.T
        self._noise = rng.standard_normal((DRAWS, self._linear.size))
        self._disc = new_form(self._linear.track, DRAWS, rng)

    def proposed(self, some: Sequence[Proposal]) -> list[tuple[Proposal, WhitenedRows | None]]:
        """Each proposal with the rows of its record."""
        linear, out = self._linear, []
        for proposal in some:
            rows = None
            if proposal.kind is not None and proposal.record is not None:
                model = linear.nominal.model(proposal.record)
                noise = linear.noise_of(proposal.kind, model)
                rows = linear.rows(proposal.kind, model, noise, self.about, proposal.idle)
            out.append((proposal, rows))
        return out

    def expected(self, information: Array, kinds: Sequence[Kind]) -> tuple[EndRange, float]:
        """End of the run on a new cam with some information more, and the chance that names are then sure."""
        values, vectors = np.linalg.eigh(information)
        root = vectors * np.sqrt(np.maximum(values, 0.0))
        shown = self._cars @ information + self._noise @ root.T
        score, found, after = [], [], []
        for subset in self._subsets:
            own = information[np.ix_(subset.at, subset.at)]
            covariance: Array = np.asarray(np.linalg.inv(subset.precision + own), dtype=float)
            off = shown[:, subset.at] - own @ subset.mean
            moved = off @ covariance
            likelihood = shown[:, subset.at] @ subset.mean + np.sum(off * moved, axis=1) / 2
            constant = np.linalg.slogdet(subset.precision)[1] + np.linalg.slogdet(covariance)[1]
            score.append(np.log(subset.weight) + likelihood - subset.mean @ own @ subset.mean / 2 + constant / 2)
            found.append(subset.mean + moved)
            after.append(covariance)
        weight = np.exp(np.array(score) - np.max(score, axis=0))
        weight /= weight.sum(axis=0)
        by_key = np.stack([weight[self._of == number].sum(axis=0) for number in range(len(self._keys))])
        # The smallest subset nested in the likeliest one and as good as likely: see `verdict`.
        logs = np.log(np.maximum(by_key, 1e-300))
        close = self._nested[np.argmax(logs, axis=0)].T & (logs > np.max(logs, axis=0) - MARGIN / 2)
        sizes = np.array([len(key) for key in self._keys])[:, None]
        best = np.argmin(np.where(close, sizes - logs / 1e3, np.inf), axis=0)
        error = np.empty(DRAWS, dtype=complex)
        for number in range(len(self._keys)):
            if (mine := best == number).any():
                floors = np.flatnonzero(self._of == number)
                shares = weight[floors][:, mine] / by_key[number, mine]
                values = np.einsum("fc,fck->ck", shares, np.array([found[floor][mine] for floor in floors]))
                likeliest = max(floors, key=lambda floor: self._subsets[floor].weight)
                error[mine] = self._error(likeliest, mine, by_key[:, mine], values, after[likeliest], kinds)
        size = np.abs(error + self._disc)
        least, most = np.percentile(size, RANGE)
        sure = float(np.mean(by_key.max(axis=0) >= SURE))
        return EndRange(float(size.mean()), float(least), float(most)), sure

    def _error(
        self,
        number: np.intp,
        mine: NDArray[np.bool_],
        weight: Array,
        found: Array,
        covariance: Array,
        kinds: Sequence[Kind],
    ) -> NDArray[np.complex128]:
        """Error at the end of the run on a cam made for what is claimed of the likeliest subset."""
        subset, cars, linear = self._subsets[number], self._cars[mine], self._linear
        where = np.full(linear.size, -1)
        where[subset.at] = np.arange(len(subset.at))
        sigma = np.sqrt(np.diag(covariance))
        named = subset.cause is None or bool(linear.at_home(subset.cause, kinds))
        # A track that was measured without tracing it to names does not trace it by more of the same.
        untraced = subset.cause is not None and TRACK in linear.kinds[: linear.measured] and not named
        aliased = TRACK in kinds and not untraced
        error = cars @ self._ways
        for effect, span in self._effects:
            at, way = where[span], self._ways[span]
            if at[0] < 0 or not way.any():
                continue
            has = np.array([effect.key in key or effect.key not in subset.key for key in self._keys])
            play = effect.deviation == deviation.RETURN_ERROR  # a number of the design, too
            place = Place.CAR if play else linear.place(effect, kinds)
            # By a track a cam is made for a whole subset, for what is not sure by name, too.
            claimed = (np.sum(weight[has], axis=0) >= SURE) | (aliased and place in (Place.CAR, Place.PART))
            if effect.key in subset.key:
                claimed &= named or aliased
            if not aliased:
                small = np.abs(found[:, at]).max(axis=1) / SIGMAS
                claimed &= np.all(sigma[at] < np.maximum(SEEN, small)[:, None], axis=1)
            if place == Place.PART:
                error -= np.where(claimed, cars[:, span] @ way, 0.0)
            elif place != Place.NOTED or aliased:
                error -= np.where(claimed, found[:, at] @ way, 0.0)
            if play:
                error -= np.where(claimed, 0.0, (self._assumed / linear.scale[span]) @ way)
        return error

    def with_part(self, best: Expected, rows: WhitenedRows, kinds: Sequence[Kind]) -> Expected:
        """The best measurement with the part of the turn that says most."""
        parts = []
        for begin in np.arange(0.0, TURN, MOVED).tolist():
            end, _ = self.expected(rows.information(rows.within(begin, PART)), kinds)
            parts.append((begin, begin + PART, end))
        return replace(best, part=min(parts, key=lambda part: part[2].mean))
