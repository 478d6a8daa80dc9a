"""Random trains and searches against gears of this file's own: `python -m tests.studies.trains --cases 200 --seed 1`.

Of every four cases one is a train as it is given and three are searches within small limits. The judge is
`tests.studies.trains_truth`, which shares nothing with cadgen. What it asks:

- the figures agree: plays, return errors, contact ratios, undercut;
- a train that is passed keeps every limit, and one that fails a check oversteps the limit that is named;
- a search makes the train of the least return error among all that can be made, or none if there is none;
- a refusal is true, and nothing ends in an error of the program.
"""

from __future__ import annotations

import random
import traceback
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from math import ceil, isclose

from tests.studies.command import PAGES, options, tell
from tests.studies.trains_truth import Pair, Wheel, best_train, errors, fits_as_given, given_pairs, height_of, in_mesh

RECORD = PAGES / "trains.md"

# ---------------------------------------------------------------- cases


@dataclass(frozen=True)
class Case:
    """One case: the design's [train] as a table, and what is asked."""

    number: int
    order: str
    keys: dict


def case(seed: int, number: int) -> Case:
    rng = random.Random(f"{seed}/{number}")
    search = number % 4 != 0
    stages = rng.choice((1, 2, 2, 3))
    modules = rng.sample((0.5, 0.6, 0.8, 1.0, 1.25, 1.5), rng.choice((1, 1, 2)))
    widths = rng.sample((4.0, 5.0, 6.0, 8.0, 10.0), rng.choice((1, 2)))
    keys: dict = {
        "module_mm": modules[0],
        "width_mm": widths[0],
        "grade": rng.choice((5, 6, 7, 7, 8, 9)),
        "bearing_span_mm": float(rng.choice((30, 40, 60))),
    }
    if rng.random() < 0.4:
        keys["thinning"] = rng.choice(("least", "greatest"))
    if rng.random() < 0.3:
        keys["E_sn_um"] = float(rng.choice((0, -20, -40, -60, -90, -130)))
    if rng.random() < 0.4:
        bore = rng.choice((1.5, 2.0, 3.0, 5.0))
        keys |= {place: {"bore_diameter_mm": bore} for place in ("drive", "intermediate", "output")}
    low = rng.choice((9, 12, 14, 17, 20))
    high = low + (rng.choice((25, 40, 60)) if stages < 3 else rng.choice((14, 20)))
    keys["stages"] = []
    for _ in range(stages):
        m = rng.choice(modules)
        teeth = sorted((rng.randint(low, high), rng.randint(low, high)), reverse=rng.random() < 0.1)
        if m * min(teeth) < 5:
            teeth = [max(z, ceil(5 / m)) for z in teeth]
        keys["stages"].append(
            {
                "centre_distance_mm": m * sum(teeth) / 2,
                "driver": {"teeth": teeth[0], "module_mm": m, "width_mm": rng.choice(widths)},
                "driven": {"teeth": teeth[1], "module_mm": m, "width_mm": rng.choice(widths)},
            }
        )
    if not search:
        return Case(number, "as-given", keys)
    keys["search"] = limits = {
        "teeth_min": low,
        "teeth_max": high,
        "modules_mm": modules,
        "widths_mm": widths,
        "keep": 5,
    }
    limits["centre_distance_min_mm"], limits["centre_distance_max_mm"] = 3.0, rng.choice((20.0, 35.0, 60.0))
    if rng.random() < 0.5:
        limits["contact_ratio_min"] = rng.choice((1.1, 1.2, 1.4, 1.6))
    if rng.random() < 0.5:
        limits["undercut_max"] = rng.choice((0.0, 0.2, 0.6))
    if rng.random() < 0.3:
        limits["stage_ratio_min"] = rng.choice((0.5, 1.5))
    if rng.random() < 0.3:
        limits["stage_ratio_max"] = rng.choice((3.0, 5.0))
    return Case(number, "search", keys)


def judged(seed: int, number: int) -> tuple[str, str]:
    """Kind of outcome of a case, and what is wrong with it; empty if nothing is."""
    from cadgen.design.schema import TrainDesign
    from cadgen.errors import DesignError
    from cadgen.jobs.gears.gear_train import NotMadeError, plan_gears

    made = case(seed, number)
    try:
        design = TrainDesign.model_validate({"name": "case", "source": "case.toml", "train": made.keys})
        plan = plan_gears(design, made.order)
    except DesignError as error:
        return "refused", _refusal(made, str(error), isinstance(error, NotMadeError))
    except Exception:
        return "internal fault", traceback.format_exc(limit=3)
    faults = [check.name for check in plan.checks if not check.passed and "report this design" in check.advice]
    if faults:
        return "internal fault", f"checks contradict: {faults}"
    facts = plan.facts()
    pairs = _pairs_of(plan, made.keys)
    wrong = _figures(facts, pairs)
    failing = {name for pair in pairs for name in in_mesh(pair)}
    named = {check.name for check in plan.checks if not check.passed}
    if (named & {"teeth jam", "contact ratio", "root clearance"}) != failing:
        wrong.append(f"fails {sorted(named)}, should fail {sorted(failing)}")
    if made.order == "search":
        best = best_train(made.keys)
        greatest, ranked = facts["return_error_deg"]["greatest"], facts["ranked"][0]["greatest"]
        if best is None:
            wrong.append(f"found {ranked:.6f}° where there is no train")
        elif not isclose(ranked, best[0], rel_tol=1e-9):
            wrong.append(f"ranks {ranked:.6f}° first, the best within the limits has {best[0]:.6f}°")
        elif not isclose(greatest, best[1], rel_tol=1e-9):
            wrong.append(f"makes {greatest:.6f}°, the best that can be made has {best[1]:.6f}°")
        if not plan.passed:
            wrong.append(f"makes a train that fails {sorted(named)}")
    kind = "passed" if plan.passed else "failed a check"
    return kind, "; ".join(wrong)


