"""Settings for the spacings of a course: sentences, a sheet, CSV, and a page to print on A4 that loads nothing."""

import csv
import io
from collections.abc import Iterator, Sequence
from math import degrees

from markupsafe import Markup

from cadgen.car.draws.drawn_spacing import DrawnSpacing
from cadgen.design.schema import Design
from cadgen.figures import Cell, Emphasis, Facts, Figure, Figures, Sheet
from cadgen.messages import Message, clauses, language, shown

_SAME = 1e-6  # mm
# Figures of a printed card with the formats of their numbers.
_FORMS = {
    "spacing": "g",
    "disc_middle": ".2f",
    "base_radius": ".3f",
    "wheel_radius": ".2f",
    "ratio": "g",
    "start_x": ".1f",
    "start_y": ".1f",
    "start_heading": ".2f",
    "error": ".1f",
    "room": ".1f",
}
_STYLE = """
@page { size: A4; margin: 12mm; }
body { font: 10pt/1.35 sans-serif; margin: 0; color: #000; background: #fff; }
@media screen { body { margin: 1.5em auto; max-width: 60em; padding: 0 1.5em; } }
h1 { font-size: 14pt; margin: 0 0 2mm; }
p { margin: 0 0 1mm; }
table { border-collapse: collapse; width: 100%; margin: 3mm 0; font-variant-numeric: tabular-nums; }
thead { display: table-header-group; }
tr { break-inside: avoid; }
th, td { border-bottom: 0.2mm solid #999; padding: 0.4mm 2mm; text-align: right; }
th { border-bottom: 0.5mm solid #000; vertical-align: bottom; }
td:first-child { font-weight: bold; }
tr:nth-child(5n) td { border-bottom-color: #000; }
tr.not td { text-decoration: line-through; }
tr.not td:last-child { text-decoration: none; font-weight: bold; text-align: left; }
"""


def figures(design: Design, drawn: DrawnSpacing) -> Figures:
    """Setting of one spacing, as it is shown.

    Args:
        design: design of the cam.
        drawn: setting with its error.
    """
    cam, setting, (x, y, heading) = design.cam, drawn.setting, drawn.start
    end, room = drawn.end_with_play, drawn.room
    return Figures(
        Figure("spacing", Message("posts apart"), drawn.spacing, "mm"),
        Figure("disc_middle", Message("disc"), round(sum(cam.faces_mm) / 2 + setting.disc, 4), "mm"),
        Figure("disc_moved", Message("disc moved"), round(setting.disc, 4), "mm"),
        Figure("base_radius", Message("head"), round(cam.base_radius_mm + setting.head, 4), "mm"),
        Figure("head_moved", Message("head moved"), round(setting.head, 4), "mm"),
        Figure("wheel_radius", Message("wheel radius"), round(setting.radius, 4), "mm"),
        Figure("ratio", Message("ratio"), round(setting.ratio, 6)),
        Figure("start_x", Message("start x"), _plain(x, 3), "mm"),
        Figure("start_y", Message("start y"), _plain(y, 3), "mm"),
        Figure("start_heading", Message("heading"), _plain(degrees(heading), 4), "°"),
        Figure("error", Message("error"), round(drawn.error, 2), "mm"),
        Figure("end_error", Message("error at the end"), round(drawn.end, 2), "mm"),
        Figure("end_with_play", Message("error at the end, with play"), None if end is None else round(end, 1), "mm"),
        Figure("room", Message("room"), None if room is None else round(room, 2), "mm"),
    )


def _plain(value: float, digits: int) -> float:
    return round(value, digits) + 0.0  # no minus before a 0


def rows(design: Design, drawn: Sequence[DrawnSpacing]) -> list[Facts]:
    """The setting of each spacing, in the units of the keys."""
    return [Facts(**figures(design, each).facts(), kept=not each.failed, fault=fault(each)) for each in drawn]


def fault(each: DrawnSpacing) -> str:
    """Reason why a spacing is not kept; empty where it is."""
    return "; ".join(f"{check.name}: {check.place}" for check in each.failed)


