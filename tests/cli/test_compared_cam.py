"""A measured cam of known motion: what differs, by lifts and by outlines of a generator of its own."""

import json
from dataclasses import replace

import numpy as np
import pytest

from cadgen import Design
from cadgen.cli import show
from cadgen.errors import DesignError, FileError
from tests.studies import worn_cams_truth as truth

TURN = 2 * np.pi
NOISE = 3e-3
TOML = """
[motion]
turns = "counterclockwise"
segments = [
    {{ to_{unit} = {height}, in_deg = 80.0, law = "polynomial_3_4_5" }},
    {{ dwell_deg = 50.0 }},
    {{ to_{unit} = 0.0, in_deg = 110.0, law = "modified_sine" }},
    {{ dwell_deg = 120.0 }},
]

[follower]
{follower}

[cam]
base_circle_radius_mm = 40.0
thickness_mm = 10.0
"""
SLIDE = TOML.format(unit="mm", height=14.0, follower='kind = "roller"\nradius_mm = 9.0\noffset_mm = 6.0')
ARM = TOML.format(
    unit="deg",
    height=10.0,
    follower='kind = "swinging_roller"\nradius_mm = 9.0\narm_mm = 70.0\ncentre_distance_mm = 90.0\nlifts = "against"',
)
ROLLER = truth.Follower("roller", {"radius_mm": 9.0, "offset_mm": 6.0}, 40.0)
SWINGING = truth.Follower(
    "swinging_roller", {"radius_mm": 9.0, "arm_mm": 70.0, "centre_distance_mm": 90.0, "lifts": "against"}, 40.0
)
THETA = np.arange(720) * TURN / 720


def cam_of(height: float) -> truth.Worn:
    return truth.Worn(
        (truth.Flank(0, 80, 0, height, "polynomial_3_4_5"), truth.Flank(130, 240, height, 0, "modified_sine"))
    )


def lifts(
    follower: truth.Follower, made: truth.Follower, *, phase: float = 0.0, **more: object
) -> dict[str, np.ndarray]:
    """Columns of lifts of a follower on the disc that was made for another, by brute force, with noise."""
    rng, slides = np.random.default_rng(1), follower.kind == "roller"
    disc = truth.dense(cam_of(14.0 if slides else np.radians(10.0)), made, 20_001)
    place = truth.dropped(disc, follower, THETA + phase, **more)  # type: ignore[arg-type]
    place = place + (NOISE if slides else NOISE / 70) * rng.standard_normal(len(THETA))
    name = "lift_mm" if slides else "lift_deg"
    return {"cam_angle_deg": np.degrees(THETA), name: place if slides else np.degrees(place)}


@pytest.mark.parametrize(
    ("keys", "code", "size"),
    [({"offset_mm": 6.2}, "offset", 0.2), ({}, "phase", np.radians(0.3)), ({}, "eccentricity", abs(0.05 + 0.02j))],
)
def test_lifts_on_a_slide_show_what_is_off(keys, code, size) -> None:
    """One deviation at a time, and no other is named."""
    other = replace(ROLLER, keys={**ROLLER.keys, **keys})
    columns = lifts(
        other,
        ROLLER,
        phase=size if code == "phase" else 0.0,
        shift=0.05 + 0.02j if code == "eccentricity" else 0j,
    )
    cam = Design.from_toml(SLIDE, "slide").compare_cam(columns)
    (found,) = cam.found
    assert found.code == code
    assert found.size == pytest.approx(size, rel=0.03)
    assert abs(found.size - size) < 5 * max(found.sigmas)
    assert cam.comparison.explained
    assert cam.readiness == "ready"


@pytest.mark.parametrize(("key", "code"), [("arm_mm", "arm"), ("centre_distance_mm", "centre_distance")])
def test_lifts_of_an_arm_show_its_dimensions(key, code) -> None:
    """The arm, or the place of its pivot."""
    other = replace(SWINGING, keys={**SWINGING.keys, key: SWINGING.keys[key] + 0.2})
    (found,) = Design.from_toml(ARM, "arm").compare_cam(lifts(other, SWINGING)).found
    assert found.code == code
    assert found.size == pytest.approx(0.2, abs=0.01)


def test_a_cam_as_designed_differs_in_nothing_and_one_wrong_side_up_is_said_to_be() -> None:
    """Lifts, of a disc that was keyed elsewhere when it was turned over."""
    design = Design.from_toml(SLIDE, "slide")
    same = design.compare_cam(lifts(ROLLER, ROLLER))
    assert same.found == ()
    assert same.readiness == "ready"
    over = design.compare_cam(lifts(ROLLER, ROLLER, mirrored=True, phase=1.0))
    assert over.comparison.mirrored
    assert over.comparison.after < 1.2 * over.comparison.noise
    assert over.readiness == "not-ready"


def outline(made: truth.Follower, *, centre: complex = 0j, mirrored: bool = False) -> dict[str, np.ndarray]:
    """Columns of an outline that was cut for a follower."""
    points = truth.outline(cam_of(14.0), made, 720, NOISE, np.random.default_rng(2), centre=centre, start=1.1)
    return {"x_mm": points[:, 0], "y_mm": points[:, 1] * (-1 if mirrored else 1)}


