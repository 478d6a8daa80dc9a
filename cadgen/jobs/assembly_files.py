"""Files of a car put together: its assembly as STEP, the list of parts, its sheet, and the steps of its mounting."""

import csv
from collections.abc import Iterator
from dataclasses import asdict, replace
from functools import partial
from io import StringIO
from math import degrees, pi
from pathlib import Path

import numpy as np

from cadgen.car.assembly.car_parts import CarPart, Content, GroupKind, Supply
from cadgen.design.blank import TIGHT
from cadgen.design.drive import DriveKind
from cadgen.design.play import Braked
from cadgen.figures import Facts
from cadgen.geometry.meshes.car_meshes import Seen, seen
from cadgen.jobs.assembly_checks import assembly_verdict, centre_of_gravity
from cadgen.jobs.car_assembly import CarAssembly
from cadgen.jobs.car_frame import frame_in
from cadgen.jobs.drawings import Folder, title_of, write_sheet
from cadgen.jobs.part_drawings import drawn_here, part_sheets, part_stem
from cadgen.messages import Message, joined
from cadgen.output.drawing.assembly_sheet import (
    CarView,
    ListedPart,
    MountingStep,
    ShaftMounting,
    assembly_drawing,
    mounting_sheet,
)
from cadgen.output.drawing.sheet import LinearDimension, LineKind, Stroke, centre_cross, rounded
from cadgen.output.files.publisher import Artifact, Written, publish, require, text_file
from cadgen.parts.features import Keyway
from cadgen.processes import in_second_process
from cadgen.progress import Progress, silent

# Directions to the right, up and towards the viewer, in the frame of the car: x ahead, y down, z to the left.
_FROM_LEFT = np.array([[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
_FROM_ABOVE = np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]])
_CHORD = 0.05  # mm, of the lines on the sheet
_PLACE_MM = 1e-9  # of a part read back, off its place
_OF_PARTS = Message("see the parts")
_VOLUME = 1e-6  # share by which a volume read back may be off
_COLUMNS = (
    "number", "code", "name", "quantity", "material", "assumed", "supply", "standard_or_files", "mass_each_g", "mass_g"
)  # fmt: skip


def silhouettes(assembly: CarAssembly, cam_angle: float) -> dict[Message, tuple[Seen, ...]]:
    """Silhouettes of all parts by the name of the view, from the left and from above.

    Args:
        assembly: car put together.
        cam_angle: cam angle, rad.
    """
    looks = {Message("from the left"): _FROM_LEFT, Message("from above"): _FROM_ABOVE}
    fork = assembly.fork_angle(cam_angle)
    return {name: seen(assembly.parts, look, cam_angle, fork, _CHORD) for name, look in looks.items()}


def listed(assembly: CarAssembly) -> tuple[ListedPart, ...]:
    """List of parts, numbered."""
    return tuple(
        ListedPart(
            number=number,
            code=part.code,
            title=part.title,
            quantity=part.quantity,
            material=part.material,
            source=part_stem(assembly, part) if drawn_here(part) else part.standard,
            mass=part.each * part.quantity,
            drawn=bool(part.places),
        )
        for number, part in enumerate(assembly.parts, 1)
    )


def parts_csv(assembly: CarAssembly) -> str:
    """List of parts as CSV, with the mass of each, and of all of a row, g."""
    text = StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(_COLUMNS)
    for number, part in enumerate(assembly.parts, 1):
        rows.writerow(
            (
                number,
                part.code,
                part.title,
                part.quantity,
                part.material,
                "yes" if part.assumed else "no",
                part.supply,
                part_stem(assembly, part) if drawn_here(part) else part.standard,
                f"{part.each:.3f}" if part.each else "",
                f"{part.each * part.quantity:.3f}" if part.each else "",
            )
        )
    return text.getvalue()


