"""Every follower of the package on a cam by its motion: closed forms, contact by brute force, figures, bad input.

The brute force of this file knows the followers by their definition alone: where each stands at a cam angle, in the
frame of the cam. It shares no formula with `cadgen.cam`.
"""

import json
import re
from dataclasses import replace
from itertools import pairwise
from math import cos, radians, sin
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad

from cadgen import Design
from cadgen.arrays import TURN
from cadgen.cam.contact import roll, roll_curve
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.flat import FlatFace
from cadgen.cam.followers.lifts import Lifts
from cadgen.cam.followers.roller import Knife, Roller
from cadgen.cam.followers.swinging_flat import SwingingFace
from cadgen.cam.followers.swinging_roller import SwingingRoller
from cadgen.curves.closed import Outline
from cadgen.errors import DesignError
from cadgen.jobs.cam.motion_cam import plan_motion_cam
from cadgen.laws.segments import MotionSpan, SegmentMotion
from cadgen.laws.table import law_of
from cadgen.laws.unit import MM, RAD
from cadgen.viewer.page.scene import section_of

DATA = Path(__file__).parents[1] / "data/cams"
STATIONS = np.linspace(0.0, TURN, 720, endpoint=False) + 1e-3
SPANS = ((100, 14.0, "polynomial_3_4_5"), (40, 14.0, None), (60, 9.0, "cycloidal"), (30, 9.0, None))
ROUND = (*SPANS, (90, 0.0, "polynomial_3_4_5"), (40, 0.0, None))


def motion(unit, spans=ROUND):
    """Motion of spans: angle in degrees, height at the end in mm or degrees, and law; None for a dwell."""
    segments, at, height = [], 0.0, 0.0
    for angle, end, law in spans:
        after = end if unit == MM else radians(end)
        stop = at + angle
        segments.append(MotionSpan(radians(at), radians(stop), height, after, law and law_of(law)))
        at, height = stop, after
    return SegmentMotion.of(segments, unit)


FOLLOWERS = {
    "roller in line": Roller(base=38.0, radius=8.0),
    "roller ahead": Roller(base=38.0, radius=8.0, offset=9.0),
    "roller behind": Roller(base=38.0, radius=8.0, offset=-9.0),
    "knife": Knife(base=38.0),
    "knife ahead": Knife(base=38.0, offset=9.0),
    "flat": FlatFace(base=38.0),
    "flat tilted": FlatFace(base=38.0, tilt=0.2, offset=4.0),
    "flat tilted back": FlatFace(base=38.0, tilt=-0.2, offset=-4.0),
    "swinging roller against": SwingingRoller(base=38, radius=8, arm=72, centre_distance=88, lifts=Lifts.AGAINST),
    "swinging roller with": SwingingRoller(base=38, radius=8, arm=72, centre_distance=88, lifts=Lifts.WITH),
    "swinging flat against": SwingingFace(base=55, face_offset=10, centre_distance=120, lifts=Lifts.AGAINST),
    "swinging flat with": SwingingFace(base=60, face_offset=-8, centre_distance=120, lifts=Lifts.WITH),
}


def brute_lift(follower, points, theta):
    """Motion at which the follower just clears all points of a disc that has been turned under it, by definition.

    In the frame of the follower a disc turns back by theta. A slide moves along x; a pivot stands at (c, 0).
    """
    p = points * np.exp(-1j * theta)
    if isinstance(follower, Knife):
        across = p.imag - follower.offset
        cut = np.flatnonzero((across[:-1] < 0) & (across[1:] >= 0))
        share = across[cut] / (across[cut] - across[cut + 1])
        ahead = (p[cut] + share * (p[cut + 1] - p[cut])).real
        return ahead.max() - np.sqrt(follower.base**2 - follower.offset**2)
    if isinstance(follower, Roller):
        reach = follower.base + follower.radius
        under = np.abs(p.imag - follower.offset) < follower.radius
        stands = p.real[under] + np.sqrt(follower.radius**2 - (p.imag[under] - follower.offset) ** 2)
        return stands.max() - np.sqrt(reach**2 - follower.offset**2)
    if isinstance(follower, FlatFace):
        # The face is a line through (x, 0) with the direction i e^(-i tau).
        cuts = (p * np.exp(1j * follower.tilt)).real.max() / cos(follower.tilt)
        return cuts - follower.base / cos(follower.tilt)
    # Swing the arm in until it touches: seen from the pivot, the camshaft ahead.
    d = follower.centre_distance - p
    d = d if follower.lifts == Lifts.AGAINST else d.conj()
    if isinstance(follower, SwingingFace):
        touching = np.angle(d) + np.arcsin(follower.face_offset / np.abs(d))
        return touching.max() - np.arcsin((follower.base + follower.face_offset) / follower.centre_distance)
    R, arm, c = np.abs(d), follower.arm, follower.centre_distance
    near = np.abs(R - arm) < follower.radius
    opening = np.arccos((arm**2 + R[near] ** 2 - follower.radius**2) / (2 * arm * R[near]))
    start = np.arccos((arm**2 + c**2 - (follower.base + follower.radius) ** 2) / (2 * arm * c))
    return (np.angle(d[near]) + opening).max() - start


