"""The roller on a slide, offset and moved by [motion]: textbooks, rolling, and every command."""

import json
import pickle
import re
from dataclasses import dataclass, replace
from math import radians

import ezdxf
import numpy as np
import pytest
from build123d import import_step

from cadgen import Design, Report, draw
from cadgen.arrays import TURN
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.envelope import actual_profile
from cadgen.cam.follower import Follower
from cadgen.cam.followers.kind import FollowerGuide
from cadgen.cam.followers.rod import LeaningRod
from cadgen.cam.followers.rod_kind import ROD
from cadgen.cam.followers.roller import Roller
from cadgen.cam.followers.roller_kind import ROLLER
from cadgen.design.load import complete_of, design_of
from cadgen.errors import CadgenError, DesignError
from cadgen.laws.segments import MotionSpan, SegmentMotion
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM, RAD, TAN

TEXT = """
name = "feeder"

[motion]
turns = "clockwise"
speed_rpm = 420
segments = [
    { to_mm = 14.0, in_deg = 80.0, law = "polynomial_3_4_5" },
    { dwell_deg = 50.0 },
    { to_mm = 0.0, in_deg = 110.0, law = "cycloidal" },
    { dwell_deg = 120.0 },
]

[follower]
kind = "roller"
radius_mm = 9.0
offset_mm = 8.0

[cam]
base_circle_radius_mm = 32.0
thickness_mm = 10.0
"""
STEP = radians(1.0)


def motion(*spans):
    """Motion of spans: angle in degrees, height at the end in mm, and law; None for a dwell."""
    segments, at, height = [], 0.0, 0.0
    for angle, after, law in spans:
        stop = at + angle
        segments.append(MotionSpan(radians(at), radians(stop), height, after, law and law_of(law)))
        at, height = stop, after
    return SegmentMotion.of(segments, MM)


FEEDER = motion((80, 14.0, "polynomial_3_4_5"), (50, 14.0, None), (110, 0.0, "cycloidal"), (120, 0.0, None))


@pytest.mark.parametrize("offset", [0.0, 8.0, -8.0])
def test_envelope_and_rolling_agree_with_the_textbook(offset):
    """The centre stands at y0 + s ahead and e across; tan(alpha) = (s' - e) / (y0 + s)."""
    roller = Roller(base=32.0, radius=9.0, offset=offset)
    profile = actual_profile(FEEDER, roller)
    assert profile.trims == ()
    theta = np.linspace(0.0, TURN, 1440, endpoint=False)
    s, slope, y0 = FEEDER.q(theta), FEEDER.q(theta, nu=1), np.sqrt(41.0**2 - offset**2)
    alpha = np.arctan2(slope - offset, y0 + s)
    contact, _ = roll_curve(profile.curve, roller, theta)
    print(f"rolled {np.abs(contact.lift - s).max() * 1e3:.5f} um off")
    assert np.abs(contact.lift - s).max() < 2e-5
    assert np.abs(contact.pressure_angle - alpha).max() < 3e-4
    point = ((y0 + s + 1j * offset) - 9.0 * np.exp(-1j * alpha)) * np.exp(1j * theta)
    jet, _ = profile.curve.at_angle(np.angle(point))
    assert np.abs(jet.point @ [1, 1j] - point).max() < 1e-9
    # The path of the centre, followed by a point beside the ray.
    pitch = roller.pitch_curve(FEEDER)
    axis = roll(pitch.outline(0.005), roller.point(), theta)
    assert np.abs(axis.lift - s).max() < 2e-5
    assert np.abs(axis.pressure_angle - alpha).max() < 2e-3


def test_brute_force_cuts_no_more_than_the_envelope():
    """Rays cut by the roller at 20 000 cam angles, without a derivative: the least of a - sqrt(r^2 - c^2)."""
    roller = Roller(base=32.0, radius=9.0, offset=8.0)
    curve = actual_profile(FEEDER, roller).curve
    theta = np.linspace(0.0, TURN, 20_000, endpoint=False)
    z = (np.sqrt(41.0**2 - 64.0) + FEEDER.q(theta) + 8.0j) * np.exp(1j * theta)
    phi = np.linspace(0.0, TURN, 97, endpoint=False)
    w = z[:, None] * np.exp(-1j * phi)
    inside = np.abs(w.imag) < 9.0
    near = np.where(inside & (w.real > 0), w.real - np.sqrt(np.where(inside, 81.0 - w.imag**2, 0.0)), np.inf)
    assert np.abs(near.min(axis=0) - curve.radius(phi)).max() < 1e-5


