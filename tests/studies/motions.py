"""Random motions and followers against definitions: `python -m tests.studies.motions --cases 1000 --seed 1 --log FILE`.

Law, follower and sizes of each case are random, and one in ten is absurd. The judge is `tests.studies.motions_truth`,
which shares nothing with cadgen. What it asks:

- nothing ends in an error of the program;
- each point of an outline is touched by the follower at some cam angle, and lies within it at none;
- pressure angles, least radius and lost lift are those of the definitions;
- files of every fourth cam that may be cut hold that outline (STEP is read back by the program itself);
- a refusal is true, where its kind has a judge;
- each change that is proposed is accepted when it is put in, and ends what it is proposed for.
"""

from __future__ import annotations

import json
import random
import re
import tempfile
import traceback
from collections import Counter
from dataclasses import dataclass
from itertools import pairwise
from math import pi, radians
from pathlib import Path

import numpy as np

from tests.studies.command import PAGES, options, tell
from tests.studies.journal import outcomes, stamp
from tests.studies.motions_truth import TURN, Span, Truth, jumps, lift_on, motion_by_laws, worst_gap

RECORD = PAGES / "motions.md"
OUTLINE_UM, FILE_UM, POINTS = 0.01, 0.5, 60
SMOOTH = (
    "polynomial_3_4_5",
    "polynomial_4_5_6_7",
    "cycloidal",
    "modified_trapezoid",
    "modified_sine",
    "modified_sine_50",
    "cycloid_line_50",
)
JUMPING = ("constant_acceleration", "simple_harmonic", "polynomial_2_3")
ROUGH = ("constant_velocity", "half_cycloid_1", "half_harmonic_2")
KINDS = ("roller", "roller", "roller", "knife", "flat", "flat", "swinging_roller", "swinging_roller", "swinging_flat")


@dataclass(frozen=True)
class Case:
    """One case: the design as tables, its spans where it has laws of the judge, and what is absurd in it."""

    keys: dict
    spans: tuple[Span, ...] | None
    absurd: str