def test_an_outline_shows_disc_bore_and_what_it_was_cut_for(cadgen, tmp_path) -> None:
    """About the bore, clocked anyhow; by the command, and from Python."""
    design = Design.from_toml(SLIDE, "slide")
    larger = design.compare_cam(outline(replace(ROLLER, base=40.05)))
    assert [(each.code, round(each.size, 2)) for each in larger.found] == [("base_circle", 0.05)]
    (off,) = design.compare_cam(outline(ROLLER, centre=0.06 - 0.03j)).found
    assert (off.code, off.size) == ("eccentricity", pytest.approx(abs(0.06 - 0.03j), abs=2e-3))
    (cut,) = design.compare_cam(outline(replace(ROLLER, keys={**ROLLER.keys, "offset_mm": 6.4}))).found
    assert (cut.code, cut.size) == ("offset", pytest.approx(0.4, abs=0.04))
    assert design.compare_cam(outline(ROLLER, mirrored=True)).comparison.mirrored
    file, table = tmp_path / "slide.toml", tmp_path / "points.csv"
    file.write_text(SLIDE)
    columns = outline(replace(ROLLER, base=40.05))
    np.savetxt(table, np.stack(list(columns.values()), axis=1), delimiter=",", header="x_mm,y_mm", comments="")
    facts = json.loads(cadgen("calibrate", str(file), str(table), "--json", code=0).stdout)
    (found,) = facts["found"]
    assert (found["deviation"], found["unit"]) == ("base_circle", "um")
    assert found["size"] == pytest.approx(50, abs=1)
    said = cadgen("calibrate", str(file), str(table), "--out", str(tmp_path / "out"), code=0).stdout
    assert "disc all round" in said
    assert "READY" in said
    assert sorted(each.name for each in (tmp_path / "out").glob("slide_compared*")) == [
        "slide_compared.json",
        "slide_compared.txt",
    ]


def test_another_motion_is_not_explained() -> None:
    """A cam with another law on its rise, and a design of a car."""
    other = truth.Worn((truth.Flank(0, 80, 0, 14, "cycloidal"), truth.Flank(130, 240, 14, 0, "modified_sine")))
    each = truth.lifts(other, ROLLER, 720, NOISE, np.random.default_rng(3))
    cam = Design.from_toml(SLIDE, "slide").compare_cam({"cam_angle_deg": np.degrees(each[:, 0]), "lift_mm": each[:, 1]})
    assert not cam.comparison.explained
    assert not cam.comparison.mirrored
    assert cam.found == cam.comparison.worn == ()
    assert cam.readiness == "not-ready"
    with pytest.raises(DesignError, match="this one is of a car"):
        Design.load("carbon_free_car").compare_cam({"x_mm": [0.0], "y_mm": [0.0]})


@pytest.mark.parametrize("made", [ROLLER, replace(ROLLER, keys={**ROLLER.keys, "offset_mm": 6.3})])
def test_wear_of_a_flank_is_told_from_deviations(made, capsys) -> None:
    """By its lift alone, and beside an offset that the disc was cut for; a larger disc with an offset comes near."""
    rise, back = cam_of(14.0).flanks
    worn = truth.Worn((replace(rise, wear=lambda u: 0.03 * np.sin(np.pi * np.clip(u, 0, 1)) ** 2), back))
    if made == ROLLER:
        each = truth.lifts(worn, made, 720, NOISE, np.random.default_rng(4))
        columns = {"cam_angle_deg": np.degrees(each[:, 0]), "lift_mm": each[:, 1]}
    else:
        points = truth.outline(worn, made, 720, NOISE, np.random.default_rng(4), start=2.0)
        columns = {"x_mm": points[:, 0], "y_mm": points[:, 1]}
    cam = Design.from_toml(SLIDE, "slide").compare_cam(columns)
    assert [each.code for each in cam.found] == ([] if made == ROLLER else ["offset"])
    (flank,) = cam.comparison.worn
    assert np.degrees([flank.start, flank.stop, flank.cam_angle]) == pytest.approx([0, 80, 40], abs=8)
    assert flank.depth == pytest.approx(0.03, abs=4e-3)
    assert cam.comparison.explained
    assert cam.readiness == "not-ready"
    # An outline is as well explained by another roller with another offset, so that it is not sure.
    said = "is worn: " if made == ROLLER else "may be worn: then "
    assert f"{said}3" in str(cam) or f"{said}2" in str(cam)
    show.found(cam, written=False)
    assert f"NOT READY: a flank {said.partition(':')[0]}" in capsys.readouterr().out


def test_a_record_that_is_all_noise_explains_nothing() -> None:
    """A step of the dial, and no reading at all."""
    design, angle = Design.from_toml(SLIDE, "slide"), np.degrees(THETA)
    for lift in (10.0 * (angle > 100) * (angle < 200), np.zeros(len(angle))):
        cam = design.compare_cam({"cam_angle_deg": angle, "lift_mm": lift})
        assert not cam.comparison.explained
        assert cam.readiness == "not-ready"


@pytest.mark.parametrize("mirrored", [False, True])
def test_points_about_another_point_than_the_bore_are_refused_with_its_place(mirrored) -> None:
    """The shift is no wear; the bore of a disc off by less than a millimetre is measured as before."""
    points = outline(ROLLER, centre=20.0 - 7.0j, mirrored=mirrored)
    place = r"\(20, 7\)" if mirrored else r"\(20, -7\)"
    with pytest.raises(FileError, match=rf"the points lie about {place}, not about 0: put the bore at the origin"):
        Design.from_toml(SLIDE, "slide").compare_cam(points)
