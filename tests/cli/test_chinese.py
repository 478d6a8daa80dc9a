"""The terminal in Chinese: no English sentence in help, complaints, tables and closing lines."""

import re
import tomllib
from pathlib import Path

import click
import pytest

from cadgen.cli import cli
from cadgen.design.load import packaged_designs
from cadgen.design.schema import DesignFile
from cadgen.inference.measurement import kinds

MEASURED = Path(__file__).parents[1] / "data" / "measured"


def _choices(option: click.Parameter) -> tuple[str, ...]:
    """Words that an option takes, and those of which its default is a list."""
    words = getattr(option.type, "choices", ())
    return (*words, *(option.default.split(",") if isinstance(option.default, str) else ()))


# What stands in Chinese texts as it is written: options, commands, paths and files, keys, sections, quoted values.
_WRITTEN = re.compile(
    r"""\[?--?[a-z][\w-]*             # an option
    | \w+=\S*                       # its value, a key with its value
    | cadgen\s+[a-z]+               # a command
    | pip\s+install
    | \[\[?[\w.]+\]\]?              # a section of a design
    | "[^"]*" | “[^”]*” | '[^']*' | `[^`]*`
    | [^\s（，：；]*[/\\][^\s（，：；]*   # a path
    | \.[a-z]+                      # the ending of a file
    | [A-Za-z]\w*(?:[._+-]\w+)+     # a key, a file, a profile of two words
    """,
    re.VERBOSE,
)
# Names that are the same in every language: commands, values of options, sections, kinds of data, packaged designs.
_NAMES = {choice for command in cli.commands.values() for choices in command.params for choice in _choices(choices)}
_NAMES |= {
    *cli.commands,
    *DesignFile.model_fields,
    *kinds.codes(),
    *packaged_designs(),
    "cadgen",
    "exports",
    "dask",
    "step",
    "value",
    "key",
    "weight",
    "formats",
    "kind",
    "double",
    "driver",
    "driven",
}


def english(text: str) -> list[str]:
    """Words of four letters and more that are neither names nor written so in every language."""
    words = re.findall(r"[A-Za-z]{4,}", _WRITTEN.sub(" ", text))
    return [word for word in words if not word.isupper() and word not in _NAMES]


@pytest.fixture
def chinese(cadgen):
    """Call `cadgen --lang zh`, and return what it prints."""

    def run(*arguments: str, code: int) -> str:
        result = cadgen("--lang", "zh", *arguments, code=code)
        return result.stdout + result.stderr

    return run


def test_an_english_sentence_is_found():
    assert english("请改正 cam.thickness_mm：it must be less") == ["must", "less"]
    assert not english("cadgen check my_car.toml --set cam.thickness_mm=3.2，见 [course]；STEP 和 DXF")


@pytest.mark.parametrize("name", ["", *sorted(cli.commands)])
def test_help(chinese, name):
    text = chinese(*([name] if name else []), "--help", code=0)
    assert "用法：" in text
    assert not english(text)


def test_help_by_the_environment_and_after_the_command(cadgen, monkeypatch):
    asked = cadgen("cam", "--help", "--lang", "zh", code=0).stdout
    monkeypatch.setenv("LANG", "zh_CN.UTF-8")
    monkeypatch.delenv("LC_ALL", raising=False)
    monkeypatch.delenv("LANGUAGE", raising=False)
    assert cadgen("cam", "--help", code=0).stdout == asked
    assert "Usage:" in cadgen("cam", "--help", "--lang", "en", code=0).stdout


def test_json_stays_english(cadgen):
    result = cadgen("--lang", "zh", "tolerance", "--samples", "0", "--json", code=2)
    assert "is not in the range" in result.stdout
    result = cadgen("--lang", "zh", "check", "--set", "cam.thicknes=3", "--json", code=2)
    assert "did you mean" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("bogus",), 2),
        (("cam", "--bogus"), 2),
        (("verify",), 2),
        (("verify", "nowhere"), 3),
        (("tolerance", "--samples", "0"), 2),
        (("tolerance", "--samples", "many"), 2),
        (("adjust", "--noise-mm", "nan", "x.csv"), 2),
        (("cam", "--out", ""), 2),
        (("cam", "--formats", "foo"), 2),
        (("cam", "--profile", "foo"), 2),
        (("plan", "--within", "10"), 2),
        (("calibrate",), 2),
        (("calibrate", "x.csv"), 3),
        (("calibrate", str(MEASURED / "squares.csv")), 3),
        (("adjust", "x.csv"), 3),
        (("explore", "x.toml", "--out", "x"), 2),
        (("merge", "x", "--out", "x"), 3),
        (("card",), 2),
        (("check", "nothing"), 2),
        (("check", "x.toml"), 2),
        (("check", "."), 2),
        (("new", "my,car"), 2),
    ],
)
def test_complaints_about_the_command_line(chinese, arguments, code):
    assert not english(chinese(*arguments, code=code))


@pytest.mark.parametrize(
    "change",
    [
        "cam",
        "cam.thicknes=3",
        "cam.thickness_mm=abc",
        "cam.thickness_mm=",
        "cam.thickness_mm=[",
        "cam.mid_plane_mm=",
        "cam.base_radius_mm=",
        "cam.blend_deg=400",
        "car.wheelbase_mm=-5",
        "car.wheelbase_mm=nan",
        "path.waypoints_mm=3",
        "path.waypoints_mm=[[0, 0]]",
        "path.offset_mm=1e9",
        "follower.kind=foo",
        "follower=",
        "car=",
        "checks.pressure_angle_limit=foo",
        "blank.bore_fit=H99",
        "train.stages=",
        "motion.segments=1",
    ],
)
def test_complaints_about_a_design(chinese, change):
    assert not english(chinese("check", "--set", change, code=2))


@pytest.mark.parametrize("closed", [[], ["--closed"]])
def test_a_new_design(chinese, cadgen, tmp_path, closed):
    assert "下一步：cadgen check my_car.toml" in " ".join(chinese("new", "my_car", *closed, code=0).split())
    assert not english(chinese("new", "my_car", *closed, code=3))
    text = (tmp_path / "my_car.toml").read_text("utf-8")
    comments = re.sub(r"(?m)^(?:# )?[\w\[\].]+(?: = [^#\n]*)?", "", text)
    assert "前叉轴到后轴" in comments
    assert not english(comments)
    cadgen("new", "my_car", *closed, "--out", "english", code=0)
    assert tomllib.loads(text) == tomllib.loads((tmp_path / "english" / "my_car.toml").read_text("utf-8"))


@pytest.mark.parametrize(
    "arguments",
    [
        ("tolerance", "workshop_car", "--samples", "10"),
        pytest.param(("calibrate", str(MEASURED / "lift_a.csv")), marks=pytest.mark.long),
        ("calibrate", str(MEASURED / "track_a.csv")),
        pytest.param(("tolerance", "--samples", "10", "--budget"), marks=pytest.mark.long),
        pytest.param(("simulate",), marks=pytest.mark.long),
        pytest.param(("optimize", "workshop_car"), marks=pytest.mark.long),
        pytest.param(("calibrate", "--next"), marks=pytest.mark.long),
        pytest.param(("draw", "--only", "train"), marks=pytest.mark.long),
    ],
)
def test_results(chinese, arguments):
    text = chinese(*arguments, code=0)
    assert not english(text)
    assert any(word in text for word in ("合格", "就绪"))
