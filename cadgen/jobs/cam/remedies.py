"""The remedies against play on one sheet: the error that each leaves, and what to build for it."""

from dataclasses import dataclass, replace
from math import degrees

from cadgen.cam.checks import check_cam
from cadgen.cam.envelope import actual_profile
from cadgen.cam.followers.kind import RunningSurface
from cadgen.car.against_play.band import PlayBand, best_for_band
from cadgen.car.against_play.evaluate import Evaluation
from cadgen.car.against_play.play_task import PlayTask
from cadgen.car.against_play.profile_kinds import ACTUAL, COMPENSATED
from cadgen.car.against_play.remedies import bearing_for, friction_to_fail, holding, trims, worst_run
from cadgen.car.path_motion import PathMotion, blend_checks
from cadgen.car.running.friction import BEARING
from cadgen.car.running.mechanics import Mechanics, MechanicsBand
from cadgen.design import cam_model, variation
from cadgen.design.load import with_overrides
from cadgen.design.schema import Design
from cadgen.errors import DesignError
from cadgen.figures import Figure, Figures
from cadgen.gears.choices import StageOrder
from cadgen.jobs.cam.comparison import PlayComparison, known_trains
from cadgen.messages import Message, clauses, joined
from cadgen.progress import Progress, silent

_MET = 1.0  # mm; a car that ends within this in all of its bands needs no bearing
_ALLOWED_END = 100.0  # mm; error allowed to a trimmed car where [optimize] has no limit


@dataclass(frozen=True, kw_only=True)
class Remedy:
    """A remedy against play, and the error that it leaves.

    Attributes:
        name: name of the remedy.
        cut_for: window of a compensated profile, rad; None for the plain profile.
        worst_end: position error at the end of the run in the worst car of the bands, mm; None if it cannot be built.
        on_way: greatest position error on the run of the worst car, mm; None if it cannot be built.
        build: advice on what to build or do besides the cam, a sentence; empty if there is none.
    """

    name: str
    cut_for: float | None
    worst_end: float | None
    on_way: float | None
    build: str = ""

    @property
    def figures(self) -> Figures:
        """Window of the profile and the errors left, as they are shown."""
        cut_for = None if self.cut_for is None else degrees(self.cut_for)
        return Figures(
            Figure("cut_for", Message("cut for"), cut_for, "°"),
            Figure("worst_end_position", Message("worst end"), self.worst_end, "mm"),
            Figure("worst_position_on_run", Message("worst on the way"), self.on_way, "mm"),
        )


@dataclass(frozen=True)
class _Sheet:
    """A design with its bands of play, friction and drag.

    Attributes:
        design: loaded design.
        task: lift wanted, car and follower.
        band: return error of its train.
        mechanics: forces on its cam, with the brake that it may have.
        compared: profiles on its train.
    """

    design: Design
    task: PlayTask
    band: PlayBand
    mechanics: MechanicsBand
    compared: tuple[Evaluation, ...]

    def best(self, ends: tuple[float, float], *, trimmed: bool = False) -> tuple[PathMotion, float]:
        """Compensated lift with the least worst end without a brake, and the window that it is cut for, rad.

        The design's own compensated profile is that one if it has no brake; then nothing is searched for twice.

        Args:
            ends: least and greatest return error, rad.
            trimmed: whether each car is trimmed after a trial run.
        """
        task, known = self.task, self.known
        if ends == (min(self.plays), max(self.plays)) and known == self.mechanics and trimmed == task.trimmed:
            for profile in self.compared:
                if profile.profile is COMPENSATED:
                    return profile.lift, profile.made_for
        cases = known.cases if trimmed else known.usual
        found = best_for_band(task.lift, task.follower, task.car, task.length, ends, mechanics=cases, trimmed=trimmed)
        return found.lift, found.made_for

    @property
    def known(self) -> MechanicsBand:
        """Range of the forces on the cam without a brake, for comparison of the remedies."""
        return replace(self.mechanics, drag=(0.0, 0.0), behind=0.0)

    @property
    def plays(self) -> list[float]:
        measured = self.band.measured
        return list(self.band.ends) if measured is None else [measured]

    def row(
        self,
        name: str,
        lift: PathMotion,
        rolled: PathMotion,
        cases: tuple[Mechanics, ...],
        *,
        plays: list[float] | None = None,
        cut_for: float | None = None,
        build: str = "",
    ) -> Remedy:
        """A remedy judged by its worst run.

        Args:
            name: name of the remedy.
            lift: lift that the cam is cut for.
            rolled: lift that the follower gets.
            cases: frictions and drags of the cars.
            plays: return errors, rad; those of the design if left out.
            cut_for, build: same as in `Remedy`.
        """
        end, way = worst_run(self.task, rolled, lift, self.plays if plays is None else plays, cases)
        return Remedy(name=name, cut_for=cut_for, worst_end=end, on_way=way, build=build)


