"""The last line of every command: PASS or FAIL, and the next step."""

import inspect

import pytest

from cadgen.cli import cli
from cadgen.cli.show import command, verdict


# The editor goes on until it is stopped, and has no result.
@pytest.mark.parametrize("name", sorted(cli.commands.keys() - {"edit"}))
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
