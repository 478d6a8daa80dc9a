"""Where an effect belongs, as design files write it: light, since every design is checked against it."""

from typing import Literal

# What becomes of an effect in an as-built design: it stays with the car; every disc made this way has it; it belongs
# to the disc that was measured; it is only recorded.
Place = Literal["car", "process", "part", "noted"]