@pytest.mark.parametrize("name", FOLLOWERS)
def test_the_outline_gives_the_motion_by_independent_contact(name):
    """The highest point of a dense outline lies below the contact by its step squared: 0.1 nm at 1 um."""
    follower = FOLLOWERS[name]
    wanted = motion(follower.unit)
    profile = actual_profile(wanted, follower)
    assert profile.trims == ()
    theta = STATIONS[::40]
    q, lever = wanted.q(theta), float(follower.lift(np.array([1.0]))[0])
    dense = profile.curve.outline(0.005).points @ [1, 1j]
    dense = np.append(dense, dense[0])
    off = [lever * (brute_lift(follower, dense, at) - one) for at, one in zip(theta, q, strict=True)]
    print(f"by brute force {1e3 * np.abs(off).max():.6f} um off")
    assert np.abs(off).max() < 1e-6  # 0.001 um
    # And the program's own rolling, which shares nothing with the envelope.
    contact, _ = roll_curve(profile.curve, follower, STATIONS)
    rolled = np.abs(contact.lift - follower.lift(wanted.q(STATIONS))).max()
    print(f"rolled {1e3 * rolled:.6f} um off")
    assert rolled < 2e-7


def textbook_angle(follower, q, q1):
    """Pressure angle of the textbooks (Norton; Rothbart), rad."""
    if isinstance(follower, Roller):
        y0 = np.sqrt((follower.base + follower.radius) ** 2 - follower.offset**2)
        return np.arctan2(q1 - follower.offset, y0 + q)
    if isinstance(follower, FlatFace):
        return np.full_like(q, -follower.tilt)
    g, c = (1 if follower.lifts == Lifts.AGAINST else -1), follower.centre_distance
    delta = follower.rest + q
    if isinstance(follower, SwingingFace):
        return np.arctan(follower.face_offset * (1 + g * q1) / (c * np.cos(delta)))
    return np.arctan2(follower.arm * (1 + g * q1) - c * np.cos(delta), c * np.sin(delta))


@pytest.mark.parametrize("name", FOLLOWERS)
def test_pressure_angles_are_those_of_the_textbooks(name):
    follower = FOLLOWERS[name]
    wanted = motion(follower.unit)
    contact, _ = roll_curve(actual_profile(wanted, follower).curve, follower, STATIONS)
    angle = textbook_angle(follower, wanted.q(STATIONS), wanted.q(STATIONS, nu=1))
    off = np.degrees(np.abs(contact.pressure_angle - angle)).max()
    print(f"{off:.6f} degrees off")
    assert off < 1e-3


def test_the_contact_travels_along_a_face_as_the_textbooks_say():
    flat = replace(FOLLOWERS["flat tilted"], tilt=0.2, offset=4.0)
    wanted = motion(MM)
    q, q1 = wanted.q(STATIONS), wanted.q(STATIONS, nu=1)
    contact, _ = roll_curve(actual_profile(wanted, flat).curve, flat, STATIONS)
    e, b = 4.0, 38.0
    w = q1 * cos(0.2) - e * cos(0.2) - ((b + e * sin(0.2)) / cos(0.2) + q) * sin(0.2)
    np.testing.assert_allclose(flat.from_axis(contact.q, contact.across), w, atol=2e-4)
    arm = FOLLOWERS["swinging flat against"]
    wanted = motion(arm.unit)
    q, q1 = wanted.q(STATIONS), wanted.q(STATIONS, nu=1)
    contact, _ = roll_curve(actual_profile(wanted, arm).curve, arm, STATIONS)
    np.testing.assert_allclose(
        arm.from_foot(contact.q, contact.across), 120.0 * np.cos(arm.rest + q) / (1 + q1), atol=5e-4
    )


