"""The page as one HTML file that asks for nothing: its parts inline, and a policy that allows these by their hashes."""

import base64
import hashlib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files

from cadgen.version import __version__
from cadgen.viewer.page.data import data_of
from cadgen.viewer.page.document import Failure, Page, Text
from cadgen.viewer.page.markup import english, labels, section, tag, text
from cadgen.viewer.page.views import cam_view, course_view, legend
from cadgen.viewer.page.words import say

_FOLDER = "cadgen.viewer.page"


def html_of(page: Page) -> str:
    """The whole page of a report."""
    document, block = data_of(page)
    data = (
        f'<script type="application/json" id="data">{document}</script>'
        f'<script type="text/plain" id="block">{block}</script>'
    )
    return shell(page.name, pieces_of(page), data)


def pieces_of(page: Page) -> dict[str, str]:
    """Everything on the page that depends on its content, by the id of the element that it fills."""
    return {
        "verdict": _verdict(page),
        "links": _links(page),
        "top": _top(page),
        "cam-box": cam_view(page.scene),
        "course-box": course_view(page.scene.floor, page.scene.goings, page.scene.car),
        "legend": legend(page.scene.goings),
        "notes": _notes(page),
        "charts": _charts(page),
        "tables": "".join(map(section, page.sections)),
        "origin": _origin(page),
    }


def shell(name: str, pieces: Mapping[str, str], data: str = "", *, aside: str = "", edited: bool = False) -> str:
    """The page around its content.

    Args:
        name: name of the design.
        pieces: content by the id of the element that it fills; what is missing stays empty.
        data: HTML with the data of the script.
        aside: HTML beside the content.
        edited: whether the design can be edited: the page then has a second script, which asks its own server.
    """
    names = ("page", "edit") if edited else ("page",)
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy(edited=edited)),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("meta", name="generator", content=f"cadgen {__version__}"),
        tag("title", english(f"{name} · cadgen")),
        *(f"<style>{_static(f'{file}.css')}</style>" for file in names),
    )
    shown = _filled("top", pieces) + _model(pieces) + _curves(pieces) + _filled("tables", pieces) + _design(pieces)
    body = tag(
        "body",
        tag("a", _inline(say("Skip to the checks")), href="#checks", class_="skip"),
        _header(name, pieces),
        tag("main", aside, tag("div", shown, id="shown")) if aside else tag("main", shown),
        _transport(),
        data,
        *(f"<script>{_static(f'{file}.js')}</script>" for file in names),
        class_="editing" if edited else None,
    )
    return f'<!doctype html>\n<html lang="en">{head}{body}</html>\n'


def policy(*, edited: bool = False) -> str:
    """Content security policy: own inline parts by their hashes, and nothing else.

    Args:
        edited: whether the page may ask its own server.
    """
    names = ("page", "edit") if edited else ("page",)
    return "; ".join(
        (
            "default-src 'none'",
            " ".join(["script-src", *(f"'{_hash(_static(f'{name}.js'))}'" for name in names)]),
            " ".join(["style-src", *(f"'{_hash(_static(f'{name}.css'))}'" for name in names)]),
            "img-src data:",
            *(["connect-src 'self'"] if edited else []),
            "base-uri 'none'",
            "form-action 'none'",
        )
    )


def _filled(code: str, pieces: Mapping[str, str], element: str = "div", **attributes: str | None) -> str:
    return tag(element, pieces.get(code, ""), id=code, **attributes)


@cache
def _static(name: str) -> str:
    return files(_FOLDER).joinpath("static", name).read_text(encoding="utf-8")


def _hash(content: str) -> str:
    """Hash of an inline element for the policy."""
    return "sha256-" + base64.b64encode(hashlib.sha256(content.encode()).digest()).decode("ascii")


def _inline(words: Text) -> str:
    return text(words)


def _header(name: str, pieces: Mapping[str, str]) -> str:
    return tag(
        "header",
        tag(
            "div",
            tag("h1", tag("span", english(name)), " ", text(say("Steering cam"), "small")),
            _filled("verdict", pieces),
            tag(
                "div",
                tag("button", "中文", type="button", id="language", aria_label="中文：切换到中文", lang="zh"),
                _button("theme", say("Light or dark"), _ICONS["theme"]),
                _button("print", say("Print"), _ICONS["print"]),
                class_="tools",
            ),
            class_="bar",
        ),
        _filled("links", pieces, "nav", **labels(say("Report"))),
    )


def _verdict(page: Page) -> str:
    # A design whose checks all pass has failures, too, if a measured file cannot be read.
    words = say("every check passes") if page.passed else say("see what fails")
    return tag(
        "span" if page.passed else "a",
        _inline(words),
        href=None if page.passed else "#failures",
        class_=f"verdict {'good' if page.passed else 'bad'}",
    )


