"""Study: paths that are dense, straight, dwelling or rippling, and blends that begin a hair beside a spline node.

    python -m tests.studies.paths --cases 2500 --seed 1 [--record]

Four of five cases are paths, one is a blend. No path may end in a fault of the program or be refused without the brute
force of `tests.studies.paths_truth` saying so too; what passes must keep its limits there. Of every tenth design
the curve is fitted as for files, and every hundredth is written in full.
"""

import tempfile
import traceback
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from math import degrees, radians
from pathlib import Path

import numpy as np

from cadgen import __version__
from cadgen.cam.checks import LOST_LIFT
from cadgen.check import CheckCode
from cadgen.curves.biarc import arcs
from cadgen.curves.spline import splines
from cadgen.design.load import load_design
from cadgen.errors import CadgenError
from cadgen.jobs.cam.cam_files import write_cam
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.cures import find_cures
from cadgen.jobs.cam.steering_cam import plan_cam
from cadgen.output.files.xyz import read_xyz, write_xyz
from tests.studies.command import PAGES, options, tell
from tests.studies.paths_truth import TURN, Truth

KINDS = ("dense", "straight", "dwelling", "rippling", "blend")
PRESSURE_LIMIT = radians(35)
LOST_LIMIT_UM = 1.0
CUTTER = 2.0
RECORD = PAGES / "paths.md"


@dataclass(frozen=True)
class Case:
    """One generated design: the values of its file."""

    kind: str
    waypoints: np.ndarray
    spline: str
    numbers: dict[str, float] = field(default_factory=dict)

    def text(self) -> str:
        """The design file."""
        n = self.numbers
        points = ", ".join(f"[{x!r}, {y!r}]" for x, y in self.waypoints.tolist())
        return (
            f'name = "study"\n[path]\nspline = "{self.spline}"\noffset_mm = {n["offset"]!r}\n'
            f"waypoints_mm = [{points}]\n[car]\nwheelbase_mm = {n['wheelbase']!r}\n"
            f"drive_wheel_offset_mm = {n['wheel']!r}\nidle_wheel_offset_mm = 150.0\n[cam]\n"
            f"base_radius_mm = {n['base']!r}\ninner_face_mm = {n['inner']!r}\nthickness_mm = {n['thick']!r}\n"
            f"blend_deg = {n['blend']!r}\n[follower]\nradius_mm = {n['rod']!r}\nlength_mm = 80.0\n"
        )

    def truth(self) -> Truth:
        """The same by brute force."""
        n = self.numbers
        faces = n["inner"], n["inner"] + n["thick"]
        return Truth(
            self.waypoints, self.spline, n["offset"], n["wheelbase"], n["wheel"], n["base"], faces, n["rod"],
            radians(n["blend"]),
        )  # fmt: skip


def case_of(seed: int, number: int, kind: str | None = None) -> Case:
    """Case `number` of a seed."""
    rng = np.random.default_rng([seed, number])
    kind = kind or KINDS[number % len(KINDS)]
    numbers = {
        "offset": float(rng.choice([0.0, rng.uniform(-100, 100)])),
        "wheelbase": float(rng.uniform(110, 200)),
        "wheel": float(rng.uniform(30, 70)),
        "base": float(rng.uniform(50, 90)),
        "inner": float(rng.uniform(16, 33)),
        "thick": float(rng.choice([0.5, 2.0, 3.0, 5.0])),
        "rod": float(rng.uniform(1.0, 3.0)),
        "blend": 12.0,
    }
    shape = rng.choice(KINDS[:4]) if kind == "blend" else kind
    waypoints = _turned(rng, _SHAPES[shape](rng))
    # Cubic curvature has kinks in turns, which is another study's: here where it is next to straight.
    spline = "cubic" if shape == "straight" and rng.random() < 0.5 else "quintic"
    case = Case(kind, waypoints, spline, numbers)
    if kind == "blend":
        # A hair beside a node of the spline, to either side, where the blend begins.
        theta = np.array(case.truth().nodes_angle())
        node = rng.choice(theta[(theta > TURN - 0.9) & (theta < TURN - 0.1)])
        hair = float(rng.choice([-1, 1]) * 10.0 ** rng.uniform(-14, -3)) if rng.random() < 0.95 else 0.0
        numbers["blend"] = degrees(TURN - node + hair)
    return case


def _turned(rng: np.random.Generator, points: np.ndarray) -> np.ndarray:
    """Turned to any heading or along an axis, rounded as files are, or not at all."""
    angle = rng.choice([0.0, np.pi / 2, rng.uniform(0, TURN)])
    c, s = np.cos(angle), np.sin(angle)
    points = points @ np.array([[c, s], [-s, c]]) + rng.choice([0.0, 1000.0]) * rng.uniform(-1, 1, 2)
    chord = float(np.linalg.norm(np.diff(points, axis=0), axis=1).min())
    # Rounding to e bends the path by some 10 e / chord^2, which must stay small beside the cam's own slopes.
    digits = max(3, int(np.ceil(-np.log10(2e-9 * chord**2.5))))
    return np.round(points, digits + int(rng.integers(0, 4))) if rng.random() < 0.7 else points