def _pairs_of(plan, keys: dict) -> tuple[Pair, ...]:
    aim = keys.get("E_sn_um", keys.get("thinning", "middle"))
    return tuple(
        Pair(
            *(
                Wheel(gear.form.teeth, gear.form.normal_module, gear.form.width, keys["grade"], aim)
                for gear in (stage.driver, stage.driven)
            ),
            keys["bearing_span_mm"],
        )
        for stage in plan.play.train.stages
    )


def _figures(facts: dict, pairs: tuple[Pair, ...]) -> list[str]:
    """Figures of the program that differ from those of this file."""
    compared = list(
        zip(
            ("least return error", "greatest return error"),
            (facts["return_error_deg"][which] for which in ("least", "greatest")),
            errors(pairs),
            (1e-9, 1e-9),
            strict=True,
        )
    )
    for number, (stage, pair) in enumerate(zip(facts["stages"], pairs, strict=True), 1):
        undercut = max(stage[role]["undercut_modules"] for role in ("driver", "driven"))
        compared += [
            (f"least play of stage {number}", stage["j_bnmin_um"], pair.least, 1e-6),
            (f"greatest play of stage {number}", stage["j_bnmax_um"], pair.greatest, 1e-6),
            (f"contact ratio of stage {number}", stage["contact_ratio"], pair.contact, 1e-7),
            (f"undercut of stage {number}", undercut, pair.undercut, 2e-3),
        ]
    return [f"{name} {said:.9g}, not {own:.9g}" for name, said, own, bar in compared if abs(said - own) > bar]


def _refusal(made: Case, said: str, ranked: bool) -> str:
    """Empty if a refusal is true."""
    pairs = given_pairs(made.keys)
    if made.order == "as-given":
        if "bearing span" in said and "shorter than the stack" in said:
            return "" if height_of(pairs) > made.keys["bearing_span_mm"] else f"false: {said}"
        return "" if not fits_as_given(pairs, made.keys) else f"false: {said}"
    best = best_train(made.keys)
    if best is None:
        return f"ranks trains where none is within the limits: {said}" if ranked else ""
    if best[1] < 0:
        return ""
    return f"false: the best that can be made has {best[1]:.6f}°: {said}"


def run(seed: int, cases: int, workers: int = 2) -> list[tuple[int, str, str]]:
    """Number, kind and fault of every case."""
    if workers == 1:
        return [(number, *judged(seed, number)) for number in range(cases)]
    with ProcessPoolExecutor(workers) as pool:
        found = pool.map(judged, [seed] * cases, range(cases), chunksize=4)
        return [(number, *outcome) for number, outcome in enumerate(found)]


def page(seed: int, found: list[tuple[int, str, str]]) -> str:
    """The record in Markdown."""
    from cadgen import __version__

    kinds = ("passed", "failed a check", "refused", "internal fault")
    rows = "".join(f"| {kind} | {sum(k == kind for _, k, _ in found)} |\n" for kind in kinds)
    wrong = [f"- case {number} ({kind}): {fault}\n" for number, kind, fault in found if fault]
    return (
        "# Study: trains and searches\n\n"
        "Random trains as given (every fourth case) and searches (`tests/studies/trains.py`), against tolerances,\n"
        "plays, teeth and an enumeration of the study's own (`trains_truth.py`): 1 to 3 stages, modules 0.5 to 1.5,\n"
        "grades 5 to 9, thinning and given thickness, bores from none to 5 mm, limits of the search at random.\n\n"
        f"`python -m tests.studies.trains --cases {len(found)} --seed {seed} --record`, cadgen {__version__}\n\n"
        f"| outcome | cases |\n|---|---|\n{rows}| wrong in any way | {len(wrong)} |\n\n"
        + (
            "".join(wrong)
            if wrong
            else "Every figure agrees, every search made the best train, every refusal is true.\n"
        )
    )


def main() -> None:
    args = options(__doc__, cases=200)
    tell(page(args.seed, run(args.seed, args.cases)), RECORD if args.record else None)


if __name__ == "__main__":
    main()
