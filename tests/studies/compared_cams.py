"""Measured cams beside their designs: `python -m tests.studies.compared_cams --cases 120 --seed 1 --record`.

Cams of two flanks with laws drawn from six and rises of 8 to 16 mm, under six followers: roller, knife, tilted face,
arm with a roller, lifting against and with the cam, swinging face. Each is off by one thing, or by two, or by none, or
is worn by 30 um over a flank, or has another law on its rise, or lies wrong side up. 720 lifts, or 720 points of the
outline about its bore, clocked anyhow, with 3 um of noise. A deviation is *named* if it is found and nothing else,
*undecided* if it stands among what explains the record as well, *not seen* if nothing is found. In lifts larger
rollers, and faces nearer to their cam, are twins of a larger disc, and count as it. A disc that was cut for another
base circle, and one that is larger along its normal, have one name. Beside each design stand the rows of
`cadgen tolerance` against changed followers and discs, let down again with as much as a row is said for, and with as
much the other way.
The generator shares no line with the program (`tests.studies.worn_cams_truth`).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tests.studies import worn_cams_truth as truth
from tests.studies.command import PAGES, options, tell
from tests.studies.journal import outcomes, stamp

TURN = 2 * np.pi
NOISE_MM, POINTS, DENSE = 3e-3, 720, 12_001
SORTS = ("lift", "outline")
TOLERANCE, ROLLED = "tolerance", 240
SIGMAS = 4.0  # within which a size must be of the truth
FIRST_ORDER = 0.02  # of a row, by which the lift may differ without being of second order
LAWS = (
    "polynomial_3_4_5",
    "polynomial_4_5_6_7",
    "cycloidal",
    "modified_trapezoid",
    "modified_sine",
    "modified_sine_50",
)
TWINS = {"roller_radius": "base_circle", "face_offset": "base_circle"}  # of lifts
CUT = {"base_circle_cut": "base_circle"}
# Dimensions of the truth's followers by the code of the deviation.
KEYS = {
    "roller_radius": "radius_mm",
    "offset": "offset_mm",
    "arm": "arm_mm",
    "centre_distance": "centre_distance_mm",
    "face_offset": "face_offset_mm",
    "tilt": "tilt_deg",
}
ANGLES = ("tilt", "phase")
OTHER = ("none", "wear", "other law", "wrong side up")
HEADS = ("cases", "named", "undecided", "not seen", "wrong", "sizes within range")
Found = dict[str, Any]


def followers(rng: np.random.Generator) -> list[tuple[truth.Follower, float]]:
    """Followers of a random size and the motion's unit by mm of rise."""
    base, r = float(rng.uniform(35, 55)), float(rng.uniform(6, 12))
    arm = {"radius_mm": r, "arm_mm": 1.6 * base, "centre_distance_mm": 2.1 * base}
    offset = float(rng.uniform(-8, 8))
    face = {"face_offset_mm": float(rng.uniform(-6, 10)), "centre_distance_mm": 3.0 * base}
    return [
        (truth.Follower("roller", {"radius_mm": r, "offset_mm": offset}, base), 1.0),
        (truth.Follower("roller", {"radius_mm": 0.0, "offset_mm": offset}, base), 1.0),
        (truth.Follower("flat", {"tilt_deg": float(rng.uniform(-12, 12))}, base + 40), 1.0),
        (truth.Follower("swinging_roller", {**arm, "lifts": "against"}, base), 1 / arm["arm_mm"]),
        (truth.Follower("swinging_roller", {**arm, "lifts": "with"}, base), 1 / arm["arm_mm"]),
        (truth.Follower("swinging_flat", {**face, "lifts": "against"}, base + 30), 1 / (2.7 * base)),
    ]


def dimensions(follower: truth.Follower) -> list[str]:
    """Codes of what may be off in a follower, and the disc all round."""
    return ["base_circle"] + [
        code
        for code, key in KEYS.items()
        if key in follower.keys and not (code == "roller_radius" and not follower.keys[key])
    ]


def code_of(follower: truth.Follower) -> str:
    """Code of a follower in a design file."""
    return "knife" if follower.keys.get("radius_mm") == 0.0 else follower.kind