def test_quintic_pieces_follow_a_law():
    """A cycloid of 110 degrees by 64 pieces: within 1e-9 of the rise, its second derivative within 1e-5."""
    u = np.linspace(0.0, 1.0, 4001)[1:-1]
    theta, width = radians(130) + u * radians(110), radians(110)
    exact = 14.0 * (np.array([1.0, 0, 0]) - law_of("cycloidal").jet(u)[:, :3]) / width ** np.arange(3)
    for order, within in ((0, 1e-8), (1, 1e-6), (2, 1e-4)):
        assert np.abs(FEEDER.q(theta, nu=order) - exact[:, order]).max() < within


def test_peaks_and_valleys_are_where_dwells_begin():
    peaks, valleys = FEEDER.extrema()
    np.testing.assert_allclose(np.degrees(peaks), [80.0])
    np.testing.assert_allclose(np.degrees(valleys), [240.0])


def plan_motion_cam(design):
    from cadgen.jobs.cam.motion_cam import plan_motion_cam

    return plan_motion_cam(design)


def loaded(changes=()):
    from pathlib import Path

    return complete_of(TEXT, Path("feeder.toml"), changes)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            "motion.segments.2.dwell_deg=40",
            "take 350 degrees; they must take 360: set motion.segments.4.dwell_deg to 130",
        ),
        (
            "motion.segments=[{to_mm=4, in_deg=3.1416, law='cycloidal'}, {to_mm=0, in_deg=3.1416, law='cycloidal'}]",
            "as angles in radians do, and they are degrees: multiply each in_deg and dwell_deg by 57.295",
        ),
        (
            "motion.segments.3.to_mm=1",
            "the motion begins at 0 mm and ends at 1, which is a jump at cam angle 0: set motion",
        ),
        (
            "motion.segments.1.law=square",
            'motion.segments.1.law is "square"; it must be "polynomial_2_3", "polynomial_3_4_5", ',
        ),
        ("motion.segments.2.in_deg=3", "a dwell has no other key"),
        ("motion.segments.1.in_deg=", "it needs dwell_deg alone, or in_deg, law and one of to_mm"),
        ("motion.segments.1={to_deg=3, in_deg=80, law='cycloidal'}", "motion.segments.1.to_deg is not of a follower"),
        ("motion.segments.2.to_mm=3", "motion.segments.2 has dwell_deg and to_mm"),
        ("motion.segments.3.law=", "motion.segments.3 has to_mm and in_deg"),
        ("motion.segments=[]", "motion says nothing of the lift: add one of motion.segments, motion.points, motion.ha"),
        ("motion.segments=", "motion says nothing of the lift: add one of motion.segments, motion.points, motion.har"),
        ("motion.turns=", 'motion.turns is missing: add it, "clockwise" or "counterclockwise"'),
        (
            "follower={kind='rod', radius_mm=3}",
            'follower.kind is "rod", which leans with a fork: give cam.base_radius_mm',
        ),
        ("follower={radius_mm=3}", "follower.kind is missing, and the design has [motion]: add it to the section"),
        ("follower=", "follower.kind is missing, and the design has [motion]: add it to the section"),
        (
            "follower.kind=rollr",
            '--set follower.kind=rollr: follower.kind is "rollr"; it must be "rod", "roller", ',
        ),
        ("blank.edge_break_mm=4.99", "leave no land of at least 0.1 mm for the follower"),
        (
            "cam.base_radius_mm=70",
            "cam.base_circle_radius_mm and cam.base_radius_mm both fix the base circle: remove one",
        ),
        ("follower.offset_mm=50", "follower.offset_mm is 50; its size must be less than the prime radius of 41 mm"),
    ],
)
def test_bad_motions_are_refused(change, words):
    with pytest.raises(DesignError, match=re.escape(words)):
        loaded([change])


@pytest.mark.parametrize("cure", ["cam.base_circle_radius_mm=150", "motion.segments.1.to_mm=-4"])
def test_a_lift_that_leaves_no_disc_is_refused_with_cures_that_work(cure):
    deep = ["motion.segments.1.to_mm=-45", "motion.segments.1.in_deg=120", "motion.segments.4.dwell_deg=80"]
    words = (
        r"the roller of 9 mm comes within [\d.]+ mm of the camshaft at cam angle [\d.]+ degrees, so nothing is "
        r"left of the disc: raise cam\.base_circle_radius_mm, or lead the follower less far in \(motion\.segments\.1\)"
    )
    with pytest.raises(DesignError, match=words):
        plan_motion_cam(loaded(deep))
    assert plan_motion_cam(loaded([*deep, cure])).passed


