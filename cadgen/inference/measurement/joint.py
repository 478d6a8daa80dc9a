"""All records of a car as one: shared parameters, one evidence; each record with its own datum, noise and discrepancy.

An effect that two kinds of data show under two names (play is *backlash* in a track, *return error* in a train) is
one effect of the joint catalogue. What is measured further up the chain motor, cam angle, lift, steering, track changes
what is measured further down, wherever the model there passes the effect's stage (`Model.behind`). Noise, datum and
discrepancy of the records are independent, so their products and their logarithms of likelihood add up. One record is
the case of one part, whose effects are its own.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag

from cadgen.arrays import Array
from cadgen.deviations.effect import READING, Active, Effect, key_of
from cadgen.inference.measurement.evidence import Evidence, Noise, Spectrum
from cadgen.inference.measurement.model import Cache, Model, slopes
from cadgen.inference.measurement.record import Kind, Record

Names = dict[str, Effect]


@dataclass(frozen=True)
class Merged:
    """Catalogue that several records share.

    Attributes:
        catalogue, shapes, datum: the effects, each once.
        cameras: errors of instruments that are looked for where these do not explain the records.
        kinds: by their keys, the kind of data whose catalogue each stands in.
        names: for each record, by the keys of the effects that act in it, what the effect is there.
    """

    catalogue: tuple[Effect, ...]
    shapes: tuple[Effect, ...]
    datum: tuple[Effect, ...]
    cameras: tuple[Effect, ...]
    kinds: dict[str, Kind]
    names: tuple[Names, ...]

    @classmethod
    def of(cls, records: Sequence[tuple[Kind, Model]]) -> "Merged":
        """Merge the catalogues of records, of one kind each.

        An effect leads under the name that it has in the kind nearest to the car's run. One that another kind calls by
        the same name, but that is another thing there, has its kind written behind it.
        """
        groups: dict[tuple[str, ...], dict[int, Effect]] = {}
        for number, (kind, model) in enumerate(records):
            for effect in model.catalogue:
                groups.setdefault(_identity(kind, model, effect), {})[number] = effect
        several = len(records) > 1
        taken: dict[str, int] = {}
        leaders: list[tuple[Effect, int, dict[int, Effect]]] = []
        nearness = [kind.nearness for kind, _ in records]
        for members in sorted(groups.values(), key=lambda m: min(nearness[n] for n in m)):
            number = min(members, key=lambda n: nearness[n])
            effect = members[number]
            if several and taken.setdefault(effect.name, number) != number:
                effect = replace(effect, name=f"{effect.name} ({records[number][0]})", called=effect.name)
            leaders.append((effect, number, members))
        leading = {effect.key for effect, _, _ in leaders}
        leaders = [(e, n, m) for e, n, m in leaders if all(part.key in leading for part in e.parts)]
        names: tuple[Names, ...] = tuple({} for _ in records)
        for effect, number, members in leaders:
            for other, (_, model) in enumerate(records):
                if other in members:
                    names[other][effect.key] = members[other]
                elif effect.stage in model.behind and not (effect.instrument or effect.shape):
                    names[other][effect.key] = members[number]
        shapes = [
            (replace(e, name=f"{e.name} ({kind})") if several else e, n, e)
            for n, (kind, model) in enumerate(records)
            for e in model.shapes
        ]
        datum = [(e, n, e) for n, (_, m) in enumerate(records) for e in m.datum]
        cameras = [(e, n, e) for n, (_, m) in enumerate(records) for e in m.cameras]
        for effect, number, own in (*shapes, *datum, *cameras):
            names[number][effect.key] = own
            for other, (_, model) in enumerate(records):
                if own.form_of and other != number and model.rolled is not None:
                    names[other][effect.key] = model.rolled.shown(effect)
        every = [(e, n) for e, n, _ in (*leaders, *shapes, *datum, *cameras)]
        return cls(
            catalogue=tuple(e for e, _, _ in leaders),
            shapes=tuple(e for e, _, _ in shapes),
            datum=tuple(e for e, _, _ in datum),
            cameras=tuple(e for e, _, _ in cameras),
            kinds={e.key: records[n][0] for e, n in every},
            names=names,
        )


def _identity(kind: Kind, model: Model, effect: Effect) -> tuple[str, ...]:
    """Identity of an effect across kinds of data: its quantity, and its number among many of one sort."""
    if effect.parts:
        return (*(name for part in effect.parts for name in _identity(kind, model, part)), effect.variant)
    alike = [e for e in model.catalogue if e.deviation == effect.deviation and not e.member]
    if effect.deviation is None or (not effect.member and len(alike) > 1):
        return (kind.code, effect.key)
    return (effect.deviation.name, effect.key if effect.member else "")


Build = Callable[[Record], Model]

_KEPT = 256  # results of a part: most differences leave most parts alone, and fits come by the same values again
_NEAR = 0.1  # of a difference step: from values so near by, slopes are the same
_ROUNDING = 1e-9  # of a column's square, that keeps what is left of a datum's twin from being nothing


@dataclass(frozen=True)
class Part:
    """Record as it is judged.

    Attributes:
        record: measured data of one kind.
        build: makes the forward model of a record, or of some of its runs.
        model: of the record.
        noise: of the record.
        evidence: of the model with that noise.
        names: by the keys of joint effects that act in this record, the effect that they are here.
    """

    record: Record
    build: Build
    model: Model
    noise: Noise
    evidence: Evidence
    names: dict[str, Effect] = field(default_factory=dict)
    _known: Cache[bytes, Array] = field(default_factory=lambda: Cache(_KEPT), repr=False)
    _leant: Cache[tuple[str, ...], tuple[Array, Array]] = field(default_factory=lambda: Cache(_KEPT), repr=False)
    _misfits: Cache[bytes, Array] = field(default_factory=lambda: Cache(_KEPT), init=False, repr=False)
    _squares: Cache[tuple[bytes, int], float] = field(default_factory=lambda: Cache(_KEPT), init=False, repr=False)

    @property
    def kind(self) -> Kind:
        """Kind of measured data."""
        return self.record.kind

    def own(self, active: Active) -> list[tuple[Effect, Array]]:
        """Joint effects as those of this record, without what does nothing here."""
        return [(self.names[e.key], v) for e, v in active if e.key in self.names]

    def residual(self, active: Active) -> Array:
        """Measured less expected with joint effects active, shape (n,), internal units; remembered."""
        mine = self.own(active)
        return self._known.of(key_of(mine), lambda: self.model.residual(mine))

    def misfit(self, active: Active) -> Array:
        """-2 log L of joint effects with values, for every spectrum; remembered."""

        def weighed() -> Array:
            return self.evidence.misfit(self.evidence.whiten(self.residual(active)))

        return self._misfits.of(key_of(self.own(active)), weighed)

    def square(self, active: Active, spectrum: int) -> float:
        """r'C^-1 r of the residual, by one spectrum; remembered."""

        def weighed() -> float:
            white = self.evidence.whiten(self.residual(active))[:, None]
            return float(self.evidence.products(white, white, [spectrum])[0, 0, 0])

        return self._squares.of((key_of(self.own(active)), spectrum), weighed)

    def slopes(self, effects: tuple[Effect, ...], active: Active, residual: Array) -> Array:
        """`models.base.slopes` of effects of this record; those near by, as a fit comes by, are used again.

        Args:
            effects: which, under the names that they have here.
            active: effects with values, likewise.
            residual: residual with these, in the record's unit, shape (n,).
        """
        steps = np.concatenate([np.empty(0), *(e.steps for e, _ in active)])
        values = np.concatenate([np.empty(0), *(v for _, v in active)])
        where = tuple(e.key for e, _ in active)
        known = {e.key: self._leant[e.key, *where] for e in effects if (e.key, *where) in self._leant}
        near = {key: lean for key, (at, lean) in known.items() if (np.abs(values - at) <= _NEAR * steps).all()}
        anew = tuple(e for e in effects if e.key not in near)
        columns = slopes(self.model, anew, active, residual)
        ends = np.cumsum([0, *(len(e.parameters) for e in anew)])
        for effect, (a, b) in zip(anew, pairwise(ends), strict=True):
            near[effect.key] = columns[:, a:b]
            self._leant[effect.key, *where] = values, columns[:, a:b]
        return np.hstack([np.empty((len(columns), 0)), *(near[e.key] for e in effects)])


