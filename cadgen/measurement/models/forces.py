"""Where the cam leads its gears, by friction."""

from dataclasses import dataclass, field, replace

from cadgen.cam.lift import LiftCurve
from cadgen.motion.mechanics import Leads, Mechanics

_KEPT = 32  # fits go back and forth between few frictions


@dataclass(frozen=True)
class Forces:
    """The cam that is measured and what acts on it.

    Attributes:
        cut: lift that it was cut for.
        mechanics: rod force and drag; the friction is what is sought.
    """

    cut: LiftCurve
    mechanics: Mechanics
    _known: dict[float, Leads] = field(default_factory=dict, repr=False)

    def leads(self, friction: float) -> Leads:
        """Where the cam leads with a sliding friction; remembered, since most differences leave friction alone."""
        if friction not in self._known:
            if len(self._known) >= _KEPT:
                self._known.pop(next(iter(self._known)))
            self._known[friction] = replace(self.mechanics, friction=friction).leads(self.cut)
        return self._known[friction]
