"""Adjustment by trial runs: cars that explain them, the best settings by hand, and what to expect then."""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from math import ceil, degrees, radians, sqrt
from pathlib import Path

import numpy as np

from cadgen.arrays import Array
from cadgen.car.running.drive import STEPS, start_pose
from cadgen.car.running.friction import USUAL
from cadgen.car.running.mechanics import Mechanics
from cadgen.design import cam_model
from cadgen.design.schema import Design
from cadgen.deviations.deviation import (
    BASE_RADIUS,
    CAM_PHASE,
    EACH_RUN,
    RETURN_ERROR,
    SETTINGS,
    SIDE_SLIP,
    SLIDING_FRICTION,
    STEERING_ZERO,
    VARIED,
    ByHand,
    Deviation,
)
from cadgen.figures import Facts
from cadgen.inference.adjustment import (
    CarPrior,
    Forecast,
    Posterior,
    RunScatter,
    Settings,
    Trial,
    TrialNoise,
    best_settings,
    explain,
    forecast,
)
from cadgen.inference.measurement.record import understood_of
from cadgen.inference.monte_carlo.cars import Cars
from cadgen.inference.records.columns import AS_NAMED, Reading
from cadgen.inference.records.load import read_trials, settings_line, trials_of
from cadgen.jobs.cam.cam_plan import CamPlan
from cadgen.jobs.cam.steering_cam import CarUse, comparison_of, plan_cam
from cadgen.jobs.nominal_car import cars_of
from cadgen.messages import Message
from cadgen.output.files.publisher import Artifact, Written, publish, text_file
from cadgen.progress import Progress, silent
from cadgen.version import __version__

WIDER = 2.0  # cars may be off by so many times their tolerances
PLAYS, FRICTION_STEP = 7, 0.03  # of the grid on which cars are looked for
FINE, COARSE = 24, 150  # steps of the run from station to station, for points and for errors
CARS = 128  # that stand for all that explain the trial runs
SEED = 1
_GRID = 1200  # cam angles of a turn: the end of the run errs by less than 0.1 mm
MOST_RESIDUAL = 1.6  # root mean square in standard deviations of a point, beyond which a run is not explained
WORTH = 60.0  # mm at the end that settings are to leave at most, if the design has no gates
# No car is better known than so, whatever its tolerances say: mm and rad.
_LEAST: dict[Deviation, float] = {BASE_RADIUS: 0.01, STEERING_ZERO: radians(0.05), CAM_PHASE: radians(0.1)}


class Point(Enum):
    """A point of the car whose places are measured."""

    DRIVE_WHEEL = "drive-wheel"
    FORK = "fork"
    IDLE_WHEEL = "idle-wheel"
    PATH = "path"


@dataclass(frozen=True, kw_only=True)
class Wanted:
    """How trial runs were measured, and what may be set.

    Attributes:
        point: point of the car that was measured.
        settings: parts of the car that a hand may set, keys of `SETTINGS` of the catalogue.
        noise: standard deviation of a measured coordinate, mm.
        division: division of the micrometer head, mm.
    """

    point: Point = Point.DRIVE_WHEEL
    settings: tuple[ByHand, ...] = (ByHand.HEAD, ByHand.START)
    noise: float = 10.0
    division: float = 0.01


