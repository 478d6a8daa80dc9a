"""Point clouds: read as a CAD system reads them, and the table against closed forms."""

import csv

import numpy as np
import pytest

from cadgen import Design
from cadgen.cam.contact import roll
from cadgen.cam.followers.rod import LeaningRod
from cadgen.curves.closed import ClosedCurve, PieceSpan
from cadgen.curves.contour import Contour, circle
from cadgen.errors import FileError
from cadgen.laws.unit import TAN
from cadgen.output.files.tables import columns, contact_outline, contact_rows, read_csv, write_csv
from cadgen.output.files.xyz import read_xyz, write_xyz

TURN = 2 * np.pi


@pytest.mark.parametrize(("count", "bar_um"), [(3600, 0.2), (1200, 0.2), (720, 0.5)])
def test_the_rod_on_a_spline_through_the_points_gives_the_lift(count, bar_um, carbon_free_car, tmp_path):
    car = carbon_free_car
    path = tmp_path / "cam.xyz"
    write_xyz(path, car.actual.curve, count)
    angle = np.linspace(0, TURN, 7200, endpoint=False)
    lift = roll(read_xyz(path), car.follower, angle).lift
    error = np.abs(lift - car.follower.lift(car.lift.q(angle))).max() * 1e3
    print(f"{count} points: {error:.3f} um at lift, {path.stat().st_size} bytes")
    # 0.17 um of it is lost at the face changes, whatever the file.
    assert error <= bar_um


def test_the_cloud_is_closed_flat_even_and_has_every_corner(carbon_free_car, tmp_path):
    curve = carbon_free_car.actual.curve
    path = tmp_path / "cam.xyz"
    write_xyz(path, curve, 3600)
    lines = path.read_text().splitlines()
    assert lines[0] == lines[-1]
    assert all(len(line.split()) == 3 and line.endswith(" 0.000000") for line in lines)
    points = np.array([[float(word) for word in line.split()[:2]] for line in lines])
    assert len(points) == pytest.approx(3600, abs=40)
    for corner in curve.corners():
        assert np.abs(points - corner.point).max(axis=1).min() < 1e-6
    gaps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    usual = np.median(gaps)
    assert gaps.max() < 1.05 * usual
    assert gaps.min() > usual / 65
    off = np.linalg.norm(points, axis=1) - curve.radius(np.arctan2(points[:, 1], points[:, 0]))
    assert np.abs(off).max() < 1e-6


def test_a_spline_bulges_beside_a_corner_by_the_share_that_the_spacing_rests_on(tmp_path):
    # Even points on the two legs of a corner of 0.02 rad, an arc far away closing the loop. The spline's second
    # derivative there is sqrt(3) turn / step, and falls by sqrt(3) - 2 from point to point.
    step, turn = 0.1, 0.02
    legs = np.arange(0, 200) * step
    first = np.stack([legs - legs[-1] - step, np.zeros(200)], axis=1)
    second = np.append(legs, legs[-1] + step)[:, None] * [np.cos(turn), np.sin(turn)]
    far = np.stack([20 * np.cos(np.linspace(turn, np.pi, 400)), 20 * np.sin(np.linspace(turn, np.pi, 400))], axis=1)
    cloud = np.concatenate([first, second, far[1:]])
    path = tmp_path / "corner.xyz"
    np.savetxt(path, np.pad(cloud.round(9), ((0, 0), (0, 1))), fmt="%.9f")
    points = read_xyz(path, step=0.005).points
    beside = (np.abs(points[:, 0]) < 0.5) & (points[:, 1] < 0.1)
    x, y = points[beside].T
    bulge = np.abs(np.where(x < 0, y, y * np.cos(turn) - x * np.sin(turn))).max()
    u = np.linspace(0, 1, 1001)
    share = np.sqrt(3) / 6 * ((1 - u) - (1 - u) ** 3 + (np.sqrt(3) - 2) * (u - u**3)).max()
    assert share == pytest.approx(1 / 12, rel=0.03)
    assert bulge == pytest.approx(turn * step * share, rel=0.01)


@pytest.fixture(scope="module")
def eccentric():
    """A rod on a circle of radius 40 whose centre is 6 mm from the camshaft."""
    return circle((6.0, 0.0), 40.0).curve(), LeaningRod(base_radius=42.0, inner=30.0, outer=33.0, radius=2.5)


