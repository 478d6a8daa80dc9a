"""The catalogues of several records as one: what they share by its physical quantity, and what acts further down."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from cadgen.deviations.effect import Effect
from cadgen.inference.measurement.models.base import Model
from cadgen.inference.measurement.record import Kind

Names = dict[str, Effect]


@dataclass(frozen=True)
class Merged:
    """One catalogue for several records.

    Attributes:
        catalogue, shapes, datum: the effects, each once.
        kinds: by their keys, the kind of data whose catalogue each stands in.
        names: for each record, by the keys of the effects that act in it, what the effect is there.
    """

    catalogue: tuple[Effect, ...]
    shapes: tuple[Effect, ...]
    datum: tuple[Effect, ...]
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
        for members in sorted(groups.values(), key=lambda m: min(_nearness(records, n) for n in m)):
            number = min(members, key=lambda n: _nearness(records, n))
            effect = members[number]
            if several and taken.setdefault(effect.name, number) != number:
                effect = replace(effect, name=f"{effect.name} ({records[number][0]})")
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
        shapes = [(_of_kind(e, kind, several), n, e) for n, (kind, m) in enumerate(records) for e in m.shapes]
        datum = [(e, n, e) for n, (_, m) in enumerate(records) for e in m.datum]
        for effect, number, own in (*shapes, *datum):
            names[number][effect.key] = own
            for other, (_, model) in enumerate(records):
                if own.form_of and other != number and model.rolled is not None:
                    names[other][effect.key] = model.rolled.shown(effect)
        every = [(e, n) for e, n, _ in (*leaders, *shapes, *datum)]
        return cls(
            catalogue=tuple(e for e, _, _ in leaders),
            shapes=tuple(e for e, _, _ in shapes),
            datum=tuple(e for e, _, _ in datum),
            kinds={e.key: records[n][0] for e, n in every},
            names=names,
        )


def _nearness(records: Sequence[tuple[Kind, Model]], number: int) -> int:
    return records[number][0].nearness


def _of_kind(effect: Effect, kind: Kind, several: bool) -> Effect:
    return replace(effect, name=f"{effect.name} ({kind})") if several else effect


def _identity(kind: Kind, model: Model, effect: Effect) -> tuple[str, ...]:
    """Identity of an effect across kinds of data: its quantity, and its number among many of one sort."""
    if effect.parts:
        return (*(name for part in effect.parts for name in _identity(kind, model, part)), effect.variant)
    alike = [e for e in model.catalogue if e.deviation == effect.deviation and not e.numerous]
    if effect.deviation is None or (not effect.numerous and len(alike) > 1):
        return (kind.code, effect.key)
    return (effect.deviation.name, effect.key if effect.numerous else "")
