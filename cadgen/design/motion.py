"""The section [motion]: what a follower does in a turn of the cam, instead of [path] and [car].

A new source of a motion is a file in `sources` and a base of `MotionSection`.
"""

from typing import TYPE_CHECKING

from pydantic import model_validator

from cadgen.cam.followers.kind import FollowerKind
from cadgen.design.section import listed
from cadgen.design.sources.harmonics import HarmonicKeys
from cadgen.design.sources.lift_table import TableKeys
from cadgen.design.sources.measured import MeasuredKeys
from cadgen.design.sources.points import PointKeys
from cadgen.design.sources.segments import SegmentKeys
from cadgen.design.sources.source import MotionKeys
from cadgen.messages import Message

if TYPE_CHECKING:
    from cadgen.laws.motion import Motion


class MotionSection(SegmentKeys, PointKeys, HarmonicKeys, TableKeys, MeasuredKeys):
    """Motion of the follower in one turn of the cam. A design has it, or [path] and [car].

    One of segments, points, harmonics and table says what the motion is; with `measured` it is to be found.
    """

    @model_validator(mode="after")
    def _has_one_source(self) -> "MotionSection":
        named = [source for source in SOURCES if source.named_in(self)]
        given = [key for source in named for key in source.named_in(self)]
        if len(named) == 1:
            self._refuse_keys_of_others(named[0], given[-1])
            if given == ["table"]:
                raise ValueError(
                    Message("motion.table names a file whose rows were not read: load the design from its file")
                )
            return self
        names = listed([f"motion.{source.code}" for source in SOURCES], "or")
        if not named:
            raise ValueError(Message("motion says nothing of the lift: add one of {names}", names=names))
        keep, *drop = given
        raise ValueError(
            Message(
                "motion has {given}, and takes one of {names}: keep {keep} and remove the others (on the command line "
                "with {drop})",
                given=listed(given, "and"),
                names=names,
                keep=keep,
                drop=" ".join(f"--set motion.{name}=" for name in drop),
            )
        )

    def _refuse_keys_of_others(self, source: type[MotionKeys], given: str) -> None:
        for other in SOURCES:
            for key in other.alone:
                if other is not source and getattr(self, key) is not None:
                    raise ValueError(
                        Message(
                            "motion.{key} is for a {code}, and the motion has {source}: remove it (on the command line "
                            "with --set motion.{key}=)",
                            key=key,
                            code=other.code,
                            source=given,
                        )
                    )

    @property
    def source(self) -> type[MotionKeys]:
        """Source that the section names."""
        return next(source for source in SOURCES if source.named_in(self))

    @property
    def shaping_key(self) -> str:
        """Key that shapes the motion, as messages name it."""
        return self.source.shaped_by(self)


SOURCES: tuple[type[MotionKeys], ...] = tuple(base for base in MotionSection.__bases__ if issubclass(base, MotionKeys))


def motion_of(section: MotionSection, kind: FollowerKind, *, corners: bool = True) -> "Motion":
    """Motion of a section [motion].

    Args:
        section: section [motion].
        kind: kind of the follower, whose unit the heights must have.
        corners: whether the follower may have a corner of its path, so that a refusal may name it.

    Raises:
        ValueError: a height is in another unit than the follower moves in.
        DesignError: the motion does not fill the turn or does not close, its velocity jumps, or its table cannot be.
    """
    return section.source.motion(section, kind, corners=corners)
