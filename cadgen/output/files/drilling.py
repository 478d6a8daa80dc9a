"""Programs that drill the holes of a disc, one a drill, in plain moves: not every controller has drilling cycles."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, radians, tan
from pathlib import Path

from cadgen.car.running.friction import DiscMaterial
from cadgen.design.machining import Drilling, Machining
from cadgen.messages import Message
from cadgen.output.files.gcode import SETTINGS, comments, words, zero_note
from cadgen.parts.blank import Blank
from cadgen.parts.face import Face
from cadgen.parts.features import DFlat

# Cutting speeds of drills of high-speed steel, not cooled, m/min. The manual of the drill press J-2221VS (JET, p. 12)
# has 24-34 in mild steel and 61-91 in aluminium and brass, cooled; plastics are drilled slowly, since their chips melt.
_SPEEDS = {
    DiscMaterial.ALUMINIUM: 45.0,
    DiscMaterial.BRASS: 45.0,
    DiscMaterial.STEEL: 20.0,
    DiscMaterial.ACRYLIC: 30.0,
    DiscMaterial.PLA: 20.0,
    DiscMaterial.POM: 30.0,
}
_SLOWEST = DiscMaterial.STEEL  # for a material that is not known
_FEED_PER_TURN = 0.01  # of the diameter; the same manual has 0.025-0.05 mm below 3.2 mm and 0.05-0.1 mm up to 6.4 mm
_SPELLED = 4  # digits of a diameter in the name of a file


@dataclass(frozen=True, slots=True)
class Hole:
    """A hole to be drilled.

    Attributes:
        place: its centre, mm.
        top: height of the work above the disc's outer face there, mm.
        bottom: where it ends below, Z in mm.
    """

    place: tuple[float, float]
    top: float
    bottom: float


@dataclass(frozen=True, slots=True)
class Drill:
    """A drill with its holes, which are one program.

    Attributes:
        diameter: diameter of the drill, mm.
        purpose: what it drills, in words.
        holes: its holes.
    """

    diameter: float
    purpose: str
    holes: tuple[Hole, ...]

    def file_name(self, stem: str) -> str:
        """Name of its program."""
        return f"{stem}_drill_{self.diameter:.{_SPELLED}g}.nc"


def drills_of(blank: Blank, thickness: float, drilling: Drilling) -> tuple[Drill, ...]:
    """The drills for a disc, the bore's first; holes of the same diameter share theirs.

    Args:
        blank: bore, hub, holes and mark.
        thickness: thickness of the disc, mm.
        drilling: what the design asks for.
    """
    hub = blank.hub
    inner = hub.length if hub and hub.side == Face.INNER else 0.0
    widest = blank.bore_diameter - (2 * blank.key.depth if isinstance(blank.key, DFlat) else 0.0)
    bore = Hole((0.0, 0.0), hub.length if hub and hub.side == Face.OUTER else 0.0, -thickness - inner)
    ring, mark = blank.lightening, blank.mark
    every: list[tuple[float, str, tuple[Hole, ...]]] = [(drilling.bore_diameter_mm or widest, "bore", (bore,))]
    if ring:
        places = [(float(x), float(y)) for x, y in ring.centers()]
        every.append((ring.hole_diameter, "lightening holes", tuple(Hole(at, 0.0, -thickness) for at in places)))
    if mark:
        every.append((mark.diameter, "mark", (Hole(mark.centre, 0.0, -thickness),)))
    drills: dict[float, Drill] = {}
    for diameter, purpose, holes in every:
        other = drills.get(diameter)
        drills[diameter] = Drill(
            diameter,
            f"{other.purpose} and {purpose}" if other else purpose,
            (*other.holes, *holes) if other else holes,
        )
    return tuple(drills.values())


def point_length(diameter: float, drilling: Drilling) -> float:
    """Length of a drill's point, mm.

    Args:
        diameter: diameter of the drill, mm.
        drilling: keys of the drills.
    """
    return diameter / 2 / tan(radians(drilling.point_angle_deg) / 2)


def drill_feed(diameter: float, drilling: Drilling, material: DiscMaterial | None) -> tuple[float, float]:
    """Speed of the spindle, turns a minute, and feed downwards, mm/min, of a drill by its diameter, mm.

    Args:
        diameter: diameter of the drill, mm.
        drilling: keys of the drills.
        material: material of the disc; None if it is not known.
    """
    speed = _SPEEDS[material or _SLOWEST]
    spindle = drilling.spindle_rpm or round(1000 * speed / (pi * diameter))
    return spindle, drilling.feed_mm_per_min or round(_FEED_PER_TURN * diameter * spindle, 1)


def drill_assumption(diameter: float, drilling: Drilling, material: DiscMaterial | None) -> Message | None:
    """Sentence on the speed of a drill for a material that nobody has stated; None where the design says it.

    Args:
        diameter: diameter of the drill, mm.
        drilling: keys of the drills.
        material: material of the disc; None if it is not known.
    """
    if material is not None or drilling.spindle_rpm is not None:
        return None
    return Message(
        "material not stated: drilled as {assumed}, the slowest, at {spindle:g} turns a minute; state blank.material, "
        "or machining.drilling.spindle_rpm",
        assumed=Message(_SLOWEST.value),
        spindle=drill_feed(diameter, drilling, material)[0],
    )


def pecks(top: float, bottom: float, peck: float) -> list[float]:
    """Z at the end of each peck of a hole from its top to its bottom, mm; none is deeper than `peck`, but for the last.

    That takes what a step would leave of less than a hundredth.

    Args:
        top: height of the hole's top, mm.
        bottom: height of its bottom, mm.
        peck: greatest depth of a peck, mm.
    """
    floors, at = [], top
    while at > bottom:
        at = bottom if at - peck < bottom + 0.01 * peck else at - peck
        floors.append(at)
    return floors


def write_drilling(
    path: Path,
    drill: Drill,
    machining: Machining,
    drilling: Drilling,
    *,
    name: str,
    material: DiscMaterial | None = None,
    notes: Sequence[str] = (),
    face: Face = Face.OUTER,
) -> None:
    """Write the program of a drill: each hole in pecks, its whole diameter through the work.

    Args:
        path: file to write.
        drill: drill and holes.
        machining: heights.
        drilling: speed, feed, pecks and points of the drills.
        name: name of the design, for the first comment.
        material: material of the disc, for the speed; None if none is given.
        notes: further comments for the shop.
        face: face of the disc that lies up.
    """
    diameter = drill.diameter
    spindle, feed = drill_feed(diameter, drilling, material)
    assumed = drill_assumption(diameter, drilling, material)
    top = max(hole.top for hole in drill.holes)
    height = machining.safe_height_mm + top
    below = point_length(diameter, drilling) + machining.break_through_mm
    count = len(drill.holes)
    lines = [
        *comments(
            [
                *([assumed] if assumed else []),
                f"{name}: {drill.purpose}, {count} {'hole' if count == 1 else 'holes'}",
                *notes,
                f"drill of {diameter:g} mm, point {drilling.point_angle_deg:g} degrees; "
                f"{f'speed for {material}' if material and drilling.spindle_rpm is None else 'spindle'} {spindle:g}",
                zero_note(face),
                f"the point goes {below:.1f} mm below the work: leave room under it",
                f"the first move lifts the drill where it stands, to {height:g} mm: be above every clamp there",
                f"rapid moves go down to {machining.approach_mm:g} mm above the work",
            ]
        ),
        SETTINGS,
        f"S{spindle:g} M3",
        f"G0 {words(Z=height)}",
    ]
    peck = drilling.peck_mm or diameter
    for hole in drill.holes:
        x, y = hole.place
        lines += [f"G0 {words(X=x, Y=y)}", f"G0 {words(Z=hole.top + machining.approach_mm)}"]
        at = hole.top
        for floor in pecks(hole.top, hole.bottom - below, peck):
            if at < hole.top:
                lines += [
                    f"G0 {words(Z=hole.top + machining.approach_mm)}",
                    f"G0 {words(Z=at + machining.approach_mm)}",
                ]
            at = floor
            lines.append(f"G1 {words(Z=at)} F{feed:g}")
        lines.append(f"G0 {words(Z=height)}")
    lines += ["M5", "M30"]
    path.write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
