"""Search for the front by whole generations: NSGA-II of pymoo over the unit cube.

A generation depends on all results of those before it and on nothing else, so a search that was killed goes through
its journal again and comes to the same places. docs/decisions/0020-explore.md has why it is pymoo.
"""

from typing import Any

import numpy as np

from cadgen.arrays import Array
from cadgen.errors import DesignError

CODE = "nsga2"
_MISSING = 1e30  # of an objective that was not computed; such a design violates a limit, which counts first


class Search:
    """NSGA-II (Deb et al. 2002), asked for places and given their results.

    Args:
        dimensions: number of keys that vary.
        objectives: number of objectives.
        population: designs of a generation.
        generations: number of generations.
        seed: seed of its random numbers.

    Raises:
        DesignError: pymoo is not installed.
    """

    def __init__(self, dimensions: int, objectives: int, population: int, generations: int, seed: int) -> None:
        try:
            from pymoo.algorithms.moo.nsga2 import NSGA2
            from pymoo.core.problem import Problem
        except ImportError:
            raise DesignError(
                "a search by nsga2 needs pymoo: pip install '.[explore]' in cadgen's folder, or take the plan sobol"
            ) from None
        self._problem = Problem(n_var=dimensions, n_obj=objectives, n_ieq_constr=1, xl=0.0, xu=1.0)
        self._search: Any = NSGA2(pop_size=population)
        # One more, since it would otherwise end before the last results are in.
        self._search.setup(self._problem, termination=("n_gen", generations + 1), seed=seed % 2**32, verbose=False)
        self._asked: Any = None

    def ask(self) -> Array:
        """Places of the next generation in the unit cube, shape (population, dimensions)."""
        self._asked = self._search.ask()
        return np.asarray(self._asked.get("X"), dtype=float)

    def answer(self, objectives: Array, violations: Array) -> None:
        """Take the results of a generation.

        Args:
            objectives: objectives, each in the unit of its figure, less of which is better, shape (population,
                objectives); NaN where none was found.
            violations: shares by which each design violates its limits, shape (population,); 0 if it keeps them.
        """
        from pymoo.core.evaluator import Evaluator
        from pymoo.problems.static import StaticProblem

        filled = np.where(np.isfinite(objectives), objectives, _MISSING)
        Evaluator().eval(StaticProblem(self._problem, F=filled, G=violations[:, None]), self._asked)
        self._search.tell(infills=self._asked)