def circle(radius, aside, step=2e-4):
    """Outline of a circle whose centre stands on +X, in points."""
    points = aside + radius * np.exp(1j * np.linspace(0.0, TURN, int(TURN * radius / step) + 1))
    return Outline(np.stack([points.real, points.imag], axis=1), np.zeros(len(points), dtype=np.intp))


def four_bar(theta, c, arm, coupler, crank, g):
    """Angle of the rocker at the pivot in the four-bar of shaft, circle's centre, roller's centre and pivot, rad."""
    d = c - crank * np.exp(-1j * theta)
    d = d if g > 0 else d.conj()
    return np.angle(d) + np.arccos((arm**2 + np.abs(d) ** 2 - coupler**2) / (2 * arm * np.abs(d)))


@pytest.mark.parametrize("name", FOLLOWERS)
def test_an_eccentric_lifts_each_follower_by_its_closed_form(name):
    """An off-centre circle, R = 40 mm, e = 6 mm, under each follower."""
    follower, big, crank = FOLLOWERS[name], 40.0, 6.0
    theta = STATIONS[::72]
    contact = roll(circle(big, crank), follower, theta)
    if isinstance(follower, Roller):
        # The roller's centre stands big + radius from the circle's centre.
        centre = crank * np.exp(-1j * theta)
        stands = centre.real + np.sqrt((big + follower.radius) ** 2 - (centre.imag - follower.offset) ** 2)
        q = stands - np.sqrt((follower.base + follower.radius) ** 2 - follower.offset**2)
    elif isinstance(follower, FlatFace):
        q = (big + crank * np.cos(theta - follower.tilt) - follower.base) / cos(follower.tilt)
    elif isinstance(follower, SwingingRoller):
        g = 1 if follower.lifts == Lifts.AGAINST else -1
        c, arm = follower.centre_distance, follower.arm
        start = np.arccos((arm**2 + c**2 - (follower.base + follower.radius) ** 2) / (2 * arm * c))
        q = four_bar(theta, c, arm, big + follower.radius, crank, g) - start
    else:
        d = follower.centre_distance - crank * np.exp(-1j * theta)
        d = d if follower.lifts == Lifts.AGAINST else d.conj()
        q = np.angle(d) + np.arcsin((big + follower.face_offset) / np.abs(d)) - follower.rest
    off = np.abs(contact.lift - follower.lift(q)).max()
    print(f"{off:.2e} mm off")
    assert off < 1e-9


def toml(name, kind, keys, segments, base, thickness=10.0):
    rows = ",\n".join("    {" + ", ".join(f"{k} = {json.dumps(v)}" for k, v in row.items()) + "}" for row in segments)
    lines = "\n".join(f"{key} = {json.dumps(value)}" for key, value in keys.items())
    return (
        f'name = "{name}"\n[motion]\nturns = "counterclockwise"\nsegments = [\n{rows}\n]\n'
        f'[follower]\nkind = "{kind}"\n{lines}\n[cam]\nbase_circle_radius_mm = {base}\nthickness_mm = {thickness}\n'
    )


def trial(name, known):
    """Design of a trial with printed figures, and the figures."""
    given = json.loads((DATA / f"{name}.json").read_text())
    follower = given["follower"]
    swings = follower["kind"].startswith("swing")
    segments = [
        {"dwell_deg": s["dwell"]}
        if "dwell" in s
        else {("rise_deg" if swings else "rise_mm"): s["rise"], "in_deg": s["deg"], "law": s["law"]}
        for s in given["motion"]
    ]
    return toml(name, follower["kind"], known(follower), segments, follower["base_radius"]), given["expected"]


TRIALS = {
    "h02_roller_offset_right": lambda f: {"radius_mm": f["roller_radius"], "offset_mm": f["offset"]},
    "h06_flat": lambda f: {"tilt_deg": f["tilt_deg"], "face_offset_mm": f["offset"]},
    "h10_swing_roller_with": lambda f: {
        "radius_mm": f["roller_radius"],
        "arm_mm": f["arm"],
        "centre_distance_mm": f["centre_distance"],
        "lifts": "with",
    },
}


