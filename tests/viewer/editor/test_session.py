"""A design that is edited: its text keeps its comments, changes are undone, and no file is lost."""

import os
import sys
from difflib import ndiff
from pathlib import Path

import pytest

from cadgen.design.load import load_design, packaged_designs
from cadgen.errors import DesignError, FileError
from cadgen.viewer.editor.session import Session
from tests.viewer.editor.conftest import CARS, TEXT


def changed_lines(before, after):
    return [line for line in ndiff(before.splitlines(), after.splitlines()) if line[0] in "+-"]


@pytest.mark.parametrize("typed", ["mine", "mine.toml", " mine.TOML "])
def test_a_name_is_saved_with_one_ending(session, file, typed):
    assert session.save(typed) == "mine.toml"
    assert (session.name, session.state()["file"]) == ("mine", "mine.toml")
    assert {entry.name for entry in file.parent.iterdir()} == {"small.toml", "mine.toml"}


def test_a_change_touches_its_own_number_and_comments_stay(session, file):
    session.change({"path.waypoints_mm.3": (2650.0, 1200.5), "car.wheelbase_mm": 170.0, "cam.thickness_mm": 3.5})
    session.change({"course.posts.1.at_mm": (2500.0, 310.0)})
    assert session.save() == "small.toml"
    assert changed_lines(TEXT, file.read_text()) == [
        "-     [2600.0, 1200.0],  # the turn",
        "+     [2650.0, 1200.5],  # the turn",
        "- at_mm = [2600.0, 300.0]",
        "+ at_mm = [2500.0, 310.0]",
        "- wheelbase_mm = 167.0   # L",
        "+ wheelbase_mm = 170.0   # L",
        "- thickness_mm = 3   # C",
        "+ thickness_mm = 3.5   # C",
    ]
    assert load_design(file).path.keys.waypoints_mm[2] == (2650.0, 1200.5)


def test_a_number_that_the_file_leaves_out_is_written_into_its_section(session, file):
    session.change({"cam.blend_deg": 14.0, "checks.min_wall_mm": 1.5})
    session.save()
    loaded = load_design(file)
    assert (loaded.cam.blend_deg, loaded.checks.min_wall_mm) == (14.0, 1.5)
    assert "# the turn" in file.read_text()


def test_undo_and_redo_step_by_moves(session):
    for x in (171.0, 172.0, 173.0):
        session.change({"car.wheelbase_mm": x}, "one slide")
    session.change({"car.wheelbase_mm": 180.0}, "another")
    assert session.state()["undo"] == 2
    session.undo()
    assert session.now.design.car.wheelbase_mm == 173.0
    session.undo()
    assert session.now.text == TEXT
    assert not session.unsaved
    session.undo()
    session.redo()
    session.redo()
    assert session.now.design.car.wheelbase_mm == 180.0
    session.undo()
    session.change({"car.wheelbase_mm": 150.0})
    assert session.state()["redo"] == 0


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"car.wheelbase_mm": -1.0}, "must be at least 1"),
        ({"cam.thickness_mm": 60.0}, "faces"),
        ({"name": 1.0}, "cannot be changed here"),
        ({"path.waypoints_mm.99": (1.0, 2.0)}, "cannot be changed here"),
        ({"path.waypoints_mm.2": (1e7, 0.0)}, "at most"),
        ({"export.point_count": 1000}, "cannot be changed here"),
    ],
)
def test_a_change_that_cannot_be_is_refused_and_nothing_has_changed(session, changes, sentence):
    revision = session.revision
    with pytest.raises(DesignError, match=sentence):
        session.change(changes)
    assert (session.now.text, session.revision) == (TEXT, revision)


def test_a_packaged_design_is_a_copy_that_needs_a_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    session = Session("figure_eight")
    packaged = packaged_designs()["figure_eight"].read_bytes()
    assert session.state()["copy"]
    session.change({"car.wheelbase_mm": 111.0})
    with pytest.raises(DesignError, match="name of its own"):
        session.save()
    assert session.save("mine") == "mine.toml"
    assert load_design("mine.toml").name == "mine"
    assert os.listdir(tmp_path) == ["mine.toml"]
    session.change({"car.wheelbase_mm": 112.0})
    session.save()
    assert load_design(Path("mine.toml")).car.wheelbase_mm == 112.0
    assert packaged_designs()["figure_eight"].read_bytes() == packaged


@pytest.mark.parametrize("name", ["", "../out", "a/b", "a\\b", "con", ".hidden", "x" * 65, 'a"b', "a\nb", "/tmp/x"])
def test_no_file_outside_the_folder(session, file, name):
    session.change({"car.wheelbase_mm": 171.0})
    with pytest.raises(DesignError, match="it must"):
        session.save(name)
    assert os.listdir(file.parent) == ["small.toml"]
    assert file.read_text() == TEXT
    assert session.unsaved


