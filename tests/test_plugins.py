"""Kinds from installed plug-ins, in processes of their own: found when they are needed, and never in the way."""

import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tests.conftest import TRICYCLE
from tests.forks import MAIN
from tests.plugins import install

ROOT = Path(__file__).parents[1]
LAW = """
import numpy as np
from cadgen.laws.law import MotionLaw
print("harmonic is loaded")
HARMONIC = MotionLaw(code="harmonic", meaning="Half a cosine.", jet=lambda u: np.stack(
    [(1 - np.cos(np.pi * u)) / 2, np.pi / 2 * np.sin(np.pi * u), np.pi**2 / 2 * np.cos(np.pi * u)], axis=1))
TWIN = MotionLaw(code="cycloidal", meaning="", jet=HARMONIC.jet)
NO_LAW = 7
"""
EFFECT = """
from cadgen.deviations import catalogue
from cadgen.deviations.catalogue import EffectOf
from cadgen.deviations.effect import Effect, Parameter
from cadgen.deviations.track import TRACK_EFFECTS
BENT = EffectOf(catalogue.TRACK, Effect(name="bent axle", stage=TRACK_EFFECTS[0].stage, act=TRACK_EFFECTS[0].act,
    parameters=TRACK_EFFECTS[0].parameters, separated_by="look at it"))
"""


def run(script: str, folder: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    """Run Python with a folder on its path."""
    env = {**os.environ, "PYTHONPATH": os.pathsep.join([str(folder), str(ROOT)])}
    return subprocess.run(
        [sys.executable, "-c", script, *arguments], env=env, capture_output=True, text=True, cwd=folder
    )


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "harmonic.py").write_text(LAW)
    return tmp_path


def test_a_kind_is_loaded_when_a_code_is_asked_for_that_the_package_does_not_have(folder):
    install(folder, "cadgen-harmonic", "1.2", {"cadgen.laws": {"harmonic": "harmonic:HARMONIC"}})
    script = """
from cadgen.laws.table import law_of
from cadgen.registry import used_plugins
law_of("cycloidal")
print("one of the package")
print(law_of("harmonic").meaning, dict(used_plugins()))
"""
    done = run(script, folder)
    told = ["one of the package", "harmonic is loaded", "Half a cosine. {'cadgen-harmonic': '1.2'}"]
    assert (done.stdout.splitlines(), done.stderr) == (told, "")


def test_processes_that_begin_anew_find_it_too(folder):
    install(folder, "cadgen-harmonic", "1.2", {"cadgen.laws": {"harmonic": "harmonic:HARMONIC"}})
    script = """
from cadgen.processes import WorkerProcess
from cadgen.laws.table import codes
if __name__ == "__main__":
    worker = WorkerProcess(anew=True)
    print(worker.submit(codes).result())
    worker.end()
"""
    (folder / "program.py").write_text(script)
    done = run("import runpy; runpy.run_path('program.py', run_name='__main__')", folder)
    assert "'harmonic')" in done.stdout, done.stderr


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        ("nowhere:KIND", "No module named 'nowhere'"),
        ("harmonic:TWIN", 'there is a motion law "cycloidal" already: choose another code'),
        ("harmonic:NO_LAW", "it brings int, and should bring MotionLaw"),
        ("harmonic:NOTHING", "has no attribute 'NOTHING'"),
    ],
)
def test_one_that_cannot_be_used_is_told_in_one_sentence(folder, value, reason):
    install(folder, "cadgen-broken", "0.1", {"cadgen.laws": {"broken": value}})
    install(folder, "cadgen-harmonic", "1.2", {"cadgen.laws": {"harmonic": "harmonic:HARMONIC"}})
    done = run("from cadgen.laws.table import codes; print(codes()); print(codes())", folder)
    assert done.stdout.count("'valve_lobe', 'harmonic')") == 2
    (line,) = done.stderr.splitlines()
    assert "the plug-in broken of cadgen-broken 0.1 (entry points cadgen.laws) cannot be used (" in line
    assert reason in line
    helped = run(MAIN, folder, "--help")
    assert (helped.returncode, helped.stderr) == (0, "")


def test_an_effect_is_looked_for_in_data_of_a_kind_of_the_package(tmp_path):
    (tmp_path / "bent.py").write_text(EFFECT)
    install(tmp_path, "cadgen-bent", "0.3", {"cadgen.effects": {"bent": "bent:BENT"}})
    script = """
from cadgen.inference.measurement.kinds import TRACK
print(TRACK.catalogue.named("bent axle").separated_by, "bent axle" in [e.name for e in TRACK.catalogue.effects])
"""
    assert run(script, tmp_path).stdout == "look at it True\n"


