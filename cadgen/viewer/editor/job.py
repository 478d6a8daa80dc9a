"""A version of a design to compute, and the answer; light to import, for the process that only sends them."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from cadgen.messages import CHINESE, shown
from cadgen.progress import Progress
from cadgen.registry import fault_sentence


class JobStage(StrEnum):
    """Stage of a computation: the actual cam alone, or all."""

    PREVIEW = "preview"
    WHOLE = "whole"


class AnswerState(StrEnum):
    """State of an answer.

    It is there; the design cannot be computed; a newer version was asked for meanwhile; or it failed in a way that is
    none of the design's.
    """

    DONE = "done"
    REFUSED = "refused"
    SUPERSEDED = "superseded"
    FAULT = "fault"


@dataclass(frozen=True)
class Job:
    """A version of a design to compute.

    Attributes:
        revision: number of the version.
        stage: what is computed of it.
        text: TOML.
        file: path of its file, for messages and for tables beside it.
    """

    revision: int
    stage: JobStage
    text: str
    file: str


@dataclass(frozen=True)
class Result:
    """Answer to a job.

    Attributes:
        state: whether the answer is there.
        body: JSON.
    """

    state: AnswerState
    body: bytes = b"{}"


Compute = Callable[[Job, Progress], Result]


def refusal(state: AnswerState, sentence: str, **more: Any) -> Result:
    """Result that says in a sentence why there is none."""
    return Result(state, json.dumps({**in_both(sentence), **more}, ensure_ascii=False).encode())


def in_both(sentence: str) -> dict[str, str]:
    """Refusal in English, and in Chinese for the page that shows it."""
    return {"error": str(sentence), "zh": shown(sentence, CHINESE)}


def fault(error: Exception) -> Result:
    """Result of a computation that failed in a way that is none of the design's."""
    return refusal(AnswerState.FAULT, fault_sentence(error))
