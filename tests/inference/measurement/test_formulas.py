"""Formulas for what repeats in logged runs: found where there is one, with its size; not where there is none."""

import numpy as np
import pytest

from cadgen.design.load import load_design, packaged_designs
from cadgen.inference.measurement import kinds
from cadgen.inference.measurement.formulas import proposal
from cadgen.inference.measurement.model import Model
from cadgen.inference.measurement.nominal import LoggedCar
from cadgen.inference.measurement.record import Record
from cadgen.inference.measurement.repeats import one_path
from cadgen.inference.measurement.runs_left_out import _along, _registered
from cadgen.jobs.calibration.calibration import accepted_formulas

pytestmark = [pytest.mark.usefixtures("tricycle"), pytest.mark.slow]

WHEELBASE, ROWS, FINE, RADIUS, DEG = 150.0, 300, 4, 32.5, np.pi / 180
NAMES = ("t_s", "distance_mm", "steering_deg", "x_mm", "y_mm", "heading_deg")


def log(seed: int, *, turning=None, travelling=None, creeping=None, kicks_deg: float = 0.0, paths: int = 4) -> Record:
    """Runs of several paths, two each, integrated in steps of a quarter of a row; camera's noise of 1 mm.

    Args:
        seed: of paths, speeds and noise.
        turning, travelling, creeping: functions of steering, rad, heading from the start, rad, speed, mm/s, distance,
            mm, and the path's number, that give by what the body turns beside the log for each mm, rad, and what
            more of the travel goes ahead and to the left.
        kicks_deg: standard deviation of turns at three places of each path, which no input tells.
        paths: how many there are.
    """
    rng, columns = np.random.default_rng(seed), {name: [] for name in NAMES}
    for path in range(paths):
        waves, phase = rng.uniform(150, 500, 2), rng.uniform(0, 2 * np.pi, 2)
        size, bias = np.radians(rng.uniform(10, 35, 2)), np.radians(rng.uniform(-12, 12))
        ridges = dict(zip(rng.integers(40, 260, 3), np.radians(rng.normal(0, kicks_deg, 3)), strict=True))
        pace = rng.uniform(0.2, 0.5), rng.uniform(1500, 3000)
        for _run in range(2):
            heading, place, time = 0.0, 0j, 0.0
            wander = np.radians(0.02) * rng.normal(0, 1, ROWS)
            rows = []
            for row in range(ROWS):
                travel = 8.0 * row
                steering = bias + float(size @ np.sin(travel / waves + phase))
                speed = 100 * (1 + pace[0] * np.sin(travel / pace[1] * 2 * np.pi))
                rows.append((time, travel, np.degrees(steering), place.real, place.imag, np.degrees(heading)))
                heading += ridges.get(row, 0.0) + wander[row]
                for part in range(FINE):
                    at, ds = travel + 8.0 * (part + 0.5) / FINE, 8.0 / FINE
                    angle = bias + float(size @ np.sin(at / waves + phase))
                    state = angle, heading, speed, at, path
                    more = 1 + (travelling(*state) if travelling else 0.0)
                    turn = np.sin(angle) * ds * more / WHEELBASE + (turning(*state) * ds if turning else 0.0)
                    step = np.cos(angle) * more + 1j * (creeping(*state) if creeping else 0.0)
                    place += ds * step * np.exp(1j * (heading + turn / 2))
                    heading, time = heading + turn, time + ds / speed
            values = np.array(rows)
            values[:, 3:5] += rng.normal(0, 1, (ROWS, 2))
            for name, column in zip(NAMES, values.T, strict=True):
                columns[name].append(column)
    return Record(
        kind=kinds.kind_of("steered track"),
        columns={name: np.concatenate(values) for name, values in columns.items()},
        run=np.repeat(np.arange(2 * paths), ROWS),
        remarks=(f"diameter {2 * RADIUS} mm",),
        source="made log",
    )


def model_of(record: Record, accepted: frozenset[str] = frozenset()) -> Model:
    assert record.kind.model is not None
    model: Model = record.kind.model(record, LoggedCar(WHEELBASE, accepted))
    return model


def proposed(record: Record):
    """Proposal beside zero, wheelbase and wheel radius, all of which are right."""
    model = model_of(record)
    effects = tuple(e for e in model.catalogue if e.name in ("steering zero", "wheelbase", "wheel radius"))
    active = [(e, np.zeros(1)) for e in effects]
    left = _registered(model, model.residual(active))
    return proposal(model, effects, active, left, one_path(_along(model.measured, model.rows.run)))


@pytest.mark.parametrize(
    ("name", "size", "made"),
    [
        (
            "turning per metre ~ v^2 sin d",
            -12.0,
            {"turning": lambda d, h, v, s, p: -0.012 * DEG * (v / 100) ** 2 * np.sin(d)},
        ),
        ("creep to the left ~ sin psi", 4.0, {"creeping": lambda d, h, v, s, p: 0.04 * np.sin(h)}),
        ("turning per metre ~ sin^3 d", 40.0, {"turning": lambda d, h, v, s, p: 0.04 * DEG * np.sin(d) ** 3}),
        ("travel ~ s", -12.0, {"travelling": lambda d, h, v, s, p: -0.12 * s / 1e4}),
    ],
)
def test_a_formula_that_no_catalogue_has_is_found_with_its_size(name, size, made):
    found = proposed(log(5, kicks_deg=0.2, **made))
    print(name, found)
    assert found is not None
    assert name in (found.finding.effect, *found.rivals)
    if found.finding.effect == name:
        assert found.finding.values[0].value == pytest.approx(size, rel=0.3)
    assert found.after < 0.85 * found.before


@pytest.mark.slow
@pytest.mark.long
def test_turns_that_no_input_tells_are_given_no_formula():
    """Each path has ridges of its own, which repeat in its runs; and every run wanders."""
    found = [proposed(log(seed, kicks_deg=2.0)) for seed in range(100, 120)]
    print([f.finding.effect for f in found if f])
    assert sum(f is not None for f in found) <= 1


def test_a_formula_that_is_accepted_is_an_effect_of_the_car_and_drives_it(tmp_path):
    """In the design file by its name; the model then looks for it, and does not propose it."""
    name = "creep to the left ~ sin psi"
    record = log(3, creeping=lambda d, h, v, s, p: 0.04 * np.sin(h))
    model = model_of(record, frozenset([name]))
    (formula,) = (effect for effect in model.catalogue if effect.name == name)
    assert name not in {effect.name for effect in model.formulas}
    bare, driven = (_registered(model, model.residual(active)) for active in ([], [(formula, np.array([0.04]))]))
    assert np.sqrt(np.mean(bare**2)) > 3
    assert np.sqrt(np.mean(driven**2)) < 1.6  # 1 mm of noise, and a heading that wanders
    accepted = f"""
[[as_built.effects]]
effect = "{name}"
kind = "steered track"
place = "noted"
values = [{{ name = "formula_percent", value = 4.0 }}]
"""
    file = tmp_path / "car.toml"
    file.write_text(packaged_designs()["carbon_free_car"].read_text() + accepted)
    assert accepted_formulas(load_design(file), record.kind) == {name}
