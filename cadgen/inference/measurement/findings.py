"""Findings in a record: effects with their numbers, the candidates compared, and the residual.

Two methods choose effects (`record.Method`), and each has a diagnosis of its own: by the evidence of residuals there is
noise, and a form error that repeats; by runs left out there are path errors alone.
"""

from collections.abc import Collection
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array
from cadgen.deviations.deviation import Deviation
from cadgen.deviations.effect import UNITS, Active, Effect
from cadgen.inference.measurement.evidence import Spectrum
from cadgen.inference.measurement.record import Kind
from cadgen.inference.measurement.verdict import SIGMAS, Judgement, Verdict, within_error


@dataclass(frozen=True, slots=True)
class Value:
    """Fitted number in the unit its name ends in, with its standard deviation."""

    name: str
    value: float
    sigma: float
    unit: str

    @classmethod
    def of(cls, number: tuple[str, str], value: float, sigma: float) -> "Value":
        """Value of a number in its own unit.

        Args:
            number: name and unit.
            value, sigma: value and standard deviation, internal units (mm, rad, 1).
        """
        name, unit = number
        return cls(name, float(value / UNITS[unit]), float(sigma / UNITS[unit]), unit)


@dataclass(frozen=True, slots=True)
class Finding:
    """Effect with its numbers, its twins, and its `indices` (see `Effect.indices`).

    `sigmas` is how many standard deviations from nothing its numbers must be to be sure: see `verdict.sigmas_of`.
    """

    effect: str
    values: tuple[Value, ...]
    twins: tuple[str, ...]
    at_bound: tuple[str, ...]
    indices: tuple[tuple[str, float], ...] = ()
    sigmas: float = SIGMAS

    @classmethod
    def of(
        cls, effect: Effect, values: Array, sigma: Array, at_bound: Collection[str], sigmas: float = SIGMAS
    ) -> "Finding":
        """Finding of an effect.

        Args:
            effect: effect.
            values, sigma: fitted values and their standard deviations, internal units (mm, rad), shape (k,).
            at_bound: names of numbers that stand on a bound, those of other effects among them.
            sigmas: number of standard deviations, as of the class.
        """
        numbers = tuple(
            Value.of((p.name, p.unit), v, s) for p, v, s in zip(effect.parameters, values, sigma, strict=True)
        )
        stuck = tuple(p.name for p in effect.parameters if p.name in at_bound)
        return cls(effect.name, numbers, effect.twins, stuck, effect.indices, sigmas)

    @property
    def within_error(self) -> bool:
        """Whether one of its numbers may be nothing: see `verdict.within_error`."""
        units, values, sigma = zip(*((v.unit, v.value, v.sigma) for v in self.values), strict=True)
        return within_error(units, values, sigma, self.sigmas)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A row of the table of candidates: a subset with its numbers.

    Attributes:
        effects: their names.
        score: less is better. By evidence, how much worse than the best by the information criterion; by runs left
            out, the path error there, mm.
        findings: the numbers.
    """

    effects: tuple[str, ...]
    score: float
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True, slots=True)
class PathCandidate(Candidate):
    """Candidate by runs left out, with the path error of each run when left out, mm."""

    held_out: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class HeldOut:
    """Root mean squares on runs left out, in the record's unit.

    Attributes:
        rms: of each run in turn, the effects fitted to the others.
        repeating: the same, less what the other runs say of the form error.
    """

    rms: float
    repeating: float


@dataclass(frozen=True, slots=True)
class Residual:
    """Root mean squares in the record's unit (um, deg or mm).

    Attributes:
        before: of the bare design, datum fitted.
        after: with the effects found.
        noise: what does not repeat between runs.
        left_out: on runs left out; None with one run.
    """

    before: float
    after: float
    noise: float
    left_out: HeldOut | None


@dataclass(frozen=True, slots=True)
class PerRun:
    """Root mean squares of each run in the record's unit, shape (runs,), as in `Residual`."""

    before: Array
    after: Array
    held_out: Array | None


@dataclass(frozen=True, slots=True)
class PathError:
    """Mean over runs of the distance from the path, start registered, rms along the run, mm: of the bare design, with
    the effects found, and of each run in turn with the effects fitted to the others."""

    before: float
    after: float
    held_out: float


@dataclass(frozen=True, slots=True)
class PathErrors:
    """Path errors of each run, shape (runs,), and `as_logged` before the start pose is registered."""

    before: Array
    after: Array
    held_out: Array
    as_logged: Array


