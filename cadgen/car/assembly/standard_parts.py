"""Bought parts by standard sizes: ball bearings, socket head screws, nuts and the holes that they need.

Sizes of bearings up to a bore of 10 mm, of screws (ISO 4762), nuts (ISO 4032), clearance holes (ISO 273) and keys are
those of the tables of bd_warehouse 0.4.0 (Apache-2.0). Its bearings are of a maker's catalogue (SKF). Sizes and lengths
of keys agree with printed extracts of DIN 6885-1 and of GB/T 1095 and 1096, which have ISO 773, too. 683 and 693 are
of the table at softsolder.com/2011/02/18/miniature-ball-bearing-sizes. Bearings of 12 and 15 mm, and set collars
(DIN 705), are usual catalogue sizes, which no table at hand held.
"""

from dataclasses import dataclass
from typing import NamedTuple


class Bearing(NamedTuple):
    """Deep groove ball bearing.

    Attributes:
        designation: basic designation, as it is ordered.
        bore: diameter of its shaft, mm.
        diameter: outer diameter, mm.
        width: width, of the kind with shields where there is one, mm.
    """

    designation: str
    bore: float
    diameter: float
    width: float


BEARINGS = (
    Bearing("683-2Z", 3, 7, 3),
    Bearing("693-2Z", 3, 8, 4),
    Bearing("623-2Z", 3, 10, 4),
    Bearing("638/4-2Z", 4, 9, 4),
    Bearing("619/4-2Z", 4, 11, 4),
    Bearing("604-2Z", 4, 12, 4),
    Bearing("624-2Z", 4, 13, 5),
    Bearing("634-2Z", 4, 16, 5),
    Bearing("638/5-2Z", 5, 11, 5),
    Bearing("619/5-2Z", 5, 13, 4),
    Bearing("625-2Z", 5, 16, 5),
    Bearing("635-2Z", 5, 19, 6),
    Bearing("628/6-2Z", 6, 13, 5),
    Bearing("619/6-2Z", 6, 15, 5),
    Bearing("626-2Z", 6, 19, 6),
    Bearing("628/7-2Z", 7, 14, 5),
    Bearing("619/7-2Z", 7, 17, 5),
    Bearing("607-2Z", 7, 19, 6),
    Bearing("627", 7, 22, 7),
    Bearing("628/8-2Z", 8, 16, 5),
    Bearing("619/8-2Z", 8, 19, 6),
    Bearing("608-2Z", 8, 22, 7),
    Bearing("628-2Z", 8, 24, 8),
    Bearing("618/9", 9, 17, 4),
    Bearing("619/9", 9, 20, 6),
    Bearing("609", 9, 24, 7),
    Bearing("629", 9, 26, 8),
    Bearing("61800", 10, 19, 5),
    Bearing("61900", 10, 22, 6),
    Bearing("6000", 10, 26, 8),
    Bearing("6200", 10, 30, 9),
    Bearing("61801", 12, 21, 5),
    Bearing("61901", 12, 24, 6),
    Bearing("6001", 12, 28, 8),
    Bearing("6201", 12, 32, 10),
    Bearing("61802", 15, 24, 5),
    Bearing("61902", 15, 28, 7),
    Bearing("6002", 15, 32, 9),
    Bearing("6202", 15, 35, 11),
)


def bearing_of(bore: float, diameter: float) -> Bearing | None:
    """Ball bearing of some sizes; None where the table has none.

    Args:
        bore: diameter of its shaft, mm.
        diameter: outer diameter, mm.
    """
    return next((each for each in BEARINGS if (each.bore, each.diameter) == (bore, diameter)), None)