def _along(curvature: np.ndarray, length: float, count: int) -> np.ndarray:
    """Points of a path with given curvature at even places of its length."""
    step = length / (len(curvature) - 1)
    heading = np.concatenate([[0.0], np.cumsum((curvature[:-1] + curvature[1:]) / 2 * step)])
    ahead = np.exp(1j * heading)
    place = np.concatenate([[0.0], np.cumsum((ahead[:-1] + ahead[1:]) / 2 * step)])
    chosen = place[np.linspace(0, len(place) - 1, count).astype(int)]
    return np.stack([chosen.real, chosen.imag], axis=1)


def _bump(x: np.ndarray) -> np.ndarray:
    """From 0 to 1 with three continuous derivatives."""
    x = np.clip(x, 0, 1)
    return x**4 * (35 - 84 * x + 70 * x**2 - 20 * x**3)


def _dense(rng: np.random.Generator) -> np.ndarray:
    """Straight, turn, straight, by 40 to 300 waypoints."""
    s = np.linspace(0, 1, 20_001)
    begin, width, ramp = rng.uniform(0.2, 0.45), rng.uniform(0.1, 0.3), rng.uniform(0.08, 0.15)
    turn = _bump((s - begin) / ramp) - _bump((s - begin - width) / ramp)
    return _along(turn * rng.uniform(2e-4, 6e-4) * rng.choice([-1, 1]), rng.uniform(5e3, 9e3), rng.integers(40, 301))


def _straight(rng: np.random.Generator) -> np.ndarray:
    """A straight line, exactly or but for a wiggle whose curvature is 1e-14 to 1e-5 per mm."""
    count = int(rng.integers(4, 160))
    x = np.linspace(0.0, rng.uniform(2e3, 1e4), count)
    if rng.random() < 0.3:
        x = np.sort(x + rng.uniform(-0.3, 0.3, count) * x[1])
    size = rng.choice([0.0, 10.0 ** rng.uniform(-14, -5)])
    chord = float(np.diff(x).min())
    return np.stack([x, size * chord**2 / 8 * rng.uniform(-1, 1, count)], axis=1)


def _dwelling(rng: np.random.Generator) -> np.ndarray:
    """Dwells at zero between rises and falls, as a lift program has them."""
    s = np.linspace(0, 1, 20_001)
    curvature = np.zeros(len(s))
    for place in np.linspace(0.05, 0.75, int(rng.integers(1, 4)), endpoint=False):
        ramp, hold = rng.uniform(0.06, 0.1), rng.choice([0.0, 0.05])
        hump = _bump((s - place) / ramp) - _bump((s - place - ramp - hold) / ramp)
        curvature += hump * rng.uniform(1e-4, 4e-4) * rng.choice([-1, 1])
    return _along(curvature, rng.uniform(5e3, 9e3), int(rng.integers(81, 322)))


def _rippling(rng: np.random.Generator) -> np.ndarray:
    """Waves of curvature about zero, of any size down to nothing, with or without a turn between."""
    s = np.linspace(0, 1, 20_001)
    size, waves = 10.0 ** rng.uniform(-13, -4), rng.integers(3, 25)
    curvature = size / max(1.0, waves / 6) ** 2 * np.sin(TURN * waves * s + rng.uniform(0, TURN))
    if rng.random() < 0.5:
        curvature = curvature + 4e-4 * (_bump((s - 0.4) / 0.12) - _bump((s - 0.6) / 0.12))
    return _along(curvature, rng.uniform(5e3, 9e3), int(rng.integers(80, 240)))


_SHAPES = {"dense": _dense, "straight": _straight, "dwelling": _dwelling, "rippling": _rippling}


def verdict(case: Case, number: int, *, write: bool = False) -> str:
    """`passed`, `refused` as the truth has it, or what went wrong."""
    truth = case.truth()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "study.toml"
        file.write_text(case.text())
        try:
            plan = plan_cam(load_design(file), "actual")
            if plan.passed and number % 10 == 0:
                _fit(plan, Path(folder))
            if plan.passed and write:
                write_cam(plan, Path(folder) / "out", find_cures(plan))
        except CadgenError as error:
            return _refusal(str(error), truth)
        except Exception:
            return "fault: " + traceback.format_exc(limit=-2).strip().replace("\n", " | ")
    if not plan.passed:
        unfounded = [c.name for c in plan.failed if not _founded(c.code, truth)]
        return "refused" if not unfounded else f"false refusal: {', '.join(unfounded)}"
    if truth.pressure_angle(driven=True) > PRESSURE_LIMIT + radians(1.5):
        return f"passed, but the pressure angle is {degrees(truth.pressure_angle(driven=True)):.1f}"
    if number % 50 == 0 and truth.lost_lift() * 1e3 > LOST_LIMIT_UM + 0.1:
        return f"passed, but {truth.lost_lift() * 1e3:.2f} µm of lift are lost"
    return "passed"


