"""How well motions are found in worn cams: `python -m tests.studies.worn_cams --cases 20 --seed 1 --log FILE --record`.

Cams of two or three flanks with rises of 10 to 22 mm, laws drawn from 18, one flank worn by 30 um: as sin^2 over all of
it, as a half sine, skewed, as a bell over a part, or between soft edges. Five followers. Half of the cams have all ends
of segments at whole degrees, half at hundredths. 720 points of the outline in the frame of a measuring machine, or 720
lifts, each with 3 um of noise along x and y or along the lift. The generator shares no line with the program
(`tests.studies.worn_cams_truth`). Beside these stand cams with a law that no table has.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from tests.studies import worn_cams_truth as truth
from tests.studies.command import PAGES, options, tell
from tests.studies.journal import outcomes, stamp

TURN = 2 * np.pi
WEAR_MM, NOISE_MM, POINTS = 0.03, 3e-3, 720
SORTS = ("outline", "lift")
STRANGE_SHARE = 0.4  # of the cases of a sort, beside them
Shape = Callable[[np.ndarray], np.ndarray]
Found = dict[str, Any]


def wears(rng: np.random.Generator) -> dict[str, Shape]:
    """Shapes of wear, 1 at their greatest, by the share of the flank."""
    a, b, c = rng.uniform(1, 3), rng.uniform(1, 3), rng.uniform(0.3, 0.7)
    top = a**a * b**b / (a + b) ** (a + b)
    return {
        "sin^2": lambda u: np.sin(np.pi * np.clip(u, 0, 1)) ** 2,
        "half sine": lambda u: np.sin(np.pi * np.clip(u, 0, 1)),
        "skewed": lambda u: np.clip(u, 0, 1) ** a * (1 - np.clip(u, 0, 1)) ** b / top,
        "bell": lambda u: np.exp(-(((u - c) / 0.12) ** 2) / 2),
        "soft edges": lambda u: np.clip(np.minimum(u, 1 - u) / 0.15, 0, 1),
    }


def followers() -> list[tuple[truth.Follower, float]]:
    """Followers and the motion's unit by mm of rise."""
    arm = {"radius_mm": 9.0, "arm_mm": 90.0, "centre_distance_mm": 120.0}
    return [
        (truth.Follower("roller", {"radius_mm": 9.0, "offset_mm": 6.0}, 60.0), 1.0),
        (truth.Follower("flat", {"tilt_deg": 0.0}, 120.0), 1.0),
        (truth.Follower("swinging_roller", {**arm, "lifts": "against"}, 50.0), 1 / 90),
        (truth.Follower("swinging_roller", {**arm, "lifts": "with"}, 50.0), 1 / 90),
        (
            truth.Follower(
                "swinging_flat", {"face_offset_mm": 5.0, "centre_distance_mm": 180.0, "lifts": "against"}, 90.0
            ),
            1 / 150,
        ),
    ]


def drawn(
    rng: np.random.Generator, number: int, *, strange: bool
) -> tuple[truth.Worn, truth.Follower, float, int, str]:
    """Cam that is not undercut, its follower, the unit of its motion by mm, its worn flank, and the shape of wear."""
    follower, scale = followers()[number % 5]
    whole = number // 5 % 2 == 0
    while True:
        count = int(rng.integers(2, 4))
        widths = rng.uniform(60, 95, 2) if count == 2 else rng.uniform(48, 70, 3)
        rests = rng.dirichlet(np.full(count, 4.0)) * (360 - widths.sum())
        widths, rests = (np.round(each, 0 if whole else 2) for each in (widths, rests))
        height = rng.uniform(10, 16)
        rises = [height, -height] if count == 2 else [height + 10.5, -10.5, -height]
        if count == 3 and rng.uniform() < 0.5:
            rises = [height, 10.5, -height - 10.5]
        laws = [str(law) for law in rng.choice(list(truth.LAWS), count)]
        worn = int(rng.integers(count))
        shapes = wears(rng)
        name = list(shapes)[int(rng.integers(len(shapes)))]
        if strange:
            laws[worn], name = str(rng.choice(list(truth.STRANGE))), "none"
        flanks, at, level = [], 0.0, 0.0
        for k in range(count):
            after = 0.0 if k == count - 1 else level + rises[k] * scale
            shape = shapes.get(name)
            wear = None if k != worn or shape is None else (lambda u, shape=shape: WEAR_MM * shape(u))
            flanks.append(truth.Flank(at, at + widths[k], level, after, laws[k], wear))
            at, level = at + widths[k] + rests[k], after
        cam = truth.Worn(tuple(flanks), truth.STRANGE)
        point, _ = follower.contact(cam.lift, np.linspace(0, TURN, 3601))
        if (np.diff(np.unwrap(np.angle(point))) < 0).all() and rests.min() > 5:
            return cam, follower, scale, worn, name


