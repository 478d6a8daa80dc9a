"""Flank lines of a gear: deviations, class and causes, on flanks that another program drew."""

import sys
from math import cos, pi, radians, sin, sqrt, tan
from pathlib import Path

import numpy as np
import pytest

from cadgen.api.design import Design
from cadgen.api.measured import Measured
from cadgen.errors import FileError
from cadgen.gears.flank_tolerances import class_reached, class_tolerance
from cadgen.verdict import Readiness
from tests.inference.gearing import flank_truth as truth
from tests.inference.gearing.test_train_errors import DESIGN

DESIGNED = Design.from_toml(DESIGN, train_only=True)
ALPHA, TEETH = radians(20.0), 61
GEAR = "gear: driven of stage 1"


def judged(*tables):
    return DESIGNED.judge_gear([Measured(columns, (GEAR,), f"data {n}") for n, columns in enumerate(tables)])


def pitches(centre=0j, table=0.0, noise=0.3, seed=1, form="index_um"):
    rng = np.random.default_rng(seed)
    found = truth.index_um(TEETH, 1.0, ALPHA, centre, table)
    rows = {"tooth": [], "flank": [], form: []}
    for side, name in ((1, "right"), (-1, "left")):
        index = found[side] + noise * rng.standard_normal(TEETH)
        values = index if form == "index_um" else np.diff(index, prepend=index[-1])
        rows["tooth"] += list(range(1, TEETH + 1))
        rows["flank"] += [name] * TEETH
        rows[form] += values.tolist()
    return rows


# ISO 1328-1:2013 for m_n 3, z 40, b 30, class 6, as two other programs print it; 8.94, 28.80 and 11.6 unrounded.
@pytest.mark.parametrize(("symbol", "printed"), [("f_p", 9.0), ("F_p", 29.0), ("F_alpha", 12.0)])
def test_tolerances_are_the_printed_ones(symbol, printed):
    assert 1e3 * class_tolerance(symbol, 120.0, 3.0, 30.0, 6) == pytest.approx(printed)


def test_two_classes_are_a_factor_of_two():
    for symbol in ("f_p", "F_p", "f_Halpha", "f_falpha", "F_alpha", "f_Hbeta", "f_fbeta", "F_beta", "F_r"):
        coarse = class_tolerance(symbol, 400.0, 8.0, 90.0, 9)
        assert coarse == pytest.approx(2 * class_tolerance(symbol, 400.0, 8.0, 90.0, 7), abs=1.5e-3)
        assert class_reached(symbol, 400.0, 8.0, 90.0, coarse) == 9
        assert class_reached(symbol, 400.0, 8.0, 90.0, coarse + 1e-4) == 10
    assert class_reached("f_p", 4.0, 1.0, 10.0, 0.001) is None


@pytest.mark.parametrize("form", ["index_um", "pitch_um"])
def test_teeth_off_the_axis_are_told_from_an_index_that_is_off(form):
    off, towards, table = 0.02, 1.1, 3e-4
    pitch = judged(pitches(off * np.exp(1j * towards), table, form=form)).pitch
    assert pitch.off.value == pytest.approx(off, abs=4 * pitch.off.sigma + 1e-4)
    assert pitch.towards == pytest.approx(towards, abs=0.02)
    assert pitch.table.value == pytest.approx(table * TEETH / 2, abs=4 * pitch.table.sigma + 1e-4)
    run_out = next(each for each in pitch.measured if each.symbol == "F_r")
    # 0.3 um of noise on two flanks are 0.6 um at the ball, and the greatest and least of 61 are taken.
    expected = truth.run_out_um(TEETH, 1.0, ALPHA, off * np.exp(1j * towards), table)
    assert 1e3 * run_out.worst == pytest.approx(expected, abs=3.0)


def test_run_out_is_that_of_a_ball_in_each_space():
    off, table = 0.02 * np.exp(1.1j), 3e-4
    run_out = next(each for each in judged(pitches(off, table, noise=0.0)).pitch.measured if each.symbol == "F_r")
    assert 1e3 * run_out.worst == pytest.approx(truth.run_out_um(TEETH, 1.0, ALPHA, off, table), rel=0.01)


