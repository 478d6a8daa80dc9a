"""Every kind of follower by its code. A new one is a file in this folder and a name below, or is registered."""

from cadgen.cam.followers.rod_kind import ROD
from cadgen.registry import Registry

_KINDS = Registry("follower", (ROD,))
register, remove, codes, kind_of = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of
