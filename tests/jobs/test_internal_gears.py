"""Internal gears from the design file to files that were read back, and refusals whose cure works."""

import re

import manifold3d
import numpy as np
import pytest

from cadgen import Design, Gear, GearPair
from cadgen.car.assembly.turning_train import turning_train
from cadgen.errors import DesignError
from cadgen.geometry.meshes.teeth import section_of

RING = """
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 60.0

[[train.stages]]
driver = { teeth = 20 }
driven = { teeth = 60, internal = true }

[train.drive]
bore_diameter_mm = 5.0
"""


def design(text=RING):
    return Design.from_toml(text, "ring", train_only=True)


def changed(old, new):
    assert old in RING
    return design(RING.replace(old, new))


@pytest.mark.parametrize("stage", ["", "helix_angle_deg = 15.0\n"])
def test_a_pair_is_made_and_measured(stage, tmp_path):
    train = changed("driver = {", f"{stage}driver = {{").gears()
    assert train.passed
    assert train.layout.train.sense == 1
    assert "shortened to an addendum_factor" in "".join(train.notes)
    written = train.write(tmp_path, formats=["step", "csv"])
    (off,) = re.search(r"'play_error_um': \(([-.\de]+),\)", str(written.entry)).groups()
    assert abs(float(off)) < 0.06
    facts = written.entry["stages"][0]
    assert facts["reserve_involute_mm"] >= 0
    assert facts["reserve_trochoid_rad"] > 0


def test_a_ring_may_drive():
    text = RING.replace("driver = { teeth = 20 }", "driver = { teeth = 60, internal = true }")
    text = text.replace("driven = { teeth = 60, internal = true }", "driven = { teeth = 20 }")
    train = design(text.partition("[train.drive]")[0]).gears()
    assert train.passed
    assert train.ratio == pytest.approx(1 / 3)


def test_a_ring_behind_a_stage_of_gears_side_by_side():
    more = RING.replace(
        "[train.drive]", "[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 40 }\n\n[train.drive]"
    )
    with pytest.raises(DesignError, match="make the stage of a ring the last one"):
        design(more).gears()
    first = RING.replace(
        "[[train.stages]]", "[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 40 }\n\n[[train.stages]]"
    )
    train = design(first).gears()
    assert train.passed
    assert train.layout.train.sense == -1


@pytest.mark.parametrize(
    ("old", "new", "said", "cure"),
    [
        (
            "internal = true",
            "internal = true, addendum_factor = 1.0",
            r"give the ring at most ([\d.]+)",
            "addendum_factor = {}",
        ),
        ("internal = true", "internal = true, cutter_teeth = 55", r"trims its tips; give (\d+)", "cutter_teeth = {}"),
        ("internal = true", "internal = true, rim_mm = 0.3", r"rim_mm of at least ([\d.]+)", "rim_mm = {}"),
        (
            "internal = true",
            "internal = true, root_radius_factor = 0.9",
            r"give at most ([\d.]+)",
            "root_radius_factor = {}",
        ),
        ("teeth = 60", "teeth = 24", r"give the ring at least (\d+) teeth", "teeth = {}"),
        ("teeth = 60", "teeth = 19", r"give the ring at least (\d+) teeth", "teeth = {}"),
        ("driver = {", "centre_distance_mm = 20.5\ndriver = {", r"give at most ([\d.]+)", "centre_distance_mm = {}"),
        ("driver = {", "centre_distance_mm = 15.5\ndriver = {", r"such as ([\d.]+)$", "centre_distance_mm = {}"),
    ],
)
def test_what_cannot_be_is_refused_with_a_value_that_can(old, new, said, cure):
    with pytest.raises(DesignError) as refused:
        changed(old, new).gears()
    (value,) = re.search(said, str(refused.value)).groups()
    wrong = new.removeprefix("internal = true, ").split("\n")[0]
    assert changed(old, new.replace(wrong, cure.format(value))).gears().passed


def test_a_ring_has_neither_bore_nor_hub():
    more = (
        "\n[train.output]\nhub = { diameter_mm = 20.0, length_mm = 5.0, set_screw_mm = 3.0 }\nbore_diameter_mm = 8.0\n"
    )
    with pytest.raises(DesignError, match=r"on shaft 2 \(output\), the ring .* remove bore_diameter_mm"):
        design(RING + more).gears()
    with pytest.raises(DesignError, match="remove hub"):
        design(RING + more.replace("bore_diameter_mm = 8.0\n", "").replace(", set_screw_mm = 3.0", "")).gears()
    with pytest.raises(DesignError, match=r"stages\.1\.driver\.rim_mm is a key of a ring: add internal = true"):
        changed("teeth = 20", "teeth = 20, rim_mm = 3.0")


def test_gears_from_python(tmp_path):
    pinion, ring = Gear(teeth=18, module=1, width=8), Gear(teeth=57, module=1, width=8, internal=True, rim=4)
    pair = GearPair(pinion, ring, backlash=0.08)
    assert pair.play == pytest.approx(0.08)
    assert pair.plays.base == pytest.approx(pair.plays.driven_angle * ring.base_diameter / 2)
    assert not pair.failed
    assert pair.build123d().volume == pytest.approx(sum(part.volume for part in pair.computed.layout.parts), rel=1e-6)
    ring.write(tmp_path, formats=["step"])
    with pytest.raises(DesignError, match="rim is given, which a ring has"):
        Gear(teeth=18, module=1, width=8, rim=4)


def test_a_ring_turns_with_its_pinion_on_the_page():
    """Parts at motor position 0 touch and do not overlap: pushed from one side, a little more from there overlaps."""
    first = "[[train.stages]]\ndriver = { teeth = 20 }\ndriven = { teeth = 40 }\n\n[[train.stages]]"
    layout = design(RING.replace("[[train.stages]]", first)).gears().layout
    drive, middle, outer = turning_train(layout, 0.0, 0.0).parts
    assert [drive.rate, middle.rate, outer.rate] == pytest.approx([6.0, -3.0, -1.0])

    def placed(wheel, turning, more=0.0):
        corners = section_of(wheel, 1e-5).corners.ravel()
        corners = np.conj(corners)[::-1] if turning.part.flipped else corners
        corners = corners * np.exp(1j * (turning.angle + more)) + turning.axis
        return manifold3d.CrossSection([np.column_stack([corners.real, corners.imag])])

    ring, pinion = outer.part.gears[0], middle.part.gears[1]
    pushed = [(placed(pinion, middle, more) - placed(ring, outer)).area() for more in (-1e-3, 0.0, 1e-3)]
    assert pushed[1] < 1e-6
    assert max(pushed[0], pushed[2]) > 1e-3
    assert min(pushed[0], pushed[2]) < 1e-6
