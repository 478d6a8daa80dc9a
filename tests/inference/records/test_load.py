"""Reading measured files: kinds by their columns, and a clear error for each way to get it wrong."""

import os

import numpy as np
import pytest

from cadgen.errors import FileError
from cadgen.inference.gearing.record_kinds import TRAIN
from cadgen.inference.measurement.record import instrument, join, printed
from cadgen.inference.records.load import MOST_BYTES, digest, load, load_text

pytestmark = pytest.mark.usefixtures("tricycle")

LIFT = "run,direction,cam_angle_deg,lift_mm\n" + "".join(f"1,forward,{k}.0,{0.01 * k:.3f}\n" for k in range(30))


@pytest.mark.parametrize(
    ("name", "kind", "runs"),
    [
        ("lift_a.csv", "lift", 3),
        ("profile_b.csv", "profile", 3),
        ("transmission_c.csv", "transmission", 3),
        ("track_a.csv", "track", 4),
        ("circles.csv", "steered track", 8),
        ("paper_section5.csv", "zones", 1),
    ],
)
def test_kind_follows_from_the_columns(name, kind, runs, measured):
    record = load(measured / name)
    assert (record.kind.code, record.runs) == (kind, runs)


@pytest.mark.slow
def test_remarks_tell_noise_and_print(measured):
    record = load(measured / "profile_b.csv")
    assert instrument(record).noise == 2.0
    assert instrument(record).unit == "um"
    assert printed(record)
    assert not printed(load(measured / "profile_a.csv"))
    assert instrument(load(measured / "circles.csv")) is None


def test_digest_is_that_of_sha256sum(tmp_path):
    path = tmp_path / "x.csv"
    path.write_bytes(b"abc")
    assert digest(path) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"


@pytest.mark.slow
def test_files_of_one_kind_join_with_their_runs_numbered_on(measured):
    one, two = load(measured / "circles.csv"), load(measured / "squares.csv")
    both = join([one, two])
    assert both.runs == 14
    assert len(both.run) == len(one.run) + len(two.run)
    with pytest.raises(FileError, match="cannot be joined"):
        join([one, load(measured / "lift_a.csv")])
    with pytest.raises(FileError, match="no measured file"):
        join([])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no table"),
        ("# only a remark\n", "no table"),
        (LIFT.replace("direction,", ""), "nearest is lift, which lacks direction"),
        (LIFT.replace("lift_mm", "lift_mm,x_mm"), "line 2: 4 cells under 5 columns"),
        (LIFT.replace("lift_mm", "lift_s"), "lacks lift_mm; say which it is with --columns lift_mm=NAME"),
        (LIFT.replace("run,", "run,run,", 1), "column run stands twice"),
        (LIFT.replace("0.050", "1e999"), "line 7: lift_mm is '1e999'"),
        (LIFT.replace("0.050", "five"), "line 7: lift_mm is 'five'"),
        (LIFT.replace("0.050", "5000"), "line 7: lift_mm is 5000, outside"),
        (LIFT.replace("1,forward,5.0,0.050", "1,forward,5.0"), "line 7: 3 cells under 4 columns"),
        (LIFT.replace("1,forward,5.0,", "1,up,5.0,"), "line 7: direction is 'up'"),
        (LIFT + "1,forward,5.0,0.050\n", "5 stands twice in one run"),
        (LIFT.replace("1,forward,29.0,0.290\n", "2,forward,29.0,0.290\n"), "run 2 has 1 rows"),
        (
            "run,direction,cam_angle_deg,lift_mm\n" + "".join(f"1,forward,{0.1 * k:.2f},0.01\n" for k in range(30)),
            "spans only",
        ),
    ],
)
def test_bad_files_are_refused(text, message, tmp_path):
    path = tmp_path / "bad.csv"
    path.write_text(text)
    with pytest.raises(FileError, match=message):
        load(path)


def test_a_missing_file_and_a_binary_one_are_refused(tmp_path):
    with pytest.raises(FileError, match="there is no file"):
        load(tmp_path / "absent.csv")
    (tmp_path / "binary.csv").write_bytes(b"\x01\x81\x02")
    with pytest.raises(FileError, match=r"binary\.csv is not text: give a CSV file"):
        load(tmp_path / "binary.csv")


def test_a_profile_that_goes_round_twice_is_refused(tmp_path):
    turned = np.linspace(0, 4 * np.pi, 200)
    rows = "".join(f"1,{60 * np.cos(t):.3f},{60 * np.sin(t):.3f}\n" for t in turned)
    path = tmp_path / "twice.csv"
    path.write_text("run,x_mm,y_mm\n" + rows)
    with pytest.raises(FileError, match=r"goes round 2.0 times"):
        load(path)


def test_marks_and_line_ends_of_other_systems_make_no_difference(tmp_path):
    (tmp_path / "plain.csv").write_text(LIFT)
    (tmp_path / "other.csv").write_bytes(
        b"\xef\xbb\xbf" + LIFT.replace("\n", "\r\n").replace("run,", '"run", ').encode()
    )
    plain, other = (load(tmp_path / f"{name}.csv") for name in ("plain", "other"))
    assert plain.kind == other.kind
    np.testing.assert_array_equal(plain["lift_mm"], other["lift_mm"])


def test_runs_written_in_turns_are_brought_together(tmp_path):
    head, *rows = LIFT.splitlines()
    second = [row.replace("1,f", "b,f") + "1" for row in rows]
    (tmp_path / "turns.csv").write_text(
        "\n".join([head, *(row for pair in zip(rows, second, strict=True) for row in pair)])
    )
    record = load(tmp_path / "turns.csv")
    assert record.runs == 2
    assert np.all(np.diff(record.run) >= 0)
    np.testing.assert_array_equal(record["cam_angle_deg"][:30], np.arange(30))


