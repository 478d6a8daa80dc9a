"""Printing of results: progress on standard error; sheets, sentences and a verdict, or one JSON document."""

import json
import os
import shlex
import shutil
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import takewhile
from math import isfinite, isinf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from rich.text import Text

from cadgen.check import Bound, Check, CheckCode
from cadgen.cli.output import hush
from cadgen.errors import escaped
from cadgen.figures import Sheet, rounded, with_unit
from cadgen.messages import Message, joined, sentence, shown
from cadgen.output.report.terminal import FittedConsole, table
from cadgen.progress import Progress
from cadgen.verdict import PartVerdict, Readiness

if TYPE_CHECKING:
    from cadgen import Card, Design, Written
    from cadgen.api.adjustment import Adjustment
    from cadgen.api.calibration import Calibration, Calibrations
    from cadgen.api.cam import Cam, Cures
    from cadgen.api.exploration import Exploration
    from cadgen.api.found_cam import ComparedCam, FoundCam
    from cadgen.api.measured_gears import MeasuredGear, MeasuredTrain
    from cadgen.api.planning import Plan


_COLOURS = {Readiness.READY: "green", Readiness.RESERVATIONS: "yellow", Readiness.NOT_READY: "red"}
# Checks of a car that its cam steers, apart from those of its course.
_OF_CAR = (
    CheckCode.PATH_WAYPOINT,
    CheckCode.PATH_END,
    CheckCode.CUT_WAYPOINT,
    CheckCode.CUT_END,
    CheckCode.LOST_LIFT_EFFECT,
    CheckCode.LIFT_ERROR_WITH_PLAY,
    CheckCode.END_POSITION_WITH_PLAY,
    CheckCode.END_HEADING_WITH_PLAY,
    CheckCode.RUN_POSITION_WITH_PLAY,
    CheckCode.CAM_RUNS_AHEAD,
    CheckCode.CAM_HOLDS,
    CheckCode.EDGES_BROKEN_MORE,
    CheckCode.CARS_KEEP_COURSE,
    CheckCode.DRIVE_WHEEL_GREATEST,
    CheckCode.DRIVE_WHEEL_LEAST,
    CheckCode.DRIVE_WHEEL_OUTLINE,
    CheckCode.ENERGY_LEFT,
    CheckCode.WEIGHT_PULL,
)
_IN_CAR = (
    CheckCode.AXLE_REACHED,
    CheckCode.CAR_CLEARANCE,
    CheckCode.FLOOR_CLEARANCE,
    CheckCode.PLATE_ROOM,
    CheckCode.PLATE_THICKNESS,
    CheckCode.CAM_SENSE,
)
_OF_FORCES = (
    CheckCode.FORCE_LEAST,
    CheckCode.FORCE_GREATEST,
    CheckCode.GUIDE_JAMS,
    CheckCode.LIFT_OFF_SPEED,
    CheckCode.TORQUE_GREATEST,
    CheckCode.TORQUE_LEAST,
    CheckCode.TORQUE_MEAN,
    CheckCode.POWER_MEAN,
    CheckCode.CONTACT_PRESSURE,
)
# Columns of a terminal below which a check's place stands under its name and not beside its figures.
_FAR_WITHIN = 0.1  # a figure below this share of its limit, or as far above it, is far within it
_NARROW = 72
_FAILS = 3  # checks that fail, of which the first lines say the figures
_MOST_ROWS = 10  # of the front of a study
_STATES = {
    "kept": Message("{count} within all limits"),
    "outside": Message("{count} outside a limit or check"),
    "screened": Message("{count} screened out"),
    "refused": Message("{count} no design"),
    "crashed": Message("{count} crashed"),
}


class Output(FittedConsole):
    """Standard output or error."""

    def __init__(self, *, stderr: bool = False) -> None:
        super().__init__(stderr=stderr)
        if self.width < 1:  # COLUMNS=0 says that the width is not known
            self.width = shutil.get_terminal_size().columns

    def on_broken_pipe(self) -> None:
        """Say nothing more, but let the command end with its own exit code."""
        hush()


