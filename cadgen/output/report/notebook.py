"""Results in a notebook: a line, the figures, and the picture."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from html import escape
from io import StringIO
from textwrap import fill
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

from cadgen.arrays import Array
from cadgen.errors import CadgenError
from cadgen.figures import JobResult, html_table, rounded
from cadgen.output.report.style import AFTER, BEFORE, GREEN, Drawing, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_MOST_ROWS = 16
_LONGEST = 60  # characters of a text that stands among the figures
_BAR = 0.28  # inches, of the height that a bar takes
_MOST_BARS = 24
_BROAD = 46  # characters of a bar's name on a line
# Solids that a viewer was shown; not in the objects themselves, which are pickled.
_SHOWN: "WeakKeyDictionary[Viewed, Any]" = WeakKeyDictionary()


class Plotted(ABC):
    """Base of what has a picture."""

    @property
    @abstractmethod
    def picture(self) -> Drawing:
        """Picture, drawn when it is entered."""

    def plot(self) -> "Figure":
        """Draw the picture.

        Returns:
            A matplotlib figure, to be shown in a notebook or saved with `savefig`.
        """
        with self.picture as drawn:
            return drawn

    def _repr_html_(self) -> str:
        return f"<p><code>{escape(repr(self))}</code></p>{_shown(self)}"


class Pictured(JobResult, Plotted):
    """Base of a result with a picture, which a notebook shows below its figures."""

    def _repr_html_(self) -> str:
        said = {
            name: rounded(value) if isinstance(value, float) else str(value)
            for name, value in self.facts().items()
            if isinstance(value, int | float | str) and 0 < len(str(value)) <= _LONGEST
        }
        rows = list(said.items())[:_MOST_ROWS]
        return f"<p><code>{escape(repr(self))}</code></p>{html_table(rows)}{_shown(self)}"


class Viewed(ABC):
    """Base of what is a build123d solid, too, so that `show` of ocp_vscode takes it as it is."""

    @abstractmethod
    def build123d(self) -> Any:
        """Solid or compound of build123d, mm."""

    def _shown(self) -> Any:
        """Solid or compound, made once, for a viewer asks many times."""
        try:
            return _SHOWN[self]
        except KeyError:
            return _SHOWN.setdefault(self, self.build123d())
        except TypeError:  # what holds a list has no hash, and is made anew
            return self.build123d()

    @property
    def wrapped(self) -> Any:
        """Shape of the CAD kernel, by which viewers such as three-cad-viewer know what can be shown."""
        return self._shown().wrapped

    @property
    def children(self) -> Any:
        """Parts of an assembly, as build123d has them; empty for one part."""
        return self._shown().children

    @property
    def label(self) -> str:
        """Name in a viewer."""
        return str(self._shown().label)

    @property
    def color(self) -> Any:
        """Colour in a viewer."""
        return self._shown().color

    @property
    def location(self) -> Any:
        """Place in a viewer."""
        return self._shown().location


def _shown(result: Plotted) -> str:
    """Picture as an SVG element, or a sentence why there is none."""
    drawn = StringIO()
    try:
        with result.picture as picture:
            picture.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
    except CadgenError as error:  # such as of a plan without a path
        return f"<p>{escape(error.message)}</p>"
    shown = drawn.getvalue()
    return shown[shown.index("<svg") :]


@contextmanager
def bars_picture(title: str, across: str, bars: Mapping[str, float]) -> "Iterator[Figure]":
    """Draw a lying bar for each of several figures, in their order from the top.

    Args:
        title: title of the picture.
        across: name of the horizontal axis, with its unit.
        bars: values by the name of the bar, in the unit that `across` names.
    """
    names, values = list(bars)[:_MOST_BARS], list(bars.values())[:_MOST_BARS]
    labels = [fill(name, _BROAD) for name in names]
    lines = max(label.count("\n") + 1 for label in labels)
    with figure(7.0, 1.1 + _BAR * len(names) * (1.0 + 0.4 * (lines - 1))) as picture:
        axes = picture.subplots()
        drawn = axes.barh(range(len(names)), values, color=AFTER)
        axes.bar_label(drawn, [rounded(value) for value in values], padding=3, fontsize=8)
        axes.set_yticks(range(len(names)), labels, fontsize=8)
        axes.invert_yaxis()
        axes.set(title=title, xlabel=across)
        axes.margins(x=0.15)
        axes.grid(axis="y", visible=False)
        yield picture


@contextmanager
def lines_picture(
    title: str, across: str, up: str, places: Array, lines: Mapping[str, Array], *, signed: bool = False
) -> "Iterator[Figure]":
    """Draw lines over common places.

    Args:
        title: title of the picture.
        across: name of the horizontal axis, with its unit.
        up: name of the vertical axis, with its unit.
        places: places of the values, in the unit that `across` names, shape (n,).
        lines: values by the name of the line, in the unit that `up` names, shape (n,) each.
        signed: whether the values have either sign.
    """
    with figure(7.0, 3.6) as picture:
        axes = picture.subplots()
        for (name, values), color, style in zip(lines.items(), (BEFORE, AFTER, GREEN), ("-", "--", ":"), strict=False):
            axes.plot(places, values, color=color, linestyle=style, label=name)
        axes.set(title=title, xlabel=across, ylabel=up, ylim=(None if signed else 0, None))
        if len(lines) > 1:
            axes.legend(loc="best")
        yield picture