def test_one_cause_alone_is_named_alone():
    eccentric = judged(pitches(0.02 * np.exp(2j))).pitch
    assert eccentric.table.value == 0.0
    indexed = judged(pitches(table=3e-4)).pitch
    assert indexed.off.value == 0.0
    assert indexed.table.clear


def profiles(tool=0.0, hob=0.0, noise=0.2, seed=2, by="roll_length_mm"):
    """Lines of four teeth; the tool has this error of its pressure angle, rad, and this run-out, mm."""
    roll, deviation = truth.profile_um(TEETH, 1.0, ALPHA, ALPHA + tool, hob)
    rng = np.random.default_rng(seed)
    place = roll if by == "roll_length_mm" else 2 * np.hypot(roll, TEETH / 2 * cos(ALPHA))
    rows = {"tooth": [], "flank": [], by: [], "profile_um": []}
    for tooth in (1, 16, 31, 46):
        for flank in ("left", "right"):
            rows["tooth"] += [tooth] * len(roll)
            rows["flank"] += [flank] * len(roll)
            rows[by] += place.tolist()
            rows["profile_um"] += (deviation + noise * rng.standard_normal(len(roll))).tolist()
    return rows


@pytest.mark.parametrize("by", ["roll_length_mm", "diameter_mm"])
def test_a_tool_of_another_pressure_angle_is_found(by):
    """Involutes of another base circle, met by the base tangents of the nominal one."""
    wrong = radians(0.08)
    profile = judged(profiles(wrong, by=by)).profile
    assert profile.tool.value == pytest.approx(wrong, rel=0.03)
    assert not profile.cutter.clear
    slope = next(each for each in profile.measured if each.symbol == "f_Halpha")
    # From where the pinion's tip makes contact, T - L_a1, to the tip of the gear.
    control = 40.5 * sin(ALPHA) - sqrt(11**2 - (10 * cos(ALPHA)) ** 2)
    whole = sqrt(31.5**2 - (30.5 * cos(ALPHA)) ** 2) - control
    assert slope.left == pytest.approx(-whole * tan(ALPHA) * wrong, abs=3e-4)
    assert not profile.between.clear


def test_run_out_of_the_hob_is_told_from_its_pressure_angle():
    wrong, hob = radians(0.05), 0.004
    profile = judged(profiles(wrong, hob)).profile
    assert profile.cutter.value == pytest.approx(hob, rel=0.05)
    assert profile.tool.value == pytest.approx(wrong, rel=0.1)
    form = next(each for each in profile.measured if each.symbol == "f_falpha")
    assert 2e3 * hob * sin(ALPHA) * 0.9 < 1e3 * form.worst < 2e3 * hob * sin(ALPHA) + 1.5


def test_the_machine_corrected_as_it_is_said_cuts_a_gear_without_these_errors():
    """Made again with each error less what was found of it: the slopes and the wave are gone."""
    wrong, hob = radians(0.08), 0.004
    found = judged(profiles(wrong, hob), helices()).profile
    again = judged(profiles(wrong - found.tool.value, hob - found.cutter.value, seed=7)).profile
    first, second = ({each.symbol: 1e3 * each.worst for each in profile.measured} for profile in (found, again))
    assert first["f_Halpha"] > 1.5 > 3 * second["f_Halpha"]
    assert first["f_falpha"] > 2 > second["f_falpha"]
    lead = judged(helices()).helix.angle.value
    corrected = judged(helices(lead=radians(0.05) - lead, seed=8)).helix
    assert abs(corrected.angle.value) < radians(0.001)


