"""Fonts of the pages: one for Latin, Greek and Cyrillic, and one of the system's for Chinese, Japanese and Korean."""

from functools import cache
from pathlib import Path

import matplotlib
from ezdxf.fonts import fonts
from fontTools.ttLib import TTCollection, TTFont, TTLibError
from matplotlib.font_manager import findSystemFonts

from cadgen.errors import FileError
from cadgen.output.drawing.dxf import FONT

# Beginnings of the names of their files in Windows, macOS and Linux, the plain ones first.
_FAR_EASTERN = (
    "msyh.",
    "simhei",
    "notosanssc",
    "notosanscjk-regular",
    "notosanscjksc-regular",
    "sourcehansans",
    "pingfang",
    "hiragino sans gb",
    "stheiti",
    "wqy",
    "droidsansfallback",
    "simsun",
    "notoserifcjk-regular",
    "arialuni",
    "arial unicode",
    "malgun.",
    "msgothic",
)


class NoFontError(FileError):
    """No font of the system has the letters of a page."""


def know_font() -> None:
    """Let ezdxf find the font that comes with matplotlib, also where the system has none."""
    if not fonts.font_manager.has_font(FONT):
        fonts.font_manager.build([str(Path(matplotlib.get_data_path()) / "fonts" / "ttf")])


def know_far_eastern(letters: frozenset[str]) -> str:
    """Let ezdxf find a font of the system that has these letters, and return its name.

    Raises:
        NoFontError: there is none.
    """
    for file in _far_eastern_files():
        number = _face_with(file, letters)
        if number is not None:
            if not fonts.font_manager.has_font(file.name):
                fonts.font_manager.build([str(file.parent)], support_dirs=False)
            fonts.font_manager.get_ttf_font(file.name, font_number=number)
            return file.name
    lacking = " ".join(sorted(letters, reverse=True)[:3])
    raise NoFontError(
        f"no font of this system has {lacking}: install one with Chinese letters, such as Noto Sans CJK, or write "
        "drawing.title and drawing.finish in Latin letters"
    )


@cache
def _far_eastern_files() -> tuple[Path, ...]:
    """Fonts of the system that may have Chinese letters, the plain ones first."""
    files = sorted(map(Path, findSystemFonts()))
    return tuple(file for begin in _FAR_EASTERN for file in files if file.name.lower().startswith(begin))


def _face_with(file: Path, letters: frozenset[str]) -> int | None:
    """Number of a face of a file that has all letters, the simplified Chinese one if there is one; None without."""
    try:
        faces = TTCollection(file, lazy=True).fonts if file.suffix.lower() == ".ttc" else [TTFont(file, lazy=True)]
        plain = [number for number, face in enumerate(faces) if _family(face).endswith((" SC", " CN"))]
        order: dict[int, None] = dict.fromkeys([*plain, *range(len(faces))])
        for number in order:
            known = faces[number].getBestCmap() or ()
            if all(ord(letter) in known for letter in letters):
                return number
    except (OSError, TTLibError):
        pass
    return None


def _family(face: TTFont) -> str:
    return str(face["name"].getBestFamilyName())
