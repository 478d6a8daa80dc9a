"""Designs of every kind of follower against their definitions, to the digits that are promised.

What is expected is computed by `tests.cam.definitions`, which shares nothing with cadgen: pressure angles with their
signs to 0.001 degrees, radii to 1e-4, run of the contact on a face to 1 um, lost lift to 0.05 um or 1 %, speed of
lift-off and peaks of the torque to 0.1 %, pressure in the line of contact to 0.5 %.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, radians

import numpy as np
import pytest

from tests.cam.definitions import Body, Face, Moved, OuterFlank, Round, lost_lift, pressure
from tests.studies.motions import computed, toml

RPM = pi / 30


@dataclass(frozen=True)
class Case:
    """Design as tables, and what it is by definition."""

    motion: dict
    follower: dict
    truth: Round | Face
    moved: Moved
    body: Body | None = None
    dynamics: dict | None = None
    lost: bool = False


def spans(*rows: tuple, unit: str = "mm", repeat: int = 1, machine: float = 1.0, **motion) -> tuple[dict, Moved]:
    """Segments of a design and their motion: (width, height at the end, law), of a dwell without height and law."""
    keys, made, height = [], [], 0.0
    for width, *rest in rows:
        if rest:
            height, law, *more = rest
            keys.append({f"to_{unit}": float(height), "in_deg": float(width), "law": law} | dict(*more))
        else:
            keys.append({"dwell_deg": float(width)})
        at = radians(height) if unit == "deg" else height
        made.append((width / machine, at, rest[1] if rest else "dwell"))
    given = {"segments": keys} | motion
    if repeat > 1:
        given["repeat"] = repeat
    if machine != 1.0:
        given["machine_turns"] = machine
    return given, Moved.of_spans(made, repeat)


def slide(radius: float, base: float, offset: float = 0.0) -> tuple[dict, Round]:
    keys = (
        {"kind": "roller", "radius_mm": radius, "offset_mm": offset}
        if radius
        else {"kind": "knife", "offset_mm": offset}
    )
    return keys, Round(base, radius, offset)


def arm(radius: float, base: float, length: float, distance: float, lifts: str) -> tuple[dict, Round]:
    keys = {"kind": "swinging_roller", "radius_mm": radius, "arm_mm": length, "centre_distance_mm": distance}
    side = 1 if lifts == "against" else -1
    return keys | {"lifts": lifts}, Round(base, radius, arm=length, distance=distance, side=side)


def flat(base: float, tilt: float = 0.0, offset: float = 0.0) -> tuple[dict, Face]:
    return {"kind": "flat", "tilt_deg": tilt, "face_offset_mm": offset}, Face(base, tilt, offset)


def swinging_flat(base: float, distance: float, off: float, lifts: str) -> tuple[dict, Face]:
    keys = {"kind": "swinging_flat", "centre_distance_mm": distance, "face_offset_mm": off, "lifts": lifts}
    return keys, Face(base, distance=distance, off=off, side=1 if lifts == "against" else -1)


def case(
    moved: tuple[dict, Moved], kind: tuple[dict, Round | Face], rpm: float = 0.0, lost: bool = False, **body: float
) -> Case:
    """Case of a motion and a follower, with what it carries where a speed is given."""
    (motion, q), (follower, truth) = moved, kind
    if not rpm:
        return Case(motion, follower, truth, q, lost=lost)
    swings = follower["kind"].startswith("swinging")
    names = (
        ("inertia_kgmm2", "damping_Nmm_s_per_rad", "spring_rate_Nmm_per_rad", "preload_Nmm", "load_Nmm")
        if swings
        else ("mass_kg", "damping_N_s_per_m", "spring_rate_N_per_mm", "preload_N", "load_N")
    )
    keys = {
        name: body[each]
        for name, each in zip(names, ("inertia", "damping", "rate", "preload", "load"), strict=True)
        if each in body
    }
    keys["contact_width_mm"] = body.get("width", 10.0)
    scaled = {
        name: value * (1e-3 if name in ("inertia",) or (name == "damping" and not swings) else 1.0)
        for name, value in body.items()
    }
    return Case(motion | {"speed_rpm": rpm}, follower, truth, q, Body(speed=rpm * RPM, **scaled), keys, lost)


def harmonics(*terms: tuple[int, float, float]) -> tuple[dict, Moved]:
    def jets(theta: np.ndarray) -> np.ndarray:
        waves = [(a - 1j * b) * np.exp(1j * k * theta) * np.array([1, 1j * k, -k * k])[:, None] for k, a, b in terms]
        return np.sum(waves, axis=0).real

    return {"harmonics": [[float(each) for each in term] for term in terms]}, Moved.of_whole(jets)


def spline(heights: Callable, count: int) -> tuple[dict, Moved]:
    """Points of a function, and the periodic quintic spline through them by its own linear system of jets."""
    step = 2 * pi / count
    theta = np.arange(count) * step
    value = np.round(heights(theta), 4)
    # Pieces of degree 5 on the unit of the step, whose first four derivatives are continuous, by values and four more.
    shift = np.array(
        [[np.prod(np.arange(k, k - order, -1)) if k >= order else 0 for k in range(6)] for order in range(6)], float
    )
    rows, right = np.zeros((6 * count, 6 * count)), np.zeros(6 * count)
    for n in range(count):
        here, there = slice(6 * n, 6 * n + 6), slice(6 * ((n + 1) % count), 6 * ((n + 1) % count) + 6)
        rows[6 * n, 6 * n], right[6 * n] = 1.0, value[n]
        for order in range(5):
            rows[6 * n + 1 + order, here] = shift[order]
            rows[6 * n + 1 + order, there.start + order] -= shift[order][order]
    pieces = np.linalg.solve(rows, right).reshape(count, 6)

    def piece(number: int) -> Callable:
        series = [
            np.polynomial.Polynomial(pieces[number]).deriv(order) if order else np.polynomial.Polynomial(pieces[number])
            for order in range(3)
        ]
        return lambda at: np.stack(
            [each((at - theta[number]) / step) / step**order for order, each in enumerate(series)]
        )

    made = tuple((float(theta[n]), float(theta[n] + step), piece(n)) for n in range(count))
    points = [[float(360 * n / count), float(each)] for n, each in enumerate(value)]
    return {"points": points}, Moved(made)


FEEDER = (80, 14, "modified_sine_20"), (50,), (110, 0, "polynomial_5_6_7_8_9"), (120,)
SWINGS = (100, 14, "modified_trapezoid"), (40,), (60, 9, "cycloidal"), (30,), (90, 0, "modified_sine"), (40,)
CASES = {
    "roller in line": lambda: case(
        spans(*FEEDER), slide(9.0, 32.0), 420, inertia=0.85, rate=9.0, preload=80.0, load=15.0, damping=2.0, width=8.0
    ),
    "roller on the wrong side": lambda: case(
        spans(*FEEDER), slide(9.0, 42.0, -8.0), 300, inertia=1.2, rate=6.0, preload=60.0
    ),
    "roller on the right side": lambda: case(
        spans((90, 12, "gutman_1_3"), (20,), (100, -3, "freudenstein_1_3"), (30,), (120, 0, "cycloidal")),
        slide(7.0, 36.0, 10.0),
        500,
        inertia=0.4,
        rate=11.0,
        preload=90.0,
    ),
    "knife": lambda: case(
        spans((120, 10, "cycloidal"), (60,), (150, 0, "polynomial_3_4_5"), (30,)), slide(0.0, 35.0, 5.0)
    ),
    "flat square": lambda: case(
        spans((130, 9, "polynomial_4_5_6_7"), (30,), (150, 0, "modified_sine"), (50,)),
        flat(30.0),
        900,
        inertia=0.3,
        rate=12.0,
        preload=90.0,
        width=9.0,
    ),
    "flat leaning forward": lambda: case(
        spans((140, 8, "cycloidal"), (30,), (150, 0, "freudenstein_1_3"), (40,)),
        flat(34.0, 12.0, 5.0),
        700,
        inertia=0.25,
        rate=9.0,
        preload=70.0,
    ),
    "flat leaning back": lambda: case(
        spans((140, 8, "modified_trapezoid"), (30,), (150, 0, "gutman_1_3"), (40,)),
        flat(34.0, -9.0, -6.0),
        600,
        inertia=0.5,
        rate=9.0,
        preload=90.0,
    ),
    "arm against": lambda: case(
        spans(*SWINGS, unit="deg"),
        arm(8.0, 38.0, 72.0, 88.0, "against"),
        300,
        inertia=900.0,
        rate=18_000.0,
        preload=3000.0,
        damping=900.0,
        width=7.0,
    ),
    "arm with": lambda: case(
        spans(*SWINGS, unit="deg"),
        arm(10.0, 45.0, 80.0, 95.0, "with"),
        250,
        inertia=1200.0,
        rate=15_000.0,
        preload=4000.0,
        load=500.0,
    ),
    "long arm": lambda: case(
        spans((70, 8, "cycloidal"), (10,), (80, 3, "polynomial_3_4_5"), (100, 0, "modified_sine"), (100,), unit="deg"),
        arm(6.0, 30.0, 110.0, 105.0, "against"),
        200,
        inertia=2000.0,
        rate=0.0,
        preload=9000.0,
    ),
    "swinging flat against": lambda: case(
        spans((120, 12, "cycloidal"), (40,), (140, 0, "polynomial_3_4_5"), (60,), unit="deg"),
        swinging_flat(38.0, 110.0, 8.0, "against"),
        250,
        inertia=1500.0,
        rate=12_000.0,
        preload=4000.0,
    ),
    "swinging flat with": lambda: case(
        spans((120, 9, "modified_sine"), (40,), (140, 0, "cycloidal"), (60,), unit="deg"),
        swinging_flat(40.0, 105.0, -6.0, "with"),
        300,
        inertia=1300.0,
        rate=12_000.0,
        preload=5000.0,
    ),
    "undercut roller": lambda: case(
        spans((40, 16, "polynomial_3_4_5"), (40,), (50, 0, "cycloidal"), (230,)), slide(18.0, 20.0, 3.0), lost=True
    ),
    "undercut flat": lambda: case(
        spans((70, 14, "cycloidal"), (40,), (90, 0, "modified_sine"), (160,)), flat(25.0, 6.0), lost=True
    ),
    "undercut arm": lambda: case(
        spans((45, 16, "polynomial_4_5_6_7"), (40,), (60, 0, "cycloidal"), (215,), unit="deg"),
        arm(18.0, 22.0, 60.0, 72.0, "against"),
        lost=True,
    ),
    "undercut swinging flat": lambda: case(
        spans((65, 13, "cycloidal"), (40,), (90, 0, "modified_sine"), (165,), unit="deg"),
        swinging_flat(26.0, 95.0, 0.0, "with"),
        lost=True,
    ),
    "thin dwell": lambda: case(
        spans((120, 10, "modified_sine"), (0.5,), (140, 0, "modified_trapezoid"), (99.5,)),
        slide(8.0, 40.0, -4.0),
        350,
        inertia=1.0,
        rate=5.0,
        preload=80.0,
    ),
    "four lobes": lambda: case(
        spans((35, 3, "cycloidal"), (10,), (35, 0, "polynomial_3_4_5"), (10,), repeat=4),
        flat(60.0, 0.0, 3.0),
        150,
        inertia=0.8,
        rate=4.0,
        preload=50.0,
    ),
    "three lobes on an arm": lambda: case(
        spans((45, 4, "modified_sine"), (20,), (45, 0, "gutman_1_3"), (10,), repeat=3, unit="deg"),
        arm(6.0, 42.0, 60.0, 82.0, "with"),
    ),
    "half speed": lambda: case(
        spans(
            (140, 7.4, "valve_lobe", {"powers": [10, 18, 26, 34]}),
            (140, 0, "valve_lobe", {"powers": [10, 18, 26, 34]}),
            (440,),
            machine=2.0,
        ),
        flat(18.4),
        1000,
        inertia=0.057,
        rate=7.13,
        preload=12.6,
        width=7.2,
    ),
    "unequal parabolas": lambda: case(
        spans((150, 12, "unequal_parabola", {"acceleration_ratio": 3.0}), (150, 0, "constant_acceleration"), (60,)),
        slide(10.0, 40.0),
        240,
        inertia=2.0,
        rate=6.0,
        preload=90.0,
    ),
    "double harmonic": lambda: case(
        spans((170, 15, "double_harmonic"), (130, 0, "cycloidal"), (60,)), slide(9.0, 45.0, 6.0)
    ),
    "harmonic beside dwells": lambda: case(
        spans((150, 20, "simple_harmonic"), (40,), (130, 0, "simple_harmonic"), (40,)),
        slide(9.0, 45.0, 2.0),
        200,
        inertia=1.5,
        rate=5.0,
        preload=90.0,
    ),
    "half laws with a line": lambda: case(
        spans(
            (40, 3.0, "half_cycloid_1"),
            (80, 15.0, "constant_velocity"),
            (40, 18.0, "half_cycloid_2"),
            (140, 0, "modified_sine"),
            (60,),
        ),
        slide(9.0, 50.0),
        150,
        inertia=2.0,
        rate=4.0,
        preload=60.0,
    ),
    "harmonics": lambda: case(
        harmonics((0, 6, 0), (1, -4, 1), (2, -1, 0.5), (3, 0.3, -0.4)),
        slide(7.0, 33.0, -5.0),
        300,
        inertia=0.9,
        rate=4.0,
        preload=60.0,
    ),
    "harmonics under a face": lambda: case(
        harmonics((0, 6, 0), (1, -4, 1), (2, -1, 0.5)), flat(24.0, -7.0, 2.0), 300, inertia=0.9, rate=4.0, preload=60.0
    ),
    "spline": lambda: case(
        spline(lambda at: 6 - 5 * np.cos(at) + np.sin(2 * at) - 0.6 * np.cos(4 * at), 24), slide(7.0, 30.0, 4.0)
    ),
    "spline on an arm": lambda: case(
        _in_rad(spline(lambda at: 6 - 5 * np.cos(at) + np.sin(2 * at) - 0.3 * np.cos(4 * at), 20)),
        arm(7.0, 36.0, 70.0, 86.0, "against"),
        200,
        inertia=800.0,
        rate=9000.0,
        preload=3000.0,
    ),
}


def _in_rad(made: tuple[dict, Moved]) -> tuple[dict, Moved]:
    keys, moved = made
    return keys, Moved(
        tuple((low, high, lambda at, jets=jets: radians(1) * jets(at)) for low, high, jets in moved.pieces)
    )


def cam_of(made: Case):
    keys = {
        "name": "case",
        "motion": {"turns": "counterclockwise"} | made.motion,
        "follower": made.follower,
        "cam": {"base_circle_radius_mm": made.truth.base, "thickness_mm": 10.0},
        "blank": {"bore_diameter_mm": 10.0},
    }
    return computed(toml(keys | ({"dynamics": made.dynamics} if made.dynamics else {})))


_LONG = (pytest.mark.long, pytest.mark.slow)
_QUICK = ("knife", "flat leaning forward", "swinging flat with", "unequal parabolas", "spline on an arm")


@pytest.mark.parametrize("name", [pytest.param(name, marks=() if name in _QUICK else _LONG) for name in CASES])
def test_figures_are_those_of_the_definitions(name):
    made = CASES[name]()
    cam, moved, truth = cam_of(made), made.moved, made.truth
    shown = {str(check.code): check for check in (*cam.verdict.checks, *cam.shown)}
    motion = cam.facts()["motion"]
    unit = motion["unit"]
    for order, word, power in ((1, "velocity", ""), (2, "acceleration", "2")):
        both = moved.extremes(lambda jets, theta, order=order: jets[order])
        most = max(abs(peak.value) for peak in both)
        assert motion[f"greatest_{word}_{unit}_per_rad{power}"] == pytest.approx(most, rel=1e-6)
    if made.lost:
        lost = lost_lift(moved, truth)
        lever = 1.0 if unit == "mm" else truth.arm if isinstance(truth, Round) else truth.distance * np.cos(truth.rest)
        found = shown["lost-lift-undercut"]
        assert lost.value * lever > 0.02
        assert found.value == pytest.approx(lost.value * lever * 1e3, rel=0.01, abs=0.05)
        return
    greatest, least = moved.extremes(truth.angle)
    assert shown["pressure-angle-greatest"].value == pytest.approx(greatest.value, abs=1e-3)
    assert shown["pressure-angle-least"].value == pytest.approx(least.value, abs=1e-3)
    for code, figure in (
        ("convex-radius-profile", truth.profile_radius),
        ("convex-radius-theory", getattr(truth, "pitch_radius", None)),
    ):
        if figure is not None and (code in shown or isinstance(truth, Round)):
            _, sharpest = moved.extremes(lambda jets, theta, figure=figure: _convex(figure(jets, theta)))
            assert shown[code].value == pytest.approx(sharpest.value, abs=1e-4)
    if isinstance(truth, Round) and truth.radius:
        hollow, _ = moved.extremes(lambda jets, theta: -_convex(-truth.profile_radius(jets, theta)))
        if np.isfinite(hollow.value) and -hollow.value < 1e4:
            assert shown["largest-cutter-radius"].value == pytest.approx(-hollow.value, rel=1e-4)
    if isinstance(truth, Face):
        far, near = moved.extremes(truth.along)
        assert sorted([shown["contact-from"].value, shown["contact-to"].value]) == pytest.approx(
            [near.value, far.value], abs=1e-3
        )
    area = moved.mean(lambda jets, theta: _swept(truth, moved, theta)) * pi
    assert cam.facts()["profile_area_mm2"] == pytest.approx(area, rel=1e-6)
    if made.body is None:
        return
    body, forces = made.body, cam.facts()["forces"]
    unit = "N" if unit == "mm" else "Nmm"
    for code, figure, within in (
        (f"force_along_{{}}_{unit}", body.along, 1e-3),
        ("normal_force_{}_N", lambda jets, theta: body.along(jets, theta) / truth.share(jets, theta), 1e-3),
        ("camshaft_torque_{}_Nmm", body.torque, 1e-3),
        ("contact_pressure_{}_MPa", pressure(truth, body), 5e-3),
    ):
        most, least = moved.extremes(figure)
        assert forces[code.format("greatest")] == pytest.approx(most.value, rel=within), code
        assert forces[code.format("least")] == pytest.approx(least.value, rel=within, abs=1e-6 * most.value), code
    _, off = moved.extremes(body.lift_off)
    if np.isfinite(off.value):
        assert forces["lift_off_rpm"] == pytest.approx(off.value / RPM, rel=1e-3)
    assert forces["camshaft_torque_mean_Nmm"] == pytest.approx(moved.mean(body.torque), abs=1e-3 * most.value)


def _convex(radius: np.ndarray) -> np.ndarray:
    return np.where(radius > 0, radius, np.inf)


def _swept(truth: Round | Face, moved: Moved, theta: np.ndarray) -> np.ndarray:
    """Twice the area swept by the contact per rad, mm²: Im(conj X dX), by differences, clockwise."""
    step = 1e-6
    ahead, behind = (truth.contact(moved.jets(theta + side * step), theta + side * step) for side in (1, -1))
    here = truth.contact(moved.jets(theta), theta)
    return -(here.conj() * (ahead - behind) / (2 * step)).imag


@pytest.mark.long
@pytest.mark.slow
def test_the_second_disc_of_a_slide_is_the_opposite_motion_half_a_turn_on():
    (motion, moved), (keys, first) = (
        spans((120, 20, "polynomial_3_4_5"), (40,), (140, 0, "cycloidal"), (60,)),
        slide(9.0, 40.0, 3.0),
    )
    keys |= {"closure": "conjugate", "second": {"radius_mm": 8.0, "span_mm": 118.0, "offset_mm": -2.0}}
    ahead = 118.0 - first.rest
    second = Round(float(np.hypot(ahead, 2.0)) - 8.0, 8.0, 2.0)
    _both_discs(Case(motion, keys, first, moved), second)


@pytest.mark.long
@pytest.mark.slow
def test_the_second_disc_of_a_lever_is_that_of_an_arm_that_goes_in():
    (motion, moved), (keys, first) = spans(*SWINGS, unit="deg"), arm(8.0, 42.0, 70.0, 90.0, "with")
    keys |= {"closure": "conjugate", "second": {"radius_mm": 7.0, "arm_mm": 66.0, "angle_deg": 85.0}}
    angle = radians(85) - first.rest
    prime = np.sqrt(90.0**2 + 66.0**2 - 2 * 90 * 66 * np.cos(angle))
    _both_discs(Case(motion, keys, first, moved), Round(float(prime) - 7.0, 7.0, arm=66.0, distance=90.0, side=1))


def _both_discs(made: Case, second: Round) -> None:
    """Pressure angles in size and least radii of both discs."""
    cam = cam_of(made)
    shown = {str(check.code): check for check in (*cam.verdict.checks, *cam.shown)}
    other = Moved(tuple((low, high, lambda at, jets=jets: -jets(at)) for low, high, jets in made.moved.pieces))
    for part, truth, moved in (("", made.truth, made.moved), ("second-", second, other)):
        steepest = max(abs(peak.value) for peak in moved.extremes(truth.angle))
        found = max(abs(shown[f"{part}pressure-angle-{each}"].value) for each in ("greatest", "least"))
        assert found == pytest.approx(steepest, abs=1e-3)
        for code, figure in (
            ("convex-radius-profile", truth.profile_radius),
            ("convex-radius-theory", truth.pitch_radius),
        ):
            _, sharpest = moved.extremes(lambda jets, theta, figure=figure: _convex(figure(jets, theta)))
            assert shown[part + code].value == pytest.approx(sharpest.value, abs=1e-4)


@pytest.mark.long
@pytest.mark.slow
@pytest.mark.parametrize("swings", [False, True])
def test_the_outer_flank_of_a_groove_is_undercut_where_the_path_is_too_hollow(swings):
    if swings:
        moved, (keys, inner) = (
            spans((40, 18, "cycloidal"), (170,), (60, 0, "modified_sine"), (90,), unit="deg"),
            arm(15.0, 30.0, 70.0, 84.0, "with"),
        )
    else:
        moved, (keys, inner) = (
            spans((40, 25, "cycloidal"), (170,), (60, 0, "modified_sine"), (90,)),
            slide(14.0, 30.0, 3.0),
        )
    keys |= {"closure": "groove", "clearance_mm": 0.06, "depth_mm": 5.0}
    rim = inner.radius + 0.03
    places = {"arm": inner.arm, "distance": inner.distance, "side": inner.side} if swings else {"offset": inner.offset}
    outer, within = (kind(inner.base + inner.radius - rim, rim, **places) for kind in (OuterFlank, Round))
    motion, q = moved
    shown = {str(check.code): check for check in cam_of(Case(motion, keys, inner, q)).verdict.checks}
    for code, truth in (("outer-lost-lift-undercut", outer), ("lost-lift-undercut", within)):
        lost = lost_lift(q, truth).value * (inner.arm or 1.0)
        assert shown[code].value == pytest.approx(lost * 1e3, rel=0.01, abs=0.05)
        if truth is outer:
            assert lost > 0.02
