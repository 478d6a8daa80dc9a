"""`cadgen cam` as a user meets it: files that hold what they claim, or no files at all."""

import hashlib
import json
import os
import shutil
import signal

import pytest

from tests.cli.conftest import one_sentence
from tests.forks import MAIN

SUFFIXES = {".step", ".stl", ".3mf", "_arcs.dxf", "_spline.dxf", ".nc", ".xyz", ".csv"}


def contents(folder):
    return {file.name for file in folder.iterdir()}


def parts(folder):
    return json.loads((folder / "manifest.json").read_text())["parts"]


@pytest.fixture(scope="module")
def made(forks, tmp_path_factory):
    """Folders with the actual profile alone, and with the theoretical one beside it; what the first run printed."""
    folder = tmp_path_factory.mktemp("cam")
    env = {**os.environ, "COLUMNS": "80"}
    result = forks.run(MAIN, "cam", "--profile", "actual", "--out", "both/", cwd=folder, env=env)
    assert result.returncode == 1, result.stderr  # the cam is right, and with this train's play no car keeps the course
    shutil.copytree(folder / "both", folder / "one")
    beside = forks.run(MAIN, "cam", "--profile", "theoretical", "--out", "both", cwd=folder, env=env)
    assert beside.returncode == 0, beside.stderr
    return folder / "one", folder / "both", result.stdout


@pytest.mark.slow
def test_all_files_are_made_proved_and_recorded(made):
    folder, _, printed = made
    print(printed)
    assert max(map(len, printed.splitlines())) <= 80
    assert contents(folder) == {f"carbon_free_car_actual{s}" for s in SUFFIXES} | {"manifest.json"}
    part = parts(folder)["carbon_free_car_actual"]
    assert part["verdict"]["failed_checks"] == ["cars that keep the course"]
    assert part["verdict"]["readiness"] == "not-ready"
    for name, facts in part["files"].items():
        data = (folder / name).read_bytes()
        assert hashlib.sha256(data).hexdigest() == facts["sha256"]
        assert facts["lift_error_um"] <= facts["lift_limit_um"]
    assert part["files"]["carbon_free_car_actual.step"]["bytes"] <= 200_000
    assert part["versions"]["cadgen"]
    assert part["blend"]["from_cam_angle_deg"] == pytest.approx(348.0)


# A blank with all that a cam has beside its profile.
HUB = [
    part
    for text in (
        "blank.keyway=",
        "blank.d_flat.across_mm=7",
        "blank.hub.diameter_mm=20",
        "blank.hub.length_mm=8",
        "blank.hub.set_screw.hole_diameter_mm=2.5",
        "blank.hub.set_screw.height_mm=4",
    )
    for part in ("--set", text)
]


@pytest.fixture(scope="module")
def optimized(forks, tmp_path_factory):
    """Folder with the optimized profile on a blank with a hub."""
    folder = tmp_path_factory.mktemp("optimized")
    result = forks.run(MAIN, "cam", *HUB, "--out", "out", cwd=folder, env={**os.environ, "COLUMNS": "80"})
    assert result.returncode == 0, result.stderr
    return folder / "out"


@pytest.mark.slow
@pytest.mark.long
def test_the_same_design_gives_the_same_bytes(optimized, cadgen, tmp_path):
    cadgen("cam", *HUB, "--out", "out", code=0, fresh=True)
    assert contents(tmp_path / "out") == contents(optimized)
    for name in contents(optimized):
        assert (optimized / name).read_bytes() == (tmp_path / "out" / name).read_bytes(), name


@pytest.mark.slow
@pytest.mark.long
def test_a_failed_check_exports_nothing_unless_forced(cadgen, tmp_path):
    thick_walls = ("--set", "checks.min_wall_mm=50")
    result = cadgen("cam", "--profile", "actual", *thick_walls, "--out", "out", code=1)
    failing = "NOT READY: thinnest wall; cars that keep the course fail, so nothing was exported"
    assert failing in " ".join(result.stdout.split())
    assert not (tmp_path / "out").exists()
    # Every format of this cam is read back in tests/jobs/test_lift_errors.py.
    forced = ("--force", "--formats", "step,csv", "--json")
    result = cadgen("cam", "appendix_car", "--profile", "actual", "--out", "out", *forced, code=0)
    part = parts(tmp_path / "out")["appendix_car_actual_step_csv"]
    assert json.loads(result.stdout) == part
    assert part["passed"] is False
    failed = {check["name"] for check in part["checks"] if not check["passed"]}
    assert failed == {"lost lift, undercut", "convex radius, theory", "cars that keep the course"}
    cures = {cure["override"].partition("=")[0] for cure in part["cures"]}
    assert cures == {"path.spline", "follower.radius_mm", "cam.base_radius_mm", "checks.lost_lift_limit_um"}


