"""Where the cam leads its gears, by friction, whichever way it is turned."""

from dataclasses import dataclass, field, replace

import numpy as np

from cadgen.arrays import TURN, Array
from cadgen.car.motion.mechanics import Leads, Mechanics
from cadgen.car.path_motion import PathMotion
from cadgen.inference.measurement.recent import Recent

_KEPT = 256  # fits go back and forth between few frictions


@dataclass(frozen=True)
class Forces:
    """The cam that is measured and what acts on it.

    Attributes:
        cut: lift that it was cut for.
        mechanics: rod force and drag; the friction is what is sought.
    """

    cut: PathMotion
    mechanics: Mechanics
    _known: Recent[tuple[float, bool, int], tuple[PathMotion, Leads]] = field(
        default_factory=lambda: Recent(_KEPT), repr=False
    )

    def leads(self, friction: float, *, back: bool = False, lift: PathMotion | None = None) -> Leads:
        """Where the cam leads with a sliding friction; remembered, since most differences leave friction alone.

        Args:
            friction: friction coefficient between rod and disc.
            back: of a cam that is turned back, by the angle that it has turned back.
            lift: that the disc gives, where that is not the one it was cut for.
        """
        cut = lift or self.cut

        def made() -> tuple[PathMotion, Leads]:
            mechanics = replace(self.mechanics, friction=friction)
            # With the lift, so that no other one is taken for it.
            return cut, mechanics.leads(cut.mirrored if back else cut)

        return self._known.of((friction, back, id(cut)), made)[1]

    def drawn(self, friction: float) -> tuple[Array, Array]:
        """Where the rod draws a free cam on, and where it draws it back.

        Args:
            friction: coefficient of friction, a number.

        Returns:
            Cam angles between which it does, shape (k, 2) each, rad, begins in [0, 2 pi) and in order: the first draw
            to their ends, the second to their begins.
        """
        ahead, mirrored = self.leads(friction).stretches, self.leads(friction, back=True).stretches
        begin = (-mirrored[:, 1]) % TURN
        back = np.stack([begin, begin + mirrored[:, 1] - mirrored[:, 0]], axis=1)
        return ahead, back[np.argsort(back[:, 0])]
