"""The section [motion]: sources, units, and bad input, whose cures are put in and pass."""

import re
from copy import deepcopy
from dataclasses import dataclass
from math import degrees, pi, radians
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from cadgen import Design
from cadgen.cam.followers import table
from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.lift_rows import read_rows
from cadgen.design.load import complete_of, design_file
from cadgen.design.motion import MotionSection, motion_of
from cadgen.design.override import override
from cadgen.errors import DesignError
from cadgen.laws.unit import RAD


@dataclass(frozen=True)
class NoKeys:
    """A follower of which only the unit counts."""


SLIDE = FollowerKind(code="slide", meaning="", keys=NoKeys, build=lambda keys, seat: None)
ARM = FollowerKind(code="arm", meaning="", keys=NoKeys, build=lambda keys, seat: None, unit=RAD)


def made(values, kind=SLIDE):
    """Motion of raw values; a refusal is a ValueError with its sentence."""
    try:
        return motion_of(MotionSection.model_validate({"turns": "clockwise", **values}), kind)
    except ValidationError as error:
        said = str(error.errors()[0]["ctx"]["error"])
        raise ValueError(said.replace("{here}", "motion.segments.1")) from None
    except DesignError as error:  # exit code 2
        raise ValueError(error.message) from None


def cured(values, sentence):
    """Raw values after the changes that a sentence names, each as it stands there."""
    changed = {"motion": deepcopy(values) | {"turns": "clockwise"}}
    texts = re.findall(r"--set (motion\.\S+?=[^\s),]*)", sentence)
    texts += [f"{key}={value}" for key, value in re.findall(r'(motion\.[\w.]+) (?:to|=) ("?[\w.+-]*\w"?)', sentence)]
    assert texts, sentence
    for text in texts:
        override(changed, text)
    return changed["motion"]


def moves(height, angle, law="cycloidal", **more):
    return {"rise_mm": float(height), "in_deg": float(angle), "law": law, **more}


def dwell(angle):
    return {"dwell_deg": float(angle)}


FEEDER = [moves(14, 80, "polynomial_3_4_5"), dwell(50), moves(-14, 110, "modified_sine"), dwell(120)]
PLAIN = [moves(10, 120), dwell(120), moves(-10, 120)]
LOBE = [[float(a), float(5.0 * (1 - np.cos(radians(a))))] for a in range(0, 360, 10)]


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"segments": [moves(10, 120), dwell(110), moves(-10, 120)]}, "take 350 degrees; they must take 360"),
        (
            {"segments": [moves(10, 130), moves(-10, 240)]},
            "370 degrees; they must take 360: set motion.segments.2.",
        ),
        ({"segments": [moves(10, 120), dwell(120), moves(-9, 120)]}, "begins at 0 mm and ends at 1, which is a jump"),
        (
            {"segments": [moves(10, 120), dwell(120), {"to_mm": 1.0, "in_deg": 120.0, "law": "cycloidal"}]},
            "set motion.segments.3.to_mm to 0",
        ),
        (
            {"segments": [moves(10, 90), moves(10, 90, "constant_velocity"), moves(-20, 180)]},
            "the velocity jumps at 90 degrees from 0 to 6.366, at 180 degrees from 6.366 to 0 mm/rad",
        ),
        (
            {"segments": [dwell(60), moves(10, 120, "constant_velocity"), dwell(60), moves(-10, 120)]},
            "the velocity jumps at 60 degrees from 0 to 4.775, at 180 degrees from 4.775 to 0 mm/rad",
        ),
        ({"segments": [moves(10, 180), dwell(0), moves(-10, 180)]}, "motion.segments.2 is a dwell of 0 degrees"),
        ({"segments": [moves(10, 0), dwell(180), moves(-10, 180)]}, "motion.segments.1 rises in 0 degrees"),
        (
            {
                "segments": [
                    {
                        "in_deg": 180.0,
                        "law": "polynomial",
                        "conditions": [[0.0, 0, 0], [0.0, 0, 1], [180.0, 0, 10], [180.0, 1, 0]],
                    },
                    moves(-10, 180),
                ]
            },
            "motion.segments.1.conditions 1 and 2 are both for order 0 at 0 degrees: remove one",
        ),
        (
            {
                "segments": [
                    {
                        "in_deg": 180.0,
                        "law": "polynomial",
                        "to_mm": 10.0,
                        "conditions": [[180.0, 0, 10], [180.0, 1, 0]],
                    },
                    moves(-10, 180),
                ]
            },
            "motion.segments.1 has to_mm and a condition for the lift at its end, two for one value: remove to_mm",
        ),
        (
            {"segments": [moves(10, 180, reversed=True, powers=[4, 5, 6, 7]), moves(-10, 180)]},
            "segments.1.powers is not of",
        ),
        ({"segments": PLAIN, "points": LOBE}, "motion has segments and points, and takes one of motion.segments"),
        ({"segments": PLAIN, "smooth": True}, "motion.smooth is for a table, and the motion has segments: remove it"),
        ({"points": [*LOBE, [360.0, 0.0]]}, "remove the last one, which is the first one again"),
        ({"rows": LOBE, "table_unit": "deg"}, 'motion.table_unit is "deg", and a follower of kind "slide" moves in mm'),
    ],
)
def test_a_refusal_names_a_cure_that_works(values, words):
    with pytest.raises(ValueError, match=re.escape(words)) as refused:
        made(values)
    print(refused.value)
    text = str(refused.value)
    first = text.split(", or set motion.allow_velocity_jump")[0]
    assert made(cured(values, first)).q is not None