def test_the_table_of_an_eccentric_circle(eccentric, tmp_path):
    curve, follower = eccentric
    path = tmp_path / "cam.csv"
    angle = np.linspace(0, TURN, 360, endpoint=False)
    contact = roll(curve.outline(0.02), follower, angle)
    write_csv(path, curve, follower, contact)
    table = read_csv(path)
    assert tuple(table) == columns(TAN)
    assert table["cam_angle_deg"] == pytest.approx(np.arange(360), abs=1e-6)
    out = np.stack([table["x_mm"] - 6.0, table["y_mm"]], axis=1) / 40.0
    assert np.linalg.norm(out, axis=1) == pytest.approx(1.0, abs=1e-7)
    assert np.stack([table["normal_x"], table["normal_y"]], axis=1) == pytest.approx(out, abs=2e-6)
    assert table["radius_of_curvature_mm"] == pytest.approx(40.0, abs=1e-6)
    assert table["polar_radius_mm"] == pytest.approx(np.hypot(table["x_mm"], table["y_mm"]), abs=2e-6)
    polar = np.radians(table["polar_angle_deg"])
    assert np.cos(polar) * table["polar_radius_mm"] == pytest.approx(table["x_mm"], abs=2e-6)
    face = np.where(table["face"] == 0, follower.inner, follower.outer)
    assert table["lift_mm"] == pytest.approx(face * np.tan(np.radians(table["steering_deg"])), abs=1e-5)
    assert np.array_equal(table["face"] == 0, table["steering_deg"] >= 0)
    assert set(table["face"]) == {0.0, 1.0}
    # At the face plane the rod's section, seen from the contact, must look along the profile's normal.
    theta = np.radians(table["cam_angle_deg"])
    c, s = np.cos(theta), np.sin(theta)
    ahead, across = c * table["x_mm"] + s * table["y_mm"], c * table["y_mm"] - s * table["x_mm"]
    slope = np.tan(np.radians(table["steering_deg"]))
    to_axis = np.stack([(follower.base_radius + face * slope - ahead) / (1 + slope**2), -across], axis=1)
    along = np.stack(
        [c * table["normal_x"] + s * table["normal_y"], c * table["normal_y"] - s * table["normal_x"]], axis=1
    )
    turn = along[:, 0] * to_axis[:, 1] - along[:, 1] * to_axis[:, 0]
    assert np.abs(turn).max() < 2e-3  # the contact is read to a few um along the profile
    assert np.abs(table["pressure_angle_deg"]).max() < 15


def test_the_table_agrees_with_itself_and_with_the_lift(carbon_free_car, tmp_path):
    car = carbon_free_car
    path = tmp_path / "cam.csv"
    angle = np.linspace(0, TURN, 3600, endpoint=False)
    write_csv(path, car.actual.curve, car.follower, roll(car.actual.curve.outline(0.03), car.follower, angle))
    table = read_csv(path)
    theta = np.radians(table["cam_angle_deg"])
    wanted = car.follower.lift(car.lift.q(theta))
    assert np.abs(table["lift_mm"] - wanted).max() < 2e-4
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["face"] for row in rows} == {"inner", "outer"}
    assert len(rows) == 3600


@pytest.mark.slow
def test_straight_lines_through_the_table_give_the_lift_at_any_angle(appendix_car, tmp_path):
    """The 26 degrees of the hollow corner are one step of the even rows: a line across it stood 27 um high."""
    car, path, tolerance = appendix_car, tmp_path / "cam.csv", 2e-4
    rows = contact_rows(car.actual.curve, car.follower, 3600, tolerance)
    write_csv(path, car.actual.curve, car.follower, rows)
    table = read_csv(path)
    assert 3600 < len(table["lift_mm"]) < 3800
    assert (np.diff(table["cam_angle_deg"]) >= 0).all()
    theta = np.sort(np.concatenate([np.linspace(0, TURN, 7200), np.radians(np.linspace(135.0, 135.2, 400))]))
    lifts = [
        roll(one, car.follower, theta).lift for one in (contact_outline(table, 0.03), car.actual.curve.outline(0.015))
    ]
    error = np.abs(lifts[0] - lifts[1]).max() * 1e3
    print(f"table of the appendix's car as an outline: {error:.3f} um at lift, {len(table['lift_mm'])} rows")
    assert error < 0.4
    # On the corner all rows are contacts at one cam angle: the same lift, and the rod's own section between them.
    angles, counts = np.unique(table["cam_angle_deg"], return_counts=True)
    assert counts.max() > 4
    corner = table["cam_angle_deg"] == angles[np.argmax(counts)]
    assert np.ptp(table["lift_mm"][corner]) < 2e-6
    assert np.ptp(table["polar_angle_deg"][corner]) > 0.2