def test_a_file_that_is_there_and_one_that_was_changed_meanwhile_stay(session, file):
    (file.parent / "other.toml").write_text("mine")
    session.change({"car.wheelbase_mm": 171.0})
    with pytest.raises(FileError, match="there already"):
        session.save("other")
    file.write_text(TEXT + "# by another program\n")
    with pytest.raises(FileError, match="changed by another program"):
        session.save()
    assert (file.parent / "other.toml").read_text() == "mine"
    assert file.read_text().endswith("program\n")
    assert session.save("third") == "third.toml"


def test_a_save_that_fails_leaves_the_old_file_and_nothing_else(session, file, monkeypatch):
    session.change({"car.wheelbase_mm": 171.0})

    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    for name in (None, "new"):
        with pytest.raises(FileError, match="No space left"):
            session.save(name)
    assert os.listdir(file.parent) == ["small.toml"]
    assert file.read_text() == TEXT
    assert session.unsaved


def test_marks_and_line_ends_of_other_systems_stay(file):
    file.write_bytes(b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode())
    session = Session(file)
    session.change({"cam.thickness_mm": 3.5})
    session.save()
    content = file.read_bytes()
    assert content.startswith(b"\xef\xbb\xbf# A small car.")
    assert content.count(b"\r\n") == content.count(b"\n") == TEXT.count("\n")


@pytest.mark.skipif(sys.platform == "win32", reason="links and modes of POSIX")
def test_a_mode_stays_and_a_link_is_not_written_through(file, tmp_path):
    file.chmod(0o640)
    session = Session(file)
    session.change({"cam.thickness_mm": 3.5})
    session.save()
    assert file.stat().st_mode & 0o777 == 0o640
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    link = folder / "link.toml"
    link.symlink_to(file)
    linked, before = Session(link), file.read_bytes()
    linked.change({"cam.thickness_mm": 3.6})
    with pytest.raises(DesignError, match="copy"):
        linked.save()
    linked.save("own")
    assert file.read_bytes() == before
    assert sorted(os.listdir(folder)) == ["link.toml", "own.toml"]


def test_overrides_are_an_unsaved_change(file):
    session = Session(file, ["cam.thickness_mm=3.2"])
    assert session.unsaved
    assert "thickness_mm = 3.2   # C" in session.now.text
    session.undo()
    assert not session.unsaved


@pytest.mark.parametrize("name", CARS)
def test_controls_and_points_of_the_packaged_designs(name):
    """Every number lies on its slider and in the schema's range, and can be written where it stands."""
    session = Session(name)
    state = session.state()
    controls = [control for group in state["groups"] for control in group["controls"]]
    assert len(controls) > 15
    for control in controls:
        least, most = control["least"], control["most"]
        assert control["low"] <= control["value"] <= control["high"], control
        assert control["low"] < control["high"]
        assert least is None or control["low"] >= least
        assert most is None or control["high"] <= most
        assert all(control["label"])
    assert len(state["points"]) >= 12
    assert len({point["key"] for point in state["points"]}) == len(state["points"])
    text = session.now.text
    session.change({point["key"]: (point["x"], point["y"]) for point in state["points"]})
    # What is there already changes nothing but how it is written.
    assert session.now.design.content_hash == load_design(name).content_hash
    session.undo()
    assert session.now.text == text


def test_the_sizes_of_posts_and_field_can_be_changed(session, file):
    session.change({"course.posts.1.radius_mm": 30.0})
    assert "radius_mm = 30.0" in session.now.text
    labels = {c["key"]: c["label"][0] for g in session.state()["groups"] for c in g["controls"]}
    assert labels["course.posts.1.radius_mm"] == "post 1, radius"
    fielded = Session("s_course")
    fielded.change({"course.field.size_mm.2": 2100.0, "course.field.corner_mm": (10.0, 0.0)})
    assert fielded.now.design.values()["course"]["field"]["size_mm"] == [7500.0, 2100.0]


@pytest.mark.parametrize(
    ("number", "before", "after"),
    [
        (1, "    [0.0, 0.0], [", "    [7.0, 8.5],\n    [0.0, 0.0], ["),
        (2, "[0.0, 0.0], [15", "[0.0, 0.0], [7.0, 8.5], [15"),
        (3, "    [2600.0, 1200.0],  # the turn", "    [7.0, 8.5],\n    [2600.0, 1200.0],  # the turn"),
        (6, "[5500.0, 1000.0],\n", "[5500.0, 1000.0], [7.0, 8.5],\n"),
    ],
)
def test_a_point_is_put_into_the_path_and_comments_stay(session, number, before, after):
    session.insert(f"path.waypoints_mm.{number}", (7.0, 8.5))
    assert session.now.text == TEXT.replace(before, after)
    assert session.now.design.path.keys.waypoints_mm[number - 1] == (7.0, 8.5)
    session.undo()
    assert session.now.text == TEXT


@pytest.mark.parametrize(
    ("number", "before", "after"),
    [
        (1, "    [0.0, 0.0], [", "    ["),
        (3, "[2600.0, 1200.0],  # the turn", "# the turn"),
        (5, "0.0], [5500.0, 1000.0],\n", "0.0],\n"),
    ],
)
def test_a_point_is_taken_out_of_the_path_and_comments_stay(session, number, before, after):
    session.remove(f"path.waypoints_mm.{number}")
    assert session.now.text == TEXT.replace(before, after)
    session.undo()
    assert session.now.text == TEXT


