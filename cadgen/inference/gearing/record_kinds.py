"""Kinds of records of a train of gears: angles at its input and output, without load or with the torque beside them."""

import numpy as np

from cadgen.deviations.catalogue import Catalogue
from cadgen.errors import FileError
from cadgen.inference.measurement.record import Column, Datum, Kind, Record, join

_MOST_DEG = 3.6e7
_MOST_NM = 1e6
_LEAST_ROWS = 24
MOST_ROWS, _MOST_LOGGED = 20_000, 400_000


def judged_together(
    code: str,
    title: str,
    columns: tuple[Column, ...],
    *,
    reading: int = -1,
    least_rows: int = _LEAST_ROWS,
    most_rows: int = MOST_ROWS,
    counts: int = 0,
    beside: tuple[Column, ...] = (),
    most_logged: int = 0,
) -> Kind:
    """Kind of which records are judged together, without effects to choose from.

    Args:
        code, title: as of a kind.
        columns: of a file.
        reading: place of the column that the instrument reads.
        least_rows, most_rows, counts, beside, most_logged: as of a kind.
    """
    return Kind(
        code=code,
        title=title,
        columns=columns,
        readings=(columns[reading].name,),
        catalogue=Catalogue(),
        datum=Datum(words=""),
        least_rows=least_rows,
        most_rows=most_rows,
        counts=counts,
        beside=beside,
        most_logged=most_logged,
        nearness=0,
    )


_ANGLES = tuple(
    Column(name=name, lower=-_MOST_DEG, upper=_MOST_DEG) for name in ("input_angle_deg", "output_angle_deg")
)
# Times tell a lag between both readings from play, where the speed changes.
_TIME = Column(name="t_s", lower=-1e12, upper=1e12)
TRAIN = judged_together("train", "Transmission of a train", _ANGLES, beside=(_TIME,), most_logged=_MOST_LOGGED)
LOADED_TRAIN = judged_together(
    "loaded train",
    "Transmission of a train under load",
    (*_ANGLES, Column(name="output_torque_Nm", lower=-_MOST_NM, upper=_MOST_NM)),
    reading=1,
    beside=(_TIME,),
    most_logged=_MOST_LOGGED,
)
# Angles by the names that a car has for them.
MOTOR_AND_CAM = judged_together(
    "train of a camshaft",
    "Transmission of a train to its camshaft",
    tuple(Column(name=name, lower=-_MOST_DEG, upper=_MOST_DEG) for name in ("motor_angle_deg", "cam_angle_deg")),
    beside=(_TIME,),
    most_logged=_MOST_LOGGED,
)
KINDS = (TRAIN, LOADED_TRAIN, MOTOR_AND_CAM)


def one_of(records: tuple[Record, ...]) -> Record:
    """Records of a train as one, without load as with none.

    Args:
        records: records of these kinds.

    Raises:
        FileError: more rows than can be judged together.
    """
    same = []
    for record in records:
        columns = dict(record.columns)
        if record.kind is MOTOR_AND_CAM:
            columns["input_angle_deg"] = columns.pop("motor_angle_deg")
            columns["output_angle_deg"] = columns.pop("cam_angle_deg")
        columns.setdefault("output_torque_Nm", np.zeros(len(record.run)))
        columns.setdefault("t_s", np.full(len(record.run), np.nan))
        same.append(
            Record(
                kind=LOADED_TRAIN,
                columns=columns,
                run=record.run,
                remarks=record.remarks,
                source=record.source,
                notes=record.notes,
            )
        )
    whole = join(same)
    for number, rows in enumerate(whole.parts, 1):
        turned, pressed = np.ptp(whole["input_angle_deg"][rows]), np.ptp(whole["output_torque_Nm"][rows])
        if turned == 0 and pressed == 0:
            raise FileError(
                "{file}: in run {run} neither the input turns nor does the torque change; turn the input, or hold it "
                "and change the torque at the output",
                file=whole.source,
                run=number,
            )
    return whole
