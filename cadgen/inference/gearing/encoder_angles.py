"""Angles of a train as encoders give them: counted on over whole turns, and held against what the train can do.

An encoder of a single turn begins anew after 360°. Its jump of nearly a turn between neighbouring rows is taken out
where both angles move by less than a quarter of a turn from row to row. With the input counted on, each run stands off
by whole turns of the input, n 360°/i at the output. Those n are chosen with which all runs have one zero.
"""

from __future__ import annotations

from dataclasses import replace
from math import degrees

import numpy as np

from cadgen.errors import FileError
from cadgen.inference.gearing.train_orders import SeenTrain
from cadgen.inference.measurement.record import Record
from cadgen.messages import Message

_TURN = 360.0
_STEP = 90.0  # degrees from row to row up to which the sense of a step is sure
_EXCHANGED = 0.02  # share by which the turns of the input for one of the output may differ from the reciprocal ratio
_UNLIKE = 0.1  # share by which a ratio differs from 1 from which on an exchange shows
_STILL = 0.01  # share of its way that the output turns at most, if it stands still


def counted_on(record: Record, train: SeenTrain) -> Record:
    """Record whose angles do not begin anew after a turn, with a note on each angle that did.

    Args:
        record: record of a train, of any kind (`record_kinds.KINDS`).
        train: train.

    Raises:
        FileError: rows too far apart to tell in which sense an angle went on.
    """
    at_input, at_output = (column.name for column in record.kind.columns[:2])
    columns = {name: record[name] for name in (at_input, at_output)}
    notes: list[Message] = []
    anew: list[str] = []
    for name, values in columns.items():
        jumps = 0
        # A single turn holds all values of an encoder that begins anew.
        if np.ptp(values) > _TURN * (1 + 1e-6):
            continue
        for rows in record.parts:
            steps = np.diff(values[rows])
            turns = np.round(steps / _TURN)
            if not turns.any():
                continue
            widest = float(np.abs(steps - _TURN * turns).max())
            if widest > _STEP:
                raise FileError(
                    "{file}: {column} jumps by up to {jump:.0f}° and begins anew after a turn, and with {step:.0f}° "
                    "between neighbouring rows its sense cannot be told: give rows less than {most:.0f}° apart, in the "
                    "order in which they were read",
                    file=record.source,
                    column=name,
                    jump=float(np.abs(steps).max()),
                    step=widest,
                    most=_STEP,
                )
            values[rows] -= _TURN * np.concatenate([[0.0], np.cumsum(turns)])
            jumps += int(np.count_nonzero(turns))
        if jumps:
            notes.append(
                Message(
                    "{column} begins anew after each turn and is counted on, over {jumps} jumps",
                    column=name,
                    jumps=jumps,
                )
            )
            anew.append(name)
    if not anew:
        return record
    parts, turned, followed = record.parts, columns[at_input], columns[at_output]
    if at_output in anew:
        for rows in parts:
            followed[rows] -= _TURN * np.round((followed[rows].mean() - followed[parts[0]].mean()) / _TURN)
    if at_input in anew:
        along = sum(np.cov(turned[rows], followed[rows])[0, 1] for rows in parts)
        zeros = [np.mean(np.sign(along) * followed[rows] - turned[rows] / train.ratio) for rows in parts]
        for rows, zero in zip(parts, zeros, strict=True):
            turned[rows] += _TURN * np.round((zero - zeros[0]) * train.ratio / _TURN)
    return replace(record, columns=record.columns | columns, notes=(*record.notes, *notes))


def refuse_impossible(record: Record, train: SeenTrain, widest: float) -> None:
    """Refuse angles that no record of the train has: of columns that are exchanged, or of an output that stands still.

    Args:
        record: angles of input and output, and torque (`record_kinds.one_of`).
        train: train.
        widest: greatest play to expect, rad at the output.

    Raises:
        FileError: columns exchanged, or an output that stands still.
    """
    covered = crossed = 0.0
    for number, rows in enumerate(record.parts, 1):
        turned, followed = record["input_angle_deg"][rows], record["output_angle_deg"][rows]
        way = np.ptp(turned) / train.ratio
        least = _STILL * way if way > degrees(widest) else 0.0
        if np.ptp(followed) <= least:
            raise FileError(
                "{file}: in run {run} the output stands still while the input turns by {turned:.4g}° or the torque "
                "changes: look whether its encoder is read, and whether it turns with the output",
                file=record.source,
                run=number,
                turned=float(np.ptp(turned)),
            )
        covered += float(np.sum((turned - turned.mean()) ** 2))
        crossed += float((turned - turned.mean()) @ (followed - followed.mean()))
    unlike = abs(train.ratio - 1) > _UNLIKE and covered > 0
    if unlike and abs(abs(crossed) / covered / train.ratio - 1) < _EXCHANGED:
        raise FileError(
            "{file}: the output turns {turns:.4g} times for one turn of the input, and the train makes it the other "
            "way round: both angles are exchanged; --columns input_angle_deg=output_angle_deg --columns "
            "output_angle_deg=input_angle_deg takes them so",
            file=record.source,
            turns=abs(crossed) / covered,
        )
