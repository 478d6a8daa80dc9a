"""The whole circle with two kinds of data: `python -m tests.studies.circles --cases 300 --seed 1 --log FILE`.

Every car has one to four declared effects, and every second one an undeclared one that moves the end of its run by 5 to
30 % of its error, or as much as it can. It is measured by a camera and, in turn, by a dial on the lift, by encoders on
the train or by a measuring machine on the disc; `cadgen calibrate` sees these; a new cam is planned for the as-built
design; and the car runs on it. All of the world is made by `tests.studies.circles_truth`.

Asked: the share that is gone of the error at the end of the run, and of that part of it that a cam can take out: all
but what the undeclared effect moves it by, if that is still there on the new cam, and the new disc's form error of 2 um
rms; whether a new cam is worse than the
old one; whether the outlook warned of it, or refused a cam that would have halved the error. A run repeats exactly:
how the start is set by hand adds to every run alike, and is left out of the mean of fresh runs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from typing import Any

import numpy as np

from tests.inference.measurement.synthetic import TURN
from tests.studies.circles_truth import CELLS, UNDECLARED, Car, World, declared, drawn_form

SECONDS = ("lift", "transmission", "profile")
WARNED = 0.01  # a chance to be worse that the first line shows


@dataclass(frozen=True)
class Outcome:
    """A car, what was said of it, and where it ends: distances from the planned end of the run, mm.

    Attributes:
        stays: by how much the undeclared effect, if it is there on the new cam too, and the form error of the new disc
            move the end.
        worse: chance that the new cam is worse, as said.
        no_cam: why none could be planned.
    """

    number: int
    second: str
    effects: str
    undeclared: str
    verdict: str
    claimed: str
    before: float
    after: float
    stays: float
    expected: float
    worse: float
    refused: bool
    no_cam: str = ""

    @property
    def gone(self) -> float:
        """Share of the whole error that is gone; none where the cam was refused."""
        return 0.0 if self.refused else 1 - self.after / self.before

    @property
    def out(self) -> float:
        """Share that is gone of what a cam can take out; none where the cam was refused."""
        return 0.0 if self.refused else (self.before - self.after) / (self.before - self.stays)


@cache
def _ground():
    from tests.conftest import build
    from tests.inference.measurement import synthetic as syn

    built = build("carbon_free_car")
    return built, syn.Car(built)


def _end(world: World, car: Car, stop: float) -> complex:
    at, path = stop / TURN * CELLS, world.path(car)
    return complex(np.interp(at, np.arange(CELLS + 1), path.real), np.interp(at, np.arange(CELLS + 1), path.imag))


@dataclass(frozen=True)
class Drawn:
    """A car of the study: without and with its undeclared effect, and on the new cam; `stays` as of `Outcome`."""

    world: World
    car: Car
    on_new: Car
    second: str
    undeclared: str
    before: float
    stays: complex


def draw(seed: int, number: int) -> Drawn:
    """A car by its number."""
    rng = np.random.default_rng([seed, number])
    built, bed = _ground()
    second = SECONDS[number % 3]
    bare = replace(Car(), **declared(rng, 1 + number // 3 % 4, second))
    world, stop = World(built, bed, drawn_form(rng)), built.lift.blend_start
    goal = complex(*built.track.position(built.track.length * stop / TURN))
    plain = _end(world, bare, stop)
    car, name, stays = bare, "", 0j
    if (number // 3 + number // 12) % 2:
        name = str(rng.choice(sorted(n for n, u in UNDECLARED.items() if second in u.seconds)))
        effect, sign = UNDECLARED[name], float(rng.choice([-1, 1]))
        shows = effect.feigns or effect.put
        wanted = rng.uniform(0.05, 0.30) * abs(plain - goal)

        def moved(size: float) -> complex:
            return _end(world, replace(bare, **_added(bare, shows(sign * size))), stop) - plain

        low, high = 0.0, effect.most
        for _ in range(14 if abs(moved(high)) > wanted else 0):
            middle = (low + high) / 2
            low, high = (low, middle) if abs(moved(middle)) > wanted else (middle, high)
        car = replace(bare, **_added(bare, effect.put(sign * high)))
        stays = moved(high) if effect.stays else 0j
    # What is of the part goes with the old disc: a dent, and a bore that a measuring machine saw in the disc.
    on_new = replace(car, dent=(0.0, 0.0), bore=(0.0, 0.0) if second == "profile" else car.bore)
    return Drawn(world, car, on_new, second, name, abs(_end(world, car, stop) - goal), stays)


def _added(car: Car, change: dict[str, Any]) -> dict[str, Any]:
    """A change, with the play that a car has already."""
    return {k: v + car.play if k == "play" else v for k, v in change.items()}


def go_round(seed: int, number: int) -> Outcome:
    """Measure a car, calibrate it, plan its cam, and run it again."""
    from cadgen.design.load import load_design, packaged_designs
    from cadgen.errors import CadgenError
    from cadgen.jobs.calibration.as_built_file import as_built_text
    from cadgen.jobs.calibration.calibration import calibrate
    from cadgen.jobs.calibration.sources import Source
    from cadgen.jobs.cam.steering_cam import plan_cam
    from tests.inference.measurement.synthetic import Car as Bed

    drawn, rng = draw(seed, number), np.random.default_rng([seed, number, 1])
    world, car, built = drawn.world, drawn.car, drawn.world.built
    more = {"lift": world.dial, "transmission": world.train, "profile": world.profile}[drawn.second](car, rng)
    records = [world.track(car, rng), more]
    sources = [Source(Path(f"{r.kind.code}.csv"), r, f"{number:064x}") for r in records]
    told = calibrate(load_design(), "actual", sources)
    claimed = ", ".join(sorted(b.claim.finding.effect for b in told.built if b.place != "noted" and not b.claim.absent))
    outlook, after, no_cam = told.outlook, drawn.before, ""
    form, stop = drawn_form(rng), built.lift.blend_start
    rough = _end(World(built, world.bed, form), Car(), stop) - _end(World(built, world.bed, 0 * form), Car(), stop)
    if outlook is not None:
        with TemporaryDirectory() as folder:
            file = Path(folder) / "as_built.toml"
            file.write_text(as_built_text(told, packaged_designs()["carbon_free_car"].read_text()))
            design = load_design(file)
        try:
            cam = plan_cam(design, "optimized")
        except CadgenError as error:
            no_cam = str(error)
        else:
            outline = cam.on_shaft.outline(0.03)
            disc = SimpleNamespace(outline=lambda step: outline)
            bed = Bed(SimpleNamespace(actual=SimpleNamespace(curve=disc), follower=built.follower))
            goal = complex(*built.track.position(built.track.length * stop / TURN))
            stop = cam.application.wanted.blend_start
            after = abs(_end(World(built, bed, form), drawn.on_new, stop) - goal)
    return Outcome(
        number=number,
        second=drawn.second,
        effects=", ".join(k for k, v in vars(car).items() if v != getattr(Car(), k)),
        undeclared=drawn.undeclared,
        verdict=told.diagnoses[0].verdict,
        claimed=claimed,
        before=drawn.before,
        after=after,
        stays=abs(drawn.stays + rough),
        expected=outlook.new if outlook else drawn.before,
        worse=outlook.worse if outlook else 0.0,
        refused=outlook is not None and not outlook.sound,
        no_cam=no_cam,
    )


def kept(seed: int, number: int) -> dict[str, Any]:
    """The same as what a journal holds."""
    return asdict(go_round(seed, number))


def page(outcomes: Sequence[Outcome], command: str) -> str:
    """The study as a page."""
    from tests.studies.journal import share, stamp

    gone, out = np.array([o.gone for o in outcomes]), np.array([o.out for o in outcomes])
    worse = [o for o in outcomes if o.after > o.before]
    silly = [o for o in outcomes if o.refused and o.after < o.before / 2]
    warned = [o for o in worse if o.refused or o.worse > WARNED]
    count = len(outcomes)

    def part(some: Sequence[Outcome]) -> str:
        return f"{np.median([o.out for o in some]):.2%}, {sum(o.out >= 0.95 for o in some)} of {len(some)}"

    rows = [
        "# Study: the whole circle with two kinds of data",
        "",
        "Cars with one to four declared effects, every second with an undeclared one that moves the end by 5 to 30 %,",
        "measured by a camera and a dial, encoders or a measuring machine, calibrated, and run on the cam that is",
        "planned for the result. *Of what a cam can take out*: of the error less what stays, which is the move of the",
        "end by the undeclared effect, where it is there on the new cam too, and by the form error of the new disc.",
        "A refusal counts as 0 %; in brackets what a share may be, 95 %.",
        "",
        f"`{command}`, {stamp()}",
        "",
        "| | | asked |",
        "|---|---|---|",
        f"| cars | {count} | 300 |",
        f"| gone of what a cam can take out, median | {np.median(out):.2%} | 99 % |",
        f"| cars of which 95 % of that is gone | {share(int(np.sum(out >= 0.95)), count)} | 90 % |",
        f"| gone of the whole error, median | {np.median(gone):.2%} | |",
        f"| cars of which 95 % of that is gone | {share(int(np.sum(gone >= 0.95)), count)} | |",
        f"| worse than before, not refused | {sum(not o.refused for o in worse)} | 0 |",
        f"| refused | {sum(o.refused for o in outcomes)} | |",
        f"| refused though the new cam would have halved the error | {share(len(silly), count)} | 5 % |",
        f"| worse with `--force`; of them refused or warned of | {len(worse)}; {len(warned)} | all |",
        f"| no cam could be planned | {sum(bool(o.no_cam) for o in outcomes)} | |",
        "",
        "| cars | gone of what a cam can take out, median; 95 % of it |",
        "|---|---|",
        f"| without an undeclared effect | {part([o for o in outcomes if not o.undeclared] or outcomes)} |",
        *(
            f"| {name} | {part(some)} |"
            for name in (*SECONDS, *UNDECLARED)
            if (some := [o for o in outcomes if name in (o.second, o.undeclared)])
        ),
        "",
        "| car | with | effects | undeclared | verdict | taken out | before | stays | after | expected | |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for o in outcomes:
        refused = "refused" if o.refused else "no cam" if o.no_cam else ""
        rows.append(
            f"| {o.number} | {o.second} | {o.effects} | {o.undeclared or '-'} | {o.verdict} | {o.claimed or '-'} | "
            f"{o.before:.0f} mm | {o.stays:.0f} mm | {o.after:.0f} mm | {o.expected:.0f} mm | {refused} |"
        )
    return "\n".join(rows) + "\n"


def main() -> None:
    """Run the study."""
    from tests.studies.command import PAGES, options, tell
    from tests.studies.journal import outcomes

    chosen = options(__doc__, cases=40)
    keys = [(chosen.seed, number) for number in range(chosen.cases)]
    found = [Outcome(**one) for one in outcomes(kept, keys, chosen.log, chosen.processes)]
    command = f"python -m tests.studies.circles --cases {chosen.cases} --seed {chosen.seed} --record"
    tell(page(found, command), PAGES / "circles.md" if chosen.record else None)


if __name__ == "__main__":
    main()
