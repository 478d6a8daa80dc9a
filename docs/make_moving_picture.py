"""The moving picture of the README: a cam under its follower, two gears in mesh, a car on its path.

    python -m docs.make_moving_picture

Outlines, lift, ratio and path are those of the parts that cadgen makes; the file is an SVG that moves by itself.
"""

from pathlib import Path

import numpy as np

from cadgen import Design, Gear, GearPair
from cadgen.output.report.gear_pictures import outlines

TARGET = Path(__file__).parent / "pictures" / "moving.svg"
STEPS = 72  # places of the follower in a turn
SECONDS = 8  # of a turn of the cam, of the pinion's turns and of a lap
STEEL, DISC, GOLD, DARK = "#9fb3c8", "#4a7fb5", "#d9a441", "#243b53"


def path_of(points: np.ndarray, digits: int = 2) -> str:
    """Closed path of an SVG through points x + iy, y upwards."""
    return "M" + "L".join(f"{point.real:.{digits}f} {-point.imag:.{digits}f}" for point in points) + "Z"


def rotation(start: float, by: float) -> str:
    """Animation of a part that turns evenly about its origin, degrees, positive counterclockwise."""
    return (
        f'<animateTransform attributeName="transform" type="rotate" from="{-start:g}" to="{-start - by:g}" '
        f'dur="{SECONDS}s" repeatCount="indefinite"/>'
    )


def cam() -> str:
    """Draw the packaged roller cam, which turns under its roller."""
    design = Design.load("roller")
    made = design.cam()
    outline = made.curve.outline(2.0).points
    lift = made.lift(np.linspace(0.0, 2 * np.pi, STEPS + 1))
    radius, base = design.values.follower.radius_mm, design.values.cam.base_circle_radius_mm
    places = ";".join(f"0 {-(base + radius + one):.3f}" for one in lift)
    return f"""<g><path d="{path_of(outline[:, 0] + 1j * outline[:, 1])}" fill="{DISC}"/>
<circle r="8" fill="white"/><rect x="7" y="-2.5" width="3.3" height="5" fill="white"/>{rotation(90, -360)}</g>
<g><rect x="-5" y="0" width="10" height="70" transform="scale(1 -1)" fill="{STEEL}"/>
<circle r="{radius}" fill="{GOLD}"/><circle r="3" fill="{DARK}"/>
<animateTransform attributeName="transform" type="translate" values="{places}" dur="{SECONDS}s"
 repeatCount="indefinite"/></g>"""


def gears() -> str:
    """Draw a pair of gears in mesh."""
    pinion, wheel = (Gear(teeth=teeth, module=4.0, width=8.0, bore=teeth * 0.7) for teeth in (16, 32))
    pair = GearPair(pinion, wheel, backlash=0.2)
    drawn = []
    for part, colour, turn in zip(pair.computed.layout.parts, (GOLD, DISC), (-720, 360), strict=True):
        ((_, (section, *_)),) = outlines(part, 0.05)
        section = section - part.axis
        bore = f'<circle r="{part.blank.bore_diameter / 2}" fill="white"/>'
        drawn.append(
            f'<g transform="translate({part.axis.real:.2f} 0)"><g><path d="{path_of(section)}" fill="{colour}"/>{bore}'
            f"{rotation(0, turn)}</g></g>"
        )
    return "\n".join(drawn)


def car() -> str:
    """Draw the packaged figure 8 with a car on it."""
    planned = Design.load("figure_eight").simulate("optimized").computed.planned
    track = planned.drive_wheel[::16]
    scale = 150 / np.ptp(track[:, 0])
    points = (track - track.mean(axis=0)) * scale
    way = path_of(points[:, 0] + 1j * points[:, 1])
    return f"""<path d="{way}" fill="none" stroke="{STEEL}" stroke-width="2"/>
<g><path d="M12 0L-8 8L-8 -8Z" fill="{GOLD}" stroke="{DARK}" stroke-linejoin="round"/>
<animateMotion path="{way}" rotate="auto" dur="{SECONDS}s" repeatCount="indefinite"/></g>"""


def picture() -> str:
    """Put the three pictures beside each other."""
    return f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 250" role="img"
 aria-label="a cam under its follower, two gears in mesh, a car on its path">
<rect width="640" height="250" rx="8" fill="#f8fafc"/>
<g transform="translate(110 155)">{cam()}</g>
<g transform="translate(275 125)">{gears()}</g>
<g transform="translate(540 125)">{car()}</g>
</svg>
"""


if __name__ == "__main__":
    TARGET.write_text(picture(), encoding="utf-8")
