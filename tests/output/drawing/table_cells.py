"""Cells of a sheet's tables as they are drawn: which texts leave theirs."""

import shapely
from ezdxf.bbox import extents

from cadgen.output.drawing.sheet import DrawingSheet
from cadgen.output.drawing.sheet_files import FAR_EASTERN_STYLE, document_of, know_far_eastern

_TOUCH = 0.3  # mm that a letter stays away from a line


def leaving(sheet: DrawingSheet, language: str) -> list[str]:
    """Texts of a sheet's tables that come up to a line between two columns, by the letters with which they are drawn.

    Raises:
        NoFontError: the system has no font with the letters.
    """
    document = document_of(sheet, language)
    space = document.modelspace()
    texts = list(space.query("TEXT"))
    if letters := frozenset("".join(text.dxf.text for text in texts if text.dxf.style == FAR_EASTERN_STYLE)):
        document.styles.get(FAR_EASTERN_STYLE).dxf.font = know_far_eastern(letters)
    found = []
    for table in sheet.tables:
        left, top = table.at
        area = shapely.box(left - 0.1, top - table.height - 0.1, left + sum(table.widths) + 0.1, top + 0.1)
        drawn = [shapely.LineString([line.dxf.start.vec2, line.dxf.end.vec2]) for line in space.query("LINE")]
        upright = [line for line in drawn if line.bounds[0] == line.bounds[2] and area.covers(line)]
        assert len(upright) == len(table.widths) + 1
        for text in (text for text in texts if area.contains(shapely.Point(text.dxf.insert.vec2))):
            whole = extents([text])
            box = shapely.box(*whole.extmin.vec2, *whole.extmax.vec2)
            if any(line.distance(box) < _TOUCH for line in upright):
                found.append(text.dxf.text)
    return found