def test_a_velocity_may_jump_if_it_is_allowed():
    values = {"segments": [dwell(60), moves(10, 120, "constant_velocity"), dwell(60), moves(-10, 120)]}
    motion = made({**values, "allow_velocity_jump": True})
    np.testing.assert_allclose(np.degrees(motion.kinks), [60, 180])
    assert motion.jets(np.array([pi / 3]))[0, 1] == pytest.approx(10 / radians(120))
    assert motion.jets(np.array([pi / 3]), before=True)[0, 1] == 0
    thrice = {"segments": [moves(3, 60, "constant_velocity"), moves(-3, 60, "constant_velocity")], "repeat": 3}
    assert len(made({**thrice, "allow_velocity_jump": True}).kinks) == 6


def test_the_half_law_that_is_named_fits():
    """Half a cycloid has twice the mean velocity at its end, so it takes twice the angle of the straight line."""
    line = [moves(10, 90), moves(10, 60, "constant_velocity"), moves(10, 120, "half_cycloid_2")]
    with pytest.raises(ValueError, match="velocity jumps at 90 degrees") as refused:
        made({"segments": [*line, dwell(45), moves(-30, 45)]})
    fits = 'set motion.segments.1.law to "half_cycloid_1" with motion.segments.1.in_deg = 120 and '
    assert fits + "motion.segments.4.dwell_deg = 15" in str(refused.value)
    made({"segments": [moves(10, 120, "half_cycloid_1"), *line[1:], dwell(15), moves(-30, 45)]})
    whole = [moves(10, 120, "half_cycloid_1"), moves(10, 60, "constant_velocity"), moves(10, 120, "half_cycloid_2")]
    motion = made({"segments": [*whole, moves(-30, 60)]})
    assert motion.vdi == ("RG", "GG", "GR", "RR")
    assert motion.seams == ()


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([[0, 0], [10, 1], [5, 2], [20, 3], [30, 2], [40, 1]], "row 3 of motion.rows is at 5 degrees, after one at 10"),
        (
            [[0, 0], [10, 1], [10, 2], [20, 3], [30, 2], [40, 1]],
            "row 3 of motion.rows repeats the angle of the row bef",
        ),
        (
            LOBE[::-1],
            "the angles of motion.rows fall from row to row, but they must grow as the cam turns: change their signs",
        ),
        (
            [*LOBE[:2], LOBE[3], LOBE[2], *LOBE[4:]],
            "after one at 30, but angles must grow: sort the rows by their angles",
        ),
        ([*LOBE, [361, 0.0]], "reach over 361 degrees; they must reach over 360 at most"),
        (LOBE[:5], "motion.rows has 5 rows; it needs at least 6"),
    ],
)
def test_tables_in_disorder_are_refused(rows, words):
    rows = [[float(angle), float(lift)] for angle, lift in rows]
    with pytest.raises(ValueError, match=re.escape(words)):
        made({"rows": rows})
    if "sort" in words:  # and the sorted rows pass
        assert made({"rows": sorted(rows), "close": "ramps"}).covered[1] > 0


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"segments": [{**moves(10, 360, "polynomial"), "conditions": [[361.0, 1, 0]]}]}, "must be within the segment"),
        (
            {"segments": [{**moves(0, 360, "polynomial"), "conditions": [[1.0, 0.5, 0]]}]},
            "is for order 0.5; it must",
        ),
        (
            {
                "segments": [
                    moves(5, 90),
                    {"in_deg": 90.0, "law": "polynomial", "conditions": [[0.0, 0, 4], [90.0, 0, 0]]},
                    dwell(180),
                ]
            },
            "conditions give 4 mm at 0 degrees, where the motion has 5: set that or leave the condition out",
        ),
        (
            {"segments": [{"in_deg": 180.0, "law": "polynomial", "conditions": [[9.0, 1, 0]]}, moves(-10, 180)]},
            "motion.segments.1 ends at no height: add to_mm to it, or a condition [180, 0, lift]",
        ),
        (
            {"segments": [{**moves(0, 360, "polynomial"), "conditions": [[0.0, 2, 0], [180.0, 1, 0], [360.0, 2, 0]]}]},
            "motion.segments.1.conditions make no polynomial",
        ),
        (
            {"segments": [moves(1, 180, "valve_lobe", powers=[9, 8, 10, 11]), moves(-1, 180)]},
            "powers is [9, 8, 10",
        ),
        ({"harmonics": [[0.5, 1, 0]]}, "motion.harmonics.1 is for k = 0.5; k must be a whole number from 0 to 60"),
        ({"harmonics": [[1, 1, 0], [1, 0, 1]]}, "motion.harmonics.2 is for k = 1"),
        (
            {},
            "motion says nothing of the lift: add one of motion.segments, motion.points, motion.harmonics,",
        ),
        ({"table": "lobe.csv"}, "motion.table names a file whose rows were not read"),
        ({"points": [[0.0, 0], [10, 1], [5, 2], [20, 3], [30, 2], [40, 1]]}, "row 3 of motion.points is at 5 degrees"),
    ],
)
def test_other_contradictions_are_refused(values, words):
    with pytest.raises(ValueError, match=re.escape(words)):
        made(values)


