"""Tables of the page for the workshop: inspection, parts, calibration."""

from math import degrees
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.gears.layout import TrainLayout
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.gears.facts import parts_facts
from cadgen.viewer.page.content.plan import PagePlan
from cadgen.viewer.page.document import Cell, Section, Table, Text, Words, number
from cadgen.viewer.page.names import State
from cadgen.viewer.page.sentences import generated
from cadgen.viewer.page.words import named, say

if TYPE_CHECKING:
    from cadgen.jobs.calibration.plan import Calibration
    from cadgen.output.report.text import Block

_STEP_DEG = 10
_LEAD = 4  # paragraphs of a calibration above its tables: expectation, warnings and verdict come first


def inspection_section(plan: PagePlan) -> Section:
    """Figures to measure the cam and the gears by, with room for what is measured."""
    tables = [_cam_sizes(plan.cam), _lift_table(plan.cam)]
    if plan.gears is not None and (gears := _gear_sizes(parts_facts(plan.gears.layout))) is not None:
        tables.append(gears)
    return Section("inspection", say("Inspection sheet"), (say("inspection-lead"),), tuple(tables))


def _cam_sizes(plan: CamPlan) -> Table:
    inner, outer = plan.design.cam.faces_mm
    blank = plan.made_blank
    radius = np.hypot(*plan.curve.outline(0.1).points.T)
    rows: list[tuple[Text, float]] = [
        (say("greatest radius of the disc"), float(radius.max())),
        (say("least radius of the disc"), float(radius.min())),
        (say("thickness"), outer - inner),
        (say("bore diameter"), blank.bore_diameter),
    ]
    if plan.design.blank.keyway is not None:
        rows += [
            (say("keyway width"), plan.design.blank.keyway.width_mm),
            (say("keyway depth"), plan.design.blank.keyway.depth_mm),
        ]
    if blank.edge_break:
        rows.append((say("broken edges, leg of the chamfer"), blank.edge_break))
    return Table(
        "cam-sizes",
        say("Cam"),
        (say("size"), say("nominal"), say("measured")),
        tuple((Cell(name), number(value, "mm"), Cell("")) for name, value in rows),
    )


def _lift_table(plan: CamPlan) -> Table:
    """Lift each ten degrees, by which a dial gauge on the follower proves the disc."""
    rolled = plan.lift if plan.comparison is None else plan.comparison.chosen.rolled
    angles = np.arange(0, 360, _STEP_DEG)
    lift = plan.rod.lift(rolled.q(np.radians(angles)))
    half = len(angles) // 2
    rows = [
        (
            number(float(angles[row]), "°", digits=0),
            number(float(lift[row]), "mm", digits=3),
            Cell(""),
            number(float(angles[row + half]), "°", digits=0),
            number(float(lift[row + half]), "mm", digits=3),
            Cell(""),
        )
        for row in range(half)
    ]
    head = (say("cam angle"), say("lift"), say("measured"))
    return Table("lift-table", say("Lift of the follower"), (*head, *head), tuple(rows), words=0)


def _gear_sizes(parts: list[dict[str, Any]]) -> Table | None:
    """Span and size over pins of each gear; None for wheels without teeth."""
    rows = []
    for part in parts:
        for gear in part["gears"]:
            if "span_max_mm" not in gear:
                continue
            rows.append(
                (
                    Cell(part["name"]),
                    number(gear["teeth"], digits=0),
                    number(gear["teeth_spanned"], digits=0),
                    number(gear["span_min_mm"], "mm", digits=3),
                    number(gear["span_max_mm"], "mm", digits=3),
                    number(gear["pin_diameter_mm"], "mm"),
                    number(gear["over_pins_min_mm"], "mm", digits=3),
                    number(gear["over_pins_max_mm"], "mm", digits=3),
                    Cell(""),
                )
            )
    heads = (
        say("part"),
        say("teeth"),
        say("teeth spanned"),
        say("span, least"),
        say("span, greatest"),
        say("pin diameter"),
        say("over pins, least"),
        say("over pins, greatest"),
        say("measured"),
    )
    return (
        Table("gear-sizes", say("Gears: base tangent length and size over pins"), heads, tuple(rows)) if rows else None
    )


