"""Studies from their files: what is refused, with which sentence; what varies, and in which order."""

import json
import os
from collections import Counter
from pathlib import Path
from zlib import crc32

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cadgen.errors import DesignError, FileError
from cadgen.studies import sampling
from cadgen.studies.journal import Journal
from cadgen.studies.results import merged
from cadgen.studies.sampling import Variation
from cadgen.studies.study_file import read_study
from cadgen.studies.study_run import open_journal

TEXT = """
objectives = ["worst_end_mm", "disc_diameter_mm"]
[plan]
kind = "sobol"
designs = 16
[[vary]]
key = "cam.base_radius_mm"
least = 60
most = 80
"""


def read(folder: Path, text: str) -> None:
    file = folder / "study.toml"
    file.write_text(text)
    read_study(file)


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('kind = "sobol"', 'kinds = "sobol"', r"plan\.kinds is not a key of a study: \[plan\] takes kind, designs and"),
        ('kind = "sobol"', 'kind = "sobel"', r'plan\.kind is "sobel"; it must be "full_factorial", .* or "nsga2"'),
        ("designs = 16", "", r"plan\.designs is missing: say how many designs sobol is to choose"),
        ("designs = 16", "designs = 0", r"plan\.designs is 0; it must be at least 1"),
        ("designs = 16", "designs = 1.5", r"plan\.designs is 1\.5; it must be a whole number"),
        ("designs = 16", "designs = ", r"is not TOML"),
        ("least = 60", "least = 80", r"the range of cam\.base_radius_mm from 80 to 80 is empty: least must be below"),
        ("least = 60", "", r"cam\.base_radius_mm must vary either by values or from least to most"),
        ("least = 60\nmost = 80", "values = []", r"cam\.base_radius_mm has no values to choose from"),
        ("most = 80", "most = 800", r"--set cam\.base_radius_mm=800\.0: cam\.base_radius_mm is 800.*it must be"),
        ("cam.base_radius_mm", "cam.base_radios_mm", r"did you mean cam\.base_radius_mm\?"),
        ("cam.base_radius_mm", "replan.within_mm", r"replan\.within_mm varies, but no path is planned: add \[replan\]"),
        ("worst_end_mm", "worst_end", r'objectives\.1 is "worst_end"; it must be "worst_end_mm", '),
        ('["worst_end_mm", "disc_diameter_mm"]', "[]", r"objectives is empty: add at least one"),
        ("[plan]", 'checks = ["round"]\n[plan]', r'checks names "round", which is no check'),
        ("[plan]", 'base = "no_car"\n[plan]', r"there is no design file .*no_car"),
        ("[plan]", 'set = ["cam.thickness_mm=0"]\n[plan]', r"--set cam\.thickness_mm=0: .*it must be"),
        ("[[vary]]", '[[limits]]\nfigure = "drift_mm"\n[[vary]]', r"the limit on drift_mm has neither least nor most"),
        (
            "[[vary]]",
            '[[limits]]\nfigure = "drift_mm"\nleast = 3\nmost = 2\n[[vary]]',
            r"the limit on drift_mm from 3 to 2 is empty: exchange them",
        ),
        ('kind = "sobol"\ndesigns = 16', 'kind = "full_factorial"', r"cam\.base_radius_mm is a range, .*: add step"),
        (
            "least = 60\nmost = 80",
            'values = [60.0, 70.0]\nalong = { "train.module_mm" = [0.5] }',
            r"train\.module_mm changes along with cam\.base_radius_mm and has 1 values, but .* has 2",
        ),
        ("[plan]", 'profile = "best"\n[plan]', r'profile is "best"; it must be "actual"'),
        ('kind = "sobol"', 'kind = "nsga2"', r"plan\.designs is 16, fewer than the 40 of one generation"),
        (
            "least = 60\nmost = 80",
            "values = [2020-01-01]",
            r"has the value datetime\.date.*; it must be a finite",
        ),
        (
            "least = 60\nmost = 80",
            "values = [nan]",
            r"cam\.base_radius_mm has the value nan; it must be",
        ),
        ("least = 60\nmost = 80", "values = [{ a = 1 }]", r"has the value \{'a': 1\}; it must be a finite number"),
        ("least = 60\nmost = 80", "values = [60, 60.0]", r"has the value 60\.0 twice: remove one$"),
        (
            "least = 60\nmost = 80",
            f"values = {[60 + k / 1e4 for k in range(1001)]}",
            r"has 1001 values; it can have",
        ),
        (
            "least = 60\nmost = 80",
            'values = [60.0, 70.0]\nalong = { "train.module_mm" = [0.5, "x"] }',
            r"train\.module_mm is \"x\"; it must be a number",
        ),
        ("most = 80", "most = 80\nstep = 30", r"the step of cam\.base_radius_mm is 30, more than its range is wide"),
        ("most = 80", "most = 80\nstep = 1e-310", r"is 1e-310, which makes more than 1000000 values: raise it"),
        ("cam.base_radius_mm", "path.waypoints_mm.99.1", r"there is no item 99: the list has 12"),
        ("cam.base_radius_mm", "...", r"write it as key=value"),
        ("cam.base_radius_mm", "", r"vary\.1\.key is empty"),
        ("[[vary]]", "[vary]", r"vary is one section; it must be a list of them: write \[\[vary\]\]"),
        ("[plan]", f"profile = {'[' * 5000}\n[plan]", r"nests keys or brackets more deeply than any study does"),
        (
            'cam.base_radius_mm"\nleast = 60\nmost = 80',
            'replan.reserve"\nvalues = [-1.0]\n[replan]',
            r"replan\.reserve is -1\.0; it must be 0 to 10",
        ),
        (
            'cam.base_radius_mm"\nleast = 60\nmost = 80',
            'replan.seeds"\nvalues = ["x"]\n[replan]',
            r"replan\.seeds is 'x'; it must be a whole number from 1 to 100",
        ),
        (
            'cam.base_radius_mm"\nleast = 60\nmost = 80',
            'replan.seeds"\nleast = 0\nmost = 5\n[replan]',
            r"replan\.seeds is 0\.0; it must be a whole number from 1 to 100",
        ),
        (
            'cam.base_radius_mm"\nleast = 60',
            'train.stages.1.driver.teeth"\nleast = 10.5',
            r"train\.stages\.1\.driver\.teeth takes whole numbers",
        ),
    ],
)
def test_a_wrong_study_is_refused_in_one_sentence(tmp_path, old, new, sentence):
    assert old in TEXT
    with pytest.raises(DesignError, match=sentence) as refused:
        read(tmp_path, TEXT.replace(old, new))
    assert "\n" not in str(refused.value)