def views_of(assembly: CarAssembly, cam_angle: float) -> tuple[CarView, CarView]:
    """Views from the left and from above, with the dimensions between axes.

    Args:
        assembly: car put together.
        cam_angle: cam angle, rad.
    """
    site, found = assembly.layout.site, assembly.layout.arrangement
    assert found is not None  # `put_together` refuses a car without an arrangement
    plain = [CarView(name=name, seen=found) for name, found in silhouettes(assembly, cam_angle).items()]
    left, _, right, _ = plain[0].bounds
    a, behind, floor, drop = -site.base_radius, site.behind, -found.height, -found.axes[0].imag
    deviation = assembly.layout.design.tolerances.base_radius_mm
    limits = f" ±{deviation:g}" if deviation else ""
    beside = 0.06 * (right - left)
    heights = tuple(
        LinearDimension(name=name, start=(at, floor), end=(x, y), at=(at, floor), angle=90.0)
        for name, at, x, y in (
            ("height of the camshaft", left - beside, a, 0.0),
            ("height of the rear axle", right + beside, behind, drop),
        )
    )
    axes = (
        LinearDimension(
            name="fork axis to camshaft", start=(a, floor), end=(0.0, floor), at=(a, floor - beside), suffix=limits
        ),
        LinearDimension(
            name="camshaft to rear axle", start=(0.0, floor), end=(behind, floor), at=(0.0, floor - beside)
        ),
    )
    ground = Stroke(np.array([[left, floor], [right, floor]]), LineKind.THIN)
    centres = tuple(centre_cross(beside, (x, y)) for x, y in ((0.0, 0.0), (behind, drop), (a, 0.0)))
    first = replace(
        plain[0], dimensions=(*heights, *axes), lines=(ground, *(each for pair in centres for each in pair))
    )
    left, _, right, _ = plain[1].bounds
    across = tuple(
        LinearDimension(name=name, start=(a, -site.fork), end=(x, -z), at=(at, -z), angle=90.0)
        for name, x, z, at in (
            ("drive wheel from the fork axis", behind, site.drive_wheel, right + beside),
            ("idle wheel from the fork axis", behind, site.idle_wheel, right + 0.5 * beside),
            ("disc's lower face from the fork axis", 0.0, 0.0, left - beside),
        )
    )
    return first, replace(plain[1], dimensions=across, lines=centre_cross(beside, (a, -site.fork)))


def mountings(assembly: CarAssembly) -> tuple[ShaftMounting, ...]:
    """Steps of mounting of every shaft, from the camshaft to the rear axle."""
    layout, shafts = assembly.layout, len(assembly.train.layout.on_shafts)
    place = None if layout.arrangement is None else layout.arrangement.place
    assert place is not None  # `put_together` refuses a car without an arrangement
    left, right = Message("from the left"), Message("from the right")
    near_side, far_side = (left, right) if place.towards < 0 else (right, left)
    tables = []
    for number in range(shafts, 0, -1):
        on = [part for part in assembly.parts if part.shaft == number and part.places]
        shaft = [part for part in on if part.order < 0]
        others = [(part, part.heights(part.places[0])) for part in on if part.order >= 0]

        def away(entry: tuple[CarPart, tuple[float, float]]) -> tuple[float, int]:
            """Order from the far plate to the disc's end, keys before what they hold."""
            part, (low, high) = entry
            return (low + high) / 2 * -place.towards, int(part.supply == Supply.MADE)

        least, most = sorted((place.near, place.far))
        inside = sorted((each for each in others if least < sum(each[1]) / 2 < most), key=away)
        outside = [each for each in others if each not in inside]
        beyond = sorted((each for each in outside if away(each)[0] > -place.near * place.towards), key=away)
        behind = sorted((each for each in outside if each not in beyond), key=away, reverse=True)
        steps = []
        for part in shaft:
            diameter = assembly.train.layout.on_shafts[part.shaft - 1].blank.shaft_diameter
            (bottom, top) = part.heights(part.places[0])
            size = Message("Ø{diameter:g} x {length}", diameter=diameter, length=rounded(top - bottom, 2))
            steps.append(MountingStep(part.title, "", "", size))
        for group, way in ((inside, near_side), (beyond, near_side), (behind, far_side)):
            steps += [
                MountingStep(
                    part.title,
                    way,
                    _place(assembly, part, (low, high)),
                    _remark(assembly, part),
                )
                for part, (low, high) in group
            ]
        name = shaft[0].title if shaft else Message("shaft {shaft}", shaft=number)
        tables.append(ShaftMounting(name, tuple(steps)))
    return tuple(tables)


