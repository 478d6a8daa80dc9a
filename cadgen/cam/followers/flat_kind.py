"""The kind of the flat face on a slide: its keys and what they must keep. Numerics come when it is built."""

from __future__ import annotations

from dataclasses import dataclass
from math import radians
from typing import TYPE_CHECKING, Annotated

from annotated_types import Ge, Gt, Le

from cadgen.cam.followers.kind import FollowerKind, FollowerSeat

if TYPE_CHECKING:
    from cadgen.cam.followers.flat import FlatFace


@dataclass(frozen=True, kw_only=True)
class FlatKeys:
    """Keys of a design's flat face on a slide, as in its file."""

    tilt_deg: Annotated[
        float, Ge(-45), Le(45), "of the face's normal from the slide's axis; 0, square; positive leans it forward"
    ] = 0.0
    face_offset_mm: Annotated[
        float, Ge(-500), Le(500), "of the slide's axis beside the camshaft: it moves the face, not the profile"
    ] = 0.0
    width_mm: Annotated[
        float | None, Gt(0), Le(1000), "of the face, centred on the slide's axis; left out, as wide as it must be"
    ] = None


def _build(keys: FlatKeys, seat: FollowerSeat) -> FlatFace:
    from cadgen.cam.followers.flat import FlatFace

    return FlatFace(base=seat.base_radius, tilt=radians(keys.tilt_deg), offset=keys.face_offset_mm, width=keys.width_mm)


FLAT = FollowerKind(
    code="flat",
    meaning="A flat face on a slide that moves straight out from the camshaft, square to it or tilted.",
    keys=FlatKeys,
    build=_build,
)
