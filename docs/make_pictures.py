"""The pictures of the tutorial, drawn from the files that its commands write.

    python -m docs.make_pictures [FOLDER]

FOLDER is one in which the tutorial's commands were run; without it they are run first, in a folder that is removed
again, and the report's page is photographed, for which a Chromium is needed. What a picture shows is computed by the
program, or driven by the generator behind the camera's file (`docs/tutorial/make_camera.py`), which shares no code with
it.
"""

import subprocess
import sys
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from typing import Any

import numpy as np

from cadgen import Design, Report
from cadgen.output.report.style import AFTER, BEFORE, GREY, WANTED, figure
from docs.tutorial.make_camera import FAULTS, car_as_designed

HERE = Path(__file__).parent
PICTURES = HERE / "pictures"
NAMES = ("first_car", "first_path", "first_cam", "first_lift", "second_run", "laps")
DEG = np.pi / 180
# A curve that was drawn keeps its name in the SVG file, so that a test finds its points again.
CURVE = "curve-"
STEP_DEG = 0.5  # between the points of a run that is drawn
GREATEST_PLAY_DEG = 0.851  # of the figure 8's train
TURNED_TO_DEG = 130  # where the rod lies in the hollow of the cam
SETTLED_MS = 1500  # after which the assembly is drawn in full


def table(file: Path) -> dict[str, Any]:
    """Read the columns of a CSV file, numbers alone."""
    lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    rows = [line.split(",") for line in lines[1:]]
    numbers = {n: i for i, n in enumerate(names) if n not in ("face",)}
    return {name: np.array([float(row[i]) for row in rows]) for name, i in numbers.items()}


def real_run(cam: Path) -> Any:
    """Drive the car as it is with the cam of a contact table; its drive wheel as x + iy, every half degree."""
    contact, world = table(cam), car_as_designed()
    angle, tangent = contact["cam_angle_deg"], np.tan(contact["steering_deg"] * DEG)

    def tan_beta(theta: Any) -> Any:
        return np.interp(np.asarray(theta) / DEG, angle, tangent, period=360.0)

    driven = SimpleNamespace(lift=SimpleNamespace(q=tan_beta), car=world.car, track=world.track)
    return FAULTS.track(driven, np.arange(0.0, 360.0, STEP_DEG) * DEG)


def planned(until_deg: float) -> Any:
    """Places of the drive wheel on the planned track, as x + iy, up to a cam angle."""
    world = car_as_designed()
    share = np.arange(0.0, until_deg, STEP_DEG) / 360
    return np.array([complex(*world.track.position(float(arc))) for arc in share * world.track.length])


def ends(folder: Path, stop_deg: tuple[float, float]) -> tuple[float, float]:
    """How far the real car ends from the end of the path, mm: with the first cam, and with the second."""
    goal = planned(348.0 + STEP_DEG)[-1]
    off = []
    for name, stop in zip(("first_car_actual", "first_car_optimized"), stop_deg, strict=True):
        run = real_run(folder / "exports" / f"{name}.csv")
        at = np.arange(len(run)) * STEP_DEG
        off.append(float(abs(np.interp(stop, at, run.real) + 1j * np.interp(stop, at, run.imag) - goal)))
    return off[0], off[1]


def pictures(folder: Path) -> Iterator[tuple[str, Any]]:
    """Draw each picture; its style is in force until the next is asked for."""
    exports = folder / "exports"
    path, first = planned(348.5), real_run(exports / "first_car_actual.csv")[:697]
    second = real_run(exports / "first_car_optimized.csv")[:691]
    old, new = table(exports / "first_car_actual.csv"), table(exports / "first_car_optimized.csv")
    camera = table(folder / "camera.csv")
    design = tomllib.loads((folder / "first_car.toml").read_text(encoding="utf-8"))
    waypoints = np.array(design["path"]["waypoints_mm"]) / 1000

    with figure(8.0, 3.6) as picture:
        left, right = picture.subplots(1, 2, width_ratios=(1, 1.9))
        _cam(left, old, new)
        _runs(right, path, first, second)
        yield "first_car", picture
    with figure(6.4, 2.6) as picture:
        axes = picture.subplots()
        axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
        _curve(axes, "path", path.real / 1000, path.imag / 1000, color=WANTED, label="track of the drive wheel")
        axes.plot(*waypoints.T, "o", color=BEFORE, markersize=5, label="waypoints")
        _legend_above(axes)
        yield "first_path", picture
    with figure(4.4, 4.2) as picture:
        _cam(picture.subplots(), old, None)
        yield "first_cam", picture
    with figure(6.4, 2.6) as picture:
        axes = picture.subplots()
        _curve(axes, "first", old["cam_angle_deg"], old["lift_mm"], color=BEFORE, label="first cam")
        _curve(axes, "second", new["cam_angle_deg"], new["lift_mm"], color=AFTER, linestyle="--", label="second cam")
        axes.set(xlabel="cam angle, degrees", ylabel="lift, mm", xlim=(0, 360))
        axes.axvspan(348, 360, color=GREY, alpha=0.25, linewidth=0)
        axes.legend(loc="upper left")
        yield "first_lift", picture
    with figure(6.4, 3.0) as picture:
        axes = _runs(picture.subplots(), path, first, second)
        rows = slice(0, None, 6)
        keep = camera["cam_angle_deg"][rows] <= 348
        axes.plot(
            camera["x_mm"][rows][keep] / 1000,
            camera["y_mm"][rows][keep] / 1000,
            ".",
            color=BEFORE,
            markersize=3,
            label="as the camera saw it",
        )
        _legend_above(axes)
        yield "second_run", picture

    with figure(7.2, 3.6) as picture:
        _laps(*picture.subplots(1, 2, sharex=True, sharey=True))
        yield "laps", picture


