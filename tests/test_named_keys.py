"""Every key of the design file that a message or a page names is one: nobody is sent to a key that is not there."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from cadgen.cam.followers import table
from cadgen.car.path.path_kinds import codes, kind_of
from cadgen.design.keys import tables
from cadgen.design.kinds import Kinds

ROOT = Path(__file__).parents[1]
# Notebooks name attributes of objects that are called as sections are.
PAGES = [
    ROOT / "README.md",
    *(page for page in sorted((ROOT / "docs").rglob("*.md")) if page.parent.name != "notebooks"),
]
# Words joined by dots, the last one whole: not the name of a file, a path, a call or the beginning of something longer.
DOTTED = re.compile(r"(?<![\w./-])([a-z_]+(?:\.[A-Za-z_]\w*)+)(?![\w{(/-])")
FILES = (".csv", ".dxf", ".md", ".nc", ".png", ".py", ".step", ".stl", ".toml", ".xyz")
OTHERS = {
    "path.simplify_threshold": "a setting of matplotlib",
    "cam.failed": "an attribute of the Python face",
    "motion.drive.driven": "a function",
    "motion.kinks": "an attribute of a motion",
    "motion.stations": "an attribute of a motion",
}
FOLLOWERS = [Kinds(follower=table.kind_of(code), motion=True) for code in table.codes()]
PATHS = [*(Kinds(path=kind_of(code)) for code in codes()), *FOLLOWERS]
TABLES = [section for kinds in PATHS for section in tables(kinds).values()]
NAMES = {name for section in TABLES for name in (section.name, *(key.name for key in section.keys))}
SECTIONS = {name.partition(".")[0] for name in tables()} - {""}


def sentences(source: str) -> Iterator[str]:
    """String literals of a module that are no docstrings; what an f-string puts in becomes a brace."""
    tree = ast.parse(source)
    apart: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and isinstance(node.body[0], ast.Expr):
            apart.add(id(node.body[0].value))
        elif isinstance(node, ast.JoinedStr):
            apart |= {id(part) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield "".join(str(part.value) if isinstance(part, ast.Constant) else "{" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in apart:
            yield node.value


def named(text: str) -> set[str]:
    """Words of a text that look like keys of the design file."""
    found = DOTTED.findall(text)
    return {name for name in found if name.partition(".")[0] in SECTIONS and not name.endswith(FILES)} - set(OTHERS)


@pytest.mark.parametrize("where", ["cadgen", "docs"])
def test_keys_named_in_messages_and_pages_exist(where):
    if where == "docs":
        texts = {page: [page.read_text("utf-8")] for page in PAGES}
    else:
        texts = {file: list(sentences(file.read_text("utf-8"))) for file in sorted((ROOT / "cadgen").rglob("*.py"))}
    keys = {(file.name, name) for file, parts in texts.items() for text in parts for name in named(text)}
    print(f"{len(keys)} keys named in {where}")
    assert len(keys) > 50
    assert not sorted(pair for pair in keys if pair[1] not in NAMES)


def test_a_key_that_is_none_is_seen():
    source = '"""cam.no_docs_mm"""\nraise ValueError(f"cam.thick_mm is {x}; see path.{y} and --set blank.hub.x_mm={z}")'
    assert {name for text in sentences(source) for name in named(text)} == {"cam.thick_mm", "blank.hub.x_mm"}
    assert not {"cam.thick_mm", "blank.hub.x_mm"} & NAMES
    assert not named("cadgen.cam.lift, docs/play.md, cam.lift(3), cam.csv")


def test_every_exception_is_still_needed():
    texts = [page.read_text("utf-8") for page in PAGES]
    texts += [file.read_text("utf-8") for file in (ROOT / "cadgen").rglob("*.py")]
    for name in OTHERS:
        assert any(name in text for text in texts)
        assert name not in NAMES
