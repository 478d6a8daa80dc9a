"""Columns of a file matched to those of a kind of measured data."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from cadgen.errors import FileError, brief
from cadgen.inference.measurement.record import Kind, Method
from cadgen.inference.records.units import IDLE, TIMES, ColumnName, heading
from cadgen.messages import Message, joined

_CAM, _MOTOR = "camangle", "motorangle"


@dataclass(frozen=True, kw_only=True)
class Reading:
    """How columns are to be understood, beside their names.

    Attributes:
        columns: columns of the kind of data -> names that they have in the file, as `x_mm` -> `East [m]`.
        ratio: turns of the motor for one of the cam, where angles of the motor may stand for those of the cam.
        by_order: whether points count in the order of driving, so that a time beside them tells nothing more.
    """

    columns: Mapping[str, str] = field(default_factory=dict)
    ratio: float | None = None
    by_order: bool = False


AS_NAMED = Reading()


@dataclass(frozen=True)
class ColumnPlace:
    """Place of a column in a file, and the factor of its numbers to the unit of the kind."""

    index: int
    factor: float


@dataclass(frozen=True)
class Match:
    """Kind of data of a file.

    Attributes:
        kind: the kind.
        places: place of each of its columns by name; the key may lack.
        notes: what was understood besides columns with the very names of the kind.
    """

    kind: Kind
    places: Mapping[str, ColumnPlace]
    notes: tuple[Message, ...] = ()


def match_columns(names: Sequence[str], name: str, known: Sequence[Kind], reading: Reading) -> Match:
    """Match the columns of a file to those of a kind of data.

    Of the kinds whose columns are all there, that with most columns is taken.

    Args:
        names: names of the columns in the file.
        name: of the file, for messages.
        known: kinds that it may be of.
        reading: how columns are to be understood.

    Raises:
        FileError: a name stands twice, no kind has these columns, or positions by time where cam angles are needed.
    """
    if len(set(names)) < len(names):
        twice = next(c for c in names if names.count(c) > 1)
        raise FileError("{name}: column {twice} stands twice; keep one", name=name, twice=brief(twice))
    if exact := next((k for k in known if set(names) == set(k.header) and not reading.columns), None):
        return Match(exact, {column: ColumnPlace(names.index(column), 1.0) for column in exact.header})
    headings = [heading(column) for column in names]
    pinned = _pinned(names, name, known, reading)
    found: list[tuple[int, Match]] = []
    for kind in known:
        places = {column: place for column in kind.header if (place := _place(column, names, headings, pinned, name))}
        places |= _beside(kind, names, headings)
        scaled = _by_motor(kind, places, headings, reading)
        needed = {column.name for column in kind.columns} | ({kind.key} if kind.method is Method.ZONE_MEANS else set())
        if needed <= (places | scaled).keys():
            found.append((len(needed), Match(kind, places | scaled, _notes(names, kind, places, scaled, reading))))
    if not found:
        raise _no_kind(names, name, known)
    _, match = max(found, key=lambda each: each[0])
    _refuse_other(names, name, headings, match, known, reading)
    return match


def _refuse_other(
    names: Sequence[str],
    name: str,
    headings: Sequence[ColumnName],
    match: Match,
    known: Sequence[Kind],
    reading: Reading,
) -> None:
    """Refuse positions alone beside a column that may say where the cam stood: a short track is no outline."""
    columns = {column.name for column in match.kind.columns}
    if reading.by_order or columns != set(match.kind.readings) or columns <= reading.columns.keys():
        return
    used = {place.index for place in match.places.values()}
    others = [n for n, has in enumerate(headings) if n not in used and has.quantity not in IDLE]
    if not others:
        return
    if all(headings[n].quantity in TIMES for n in others):
        raise FileError(
            "{name}: positions by time are no data that can be judged: add cam_angle_deg beside them, or "
            "motor_angle_deg; cadgen adjust takes them in the order of driving",
            name=name,
        )
    if any(headings[n].quantity == _MOTOR for n in others):
        raise FileError(
            "{name} has angles of the motor, and the design has no train that tells those of the cam: add [train], "
            "or a column cam_angle_deg",
            name=name,
        )
    if len(others) > 1:
        raise _no_kind(names, name, known)
    raise FileError(
        "{name}: {column} is not understood; if it is the cam angle, add --columns cam_angle_deg={column}, and if "
        "this is an outline, take the column out",
        name=name,
        column=brief(names[others[0]]),
    )


def _pinned(names: Sequence[str], name: str, known: Sequence[Kind], reading: Reading) -> dict[str, ColumnPlace]:
    """Places of the columns that the user names."""
    columns = {column for kind in known for column in kind.header}
    pinned = {}
    for column, given in reading.columns.items():
        if column not in columns:
            raise FileError(
                "--columns names {column}, and no kind of data has such a column: write one of {columns}",
                column=brief(column),
                columns=joined(sorted(columns), ", "),
            )
        if given not in names:
            raise FileError(
                "{name} has no column {given}: write one of {names}",
                name=name,
                given=brief(given),
                names=brief(joined(names, ", ")),
            )
        unit = column.rpartition("_")[2]
        pinned[column] = ColumnPlace(names.index(given), heading(given).factor(unit) or 1.0)
    return pinned


def _place(
    column: str, names: Sequence[str], headings: Sequence[ColumnName], pinned: Mapping[str, ColumnPlace], name: str
) -> ColumnPlace | None:
    """Place of a column of a kind; None if the file has none that can be it."""
    if column in pinned:
        return pinned[column]
    taken = {place.index for place in pinned.values()}
    if column in names and names.index(column) not in taken:
        return ColumnPlace(names.index(column), 1.0)
    asked = heading(column)
    places = [
        ColumnPlace(n, factor)
        for n, has in enumerate(headings)
        if n not in taken and has.quantity == asked.quantity and (factor := _factor(has, asked)) is not None
    ]
    if len(places) > 1:
        raise FileError(
            "{name}: {first} and {second} may both be {column}; say which with --columns {column}=NAME",
            name=name,
            first=brief(names[places[0].index]),
            second=brief(names[places[1].index]),
            column=column,
        )
    return places[0] if places else None


def _beside(kind: Kind, names: Sequence[str], headings: Sequence[ColumnName]) -> dict[str, ColumnPlace]:
    """Places of columns that need not be there, where one column alone can be each."""
    found = {}
    for column in kind.beside:
        asked = heading(column.name)
        each = [n for n, has in enumerate(headings) if has.quantity == asked.quantity and _factor(has, asked)]
        if len(each) == 1:
            found[column.name] = ColumnPlace(each[0], _factor(headings[each[0]], asked) or 1.0)
    return found


def _factor(has: ColumnName, asked: ColumnName) -> float | None:
    """Factor of a column's numbers to those asked for; None where they are of another quantity."""
    return has.factor(asked.unit) if asked.unit else None if has.unit else 1.0