def remedies(design: Design, comparison: PlayComparison, progress: Progress = silent) -> tuple[Remedy, ...]:
    """Every remedy for the design's car, in the worst of its plays and frictions, and the design as it is.

    Remedies are compared without the brake that the design may have. A bearing is left out where the design itself ends
    within a millimetre.

    Args:
        design: loaded design.
        comparison: its profiles against play, with those of all its trains.
        progress: function that is called with a few words on each step.

    Raises:
        DesignError: the design has no [mechanics].
    """
    mechanics = comparison.task.mechanics
    if mechanics is None:
        raise DesignError("remedies against play go by the rod's force and friction: add [mechanics]")
    progress("comparing remedies against play")
    compared = tuple(
        evaluation
        for evaluation in comparison.evaluations
        if evaluation.train == design.optimize.order and not evaluation.measured
    )
    sheet = _Sheet(design, comparison.task, comparison.band, mechanics, compared)
    plain = next(evaluation for evaluation in compared if evaluation.profile is ACTUAL)
    cases, chosen = sheet.known.cases, comparison.chosen
    name = Message("this design: {profile}", profile=Message(str(chosen.profile)))
    if sheet.task.trimmed:
        name = Message("{name}, trimmed", name=name)
        this = _trimmed(sheet, name, chosen.lift, chosen.rolled, sheet.mechanics.fine_cases)
    else:
        this = sheet.row(name, chosen.lift, chosen.rolled, sheet.mechanics.cases)
    rows = [
        this,
        sheet.row(Message("plain cam"), plain.lift, plain.rolled, cases),
    ]
    bands = known_trains(design)
    if StageOrder.REORDERED in bands and design.optimize.order != StageOrder.REORDERED:
        lift, plays = sheet.task.lift, list(bands[StageOrder.REORDERED].ends)
        build = Message("the train with its stages reordered: --set optimize.order=reordered")
        rows.append(sheet.row(Message("plain cam, reordered"), lift, lift, cases, plays=plays, build=build))
    rows += _compensated(sheet)
    rows += _tight_joint(sheet)
    rows += _split_wheel(sheet)
    if this.worst_end is None or this.worst_end >= _MET:  # no other rod is better, and the search for its cam is long
        rows += _bearing(sheet)
    if holding(plain.lift, sheet.known).torque > 0:
        rows += [_trim(sheet, plain), _compensated_trim(sheet)]
        rows += _drag(sheet, plain)
    return tuple(rows)


def _compensated(sheet: _Sheet) -> list[Remedy]:
    """Profiles compensated for the car in the middle of the bands, and for all of them."""
    task, known = sheet.task, sheet.known
    play = sum(sheet.plays) / len(sheet.plays)
    middle = best_for_band(task.lift, task.follower, task.car, task.length, (play, play), mechanics=(known.nominal,))
    left = middle.worst_distance
    rows = [
        sheet.row(
            Message("compensated for one car"),
            middle.lift,
            middle.lift,
            known.cases,
            cut_for=middle.made_for,
            build=Message(
                "right for a play of {play:.3f}° and a friction of {friction:.3g}, where it leaves {left:.0f} mm: "
                "measure both on the car",
                play=degrees(play),
                friction=known.nominal.friction,
                left=left,
            ),
        )
    ]
    return [*rows, _robust(sheet, Message("compensated for all"), (min(sheet.plays), max(sheet.plays)))]


def _robust(sheet: _Sheet, name: str, ends: tuple[float, float], build: str = "") -> Remedy:
    """The profile with the least worst end over plays between two ends (rad), as a remedy."""
    lift, cut_for = sheet.best(ends)
    return sheet.row(name, lift, lift, sheet.known.cases, plays=list(ends), cut_for=cut_for, build=build)


