"""Physical quantities behind the effects, whose names differ between kinds of data.

Play is *backlash* in a track and a *return error* in a train; a run-out of the camshaft shows as an
*eccentric bore* in a lift.
Records agree or not about a quantity, and the car as built takes each once.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """A physical quantity of the car or its disc; `name` is unique."""

    name: str


RETURN_ERROR = Quantity("return error")
SLIDING_FRICTION = Quantity("sliding friction")
CAM_PHASE = Quantity("cam phase")
ECCENTRIC_BORE = Quantity("eccentric bore")
SHAFT_RUNOUT = Quantity("run-out of the shaft")
WORN_NOSE = Quantity("worn nose")
AXIS_REVERSAL = Quantity("machine-axis reversal")
UNDULATION = Quantity("undulation")