SPEAK = """
from cadgen.laws.table import codes
from cadgen.messages import shown
codes()
print(shown("Half a cosine.", "zh"), shown("roller", "zh"))
"""


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ('msgid "Half a cosine."\nmsgstr "半个余弦。"\n\nmsgid "roller"\nmsgstr "轮"\n', "半个余弦。 滚子"),
        ('msgid "a\nfoo\n', "Half a cosine. 滚子"),
    ],
    ids=["its own, and no other's", "unreadable"],
)
def test_it_brings_its_translations(tmp_path, entry, said):
    folder = tmp_path / "harmonic" / "locale" / "zh"
    folder.mkdir(parents=True)
    (tmp_path / "harmonic" / "__init__.py").write_text(LAW.replace('print("harmonic is loaded")', ""))
    (folder / "laws.po").write_text(entry, encoding="utf-8")
    install(tmp_path, "cadgen-harmonic", "1.2", {"cadgen.laws": {"harmonic": "harmonic:HARMONIC"}})
    done = run(SPEAK, tmp_path)
    assert done.stdout.strip() == said
    unread = "the catalogue laws.po of the plug-in harmonic cannot be read"
    assert (unread in done.stderr) == ("Half a" in said)


def test_the_manifest_names_it(folder):
    install(folder, "cadgen-harmonic", "1.2", {"cadgen.laws": {"harmonic": "harmonic:HARMONIC"}})
    script = """
from pathlib import Path
from cadgen.laws.table import law_of
from cadgen.figures import Facts
from cadgen.output.files.manifest import write_manifest
write_manifest(Path(), "a", Facts(files={}))
print(Path("manifest.json").read_text().count("plugins"))
law_of("harmonic")
write_manifest(Path(), "a", Facts(files={}))
"""
    done = run(script, folder)
    assert done.stdout.splitlines()[0] == "0", done.stderr
    (part,) = json.loads((folder / "manifest.json").read_text())["parts"].values()
    assert part == {"files": {}, "plugins": {"cadgen-harmonic": "1.2"}}


@pytest.mark.slow
@pytest.mark.long
def test_the_tricycle_is_known_once_it_is_installed(tmp_path):
    """The example package, from a process that knows nothing of it but what its own file of facts says."""
    lines = (ROOT / "tests" / "data" / "measured" / "circles.csv").read_text().splitlines()
    head = next(number for number, line in enumerate(lines) if not line.startswith("#"))
    run_of_first = lines[head + 1].split(",")[lines[head].split(",").index("run")]
    rows = [line for line in lines[head + 1 :] if line.split(",")[lines[head].split(",").index("run")] == run_of_first]
    (tmp_path / "log.csv").write_text("\n".join([*lines[: head + 1], *rows]) + "\n")
    unknown = run(MAIN, tmp_path, "calibrate", "log.csv")
    assert unknown.returncode == 3
    (sentence,) = unknown.stderr.splitlines()
    assert "are no kind of measured data" in sentence
    project = tomllib.loads((TRICYCLE / "pyproject.toml").read_text())["project"]
    install(tmp_path / "site", project["name"], project["version"], project["entry-points"])
    (tmp_path / "site" / "cadgen_tricycle").symlink_to(TRICYCLE / "src" / "cadgen_tricycle")
    (tmp_path / "site" / "log.csv").write_text((tmp_path / "log.csv").read_text())
    known = run(MAIN, tmp_path / "site", "calibrate", "log.csv", "--out", "out")
    assert "one run only" in " ".join(known.stdout.split()), known.stderr
    (part,) = json.loads((tmp_path / "site" / "out" / "manifest.json").read_text())["parts"].values()
    assert part["plugins"] == {project["name"]: project["version"]}
    chinese = run(MAIN, tmp_path / "site", "calibrate", "log.csv", "--lang", "zh")
    assert "转向增益" in chinese.stdout
    own = run(
        "import pytest, sys; sys.exit(pytest.main(['-q', '-p', 'no:cacheprovider', sys.argv[1]]))",
        tmp_path / "site",
        str(TRICYCLE / "tests"),
    )
    assert own.returncode == 0, own.stdout