def _links(page: Page) -> str:
    links: list[tuple[str, Text]] = [("model", say("Model")), ("curves", say("Curves"))]
    links += [(item.code, item.title) for item in page.sections]
    return "".join(tag("a", _inline(title), href=f"#{code}") for code, title in links)


# Drawn on 24 by 24.
_ICONS = {
    "theme": "M12 3a9 9 0 1 0 0 18V3z",
    "print": "M7 3h10v5H7zM4 9h16v8h-3v4H7v-4H4zm5 6v4h6v-4z",
    "play": "M7 4l13 8-13 8z",
}


def _button(code: str, label: Text, path: str, *, pressed: bool | None = None) -> str:
    icon = tag("svg", tag("path", d=path), viewBox="0 0 24 24", aria_hidden="true")
    state = None if pressed is None else str(pressed).lower()
    return tag("button", icon, type="button", id=code, aria_pressed=state, **labels(label))


def _top(page: Page) -> str:
    tiles = (
        tag(
            "div",
            text(name, "dt"),
            tag(
                "dd",
                _inline(cell.text),
                *([" ", tag("small", cell.unit)] if cell.unit else []),
                class_=cell.state or None,
            ),
        )
        for name, cell in page.summary
    )
    failures = ""
    if page.failures:
        failures = tag(
            "section",
            text(say("What fails"), "h2", id="failures-title"),
            tag("ul", *map(_failure, page.failures)),
            id="failures",
            aria_labelledby="failures-title",
        )
    return failures + tag("dl", *tiles, class_="tiles")


def _failure(failure: Failure) -> str:
    advice = tag("p", _inline(failure.advice)) if failure.advice else ""
    return tag("li", text(failure.what, "strong"), advice)


def _model(pieces: Mapping[str, str]) -> str:
    """The three views side by side."""
    views = (
        tag(
            "figure",
            text(say("Assembly in 3D"), "figcaption"),
            tag("div", id="scene", class_="view"),
            id="assembly",
        ),
        tag(
            "figure",
            text(say("Cam and follower"), "figcaption"),
            _filled("cam-box", pieces, class_="view"),
            text(say("seen from the left of the car, the front to the left"), "p", class_="hint"),
        ),
        tag(
            "figure",
            text(say("The car on its course"), "figcaption"),
            _filled("course-box", pieces, class_="view"),
            _filled("legend", pieces, "ul", class_="legend"),
            id="course-figure",
        ),
    )
    return tag(
        "section",
        text(say("Model"), "h2", id="model-title"),
        tag("noscript", text(say("no-script"), "p", class_="lead")),
        tag("p", "", id="trouble", class_="lead", hidden=True),
        tag("div", *views, class_="views"),
        _filled("notes", pieces, "ul", class_="notes"),
        id="model",
        aria_labelledby="model-title",
    )


def _notes(page: Page) -> str:
    return "".join(text(note, "li") for note in page.notes)


def _charts(page: Page) -> str:
    return "".join(
        tag(
            "figure",
            tag("figcaption", text(chart.title, "b"), " ", tag("small", chart.unit), tag("span", "", class_="now")),
            tag("div", class_="plot"),
            id=f"chart-{chart.code}",
            class_="chart",
        )
        for chart in page.charts
    )


def _curves(pieces: Mapping[str, str]) -> str:
    return tag(
        "section",
        text(say("Curves"), "h2", id="curves-title"),
        _filled("charts", pieces, class_="charts"),
        id="curves",
        aria_labelledby="curves-title",
    )


def _origin(page: Page) -> str:
    return "".join(tag("div", text(name, "dt"), tag("dd", _inline(value))) for name, value in page.origin)


def _design(pieces: Mapping[str, str]) -> str:
    licences = tag(
        "details", text(say("Licences"), "summary"), tag("pre", _escaped(_static("LICENSES.txt")), lang="en")
    )
    return tag(
        "section",
        text(say("Design"), "h2", id="design-title"),
        _filled("origin", pieces, "dl", class_="origin"),
        licences,
        id="design",
        aria_labelledby="design-title",
    )


def _escaped(content: str) -> str:
    return content.replace("&", "&amp;").replace("<", "&lt;")


def _transport() -> str:
    """The slider with its button and read-outs; the script fills it."""
    slider = tag(
        "input", type="range", id="angle", min=0, max=360, step=0.1, value=0, **labels(say("cam angle at the slider"))
    )
    return tag(
        "div",
        _button("go", say("Play or pause"), _ICONS["play"], pressed=False),
        tag("div", slider, tag("div", id="marks", aria_hidden="true"), class_="track"),
        tag("output", "0.0°", id="angle-now", for_="angle"),
        tag("div", id="options"),
        tag("div", id="now", aria_hidden="true"),
        tag("div", id="live", class_="quiet", role="status", aria_live="polite"),
        id="transport",
        role="region",
        hidden=True,
        **labels(say("Playback")),
    )
