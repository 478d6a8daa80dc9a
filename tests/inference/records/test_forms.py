"""Forms in which people export a table: each is read as the same numbers, or refused with the reason."""

import csv
import io
import zipfile
from pathlib import Path

import numpy as np
import pytest

from cadgen.errors import FileError
from cadgen.inference.gearing.flank_kinds import GEAR_KINDS
from cadgen.inference.records.columns import Reading
from cadgen.inference.records.load import TRIAL, load, load_text, read_trials

ANGLES = np.arange(0.0, 360.0, 3.0)
# A track of a curve in mm, to a tenth; no two numbers of a row are equal.
X = np.round(4000 * np.sin(np.radians(ANGLES) / 3) + 0.3, 1)
Y = np.round(900 * np.sin(np.radians(ANGLES)) - 250.0, 1)
TRACK = {"run": ["1"] * len(X), "cam_angle_deg": ANGLES, "x_mm": X, "y_mm": Y}


def text(columns, *, mark=",", comma=False, digits="{:.6g}", end="\n", above=(), units=(), quote=False):
    """Table of columns by name as text."""
    out = io.StringIO(newline="")
    out.writelines(line + end for line in above)
    writer = csv.writer(out, delimiter=mark, lineterminator=end, quoting=csv.QUOTE_ALL if quote else csv.QUOTE_MINIMAL)
    writer.writerow(columns)
    if units:
        writer.writerow(units)
    for row in zip(*columns.values(), strict=True):
        cells = [cell if isinstance(cell, str) else digits.format(float(cell)) for cell in row]
        writer.writerow([cell.replace(".", ",") if comma else cell for cell in cells])
    return out.getvalue()


def named(run="run", angle="cam_angle_deg", x="x_mm", y="y_mm", by=(1.0, 1.0)):
    """Columns of the track under other names, in other units."""
    columns = {run: TRACK["run"]} if run else {}
    return columns | {angle: ANGLES * by[0], x: X * by[1], y: Y * by[1]}