def _place(assembly: CarAssembly, part: CarPart, ends: tuple[float, float]) -> str:
    """Place of a part along its shaft from the fork axis, to the left; of the disc that of its faces, with limits.

    Args:
        assembly: car put together.
        part: part on a shaft.
        ends: its heights, mm.
    """
    fork = assembly.layout.site.fork
    limits = ["", ""]
    if part.code == "cam-disc":
        (inner, outer), (near, far) = _faces(assembly)
        ends = (fork + inner, fork + outer)
        limits = [f" ±{each:g}" if each else "" for each in (near, far)]
        if inner > outer:
            ends, limits = ends[::-1], limits[::-1]
    low, high = (f"{rounded(end - fork, 2)}{limit}" for end, limit in zip(ends, limits, strict=True))
    return f"{low} … {high} mm"


def _faces(assembly: CarAssembly) -> tuple[tuple[float, float], tuple[float | None, float | None]]:
    """Places of the disc's inner and outer face to the left of the fork axis, and their half widths, mm."""
    keys, tolerances = assembly.layout.design.cam, assembly.layout.design.tolerances
    inner, outer = (assembly.layout.site.rod_side * face for face in keys.faces_mm)
    return (inner, outer), (tolerances.inner_face_mm, tolerances.outer_face_mm)


def loose_parts(assembly: CarAssembly) -> tuple[tuple[str, str, str, str], ...]:
    """Number in the list, name, quantity and place of every part that no view shows."""
    return tuple(
        (str(number), part.title, str(part.quantity), part.how)
        for number, part in enumerate(assembly.parts, 1)
        if not part.places
    )


def _remark(assembly: CarAssembly, part: CarPart) -> str:
    """Remark on a part: key, face, and what holds it."""
    left, right = Message("left"), Message("right")
    if part.code == "cam-disc":
        plan = assembly.cam
        # The files show the disc from +z, which points to the face seen; turned over it looks to the other side.
        side = right if assembly.layout.turned_over else left
        said: list[str] = [Message("face shown on its sheet to the {side}", side=side)]
        if isinstance(plan.made_blank.key, Keyway):
            said.append(Message("on its key"))
        holders = {each.code for each in assembly.parts} & {"sleeve-disc", "collar-disc"}
        if holders:
            said.append(
                Message("between sleeve and set collar") if len(holders) == 2 else Message("held by a set collar")
            )
        joint = plan.making.fit.joint
    elif part.code.startswith("gear-"):
        pieces = assembly.train.layout.pieces.on_shafts
        gear = next(each for each in pieces if part.code == f"gear-{each.name}".replace("_", "-"))
        said = []
        if gear.blank.hub is not None and gear.blank.hub.length and len(gear.gears) == 1:
            said.append(Message("hub to the {side}", side=right if gear.flipped else left))
        elif len(gear.gears) == 2:
            low, high = (getattr(each, "teeth", 0) for each in gear.gears)
            said.append(Message("{teeth} teeth to the {side}", teeth=high if high else low, side=left))
        if isinstance(gear.blank.key, Keyway):
            said.append(Message("on its key"))
        joint = assembly.train.making.shaft(part.shaft, len(assembly.train.layout.on_shafts)).fit.joint
        if gear.blank.hub is not None and gear.blank.hub.set_screw is not None:
            said.append(Message("set screw"))
        elif joint not in TIGHT:
            said.append(Message("a drop of adhesive against sliding"))
        if gear.joined_to:
            said.append(Message("with the gear beside it, angle between the teeth free"))
    else:
        return part.how
    if joint is not None:
        said.append(Message(str(joint)))
    return joined(said)