def csv_text(rows: Sequence[Facts]) -> str:
    """Rows of settings as CSV."""
    table = [row.json() for row in rows]
    text = io.StringIO()
    writer = csv.DictWriter(text, list(table[0]), lineterminator="\n")
    writer.writeheader()
    words = {True: "yes", False: "no"}
    writer.writerows(
        {key: words[value] if isinstance(value, bool) else value for key, value in row.items()} for row in table
    )
    return text.getvalue()


def sheet(design: Design, drawn: Sequence[DrawnSpacing]) -> Sheet:
    """The card as a sheet, without columns of what cannot be set or is not known; a spacing not kept is marked."""
    given, left_out = design.settings, set()
    if given is not None and given.head_from_mm == given.head_to_mm:
        left_out.add("base_radius")
    if given is not None and len(given.ratios) < 2:
        left_out.add("ratio")
    if all(each.room is None for each in drawn):
        left_out.add("room")
    codes = [code for code in _FORMS if code not in left_out]
    cells = []
    for each in drawn:
        shown, state = figures(design, each), Emphasis.BAD if each.failed else Emphasis.PLAIN
        values = {code: shown[code].value for code in codes}
        cells.append(
            tuple(
                Cell("" if value is None else format(value, _FORMS[code]), value, state=state)
                for code, value in values.items()
            )
        )
    heads = []
    for figure in (figures(design, drawn[0])[code] for code in codes):
        heads.append(clauses(figure.name, figure.unit) if figure.unit else figure.name)
    return Sheet("settings", "", tuple(heads), tuple(cells), words=0)


def legend(design: Design, drawn: Sequence[DrawnSpacing], stated: float) -> list[str]:
    """Meaning of the columns of the card, a sentence each.

    Args:
        design: design of the cam.
        drawn: settings in the order of their spacings.
        stated: spacing that the cam is made for, mm.
    """
    point, heads = planned_point(design), {str(head).partition(",")[0] for head in sheet(design, drawn).heads}
    lines = {
        "disc": Message("disc: from the fork axis to the middle of the disc, along its shaft"),
        "head": Message("head: base radius, from the camshaft to the fork axis, set at the micrometer head"),
        "wheel radius": Message("wheel radius: of the drive wheel as it rolls under load"),
        "ratio": Message("ratio: turns of the drive wheel for one turn of the cam"),
        "start x": Message("start x, y: where {point} stands at the start, in the frame of the course", point=point),
        "heading": Message("heading: direction of travel at the start, counterclockwise from the x axis"),
        "error": Message(
            "error: the most that {point} leaves the path, which is scaled from posts {stated:g} mm apart",
            point=point,
            stated=stated,
        ),
        "room": Message("room: the least distance from all that stands on the course, beyond the margin"),
    }
    return [line for head, line in lines.items() if head in heads]


def planned_point(design: Design) -> Message:
    """Name of the point of the car whose start and errors are shown."""
    car, offset = design.car, design.path.offset_mm
    a1, a2 = car.drive_wheel_offset_mm, car.idle_wheel_offset_mm
    names = {
        (a1 + a2) / 2: Message("the middle between the rear wheels"),
        0.0: Message("the drive wheel"),
        a1 + a2: Message("the idle wheel"),
    }
    for place, name in names.items():
        if abs(place - offset) < _SAME:
            return name
    return Message("the point of the rear axle {offset:g} mm to the right of the drive wheel", offset=offset)