@pytest.mark.parametrize("layout", ["[[0,0],[1_500,2e2],[2600,1200],[4000,1500],[5500,1000]]", "# [9\n[ # ]\r\n[0,0]"])
def test_lists_in_any_layout_and_twice_the_same(file, layout):
    """The path is found although a comment and a wall have the same points."""
    points = [[0.0, 0.0], [1500.0, 200.0], [2600.0, 1200.0], [4000.0, 1500.0], [5500.0, 1000.0]]
    if layout.startswith("#"):
        layout = "[ # ]\r\n" + "".join(f"  # [9\r\n  {point}\r\n  ,\r\n" for point in points) + "]"
    head, _, tail = TEXT.partition("waypoints_mm = [")
    text = head + f"waypoints_mm = {layout}" + tail.partition("\n]")[2]
    same = text.replace("[path]", f"# was {layout if chr(10) not in layout else ''}\n[path]")
    file.write_bytes((same + f"\n[[course.walls]]\nline_mm = {layout}\n").encode())
    session = Session(file)
    for number in range(1, 7):
        session.insert(f"path.waypoints_mm.{number}", (7.0, 8.0))
        now = [list(point) for point in session.now.design.path.keys.waypoints_mm]
        assert now == [*points[: number - 1], [7.0, 8.0], *points[number - 1 :]]
        session.remove(f"path.waypoints_mm.{number}")
        assert [list(point) for point in session.now.design.path.keys.waypoints_mm] == points
    session.remove("course.walls.1.line_mm.5")
    assert session.now.text.count("#") == same.count("#") + layout.count("#")


@pytest.mark.parametrize(
    "key",
    [
        *("path.waypoints_mm.7", "path.waypoints_mm.0", "path.waypoints_mm", "course.posts.1.at_mm", "course.posts.3"),
        *("course.posts", "course.gates.2", "course.field.1", "course.spacing", "car.outline", "train.stages.1"),
    ],
)
def test_nothing_else_grows_and_shrinks(session, key):
    for refused in (
        lambda: session.insert(key, (1.0, 2.0)),
        lambda: session.remove(key),
        lambda: session.exchange(key),
    ):
        with pytest.raises(DesignError, match=r"no place for a point|cannot be removed here|cannot be exchanged"):
            refused()
    session.remove("path.waypoints_mm.5")
    with pytest.raises(DesignError, match="it needs at least 4"):
        session.remove("path.waypoints_mm.1")
    assert session.state()["undo"] == 1


def test_a_new_name_stays_when_older_changes_are_undone(session, file):
    session.change({"car.wheelbase_mm": 170.0})
    session.save("other")
    session.undo()
    assert (session.name, session.unsaved) == ("other", True)
    session.save()
    assert (file.parent / "other.toml").read_text() == TEXT.replace('"small"', '"other"')
    session.redo()
    assert (session.name, session.now.design.car.wheelbase_mm) == ("other", 170.0)


def test_a_design_without_a_name_has_that_of_its_file(file):
    file.write_text(TEXT.replace('name = "small"\n', ""))
    session = Session(file)
    session.change({"car.wheelbase_mm": 170.0})
    session.save("other")
    assert (session.name, session.state()["name"], session.unsaved) == ("other", "other", False)
    session.undo()
    assert session.name == "other"
    assert "name" not in session.now.text


@pytest.mark.skipif(sys.platform == "win32", reason="links and modes of POSIX")
def test_what_another_program_has_put_in_the_place_of_the_file_stays(session, file, tmp_path):
    session.change({"car.wheelbase_mm": 171.0})
    aside = tmp_path / "aside"
    file.rename(aside)
    for put in (lambda: file.write_bytes(b"#" * 600_000), lambda: file.symlink_to(aside), file.mkdir):
        put()
        with pytest.raises(FileError, match="changed by another program"):
            session.save()
        assert aside.read_text() == TEXT
        file.rmdir() if file.is_dir() else file.unlink()
    session.save()  # a file that was removed is written again
    assert "171.0" in file.read_text()


def test_a_file_that_is_read_only_stays(session, file, monkeypatch):
    session.change({"car.wheelbase_mm": 171.0})
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(FileError, match="read-only: save under another name"):
        session.save()
    assert file.read_text() == TEXT


@pytest.mark.parametrize("error", [KeyError, TypeError, ValueError])
def test_what_the_library_cannot_write_is_a_sentence(session, monkeypatch, error):
    def broken(_):
        raise error("its own")

    monkeypatch.setattr("tomlkit.parse", broken)
    for change in (
        lambda: session.change({"car.wheelbase_mm": 171.0}),
        lambda: session.insert("path.waypoints_mm.2", (1.0, 2.0)),
    ):
        with pytest.raises(DesignError, match="make it in a text editor"):
            change()
    assert session.now.text == TEXT