def test_a_motion_that_stands_still_is_a_reservation():
    cam = plan_motion_cam(loaded(["motion.segments=[{dwell_deg=360}]"]))
    (still,) = cam.verdict.reservations
    assert (still.code, still.text) == ("no-motion", "the follower stands still through the whole turn")


def test_a_design_has_a_motion_or_a_car():
    text = TEXT + "\n[car]\nwheelbase_mm = 100\n"
    from pathlib import Path

    with pytest.raises(DesignError, match=r"has \[motion\], .* and \[car\], which only a design with"):
        complete_of(text, Path("both.toml"))
    with pytest.raises(DesignError, match=r"follower.kind is \"roller\", which moves by its lift"):
        Design.load("carbon_free_car").with_({"follower": {"kind": "roller", "radius_mm": 9.0}})
    with pytest.raises(DesignError, match=r"worked out for a car, but the design has \[motion\]"):
        design_of(TEXT, Path("feeder.toml"))


def test_a_jump_of_velocity_is_refused_and_one_of_acceleration_named():
    from cadgen.laws.law import MotionLaw

    line = MotionLaw(code="line", meaning="", jet=lambda u: np.stack([u, 1 + 0 * u, 0 * u], axis=1), pieces=1)
    sine = MotionLaw(
        code="sine",
        meaning="",
        jet=lambda u: np.stack(
            [(1 - np.cos(np.pi * u)) / 2, np.pi / 2 * np.sin(np.pi * u), np.pi**2 / 2 * np.cos(np.pi * u)], axis=1
        ),
    )

    def made(law):
        return SegmentMotion.of([MotionSpan(0.0, np.pi, 0.0, 5.0, law), MotionSpan(np.pi, TURN, 5.0, 0.0, sine)], MM)

    with pytest.raises(DesignError, match=r"the velocity jumps at 0 degrees from 0 to 1\.592, at 180 degrees from"):
        made(line)
    dwelling = [
        MotionSpan(0.0, np.pi, 0.0, 5.0, sine),
        MotionSpan(np.pi, 4.0, 5.0, 5.0, None),
        MotionSpan(4.0, TURN, 5.0, 0.0, sine),
    ]
    seams = SegmentMotion.of(dwelling, MM).seams
    assert [seam.order for seam in seams] == [2, 2, 2]
    # On either side of a seam the motion has its own second derivative.
    curve = SegmentMotion.of(dwelling, MM).q
    assert curve(np.pi - 1e-9, nu=2) == pytest.approx(-2.5, rel=1e-3)
    assert curve(np.pi + 1e-9, nu=2) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("turns", ["clockwise", pytest.param("counterclockwise", marks=pytest.mark.long)])
def test_it_goes_through_every_command(tmp_path, turns):
    design = Design.from_toml(TEXT).with_({"motion.turns": turns, "blank.edge_break_mm": 0.3})
    cam = design.cam()
    assert cam.passed, [check.name for check in cam.failed]
    assert "car" not in " ".join(cam.notes)
    written = cam.write(tmp_path)
    assert {name.rpartition(".")[2] for name in written.entry["files"]} == {
        "step",
        "stl",
        "3mf",
        "dxf",
        "nc",
        "xyz",
        "csv",
    }
    assert all(file.lift_error_um <= file.lift_limit_um for file in written.files)
    header, first = (tmp_path / "feeder_actual.csv").read_text().splitlines()[:2]
    assert "steering" not in header
    assert len(header.split(",")) == len(first.split(","))
    assert "rod" not in json.dumps({k: v for k, v in written.entry.items() if k != "checks"}, default=str)
    drawn = draw(tmp_path, cam=cam)
    assert {"feeder_actual_drawing.dxf"} <= set(drawn.entry["files"])
    report = Report.of(design, samples=10)
    assert report.passed
    page = report.write(tmp_path)
    html = (tmp_path / page.files[0].name).read_text()
    assert "pressure angle" in html
    assert design.cam(profile="theoretical").passed


