"""Kinds of records of one gear: lines of a gear measuring machine, pitch of its teeth, its span or size over balls.

A comment line `gear: driven of stage 2` says which gear of the train it is.
"""

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from cadgen.errors import FileError
from cadgen.inference.gearing.record_kinds import judged_together
from cadgen.inference.measurement.record import Column, Kind, Record, said

_MOST_UM = 5000.0
LEFT, RIGHT = "left", "right"


def _kind(code: str, title: str, columns: tuple[Column, ...]) -> Kind:
    """Kind of a few rounded readings, many of which are alike."""
    return judged_together(code, title, columns, least_rows=1, counts=10_000)


_TOOTH = Column(name="tooth", lower=1, upper=1000)
_FLANK = Column(name="flank", words=(LEFT, RIGHT))


def _um(name: str) -> Column:
    return Column(name=name, lower=-_MOST_UM, upper=_MOST_UM)


PITCH = _kind("tooth pitch", "Single pitch of each tooth", (_TOOTH, _FLANK, _um("pitch_um")))
INDEX = _kind("tooth index", "Cumulative pitch of each tooth", (_TOOTH, _FLANK, _um("index_um")))
PROFILE_LINES = _kind(
    "profile lines",
    "Profile lines of teeth",
    (_TOOTH, _FLANK, Column(name="roll_length_mm", lower=0, upper=1000), _um("profile_um")),
)
PROFILE_DIAMETERS = _kind(
    "profile lines by diameter",
    "Profile lines of teeth by diameter",
    (_TOOTH, _FLANK, Column(name="diameter_mm", lower=0, upper=20_000), _um("profile_um")),
)
HELIX_LINES = _kind(
    "helix lines",
    "Helix lines of teeth",
    (_TOOTH, _FLANK, Column(name="face_mm", lower=-2000, upper=2000), _um("helix_um")),
)
SPANS = _kind(
    "spans",
    "Spans of a gear",
    (Column(name="teeth_spanned", lower=2, upper=500), Column(name="span_mm", lower=0.1, upper=5000)),
)
BALLS = _kind(
    "sizes over balls",
    "Sizes of a gear over balls",
    (Column(name="ball_diameter_mm", lower=0.01, upper=200), Column(name="over_balls_mm", lower=0.1, upper=5000)),
)
GEAR_KINDS = (PITCH, INDEX, PROFILE_LINES, PROFILE_DIAMETERS, HELIX_LINES, SPANS, BALLS)
_WHICH = r"gear: *(driver|driven) of stage (\d+)"


def gear_place(records: Sequence[Record], teeth: Sequence[tuple[int, int]]) -> tuple[int, bool]:
    """Stage of the measured gear, from 0, and whether it is the driver.

    Args:
        records: records of one gear.
        teeth: teeth of driver and driven wheel of each stage.

    Raises:
        FileError: no remark says which, or one that the train has not, or several that differ.
    """
    stated = {match for record in records if (match := said(record, re.compile(_WHICH, re.IGNORECASE).pattern))}
    name = records[0].source
    if len(stated) > 1:
        raise FileError(
            "{file}: the files say different gears of the train; give those of one gear at a time", file=name
        )
    if stated:
        ((which, number),) = stated
        stage = int(number) - 1
        if not 0 <= stage < len(teeth):
            raise FileError(
                "{file} says a gear of stage {stage}, and the design has {stages}; correct the line",
                file=name,
                stage=stage + 1,
                stages=len(teeth),
            )
        return stage, which == "driver"
    counts = {int(record["tooth"].max()) for record in records if record.kind in (PITCH, INDEX)}
    places = [(n, k == 0) for n, pair in enumerate(teeth) for k, z in enumerate(pair) if z in counts]
    if len(places) != 1:
        raise FileError(
            "{file} does not say which gear it is of: add a line # gear: driven of stage 1, or driver", file=name
        )
    return places[0]


