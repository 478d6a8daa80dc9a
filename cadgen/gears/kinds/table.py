"""Every kind of stage by its code. A new one is a file in this folder and a name below, or is registered.

Spur gears have no entry: theirs are the keys of a stage that names no kind, and what a gear leaves out [train] says.
"""

from cadgen.gears.kinds.kind import StageKind
from cadgen.registry import Registry

SPUR = "spur"
_KINDS: Registry[StageKind] = Registry("kind of stage", (), reserved=(SPUR,))
register, remove, codes, kind_of = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of