@pytest.mark.parametrize(("turns", "seen"), [("clockwise", "outer"), ("counterclockwise", "inner")])
def test_the_disc_of_a_file_gives_the_motion_when_it_turns_as_designed(tmp_path, turns, seen):
    """Laid with its outer face to the viewer, the disc of the DXF lifts the roller of the books by the motion.

    There a disc that turns counterclockwise by theta has its points at p e^(i theta), and the roller moves along x = e
    of the books; a clockwise one is the mirror image. No formula is shared with `cadgen.cam`.
    """
    design = Design.from_toml(TEXT).with_({"motion.turns": turns, "blank.hub": {"diameter_mm": 16, "length_mm": 5}})
    cam = design.cam()
    cam.write(tmp_path, formats=["dxf", "step"])
    splines = ezdxf.readfile(tmp_path / "feeder_actual_spline.dxf").modelspace().query("SPLINE")
    points = np.array([complex(p.x, p.y) for each in splines for p in each.construction_tool().flattening(1e-4)])
    if seen == "inner":
        points = points.conj()  # turned over about the x axis: now the outer face is seen
    sense = -1 if turns == "clockwise" else 1
    y0 = np.sqrt(41.0**2 - 8.0**2)
    for theta in np.linspace(0.0, TURN, 12, endpoint=False):
        disc = points * np.exp(1j * sense * theta)
        across = disc.imag + sense * 8.0  # from the line of the roller's centre, which leans the favourable way
        under = np.abs(across) < 9.0
        lift = (disc.real[under] + np.sqrt(81.0 - across[under] ** 2)).max() - y0
        assert lift == pytest.approx(float(FEEDER.q(theta)), abs=2e-3)
    assert f"files show its {seen} face, on which it turns clockwise" in " ".join(map(str, cam.notes))
    # A hub on the outer side stands out towards the viewer of that face, whose z grows towards him in the STEP file.
    box = import_step(tmp_path / "feeder_actual.step").bounding_box()
    low, high = (0.0, 15.0) if seen == "outer" else (-5.0, 10.0)
    assert pytest.approx((low, high), abs=1e-3) == (box.min.Z, box.max.Z)


@pytest.mark.parametrize("job", ["simulate", "tolerance", "card", "plan"])
def test_jobs_of_a_car_say_so(job):
    with pytest.raises(CadgenError, match=r"worked out for a car, but the design has \[motion\], and not \[path\]"):
        getattr(Design.from_toml(TEXT), job)()


def test_a_design_of_a_motion_comes_back_from_pickle():
    design = Design.from_toml(TEXT)
    again = pickle.loads(pickle.dumps(design))
    assert again == design
    assert type(again.values) is type(design.values)
    assert again.sha256 == design.sha256


def test_the_usual_limit_of_the_pressure_angle_goes_by_the_guide():
    """Norton: 30 degrees for a translating follower, 35 for one on a pivoted arm; a design's own limit comes first."""
    cam = Design.from_toml(TEXT).cam()
    limits = [check.limit for check in cam.checks if check.code in ("pressure-angle-rise", "pressure-angle-return")]
    np.testing.assert_allclose(limits, 30.0)
    assert loaded().values()["checks"]["pressure_angle_limit"] == "norton_translating"
    given = loaded(["checks.pressure_angle_limit=chinese_texts"])
    assert given.checks.pressure_angle_limit == "chinese_texts"
    for kind, name in (
        (replace(ROLLER, unit=RAD), "norton_oscillating"),
        (replace(ROLLER, unit=TAN), "norton_oscillating"),
        (replace(ROLLER, unit=TAN, guide=FollowerGuide.TRANSLATING), "norton_translating"),
        (ROD, "norton_oscillating"),
    ):
        assert kind.pressure_angle_limit == name


def test_followers_show_their_section():
    """The outline of each kind in a picture touches the envelope and no more: its nearer side is `ahead`."""
    rod = LeaningRod(base_radius=70.0, inner=23.5, outer=26.5, radius=3.0, length=60.0)
    face = SquareFace(base=30.0, radius=4.0)
    for follower, q in ((Roller(base=32.0, radius=9.0, offset=8.0), 5.0), (rod, 0.3), (rod, -0.3), (face, 2.0)):
        plane = follower.planes[-1]
        x, y = follower.outline(q, plane).T
        near = follower.ahead(np.full_like(x, q), np.full_like(x, plane), y)
        assert (x >= near - 1e-9).all()
        assert np.abs(x - near).min() < 1e-9
        assert np.ptp(y) == pytest.approx(2 * follower.reach if follower is face else 2 * follower.radius)