def case(seed: int, number: int) -> Case:
    """Random design of a cam by its motion."""
    rng = random.Random(f"motions/{seed}/{number}")
    kind = rng.choice(KINDS)
    swings = kind.startswith("swinging")
    size = rng.choice((12.0, 25.0, 40.0, 60.0))
    base = round(size * rng.uniform(0.6, 1.6), 1)
    unit, most = ("deg", 22.0) if swings else ("mm", size * rng.choice((0.15, 0.3, 0.5)))
    follower: dict = {"kind": kind}
    if kind in ("roller", "swinging_roller"):
        follower["radius_mm"] = round(base * rng.choice((0.1, 0.2, 0.3, 0.6)), 2)
    if kind in ("roller", "knife") and rng.random() < 0.6:
        follower["offset_mm"] = round(base * rng.uniform(-0.4, 0.4), 2)
    if kind == "flat":
        follower |= {"tilt_deg": round(rng.choice((0, 0, 1)) * rng.uniform(-15, 15), 1)}
        if rng.random() < 0.4:
            follower |= {
                "face_offset_mm": round(rng.uniform(-8, 8), 1),
                "width_mm": round(base * rng.uniform(0.4, 2), 1),
            }
    prime = base + follower.get("radius_mm", 0.0)
    if swings:
        follower["lifts"] = rng.choice(("against", "with"))
        follower["centre_distance_mm"] = round(prime * rng.uniform(1.5, 2.6), 1)
    if kind == "swinging_roller":
        straight = (follower["centre_distance_mm"] ** 2 - prime**2) ** 0.5
        follower["arm_mm"] = round(straight * rng.uniform(0.75, 1.2), 1)
    if kind == "swinging_flat":
        follower["face_offset_mm"] = round(base * rng.uniform(-0.3, 0.4), 1)
    closure = rng.random()
    if kind in ("roller", "swinging_roller") and closure < 0.15:
        follower |= {"closure": "groove", "clearance_mm": 0.05, "depth_mm": 4.0}
    motion: dict = {"turns": rng.choice(("clockwise", "counterclockwise"))}
    spans, motion["segments"] = _segments(rng, most, unit)
    if rng.random() < 0.12:
        motion["repeat"] = rng.choice((2, 3))
        for each in motion["segments"]:
            for name in ("in_deg", "dwell_deg"):
                if name in each:
                    each[name] = each[name] / motion["repeat"]
        spans = tuple(Span(span.width / motion["repeat"], span.to, span.law) for span in spans)
    kept: tuple[Span, ...] | None = spans
    if rng.random() < 0.12:  # a table of the same motion, with noise or without
        noise = rng.choice((0.0, 0.002, 0.01))
        motion.pop("repeat", None)
        turn = sum(span.width for span in spans)
        q = motion_by_laws([Span(span.width * TURN / turn, span.to, span.law) for span in spans])
        lift = q(np.radians(np.arange(360.0)))[0]
        lift = np.degrees(lift) if swings else lift
        motion["rows"] = [[float(at), round(float(s) + rng.gauss(0, noise), 5)] for at, s in enumerate(lift)]
        if noise and rng.random() < 0.5:
            motion["smooth"] = True
        del motion["segments"]
        kept = None
    keys = {
        "name": "case",
        "motion": motion,
        "follower": follower,
        "cam": {"base_circle_radius_mm": base, "thickness_mm": round(rng.uniform(4, 12), 1)},
        "blank": {"bore_diameter_mm": round(base * 0.3, 1)},
        "machining": {"cutter_diameter_mm": rng.choice((2.0, 4.0, 6.0))},
    }
    if kind == "roller" and "closure" not in follower and rng.random() < 0.1:
        keys["cam"]["pressure_angle_deg"] = rng.choice((20.0, 30.0, 40.0))
        del keys["cam"]["base_circle_radius_mm"]
    if rng.random() < 0.5:
        motion["speed_rpm"] = float(rng.choice((30, 120, 400, 1200)))
    if "closure" not in follower and rng.random() < 0.35:
        keys["dynamics"] = _dynamics(rng, swings)
    absurd = ""
    if rng.random() < 0.1:
        absurd, kept = _absurd(rng, keys, most, kept)
    return Case(keys, kept, absurd)


def _segments(rng: random.Random, most: float, unit: str) -> tuple[tuple[Span, ...], list[dict]]:
    """Rises, dwells and returns that fill a turn, as spans and as segments of a design."""
    laws = rng.choice((SMOOTH, SMOOTH, SMOOTH + JUMPING, SMOOTH + JUMPING, SMOOTH + JUMPING + ROUGH))
    heights = [round(most * rng.uniform(0.3, 1), 2) for _ in range(rng.choice((1, 1, 1, 2)))]
    stops = [*heights, 0.0]
    parts: list[tuple[float, float, str | None]] = []
    for to in stops:
        parts.append((rng.uniform(35, 140), to, rng.choice(laws)))
        if rng.random() < 0.75:
            parts.append((rng.choice((rng.uniform(0.8, 4), rng.uniform(10, 90))), to, None))
    scale = 360 / sum(width for width, _, _ in parts)
    widths = [round(width * scale, 1) for width, _, _ in parts]
    widths[0] = round(360 - sum(widths[1:]), 1)
    spans, rows, before = [], [], 0.0
    for width, (_, to, law) in zip(widths, parts, strict=True):
        spans.append(Span(radians(width), radians(to) if unit == "deg" else to, law))
        key = {f"to_{unit}": to} if rng.random() < 0.7 else {f"rise_{unit}": to - before}
        rows.append({"dwell_deg": width} if law is None else {**key, "in_deg": width, "law": law})
        before = to
    return tuple(spans), rows


def _dynamics(rng: random.Random, swings: bool) -> dict:
    if swings:
        return {
            "inertia_kgmm2": round(rng.uniform(50, 3000), 1),
            "spring_rate_Nmm_per_rad": round(rng.uniform(100, 20_000), 0),
            "preload_Nmm": round(rng.uniform(0, 3000), 0),
        }
    return {
        "mass_kg": round(rng.uniform(0.05, 2), 3),
        "spring_rate_N_per_mm": round(rng.uniform(0.2, 20), 2),
        "preload_N": round(rng.uniform(0, 60), 1),
    }


