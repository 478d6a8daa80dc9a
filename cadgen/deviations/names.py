"""Words of the measurement room that design files use: light, since every design is checked against them."""

from typing import Literal, get_args

Kind = Literal["lift", "profile", "transmission", "track", "steered track", "zones"]
KINDS: tuple[Kind, ...] = get_args(Kind)

# What becomes of an effect in an as-built design: it stays with the car; every disc made this way has it; it belongs
# to the disc that was measured; it is only recorded.
Place = Literal["car", "process", "part", "noted"]
