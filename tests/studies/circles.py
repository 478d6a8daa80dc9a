"""The whole circle with two kinds of data: `python -m tests.studies.circles --cases 300 --seed 1 --log FILE`.

Every car has one to four declared effects, in two of three a rod that rubs besides, and every second one an undeclared
effect that moves the end of its run by 5 to 30 % of its error, or as much as it can. Every second car has the packaged
cam against play on it, the others the plain one. It is measured by a camera and, in turn, by a dial on the lift, by
encoders on the train or by a measuring machine on the disc; `cadgen calibrate` sees these; a new cam is planned for the
as-built design; and the car runs on it. With `--loops` it is measured again on that cam, and so on. All of the world
is made by `tests.studies.circles_truth`.

Asked: whether the end lies in the range that was said; the share that is gone of the error at the end of the run, and
of that part of it that a cam can take out: all but what the undeclared effect moves it by, if that is still there on
the new cam, and the new disc's form error of 2 um rms; whether a new cam is worse than the old one; whether the outlook
warned of it, or refused a cam that would have halved the error. A run repeats exactly: how the start is set by hand
adds to every run alike, and is left out of the mean of fresh runs.

Every second new disc has the spectrum of the old one's form error, as where one machine cuts both in one way. The
others have one of their own, since clamping, cutter, blank and often the shop are others. None has the very form error
of the old disc.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from typing import Any

import numpy as np

from cadgen.inference.measurement.record import Record
from tests.inference.measurement.synthetic import TURN
from tests.inference.measurement.synthetic import Car as Bed
from tests.studies.circles_truth import CELLS, UNDECLARED, Car, World, declared, drawn_form, drawn_shop

LATER = ("broken edges", "camera scale", "wobble")  # of those that no one declared, the ones that came last
SECONDS = ("lift", "transmission", "profile")
WARNED = 0.01  # a chance to be worse that the first line shows
WORSE = 5.0  # mm by which a new cam may end farther off than the old one
_FILES = 10**6  # cars whose files have hashes of their own in each loop
NEAR = 15.0  # mm from the planned end: as near as a car can be set


@dataclass(frozen=True)
class Outcome:
    """A car, what was said of it, and where it ends: distances from the planned end of the run, mm.

    Attributes:
        stays: by how much the undeclared effect, if it is there on the new cam too, and the form error of the new disc
            move the end.
        least, most: range in which the end on the new cam was said to lie with a chance of 90 %.
        worse: chance that the new cam is worse, as said.
        no_cam: why none could be planned.
        friction: between rod and disc.
        against_play: whether the cam that it had was the one against play.
        same_shop: whether the new disc's form error has the spectrum of the old one's.
        later: ends after the second and each further loop; an end repeats where no new cam was cut.
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
    least: float = 0.0
    most: float = 0.0
    friction: float = 0.0
    against_play: bool = False
    same_shop: bool = False
    later: tuple[float, ...] = ()

    @property
    def cut(self) -> bool:
        """Whether a new cam was cut."""
        return not self.refused and not self.no_cam

    @property
    def gone(self) -> float:
        """Share of the whole error that is gone; none where the cam was refused."""
        return 0.0 if self.refused else 1 - self.after / self.before

    @property
    def out(self) -> float:
        """Share that is gone of what a cam can take out; none where the cam was refused."""
        return 0.0 if self.refused else (self.before - self.after) / (self.before - self.stays)

    @property
    def within(self) -> bool:
        """Whether the car ends in the range that was said."""
        return self.least <= self.after <= self.most


@cache
def _ground() -> Any:
    """The paper's car as built by the numeric rooms."""
    from tests.conftest import build

    return build("carbon_free_car")


@cache
def _bed(against_play: bool) -> Bed:
    """Disc on which cars run: the plain one, or the packaged one against play."""
    if not against_play:
        return Bed(_ground())
    from cadgen.design.load import load_design
    from cadgen.jobs.cam.steering_cam import plan_cam

    return _bed_of(plan_cam(load_design(), "optimized"))


def _bed_of(cam: Any) -> Bed:
    """Disc of a planned cam."""
    outline = cam.on_shaft.outline(0.03)
    disc = SimpleNamespace(outline=lambda step: outline)
    return Bed(SimpleNamespace(actual=SimpleNamespace(curve=disc), follower=_ground().follower))


def _end(world: World, car: Car, stop: float) -> complex:
    at, path = stop / TURN * CELLS, world.path(car)
    return complex(np.interp(at, np.arange(CELLS + 1), path.real), np.interp(at, np.arange(CELLS + 1), path.imag))


@dataclass(frozen=True)
class Drawn:
    """A car of the study: without and with its undeclared effect, and on the new cam; `stays` as of `Outcome`.

    Attributes:
        shop: spectrum that the next discs' form errors have, shape (1800,), mm^2; None if each has its own.
    """

    world: World
    car: Car
    on_new: Car
    second: str
    undeclared: str
    against_play: bool
    before: float
    stays: complex
    shop: np.ndarray | None = None


