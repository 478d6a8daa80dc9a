"""Random cars with a train of 20 to 80 turns: whether a layout is found, or a limit is proved.

Wheelbase, wheels, base radius, faces and teeth of two or three stages are random. A layout that is found is set up of
meshes by the sizes of the car alone, and its least gap is measured at 25 places of the fork. Where none is found, the
distances cannot reach the axle, or the nearest layout names the parts that lack room. Of cars of two stages an
exhaustive search over heights and both bends finds none either.

    python -m tests.studies.car_layouts [--cases 100] [--seed 1] [--record]
"""

from collections import Counter

import numpy as np

from cadgen import __version__
from tests.car.assembly.test_arrangement import judged, random_car
from tests.studies.command import PAGES, options, tell

REPORT = PAGES / "car_layouts.md"
RATIOS = (20.0, 80.0)


def turns(shafts: list[list[object]]) -> float:
    """Turns of the drive for one of the cam: the product of the ratios of its teeth of module 0.5."""
    by_stage: dict[int, list[float]] = {}
    for gears in shafts:
        for gear in gears:
            by_stage.setdefault(gear.stage, []).append(4 * (gear.radius - 0.5))
    return float(np.prod([driven / driver for driver, driven in by_stage.values()]))


def main() -> int:
    """Judge random cars, and tell how many are laid out."""
    given = options(__doc__, cases=100)
    rng, count, worst, searched = np.random.default_rng(given.seed), Counter[str](), 0.0, 0
    while count.total() < given.cases:
        car = random_car(rng)
        if RATIOS[0] <= turns(car[1]) <= RATIOS[1]:
            state, error = judged(*car)
            count[state] += 1
            searched += state == "without room" and len(car[2]) == 2
            worst = max(worst, error)
            print(count.total(), state, flush=True)
    title, text, *_ = (__doc__ or "").strip().split("\n\n")
    told = ", ".join(f"{number} {state}" for state, number in sorted(count.items()))
    tell(
        f"# Layouts of random cars\n\n`python -m tests.studies.car_layouts --cases {given.cases} --seed {given.seed} "
        f"--record`, cadgen {__version__}.\n\n{title}\n\n{text}\n\nOf {given.cases} cars: {told}. Least gaps differ "
        f"from those of the meshes by {worst:.4f} mm at most. {searched} of those without room have two stages, and "
        "the exhaustive search found a layout for none of them.",
        REPORT if given.record else None,
    )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
