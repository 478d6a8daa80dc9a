"""Polygons of a design file: whether their sides cross. Plain numbers: a design is read without numpy."""

from collections.abc import Sequence

from cadgen.design.section import Point


def crossing(corners: Sequence[Point]) -> tuple[int, int] | None:
    """Numbers of the first two sides that meet where they should not, counted from 0; None of a simple polygon.

    Side i leads from corner i to the next. Neighbours share a corner and no more; a side without length meets its
    neighbour.

    Args:
        corners: corners in order, three or more; the last is joined to the first.
    """
    count = len(corners)
    sides = [(corners[i], corners[(i + 1) % count]) for i in range(count)]
    for i in range(count):
        for j in range(i + 1, count):
            if j == i + 1 or (i == 0 and j == count - 1):
                first, second = (i, j) if j == i + 1 else (j, i)
                if _folds_back(sides[first], sides[second]):
                    return i, j
            elif _meet(sides[i], sides[j]):
                return i, j
    return None


def _folds_back(first: tuple[Point, Point], second: tuple[Point, Point]) -> bool:
    """Whether a side runs back over the one before it, or one of the two has no length."""
    (a, b), (_, c) = first, second
    if _turn(a, b, c) != 0:
        return False
    return (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) <= 0


def _meet(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    (a, b), (c, d) = one, other
    turns = _turn(a, b, c), _turn(a, b, d), _turn(c, d, a), _turn(c, d, b)
    if turns[0] * turns[1] < 0 and turns[2] * turns[3] < 0:
        return True
    ends = zip(turns, ((a, b, c), (a, b, d), (c, d, a), (c, d, b)), strict=True)
    return any(turn == 0 and _between(p, q, r) for turn, (p, q, r) in ends)


def _turn(a: Point, b: Point, c: Point) -> int:
    """Sign of the turn from a to b to c: 1 to the left, -1 to the right, 0 straight on or back."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (area > 0) - (area < 0)


def _between(a: Point, b: Point, c: Point) -> bool:
    """Whether c, on the line through a and b, lies between them."""
    return min(a[0], b[0]) <= c[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= c[1] <= max(a[1], b[1])
