"""Files and sheets of a car's frame: outlines, solids, programs and drawings, read back and published."""

import csv
from collections.abc import Iterator
from dataclasses import dataclass, replace
from io import StringIO
from pathlib import Path
from typing import NamedTuple

import numpy as np

from cadgen.car.assembly.car_parts import Block, Joined
from cadgen.car.assembly.frame.foot_joints import SHEET_SHARE
from cadgen.car.assembly.frame.one_piece import OnePiece, foot_of
from cadgen.car.assembly.panels import Feature, Panel, rectangle
from cadgen.car.running.friction import DiscMaterial, named_material
from cadgen.curves.contour import Contour
from cadgen.design import gear_model
from cadgen.design.frame import Cutting, FrameSection
from cadgen.design.machining import Machining
from cadgen.design.train import PlateSection
from cadgen.figures import Facts
from cadgen.jobs.car_frame import CLEAR, CarFrame
from cadgen.jobs.drawings import Folder, distance_notes, span_notes, title_of, write_sheet
from cadgen.jobs.frame_parts import material_of
from cadgen.messages import Message
from cadgen.output.drawing.frame_sheets import PanelText, block_drawing, panel_drawing
from cadgen.output.drawing.hole_frames import seat_zones
from cadgen.output.drawing.sheet import Title
from cadgen.output.files.frame_files import FrameText, block_files, mesh_files, one_piece_files, panel_files
from cadgen.output.files.manifest import Origin
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.progress import Progress, silent

_REAMED = Message("Classes and frames are of reamed seats; all else is as printed.")


