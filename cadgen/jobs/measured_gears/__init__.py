"""Measured gears: from angles of a train to what its gears have, and what to change.

| module           | what it holds                                                                     |
|------------------|-----------------------------------------------------------------------------------|
| `measured_train` | angles at both ends of a train -> its errors by wheel, and in sentences           |
| `measured_gear`  | flank lines, pitch, span of one gear -> its errors, class, play, and a change     |
| `wanted_play`    | play found and play wanted -> thickness or centre distance, and a design          |
"""
