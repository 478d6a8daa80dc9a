"""Texts of a page that its Chinese view shows in English."""

import re
from html import unescape
from html.parser import HTMLParser

# Keys, commands, names of files and designs, units, symbols: the same in every language.
SAME = re.compile(
    r"--[\w-]+(?: '?[\w.=\[\]\"+-]+'?)?|\[[\w.]+\]|[a-z_]+(?:\.[a-z_0-9]+)+|\b[a-z]+(?:_[a-z]+)+\b|cadgen(?: \w+)?|"
    r"N·mm|(?:m?m|rad)/(?:rad|s)[²³]?|MPa|"
    r"= \"[a-z_]+\"|"
    r"\b\d_\w+|\b(?:c?mm?[23²³]?|kg|min|deg|N|J|PASS|cubic|quintic|b_spline|STEP|DXF|ISO|DIN|WebGL|three\.js|uPlot)\b|[0-9a-f]{12,}|\S+\.(?:toml|csv|step|html)\b"
)
_VOID = {"meta", "input", "br", "path", "circle", "ellipse", "line", "rect", "polyline", "polygon", "link", "img", "hr"}


class _Reader(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.texts = [], []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in _VOID:
            self.open.append((tag, "data-zh" in attributes, attributes.get("lang")))
        for name in ("aria-label", "title", "placeholder"):
            if attributes.get(name) and f"data-{name.removeprefix('aria-')}-zh" not in attributes:
                self.texts.append(attributes[name])

    def handle_endtag(self, tag):
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data):
        if any(
            tag in ("script", "style", "title") or zh or (tag, lang) == ("pre", "en") for tag, zh, lang in self.open
        ):
            return
        self.texts.append(data.strip())


def left_in_english(html: str) -> list[str]:
    """Texts with a word for which the page has no Chinese, and Chinese ones with English left."""
    reader = _Reader()
    reader.feed(html)
    chinese = [unescape(text) for text in re.findall(r'data-(?:label-)?zh="([^"]*)"', html)]
    left = [text for text in reader.texts if re.search(r"[A-Za-z]{2,}", SAME.sub(" ", text))]
    return [
        *dict.fromkeys(left),
        *(text for text in dict.fromkeys(chinese) if re.search(r"[a-z]{4,}", SAME.sub(" ", text))),
    ]
