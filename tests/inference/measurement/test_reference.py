"""The page of effects is what the catalogue says, and the signs on it are those of the models."""

from pathlib import Path

import numpy as np
import pytest

from cadgen.car.running.drive import Running
from cadgen.deviations.disc import Disc
from cadgen.inference.measurement.kinds import PROFILE, TRACK, kinds
from cadgen.inference.measurement.reference import page
from tests.inference.measurement.synthetic_drive import Wheels

PAGE = Path(__file__).parents[3] / "docs" / "effects.md"


@pytest.mark.parametrize(("language", "end"), [("en", ""), ("zh", ".zh-CN")])
def test_the_page_is_up_to_date(language, end):
    file = PAGE.with_suffix(f"{end}.md")
    command = f"python -m cadgen.inference.measurement.reference {language} > docs/{file.name}"
    assert file.read_text(encoding="utf-8") == page(language), f"run: {command}"


def test_every_number_has_a_meaning_and_a_signed_one_says_its_sense():
    for parameter in (p for kind in kinds() for effect in kind.catalogue.entries for p in effect.parameters):
        assert parameter.meaning
        assert (parameter.lower < 0) == parameter.meaning.startswith("+: "), parameter.name


@pytest.fixture(scope="module")
def circle():
    """A round disc of 20 mm about its bore."""
    angle = np.linspace(0, 2 * np.pi, 360, endpoint=False)
    normal = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return Disc(20 * normal, normal, angle, np.empty(0), np.zeros(360, dtype=np.intp))


def test_signs_on_the_disc(circle):
    def changed(name, *values):
        return PROFILE.named(name).act(circle, np.array(values), None).points

    # Seen from the middle of the outline the bore, which is the origin, lies at (+0.3, +0.1).
    np.testing.assert_allclose(-changed("eccentric bore", 0.3, 0.1).mean(axis=0), (0.3, 0.1), atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(changed("cutter compensation", 0.2), axis=1), 20.2)
    assert changed("anisotropic scale", 0.01, 0.0).max(axis=0) == pytest.approx((20.2, 20.0))
    assert np.linalg.norm(changed("lobing, order 3", 0.1, 0.0)[0]) == pytest.approx(20.1)
    # Counterclockwise the cutter goes up at +x: an axis that lags stays low.
    assert changed("machine-axis reversal", 0.0, 0.1)[0, 1] == pytest.approx(-0.05)


def test_a_positive_steering_zero_turns_right(carbon_free_car):
    """By the generator that drives the synthetic cars, whose names of the effects are the catalogue's."""
    motor = np.array([0.0, 0.3])
    straight, off = (Wheels(zero=zero).track(carbon_free_car, motor) for zero in (0.0, 0.01))
    ahead = straight[1] - straight[0]
    assert ((off[1] - straight[1]) / ahead).imag < 0
    run = TRACK.named("steering zero").act(Running(car=carbon_free_car.car, length=1.0), np.array([0.01]), None)
    assert run.car.steering_zero == 0.01