def _by_motor(
    kind: Kind, places: Mapping[str, ColumnPlace], headings: Sequence[ColumnName], reading: Reading
) -> dict[str, ColumnPlace]:
    """Cam angles from those of the motor, where a file has no other."""
    lacking = [column for column in kind.header if heading(column).quantity == _CAM and column not in places]
    motor = [n for n, has in enumerate(headings) if has.quantity == _MOTOR and has.factor("deg") is not None]
    # Data that compare both angles have each from its own column.
    if any(heading(column).quantity == _MOTOR for column in kind.header):
        return {}
    if not lacking or len(motor) != 1 or reading.ratio is None or kind.method is Method.ZONE_MEANS:
        return {}
    return {lacking[0]: ColumnPlace(motor[0], (headings[motor[0]].factor("deg") or 1.0) / reading.ratio)}


def _notes(
    names: Sequence[str],
    kind: Kind,
    places: Mapping[str, ColumnPlace],
    scaled: Mapping[str, ColumnPlace],
    reading: Reading,
) -> tuple[Message, ...]:
    """Columns that have other names or units, that lack, or that are not used."""
    notes = []
    for column, place in places.items():
        called = names[place.index]
        if called == column:
            continue
        if not heading(called).unit and (unit := heading(column).unit):
            notes.append(Message('{column} is "{called}", taken as {unit}', column=column, called=called, unit=unit))
        elif place.factor != 1.0:
            notes.append(
                Message('{column} is "{called}" times {factor:g}', column=column, called=called, factor=place.factor)
            )
        else:
            notes.append(Message('{column} is "{called}"', column=column, called=called))
    for column, place in scaled.items():
        notes.append(
            Message(
                '{column} is "{called}" divided by the ratio of the train, {ratio:g}',
                column=column,
                called=names[place.index],
                ratio=reading.ratio,
            )
        )
    used = {place.index for place in (*places.values(), *scaled.values())}
    if idle := [called for n, called in enumerate(names) if n not in used]:
        notes.append(Message("{columns} not used", columns=joined([brief(called) for called in idle], ", ")))
    return tuple(notes)


def _no_kind(names: Sequence[str], name: str, known: Sequence[Kind]) -> FileError:
    """Error that no kind has the columns of a file."""
    has = [heading(column) for column in names]

    def there(column: str, *, unit: bool = True) -> bool:
        asked = heading(column)
        return any(h.quantity == asked.quantity and (not unit or _factor(h, asked) is not None) for h in has)

    lacking = {
        kind: [c for c in kind.header if not there(c) and (c != kind.key or kind.method is Method.ZONE_MEANS)]
        for kind in known
    }
    some = [kind for kind in known if lacking[kind]] or known
    near = max(some, key=lambda kind: (sum(there(c.name, unit=False) for c in kind.columns), -len(kind.columns)))
    lacks = lacking[near] or [near.header[-1]]
    return FileError(
        "{name}: the columns {names} are no kind of measured data; nearest is {kind}, which lacks {columns}; say "
        "which it is with --columns {column}=NAME",
        name=name,
        names=brief(", ".join(names)),
        kind=near.code,
        columns=brief(", ".join(lacks)),
        column=lacks[0],
    )