@dataclass(frozen=True, kw_only=True)
class Joint:
    """Records of one car, judged by one evidence.

    Attributes:
        parts: the records.
        core: effects that combine freely.
        members: effects of families, which enter a subset one at a time.
        shapes: forms without a name, each of one part.
        datum: effects that are always fitted.
        cameras: errors of instruments that are not among these.
        kinds: by the keys of effects, the kind of data whose catalogue they stand in.
    """

    parts: tuple[Part, ...]
    core: tuple[Effect, ...]
    members: tuple[Effect, ...]
    shapes: tuple[Effect, ...]
    datum: tuple[Effect, ...]
    cameras: tuple[Effect, ...]
    kinds: dict[str, Kind]

    @classmethod
    def of(cls, parts: Sequence[Part]) -> "Joint":
        """Records joined: their catalogues merged."""
        merged = Merged.of([(part.kind, part.model) for part in parts])
        return cls(
            parts=tuple(replace(part, names=names) for part, names in zip(parts, merged.names, strict=True)),
            core=tuple(e for e in merged.catalogue if not e.member),
            members=tuple(e for e in merged.catalogue if e.member),
            shapes=merged.shapes,
            datum=merged.datum,
            cameras=merged.cameras,
            kinds=merged.kinds,
        )

    @property
    def with_cameras(self) -> "Joint":
        """The records with the errors of their instruments among the effects that combine freely."""
        return replace(self, core=(*self.core, *self.cameras), cameras=())

    @cached_property
    def spans(self) -> tuple[slice, ...]:
        """Rows of each part among all."""
        ends = np.cumsum([0, *(len(part.model.rows.run) for part in self.parts)]).tolist()
        return tuple(slice(a, b) for a, b in pairwise(ends))

    @property
    def rows(self) -> int:
        """How many numbers were measured."""
        return int(self.spans[-1].stop)

    @property
    def grid(self) -> tuple[Spectrum, ...]:
        """Spectra of the form error; all parts choose the same."""
        return self.parts[0].evidence.grid

    @property
    def within(self) -> NDArray[np.bool_]:
        """Which of them keep the stated floor."""
        return self.parts[0].evidence.within

    @cached_property
    def beside(self) -> Array:
        """Size of the discrepancy in each of them, as a multiple of what it may be."""
        return np.array([spectrum.beside for spectrum in self.grid])

    @cached_property
    def constant(self) -> Array:
        """log det C for each spectrum."""
        return np.asarray(np.sum([part.evidence.constant for part in self.parts], axis=0))

    @property
    def source(self) -> str:
        """Names of the files."""
        return ", ".join(part.record.source for part in self.parts)

    @property
    def offsets(self) -> Array:
        """Linear datum freedoms of all parts as columns, shape (n, d)."""
        return np.asarray(block_diag(*(part.model.offsets for part in self.parts)), dtype=float)

    def residual(self, active: Active) -> Array:
        """Measured less expected of all records, shape (n,), each in its own internal unit."""
        return np.concatenate([part.residual(active) for part in self.parts])

    def slopes(self, effects: tuple[Effect, ...], active: Active) -> Array:
        """How the expected values answer each parameter, shape (n, sum of parameters); see `models.base.slopes`."""
        widths = np.cumsum([0, *(len(e.parameters) for e in effects)])
        out = np.zeros((self.rows, int(widths[-1])))
        for part, span in zip(self.parts, self.spans, strict=True):
            own, columns = self._here(part, effects, widths)
            out[span, columns] = slopes(part.model, own, part.own(active))
        return out

    def own_name(self, effect: Effect) -> str:
        """Name of an effect in the kind of data whose catalogue it stands in."""
        part = next(part for part in self.parts if part.kind is self.kinds[effect.key])
        return part.names[effect.key].name

    def shape_column(self, shape: Effect, step: Array) -> Array:
        """Reading of a form without a name with parameters `step`, where it is searched for, shape (n,).

        Args:
            shape: form without a name.
            step: values of its parameters, internal units (mm, rad).
        """
        out = np.zeros(self.rows)
        for part, span in zip(self.parts, self.spans, strict=True):
            if shape.key in part.names and part.names[shape.key].stage is READING:
                rows = part.model.rows
                out[span] = part.names[shape.key].act(np.zeros(len(rows.run)), step, rows)
        return out

    def whiten(self, columns: Array) -> Array:
        """Divide each part by its noise; see `Evidence.whiten`.

        Args:
            columns: columns, shape (n, m), internal units (mm, rad).
        """
        return np.concatenate([p.evidence.whiten(columns[s]) for p, s in zip(self.parts, self.spans, strict=True)])

    def halves(self, white: Array) -> Array:
        """See `Evidence.halves`; those of all parts below each other, shape (g, q, m).

        Args:
            white: whitened columns, shape (n, m).
        """
        return np.concatenate(
            [p.evidence.halves(white[s]) for p, s in zip(self.parts, self.spans, strict=True)], axis=1
        )

    def misfit(self, active: Active) -> Array:
        """-2 log L of joint effects with values, for every spectrum."""
        return np.asarray(np.sum([part.misfit(active) for part in self.parts], axis=0), dtype=float)

    def square(self, active: Active, spectrum: int) -> float:
        """r'C^-1 r of the residual, by one spectrum."""
        return sum(part.square(active, spectrum) for part in self.parts)

    def normal(
        self, effects: tuple[Effect, ...], active: Active, among: Sequence[int] | NDArray[np.intp]
    ) -> tuple[Array, Array]:
        """Information and gradient of all numbers of some effects, for some spectra.

        Args:
            effects: which, active or not.
            active: effects with values.
            among: numbers of the spectra, shape (g,).

        Returns:
            H = J'C^-1 J, shape (g, k, k), and g = J'C^-1 r, shape (g, k); J are the slopes of the residual r.
        """
        widths = np.cumsum([0, *(len(e.parameters) for e in effects)])
        H, g = np.zeros((len(among), widths[-1], widths[-1])), np.zeros((len(among), widths[-1]))
        for part in self.parts:
            own, columns = self._here(part, effects, widths)
            if not own:
                continue
            residual = part.residual(active)
            J = -part.evidence.whiten(part.slopes(own, part.own(active), residual))
            both = np.column_stack([J, part.evidence.whiten(residual)])
            product = part.evidence.products(both, both, among)
            rounding = _ROUNDING * np.einsum("nk,nk->k", J, J)
            H[:, columns[:, None], columns] += product[:, :-1, :-1] + np.diag(rounding)
            g[:, columns] += product[:, :-1, -1]
        return H, g

    def _here(
        self, part: Part, effects: tuple[Effect, ...], widths: NDArray[np.intp]
    ) -> tuple[tuple[Effect, ...], NDArray[np.intp]]:
        """Effects that are searched for in a part, as they are there, and their columns among all.

        Those of a family are searched for in the record that shows them best; the others join in the exact fit.
        """
        here = [
            i for i, e in enumerate(effects) if e.key in part.names and (not e.member or self.kinds[e.key] is part.kind)
        ]
        columns = [np.arange(widths[i], widths[i + 1]) for i in here]
        return tuple(part.names[effects[i].key] for i in here), np.concatenate([*columns, np.empty(0, dtype=np.intp)])

    def without(self, part: Part, runs: NDArray[np.intp], spectrum: Spectrum) -> tuple["Joint", list[Part]]:
        """Records with some runs of a part left out, and each of these; noises as they are, one spectrum."""
        others = np.setdiff1d(np.arange(part.record.runs), runs)
        train, *tests = (_only(part, kept, spectrum) for kept in (others, *runs[:, None]))
        parts = [
            train
            if other.record is part.record
            else replace(other, evidence=Evidence(other.model, other.noise, (spectrum,)))
            for other in self.parts
        ]
        return replace(self, parts=tuple(parts)), tests


def _only(part: Part, runs: NDArray[np.intp], spectrum: Spectrum) -> Part:
    """Some runs of a part, by one spectrum of the form error."""
    # Of runs with fewer points than others the harmonics would be others, and what repeats could not be compared.
    record = replace(part.record.only(runs), resolved=part.model.resolved)
    model, rows = part.build(record), np.isin(part.model.rows.run, runs)
    slip = part.noise.slip * (len(runs) > 1)
    noise = Noise(part.noise.sigma[rows], part.noise.correlation, slip, len(runs))
    return Part(record, part.build, model, noise, Evidence(model, noise, (spectrum,)), part.names)
