"""The page as one HTML file that asks for nothing: its parts inline, allowed by their hashes.

`templates/page.html` is the page around its pieces, `templates/pieces.html` holds these. Their line ends and
indentation are taken out, so that the page has none where a browser would show a gap.
"""

import base64
import hashlib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from importlib.resources import files
from math import isfinite
from typing import NamedTuple

import numpy as np
from jinja2 import Environment, FunctionLoader, StrictUndefined
from markupsafe import Markup, escape

from cadgen.figures import Sheet, rounded
from cadgen.messages import CHINESE, Message, catalogue, language, shown
from cadgen.version import __version__
from cadgen.viewer.page.data import data_of
from cadgen.viewer.page.document import Chart, FloorShape, Page
from cadgen.viewer.page.plan_views import cam_view, coordinate, course_view, train_view

_FOLDER = files("cadgen.viewer.page")
_THINNED = 4  # of the points of a curve, one in so many is drawn without scripts
_FILES = {False: ("page",), True: ("page", "edit")}  # of script and style, by whether the design can be edited

NO_SCRIPT = Message(
    "Scripts are off: the model stands still at cam angle 0, and the assembly in 3D is left out. All tables are below."
)
EDITING_NEEDS_SCRIPTS = Message("Editing needs scripts: allow them for this address.")


def html_of(page: Page) -> str:
    """The whole page of a report."""
    document, block = data_of(page)
    data = Markup(
        f'<script type="application/json" id="data">{document}</script>'
        f'<script type="text/plain" id="block">{block}</script>'
    )
    return shell(page.name, pieces_of(page), data, car=page.scene.car is not None, train=bool(page.scene.wheels))


def pieces_of(page: Page) -> dict[str, Markup]:
    """Everything on the page that depends on its content, by the id of the element that it fills."""
    return {
        **{code: _piece(code, page) for code in ("verdict", "links", "top", "notes", "charts", "tables", "origin")},
        "cam-box": _piece("train", train_view(page.scene))
        if page.scene.wheels
        else _piece("cam", cam_view(page.scene)),
        "cam-legend": _piece("cam_legend", page.scene),
        "course-box": _piece("course", course_view(page.scene.floor, page.scene.goings, page.scene.car)),
        "legend": _piece("legend", page.scene.goings),
    }


def floor_html(floor: Sequence[FloorShape], points: Sequence[tuple[float, float]]) -> Markup:
    """The floor from above, of a design that cannot be driven.

    Args:
        floor: what stands or lies on it.
        points: further places to have in the picture, mm.
    """
    return _piece("course", course_view(floor, points=points))


def table_html(sheet: Sheet) -> Markup:
    """A sheet as a table."""
    return _piece("table", sheet)


def shell(
    name: str,
    pieces: Mapping[str, str],
    data: str = "",
    *,
    edited: bool = False,
    car: bool = True,
    train: bool = False,
) -> str:
    """The page around its content.

    Args:
        name: name of the design.
        pieces: content by the id of the element that it fills; what is missing stays empty.
        data: HTML with the data of the script.
        edited: whether the design can be edited: the page then has a second script, which asks its own server.
        car: whether there is a car that the cam steers.
        train: whether there are gears without a cam.
    """
    codes = (
        "verdict",
        "links",
        "top",
        "cam-box",
        "cam-legend",
        "course-box",
        "legend",
        "notes",
        "charts",
        "tables",
        "origin",
    )
    return (
        _templates()
        .get_template("page.html")
        .render(
            name=name,
            pieces={code: pieces.get(code, "") for code in codes},
            data=data,
            edited=edited,
            car=car,
            train=train,
            policy=policy(edited=edited),
            styles=[Markup(_static(f"{file}.css")) for file in _FILES[edited]],
            scripts=[Markup(_static(f"{file}.js")) for file in _FILES[edited]],
            licences=_static("LICENSES.txt"),
            words=_words(),
            language=language(),
            version=__version__,
            no_script=NO_SCRIPT,
            editing_needs_scripts=EDITING_NEEDS_SCRIPTS,
        )
    )


