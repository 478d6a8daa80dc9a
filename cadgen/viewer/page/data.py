"""The page's data as one JSON document with a version, and the block of arrays that it points into."""

import json

import numpy as np

from cadgen.figures import Facts
from cadgen.messages import CHINESE, shown
from cadgen.verdict import Readiness
from cadgen.viewer.page.document import Arm, Chart, Going, Page, Scene, Slide, Travel
from cadgen.viewer.page.mesh_block import ArrayBlock

FORMAT, VERSION = "cadgen-report", 1


def data_of(page: Page, level: int = 9) -> tuple[str, str]:
    """JSON document and block, both as text that can stand in HTML.

    Args:
        page: content of the page.
        level: of the compression, 1 to 9: how long it may look for repetitions.
    """
    block = ArrayBlock()
    document = Facts(
        format=FORMAT,
        version=VERSION,
        name=page.name,
        passed=page.readiness != Readiness.NOT_READY,
        scene=_scene(page.scene, block),
        charts=[_chart(chart, block) for chart in page.charts],
        marks=[Facts(kind=mark.kind, angle=mark.angle) for mark in page.marks],
    )
    text = json.dumps(document.json(), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    # So that no text of a design can end the element.
    return text.replace("<", "\\u003c"), block.text(level)


def both(text: str) -> list[str]:
    """A text in English and Chinese, as the page's script takes it."""
    return [str(text), shown(text, CHINESE)]


def _scene(scene: Scene, block: ArrayBlock) -> Facts:
    rod, car, travel = scene.follower, scene.car, scene.travel
    return Facts(
        base=scene.base,
        rod=rod and Facts(radius=rod.radius, length=rod.length, faces=rod.faces, height=rod.height, side=rod.side),
        unit=scene.unit,
        lift=Facts(lift=block.add(scene.lift.lift), tan=block.add(scene.lift.q)),
        travel=travel and _travel(travel, block),
        section=None if rod or scene.wheels else scene.section,
        slide=scene.guide if isinstance(scene.guide, Slide) else None,
        arm=scene.guide if isinstance(scene.guide, Arm) else None,
        stop=scene.stop,
        goings=[_going(going, block) for going in scene.goings],
        car=car and Facts(fork=car.fork, middle=car.middle, steering=car.steering),
        shafts=[
            Facts(
                label=both(shaft.label),
                axis=list(map(float, shaft.axis)),
                diameter=shaft.diameter,
                low=shaft.low,
                high=shaft.high,
                angle=float(shaft.angle),
                rate=shaft.rate,
                lead=float(shaft.lead),
                round=shaft.round,
            )
            for shaft in scene.shafts
        ],
        parts=[
            Facts(
                code=part.code,
                label=both(part.label),
                shaft=part.shaft,
                colour=part.colour,
                branch=part.branch and both(part.branch),
                apart=part.apart,
                near=part.near and both(part.near),
                mesh=block.mesh(part.shades[0]),
                coarse=block.mesh(part.shades[1]),
            )
            for part in scene.parts
        ],
        wheel=scene.wheel,
        wheels=[wheel.shaft for wheel in scene.wheels],
        drive=scene.drive,
        second=scene.second
        and Facts(
            section=scene.second.section,
            travel=_travel(scene.second.travel, block),
            arm=scene.second.arm,
            height=scene.second.height,
        ),
    )


def _travel(travel: Travel, block: ArrayBlock) -> Facts:
    return Facts(
        centre=travel.centre,
        ahead=block.add(travel.ahead),
        across=block.add(travel.across),
        turned=block.add(travel.turned),
    )


def _going(going: Going, block: ArrayBlock) -> Facts:
    """A run; angles and places in arrays of their own, the cam's angle as its lead over the motor."""
    return Facts(
        code=going.code,
        label=both(going.label),
        motor=block.add(going.motor),
        lead=block.add(going.cam_angle - going.motor),
        x=block.add(going.x),
        y=block.add(going.y),
        heading=block.add(going.heading),
        play=float(going.play),
    )


def _chart(chart: Chart, block: ArrayBlock) -> Facts:
    return Facts(
        code=chart.code,
        title=both(chart.title),
        unit=chart.unit,
        angle=block.add(np.degrees(chart.angle)),
        curves=[
            Facts(label=both(curve.label), values=block.add(curve.values), dashed=curve.dashed)
            for curve in chart.curves
        ],
        limits=[Facts(label=both(limit.label), value=limit.value) for limit in chart.limits],
    )