def test_heights_angles_and_machine_degrees():
    slide, arm = made({"segments": FEEDER}), None
    swing = [{("rise_deg" if key == "rise_mm" else key): value for key, value in each.items()} for each in FEEDER]
    arm = made({"segments": swing}, ARM)
    theta = np.linspace(0.0, 2 * pi, 50)
    np.testing.assert_allclose(arm.jets(theta), np.radians(slide.jets(theta)), atol=1e-12)
    twice = [{key: 2 * value if key.endswith("_deg") else value for key, value in each.items()} for each in FEEDER]
    machine = made({"segments": twice, "machine_turns": 2.0})
    np.testing.assert_allclose(machine.jets(theta), slide.jets(theta), atol=1e-12)
    with pytest.raises(ValueError, match=r"take 720 degrees; they must take 360"):
        made({"segments": twice})
    with pytest.raises(ValueError, match=r"motion.segments.1.rise_mm is not of a follower"):
        made({"segments": FEEDER}, ARM)


def test_lobes_repeat_every_source():
    theta = np.linspace(0.0, 2 * pi / 3, 40)
    third = [{key: value / 3 if key.endswith("_deg") else value for key, value in each.items()} for each in FEEDER]
    harmonic = {"harmonics": [[0, 5, 0], [1, -5, 0.5]]}
    points = [[a / 3, lift] for a, lift in LOBE]
    for once, thrice in (
        ({"segments": FEEDER}, {"segments": third, "repeat": 3}),
        (harmonic, {**harmonic, "repeat": 3}),
        ({"points": LOBE}, {"points": points, "repeat": 3}),
        ({"rows": LOBE}, {"rows": points, "repeat": 3}),
    ):
        one, three = made(once), made(thrice)
        for lobe in range(3):
            expected = one.jets(3 * theta) * 3.0 ** np.arange(4)
            jets = three.jets(theta + lobe * 2 * pi / 3)
            np.testing.assert_allclose(jets[1:-1], expected[1:-1], atol=1e-8 * np.abs(expected).max())


