"""Where measured numbers belong: the run, the place on the cam, the place within the run."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from cadgen.arrays import Array


@dataclass(frozen=True, kw_only=True)
class Rows:
    """Where each measured number belongs; arrays of shape (n,), in the order measured within each run.

    Attributes:
        run: number of the run, from 0.
        place: angle round the cam, rad.
        elapsed: place within the run, -1/2 to 1/2.
        cell: rows of different runs with one number were taken under the same conditions; -1 if none repeats.
    """

    run: NDArray[np.intp]
    place: Array
    elapsed: Array
    cell: NDArray[np.intp]

    @property
    def runs(self) -> int:
        """How many runs there are."""
        return int(self.run.max()) + 1
