"""Texts of the package and what each language lacks: `python -m tests.catalogue zh` prints entries to be filled in."""

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import polib

PACKAGE = Path(__file__).parents[1] / "cadgen"


def is_text(call: ast.Call) -> bool:
    """Whether a call makes a message: `Message("...")` or an error with arguments."""
    name = call.func.id if isinstance(call.func, ast.Name) else getattr(call.func, "attr", "")
    return name == "Message" or (name.endswith("Error") and any(key.arg for key in call.keywords))


def templates(source: str) -> Iterator[str]:
    """Templates of the messages that a module makes."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and node.args and is_text(node):
            for inner in ast.walk(node.args[0]) if isinstance(node.args[0], ast.IfExp) else [node.args[0]]:
                if isinstance(inner, ast.Constant) and isinstance(inner.value, str):
                    yield inner.value


def used() -> dict[str, str]:
    """Every template of the package, with a file that has it; those of the page's HTML among them."""
    found = [(file, templates(file.read_text("utf-8"))) for file in sorted(PACKAGE.rglob("*.py"))]
    found += [
        (file, re.findall(r'\b_\("([^"]+)"\)', file.read_text("utf-8"))) for file in sorted(PACKAGE.rglob("*.html"))
    ]
    return {template: str(file.relative_to(PACKAGE)) for file, texts in found for template in texts}


def entries(language: str) -> list[polib.POEntry]:
    """All entries of a language's catalogues."""
    files = sorted((PACKAGE / "locale" / language).glob("*.po"))
    return [entry for file in files for entry in polib.pofile(str(file))]


def fields(template: str) -> set[str]:
    """Names of the fields of a template."""
    return {name for _, name, _, _ in Formatter().parse(template) if name is not None}


if __name__ == "__main__":
    known = {entry.msgid for entry in entries(sys.argv[1])}
    for template, file in used().items():
        if template not in known and (not sys.argv[2:] or file.startswith(sys.argv[2])):
            print(f"# {file}\n{polib.POEntry(msgid=template)}")
