"""Drawings of a computed cam and gear train: their sheets, and DXF, PDF and forms that are read back and published.

A sheet's title block names the design by its hash, and its notes name the files of the folder that hold the same part.
"""

import os
import re
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from datetime import UTC, datetime
from itertools import chain
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.assembly.standard_parts import bearing_of
from cadgen.curves.biarc import arcs
from cadgen.design.keys import unit_of, without_unit
from cadgen.design.load import packaged_designs
from cadgen.design.machining import DrawingText, DrawnTeeth
from cadgen.errors import CheckError, DesignError, FileError
from cadgen.figures import Facts, Figures, with_unit
from cadgen.gears.cutting import sheet_notes
from cadgen.gears.layout import TrainLayout, TrainPart
from cadgen.gears.planetary_stage import PLANET, Carrier
from cadgen.gears.rack_stage import Bar
from cadgen.gears.stage import Mating, Stage, Wheel, holes_of, is_bar, is_ring, rim_diameter
from cadgen.gears.tolerances import run_outs, tip_tolerance
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train
from cadgen.inference.measurement.record import Direction
from cadgen.jobs.cam.cam_files import cam_export, groove_export
from cadgen.jobs.cam.cam_plan import CamPlan, Groove
from cadgen.jobs.gears.assembly import gear_figures
from cadgen.jobs.gears.gear_train import GearTrain
from cadgen.messages import ENGLISH, Message, joined, language
from cadgen.output.drawing.cam_sheet import EVERY, CamPart, Neighbour, SheetGroove, cam_drawing
from cadgen.output.drawing.cam_turns import outline_turns
from cadgen.output.drawing.gear_sheets import GearPart, gear_drawing, gear_rows, plate_drawing
from cadgen.output.drawing.hole_frames import seat_zones
from cadgen.output.drawing.shaft_fit import ShaftFit, fillet, hole_class, limits
from cadgen.output.drawing.sheet import DrawingSheet, Title, scale_text
from cadgen.output.drawing.timing import TimingDiagram
from cadgen.output.files.dxf import gear_outlines
from cadgen.output.files.formats import CAM, GROOVE
from cadgen.output.files.manifest import NAME, ManifestEntry, Origin, file_hash, sound_parts
from cadgen.output.files.plate import Axis, Plate, bearing_bores, plate_files
from cadgen.output.files.publisher import Artifact, Written, publish, require, text_file
from cadgen.parts.face import Face
from cadgen.parts.features import Keyway
from cadgen.progress import Progress, silent
from cadgen.verdict import PartVerdict, Readiness

if TYPE_CHECKING:
    from cadgen.output.drawing.sheet_files import SheetDocument

_EDGES = ((3.0, 0.3), (2.0, 0.2), (0.0, 0.1))  # least module, and what may be taken off an edge of its teeth, mm
_IN_WORDS = re.compile(r"(\d+(?:\.\d+)?) ?mm")  # thickness of a sheet in the words of its material
_LEAST_THICKNESS = 5.0  # mm, of a plate without bearings and shafts
_HASH = 12  # letters of a design's hash in a title block


