"""The lift on a changed disc: its change to first order against the rod rolled on discs a little different."""

import numpy as np
import pytest

from cadgen.deviations.disc import PROFILE_EFFECTS, worn_nose
from cadgen.deviations.lift import LIFT_EFFECTS
from cadgen.inference.measurement.model import Rolled

EFFECTS = {e.name: e for e in (*LIFT_EFFECTS, *PROFILE_EFFECTS, worn_nose(0, 4.0)) if e.stage in Rolled.stages}
ANGLES = np.linspace(0, 2 * np.pi, 1000)
# Where an axis turned round the outline has a step: the rod rides on its edge, by the height of the step.
ROUGH = {"machine-axis reversal": 0.08}


@pytest.mark.slow
@pytest.mark.parametrize("state", [{}, {"eccentric bore": (0.08, -0.05), "camshaft wobble": (0.8, -1.0)}], ids=len)
def test_first_order_is_that_of_rolled_differences(nominal, state):
    rolled = nominal.rolled
    active = [(EFFECTS[name], np.array(values)) for name, values in state.items()]

    def change(some):
        spline = rolled.change(some, None)
        return np.zeros(len(ANGLES)) if spline is None else spline(ANGLES)

    errors = {}
    for name, effect in EFFECTS.items():
        if state and name not in state and name != "rod radius":
            continue
        for number, step in enumerate(effect.steps):
            middle = np.array(state.get(name, effect.start))
            step = min(step, effect.bounds[1][number] - middle[number])
            ends = []
            for sign in (-1, 1):
                moved = middle.copy()
                moved[number] = max(moved[number] + sign * step, effect.bounds[0][number])
                others = [(e, moved if e is effect else v) for e, v in active]
                ends.append((moved[number], change(others if name in state else [*others, (effect, moved)])))
            true = (ends[1][1] - ends[0][1]) / (ends[1][0] - ends[0][0])
            standing = rolled.first_order(effect, number, active, None)
            ours = (change([*active, (standing, np.array([step]))]) - change(active)) / step
            errors[name, number] = np.sqrt(np.mean((ours - true) ** 2) / max(np.mean(true**2), 1e-30))
    print({f"{name} {number}": f"{100 * error:.2f} %" for (name, number), error in errors.items()})
    assert len(errors) >= 5
    assert all(error < ROUGH.get(name, 0.015) for (name, _), error in errors.items())
