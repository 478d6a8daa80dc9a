"""Pictures: complete, the same bytes each time, and with the data that they claim to show."""

import re
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from cadgen.car.course.layout import Shape
from cadgen.car.running.run_errors import deflections
from cadgen.design.load import load_design
from cadgen.jobs.simulation import lift_picture, simulate
from cadgen.output.report import style
from cadgen.output.report.cam_pictures import events_picture, lift_of_cams
from cadgen.output.report.cars import FleetPicture, budget_picture, fleet_picture
from cadgen.output.report.style import save
from cadgen.output.report.tracks import ErrorLine, Field, TrackPanel, run_errors_picture, tracks_picture


def _panel(simulation):
    return TrackPanel(title="run", run=simulation.before)


@pytest.fixture(scope="module")
def simulation():
    return simulate(load_design("carbon_free_car"), "compensated")


@pytest.fixture
def figures(monkeypatch):
    """Figures as they stand when they are saved."""
    kept = []

    def keep(drawing, folder, name):
        with drawing as picture:
            kept.append(picture)
        return []

    monkeypatch.setitem(globals(), "save", keep)
    return kept


EDGE = np.array([[0.0, 0.0], [8000.0, 0.0], [8000.0, 8000.0], [0.0, 8000.0]])


def draw_all(simulation, folder):
    error = simulation.before_error
    lines = [ErrorLine(label="actual", at_play=error, at_ends=(error, error))]
    field = Field(edge=EDGE, obstacles=[Shape.disc((700.0, 1000.0), 50.0)], gates=[Shape(((0.0, 0.0), (0.0, 90.0)))])
    generator = np.random.default_rng(0)
    fleet = FleetPicture(
        title="fleet",
        along=generator.normal(0, 80, 500),
        across=generator.normal(0, 30, 500),
        gate_width=100.0,
        passed=0.9,
        shares={"steering_zero": 0.7, "play": 0.3},
    )
    return [
        *save(lift_of_cams(lift_picture(simulation)), folder, "lift"),
        *save(tracks_picture([_panel(simulation)], simulation.planned, field), folder, "tracks"),
        *save(run_errors_picture("errors", lines, simulation.cam.application.track.length), folder, "run"),
        *save(events_picture("events", {"actual": simulation.events}), folder, "events"),
        *save(fleet_picture(fleet), folder, "fleet"),
        *save(budget_picture("costs", {"taper": (65.0, 3.0), "start heading": (23.0, 23.0)}), folder, "budget"),
    ]


@pytest.mark.slow
@pytest.mark.long
def test_every_picture_has_both_formats_and_the_same_bytes_each_time(simulation, tmp_path):
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        names = draw_all(simulation, tmp_path / folder)
        assert len(names) == 12
    for name in names:
        first = (tmp_path / "a" / name).read_bytes()
        assert first == (tmp_path / "b" / name).read_bytes(), name
        assert first.startswith(b"\x89PNG" if name.endswith("png") else b"<?xml")
        assert not re.search(rb"20\d\d-\d\d-\d\d|/work|/tmp|/home", first), name


@pytest.mark.slow
def test_the_style_leaves_the_programs_own_settings_alone(simulation, tmp_path):
    import matplotlib as mpl

    with mpl.rc_context({"font.size": 31.0}):
        save(events_picture("events", {"actual": simulation.events}), tmp_path, "events")
        assert mpl.rcParams["font.size"] == 31.0


def test_axes_say_what_they_show_and_in_what_unit(simulation, figures, tmp_path):
    draw_all(simulation, tmp_path)
    assert len(figures) == 6
    for picture in figures:
        labels = [label for axes in picture.axes for label in (axes.get_xlabel(), axes.get_ylabel()) if label]
        print(labels)
        assert len(labels) >= len(picture.axes)
        assert any(re.search(r"\((°|mm|m)\)", label) for label in labels)


def test_the_bars_are_the_deflection_errors(simulation, carbon_free_car, figures, tmp_path):
    save(events_picture("events", {"actual": simulation.events}), tmp_path, "events")
    built = carbon_free_car
    wanted = deflections(built.lift, built.follower, built.car, built.track.length, simulation.play)
    axes, total = figures[0].axes
    heights = [bar.get_height() for bar in axes.patches]
    np.testing.assert_allclose(heights, np.degrees([event.deflection for event in wanted]), rtol=1e-9)
    assert total.patches[0].get_height() == pytest.approx(sum(heights))


def test_the_lines_are_the_tracks_of_the_wheels_in_metres(simulation, figures, tmp_path):
    panel = TrackPanel(title="run", run=simulation.before)
    save(tracks_picture([panel, panel], simulation.planned, Field()), tmp_path, "tracks")
    lines = {line.get_label(): line for line in figures[0].axes[1].lines}
    for label, wheel in (("drive wheel", "drive_wheel"), ("front wheel", "front_wheel"), ("right wheel", "idle_wheel")):
        np.testing.assert_allclose(lines[label].get_xydata(), getattr(simulation.before, wheel) / 1000)


def test_the_obstacles_stand_where_the_design_has_them(simulation, figures, tmp_path):
    field = Field(edge=EDGE, obstacles=[Shape.disc((700.0, 900.0), 50.0)])
    save(tracks_picture([_panel(simulation)], simulation.planned, field), tmp_path, "tracks")
    circle = figures[0].axes[0].patches[-1]
    assert circle.center == pytest.approx((0.7, 0.9))
    assert circle.radius == pytest.approx(0.05)


def test_a_lift_without_valleys_has_no_picture_of_one(simulation, figures, tmp_path):
    bare = replace(lift_picture(simulation), valley=None)
    save(lift_of_cams(bare), tmp_path, "lift")
    assert len(figures[0].axes) == 3


def test_colours_differ_in_lightness():
    """Contrast in grey: relative luminance of neighbours in a picture, at least 0.05 apart."""

    def luminance(color):
        red, green, blue = (int(color[at : at + 2], 16) / 255 for at in (1, 3, 5))
        return 0.2126 * red**2.2 + 0.7152 * green**2.2 + 0.0722 * blue**2.2

    for one, other in ((style.BEFORE, style.AFTER), (style.BLUE, style.ORANGE), (style.VERMILLION, style.ORANGE)):
        assert abs(luminance(one) - luminance(other)) > 0.05


@pytest.mark.slow
@pytest.mark.parametrize("arguments", [["optimize"], ["simulate", "--help"]])
def test_matplotlib_is_loaded_only_to_draw(arguments):
    script = (
        "import sys, atexit\n"
        "atexit.register(lambda: sys.stderr.write('LOADED ' + str('matplotlib' in sys.modules)))\n"
        "from cadgen.cli import main\n"
        "main()\n"
    )
    result = subprocess.run([sys.executable, "-c", script, *arguments], capture_output=True, text=True)
    assert result.returncode == 0
    assert result.stderr.endswith("LOADED False")


@pytest.mark.parametrize(("play_deg", "half_width"), [(0.0, 1.0), (0.1, 1.0), (0.738, 3.5 * 0.738)])
def test_the_lift_close_by_an_event_has_a_width_without_play_too(simulation, figures, tmp_path, play_deg, half_width):
    save(lift_of_cams(replace(lift_picture(simulation), play=np.radians(play_deg))), tmp_path, "lift")
    for axes in figures[0].axes[1:3]:
        for line in axes.lines:
            assert np.ptp(line.get_xdata()) == pytest.approx(2 * half_width)
            assert np.ptp(line.get_ydata()) > 1e-4
