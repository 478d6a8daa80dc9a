"""The house itself: who imports whom, and which strings stand for what."""

import ast
import re
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[1]
MODULES = {
    ".".join(file.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): file
    for file in sorted((ROOT / "cadgen").rglob("*.py"))
}


parsed = cache(ast.parse)  # several tests read the whole package


@cache
def nodes(source: str) -> tuple[ast.AST, ...]:
    """Nodes of the tree of a module."""
    return tuple(ast.walk(parsed(source)))


def imported(name: str, source: str, modules: dict[str, Path] | set[str]) -> Iterator[str]:
    """Modules of the program that a module imports anywhere: at its top, in functions, and for types alone."""
    for node in nodes(source):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in modules)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            if node.level:
                raise AssertionError(f"{name} imports by dots: write the whole name")
            for alias in node.names:
                whole = f"{base}.{alias.name}"
                if whole in modules:
                    yield whole
                elif base in modules:
                    yield base


def circle(graph: dict[str, set[str]]) -> list[str]:
    """A way from some module back to itself; empty if there is none."""
    done: set[str] = set()

    def from_here(name: str, way: list[str]) -> list[str]:
        if name in way:
            return [*way[way.index(name) :], name]
        if name in done:
            return []
        for other in sorted(graph[name]):
            if found := from_here(other, [*way, name]):
                return found
        done.add(name)
        return []

    return next((found for name in graph if (found := from_here(name, []))), [])


def test_no_module_imports_itself_by_way_of_others():
    graph = {name: set(imported(name, file.read_text("utf-8"), MODULES)) for name, file in MODULES.items()}
    edges = sum(map(len, graph.values()))
    print(f"{len(graph)} modules, {edges} imports")
    assert edges > len(graph)
    assert not circle(graph), " -> ".join(circle(graph))


def test_a_circle_is_seen_wherever_it_hides():
    sources = {
        "a": "from b import x",
        "b": "def f():\n    from c.d import y",
        "c": "",
        "c.d": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import a",
    }
    graph = {name: set(imported(name, source, set(sources))) for name, source in sources.items()}
    assert circle(graph) == ["a", "b", "c.d", "a"]
    assert not circle({**graph, "c.d": set()})


SAME_LINES = 6


def room_of(name: str) -> str:
    """The folder, or the file on the ground, that a module belongs to."""
    return name.split(".")[1] if "." in name else ""


def test_no_room_imports_what_another_keeps_to_itself():
    private = [
        f"{name}: {node.module}.{alias.name}"
        for name, file in MODULES.items()
        for node in nodes(file.read_text("utf-8"))
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("cadgen")
        for alias in node.names
        if alias.name.startswith("_") and alias.name != "__version__" and room_of(node.module or "") != room_of(name)
    ]
    assert not private


def statements(source: str) -> list[tuple[int, str]]:
    """Lines of statements with their numbers: without imports, signatures, decorators, fields, texts and brackets."""
    left_out: set[int] = set()
    for node in nodes(source):
        last = getattr(node, "end_lineno", 0)
        if isinstance(node, ast.Import | ast.ImportFrom) or (
            isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        ):
            left_out |= set(range(node.lineno, last + 1))
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            first = min([node.lineno, *(mark.lineno for mark in node.decorator_list)])
            left_out |= set(range(first, node.body[0].lineno))
        elif isinstance(node, ast.AnnAssign):
            left_out |= set(range(node.lineno, last + 1))
    lines = ((number, line.strip()) for number, line in enumerate(source.splitlines(), 1))
    return [(n, line) for n, line in lines if n not in left_out and line.strip("()[]{},") and not line.startswith("#")]


def test_nothing_is_written_twice():
    seen: dict[tuple[str, ...], str] = {}
    twice = []
    for name, file in MODULES.items():
        lines = statements(file.read_text("utf-8"))
        for at in range(len(lines) - SAME_LINES + 1):
            block = tuple(line for _, line in lines[at : at + SAME_LINES])
            place = f"{name}:{lines[at][0]}"
            if seen.setdefault(block, place) != place:
                twice.append(f"{seen[block]} = {place}: {block[0]}")
    assert not twice, "\n".join(twice)


def listed(docstring: str) -> set[str]:
    """First column of the table in a package's docstring."""
    rows = (line.split("|")[1].strip() for line in docstring.splitlines() if line.startswith("| `"))
    return {name.strip("` ") for row in rows for name in row.split(",")}


