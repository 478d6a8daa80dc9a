"""The last line of every command: PASS or FAIL, and the next step."""

import inspect
import json
import re
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from cadgen import Design
from cadgen.check import Bound, Check, CheckCode
from cadgen.cli import cli, show
from cadgen.cli.show import command, verdict
from cadgen.verdict import PartVerdict


# The editor goes on until it is stopped, and has no result; an explanation judges nothing.
@pytest.mark.parametrize("name", sorted(cli.commands.keys() - {"edit", "explain"}))
def test_every_command_prints_it(name):
    """Each by the one function, and none by words of its own."""
    function = cli.commands[name].callback
    helpers = [help for word, help in vars(inspect.getmodule(function)).items() if word in function.__code__.co_names]
    sources = [inspect.getsource(each) for each in (function, *helpers) if inspect.isfunction(each)]
    assert any("verdict(" in source for source in sources)
    assert not any("PASS" in source.replace("PASS or FAIL", "") for source in sources)


@pytest.mark.parametrize("width", ["60", "80"])
def test_it_fits_a_narrow_terminal(width, monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", width)
    step = command("cam", "my_car.toml", "--profile optimized", overrides=["a=1"])
    verdict(True, "every check holds, and each file in exports was read back", step)
    printed = capsys.readouterr().out
    assert max(map(len, printed.splitlines())) <= int(width)
    assert " ".join(printed.split()) == (
        "PASS: every check holds, and each file in exports was read back; next: cadgen cam my_car.toml "
        "--profile optimized (with the same --set)"
    )


RUBS = ["--set", "mechanics.friction_least=0.1", "--set", "mechanics.friction_greatest=0.5"]


@pytest.mark.slow
@pytest.mark.parametrize(
    "command",
    [
        ["check"],
        pytest.param(["cam"], marks=pytest.mark.long),
        pytest.param(["draw", "--only", "cam"], marks=pytest.mark.long),
        pytest.param(["plan"], marks=pytest.mark.long),
        pytest.param(["tolerance", "--profile", "optimized", "--samples", "300"], marks=pytest.mark.long),
        pytest.param(["simulate"], marks=pytest.mark.long),
    ],
    ids=lambda words: words[0],
)
def test_a_design_that_no_profile_serves_ends_in_the_verdict(cadgen, command):
    """With its reason and a cure: friction misses the lift by more than the design allows."""
    facts = json.loads(cadgen(*command, "carbon_free_car", *RUBS, "--json", code=1).stdout)
    assert not facts["passed"]
    assert facts["verdict"]["readiness"] == "not-ready"
    assert "lift error with play" in facts["verdict"]["failed_checks"]


@pytest.mark.slow
@pytest.mark.long
def test_its_cures_work():
    plain = Design.load("carbon_free_car").with_({"mechanics.friction_least": 0.1, "mechanics.friction_greatest": 0.5})
    (refused,) = (check for check in plain.cam().failed if check.code == "lift-error-with-play")
    raised = float(re.search(r"raise optimize\.max_lift_error_um to ([\d.]+),", refused.advice)[1])
    assert 'set optimize.hardware = ["drag"]' in refused.advice
    for cure in ({"optimize.max_lift_error_um": raised}, {"optimize.hardware": ["drag"]}):
        assert "lift-error-with-play" not in [check.code for check in plain.with_(cure).cam().failed]


LOST = Check(CheckCode.CARS_KEEP_COURSE, "cars that keep the course", 11.8, "%", 25.0, Bound.MIN)


@pytest.mark.parametrize(
    ("checks", "lost", "code", "line"),
    [
        (
            (),
            0,
            0,
            "READY: the path keeps the course, and every check of its cam holds; next: cadgen plan figure_eight",
        ),
        ((LOST,), 0, 1, "NOT READY: cars that keep the course fails; next: change the design"),
        ((), 2, 1, "NOT READY: the course is not kept at 2 of 3 spacings; next: widen [settings], or narrow"),
    ],
)
def test_the_last_line_of_a_plan_follows_what_failed(monkeypatch, checks, lost, code, line):
    ruling = PartVerdict(checks)
    cam = SimpleNamespace(verdict=ruling, failed=ruling.failed, passed=ruling.passed)
    drawn = tuple(SimpleNamespace(failed=(LOST,) * (number < lost)) for number in range(3))
    sound, passed = not lost, not lost and ruling.passed
    plan = SimpleNamespace(cam=cam, drawn=drawn, sound=sound, passed=passed, proven=False)
    monkeypatch.setattr(Design, "plan", lambda *_, **__: plan)
    monkeypatch.setattr(show, "plan", lambda *_, **__: None)
    run = CliRunner().invoke(cli, ["plan", "figure_eight"])
    assert run.exit_code == code
    assert " ".join(run.output.split()).startswith(line)
