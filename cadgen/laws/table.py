"""Every motion law by its code. A new one is a file in this folder and a name below, is registered in Python,
or comes from a plug-in (`cadgen.registry`)."""

from cadgen.laws.cycloidal import CYCLOIDAL
from cadgen.laws.law import MotionLaw
from cadgen.laws.polynomial_3_4_5 import POLYNOMIAL_3_4_5
from cadgen.messages import Message
from cadgen.registry import Registry

_LAWS = Registry(Message("motion law"), (POLYNOMIAL_3_4_5, CYCLOIDAL), group="cadgen.laws", sort=MotionLaw)
register, remove, codes, law_of, has = _LAWS.register, _LAWS.remove, _LAWS.codes, _LAWS.kind_of, _LAWS.has