def test_the_maps_name_every_room_and_every_module():
    missing = {}
    for name, file in MODULES.items():
        if file.name != "__init__.py":
            continue
        inside = {other.removeprefix(f"{name}.").split(".")[0] for other in MODULES if other.startswith(f"{name}.")}
        inside -= {"__main__"}
        named = listed(ast.get_docstring(parsed(file.read_text("utf-8"))) or "")
        if named != inside:
            missing[name] = {"missing": sorted(inside - named), "gone": sorted(named - inside)}
    assert not missing, missing


def docstrings(source: str) -> Iterator[str]:
    """Docstrings of a module, its classes and functions."""
    kinds = ast.Module | ast.ClassDef | ast.FunctionDef
    yield from (doc for node in nodes(source) if isinstance(node, kinds) and (doc := ast.get_docstring(node)))


def test_docstrings_name_what_they_describe():
    """`Play of a train`, and not `What a train has of play`."""
    files = [file for folder in ("cadgen", "tests", "benchmarks", "docs") for file in (ROOT / folder).rglob("*.py")]
    maybe = {file: text for file in files if re.search(r"""["']\s*What""", text := file.read_text("utf-8"))}
    vague = [f"{file}: {doc[:60]}" for file, text in maybe.items() for doc in docstrings(text) if doc[:4] == "What"]
    assert not vague, "\n".join(vague)


# Words that mean something else where they are compared: keys of a design file, of HTTP, of pydantic, of a journal.
OTHER_WORDS = {
    "cadgen.output.files.gcode_machine": {"M3", "M5"},  # of the spindle, and no threads
    "cadgen.api.planetary": {"ring"},
    "cadgen.design.explain": {"missing"},
    "cadgen.design.planned": {"path"},
    "cadgen.design.reference": {"path"},
    "cadgen.viewer.editor.guard": {"none"},
    "cadgen.viewer.editor.controls": {"finish", "start"},
    "cadgen.viewer.editor.course_items": {"field", "walls", "zones"},
    "cadgen.processes": {"fork"},
    "cadgen.studies.study_file": {"missing"},
    "cadgen.studies.journal": {"path"},
    "cadgen.output.files.dxf": {"TEXT"},
    "cadgen.cli.page_commands": {"cam"},  # the value of --only
    "cadgen.output.report.terminal": {"right"},  # of rich
    "cadgen.output.report.study_pictures": {"deg"},  # a unit
    "cadgen.inference.measurement.reference": {"deg"},
    "cadgen.design.lift_rows": {"deg", "mm"},
    "cadgen.inference.records.units": {"mm"},
}


def texts(node: ast.AST) -> Iterator[str]:
    """Texts of a constant, or of a tuple, list or set of them."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.Tuple | ast.List | ast.Set):
        for item in node.elts:
            yield from texts(item)


def words_of_enumerations(sources: Iterable[str]) -> set[str]:
    """Values of all enumerations of words."""
    return {
        text
        for source in sources
        for node in nodes(source)
        if isinstance(node, ast.ClassDef) and any(ast.unparse(base) in ("Enum", "StrEnum") for base in node.bases)
        for statement in node.body
        if isinstance(statement, ast.Assign)
        for text in texts(statement.value)
        if text
    }


def compared(source: str, words: set[str]) -> set[str]:
    """Words of these that a module compares something with."""
    return {
        text
        for node in nodes(source)
        if isinstance(node, ast.Compare)
        for side in (node.left, *node.comparators)
        for text in texts(side)
        if text in words
    }


def test_a_member_of_an_enumeration_is_compared_and_not_its_word():
    sources = {name: file.read_text("utf-8") for name, file in MODULES.items()}
    words = words_of_enumerations(sources.values())
    print(f"{len(words)} words of enumerations")
    assert len(words) > 200
    found = {name: words_here for name, source in sources.items() if (words_here := compared(source, words))}
    assert found == OTHER_WORDS


def test_closed_lists_of_words_are_enumerations():
    """`Literal` is for what libraries name, such as the types of numpy."""
    literal = {
        name
        for name, file in MODULES.items()
        for node in nodes(file.read_text("utf-8"))
        if isinstance(node, ast.Subscript) and ast.unparse(node.value) == "Literal" and [*texts(node.slice)]
    }
    assert literal <= {"cadgen.viewer.page.mesh_block"}


def test_a_word_that_is_compared_is_seen():
    source = """
class Side(StrEnum):
    LEFT = "left"
def f(side):
    return side == "left" or side in ("left", "right")
"""
    assert words_of_enumerations([source]) == {"left"}
    assert compared(source, {"left"}) == {"left"}
    assert not compared(source.replace('"left" or', "Side.LEFT or").replace('("left", "right")', "SIDES"), {"left"})
