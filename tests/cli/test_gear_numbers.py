"""`cadgen gear`, `pair` and `planetary` in this process: files, design files that say the same, refusals."""

import json
import re

import numpy as np
import pytest
from click.testing import CliRunner

from cadgen import Design, Gear, GearPair, Planetary
from cadgen.cli import cli
from cadgen.errors import DesignError

SIZES = ("--module", "1", "--width", "6")


def run(*arguments):
    result = CliRunner().invoke(cli, [str(each) for each in arguments])
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


def test_a_gear(tmp_path):
    done = run("gear", "--teeth", 20, *SIZES, "--helix-deg", 20, "--bore", 5, "--formats", "stl", "--out", tmp_path)
    assert done.exit_code == 0
    assert "lead, mm" in done.output
    assert (tmp_path / "gear.stl").exists()
    ring = run(
        "gear", "--teeth", 50, "--internal", "--rim", 3, *SIZES, "--formats", "step", "--json", "--out", tmp_path
    )
    assert json.loads(ring.output)["rim_diameter_mm"] == pytest.approx(58.5)


@pytest.mark.parametrize(
    "flags",
    [
        ("--backlash-um", "150"),
        ("--internal", "--helix-angle-deg", "12", "--bore", "5,0", "--backlash-deg", "0.3", "--rim-mm", "3"),
        ("--profile-shift", "0.2,0.1", "--helix-deg", "25", "--double", "--hand", "left", "--grade", "6"),
    ],
)
def test_a_pair_and_the_design_file_that_says_the_same(flags, tmp_path):
    arguments = ("pair", "--teeth", "20,60", *SIZES, *flags)
    done = run(*arguments, "--json", "--formats", "csv", "--out", tmp_path)
    assert done.exit_code == 0
    stage = json.loads(done.output)["stages"][0]
    design = Design.from_toml(run(*arguments, "--toml").output, "pair", train_only=True)
    same = design.gears().entry().json()["stages"][0]
    assert same["play_as_cut_um"] == pytest.approx(stage["play_as_cut_um"], abs=1e-9)
    assert same["exact_least_um"] == pytest.approx(stage["exact_least_um"], abs=1e-6)
    assert same["centre_distance_mm"] == stage["centre_distance_mm"]


def test_a_planetary_set(tmp_path):
    done = run(
        "planetary", "--sun", 18, "--planet", 27, *SIZES, "--bore", "5,4,0", "--formats", "csv", "--out", tmp_path
    )
    assert done.exit_code == 0
    assert "The planets stand at 0.0000°, 120.0000°, 240.0000°" in done.output
    assert "no carrier holds them" not in done.output
    with pytest.raises(DesignError, match=r"give planets \(planet\.count\) = 2 or 3"):
        run("planetary", "--sun", 20, "--planet", 31, "--planets", 4, *SIZES)
    unequal = ("planetary", "--sun", 20, "--planet", 31, "--planets", 4, "--unequal", *SIZES)
    assert json.loads(run(*unequal, "--json", "--formats", "csv", "--out", tmp_path).output)["passed"]


def test_a_shift_that_is_rounding_is_none(tmp_path):
    flags = ("planetary", "--sun", 18, "--planet", 27, *SIZES, "--formats", "csv", "--out", tmp_path)
    said = run(*flags).output
    assert re.search(r"profile shift of the ring +0\n", said)
    assert "next: give --bore-diameter-mm for sun and planets" in " ".join(said.split())
    assert '"ring_profile_shift": 0.0' in (tmp_path / "manifest.json").read_text()


def test_a_part_is_laid_on_a_sheet_of_its_own_size_alone(tmp_path):
    (tmp_path / "pair.toml").write_text(run("pair", "--teeth", "12,45", "--module", 1, "--width", 6, "--toml").output)
    said = " ".join(run("draw", tmp_path / "pair.toml", "--out", tmp_path).output.split())
    scales = dict(re.findall(r"(\w+)_drawing\.pdf \w+ (\d+:\d+)", said))
    full = [f"pair{name}_drawing.pdf" for name, scale in scales.items() if scale == "1:1"]
    print(scales)
    assert 0 < len(full) < len(scales)
    assert f"next: print {', '.join(full)} at 100 %, and lay each part on its sheet" in said


def test_a_pair_that_jams_is_not_exported(tmp_path):
    done = run("pair", "--teeth", "20,60", *SIZES, "--backlash-um", 0, "--out", tmp_path)
    assert done.exit_code == 1
    assert "nothing was exported" in done.output
    assert not list(tmp_path.iterdir())


def test_a_pair_that_jams_names_a_grade_that_was_tried(tmp_path):
    asked = ("pair", "--teeth", "20,60", *SIZES, "--backlash-um", 50, "--out", tmp_path, "--formats", "csv")
    named = re.search(r"does\s+grade\s+(\d+)", run(*asked).output)
    assert run(*asked, "--grade", named[1]).exit_code == 0
    assert run(*asked, "--grade", int(named[1]) + 1).exit_code == 1


