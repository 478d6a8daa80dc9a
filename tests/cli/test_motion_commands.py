"""Commands on a cam by its motion: what is worked out for a car alone is refused in a sentence that names the key."""

import pytest

from tests.cli.conftest import one_sentence
from tests.docs.blocks import DOCS

CAMERA, TRIAL = (str(DOCS / f"tutorial/{name}.csv") for name in ("camera", "trial_1"))


@pytest.mark.parametrize(
    "arguments",
    [
        ["optimize", "roller"],
        ["simulate", "roller"],
        ["adjust", "roller", TRIAL],
        ["card", "conjugate_pair"],
        ["plan", "groove"],
        ["plan", "roller", "--from", "roller", "--within", "5"],
    ],
    ids=lambda arguments: " ".join(arguments[:3]),
)
def test_what_is_for_a_car_alone_names_the_key_and_the_commands_that_fit(cadgen, tmp_path, arguments):
    said = one_sentence(cadgen(*arguments, code=2))
    assert "the design has [motion], and not [path] and [car]" in said
    assert all(f" {name}" in said for name in ("check", "cam", "draw", "report", "edit", "explore"))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (
            ["check", "roller", "--profile", "optimized"],
            "is against the play of a car's gears, and the design has [moti",
        ),
        (["calibrate", "roller", "--next"], "--next is for a car, and the design has [motion]"),
        (["gears", "roller"], "roller.toml has no gear train: add a section [train]"),
        (["check", "roller", "--set", "course.margin_mm=3"], "course is not a key: a design takes name, motion, dyna"),
        (
            ["check", "groove", "--set", "dynamics.preload_N=3"],
            "dynamics.preload_N is of a spring, and the follower is",
        ),
    ],
    ids=lambda value: " ".join(value[:3]) if isinstance(value, list) else "",
)
def test_options_and_keys_of_a_car_are_one_sentence(cadgen, tmp_path, arguments, words):
    assert words in one_sentence(cadgen(*arguments, code=2))
    assert not list(tmp_path.iterdir())
