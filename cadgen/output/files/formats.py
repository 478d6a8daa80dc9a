"""Choice among the files that a job can write. A format is named by the ending of its files."""

from collections.abc import Iterable, Sequence
from enum import StrEnum

from cadgen.design.section import listed
from cadgen.errors import DesignError, brief


class Format(StrEnum):
    """A format of files, by the ending of their names."""

    STEP = "step"
    STL = "stl"
    THREE_MF = "3mf"
    DXF = "dxf"
    GCODE = "nc"
    XYZ = "xyz"
    CSV = "csv"


CAM_FORMATS = tuple(Format)
TRAIN_FORMATS = (Format.STEP, Format.STL, Format.CSV)
GEAR_FORMATS = (Format.STEP, Format.STL)


def chosen_formats(wanted: str | Iterable[str] | None, offered: Sequence[Format]) -> tuple[Format, ...]:
    """Formats to be written, in the order in which they are offered.

    Args:
        wanted: endings such as `step` and `dxf`, or one text with commas between them; None for all.
        offered: formats that the job can write.

    Raises:
        DesignError: an ending that is not offered, or none at all.
    """
    if wanted is None:
        return tuple(offered)
    if isinstance(wanted, bytes) or not isinstance(wanted, Iterable):
        raise DesignError(f"formats is {brief(repr(wanted), 40)}; it must name {listed(list(offered), 'or')}")
    parts = wanted.split(",") if isinstance(wanted, str) else [str(part) for part in wanted]
    endings = [part.strip().lower().removeprefix(".") for part in parts]
    for ending in endings:
        if ending not in offered:
            raise DesignError(f'formats has "{brief(ending, 40)}"; it must name {listed(list(offered), "or")}')
    if not endings:
        raise DesignError(f"formats is empty; it must name at least one of {listed(list(offered), 'and')}")
    return tuple(ending for ending in offered if ending in endings)


def entry_name(stem: str, formats: Sequence[Format], offered: Sequence[Format]) -> str:
    """Name of a manifest's entry: some of the formats get an entry of their own, beside that of the others."""
    return stem if len(formats) == len(offered) else "_".join([stem, *formats])


def entry_formats(formats: Sequence[Format], offered: Sequence[Format]) -> dict[str, list[str]]:
    """Facts on the chosen formats for a manifest's entry; empty if every format is there."""
    return {} if len(formats) == len(offered) else {"formats": list(formats)}