@dataclass(frozen=True)
class Folder:
    """State of a folder before its drawings are made.

    Attributes:
        parts: entries of its manifest by their names.
        date: day on which the manifest was written, or today, ISO 8601; by SOURCE_DATE_EPOCH where that is set.
    """

    parts: Mapping[str, ManifestEntry]
    date: str

    @classmethod
    def at(cls, folder: Path) -> "Folder":
        """State of a folder, which need not exist.

        Raises:
            FileError: SOURCE_DATE_EPOCH is no number of seconds.
        """
        manifest = folder / NAME
        parts = sound_parts(manifest)
        stated = os.environ.get("SOURCE_DATE_EPOCH")
        try:
            if stated is not None:
                moment = datetime.fromtimestamp(int(stated), UTC)
            elif parts:
                moment = datetime.fromtimestamp(manifest.stat().st_mtime, UTC)
            else:
                moment = datetime.now(UTC)
        except (ValueError, OverflowError, OSError):
            raise FileError(
                "SOURCE_DATE_EPOCH is {stated}; it must be a number of seconds since 1970", stated=repr(stated)
            ) from None
        return cls(parts, moment.date().isoformat())

    def files(self, stem: str, design_hash: str, endings: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
        """Name and hash of the files of a design whose names begin with `stem` and end as stated.

        Args:
            stem: what the names begin with.
            design_hash: hash of the design that they must be of.
            endings: endings of names, in the order in which the files are named.
        """
        listed = {
            name: digest
            for entry in self.parts.values()
            if entry.design_sha256 == design_hash
            for name, digest in entry.hashes.items()
        }
        named = (f"{stem}{ending}" for ending in endings)
        return tuple((name, listed[name]) for name in named if name in listed)

    def with_files(self, part: str, design_hash: str, hashes: Mapping[str, str]) -> "Folder":
        """The folder with other files of one part in the place of those that it lists.

        Args:
            part: name of the part's entry.
            design_hash: hash of the design that they are of.
            hashes: SHA-256 of each file, by name.
        """
        others = {name: entry for name, entry in self.parts.items() if name != part}
        return replace(self, parts=others | {part: ManifestEntry(None, design_hash, hashes)})


def title_of(origin: Origin, text: DrawingText | None, part: str, material: str, number: str, folder: Folder) -> Title:
    """Title block of a part's sheet.

    Args:
        origin: design of the part.
        text: texts of the design's title blocks.
        part: name of the part.
        material: material of the part; empty where the design does not say.
        number: stem of the names of its files.
        folder: folder with the files.
    """
    text = text or DrawingText()
    return Title(
        part=part,
        title=text.title or origin.name,
        material=Message(material),
        finish=text.finish or "",
        quantity=text.quantity,
        date=folder.date,
        design=f"{origin.name} {origin.content_hash[:_HASH]}",
        number=number,
        owner=text.owner or "",
        drawn_by=text.drawn_by or "",
        approved_by=text.approved_by or "",
    )


def not_stated(text: DrawingText | None, cam: CamPlan | None, train: GearTrain | None) -> dict[str, str]:
    """Facts that the sheets leave open, each with the key of the design that states it.

    Args:
        text: texts of the design's title blocks.
        cam: cam that is drawn; None for the train alone.
        train: train that is drawn; None for the cam alone.
    """
    keys: dict[str, tuple[str, object]] = {}
    if cam is not None:
        keys = {
            "material": ("blank.material", cam.making.ordered),
            "fit of the bore": ("blank.bore_fit", cam.making.fit.bore),
            **cam.application.open_keys(),
        }
        if cam.making.screwed:
            keys[Message("thread of the set screw")] = ("blank.hub.set_screw.thread", cam.making.fit.thread)
    keys["surface finish"] = ("drawing.finish", text and text.finish)
    further = {} if train is None else train.making.open_keys(len(train.layout.on_shafts))
    return {name: key for name, (key, value) in keys.items() if not value} | further


_CAM_ENDINGS = ("_spline.dxf", "_arcs.dxf", ".step", ".nc")  # of the files that a sheet names
_ARCS_WITHIN = 1e-3  # mm, of the outline on the sheet
_DENSE = 3600  # angles at which points of the outline are sought: what the sheet says has one digit
_OF_A_FLANK = 8  # turning points of each flank of a groove on the sheet
_RUNS = 3  # of the inspection, which tells noise from what repeats
_ACROSS_AT = _DENSE * 215 // 360  # angle at which the width of a groove is dimensioned
_STEP = 5  # degrees between its readings


def sheet_of(plan: CamPlan, folder: Folder, other: CamPlan | None = None) -> DrawingSheet:
    """Sheet of a cam; it names the files of the folder that hold the same cam.

    Args:
        plan: cam, or a disc of a conjugate pair.
        folder: folder with the files.
        other: other disc of the pair; None for one disc.
    """
    making, use = plan.making, plan.application
    angles = np.radians(np.arange(0.0, 360.0, EVERY))
    dense = np.linspace(0.0, TURN, _DENSE, endpoint=False)
    jet, _ = plan.curve.at_angle(dense)
    radii = np.hypot(*jet.point.T)
    most, least = int(radii.argmax()), int(radii.argmin())
    endings = (*_CAM_ENDINGS[:-1], "_groove.nc") if plan.groove else _CAM_ENDINGS
    timing = use.timing(plan)
    part = CamPart(
        profile=arcs(plan.curve, _ARCS_WITHIN),
        angles=angles,
        radii=plan.curve.radius(angles),
        greatest=(float(radii[most]), float(dense[most])),
        least=(float(radii[least]), float(dense[least])),
        turns=outline_turns(radii, jet.curvature, *([_OF_A_FLANK] if plan.groove else [])),
        blank=plan.made_blank,
        thickness=plan.thickness,
        fit=making.fit,
        profile_tolerance=use.profile_tolerance or None,
        follower=Message(plan.follower.noun),
        on_ray=Message(plan.follower.on_ray),
        sizes=Message(
            "Follower: {parts}.",
            parts=joined([Message(plan.follower_as_built.noun), *_sizes(use.design.follower.keys)], ", "),
        ),
        leans=plan.follower.leans,
        face=Message("inner face") if plan.seen == Face.INNER else Message("outer face"),
        files=folder.files(plan.stem, plan.origin.content_hash, endings),
        notes=(
            *use.drawing_notes(plan),
            *([plan.kind.note] if plan.kind.note else []),
            *([making.export.printing.note] if making.export.printing else []),
        ),
        thickness_limits=_half_width(use.thickness_tolerance),
        edge_limits=_half_width(use.edge_tolerance),
        taper=use.taper_tolerance,
        base_radius=use.base_radius if plan.groove is None and not plan.part else None,
        timing=None if timing is None else TimingDiagram.of(timing),
        groove=None if plan.groove is None else _groove(plan, plan.groove, angles),
        rim_texture=(making.title and making.title.rim_finish) or "",
        bore_texture=(making.title and making.title.bore_finish) or "",
        neighbour=None if other is None else _neighbour(plan, other),
    )
    noun = Message("second {cam}", cam=Message(use.noun)) if plan.part else Message(use.noun)
    name = Message("{cam}, {kind} profile", cam=noun, kind=Message(str(plan.kind)))
    title = title_of(plan.origin, making.title, name, making.ordered, plan.stem, folder)
    return cam_drawing(part, replace(title, verdict=_verdict(plan), edge=_EDGES[-1][1]))


def _neighbour(plan: CamPlan, other: CamPlan) -> Neighbour | None:
    """Other disc of a conjugate pair, the second one behind the first; None where their distance is not stated."""
    gap = plan.application.disc_gap
    if gap is None:
        return None
    radii = other.curve.radius(np.linspace(0.0, TURN, _DENSE, endpoint=False))
    word = Message("second disc") if other.part else Message("first disc")
    side = 1 if plan.part else -1
    return Neighbour(word=word, radius=float(radii.max()), gap=gap, thickness=other.thickness, side=side)


def _half_width(deviation: float) -> str:
    """Limits either way as they follow a size; empty for the general tolerance."""
    return f" {limits(-deviation, deviation)}" if deviation else ""


def _groove(plan: CamPlan, groove: Groove, angles: Array) -> SheetGroove:
    """Groove of a cam for its sheet.

    Args:
        plan: cam, whose curve is the inner flank.
        groove: its groove.
        angles: polar angles of the table, rad.
    """
    dense = np.linspace(0.0, TURN, _DENSE, endpoint=False)
    outer = groove.outer.curve
    jet, _ = outer.at_angle(dense)
    radii = np.hypot(*jet.point.T)
    inner = plan.curve.radius(dense)[:, None] * np.column_stack([np.cos(dense), np.sin(dense)])
    normal = np.gradient(np.vstack([inner[-1:], inner, inner[:1]]), axis=0)[1:-1] @ np.array([[0.0, -1.0], [1.0, 0.0]])
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    half = plan.follower_as_built.radius
    across = inner[_ACROSS_AT] + np.array([[0.0], [2 * half]]) * normal[_ACROSS_AT]
    return SheetGroove(
        outer=arcs(outer, _ARCS_WITHIN),
        radii=outer.radius(angles),
        turns=outline_turns(radii, jet.curvature, _OF_A_FLANK),
        path=np.vstack([inner + half * normal, inner[:1] + half * normal[:1]]),
        across=across,
        outside_radius=groove.outside_radius,
        depth=groove.depth,
    )


_SIGNS = {"degrees": "°"}  # of units on a sheet, which are read in any language


def _sizes(keys: Any) -> Iterator[Message]:
    """Values of the keys of a follower in words, those of a part of it under its name."""
    for key, value in ((field.name, getattr(keys, field.name)) for field in fields(keys)):
        if value is None:
            continue
        name = Message(without_unit(key).replace("_", " "))
        if key == "lifts":
            yield Message("arm lifts {way}", way=Message(value.words))
        elif is_dataclass(value):
            yield Message("{name}: {parts}", name=name, parts=joined(tuple(_sizes(value)), ", "))
        elif isinstance(value, float | int):
            unit = unit_of(key)
            yield Message("{name} {value}", name=name, value=with_unit(f"{value:g}", _SIGNS.get(unit, unit)))
        else:
            words = getattr(value, "words", str(value).replace("_", " "))
            yield Message("{name} {value}", name=name, value=Message(words))


def _verdict(plan: CamPlan) -> str:
    """Verdict on a cam in a short line; empty for one that is ready."""
    verdict = plan.verdict
    match verdict.readiness:
        case Readiness.NOT_READY:
            first, *others = (Message(check.name) for check in verdict.failed)
            if others:
                return Message("NOT READY: {check} and {count} more", check=first, count=len(others))
            return Message("NOT READY: {check}", check=first)
        case Readiness.RESERVATIONS:
            return Message("ready with reservations, see cadgen check {name}", name=_as_given(plan.origin))
    return ""


def _as_given(origin: Origin) -> str:
    """Name by which a command takes a design: that of its file, or of one that comes with cadgen."""
    name = Path(origin.source).stem
    return shlex.quote(name if name in packaged_designs() else origin.source or origin.name)


def inspection_csv(plan: CamPlan) -> str:
    """Form for a dial on the lever, in the columns that `cadgen calibrate` reads: the readings are left open.

    A form that is not filled in is refused by `calibrate`, which names the first open row.
    """
    lines = [
        f"# design: {plan.origin.name}",
        f"# profile: {plan.kind}; give calibrate --profile {plan.kind}",
        "# a dial on the lever at the disc's inner face: write each reading into lift_mm",
        "run,direction,cam_angle_deg,lift_mm",
    ]
    for run in range(1, _RUNS + 1):
        for direction, angles in (
            (Direction.FORWARD, range(0, 360, _STEP)),
            (Direction.REVERSE, range(360 - _STEP, -1, -_STEP)),
        ):
            lines += [f"{run},{direction},{angle}," for angle in angles]
    return "\n".join(lines) + "\n"


_PART_ENDINGS = (".step", ".stl", "_outline.dxf", "_1_outline.dxf", "_2_outline.dxf")


def sheets_of(plan: GearTrain, folder: Folder) -> Iterator[tuple[str, DrawingSheet]]:
    """Stem of the files that a sheet stands for, and the sheet: of each part, then of the plate."""
    layout, origin = plan.layout.pieces, plan.origin
    every = gear_figures(layout)
    first: dict[tuple[int, int], int] = {}
    for part in layout.parts:
        if part.figures is not None:
            first[part.stages[0], part.figures] = first.get((part.stages[0], part.figures), 0) + 1
    for part, gears, teeth in zip(layout.parts, every, plan.makings, strict=True):
        count = 1 if part.figures is None else first.pop((part.stages[0], part.figures), 0)
        if not count:  # a planet like the one before
            continue
        stem = f"{plan.stem}_{part.name}"
        data, blanks, places = [], [], [0.0]
        in_carrier: str | None = None
        loose: list[Message] = []
        grades: list[int] = []
        for (number, gear), wheel in zip(gears.items(), part.gears, strict=True):
            mates, pair, drives = _mates(layout, every, number, part)
            data.append(gear_rows(gear, mates, pair, drives=drives, double=getattr(wheel, "double", False)))
            if holes_of(wheel):  # where no place is stated the pins keep the deviation of their distance
                stated = getattr(layout.train.stages[number - 1], "pin_place", 0.0)
                places.append(stated or pair.distance_deviation or 0.0)
                pins = plan.making.pins.get(number)
                in_carrier = pins.carrier if pins else None
                if pins and pins.loose:
                    loose = [Message("Pins run in the carrier and in the planets: hold them axially.")]
            grade = pair.grades[0 if drives else 1]
            grades += [] if grade is None or gear.value("E_sns") == gear.value("E_sni") else [grade]
            blanks.append(_run_outs(gear, wheel, part, grade))
        of_stages = [layout.train.stages[number - 1] for number in gears]
        bodies = joined([_kind_of(gear) for gear in part.gears], " and ")
        made = plan.making.shaft(part.shaft, len(plan.layout.on_shafts))
        place = Message("Shaft {shaft} of the train, counted from the drive.", shaft=part.shaft)
        fit = made.fit
        if part.figures == PLANET and part.stages[0] in plan.making.pins:
            fit = ShaftFit(bore=plan.making.pins[part.stages[0]].planets)
        if part.beside or is_bar(part.gears[0]):
            place = Message("Stage {number} of the train, counted from the drive.", number=part.stages[0])
        sheet = GearPart(
            part=part,
            fit=fit,
            data=tuple(data),
            files=folder.files(stem, origin.content_hash, _PART_ENDINGS),
            pitch_diameters=tuple(
                float(f"{diameter:.7g}") for gear in gears.values() if (diameter := gear.value("reference_diameter"))
            ),
            notes=(
                place,
                *sheet_notes(part, teeth, min(grades, default=None)),
                *loose,
                *([plan.printing.note] if plan.printing else []),
            ),
            flank_texture=(plan.title and plan.title.flank_finish) or "",
            bore_texture=(plan.title and plan.title.bore_finish) or "",
            simplified=bool(plan.title and plan.title.teeth is DrawnTeeth.SIMPLIFIED),
            tip_limits=tuple(map(_tip_limits, part.gears)),
            run_outs=tuple(blanks),
            pins=2 * max(places),
            pin_class=hole_class(in_carrier),
            parallel=of_stages[-1].distance_deviation or 0.0 if is_bar(part.gears[0]) else 0.0,
        )
        name = Message("{part}: {bodies}", part=part.name, bodies=bodies)
        title = title_of(origin, plan.title, name, made.material or "", stem, folder)
        edge = next(
            (
                most
                for module, most in _EDGES
                if all(getattr(gear, "normal_module", 0.0) >= module for gear in part.gears)
            ),
            0.1,
        )
        key = part.blank.key
        inner = min(edge, fillet(key.width)) if isinstance(key, Keyway) else None
        yield stem, gear_drawing(sheet, replace(title, quantity=count * title.quantity, edge=edge, inner=inner))
    if _printed(plan):
        return
    stem = f"{plan.stem}_plate"
    title = title_of(origin, plan.title, Message("plate for the axes"), plan.making.plate or "", stem, folder)
    title = replace(title, quantity=2 * title.quantity)
    of_shafts = plan.making.bearing_bores is None and not plan.making.holes
    holes = Message("shaft Ø, mm") if of_shafts else Message("hole Ø, mm")
    plate = plate_of(plan)
    zones = seat_zones([axis.shaft for axis in plate.holed], plan.layout.train)
    thickness = plate.thickness or _usual_thickness(plan)
    stages = enumerate(plan.layout.train.stages, 1)
    deviations = {number: stage.distance_deviation for number, stage in stages if stage.distance_deviation}
    yield stem, plate_drawing(plate, thickness, holes, tuple(_plate_notes(plan)), title, zones, deviations)


def _kind_of(wheel: Wheel) -> str:
    """Kind of a wheel with the number of its teeth or planets, for the title of its sheet."""
    match wheel:
        case GearForm(teeth=teeth) if is_ring(wheel):
            return Message("ring gear of {teeth} teeth", teeth=teeth)
        case GearForm(teeth=teeth):
            return Message("gear of {teeth} teeth", teeth=teeth)
        case Bar(form=form):
            return Message("rack of {teeth} teeth", teeth=form.teeth)
        case Carrier(orbits=orbits):
            return Message("carrier of {count} planets", count=len(orbits))
    return wheel.noun.removeprefix("the ")


def _run_outs(gear: Figures, wheel: Wheel, part: TrainPart, grade: int | None) -> tuple[float, float] | None:
    """Run-outs of a gear's blank by its grade, mm; None without one, and for sizes that the standard does not cover.

    Args:
        gear: figures of the gear.
        wheel: gear.
        part: part that it is of, whose lower face runs out.
        grade: tolerance grade.
    """
    upper, face = gear.value("E_sns"), rim_diameter(part.gears[0])
    if grade is None or not isinstance(wheel, GearForm) or upper is None or upper == gear.value("E_sni"):
        return None  # nothing is tolerated
    try:
        return run_outs(wheel.reference_diameter, wheel.normal_module, wheel.width, face, grade)
    except DesignError:
        return None


def _tip_limits(wheel: Wheel) -> str:
    """Limits of a tip diameter as they follow it: into the material; empty for a carrier or a bar."""
    if not isinstance(wheel, GearForm):
        return ""
    width = tip_tolerance(wheel.tip_diameter, wheel.normal_module)
    return f" {limits(0.0, width) if is_ring(wheel) else limits(-width, 0.0)}"


def plate_of(plan: GearTrain) -> Plate:
    """Plate of a train.

    Raises:
        DesignError: bores for bearings that meet, or are too many or too few.
    """
    parts, making = [part for part in plan.layout.on_shafts if not is_bar(part.gears[0])], plan.making
    beside = [part for part in plan.layout.parts if part.beside]
    bores = bearing_bores(making.bearing_bores, [part.blank.bore_diameter for part in parts])
    axes = tuple(
        Axis(
            shaft=part.shaft,
            x=part.axis.real,
            y=part.axis.imag,
            bore=bore,
            reach=max(
                abs(near.axis - part.axis) + rim_diameter(gear) / 2
                for near in (part, *(each for each in beside if each.stages[0] == part.shaft))
                for gear in near.gears
            ),
            hole=hole_class(making.holes),
        )
        for part, bore in zip(parts, bores, strict=True)
    )
    return Plate(axes, making.plate_thickness)


def _printed(plan: GearTrain) -> bool:
    """Whether a train stands in a frame that is printed in one piece, and has no plates of its own."""
    return plan.car is not None and plan.car.printed


def _usual_thickness(plan: GearTrain) -> float:
    """Thickness that the sheet of the plates states where no key does, mm.

    A car's plates have the thickness of its layout, others that in the words of their material, such as `plywood 5 mm`.
    Else it is the width of the widest bearing, or the diameter of the thickest shaft where shafts run in plain holes.
    """
    if plan.car is not None:
        return plan.car.site.plate
    if named := _IN_WORDS.search(plan.making.plate or ""):
        return float(named[1])
    shafts = [part.blank.bore_diameter for part in plan.layout.on_shafts if not is_bar(part.gears[0])]
    bores = bearing_bores(plan.making.bearing_bores, shafts)
    bearings = [bearing_of(shaft, bore) for shaft, bore in zip(shafts, bores, strict=True)]
    widths = [bearing.width for bearing in bearings if bearing is not None]
    return max(widths or shafts) or _LEAST_THICKNESS


def _plate_notes(plan: GearTrain) -> Iterator[str]:
    """Sentences on the plate of a train."""
    yield Message("Seen along the axes from the output's end. Broken circles: tips of the gears, for room.")
    yield Message("Two to a machine, before and behind the gears.")
    holes, bearings = plan.making.holes, plan.making.bearing_bores is not None
    if bearings:
        yield Message("Holes for the bearings, as the table has them.")
    elif holes is None:
        yield Message(
            "Holes as large as the shafts: open them for your bearings. Where no bore is given there is no hole."
        )
    car = plan.car
    if car is not None and car.arrangement is not None:
        yield Message(
            "In the car x points ahead and y down: turned by 180°, this sheet is seen from the left of the car. The "
            "fork axis stands {fork:g} mm ahead of axis {last}, which lies {height:.4g} mm over the floor.",
            fork=car.site.base_radius,
            last=len(plan.layout.parts),
            height=car.arrangement.height,
        )
    if car is not None and car.design.frame is not None:
        yield Message("The frame of this car has plates of its own: sheets of cadgen frame hold in place of this one.")
    yield from span_notes(plan.layout.train)


def span_notes(train: Train) -> Iterator[Message]:
    """Distances of the bearings of a shaft, in words.

    Args:
        train: train.
    """
    for span in dict.fromkeys(stage.bearing_span for stage in train.stages if stage.distance_deviation):
        yield Message("Bearings of a shaft {span:g} mm apart, for which the play is computed.", span=span)


def distance_notes(train: Train) -> Iterator[Message]:
    """Distances of the axes of a train with their tolerances, in words.

    Args:
        train: train.
    """
    for number, stage in enumerate(train.stages, 1):
        if stage.distance_deviation:
            yield Message(
                "Axes {first} and {second}: {apart:g} ± {deviation:.4g} mm, bearings {span:g} mm apart, for which "
                "the play is computed.",
                first=number,
                second=number + 1,
                apart=stage.centre_distance,
                deviation=stage.distance_deviation,
                span=stage.bearing_span,
            )


def _mates(
    layout: TrainLayout, every: Sequence[Mapping[int, Figures]], stage: int, part: TrainPart
) -> tuple[tuple[str, ...], Stage, bool]:
    """Gears in mesh with that of a part, in words; the mesh as a pair; and whether the gear drives it.

    A planet meshes with sun and ring: the pair is that with the sun.
    """
    whole, wheel, places = layout.train.stages[stage - 1], part.wheel_of(stage), layout.places(stage)
    matings = [mating for mating in whole.matings if wheel in (mating.driver, mating.driven)]
    if not matings and whole.matings:  # a carrier
        planet = whole.matings[0]
        return (layout.parts[places[planet.driven]].name,), planet.pair, False
    matings = matings or [Mating(whole)]
    named = []
    for mating in matings:
        other = places[mating.driven if wheel == mating.driver else mating.driver]
        teeth, name = every[other][stage].value("teeth"), layout.parts[other].name
        named.append(name if teeth is None else f"z = {teeth}, {name}")
    return tuple(named), matings[0].pair, wheel == matings[0].driver


# Greatest difference of a dimension in a file from that of the part, mm: rounding.
DIMENSION_LIMIT = 1e-6


@dataclass(frozen=True, eq=False)
class Parts:
    """Computed parts for drawings.

    Attributes:
        name: name of the design.
        design_hash: hash of the design.
        cam: computed cam; None to draw the train alone.
        train: computed train; None to draw the cam alone.
    """

    name: str
    design_hash: str
    cam: CamPlan | None
    train: GearTrain | None

    @property
    def verdict(self) -> PartVerdict:
        """Verdict on the cam in its application, with the checks of the train."""
        cam = PartVerdict(()) if self.cam is None else self.cam.verdict
        return PartVerdict((*cam.checks, *(() if self.train is None else self.train.checks)), cam.reservations)

    @property
    def stem(self) -> str:
        """Name of the entry in the manifest."""
        kinds = [part for part, there in (("cam", self.cam), ("train", self.train)) if there is not None]
        which = "" if len(kinds) == 2 else f"_{kinds[0]}"
        return f"{self.name}{which}_drawings"


def write_drawings(parts: Parts, out: Path, progress: Progress = silent) -> Written:
    """Draw, read back and publish: a sheet of the cam, of every part of the train and of the plate, and the forms.

    Args:
        parts: what is drawn.
        out: folder for the files; it is made if need be. Files of the same parts in it are referred to by their hashes.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    before = Folder.at(out)
    omitted: dict[str, str] = {}

    def files(staging: Path) -> Iterator[Artifact]:
        outlines = list(_outlines(parts, before.with_files(parts.stem, parts.design_hash, {}), staging, omitted))
        hashes = {each.name: file_hash(staging / each.name) for each in outlines}
        folder = before.with_files(parts.stem, parts.design_hash, hashes)
        discs = () if parts.cam is None else parts.cam.discs
        others = discs[::-1] if len(discs) > 1 else (None,) * len(discs)
        sheets = [(disc.stem, sheet_of(disc, folder, other)) for disc, other in zip(discs, others, strict=True)]
        for stem, sheet in chain(sheets, () if parts.train is None else sheets_of(parts.train, folder)):
            progress(Message("drawing {stem}", stem=stem))
            yield from write_sheet(staging, stem, sheet, omitted)
        yield from outlines
        if parts.train is not None:
            if _printed(parts.train):
                omitted["plate"] = Message("the frame is printed in one piece, which cadgen frame draws")
            else:
                yield from plate_files(plate_of(parts.train), staging, f"{parts.train.stem}_plate")
        if parts.cam is not None and parts.cam.application.measured_again:
            yield text_file(staging / f"{parts.cam.stem}_inspection.csv", inspection_csv(parts.cam))

    further = {"omitted": omitted}
    if parts.cam is not None:
        further["not_stated"] = not_stated(parts.cam.making.title, parts.cam, parts.train)
    elif parts.train is not None:
        further["not_stated"] = not_stated(parts.train.title, None, parts.train)
    return publish(
        parts.stem,
        out,
        files,
        Facts(
            design=parts.name,
            design_sha256=parts.design_hash,
            date=before.date,
            passed=parts.verdict.passed,
            verdict=parts.verdict.entry(),
        ),
        lambda _: Facts(**{key: value for key, value in further.items() if value}),
    )


def _outlines(parts: Parts, folder: Folder, staging: Path, omitted: dict[str, str]) -> Iterator[Artifact]:
    """Outlines that sheets name, as DXF: of every gear, and of a cam of which no file lies in the folder.

    Args:
        parts: what is drawn.
        folder: folder without the files of an earlier drawing.
        staging: folder for the files.
        omitted: reasons by what could not be made, which get that of a cam.
    """
    plan = parts.cam
    if plan is not None and not _dxf_in(folder, plan):
        made = (
            [one for disc in plan.discs for one in CAM.made(cam_export(disc), staging, CAM.chosen("dxf"))]
            if plan.groove is None
            else GROOVE.made(groove_export(plan, plan.groove), staging, GROOVE.chosen("dxf"))
        )
        for each, result in made:
            if isinstance(result, CheckError):
                omitted[each.label] = result.message
            else:
                yield from result
    if parts.train is not None:
        for part in parts.train.layout.pieces.parts:
            stem = f"{parts.train.stem}_{part.name}"
            drawn = gear_outlines(staging, part, stem, "_outline", drilled=False)
            yield from (replace(each, readings=()) for each in drawn)


def _dxf_in(folder: Folder, plan: CamPlan) -> bool:
    """Whether the outline of every disc of a cam lies in the folder already."""
    return all(folder.files(disc.stem, plan.origin.content_hash, _CAM_ENDINGS[:2]) for disc in plan.discs)


def write_sheet(staging: Path, stem: str, sheet: DrawingSheet, omitted: dict[str, str]) -> Iterator[Artifact]:
    """Write a sheet and read it back; a page without a font for its letters is left out, with the reason."""
    from cadgen.output.drawing.sheet_files import NoFontError, SheetDocument, read_dimensions

    document = SheetDocument(sheet, language())
    scale = scale_text(sheet.scale)
    look = Facts(sheet=sheet.size, scale=scale)
    name = f"{stem}_drawing.dxf"
    (staging / name).write_bytes(document.dxf())
    again, drawn = read_dimensions(staging / name), sheet.dimensions
    off = [abs(again.get(key, inf) - length) for key, length in drawn.items()]
    same = again.keys() == drawn.keys() and max(off, default=0.0) <= DIMENSION_LIMIT
    require(same, name, Message("has other dimensions"))
    lengths = {key: round(length, 6) for key, length in sorted(drawn.items())}
    yield Artifact(name, look | Facts(dimensions_mm=lengths), (sheet.size, scale, str(len(lengths))))
    name = f"{stem}_drawing.pdf"
    try:
        page = _page(document, omitted)
    except NoFontError as error:
        omitted["PDF"] = error.message
        return
    (staging / name).write_bytes(page)
    if page.count(b"/Type /Page ") + page.count(b"/Type /Page\n") != 1:
        raise FileError("{name} is not one page: report this design", name=name)
    yield Artifact(name, look, (sheet.size, scale, ""))


def _page(document: "SheetDocument", omitted: dict[str, str]) -> bytes:
    """Page of a sheet in the language that is shown; in English where the system has no font for that language."""
    from cadgen.output.drawing.sheet_files import NoFontError

    try:
        return document.page()
    except NoFontError:
        page = replace(document, language=ENGLISH).page()  # raises where the title block has letters without a font
        omitted["translated PDF"] = Message(
            "the pages are in English, for no font of this system has the letters of the language asked for: install"
            " one, such as Noto Sans CJK"
        )
        return page