def _fit(plan: CamPlan, folder: Path) -> None:
    """The curve as arcs, as splines and as a cloud that can be read again."""
    export = plan.application.design.export
    arcs(plan.curve, export.arc_tolerance_um * 1e-3)
    splines(plan.curve, 1e-5, 5)
    write_xyz(folder / "cloud.xyz", plan.curve, export.point_count)
    read_xyz(folder / "cloud.xyz")


def _refusal(message: str, truth: Truth) -> str:
    if "report this design" in message:
        return f"fault: {message}"
    steep = max(truth.pressure_angle(driven=True), truth.pressure_angle(driven=False)) > radians(75)
    founded = {
        "steeper than radial": steep,
        "overhangs": steep,
        "steering": truth.greatest_steering() > radians(30),
        "nothing is left of the disc": truth.room() < 0,
    }
    return "refused" if any(part in message and true for part, true in founded.items()) else f"false refusal: {message}"


def _founded(check: CheckCode, truth: Truth) -> bool:
    """Whether the truth fails a check, too, or all but fails it."""
    convex, hollow = truth.radii
    if check in (CheckCode.PRESSURE_ANGLE_RISE, CheckCode.PRESSURE_ANGLE_RETURN):
        return truth.pressure_angle(driven=True) > PRESSURE_LIMIT - radians(1.5)
    if check in (CheckCode.BLEND_PRESSURE_ANGLE_RISE, CheckCode.BLEND_PRESSURE_ANGLE_RETURN):
        return truth.pressure_angle(driven=False) > radians(65)
    if check is CheckCode.CUTTER_RADIUS:
        # Where the curvature has kinks, the rod's own section rounds the hollow corner.
        corner = truth.kind == "cubic" and truth.rod < CUTTER and truth.hollow_corner() > 4e-3
        # And where lift is lost, what the rod's own section has cut is left of the flanks.
        lost = truth.rod < CUTTER and truth.lost_lift() * 1e3 > LOST_LIMIT_UM
        return hollow + truth.rod < CUTTER * 1.1 or corner or lost
    if check is CheckCode.CONVEX_RADIUS_PROFILE:
        return 0 < convex < truth.rod + 0.6
    if check in LOST_LIFT or check is CheckCode.CONVEX_RADIUS_THEORY:
        return truth.lost_lift() * 1e3 > LOST_LIMIT_UM * 0.8
    return False


def _numbered(job: tuple[int, int, bool]) -> tuple[int, str, str]:
    seed, number, files = job
    case = case_of(seed, number)
    return number, case.kind, verdict(case, number, write=files and number % 100 == 0)


def run(cases: int, seed: int) -> Iterator[tuple[int, str, str]]:
    """Number, kind and verdict of each case."""
    with ProcessPoolExecutor(2) as pool:
        yield from pool.map(_numbered, [(seed, number, True) for number in range(cases)], chunksize=10)


def main() -> None:
    """Run the study and print, or record, its counts."""
    args = options(__doc__, cases=2500)
    counts: Counter[tuple[str, str]] = Counter()
    wrong = []
    for number, kind, said in run(args.cases, args.seed):
        good = said in ("passed", "refused")
        counts[kind, said if good else "wrong"] += 1
        if number % 100 == 99:
            print(f"{number + 1} cases, {len(wrong)} wrong", flush=True)
        if not good:
            wrong.append(f"- seed {args.seed}, case {number} ({kind}): {said}")
            print(wrong[-1], flush=True)
    rows = [
        f"| {kind} | " + " | ".join(str(counts[kind, said]) for said in ("passed", "refused", "wrong")) + " |"
        for kind in KINDS
    ]
    text = "\n".join(
        [
            "# Paths that are dense, straight, dwelling or rippling; blends beside a spline node",
            "",
            *(__doc__ or "").strip().splitlines()[4:],
            "",
            f"`python -m tests.studies.paths --cases {args.cases} --seed {args.seed} --record`, cadgen {__version__}.",
            "",
            "| kind | passed | refused, and so does the brute force | wrong |",
            "|---|---|---|---|",
            *rows,
            "",
            *(wrong or ["No case was wrong."]),
            "",
        ]
    )
    tell(text, RECORD if args.record else None)


if __name__ == "__main__":
    main()