SPACES = "\n".join(
    ["run cam_angle_deg x_mm y_mm", *(f"1  {a:g}   {x:.1f} {y:.1f}" for a, x, y in zip(ANGLES, X, Y, strict=True))]
)
FINE = {"digits": "{:.9g}"}
# Name -> (bytes of the file, words of the sentence that says what was understood).
READ = {
    "as the page says": (text(named()), ""),
    "byte order mark": ("﻿" + text(named()), ""),
    "line ends of Windows": (text(named(), end="\r\n"), ""),
    "line ends of old computers": (text(named(), end="\r"), ""),
    "quotes": (text(named(), quote=True), ""),
    "semicolons": (text(named(), mark=";"), "semicolons"),
    "semicolons and decimal commas": (text(named(), mark=";", comma=True), "decimal commas"),
    "tabs": (text(named(), mark="\t"), "tabs"),
    "tabs and decimal commas": (text(named(), mark="\t", comma=True), "decimal commas"),
    "bars": (text(named(), mark="|"), "bars"),
    "spaces": (SPACES, "spaces"),
    "quoted decimal commas": (text(named(), comma=True, quote=True), "decimal commas"),
    "UTF-16, little end first": (text(named(), mark="\t").encode("utf-16-le").join([b"\xff\xfe", b""]), "UTF-16"),
    "UTF-16, big end first": (b"\xfe\xff" + text(named(), mark="\t").encode("utf-16-be"), "UTF-16"),
    "UTF-16 without a mark": (text(named(), mark=";").encode("utf-16-le"), "UTF-16"),
    "code page 1252": (text(named(angle="Winkel [°]", x="x [mm]", y="y [mm]"), mark=";").encode("cp1252"), "CP1252"),
    "GB 18030": (
        text(named(run="次数", angle="凸轮转角(度)", x="X坐标(毫米)", y="Y坐标(毫米)")).encode("gb18030"),
        "GB18030",
    ),
    "Chinese": (text(named(run="次数", angle="凸轮转角/度", x="x坐标/毫米", y="y坐标/毫米")), "凸轮转角/度"),
    "German": (text(named("Lauf", "Nockenwinkel (Grad)", "X (mm)", "Y (mm)"), mark=";", comma=True), "Nockenwinkel"),
    "brackets": (text(named("Run", "Cam angle [deg]", "X [mm]", "Y [mm]")), 'x_mm is "X [mm]"'),
    "strokes": (text(named("run", "theta/deg", "x/mm", "y/mm")), '"theta/deg"'),
    "in words": (text(named("run no", "Camshaft angle in degrees", "pos x in mm", "pos y in mm")), "pos x in mm"),
    "metres": (text(named(x="x_m", y="y_m", by=(1.0, 1e-3)), **FINE), "times 1000"),
    "metres in brackets": (text(named(x="X (m)", y="Y (m)", by=(1.0, 1e-3)), **FINE), "times 1000"),
    "centimetres": (text(named(x="x [cm]", y="y [cm]", by=(1.0, 0.1)), **FINE), "times 10"),
    "inches": (text(named(x="x [in]", y="y [inch]", by=(1.0, 1 / 25.4)), **FINE), "times 25.4"),
    "radians": (text(named(angle="cam_angle_rad", by=(np.pi / 180, 1.0)), **FINE), "times 57.2958"),
    "turns": (text(named(angle="cam angle [turns]", by=(1 / 360, 1.0)), **FINE), "times 360"),
    "without units": (text(named("run", "theta", "x", "y")), "taken as mm"),
    "without runs": (text(named(run="")), "one run"),
    "columns that are not used": (
        text(named() | {"speed": ANGLES, "comment": ["a, b"] * len(X)}),
        "speed, comment not used",
    ),
    "time beside the angle": (text({"t_s": ANGLES / 10} | named()), "t_s not used"),
    "other order": (text(dict(reversed(named().items()))), ""),
    "lines above": (text(named(), above=("Exported by a camera", "2026-05-04, 10:00")), "line 3"),
    "a title in mm": (text(named("run", "theta", "x", "y"), above=("track in mm and no inches",)), "taken as mm"),
    "a size in a remark": (
        text(named("run", "theta", "x", "y"), above=("# design: mil_car", "# wheel of 2 inches")),
        "taken as mm",
    ),
    "a line of units": (
        text(named("run", "angle", "x", "y"), units=("", "deg", "mm", "mm")),
        "second line has the units",
    ),
    "a line of other units": (
        text(named("run", "angle", "x", "y", by=(1.0, 1e-3)), units=("", "[°]", "[m]", "[m]"), **FINE),
        "times 1000",
    ),
    "mark at the ends of lines": (text(named(), mark=";").replace("\n", ";\n"), "semicolons"),
    "the mark that a table names": ("sep=;\n" + text(named(), mark=";"), "semicolons"),
    "motor angle": (
        text(named(angle="motor_angle_deg", by=(45.0, 1.0)), **FINE),
        "divided by the ratio of the train, 45",
    ),
    "exponents": (text(named(), digits="{:.7e}"), ""),
    "gradians": (text(named(angle="cam angle [gon]", by=(400 / 360, 1.0)), **FINE), "times 0.9"),
    "degrees, minutes and seconds": (
        text(
            named("run", "cam angle", "x [mm]", "y [mm]")
            | {"cam angle": [f"{int(a) - 1}°59'60\"" if a else "0°" for a in ANGLES]},
            mark=";",
        ),
        "degrees, minutes and seconds",
    ),
    "thousands by apostrophes": (text(named() | {"x_mm": [f"{x:,.1f}".replace(",", "'") for x in X]}), ""),
    "thousands by thin spaces": (
        text(named() | {"x_mm": [f"{x:,.1f}".replace(",", "\u202f") for x in X]}, mark=";", comma=True),
        "decimal commas",
    ),
    "thousands by points": (
        text(
            named()
            | {
                "x_mm": [f"{x:,.1f}".translate(str.maketrans(",.", ".,")) for x in X],
                "y_mm": [f"{y:.1f}".replace(".", ",") for y in Y],
            },
            mark=";",
        ),
        "points that set thousands apart",
    ),
    "thousands by commas": (
        text(named() | {"x_mm": [f"{x:,.1f}" for x in X]}, quote=True),
        "commas set thousands apart",
    ),
    "summaries behind the rows": (
        text(named()) + "Mean,178.5,12.1,-250.0\nMax,357,3989,649\n",
        "lines that are no rows are passed over: 122, 123",
    ),
    "lines of a logger behind the rows": (text(named()) + "\nEND OF DATA\npoints: 120\n", "passed over: 123, 124"),
    "lost points": (
        text(named())
        .replace("\n", "\n1,7,NaN,NaN\n1,8,---,5\n1,9,,\n", 3)
        .replace("\n1,7,NaN,NaN\n1,8,---,5\n1,9,,\n", "\n", 2),
        "3 rows without a number are left out",
    ),
    "rows that were written twice": (
        "\n".join(line for k, line in enumerate(text(named()).splitlines()) for _ in range(1 + (k % 9 == 4))),
        "13 rows that repeat the one before",
    ),
    "units in cells": (
        text(
            {
                "run": TRACK["run"],
                "angle": [f"{a:g}°" for a in ANGLES],
                "x": [f"{x} mm" for x in X],
                "y": [f"{y / 10:.2f} cm" for y in Y],
            }
        ),
        'y_mm is "y [cm]" times 10',
    ),
    "another minus": (text(named()).replace("-", "−"), ""),
    "names in a remark": ("# " + SPACES, "a remark names its columns"),
    "remarks of another program": ("% camera 2\n// 30 Hz\n" + text(named()), ""),
    "names that run together": (text(named(angle="camAngleDeg", x="xMm", y="yMm")), '"camAngleDeg"'),
    "empty rows and columns": (text(named(), mark=";").replace("\n", ";;\n") + ";;;;;\n;;;;;\n", "semicolons"),
    "a line of words under the units": (
        text(named("run", "angle", "x", "y"), units=("", "deg", "mm", "mm")).replace(
            "mm,mm\n", "mm,mm\n,encoder,camera,camera\n"
        ),
        "passed over: 3",
    ),
    "a unit that is not needed": (
        text(named("run", "angle", "x", "y") | {"U": ANGLES}, units=("-", "°", "mm", "mm", "V")),
        "second line has the units",
    ),
    "fixed width": (
        f"{'Run':>5}{'Cam angle':>12}{'X pos':>12}{'Y pos':>12}\n{'deg':>17}{'mm':>12}{'mm':>12}\n"
        + "".join(f"{1:5d}{a:12.2f}{x:12.2f}{y:12.2f}\n" for a, x, y in zip(ANGLES, X, Y, strict=True)),
        "second line has the units",
    ),
    "a table drawn with bars": (
        "\n".join(
            f"| {line.replace(',', ' | ')} |"
            for line in text(named())
            .replace("\n", "\n-,-,-,-\n", 1)
            .replace("-,-,-,-", "---,---:,---:,---:")
            .splitlines()
        ),
        "bars",
    ),
    "wide marks": (text(named("次数", "凸轮转角（°）", "X（mm）", "Y（mm）")).replace(",", "，"), "凸轮转角（°）"),
    "a comment that rows lack": (text(named()).replace("y_mm", "y_mm,comment", 1), "comment not used"),
}
REFUSED = {
    "commas for both": (text(named(), comma=True).replace('"', ""), "cells under 4 columns"),
    "thousands": (
        "run;cam_angle_deg;x_mm;y_mm\n" + "".join(f"1;{k};{1000 + 7 * k:,};{k}\n" for k in range(-70, 90)),
        "decimal marks or set thousands apart, as in 1,000",
    ),
    "no names": (text(named()).split("\n", 1)[1], "no kind of measured data"),
    "positions by time": (text({"time": ANGLES / 10, "x": X, "y": Y}), "add cam_angle_deg beside them"),
    "two angles": (
        text(named() | {"theta [deg]": ANGLES}).replace("cam_angle_deg", "angle [deg]", 1),
        "may both be cam_angle_deg",
    ),
    "a unit that is none": (text(named(x="x [px]", y="y [px]")), "lacks x_mm, y_mm"),
    "points for thousands beside decimal commas": (
        "motor angle [deg];cam angle [deg]\n"
        + "".join(f"{90 * k:,};2_{k:04d}\n" for k in range(60)).replace(",", ".").replace("_", ","),
        "decimal marks or set thousands apart, as in 1.080",
    ),
    "a cam angle that is not understood beside the motor's": (
        text({"motor [deg]": ANGLES * 45, "pos 2 [deg]": ANGLES}),
        "lacks cam_angle_deg",
    ),
    "another unit under a name": (
        text(named("run", "angle", "x [mm]", "y [mm]"), units=("", "deg", "m", "m")),
        "another unit in the line under its name, m",
    ),
    "another unit in the cells": (
        text(named(x="x [cm]") | {"x [cm]": [f"{x} mm" for x in X]}),
        "named in another unit than its cells, mm",
    ),
    "two markers by one clock": (
        text({"t": ANGLES / 10, "angle [deg]": ANGLES, "x1": X, "y1": Y, "x2": X + 9, "y2": Y}),
        "no kind of measured data",
    ),
    "two markers by frames": (
        text({"frame": ANGLES, "x1": X, "y1": Y, "x2": X + 9 * np.sin(ANGLES), "y2": Y}),
        "no kind of measured data",
    ),
    "two markers of one body": (
        text({"angle": ANGLES, "x1": X, "y1": Y, "x2": X + 300, "y2": Y}),
        "no kind of measured data",
    ),
    "two wheels": (
        text({"angle": ANGLES, "x left": X, "y left": Y, "x right": X, "y right": Y + 80}),
        "no kind of measured data",
    ),
    "units in words under the names": (
        text(named("", "angle", "x", "y")).replace("\n", "\nin degrees,in inches,in inches\n", 1),
        "line 2: no number stands in it",
    ),
    "a unit behind the table": (
        text(named("run", "theta", "x", "y")) + "all positions in inches\n",
        "beside its table says inches",
    ),
    "a unit in the title of a run": (
        "Run 1 (inches),,\n" + text(named("", "angle", "x", "y")),
        "beside its table says inches",
    ),
    "a run under two heads": (text(named()) + text(named() | {"x_mm": X + 1.7}), "run 1 stands under another head"),
    "runs called min and mid": (
        "run,cam_angle_deg,x_mm,y_mm\n"
        + "".join(f"{run},{row}\n" for run in ("min", "mid") for row in text(named(run="")).splitlines()[1:]),
        "min begins a row that sums others up",
    ),
    "runs called mid and max": (
        "run,cam_angle_deg,x_mm,y_mm\n"
        + "".join(f"{run},{row}\n" for run in ("mid", "max") for row in text(named(run="")).splitlines()[1:]),
        "max begins a row that sums others up",
    ),
    "thousands in one column, decimals in another": (
        "motor angle [deg],cam angle [deg]\n" + "".join(f'"{1000 + 60 * k:,}",{6 * k + 0.25}\n' for k in range(60)),
        "set thousands apart, as in 1,000",
    ),
    "thousands by points alone": (
        "motor angle [deg];cam angle [deg]\n" + "".join(f"{90 * k:,};{2 * k}\n".replace(",", ".") for k in range(60)),
        "set thousands apart, as in 1.080",
    ),
    "last rows with a cell too many": (text(named(run="")).rstrip() + ",touched\n", "4 cells under 3 columns"),
    "75 minutes": (text(named(run="") | {"cam_angle_deg": [f"{a:g}°75'" for a in ANGLES]}), "finite number"),
    "a line that broke off": (text(named()).rstrip()[:-8] + "\n", "3 cells under 4 columns"),
    "a column that is mostly empty": (text(named() | {"x_mm": ["", "", "1.5"] * 40}), "finite number"),
    "a unit in a title alone": (
        text(named("run", "theta", "x", "y", by=(1.0, 0.1)), above=("positions in cm",)),
        r"says cm, and the column x has no unit: write it there, as in",
    ),
    "a unit in a remark alone": (
        text(named("run", "theta", "x", "y", by=(1.0, 1 / 25.4)), above=("# all in inches",)),
        "says inches, and the column x has no unit",
    ),
    "wrong unit": (text(named(angle="cam_angle_deg", by=(np.pi / 180, 1.0))), "spans only"),
}