def design_text(follower: truth.Follower) -> str:
    """Design file that says what is known."""
    keys = "\n".join(
        f'{key} = "{value}"' if isinstance(value, str) else f"{key} = {value}" for key, value in follower.keys.items()
    )
    return f"""
[motion]
turns = "counterclockwise"
measured = true
[follower]
kind = "{follower.kind}"
{keys}
[cam]
base_circle_radius_mm = {follower.base}
thickness_mm = 10.0
"""


def judged(seed: int, sort: str, number: int, strange: bool) -> Found:
    """A case, and what was found in it."""
    from cadgen import Design
    from cadgen.errors import CadgenError

    rng = np.random.default_rng([seed, number, SORTS.index(sort), strange])
    cam, follower, scale, worn, wear = drawn(rng, number, strange=strange)
    start = rng.uniform(0, TURN)
    case: Found = {"sort": sort, "follower": follower.kind, "wear": wear, "strange": strange}
    if sort == "outline":
        centre = complex(*rng.uniform(-200, 200, 2))
        points = truth.outline(
            cam, follower, POINTS, NOISE_MM, rng, centre=centre, start=start, backwards=bool(rng.integers(2))
        )
        columns = {"x_mm": points[:, 0], "y_mm": points[:, 1]}
        ahead = np.pi / 2 if follower.kind in ("roller", "flat") else 0.0
        # Where the follower stands at the drawing's cam angle 0, and that the record counts the other way.
        turned = -(start + ahead)
    else:
        each = truth.lifts(cam, follower, POINTS, NOISE_MM * scale, rng, start=start)
        swings = scale != 1
        columns = {
            "cam_angle_deg": np.degrees(each[:, 0]),
            "lift_deg" if swings else "lift_mm": np.degrees(each[:, 1]) if swings else each[:, 1],
        }
        turned = start
    try:
        found = Design.from_toml(design_text(follower), "cam").find_motion(columns)
    except CadgenError as error:
        return case | {"refused": str(error)}
    theta = np.linspace(0, TURN, 7201)
    low = min(flank.before for flank in cam.flanks)
    off = np.abs(found.motion.lift(theta + turned) - (cam.lift(theta) - low)) / scale
    case["lift_um"] = 1e3 * float(off.max())
    case["sound"] = bool(found.cam.sound)
    grid = found.stated.grid
    case["grid"] = None if grid is None or not grid.sure else grid.step
    case["flanks"] = []
    for number_of, real in enumerate(cam.flanks):
        near = min(found.flanks, key=lambda flank: abs(_apart(flank.start - turned, np.radians(real.start))))
        codes = [fit.candidate.code for fit in near.rivals]
        mine = (theta >= np.radians(real.start)) & (theta <= np.radians(real.stop))
        case["flanks"].append(
            {
                "law": real.law,
                "said": codes,
                "worn": number_of == worn,
                "ends_deg": [
                    float(np.degrees(_apart(near.start - turned, np.radians(real.start)))),
                    float(np.degrees(_apart(near.stop - turned, np.radians(real.stop)))),
                ],
                "rise_um": 1e3 * float(near.after - near.before - (real.after - real.before)) / scale,
                "lift_um": 1e3 * float(off[mine].max()),
                "doubtful": near.doubtful,
            }
        )
    return case


def _apart(one: float, two: float) -> float:
    return float((one - two + np.pi) % TURN - np.pi)


