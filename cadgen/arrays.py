"""Names that every numeric room shares: the type of an array of floats, and a full turn, rad."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
TURN = 2 * np.pi