@contextmanager
def progress(enabled: bool) -> Iterator[Progress]:
    """Yield a function that shows the current step; silent unless standard error is a terminal."""
    console = Output(stderr=True)
    if not enabled or not console.is_terminal:
        yield lambda text: None
        return
    with console.status(shown(Message("reading the design"))) as status:
        yield lambda text: status.update(shown(text))


def document(facts: Mapping[str, Any]) -> None:
    """Print one JSON document."""
    try:
        click.echo(json.dumps(dict(facts), indent=2, allow_nan=False))
    except BrokenPipeError:
        hush()


def sheet(content: Sheet, *, gap: bool = True) -> None:
    """Print a sheet, with an empty line above its title if `gap` holds."""
    Output().print(table(content, gap=gap))


def sentences(lines: Iterable[str]) -> None:
    """Print clauses as sentences."""
    console = Output()
    for line in lines:
        console.print(sentence(line))


def verdict(passed: bool | Readiness, result: str, step: str = "") -> None:
    """Print the last line: PASS or FAIL, or the readiness of a cam, and what to do next.

    Args:
        passed: whether the command did all that was asked of it; of a cam, its readiness.
        result: result in a few words.
        step: what to do next.
    """
    line = Message("{result}; next: {step}", result=result, step=step) if step else result
    if isinstance(passed, Readiness):
        head = Text(shown(passed.words).upper(), f"bold {_COLOURS[passed]}")
    else:
        word, colour = (Message("PASS"), "green") if passed else (Message("FAIL"), "red")
        head = Text(shown(word), f"bold {colour}")
    Output().print(Text.assemble(head, f"{shown(': ')}{shown(line)}"))


def failed(checks: "Sequence[Check]") -> Message:
    """The checks that fail, in words."""
    names = list(dict.fromkeys(check.name for check in checks if not check.passed))
    if len(names) == 1:
        return Message("{name} fails", name=label(names[0]))
    return Message("{names} fail", names=joined(map(label, names), "; "))


def with_assumed(result: Message, cam: "Cam") -> Message:
    """Result of a cam with the names of what its milling programs assume, for the line of the verdict."""
    names = cam.making.machining.unstated(cam.making.material)
    return Message("{result}; assumed for the mill: {names}", result=result, names=joined(names)) if names else result


def label(name: str) -> Message:
    """A name that the catalogue may have, as a message."""
    return Message(name)


def command(verb: str, design: str | None, *more: str, overrides: Sequence[str] = ()) -> Message:
    """A command on the same design, as it is typed; many overrides are only named."""
    words = " ".join(["cadgen", verb, *([shlex.quote(design)] if design else []), *more])
    return Message("{command} (with the same --set)", command=words) if overrides else Message(words)


def checks(cam: "Cam", cures: "Cures", *, every: bool) -> None:
    """Print the verdict on a cam in a few lines, then what fails with its advice and cures; on request all rows.

    Args:
        cam: cam that was computed.
        cures: cures of its lost lift.
        every: whether every check is shown, by group, with what was assumed; else what to do beside the cam.
    """
    console = Output()
    if cam.expected:
        console.print(cam.expected)
    console.print(*summary(cam), sep="\n")
    if every:
        console.print(cam.wheel)
        friction(cam)
    else:
        sentences(cam.application.setting(cam))
    rows(cam, every=every)
    for line in cures.sentences():
        console.print(line)


def rows(cam: "Cam", *, every: bool) -> None:
    """Print the checks of a cam that fail, or all of them by group."""
    if every:
        for title, group in _groups(cam.figures):
            figures(title, group, gap=True)
        for content in cam.application.sheets(cam):
            sheet(content)
    else:
        failures(cam)


