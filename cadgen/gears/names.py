"""Names that files of designs and the gears share: light to import."""

from typing import Literal, get_args

# How a quantity varies within its tolerance zone: normal with 3 sigma at the limits and clipped there, or uniform.
Law = Literal["normal", "uniform"]
# To which limit of their grade teeth are thinned, or to the middle.
Thinning = Literal["least", "middle", "greatest"]
# Order of the stages in a car: as the design has them, or that of least return error.
StageOrder = Literal["as-given", "reordered"]
# What a train may be planned by: these, or the best teeth within limits.
Order = Literal[StageOrder, "search"]
STAGE_ORDERS: tuple[StageOrder, ...] = get_args(StageOrder)
ORDERS: tuple[Order, ...] = get_args(Order)
