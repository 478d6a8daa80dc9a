"""Gears with square, hexagonal and D-shaped bores: volumes by elementary geometry, files, plays, refusals."""

from math import acos, pi, sqrt, tan

import pytest
from click.testing import CliRunner

from cadgen import Design, DFlat, Flats, Gear, Hub, Keyway, SetScrew
from cadgen.cli import cli
from cadgen.errors import DesignError

PLAIN = {"teeth": 30, "module": 1, "width": 10}
TRAIN = """
[train]
module_mm = 1.0
width_mm = 8.0
bearing_span_mm = 60.0
[train.drive]
bore_diameter_mm = 5.0
d_flat = { across_mm = 4.5 }
joint = "d_flat"
joint_clearance_greatest_um = 25.0
[train.output]
bore_diameter_mm = 8.0
bore_flats = 6
[[train.stages]]
driver = { teeth = 20 }
driven = { teeth = 40 }
"""


@pytest.mark.parametrize(
    ("key", "area"),
    [
        (Flats(count=4), 64.0),
        (Flats(count=6), 32 * sqrt(3)),
        (DFlat(depth=1.0), 16 * (pi - acos(3 / 4)) + 3 * sqrt(16 - 9)),
    ],
)
def test_volume_of_a_bore_with_flats(key, area):
    bored, full = Gear(**PLAIN, bore=8, keyway=key), Gear(**PLAIN)
    assert full.volume - bored.volume == pytest.approx(10 * area, rel=1e-12)


@pytest.mark.parametrize(("key", "depth"), [(Flats(count=4), 8 / 2), (Flats(count=6), 8 / 2), (DFlat(depth=1.0), 3.0)])
def test_set_screw_opens_on_the_flat(tmp_path, key, depth):
    """The hole reaches from the flat to the hub's round: ∫ (√(R² − y²) − depth) dA. STEP has the same volume."""
    hub = Hub(diameter=16.0, length=8.0, set_screw=SetScrew(diameter=3.0, height=4.0))
    gear = Gear(**PLAIN, bore=8, keyway=key, hub=hub)
    solid = Gear(**PLAIN, bore=8, keyway=key, hub=Hub(diameter=16.0, length=8.0))
    count = 20000
    y = [1.5 * ((n + 0.5) / count * 2 - 1) for n in range(count)]
    removed = sum(2 * sqrt(2.25 - each**2) * (sqrt(64 - each**2) - depth) for each in y) * 3.0 / count
    assert solid.volume - gear.volume == pytest.approx(removed, rel=1e-5)
    (file,) = gear.write(tmp_path, "step")
    assert file.facts["volume_error_relative"] < 1e-6


def test_dxf_and_facts_have_the_flats(tmp_path):
    gear = Gear(**PLAIN, bore=8, keyway=Flats(count=6))
    (file,) = gear.write(tmp_path, "dxf")
    assert "LWPOLYLINE" in file.path.read_text()
    assert gear.facts()["bore_flats"] == 6
    assert Gear(**PLAIN, bore=5, keyway=DFlat(depth=0.5)).facts()["bore_across_flat_mm"] == 4.5


def test_corners_of_a_bore_stay_under_the_root():
    with pytest.raises(DesignError, match=r"bore that reaches to 9\.238 mm .* keep it within 7\.25 mm"):
        Gear(teeth=12, module=1, width=5, bore=8, keyway=Flats(count=6)).build123d()
    Gear(teeth=12, module=1, width=5, bore=7.25 * sqrt(3) / 2, keyway=Flats(count=6)).build123d()
    with pytest.raises(DesignError, match=r"at most 1\.5"):
        # A flat of a hexagon is across · tan 30° wide.
        Gear(
            **PLAIN,
            bore=4,
            keyway=Flats(count=6),
            hub=Hub(diameter=9, length=8, set_screw=SetScrew(diameter=2, height=4)),
        ).build123d()
    assert 4 * tan(pi / 6) - 0.8 == pytest.approx(1.509, abs=1e-3)


def test_a_design_says_flats_and_their_play(tmp_path):
    file = tmp_path / "flats.toml"
    file.write_text(TRAIN)
    train = Design.load(file, train_only=True).gears()
    assert [part.get("bore_flats") for part in train.facts()["parts"]] == [None, 6]
    # The lever of a D-flat is half of its width: 25 µm at a flat 2 mm off the axis of a shaft of 5 mm.
    (loose,) = train.loose
    assert loose.greatest == pytest.approx(2 * (acos(2 / 2.5) - acos(2.025 / 2.5)) / 2, rel=0.05)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ("train.drive.d_flat.across_mm=2", "d_flat.across_mm is 2; it must lie between 2.5 and 5"),
        ("train.output.bore_flats=5", "bore_flats is 5; it must be 4 for a square, or 6"),
        ("train.output.bore_diameter_mm=0", "train.output.bore_flats needs a bore: give train.output.bore_diameter_mm"),
        ("train.drive.bore_flats=4", "has d_flat and bore_flats, which exclude each other: remove train.drive.d_flat"),
    ],
)
def test_flats_that_do_not_fit_are_refused(tmp_path, change, says):
    file = tmp_path / "flats.toml"
    file.write_text(TRAIN)
    with pytest.raises(DesignError, match=says.replace("(", r"\(")):
        Design.load(file, [change], train_only=True)


def test_flags_of_flats(tmp_path):
    def run(*more):
        return CliRunner().invoke(cli, ["pair", "--teeth", "20,40", "--module", "1", "--width", "6", *more])

    said = run("--bore", "5,8", "--bore-flats", "4,6", "--toml").output
    assert "bore_flats = 4" in said
    assert "bore_flats = 6" in said
    assert "d_flat = { across_mm = 4.5 }" in run("--bore", "5", "--flat-across-mm", "4.5", "--toml").output
    for more, says in (
        (("--bore", "5", "--flat-across-mm", "2"), "give more than half of --bore-diameter-mm"),
        (("--bore", "5", "--bore-flats", "5"), "give 4 for a square, or 6 for a hexagon"),
        (("--bore", "5", "--bore-flats", "4", "--flat-across-mm", "4"), "give one of them"),
    ):
        failed = run(*more)
        assert failed.exit_code == 2
        assert says in failed.output


@pytest.mark.parametrize("key", [Flats(count=4), DFlat(depth=0.5), Keyway(width=1.0, depth=0.5)])
def test_flats_without_a_bore_are_refused(key):
    with pytest.raises(DesignError, match="and no bore; give bore_diameter_mm, such as 5"):
        Gear(**PLAIN, keyway=key).build123d()