def test_slopes_are_of_the_range_of_evaluation_and_extrapolated():
    """ISO 1328-1:2013: end zones are left out, the mean line is told over the whole facewidth."""
    z = np.linspace(0, 8, 81)
    ends = np.where((z < 0.39) | (z > 7.61), -30.0, 0.0)  # ends that are rounded, and not evaluated
    rows = {
        "tooth": [1] * 81 + [31] * 81,
        "flank": ["right"] * 162,
        "face_mm": [*z, *z],
        "helix_um": [*(0.5 * z + ends), *(0.25 * z + ends)],
    }
    slope, form, total = judged(rows).helix.measured
    assert 1e3 * slope.right == pytest.approx(0.5 * 8)
    assert 1e3 * form.right == pytest.approx(0, abs=1e-9)
    assert 1e3 * total.right == pytest.approx(0.5 * 7.2)
    few = {name: [v for v, at in zip(values, rows["face_mm"], strict=True) if at < 4] for name, values in rows.items()}
    assert "cover 5" in str(judged(few))


LEAD, LEANING = radians(0.05), radians(0.04)


def helices(lead=LEAD, taper=0.004, leaning=LEANING, towards=0.6, seed=3):
    """Points of a flank on a part that leans, by its displacement at each height."""
    width = 8.0
    rng = np.random.default_rng(seed)
    z = np.linspace(0, width, 25)
    rows = {"tooth": [], "flank": [], "face_mm": [], "helix_um": []}
    for tooth in (1, 16, 31, 46):
        place = 2 * pi * (tooth - 1) / TEETH
        for name, side in (("right", 1), ("left", -1)):
            flank = place + side * pi / 2 / TEETH
            normal = np.exp(1j * (flank + side * pi / 2)) * cos(ALPHA) + np.exp(1j * flank) * np.sin(ALPHA)
            moved = leaning * z * (np.exp(1j * towards) * np.conj(normal)).real
            turned = side * tan(lead) * z * cos(ALPHA)
            rows["tooth"] += [tooth] * len(z)
            rows["flank"] += [name] * len(z)
            rows["face_mm"] += z.tolist()
            values = moved + turned + taper * z / width
            rows["helix_um"] += (1e3 * values + 0.1 * rng.standard_normal(len(z))).tolist()
    return rows


def test_lead_taper_and_leaning_are_told_apart():
    helix = judged(helices()).helix
    assert helix.angle.value == pytest.approx(radians(0.05), rel=0.03)
    assert helix.taper.value == pytest.approx(0.004, rel=0.05)
    assert helix.leaning.value == pytest.approx(radians(0.04), rel=0.05)


def test_spans_give_thickness_play_and_a_change():
    """W = m cos(alpha) ((k - 1/2) pi + z inv(alpha)) + E_sn cos(alpha), by hand; play by r_b."""
    thinned = -0.200
    involute = tan(ALPHA) - ALPHA
    span = cos(ALPHA) * (6.5 * pi + TEETH * involute) + thinned * cos(ALPHA)
    noise = np.array([0.0005, -0.0005, 0.0003, -0.0003])
    result = judged({"teeth_spanned": np.full(4, 7), "span_mm": span + noise})
    assert result.thickness.value == pytest.approx(thinned, abs=1e-3)
    driver = result.pair.driver.form.tooth_thickness_deviation
    assert result.play.value == pytest.approx(-(thinned + driver) / (TEETH / 2), rel=0.01)
    assert result.change > 0
    assert "too thin" in str(result)
    # Cut by the change that is asked for, the gear has the thickness and the pair the play of the design.
    right = judged({"teeth_spanned": np.full(4, 7), "span_mm": span + noise + result.change * cos(ALPHA)})
    assert right.readiness == Readiness.READY
    assert right.play.value == pytest.approx(right.pair.exact_play(), rel=2e-3)
    written = Design.from_toml(result.designs["reducer_as_built"], train_only=True)
    assert written.values.train.stages[0].driven.E_sn_um == pytest.approx(-200, abs=1)