def mounting_notes(assembly: CarAssembly) -> Iterator[Message]:
    """Steps of the whole car, after the shafts."""
    site, layout, design = assembly.layout.site, assembly.layout, assembly.layout.design
    found, mechanics = layout.arrangement, design.mechanics
    assert found is not None  # `put_together` refuses a car without an arrangement
    yield Message("Left and right are those of the car as it drives. Places are mm to the left of the fork axis.")
    framed = any(part.group.kind == GroupKind.FRAME and part.places for part in assembly.parts)
    printed = framed and frame_in(layout).frame.printed is not None
    if printed:
        yield Message(
            "The walls stand on the base, so shafts come last: hold the gears between the walls, the lowest first, and "
            "push each shaft from the {side} through one wall, what its table has between them, and the other wall. "
            "What stands outside the walls comes after that.",
            side=Message("left") if site.idle_wheel < site.fork else Message("right"),
        )
        yield Message(
            "Then push the bearings over the ends of the shafts into their seats from outside, flush with the face "
            "that looks to the train, and bond them there. The rear axle goes through the wall beside the idle wheel, "
            "too."
        )
    else:
        if framed:
            yield Message(
                "Bond the bearings into their seats in plates, bracket and block before the shafts, flush with the "
                "face that looks to the train."
            )
        yield Message(
            "Put the gears of each shaft on in the order of its table, then all shafts into the {side} plate, the "
            "camshaft first, and the other plate over them. What stands outside the plates comes after that.",
            side=Message("right") if found.place.towards < 0 else Message("left"),
        )
    if framed and not printed:
        yield Message("Set the tabs of plates and brackets into the slots of the base, and screw all from below.")
    yield Message(
        "Bond each shaft into the inner ring of one of its bearings, of that nearest to the disc, and leave it free in "
        "the other one: it then cannot move along its axis."
    )
    yield _disc_note(assembly)
    if framed:
        drive = design.drive
        if drive is not None and drive.kind == DriveKind.MOTOR:
            yield Message("Motor: screw it to the base from below; its shaft drives the rear axle by belt or gears.")
        elif drive is not None:
            yield Message(
                "Weight: set the tubes over their holes in the base with the threaded rods in them, put the weight "
                "between them and the top plate on, and tighten the nuts under the base and over the plate. Screw the "
                "pulley's bracket on the plate; {how}.",
                how=assembly.part("drop-weight").how,
            )
        else:
            yield Message(
                "Drive: screw motor or weight on the holes for it in the base, if they suit it; it drives the rear "
                "axle."
            )
        yield Message(
            "Fork: bond the bearings into its block, screw the block on its platform, the platform on its spacers, and "
            "push the spindle through the bearings from above. Bond it into their inner rings while they are pressed "
            "together, then the bridge on its lower end, parallel to the rod."
        )
    else:
        yield Message("Fork: bond the spindle into its bridge, after its bearings.")
    yield Message(
        "Screw a cheek to either end of the bridge, and press the pin through cheeks and front wheel, which must run "
        "free. Glue the rod into the head of the spindle, parallel to the pin, its end {length} mm from the fork axis.",
        length=rounded(site.rod_length, 2),
    )
    deviation = design.tolerances.base_radius_mm
    within = (
        f"± {deviation:g} mm" if deviation else Message("what you choose, for tolerances.base_radius_mm states nothing")
    )
    if framed and frame_in(layout).frame.sizes.stem:
        yield Message(
            "Bond the micrometer head into its {holder}, its spindle towards the platform. Set the fork axis "
            "{distance} mm ahead of the camshaft with it, and tighten the screws of the platform; hold it within "
            "{within}.",
            holder=Message("wall") if printed else Message("bracket"),
            distance=rounded(site.base_radius, 3),
            within=within,
        )
    else:
        yield Message(
            "Set the fork axis {distance} mm ahead of the camshaft; hold it within {within}.",
            distance=rounded(site.base_radius, 3),
            within=within,
        )
    yield Message(
        "Leg spring: push it on the journal over the head of the spindle, one leg round the rod, the other behind "
        "{what}. It presses the rod on the disc with {force:g} N{where}.",
        what=Message("the block") if framed else Message("the frame"),
        force=1.0 if mechanics is None else mechanics.rod_force_N,
        where=Message(", which the design does not state") if mechanics is None else "",
    )
    if mechanics is not None and mechanics.drag_least_Nmm:
        yield Message(
            "Brake: bond the felt {where}. Set it by pieces of felt so that the camshaft takes {least:g} to {most:g} "
            "N·mm to turn, without the rod.",
            where=_felt_place(mechanics.drag_on, framed=framed, printed=printed),
            least=mechanics.drag_least_Nmm,
            most=mechanics.drag_greatest_Nmm or mechanics.drag_least_Nmm,
        )
    if mechanics is None or mechanics.greased:
        yield Message("Grease the rim of the disc and the rod.")
    yield from _slack_notes(assembly)
    start = degrees(assembly.fork_angle(0.0)) * site.rod_side
    yield Message(
        "Start: turn the drive forward until the ray of cam angle 0, the x axis of the disc's sheet, points to the "
        "rod. The front wheel then stands {angle:.2f}° to the {side}.",
        angle=abs(start),
        side=Message("right") if start > 0 else Message("left"),
    )
    yield Message(
        "Trim: after a trial run give cadgen adjust what it ended off; set the micrometer head and the rod's angle as "
        "it says, and run again."
    )