def test_a_bore_without_room_names_teeth_that_were_tried(tmp_path):
    asked = ("gear", "--module", "0.2", "--width", 3, "--bore", 1, "--out", tmp_path, "--formats", "stl")
    with pytest.raises(DesignError, match=r"too small for a bore.* give 10 teeth"):
        run(*asked, "--teeth", 4)
    with pytest.raises(DesignError, match="keep it within"):
        run(*asked, "--teeth", 9)
    assert run(*asked, "--teeth", 10).exit_code == 0


@pytest.mark.parametrize("backlash", [(), ("--backlash-um", "80"), ("--backlash-deg", "0.4")])
def test_the_largest_bore_of_a_pair_is_that_of_the_teeth_as_cut(tmp_path, backlash):
    asked = ("pair", "--teeth", "20,40", *SIZES, *backlash, "--formats", "csv", "--out", tmp_path)
    with pytest.raises(DesignError, match="keep it within") as refused:
        run(*asked, "--bore", "16,8")
    largest = float(re.search(r"keep it within ([\d.]+) mm", str(refused.value))[1])
    assert largest < 15.25  # that of teeth that are not thinned
    assert run(*asked, "--bore", f"{largest},8").exit_code == 0
    with pytest.raises(DesignError, match="keep it within"):
        run(*asked, "--bore", f"{largest + 0.01:.2f},8")


def test_a_gear_a_pair_and_a_set_judge_bores_by_the_root_as_cut():
    """A rack that cuts deeper by s leaves teeth thinner by 2 s tan α, and a root s deeper: d_f + E_sn / tan α."""
    sizes = {"module": 1, "width": 8}

    def largest(made):
        """Root that a refusal names, and the bore that it allows, once this and no more is accepted."""
        with pytest.raises(DesignError, match="keep it within") as refused:
            made(15.9)
        root, bore = re.search(r"root of ([\d.]+) mm; keep it within ([\d.]+) mm", str(refused.value)).groups()
        with pytest.raises(DesignError, match="keep it within"):
            made(float(bore) + 0.01)
        return made(float(bore)), float(root)

    def gear(bore, deviation=-0.1):
        return Gear(teeth=20, bore=bore, thickness_deviation=deviation, **sizes)

    def pair(bore):  # further apart than nominal teeth without play: these are thicker
        wheel = Gear(teeth=40, bore=8, **sizes)
        return GearPair(Gear(teeth=20, bore=bore, **sizes), wheel, backlash=0.02, centre_distance=30.2)

    def planetary(bore):
        planet = Gear(teeth=20, bore=bore, **sizes)
        return Planetary(Gear(teeth=20, **sizes), planet, planets=4, backlash=0.2)

    deviations = []
    for made, form in (
        (gear, lambda gear: gear.form),
        (pair, lambda pair: pair.cut.driver.form),
        (planetary, lambda planetary: planetary.cut.planet.form),
    ):
        fitted, root = largest(made)
        deviations.append(form(fitted).tooth_thickness_deviation)
        assert root == pytest.approx(20 - 2 * 1.25 + deviations[-1] / np.tan(np.radians(20)), abs=6e-3)
    assert deviations[0] < 0 < deviations[1]
    assert deviations[2] < 0
    with pytest.raises(DesignError, match="keep it within"):
        gear(15.9, None).part  # noqa: B018


def test_a_pair_says_the_range_of_its_play_as_its_design_file_does(tmp_path):
    flags = ("pair", "--teeth", "20,40", *SIZES, "--backlash-um", "80")
    ending = ("--formats", "csv", "--out", tmp_path)
    said = run(*flags, *ending).output
    ends = [
        float(re.search(rf"{end}play on the pitch circles{how}, µm +([\d.]+)", said)[1])
        for end, how in (("least ", ""), ("", " as cut"), ("greatest ", ""))
    ]
    (tmp_path / "pair.toml").write_text(run(*flags, "--toml").output)
    least, greatest, cut = re.search(
        r"([\d.]+)-([\d.]+) +([\d.]+)", run("gears", tmp_path / "pair.toml", *ending).output
    ).groups()
    assert [f"{end:.1f}" for end in ends] == [least, cut, greatest]