def test_a_good_gear_is_ready_and_a_bad_one_is_not(tmp_path, monkeypatch, capsys):
    from cadgen.cli import interrupt, main

    assert judged(pitches(noise=0.5)).readiness == Readiness.READY
    monkeypatch.setattr(interrupt, "install", lambda: None)
    monkeypatch.chdir(tmp_path)
    Path("reducer.toml").write_text(DESIGN)
    rows = pitches(0.08 * np.exp(1j))
    text = "\n".join(",".join(map(str, row)) for row in zip(*rows.values(), strict=True))
    Path("pitch.csv").write_text(f"# {GEAR}\n{','.join(rows)}\n{text}\n")
    monkeypatch.setattr(sys, "argv", ["cadgen", "calibrate", "reducer.toml", "pitch.csv", "--out", "out"])
    with pytest.raises(SystemExit) as left:
        main()
    printed = capsys.readouterr().out
    assert left.value.code == 1
    assert "NOT READY" in printed
    assert "off the axis" in printed
    assert Path("out/reducer_as_built.toml").is_file()


def test_the_gear_must_be_known():
    rows = pitches()
    assert DESIGNED.judge_gear(Measured(rows)).stage == 0  # by its number of teeth
    with pytest.raises(FileError, match="does not say which gear"):
        DESIGNED.judge_gear(Measured({"teeth_spanned": [7], "span_mm": [20.0]}))
    with pytest.raises(FileError, match="gear of stage 3"):
        DESIGNED.judge_gear(Measured(rows, ("gear: driver of stage 3",)))
    with pytest.raises(FileError, match="not every tooth once"):
        judged({name: values[:-3] for name, values in rows.items()})
    with pytest.raises(FileError, match="no size of"):
        judged({"teeth_spanned": [7], "span_mm": [25.0]})
    with pytest.raises(FileError, match="within the base circle"):
        judged({"tooth": [1] * 3, "flank": ["left"] * 3, "diameter_mm": [28.0, 30.0, 31.0], "profile_um": [0, 1, 2]})


def test_lines_of_which_nothing_can_be_evaluated_are_refused():
    def helix(z, tooth=1):
        return {"tooth": [tooth] * len(z), "flank": ["right"] * len(z), "face_mm": z, "helix_um": [0.1] * len(z)}

    with pytest.raises(FileError, match="no line of three points"):
        judged(helix([0.0]))
    with pytest.raises(FileError, match="face_mm reaches 160"):
        judged(helix([0.0, 40.0, 80.0, 120.0, 160.0]))
    with pytest.raises(FileError, match="whole numbers of teeth"):
        judged(helix([0.0, 4.0, 8.0], tooth=1.5))
    with pytest.raises(FileError, match="whole numbers of teeth"):
        judged({"teeth_spanned": [7.4], "span_mm": [19.958]})
    rows = profiles()
    rows["roll_length_mm"] = [np.degrees(each / (TEETH / 2 * cos(ALPHA))) for each in rows["roll_length_mm"]]
    with pytest.raises(FileError, match="roll_length_mm reaches"):
        judged(rows)
    with pytest.raises(FileError, match="give one of them"):
        judged(pitches(), pitches(form="pitch_um"))


def test_a_short_line_is_a_reservation_and_corrects_nothing():
    z = np.linspace(0, 0.08, 50)
    rows = {"tooth": [1] * 50, "flank": ["right"] * 50, "face_mm": z, "helix_um": 0.6 * z}
    result = judged(rows)
    assert result.readiness == Readiness.RESERVATIONS
    assert "correct the machine" not in str(result)


def test_a_gear_within_its_own_zone_of_thickness_is_ready():
    zoned = DESIGN.replace("{ teeth = 61 }", "{ teeth = 61, E_sns_um = -60, T_sn_um = 80 }")
    involute = tan(ALPHA) - ALPHA
    for deviation, ready in ((-0.0899, True), (-0.030, False), (-0.170, False)):
        span = cos(ALPHA) * (6.5 * pi + TEETH * involute + deviation)
        measured = Measured({"teeth_spanned": [7, 7], "span_mm": [span, span + 1e-5]}, (GEAR,))
        result = Design.from_toml(zoned, train_only=True).judge_gear([measured])
        assert (result.readiness == Readiness.READY) is ready
        assert ("Cut it again" in str(result)) is (deviation == -0.030)