def save(folder: Path, content) -> Path:
    path = folder / "track.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


@pytest.mark.parametrize("form", READ)
def test_a_form_is_read_as_the_same_numbers(form, tmp_path):
    content, said = READ[form]
    record = load(save(tmp_path, content), reading=Reading(ratio=45.0))
    assert record.kind.code == "track"
    assert record.runs == 1
    for column, values in (("cam_angle_deg", ANGLES), ("x_mm", X), ("y_mm", Y)):
        np.testing.assert_allclose(record[column], values, rtol=1e-6, atol=1e-5)
    notes = "; ".join(record.notes)
    assert said in notes
    assert bool(notes) == bool(said)


@pytest.mark.parametrize("form", REFUSED)
def test_a_form_that_is_unclear_is_refused(form, tmp_path):
    content, said = REFUSED[form]
    with pytest.raises(FileError, match=said):
        load(save(tmp_path, content), reading=Reading(ratio=45.0))


SECOND = np.round(X + 1.7, 1)
SEVERAL = {
    "numbers in names": text({"cam_angle_deg": ANGLES, "x1_mm": X, "y1_mm": Y, "x2_mm": SECOND, "y2_mm": Y}),
    "words before names": text({"angle": ANGLES, "Run 1 X": X, "Run 1 Y": Y, "Run 2 X": SECOND, "Run 2 Y": Y}),
    "the names again, beside": "Run 1,,,Run 2,,\n"
    + "\n".join(
        f"{one},{other}"
        for one, other in zip(
            text(named(run="")).splitlines(), text(named(run="") | {"x_mm": SECOND}).splitlines(), strict=True
        )
    ),
    "the names again, below": text(named(run="")) + "\n" + text(named(run="") | {"x_mm": SECOND}),
    "names and units again": text(named("", "angle", "x", "y"), units=("deg", "mm", "mm"))
    + text(named("", "angle", "x", "y") | {"x": SECOND}, units=("deg", "mm", "mm")),
    "titles": text(named(run="")).replace("\n", "\nRun 1\n", 1)
    + "Run 2,,\n"
    + text(named(run="") | {"x_mm": SECOND}).split("\n", 1)[1],
}


