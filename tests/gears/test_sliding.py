"""Specific sliding and losses: published values, velocities of points, and the balance of torques."""

from dataclasses import replace
from math import cos, radians

import numpy as np
import pytest

from cadgen import Design, Gear, GearPair, Planetary
from cadgen.errors import DesignError
from cadgen.gears import sliding
from cadgen.gears.contact import path_of_contact
from tests.gears.test_helical import form_of, pair_of, trial


def fzg_c():
    """Test gears FZG type C: 16/24, m 4.5, a 91.5, tips of 82.46 and 118.36 mm."""
    pinion = Gear(
        teeth=16, module=4.5, width=14, profile_shift=0.1817, addendum=82.46 / 9 - 8 - 0.1817, thickness_deviation=0.0
    )
    wheel = Gear(
        teeth=24, module=4.5, width=14, profile_shift=0.1715, addendum=118.36 / 9 - 12 - 0.1715, thickness_deviation=0.0
    )
    return GearPair(pinion, wheel, centre_distance=91.5)


def test_loss_factor_of_published_test_gears():
    """GEARpie REPORT/C14.txt: contact ratio 1.44, H_v 0.1950."""
    assert fzg_c().contact_ratio == pytest.approx(1.44, abs=5e-3)
    assert fzg_c().loss_factor == pytest.approx(0.1950, abs=5e-5)


PAIRS = {
    "external": (Gear(teeth=18, module=1, width=8, profile_shift=0.3), Gear(teeth=47, module=1, width=8)),
    "helical": (
        Gear(teeth=18, module=1, width=8, helix_angle=radians(25)),
        Gear(teeth=40, module=1, width=8, helix_angle=radians(25), hand="left"),
    ),
    "internal": (Gear(teeth=20, module=1, width=8), Gear(teeth=60, module=1, width=8, internal=True)),
}


def velocities(pair, along):
    """Speeds of both flanks along the tangent at a point of the line of action, for a pinion that turns with 1 rad/s.

    The pinion's axis is the origin, the other's at +a (a ring's at -a); the line of action runs at the pressure angle.
    """
    first, second = (gear.form for gear in pair.by_size)
    alpha = pair.working_pressure_angle
    way = np.exp(1j * (np.pi / 2 - alpha))  # of the line of action
    foot = first.base_diameter / 2 * np.exp(-1j * alpha)
    point = foot + along * way
    axis = pair.centre_distance if second.side > 0 else -pair.centre_distance
    turn = -first.teeth / second.teeth * second.side
    across = 1j * way
    return tuple((speed * 1j * (point - at) * np.conj(across)).real for speed, at in ((1.0, 0.0), (turn, axis)))


@pytest.mark.parametrize("name", PAIRS)
def test_sliding_and_losses_from_velocities(name):
    pair = GearPair(*PAIRS[name], backlash=0.05).cut
    start, end = path_of_contact(pair)
    of_pinion, of_wheel = sliding.specific_sliding(pair)
    one, other = velocities(pair, start)
    assert of_pinion == pytest.approx((one - other) / one)
    one, other = velocities(pair, end)
    assert of_wheel == pytest.approx((other - one) / other)
    # Work of friction over a base pitch, the load on one or two teeth alike, against the work that is passed on.
    form = pair.by_size[0].form
    pitch = np.pi * form.transverse_module * cos(form.transverse_pressure_angle)
    places = start + (np.arange(4000) + 0.5) / 4000 * pitch
    power = []
    for place in places:
        touching = [each for each in (place, place + pitch) if each <= end]
        power.append(np.mean([abs(np.subtract(*velocities(pair, each))) for each in touching]))
    mean = np.mean(power) / (form.base_diameter / 2) / cos(form.base_helix_angle)
    assert sliding.loss_factor(pair) == pytest.approx(mean, rel=1e-3)


def test_equal_gears_slide_alike_and_the_mean_meets_the_formula(monkeypatch):
    gear = Gear(teeth=25, module=1, width=8)
    pair = GearPair(gear, gear, backlash=0.02)
    assert pair.specific_sliding[0] == pytest.approx(pair.specific_sliding[1])
    high = GearPair(
        replace(gear, addendum=1.35, dedendum=1.6, rack_tip_radius=0.2),
        replace(gear, addendum=1.35, dedendum=1.6, rack_tip_radius=0.2),
        backlash=0.05,
    )
    assert high.contact_ratio > 2  # beyond the formula
    assert 0.5 * pair.loss_factor < high.loss_factor < 1.5 * pair.loss_factor


def test_efficiency_of_planetary_sets_by_torques():
    """Sun in, ring held: torques of sun and ring are as -1 : η0 z_r/z_s, and the carrier takes their sum."""
    sun, planet = Gear(teeth=18, module=1, width=8, bore=5), Gear(teeth=27, module=1, width=8, bore=4)
    from cadgen.gears.planetary_stage import PlanetaryStage

    for held in ("ring", "carrier", "sun"):
        made = Planetary(sun, planet, planets=3, held=held)
        (stage,) = made.computed.layout.train.stages
        assert isinstance(stage, PlanetaryStage)
        fixed = np.prod([1 - 0.1 * sliding.loss_factor(mesh) for mesh in made.cut.meshes])
        if held == "ring":
            # T_sun = 1, T_ring = η0 z_r/z_s, carrier 1 + that, at 1/i of the sun's speed.
            wanted = (1 + fixed * 72 / 18) / 5
        elif held == "carrier":
            wanted = fixed
        else:  # ring in: T_ring = 1, T_sun = η0 z_s/z_r
            wanted = (1 + fixed * 18 / 72) / (1 + 18 / 72)
        assert stage.efficiency(0.1) == pytest.approx(wanted)


def test_a_train_says_its_losses_with_method_and_source(tmp_path):
    file = tmp_path / "pair.toml"
    text = (
        "[train]\nmodule_mm = 1.0\nwidth_mm = 8.0\nbearing_span_mm = 60.0\nfriction_coefficient = 0.1\n{source}"
        "[[train.stages]]\ndriver = {{ teeth = 20 }}\ndriven = {{ teeth = 60 }}\n"
    )
    file.write_text(text.format(source="friction_source = 'estimated'\n"))
    train = Design.load(file, train_only=True).gears()
    facts = train.facts()
    (stage,) = facts["stages"]
    assert facts["losses"]["efficiency"] == pytest.approx(1 - 0.1 * stage["loss_factor"])
    assert facts["losses"]["method"].startswith("Niemann/Ohlendorf")
    assert any("(estimated), by Niemann" in note for note in train.notes)
    file.write_text(text.format(source=""))
    with pytest.raises(DesignError, match=r'go together: give both, such as 0\.1 and "estimated"'):
        Design.load(file, train_only=True)


@pytest.mark.parametrize("name", ["01_helical_shifted", "03_undercut_helical", "05_z5_shift"])
def test_loss_factors_of_another_program(name):
    """Trials of helical pairs, the last with a contact ratio below 1 that the overlap carries."""
    numbers = trial(name)
    forms = [form_of(numbers["design"][key]) for key in ("gear1", "gear2")]
    said = numbers["expected"]["pair"]["H_v"]
    assert sliding.loss_factor(pair_of(*forms, numbers["design"]["a"])) == pytest.approx(said, abs=1e-6)