def test_the_design_file_of_a_pair_makes_the_files_of_the_pair(tmp_path):
    flags = ("pair", "--teeth", "20,60", *SIZES, "--backlash-um", "100")
    ending = ("--formats", "csv", "--out", tmp_path / "out")
    said = run(*flags, *ending).output
    assert re.search(r"ratio +3\n", said)
    names = {path.name for path in (tmp_path / "out").iterdir()}
    design = tmp_path / "pair.toml"
    design.write_text(run(*flags, "--toml").output)
    assert run("gears", design, *ending).exit_code == 0
    assert {path.name for path in (tmp_path / "out").iterdir()} == names
    # Of a train alone its sheets are drawn, and they name the files.
    assert run("draw", design, "--out", tmp_path / "out").exit_code == 0
    assert (tmp_path / "out" / "pair_1_pinion_drawing.pdf").exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("gear", "--teeth", 20), "--module-mm is missing"),
        (("pair", "--teeth", "20", *SIZES), "give 2 numbers"),
        (("pair", "--teeth", "20,x", *SIZES), "give a whole number, such as 20"),
        (("gear", "--teeth", "20.5", *SIZES), "--teeth is 20.5; give a whole number, such as 20"),
        (("gear", "--teeth", 20, *SIZES, "--helix-deg", "50"), "--helix-angle-deg is 50; give 0 to 45"),
        (("pair", "--teeth", "20,60", *SIZES, "--bore", "1,2,3"), "--bore-diameter-mm has 3 values; give one, or 2"),
        (("pair", "--teeth", "20,60", *SIZES, "--backlash-um", 1, "--backlash-deg", 1), "give one of them"),
        (
            ("pair", "--teeth", "20,60", *SIZES, "--module", "1,5"),
            "--module-mm is 1,5; give one number",
        ),
        (("gear", "--teeth", "20", *SIZES, "--width", "0,8"), "with a decimal point, such as 0.8"),
        (
            ("pair", "--teeth", "20,60", *SIZES, "--backlash-um", "50,5"),
            "--backlash-um is 50,5; give one number",
        ),
    ],
)
def test_flags_that_are_wrong(arguments, said):
    done = run(*arguments)
    assert done.exit_code == 2
    assert said in done.output


@pytest.mark.parametrize(
    "arguments",
    [
        ("planetary", "--sun", 18, "--planet", 27, "--planets", 3, "--module", "1", "--width", 6.5, "--bore", "5,4,0"),
        ("gear", "--teeth", 30, *SIZES, "--internal", "--helix-deg", 12, "--hand", "left", "--rim", 3),
    ],
)
def test_a_file_of_the_flags_says_the_same(arguments, tmp_path):
    file = tmp_path / "set.toml"
    file.write_text(run(*arguments, "--toml").output)
    assert run(arguments[0], file, "--toml").output == file.read_text()
    ending = ("--json", "--formats", "stl", "--out", tmp_path)
    by_file, by_flags = (json.loads(run(*given, *ending).output) for given in ((arguments[0], file), arguments))
    assert by_file["files"] == by_flags["files"]
    # A flag goes before the file.
    more = run(arguments[0], file, "--width", 7, "--toml").output
    assert "width_mm = 7" in more
    file.write_text(f"[{arguments[0]}]\nteeht = 3\n")
    wrong = run(arguments[0], file)
    assert wrong.exit_code == 2
    assert "has teeht, which is no flag" in wrong.output


def test_a_file_of_flags_is_no_design_and_names_its_command(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    flags = ("planetary", "--sun", 18, "--planet", 27, *SIZES, "--toml")
    (tmp_path / "pl.toml").write_text(run(*flags).output)
    for verb in ("check", "gears", "draw"):
        with pytest.raises(DesignError, match=r"flags of cadgen planetary.*: cadgen planetary pl\.toml"):
            run(verb, "pl.toml")


@pytest.mark.parametrize(
    ("helix", "internal", "size"),
    [("0", False, "over_pins"), ("15", False, "over_balls"), ("0", True, "between_balls")],
)
def test_the_sizes_of_a_train_are_named_by_what_they_are_measured_with(helix, internal, size):
    """A ring, and a helical gear with an odd number of teeth, are measured over balls alone."""
    pinion = Gear(teeth=19, module=1, width=8, helix_angle=np.radians(float(helix)))
    teeth = {"teeth": 60, "internal": True} if internal else {"teeth": 47, "hand": "left"}
    wheel = Gear(**teeth, module=1, width=8, helix_angle=np.radians(float(helix)))
    parts = GearPair(pinion, wheel, backlash=0.1).facts()["parts"]
    (gear,) = parts[1]["gears"]
    named = {name.rsplit("_", 2)[0] for name in gear if "_pins_" in name or "_balls_" in name}
    assert named == {size}
    assert ("ball_diameter_mm" in gear) == (size != "over_pins")
    assert gear[f"{size}_min_mm"] <= gear[f"{size}_max_mm"]


def test_a_pair_that_no_body_holds_is_not_printed_as_a_design():
    """A root of 9.5 mm has no room for a bore of 20."""
    result = run("pair", "--teeth", "12,40", "--module", 1, "--width", 8, "--bore-diameter", 20, "--toml")
    assert result.exit_code != 0
    assert "bore" in result.output