def by_roll(record: Record, base_diameter: float) -> Record:
    """Profile lines by the length of roll L = √(d² − d_b²)/2, where they were read by the diameter d.

    Args:
        record: profile lines.
        base_diameter: of the gear, mm.

    Raises:
        FileError: a point lies within the base circle, where no involute is.
    """
    if record.kind is PROFILE_LINES:
        return record
    diameters = record["diameter_mm"]
    if diameters.min() < base_diameter:
        raise FileError(
            "{file} has a point at the diameter {least:g} mm, within the base circle of {base:.4f} mm, where no "
            "involute is: give diameters, not radii, of the gear that the line says",
            file=record.source,
            least=float(diameters.min()),
            base=base_diameter,
        )
    columns = {name: values for name, values in record.columns.items() if name != "diameter_mm"}
    columns["roll_length_mm"] = np.sqrt(diameters**2 - base_diameter**2) / 2
    return replace(record, kind=PROFILE_LINES, columns=columns)


def refuse_parts(record: Record, column: str) -> None:
    """Refuse numbers of teeth that are not whole.

    Args:
        record: record with the column.
        column: name of a column of numbers of teeth.

    Raises:
        FileError: a number is not whole.
    """
    parts = record[column][record[column] % 1 != 0]
    if parts.size:
        raise FileError(
            "{file} has {column} {number:g}: give whole numbers of teeth",
            file=record.source,
            column=column,
            number=float(parts[0]),
        )


_LONGER = 1.25  # by which lines may pass the end of the gear


def to_tip(record: Record, side: int) -> Record:
    """Profile lines whose places grow to the tip: those of a ring by the length of roll below 0.

    Args:
        record: profile lines by the length of roll.
        side: -1 for an internal gear.
    """
    return replace(record, columns={**record.columns, "roll_length_mm": side * record["roll_length_mm"]})


def refuse_lines(record: Record, column: str, reach: float, most: float, found: bool) -> None:
    """Refuse lines that are longer than the gear, or of which nothing can be evaluated.

    Args:
        record: profile or helix lines.
        column: name of the column of their places.
        reach: greatest place of them, or their length, mm.
        most: greatest that the gear has, mm.
        found: whether a line has three points in the range of evaluation.

    Raises:
        FileError: it is so.
    """
    if reach > _LONGER * most:
        raise FileError(
            "{file}: {column} reaches {reach:.3f} mm, and the gear has {most:.3f} mm: give millimetres, no degrees or "
            "inches, of the gear that the line says",
            file=record.source,
            column=column,
            reach=reach,
            most=most,
        )
    if not found:
        raise FileError(
            "{file} has no line of three points within the range of evaluation: measure whole lines, with {column} in "
            "millimetres",
            file=record.source,
            column=column,
        )


def refuse_teeth(record: Record, teeth: int) -> None:
    """Refuse teeth that the gear has not, or pitches that are not those of all its teeth.

    Args:
        record: record of one of the kinds.
        teeth: teeth of the gear.

    Raises:
        FileError: a number is greater or no whole number, or a flank lacks teeth.
    """
    if "tooth" not in record.columns:
        return
    refuse_parts(record, "tooth")
    if (most := int(record["tooth"].max())) > teeth:
        raise FileError(
            "{file} has tooth {tooth}, and the gear has {teeth}: correct the line that says which gear it is",
            file=record.source,
            tooth=most,
            teeth=teeth,
        )
    if record.kind not in (PITCH, INDEX):
        return
    flanks = record.columns["flank"]
    for flank in sorted(set(flanks.tolist())):
        for run in range(record.runs):
            mine = (flanks == flank) & (record.run == run)
            if mine.any() and sorted(record["tooth"][mine].astype(int)) != list(range(1, teeth + 1)):
                raise FileError(
                    "{file} has not every tooth once on the {flank} flanks of run {run}: give all {teeth}",
                    file=record.source,
                    flank=str(flank),
                    run=run + 1,
                    teeth=teeth,
                )