def _tight_joint(sheet: _Sheet) -> list[Remedy]:
    """The loosest joint clamped, pinned or glued, and a profile for the play that is left."""
    whole = variation.whole_play(sheet.design)
    if whole is None or not whole.loose or sheet.design.play is not None:
        return []
    worst = max(whole.loose, key=lambda joint: joint.greatest)
    low, high = sheet.band.ends
    ends = max(low - worst.least, 0.0), max(high - worst.greatest, 0.0)
    return [_robust(sheet, Message("no play in one joint, compensated"), ends, whole.sentence())]


def _split_wheel(sheet: _Sheet) -> list[Remedy]:
    """A wheel of two halves under springs at the camshaft: it takes out its own mesh, and no other."""
    trains = variation.train_plays(sheet.design)
    if not trains or sheet.design.play is not None:
        return []
    teeth = trains[sheet.design.optimize.order].teeth
    if teeth is None or not teeth.train.stages[-1].toothed:
        return []
    last = teeth.stages[-1]
    low, high = sheet.band.ends
    ends = max(low - last.B_min, 0.0), max(high - last.B_max, 0.0)
    build = Message(
        "a wheel of two halves under springs on the camshaft, which takes out its own mesh only, {mesh:.3f} of "
        "{whole:.3f}°; its springs must hold more torque than the cam gives",
        mesh=degrees(last.B_max),
        whole=degrees(high),
    )
    return [_robust(sheet, Message("split wheel, compensated"), ends, build)]


def _bearing(sheet: _Sheet) -> list[Remedy]:
    """A ball bearing on the rod, and a cam for its radius, compensated."""
    task, design = sheet.task, sheet.design
    if not design.follower.registered.runs or design.follower.surface == RunningSurface.BALL_BEARING:
        return []
    fitting = bearing_for(task.lift, task.follower)
    if fitting is None:
        return []
    bearing, count = fitting
    follower = replace(task.follower, radius=bearing.outside / 2)
    known = replace(sheet.known, follower=follower, friction=BEARING, measured=False)
    overrides = [
        f"follower.radius_mm={bearing.outside / 2:g}",
        "follower.material=ball_bearing",
        f"follower.width_mm={count * bearing.width:g}",
    ]
    if design.mechanics and design.mechanics.friction_least is not None:
        overrides += ["mechanics.friction_least=", "mechanics.friction_greatest="]
    try:
        with_overrides(design, overrides)
        ends = min(sheet.plays), max(sheet.plays)
        best = best_for_band(task.lift, follower, task.car, task.length, ends, mechanics=known.corners)
        profile = actual_profile(best.lift, follower)
        limits = cam_model.check_limits(design)
        blank = cam_model.blank(design)
        checks = check_cam(best.lift, follower, profile.curve, profile.trims, blank, limits, application=blend_checks)
        failed = [check.name for check in checks if not check.passed]
        verdict = Message("its cam keeps every check")
        if failed:
            verdict = Message("its cam fails {failed}", failed=joined(failed))
    except DesignError as error:
        return [
            Remedy(
                name=Message("ball bearing, compensated"),
                cut_for=None,
                worst_end=None,
                on_way=None,
                build=Message(
                    "no cam can be made for a bearing of {outside:g} mm: {reason}",
                    outside=bearing.outside,
                    reason=error.message,
                ),
            )
        ]
    several = Message("a ball bearing")
    if count > 1:
        several = Message("{count} ball bearings side by side", count=count)
    return [
        sheet.row(
            Message("ball bearing, compensated"),
            best.lift,
            best.lift,
            known.cases,
            cut_for=best.made_for,
            build=Message(
                "{several} of {bore:g} x {outside:g} x {width:g} mm on the rod, and a cam for it: {changes}; {verdict}",
                several=several,
                bore=bearing.bore,
                outside=bearing.outside,
                width=bearing.width,
                changes=" ".join(f"--set {override}" for override in overrides),
                verdict=verdict,
            ),
        )
    ]