def _disc_note(assembly: CarAssembly) -> Message:
    """Where the disc's faces must stand from the fork axis, and what sets them."""
    places, widths = _faces(assembly)
    inner, outer = (
        f"{rounded(abs(at), 2)} ± {width:g}" if width else rounded(abs(at), 2)
        for at, width in zip(places, widths, strict=True)
    )
    return Message(
        "Disc: its inner face stands {inner} mm and its outer face {outer} mm to the {side} of the fork axis. Measure "
        "both from the spindle before the disc is {held}, and {how} until they do.{untold}",
        inner=inner,
        outer=outer,
        side=Message("left") if places[0] > 0 else Message("right"),
        held=Message("clamped") if _on_sleeve(assembly) else Message("fixed"),
        how=Message("fit the length of the sleeve") if _on_sleeve(assembly) else Message("move it"),
        untold=""
        if all(widths)
        else Message(" How far they may be off is not stated (tolerances.inner_face_mm, tolerances.outer_face_mm)."),
    )


def _on_sleeve(assembly: CarAssembly) -> bool:
    """Whether a sleeve sets the place of the disc."""
    return any(part.code == "sleeve-disc" for part in assembly.parts)


def _felt_place(braked: Braked, *, framed: bool, printed: bool) -> Message:
    """Place of the brake's felt."""
    if braked == Braked.SHAFT:
        return Message("round the camshaft, in a clip on the frame")
    if printed:
        return Message("on the face of the wall that looks to the disc, where it touches no hole of it")
    if framed:
        return Message("on the face of the bearing plate that looks to the disc, where it touches no hole of it")
    return Message("where it touches the face of the disc, and no hole of it")


