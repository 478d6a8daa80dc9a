"""Figures of a real design against other ways to the same numbers."""

from collections.abc import Iterator
from dataclasses import replace
from math import hypot, pi
from pathlib import Path

import numpy as np
import pytest
import shapely

from cadgen.car.against_play.band import fixed_profile_bound
from cadgen.design import cam_model
from cadgen.design.load import load_design
from cadgen.errors import DesignError
from cadgen.studies.study_figures import Evaluated, StudyFigure, codes, kind_of, register, remove

OVERRIDES = (
    "blank.material=aluminium",
    "mechanics.rod_force_N=2.0",
    "mechanics.drag_least_Nmm=60.0",
    "tolerances.start_heading_deg=0.4",
)


def evaluated_of(name: str = "carbon_free_car", overrides: tuple[str, ...] = ()) -> Evaluated:
    return Evaluated({}, lambda: load_design(name, overrides), None, 300, 1)


@pytest.fixture(scope="module")
def paper() -> Iterator[Evaluated]:
    return evaluated_of()


@pytest.mark.slow
def test_the_drift_is_the_exact_chains_worst_end(paper):
    """Within 1 %: see docs/how-to/explore.md."""
    drift, exact = kind_of("drift_mm").of(paper), kind_of("worst_end_mm").of(paper)
    print(f"drift {drift:.1f} mm, exact {exact:.1f} mm")
    assert drift == pytest.approx(exact, rel=0.01)


@pytest.mark.slow
def test_figures_of_the_disc_by_its_polygon(paper):
    points = paper.plan.curve.outline(0.05).points
    disc = shapely.Polygon(points)
    assert kind_of("disc_diameter_mm").of(paper) == pytest.approx(
        2 * max(hypot(x, y) for x, y in points.tolist()), abs=1e-3
    )
    # The cutter's centre runs at its radius from the outline, with quarters of 3 mm before and after; passes of 1 mm
    # through 3.3 mm are 4, at 240 mm/min, and down 1 mm above each, at 60.
    centre = disc.buffer(2.0, quad_segs=64).exterior.length
    minutes = 4 * (centre + 3 * pi) / 240 + (3.3 + 4) / 60
    assert kind_of("cutting_time_min").of(paper) == pytest.approx(minutes, rel=1e-3)
    # Bore 8 mm with a keyway 3 x 1.4 mm into its wall, and six holes of 18 mm.
    bore = shapely.Point(0, 0).buffer(4.0, quad_segs=256).union(shapely.box(-1.5, 0, 1.5, 5.4))
    area = disc.area - bore.area - 6 * pi * 81
    assert kind_of("disc_mass_g").of(paper) == pytest.approx(area * 3.0 * 2.70e-3, rel=1e-4)
    unknown = evaluated_of()
    unknown.__dict__["plan"] = replace(paper.plan, making=replace(paper.plan.making, material=None))
    with pytest.raises(DesignError, match=r"needs its material: add blank\.material"):
        kind_of("disc_mass_g").of(unknown)


def test_cheap_figures_by_numbers_that_are_known():
    """Eq. 31 of the paper's table: the return error of the train as given is 0.962 degrees at most."""
    assert kind_of("return_error_deg").of(evaluated_of()) == pytest.approx(0.962, abs=5e-4)
    known = evaluated_of(overrides=("play.least_deg=0.5", "play.greatest_deg=0.5"))
    assert kind_of("drift_mm").of(known) == 0.0
    twice = evaluated_of(overrides=("play.least_deg=0.3", "play.greatest_deg=0.7"))
    once = evaluated_of(overrides=("play.least_deg=0.4", "play.greatest_deg=0.6"))
    assert kind_of("drift_mm").of(twice) == pytest.approx(2 * kind_of("drift_mm").of(once))


def test_the_drift_is_above_the_bound_of_all_profiles():
    """That bound may choose where on each fall a car turns; the drift has it where it is."""
    evaluated = evaluated_of()
    car, length = cam_model.car(evaluated.design), cam_model.travel(evaluated.design, evaluated.track)
    bound = fixed_profile_bound(evaluated.lift, car, length, evaluated.band.ends).distance
    assert 0.7 * kind_of("drift_mm").of(evaluated) < bound < kind_of("drift_mm").of(evaluated)


def test_a_figure_from_outside():
    figure = StudyFigure(code="cube_mm3", meaning="", of=lambda evaluated: 1.0)
    register(figure)
    try:
        assert "cube_mm3" in codes()
        with pytest.raises(DesignError, match="already"):
            register(figure)
    finally:
        remove(figure)


@pytest.mark.slow
@pytest.mark.long
def test_figures_with_forces_and_cars():
    rubbing = evaluated_of(overrides=OVERRIDES)
    comparison = rubbing.plan.application.comparison
    theta = np.linspace(0, 2 * pi, 20_000)
    torque = comparison.task.mechanics.at(0.0, 0.0).torque(comparison.chosen.lift, theta).max()
    # A drag of 1.25 times that torque, once round.
    assert kind_of("holding_energy_J").of(rubbing) == pytest.approx(1.25 * torque * 2 * pi * 1e-3, rel=1e-3)
    passed = kind_of("passed_percent").of(rubbing)
    assert passed == 100 * rubbing.tolerance.passed
    with pytest.raises(DesignError, match="rod's force"):
        kind_of("holding_energy_J").of(evaluated_of())


def test_docs_name_every_figure():
    page = (Path(__file__).parents[2] / "docs" / "how-to" / "explore.md").read_text()
    assert [code for code in codes() if f"`{code}`" not in page] == []