def test_tables_in_inches_and_machine_degrees_are_the_same():
    theta = np.linspace(0.0, 2 * pi, 50)
    plain = made({"rows": LOBE})
    inches = made({"rows": [[angle, lift / 25.4] for angle, lift in LOBE], "table_unit": "inch"})
    machine = made({"rows": [[2 * angle, lift] for angle, lift in LOBE], "machine_turns": 2.0})
    cam = made({"rows": LOBE, "machine_turns": 2.0, "table_angle": "cam"})
    for other in (inches, machine, cam):
        np.testing.assert_allclose(other.jets(theta), plain.jets(theta), atol=1e-8)
    # A raised cosine is its own derivative: the spline through 36 points has its acceleration within 1e-4.
    assert np.abs(plain.jets(theta)[:, 2] - 5 * np.cos(theta)).max() < 1e-3


def test_a_law_for_the_top_runs_backwards_on_the_return():
    motion = made({"segments": [moves(10, 180, "double_harmonic"), moves(-10, 180, "double_harmonic")]})
    top = np.array([pi])
    assert motion.jets(top, before=True)[0, 2] == pytest.approx(-10 * pi**2 / pi**2)
    np.testing.assert_allclose(motion.jets(top)[0], motion.jets(top, before=True)[0], atol=1e-10)
    assert [seam.order for seam in motion.joints] == [None, None]
    assert motion.vdi == ("RU", "UR")
    other = [moves(10, 180, "double_harmonic"), moves(-10, 180, "double_harmonic", reversed=True)]
    assert [seam.order for seam in made({"segments": other}).seams] == [2, 2]


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("angle,lift\n0,1.5\n10,2\n", [[0, 1.5], [10, 2]]),
        ("\ufeffWinkel;Hub\r\n0;1,5\r\n10;2,0\r\n", [[0, 1.5], [10, 2]]),
        ("# measured\n0\t1.5\n\n10\t2  # top\n", [[0, 1.5], [10, 2]]),
        ("0 1.5\n-10 2e0\n", [[0, 1.5], [-10, 2]]),
        ("names, of\nangle, lift\n0, 1.5\n10 , 2\n", [[0, 1.5], [10, 2]]),
    ],
)
def test_rows_of_a_file(tmp_path, text, rows):
    file = tmp_path / "lobe.csv"
    file.write_text(text, encoding="utf-8")
    assert read_rows(file) == (rows, None)