@pytest.mark.parametrize("name", TRIALS)
def test_trials_have_their_printed_figures(name):
    text, expected = trial(name, TRIALS[name])
    cam = Design.from_toml(text).cam()
    assert cam.passed
    figures = {check.code: check.value for check in cam.checks}
    angles = expected["pressure_angle_deg"]
    assert figures["pressure-angle-greatest"] == pytest.approx(angles["max"], abs=1e-3)
    assert figures["pressure-angle-least"] == pytest.approx(angles["min"], abs=1e-3)
    if "pitch_least_convex_radius_mm" in expected:
        assert figures["convex-radius-theory"] == pytest.approx(expected["pitch_least_convex_radius_mm"], abs=1e-4)
        assert figures["convex-radius-profile"] == pytest.approx(expected["profile_least_convex_radius_mm"], abs=1e-4)
        most = expected["largest_cutter_radius_mm"] or np.inf
        assert figures["largest-cutter-radius"] == pytest.approx(most, rel=1e-4)
    else:
        assert figures["convex-radius-profile"] == pytest.approx(expected["profile_least_radius_mm"], abs=1e-4)
        along = expected["along_face_mm"]
        assert figures["contact-from"] == pytest.approx(along["min"], abs=1e-3)
        assert figures["contact-to"] == pytest.approx(along["max"], abs=1e-3)
        assert figures["face-width"] == pytest.approx(expected["face_width_mm"], abs=1e-3)
    disc, computed = expected["disc_radius_mm"], cam.computed
    radii = np.linalg.norm(computed.curve.outline(0.02).points, axis=1)
    assert (radii.min(), radii.max()) == (
        pytest.approx(disc["least"], abs=1e-4),
        pytest.approx(disc["greatest"], abs=1e-4),
    )
    assert computed.area == pytest.approx(expected["area_mm2"], abs=1e-4)


RISE = {"to_mm": 14.0, "in_deg": 100.0, "law": "polynomial_3_4_5"}
LIFTED = (RISE, {"dwell_deg": 40.0}, {"to_mm": 0.0, "in_deg": 130.0, "law": "cycloidal"}, {"dwell_deg": 90.0})
SWUNG = tuple({("to_deg" if key == "to_mm" else key): value for key, value in row.items()} for row in LIFTED)
DESIGNS = {
    "roller": toml("roller", "roller", {"radius_mm": 9.0, "offset_mm": 8.0}, LIFTED, 42.0),
    "knife": toml("knife", "knife", {"offset_mm": 3.0}, LIFTED, 42.0),
    "flat": toml("flat", "flat", {"width_mm": 40.0}, LIFTED, 42.0),
    "tilted": toml("tilted", "flat", {"tilt_deg": 10.0}, LIFTED, 42.0),
    "swinging_roller": toml(
        "swinging_roller",
        "swinging_roller",
        {"radius_mm": 8.0, "arm_mm": 72.0, "centre_distance_mm": 88.0, "lifts": "with"},
        SWUNG,
        42.0,
    ),
    "swinging_flat": toml(
        "swinging_flat",
        "swinging_flat",
        {"centre_distance_mm": 120.0, "lifts": "against", "face_offset_mm": 10.0},
        SWUNG,
        42.0,
    ),
}
FAST = ["motion.segments.1.to_deg=55", "motion.segments.3.in_deg=60", "motion.segments.4.dwell_deg=160"]
FAR = [
    "follower.arm_mm=60",
    "follower.centre_distance_mm=100",
    "motion.segments.1={rise_deg=140,in_deg=100,law='cycloidal'}",
]
IN_MM = "motion.segments.1={to_mm=3, in_deg=100, law='cycloidal'}"
# Design, changes that make bad input, words of its sentence, and changes that cure it, each alone.
BAD = [
    (
        "roller",
        ["follower.offset_mm=51"],
        "its size must be less than the prime radius of 51 mm",
        "follower.offset_mm=50",
    ),
    ("roller", ["follower.offset_mm=51"], "or raise cam.base_circle_radius_mm", "cam.base_circle_radius_mm=60"),
    ("knife", ["follower.offset_mm=-42"], "prime radius of 42 mm", "follower.offset_mm=-30"),
    (
        "swinging_roller",
        ["follower.arm_mm=40", "follower.centre_distance_mm=100"],
        "more than 50 and less than 150 mm: set follower.arm_mm to 86.6, or set follower.centre_distance_mm to 64.1",
        "follower.arm_mm=86.6",
    ),
    (
        "swinging_roller",
        ["follower.arm_mm=40", "follower.centre_distance_mm=100"],
        "or set follower.centre_distance_mm to 64.1",
        "follower.centre_distance_mm=64.1",
    ),
    (
        "swinging_roller",
        FAR,
        "would be beyond 60 degrees even at rest: lead it by 0 to 58.37 degrees",
        "motion.segments.1={rise_deg=58.37,in_deg=100,law='cycloidal'}",
    ),
    ("swinging_flat", ["follower.centre_distance_mm=51"], "set it to 104", "follower.centre_distance_mm=104"),
    (
        "swinging_flat",
        ["follower.centre_distance_mm=51"],
        "or lower follower.face_offset_mm",
        "follower.face_offset_mm=-9",
    ),
    (
        "swinging_flat",
        ["motion.segments.1.to_deg=70"],
        "lead it by 0 to 33.92 degrees",
        "motion.segments.1.to_deg=33.92",
    ),
    ("swinging_flat", FAST, "the face swings as fast as the cam turns", "motion.segments.1.to_deg=8"),
    ("swinging_flat", FAST, "or lead it by 0 to ", "motion.segments.1.to_deg=8"),
    ("swinging_flat", ["follower.face_offset_mm=-50"], "set it to -21, or to 0", "follower.face_offset_mm=-21"),
    ("swinging_flat", ["follower.lifts=up"], 'it must be "against" or "with"', "follower.lifts=with"),
    ("swinging_flat", [IN_MM], "moves in degrees: give to_deg instead", IN_MM.replace("mm", "deg")),
]


