"""Settings for the spacings of a course as sentences and as a table."""

import csv
import io
from collections.abc import Iterator, Sequence
from math import degrees
from typing import Any

from cadgen.car.draws.drawn_spacing import DrawnSpacing
from cadgen.design.schema import Design
from cadgen.output.report.card import Column

_SAME = 1e-6  # mm
_COLUMNS = (
    Column("spacing_mm", "posts apart", "mm", "g"),
    Column("disc_middle_mm", "disc", "mm", ".2f"),
    Column("base_radius_mm", "head", "mm", ".3f"),
    Column("wheel_radius_mm", "wheel radius", "mm", ".2f"),
    Column("ratio", "ratio", "", "g"),
    Column("start_x_mm", "start x", "mm", ".1f"),
    Column("start_y_mm", "start y", "mm", ".1f"),
    Column("start_heading_deg", "heading", "°", ".2f"),
    Column("error_mm", "error", "mm", ".1f"),
    Column("room_mm", "room", "mm", ".1f"),
)


def sentences(drawn: Sequence[DrawnSpacing], band: tuple[float, float] | None, laps: int | None = None) -> list[str]:
    """The settings in words, the most important first.

    Args:
        drawn: settings in the order of their spacings.
        band: least and greatest return error, rad; None where it is not known.
        laps: laps of a run on a closed path; None of an open one.
    """
    worst, wrong = max(drawn, key=lambda each: each.error), [each for each in drawn if each.failed]
    reach = f"posts {drawn[0].spacing:g} to {drawn[-1].spacing:g} mm apart"
    off = "" if laps is None else f"in {laps} laps " if laps > 1 else "in a lap "
    off += (
        f"the car leaves the scaled path by at most {worst.error:.1f} mm, with posts {worst.spacing:g} mm apart, "
        f"{worst.error_at:.0f} mm along"
    )
    lines = [f"one cam serves {reach}, {len(drawn)} spacings: {off}"]
    if wrong:
        lines = [
            f"the course is not kept at {len(wrong)} of {len(drawn)} spacings, {reach}",
            *_faults(drawn),
            off,
        ]
    room = [(each.room, each.spacing) for each in drawn if each.room is not None]
    if room:
        lines.append(
            "the least room beyond what must be kept is {:.1f} mm, with posts {:g} mm apart".format(*min(room))
        )
    ends = [(each.end_with_play, each.spacing) for each in drawn if each.end_with_play is not None]
    if ends and band is not None:
        low, high = (degrees(end) for end in band)
        most, spacing = max(ends)
        off = f"the run ends at most {most:.0f} mm off the path's end"
        if laps is not None:
            off = f"the car is on the last lap at most {most:.0f} mm off the path"
        lines.append(f"with play from {low:.3f} to {high:.3f} degrees {off}, with posts {spacing:g} mm apart")
    return lines


def _faults(drawn: Sequence[DrawnSpacing]) -> Iterator[str]:
    """A sentence for each row of spacings at which the same limit is not kept."""
    row: list[DrawnSpacing] = []
    for each, after in zip(drawn, (*drawn[1:], None), strict=True):
        if not each.failed:
            continue
        row.append(each)
        if after is None or not after.failed or after.failed[0].name != each.failed[0].name:
            fault = max((other.failed[0] for other in row), key=lambda check: abs(check.value - check.limit))
            where = f"{row[0].spacing:g}" if len(row) == 1 else f"{row[0].spacing:g} to {each.spacing:g}"
            yield (
                f"posts {where} mm apart: {fault.name} {fault.value:.1f} {fault.unit} where {fault.limit:g} is the "
                f"limit ({fault.place})"
            )
            row = []


def planned_point(design: Design) -> str:
    """Name of the point of the car whose start and errors are shown."""
    car, offset = design.car, design.path.offset_mm
    a1, a2 = car.drive_wheel_offset_mm, car.idle_wheel_offset_mm
    names = {(a1 + a2) / 2: "the middle between the rear wheels", 0.0: "the drive wheel", a1 + a2: "the idle wheel"}
    for place, name in names.items():
        if abs(place - offset) < _SAME:
            return name
    return f"the point of the rear axle {offset:g} mm to the right of the drive wheel"


def rows(design: Design, drawn: Sequence[DrawnSpacing]) -> list[dict[str, Any]]:
    """The setting of each spacing in the units of its names."""
    cam = design.cam
    middle = sum(cam.faces_mm) / 2
    return [
        {
            "spacing_mm": each.spacing,
            "disc_middle_mm": round(middle + each.setting.disc, 4),
            "disc_moved_mm": round(each.setting.disc, 4),
            "base_radius_mm": round(cam.base_radius_mm + each.setting.head, 4),
            "head_moved_mm": round(each.setting.head, 4),
            "wheel_radius_mm": round(each.setting.radius, 4),
            "ratio": round(each.setting.ratio, 6),
            "start_x_mm": _plain(each.start[0], 3),
            "start_y_mm": _plain(each.start[1], 3),
            "start_heading_deg": _plain(degrees(each.start[2]), 4),
            "error_mm": round(each.error, 2),
            "end_error_mm": round(each.end, 2),
            "end_with_play_mm": None if each.end_with_play is None else round(each.end_with_play, 1),
            "room_mm": None if each.room is None else round(each.room, 2),
            "kept": not each.failed,
            "fault": "; ".join(f"{check.name}: {check.place}" for check in each.failed),
        }
        for each in drawn
    ]


def _plain(value: float, digits: int) -> float:
    return round(value, digits) + 0.0  # no minus before a 0


def columns(design: Design, drawn: Sequence[DrawnSpacing]) -> tuple[Column, ...]:
    """Columns of a printed card, without what cannot be set or is not known."""
    given, left_out = design.settings, set()
    if given is not None and given.head_from_mm == given.head_to_mm:
        left_out.add("base_radius_mm")
    if given is not None and len(given.ratios) < 2:
        left_out.add("ratio")
    if all(each.room is None for each in drawn):
        left_out.add("room_mm")
    return tuple(column for column in _COLUMNS if column.key not in left_out)


def legend(design: Design, shown: Sequence[Column], stated: float) -> list[str]:
    """Meaning of the columns of a printed card, a sentence each.

    Args:
        design: design of the cam.
        shown: the columns.
        stated: spacing that the cam is made for, mm.
    """
    point, keys = planned_point(design), {column.key for column in shown}
    lines = {
        "disc_middle_mm": "disc: from the fork axis to the middle of the disc, along its shaft",
        "base_radius_mm": "head: base radius, from the camshaft to the fork axis, set at the micrometer head",
        "wheel_radius_mm": "wheel radius: of the drive wheel as it rolls under load",
        "ratio": "ratio: turns of the drive wheel for one turn of the cam",
        "start_x_mm": f"start x, y: where {point} stands at the start, in the frame of the course",
        "start_heading_deg": "heading: direction of travel at the start, counterclockwise from the x axis",
        "error_mm": f"error: the most that {point} leaves the path, which is scaled from posts {stated:g} mm apart",
        "room_mm": "room: the least distance from all that stands on the course, beyond the margin",
    }
    return [line for key, line in lines.items() if key in keys]


def csv_text(table: Sequence[dict[str, Any]]) -> str:
    """A table of settings as CSV."""
    text = io.StringIO()
    writer = csv.DictWriter(text, list(table[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows({key: _cell(value) for key, value in row.items()} for row in table)
    return text.getvalue()


def _cell(value: Any) -> Any:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "" if value is None else value
