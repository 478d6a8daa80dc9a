"""Words that every numeric room shares: an array of floats, and a turn."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
TURN = 2 * np.pi