def summary(cam: "Cam", *, drawn: PartVerdict | None = None) -> Iterator[Text]:
    """Lines on a cam: verdict, purpose, the figures that decide, the tightest check, and the reservations.

    Args:
        cam: cam that was computed.
        drawn: verdict with the spacings of a draw, where the figures that decide were shown already, those of more
            cars among them; None for the cam's own.
    """
    ruling = drawn or cam.verdict
    yield _heading(cam, ruling)
    yield Text(shown(Message("For {purpose}.", purpose=cam.application.purpose(cam))))
    if cam.deciding and drawn is None:
        yield Text(shown(sentence(joined(cam.deciding))))
    close = tightest(ruling.checks) if ruling.passed else None
    if close is not None:
        yield Text(shown(Message("Tightest: {check}.", check=_against_limit(close))))
    if ruling.failed:
        said = [_against_limit(check) for check in ruling.failed[:_FAILS]]
        if (more := len(ruling.failed) - _FAILS) > 0:
            said.append(Message("and {count} more", count=more))
        yield Text(shown(Message("Fails: {checks}.", checks=joined(said, "; "))))
    yield from _reservations(ruling)


def _heading(cam: "Cam", ruling: PartVerdict) -> Text:
    """Name of a cam with the verdict."""
    named = Message("{name}, {profile} profile", name=cam.origin.name, profile=Message(str(cam.profile)))
    return Text.assemble(
        f"{shown(named)}{shown(': ')}",
        (shown(ruling.readiness.words), f"bold {_COLOURS[ruling.readiness]}"),
    )


def _reservations(ruling: PartVerdict) -> Iterator[Text]:
    """A line for each reservation."""
    for reservation in ruling.reservations:
        yield Text.assemble(
            (f"{shown(Message('Reservation'))}{shown(': ')}", "yellow"), shown(sentence(reservation.sentence))
        )


def _against_limit(check: Check) -> Message:
    """A check with its value, its limit and its place, in a clause."""
    return Message(
        "{name} {value}, {least} {limit} allowed{place}",
        name=label(check.name),
        value=check.text() if isfinite(check.value) else _number(check.value),
        least=Message("at least") if check.bound == Bound.MIN else Message("at most"),
        limit=with_unit(rounded(check.limit), check.unit_shown),
        place=Message(" ({place})", place=check.place) if check.place else "",
    )


def tightest(checks: "Sequence[Check]") -> "Check | None":
    """Passed check whose value lies nearest to its limit, as a share of it; None where none comes near one.

    Args:
        checks: figures that were judged.
    """
    limited = [
        check
        for check in checks
        if check.unit
        and isfinite(check.limit)
        and check.limit
        and check.passed
        # A figure far within its limit, such as the error of rolling, says nothing of the cam.
        and (
            abs(check.value) < abs(check.limit) / _FAR_WITHIN
            if check.bound == Bound.MIN
            else abs(check.value) > abs(check.limit) * _FAR_WITHIN
        )
    ]
    return min(limited, key=lambda check: abs(check.value - check.limit) / abs(check.limit), default=None)


def _groups(checks: "Sequence[Check]") -> Iterator[tuple[Message, list[Check]]]:
    """Checks by what they are of: the disc, its motion, the car, the course."""
    course = [check for check in checks if check.code.value.startswith("course-")]
    car = [check for check in checks if check.code in _OF_CAR]
    motion = [check for check in checks if check.code.value.startswith("motion-")]
    forces = [check for check in checks if check.code in _OF_FORCES]
    parts = [check for check in checks if check.code in _IN_CAR]
    disc = [check for check in checks if not any(check in group for group in (course, car, motion, forces, parts))]
    groups = (
        (Message("The cam"), disc),
        (Message("The motion"), motion),
        (Message("The forces"), forces),
        (Message("The car on its path"), car),
        (Message("The parts in the car"), parts),
        (Message("The course"), course),
    )
    yield from ((title, rows) for title, rows in groups if rows)


