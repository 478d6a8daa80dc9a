"""Every kind of path by its code. A new one is a file in this folder and a name below, or is registered."""

from cadgen.car.path.kinds.b_spline import B_SPLINE
from cadgen.car.path.kinds.cubic import CUBIC
from cadgen.car.path.kinds.quintic import QUINTIC
from cadgen.registry import Registry

_KINDS = Registry("path", (QUINTIC, CUBIC, B_SPLINE))
register, remove, codes, kind_of = _KINDS.register, _KINDS.remove, _KINDS.codes, _KINDS.kind_of
