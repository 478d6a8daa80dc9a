"""Every kind of follower by its code. A new one is a file in this folder and a name below, is registered in
Python, or comes from a plug-in (`cadgen.registry`)."""

from cadgen.cam.followers.flat_kind import FLAT
from cadgen.cam.followers.kind import FollowerKind
from cadgen.cam.followers.rod_kind import ROD
from cadgen.cam.followers.roller_kind import KNIFE, ROLLER
from cadgen.cam.followers.swinging_kind import SWINGING_FLAT, SWINGING_ROLLER
from cadgen.messages import Message
from cadgen.registry import Registry

_KINDS = Registry(
    Message("follower"),
    (ROD, ROLLER, KNIFE, FLAT, SWINGING_ROLLER, SWINGING_FLAT),
    group="cadgen.followers",
    sort=FollowerKind,
)
register, remove, codes, kind_of, has = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of, _KINDS.has
