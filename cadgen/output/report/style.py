"""Colours, sizes, and files whose bytes depend on their content alone."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from functools import partial
from importlib import import_module
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from cadgen.aside import Aside, Ready, Standby

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


_DRAWING = Standby("drawing")


def ready_to_draw(module: str, *, wanted: bool) -> AbstractContextManager[Ready]:
    """Load what draws in a process of its own, beside a block, since that takes as long as a short command.

    Args:
        module: of this room, that will draw.
        wanted: whether it will at all.
    """
    return _DRAWING.ready(partial(_load, module), wanted=wanted)


def drawing(pictures: Callable[[], list[str]]) -> AbstractContextManager[Callable[[], list[str]]]:
    """Draw beside a block if a process is ready for it; the block gets a function for the names of the files.

    Args:
        pictures: draws, and gives the names; it must be such as can be pickled.
    """
    return _DRAWING.beside(pictures)


def _load(module: str) -> None:
    backends = (f"matplotlib.backends.backend_{name}" for name in ("agg", "svg"))
    for name in ("matplotlib.figure", *backends, f"cadgen.output.report.{module}"):
        import_module(name)
    # A first picture takes longer than the next: fonts are looked up, and more is loaded.
    with figure(1.0, 1.0) as picture:
        axes = picture.subplots()
        axes.set_title("1")
        axes.plot([0, 1], label="1")
        axes.legend()
        for ending in ("png", "svg"):
            picture.savefig(BytesIO(), format=ending)


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


def save(picture: "Figure", folder: Path, name: str) -> list[str]:
    """Write a figure as PNG and SVG, without dates, and return the files' names.

    Must be called while the figure's style is in force. Its parts are placed once, and the two files drawn beside each
    other.

    Args:
        picture: figure of `figure`; its layout is fixed afterwards.
        folder: folder for the files.
        name: name of the files, without ending.
    """
    layout = picture.get_layout_engine()
    if layout is not None:
        layout.execute(picture)
        picture.set_layout_engine(None)
    points, lines = f"{name}.png", f"{name}.svg"
    with Aside(partial(_save, picture, folder / points, dpi=_DPI, metadata={"Software": None})) as beside:
        _save(picture, folder / lines, metadata={"Date": None, "Creator": None})
        beside.result()
    return [points, lines]


def _save(picture: "Figure", file: Path, **settings: Any) -> None:
    picture.savefig(file, **settings)


def zero_line(axes: "Axes") -> None:
    """Draw a thin line at an error of 0."""
    axes.axhline(0.0, color=GREY, linewidth=0.8, zorder=1)
