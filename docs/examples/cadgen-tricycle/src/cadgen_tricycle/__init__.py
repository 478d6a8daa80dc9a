"""A tricycle for cadgen: a vehicle without a cam, whose steering and travel are logged.

| module          | what it holds                                                        |
|-----------------|----------------------------------------------------------------------|
| `effects`       | what may be off: zero, gain, wheelbase, odometer, lag, markers       |
| `formulas`      | what is proposed for an error that repeats and has no name           |
| `clock`         | clock of the camera against the log's, by the speeds that both show  |
| `steered_track` | the kind of data with its forward model, which cadgen finds by name  |
"""

from cadgen_tricycle.steered_track import STEERED_TRACK

__all__ = ["STEERED_TRACK"]