def test_copied_runs_are_no_repetition(tmp_path):
    (tmp_path / "copied.csv").write_text(LIFT + LIFT.split("\n", 1)[1].replace("1,f", "2,f"))
    with pytest.raises(FileError, match="runs 1 and 2 are the same to the last digit"):
        load(tmp_path / "copied.csv")


def test_a_cam_that_turns_twice_behind_its_train_is_refused(tmp_path):
    rows = "".join(f"1,{45.0 * k},{k}.{k % 7}\n" for k in range(500))
    (tmp_path / "twice.csv").write_text("run,motor_angle_deg,cam_angle_deg\n" + rows)
    with pytest.raises(FileError, match="turns by 499 degrees, so the angle goes round more than once"):
        load(tmp_path / "twice.csv")


def test_too_many_rows_are_refused(tmp_path):
    rows = "".join(f"1,{50 * np.cos(k / 4000)},{50 * np.sin(k / 4000)}\n" for k in range(21_000))
    (tmp_path / "many.csv").write_text("run,x_mm,y_mm\n" + rows)
    with pytest.raises(FileError, match=r"21000 rows, more than the 20000 .* keep one row in 2"):
        load(tmp_path / "many.csv")
    # Before any of them is read.
    (tmp_path / "many.csv").write_text("run,x_mm,y_mm\n" + "not a row\n" * 21_000)
    with pytest.raises(FileError, match=r"21000 rows, more than the 20000"):
        load(tmp_path / "many.csv")
    # A row of another length is refused where it stands.
    (tmp_path / "many.csv").write_text("run,x_mm,y_mm\n1,2,3\n" + "1,2,3,4\n" * 10_000)
    with pytest.raises(FileError, match=r"many.csv, line 3: 4 cells under 3 columns"):
        load(tmp_path / "many.csv")
    (tmp_path / "half.csv").write_text("run,x_mm,y_mm\n" + "".join(f"{row}\n" for row in rows.splitlines()[:10_500]))
    half = load(tmp_path / "half.csv")
    with pytest.raises(FileError, match=r"half.csv \+ half.csv: 21000 rows"):
        join([half, half])


def test_a_log_of_more_rows_than_can_be_thinned_is_refused_with_their_number():
    text = "input_angle_deg,output_angle_deg\n" + "0,0\n" * 400_001
    with pytest.raises(FileError, match=r"400001 rows, more than the 400000 .* keep one row in 2"):
        load_text(text, "log.csv", [TRAIN])


def test_too_many_runs_are_refused(tmp_path):
    """Each has columns of its own: of 8000 they would fill twelve gigabytes."""
    runs = [[f"{run},forward,{k},{run / 10 + k / 1000}\n" for k in range(30)] for run in range(101)]
    head = "run,direction,cam_angle_deg,lift_mm\n"
    (tmp_path / "runs.csv").write_text(head + "".join(map("".join, runs)))
    with pytest.raises(FileError, match=r"101 runs, more than the 100 .* keep one run in 2"):
        load(tmp_path / "runs.csv")
    (tmp_path / "half.csv").write_text(head + "".join(map("".join, runs[:51])))
    half = load(tmp_path / "half.csv")
    with pytest.raises(FileError, match=r"half.csv \+ half.csv: 102 runs"):
        join([half, half])


def test_too_many_rows_for_so_many_runs_are_refused(tmp_path):
    """Twenty thousand rows in a hundred runs would take more than two gigabytes."""
    rows = "".join(f"{run},forward,{k / 2},{run / 100 + k / 1000}\n" for run in range(60) for k in range(200))
    (tmp_path / "runs.csv").write_text("run,direction,cam_angle_deg,lift_mm\n" + rows)
    with pytest.raises(FileError, match=r"60 runs of 12000 rows in all, more than the 41 .* keep one row in 2"):
        load(tmp_path / "runs.csv")


@pytest.mark.skipif(os.name != "posix", reason="no such files there")
def test_only_regular_files_of_a_sensible_size_are_read(tmp_path):
    os.mkfifo(tmp_path / "pipe.csv")
    (tmp_path / "zero.csv").symlink_to("/dev/zero")
    (tmp_path / "huge.csv").touch()
    os.truncate(tmp_path / "huge.csv", MOST_BYTES + 1)
    (tmp_path / "escape\x1b[31m.csv").write_text("\x1b[31m" * 1000)
    for name, words in (("pipe", "a pipe and no"), ("zero", "a device and no"), ("huge", "larger than 32 MB")):
        with pytest.raises(FileError, match=words):
            load(tmp_path / f"{name}.csv")
    with pytest.raises(FileError) as caught:
        load(tmp_path / "escape\x1b[31m.csv")
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 800


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("# noise " + "1" * 1000 + "\nrun,x_mm,y_mm\n1,2,3\n", "line 1: 1008 characters, more than the 1000"),
        (",".join(f"c{k}" for k in range(400)) + "\n1,2\n", "line 1: .* characters, more than the 1000"),
        ("# dull\n" * 201 + "run,x_mm,y_mm\n1,2,3\n", "201 comment lines, more than 200"),
    ],
)
def test_long_lines_and_many_remarks_are_refused(tmp_path, content, words):
    (tmp_path / "long.csv").write_text(content)
    with pytest.raises(FileError, match=words):
        load(tmp_path / "long.csv")
