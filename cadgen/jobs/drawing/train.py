"""Sheets of the parts of a computed train, and of the plate that holds the axes."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from cadgen.jobs.drawing.title import Folder, title_of
from cadgen.jobs.gears.facts import parts_facts
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.output.drawing.data import gear_rows
from cadgen.output.drawing.gear import GearPart, gear_drawing
from cadgen.output.drawing.plate import Axis, plate_drawing
from cadgen.output.drawing.sheet import Drawing

_ENDINGS = (".step", ".stl")


def sheets_of(plan: GearsPlan, folder: Folder) -> Iterator[tuple[str, Drawing]]:
    """Stem of the files that a sheet stands for, and the sheet: of each part, then of the plate."""
    layout, design = plan.layout, plan.design
    every = parts_facts(layout)
    for part, facts in zip(layout.parts, every, strict=True):
        stem = f"{plan.stem}_{part.name}"
        data = tuple(
            gear_rows(
                gear,
                _mate(every, gear["stage"], part.shaft),
                layout.train.stages[gear["stage"] - 1],
                drives=gear["stage"] == part.shaft,
            )
            for gear in facts["gears"]
        )
        name = " and ".join(str(gear.noun).removeprefix("the ") for gear in part.gears)
        sheet = GearPart(
            part=part,
            data=data,
            files=folder.files(stem, design.content_hash, _ENDINGS),
            notes=(f"Shaft {part.shaft} of the train, counted from the drive.",),
        )
        yield stem, gear_drawing(sheet, title_of(design, f"{part.name}: {name}", "", stem, folder))
    axes = tuple(
        Axis(
            shaft=part.shaft,
            x=part.axis.real,
            y=part.axis.imag,
            bore=part.blank.bore_diameter,
            reach=max(gear.tip_diameter for gear in part.gears) / 2,
        )
        for part in layout.parts
    )
    stem = f"{plan.stem}_plate"
    title = title_of(design, "plate for the axes", "", stem, folder)
    pair = replace(title, quantity=2 * title.quantity)
    yield stem, plate_drawing(axes, tuple(_plate_notes(plan)), pair)


def _plate_notes(plan: GearsPlan) -> Iterator[str]:
    yield "Seen along the axes from the output's end. Broken circles: tips of the gears, for room."
    yield "Two to a machine, before and behind the gears. Thickness as the bearings need."
    yield "Holes as large as the shafts: open them for your bearings. Where no bore is given there is no hole."
    yield "Places of the axes: hold the distances below, not the general tolerance."
    for number, stage in enumerate(plan.layout.train.stages, 1):
        deviation = stage.facts().get("f_a_um")
        if deviation is not None:
            apart = f"{stage.centre_distance:g} ± {deviation / 1e3:.4g} mm"
            span = f"bearings {stage.bearing_span:g} mm apart"
            yield f"Axes {number} and {number + 1}: {apart}, {span}, as the play is reckoned."


def _mate(every: list[dict[str, Any]], stage: int, shaft: int) -> str:
    """The gear in mesh with one on a shaft, in words."""
    other = next(part for part in every if part["shaft"] == (stage + 1 if shaft == stage else stage))
    gear = next(gear for gear in other["gears"] if gear["stage"] == stage)
    teeth = f"z = {gear['teeth']}, " if "teeth" in gear else ""
    return f"{teeth}{other['name']}"