def _trim(sheet: _Sheet, plain: Evaluation) -> Remedy:
    """The plain cam with the steering set after a trial run."""
    task, known = sheet.task, sheet.known
    middle = sum(sheet.plays) / len(sheet.plays)
    allowed = sheet.design.optimize.max_end_position_mm or _ALLOWED_END
    low, high = friction_to_fail(task, plain.rolled, plain.lift, middle, known.nominal, allowed)
    found = _trimmed(sheet, Message("plain cam, trimmed"), plain.lift, plain.rolled, known.fine_cases)
    holds = Message(
        "set at a friction of {friction:.3g}, the end stays within {allowed:g} mm more while friction stays from "
        "{low:.3g} to {high:.3g}",
        friction=known.nominal.friction,
        allowed=allowed,
        low=low,
        high=high,
    )
    return replace(found, build=joined((found.build, holds), "; "))


def _compensated_trim(sheet: _Sheet) -> Remedy:
    """The profile with the least worst end after the trim, with the steering set after a trial run."""
    lift, cut_for = sheet.best((min(sheet.plays), max(sheet.plays)), trimmed=True)
    found = _trimmed(sheet, Message("compensated, trimmed"), lift, lift, sheet.known.fine_cases)
    cam = Message("a cam that is compensated for what the trim leaves, --set 'optimize.hardware=[\"trim\"]'")
    return replace(found, cut_for=cut_for, build=joined((cam, found.build), "; "))


def _trimmed(sheet: _Sheet, name: str, lift: PathMotion, rolled: PathMotion, cases: tuple[Mechanics, ...]) -> Remedy:
    """A profile with the steering set after a trial run of each car.

    Args:
        sheet: design with its bands.
        name: name of the remedy.
        lift: lift that the cam is cut for.
        rolled: lift that the follower gets.
        cases: frictions and drags of the cars.
    """
    settings = trims(sheet.task, rolled, lift, sheet.plays, cases)
    # A larger base radius turns the steering to the left: tan(beta) falls by its growth over the faces' distance.
    arm = (sheet.task.follower.inner + sheet.task.follower.outer) / 2
    turns = sorted((-trim.tan_beta * arm * 1e3 for trim in settings), key=abs)
    return Remedy(
        name=name,
        cut_for=None,
        worst_end=max(trim.error.end_distance for trim in settings),
        on_way=max(float(trim.error.distance.max()) for trim in settings),
        build=Message(
            "after a trial run change the base radius at the micrometer by {least:+.0f} to {most:+.0f} µm, so that the "
            "end is met",
            least=round(turns[0]) + 0.0,
            most=round(turns[-1]) + 0.0,
        ),
    )


def _drag(sheet: _Sheet, plain: Evaluation) -> list[Remedy]:
    """The plain cam with a brake on the disc that holds it."""
    need = holding(plain.lift, sheet.known)
    braked = replace(sheet.known, drag=(need.drag, need.drag), friction=(0.0, sheet.known.friction[1]), behind=0.0)
    keys = sheet.design.mechanics
    share: str = ""
    if keys is not None and keys.drive_energy_J is not None:
        drive = keys.drive_energy_J
        share = Message(", {percent:.1f} % of the drive's {drive:g} J", percent=100 * need.energy / drive, drive=drive)
        if need.energy > drive:
            share = clauses(share, Message("which it has not got"))
    return [
        sheet.row(
            Message("plain cam, drag that holds"),
            plain.lift,
            plain.rolled,
            braked.cases,
            build=Message(
                "a brake or felt on the disc itself, {drag:.3g} N·mm for a rod force of {rod_force:g} N: a quarter "
                "more than the cam's {torque:.3g} N·mm at {cam_angle:.1f}° without friction ({with_friction:.3g} at "
                "the least friction); it takes {energy:.2g} J a turn{share}, and holds until the drag falls by "
                "{falls:.0f} % or the rod's force rises by {rises:.0f} %; a milder path there needs less, a larger "
                "base radius does not",
                drag=need.drag,
                rod_force=sheet.known.rod_force,
                torque=need.torque,
                cam_angle=degrees(need.cam_angle),
                with_friction=need.with_friction,
                energy=need.energy,
                share=share,
                falls=100 * (1 - need.torque / need.drag),
                rises=100 * (need.drag / need.torque - 1),
            ),
        )
    ]
