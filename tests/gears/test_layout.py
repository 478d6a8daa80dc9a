"""Layout of a train: shafts that keep clear, teeth in phase, and what cannot be laid out."""

from dataclasses import replace
from math import cos, degrees, pi, radians

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from cadgen.errors import DesignError
from cadgen.gears.layout import Blanks, TrainLayout, lay_out
from cadgen.gears.pair import GradedGear
from cadgen.gears.spur import SpurPair
from cadgen.gears.tooth import GearForm
from cadgen.gears.train import Train, thinned
from cadgen.geometry.meshes.mesh import body_mesh
from cadgen.parts.blank import Blank
from cadgen.parts.features import Hub, Keyway, SetScrew

CLEARANCE = 0.3
COLLAR = Blank(bore_diameter=2.0, hub=Hub(diameter=6.0, length=1.0))
BLANKS = Blanks(
    drive=Blank(bore_diameter=3.0, hub=Hub(diameter=7.0, length=5.0, set_screw=SetScrew(diameter=1.6, height=2.5))),
    intermediate=COLLAR,
    output=Blank(bore_diameter=6.0, key=Keyway(width=2.0, depth=1.0), hub=Hub(diameter=12.0, length=4.0)),
)


def train(*stages: tuple[int, int], module: float = 0.5, **form: float) -> Train:
    pairs = []
    for teeth in stages:
        one, two = (GradedGear(form=GearForm(teeth=z, normal_module=module, width=4.0, **form)) for z in teeth)
        pairs.append(SpurPair(driver=one, driven=two, centre_distance=module * sum(teeth) / 2, bearing_span=60.0))
    return thinned(Train(tuple(pairs)))


def shared_volume(layout: TrainLayout) -> float:
    """Greatest common volume of two parts, by their meshes: another way to see a collision than discs."""
    solids = [body_mesh(part.body, 0.01).solid().transform(part.transform) for part in layout.parts]
    return max((a ^ b).volume() for i, a in enumerate(solids) for b in solids[i + 1 :])


def test_axes_stand_at_true_centre_distances_and_pairs_share_a_plane():
    given_train = train((30, 150), (40, 120), (40, 120))
    blanks = replace(BLANKS, intermediate=replace(COLLAR, bore_diameter=3.0))
    layout = lay_out(given_train, blanks, clearance=CLEARANCE)
    axes = [part.axis for part in layout.parts]
    assert np.abs(np.diff(axes)) == pytest.approx([45.0, 40.0, 40.0])
    for number, pair in enumerate(given_train.stages):
        driver, driven = layout.parts[number], layout.parts[number + 1]
        low = [
            part.height + (-part.starts[-1] - form.width if part.flipped else part.starts[place])
            for part, place, form in ((driver, -1, pair.driver.form), (driven, 0, pair.driven.form))
        ]
        assert low[0] == pytest.approx(low[1])


def test_no_two_parts_of_the_paper_s_train_share_volume():
    blanks = replace(BLANKS, intermediate=replace(COLLAR, bore_diameter=3.0))
    assert shared_volume(lay_out(train((30, 150), (40, 120), (40, 120)), blanks, clearance=CLEARANCE)) == 0.0


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(
    st.lists(st.tuples(st.integers(25, 40), st.integers(41, 90)), min_size=1, max_size=4),
    st.lists(st.none() | st.floats(-pi, pi), min_size=4, max_size=4),
)
def test_whatever_can_be_laid_out_is_free_of_collisions(stages, directions):
    made = train(*stages)
    wanted = tuple(directions[: len(stages)])
    try:
        layout = lay_out(made, BLANKS, wanted, CLEARANCE)
    except DesignError as error:
        if "collide" not in str(error) and "laid out" not in str(error):
            raise
        assume(False)
    assert shared_volume(layout) == 0.0
    for part, direction in zip(layout.parts[1:], wanted, strict=True):
        before = layout.parts[part.shaft - 2]
        if direction is not None:
            assert np.angle((part.axis - before.axis) * np.exp(-1j * direction)) == pytest.approx(0, abs=1e-9)


@pytest.mark.slow
@given(st.integers(8, 60), st.integers(8, 60), st.floats(-10, 10), st.floats(-10, 10))
def test_a_tooth_of_one_meets_a_space_of_the_other(z1, z2, angle, direction):
    """Counted from the line of centres, the driver's phase in pitches and the driven gear's add up to one half."""
    pair = train((z1, z2), module=2.0).stages[0]
    driven = pair.driven_angle(angle, direction)
    phases = z1 * (angle - direction) + z2 * (driven - direction - pi)
    assert cos(phases) == pytest.approx(-1.0, abs=1e-9)