def table(cases: Sequence[Found]) -> list[str]:
    """Rows of the page."""
    plain = [case for case in cases if not case["strange"]]
    lines = ["| | bar | outline | lift |", "|---|---|---|---|"]

    def row(name: str, bar: str, figure: Callable[[list[Found]], str]) -> None:
        cells = [figure([case for case in plain if case["sort"] == sort and "flanks" in case]) for sort in SORTS]
        lines.append(f"| {name} | {bar} | {' | '.join(cells)} |")

    def flanks(of: list[Found], *, worn: bool | None = None) -> list[Found]:
        return [each for case in of for each in case["flanks"] if worn is None or each["worn"] == worn]

    def right(each: Found) -> bool:
        return bool(each["said"] == [each["law"]])

    def open_(each: Found) -> bool:
        return each["law"] in each["said"] and 1 < len(each["said"]) <= 2

    row("cams", "20", lambda of: str(len(of)))
    row("law of every flank named rightly", "≥ 18 of 20", lambda of: str(sum(all(map(right, c["flanks"])) for c in of)))
    row(
        "undecided between two, the truth among them",
        "≤ 2",
        lambda of: str(
            sum(any(map(open_, c["flanks"])) and all(right(f) or open_(f) for f in c["flanks"]) for c in of)
        ),
    )
    row(
        "undecided between more",
        "0",
        lambda of: str(sum(any(f["law"] in f["said"] and len(f["said"]) > 2 for f in c["flanks"]) for c in of)),
    )
    row("wrong", "0", lambda of: str(sum(any(f["law"] not in f["said"] for f in c["flanks"]) for c in of)))
    row("flanks named rightly", "", lambda of: f"{sum(map(right, flanks(of)))} of {len(flanks(of))}")
    for what, worn, bar in (("sound", False, "≤ 0.05"), ("worn", True, "≤ 0.6")):
        row(
            f"ends of segments, {what} flanks, greatest error, degrees",
            bar,
            lambda of, worn=worn: (
                f"{max((abs(e) for f in flanks(of, worn=worn) for e in f['ends_deg']), default=0):.3f}"
            ),
        )
    row("rise, greatest error, µm", "≤ 5", lambda of: f"{max((abs(f['rise_um']) for f in flanks(of)), default=0):.1f}")
    row("new lift, greatest error, µm", "≤ 5", lambda of: f"{max((c['lift_um'] for c in of), default=0):.1f}")
    for what, grid in (("ends at whole degrees, all taken to be there", True), ("other cams", False)):
        row(
            f"new lift, {what}: cams, median and greatest error, µm",
            "",
            lambda of, grid=grid: _spread([c["lift_um"] for c in of if (c["grid"] is not None) == grid]),
        )
    row(
        "new lift, sound flanks, greatest error, µm",
        "≤ 5",
        lambda of: f"{max((f['lift_um'] for f in flanks(of, worn=False)), default=0):.1f}",
    )
    refused = {sort: sum("refused" in c for c in plain if c["sort"] == sort) for sort in SORTS}
    lines.append(f"| refused | 0 | {refused['outline']} | {refused['lift']} |")
    strange = [case for case in cases if case["strange"] and "flanks" in case]
    told = [f for c in strange for f in c["flanks"] if f["worn"]]
    lines += [
        "",
        f"Of {len(told)} flanks with a law of no table, {sum(not f['said'] for f in told)} are said to have none, "
        f"{sum(bool(f['said']) and f['doubtful'] for f in told)} are said to be worn or to have none, and "
        f"{sum(bool(f['said']) and not f['doubtful'] for f in told)} are given a law:",
        "",
        "| law | flanks | none of the table | worn, or none of the table | given a law |",
        "|---|---|---|---|---|",
    ]
    for law in truth.STRANGE:
        of = [f for f in told if f["law"] == law]
        none = sum(not f["said"] for f in of)
        doubtful = sum(bool(f["said"]) and f["doubtful"] for f in of)
        lines.append(f"| {law} | {len(of)} | {none} | {doubtful} | {len(of) - none - doubtful} |")
    return lines


def _spread(values: list[float]) -> str:
    return f"{len(values)}: {np.median(values):.1f}, {max(values):.1f}" if values else "0"


def wanting(cases: Sequence[Found]) -> list[str]:
    """Rows of the cases whose laws are not all named, or whose lift is off."""
    rows = ["| record | follower | wear | law | said | ends, degrees | lift, µm |", "|---|---|---|---|---|---|---|"]
    for case in cases:
        if case["strange"]:
            continue
        if "refused" in case:
            rows.append(f"| {case['sort']} | {case['follower']} | {case['wear']} | | {case['refused']} | | |")
            continue
        for each in case["flanks"]:
            if each["said"] != [each["law"]] or each["lift_um"] > 5:
                ends = ", ".join(f"{end:.3f}" for end in each["ends_deg"])
                wear = case["wear"] if each["worn"] else "sound"
                said = ", ".join(each["said"]) or "none"
                rows.append(
                    f"| {case['sort']} | {case['follower']} | {wear} | {each['law']} | {said} | {ends} | "
                    f"{each['lift_um']:.1f} |"
                )
    return rows


def keys(cases: int, seed: int) -> list[tuple[int, str, int, bool]]:
    """Cases of a study."""
    strange = round(cases * STRANGE_SHARE)
    return [
        (seed, sort, n, odd) for odd, count in ((False, cases), (True, strange)) for n in range(count) for sort in SORTS
    ]


def main() -> None:
    """Run the study."""
    asked = options(__doc__, cases=20)
    found = outcomes(judged, keys(asked.cases, asked.seed), asked.log, processes=asked.processes)
    about = (__doc__ or "").partition("\n\n")[2]
    text = "\n".join(
        [
            "# Motions found in worn cams",
            "",
            about,
            f"`python -m tests.studies.worn_cams --cases {asked.cases} --seed {asked.seed} --record`, {stamp()}",
            "",
            *table(found),
            "",
            "Flanks that are not named, or whose lift is more than 5 µm off:",
            "",
            *wanting(found),
            "",
        ]
    )
    tell(text, PAGES / "worn_cams.md" if asked.record else None)


if __name__ == "__main__":
    main()
