"""Docstrings of the public functions: every argument of the face, no half of a list, a unit for every quantity."""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
# Docstrings that leave their arguments to another: `Arguments and errors as in ...`, `see Evidence.halves`.
ELSEWHERE = re.compile(r"\b(?:[Aa]rguments\b.*\bas\b|[Ss]ee `|[Aa]s (?:of |in |for )?`|[Tt]he same as `)", re.S)
UNITS = (
    *(
        "mm",
        "µm",
        "um",
        "rad²?",
        "deg",
        "degrees?",
        "°",
        "s",
        "seconds",
        "rev/min",
        "N",
        "N mm",
        "N·mm",
        "Nmm",
        "J",
        "K",
        "kg",
        "%",
    ),
    *("per cent", "percent", r"mm\^-?\d", "mm²", "mm³", "inch(?:es)?", "rpm", "dots", "points per inch"),
)
# What has no unit says what it is.
PURE = (
    *(
        "shares?",
        "ratios?",
        "factors?",
        "scales?",
        "tan(?:gent)?s?",
        r"tan\(beta\w*\)",
        "parameters?",
        "numbers?",
        "counts?",
    ),
    *("orders?", "turns?", "teeth", "probabilit(?:y|ies)", "weights?", "unit", "direction", "poles?", "frictions?"),
    *("whitened", "columns?", "rows?", "dimensionless", "random"),
)
UNIT = re.compile(rf"(?<![\w'])(?:{'|'.join((*UNITS, *PURE))})(?![\w])")
NAMED = re.compile(r"_(?:mm|um|deg|s|percent|N|Nmm|J|K|kg|rpm|mb)$|^seconds$")
NUMBERS = r"(?:float|Array|ArrayLike)"
QUANTITY = re.compile(rf"{NUMBERS}(?: \| (?:{NUMBERS}|None))*")


@dataclass(frozen=True)
class Function:
    """A public function or method.

    Attributes:
        place: module, class and name.
        arguments: annotation of each, by its name.
        doc: docstring.
    """

    place: str
    arguments: dict[str, str]
    doc: str

    @property
    def listed(self) -> dict[str, str]:
        """Entries of the docstring's Args section, by argument; `x, y: ...` is an entry of both."""
        section = re.search(r"^Args:\n((?:[ ]{4}.*\n?|\n(?=[ ]{4}))*)", self.doc, re.M)
        entries = (
            re.findall(r"^ {4}([*\w]+(?:, [*\w]+)*): ((?:.*\n?)(?: {8}.*\n?)*)", section[1], re.M) if section else []
        )
        return {name.strip("* "): text for names, text in entries for name in names.split(",")}


def functions(source: str, module: str) -> Iterator[Function]:
    """Public functions of a module and public methods of its public classes."""

    def of(body: list[ast.stmt], place: str) -> Iterator[Function]:
        for node in body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                yield from of(node.body, f"{place}.{node.name}")
            elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and not node.name.startswith("_"):
                every = [
                    *node.args.posonlyargs,
                    *node.args.args,
                    *node.args.kwonlyargs,
                    node.args.vararg,
                    node.args.kwarg,
                ]
                arguments = {
                    one.arg: ast.unparse(one.annotation) if one.annotation else ""
                    for one in every
                    if one is not None and one.arg not in ("self", "cls")
                }
                yield Function(f"{place}.{node.name}", arguments, ast.get_docstring(node) or "")

    yield from of(ast.parse(source).body, module)


@cache
def every_function() -> list[Function]:
    """Functions of the package that take something; read by the tests alone, since each process collects them."""
    return [
        function
        for file in sorted((ROOT / "cadgen").rglob("*.py"))
        for function in functions(file.read_text("utf-8"), ".".join(file.relative_to(ROOT).with_suffix("").parts))
        if function.arguments
    ]


def half_listed(every: list[Function]) -> list[str]:
    """Functions whose Args section lacks an argument, or has one that is not there."""
    return [
        f"{function.place}: {sorted(function.listed.keys() ^ function.arguments.keys())}"
        for function in every
        if function.listed and function.listed.keys() != function.arguments.keys()
    ]


def without_unit(every: list[Function]) -> list[str]:
    """Quantities whose unit stands neither in their name, nor in their entry, nor in a docstring without entries."""
    return [
        f"{function.place}: {name}"
        for function in every
        for name, annotation in function.arguments.items()
        if QUANTITY.fullmatch(annotation)
        and not NAMED.search(name)
        and not UNIT.search(function.listed.get(name, "") if function.listed else function.doc)
        and not ELSEWHERE.search(function.doc)
    ]


def test_a_list_of_arguments_has_them_all() -> None:
    assert sum(bool(function.listed) for function in every_function()) > 300
    assert not half_listed(every_function()), "\n".join(half_listed(every_function()))


def without_list(every: list[Function]) -> list[str]:
    """Functions that take a quantity and have no Args section, nor leave it to another's."""
    return [
        function.place
        for function in every
        if not function.listed
        and not ELSEWHERE.search(function.doc)
        and any(QUANTITY.fullmatch(annotation) for annotation in function.arguments.values())
    ]


def test_whoever_takes_a_quantity_lists_the_arguments() -> None:
    """The commands are left out: their docstrings are their help, and each option has its own."""
    every = [function for function in every_function() if not function.place.startswith("cadgen.cli.")]
    assert sum(bool(function.listed) for function in every) > 650
    assert not without_list(every), "\n".join(without_list(every))


def test_the_face_describes_every_argument() -> None:
    face = [function for function in every_function() if function.place.startswith(("cadgen.api.", "cadgen.parts."))]
    assert len(face) > 50
    bare = [function.place for function in face if not function.listed and not ELSEWHERE.search(function.doc)]
    assert not bare, "\n".join(bare)


def test_every_quantity_has_its_unit() -> None:
    assert not without_unit(every_function()), "\n".join(without_unit(every_function()))


@pytest.mark.parametrize(
    ("text", "half", "unitless"),
    [
        ("Length of a line.", 0, 1),
        ("Length of a line from x to y, mm.", 0, 0),
        ("Length of a line.\n\nArgs:\n    x: its start, mm.\n", 1, 1),
        ("Length of a line.\n\nArgs:\n    x: its start, mm.\n    y: its end.\n", 0, 1),
        ("Length of a line.\n\nArgs:\n    x, y: its ends,\n        mm.\n", 0, 0),
        ("Length of a line.\n\nArgs:\n    x, y: its ends, mm.\n    z: gone, mm.\n", 1, 0),
    ],
)
def test_what_is_missing_is_seen(text: str, half: int, unitless: int) -> None:
    indented = text.replace("\n", "\n    ")
    (line,) = functions(f'def line(x: float, y: float) -> float:\n    """{indented}"""\n', "m")
    assert (bool(half_listed([line])), bool(without_unit([line]))) == (bool(half), bool(unitless))
    assert bool(without_list([line])) == ("Args:" not in text)


def test_a_private_thing_needs_no_list() -> None:
    assert not [*functions("def _x(a: float): pass\nclass _C:\n    def y(self, a: float): pass", "m")]