@dataclass(frozen=True, kw_only=True)
class AdjustmentPlan:
    """Settings by hand after trial runs.

    Attributes:
        plan: plan of the cam on the car.
        described: facts on design, drive wheel and profile.
        stem: name of the files.
        wanted: how the runs were measured, and what may be set.
        trials: in the order of driving.
        posterior: cars that explain them.
        settings: for the next run, as changes of the design, mm and rad.
        designed: errors to expect as the car is designed.
        before: position errors to expect with the settings of the last trial run, mm.
        after: position errors to expect with the new settings, mm.
        allowed: position error at the end that the next run may have, mm: half the narrowest gate, or 60 without gates.
        steady: position errors to expect with the new settings and no side slip, mm; None if none is reckoned with.
        scatter: how far runs with the settings of the last end apart; None for fewer than three.
        understood: sentences on files that are not as those of trial runs.
    """

    plan: CamPlan
    described: Facts
    stem: str
    wanted: Wanted
    trials: tuple[Trial, ...]
    posterior: Posterior
    settings: Settings
    designed: Forecast
    before: Forecast
    after: Forecast
    allowed: float
    steady: Forecast | None = None
    scatter: RunScatter | None = None
    understood: tuple[Message, ...] = ()

    @property
    def explained(self) -> bool:
        """Whether cars within twice the tolerances explain the trial runs; if not, set nothing by this."""
        return self.posterior.residual <= MOST_RESIDUAL

    @property
    def worse(self) -> float:
        """Chance that the next run ends further off than one with the settings of the last, 0 to 1."""
        return float(np.mean(self.after.end > self.before.end))

    @property
    def divisions(self) -> int:
        """Divisions by which the head is turned from where it stood; positive makes the base radius larger."""
        return round((self.settings.head - self.trials[-1].settings.head) / self.wanted.division)

    @property
    def sentences(self) -> tuple[Message, ...]:
        """Result in words, the most important first."""
        said = []
        if not self.explained:
            said.append(
                Message(
                    "not explained: the points lie {residual:.1f} times their noise off the track of every car within "
                    "{wider:g} times the tolerances, so set nothing by this yet: look for a wrong unit, point or "
                    "start, or for what no tolerance holds; measure lift or transmission and run cadgen calibrate",
                    residual=self.posterior.residual,
                    wider=WIDER,
                )
            )
        said.append(
            Message(
                "end of the run: {before} with the settings of the last trial run, {after} with the new ones; chance "
                "to end further off than before {worse:.0f} %",
                before=_range(self.before),
                after=_range(self.after),
                worse=100 * self.worse,
            )
        )
        if self.steady is not None:
            said.append(
                Message("without the side slip that comes anew in every run: {steady}", steady=_range(self.steady))
            )
        if self.scatter is not None:
            said.append(
                Message(
                    "{count} runs with the same settings scatter by {end:.0f} mm at the end, which no trim and no cam "
                    "takes out; a side slip alone that does it: --set tolerances.side_slip_deg={slip:.2g}",
                    count=self.scatter.count,
                    end=self.scatter.end,
                    slip=degrees(self.scatter.side_slip),
                )
            )
        if self.after.end_quantile(0.95) > self.allowed:
            said.append(
                Message(
                    "a new cam is worth it: more than one run in twenty ends beyond the {allowed:g} mm allowed, "
                    "whatever is set; measure the car and run cadgen calibrate",
                    allowed=self.allowed,
                )
            )
        elif self.after.way.mean() > self.allowed:
            said.append(
                Message(
                    "on its way the car is up to {way:.0f} mm off, more than the {allowed:g} mm allowed: where that "
                    "matters a new cam is worth it; measure the car and run cadgen calibrate",
                    way=self.after.way.mean(),
                    allowed=self.allowed,
                )
            )
        return tuple(said)

    @property
    def steps(self) -> tuple[Message, ...]:
        """Settings for the next run, a sentence for each that may be changed."""
        last, new, steps = self.trials[-1].settings, self.settings, []
        if ByHand.HEAD in self.wanted.settings and self.divisions:
            steps.append(
                Message(
                    "micrometer head: base radius {way} by {count} × {division:g} µm (in all {all:+.0f} µm)",
                    way=Message("larger") if self.divisions > 0 else Message("smaller"),
                    count=abs(self.divisions),
                    division=self.wanted.division * 1e3,
                    all=new.head * 1e3,
                )
            )
        elif ByHand.HEAD in self.wanted.settings:
            steps.append(Message("micrometer head: leave it (in all {all:+.0f} µm)", all=new.head * 1e3))
        if ByHand.KEY in self.wanted.settings:
            way = _turn(new.key - last.key, "ahead", "back")
            steps.append(Message("cam on its shaft: {way} (in all {all:+.2f}°)", way=way, all=degrees(new.key)))
        if ByHand.START in self.wanted.settings:
            steps.append(
                Message(
                    "start, from where it is planned: {along}, {across}, heading {heading}",
                    along=_shift(new.start_x, "ahead", "back"),
                    across=_shift(new.start_y, "to the left", "to the right"),
                    heading=_turn(new.start_heading, "to the left", "to the right"),
                )
            )
        return tuple(steps)

    @property
    def line(self) -> str:
        """Comment line with these settings, with which the file of the next trial run begins."""
        return f"# {settings_line(self.settings)}"


def _range(errors: Forecast) -> Message:
    return Message(
        "{mean:.0f} mm expected ({low:.0f} to {high:.0f} in nine runs of ten)",
        mean=errors.end.mean(),
        low=errors.end_quantile(0.05),
        high=errors.end_quantile(0.95),
    )


