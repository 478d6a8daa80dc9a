"""One page of the Python reference for each room of the package, written when the site is built.

`cadgen.api`, the face of the package, comes first, then the rooms whose functions the theory names; each page has every
public name of the room's modules, and a new module appears by itself. Docstrings are written as plain text with tables
and formulas indented; here they become what Sphinx reads.
"""

import re
from pathlib import Path
from pkgutil import iter_modules
from typing import Any

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx

import cadgen
from cadgen.messages import CHINESE, ENGLISH
from docs import public_names

FOLDER = "reference/python"
_ROOMS, _NAMES = "<!-- rooms -->", "<!-- public names -->"
_ARRAY = re.compile(r"~?numpy\.ndarray\[tuple\[~?typing\.Any, \.\.\.\], ~?numpy\.dtype\[~?numpy\.float64\]\]")
ROOMS = ("api", "cam", "gears", "car.path", "car.steering", "car.running")


def modules(room: str) -> list[str]:
    """List a room's modules, the room itself first; none for a room that the package does not have."""
    folder = Path(cadgen.__path__[0], *room.split("."))
    if not (folder.is_dir() or folder.with_suffix(".py").is_file()):
        return []
    inside = iter_modules([str(folder)])
    return [f"cadgen.{room}", *(f"cadgen.{room}.{module.name}" for module in inside)]


def write_pages(app: Sphinx) -> None:
    """Write the pages, and take away those of rooms that are gone; a page that is as it was keeps its date."""
    folder = Path(app.srcdir, FOLDER)
    folder.mkdir(parents=True, exist_ok=True)
    rooms = [room for room in ROOMS if modules(room)]
    pages = {f"{room}.rst": _page(room, modules(room)) for room in rooms}
    for old in folder.iterdir():
        if old.name not in pages:
            old.unlink()
    for name, text in pages.items():
        page = folder / name
        if not page.exists() or page.read_text(encoding="utf-8") != text:
            page.write_text(text, encoding="utf-8")


def _page(room: str, names: list[str]) -> str:
    title = f"cadgen.{room}"
    lines = [title, "=" * len(title), ""]
    for module in names:
        if module != title:
            lines += [module, "-" * len(module), ""]
        lines += [f".. automodule:: {module}", "   :members:", ""]
    return "\n".join(lines)


def fill(app: Sphinx, page: str, source: list[str]) -> None:
    """Put rooms and public names where a page has the marks; the tree of the site has the rooms once, in English."""
    rooms = [room for room in ROOMS if modules(room)]
    if page.endswith(".zh-CN"):
        language, listed = CHINESE, [f"- {{doc}}`cadgen.{room} <python/{room}>`" for room in rooms]
    else:
        language, listed = ENGLISH, ["```{toctree}", ":maxdepth: 1", *(f"python/{room}" for room in rooms), "```"]
    for mark, text in ((_ROOMS, lambda: "\n".join(listed)), (_NAMES, lambda: public_names.page(language))):
        if mark in source[0]:
            source[0] = source[0].replace(mark, text())


def as_rst(app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Turn the tables and indented formulas of a docstring into reStructuredText, in place."""
    out: list[str] = []
    for number, line in enumerate(lines):
        before = lines[number - 1] if number else ""
        if line.startswith("|") and line.rstrip().endswith("|"):
            if not before.startswith("|"):
                out += ["", ".. list-table::", "   :header-rows: 1", ""]
            if not re.fullmatch(r"[|\s:-]+", line):
                cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
                out += [f"   {'* -' if column == 0 else '  -'} {cell}" for column, cell in enumerate(cells)]
            continue
        if before.startswith("|"):
            out.append("")
        out.append(line)
    lines[:] = [re.sub(r"\|(?=\S)", r"\\|", line) for line in _formulas(out)]


def _formulas(lines: list[str]) -> list[str]:
    """Mark text that is indented by four under a plain sentence as a literal block."""
    out: list[str] = []
    inside = False
    for number, line in enumerate(lines):
        before = lines[number - 1] if number else ""
        formula = line.startswith("    ") and not line.lstrip().startswith((":", "*", "-", ".."))
        if formula and not inside and not before.startswith((" ", ":", "..")):
            if before.strip():
                out.append("")
            out += ["::", ""]
            inside = True
        elif inside and line.strip() and not line.startswith("    "):
            if before.strip():
                out.append("")
            inside = False
        out.append(line)
    return out


def shorten(app: Sphinx, what: str, name: str, thing: Any, options: Any, signature: str, returns: str) -> Any:
    """Write `Array` for an array of floats, as the code does."""
    return tuple(text and _ARRAY.sub("Array", text) for text in (signature, returns))


def link_names(app: Sphinx, tree: nodes.document) -> None:
    """Link every full name of ours in a page to the reference, such as `cadgen.cam.checks.check_cam`."""
    for literal in list(tree.findall(nodes.literal)):
        name = literal.astext()
        if re.fullmatch(r"cadgen(\.\w+)+", name) and not isinstance(literal.parent, (pending_xref, nodes.reference)):
            link = pending_xref(
                "",
                refdomain="py",
                reftype="obj",
                reftarget=name,
                refexplicit=True,
                refdoc=app.env.docname,
                refwarn=False,
            )
            literal.replace_self(link)
            link += literal


_STUDY = re.compile(r"\[([^\]]+)\]\((?:\.\./)+(studies/\w+\.md)\)")


def name_studies(app: Sphinx, page: str, source: list[str]) -> None:
    """Name a study by its file in the repository, where a page links it: studies are no pages of the site."""
    source[0] = _STUDY.sub(r"\1 (`\2`)", source[0])


_BROKEN = re.compile(r"(?<=[\u3001-\u9fff\uff01-\uff60])\n(?=[\u3001-\u9fff\uff01-\uff60])")


def join_lines(app: Sphinx, page: str, source: list[str]) -> None:
    """Join lines that end and begin with Chinese: a browser would show a space where they are broken."""
    source[0] = _BROKEN.sub("", source[0])


def setup(app: Sphinx) -> dict[str, bool]:
    """Have the pages written before the sources are read, and docstrings turned when they are."""
    app.connect("builder-inited", write_pages)
    app.connect("source-read", fill)
    app.connect("source-read", name_studies)
    app.connect("source-read", join_lines)
    app.connect("autodoc-process-docstring", as_rst, priority=900)
    app.connect("autodoc-process-signature", shorten)
    app.connect("doctree-read", link_names)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
