"""A design that is edited: its text keeps its comments, changes are undone, and no file is lost."""

import os
import sys
from difflib import ndiff
from pathlib import Path

import pytest

from cadgen.design.load import load_design, packaged_designs
from cadgen.editor.session import Session
from cadgen.errors import DesignError, FileError
from tests.editor.conftest import TEXT


def changed_lines(before, after):
    return [line for line in ndiff(before.splitlines(), after.splitlines()) if line[0] in "+-"]


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
        ({"car.wheelbase_mm": -1.0}, "must be greater than 0"),
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


@pytest.mark.parametrize("name", sorted(packaged_designs()))
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