def test_volume_less_the_set_screw_is_that_of_a_fine_mesh():
    """The drilled mesh is made by manifold3d; its chords leave it short by their tolerance times the walls."""
    for blank in (BLANKS.drive, replace(BLANKS.drive, key=Keyway(width=1.0, depth=0.6))):
        part = lay_out(train((30, 90)), replace(BLANKS, drive=blank)).parts[0]
        assert body_mesh(part.body, 1e-5).solid().volume() == pytest.approx(part.volume, abs=1e-5 * 500)
        assert part.body.prismatic_volume - part.volume > 1.0


def test_a_shaft_in_the_way_of_the_stage_before_is_refused():
    with pytest.raises(DesignError, match=r"the gear of 90 teeth on shaft 2 and shaft 3 itself collide.*smaller bores"):
        lay_out(train((30, 90), (30, 42)), BLANKS)


def test_wheels_that_rub_without_a_collar_are_refused():
    flush = replace(BLANKS, intermediate=Blank(bore_diameter=2.0, hub=Hub(diameter=6.0, length=0.1)))
    with pytest.raises(DesignError, match=r"gap between them is 0\.1 mm.*longer collar"):
        lay_out(train((20, 60), (20, 60)), flush)


def test_a_given_direction_that_collides_is_refused_and_another_found():
    made = train((20, 60), (20, 60))
    directions = lay_out(made, BLANKS).directions
    assert 90 < degrees(abs(directions[1] - directions[0])) < 180
    tighter = (0.0, directions[1] + radians(5.0))
    with pytest.raises(DesignError, match="collide"):
        lay_out(made, BLANKS, tighter)


def test_bearings_nearer_together_than_the_stack_is_high_are_refused():
    """Else the shafts would end inside the stack, and one through a wheel would not be seen."""
    made = train((20, 60), (20, 60))
    # Drive's hub 5, gears 4 with a collar of 1 between, output's hub 4.
    height = 5 + 4 + 1 + 4 + 4
    for span, refused in ((height, False), (height - 1e-3, True), (1e-300, True)):
        stages = (made.stages[0], replace(made.stages[1], bearing_span=span))
        if not refused:
            lay_out(replace(made, stages=stages), BLANKS)
            continue
        with pytest.raises(DesignError, match=r"in stage 2, the bearing span .* shorter than the stack.*least 18 mm"):
            lay_out(replace(made, stages=stages), BLANKS)


def test_a_shaft_through_a_wheel_is_seen_with_bearings_just_outside_the_stack():
    """The shaft of 8 mm and the wheel of 76 mm at axes 40 mm apart share 2 mm."""
    made = train((30, 150), (40, 120))
    tight = replace(made, stages=tuple(replace(pair, bearing_span=18.0) for pair in made.stages))
    blanks = replace(BLANKS, output=replace(BLANKS.output, bore_diameter=8.0))
    with pytest.raises(DesignError, match=r"the gear of 150 teeth on shaft 2 and shaft 3 itself.* is -2 mm"):
        lay_out(tight, blanks)


def test_axes_on_top_of_each_other_may_be_given_and_are_not_found():
    """A reverted train: the shafts on one axis end at their gears, with the collar between them."""
    made = train((30, 40), (30, 40), (30, 40))
    first, _, third, fourth = lay_out(made, BLANKS, (0.0, pi, None)).parts
    assert abs(first.axis - third.axis) < 1e-9
    assert third.height - first.height == pytest.approx(1.0)
    assert abs(fourth.axis - first.axis) > 1.0


def test_a_blank_that_cannot_be_made_names_its_shaft():
    with pytest.raises(DesignError, match=r"on shaft 3 \(output\), the gear with 60 teeth .* has a bore"):
        lay_out(train((20, 60), (20, 60)), replace(BLANKS, output=Blank(bore_diameter=29.0)))
    with pytest.raises(DesignError, match=r"on shaft 2 \(intermediate\), the collar of 6 mm stands in the teeth"):
        lay_out(train((20, 60), (12, 60)), BLANKS)


@pytest.mark.parametrize("clearance", [0.3, 0.9])
def test_the_clearance_is_kept_between_all_shafts(clearance):
    """Two wheels side by side on shafts one apart: folded until the next shaft clears the tips by that much."""
    layout = lay_out(train((20, 60), (20, 60)), BLANKS, clearance=clearance)
    first, _, third = layout.parts
    # The output's wheel and the drive's shaft share no stage: its tips pass the shaft.
    tips, shaft = layout.train.stages[1].driven.form.tip_diameter / 2, BLANKS.drive.bore_diameter / 2
    gap = abs(third.axis - first.axis) - tips - shaft
    assert gap >= clearance
    # One step of 5 degrees of a line of 20 mm is 1.7 mm.
    assert gap < clearance + 2.0