@pytest.mark.parametrize(
    ("old", "new", "readiness"),
    [
        ("width_mm = 8.0", 'width_mm = 3.0\nstandard = "free"', Readiness.RESERVATIONS),
        ("grade = 8", "grade = 12", Readiness.RESERVATIONS),
        ("{ teeth = 61 }", "{ teeth = 61, f_pt_um = 0.2 }", Readiness.NOT_READY),
        ("{ teeth = 61 }", "{ teeth = 61, f_pt_um = 9, F_r_um = 50 }", Readiness.READY),
    ],
)
def test_a_gear_without_a_class_is_judged_by_what_the_design_states(old, new, readiness):
    measured = Measured(pitches(), (GEAR,))
    assert Design.from_toml(DESIGN.replace(old, new), train_only=True).judge_gear([measured]).readiness == readiness


def test_independent_pitches_have_no_cause():
    named = 0
    for seed in range(40):
        noise = np.random.default_rng(seed).normal(0, 2, (2, TEETH)).ravel()
        teeth = [*range(1, TEETH + 1)] * 2
        rows = {"tooth": teeth, "flank": ["left"] * TEETH + ["right"] * TEETH, "pitch_um": noise}
        pitch = judged(rows).pitch
        named += any(each is not None and each.clear for each in (pitch.off, pitch.table))
    assert named <= 1


@pytest.mark.parametrize(("which", "teeth", "words"), [("driver", 20, "more helix"), ("driven", 61, "less helix")])
def test_a_right_hand_slope_is_less_helix_of_a_left_hand_gear(which, teeth, words):
    """A point of a right-hand tooth turns clockwise, along the count, on its way from the eye into the gear."""
    helical = Design.from_toml(DESIGN.replace("grade = 8", "grade = 8\nhelix_angle_deg = 15"), train_only=True)
    rows = helices(lead=radians(0.05), taper=0.0, leaning=0.0)
    rows["tooth"] = [min(tooth, teeth) for tooth in np.array(rows["tooth"]) // 4 + 1]
    result = helical.judge_gear([Measured(rows, (f"gear: {which} of stage 1",))])
    form = (result.pair.driver if which == "driver" else result.pair.driven).form
    hand = 1 if form.helix_angle > 0 else -1  # β > 0 is a right hand, which is the sense of these lines
    assert hand == (1 if words == "more helix" else -1)
    assert hand * result.helix.angle.value * (1 if words == "more helix" else -1) > 0
    assert words in str(result)


@pytest.mark.parametrize("exponent", [0.0, 1.0, 2.0])
def test_an_index_without_a_cause_has_none_however_its_power_falls(exponent):
    """Many machines add up the pitches themselves, whose index walks; 12 % of such had a cause by a fall with 1/k."""
    order = np.arange(TEETH // 2 + 1)
    named = 0
    for seed in range(40):
        rng = np.random.default_rng(seed)
        spectra = rng.standard_normal((2, len(order))) + 1j * rng.standard_normal((2, len(order)))
        spectra *= np.where(order > 0, np.maximum(order, 1) ** (-exponent / 2), 0.0)
        both = np.fft.irfft(spectra, TEETH)
        pitch = judged(indexed(both * 2 / both.std())).pitch
        named += any(each is not None and each.clear for each in (pitch.off, pitch.table))
    assert named <= 2


def test_a_run_out_among_as_large_an_index_error_is_not_named_where_both_fit():
    """It is there, and the flanks of few teeth lean too little to tell it from the table of the machine."""
    rng = np.random.default_rng(3)
    place = 2 * np.pi * np.arange(TEETH) / TEETH
    words = [str(judged(indexed(rng.normal(0, 4, (2, TEETH)) + 4 * np.sin(place)))) for _ in range(6)]
    assert any("both flanks fit run-out as well as the indexing" in " ".join(text.split()) for text in words)


def indexed(both):
    """Columns of an index by flank, left first, micrometres."""
    return {
        "tooth": np.tile(np.arange(1.0, TEETH + 1), 2),
        "flank": np.repeat(["left", "right"], TEETH),
        "index_um": np.concatenate(list(both)),
    }