def _slack_notes(assembly: CarAssembly) -> Iterator[Message]:
    """Steps before each start: the string wound, which turns the cam back, and then the slack taken up."""
    wheel, gap = assembly.use.drive_wheel, assembly.layout.design.tolerances.start_gap_deg
    found = assembly.layout.arrangement
    assert found is not None  # `put_together` refuses a car without an arrangement
    carried = frame_in(assembly.layout).frame.carried if assembly.layout.design.drive is not None else None
    if carried is not None and carried.body.fall and wheel.radius:
        turns = carried.body.turns
        angle = 360.0 * turns * 2 * pi * wheel.radius / wheel.turn
        yield Message(
            "Knot the string with the weight at its lowest and the drive wheel {turns:.1f} turns ahead of the start, "
            "which is {angle:.0f}° of the cam.",
            turns=turns,
            angle=angle,
        )
        yield Message(
            "Wind the string before each start: turn the drive wheel backwards by a little more than these {turns:.1f} "
            "turns, until the weight hangs {height:.0f} mm over the floor. The gears turn the cam back with it, by "
            "{angle:.0f}°, and stand on the wrong side of their play in the end.",
            turns=turns,
            height=found.height - carried.high,
            angle=angle,
        )
    wound = Message(
        "Take up the slack before each start: pushing the car back or turning the cam by hand opens the play."
    )
    if carried is not None and carried.body.fall:
        wound = Message(
            "Take up the slack before each start, after the string is wound: winding it, pushing the car back or "
            "turning the cam by hand opens the play again."
        )
    yield wound
    yield Message(
        "Turn the drive wheel forward until the cam moves, and never back after that. The teeth leave the cam "
        "{play:.2f}° of play, which must be used up before the start{within}.",
        play=degrees(assembly.train.return_error.as_cut),
        within=Message(" to within {gap:g}°", gap=gap) if gap else "",
    )


def sheet_notes(assembly: CarAssembly, mass: Content) -> Iterator[Message]:
    """Notes of the sheet: masses, and what is not drawn."""
    yield centre_of_gravity(assembly, mass)
    if assumed := [part for part in assembly.parts if part.assumed]:
        yield Message(
            "Materials that the design does not state are usual ones: {parts}.",
            parts=joined(str(number) for number, part in enumerate(assembly.parts, 1) if part in assumed),
        )
    yield Message("Parts without a balloon are not drawn: where they belong stands in the steps of mounting.")


def write_assembly(assembly: CarAssembly, out: Path, cam_angle: float = 0.0, progress: Progress = silent) -> Written:
    """Write the STEP file, list, sheet and mounting plan of a car; read all back, and publish all together or none.

    Args:
        assembly: car put together.
        out: folder for the files; it is made if need be.
        cam_angle: cam angle at which moving parts stand, rad.
        progress: function that is called with a few words on each step.

    Raises:
        FileError: a file cannot be written, or holds something else when it is read back.
    """
    folder, stem = Folder.at(out), f"{assembly.origin.name}_assembly"
    omitted: dict[str, str] = {}
    mass = assembly.balance(cam_angle)

    def files(staging: Path) -> Iterator[Artifact]:
        progress(Message("writing and reading back the assembly"))
        # 1.4 times as fast as one after the other: the kernel loads and writes while the sheets are drawn.
        with in_second_process(partial(_step_files, assembly, staging / f"{stem}.step", cam_angle)) as step:
            yield text_file(staging / f"{stem}_parts.csv", parts_csv(assembly))
            title = title_of(assembly.origin, assembly.train.title, Message("car, assembly"), _OF_PARTS, stem, folder)
            title = replace(title, finish=_OF_PARTS, document=Message("assembly drawing"))
            side, top = views_of(assembly, cam_angle)
            sheet = assembly_drawing(side, top, listed(assembly), tuple(sheet_notes(assembly, mass)), title)
            yield from write_sheet(staging, stem, sheet, omitted)
            mounting = f"{assembly.origin.name}_mounting"
            title = replace(
                title,
                part=Message("car, steps of mounting"),
                number=mounting,
                document=Message("assembly instructions"),
            )
            steps = mounting_sheet(mountings(assembly), loose_parts(assembly), tuple(mounting_notes(assembly)), title)
            yield from write_sheet(staging, mounting, steps, omitted)
            for number, drawn in part_sheets(assembly, folder):
                yield from write_sheet(staging, number, drawn, omitted)
            yield from step()

    return publish(
        stem,
        out,
        files,
        assembly.origin.entry() | assembly_facts(assembly, cam_angle),
        lambda _: Facts(**({"omitted": omitted} if omitted else {})),
    )


