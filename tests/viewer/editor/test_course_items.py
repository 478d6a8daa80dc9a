"""Posts, gates, walls, zones, start, finish, field: put onto the course and taken off it, the file's comments kept."""

import re
import tomllib
from pathlib import Path

import pytest

from cadgen.design.load import packaged_designs
from cadgen.viewer.editor.session import Session
from tests.viewer.editor.conftest import CARS, TEXT

KINDS = ("posts", "walls", "zones", "gates")
ALONE = ("start", "finish", "field")
POST = "[[course.posts]]   # in the way\nat_mm = [2600.0, 300.0]\nradius_mm = 20.0\n"
GATES = """
# The way through.
[[course.gates]]
at_mm = [700.0, 100.0]   # a
radius_mm = 60.0

# narrow
[[course.gates]]         # one
at_mm = [1500.0, 200.0]
# radius_mm = 9.0

[[ course . "gates" ]]
at_mm = [
    2600.0,
    1200.0,
]"""


def comments(text):
    return sorted(re.findall(r"#[^\r\n]*", text))


def course(session):
    return tomllib.loads(session.now.text.lstrip("\ufeff")).get("course", {})


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("name", CARS)
def test_each_kind_of_item_comes_and_goes(tmp_path, name, end):
    """In any layout of the file only the item asked for changes, and undo gives the same text again."""
    file = tmp_path / "design.toml"
    text = packaged_designs()[name].read_text(encoding="utf-8")
    file.write_bytes(text.replace("\n", end).encode())
    session = Session(file)
    text, before = session.now.text, course(session)
    for kind in KINDS:
        items = before.get(kind, [])
        for number in {1, len(items), len(items) + 1} - {0}:
            session.insert(f"course.{kind}.{number}", (400.0, 250.0))
            now = course(session)
            new = now[kind].pop(number - 1)
            assert now == {**before, kind: items}
            points = new.get("line_mm") or [
                new.get("at_mm") or [c + s / 2 for c, s in zip(*new.values(), strict=False)]
            ]
            assert [sum(axis) / len(points) for axis in zip(*points, strict=True)] == pytest.approx([400.0, 250.0])
            assert comments(session.now.text) == comments(text)
            session.remove(f"course.{kind}.{number}")
            assert {k: v for k, v in course(session).items() if v} == before
            for _ in range(2):
                session.undo()
            assert session.now.text == text
            assert session.now.text.count("\r") == (text.count("\n") if end == "\r\n" else 0)
        for number in {1, len(items)} if items else ():
            session.remove(f"course.{kind}.{number}")
            assert course(session).get(kind, []) == items[: number - 1] + items[number:]
            assert comments(session.now.text) == comments(text)
            session.undo()
    for kind in ALONE:
        if kind in before:
            session.remove(f"course.{kind}")
        else:
            session.insert(f"course.{kind}", (400.0, 250.0))
        now = course(session)
        assert (kind in now) != (kind in before)
        assert {k: v for k, v in now.items() if k != kind} == {k: v for k, v in before.items() if k != kind}
        assert comments(session.now.text) == comments(text)
        session.undo()
    assert session.now.text == text


def test_a_table_is_put_where_the_others_are(session):
    session.insert("course.posts.2", (7.0, 8.0))
    new = "\n[[course.posts]]\nat_mm = [7.0, 8.0]\nradius_mm = 20.0\n"
    assert session.now.text == TEXT.replace(POST, POST + new)
    session.remove("course.posts.1")
    assert session.now.text == TEXT.replace(POST, "# in the way\n" + new)
    session.undo()
    session.remove("course.posts.2")
    assert session.now.text == TEXT
    session.insert("course.posts.1", (7.0, 8.0))
    assert session.now.text == TEXT.replace(POST, new[1:] + "\n" + POST)


