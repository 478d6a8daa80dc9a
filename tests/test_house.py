"""The house itself: who imports whom, which strings stand for what, and how large a room may be."""

import ast
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
MODULES = {
    ".".join(file.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): file
    for file in sorted((ROOT / "cadgen").rglob("*.py"))
}


def imported(name: str, source: str, modules: dict[str, Path] | set[str]) -> Iterator[str]:
    """Modules of the program that a module imports anywhere: at its top, in functions, and for types alone."""
    for node in ast.walk(ast.parse(source)):
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
