"""Every motion law by its code. A new one is a file in this folder and a name below, is registered in Python,
or comes from a plug-in (`cadgen.registry`)."""

from cadgen.laws.cycloidal import CYCLOIDS
from cadgen.laws.few_harmonics import FEW_HARMONICS
from cadgen.laws.harmonics import HARMONICS
from cadgen.laws.law import MotionLaw
from cadgen.laws.parabolas import PARABOLAS
from cadgen.laws.polynomials import POLYNOMIALS
from cadgen.laws.scca import SCCA
from cadgen.laws.valve_lobe import VALVE_LOBE
from cadgen.messages import Message
from cadgen.registry import Registry

# A polynomial by conditions is made for its segment, and is no law of the table.
POLYNOMIAL = "polynomial"

_LAWS = Registry(
    Message("motion law"),
    (*POLYNOMIALS, *CYCLOIDS, *SCCA, *HARMONICS, *PARABOLAS, *FEW_HARMONICS, VALVE_LOBE),
    reserved=(POLYNOMIAL,),
    group="cadgen.laws",
    sort=MotionLaw,
)
register, remove, codes, law_of, has = _LAWS.register, _LAWS.remove, _LAWS.codes, _LAWS.kind_of, _LAWS.has
