"""`cadgen gear`, `cadgen pair` and `cadgen planetary`: gears by flags, without a design file."""

from __future__ import annotations

import json
import sys
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import replace
from math import degrees, radians
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
from click.core import ParameterSource

from cadgen.cli import help
from cadgen.cli.options import formats_option, out_option
from cadgen.errors import DesignError
from cadgen.figures import Sheet
from cadgen.figures import as_json as as_plain
from cadgen.gears.choices import HelixHand, ToleranceStandard
from cadgen.messages import Message, clauses

if TYPE_CHECKING:
    from cadgen import Gear, GearPair, Planetary, Written
    from cadgen.gears.shifts import Shifts

Command = Callable[..., Any]
_NOTHING = 1e-12  # a figure that is as near to zero is printed as 0
Named = dict[str, Any]  # arguments or figures by their names


def _whole(name: str, example: int) -> Callable[[str], int]:
    """Reader of a flag's whole number, whose refusal names one that is."""

    def integer(text: str) -> int:
        try:
            return int(text)
        except ValueError:
            raise click.UsageError(
                Message(
                    "--{name} is {given}; give a whole number, such as {example}",
                    name=name,
                    given=text,
                    example=example,
                )
            ) from None

    return integer


def _numbers(each: Callable[[str], Any], name: str, given: str | None) -> list[Any]:
    """Values of a flag, one for each gear, separated by commas."""
    if given is None:
        return []
    try:
        return [each(part.strip()) for part in given.split(",")]
    except ValueError:
        raise click.UsageError(
            Message(
                "--{name} is {given}; give {number}, or one for each gear with commas",
                name=name,
                given=given,
                number=Message("a whole number, such as 20") if each is int else Message("a number, such as 0.5"),
            )
        ) from None


_OF_ALL = ("module", "helix_angle", "pressure_angle")  # of gears in mesh, whose flags take one number


def _one_number(name: str, given: str | None, count: int) -> None:
    """Refuse a comma where one number is wanted, as a decimal comma is no separator of gears."""
    if given is None or "," not in given:
        return
    parts = [part.strip() for part in given.split(",")]
    point = ".".join(parts) if len(parts) == 2 and all(part.isdigit() for part in parts) else parts[0]
    gears = "" if count == 1 else Message("; gears in mesh have it in common")
    raise click.UsageError(
        Message(
            "--{name} is {given}; give one number, with a decimal point, such as {point}{gears}",
            name=name,
            given=given,
            point=point,
            gears=gears,
        )
    )


def _within(flag: str, low: float, high: float, read: Callable[[float], float]) -> Callable[[str], float]:
    """Reader of a flag's number within a range."""

    def number(text: str) -> float:
        try:
            value = float(text)
        except ValueError:
            raise click.UsageError(
                Message(
                    "{flag} is {given}; give one number from {low:g} to {high:g}, with a decimal point",
                    flag=flag,
                    given=text,
                    low=low,
                    high=high,
                )
            ) from None
        if not low <= value <= high:
            raise click.UsageError(
                Message("{flag} is {value:g}; give {low:g} to {high:g}", flag=flag, value=value, low=low, high=high)
            )
        return read(value)

    return number


