"""Where an effect belongs, as design files write it: light, since every design is checked against it."""

from enum import StrEnum


class Place(StrEnum):
    """Place of an effect in an as-built design.

    It stays with the car; every disc made this way has it; it belongs to the disc that was measured; it is only
    recorded.
    """

    CAR = "car"
    PROCESS = "process"
    PART = "part"
    NOTED = "noted"