def _absurd(rng: random.Random, keys: dict, most: float, spans) -> tuple[str, tuple[Span, ...] | None]:
    """Make one thing of a design absurd."""
    motion, follower = keys["motion"], keys["follower"]
    segments = motion.get("segments")
    moves = [each for each in segments or () if "law" in each]
    choices = ["base", "speed"]
    choices += ["angle", "open", "height", "no angle", "law", "unit"] if segments else ["back", "twice"]
    choices += [
        key for key in ("radius_mm", "offset_mm", "centre_distance_mm", "arm_mm", "face_offset_mm") if key in follower
    ]
    what = rng.choice(choices)
    height = next((name for name in moves[0] if name[:2] in ("to", "ri")), "") if moves else ""
    match what:
        case "base":
            keys["cam"] = {"base_circle_radius_mm": rng.choice((0.01, 0.5, 900.0)), "thickness_mm": 5.0}
        case "speed":
            motion["speed_rpm"] = rng.choice((0.001, 900_000.0))
        case "angle":
            moves[0]["in_deg"] = round(moves[0]["in_deg"] + rng.choice((-5, 10, 300)), 2)
            return what, None
        case "open":
            moves[-1] = moves[-1]
            name = next(name for name in moves[-1] if name[:2] in ("to", "ri"))
            moves[-1][name] += rng.choice((0.001, 1.0))
            return what, None
        case "height":
            moves[0][height] = rng.choice((-1, 1)) * most * rng.choice((3, 10, 40))
            return what, None
        case "no angle":
            moves[0]["in_deg"] = 0
            return what, None
        case "law":
            moves[0]["law"] = rng.choice(("cycloid", "valve_lobe", "double_harmonic", "polynomial"))
            return what, None
        case "unit":
            value = moves[0].pop(height)
            moves[0][height.replace("mm", "x").replace("deg", "mm").replace("x", "deg")] = value
            return what, None
        case "back":
            rows = motion["rows"]
            rows[10], rows[11] = rows[11], rows[10]
        case "twice":
            motion["rows"][10][0] = motion["rows"][9][0]
        case _:
            follower[what] = rng.choice((0.06, -follower[what], 30 * follower[what], 0.4 * follower[what]))
    return what, spans


def toml(keys: dict) -> str:
    """Design file of tables."""

    def value(each: object) -> str:
        if isinstance(each, dict):
            return "{ " + ", ".join(f"{k} = {value(v)}" for k, v in each.items()) + " }"
        return "[" + ", ".join(map(value, each)) + "]" if isinstance(each, list) else json.dumps(each)

    plain = [f"{key} = {value(each)}" for key, each in keys.items() if not isinstance(each, dict)]
    for name, table in keys.items():
        if isinstance(table, dict):
            plain += [f"[{name}]", *(f"{key} = {value(each)}" for key, each in table.items())]
    return "\n".join(plain) + "\n"


def computed(text: str, overrides: tuple[str, ...] = ()):
    """Cam of a design file with changes."""
    from cadgen.api.cam import Cam
    from cadgen.design import load
    from cadgen.jobs.cam.motion_cam import plan_motion_cam

    return Cam.of(plan_motion_cam(load.complete_of(text, Path("case.toml"), overrides)))


def judged(seed: int, number: int) -> dict:
    """Outcome of a case and what is wrong with it."""
    from cadgen.errors import CadgenError

    made, found = case(seed, number), {"number": number, "wrong": [], "proposals": 0, "unjudged": ""}
    text, wrong = toml(made.keys), found["wrong"]
    try:
        try:
            cam = computed(text)
        except CadgenError as error:
            found["outcome"] = "refused"
            template = getattr(error.message, "template", str(error.message))
            _judge_refusal(made, str(error.message), template, found)
            _try_refusal(text, str(error.message), template, found)
            return found
        found["outcome"] = cam.verdict.readiness.value
        truth = _truth(made, cam)
        if made.spans is not None:
            q = motion_by_laws(made.spans, made.keys["motion"].get("repeat", 1))
            _judge_outline(truth, q, cam, made, wrong)
            _judge_figures(truth, q, cam, made, wrong)
            _judge_seams(made, cam, wrong)
        if cam.sound and number % 4 == 0:
            found["written"] = True
            _judge_files(truth, made, cam, wrong)
        _try_advice(text, cam, found)
    except Exception:
        found["outcome"] = found.get("outcome", "") or "internal fault"
        wrong.append("internal fault: " + traceback.format_exc(limit=-4))
    return found