# Flags of every gear: name, argument of `Gear`, how it is read, what it says.
_FLAGS: tuple[tuple[tuple[str, ...], str, Callable[[str], Any], str], ...] = (
    (("--module-mm", "--module"), "module", float, "Normal module, mm."),
    (("--width-mm", "--width"), "width", float, "Width of the face, mm."),
    (
        ("--helix-angle-deg", "--helix-deg"),
        "helix_angle",
        _within("--helix-angle-deg", 0, 45, radians),
        "Helix angle, degrees.",
    ),
    (
        ("--pressure-angle-deg",),
        "pressure_angle",
        _within("--pressure-angle-deg", 10, 35, radians),
        "Normal pressure angle, degrees.",
    ),
    (("--profile-shift",), "profile_shift", float, "Profile shift x, in modules, by ISO 21771 for a ring, too."),
    (("--addendum-factor",), "addendum", float, "Addendum h_aP*, in modules."),
    (("--bore-diameter-mm", "--bore"), "bore", float, "Diameter of the bore, mm; 0 for none."),
    (("--bore-flats",), "flats", int, "4 for a square bore, 6 for a hexagonal one; the bore is its size across flats."),
    (("--flat-across-mm",), "across", float, "Across the flat of a D-bore, mm, from the flat to the far side."),
    (("--grade",), "grade", int, "Tolerance grade of ISO 1328; 7 if left out."),
    (("--tip-chamfer-mm",), "tip_chamfer", float, "Leg of the chamfer at the tips, mm."),
)
_RING: tuple[tuple[tuple[str, ...], str, Callable[[str], Any], str], ...] = (
    (("--rim-mm", "--rim"), "rim", float, "Wall of a ring outside its roots, mm."),
    (("--cutter-teeth",), "cutter_teeth", int, "Teeth of the pinion cutter of a ring; 0 for roots that are arcs."),
    (("--root-radius-factor",), "root_radius", float, "Tip radius of that cutter, or of the arc, in modules."),
)


# Flags that say what becomes of the result, and nothing of the gears.
_ASIDE = ("out", "formats", "as_json", "toml", "force", "lang")


def _key(option: click.Parameter) -> str:
    """Key of a flag in a file: its longest name."""
    return max(option.opts, key=len).removeprefix("--").replace("-", "_")


def _from_file(context: click.Context, _argument: click.Parameter, file: str | None) -> None:
    """Take from a file what the flags do not say."""
    if file is None:
        return
    try:
        table = tomllib.loads(Path(file).read_text(encoding="utf-8")).get(str(context.info_name), {})
    except (OSError, UnicodeError, tomllib.TOMLDecodeError) as error:
        raise click.UsageError(Message("cannot read {file}: {error}", file=file, error=str(error))) from None
    options = {_key(each): each.name for each in context.command.params if each.name not in (*_ASIDE, "file")}
    for key in table:
        if key not in options:
            raise click.UsageError(
                Message("{file} has {key}, which is no flag of this command: remove it", file=file, key=key)
            )
    context.default_map = {options[key]: each if isinstance(each, bool) else str(each) for key, each in table.items()}


_FILE = click.argument("file", required=False, is_eager=True, expose_value=False, callback=_from_file)
_TOML = help.option(
    "--toml", is_flag=True, help="Print the file that says the same, which this command reads, and make nothing."
)


def _said() -> str:
    """File with the flags as they were given."""
    context = click.get_current_context()
    lines = [f"[{context.info_name}]"]
    for option in context.command.params:
        name = option.name or ""
        if name in (*_ASIDE, "file") or context.get_parameter_source(name) == ParameterSource.DEFAULT:
            continue
        value = context.params[name]
        try:
            text = str(float(value)) if "." in str(value) else str(int(value))
        except ValueError:
            text = json.dumps(value)
        lines.append(f"{_key(option)} = {str(value).lower() if isinstance(value, bool) else text}")
    return "\n".join(lines) + "\n"


def _gear_flags(command: Command) -> Command:
    """Flags of gears; several gears take values with commas."""
    for names, argument, _, said in reversed((*_FLAGS, *_RING)):
        command = help.option(*names, argument, default=None, metavar="NUMBER", help=said)(command)
    return command