def smallest_bearing(bore: float, widest: float) -> Bearing | None:
    """Ball bearing of the least outer diameter for a shaft; None where the table has none for it.

    Args:
        bore: diameter of the shaft, mm.
        widest: greatest width, mm; where none is so narrow, the narrowest is given.
    """
    every = [each for each in BEARINGS if each.bore == bore]
    narrow = [each for each in every if each.width <= widest]
    return min(narrow, key=lambda each: each.diameter) if narrow else min(every, key=lambda e: e.width, default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Screw:
    """Socket head cap screw (ISO 4762) with its nut (ISO 4032) and its clearance hole (ISO 273, medium).

    Attributes:
        thread: name of the thread, such as `M3`.
        diameter: nominal diameter, mm.
        pitch: coarse pitch, mm.
        head_diameter: diameter of the head, mm.
        head_height: height of the head, mm.
        hole: diameter of the clearance hole, mm.
        nut_width: width of the nut across flats, mm.
        nut_height: greatest height of the nut, mm.
    """

    thread: str
    diameter: float
    pitch: float
    head_diameter: float
    head_height: float
    hole: float
    nut_width: float
    nut_height: float

    @property
    def tap_drill(self) -> float:
        """Diameter of the hole before the thread is cut, mm: nominal diameter less the pitch (ISO 2306)."""
        return self.diameter - self.pitch

    @property
    def least_length(self) -> float:
        """Length of thread in aluminium, mm: two diameters."""
        return 2 * self.diameter


def _screw(thread: str, pitch: float, head: tuple[float, float], hole: float, nut: tuple[float, float]) -> Screw:
    return Screw(
        thread=thread,
        diameter=float(thread[1:]),
        pitch=pitch,
        head_diameter=head[0],
        head_height=head[1],
        hole=hole,
        nut_width=nut[0],
        nut_height=nut[1],
    )


# Height of a parallel key and depth of its seat in the shaft by its width, mm (DIN 6885-1, ISO 773).
_KEYS = {
    2.0: (2.0, 1.2), 3.0: (3.0, 1.8), 4.0: (4.0, 2.5), 5.0: (5.0, 3.0), 6.0: (6.0, 3.5), 8.0: (7.0, 4.0),
    10.0: (8.0, 5.0), 12.0: (8.0, 5.0), 14.0: (9.0, 5.5), 16.0: (10.0, 6.0), 18.0: (11.0, 7.0), 20.0: (12.0, 7.5),
    22.0: (14.0, 9.0), 25.0: (14.0, 9.0), 28.0: (16.0, 10.0),
}  # fmt: skip
_SEAT_SHARE = 0.6  # of the height of a key in its shaft, where the table has none of its width
# Lengths of parallel keys that are sold, mm, and least and greatest by the width (DIN 6885-1, GB/T 1096).
_KEY_LENGTHS = (
    6, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 32, 36, 40, 45, 50, 56, 63, 70, 80, 90, 100, 110, 125, 140, 160, 180, 200
)  # fmt: skip
_LENGTHS_SOLD = {
    2.0: (6, 20), 3.0: (6, 36), 4.0: (8, 45), 5.0: (10, 56), 6.0: (14, 70), 8.0: (18, 90), 10.0: (22, 110),
    12.0: (28, 140), 14.0: (36, 160), 16.0: (45, 180), 18.0: (50, 200), 20.0: (56, 220), 22.0: (63, 250),
    25.0: (70, 280), 28.0: (80, 320),
}  # fmt: skip


def key_size(width: float) -> tuple[float, float]:
    """Height of a parallel key, and depth of its seat in the shaft, mm.

    Args:
        width: width of the key, mm.
    """
    return _KEYS.get(width, (width, _SEAT_SHARE * width))


def key_length(width: float, room: float) -> float | None:
    """Length of the longest parallel key with round ends (form A) that is sold for a seat; None where none is so short.

    Args:
        width: width of the key, mm.
        room: greatest length, mm.
    """
    least, greatest = _LENGTHS_SOLD.get(width, (2 * width, _KEY_LENGTHS[-1]))
    return max((float(each) for each in _KEY_LENGTHS if least <= each <= min(greatest, room + 1e-9)), default=None)


class ParallelKey(NamedTuple):
    """Parallel key as it is ordered or cut (DIN 6885-1, ISO 773).

    Attributes:
        form: `A` with round ends, `B` with square ones.
        width: width, mm.
        height: height, mm.
        length: length over all, mm.
    """

    form: str
    width: float
    height: float
    length: float

    @property
    def size(self) -> str:
        """Form and size: `A 3 x 3 x 8`."""
        return f"{self.form} {self.width:g} x {self.height:g} x {self.length:.6g}"

    @property
    def designation(self) -> str:
        """Standard and size, as it is ordered."""
        return f"DIN 6885-1 (ISO 773) {self.size}"


class SetCollar(NamedTuple):
    """Set collar with its set screw (DIN 705 A).

    Attributes:
        bore: diameter of its shaft, mm.
        diameter: outer diameter, mm.
        width: width, mm.
    """

    bore: float
    diameter: float
    width: float

    @property
    def designation(self) -> str:
        """Standard and size, as it is ordered."""
        return f"DIN 705 A {self.bore:g}"


# Outer diameter and width by the bore, mm.
_COLLARS = {
    2.0: (7.0, 5.0),
    3.0: (7.0, 5.0),
    4.0: (8.0, 5.0),
    5.0: (10.0, 6.0),
    6.0: (12.0, 8.0),
    7.0: (12.0, 8.0),
    8.0: (16.0, 8.0),
    9.0: (18.0, 10.0),
    10.0: (20.0, 10.0),
    12.0: (22.0, 12.0),
    14.0: (25.0, 12.0),
    15.0: (25.0, 12.0),
}


def set_collar(bore: float) -> SetCollar:
    """Set collar of a shaft; one of twice its diameter where the table has none.

    Args:
        bore: diameter of the shaft, mm.
    """
    return SetCollar(bore, *_COLLARS.get(bore, (2 * bore, max(5.0, bore))))


# Heads are those of knurled screws, the larger ones.
SCREWS = {
    screw.thread: screw
    for screw in (
        _screw("M2", 0.4, (3.98, 2.0), 2.4, (4.0, 1.6)),
        _screw("M2.5", 0.45, (4.68, 2.5), 2.9, (5.0, 2.0)),
        _screw("M3", 0.5, (5.68, 3.0), 3.4, (5.5, 2.4)),
        _screw("M4", 0.7, (7.22, 4.0), 4.5, (7.0, 3.2)),
        _screw("M5", 0.8, (8.72, 5.0), 5.5, (8.0, 4.7)),
    )
}
# Lengths in which such screws are sold, mm (ISO 4762).
LENGTHS = (4, 5, 6, 8, 10, 12, 16, 20, 25, 30, 35, 40, 45, 50)


def screw_length(least: float) -> float:
    """Least length of a screw that is sold, mm.

    Args:
        least: length that it must have, mm.
    """
    return float(next((each for each in LENGTHS if each >= least - 1e-9), LENGTHS[-1]))
