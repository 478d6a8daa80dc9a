"""The quick tests, `-m "not slow"`, leave out no room; nor does the suite, `-m "not long"`; none of them is timed."""

import ast
from pathlib import Path

import pytest
from hypothesis import settings

HERE = Path(__file__).parent


def marks(file: Path) -> dict[str, set[str]]:
    """Marks of each test function in a file, by its name."""
    functions = (node for node in ast.parse(file.read_text()).body if isinstance(node, ast.FunctionDef))
    tests = (node for node in functions if node.name.startswith("test_"))
    return {
        test.name: {ast.unparse(mark).removeprefix("pytest.mark.") for mark in test.decorator_list} for test in tests
    }


def quick(file: Path) -> int:
    """Number of a file's test functions that are not marked slow."""
    return sum("slow" not in of_test for of_test in marks(file).values())


@pytest.mark.parametrize("room", sorted({file.parent.name for file in HERE.glob("*/test_*.py")}))
def test_every_folder_has_quick_tests(room):
    files = (HERE / room).glob("test_*.py")
    assert sum(map(quick, files)) >= 1


WINGS = {"car", "geometry", "inference", "output", "viewer"}  # their rooms have the tests


def test_every_room_of_the_package_has_a_folder_of_tests():
    rooms = {file.parent.name for file in (HERE.parent / "cadgen").glob("*/__init__.py")}
    assert rooms <= {file.parent.name for file in HERE.glob("**/test_*.py")} | WINGS


def test_long_tests_are_slow_and_no_room_has_them_alone():
    every = {file: marks(file) for file in HERE.glob("**/test_*.py")}
    named = [(name, of_test) for tests in every.values() for name, of_test in tests.items()]
    assert not [name for name, of_test in named if "long" in of_test and "slow" not in of_test]
    for room in {file.parent.name for file in HERE.glob("*/test_*.py")}:
        tests = [of_test for file, of_file in every.items() if file.parent.name == room for of_test in of_file.values()]
        assert sum("long" not in of_test for of_test in tests) > len(tests) / 2, room


def test_property_tests_have_no_deadline():
    assert settings().deadline is None
    deadlines = {
        ast.unparse(key.value)
        for file in HERE.glob("**/test_*.py")
        for key in ast.walk(ast.parse(file.read_text("utf-8")))
        if isinstance(key, ast.keyword) and key.arg == "deadline"
    }
    assert deadlines <= {"None"}