def _gears(count: int, ring: int | None, values: Named, names: tuple[str, ...]) -> list[Named]:
    """Arguments of `Gear` for each gear by the flags; what is given once is for all of them, or for the ring."""
    from cadgen import DFlat, Flats

    arguments: list[Named] = [{} for _ in range(count)]
    for flags, argument, read, _ in (*_FLAGS, *_RING):
        if count == 1 or argument in _OF_ALL:
            _one_number(flags[0].removeprefix("--"), values[argument], count)
        given = _numbers(read, flags[0].removeprefix("--"), values.pop(argument))
        of_ring = any(argument == each[1] for each in _RING)
        wanted = [ring] if of_ring and ring is not None else list(range(count))
        if len(given) == 1:
            given *= len(wanted)
        if given and len(given) != len(wanted):
            raise click.UsageError(
                Message(
                    "{flag} has {found} values; give one, or {wanted} with commas",
                    flag=flags[0],
                    found=len(given),
                    wanted=len(wanted),
                )
            )
        for number, value in zip(wanted, given, strict=False):
            arguments[number][argument] = value
    for each, name in zip(arguments, names, strict=True):
        for needed in ("module", "width"):
            if needed not in each:
                raise click.UsageError(
                    Message("--{needed}-mm is missing: give it in mm, such as --{needed}-mm 1", needed=needed)
                )
        each["name"] = name
        flats, across = each.pop("flats", None), each.pop("across", None)
        if flats and across:
            raise click.UsageError(Message("--bore-flats and --flat-across-mm are both given; give one of them"))
        bore = each.get("bore", 0.0)
        if flats not in (None, 4, 6):
            raise click.UsageError(
                Message("--bore-flats is {flats}; give 4 for a square, or 6 for a hexagon", flats=flats)
            )
        if across and not bore / 2 < across < bore:
            raise click.UsageError(
                Message(
                    "--flat-across-mm is {across:g} in a bore of {bore:g} mm; give more than half of "
                    "--bore-diameter-mm and less than all of it, such as 4.5 in 5",
                    across=across,
                    bore=bore,
                )
            )
        if flats:
            each["keyway"] = Flats(count=flats)
        elif across:
            each["keyway"] = DFlat(depth=bore - across)
    return arguments


def _hands(first: str, count: int, ring: int | None) -> list[str]:
    """Hands of gears that mesh in a row: the next one opposite, a ring like its pinion."""
    other = HelixHand.LEFT.value if first == HelixHand.RIGHT else HelixHand.RIGHT.value
    hands = [first, other, first][:count]
    if ring is not None:
        hands[ring] = hands[ring - 1] if ring else hands[1]
    return hands


def _name(usual: str) -> Callable[[Command], Command]:
    return help.option("--name", default=usual, show_default=True, help="Name of the files.")


_HAND = help.option(
    "--hand",
    type=click.Choice([hand.value for hand in HelixHand]),
    default=HelixHand.RIGHT.value,
    show_default=True,
    help="Of the first gear's helix.",
)
_DOUBLE = help.option("--double", is_flag=True, help="The helix turns back at half the width.")
_OUT = out_option(default=Path("exports"), show_default=True, help="Folder for the files; it is made if need be.")
_JSON = help.option("--json", "as_json", is_flag=True, help="Print one JSON document instead of sentences.")
_FORCE = help.option("--force", is_flag=True, help="Export even if a check fails, and say so in the manifest.")


@help.command()
@_FILE
@help.option("--teeth", type=_whole("teeth", 20), required=True, help="Number of teeth.")
@help.option("--internal", is_flag=True, help="A ring with teeth inside.")
@_gear_flags
@_HAND
@_DOUBLE
@help.option(
    "--E-sn-um", "E_sn_um", type=float, default=None, help="Deviation of the tooth thickness, µm; below 0 thinner."
)
@_name("gear")
@_OUT
@formats_option("gear")
@_JSON
@_TOML
def gear(
    teeth: int,
    internal: bool,
    hand: str,
    double: bool,
    E_sn_um: float | None,
    name: str,
    out: Path,
    formats: str | None,
    as_json: bool,
    toml: bool,
    **values: Any,
) -> None:
    """Make one gear by flags: spur, helical or double helical, or a ring; with the sizes to measure it by."""
    if toml:
        click.echo(_said(), nl=False)
        return
    from cadgen import Gear
    from cadgen.cli import show

    (arguments,) = _gears(1, 0 if internal else None, values, (name,))
    made = Gear(
        teeth=teeth,
        internal=internal,
        hand=hand,
        double=double,
        thickness_deviation=None if E_sn_um is None else E_sn_um * 1e-3,
        **arguments,
    )
    with show.progress(not as_json) as progress:
        written = made.write(out, formats, progress=progress)
    if as_json:
        show.document(written.entry)
        return
    figures = {clauses(each.name, each.unit) if each.unit else each.name: each.value for each in made.figures.values()}
    _figures(Message("{name}, {teeth} teeth", name=made.name, teeth=teeth), figures)
    _files(written, out)
    show.verdict(True, Message("each file in {out} was read back", out=out), Message("make it"))