def test_a_right_study_is_taken_with_what_is_only_right_together(tmp_path):
    both = TEXT.replace("cam.base_radius_mm", "cam.inner_face_mm").replace("60", "30").replace("80", "32")
    read(tmp_path, both + '[[vary]]\nkey = "cam.mid_plane_mm"\nvalues = [33.0]\n' + "")


def test_journals_of_others_are_refused(tmp_path, monkeypatch):
    def opened(text: str, name: str = "study.toml") -> None:
        file = tmp_path / name
        file.write_text(text)
        study, content = read_study(file)
        open_journal(study, content, tmp_path).close()

    opened(TEXT)
    opened(TEXT + "# a comment changes nothing\n")
    opened("best = 9  # changes no row\n" + TEXT)
    with pytest.raises(FileError, match=r"is of another study, or of another state of this one"):
        opened(TEXT.replace("60", "61"))
    (tmp_path / "study.toml").write_text(TEXT)
    (tmp_path / "study.journal").rename(tmp_path / "study.1of2.journal")
    with pytest.raises(FileError, match=r"is of shard 1/1: name it study\.journal again"):
        open_journal(*read_study(tmp_path / "study.toml"), tmp_path, (1, 2))
    (tmp_path / "study.1of2.journal").rename(tmp_path / "study.journal")
    monkeypatch.setattr("cadgen.studies.study_run.__version__", "99.0")
    with pytest.raises(FileError, match=r"was begun by cadgen .*, and this is 99\.0: end it with that version"):
        opened(TEXT)
    (tmp_path / "study.journal").write_text("something else, and longer than a header would ever be\n" * 200)
    with pytest.raises(FileError, match="is no journal of cadgen explore"):
        opened(TEXT)


ROW = [0, [70.0], "kept", [1.0, 2.0], [], ""]


def line(content: object) -> bytes:
    """A journal's line with a true checksum; bytes stand as they are."""
    text = content if isinstance(content, bytes) else json.dumps(content).encode()
    return b"%08x %s\n" % (crc32(text), text)


@pytest.fixture
def begun(tmp_path):
    """Header of a journal that was begun, as plain values, and the journal's path."""
    (tmp_path / "study.toml").write_text(TEXT)
    open_journal(*read_study(tmp_path / "study.toml"), tmp_path).close()
    return json.loads((tmp_path / "study.journal").read_bytes()[9:]), tmp_path / "study.journal"