@pytest.mark.parametrize(("name", "changes", "words", "cure"), BAD)
def test_bad_followers_are_refused_with_cures_that_work(name, changes, words, cure):
    design = Design.from_toml(DESIGNS[name])
    with pytest.raises(DesignError, match=re.escape(words)):
        design.with_(changes).cam()
    if cure.startswith("motion.segments.1={rise_deg"):
        back = "motion.segments.3={rise_deg=-58.37,in_deg=130,law='cycloidal'}"
        design.with_([*changes, cure, back]).cam()
        return
    design.with_([*changes, cure]).cam()


def test_a_key_of_another_follower_is_none_of_this():
    """As a roller's radius for a flat face."""
    with pytest.raises(
        DesignError, match=r"follower.radius_mm is a key of .*kind is \"flat\".* kind, tilt_deg, face_offset_mm and"
    ):
        Design.from_toml(DESIGNS["flat"]).with_({"follower.radius_mm": 5.0})


def test_a_face_too_narrow_names_width_and_offset_that_cure_it():
    design = Design.from_toml(DESIGNS["flat"]).with_({"follower.width_mm": 28.0})
    cam = design.cam()
    (end,) = cam.failed
    assert end.code == "face-end"
    offset, width = re.match(
        r"set follower.face_offset_mm to ([\d.]+), or follower.width_mm to ([\d.]+)", end.advice
    ).groups()
    assert design.with_({"follower.face_offset_mm": float(offset)}).cam().passed
    assert design.with_({"follower.width_mm": float(width)}).cam().passed
    (end,) = design.with_({"follower.width_mm": 20.0}).cam().failed
    both = re.match(
        r"set follower.width_mm to [\d.]+, or to ([\d.]+) with follower.face_offset_mm = ([\d.]+)", end.advice
    )
    width, offset = map(float, both.groups())
    assert design.with_({"follower.width_mm": width, "follower.face_offset_mm": offset}).cam().passed


@pytest.mark.parametrize("name", DESIGNS)
def test_the_picture_of_the_follower_rides_on_the_disc(name):
    """No point of its section lies within the disc that is turned under it, and one touches it."""
    plan = plan_motion_cam(Design.from_toml(DESIGNS[name]).values)
    for theta in np.linspace(0.3, TURN, 9):
        section = section_of(plan, float(plan.motion.q(theta))) @ [1, 1j]
        sides = np.linspace(section[:-1], section[1:], 50, axis=1).ravel() * np.exp(1j * theta)
        room = np.abs(sides) - plan.curve.radius(np.angle(sides))
        assert abs(room.min()) < 0.02  # a roller is drawn by chords