def drawn(rng: np.random.Generator, number: int) -> tuple[truth.Worn, truth.Follower, float]:
    """Cam that can be run on, its follower, and the unit of its motion by mm."""
    while True:
        follower, scale = followers(rng)[number % 6]
        widths, rest = np.round(rng.uniform(75, 125, 2), 1).tolist(), round(float(rng.uniform(20, 70)), 1)
        height, laws = float(rng.uniform(8, 16)) * scale, [str(law) for law in rng.choice(LAWS, 2)]
        start = widths[0] + rest
        cam = truth.Worn(
            (
                truth.Flank(0.0, widths[0], 0.0, height, laws[0]),
                truth.Flank(start, start + widths[1], height, 0.0, laws[1]),
            )
        )
        point = truth.dense(cam, follower, 3601)
        if start + widths[1] < 350 and (np.diff(np.unwrap(np.angle(point))) < 0).all():
            return cam, follower, scale


def design_text(cam: truth.Worn, follower: truth.Follower, more: str = "") -> str:
    """Design file of a cam as it is meant."""
    kind = code_of(follower)
    keys = "\n".join(
        f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value!r}"
        for key, value in follower.keys.items()
        if not (kind == "knife" and key == "radius_mm")
    )
    first, second = cam.flanks
    swings = kind.startswith("swinging")
    top = float(np.degrees(first.after)) if swings else first.after
    unit = "deg" if swings else "mm"
    return f"""
[motion]
turns = "counterclockwise"
segments = [
    {{ to_{unit} = {top!r}, in_deg = {first.stop!r}, law = "{first.law}" }},
    {{ dwell_deg = {second.start - first.stop!r} }},
    {{ to_{unit} = 0.0, in_deg = {second.stop - second.start!r}, law = "{second.law}" }},
    {{ dwell_deg = {360 - second.stop!r} }},
]
[follower]
kind = "{kind}"
{keys}
[cam]
base_circle_radius_mm = {follower.base!r}
thickness_mm = 10.0
{more}"""


def changed(follower: truth.Follower, by: Mapping[str, complex]) -> truth.Follower:
    """Follower with dimensions changed, mm or rad, but the disc all round."""
    keys = dict(follower.keys)
    for code, change in by.items():
        if code in KEYS:
            step = float(np.degrees(change.real)) if code == "tilt" else change.real
            keys[KEYS[code]] = float(keys[KEYS[code]]) + step  # type: ignore[arg-type]
    return replace(follower, keys=keys, base=follower.base + by.get("base_circle_cut", 0j).real)


def grown(cam: truth.Worn, follower: truth.Follower, by: float) -> np.ndarray:
    """Dense points of a disc that is larger by a distance along its normal, complex, mm."""
    point, normal = follower.contact(cam.lift, np.linspace(0, TURN, DENSE))
    return point + (by - cam.wear(np.linspace(0, TURN, DENSE))) * normal


def let_down(
    cam: truth.Worn, follower: truth.Follower, by: Mapping[str, complex], theta: np.ndarray, *, mirrored: bool = False
) -> np.ndarray:
    """Place of a follower that is off on a disc that is off, mm or rad."""
    disc = grown(cam, follower, by.get("base_circle", 0j).real)
    turned = theta + by.get("phase", 0j).real
    return truth.dropped(disc, changed(follower, by), turned, mirrored=mirrored, shift=by.get("eccentricity", 0j))


def outline(
    cam: truth.Worn, follower: truth.Follower, by: Mapping[str, complex], rng: np.random.Generator, *, mirrored: bool
) -> np.ndarray:
    """Measured points of a disc about its bore, that was cut for a follower that is off, shape (n, 2), mm."""
    start = float(rng.uniform(0, TURN))
    points = truth.outline(
        cam,
        changed(follower, by),
        POINTS,
        NOISE_MM,
        rng,
        centre=by.get("eccentricity", 0j) * np.exp(1j * start),
        start=start,
        backwards=bool(rng.integers(2)),
        larger=by.get("base_circle", 0j).real,
    )
    return points * [1.0, -1.0] if mirrored else points