def friction(cam: "Cam") -> None:
    """Print the effect that friction would have on the result, if it was computed without friction."""
    for warning in cam.application.warnings():
        Output().print(Text(shown(warning), "yellow"))


def failures(cam: "Cam") -> None:
    """Print the checks that fail, with their advice; nothing if all pass."""
    if cam.failed:
        title = Message(
            "{name}: the {profile} profile fails its checks", name=cam.origin.name, profile=Message(str(cam.profile))
        )
        figures(title, cam.failed, gap=True)


def train_figures(checks: "Sequence[Check]") -> None:
    """Print the checks of a train, those of its teeth and those of its place in a car in tables of their own.

    Args:
        checks: checks of the train.
    """
    placed = [check for check in checks if check.code in _IN_CAR]
    figures(Message("teeth in mesh, measured"), [check for check in checks if check not in placed], gap=True)
    if placed:
        figures(Message("the parts in the car"), placed, gap=True)


def figures(title: str, checks: "Sequence[Check]", *, gap: bool = False) -> None:
    """Print checks as a table, then the advice for each that failed.

    Args:
        title: title of the table.
        checks: checks, in the order of the rows.
        gap: whether an empty line stands above the title.
    """
    console = Output()
    narrow = console.width < _NARROW
    made = table(Sheet("checks", title, (), ()), gap=gap)
    for head in ("check", "value", "limit", "", *(() if narrow else ("where",))):
        made.add_column(shown(head), justify="right" if head in ("value", "limit") else "left")
    for check in checks:
        verdict = Text(shown(Message("ok")), "green") if check.passed else Text(shown(Message("FAIL")), "red")
        if isinf(check.limit):  # a figure, not a verdict
            verdict = Text("")
        bound = "<=" if check.bound == Bound.MAX else ">="
        name, place = shown(check.name), shown(check.place)
        made.add_row(
            Text.assemble(name, (f"\n{place}", "dim")) if narrow else Text(name),
            with_unit(_number(check.value), shown(check.unit_shown)) if isfinite(check.value) else _number(check.value),
            f"{bound} {_number(check.limit)}",
            verdict,
            *([] if narrow else [Text(place)]),
        )
    console.print(made)
    # One advice may serve several checks.
    advice: dict[str, list[str]] = {}
    for check in checks:
        if not check.passed and check.advice:
            advice.setdefault(check.advice, []).append(check.name)
    for text, names in advice.items():
        named = shown(joined(map(label, names), " and "))
        console.print(Text.assemble((named, "red"), f"{shown(': ')}{shown(text)}{shown(Message('.'))}"))


def _number(value: float) -> str:
    if isfinite(value):
        return rounded(value)
    return shown(Message("none")) if value != value else shown(Message("any"))


def plan(planned: "Plan[Any]", *, every: bool) -> None:
    """Print a planned path, and the verdict on the cam for it if there is one.

    Args:
        planned: planned path.
        every: whether every check of the cam is shown.
    """
    sentences(planned.sentences)
    if planned.cam is not None:
        Output().print("", *summary(planned.cam, drawn=planned.verdict), sep="\n")
        rows(planned.cam, every=every)


def card(result: "Card[Cam]") -> None:
    """Print a card: the verdict, the settings of every spacing, and the checks of a cam that fails."""
    Output().print(_heading(result.cam, result.verdict))
    sentences(result.sentences)
    for reservation in _reservations(result.verdict):
        Output().print(reservation)
    sheet(result.sheet, gap=False)
    for line in result.legend:
        Output().print(f"{shown(line)}{shown(Message('.'))}", style="dim")
    failures(result.cam)