@pytest.mark.parametrize(
    ("head", "stated", "factors", "unit"),
    [
        ("angle [deg], lift [in]", None, (1.0, 25.4), "mm"),
        ("angle_rad,lift_mm", None, (degrees(1.0), 1.0), "mm"),
        ("theta;Hub (µm)", None, (1.0, 1e-3), "mm"),
        ("angle,swing [deg]", None, (1.0, 1.0), "deg"),
        ("angle,lift", "inch", (1.0, 1.0), "inch"),
        ("angle,lift [in]", "inch", (1.0, 1.0), "inch"),
        ("Nockenwinkel [°];Hub [Zoll]", None, (1.0, 25.4), "mm"),
        ("angle_deg lift_in", None, (1.0, 25.4), "mm"),
        ("angle (deg) lift (thou)", None, (1.0, 0.0254), "mm"),
        ("deg, um\nangle, lift", None, (1.0, 1e-3), "mm"),
        ("angle,lift\ndeg,in", None, (1.0, 25.4), "mm"),
        ("angle [deg],lift [in]\nmeasured in May", None, (1.0, 25.4), "mm"),
        ("# angle_deg,lift_in", None, (1.0, 25.4), "mm"),
        ("# range 360 deg, resolution 1 um", None, (1.0, 1.0), None),
        ("theta, s", None, (1.0, 1.0), None),
        ("angle,lift [Spanne]", "inch", (1.0, 1.0), "inch"),
        ("Cam 2 (intake), rev. B\nangle,lift", None, (1.0, 1.0), None),
        ("Cam with sizes in mm and no inches\nangle,lift", None, (1.0, 1.0), None),
        ("# roller of 1 inch, lift at 0.05-inch, all in all\nangle,lift", None, (1.0, 1.0), None),
        ('"angle","lift"', None, (1.0, 1.0), None),
        ("all dimensions in inches\nangle,lift", "inch", (1.0, 1.0), "inch"),
        # A title that denies a unit, or names those of other things.
        ("Cam in mm, not inches\nangle,lift", None, (1.0, 1.0), None),
        ("Cam in mm, not inches", None, (1.0, 1.0), None),
        ("Cam in millimetres (not in inches)\nangle,lift", None, (1.0, 1.0), None),
        ("Maße in mm, nicht in Zoll\nWinkel;Hub", None, (1.0, 1.0), None),
        ("# converted from inches to mm\nangle,lift", None, (1.0, 1.0), None),
        ("凸轮，单位mm，不是英寸\n转角,升程", None, (1.0, 1.0), None),
        ("lift in mm, roller in inches\nangle,lift", None, (1.0, 1.0), None),
        ("Cam 7, all dimensions in inches\nangle,lift", None, (1.0, 25.4), "mm"),
    ],
)
def test_units_of_the_head_count(tmp_path, head, stated, factors, unit):
    file = tmp_path / "lobe.csv"
    file.write_text(f"{head}\n2 1.5\n3 2\n", encoding="utf-8")
    rows, found = read_rows(file, stated)
    np.testing.assert_allclose(rows, np.array([[2, 1.5], [3, 2]]) * factors)
    assert found == unit