@help.command()
@help.option("--teeth", required=True, metavar="Z1,Z2", help="Teeth of pinion and wheel, such as 20,60.")
@help.option("--internal", is_flag=True, help="The wheel is a ring round the pinion.")
@_gear_flags
@_HAND
@_DOUBLE
@help.option(
    "--backlash-um",
    type=_within("--backlash-um", 0, 1e4, float),
    default=None,
    help="Backlash on the working pitch circles, µm.",
)
@help.option(
    "--backlash-deg",
    type=_within("--backlash-deg", 0, 45, float),
    default=None,
    help="Backlash as the free angle of the wheel, degrees.",
)
@help.option(
    "--centre-distance-mm", type=float, default=None, help="Distance of the axes, mm; that without play if left out."
)
@help.option("--bearing-span-mm", type=float, default=None, help="Between the bearings of a shaft, mm.")
@help.option("--propose-shifts", is_flag=True, help="Print profile shifts that suit the pair, and make nothing.")
@help.option("--least-land", type=float, default=0.2, show_default=True, help="Least tip land of these, in modules.")
@help.option(
    "--standard",
    type=click.Choice([each.value for each in ToleranceStandard]),
    default=ToleranceStandard.ISO.value,
    show_default=True,
    help="Of tolerances; free for none, as for sizes that ISO 1328 does not cover.",
)
@_name("pair")
@_OUT
@formats_option("train")
@_FORCE
@_JSON
@help.option("--toml", is_flag=True, help="Print the design file that says the same, and make nothing.")
def pair(
    teeth: str,
    internal: bool,
    hand: str,
    double: bool,
    backlash_um: float | None,
    backlash_deg: float | None,
    centre_distance_mm: float | None,
    bearing_span_mm: float | None,
    propose_shifts: bool,
    least_land: float,
    standard: str,
    name: str,
    out: Path,
    formats: str | None,
    force: bool,
    as_json: bool,
    toml: bool,
    **values: Any,
) -> None:
    """Make two gears in mesh by flags; what is given once is for both.

    Without a backlash the teeth are thinned for their tolerance grade. Nothing is exported and the exit code is 1 if a
    check fails, unless --force is given.
    """
    from cadgen import Gear, GearPair

    counts = _numbers(int, "teeth", teeth)
    if len(counts) != 2:
        raise click.UsageError(
            Message("--teeth is {given}; give {count} numbers with a comma, such as 20,60", given=teeth, count=2)
        )
    ring = 1 if internal else None
    arguments = _gears(2, ring, values, ("pinion", "wheel"))
    hands = _hands(hand, 2, ring)
    free = (
        dict.fromkeys(("f_pt", "F_beta", "F_r", "b_r", "F_i_radial"), 0.0)
        if standard == ToleranceStandard.FREE
        else None
    )
    common: Named = {
        "centre_distance": centre_distance_mm,
        "bearing_span": 60.0 if bearing_span_mm is None else bearing_span_mm,
        "centre_distance_deviation": 0.0 if free else None,
        "name": name,
    }
    teeth_of = [
        {"teeth": count, "internal": number == ring, "hand": of, "double": double, "tolerances": free}
        for number, (count, of) in enumerate(zip(counts, hands, strict=True))
    ]
    gears = [Gear(**own, **each) for own, each in zip(teeth_of, arguments, strict=True)]
    if backlash_um is not None and backlash_deg is not None:
        raise click.UsageError(Message("--backlash-um and --backlash-deg are both given; give one of them"))
    backlash = _backlash(gears, backlash_um, backlash_deg, common)
    if toml:
        GearPair(*gears, backlash=backlash, **common)  # refuses what no pair can be
        text = _pair_toml(gears, backlash_um, backlash_deg, centre_distance_mm, bearing_span_mm)
        click.echo(text.replace("[train]\n", '[train]\nstandard = "free"\n', 1) if free else text, nl=False)
        return
    if propose_shifts:
        bare = GearPair(*gears, backlash=backlash, **common | {"centre_distance": None})
        _proposals(bare.propose_shifts(centre_distance_mm, least_land), as_json)
        return
    made = GearPair(*gears, backlash=backlash, **common)
    play, along = made.plays, Message("with the pinion")
    (zone,), arc = made.computed.play.stages, made.cut.driven_pitch_radius * 1e3
    rows: Named = {
        Message("ratio"): str(made.ratio),
        Message("the wheel turns"): along if made.nominal.sense > 0 else Message("against the pinion"),
        Message("centre distance, mm"): made.axes_apart,
        Message("working pressure angle, degrees"): degrees(made.working_pressure_angle),
        Message("contact ratio"): made.contact_ratio,
        **({Message("overlap ratio"): made.overlap_ratio} if made.overlap_ratio else {}),
        Message("specific sliding of the pinion"): made.specific_sliding[0],
        Message("specific sliding of the wheel"): made.specific_sliding[1],
        Message("loss factor"): made.loss_factor,
        Message("play along the line of action, µm"): play.base * 1e3,
        Message("play normal to the flanks, µm"): play.normal * 1e3,
        Message("least play on the pitch circles, µm"): zone.B_min * arc,
        Message("play on the pitch circles as cut, µm"): play.pitch * 1e3,
        Message("greatest play on the pitch circles, µm"): zone.B_max * arc,
        Message("play as an angle of the pinion, degrees"): degrees(play.driver_angle),
        Message("play as an angle of the wheel, degrees"): degrees(play.driven_angle),
    }
    _make(
        made,
        Message("{name}, {teeth}", name=made.name, teeth=made.cut.label),
        rows,
        made.cut.notes(1),
        Message("make them"),
        out,
        formats,
        force,
        as_json,
    )


