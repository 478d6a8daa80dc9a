"""A course whose spacing is drawn on site: what moves with the spacing, about a point that stays."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TypeVar

from cadgen.arrays import Array
from cadgen.car.course.course import Course, Gate, Point, Shape
from cadgen.car.course.names import Scaled

C = TypeVar("C", float, Array)


@dataclass(frozen=True, kw_only=True)
class Draw:
    """Spacings of a course, of which one is drawn.

    Attributes:
        spacings: spacings that can be drawn, in order, mm.
        stated: spacing of the course as it is stated, mm.
        about: point that stays where it is, mm.
        kinds: kinds of things that move with the spacing; sizes stay.
    """

    spacings: tuple[float, ...]
    stated: float
    about: Point
    kinds: frozenset[Scaled]

    def course(self, stated: Course, spacing: float) -> Course:
        """The course at a spacing, mm.

        Args:
            stated: course as it is stated.
            spacing: spacing drawn, mm.
        """
        factor, kinds = spacing / self.stated, self.kinds
        obstacles = (
            replace(each, shape=self._shape(each.shape, factor)) if f"{each.kind}s" in kinds else each
            for each in stated.obstacles
        )
        return replace(
            stated,
            edge=self._shape(stated.edge, factor) if stated.edge is not None and Scaled.FIELD in kinds else stated.edge,
            obstacles=tuple(obstacles),
            gates=tuple(self._gates(stated.gates, factor) if Scaled.GATES in kinds else stated.gates),
            start=self._stand(stated.start, factor, moves=Scaled.START in kinds),
            finish=self._stand(stated.finish, factor, moves=Scaled.FINISH in kinds),
        )

    def seen(self, stated: Course, factor: float) -> Course:
        """The course at so many times (a factor) the stated spacing, made smaller by it: what moves is where it was.

        Args:
            stated: course as it is stated.
            factor: ratio of the spacing to the stated one.
        """
        moved = self.course(stated, factor * self.stated)
        whole = replace(self, kinds=frozenset(Scaled))
        return whole.course(moved, self.stated / factor)

    def without_moving(self, stated: Course) -> Course:
        """Obstacles and edge that do not move with the spacing, alone."""
        obstacles = tuple(each for each in stated.obstacles if f"{each.kind}s" not in self.kinds)
        return replace(stated, obstacles=obstacles, edge=None if Scaled.FIELD in self.kinds else stated.edge)

    def tightest(self, stated: Course) -> Course:
        """The course as stated, with gates and finish as small as they are, by the path, at the greatest spacing."""
        share = min(self.stated / self.spacings[-1], 1.0)

        def lessened(gate: Gate) -> Gate:
            return replace(gate, place=replace(gate.place, reach=gate.place.reach * share))

        return replace(
            stated,
            gates=tuple(map(lessened, stated.gates)),
            finish=None if stated.finish is None else lessened(stated.finish),
        )

    def point(self, place: tuple[C, C], factor: float) -> tuple[C, C]:
        """Place of a point, or of many, at so many times the stated spacing, mm.

        Args:
            place: x and y of the point or points, mm.
            factor: ratio of the spacing to the stated one.
        """
        (x, y), (x0, y0) = place, self.about
        return x0 + factor * (x - x0), y0 + factor * (y - y0)

    def _shape(self, shape: Shape, factor: float) -> Shape:
        return replace(shape, points=tuple(self.point(each, factor) for each in shape.points))

    def _gates(self, gates: Iterable[Gate], factor: float) -> Iterable[Gate]:
        return (replace(gate, place=self._shape(gate.place, factor)) for gate in gates)

    def _stand(self, stand: Gate | None, factor: float, *, moves: bool) -> Gate | None:
        return replace(stand, place=self._shape(stand.place, factor)) if stand is not None and moves else stand
