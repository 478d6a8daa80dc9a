"""Helical trains from the design file to files that were read back, and refusals whose cure works."""

import json
import re

import pytest

from cadgen import Design
from cadgen.errors import DesignError

PAIR = """
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 60.0
helix_angle_deg = 20.0

[[train.stages]]
centre_distance_mm = 32.0
driver = { teeth = 20 }
driven = { teeth = 40, width_mm = 7.0 }
"""


SPUR = PAIR.replace("helix_angle_deg = 20.0", "").replace("32.0", "30.0")


def design(text=PAIR, *more):
    return Design.from_toml(text + "\n".join(more), "pair", train_only=True)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = tmp_path_factory.mktemp("helical")
    train = design(PAIR.replace("driver = ", "double = true\ndriver = ")).gears()
    return train, train.write(folder)


def test_a_double_helical_pair_is_made_and_measured_at_three_heights(written):
    train, files = written
    assert train.passed
    entry = files.entry
    stage = entry["stages"][0]
    assert stage["overlap_ratio"] == pytest.approx(3.5 * 0.3420201433 / 3.1415926536, rel=1e-9)
    assert stage["axial_force_per_tangential"] == 0.0
    assert stage["play_normal_um"] < stage["play_base_um"] < stage["play_pitch_circle_um"]
    assert "overlap ratio 0.38" in "".join(train.notes)
    text = json.dumps(entry)
    assert max(map(abs, map(float, re.findall(r'"play_error_um": \[([-.\de]+)\]', text)))) < 0.06
    assert "lead_error_um" in text


def test_hands_that_do_not_match_are_refused_with_a_hand_that_does():
    both = PAIR.replace("teeth = 20 }", 'teeth = 20, hand = "left" }')
    wrong = both.replace("teeth = 40,", 'teeth = 40, hand = "left",')
    with pytest.raises(DesignError, match=r'in stage 1, .* give the driven gear hand = "right"'):
        design(wrong).gears()
    assert design(both).gears().layout.train.stages[0].wheels[1].helix_angle > 0
    assert design(wrong.replace('40, hand = "left"', '40, hand = "right"')).gears().passed


def test_the_search_is_for_spur_gears_and_says_what_to_leave_out():
    with pytest.raises(DesignError, match=r"train\.stages\.1 has helical gears.* leave helix_angle_deg"):
        design().gears("search")
    assert design(SPUR).gears("search").passed


def test_hashes_do_not_know_of_keys_that_are_left_out():
    spur = design(SPUR).gears().origin.content_hash
    assert spur != design().gears().origin.content_hash
    # A pinned output, of the time before there were helical gears.
    assert spur == PINNED


PINNED = "6a4f79de6d4420b0e0a618669884c615665a5e35653e5a6530bc0e558dfe3446"