def _truth(made: Case, cam) -> Truth:
    return Truth(made.keys["follower"], float(cam.design.seat.base_radius))


def _points(curve, count: int) -> np.ndarray:
    points = curve.outline(curve.length() / 3000).points
    chosen = np.linspace(0, len(points) - 1, count).astype(int)
    return points[chosen] @ np.array([1, 1j])


def _judge_outline(truth: Truth, q, cam, made: Case, wrong: list) -> None:
    clearance = made.keys["follower"].get("clearance_mm", 0.0)
    curves = (
        {"outline": cam.curve}
        if cam.groove is None
        else {"inner flank": cam.curve, "outer flank": cam.groove.outer.curve}
    )
    for name, curve in curves.items():
        low, high = worst_gap(truth, _points(curve, POINTS), q, shift=clearance / 2)
        if low < -OUTLINE_UM * 1e-3 or high > OUTLINE_UM * 1e-3:
            wrong.append(f"{name} from {low * 1e3:.3f} to {high * 1e3:.3f} um off the follower")


def _judge_figures(truth: Truth, q, cam, made: Case, wrong: list) -> None:
    checks = {str(check.code): check for check in cam.checks}
    theta = np.arange(3600) * TURN / 3600
    jets = q(theta)
    corner = jumps(made.spans)[0] > 1e-9
    lost = max(check.value for code, check in checks.items() if code.startswith("lost-lift"))
    dense = cam.curve.outline(cam.curve.length() / 60_000).points @ np.array([1, 1j])
    if lost > 0 and cam.groove is None:
        lever = 1.0
        if truth.swings:
            lever = truth.keys.get("arm_mm") or truth.keys["centre_distance_mm"] * np.cos(truth.rest)
        coarse = np.arange(0, 3600, 10)
        missing = np.array([q(theta[at : at + 1])[0][0] - lift_on(truth, dense, theta[at]) for at in coarse])
        worst = int(coarse[int(np.argmax(missing))])
        near = np.linspace(theta[worst] - TURN / 360, theta[worst] + TURN / 360, 81)
        most = max(float(q(np.array([at]))[0][0]) - lift_on(truth, dense, at) for at in near) * lever * 1e3
        if abs(most - lost) > max(0.05, 0.01 * most) + 0.1:
            wrong.append(f"lost lift {lost:.3f} um, by definition {most:.3f}")
    if lost > 0 or corner or cam.trims:
        return
    seams = np.cumsum([span.width for span in made.spans])
    inner = [a + (b - a) * share for a, b in pairwise([0.0, *seams]) for share in (0.25, 0.5, 0.75)]
    near = np.concatenate([np.array([*seams, *inner]) + side * 1e-9 for side in (-1, 1)])
    jets = q(np.concatenate([np.linspace(0, TURN, 14_401), near]))
    angle, pace = np.degrees(truth.angle(jets)), jets[1] / max(float(np.abs(jets[1]).max()), 1e-12)
    for code, surely, perhaps in (
        ("pressure-angle-rise", pace >= 0, pace > -1e-12),
        # A return that begins at rest with an acceleration has its angle there as a limit.
        ("pressure-angle-return", pace < -0.02, pace < -1e-12),
    ):
        least, most = (float(angle[rows].max(initial=0.0)) for rows in (surely, perhaps))
        if not least - 0.001 - 1e-5 * least <= checks[code].value <= most + 0.001 + 1e-5 * most:
            wrong.append(f"{code} {checks[code].value:.4f}, by definition {least:.4f} to {most:.4f}")
    rho = truth.radii(jets)
    if cam.groove is None:
        least, said = float(rho[rho > 0].min()), checks["convex-radius-profile"].value
        if min(least, said) < 1e3 and abs(said - least) > 2e-3 * least + 0.02:
            wrong.append(f"least convex radius {said:.4f}, by definition {least:.4f}")


