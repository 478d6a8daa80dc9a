"""Every kind of stage by its code.

A new one is a file in this folder and a name in the table `STAGES`, or it is registered from outside. Pairs of
cylindrical gears, spur, helical or internal, have no entry: theirs are the keys of a stage that names no kind, and what
a gear leaves out [train] says. The module is light to import.
"""

from cadgen.gears.planetary_kind import PLANETARY
from cadgen.gears.rack_kind import RACK
from cadgen.gears.stage_kind import StageKind
from cadgen.messages import Message
from cadgen.registry import Registry

SPUR = "spur"
STAGES: tuple[StageKind, ...] = (PLANETARY, RACK)
_KINDS = Registry(Message("kind of stage"), STAGES, (SPUR,), group="cadgen.stages", sort=StageKind)
register, remove, codes, kind_of, has = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of, _KINDS.has