def explained(result: "Calibration[Design] | Calibrations[Design]", *, written: bool, asked: bool) -> None:
    """Print whether all that was measured is explained, and what to do next.

    Args:
        result: judged files, together or each alone.
        written: whether the as-built design was written.
        asked: whether it was said already what to measure next.
    """
    from cadgen.api.calibration import Calibration

    if result.readiness == Readiness.NOT_READY:
        kinds = joined(Message("{name} {what}", name=name, what=Message(what)) for name, what in result.unclear.items())
        step: str = Message("measure again, or other data")
        if isinstance(result, Calibration) and not asked:
            step = Message("the same command with --next says what to measure")
        said: str = Message("not all is explained ({kinds})", kinds=kinds)
        if not result.unclear:
            said = Message("what was measured is explained, but no new cam is sure to bring the car nearer")
        if not isinstance(result, Calibration) and result.cams_unknown and not result.unclear:
            names = joined(result.cams_unknown, ", ")
            said = Message("it is not sure which cam is on the car of {names}", names=names)
            step = Message("give its --profile")
        if isinstance(result, Calibration) and result.cam_unknown:
            said, step = Message("it is not sure which cam is on the car"), Message("give its --profile")
            if result.other_cam is not None and result.other_cam.earlier:
                step = Message(
                    "calibrate the design that the earlier cam was cut from with --profile {profile}",
                    profile=result.other_cam.profile,
                )
            elif result.profile_stated:
                step = Message("look which cam was on the car, and calibrate again with its --profile")
        verdict(result.readiness, said, step)
        return
    said = Message("what was measured is explained")
    if result.readiness == Readiness.RESERVATIONS:
        said = Message("{said}, but {left:.1f} times the noise remain and have no name", said=said, left=result.left)
    if not isinstance(result, Calibration):
        verdict(result.readiness, said)
    elif not result.effects:
        verdict(result.readiness, said, Message("nothing differs from the design: drive"))
    elif written:
        verdict(result.readiness, said, Message("cadgen cam on the as-built design"))
    else:
        verdict(result.readiness, said, Message("--out writes the as-built design, for cadgen cam"))


def found(result: "FoundCam | ComparedCam | MeasuredGear | MeasuredTrain", *, written: bool) -> None:
    """Print whether a measured cam or train is explained, and what to do next.

    Args:
        result: measured cam or train.
        written: whether the new design was written.
    """
    from cadgen.api.found_cam import ComparedCam, FoundCam

    if not isinstance(result, FoundCam | ComparedCam):
        from cadgen.api.measured_gears import MeasuredGear

        (_gear if isinstance(result, MeasuredGear) else _train)(result, written=written)  # type: ignore[arg-type]
        return
    if not isinstance(result, FoundCam):
        _compared(result)
        return
    step: str = Message("--out writes the design of the new cam, for cadgen cam")
    if written:
        step = Message("cadgen cam on {name}.toml", name=result.name)
    if result.named:
        said = Message("the law of every segment is named")
    elif result.readiness == Readiness.NOT_READY:
        said, step = Message("a segment has no law of the table"), Message("look whether its wear may be copied")
    else:
        said = Message("the law of a segment is not decided")
    verdict(result.readiness, said, step)


def _train(result: "MeasuredTrain", *, written: bool) -> None:
    step: str = Message("--out writes the corrected design") if result.designs else ""
    if written and result.designs:
        step = Message("cadgen gears on {name}.toml", name=next(iter(result.designs)))
    if result.faults:
        verdict(result.readiness, Message("not all that was measured is explained"), result.faults[0].step)
    elif result.within is False:
        verdict(result.readiness, Message("the play is not that of the design"), step)
    elif result.errors.play is None:
        verdict(
            result.readiness, Message("the play was not seen"), Message("turn back, or load both ways, within each run")
        )
    elif result.noisy:
        verdict(
            result.readiness, Message("the noise is great beside the play"), Message("measure again with less noise")
        )
    elif result.readiness == Readiness.RESERVATIONS:
        verdict(result.readiness, Message("what was measured has more than one cause"), step)
    else:
        verdict(result.readiness, Message("what was measured is explained"), step)


