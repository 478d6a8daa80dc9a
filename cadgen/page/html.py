"""The page as one HTML file that asks for nothing: its parts inline, and a policy that allows these by their hashes."""

import base64
import hashlib
from functools import cache
from importlib.resources import files

from cadgen.page.data import data_of
from cadgen.page.document import Failure, Page, Text
from cadgen.page.markup import english, labels, section, tag, text
from cadgen.page.views import cam_view, course_view, legend
from cadgen.page.words import say
from cadgen.version import __version__

_FOLDER = "cadgen.page"


def html_of(page: Page) -> str:
    """The whole page."""
    style, script = _static("page.css"), _static("page.js")
    document, block = data_of(page)
    policy = "; ".join(
        (
            "default-src 'none'",
            f"script-src '{_hash(script)}'",
            f"style-src '{_hash(style)}'",
            "img-src data:",
            "base-uri 'none'",
            "form-action 'none'",
        )
    )
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("meta", name="color-scheme", content="light dark"),
        tag("meta", name="generator", content=f"cadgen {__version__}"),
        tag("title", english(f"{page.name} · cadgen")),
        f"<style>{style}</style>",
    )
    body = tag(
        "body",
        tag("a", _inline(say("Skip to the checks")), href="#checks", class_="skip"),
        _header(page),
        tag("main", _top(page), _model(page), _curves(page), *map(section, page.sections), _design(page)),
        _transport(),
        f'<script type="application/json" id="data">{document}</script>',
        f'<script type="text/plain" id="block">{block}</script>',
        f"<script>{script}</script>",
    )
    return f'<!doctype html>\n<html lang="en">{head}{body}</html>\n'


@cache
def _static(name: str) -> str:
    return files(_FOLDER).joinpath("static", name).read_text(encoding="utf-8")


def _hash(content: str) -> str:
    """Hash of an inline element for the policy."""
    return "sha256-" + base64.b64encode(hashlib.sha256(content.encode()).digest()).decode("ascii")


def _inline(words: Text) -> str:
    return text(words)


def _header(page: Page) -> str:
    verdict = say("every check passes") if page.passed else say("a check fails")
    links = [("model", say("Model")), ("curves", say("Curves"))]
    links += [(item.code, item.title) for item in page.sections]  # type: ignore[misc]
    return tag(
        "header",
        tag(
            "div",
            tag("h1", tag("span", english(page.name)), " ", text(say("Steering cam"), "small")),
            tag(
                "a" if not page.passed else "span",
                _inline(verdict),
                href=None if page.passed else "#failures",
                class_=f"verdict {'good' if page.passed else 'bad'}",
            ),
            tag(
                "div",
                tag("button", "中文", type="button", id="language", aria_label="中文：切换到中文", lang="zh"),
                _button("theme", say("Light or dark"), _ICONS["theme"]),
                _button("print", say("Print"), _ICONS["print"]),
                class_="tools",
            ),
            class_="bar",
        ),
        tag("nav", *(tag("a", _inline(title), href=f"#{code}") for code, title in links), **labels(say("Report"))),
    )


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


def _model(page: Page) -> str:
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
            tag("div", cam_view(page.scene), class_="view"),
            text(say("seen from the left of the car, the front to the left"), "p", class_="hint"),
        ),
        tag(
            "figure",
            text(say("The car on its course"), "figcaption"),
            tag("div", course_view(page.scene), class_="view"),
            legend(page.scene),
        ),
    )
    notes = tag("ul", *(text(note, "li") for note in page.notes), class_="notes") if page.notes else ""
    return tag(
        "section",
        text(say("Model"), "h2", id="model-title"),
        tag("noscript", text(say("no-script"), "p", class_="lead")),
        tag("p", "", id="trouble", class_="lead", hidden=True),
        tag("div", *views, class_="views"),
        notes,
        id="model",
        aria_labelledby="model-title",
    )


def _curves(page: Page) -> str:
    boxes = (
        tag(
            "figure",
            tag("figcaption", text(chart.title, "b"), " ", tag("small", chart.unit), tag("span", "", class_="now")),
            tag("div", class_="plot"),
            id=f"chart-{chart.code}",
            class_="chart",
        )
        for chart in page.charts
    )
    return tag(
        "section",
        text(say("Curves"), "h2", id="curves-title"),
        tag("div", *boxes, class_="charts"),
        id="curves",
        aria_labelledby="curves-title",
    )


def _design(page: Page) -> str:
    rows = (tag("div", text(name, "dt"), tag("dd", _inline(value))) for name, value in page.origin)
    licences = tag(
        "details", text(say("Licences"), "summary"), tag("pre", _escaped(_static("LICENSES.txt")), lang="en")
    )
    return tag(
        "section",
        text(say("Design"), "h2", id="design-title"),
        tag("dl", *rows, class_="origin"),
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