def draw(seed: int, number: int, *, smooth: bool = False, against_play: bool | None = None) -> Drawn:
    """A car by its number; a smooth one has neither friction nor, if it is left open, a cam against play."""
    rng, other = np.random.default_rng([seed, number]), np.random.default_rng([seed, number, 2])
    built = _ground()
    second = SECONDS[number % 3]
    bare = replace(Car(), **declared(rng, 1 + number // 3 % 4, second))
    drawn_on = other.random() < 1 / 2 and not smooth
    against_play = drawn_on if against_play is None else against_play
    if other.random() < 2 / 3 and not smooth:
        bare = replace(bare, friction=other.uniform(0.05, 0.30))
    form, shop = drawn_shop(rng)
    same_shop = other.random() < 1 / 2
    world, stop = World(built, _bed(against_play), form), built.lift.blend_start
    goal = complex(*built.track.position(built.track.length * stop / TURN))
    plain = _end(world, bare, stop)
    car, name, stays = bare, "", 0j
    if (number // 3 + number // 12) % 2:
        known = UNDECLARED if not smooth else {n: u for n, u in UNDECLARED.items() if n not in LATER}
        name = str(rng.choice(sorted(n for n, u in known.items() if second in u.seconds)))
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
    before = abs(_end(world, car, stop) - goal)
    return Drawn(world, car, on_new, second, name, against_play, before, stays, shop if same_shop else None)


def _added(car: Car, change: dict[str, Any]) -> dict[str, Any]:
    """A change, with the play that a car has already."""
    return {k: v + car.play if k == "play" else v for k, v in change.items()}


@dataclass(frozen=True)
class Loop:
    """A car measured once and its new cam.

    Attributes:
        told: calibration.
        text: as-built design; that before where none was written.
        cam: new cam; None where none was planned.
        no_cam: why.
    """

    told: Any
    text: str
    cam: Any
    no_cam: str = ""


@cache
def _nominals() -> dict[str, Any]:
    """The packaged car with each cam that may be on it, made once: records of every first loop are held against it."""
    from cadgen.design.load import load_design
    from cadgen.jobs.calibration.cam_on_car import nominal_of

    return {profile: nominal_of(load_design(), profile) for profile in ("actual", "optimized")}


def go_loop(text: str, profile: str, records: Sequence[Any], number: int, *, first: bool = False) -> Loop:
    """Calibrate a car by its records, and plan its cam.

    Args:
        text: design file of the cam that is on the car.
        profile: its profile.
        records: measured data.
        number: of the car, for the hashes of its files.
        first: whether the design is the packaged one.
    """
    from cadgen.design.load import load_design
    from cadgen.errors import CadgenError
    from cadgen.jobs.calibration.as_built_file import as_built_text
    from cadgen.jobs.calibration.calibration import calibrate
    from cadgen.jobs.calibration.sources import Source
    from cadgen.jobs.cam.steering_cam import plan_cam

    sources = [Source(Path(f"{r.kind.code}.csv"), r, f"{number:064x}") for r in records]
    with TemporaryDirectory() as folder:
        file = Path(folder) / "carbon_free_car.toml"
        file.write_text(text)
        cams = _nominals() if first else {}
        # The other cam of a packaged car is the only one of its number.
        made = {(code, 0): other for code in cams for name, other in cams.items() if name != code}
        told = calibrate(load_design(file), profile, sources, nominal=cams.get(profile), made=made)
        if told.outlook is None:
            return Loop(told, text, None, told.no_cam or "nothing to change")
        after = as_built_text(told, text)
        file.write_text(after)
        try:
            return Loop(told, after, plan_cam(load_design(file), "optimized"))
        except CadgenError as error:
            return Loop(told, text, None, str(error))


def records_of(drawn: Drawn, rng: np.random.Generator) -> list[Any]:
    """Records of a car on the cam that it has: its track, and the second kind."""
    world = drawn.world
    second = {"lift": world.dial, "transmission": world.train, "profile": world.profile}[drawn.second]
    return [world.track(drawn.car, rng), second(drawn.car, rng)]


def go_round(
    seed: int,
    number: int,
    *,
    loops: int = 1,
    smooth: bool = False,
    drawn: Drawn | None = None,
    profile: str | None = None,
    spoil: Callable[[Record], Record] = lambda record: record,
    noise: float = 1.0,
    look: Callable[[Any], None] = lambda told: None,
) -> Outcome:
    """Measure a car, calibrate it, plan its cam, and run it again; in each further loop once more, on the new cam.

    Args:
        seed, number: of the car.
        loops: how often it is measured.
        smooth: as of `draw`.
        drawn: the car, if that is at hand already.
        profile: that is stated; the one on the car if left out.
        spoil: what is done to each record before it is calibrated.
        noise: of the camera, as a factor of the usual.
        look: is shown each calibration.
    """
    from cadgen.design.load import packaged_designs

    drawn = draw(seed, number, smooth=smooth) if drawn is None else drawn
    rng = np.random.default_rng([seed, number, 1])
    world, car, built = drawn.world, drawn.car, _ground()
    text = packaged_designs()["carbon_free_car"].read_text()
    profile = profile or ("optimized" if drawn.against_play else "actual")
    goal = complex(*built.track.position(built.track.length * built.lift.blend_start / TURN))
    stands, rounds, later = drawn.before, [], []
    for turn in range(loops):
        more = {"lift": world.dial, "transmission": world.train, "profile": world.profile}[drawn.second](car, rng)
        records = [spoil(world.track(car, rng, noise_mm=3.0 * noise)), spoil(more)]
        loop = go_loop(text, profile, records, number + _FILES * turn, first=not turn)
        look(loop.told)
        form = drawn_form(rng, drawn.shop)
        after = stands
        if loop.cam is not None:
            on_new = World(built, _bed_of(loop.cam), form)
            after = abs(_end(on_new, drawn.on_new, loop.cam.application.wanted.blend_start) - goal)
            if loop.told.outlook.sound and not loop.told.cam_unknown:
                stands, world, car, text, profile = after, on_new, drawn.on_new, loop.text, "optimized"
        rounds.append((loop, form, after))
        later.append(stands)
    first, form, after = rounds[0]
    stop, told, outlook = built.lift.blend_start, first.told, first.told.outlook
    rough = _end(World(built, _bed(False), form), Car(), stop) - _end(World(built, _bed(False), 0 * form), Car(), stop)
    return Outcome(
        number=number,
        second=drawn.second,
        effects=", ".join(k for k, v in vars(drawn.car).items() if v != getattr(Car(), k)),
        undeclared=drawn.undeclared,
        verdict=told.diagnoses[0].verdict,
        claimed=", ".join(
            sorted(b.claim.finding.effect for b in told.built if b.place != "noted" and not b.claim.absent)
        ),
        before=drawn.before,
        after=after,
        stays=abs(drawn.stays + rough),
        expected=outlook.new if outlook else drawn.before,
        worse=outlook.worse if outlook else 0.0,
        refused=outlook is not None and (told.cam_unknown or not outlook.sound),
        no_cam=first.no_cam,
        least=outlook.least if outlook else 0.0,
        most=outlook.most if outlook else 0.0,
        friction=drawn.car.friction,
        against_play=drawn.against_play,
        same_shop=drawn.shop is not None,
        later=tuple(later[1:]),
    )


def kept(seed: int, number: int, loops: int = 1) -> dict[str, Any]:
    """Outcome as a journal holds it."""
    return asdict(go_round(seed, number, loops=loops))


def page(outcomes: Sequence[Outcome], command: str) -> str:
    """The study as a page."""
    from tests.studies.journal import share, stamp

    gone, out = np.array([o.gone for o in outcomes]), np.array([o.out for o in outcomes])
    made = [o for o in outcomes if o.cut]
    worse = [o for o in outcomes if o.after > o.before + WORSE]
    silly = [o for o in outcomes if o.refused and o.after < o.before / 2]
    warned = [o for o in worse if o.refused or o.worse > WARNED]
    # A car within 15 mm is where hands put it: no cam can help it.
    helped = [o for o in outcomes if o.before - o.stays > NEAR]
    count = len(outcomes)

    def part(some: Sequence[Outcome]) -> str:
        ranges = [o.within for o in some if o.cut]
        gone = f"{np.median([o.out for o in some]):.2%}, {sum(o.out >= 0.95 for o in some)} of {len(some)}"
        return f"{gone} | {sum(ranges)} of {len(ranges)}"

    def near(some: Sequence[Outcome]) -> int:
        return sum(o.out >= 0.95 or o.after <= NEAR for o in some)

    rows = [
        "# Study: the whole circle with two kinds of data",
        "",
        "Cars with one to four declared effects, in two of three a rod that rubs, every second with an undeclared",
        "effect that moves the end by 5 to 30 %, every second with the cam against play on it. Each is measured by a",
        "camera and a dial, encoders or a measuring machine, calibrated, and run on the cam that is planned for the",
        "result. *Of what a cam can take out*: of the error less what stays, which is the move of the end by the",
        "undeclared effect, where it is there on the new cam too, and by the form error of the new disc.",
        "Every second new disc has the spectrum of the old one's form error, as of one machine; the others their own.",
        "A refusal counts as 0 %; in brackets what a share may be, 95 %.",
        "",
        f"`{command}`, {stamp()}",
        "",
        "| | | asked |",
        "|---|---|---|",
        f"| cars | {count} | 1200 |",
        f"| end in the stated 90 % range, of cams cut | {share(sum(o.within for o in made), len(made))} | 87-93 % |",
        f"| below it; to the median that was said; to its upper end; above it | {_placed(made)} | 5; 45; 45; 5 % |",
        f"| gone of what a cam can take out, median | {np.median(out):.2%} | 99 % |",
        f"| 95 % of that gone, or the end within {NEAR:g} mm | {share(near(outcomes), count)} | 90 % |",
        f"| gone of the whole error, median | {np.median(gone):.2%} | |",
        f"| worse than before by more than {WORSE:g} mm, not refused | {sum(o.cut for o in worse)} | 0 |",
        f"| cars that a cam can help, and that get one | {share(sum(o.cut for o in helped), len(helped))} | 95 % |",
        f"| refused | {sum(o.refused for o in outcomes)} | |",
        f"| refused though the new cam would have halved the error | {share(len(silly), count)} | 5 % |",
        f"| worse with `--force`; of them refused or warned of | {len(worse)}; {len(warned)} | all |",
        f"| no cam could be planned | {sum(bool(o.no_cam) for o in outcomes)} | |",
        *_loops([o for o in outcomes if o.later]),
        "",
        "| cars | gone of what a cam can take out, median; 95 % of it | in the range |",
        "|---|---|---|",
        f"| without an undeclared effect | {part([o for o in outcomes if not o.undeclared] or outcomes)} |",
        *(
            f"| {name} | {part(some)} |"
            for name, some in (
                ("without friction", [o for o in outcomes if not o.friction]),
                ("with friction", [o for o in outcomes if o.friction]),
                ("with the plain cam on them", [o for o in outcomes if not o.against_play]),
                ("with the cam against play on them", [o for o in outcomes if o.against_play]),
                ("with a new disc of the old one's spectrum", [o for o in outcomes if o.same_shop]),
                ("with a new disc of another spectrum", [o for o in outcomes if not o.same_shop]),
            )
            if some
        ),
        *(
            f"| {name} | {part(some)} |"
            for name in (*SECONDS, *UNDECLARED)
            if (some := [o for o in outcomes if name in (o.second, o.undeclared)])
        ),
        "",
        "| car | with | effects | undeclared | verdict | taken out | before | stays | after | expected | later | |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for o in outcomes:
        refused = "refused" if o.refused else "no cam" if o.no_cam else ""
        effects = o.effects.replace("friction", f"friction {o.friction:.2f}") + ("; cam against play" * o.against_play)
        rows.append(
            f"| {o.number} | {o.second} | {effects} | {o.undeclared or '-'} | {o.verdict} | {o.claimed or '-'} | "
            f"{o.before:.0f} mm | {o.stays:.0f} mm | {o.after:.0f} mm | "
            f"{o.expected:.0f} ({o.least:.0f}-{o.most:.0f}) mm | "
            f"{', '.join(f'{end:.0f}' for end in o.later) or '-'} | {refused} |"
        )
    return "\n".join(rows) + "\n"


def _placed(made: Sequence[Outcome]) -> str:
    """How many cars end below their range, in its lower and its upper half by chance, and above it."""
    places = [sum(o.after > bound for bound in (np.nextafter(o.least, 0.0), o.expected, o.most)) for o in made]
    return "; ".join(str(places.count(place)) for place in range(4))


def _loops(outcomes: Sequence[Outcome]) -> list[str]:
    """Rows on cars that went round more than once: each end against the one before."""
    if not outcomes:
        return []
    turns = [
        (a, b) for o in outcomes for ends in [(o.after if o.cut else o.before, *o.later)] for a, b in pairwise(ends)
    ]
    worse = sum(b > a + WORSE and b > NEAR for a, b in turns)
    what = f"further loops: ends farther off by more than {WORSE:g} mm, and beyond {NEAR:g} mm"
    return [f"| {what} | {worse} of {len(turns)} | 0 |"]


def main() -> None:
    """Run the study."""
    from tests.studies.command import PAGES, options, tell
    from tests.studies.journal import outcomes

    chosen = options(__doc__, cases=40, more={"--loops": 1})
    keys = [(chosen.seed, number, chosen.loops) for number in range(chosen.cases)]
    found = [Outcome(**one) for one in outcomes(kept, keys, chosen.log, chosen.processes)]
    loops = f" --loops {chosen.loops}" if chosen.loops > 1 else ""
    command = f"python -m tests.studies.circles --cases {chosen.cases} --seed {chosen.seed}{loops} --record"
    tell(page(found, command), PAGES / "circles.md" if chosen.record else None)


if __name__ == "__main__":
    main()