def _gear(result: "MeasuredGear", *, written: bool) -> None:
    step: str = Message("--out writes the design as built") if result.designs else ""
    if written and result.designs:
        step = Message("cadgen gears on {name}.toml", name=next(iter(result.designs)))
    if result.readiness == Readiness.NOT_READY:
        verdict(result.readiness, Message("the flanks do not keep what the design allows"), step)
    elif result.readiness == Readiness.RESERVATIONS:
        verdict(result.readiness, joined(result.reservations, "; "), step)
    else:
        verdict(result.readiness, Message("the gear is as designed, within its grade"), step)


def _compared(result: "ComparedCam") -> None:
    if result.comparison.mirrored:
        verdict(result.readiness, Message("the disc is wrong side up"), Message("turn it over, and measure again"))
    elif not result.comparison.explained:
        verdict(
            result.readiness,
            Message("not all that was measured is explained"),
            Message("motion.measured = true instead of the motion finds the one that it has"),
        )
    elif result.comparison.worn:
        said = Message("a flank is worn") if result.comparison.surely_worn else Message("a flank may be worn")
        verdict(result.readiness, said, Message("make the disc anew"))
    elif not result.found:
        verdict(result.readiness, Message("nothing differs from the design"))
    else:
        verdict(result.readiness, Message("what was measured is explained"), Message("correct what differs"))


def settings(adjustment: "Adjustment") -> None:
    """Print the result of trial runs, what to set, and the comment line of the next run."""
    sentences([*adjustment.understood, *adjustment.sentences])
    console = Output()
    console.print(f"\n{shown(Message('Set:'))}")
    for step in adjustment.steps:
        console.print(f"- {shown(step)}")
    console.print(f"\n{shown(Message('If you measure the next run too, begin its file with this line:'))}")
    console.print(adjustment.line, soft_wrap=True)


def study(computed: "Exploration", written: "Written | None", out: Path, *, as_json: bool) -> None:
    """Print counts, front and files of a study; of a shard, which has none of these yet, only JSON.

    Args:
        computed: results.
        written: files that were written; None for a shard.
        out: folder of the results.
        as_json: whether to print one JSON document instead.
    """
    if as_json:
        document(computed.facts() if written is None else written.entry)
        return
    if written is None:
        return
    summary = computed.summary
    states = joined(Message(_STATES[state].template, count=count) for state, count in summary.states.items())
    Output().print(
        Message("{name}: {count} designs, {states}.", name=computed.name, count=computed.computed.count, states=states)
    )
    if summary.front:
        _front(computed)
    files(written, out)


def _front(computed: "Exploration") -> None:
    study, front = computed.computed.study, computed.summary.front
    title = Message("front: {count} designs", count=len(front))
    if len(front) == 1:
        title = Message("front: 1 design")
    elif len(front) > _MOST_ROWS:
        title = Message("front: {count} designs, the first:", count=len(front))
    rows = tuple(
        (
            str(row.number),
            *(f"{value:.6g}" if isinstance(value, float) else str(value) for value in (*row.values, *row.figures)),
        )
        for row in front[:_MOST_ROWS]
    )
    heads = (Message("number"), *study.keys, *(figure.code for figure in study.figures))
    sheet(Sheet("front", title, heads, rows, words=0))


def outcome(computed: "Exploration", out: Path) -> tuple[bool, str, str]:
    """Whether any design of a study keeps all limits and checks, the result in words, and the next step."""
    place, count = out / computed.name, len(computed.summary.front)
    if not count:
        reasons = Message("the columns failed and sentence of {file}.csv say what is in the way", file=place)
        return False, Message("no design keeps all limits and checks"), reasons
    best = Message("raise best in the study")
    if computed.computed.study.file.best:
        best = Message("cadgen cam {place}_best_1.toml", place=place)
    return True, Message("every design has its row; on the front: {count}", count=count), best