@help.command()
@_FILE
@help.option("--sun", type=_whole("sun", 18), required=True, help="Teeth of the sun.")
@help.option("--planet", type=_whole("planet", 27), required=True, help="Teeth of a planet.")
@help.option(
    "--ring", type=_whole("ring", 72), default=None, help="Teeth of the ring; sun and two planets together if left out."
)
@help.option("--planets", type=_whole("planets", 3), default=3, show_default=True, help="Number of planets.")
@help.option(
    "--held",
    type=click.Choice(["ring", "carrier", "sun"]),
    default="ring",
    show_default=True,
    help="What does not turn.",
)
@help.option("--unequal", is_flag=True, help="Let planets stand at the nearest angles at which they fit.")
@_gear_flags
@_HAND
@_DOUBLE
@help.option(
    "--backlash-um",
    type=_within("--backlash-um", 0, 1e4, float),
    default=None,
    help="Backlash of both meshes on their pitch circles, µm.",
)
@help.option(
    "--centre-distance-mm",
    type=float,
    default=None,
    help="Of the planets from the axis, mm; that without play if left out.",
)
@_name("planetary")
@_OUT
@formats_option("train")
@_FORCE
@_JSON
@_TOML
def planetary(
    sun: int,
    planet: int,
    ring: int | None,
    planets: int,
    held: str,
    unequal: bool,
    hand: str,
    double: bool,
    backlash_um: float | None,
    centre_distance_mm: float | None,
    name: str,
    out: Path,
    formats: str | None,
    force: bool,
    as_json: bool,
    toml: bool,
    **values: Any,
) -> None:
    """Make a planetary set by flags; what is given once is for all gears, with commas for sun, planet and ring.

    The ring's profile shift follows from the distance of sun and planets. Nothing is exported and the exit code is 1 if
    a check fails, unless --force is given.
    """
    if toml:
        click.echo(_said(), nl=False)
        return
    from cadgen import Gear, Planetary

    arguments = _gears(3, 2, values, ("sun", "planet", "ring"))
    for key in ("bore",):
        arguments[2].pop(key, None)
    arguments[2].pop("profile_shift", None)
    hands = _hands(hand, 3, 2)
    counts = (sun, planet, ring or sun + 2 * planet)
    one, two, three = (
        Gear(teeth=count, internal=number == 2, hand=of, double=double, **each)
        for number, (count, of, each) in enumerate(zip(counts, hands, arguments, strict=True))
    )
    made = Planetary(
        one,
        two,
        three,
        planets=planets,
        held=held,
        backlash=None if backlash_um is None else backlash_um * 1e-3,
        centre_distance=centre_distance_mm,
        equal=not unequal,
        name=name,
    )
    error = made.return_error
    bare = Message("give --bore-diameter-mm for sun and planets: without it no carrier holds them")
    rows: Named = {
        Message("ratio"): str(made.ratio),
        Message("centre distance, mm"): made.axes_apart,
        Message("teeth of the ring"): str(made.ring_teeth),
        Message("profile shift of the ring"): made.cut.ring.form.profile_shift,
        Message("gap between planets, mm"): made.cut.neighbour_gap,
        Message("least play, degrees"): degrees(error.least),
        Message("play as cut, degrees"): degrees(error.as_cut),
        Message("greatest play, degrees"): degrees(error.greatest),
    }
    _make(
        made,
        Message("{name}, {teeth}", name=made.name, teeth=f"{sun}/{planet}/{counts[2]}"),
        rows,
        made.notes,
        Message("make them") if arguments[1].get("bore") else bare,
        out,
        formats,
        force,
        as_json,
    )