def assembly_facts(assembly: CarAssembly, cam_angle: float) -> Facts:
    """Parts, masses and places for JSON and manifests.

    Args:
        assembly: car put together.
        cam_angle: cam angle, rad.
    """
    mass, fork = assembly.balance(cam_angle), assembly.fork_angle(cam_angle)
    return Facts(
        cam_angle_deg=degrees(cam_angle),
        fork_angle_deg=degrees(fork),
        mass_g=mass.volume,
        centre_of_gravity_mm=mass.centre,
        checks=[Facts(**asdict(check), passed=check.passed) for check in assembly_verdict(assembly).checks],
        parts=[
            Facts(
                number=number,
                code=part.code,
                quantity=part.quantity,
                material=part.material,
                assumed=part.assumed,
                supply=part.supply,
                source=part_stem(assembly, part) if drawn_here(part) else part.standard,
                mass_each_g=part.each,
                moves_with=part.group.kind if part.group.kind != GroupKind.SHAFT else f"shaft-{part.group.number}",
                places=[np.round(place, 9).tolist() for place in part.placed(cam_angle, fork)],
            )
            for number, part in enumerate(assembly.parts, 1)
        ],
    )


def _step_files(assembly: CarAssembly, path: Path, cam_angle: float) -> list[Artifact]:
    """STEP files of the car and of its plain parts, read back by the kernel: names, places, faces, volumes."""
    from cadgen.geometry.solids.car_solids import car_bytes, car_solids, read_car
    from cadgen.geometry.solids.kernel import faces, volume
    from cadgen.geometry.solids.step import read_part, step_bytes

    fork = assembly.fork_angle(cam_angle)
    description = f"car, design {assembly.origin.content_hash[:12]}"
    solids = car_solids(assembly.parts, description)
    places = {part.code: part.placed(cam_angle, fork) for part in assembly.parts if part.code in solids}
    path.write_bytes(car_bytes(solids, places, path.stem, description))
    uses = read_car(path)
    whole = [
        (part, number, place) for part in assembly.parts for number, place in enumerate(places.get(part.code, ()), 1)
    ]
    names = [part.code if part.quantity == 1 else f"{part.code}-{number}" for part, number, _ in whole]
    require([use.name for use in uses] == names, path.name, Message("has other parts"))
    same = all(np.abs(use.transform - place).max() < _PLACE_MM for use, (*_, place) in zip(uses, whole, strict=True))
    require(same, path.name, Message("has parts at other places"))
    sound = all(
        use.bodies == 1 and use.faces == len(faces(solids[part.code].solid))
        for use, (part, *_) in zip(uses, whole, strict=True)
    )
    require(sound, path.name, Message("has parts with other faces"))
    off = max(
        abs(use.volume / volume(solids[part.code].solid) - 1)
        for use, (part, *_) in zip(uses, whole, strict=True)
        if use.volume is not None
    )
    require(off < _VOLUME, path.name, Message("has parts of other volumes"))
    readings = "", "", Message("{count} parts", count=len(uses))
    made = [Artifact(path.name, Facts(parts=len(uses), volume_error=off), readings)]
    for part in filter(drawn_here, assembly.parts):
        stem = part_stem(assembly, part)
        own = path.parent / f"{stem}.step"
        own.write_bytes(step_bytes(replace(solids[part.code], name=stem)))
        read, size = read_part(own), volume(solids[part.code].solid)
        alike = read.valid and read.bodies == 1 and abs(read.volume / size - 1) < _VOLUME
        require(alike, own.name, Message("is another solid"))
        made.append(Artifact(own.name, Facts(volume_mm3=read.volume)))
    return made