@pytest.mark.parametrize("form", SEVERAL)
def test_runs_beside_or_below_each_other_are_runs(form, tmp_path):
    record = load(save(tmp_path, SEVERAL[form]))
    assert record.kind.code == "track"
    assert record.runs == 2
    for rows, x in zip(record.parts, (X, SECOND), strict=True):
        np.testing.assert_allclose(record["cam_angle_deg"][rows], ANGLES)
        np.testing.assert_allclose(record["x_mm"][rows], x)


def test_lifts_there_and_back_beside_each_other_are_directions(tmp_path):
    there, back = np.cos(np.radians(ANGLES)), np.cos(np.radians(ANGLES)) - 0.004
    for one, other in (
        ("Hub auf [mm]", "Hub ab [mm]"),
        ("lift forward", "lift reverse"),
        ("升程（正转）", "升程（反转）"),
    ):
        record = load(save(tmp_path, text({"angle [deg]": ANGLES, one: there, other: back}, **FINE)))
        ways = record.columns["direction"]
        np.testing.assert_allclose(record["lift_mm"][ways == "forward"], there, atol=1e-6)
        np.testing.assert_allclose(record["lift_mm"][ways == "reverse"], back, atol=1e-6)


def test_angles_there_and_back_beside_each_other_are_read_in_the_order_of_the_motion(tmp_path):
    there, back = ANGLES, ANGLES + 0.3
    columns = {"motor angle [deg]": 45 * ANGLES, "cam forward [deg]": there, "cam back [deg]": back}
    record = load(save(tmp_path, text(columns, **FINE)))
    np.testing.assert_allclose(record["motor_angle_deg"], 45 * np.array([*ANGLES, *ANGLES[::-1]]))
    np.testing.assert_allclose(record["cam_angle_deg"], [*there, *back[::-1]], atol=1e-6)