@pytest.mark.slow
@pytest.mark.long
@pytest.mark.parametrize("name", DESIGNS)
def test_files_keep_the_motion(name, tmp_path):
    """Read back and rolled with its own follower; STEP, points and CSV within 0.05 um, G-code and DXF within 1 um."""
    cam = Design.from_toml(DESIGNS[name]).cam()
    assert cam.passed, [check.name for check in cam.failed]
    written = cam.write(tmp_path)
    errors = {each.name: each.lift_error_um for each in written.files if each.lift_error_um is not None}
    print(errors)
    for file, error in errors.items():
        assert error <= (1.0 if file.endswith((".dxf", ".nc")) else 5.0 if file.endswith((".stl", ".3mf")) else 0.05)


ROD = toml("rodcam", "rod", {"radius_mm": 3.0}, SWUNG, 70.0, 3.0).replace(
    "base_circle_radius_mm = 70.0", "base_radius_mm = 70.0\ninner_face_mm = 23.5"
)


def test_a_rod_takes_a_motion_in_degrees_of_steering():
    """Let down on its disc, by the ellipse in each face (decision 11), it steers by the angle that the motion gives."""
    cam = Design.from_toml(ROD).cam()
    assert cam.passed
    plan = cam.computed
    disc = plan.curve.outline(0.004).points @ [1, 1j]
    angle = motion(
        RAD,
        tuple(
            (s.get("in_deg") or s["dwell_deg"], s.get("to_deg", h), s.get("law"))
            for s, h in zip(SWUNG, (0, 14, 0, 0), strict=True)
        ),
    )
    for theta in np.linspace(0.1, TURN, 16):
        p = disc * np.exp(-1j * theta)
        under = np.abs(p.imag) < 3.0
        u, h = p.real[under] - 70.0, np.sqrt(9.0 - p.imag[under] ** 2)
        steered = [((w * u + h * np.sqrt(u**2 + w**2 - h**2)) / (w**2 - h**2)).max() for w in (23.5, 26.5)]
        assert np.degrees(np.arctan(max(steered)) - angle.q(theta)) == pytest.approx(0.0, abs=5e-6)  # 2 nm of lift
    with pytest.raises(DesignError, match="are the place of a disc under a rod, and one of them is missing"):
        Design.from_toml(ROD.replace("inner_face_mm = 23.5\n", ""))
    with pytest.raises(DesignError, match=r"cam\.base_radius_mm is of a rod, and follower\.kind is"):
        Design.from_toml(ROD.replace('"rod"', '"roller"').replace("to_deg", "to_mm"))


def test_the_area_under_a_flat_face_whose_acceleration_jumps():
    """Area by Cauchy's formula, half the integral of h² - h'² by the angle of the normal, from the laws as books have
    them; the jump near an edge of a step of a quadrature was missed by 1e-6.
    """

    def straight_middle(u):  # velocity 2/3 (1 - cos 4 pi u), then 4/3, then back
        begin = 2 / 3 * (u - sin(4 * np.pi * u) / (4 * np.pi)) if u < 0.25 else 1 / 6 + 4 / 3 * (u - 0.25)
        slope = 2 / 3 * (1 - cos(4 * np.pi * u)) if u < 0.25 else 4 / 3
        return begin, slope

    def parabola(u):
        return 2 * u**2, 4 * u

    def half(law, u):
        if u <= 0.5:
            return law(u)
        height, slope = law(1 - u)
        return 1 - height, slope

    high, width, base, tilt = 13.67, radians(80.3), 53.3, radians(1.6)

    def swept(law, u):
        height, slope = half(law, u)
        return ((base + high * height * cos(tilt)) ** 2 - (high * slope / width * cos(tilt)) ** 2) * width / 2

    still = radians(94.2) * (base + high * cos(tilt)) ** 2 / 2 + radians(105.2) * base**2 / 2
    moving = [
        quad(lambda u, law=law: swept(law, u), a, b, epsabs=1e-11)[0]
        for law in (straight_middle, parabola)
        for a, b in pairwise((0, 0.25, 0.5, 0.75, 1))
    ]
    spans = ((80.3, high, "cycloid_line_50"), (94.2, high, None), (80.3, 0.0, "constant_acceleration"))
    wanted = motion(MM, (*spans, (105.2, 0.0, None)))
    face = FlatFace(base=base, tilt=tilt)
    for moved in (wanted, wanted.mirrored):
        curve = actual_profile(moved, face).curve
        assert curve.area() == pytest.approx(still + sum(moving), rel=1e-9)