def policy(*, edited: bool = False) -> str:
    """Content security policy: own inline parts by their hashes, and nothing else.

    Args:
        edited: whether the page may ask its own server.
    """
    return "; ".join(
        (
            "default-src 'none'",
            " ".join(["script-src", *(f"'{_hash(_static(f'{name}.js'))}'" for name in _FILES[edited])]),
            " ".join(["style-src", *(f"'{_hash(_static(f'{name}.css'))}'" for name in _FILES[edited])]),
            "img-src data:",
            *(["connect-src 'self'"] if edited else []),
            "base-uri 'none'",
            "form-action 'none'",
        )
    )


@cache
def _static(name: str) -> str:
    return _FOLDER.joinpath("static", name).read_text(encoding="utf-8")


@cache
def _words() -> Markup:
    """Chinese of the scripts' own words, as JSON that can stand in HTML."""
    text = json.dumps(
        {**catalogue(CHINESE, "common"), **catalogue(CHINESE, "script")}, ensure_ascii=False, separators=(",", ":")
    )
    return Markup(text.replace("<", "\\u003c"))


def _hash(content: str) -> str:
    """Hash of an inline element for the policy."""
    return "sha256-" + base64.b64encode(hashlib.sha256(content.encode()).digest()).decode("ascii")


@cache
def _templates() -> Environment:
    def source(name: str) -> str:
        # Without line ends and the indentation behind them.
        return re.sub(r"\n *", "", _FOLDER.joinpath("templates", name).read_text(encoding="utf-8"))

    def said(text: str) -> Markup:
        # The page's script shows the other language.
        return Markup("<span{}>{}</span>").format(chinese, text) if (chinese := _zh(text)) else escape(text)

    def labels(text: str) -> Markup:
        # Attributes of an element's label in both languages.
        return Markup(' aria-label="{}" data-label-zh="{}"').format(text, shown(text, CHINESE))

    made = Environment(loader=FunctionLoader(source), autoescape=True, undefined=StrictUndefined)
    made.globals.update(
        _=Message, said=said, zh=_zh, labels=labels, n=coordinate, points=_points, plotted=_plotted, rounded=_three
    )
    return made


def _piece(name: str, content: object) -> Markup:
    """Content laid out by a macro of `templates/pieces.html`."""
    return Markup(getattr(_templates().get_template("pieces.html").module, name)(content))


def _zh(text: str) -> Markup:
    """Attribute of an element's text in Chinese; nothing where it is the same."""
    chinese = shown(text, CHINESE)
    return Markup("") if chinese == text else Markup(' data-zh="{}"').format(chinese)


class Plot(NamedTuple):
    """Curves of a chart in a frame of 360 by 120 for readers without scripts, as text of SVG.

    Attributes:
        lines: points of each curve.
        up: places of the ticks at least value, zero and greatest value, each with its text.
        across: places of the ticks by the cam angle.
    """

    lines: tuple[str, ...]
    up: tuple[tuple[str, str], ...]
    across: tuple[tuple[str, str], ...]


def _plotted(chart: Chart) -> Plot:
    values = [curve.values[::_THINNED] for curve in chart.curves]
    low = min(0.0, *(float(np.nanmin(one)) for one in values))
    high = max(0.0, *(float(np.nanmax(one)) for one in values))
    scale = 120 / ((high - low) or 1.0)
    angle = np.degrees(chart.angle[::_THINNED])
    lines = tuple(
        _points((x, y) for x, y in zip(angle.tolist(), ((high - one) * scale).tolist(), strict=True) if isfinite(y))
        for one in values
    )
    up = tuple((coordinate((high - value) * scale), f"{value:.4g}") for value in sorted({low, 0.0, high}))
    return Plot(lines, up, tuple((str(place), f"{place}°") for place in range(0, 361, 60)))


def _three(value: float, digits: int | None = None) -> str:
    """Figure of a bar: three digits that count, or so many decimals."""
    return rounded(round(value, digits) + 0.0, digits) if digits is not None else f"{value:.3g}"


def _points(points: Iterable[Iterable[float]]) -> str:
    return " ".join(f"{coordinate(x)},{coordinate(y)}" for x, y in points)