@pytest.mark.slow
def test_a_cutter_too_large_leaves_out_only_the_program(cadgen, tmp_path):
    too_large = ("--set", "machining.cutter_diameter_mm=20")
    formats = ("--formats", "nc,dxf,csv")
    result = cadgen("cam", "--profile", "actual", *too_large, *formats, "--out", "out", "--force", code=0)
    assert "G-code left out: machining.cutter_diameter_mm is 20" in result.stdout
    (part,) = parts(tmp_path / "out").values()
    assert "choose a smaller cutter" in part["omitted"]["G-code"]
    assert set(part["files"]) == {f"carbon_free_car_actual{end}" for end in ("_arcs.dxf", "_spline.dxf", ".csv")}
    assert contents(tmp_path / "out") == {*part["files"], "manifest.json"}


@pytest.mark.slow
def test_the_theoretical_profile(made):
    _, folder, _ = made
    part = parts(folder)["carbon_free_car_theoretical"]
    assert part["passed"] is True
    assert len(part["files"]) == 8


@pytest.mark.slow
def test_the_published_profile(cadgen, tmp_path):
    cadgen("cam", "--profile", "published", "--out", "out", "--force", code=0)
    part = parts(tmp_path / "out")["carbon_free_car_published"]
    assert part["passed"] is False
    assert len(part["files"]) == 8


@pytest.mark.slow
def test_parts_share_a_manifest_and_edited_files_drop_out(made, cadgen, tmp_path):
    """The run that comes after them writes its table alone, anew at its second time."""
    _, both, _ = made
    out = shutil.copytree(both, tmp_path / "out")
    assert set(parts(out)) == {"carbon_free_car_theoretical", "carbon_free_car_actual"}
    (out / "carbon_free_car_theoretical.nc").write_text("edited by hand")
    table = ("cam", "--profile", "actual", "--formats", "csv", "--out", "out", "--force")
    cadgen(*table, code=0)
    assert set(parts(out)) == {"carbon_free_car_actual", "carbon_free_car_actual_csv"}
    cadgen(*table, code=0)
    assert set(parts(out)) == {"carbon_free_car_actual", "carbon_free_car_actual_csv"}


@pytest.mark.slow
def test_a_hub_and_a_d_shaft(optimized):
    assert len(contents(optimized)) == 9


@pytest.mark.slow
def test_a_file_in_the_folders_place(cadgen, tmp_path):
    (tmp_path / "taken").write_text("")
    assert "choose another folder" in one_sentence(cadgen("cam", "--out", "taken/below", code=3))
    cadgen("cam", "--out", "taken", code=2)
    assert contents(tmp_path) == {"taken"}


@pytest.mark.slow
@pytest.mark.parametrize("limit", [300_000, 60_000, 20_000])
def test_a_full_disk_leaves_the_folder_as_it_was(cadgen, tmp_path, limit):
    """A limit on file size stands for the full disk: the write fails in the middle, in one format or another."""
    out = tmp_path / "out"
    out.mkdir()
    (out / "carbon_free_car_actual.step").write_text("an earlier part")

    small_files = (
        "import resource, signal\n"
        f"resource.setrlimit(resource.RLIMIT_FSIZE, ({limit}, {limit}))\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
    )
    result = cadgen("cam", "--profile", "actual", "--out", "out", code=3, script=small_files + MAIN)
    message = one_sentence(result)
    assert "nothing was written" in message
    assert contents(out) == {"carbon_free_car_actual.step"}
    assert (out / "carbon_free_car_actual.step").read_text() == "an earlier part"


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_an_interrupted_run_leaves_nothing(cadgen, tmp_path, number):
    """The signal comes when STL and 3MF stand in the staging folder and DXF is about to be written."""
    script = (
        "import os, signal\n"
        f"signal.signal({int(number)}, signal.SIG_DFL)\n"  # jobs in a background may ignore it
        "from cadgen.cli import main\n"
        "from dataclasses import replace\n"
        "from cadgen.output.files.formats import FORMATS\n"
        "dxf, here = FORMATS.kind_of('dxf'), os.getpid()\n"
        "def kill(cam, folder):\n"  # beside the process that makes STEP
        f"    os.kill(here, {int(number)})\n"
        "    yield from ()\n"
        "FORMATS._kinds['dxf'] = replace(dxf, cam=kill)\n"
        "main()\n"
    )
    result = cadgen("cam", "--profile", "actual", "--out", "out", code=130, script=script)
    assert result.stderr.strip() == "cadgen: interrupted: nothing was written"
    assert result.stdout == ""
    assert contents(tmp_path) == set()