def test_points_closer_than_rounding_are_one(carbon_free_car, tmp_path):
    """A piece of a nanometre, as a slight kink has it, once made two equal neighbours at any number of points."""
    curve = carbon_free_car.actual.curve
    piece = curve.pieces[1]
    middle = (piece.start + piece.stop) / 2
    parts = (
        PieceSpan(piece, piece.start, middle),
        PieceSpan(piece, middle, middle + 1e-11),
        PieceSpan(piece, middle + 1e-11, piece.stop),
    )
    split = ClosedCurve((*curve.pieces[:1], *parts, *curve.pieces[2:]))
    for count in (360, 3600, 36000):
        write_xyz(tmp_path / "cam.xyz", split, count)
        cloud = np.loadtxt(tmp_path / "cam.xyz")
        assert np.linalg.norm(np.diff(cloud, axis=0), axis=1).min() > 4.9e-4
        read_xyz(tmp_path / "cam.xyz")


def test_a_straight_profile_has_an_empty_radius_of_curvature(tmp_path):
    square = np.array([[40.0, 40.0], [-40.0, 40.0], [-40.0, -40.0], [40.0, -40.0]])
    curve = Contour(square, np.zeros(4)).curve()
    follower = LeaningRod(base_radius=60.0, inner=30.0, outer=33.0, radius=2.5)
    write_csv(tmp_path / "square.csv", curve, follower, roll(curve.outline(0.05), follower, np.zeros(1)))
    assert np.isnan(read_csv(tmp_path / "square.csv")["radius_of_curvature_mm"]).all()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a b c\n", "not a table of numbers"),
        ("1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n", "not a closed cloud"),
        ("1 0 0\n0 1 2\n-1 0 0\n1 0 0\n", "not a closed cloud"),
        ("1 0\n0 1\n-1 0\n1 0\n", "not a closed cloud"),
        ("1 0 0\n0 1 0\n0 1 0\n-1 0 0\n1 0 0\n", "two equal neighbours"),
    ],
)
def test_a_damaged_cloud_is_refused(text, message, tmp_path):
    path = tmp_path / "cam.xyz"
    path.write_text(text)
    with pytest.raises(FileError, match=message):
        read_xyz(path)


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (lambda text: text.replace("lift_mm", "lift"), "has columns"),
        (lambda text: text[:-3], "not a complete table"),
        (lambda text: text.replace(",inner", ",middle", 1), "not a complete table"),
        (lambda text: text[:1000], "not a complete table"),
        (lambda text: "", "not a complete table"),
    ],
)
def test_a_damaged_table_is_refused(edit, message, eccentric, tmp_path):
    curve, follower = eccentric
    path = tmp_path / "cam.csv"
    write_csv(path, curve, follower, roll(curve.outline(0.1), follower, np.linspace(0, 6, 20)))
    path.write_text(edit(path.read_text()))
    with pytest.raises(FileError, match=message):
        read_csv(path)


def test_points_are_closer_where_the_outline_bends_within_their_distance(tmp_path):
    """A flat face: the radius falls from 150 to 7 mm and rises again within a millimetre of the outline."""
    cam = Design.load("flat").cam()
    angle = np.radians(np.arange(30.0, 60.0, 0.05))
    for bends, low, high in ((False, 0.2, 0.4), (True, 0.0, 0.05)):
        write_xyz(tmp_path / "cam.xyz", cam.curve, 3600, bends=bends)
        lift = roll(read_xyz(tmp_path / "cam.xyz", 0.02), cam.follower, angle).lift
        assert low <= np.abs(lift - cam.follower.lift(cam.motion.q(angle))).max() * 1e3 <= high