def files(written: "Written", out: Path) -> None:
    """Print each file with its size, its error at the follower's lift, and the end of a run with play on it.

    The common start of their names stands above the table, so that it fits a narrow terminal.
    """
    stem = written.part if all(file.name.startswith(written.part) for file in written) else ""
    with_lift = any(file.lift_error_um is not None for file in written)
    with_play = any(file.end_position_mm is not None for file in written)
    heads: list[str] = [Message("file"), Message("size")]
    heads += [Message("at lift"), Message("limit")] if with_lift else []
    heads += [Message("end of run")] if with_play else []
    rows = []
    for file in written:
        error, limit, end = file.lift_error_um, file.lift_limit_um, file.end_position_mm
        cells = [file.name.removeprefix(stem), size(file.bytes)]
        if with_lift:
            cells += ["" if error is None else f"{error:.3f} µm", "" if limit is None else f"{limit:g} µm"]
        if with_play:
            cells.append("" if end is None else f"{end:.2f} mm")
        rows.append(tuple(cells))
    heading(out, stem)
    sheet(Sheet("files", "", tuple(heads), tuple(rows)), gap=False)
    _omitted(written)
    _not_stated(written)
    for warning in written.warnings:
        Output().print(_warning(warning))
    _of_earlier_versions(out, os.path.commonprefix([Path(file.name).stem for file in written]))  # noqa: RUF071 (of names)


def of_earlier_version(design: str, names: Sequence[str]) -> Text:
    """Warning of files that an earlier version of a design has left.

    Args:
        design: name of the design.
        names: of the files.
    """
    said = Message(
        "of an earlier version of {design} than other files in this folder: {names}",
        names=joined(names),
        design=escaped(design),
    )
    return _warning(said)


def _warning(clause: str) -> Text:
    return Text.assemble((shown(Message("Warning")), "yellow"), f"{shown(': ')}{shown(clause)}{shown('.')}")


def _of_earlier_versions(out: Path, stem: str) -> None:
    from cadgen.output.files.manifest import NAME, older_files, sound_parts

    older = {name: of for name, of in older_files(sound_parts(out / NAME)).items() if name.startswith(stem)}
    for design in dict.fromkeys(older.values()):
        Output().print(of_earlier_version(design, [escaped(name) for name, of in older.items() if of == design]))


def size(count: int) -> str:
    """Size of a file of so many bytes."""
    return f"{count / 1000:.0f} kB" if count >= 1000 else f"{count / 1000:.1f} kB"


def heading(out: Path, stem: str) -> None:
    """Print the folder of files, and what their names begin with, above their table."""
    Output().print(f"\n{out / stem}{'' if stem else os.sep}", style="bold", overflow="fold")


def _omitted(written: "Written") -> None:
    for label, reason in written.omitted.items():
        left_out = shown(Message("{label} left out", label=label))
        Output().print(Text.assemble((left_out, "yellow"), f"{shown(': ')}{shown(reason)}{shown('.')}"))


def _not_stated(written: "Written") -> None:
    """Print what the sheets leave open, with the keys that state it."""
    if written.not_stated:
        named = joined(
            Message("{name} ({key})", name=Message(name), key=key) for name, key in written.not_stated.items()
        )
        Output().print(
            Message(
                "The sheets say that these are not stated: {named}. State them in the design, or on the paper.",
                named=named,
            )
        )


def stem_of(names: Collection[str]) -> str:
    """The words that all names of files begin with; it stands above their table, which then fits a narrow terminal."""
    first, last = min(names), max(names)
    same = takewhile(lambda letters: letters[0] == letters[1], zip(first, last, strict=False))
    return "".join(letter for letter, _ in same).rpartition("_")[0]


def drawings(written: "Written", out: Path) -> None:
    """Print each drawing with its sheet, and what else was written."""
    stem = stem_of([file.name for file in written])
    rows = [(file.name.removeprefix(stem), *(file.readings or ("", "", ""))) for file in written]
    heading(out, stem)
    heads = (Message("file"), Message("sheet"), Message("scale"), Message("dimensions"))
    sheet(Sheet("drawings", "", heads, tuple(rows)), gap=False)
    _omitted(written)
    _not_stated(written)