def _turn(angle: float, positive: str, negative: str) -> Message:
    return Message("{size:.2f}° {way}", size=abs(degrees(angle)), way=Message(positive if angle >= 0 else negative))


def _shift(length: float, positive: str, negative: str) -> Message:
    return Message("{size:.0f} mm {way}", size=abs(length), way=Message(positive if length >= 0 else negative))


def adjust(
    design: Design,
    files: Sequence[Path],
    profile: str,
    wanted: Wanted,
    reading: Reading = AS_NAMED,
    progress: Progress = silent,
) -> AdjustmentPlan:
    """Settings for the next run from trial runs of one car.

    Args:
        design: a loaded design.
        files: CSV files of trial runs, in the order of driving.
        profile: code of the profile of the cam on the car.
        wanted: how the runs were measured, and what may be set.
        reading: how the columns of the files are to be understood.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: as `plan_cam`.
        FileError: as `read_trials` and `trials_of`.
    """
    cam_model.refuse_laps(design, "an adjustment by trial runs", "adjust the car on a design with an open path")
    records = read_trials(files, reading)
    plan = plan_cam(design, profile, progress, with_play=True)
    use = CarUse.of(plan)
    trials = trials_of(records, start_pose(use.track), use.steering.blend_start)
    progress("explaining the trial runs")
    understood = tuple(understood_of(record) for record in records if record.notes)
    return replace(Bench.of(plan, wanted).adjustment(trials), understood=understood)


@dataclass(frozen=True, kw_only=True)
class Bench:
    """A car that is to be adjusted, ready for any trial runs.

    Attributes:
        plan: plan of the cam on it.
        described: facts on design, drive wheel and profile.
        stem: name of the files.
        lever: place of the measured point in the car's frame from the drive wheel, ahead + i left, mm.
        allowed: position error at the end that a run may have, mm.
        wanted: how runs are measured, and what may be set.
        prior: what the car may differ by.
        fine, coarse: the nominal car at stations close together, for points, and further apart, for errors.
    """

    plan: CamPlan
    described: Facts
    stem: str
    lever: complex
    allowed: float
    wanted: Wanted
    prior: CarPrior
    fine: Cars
    coarse: Cars

    @classmethod
    def of(cls, plan: CamPlan, wanted: Wanted) -> "Bench":
        """Make a car ready whose cam was planned with play.

        Deviations lie evenly within twice their tolerances. Friction is that of [mechanics], or anything from none to
        that of a greased rod: the nominal car stands in the middle of the bands.
        """
        comparison = comparison_of(plan)
        band = comparison.task.mechanics
        low, high = comparison.band.ends
        play = (low + high) / 2
        if band is None:
            frictions: tuple[float, float] = (0.0, USUAL[1])
            mechanics = Mechanics(follower=comparison.task.follower, friction=sum(frictions) / 2)
        else:
            frictions, mechanics = band.friction, band.nominal
        steps = 1 + ceil((frictions[1] - frictions[0]) / FRICTION_STEP - 1e-9)
        grid = {
            RETURN_ERROR: _grid(low, high, PLAYS if high > low else 1) - play,
            SLIDING_FRICTION: _grid(*frictions, steps) - mechanics.friction,
        }
        sigma = _spreads(plan)
        if len(grid[RETURN_ERROR]) == 1:
            sigma[RETURN_ERROR] = max(0.03 * play, radians(0.01))
        slip = CarUse.of(plan).half_widths().get(SIDE_SLIP, 0.0) / sqrt(3)
        noise = TrialNoise(point=wanted.noise, head=wanted.division / sqrt(12), side_slip=slip)
        ordered = {each: sigma[each] for each in VARIED if each in sigma}
        use, origin = CarUse.of(plan), plan.origin
        fine, coarse = (
            cars_of(use, plan.curve, list(range(0, STEPS + 1, apart)), mechanics, play, grid=_GRID)
            for apart in (FINE, COARSE)
        )
        course, width = use.course, use.gate_width
        reaches = [gate.place.reach for gate in course.course.gates if gate.place.reach] if course else []
        return cls(
            plan=plan,
            described=Facts(
                design=origin.name,
                design_sha256=origin.content_hash,
                overrides=origin.overrides,
                drive_wheel=use.drive_wheel.entry(),
                cadgen=__version__,
                profile=plan.kind.code,
            ),
            stem=f"{origin.name}_{plan.kind.code}_adjustment".replace("+", "_"),
            lever=use.points[wanted.point.value],
            allowed=min(reaches, default=WORTH if width is None else width / 2),
            wanted=wanted,
            prior=CarPrior(sigma=ordered, grid=grid, noise=noise),
            fine=fine,
            coarse=coarse,
        )

    def adjustment(self, trials: tuple[Trial, ...]) -> AdjustmentPlan:
        """Find settings for the next run after trial runs."""
        wanted, noise, last = self.wanted, self.prior.noise, trials[-1].settings
        posterior = explain(self.fine, self.lever, self.prior, trials)
        cars = posterior.draw(np.random.default_rng(SEED), CARS)
        free = [each for part in wanted.settings for each in SETTINGS[part]]
        settings = best_settings(
            self.coarse,
            cars,
            free,
            division=wanted.division,
            noise=noise,
            generator=np.random.default_rng(SEED),
        )
        designed, before, after = (
            forecast(self.coarse, cars, chosen, noise, np.random.default_rng(SEED))
            for chosen in (Settings(), last, settings)
        )
        steady = None
        if noise.side_slip > 0:
            still = replace(noise, side_slip=0.0)
            steady = forecast(self.coarse, cars, settings, still, np.random.default_rng(SEED))
        return AdjustmentPlan(
            plan=self.plan,
            described=self.described,
            stem=self.stem,
            wanted=wanted,
            trials=trials,
            posterior=posterior,
            settings=settings,
            designed=designed,
            before=before,
            after=after,
            allowed=self.allowed,
            steady=steady,
            scatter=RunScatter.of(self.coarse, trials, noise),
        )