def _laps(left: Any, right: Any) -> None:
    """Draw ten laps of the packaged figure 8 at the greatest play of its band, with the plain and the optimized cam."""
    # No brake, and no friction.
    free = {"mechanics": None, "blank.material": None, "optimize.hardware": None, "tolerances.start_gap_deg": None}
    simulation = Design.load("figure_eight", free).simulate("optimized", GREATEST_PLAY_DEG)
    runs = simulation.computed
    for axes, name, run, colour in (
        (left, "plain cam", runs.before, BEFORE),
        (right, "optimized cam", runs.after, AFTER),
    ):
        axes.set(title=f"{name}: ten laps", xlabel="x, m", aspect="equal")
        _curve(axes, f"lap-{name[:5]}", *(runs.planned.drive_wheel.T / 1000), color=WANTED, linewidth=2.5, alpha=0.3)
        _curve(axes, f"laps-{name[:5]}", *(run.drive_wheel[::4].T / 1000), color=colour, linewidth=0.7)
        for x in (-0.2, 0.2):
            axes.plot(x, 0.0, "o", color=GREY, markersize=3)
        axes.plot(*(run.drive_wheel[0] / 1000), "o", color=WANTED, markersize=4)
    left.set_ylabel("y, m")


def _curve(axes: Any, name: str, x: Any, y: Any, **how: Any) -> None:
    (line,) = axes.plot(x, y, **how)
    line.set_gid(CURVE + name)


def _legend_above(axes: Any) -> None:
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=4, fontsize=8, columnspacing=1.2)


def _runs(axes: Any, path: Any, first: Any, second: Any) -> Any:
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    for name, run, colour, style, label in (
        ("path", path, WANTED, "-", "path"),
        ("first", first, BEFORE, "-", "with the first cam"),
        ("second", second, AFTER, "--", "with the second cam"),
    ):
        _curve(axes, name, run.real / 1000, run.imag / 1000, color=colour, linestyle=style, label=label)
    _legend_above(axes)
    return axes


def _cam(axes: Any, old: dict[str, Any], new: dict[str, Any] | None) -> None:
    axes.set(aspect="equal", xlabel="x, mm", ylabel="y, mm")
    _curve(axes, "outline", old["x_mm"], old["y_mm"], color=BEFORE, label="first cam")
    if new:
        _curve(axes, "second", new["x_mm"], new["y_mm"], color=AFTER, linestyle="--", label="second cam")
    turn = np.linspace(0, 2 * np.pi, 181)
    axes.plot(70 * np.cos(turn), 70 * np.sin(turn), color=GREY, linewidth=0.8, linestyle=":", label="base circle")
    axes.plot(4 * np.cos(turn), 4 * np.sin(turn), color=WANTED, linewidth=1.0)
    middle = 70 + old["lift_mm"][0]
    axes.plot(middle + 2.5 * np.cos(turn), 2.5 * np.sin(turn), color=WANTED, linewidth=1.0, label="rod, at the start")
    axes.legend(loc="center", fontsize=7, bbox_to_anchor=(0.5, 0.3))


@contextmanager
def tutorial_run() -> Iterator[Path]:
    """Run the tutorial's commands in a folder of their own."""
    from tests.docs.blocks import DOCS, Workshop

    def cadgen(arguments: list[str], folder: Path) -> tuple[int, str]:
        done = subprocess.run([sys.executable, "-m", "cadgen", *arguments], cwd=folder, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    with TemporaryDirectory() as folder:
        Workshop.at(Path(folder), cadgen).run(DOCS / "tutorial.md")
        yield Path(folder)


def save(folder: Path, target: Path) -> None:
    """Draw the pictures of a tutorial's run as SVG files without dates."""
    target.mkdir(exist_ok=True)
    for name, picture in pictures(folder):
        picture.savefig(target / f"{name}.svg", metadata={"Date": None, "Creator": None})


def photograph_report(target: Path) -> None:
    """Write a picture of the report page of the packaged car as it opens, the cam turned to 130 degrees.

    Where there is no Chromium, pytest's own sentence says so.
    """
    from playwright.sync_api import sync_playwright

    from tests.viewer.page.chromium import ARGUMENTS, READY, chromium_path

    turn = "to => { angle.value = to; angle.dispatchEvent(new Event('input')) }"
    with TemporaryDirectory() as folder, sync_playwright() as playwright:
        (page_file,) = Report.of(Design.load("carbon_free_car")).write(folder)
        browser = playwright.chromium.launch(executable_path=chromium_path(), args=ARGUMENTS)
        page = browser.new_page(viewport={"width": 1280, "height": 720}, color_scheme="light")
        page.goto(page_file.path.as_uri() + "#lang=en")
        page.wait_for_selector(READY, state="attached")
        page.evaluate(turn, TURNED_TO_DEG)
        page.wait_for_timeout(SETTLED_MS)
        page.screenshot(path=target / "report.png")
        browser.close()


if __name__ == "__main__":
    if len(sys.argv) > 1:
        save(Path(sys.argv[1]), PICTURES)
    else:
        with tutorial_run() as here:
            save(here, PICTURES)
        photograph_report(PICTURES)