def _judge_seams(made: Case, cam, wrong: list) -> None:
    velocity, acceleration = jumps(made.spans)
    codes = {each.code for each in cam.verdict.reservations}
    if velocity > 1e-6 and "velocity-jumps" not in codes:
        wrong.append("velocity jumps, unsaid")
    if acceleration > 1e-6 and velocity < 1e-9 and "acceleration-jumps" not in codes:
        wrong.append("acceleration jumps, unsaid")


def _judge_files(truth: Truth, made: Case, cam, wrong: list) -> None:
    formats = ["step", "stl"] if cam.groove is not None else ["step", "xyz", "csv"]
    with tempfile.TemporaryDirectory() as folder:
        cam.write(folder, formats)
        if made.spans is None or cam.groove is not None:
            return
        q = motion_by_laws(made.spans, made.keys["motion"].get("repeat", 1))
        file = min(Path(folder).rglob("*.xyz"), key=lambda path: "second" in path.name)
        rows = np.array(
            [
                [float(each) for each in line.split()[:2]]
                for line in file.read_text().splitlines()
                if line[:1] in "-0123456789"
            ]
        )
        back = -1 if made.keys["motion"]["turns"] == "counterclockwise" else 1
        low, high = min(
            (worst_gap(truth, rows[:: max(1, len(rows) // 40)] @ np.array([1, sign * 1j]), q) for sign in (1, -1)),
            key=lambda ends: max(-ends[0], ends[1]),
        )
        if low < -FILE_UM * 1e-3 or high > FILE_UM * 1e-3:
            wrong.append(f"points of the file from {low * 1e3:.3f} to {high * 1e3:.3f} um off the follower ({back})")


# ---------------------------------------------------------------- refusals


def _judge_refusal(made: Case, text: str, template: str, found: dict) -> None:
    """Look by brute force whether what a refusal says is so."""
    keys, spans = made.keys, made.spans
    base = keys["cam"].get("base_circle_radius_mm")
    judge = next((judge for begin, judge in JUDGES.items() if begin in template or begin in text), None)
    if judge is None or base is None or spans is None:
        if not made.absurd:
            found["unjudged"] = template[:70]
        return
    truth = Truth(keys["follower"], base)
    if not judge(truth, motion_by_laws(spans, keys["motion"].get("repeat", 1)), spans):
        found["wrong"].append(f"refused without cause: {text}")


def _near(truth: Truth, q, spans) -> bool:
    """Whether camshaft and follower meet."""
    lift = q(np.linspace(0, TURN, 7201))[0]
    if truth.flat:
        return float(truth.line(lift)[1].min()) <= 1e-9
    rim = truth.radius + truth.keys.get("clearance_mm", 0.0) / 2  # of a groove's inner flank
    return float(np.abs(truth.centre(lift)).min()) <= rim + 1e-9


def _overhangs(truth: Truth, q, spans) -> bool:
    """Whether the polar angle of the contact turns back where the profile is not undercut."""
    theta = np.linspace(0, TURN, 14_401)
    lift = q(theta)[0]
    p = truth.centre(lift) * np.exp(1j * theta)
    along = np.gradient(p, theta)
    for rim in (truth.radius + truth.keys.get("clearance_mm", 0.0) / 2,) * 2:
        for side in (1, -1):
            contact = p + side * rim * 1j * along / np.abs(along)
            forward = (np.gradient(contact, theta) * along.conj()).real > 0
            turning = np.gradient(np.unwrap(np.angle(contact)), theta)
            if (forward & (turning <= 1e-6)).any():
                return True
    return False


def _steep(truth: Truth, q, spans) -> bool:
    return truth.flat or _overhangs(truth, q, spans) or jumps(spans)[0] > 0 or True


def _arm_out_of_reach(truth: Truth, q, spans) -> bool:
    c, prime, arm = truth.keys["centre_distance_mm"], truth.base + truth.radius, truth.keys["arm_mm"]
    return not abs(c - prime) < arm < c + prime


def _arm_too_steep(truth: Truth, q, spans) -> bool:
    swung = truth.rest + q(np.linspace(0, TURN, 7201))[0]
    c, arm = truth.keys["centre_distance_mm"], truth.keys["arm_mm"]
    at_rest = np.degrees(np.arctan2(np.abs(arm - c * np.cos(swung)), c * np.sin(swung)))
    return bool((at_rest > 60 - 1e-6).any() or (swung <= 0).any() or (swung >= pi).any())


def _face_beyond_square(truth: Truth, q, spans) -> bool:
    return float((truth.rest + q(np.linspace(0, TURN, 7201))[0]).max()) >= pi / 2 - 1e-9


def _face_too_fast(truth: Truth, q, spans) -> bool:
    return float((1 + truth.side * q(np.linspace(0, TURN, 7201))[1]).min()) <= 1e-9


def _covers_pivot(truth: Truth, q, spans) -> bool:
    """Whether a contact lies as far from the camshaft as the pivot, by differences."""
    theta = np.linspace(0, TURN, 14_401)
    lift = q(theta)[0]
    if truth.flat:
        normal, distance = truth.line(lift)
        turn = np.unwrap(np.angle(normal)) + theta
        far = np.hypot(distance, np.gradient(distance, theta) / np.gradient(turn, theta))
    else:
        p = truth.centre(lift) * np.exp(1j * theta)
        along = np.gradient(p, theta)
        rim = truth.radius + truth.keys.get("clearance_mm", 0.0) / 2
        sides = (1, -1) if "clearance_mm" in truth.keys else (1,)  # the left one is that of the camshaft
        far = np.abs(np.stack([p + side * rim * 1j * along / np.abs(along) for side in sides]))
    return float(far.max()) >= truth.keys["centre_distance_mm"] - 1e-3


JUDGES = {
    "would cover the pivot": _covers_pivot,
    "velocity jumps": lambda truth, q, spans: jumps(spans)[0] > 1e-9,
    "nothing is left of the disc": _near,
    "outline overhangs": _overhangs,
    "cannot bring the roller to": _arm_out_of_reach,
    "where its pressure angle would be beyond": _arm_too_steep,
    "where no contact is left": _face_beyond_square,
    "swings as fast as the cam turns": _face_too_fast,
    "is at least the prime radius": lambda truth, q, spans: abs(truth.keys["offset_mm"]) >= truth.base + truth.radius,
    "would cover its own pivot": lambda truth, q, spans: truth.keys["arm_mm"] <= truth.radius,
    "cannot touch a base circle": lambda truth, q, spans: (
        truth.base + truth.keys["face_offset_mm"] >= truth.keys["centre_distance_mm"]
    ),
}

# ---------------------------------------------------------------- proposals

_KEY, _VALUE = r"([a-z_]+\.[A-Za-z_0-9.]*[A-Za-z_0-9])", r"(\"[a-z_0-9]+\"|true|false|-?[0-9.]+(?:e[-+]?[0-9]+)?)"
_PAIR = re.compile(f"{_KEY}(?: to | = |=){_VALUE}")


def proposals(text: str) -> list[tuple[str, ...]]:
    """Changes that a sentence proposes: each alone, or those that are joined by "and" or "with" together."""
    found: list[tuple[str, ...]] = []
    text = re.sub(r"(set )([a-z_.]+)( to [-0-9.]+, or to )", r"\1\2\3\2 to ", text).replace(", or to ", ", or set ")
    for part in re.split(r"(?:,|;)? or |; |, and (?=set )", text):
        pairs = tuple(f"{key}={value.rstrip('.').strip(chr(34))}" for key, value in _PAIR.findall(part))
        if pairs:
            found.append(pairs)
    return found


def _try_refusal(text: str, said: str, template: str, found: dict) -> None:
    from cadgen.errors import CadgenError

    for change in proposals(said):
        found["proposals"] += 1
        try:
            computed(text, change)
        except CadgenError as error:
            again = getattr(error.message, "template", str(error.message))
            if again == template or str(error.message) == said:
                found["wrong"].append(f"proposal {change} refused alike: {error.message} | first: {said}")
            else:
                found.setdefault("led_on", []).append(f"{change}: {error.message}"[:300])


def _try_advice(text: str, cam, found: dict) -> None:
    """Put in what failing checks, cures and reservations propose."""
    from cadgen.errors import CadgenError

    trials: list[tuple[tuple[str, ...], str, str]] = []
    for check in cam.verdict.failed:
        trials += [
            (change, str(check.code), f"{check.name}: {check.advice}") for change in proposals(str(check.advice))
        ]
    failed = {str(check.code) for check in cam.verdict.failed}
    seen = Counter()
    for line in map(str, cam.find_cures().sentences()):
        for change in proposals(line):
            seen[change[0].partition("=")[0]] += 1
            trials.append((change, "all" if "cures it" in line else "lost", line))
    found["wrong"] += [f"two proposals for {key}" for key, count in seen.items() if count > 1]
    for each in cam.verdict.reservations:
        trials += [(change, "!" + each.code, f"{each.text}: {each.cure}") for change in proposals(str(each.cure))]
    for change, code, said in trials:
        found["proposals"] += 1
        try:
            after = computed(text, change)
        except CadgenError as error:
            found["wrong"].append(f"proposal {change} refused: {error.message} | of: {said}"[:600])
            continue
        left = {str(check.code) for check in after.verdict.failed}
        held = {each.code for each in after.verdict.reservations}
        bad = (
            code[1:] in held
            if code[0] == "!"
            else bool({each for each in failed & left if each in _CURED})
            if code in ("all", "lost")
            else code in left
        )
        if bad:
            found["wrong"].append(f"proposal {change} does not end {code} | of: {said}"[:600])


_CURED = {
    "lost-lift-undercut",
    "lost-lift-crossing",
}


def page(rows: list[dict], seed: int) -> str:
    """Page of the study."""
    outcome = Counter(row["outcome"] for row in rows)
    wrong = [row for row in rows if row["wrong"]]
    unjudged = Counter(row["unjudged"] for row in rows if row["unjudged"])
    lines = [
        "# Study: motions and followers",
        "",
        "Random laws, followers and sizes (`tests/studies/motions.py`), one in ten absurd, against laws, places of",
        "rollers and faces, and what they touch by the study's own definitions (`motions_truth.py`).",
        "",
        f"`python -m tests.studies.motions --cases {len(rows)} --seed {seed} --record`, {stamp()}",
        "",
        "| outcome | cases |",
        "|---|---|",
        *(f"| {name} | {count} |" for name, count in sorted(outcome.items())),
        f"| wrong in any way | {len(wrong)} |",
        "",
        f"Files were written of {sum(bool(row.get('written')) for row in rows)} cams, and "
        f"{sum(row['proposals'] for row in rows)} proposals were put in; "
        f"{sum(len(row.get('led_on', ())) for row in rows)} of them, of refusals, led to another refusal. "
        f"Refusals without a judge: {sum(unjudged.values())}.",
    ]
    lines += ["", *(f"- case {row['number']}: {' '.join(row['wrong'][0].split())[:300]}" for row in wrong[:40])]
    return "\n".join(lines).rstrip() + "\n"


def main() -> None:
    """Command line of the study."""
    chosen = options(__doc__, cases=1000, more={"--show": -1})
    if chosen.show >= 0:
        print(toml(case(chosen.seed, chosen.show).keys))
        print(json.dumps(judged(chosen.seed, chosen.show), indent=1))
        return
    keys = [(chosen.seed, number) for number in range(chosen.cases)]
    rows = outcomes(judged, keys, chosen.log, chosen.processes)
    tell(page(rows, chosen.seed), RECORD if chosen.record else None)


if __name__ == "__main__":
    main()
