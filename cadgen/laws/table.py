"""Every motion law by its code. A new one is a file in this folder and a name below, is registered in Python,
or comes from a plug-in (`cadgen.registry`)."""

from cadgen.laws.law import MotionLaw
from cadgen.laws.power_laws import POWER_LAWS
from cadgen.laws.scca import SCCA
from cadgen.laws.sine_laws import SINE_LAWS
from cadgen.laws.valve_lobe import VALVE_LOBE
from cadgen.messages import Message
from cadgen.registry import Registry

# A polynomial by conditions is made for its segment, and is no law of the table.
POLYNOMIAL = "polynomial"

_LAWS = Registry(
    Message("motion law"),
    (*POWER_LAWS, *SINE_LAWS, *SCCA, VALVE_LOBE),
    reserved=(POLYNOMIAL,),
    group="cadgen.laws",
    sort=MotionLaw,
)
register, remove, codes, law_of, has = _LAWS.register, _LAWS.remove, _LAWS.codes, _LAWS.kind_of, _LAWS.has