def _spreads(plan: CamPlan) -> dict[Deviation, float]:
    """Standard deviations of what the car may differ by, but for play, friction and the start."""
    sigma = dict(_LEAST)
    for name, width in CarUse.of(plan).half_widths().items():
        # Deviations of the start are in each run's own settings and noise.
        if name not in (*EACH_RUN, SLIDING_FRICTION):
            # A value that is anywhere within the zone, or one direction of such a size.
            spread = WIDER * width / (sqrt(6) if name.directed else sqrt(3))
            sigma[name] = max(sigma.get(name, 0.0), spread)
    return sigma


def _grid(low: float, high: float, count: int) -> Array:
    """Even steps from end to end; the middle if there is one only."""
    return np.linspace(low, high, count) if count > 1 else np.array([(low + high) / 2])


def adjustment_facts(adjustment: AdjustmentPlan) -> Facts:
    """Result in the units of the keys' names."""
    a = adjustment
    return a.described | Facts(
        trial_runs=len(a.trials),
        points=[len(trial.points) for trial in a.trials],
        measured_point=a.wanted.point.value,
        noise_mm=a.wanted.noise,
        division_um=a.wanted.division * 1e3,
        residual_in_noise=a.posterior.residual,
        explained=a.explained,
        settings=_settings(a.settings),
        settings_of_last_trial_run=_settings(a.trials[-1].settings),
        divisions=a.divisions,
        end_position_mm=Facts(as_designed=_expected(a.designed), before=_expected(a.before), after=_expected(a.after)),
        chance_to_be_worse=a.worse,
        understood=a.understood,
        said=a.sentences,
        steps=a.steps,
        line=a.line,
    )


def _settings(settings: Settings) -> Facts:
    return Facts(
        head_mm=settings.head,
        key_deg=degrees(settings.key),
        start_x_mm=settings.start_x,
        start_y_mm=settings.start_y,
        start_heading_deg=degrees(settings.start_heading),
    )


def _expected(errors: Forecast) -> dict[str, float]:
    return {
        "mean": float(errors.end.mean()),
        "5 %": errors.end_quantile(0.05),
        "95 %": errors.end_quantile(0.95),
        "on the way": float(errors.way.mean()),
    }


def write_adjustment(adjustment: AdjustmentPlan, out: Path, progress: Progress = silent) -> Written:
    """Publish the result as JSON, and the table of the next trial run with its settings and no rows yet.

    Raises:
        FileError: a file cannot be written, or read back is not what was written.
    """
    stem = adjustment.stem
    facts = adjustment_facts(adjustment)
    progress("writing")

    def files(folder: Path) -> Iterator[Artifact]:
        document = json.dumps(facts.json(), indent=2, ensure_ascii=False, allow_nan=False)
        yield text_file(folder / f"{stem}.json", f"{document}\n")
        yield text_file(folder / f"{stem}_next_run.csv", f"{adjustment.line}\nrun,x_mm,y_mm\n")

    return publish(stem, out, files, facts)
