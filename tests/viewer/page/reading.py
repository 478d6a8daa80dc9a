"""A page read back with code of its own: its tables, and its data as the script sees them."""

import base64
import gzip
import json
import re
from html.parser import HTMLParser

import numpy as np

KINDS = {"f4": "<f4", "u2": "<u2", "u4": "<u4", "i1": "<i1"}


class Tables(HTMLParser):
    """Rows of numbers of every table by the identifier of its box; None for a cell of words."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.name = {}, None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        if tag == "div" and (given.get("id") or "").startswith("table-"):
            self.name = given["id"].removeprefix("table-")
            self.rows[self.name] = []
        elif tag == "tr" and self.name:
            self.rows[self.name].append([])
        elif tag == "td" and self.name:
            value = given.get("data-value")
            self.rows[self.name][-1].append(None if value is None else float(value))

    def numbers(self, name):
        """Rows with a number in them, without their words."""
        rows = ([value for value in row if value is not None] for row in self.rows[name])
        return [row for row in rows if row]


def content(text, identifier):
    """Text of an inline element."""
    return re.search(rf'<script type="[^"]*" id="{identifier}">(.*?)</script>', text, re.DOTALL)[1]


def data(text):
    """The page's document, its arrays in place."""
    block = gzip.decompress(base64.b64decode(content(text, "block")))

    def filled(value):
        if isinstance(value, list):
            return [filled(inside) for inside in value]
        if isinstance(value, dict):
            if value.keys() == {"at", "n", "kind"}:
                return np.frombuffer(block, KINDS[value["kind"]], value["n"], value["at"])
            return {key: filled(inside) for key, inside in value.items()}
        return value

    return filled(json.loads(content(text, "data")))


def going(document, code):
    """A run by its code."""
    return next(run for run in document["scene"]["goings"] if run["code"] == code)


def at(document, run, motor):
    """Cam angle, tangent of the steering angle and share of the play at a motor position, read between the entries."""
    ahead = float(np.interp(motor, run["motor"], run["lead"]))
    theta, tables = motor + ahead, document["scene"]["lift"]
    turn = np.linspace(0.0, 2 * np.pi, len(tables["tan"]))
    tan_beta, lift = (float(np.interp(theta % (2 * np.pi), turn, tables[name])) for name in ("tan", "lift"))
    return theta, tan_beta, lift, (ahead / run["play"] if run["play"] else 0.0)
