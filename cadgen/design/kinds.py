"""The registered kinds that a design names, which decide what keys it has."""

from dataclasses import dataclass

from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.followers.rod_kind import ROD
from cadgen.car.path.path_kinds import QUINTIC, PathKind
from cadgen.design.follower import FOLLOWER
from cadgen.design.path import PATH
from cadgen.design.train import stage_kinds
from cadgen.gears.stage_kind import StageKind

# A key's parts from the top, items of lists counted from 0.
Place = tuple[str | int, ...]


@dataclass(frozen=True)
class Kinds:
    """Kinds that decide what keys there are at a place of a design.

    Attributes:
        follower: kind of follower.
        stage: kind of the stage that holds the place; None for spur gears.
        path: kind of path.
        motion: whether the design has [motion] instead of [path] and [car].
    """

    follower: FollowerKind = ROD
    stage: StageKind | None = None
    path: PathKind = QUINTIC
    motion: bool = False


USUAL = Kinds()


@dataclass(frozen=True)
class NamedKinds:
    """Kinds that a whole design names.

    Attributes:
        follower: kind of follower.
        stages: kind of each stage of the train; None for spur gears.
        path: kind of path.
        motion: whether the design has [motion] instead of [path] and [car].
    """

    follower: FollowerKind = ROD
    stages: tuple[StageKind | None, ...] = ()
    path: PathKind = QUINTIC
    motion: bool = False

    @classmethod
    def of(cls, values: object) -> "NamedKinds":
        """Kinds that raw values name; the usual ones where they name none that is known."""
        follower, path = (values.get(name) if isinstance(values, dict) else None for name in ("follower", "path"))
        motion = isinstance(values, dict) and "motion" in values
        return cls(FOLLOWER.kind(follower), stage_kinds(values), PATH.kind(path), motion)

    def at(self, place: Place) -> Kinds:
        """Kinds that decide at a place."""
        match place:
            case ("train", "stages", int(number), *_) if number < len(self.stages):
                return Kinds(self.follower, self.stages[number], self.path, self.motion)
        return Kinds(self.follower, path=self.path, motion=self.motion)