@pytest.mark.parametrize(
    ("head", "bases", "words"),
    [
        (
            "angle,lift [ell]",
            ("mm", "deg"),
            'of lobe.csv is "ell" by its first lines, which does not do here: write mm',
        ),
        ("angle [ell],lift", ("mm", "deg"), 'the unit of the angle in lobe.csv is "ell" by its first lines'),
        ("Cam 7 all dimensions in inches\nangle,lift", ("mm",), "lobe.csv, line 1, says inches, and no column has"),
        ("# lift in Inches", ("mm", "deg"), "lobe.csv, line 1, says Inches, and no column has a unit: write it beside"),
        ('angle,lift"', ("mm",), 'lobe.csv, line 1, says ", and no column has a unit'),
        ("凸轮7单位为英寸\n转角,升程", ("mm",), "lobe.csv, line 1, says 英寸, and"),
        # Never in mm where the lift may be in inches.
        ("Cam in inches, not mm\nangle,lift", ("mm",), "line 1, says inches, and no column has a unit"),
        ("Alle Maße in Zoll (nicht mm)\nangle,lift", ("mm",), "line 1, says Zoll, and no column has a unit"),
        ("sizes in mm except lift in inches\nangle,lift", ("mm",), "line 1, says inches, and no column has a unit"),
        ("lift in inches; roller in mm\nangle,lift", ("mm",), "line 1, says inches, and no column has a unit"),
        ("单位为英寸，不是毫米\n转角,升程", ("mm",), "line 1, says 英寸, and no column has a unit"),
        ("lifts, but not in mm\nangle,lift", ("mm",), "line 1, says not mm, and no column has a unit"),
        ("angle [deg],radius [mm]", ("mm",), 'of lobe.csv is called "radius [mm]", and lifts are needed: subtract'),
        ("# theta, Pitch radius", ("mm",), 'is called "Pitch radius", and lifts'),
        ("angle,load [N]", ("Nm",), 'is "N" by its first lines, which does not do here: write N·mm, Nm there'),
    ],
)
def test_a_unit_that_is_not_known_is_refused(tmp_path, monkeypatch, head, bases, words):
    monkeypatch.chdir(tmp_path)
    Path("lobe.csv").write_text(f"{head}\n2,1.5\n3,2\n", encoding="utf-8")
    with pytest.raises(DesignError, match=re.escape(words)):
        read_rows(Path("lobe.csv"), bases=bases)


def test_a_lift_in_mm_is_refused_where_an_arm_turns(tmp_path):
    """The head of the file says the unit, so no key can be named that changes it."""
    (tmp_path / "lobe.csv").write_text("angle;lift [mm]\n2;1,5\n3;2\n")
    (tmp_path / "lever.toml").write_text(
        '[motion]\nturns = "clockwise"\ntable = "lobe.csv"\n'
        '[follower]\nkind = "swinging_roller"\nradius_mm = 8\narm_mm = 70\ncentre_distance_mm = 90\nlifts = "with"\n'
        "[cam]\nthickness_mm = 8\nbase_circle_radius_mm = 40\n"
    )
    with pytest.raises(DesignError, match=r'lobe.csv is "mm" by its first lines, .* write deg, rad there'):
        Design.load(tmp_path / "lever.toml")


@pytest.mark.parametrize(("unit", "value"), [("N·mm", 1500.0), ("Nm", 1.5)])
def test_moments_of_a_load_are_in_newton_millimetres(tmp_path, unit, value):
    file = tmp_path / "load.csv"
    file.write_text(f"angle [deg],load [{unit}]\n0,{value}\n180,{value}\n", encoding="utf-8")
    assert read_rows(file, bases=("Nm",))[0] == [[0, 1500], [180, 1500]]


def test_another_unit_than_that_of_the_head_is_refused(tmp_path):
    file = tmp_path / "lobe.csv"
    file.write_text("angle,lift [mm]\n2,1.5\n", encoding="utf-16")
    with pytest.raises(DesignError, match=r'is "mm" by its first lines, and motion.table_unit is "inch": remove'):
        read_rows(file, "inch")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"0,1\n1,2,3\n", r"lobe.csv, line 2: `1,2,3` is no row: write an angle and a lift, two numbers"),
        (b"0,1\n1,x\n", "line 2: `1,x` is no row"),
        (b"0,1\n1,nan\n", "line 2: `1,nan` is no row"),
        (b"", "has no rows"),
        (b"0,1\n\x01\x02\xff", "is not text: give a CSV file"),
        (b"0,1\n" * 20_001, "has more than 20000 rows"),
        (None, "there is no such file: correct the path, which counts from the folder of the design file"),
    ],
)
def test_files_that_are_no_table(tmp_path, content, words):
    file = tmp_path / "lobe.csv"
    if content is not None:
        file.write_bytes(content)
    with pytest.raises(DesignError, match=re.escape(words)):
        read_rows(file)


