"""The quick tests, `-m "not slow"`, leave out no room."""

import ast
from pathlib import Path

import pytest

HERE = Path(__file__).parent


def quick(file: Path) -> int:
    """Number of a file's test functions that are not marked slow."""
    functions = (node for node in ast.parse(file.read_text()).body if isinstance(node, ast.FunctionDef))
    tests = (node for node in functions if node.name.startswith("test_"))
    return sum(not any(ast.unparse(mark) == "pytest.mark.slow" for mark in test.decorator_list) for test in tests)


@pytest.mark.parametrize("room", sorted({file.parent.name for file in HERE.glob("*/test_*.py")}))
def test_every_folder_has_quick_tests(room):
    files = (HERE / room).glob("test_*.py")
    assert sum(map(quick, files)) >= 1


def test_every_room_of_the_package_has_a_folder_of_tests():
    rooms = {file.parent.name for file in (HERE.parent / "cadgen").glob("*/__init__.py")}
    assert rooms <= {file.parent.name for file in HERE.glob("*/test_*.py")}