def test_flanks_of_teeth_by_other_words_and_beside_each_other(tmp_path):
    teeth, left, right = np.arange(1, 21), np.sin(np.arange(20)), np.cos(np.arange(20))
    rows = "".join(
        f"{z};{side};{um / 1e3:.9f}\n"
        for side, row in (("L", left), ("rechts", right))
        for z, um in zip(teeth, row, strict=True)
    )
    beside = text({"Tooth": teeth, "Pitch left [µm]": left, "Pitch right [µm]": right}, **FINE)
    for content in ("Zahn-Nr.;Flanke;Einzelteilung [mm]\n" + rows, beside):
        record = load(save(tmp_path, content), GEAR_KINDS)
        for side, row in (("left", left), ("right", right)):
            mine = record.columns["flank"] == side
            np.testing.assert_array_equal(record["tooth"][mine], teeth)
            np.testing.assert_allclose(record["pitch_um"][mine], row, atol=1e-5)


def test_names_that_are_not_understood_can_be_given(tmp_path):
    path = save(
        tmp_path,
        text(named(angle="Pos 3", x="East", y="North [m]", by=(1.0, 1e-3)), **FINE).replace("East", "East [m]"),
    )
    given = {"cam_angle_deg": "Pos 3", "x_mm": "East [m]", "y_mm": "North [m]"}
    np.testing.assert_allclose(load(path, reading=Reading(columns=given))["y_mm"], Y, atol=1e-5)
    with pytest.raises(FileError, match="lacks x_mm, y_mm; say which it is with --columns x_mm=NAME"):
        load(path)
    with pytest.raises(FileError, match=r"no column West: write one of run, Pos 3, East \[m\]"):
        load(path, reading=Reading(columns={"x_mm": "West"}))
    with pytest.raises(FileError, match="no kind of data has such a column"):
        load(path, reading=Reading(columns={"z_mm": "East [m]"}))