@pytest.mark.parametrize(
    "content",
    [
        b"{",
        b"[" * 100_000,
        b"1" * 5000,
        7,
        [],
        {},
        {"row": ROW},
        {"row": ROW, "seconds": "1"},
        {"row": ROW, "seconds": -1.0},
        {"row": ROW, "seconds": float("nan")},
        {"row": ROW[:5], "seconds": 1.0},
        *(
            {"row": [*ROW[:place], value, *ROW[place + 1 :]], "seconds": 1.0}
            for place, value in [
                (0, 10**15),
                (0, -1),
                (0, True),
                (0, "0"),
                (1, 7),
                (2, "good"),
                (3, ["1.0", 2.0]),
                (3, [float("inf"), 2.0]),
                (3, [10**400, 2.0]),
                (4, [1]),
                (5, None),
            ]
        ),
        {"path": 7},
        {"path": ["key"]},
        {"path": [["key"], "", ""]},
        {"path": ["key", "", None]},
    ],
    ids=lambda content: repr(content)[:40],
)
def test_a_line_with_a_true_checksum_that_is_no_result_is_named(begun, content):
    header, file = begun
    file.write_bytes(line(header) + line({"row": ROW, "seconds": 1.0}) + line(content))
    for opened in (lambda: Journal.read(file), lambda: merged([file]), lambda: read_and_open(file.parent)):
        with pytest.raises(FileError, match=r"study\.journal, line 3: this is no result of a study"):
            opened()


def read_and_open(folder: Path) -> Journal:
    return open_journal(*read_study(folder / "study.toml"), folder)


@pytest.mark.parametrize(
    "change",
    [
        {"version": 7},
        {"study": None},
        {"shard": [1.0, 1.0]},
        {"shard": [True, True]},
        {"shard": 1},
        {"shard": [2, 1]},
        {"format": 2},
    ],
    ids=str,
)
def test_a_header_with_a_true_checksum_that_is_none_is_named(begun, change):
    header, file = begun
    file.write_bytes(line({**header, **change}))
    with pytest.raises(FileError, match=r"study\.journal is no journal of cadgen explore"):
        merged([file])


def test_a_journal_with_rows_or_a_study_of_others_is_named(begun):
    header, file = begun
    for content in (
        line(header) + line({"row": [0, [70.0, 1.0], *ROW[2:]], "seconds": 1.0}),
        line({**header, "study": header["study"].replace("60", "61")}),
    ):
        file.write_bytes(content)
        with pytest.raises(FileError, match=r"study\.journal is of another study"):
            merged([file])


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes have no names here")
def test_a_pipe_or_device_is_no_journal_and_nobody_waits_for_it(tmp_path):
    (tmp_path / "study.toml").write_text(TEXT)
    os.mkfifo(tmp_path / "study.journal")
    for places in ([tmp_path / "study.journal"], [tmp_path]):
        with pytest.raises(FileError, match=r"study\.journal cannot be read \(it is a pipe and no regular file\)"):
            merged(places)
    with pytest.raises(FileError, match=r"study\.journal is no journal"):
        read_and_open(tmp_path)
    with pytest.raises(FileError, match=r"cannot be read \(it is a device and no regular file\)"):
        merged([Path("/dev/zero")])


CHOICE = Variation("a", values=("x", "y", "z"))
RANGE = Variation("b", least=1.0, most=3.0)
STEPS = Variation("c", least=1.0, most=3.0, step=0.5)
WHOLE = Variation("d", least=10, most=14, whole=True)


def test_a_full_factorial_has_every_combination_once():
    kinds = (CHOICE, STEPS, WHOLE)
    count = sampling.count("full_factorial", kinds, None)
    plan = sampling.plan("full_factorial", kinds, count, 1)
    assert count == 3 * 5 * 5
    assert len({plan(number) for number in range(count)}) == count
    assert {plan(number)[1] for number in range(count)} == {1.0, 1.5, 2.0, 2.5, 3.0}
    assert [plan(number)[2] for number in range(6)] == [10, 11, 12, 13, 14, 10]


@pytest.mark.parametrize("kind", ["sobol", "latin_hypercube"])
def test_a_plan_by_chance_spreads_evenly_and_repeats_by_its_seed(kind):
    kinds = (CHOICE, RANGE, WHOLE)
    plan, again, other = (sampling.plan(kind, kinds, 60, seed) for seed in (1, 1, 2))
    rows = [plan(number) for number in range(60)]
    assert rows == [again(number) for number in range(60)] != [other(number) for number in range(60)]
    assert all(1 <= row[1] <= 3 and isinstance(row[2], int) for row in rows)
    for column, levels in ((0, 3), (2, 5)):
        counts = Counter(row[column] for row in rows)
        assert len(counts) == levels
        assert max(abs(count - 60 / levels) for count in counts.values()) <= 4
    assert np.abs(np.sort([row[1] for row in rows]) - np.linspace(1, 3, 60)).max() < 0.1


@given(st.floats(0, 1, exclude_max=True))
def test_a_place_of_the_unit_interval_is_a_value(place):
    assert CHOICE.at(place) == CHOICE.values[int(3 * place)]
    assert abs(RANGE.at(place) - (1 + 2 * place)) < 1e-5
    assert STEPS.at(place) in (1.0, 1.5, 2.0, 2.5, 3.0)
    assert WHOLE.at(place) in (10, 11, 12, 13, 14)