@dataclass(frozen=True, kw_only=True)
class SquareFace(Roller):
    """Face square to its slide, as far as a picture asks."""

    outline = Follower.outline

    def ahead(self, q, face, across):
        return self.base + q + 0.0 * across


def test_undercut_is_cured_by_its_own_keys():
    steep = {"1.in_deg": 30.0, "2.dwell_deg": 5.0, "3.in_deg": 40.0, "4.dwell_deg": 285.0}
    changes = {f"motion.segments.{key}": value for key, value in steep.items()}
    design = Design.from_toml(TEXT).with_({**changes, "follower.radius_mm": 20.0, "follower.offset_mm": 0.0})
    cam = design.cam()
    assert "lost lift, undercut" in {check.name for check in cam.failed}
    overrides = [cure.override for cure in cam.cures.proved]
    print(overrides)
    assert any(text.startswith("cam.base_circle_radius_mm=") for text in overrides)
    assert "cam.base_radius_mm" not in " ".join(check.advice for check in cam.checks)


@pytest.mark.parametrize(("offset", "code"), [(10.89, "rise"), (-10.89, "return")])
def test_the_pressure_angle_where_the_roller_stands_still_counts_on_both_sides(offset, code):
    """At rest sin(alpha) = -e / R_p, which may be the greatest angle of a side that begins without a dwell."""
    laws = ((9.85, "simple_harmonic"), (0.0, "constant_acceleration"))
    changes = {
        "motion.segments": [{"to_mm": to, "in_deg": 180.0, "law": law} for to, law in laws],
        "follower.radius_mm": 11.74,
        "follower.offset_mm": offset,
        "cam.base_circle_radius_mm": 58.7,
    }
    checks = {check.code: check for check in Design.from_toml(TEXT).with_(changes).cam().checks}
    angle = checks[f"pressure-angle-{code}"].value
    assert angle == pytest.approx(np.degrees(np.arcsin(10.89 / 70.44)), abs=1e-4)


def _fitted(lift, half, step):
    """Velocity and acceleration of lifts all round by quintics through the neighbours within a window, by rad."""
    share = np.arange(-half, half + 1) / half
    weights = np.linalg.pinv(np.vander(share, 6, increasing=True))
    window = np.lib.stride_tricks.sliding_window_view(np.concatenate([lift[-half:], lift, lift[:half]]), 2 * half + 1)
    return window @ weights[1] / (half * step), 2 * window @ weights[2] / (half * step) ** 2


_LONG = [pytest.mark.slow, pytest.mark.long]
_OTHERS = (
    *("polynomial_2_3", "polynomial_4_5_6_7", "polynomial_5_6_7_8_9", "constant_acceleration", "unequal_parabola"),
    *("trapezoid", "cycloidal", "cycloid_line_50", "simple_harmonic", "gutman_1_3", "freudenstein_1_3"),
    *("freudenstein_1_3_5", "modified_sine", "modified_sine_20", "modified_sine_33", "modified_sine_66"),
)


@pytest.mark.parametrize(
    "law",
    ["polynomial_3_4_5", "modified_trapezoid", "modified_sine_50", *(pytest.param(c, marks=_LONG) for c in _OTHERS)],
)
def test_the_outline_gives_velocity_and_acceleration_of_the_law(law):
    """Rolled every 0.1 degrees and fitted by quintics over 2 degrees, as the law's own lifts are.

    Where the jerk jumps within a window, the fit itself is off, of the law's lifts as of the outline's.
    """
    moved = motion((80, 14.0, law), (50, 14.0, None), (110, 0.0, law), (120, 0.0, None))
    roller = Roller(base=60.0, radius=9.0, offset=8.0)
    theta = np.radians(np.arange(0.0, 360.0, 0.1))
    contact, _ = roll_curve(actual_profile(moved, roller).curve, roller, theta)
    exact = moved.jets(theta)
    found, fits = (_fitted(lift, 10, radians(0.1)) for lift in (contact.lift, exact[:, 0]))
    seams = np.array([seam.cam_angle for seam in moved.joints if seam.order is not None])
    away = (np.abs(np.exp(1j * (theta[:, None] - seams)) - 1) > radians(1.001)).all(axis=1)
    for order, within in ((1, 1e-4), (2, 1e-3)):
        peak = np.abs(exact[:, order]).max()
        assert np.abs(found[order - 1] - fits[order - 1]).max() < within / 10 * peak
        if law != "modified_sine_66":  # whose curves of 7 degrees are too short for the window
            assert np.abs(found[order - 1] - exact[:, order])[away].max() < within * peak