def write_frame(frame: CarFrame, out: Path, progress: Progress = silent) -> Written:
    """Write outlines, solids, programs and sheets of a frame, read them back, and publish all together or none.

    Args:
        frame: frame of a car.
        out: folder for the files; it is made if need be.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the cutter is too large for a sheet.
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    omitted: dict[str, str] = {}
    state = Folder.at(out)
    return publish(
        frame.stem,
        out,
        lambda staging: _Files(frame, state, staging, omitted, progress).made(),
        frame.entry(),
        lambda _: Facts(
            **{key: each for key, each in (("omitted", omitted), ("not_stated", _not_stated(frame))) if each}
        ),
    )


def _not_stated(frame: CarFrame) -> dict[str, str]:
    """Facts that the sheets leave open, each with the key of the design that states it."""
    plates, keys = gear_model.train_keys(frame.design).plate or PlateSection(), frame.design.frame or FrameSection()
    materials = {
        Message("material of the plates"): ("train.plate.material", plates.material),
        Message("material of the base"): ("frame.material", keys.material or plates.material),
    }
    finish = {Message("surface finish"): ("drawing.finish", frame.design.drawing and frame.design.drawing.finish)}
    stated = ({} if keys.printed else materials | finish) | {
        Message("tolerance of the base radius"): (
            "tolerances.base_radius_mm",
            frame.design.tolerances.base_radius_mm,
        ),
    }
    return {name: key for name, (key, value) in stated.items() if not value}


class _Zero(NamedTuple):
    """Datum of a sheet part: zero of its sheet, outline, solid and program.

    Attributes:
        at: its place in the part's frame, mm.
    """

    at: tuple[float, float]


@dataclass(frozen=True, slots=True)
class _Files:
    """Files of a frame while they are made."""

    job: CarFrame
    folder: Folder
    staging: Path
    omitted: dict[str, str]
    progress: Progress

    def made(self) -> Iterator[Artifact]:
        """Write every file, and read it back."""
        job = self.job
        design, frame = job.design, job.frame
        keys = design.frame or FrameSection()
        text = FrameText(design.name, f"frame, design {Origin.of(design).content_hash[:12]}")
        machining: Machining | None = None
        if keys.cutting == Cutting.MILL and not keys.printed:
            machining = design.machining.model_copy(update={"cutter_diameter_mm": keys.cutter_diameter_mm})
        plates = gear_model.train_keys(design).plate or PlateSection()
        others = material_of(job) or (str(DiscMaterial.PLA) if keys.printed else "")
        if frame.printed is not None:
            yield from self._printed(frame.printed, text, others)
        for panel in frame.sheets:
            stem = f"{job.stem}_{panel.code}"
            self.progress(Message("writing {stem}", stem=stem))
            material = plates.material or "" if panel in frame.plates else others
            known = named_material(material)
            zero = self._zero(panel)
            counted = panel.counted_from(*zero.at)
            yield from panel_files(counted, self.staging, stem, text, machining, frame.sizes.seat, known)
            if keys.printed:
                yield from self._meshes(counted.shape, stem, text)
            sheet = panel_drawing(counted, self._words(panel, zero), self._title(panel.name, material, stem))
            yield from write_sheet(self.staging, stem, sheet, self.omitted)
        stem = f"{job.stem}_block"
        yield from block_files(frame.block, self.staging, stem, text)
        if keys.printed:
            yield from self._meshes(frame.block.shape, stem, text)
        title = self._title(Message("block of the fork"), others, stem)
        seats = [Message("Seats for bearings {code}, one in each end.", code=frame.block.bearing.designation)]
        seats += [_REAMED] if keys.printed else []
        sheet = block_drawing(frame.block, tuple(seats), frame.sizes.screw.thread, title)
        yield from write_sheet(self.staging, stem, sheet, self.omitted)
        table = StringIO()
        writer = csv.writer(table, lineterminator="\n")
        writer.writerow(["code", "name", "quantity"])
        writer.writerows((code, str(name), number) for code, name, number in job.bought)
        yield text_file(self.staging / f"{job.stem}_bought.csv", table.getvalue())

    def _printed(self, printed: OnePiece, text: FrameText, material: str) -> Iterator[Artifact]:
        """Files of a frame in one piece: solid, meshes, its sheet from above, and one of each wall."""
        frame, stem = self.job.frame, f"{self.job.stem}_printed"
        self.progress(Message("writing {stem}", stem=stem))
        yield from one_piece_files(printed, self.staging, stem, text)
        yield from self._meshes(printed.shape, stem, text)
        feet = [(wall.name, foot_of(wall).bounds) for wall in frame.standing]
        features = tuple(
            Feature(name, (left + right) / 2, (low + high) / 2, right - left, high - low)
            for name, (left, low, right, high) in feet
        )
        zero = self._zero(frame.base)
        walls = tuple(Contour(rectangle(*bounds) - zero.at, np.zeros(4)) for _, bounds in feet)
        words = replace(self._words(frame.base, zero), walls=walls)
        words = replace(words, notes=(*words.notes, *self._print_notes(printed)))
        whole = replace(frame.base, features=(*frame.base.features, *features)).counted_from(*zero.at)
        sheet = panel_drawing(whole, words, self._title(Message("frame in one piece"), material, stem))
        yield from write_sheet(self.staging, stem, sheet, self.omitted)
        for wall in frame.standing:
            title = self._title(Message("frame in one piece: {wall}", wall=wall.name), material, f"{stem}_{wall.code}")
            zero = self._zero(wall)
            sheet = panel_drawing(wall.counted_from(*zero.at), self._words(wall, zero), title)
            yield from write_sheet(self.staging, f"{stem}_{wall.code}", sheet, self.omitted)

    def _print_notes(self, printed: OnePiece) -> Iterator[Message]:
        yield Message(
            "Print it as one part on the lower face of the base: {size} mm. The list of parts counts it as solid.",
            size=" x ".join(f"{each:.1f}" for each in printed.size),
        )
        if printed.bridges:
            yield Message(
                "Walls bridge openings of the base, the longest by {length:.1f} mm: {wall}.",
                length=printed.bridges[0].length,
                wall=printed.bridges[0].wall,
            )
        yield Message(
            "Seats of bearings lie across the layers: print them without support, and ream all of one shaft in one go."
        )
        if self.job.design.export.printing is not None:
            yield self.job.design.export.printing.note
        yield Message("Sections of the walls: sheets {stem}_wall_near and so on.", stem=f"{self.job.stem}_printed")

    def _meshes(self, shape: Block | Joined, stem: str, text: FrameText) -> Iterator[Artifact]:
        export = self.job.design.export
        return mesh_files(shape, self.staging, stem, text, export.printing, export.cam_chord_um * 1e-3)

    def _title(self, part: str, material: str, stem: str) -> Title:
        design = self.job.design
        made = title_of(Origin.of(design), design.drawing, part, material, stem, self.folder)
        if not (design.frame or FrameSection()).printed:
            return made
        return replace(made, printed=True, finish="")  # the design's is of parts that are cut

    def _zero(self, panel: Panel) -> _Zero:
        """Datum on a sheet part: two edges of the base; else the first seat of a shaft, or the first hole."""
        if panel is self.job.frame.base or not panel.holes:
            left, low = panel.outline.vertices.min(axis=0).tolist()  # all its arcs are in the material
            return _Zero((left, low))
        hole = min(panel.holes, key=lambda each: (not (each.fit and each.shaft), each.shaft))
        return _Zero((hole.u, hole.v))

    def _words(self, panel: Panel, zero: _Zero) -> PanelText:
        frame = self.job.frame
        train, zones = gear_model.train(self.job.design), dict[int, float]()
        if panel in frame.plates:
            zones = seat_zones(sorted(hole.shaft for hole in panel.holes if hole.fit and hole.shaft), train)
        walls = () if frame.printed is None else frame.standing
        thick, flat = panel.thickness, panel is frame.platform or panel.code == "guide_top"
        notes: list[Message] = []
        if panel in walls:
            notes = [Message("Wall of the frame that is printed in one piece."), *([_REAMED] if panel.holes else [])]
        elif walls and panel is frame.base:
            notes = [Message("Base of {size:g} mm with walls on its upper face.", size=thick)]
        between: list[tuple[str, tuple[float, float], tuple[float, float]]] = []
        if panel is frame.base:
            notes += self._base_notes()
            a = frame.site.base_radius
            left, low = zero.at
            between.append(("camshaft to fork axis", (-left, -low), (-a - left, -frame.site.fork - low)))
        elif flat:
            notes.append(Message("Seen from above, the front of the car to the left."))
        elif panel.code in ("bracket_micrometer", "wall_micrometer"):
            notes += [Message("Seen from before the car."), Message("Micrometer head bonded into its hole.")]
        else:
            notes.append(Message("Seen from the left of the car, its front to the left."))
        if panel in frame.plates:
            notes += span_notes(train) if zones else distance_notes(train)
            notes.append(Message("Bearings flush with the face that looks to the train, bonded."))
        if frame.sizes.corner and not flat:
            notes.append(
                Message("Inner corners are opened for a cutter of {size:g} mm.", size=2 * (frame.sizes.corner - CLEAR))
            )
        thread = frame.sizes.screw.thread
        slots = [each for each in frame.base.features if each.pattern == panel.code]
        held = SHEET_SHARE if any(all(each.fitted) for each in slots) else 0.0
        return PanelText(
            notes=tuple(notes),
            between=tuple(between),
            zones=zones,
            thread=thread,
            thickness_share=held,
        )

    def _base_notes(self) -> Iterator[Message]:
        frame = self.job.frame
        site, way = frame.site, frame.sizes.travel / 2
        yield Message(
            "Seen from above, the front of the car to the left; upper face {low:.4g} mm below the camshaft.",
            low=frame.top,
        )
        deviation = self.job.design.tolerances.base_radius_mm
        if deviation:
            yield Message(
                "Camshaft to fork axis: {apart:g} ± {deviation:g} mm, set with the micrometer head; the slots allow "
                "{way:g} mm to either side. Then tighten the screws of the platform.",
                apart=site.base_radius,
                deviation=deviation,
                way=way,
            )
        else:
            yield Message(
                "Camshaft to fork axis: {apart:g} mm, set with the micrometer head; the slots allow {way:g} mm to "
                "either side. Its tolerance is not stated (tolerances.base_radius_mm).",
                apart=site.base_radius,
                way=way,
            )
