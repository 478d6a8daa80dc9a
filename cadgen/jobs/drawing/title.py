"""Title blocks, and the files of a folder that a drawing refers to."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from cadgen.design.drawing import DrawingText
from cadgen.design.schema import Design, TrainDesign
from cadgen.errors import FileError
from cadgen.output.drawing.sheet import Title
from cadgen.output.files.manifest import NAME, sound_parts

_HASH = 12  # letters of a design's hash in a title block


@dataclass(frozen=True)
class Folder:
    """State of a folder before its drawings are made.

    Attributes:
        parts: entries of its manifest by their names.
        date: day on which the manifest was written, or today, ISO 8601; by SOURCE_DATE_EPOCH where that is set.
    """

    parts: Mapping[str, Any]
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
            raise FileError(f"SOURCE_DATE_EPOCH is {stated!r}; it must be a number of seconds since 1970") from None
        return cls(parts, moment.date().isoformat())

    def files(self, stem: str, design_hash: str, endings: tuple[str, ...]) -> tuple[tuple[str, str], ...]:
        """Name and hash of the files of a design whose names begin with `stem` and end as stated.

        Args:
            stem: what the names begin with.
            design_hash: hash of the design that they must be of.
            endings: endings of names, in the order in which the files are named.
        """
        listed = {
            name: facts["sha256"]
            for entry in self.parts.values()
            if entry.get("design_sha256") == design_hash
            for name, facts in entry["files"].items()
        }
        named = (f"{stem}{ending}" for ending in endings)
        return tuple((name, listed[name]) for name in named if name in listed)


def title_of(design: TrainDesign, part: str, material: str, number: str, folder: Folder) -> Title:
    """Title block of a part's sheet."""
    text = design.drawing or DrawingText()
    return Title(
        part=part,
        title=text.title or design.name,
        material=material,
        finish=text.finish or "",
        quantity=text.quantity,
        date=folder.date,
        design=f"{design.name} {design.content_hash[:_HASH]}",
        number=number,
    )


def not_stated(design: TrainDesign, *, cam: bool) -> dict[str, str]:
    """Facts that the sheets leave open, each with the key of the design that states it.

    Args:
        design: design that is drawn.
        cam: whether its cam is drawn, and not its train alone.
    """
    keys: dict[str, tuple[str, object]] = {}
    if cam and isinstance(design, Design):
        keys = {
            "material": ("blank.material", design.blank.material),
            "fit of the bore": ("blank.bore_fit", design.blank.bore_fit),
            "tolerance of the outline": ("tolerances.profile_offset_mm", design.tolerances.profile_offset_mm),
        }
    keys["finish"] = ("drawing.finish", design.drawing and design.drawing.finish)
    return {name: key for name, (key, value) in keys.items() if not value}


def bore_class(fit: str | None) -> str:
    """Tolerance class of a bore from its fit: `H7` of `H7/g6`; empty without a fit."""
    return fit.partition("/")[0].strip() if fit else ""