def deviations(rng: np.random.Generator, follower: truth.Follower, sort: str, number: int) -> tuple[str, list[str]]:
    """Name of the thing that a case is off by, and codes of deviations."""
    codes = [*dimensions(follower), "phase" if sort == "lift" else "base_circle_cut"]  # an outline is clocked anyhow
    codes.append("eccentricity")
    several = ["two"] * 2
    choice = [*codes, *OTHER, *several][number // 6 % (len(codes) + len(OTHER) + len(several))]
    if choice in OTHER:
        return choice, []
    if choice != "two":
        return choice, [choice]
    while True:
        two = [str(code) for code in rng.choice(codes, 2, replace=False)]
        if not set(two) & {*TWINS, "base_circle_cut"}:
            return " and ".join(sorted(two)), two


def size_of(rng: np.random.Generator, code: str, *, cut: bool) -> complex:
    """Random size of a deviation, mm or rad; along x and y of an eccentric bore."""
    sign = rng.choice((-1, 1))
    if code in ANGLES:
        return complex(sign * np.radians(rng.uniform(0.1, 0.4)))
    if code == "roller_radius" and cut:  # shows by 1 - cos of the pressure angle alone
        return complex(sign * rng.uniform(0.3, 0.6))
    if code == "eccentricity":
        return complex(rng.uniform(0.03, 0.1) * np.exp(1j * rng.uniform(0, TURN)))
    return complex(
        sign * (rng.uniform(0.1, 0.4) if code in ("offset", "arm", "centre_distance") else rng.uniform(0.02, 0.1))
    )


def judged(seed: int, sort: str, number: int) -> Found:
    """A measured cam, and what was found in it; or rows of a design's tolerances."""
    return rows_of(seed, number) if sort == TOLERANCE else compared(seed, sort, number)


def rows_of(seed: int, number: int) -> Found:
    """Rows of `cadgen tolerance` beside what changed followers and discs do when they are let down again."""
    from cadgen import Design

    rng = np.random.default_rng([seed, number, len(SORTS)])
    cam, follower, scale = drawn(rng, number)
    codes = [*dimensions(follower), "phase", "eccentricity"]
    sizes = {code: abs(size_of(rng, code, cut=False)) for code in codes}
    stated = (
        "\n".join(
            f"{code}_deg = {np.degrees(size)!r}" if code in ANGLES else f"{code}_um = {1e3 * size!r}"
            for code, size in sizes.items()
        )
        .replace("np.float64(", "")
        .replace(")", "")
    )
    run = Design.from_toml(design_text(cam, follower, f"[lift_tolerances]\n{stated}\n"), "cam").lift_tolerance(100)
    theta = np.arange(ROLLED) * TURN / ROLLED
    plain = let_down(cam, follower, {}, theta)
    case: Found = {"sort": TOLERANCE, "follower": code_of(follower), "rows": []}
    # The way of the contact along which the lift of an arm is told.
    for cost in run.costs:
        size = sizes[cost.code]
        ways = (1.0, 1j) if cost.code == "eccentricity" else (1.0,)
        both = [
            [_set(let_down(cam, follower, {cost.code: complex(sign * size * way)}, theta) - plain) for sign in (1, -1)]
            for way in ways
        ]
        first = np.sqrt(sum(((one - other) / 2) ** 2 for one, other in both))
        second = np.sqrt(sum(((one + other) / 2) ** 2 for one, other in both))
        lift = length_of(follower, scale)
        case["rows"].append(
            [cost.code, 1e3 * cost.greatest, 1e3 * lift * float(first.max()), 1e3 * lift * float(second.max())]
        )
    return case


def _set(error: np.ndarray) -> np.ndarray:
    """Error of a follower that is set at cam angle 0."""
    return error - error[0]


def length_of(follower: truth.Follower, scale: float) -> float:
    """Way of the contact by the motion, mm: on an arm its length, on a swinging face the contact's distance at rest."""
    if scale == 1:
        return 1.0
    if follower.kind == "swinging_roller":
        return float(follower.keys["arm_mm"])  # type: ignore[arg-type]
    c, f = float(follower.keys["centre_distance_mm"]), float(follower.keys["face_offset_mm"])  # type: ignore[arg-type]
    return float(np.sqrt(c**2 - (follower.base + f) ** 2))


def compared(seed: int, sort: str, number: int) -> Found:
    """A measured cam, and what was found in it."""
    from cadgen import Design
    from cadgen.errors import CadgenError

    rng = np.random.default_rng([seed, number, SORTS.index(sort)])
    cam, follower, scale = drawn(rng, number)
    text = design_text(cam, follower)
    name, codes = deviations(rng, follower, sort, number)
    by = {code: size_of(rng, code, cut=sort == "outline") for code in codes}
    case: Found = {"sort": sort, "follower": code_of(follower), "off": name, "number": number}
    worn = int(rng.integers(2))
    if name == "wear":
        flanks = list(cam.flanks)
        flanks[worn] = replace(flanks[worn], wear=lambda u: 0.03 * np.sin(np.pi * np.clip(u, 0, 1)) ** 2)
        cam = replace(cam, flanks=tuple(flanks))
    if name == "other law":
        first = cam.flanks[0]
        law = "simple_harmonic" if first.law != "polynomial_3_4_5" else "cycloidal"
        cam = replace(cam, flanks=(replace(first, law=law), cam.flanks[1]))
    mirrored = name == "wrong side up"
    if sort == "lift":
        theta = np.arange(POINTS) * TURN / POINTS
        keyed = float(rng.uniform(0, TURN)) if mirrored else 0.0
        place = let_down(cam, follower, by, theta + keyed, mirrored=mirrored)
        place = place + NOISE_MM * scale * rng.standard_normal(POINTS)
        column = np.degrees(place) if scale != 1 else place
        columns = {"cam_angle_deg": np.degrees(theta), "lift_deg" if scale != 1 else "lift_mm": column}
    else:
        points = outline(cam, follower, by, rng, mirrored=mirrored)
        columns = {"x_mm": points[:, 0], "y_mm": points[:, 1]}
    try:
        found = Design.from_toml(text, "cam").compare_cam(columns)
    except CadgenError as error:
        return case | {"refused": str(error)}
    c = found.comparison
    said = {each.code: each for each in c.found}
    case |= {
        "said": sorted(said),
        "rivals": [sorted(each) for each in c.rivals],
        "worn": [[float(np.degrees(each.start)), float(np.degrees(each.stop)), 1e3 * each.depth] for each in c.worn],
        "mirrored": bool(c.mirrored),
        "explained": bool(c.explained),
        "readiness": found.readiness.value,
        "left_um": 1e3 * c.worst[0],
        "left_deg": float(np.degrees(c.worst[1])),
        "noise_um": 1e3 * c.noise,
    }
    alike = TWINS if sort == "lift" else CUT
    meant = {alike.get(code, code) for code in codes}
    if sort == "lift" and follower.kind == "flat":
        meant -= {"base_circle"}  # lifts a face alike everywhere, which the zero of the dial takes
    case["meant"] = sorted(meant)
    if name == "wear":
        flank = cam.flanks[worn]
        case["place"] = len(c.worn) == 1 and bool(abs(case["worn"][0][0] - flank.start) < 3)
    case["sizes"] = []
    for code, size in by.items():
        one = said.get(alike.get(code, code))
        if one is None or set(said) != meant:
            continue
        meant_size: complex = size
        if code == "eccentricity":  # files show the face on which the disc turns clockwise, from the follower's ray
            meant_size = np.conj(size * (1 if scale != 1 else -1j))
        away = complex(*one.values) - meant_size
        case["sizes"].append([code, float(abs(size)), abs(away), float(max(one.sigmas))])
    return case


def verdict(case: Found) -> str:
    """Whether a case is named rightly."""
    if "refused" in case:
        return "refused"
    said, meant = set(case["said"]), set(case["meant"])
    if case["off"] == "wrong side up":
        return "named" if case["mirrored"] else "wrong"
    if case["mirrored"]:
        return "wrong"
    if case["off"] == "wear":
        if not case["worn"]:
            return "undecided" if ["wear"] in case["rivals"] else "wrong"
        if said or not case["place"] or case["readiness"] != "not-ready":
            return "wrong"
        return "undecided" if case["rivals"] else "named"
    if case["off"] == "other law":
        return "wrong" if said or case["worn"] or case["readiness"] != "not-ready" else "named"
    if case["worn"]:
        return "undecided" if sorted(meant) in case["rivals"] else "wrong"
    if said == meant:
        return "named" if case["explained"] and not case["rivals"] else "undecided" if case["explained"] else "wrong"
    if sorted(meant) in case["rivals"]:
        return "undecided"
    return "not seen" if said < meant else "wrong"


def sized(case: Found) -> bool:
    """Whether every size lies within its range."""
    return all(away < SIGMAS * sigma for _, _, away, sigma in case["sizes"])


def row_of(row: Sequence[Any]) -> str:
    """Whether a row of the tolerances is right."""
    _, said, first, second = row
    if abs(said - first) <= FIRST_ORDER * max(first, 0.05):
        return "within 2 %"
    return "second order" if abs(said - first) <= second else "wrong"


def table(cases: Sequence[Found]) -> list[str]:
    """Rows of the page."""
    lines = ["| off by | " + " | ".join(f"{sort}: {what}" for sort in SORTS for what in HEADS) + " |"]
    lines.append("|---" * (1 + len(SORTS) * len(HEADS)) + "|")
    kinds = {"two": "two at once"}
    measured = [case for case in cases if case["sort"] != TOLERANCE]
    names = sorted({_group(case) for case in measured})
    for name in [*names, "all"]:
        cells = []
        for sort in SORTS:
            some = [case for case in measured if case["sort"] == sort and name in (_group(case), "all")]
            found = Counter(verdict(case) for case in some)
            sizes = [case for case in some if case.get("sizes")]
            cells += [len(some), *(found[each] for each in ("named", "undecided", "not seen", "wrong"))]
            cells.append(f"{sum(map(sized, sizes))} of {len(sizes)}" if sizes else "-")
        lines.append(f"| {kinds.get(name, name)} | " + " | ".join(map(str, cells)) + " |")
    refused = sum(verdict(case) == "refused" for case in measured)
    lines += ["", f"Refused: {refused}.", "", "Rows of the tolerances:", ""]
    rows = [(case["follower"], row) for case in cases if case["sort"] == TOLERANCE for row in case["rows"]]
    lines += [
        "| off by | rows | within 2 % of what is rolled | off by no more than its second order | wrong | greatest, % |"
    ]
    lines.append("|---|---|---|---|---|---|")
    for code in sorted({row[0] for _, row in rows}):
        some = [row for _, row in rows if row[0] == code]
        found = Counter(map(row_of, some))
        worst = max(100 * abs(row[1] - row[2]) / max(row[2], 0.05) for row in some)
        lines.append(
            f"| {code} | {len(some)} | {found['within 2 %']} | {found['second order']} | {found['wrong']} "
            f"| {worst:.2f} |"
        )
    return lines


def _group(case: Found) -> str:
    return "two" if " and " in case["off"] else str(case["off"])


def wanting(cases: Sequence[Found]) -> list[str]:
    """Rows of the cases that are not named, or whose sizes are off."""
    lines = [
        "| record | follower | off by | said | as likely | verdict | sizes off by, sigmas |",
        "|---|---|---|---|---|---|---|",
    ]
    for case in cases:
        if case["sort"] == TOLERANCE:
            continue
        judged_as = verdict(case)
        if judged_as == "named" and sized(case):
            continue
        if judged_as == "refused":
            lines.append(f"| {case['sort']} | {case['follower']} | {case['off']} | {case['refused']} | | refused | |")
            continue
        said = [*case["said"], *(["wear"] if case["worn"] else []), *(["wrong side up"] if case["mirrored"] else [])]
        rivals = "; ".join(" and ".join(each) or "nothing" for each in case["rivals"])
        off = ", ".join(f"{away / sigma:.1f}" for _, _, away, sigma in case["sizes"])
        lines.append(
            f"| {case['sort']} | {case['follower']} | {case['off']} | {', '.join(said) or 'nothing'} | {rivals} "
            f"| {judged_as} | {off} |"
        )
    return lines


def keys(cases: int, seed: int) -> list[tuple[int, str, int]]:
    """Cases of a study: of each record as many, and a quarter as many designs with tolerances."""
    return [
        *((seed, sort, n) for n in range(cases) for sort in SORTS),
        *((seed, TOLERANCE, n) for n in range(cases // 4)),
    ]


def main() -> None:
    """Run the study."""
    asked = options(__doc__, cases=120)
    found = outcomes(judged, keys(asked.cases, asked.seed), asked.log, processes=asked.processes)
    text = "\n".join(
        [
            "# Measured cams beside their designs",
            "",
            (__doc__ or "").partition("\n\n")[2],
            f"`python -m tests.studies.compared_cams --cases {asked.cases} --seed {asked.seed} --record`, {stamp()}",
            "",
            *table(found),
            "",
            "Cases that are not named, or whose sizes are not within 4 standard deviations:",
            "",
            *wanting(found),
            "",
        ]
    )
    tell(text, PAGES / "compared_cams.md" if asked.record else None)


if __name__ == "__main__":
    main()
