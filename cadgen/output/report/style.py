"""Colours, sizes, and files whose bytes depend on their content alone."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Figure

# Okabe & Ito's palette, told apart by people with any kind of colour vision; lines differ in style as well.
BLACK, GREY = "#000000", "#8c8c8c"
BLUE, VERMILLION, GREEN, ORANGE, SKY = "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9"
WANTED, BEFORE, AFTER = BLACK, VERMILLION, BLUE

_DPI = 150
_SETTINGS: dict[Any, Any] = {
    "font.family": "DejaVu Sans",  # comes with matplotlib, so a picture is the same on every machine
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e6e6e6",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "legend.frameon": False,
    "lines.linewidth": 1.4,
    "svg.hashsalt": "cadgen",  # identifiers in the file, otherwise random
    "path.simplify_threshold": 0.05,
}


@contextmanager
def figure(width: float, height: float) -> Iterator["Figure"]:
    """Yield an empty figure of width and height in inches; the style of the program holds while it is drawn.

    Args:
        width: width of the figure, inches.
        height: height, inches.
    """
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(_SETTINGS)
        yield Figure(figsize=(width, height), layout="constrained")


# A picture that is drawn when it is entered, and in whose style it then can be saved.
Drawing: TypeAlias = "AbstractContextManager[Figure]"


def save(drawing: Drawing, folder: Path, name: str) -> list[str]:
    """Draw a picture, write it as PNG and SVG without dates, and return the files' names.

    Its parts are placed once for both files.

    Args:
        drawing: picture.
        folder: folder for the files.
        name: name of the files, without ending.
    """
    points, lines = f"{name}.png", f"{name}.svg"
    with drawing as picture:
        layout = picture.get_layout_engine()
        if layout is not None:
            layout.execute(picture)
            picture.set_layout_engine(None)
        picture.savefig(folder / points, dpi=_DPI, metadata={"Software": None})
        picture.savefig(folder / lines, metadata={"Date": None, "Creator": None})
    return [points, lines]


def zero_line(axes: "Axes") -> None:
    """Draw a thin line at an error of 0."""
    axes.axhline(0.0, color=GREY, linewidth=0.8, zorder=1)