def test_a_design_without_a_course_gets_one_and_loses_it(file):
    bare = TEXT.replace(POST + "\n", "")
    file.write_text(bare)
    session = Session(file)
    assert [kind["count"] for kind in session.state()["kinds"]] == [0] * 7
    session.insert("course.gates.1", (1500.0, 200.0))
    gate = "[[course.gates]]\nat_mm = [1500.0, 200.0]\nradius_mm = 50.0\n"
    assert session.now.text == bare.replace("[car]", f"{gate}\n[car]", 1)
    assert "course.gates.1.radius_mm" in {c["key"] for g in session.state()["groups"] for c in g["controls"]}
    session.remove("course.gates.1")
    assert session.now.text == bare
    assert session.now.design.course is None
    session.insert("course.field", (0.0, 0.0))
    points = [point for point in session.state()["points"] if point["layer"] == "path"]
    field = course(session)["field"]
    for axis, at in enumerate("xy"):
        low = field["corner_mm"][axis]
        assert low + 300 <= min(point[at] for point in points)
        assert low + field["size_mm"][axis] - 300 >= max(point[at] for point in points)


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_gates_change_their_order_and_comments_go_with_them(file, end):
    file.write_bytes((TEXT + GATES).replace("\n", end).encode())
    session = Session(file)
    a, b, c = course(session)["gates"]
    session.exchange("course.gates.1")
    assert course(session)["gates"] == [b, a, c]
    assert comments(session.now.text) == comments(TEXT + GATES)
    # The comments above and inside of the second gate have gone to the first place with it.
    second = "# narrow\n[[course.gates]]         # one\nat_mm = [1500.0, 200.0]\n# radius_mm = 9.0\n\n# The way"
    assert f"{TEXT}\n{second}".replace("\n", end) in session.now.text
    session.exchange("course.gates.2")
    assert course(session)["gates"] == [b, c, a]
    session.remove("course.gates.3")
    session.remove("course.gates.1")
    assert course(session)["gates"] == [c]
    assert comments(session.now.text) == comments(TEXT + GATES)
    assert session.now.text.count("\r") == (session.now.text.count("\n") if end == "\r\n" else 0)


@pytest.mark.parametrize(
    ("gates", "after"),
    [
        ("[{ at_mm = [1, 2] }, {at_mm=[3, 4]}]", "[{at_mm=[3, 4]}, { at_mm = [1, 2] }]"),
        (
            "[\n  { at_mm = [1, 2] },  # a ]\n  { at_mm = [3, 4] },  # b }\n]",
            "[\n  { at_mm = [3, 4] },  # b }\n  { at_mm = [1, 2] },  # a ]\n]",
        ),
        (
            '[\n  { at_mm = [1, 2], point = "fork" },  # a\n  { at_mm = [3, 4] }  # b\n]',
            '[\n  { at_mm = [3, 4] },  # a\n  { at_mm = [1, 2], point = "fork" }  # b\n]',
        ),
    ],
)
def test_gates_in_brackets(file, gates, after):
    text = TEXT.replace(POST, f"[course]\ngates = {gates}\n")
    file.write_text(text)
    session = Session(file)
    session.exchange("course.gates.1")
    assert session.now.text == text.replace(gates, after)
    session.undo()
    session.insert("course.gates.2", (7.0, 8.0))
    assert session.now.text.replace("{ at_mm = [7.0, 8.0], radius_mm = 50.0 }", "") != text
    assert [gate["at_mm"] for gate in course(session)["gates"]] == [[1, 2], [7.0, 8.0], [3, 4]]
    for number in (2, 1, 1):
        session.remove(f"course.gates.{number}")
    assert course(session)["gates"] == []
    assert comments(session.now.text) == comments(text)
    session.insert("course.gates.1", (5.0, 6.0))
    assert course(session)["gates"] == [{"at_mm": [5.0, 6.0], "radius_mm": 50.0}]


def test_headings_in_texts_and_lists_are_none(file):
    """A heading inside a comment, and the points of a list, are passed over."""
    head, rest = TEXT.split("[[course.posts]]", 1)
    file.write_text(
        f"{head}# [[course.posts]]\n[[course.walls]]\nline_mm = [\n  [0, 900],\n  [9, 900]\n]\n[[course.posts]]{rest}"
    )
    session = Session(file)
    before = course(session)
    session.insert("course.walls.2", (0.0, 800.0))
    session.insert("course.posts.1", (0.0, 700.0))
    assert course(session)["walls"][0] == before["walls"][0]
    assert course(session)["posts"][1] == before["posts"][0]
    session.remove("course.walls.1")
    assert [len(course(session)[kind]) for kind in ("walls", "posts")] == [1, 2]
    assert Path(file).read_text().count("#") == session.now.text.count("#")