def parts_section(plan: PagePlan) -> Section:
    """Parts list."""
    design, cam = plan.design, plan.cam
    inner, outer = design.cam.faces_mm
    rows: list[tuple[Cell, ...]] = [
        (
            Cell(say("cam")),
            Cell(named(design.blank.material or "–")),
            number(1, digits=0),
            number(None),
            number(None),
            number(cam.made_blank.bore_diameter, "mm"),
            number(outer - inner, "mm"),
            number(cam.made_blank.disc_volume(cam.area, outer - inner) * 1e-3, "cm³")
            if cam.made_blank.hub is None
            else number(None),
        )
    ]
    if plan.gears is not None:
        rows += _gear_rows(plan.gears.layout)
    heads = (
        say("part"),
        say("material"),
        say("quantity"),
        say("teeth"),
        say("module"),
        say("bore"),
        say("width"),
        say("volume"),
    )
    tables = [Table("parts", say("Parts"), heads, tuple(rows), words=2)]
    if plan.gears is not None:
        tables.append(_stages(plan.gears.layout))
    notes = () if plan.gears is None else tuple(map(generated, plan.gears.notes))
    return Section("parts", say("Parts list"), (), tuple(tables), notes)


def _gear_rows(layout: TrainLayout) -> list[tuple[Cell, ...]]:
    rows: list[tuple[Cell, ...]] = []
    for part in parts_facts(layout):
        gears = part["gears"]
        teeth = [gear["teeth"] for gear in gears if "teeth" in gear]
        modules = sorted({gear["module_mm"] for gear in gears if "module_mm" in gear})
        rows.append(
            (
                Cell(part["name"]),
                Cell("–", state=State.MUTED),
                number(1, digits=0),
                Cell(" + ".join(map(str, teeth)) or "–"),
                Cell(" + ".join(f"{module:g}" for module in modules) or "–", unit="mm" if modules else ""),
                number(part["bore_mm"], "mm"),
                Cell(" + ".join(f"{gear['width_mm']:g}" for gear in gears if "width_mm" in gear) or "–", unit="mm"),
                number(float(part["volume_mm3"]) * 1e-3, "cm³"),
            )
        )
    return rows


def _stages(layout: TrainLayout) -> Table:
    """Each stage with its ratio and play."""
    rows = [
        (
            number(count, digits=0),
            Cell(stage.label),
            number(float(stage.ratio)),
            number(stage.centre_distance, "mm"),
            number(degrees(stage.free_angle()), "°"),
            number(degrees(layout.directions[count - 1]) % 360, "°", digits=1),
        )
        for count, stage in enumerate(layout.train.stages, 1)
    ]
    heads = (
        say("stage"),
        say("teeth"),
        say("ratio"),
        say("centre distance"),
        say("play as cut, at the driven wheel"),
        say("direction"),
    )
    return Table("stages", say("Stages"), heads, tuple(rows), words=2)


def calibration_section(plan: PagePlan, reason: str) -> Section:
    """Measurements: verdicts on files, or the effects of an as-built design; a sentence without either.

    Args:
        plan: computed report.
        reason: why the measured data are left out; empty if they are not.
    """
    if reason:
        left_out = Words(f"The measured data are left out: {reason}.", f"未采用实测数据：{reason}。")
        return Section("calibration", say("Calibration"), (left_out,))
    if plan.calibration is not None:
        return _measured(plan.calibration)
    record = plan.design.as_built
    if record is None:
        return Section("calibration", say("Calibration"), (say("no-calibration"),))
    rows = [
        (
            Cell(effect.effect.replace("_", " ")),
            Cell(say(f"place-{effect.place}")),
            Cell(value.name),
            number(value.value),
            number(value.sigma),
        )
        for effect in record.effects
        for value in effect.values
    ]
    heads = (say("effect"), say("stays with"), say("number"), say("value"), say("standard deviation"))
    sources = [(Cell(source.file), Cell(source.kind), Cell(source.verdict or "–")) for source in record.sources]
    tables = [Table("as-built", say("Effects on the car as built"), heads, tuple(rows), words=3)]
    if sources:
        head = (say("file"), say("kind of data"), say("verdict"))
        tables.append(Table("sources", say("Measured files"), head, tuple(sources), words=3))
    return Section("calibration", say("Calibration"), (say("as-built-lead"),), tuple(tables))


def _measured(calibration: "Calibration") -> Section:
    from cadgen.jobs.calibration.words import report

    lead: list[Text] = []
    tables: list[Table] = []
    heading: Text = say("Calibration")
    for block in report(calibration):
        if isinstance(block, str):
            if block.strip():
                lead.append(block.strip())
        else:
            heading = _add(block, heading, tables)
    return Section("calibration", say("Calibration"), tuple(lead[:_LEAD]), tuple(tables), tuple(lead[_LEAD:]))


def _add(block: "Block", heading: Text, tables: list[Table]) -> Text:
    """Add a table of the report, or return the heading of those that follow."""
    from cadgen.output.report.text import Heading
    from cadgen.output.report.text import Table as Told

    if isinstance(block, Heading):
        return block.text
    assert isinstance(block, Told)
    rows = tuple(tuple(Cell(str(cell)) for cell in row) for row in block.rows)
    tables.append(Table(f"calibration-{len(tables) + 1}", heading, tuple(block.head), rows, words=block.words))
    return heading