def sentences(drawn: Sequence[DrawnSpacing], band: tuple[float, float] | None, laps: int | None = None) -> list[str]:
    """The settings in words, the most important first.

    Args:
        drawn: settings in the order of their spacings.
        band: least and greatest return error, rad; None where it is not known.
        laps: laps of a run on a closed path; None of an open one.
    """
    worst, wrong = max(drawn, key=lambda each: each.error), [each for each in drawn if each.failed]
    reach = Message("posts {least:g} to {greatest:g} mm apart", least=drawn[0].spacing, greatest=drawn[-1].spacing)
    off = Message(
        "the car leaves the scaled path by at most {error:.1f} mm, with posts {spacing:g} mm apart, {along:.0f} mm "
        "along",
        error=worst.error,
        spacing=worst.spacing,
        along=worst.error_at,
    )
    if laps is not None:
        off = Message("in {laps} laps {off}", laps=laps, off=off) if laps > 1 else Message("in a lap {off}", off=off)
    lines: list[str] = [
        Message("one cam serves {reach}, {count} spacings: {off}", reach=reach, count=len(drawn), off=off)
    ]
    if wrong:
        fault = Message(
            "the course is not kept at {lost} of {count} spacings, {reach}",
            lost=len(wrong),
            count=len(drawn),
            reach=reach,
        )
        lines = [fault, *_faults(drawn), off]
    room = [(each.room, each.spacing) for each in drawn if each.room is not None]
    if room:
        least, spacing = min(room)
        lines.append(
            Message(
                "the least room beyond what must be kept is {room:.1f} mm, with posts {spacing:g} mm apart",
                room=least,
                spacing=spacing,
            )
        )
    ends = [(each.end_with_play, each.spacing) for each in drawn if each.end_with_play is not None]
    if ends and band is not None:
        most, spacing = max(ends)
        end = Message("the run ends at most {most:.0f} mm off the path's end", most=most)
        if laps is not None:
            end = Message("the car is on the last lap at most {most:.0f} mm off the path", most=most)
        lines.append(
            Message(
                "with play from {low:.3f} to {high:.3f} degrees {end}, with posts {spacing:g} mm apart",
                low=degrees(band[0]),
                high=degrees(band[1]),
                end=end,
                spacing=spacing,
            )
        )
    return lines


def _faults(drawn: Sequence[DrawnSpacing]) -> Iterator[Message]:
    """A sentence for each row of spacings at which the same limit is not kept."""
    row: list[DrawnSpacing] = []
    for each, after in zip(drawn, (*drawn[1:], None), strict=True):
        if not each.failed:
            continue
        row.append(each)
        if after is None or not after.failed or after.failed[0].name != each.failed[0].name:
            fault = max((other.failed[0] for other in row), key=lambda check: abs(check.value - check.limit))
            where = Message("posts {least:g} mm apart", least=row[0].spacing)
            if len(row) > 1:
                where = Message("posts {least:g} to {greatest:g} mm apart", least=row[0].spacing, greatest=each.spacing)
            yield Message(
                "{where}: {name} {value:.1f} {unit} where {limit:g} is the limit ({place})",
                where=where,
                name=fault.name,
                value=fault.value,
                unit=fault.unit,
                limit=fault.limit,
                place=fault.place,
            )
            row = []


def printed_card(title: str, lines: Sequence[str], card: Sheet, faults: Sequence[str], legend: Sequence[str]) -> str:
    """Text of the page, in the language that is shown.

    Args:
        title: heading of the page.
        lines: sentences above the table.
        card: settings.
        faults: why a spacing cannot be used, by row; empty where it can.
        legend: sentences below the table.
    """
    wrong = any(faults)
    heads = Markup("").join(Markup("<th>{}</th>").format(shown(head)) for head in card.heads) + Markup(
        "<th></th>" * wrong
    )
    body = []
    for row, fault in zip(card.cells, faults, strict=True):
        cells = Markup("").join(Markup("<td>{}</td>").format(shown(cell.text)) for cell in row)
        if fault:
            text = shown(Message("not kept: {fault}", fault=fault))
            body.append(Markup('<tr class="not">{}<td>{}</td></tr>').format(cells, text))
        else:
            body.append(Markup("<tr>{}</tr>").format(cells + Markup("<td></td>" * wrong)))
    return Markup(
        '<!DOCTYPE html>\n<html lang="{language}">\n<head>\n<meta charset="utf-8">\n'
        "<title>{title}</title>\n<style>{style}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
        "{lines}<table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>\n"
        "{legend}</body>\n</html>\n"
    ).format(
        language=language(),
        title=shown(title),
        style=Markup(_STYLE),
        lines=_paragraphs(lines),
        heads=heads,
        body=Markup("\n").join(body),
        legend=_paragraphs(legend),
    )


def _paragraphs(lines: Sequence[str]) -> Markup:
    texts = [shown(Message("{sentence}.", sentence=line)) for line in lines]
    return Markup("").join(Markup("<p>{}</p>\n").format(text[:1].upper() + text[1:]) for text in texts)
