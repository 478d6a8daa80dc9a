"""Time at the feeds, against the moves of the programs as they are written."""

import re
from math import atan2, hypot, pi
from pathlib import Path

import numpy as np
import pytest

from cadgen.cam.followers.rod import LeaningRod
from cadgen.curves.contour import circle
from cadgen.design.machining import Drilling, Machining, Tabs
from cadgen.design.schema import Export
from cadgen.output.files.exports import CamExport
from cadgen.output.files.nc import drilling_minutes, milling_minutes, programs
from tests.output.files.test_drilling import BLANK


def minutes_of(program: Path) -> float:
    """Lengths of the moves G1, G2 and G3 of a program over their feeds."""
    at, feed, minutes = {"X": 0.0, "Y": 0.0, "Z": 0.0}, 0.0, 0.0
    for line in program.read_text().splitlines():
        words = {word[0]: float(word[1:]) for word in re.findall(r"[A-Z]-?[0-9.]+", re.sub(r"\(.*?\)", "", line))}
        start, feed = dict(at), words.get("F", feed)
        at.update({axis: words[axis] for axis in at if axis in words})
        match words.get("G"):
            case 1:
                length = hypot(*(at[axis] - start[axis] for axis in at))
            case 2 | 3:
                x, y = start["X"] + words["I"], start["Y"] + words["J"]
                turned = atan2(at["Y"] - y, at["X"] - x) - atan2(start["Y"] - y, start["X"] - x)
                # Equal ends make a whole turn.
                turned = (turned if words["G"] == 3 else -turned) % (2 * pi) or 2 * pi
                length = hypot(hypot(words["I"], words["J"]) * turned, at["Z"] - start["Z"])
            case _:
                continue
        minutes += length / feed
    return minutes


@pytest.mark.parametrize(
    ("machining", "ends"),
    [
        (Machining(), []),
        (Machining(cutter_teeth=3, step_down_mm=3.3, safe_height_mm=0.5, lead_radius_mm=1.0), []),
        # Bore and lightening holes are wider than the cutter, and milled; the mark is drilled.
        (Machining(tabs=Tabs(), drilling=Drilling()), ["holes", "drill_3"]),
        (
            Machining(feed_mm_per_min=300.0, tabs=Tabs(count=4, height_mm=2.5), drilling=Drilling(peck_mm=0.7)),
            ["holes", "drill_3"],
        ),
        (Machining(drilling=Drilling(bore_diameter_mm=7.8)), ["holes", "drill_7.8", "drill_3"]),
        (Machining(cutter_diameter_mm=2.0, step_down_mm=0.4, drilling=Drilling()), ["holes"]),
        (Machining(cutter_diameter_mm=8.0, drilling=Drilling()), ["drill_8", "drill_6", "drill_3"]),
    ],
)
def test_the_time_is_that_of_the_moves(machining, ends, tmp_path):
    blank = BLANK
    cam = CamExport(
        stem="disc",
        description="",
        curve=circle((4.0, 3.0), 60.0).curve(),
        area=pi * 60.0**2,
        follower=LeaningRod(base_radius=60.0, inner=30.0, outer=33.0, radius=2.5),
        cam_angle=np.zeros(0),
        blank=blank,
        thickness=3.0,
        material="aluminium",
        notes=(),
        export=Export(arc_tolerance_um=0.1),
        machining=machining,
    )
    made = [each.name for each, _ in programs(cam, tmp_path, 0.1)]
    assert made == ["disc.nc", *(f"disc_{end}.nc" for end in ends)]
    outline, *drills = [minutes_of(tmp_path / name) for name in made]
    # The way along a tab is reckoned as straight: on this circle 0.003 mm of 7 are left out.
    close = 1e-5 if machining.tabs is None else 5e-5
    assert milling_minutes(120 * pi, machining, 3.0, "aluminium") == pytest.approx(outline, rel=close)
    assert drilling_minutes(blank, machining, 3.0, "aluminium") == pytest.approx(sum(drills), rel=1e-5)