@dataclass(frozen=True, kw_only=True)
class Diagnosis:
    """Diagnosis of one record, by any method.

    Attributes:
        source, kind, unit: of the record; residuals are in the unit.
        judgement: the class of verdict, what is claimed, and one sentence.
        findings: the effects of the best subset, shapes among them.
        candidates: the best subsets, best first.
        place: of each measured row, shape (n,), internal units.
        run: of each row, shape (n,).
        before, after: residual of each row, datum fitted, internal units.
        active: the effects found with their values, internal units.
        measured: coordinate of each row of a track, mm; None for what is no track.
        backwards: whether each row was read on the way back, shape (n,); None where the record does not say.
    """

    source: str
    kind: Kind
    unit: str
    judgement: Judgement
    findings: tuple[Finding, ...]
    candidates: tuple[Candidate, ...]
    place: Array
    run: Array
    before: Array
    after: Array
    active: Active
    measured: Array | None = None
    backwards: NDArray[np.bool_] | None = None

    @property
    def verdict(self) -> Verdict:
        """The class of verdict."""
        return self.judgement.verdict

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return int(self.run.max()) + 1


@dataclass(frozen=True)
class Unnamed:
    """Repeating error without a name in a track: coefficients of the disc's form error, and of what floor and car do.

    Attributes:
        weight: its chance among those that may be.
        values: likeliest coefficients, shape (q + k,), as of `model.repeating`.
        covariance: of these, shape (q + k, q + k).
        answer: how they answer the values of the subset, as all must make up what was measured, shape (q + k, p).
        end: the end of this track by each, x + iy, shape (q + k,), mm.
        orders: how many of them are the form error's, q.
        spectrum: spectrum of what repeats, the disc's form error among it, with which it is so.
    """

    weight: float
    values: Array
    covariance: Array
    answer: Array
    end: NDArray[np.complex128]
    orders: int
    spectrum: Spectrum


@dataclass(frozen=True, slots=True)
class Likely:
    """A subset that may be true, by all records together.

    Attributes:
        weight: its chance among those that may be.
        effects: kind of data that each stands in and its name there, the effect, and its values in internal units.
        covariance: of all values in order.
        shown: for each effect, the kinds of data given in which it acts, by their codes.
        unnamed: what may repeat beside the effects at the end of a track; empty without a track.
    """

    weight: float
    effects: tuple[tuple[tuple[str, str], Effect, Array], ...]
    covariance: Array
    shown: tuple[frozenset[str], ...]
    unnamed: tuple[Unnamed, ...] = ()


@dataclass(frozen=True, kw_only=True)
class EvidenceDiagnosis(Diagnosis):
    """Diagnosis of a record by the evidence of its residuals.

    Attributes:
        datum: fitted freedoms, never claimed; those of each run in order.
        leads: effects found that stand in this kind's own catalogue, and are claimed by this record.
        held: what was known of these beforehand, in words; empty if nothing was.
        discrepancy: of the record's kind (see `models.base.Discrepancy`), never claimed; None where none is sure.
        residual: before and after.
        per_run: the same for each run.
        correlation: of the noise between neighbours.
        unnamed: how much there could be of the quantities of `Kind.absences` that a sound verdict does not name, by
            quantity, fitted beside what it does.
        score: of the subset reported, by the criterion; of all records judged together.
        apart: whether the record was judged apart from others of the car: they contradict each other, or no effect
            explains it and some explain the others.
        likely: subsets that may be true by all records together, the same for each of them.
        play_known: whether the play found has in it what was measured of it apart.
    """

    datum: tuple[Finding, ...]
    residual: Residual
    per_run: PerRun
    correlation: float
    leads: tuple[str, ...] = ()
    held: str = ""
    discrepancy: Finding | None = None
    unnamed: dict[Deviation, Finding] = field(default_factory=dict)
    play_known: bool = False
    score: float = 0.0
    apart: bool = False
    likely: tuple[Likely, ...] = ()


@dataclass(frozen=True)
class FormulaProposal:
    """Formula that predicts what repeats in logged runs, proposed and not claimed.

    Attributes:
        finding: formula with its number.
        before, after: path error on paths left out, mean over runs, mm, without it and with it.
        chance: that the best of all formulas gains as much in residuals that have nothing to do with them.
        rivals: names of formulas that gain nearly as much.
    """

    finding: Finding
    before: float
    after: float
    chance: float
    rivals: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class PathDiagnosis(Diagnosis):
    """Diagnosis of logged runs by path errors on runs left out.

    Attributes:
        residual: path errors before and after.
        per_run: the same for each run.
        candidates: every subset, best first.
        proposal: formula for what repeats; None where none predicts it.
        accepted: names of formulas that the user has accepted as effects of this vehicle.
    """

    residual: PathError
    per_run: PathErrors
    candidates: tuple[PathCandidate, ...]
    proposal: FormulaProposal | None = None
    accepted: frozenset[str] = frozenset()