def test_angles_of_the_motor_need_the_ratio(tmp_path):
    path = save(tmp_path, text(named(angle="motor_angle_deg", by=(45.0, 1.0))))
    with pytest.raises(FileError, match=r"angles of the motor, .* add \[train\]"):
        load(path)


def test_trial_runs_by_time_count_in_their_order(tmp_path):
    path = save(tmp_path, text({"time": ANGLES / 10, "x [m]": X / 1e3, "y [m]": Y / 1e3}, mark=";", **FINE))
    (record,) = read_trials([path])
    assert record.kind is TRIAL
    np.testing.assert_allclose(record["x_mm"], X, atol=1e-5)


def test_words_for_directions(tmp_path):
    rows = "".join(f"{way};{k},5;{k / 100:.2f}\n".replace(".", ",") for way in ("vor", "zurück") for k in range(30))
    record = load(save(tmp_path, "Richtung;Winkel (Grad);Hub (mm)\n" + rows))
    assert record.kind.code == "lift"
    assert set(record.columns["direction"]) == {"forward", "reverse"}


def test_a_workbook_is_read_by_its_first_sheet_with_rows(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    sheet = book.create_sheet("data")
    sheet.append(["Run", "Cam angle [deg]", "X [m]", "Y [m]", None])
    for row in zip(ANGLES.tolist(), (X / 1e3).tolist(), (Y / 1e3).tolist(), strict=True):
        sheet.append([1, *row])
    path = tmp_path / "track.xlsx"
    book.save(path)
    record = load(path)
    np.testing.assert_allclose(record["x_mm"], X, atol=1e-6)
    assert "sheet data" in record.notes


def test_of_several_sheets_that_with_the_data_is_read_and_others_like_it_are_named(tmp_path):
    """A cover before the data, and a run on each of two sheets."""
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.active.append(["Test of the car", "by hand"])
    path = tmp_path / "track.xlsx"
    for title in ("run 1", "run 2"):
        sheet = book.create_sheet(title)
        sheet.append(["Run", "Cam angle [deg]", "X [m]", "Y [m]"])
        for row in zip(ANGLES.tolist(), (X / 1e3).tolist(), (Y / 1e3).tolist(), strict=True):
            sheet.append([1, *row])
        book.save(path)
        record = load(path)
        np.testing.assert_allclose(record["x_mm"], X, atol=1e-6)
        assert any(note == "sheet run 1" for note in record.notes) == (title == "run 1")
    assert "sheet run 1 alone is read, and not run 2: save each sheet as a file of its own" in record.notes


def test_a_workbook_that_is_damaged_or_a_bomb_is_refused(tmp_path):
    pytest.importorskip("openpyxl")
    path = tmp_path / "track.xlsx"
    path.write_bytes(b"PK\x03\x04" + bytes(100))
    with pytest.raises(FileError, match="no workbook that can be read"):
        load(path)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as parts:
        parts.writestr("xl/sharedStrings.xml", bytes(210_000_000))
    with pytest.raises(FileError, match="holds 210 MB, more than the 200"):
        load(path)


@pytest.mark.parametrize(
    ("header", "row"),
    [
        ("motor forward [deg],cam forward [deg],motor reverse [deg],cam reverse [deg]", "{up},{there},{down},{back}"),
        ("motor forward [deg],cam forward [deg],motor reverse [deg],cam reverse [deg]", "{up},{there},{up},{same}"),
        ("motor [deg],cam forward [deg],cam reverse [deg]", "{up},{there},{same}"),
    ],
    ids=["in the order of time", "by rising angles", "beside one column of angles"],
)
def test_a_way_back_goes_back(header, row):
    """By rising angles the way back stands in the order of the way there; in time it falls already."""
    ups = [60.0 * k for k in range(60)]
    lines = [
        row.format(up=up, down=ups[-1] - up, there=up / 45, back=(ups[-1] - up) / 45 + 0.4, same=up / 45 + 0.4)
        for up in ups
    ]
    record = load_text("\n".join([header, *lines]), "train.csv")
    assert list(record.columns["motor_angle_deg"]) == [*ups, *reversed(ups)]
    np.testing.assert_allclose(record.columns["cam_angle_deg"][60:], np.array(ups[::-1]) / 45 + 0.4)


def test_degrees_and_minutes_stand_under_the_name_of_the_page_too():
    record = load_text(text({"cam_angle_deg": [f"{a:g}°30'" for a in ANGLES], "x_mm": X, "y_mm": Y}), "track.csv")
    np.testing.assert_allclose(record.columns["cam_angle_deg"], ANGLES + 0.5)