def test_a_table_is_read_beside_the_design_and_kept(tmp_path, monkeypatch):
    """The rows become values of the design: a hash, a copy and a process of its own need no file."""
    (tmp_path / "lobe.csv").write_text("\n".join(f"{angle},{lift}" for angle, lift in LOBE), encoding="utf-8")
    text = """
name = "lobe"
[motion]
turns = "clockwise"
table = "lobe.csv"
[follower]
kind = "slide"
[cam]
base_circle_radius_mm = 32.0
thickness_mm = 10.0
"""
    (tmp_path / "lobe.toml").write_text(text, encoding="utf-8")
    table.register(SLIDE)
    try:
        design = Design.load(tmp_path / "lobe.toml")
        assert design.values.motion.rows == tuple((angle, lift) for angle, lift in LOBE)
        thicker = design.with_({"cam.thickness_mm": 11.0})
        assert thicker.values.motion.rows == design.values.motion.rows
        (tmp_path / "other.csv").write_text("\n".join(f"{a},{lift / 2}" for a, lift in LOBE), encoding="utf-8")
        other = design.with_({"motion.table": "other.csv"})
        assert other.values.motion.rows[18][1] == LOBE[18][1] / 2
        assert other.sha256 != design.sha256
        monkeypatch.chdir(tmp_path)
        with pytest.raises(DesignError, match="there is no such file"):
            design.with_({"motion.table": str(Path("none.csv"))})
    finally:
        table.remove(SLIDE)


@pytest.mark.parametrize("key", ["closure", "radius_mm", "clearance_mm", "lifts"])
def test_a_key_of_another_follower_is_told_with_its_kinds(key):
    text = """
[motion]
turns = "clockwise"
segments = [{ to_mm = 3, in_deg = 180, law = "cycloidal" }, { to_mm = 0, in_deg = 180, law = "cycloidal" }]
[follower]
kind = "flat"
[cam]
base_circle_radius_mm = 20
thickness_mm = 5
"""
    with pytest.raises(DesignError) as refused:
        complete_of(text.replace('"flat"', f'"flat"\n{key} = 1'), Path("cam.toml"), ())
    said = str(refused.value)
    assert f"follower.{key} is a key of " in said
    assert 'and follower.kind is "flat", under which [follower] takes kind, tilt_deg' in said
    assert said.endswith(": remove it")
    assert "train." not in said


def test_a_table_that_is_too_large_is_told_what_to_keep(tmp_path):
    (tmp_path / "lobe.csv").write_text("0.000000000000000,1.000000000000000\n" * 60_000, encoding="utf-8")
    with pytest.raises(DesignError, match=r"larger than 2 MB, the most that is read: keep two columns"):
        read_rows(tmp_path / "lobe.csv")


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        (("[follower]", "[folower]"), r"\[folower\] is not a section: write \[follower\]"),
        (('law = "cycloidal" }]', 'law = "cycloidl" }]'), r'law is "cycloidl": did you mean "cycloidal"\?$'),
    ],
)
def test_what_is_misspelt_is_named_with_what_was_meant(wrong, said):
    text = """
[motion]
turns = "clockwise"
segments = [{ to_mm = 3, in_deg = 180, law = "cycloidal" }, { to_mm = 0, in_deg = 180, law = "cycloidal" }]
[follower]
kind = "flat"
[cam]
base_circle_radius_mm = 20
thickness_mm = 5
"""
    with pytest.raises(DesignError, match=said):
        complete_of(text.replace(*wrong), Path("cam.toml"), ())


@pytest.mark.parametrize("key", ["tabs", "drilling"])
def test_programs_that_a_groove_has_not_are_refused(key):
    file = design_file("groove")
    text = file.read_text(encoding="utf-8")
    with pytest.raises(DesignError, match=rf"machining\.{key} is of the programs of an outline, .* remove it"):
        complete_of(text, file, [f"machining.{key}={{}}"])
    complete_of(text, file, [f"machining.{key}={{}}", f"machining.{key}="])
