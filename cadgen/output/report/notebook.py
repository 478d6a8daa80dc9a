"""Results in a notebook: a line, the figures, and the picture."""

from abc import abstractmethod
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from html import escape
from io import StringIO
from typing import TYPE_CHECKING

from cadgen.arrays import Array
from cadgen.errors import CadgenError
from cadgen.figures import JobResult, rounded
from cadgen.output.report.style import AFTER, BEFORE, GREEN, Drawing, figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_MOST_ROWS = 16
_LONGEST = 60  # characters of a text that stands among the figures


class Pictured(JobResult):
    """Base of a result with a picture, which a notebook shows below its figures."""

    @property
    @abstractmethod
    def picture(self) -> Drawing:
        """Picture of the result, drawn when it is entered."""

    def plot(self) -> "Figure":
        """Draw the result.

        Returns:
            A matplotlib figure, to be shown in a notebook or saved with `savefig`.
        """
        with self.picture as drawn:
            return drawn

    def _repr_html_(self) -> str:
        said = {
            name: rounded(value) if isinstance(value, float) else str(value)
            for name, value in self.facts().items()
            if isinstance(value, int | float | str) and 0 < len(str(value)) <= _LONGEST
        }
        rows = [f"<tr><td>{escape(name)}</td><td>{escape(text)}</td></tr>" for name, text in said.items()][:_MOST_ROWS]
        drawn = StringIO()
        try:
            with self.picture as picture:
                picture.savefig(drawn, format="svg", metadata={"Date": None, "Creator": None})
        except CadgenError as error:  # such as of a plan without a path
            drawn.write(f"<p>{escape(error.message)}</p>")
        shown = drawn.getvalue()
        return f"<p><code>{escape(repr(self))}</code></p><table>{''.join(rows)}</table>{shown[shown.find('<svg') :]}"


@contextmanager
def lines_picture(title: str, across: str, up: str, places: Array, lines: Mapping[str, Array]) -> "Iterator[Figure]":
    """Draw lines over common places.

    Args:
        title: title of the picture.
        across: name of the horizontal axis, with its unit.
        up: name of the vertical axis, with its unit.
        places: places of the values, in the unit that `across` names, shape (n,).
        lines: values by the name of the line, in the unit that `up` names, shape (n,) each.
    """
    with figure(7.0, 3.6) as picture:
        axes = picture.subplots()
        for (name, values), color, style in zip(lines.items(), (BEFORE, AFTER, GREEN), ("-", "--", ":"), strict=False):
            axes.plot(places, values, color=color, linestyle=style, label=name)
        axes.set(title=title, xlabel=across, ylabel=up, ylim=(0, None))
        axes.legend(loc="best")
        yield picture