def _backlash(gears: Sequence[Gear], in_um: float | None, in_deg: float | None, common: Named) -> float | None:
    """Backlash of a pair on the pitch circles, mm; None where it is left to the tolerances.

    Args:
        gears: pinion and wheel.
        in_um: backlash as asked for, µm.
        in_deg: free angle of the wheel as asked for, degrees.
        common: other arguments of the pair.
    """
    from cadgen import GearPair

    if in_deg is None:
        return None if in_um is None else in_um * 1e-3
    solid = (replace(gear, bore=0.0, keyway=None) for gear in gears)  # bores are judged by the teeth as cut
    return radians(in_deg) * GearPair(*solid, **common).nominal.driven_pitch_radius


def _make(
    made: GearPair | Planetary,
    title: Message,
    rows: Named,
    notes: tuple[str, ...],
    afterwards: Message,
    out: Path,
    formats: str | None,
    force: bool,
    as_json: bool,
) -> None:
    """Show a pair or a set, and write its files if it passes."""
    from cadgen.cli import show
    from cadgen.output.files.formats import TRAIN

    TRAIN.chosen(formats)
    with show.progress(not as_json) as progress:
        written = made.write(out, formats, force=force, progress=progress) if made.passed or force else None
    if as_json:
        show.document(made.facts() if written is None else written.entry)
    else:
        _figures(title, rows)
        show.sentences(notes)
        show.figures(Message("teeth in mesh, measured"), made.checks, gap=True)
        if written is not None:
            _files(written, out)
        if made.passed:
            passed = Message("every check holds, and each file in {out} was read back", out=out)
            show.verdict(True, passed, afterwards)
        else:
            failing = show.failed(made.checks)
            result = failing if force else Message("{failing}, so nothing was exported", failing=failing)
            show.verdict(False, result, Message("change the numbers as it is said above"))
    sys.exit(0 if made.passed or force else 1)


def _figures(title: Message, values: Named) -> None:
    """Print values by their names, with their units."""
    from cadgen.cli.show import sheet

    rows = [
        (key, f"{value if abs(value) > _NOTHING else 0.0:.6g}" if isinstance(value, float) else str(value))
        for key, value in values.items()
        if value is not None and not isinstance(value, dict | list)
    ]
    sheet(Sheet("figures", title, (Message("figure"), Message("value")), tuple(rows)), gap=False)


def _files(written: Written, out: Path) -> None:
    """Print each file with its size and what was read back."""
    from cadgen.cli.show import heading, sheet, size, stem_of

    stem = stem_of([file.name for file in written])
    rows = [(file.name.removeprefix(stem), size(file.bytes), *file.readings) for file in written]
    heading(out, stem)
    sheet(Sheet("files", "", (Message("file"), Message("size"), Message("read back")), tuple(rows), tail=1), gap=False)


