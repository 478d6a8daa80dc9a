"""Files of drawings: DXF, PDF and forms, read back and published with their entry in the manifest."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import Any

from cadgen.errors import FileError
from cadgen.gears.layout import TrainPart
from cadgen.jobs.cam.plan import CamPlan
from cadgen.jobs.drawing import cam as cam_sheets
from cadgen.jobs.drawing import train as train_sheets
from cadgen.jobs.drawing.title import Folder, not_stated
from cadgen.jobs.gears.plan import GearsPlan
from cadgen.output.drawing.sheet import Drawing, scale_text
from cadgen.output.files.folder import publishing
from cadgen.output.files.manifest import Written, file_facts, versions, write_manifest
from cadgen.progress import Progress, silent

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
    train: GearsPlan | None

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
    folder = Folder.at(out)
    files: dict[str, dict[str, Any]] = {}
    omitted: dict[str, str] = {}
    with publishing(out) as staging:
        for stem, sheet in _sheets(parts, folder):
            progress(f"drawing {stem}")
            for name, facts in write_sheet(staging, stem, sheet, omitted):
                files[name] = {**file_facts(staging / name), **facts}
        if parts.train is not None:
            for part in parts.train.layout.parts:
                for name, facts in _write_outlines(staging, f"{parts.train.stem}_{part.name}", part):
                    files[name] = {**file_facts(staging / name), **facts}
        if parts.cam is not None:
            name = f"{cam_sheets.stem_of(parts.cam)}_inspection.csv"
            (staging / name).write_text(cam_sheets.inspection_csv(parts.cam), encoding="ascii", newline="\n")
            files[name] = file_facts(staging / name)
        entry = {
            "design": parts.name,
            "design_sha256": parts.design_hash,
            "date": folder.date,
            "versions": versions(),
            **({"omitted": omitted} if omitted else {}),
            **({"not_stated": open_} if (open_ := _open(parts)) else {}),
            "files": files,
        }
        write_manifest(staging, parts.stem, entry)
    return Written(parts.stem, entry)


def _open(parts: Parts) -> dict[str, str]:
    if parts.cam is not None:
        return not_stated(parts.cam.design, cam=True)
    return {} if parts.train is None else not_stated(parts.train.design, cam=False)


def _sheets(parts: Parts, folder: Folder) -> Iterator[tuple[str, Drawing]]:
    if parts.cam is not None:
        yield cam_sheets.stem_of(parts.cam), cam_sheets.sheet_of(parts.cam, folder)
    if parts.train is not None:
        yield from train_sheets.sheets_of(parts.train, folder)


def write_sheet(
    staging: Path, stem: str, sheet: Drawing, omitted: dict[str, str]
) -> Iterator[tuple[str, dict[str, Any]]]:
    """Write a sheet and read it back; a page without a font for its letters is left out, with the reason."""
    from cadgen.output.drawing.dxf import dxf_bytes, read_dimensions
    from cadgen.output.drawing.fonts import NoFontError
    from cadgen.output.drawing.pdf import pdf_bytes

    look = {"sheet": sheet.size, "scale": scale_text(sheet.scale)}
    name = f"{stem}_drawing.dxf"
    (staging / name).write_bytes(dxf_bytes(sheet))
    again, drawn = read_dimensions(staging / name), sheet.dimensions
    off = [abs(again.get(key, inf) - length) for key, length in drawn.items()]
    if again.keys() != drawn.keys() or max(off, default=0.0) > DIMENSION_LIMIT:
        raise FileError(f"{name}, read back, has other dimensions: report this design")
    yield name, {**look, "dimensions_mm": {key: round(length, 6) for key, length in sorted(drawn.items())}}
    name = f"{stem}_drawing.pdf"
    try:
        page = pdf_bytes(sheet)
    except NoFontError as error:
        omitted["PDF"] = str(error)
        return
    (staging / name).write_bytes(page)
    if page.count(b"/Type /Page ") + page.count(b"/Type /Page\n") != 1:
        raise FileError(f"{name} is not one page: report this design")
    yield name, look


def _write_outlines(staging: Path, stem: str, part: TrainPart) -> Iterator[tuple[str, dict[str, Any]]]:
    """DXF of the teeth of each gear of a part with its bore, for a laser or a wire."""
    from cadgen.output.files.gear_outline import write_outline

    bore = part.blank.bore() if part.blank.bore_diameter else None
    for number, gear in enumerate(part.gears, 1):
        which = f"_{number}" if len(part.gears) > 1 else ""
        name = f"{stem}{which}_outline.dxf"
        yield name, {"outline_error_um": write_outline(staging / name, gear.outline, bore) * 1e3}