def _proposals(shifts: tuple[Shifts, ...], as_json: bool) -> None:
    """Print the profile shifts that suit a pair."""
    from cadgen.cli import show

    if as_json:
        show.document({"proposals": [as_plain(each) for each in shifts]})
        return
    aims = {"no undercut": Message("no undercut"), "balanced sliding": Message("balanced sliding")}
    rows = tuple(
        (
            aims[each.aim],
            f"{each.driver:.4f}, {each.driven:.4f}",
            f"{each.centre_distance:.4f}",
            "{:.2f}, {:.2f}".format(*each.sliding),
            "{:.2f}, {:.2f}".format(*each.lands),
            f"{each.contact_ratio:.2f}",
        )
        for each in shifts
    )
    heads = (
        Message("aim"),
        Message("--profile-shift"),
        Message("a, mm"),
        Message("sliding"),
        Message("tip lands, modules"),
        Message("contact ratio"),
    )
    show.sheet(Sheet("shifts", Message("profile shifts that pass every check of the pair"), heads, rows))


def _pair_toml(
    gears: list[Gear],
    backlash_um: float | None,
    backlash_deg: float | None,
    centre_distance: float | None,
    bearing_span: float | None,
) -> str:
    """Design file of a pair that says what the flags say."""
    from cadgen import DFlat, Flats

    first = gears[0]
    for name in ("module", "pressure_angle", "helix_angle", "tip_chamfer"):
        if len({getattr(gear, name) for gear in gears}) > 1:
            raise DesignError("{name} differs from gear to gear, which a design file does not say: give one", name=name)
    lines = ["[train]", f"module_mm = {first.module!r}", f"width_mm = {first.width!r}"]
    lines.append(f"bearing_span_mm = {60.0 if bearing_span is None else bearing_span!r}")
    if first.helix_angle:
        lines.append(f"helix_angle_deg = {round(degrees(first.helix_angle), 9)!r}")
    if round(degrees(first.pressure_angle), 9) != 20.0:
        lines.append(f"pressure_angle_deg = {round(degrees(first.pressure_angle), 9)!r}")
    if first.tip_chamfer:
        lines.append(f"tip_chamfer_mm = {first.tip_chamfer!r}")
    lines += ["", "[[train.stages]]"]
    for key, value in (
        ("centre_distance_mm", centre_distance),
        ("backlash_um", backlash_um),
        ("backlash_deg", backlash_deg),
        ("double", "true" if first.double else None),
    ):
        if value is not None:
            lines.append(f"{key} = {value}")
    for role, gear in zip(("driver", "driven"), gears, strict=True):
        keys = [f"teeth = {gear.teeth}", f"width_mm = {gear.width!r}", f"grade = {gear.grade}"]
        if gear.profile_shift:
            keys.append(f"profile_shift = {gear.profile_shift!r}")
        if gear.addendum is not None:
            keys.append(f"addendum_factor = {gear.addendum!r}")
        if gear.helix_angle:
            keys.append(f'hand = "{gear.hand}"')
        if gear.internal:
            keys.append("internal = true")
            named = (
                ("rim_mm", gear.rim),
                ("cutter_teeth", gear.cutter_teeth),
                ("root_radius_factor", gear.root_radius),
            )
            keys += [f"{key} = {value!r}" for key, value in named if value is not None]
        lines.append(f"{role} = {{ {', '.join(keys)} }}")
    for place, gear in zip(("drive", "output"), gears, strict=True):
        if gear.bore:
            lines += ["", f"[train.{place}]", f"bore_diameter_mm = {gear.bore!r}"]
            if isinstance(gear.keyway, Flats):
                lines.append(f"bore_flats = {gear.keyway.count}")
            elif isinstance(gear.keyway, DFlat):
                lines.append(f"d_flat = {{ across_mm = {gear.bore - gear.keyway.depth!r} }}")
    return "\n".join(lines) + "\n"
